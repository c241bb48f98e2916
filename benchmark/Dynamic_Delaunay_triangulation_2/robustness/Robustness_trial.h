// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ROBUSTNESS_TRIAL_H
#define ROBUSTNESS_ROBUSTNESS_TRIAL_H

#include "../random_operations/Arithmetic.h"
#include "../random_operations/Counts.h"
#include "../random_operations/Make_subject.h"
#include "../random_operations/Trial.h"
#include "Trial_seed.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace robustness {

using namespace random_operations;

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

// A trial whose every decision comes from one seed, on a triangulation of its own.
class Robustness_trial
{
public:
  // `family_name` is that of the only family that is wanted, or empty.
  Robustness_trial(std::uint64_t seed, const std::string& family_name, const Arithmetic& arithmetic)
    : m_seed(seed)
    , m_arithmetic(arithmetic)
    , m_decisions(seed)
    , m_family(&any_family(m_decisions)) // is drawn in any case
  {
    m_family = family_name.empty() ? m_family : &named(families(), family_name, "family");
    m_setup = any_setup(*m_family, m_decisions);
  }

  const Family& family() const { return *m_family; }
  const Setup& setup() const { return m_setup; }

  // Runs the trial up to its first fault. Writes what it does to `told`, if that is not null. Calls
  // `before(operations_done)` before each operation.
  template <class Before>
  void run(std::uint64_t number, std::size_t operations, std::ostream* told, Results& results,
           const Before& before)
  {
    if (told != nullptr) {
      *told << family().name << ": " << setup().text() << std::endl;
    }
    const auto subject = make_subject(setup());
    Counts counts;
    Trial trial(family(), setup(), *subject, m_decisions, counts, {arithmetic_in_use(), told});
    try {
      trial.run(operations, [&] { before(trial.operations_done()); });
    } catch (const Finding& finding) {
      results.findings.push_back({number, m_seed, family().name, setup().text(),
                                  trial.operations_done(), finding.fault(), finding.what()});
    }
    results.families[family().name] += counts;
    results.classifiers[setup().classifier_name()] += counts;
  }

private:
  // Exact kernels run in the default mode where subnormals would count as zero: their numbers are
  // intervals at first, and would be wrong before any triangulation gets them.
  Arithmetic arithmetic_in_use() const
  {
    return setup().constructs_exactly && m_arithmetic.flushes_subnormals ? Arithmetic()
                                                                         : m_arithmetic;
  }

  std::uint64_t m_seed;
  Arithmetic m_arithmetic;
  Random_decisions m_decisions;
  const Family* m_family;
  Setup m_setup;
};

} // namespace robustness

#endif // ROBUSTNESS_ROBUSTNESS_TRIAL_H
