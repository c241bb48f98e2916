// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_TEXT_FILE_H
#define SCENARIO_TEXT_FILE_H

#include "Scenario_error.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace scenario {

inline std::string read_text_file(const std::string& path)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Scenario_error(path, "is a directory, not a file");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw Scenario_error(path, std::string("cannot be opened: ") + std::strerror(errno));
  }
  std::string text;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored) {
    text.reserve(size);
  }
  char buffer[1 << 16];
  while (stream.read(buffer, sizeof buffer), stream.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) {
    throw Scenario_error(path, "cannot be read to its end");
  }
  return text;
}

} // namespace scenario

#endif // SCENARIO_TEXT_FILE_H
