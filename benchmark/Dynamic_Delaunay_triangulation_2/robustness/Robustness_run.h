// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ROBUSTNESS_RUN_H
#define ROBUSTNESS_ROBUSTNESS_RUN_H

#include "../random_operations/Make_subject.h"
#include "../random_operations/Trial.h"
#include "Watchdog.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace robustness {

using namespace random_operations;

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

inline constexpr std::size_t operations_of_trial = 200;

// What one seed decides.
struct Trial_start
{
  Random_decisions decisions;
  const Family* family;
  Setup setup;

  // `family_name` is that of the only one that is wanted, or empty.
  Trial_start(std::uint64_t seed, const std::string& family_name)
    : decisions(seed)
    , family(&any_family(decisions))
  {
    family = family_name.empty() ? family : &named(families(), family_name, "family");
    setup = any_setup(*family, decisions);
  }
};

struct Found
{
  std::uint64_t trial;
  std::uint64_t seed;
  std::string family, setup;
  std::size_t operation;
  Fault fault;
  std::string what;
};

struct Results
{
  std::map<std::string, Counts> families;
  std::map<std::string, Counts> classifiers;
  std::vector<Found> findings;

  Counts total() const
  {
    Counts total;
    for (const auto& [name, counts] : families) {
      total += counts;
    }
    return total;
  }

  Results& operator+=(const Results& other)
  {
    for (const auto& [name, counts] : other.families) {
      families[name] += counts;
    }
    for (const auto& [name, counts] : other.classifiers) {
      classifiers[name] += counts;
    }
    findings.insert(findings.end(), other.findings.begin(), other.findings.end());
    return *this;
  }
};

// Seeds that have nothing to do with each other (SplitMix64).
inline std::uint64_t seed_of_trial(std::uint64_t seed, std::uint64_t trial)
{
  std::uint64_t x = (seed + 1) * 0x9E3779B97F4A7C15u + trial * 0xD1B54A32D192ED03u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

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

  // A single one, which tells what it does.
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
    Trial_start start(seed, m_options.family);
    const Family& family = *start.family;
    const auto subject = make_subject(start.setup);
    if (is_told) {
      std::cout << family.name << ": " << start.setup.text() << std::endl;
    }
    Counts counts;
    Trial trial(family, start.setup, *subject, start.decisions, counts,
                {arithmetic_of(start.setup), is_told ? &std::cout : nullptr});
    this_thread_watched = &watched;
    watched.seed = seed;
    watched.family = family.name.c_str();
    try {
      trial.run(operations, [&] {
        watched.operation = trial.operations_done();
        watched.since = Watched_thread::now();
      });
    } catch (const Finding& finding) {
      results.findings.push_back({number, seed, family.name, start.setup.text(),
                                  trial.operations_done(), finding.fault(), finding.what()});
    }
    watched.since = 0;
    results.families[family.name] += counts;
    results.classifiers[start.setup.classifier_name()] += counts;
  }

  // Numbers of exact kernels are intervals first, which are wrong where subnormals are zero, before
  // any triangulation sees them.
  Arithmetic arithmetic_of(const Setup& setup) const
  {
    return setup.constructs_exactly && m_arithmetic.flushes_subnormals ? Arithmetic()
                                                                       : m_arithmetic;
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
