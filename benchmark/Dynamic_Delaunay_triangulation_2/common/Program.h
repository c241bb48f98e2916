// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_PROGRAM_H
#define COMMON_PROGRAM_H

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace common {

// The command that reproduces these results: "./dev bench NAME ...", without the output files.
inline std::string command_of(const std::string& name, int argc, const char* const* argv)
{
  std::string command = "./dev bench " + name;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--output") {
      ++i;
    } else if (argument.compare(0, 9, "--output=") != 0) {
      command += ' ' + argument;
    }
  }
  return command;
}

// Calls `run(options, command)` with what `add_options(app, options)` made of the command line;
// it returns whether everything was right.
template <class Options, class Add_options, class Run>
int run_program(const std::string& name, int argc, const char* const* argv,
                const Add_options& add_options, const Run& run)
{
  CLI::App app("", name);
  try {
    Options options;
    add_options(app, options);
    app.parse(argc, argv);
    return run(options, command_of(name, argc, argv)) ? 0 : 1;
  } catch (const CLI::ParseError& error) { // or help
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
    return 1;
  }
}

template <class Value>
CLI::Option* add_option(CLI::App& app, const std::string& name, Value& value,
                        const std::string& type, const std::string& description,
                        const CLI::Validator& check = {})
{
  return app.add_option(name, value, description)->type_name(type)->check(check);
}

// An option that may be given several times, with one value each.
inline void add_repeated(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                         const std::string& type, const std::string& description,
                         const CLI::Validator& check = {})
{
  add_option(app, name, values, type, description, check)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

} // namespace common

#endif // COMMON_PROGRAM_H
