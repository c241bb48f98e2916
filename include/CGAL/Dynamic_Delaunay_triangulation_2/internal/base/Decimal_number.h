// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_DECIMAL_NUMBER_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_DECIMAL_NUMBER_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>
#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

inline const char* after_digits(const char* first, const char* beyond)
{
  return std::find_if(first, beyond, [](char c) { return c < '0' || c > '9'; });
}

// Where a number such as -12.5e-3 ends, or `first` if there is none.
inline const char* after_decimal_number(const char* first, const char* beyond)
{
  const char* const whole = first + (first != beyond && *first == '-');
  const char* end = after_digits(whole, beyond);
  auto digits = end - whole;
  if (end != beyond && *end == '.') {
    const char* const fraction = end + 1;
    end = after_digits(fraction, beyond);
    digits += end - fraction;
  }
  if (digits == 0)
    return first;
  if (end != beyond && (*end == 'e' || *end == 'E')) {
    const char* const sign = end + 1;
    const char* const exponent = sign + (sign != beyond && (*sign == '-' || *sign == '+'));
    const char* const beyond_exponent = after_digits(exponent, beyond);
    if (beyond_exponent != exponent)
      end = beyond_exponent;
  }
  return end;
}

// Reads a number as `std::from_chars(first, beyond, number)` does, but no infinity and no NaN. For
// standard libraries whose from_chars() reads only integers: libc++ of LLVM before version 20.
inline std::from_chars_result read_decimal_number(const char* first, const char* beyond,
                                                  double& number)
{
  const char* const end = after_decimal_number(first, beyond);
  if (end == first)
    return {first, std::errc::invalid_argument};
  std::string text(first, end);
  const std::size_t point = text.find('.');
  if (point != std::string::npos) // std::strtod() expects the locale's decimal point
    text.replace(point, 1, std::localeconv()->decimal_point);
  const double value = std::strtod(text.c_str(), nullptr);
  const bool is_zero =
      std::none_of(text.begin(),
                   text.begin() + std::ptrdiff_t((std::min)(text.find_first_of("eE"), text.size())),
                   [](char c) { return c >= '1' && c <= '9'; });
  if (std::isinf(value) || (value == 0 && !is_zero))
    return {end, std::errc::result_out_of_range};
  number = value;
  return {end, std::errc()};
}

// Prints the number by std::snprintf(), but with a point in every locale. The format takes a number
// of digits first.
inline std::string printed_number(const char* format, int digits, double number)
{
  char text[400]; // the largest double has 309 digits before the point
  std::snprintf(text, sizeof(text), format, digits, number);
  std::string result = text;
  const std::string point = std::localeconv()->decimal_point;
  const std::size_t place = result.find(point);
  if (place != std::string::npos)
    result.replace(place, point.size(), ".");
  return result;
}

// Prints a finite number with the fewest digits that are read back as the same number.
inline std::string shortest_decimal_number(double number)
{
  constexpr int enough = std::numeric_limits<double>::max_digits10;
  for (int digits = 1;; ++digits) {
    const std::string text = printed_number("%.*g", digits, number);
    double read = 0;
    read_decimal_number(text.data(), text.data() + text.size(), read);
    if (read == number || digits == enough)
      return text;
  }
}

// Read a number as `std::from_chars()` does, and append the shortest text of a number.
template <class Number>
std::from_chars_result read_number(const char* first, const char* beyond, Number& number)
{
#ifndef __cpp_lib_to_chars // defined if floating-point numbers are supported, too
  if constexpr (std::is_floating_point_v<Number>)
    return read_decimal_number(first, beyond, number);
  else
#endif
    return std::from_chars(first, beyond, number);
}

template <class Number>
void append_number(std::string& text, Number number)
{
#ifndef __cpp_lib_to_chars
  if constexpr (std::is_floating_point_v<Number>)
    text += shortest_decimal_number(number);
  else
#endif
  {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof(digits), number).ptr);
  }
}

template <class Part>
void append_part(std::string& text, const Part& part)
{
  if constexpr (std::is_arithmetic_v<Part>)
    append_number(text, part);
  else
    text += part;
}

// Joins texts and numbers. A stream would write numbers in the global locale, and bring all locales
// of the standard library into a program that is loaded over a network.
template <class... Parts>
std::string message_text(const Parts&... parts)
{
  std::string text;
  (append_part(text, parts), ...);
  return text;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_DECIMAL_NUMBER_H
