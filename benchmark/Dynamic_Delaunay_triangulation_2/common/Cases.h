// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_CASES_H
#define COMMON_CASES_H

#include "scenario_runner/Measurement.h"
#include "Table.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace common {

// The figures of a case, by name. Figures that no frame yields are missing.
using Figures = std::map<std::string, double>;

// Median and quartiles.
inline void add_spread(Figures& figures, const std::string& name, const std::string& quartile,
                       const std::vector<double>& values)
{
  const run::Spread spread = *run::spread(values);
  figures[name] = spread.median;
  figures[quartile + "q1"] = spread.low_quartile;
  figures[quartile + "q3"] = spread.high_quartile;
}

// The results of a case.
struct Case_result
{
  Figures figures{};
  double seconds = 0.0; // that were timed
};

// The table of a group of cases; its columns are figures.
struct Case_table
{
  std::string title;
  std::vector<Column> columns;
};

using Case_tables = std::map<std::string, const Case_table*>; // by the names of the cases

// Registers cases as benchmarks of a single iteration each, and remembers whether one has failed.
// The list has to outlive their run.
class Case_list
{
public:
  using Work = std::function<Case_result()>;

  Case_list() = default;
  Case_list(const Case_list&) = delete;
  Case_list& operator=(const Case_list&) = delete;

  void add(const Case_table& table, const std::string& name, const Work& work)
  {
    m_tables[name] = &table;
    benchmark::RegisterBenchmark(name.c_str(),
                                 [this, work](benchmark::State& state) { run(state, work); })
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }

  const Case_tables& tables() const { return m_tables; }
  bool has_failed() const { return m_has_failed; }

private:
  void run(benchmark::State& state, const Work& work)
  {
    for (auto _ : state) {
      try {
        const Case_result result = work();
        state.counters.insert(result.figures.begin(), result.figures.end());
        state.SetIterationTime(result.seconds);
      } catch (const std::exception& error) {
        m_has_failed = true;
        state.SkipWithError(error.what());
        break;
      }
    }
  }

  Case_tables m_tables;
  bool m_has_failed = false;
};

// Google Benchmark's own table has a column for every counter, in alphabetical order, behind three
// that say nothing here. This one has a title and the columns of a group of cases in their order.
class Case_reporter : public benchmark::ConsoleReporter
{
public:
  explicit Case_reporter(const Case_tables& tables)
    : ConsoleReporter(OO_None)
    , m_tables(tables)
  {
    for (const auto& [name, table] : tables) {
      m_name_width = (std::max)(m_name_width, static_cast<int>(name.size()));
    }
  }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs) {
      if (run.aggregate_unit == benchmark::kPercentage) {
        continue; // of repetitions; it does not fit the columns
      }
      const Case_table& table = *m_tables.at(run.run_name.function_name);
      if (m_last_table != &table) {
        GetOutputStream() << '\n' << table.title << '\n';
        m_table.emplace(GetOutputStream(), m_name_width, table.columns).write_head("");
        m_last_table = &table;
      }
      write_row(run);
    }
  }

private:
  void write_row(const Run& run)
  {
    std::string name = run.run_name.function_name;
    if (run.run_type == Run::RT_Aggregate) {
      name += ' ' + run.aggregate_name;
    }
    if (run.error_occurred) {
      m_table->write_cells(name, {}, "  " + run.error_message);
      return;
    }
    std::vector<std::string> cells;
    for (const Column& column : m_table->columns()) {
      const auto counter = run.counters.find(column.name);
      cells.push_back(counter == run.counters.end() ? "-"
                                                    : cell(counter->second.value, column.decimals));
    }
    m_table->write_cells(name, cells);
  }

  const Case_tables& m_tables;
  int m_name_width = 0;
  const Case_table* m_last_table = nullptr;
  std::optional<Table> m_table;
};

// Runs the cases that Google Benchmark's options ask for, and writes its JSON to `path`, unless the
// options name another file. False if any has failed, or none was there.
inline bool run_cases(const Case_list& cases, int argc, char** argv, const std::string& path)
{
  std::vector<std::string> options(argv, argv + argc);
  const auto find = [&](const std::string& start) {
    return std::find_if(options.begin(), options.end(), [&](const std::string& option) {
      return option.compare(0, start.size(), start) == 0;
    });
  };
  const std::string out = "--benchmark_out=";
  if (find(out) == options.end() && find("--benchmark_list_tests") == options.end()) {
    options.push_back(out + path);
  }
  std::vector<char*> arguments;
  for (std::string& option : options) {
    arguments.push_back(option.data());
  }
  int number = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  const auto output = find(out);
  const std::string output_file = output == options.end() ? "" : output->substr(out.size());
  const bool has_format = find("--benchmark_format=") != options.end();
  benchmark::Initialize(&number, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(number, arguments.data())) {
    return false;
  }
  Case_reporter table(cases.tables());
  if (benchmark::RunSpecifiedBenchmarks(has_format ? nullptr : &table) == 0) {
    return false;
  }
  if (!output_file.empty()) {
    std::cerr << "JSON: " << output_file << '\n';
  }
  return !cases.has_failed();
}

// All that the main function of a program of cases has to do; its results go to NAME.json.
template <class Add_cases>
int run_case_program(const std::string& name, const Add_cases& add_cases, int argc, char** argv)
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

} // namespace common

#endif // COMMON_CASES_H
