// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_ROUNDED_NUMBER_H
#define RUN_ROUNDED_NUMBER_H

#include <charconv>
#include <ostream>

namespace run {

// Written for people: without the last digits, in which a product like 154 * 0.3 is not 46.2.
struct Rounded_number
{
  double value;

  friend std::ostream& operator<<(std::ostream& out, const Rounded_number& number)
  {
    constexpr int digits = 12;
    char text[32];
    const auto result =
        std::to_chars(text, text + sizeof text, number.value, std::chars_format::general, digits);
    return out.write(text, result.ptr - text);
  }
};

} // namespace run

#endif // RUN_ROUNDED_NUMBER_H
