// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes many random calls of triangulations in space, and checks the triangulation after each call:
// is every point where it has to be, is the triangulation certified and valid, and does it have the
// cells of a fresh triangulation of CGAL's, or, where points are cospherical, cells with empty
// spheres?
//
// A trial is a row of operations on one triangulation. Its family and its seed decide everything
// about it. Columns of the table, all of them counts:
//   operations           calls that change something
//   points               those that were looked at, over all operations
//   flips to rebuilds    from the reports
//   wrong                not what it has to be; a trial ends with its first fault
//   crashed              an exception that was not asked for
// If an operation crashes the program or takes too long, it is reported with its trial. The program
// ends with success only if there are no faults.

#include "common/Program.h"
#include "common/Table.h"
#include "robustness/Trial_seed.h"
#include "robustness/Watchdog.h"
#include "scenario_runner/Progress.h"
#include "test/Dynamic_Delaunay_triangulation_2/space_operations.h"
#include "test/Dynamic_Delaunay_triangulation_2/space_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

using robustness::operations_of_trial;

struct Options
{
  std::uint64_t operations = 1'000'000;
  std::uint64_t seed = 1;
  std::vector<std::uint64_t> trial; // the one that is repeated, if there is one
  std::string family;               // empty: all
  double time_limit = 60.0;         // seconds
};

struct Family
{
  std::string name;
  double extent, grid, thickness; // the grid is a share of the extent
  std::size_t most_points;
  bool is_exact_kernel = false;
};

const std::vector<Family>& families()
{
  // Points may leave their cube by some powers of two.
  static const double huge = (std::min)(
      1e150, CGAL::Dynamic_Delaunay_triangulations_3::internal::coordinate_limit * 0x1p-20);
  static const std::vector<Family> all = {{"anywhere", 1, 0, 1, 40},
                                          {"hundreds", 1, 0, 1, 300},
                                          {"few", 1, 0, 1, 9},
                                          {"coarse_lattice", 1, 0.25, 1, 40},
                                          {"fine_lattice", 1, 0.0625, 1, 60},
                                          {"few_on_lattice", 1, 0.5, 1, 12},
                                          {"thin_slab", 1, 0, 1e-6, 40},
                                          {"flat_lattice", 1, 0.125, 0.125, 40},
                                          {"tiny", 1e-150, 0, 1, 40},
                                          {"tiny_lattice", 1e-150, 0.25, 1, 40},
                                          {"huge", huge, 0, 1, 40},
                                          {"huge_lattice", huge, 0.25, 1, 40},
                                          {"exact_kernel", 1, 0, 1, 20, true}};
  return all;
}

std::vector<std::string> family_names()
{
  std::vector<std::string> names;
  for (const Family& family : families()) {
    names.push_back(family.name);
  }
  return names;
}

struct Results
{
  std::uint64_t operations = 0, points = 0, wrong = 0, crashed = 0;
  space_operations::Counts counts;
};

class Trials
{
public:
  explicit Trials(const Options& options)
    : m_options(options)
    , m_watchdog(options.time_limit)
    , m_watched(m_watchdog.add_thread())
    , m_results(families().size())
  {
    robustness::this_thread_watched = &m_watched;
  }

  void run()
  {
    run::Progress_display progress(m_options.operations, true, "operation");
    for (std::uint64_t trial = 0; total() < m_options.operations; ++trial) {
      const std::size_t family = family_of(trial);
      run_trial(family, robustness::seed_of_trial(m_options.seed, trial));
      progress.show(total());
    }
  }
  void repeat(std::uint64_t seed) { run_trial(family_of(0), seed); }

  bool has_faults() const
  {
    for (const Results& results : m_results) {
      if (results.wrong + results.crashed != 0) {
        return true;
      }
    }
    return false;
  }

  void write(std::ostream& out) const
  {
    constexpr int name_width = 16, width = 11;
    std::vector<common::Column> columns;
    for (const char* const name : {"operations", "points", "flips", "held", "relocated", "merged",
                                   "parted", "rebuilds", "wrong", "crashed"}) {
      columns.push_back({name, width});
    }
    common::Table table(out, name_width, columns);
    table.write_head("family");
    for (std::size_t i = 0; i < families().size(); ++i) {
      const Results& r = m_results[i];
      const space_operations::Counts& c = r.counts;
      std::vector<std::string> cells;
      for (const std::uint64_t number :
           {r.operations, r.points, std::uint64_t(c.flips), std::uint64_t(c.held),
            std::uint64_t(c.relocated), std::uint64_t(c.merged), std::uint64_t(c.parted),
            std::uint64_t(c.rebuilds), r.wrong, r.crashed}) {
        cells.push_back(std::to_string(number));
      }
      if (r.operations != 0) {
        table.write_cells(families()[i].name, cells);
      }
    }
  }

