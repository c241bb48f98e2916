// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_RUN_CASES_H
#define SPEED_RUN_CASES_H

#include "Benchmark_options.h"
#include "Case_list.h"
#include "Speed_table_reporter.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <exception>
#include <iostream>
#include <string>

namespace speed {

inline std::size_t write_cases(const Case_list& cases, const Benchmark_options& options)
{
  if (!options.wants_own_table()) {
    return benchmark::RunSpecifiedBenchmarks();
  }
  Speed_table_reporter table(cases.tables());
  return benchmark::RunSpecifiedBenchmarks(&table);
}

// Runs those that Google Benchmark's options ask for. False if any has failed, or none was there.
inline bool run_cases(const Case_list& cases, int argc, char** argv,
                      const std::string& usual_output_file)
{
  Benchmark_options options(argc, argv, usual_output_file);
  if (!options.initialize() || write_cases(cases, options) == 0) {
    return false;
  }
  if (!options.output_file().empty()) {
    std::cerr << "JSON: " << options.output_file() << '\n';
  }
  return !cases.has_failed();
}

// All that the main function of a program of cases has to do; its results go to NAME.json, unless
// the options name another file.
template <class Add_cases>
int run_program(const std::string& name, const Add_cases& add_cases, int argc, char** argv)
{
  try {
    Case_list cases;
    add_cases(cases);
    return run_cases(cases, argc, argv, RESULTS_DIR "/" + name + ".json") ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 1;
  }
}

} // namespace speed

#endif // SPEED_RUN_CASES_H
