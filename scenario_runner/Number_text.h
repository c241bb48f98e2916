// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_NUMBER_TEXT_H
#define SCENARIO_RUNNER_NUMBER_TEXT_H

#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

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

// Three significant digits, never an exponent.
inline std::string readable(double value)
{
  if (value == 0.0) {
    return "0";
  }
  const double size = std::abs(value);
  const int digits_before = size < 1.0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
  const int digits_behind = 3 - digits_before;
  const double unit = std::pow(10.0, -(std::min)(0, digits_behind));
  std::ostringstream text;
  text << std::fixed << std::setprecision((std::max)(0, digits_behind))
       << (unit > 1.0 ? std::round(value / unit) * unit : value);
  return text.str();
}

inline std::string readable(const std::optional<double>& value)
{
  return value ? readable(*value) : "-";
}

// Never rounded up: what is shown as 1 is 1.
inline std::string readable_validity(const std::optional<double>& value)
{
  if (!value) {
    return "-";
  }
  std::ostringstream text;
  text << std::floor(*value * 1e6) / 1e6;
  return text.str();
}

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

#endif // SCENARIO_RUNNER_NUMBER_TEXT_H
