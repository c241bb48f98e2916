// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_CASE_LIST_H
#define SPEED_CASE_LIST_H

#include "Speed_summary.h"
#include "Speed_table_reporter.h"

#include <benchmark/benchmark.h>

#include <exception>
#include <functional>
#include <string>

namespace speed {

// What a case hands over.
struct Case_result
{
  Figures figures{};
  double seconds = 0.0; // that were timed
  std::string note{};
};

// Registers cases as benchmarks, each of a single iteration, and remembers whether one has failed.
// It has to outlive them.
class Case_list
{
public:
  using Work = std::function<Case_result()>;

  Case_list() = default;
  Case_list(const Case_list&) = delete;
  Case_list& operator=(const Case_list&) = delete;

  void add(const Table& table, const std::string& name, const Work& work)
  {
    m_tables[name] = &table;
    benchmark::RegisterBenchmark(name.c_str(),
                                 [this, work](benchmark::State& state) { run(state, work); })
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }

  const Tables& tables() const { return m_tables; }
  bool has_failed() const { return m_has_failed; }

private:
  void run(benchmark::State& state, const Work& work)
  {
    for (auto _ : state) {
      try {
        report(state, work());
      } catch (const std::exception& error) {
        m_has_failed = true;
        state.SkipWithError(error.what());
        break;
      }
    }
  }

  static void report(benchmark::State& state, const Case_result& result)
  {
    for (const auto& [name, value] : result.figures) {
      state.counters[name] = value;
    }
    state.SetIterationTime(result.seconds);
    state.SetLabel(result.note);
  }

  Tables m_tables;
  bool m_has_failed = false;
};

} // namespace speed

#endif // SPEED_CASE_LIST_H
