// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The trials of ./dev bench robustness inside of WebAssembly, one call for each, but for those with
// a kernel of exact constructions: nothing for web pages has one, and without GMP CGAL's fails on
// coordinates near the largest double.

#include "benchmark/Dynamic_Delaunay_triangulation_2/robustness/Robustness_trial.h"

#include <emscripten/emscripten.h>

#include <cstdint>
#include <string>

namespace {

robustness::Results results;

} // namespace

extern "C" {

// The seed is that of ./dev bench robustness, and the trial's number.
EMSCRIPTEN_KEEPALIVE void run_trial(double seed, double trial)
{
  const auto number = static_cast<std::uint64_t>(trial);
  const auto its_seed = robustness::seed_of_trial(static_cast<std::uint64_t>(seed), number);
  robustness::Robustness_trial its_trial(its_seed, "", robustness::Arithmetic());
  if (!its_trial.setup().constructs_exactly) {
    its_trial.run(number, robustness::operations_of_trial, nullptr, results, [](std::size_t) {});
  }
}

// What has been counted: operations, wrong, lost, crashed.
EMSCRIPTEN_KEEPALIVE double count(int which)
{
  using robustness::Fault;
  const robustness::Counts total = results.total();
  switch (which) {
  case 0:
    return static_cast<double>(total.number_of_operations());
  case 1:
    return static_cast<double>(total[Fault::WRONG]);
  case 2:
    return static_cast<double>(total[Fault::LOST]);
  default:
    return static_cast<double>(total[Fault::CRASHED]);
  }
}

// A line for each trial that found a fault.
EMSCRIPTEN_KEEPALIVE const char* findings()
{
  static std::string text;
  text.clear();
  for (const robustness::Found& found : results.findings) {
    text += "trial " + std::to_string(found.trial) + ", " + found.family + ", " + found.setup +
            ", operation " + std::to_string(found.operation) + ": " + found.what + '\n';
  }
  return text.c_str();
}

} // extern "C"
