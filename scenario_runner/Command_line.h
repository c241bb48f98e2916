// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_COMMAND_LINE_H
#define SCENARIO_RUNNER_COMMAND_LINE_H

#include "scenario_runner/Number_text.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace run {

// For CLI11's options of whole numbers, as CLI::Range is, which says no "from" and takes "010" for
// 8.
inline CLI::Validator whole_number(std::uint64_t lowest, std::uint64_t highest)
{
  const auto check = [lowest, highest](std::string& text) {
    try {
      text = std::to_string(count_argument(text, lowest, highest));
      return std::string();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  return {check, ""};
}

// Numbers that need not be whole.
inline CLI::Validator number(const scenario::Range& range)
{
  const auto check = [range](std::string& text) {
    try {
      number_argument(text, range);
      return std::string();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  return {check, ""};
}

// An option with a syntax of its own: `take` gets the text after it and throws
// std::invalid_argument if it dislikes it.
template <class Take>
void add_option(CLI::App& app, const std::string& name, const std::string& value,
                const std::string& description, Take take)
{
  const auto checked_take = [name, take](const std::string& text) {
    try {
      take(text);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(name, error.what());
    }
  };
  app.add_option_function<std::string>(name, checked_take, description)->type_name(value);
}

} // namespace run

#endif // SCENARIO_RUNNER_COMMAND_LINE_H
