// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_COMMAND_LINE_H
#define SCENARIO_RUNNER_COMMAND_LINE_H

#include <CLI/CLI.hpp>

#include <stdexcept>
#include <string>

namespace run {

// `take` gets the text after the option and throws std::invalid_argument if it dislikes it.
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
