// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_EXACT_NUMBER_H
#define RUN_EXACT_NUMBER_H

#include <charconv>
#include <ostream>

namespace run {

// Written as the shortest text that is read as the same number again.
struct Exact_number
{
  double value;

  friend std::ostream& operator<<(std::ostream& out, const Exact_number& number)
  {
    char text[32]; // -2.2250738585072014e-308 is among the longest
    const auto result = std::to_chars(text, text + sizeof text, number.value);
    return out.write(text, result.ptr - text);
  }
};

} // namespace run

#endif // RUN_EXACT_NUMBER_H
