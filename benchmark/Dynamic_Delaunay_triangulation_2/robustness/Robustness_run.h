// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ROBUSTNESS_RUN_H
#define ROBUSTNESS_ROBUSTNESS_RUN_H

#include "Arithmetic_subject.h"
#include "Counts.h"
#include "Decisions.h"
#include "Families.h"
#include "Finding.h"
#include "Robustness_options.h"
#include "Setup.h"
#include "Subject_choice.h"
#include "Told_subject.h"
#include "Trial.h"
#include "Watchdog.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace robustness {

inline constexpr std::size_t operations_of_trial = 200;

// What one seed decides.
struct Trial_start
{
  Random_decisions decisions;
  std::size_t family;
  Setup setup;

  Trial_start(std::uint64_t seed, const std::optional<std::size_t>& wanted_family)
    : decisions(seed)
    , family(any_family(decisions))
  {
    family = wanted_family.value_or(family);
    setup = any_setup(families()[family], decisions);
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
  std::vector<Counts> families = std::vector<Counts>(robustness::families().size());
  std::map<std::string, Counts> classifiers;
  std::vector<Found> findings;

  Counts total() const
  {
    Counts total;
    for (const Counts& counts : families) {
      total += counts;
    }
    return total;
  }

  Results& operator+=(Results other)
  {
    for (std::size_t i = 0; i < families.size(); ++i) {
      families[i] += other.families[i];
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
    m_results += std::move(results);
  }

  void run_trial(std::uint64_t number, std::uint64_t seed, std::size_t operations,
                 Watched_thread& watched, Results& results, bool is_told) const
  {
    Trial_start start(seed, m_options.family);
    const Family& family = families()[start.family];
    const auto subject = make_subject(start.setup);
    Arithmetic_subject called(*subject, arithmetic_of(start.setup));
    Told_subject told(called, std::cout);
    if (is_told) {
      std::cout << family.name << ": " << start.setup.text() << std::endl;
    }
    Counts counts;
    Trial trial(family, start.setup, is_told ? static_cast<Subject&>(told) : called,
                start.decisions, counts);
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
    results.families[start.family] += counts;
    results.classifiers[start.setup.classifier_name()] += counts;
  }

  // Numbers of exact kernels are intervals first, which are wrong where subnormals are zero, before
  // any triangulation sees them.
  const Arithmetic& arithmetic_of(const Setup& setup) const
  {
    return setup.constructs_exactly && m_options.arithmetic.flushes_subnormals
               ? m_usual_arithmetic
               : m_options.arithmetic;
  }

  const Robustness_options& m_options;
  Arithmetic m_usual_arithmetic;
  std::uint64_t m_trials;
  Watchdog m_watchdog;
  std::atomic<std::uint64_t> m_next{0};
  std::mutex m_mutex;
  Results m_results;
};

} // namespace robustness

#endif // ROBUSTNESS_ROBUSTNESS_RUN_H