  std::uint64_t total() const
  {
    std::uint64_t total = 0;
    for (const Results& results : m_results) {
      total += results.operations;
    }
    return total;
  }

private:
  std::size_t family_of(std::uint64_t trial) const
  {
    const std::vector<std::string> names = family_names();
    const auto found = std::find(names.begin(), names.end(), m_options.family);
    return found == names.end() ? std::size_t(trial % names.size())
                                : std::size_t(found - names.begin());
  }

  void run_trial(std::size_t number, std::uint64_t seed)
  {
    const Family& family = families()[number];
    m_watched.seed = seed;
    m_watched.family = family.name.c_str();
    if (family.is_exact_kernel) {
      run_trial<CGAL::Exact_predicates_exact_constructions_kernel>(family, seed, m_results[number]);
    } else {
      run_trial<CGAL::Exact_predicates_inexact_constructions_kernel>(family, seed,
                                                                     m_results[number]);
    }
    m_watched.since = 0;
  }

  template <class Kernel>
  void run_trial(const Family& family, std::uint64_t seed, Results& results)
  {
    space_operations::Program<CGAL::Dynamic_Delaunay_triangulation_3<Kernel>> program(
        seed, family.extent, family.grid * family.extent, family.thickness);
    std::size_t done = 0;
    try {
      begin(done);
      program.insert(seed % family.most_points);
      while (done < operations_of_trial && total() < m_options.operations) {
        begin(++done);
        step(program, seed >> 8, done);
        ++results.operations;
        results.points += program.points().size();
        space_oracle::expect_exact(program.triangulation(), program.points());
        if (program.points().size() > 2 * family.most_points) {
          program.remove(program.points().size() / 2);
        }
      }
    } catch (const testing::internal::GoogleTestFailureException& failure) {
      ++results.wrong;
      report(failure, family, seed, done);
    } catch (const std::exception& error) {
      ++results.crashed;
      report(error, family, seed, done);
    }
    add(program.counts(), results.counts);
  }

  // Most trials mix everything; others move few points, or go on from checkpoints.
  template <class Program>
  static void step(Program& program, std::uint64_t kind, std::size_t number)
  {
    if (kind % 8 == 0) {
      program.move_some();
    } else if (kind % 8 == 1) {
      program.move_some_a_little();
    } else {
      program.do_something();
    }
    if (kind % 16 == 2 && number % 16 == 0) {
      program.interrupt();
    }
  }

  void begin(std::size_t operation)
  {
    m_watched.operation = operation;
    m_watched.since = robustness::Watched_thread::now();
  }

  static void report(const std::exception& error, const Family& family, std::uint64_t seed,
                     std::size_t operation)
  {
    std::cout << "after " << operation << " operations: " << error.what() << "\n  --family "
              << family.name << " --trial " << seed << '\n';
  }

  static void add(const space_operations::Counts& some, space_operations::Counts& all)
  {
    all.flips += some.flips;
    all.held += some.held;
    all.relocated += some.relocated;
    all.merged += some.merged;
    all.parted += some.parted;
    all.rebuilds += some.rebuilds;
  }

  const Options& m_options;
  robustness::Watchdog m_watchdog;
  robustness::Watched_thread& m_watched;
  std::vector<Results> m_results;
};

void add_options(CLI::App& app, Options& options)
{
  constexpr double max_operations = 1e12, max_time_limit = 1e6;
  app.description(
      "Does random things to triangulations in space, and compares them with fresh ones "
      "of CGAL's after each of them.");
  common::add_option(app, "--operations", options.operations, "N",
                     "how many, of all families; default 1000000", CLI::Range(1.0, max_operations));
  common::add_option(app, "--seed", options.seed, "N", "what everything is drawn from; default 1");
  common::add_option(app, "--family", options.family, "NAME", "this one only",
                     CLI::IsMember(family_names()));
  app.add_option("--trial", options.trial, "repeat one trial, with --family as it was reported")
      ->type_name("SEED")
      ->expected(1);
  common::add_option(app, "--time_limit", options.time_limit, "SECONDS",
                     "an operation that takes longer ends the program; default 60",
                     CLI::Range(1e-3, max_time_limit));
}

// Whether everything was right.
bool run_space_robustness(const Options& options, const std::string& command)
{
  testing::GTEST_FLAG(throw_on_failure) = true; // as faults
  robustness::watch_signals();
  Trials trials(options);
  if (options.trial.empty()) {
    trials.run();
  } else {
    trials.repeat(options.trial.front());
  }
  trials.write(std::cout);
  std::cout << '\n'
            << trials.total() << " operations, " << (trials.has_faults() ? "with" : "without")
            << " faults; seed " << options.seed << '\n'
            << command << '\n';
  return !trials.has_faults();
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Options>("space_robustness", argc, argv, add_options,
                                      run_space_robustness);
}
