// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_NAMED_H
#define RANDOM_OPERATIONS_NAMED_H

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace random_operations {

// The words of a text, without the white space between them.
inline std::vector<std::string> words_in(const std::string& text)
{
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
}

template <class Thing>
std::vector<std::string> names_of(const std::vector<Thing>& things)
{
  std::vector<std::string> names;
  for (const Thing& thing : things) {
    names.push_back(thing.name);
  }
  return names;
}

// \throws std::invalid_argument if there is none; `what` says what they are.
template <class Thing>
const Thing& named(const std::vector<Thing>& things, const std::string& name, const char* what)
{
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const Thing& thing) { return thing.name == name; });
  if (found == things.end()) {
    std::string names;
    for (const std::string& one : names_of(things)) {
      names += (names.empty() ? "" : ", ") + one;
    }
    throw std::invalid_argument(std::string("there is no ") + what + " '" + name + "'; there are " +
                                names);
  }
  return *found;
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_NAMED_H
