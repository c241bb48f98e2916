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

// A validator for options whose text `check` may change; it throws std::invalid_argument if the
// text is wrong.
template <class Check>
CLI::Validator validator(Check check)
{
  const auto message = [check](std::string& text) -> std::string {
    try {
      check(text);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  return {message, ""};
}

// A validator for options of whole numbers. Unlike CLI::Range its message says "from", and "010" is
// not taken for 8.
inline CLI::Validator whole_number(std::uint64_t lowest, std::uint64_t highest)
{
  return validator([lowest, highest](std::string& text) {
    text = std::to_string(count_argument(text, lowest, highest));
  });
}

// A validator for numbers that need not be whole.
inline CLI::Validator number(const scenario::Range& range)
{
  return validator([range](const std::string& text) { number_argument(text, range); });
}

// An option with a syntax of its own: `take` gets the text after it, and throws
// std::invalid_argument if the text is wrong.
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
