// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Number_text.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace run {

namespace decimal = CGAL::Dynamic_Delaunay_triangulations_2::internal;

std::string number_text(double value, int digits)
{
  return decimal::printed_number("%.*g", digits, value);
}

std::string fixed_text(double value, int digits)
{
  return decimal::printed_number("%.*f", digits, value);
}

std::string number_text(double value)
{
  std::string text;
  decimal::append_number(text, value);
  return text;
}

std::string readable(double value)
{
  if (value == 0.0) {
    return "0";
  }
  const double size = std::abs(value);
  const int digits_before = size < 1.0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
  const int digits_behind = 3 - digits_before;
  const double unit = std::pow(10.0, -(std::min)(0, digits_behind));
  return fixed_text(unit > 1.0 ? std::round(value / unit) * unit : value,
                    (std::max)(0, digits_behind));
}

std::string readable(const std::optional<double>& value)
{
  return value ? readable(*value) : "-";
}

std::string readable_validity(const std::optional<double>& value)
{
  return value ? number_text(std::floor(*value * 1e6) / 1e6, 6) : "-";
}

std::uint64_t count_argument(const std::string& text, std::uint64_t lowest, std::uint64_t highest)
{
  std::uint64_t value = 0;
  if (!is_number(text, value) || value < lowest || value > highest) {
    throw std::invalid_argument("'" + text + "' is not a whole number from " +
                                std::to_string(lowest) + " to " + std::to_string(highest));
  }
  return value;
}

double number_argument(const std::string& text, const scenario::Range& range)
{
  double value = 0.0;
  if (!is_number(text, value) || !range.contains(value)) {
    throw std::invalid_argument("'" + text + "' is not a number " + range.text());
  }
  return value;
}

} // namespace run
