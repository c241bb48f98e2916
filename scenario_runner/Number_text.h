// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_NUMBER_TEXT_H
#define SCENARIO_RUNNER_NUMBER_TEXT_H

#include "scenario_runner/Text_input.h"

#include <cstdint>
#include <optional>
#include <string>

namespace run {

// The shortest text that is read as the same number again; or with `digits` significant digits,
// without trailing zeros. In no locale, with an exponent where that is shorter.
std::string number_text(double value);
std::string number_text(double value, int digits);

// A text with `digits` digits behind the point, and never an exponent.
std::string fixed_text(double value, int digits);

// For people: three significant digits, never an exponent; a dash for none.
std::string readable(double value);
std::string readable(const std::optional<double>& value);

// A validity, never rounded up: only 1 is shown as 1.
std::string readable_validity(const std::optional<double>& value);

using scenario::is_number;

// Reads a number in the range.
// \throws std::invalid_argument, with the range in the message
std::uint64_t count_argument(const std::string& text, std::uint64_t lowest, std::uint64_t highest);
double number_argument(const std::string& text, const scenario::Range& range);

} // namespace run

#endif // SCENARIO_RUNNER_NUMBER_TEXT_H
