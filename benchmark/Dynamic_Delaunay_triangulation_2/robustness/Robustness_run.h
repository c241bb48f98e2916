// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ROBUSTNESS_RUN_H
#define ROBUSTNESS_ROBUSTNESS_RUN_H

#include "Robustness_trial.h"
#include "Watchdog.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace robustness {

// What a person asks for.
struct Robustness_options
{
  std::uint64_t operations = 10'000'000;
  std::uint64_t seed = 1;
  unsigned threads = (std::max)(1u, std::thread::hardware_concurrency());
  double time_limit = 20.0;         // seconds
  std::vector<std::uint64_t> trial; // the one that is repeated, if there is one
  std::string family, report;       // empty: all, none
  std::string arithmetic = "usual";
};

// Runs trials on several threads. What comes out does not depend on their number.
class Robustness_run
{
public:
  explicit Robustness_run(const Robustness_options& options)
    : m_options(options)
    , m_arithmetic(named(all_arithmetic(), options.arithmetic, "arithmetic"))
    , m_trials((options.operations + operations_of_trial - 1) / operations_of_trial)
    , m_watchdog(options.time_limit)
  {
  }

  // Calls `show(operations)` now and then.
  template <class Show>
  Results run(const Show& show)
  {
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < m_options.threads; ++i) {
      threads.emplace_back([&] { work(show); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    std::sort(m_results.findings.begin(), m_results.findings.end(),
              [](const Found& f, const Found& g) { return f.trial < g.trial; });
    return std::move(m_results);
  }

  // Repeats a single trial, which writes what it does.
  Results repeat(std::uint64_t seed)
  {
    Results results;
    run_trial(0, seed, operations_of_trial, m_watchdog.add_thread(), results, true);
    return results;
  }

private:
  template <class Show>
  void work(const Show& show)
  {
    Results results;
    Watched_thread& watched = m_watchdog.add_thread();
    for (std::uint64_t trial = m_next++; trial < m_trials; trial = m_next++) {
      const std::uint64_t first = trial * operations_of_trial;
      run_trial(trial, seed_of_trial(m_options.seed, trial),
                std::min<std::uint64_t>(operations_of_trial, m_options.operations - first), watched,
                results, false);
      const std::lock_guard<std::mutex> lock(m_mutex);
      show(first);
    }
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_results += results;
  }

  void run_trial(std::uint64_t number, std::uint64_t seed, std::size_t operations,
                 Watched_thread& watched, Results& results, bool is_told) const
  {
    Robustness_trial trial(seed, m_options.family, m_arithmetic);
    this_thread_watched = &watched;
    watched.seed = seed;
    watched.family = trial.family().name.c_str();
    trial.run(number, operations, is_told ? &std::cout : nullptr, results,
              [&](std::size_t operations_done) {
                watched.operation = operations_done;
                watched.since = Watched_thread::now();
              });
    watched.since = 0;
  }

  const Robustness_options& m_options;
  Arithmetic m_arithmetic;
  std::uint64_t m_trials;
  Watchdog m_watchdog;
  std::atomic<std::uint64_t> m_next{0};
  std::mutex m_mutex;
  Results m_results;
};

} // namespace robustness

#endif // ROBUSTNESS_ROBUSTNESS_RUN_H
