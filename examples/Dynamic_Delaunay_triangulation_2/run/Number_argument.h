// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_NUMBER_ARGUMENT_H
#define RUN_NUMBER_ARGUMENT_H

#include "../scenario/Json_object_reader.h"

#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <system_error>

namespace run {

// Strict, unlike strtoull(), to which "-1" is a large number and "010" is 8.
template <class Number>
bool is_number(const std::string& text, Number& value)
{
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

inline std::uint64_t count_argument(const std::string& text, std::uint64_t lowest,
                                    std::uint64_t highest)
{
  std::uint64_t value = 0;
  if (!is_number(text, value) || value < lowest || value > highest) {
    throw std::invalid_argument("'" + text + "' is not a whole number from " +
                                std::to_string(lowest) + " to " + std::to_string(highest));
  }
  return value;
}

inline double number_argument(const std::string& text, const scenario::Range& range)
{
  double value = 0.0;
  if (!is_number(text, value) || !range.contains(value)) {
    throw std::invalid_argument("'" + text + "' is not a number " + range.text());
  }
  return value;
}

} // namespace run

#endif // RUN_NUMBER_ARGUMENT_H
