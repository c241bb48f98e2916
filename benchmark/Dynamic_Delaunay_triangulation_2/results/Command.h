// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RESULTS_COMMAND_H
#define RESULTS_COMMAND_H

#include <string>

namespace results {

// What makes these results again: "./dev bench NAME ...". Where they are written does not matter.
inline std::string command_of(const std::string& name, int argc, const char* const* argv)
{
  std::string command = "./dev bench " + name;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--output") {
      ++i;
    } else if (argument.compare(0, 9, "--output=") != 0) {
      command += ' ' + argument;
    }
  }
  return command;
}

} // namespace results

#endif // RESULTS_COMMAND_H
