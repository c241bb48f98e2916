// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes many random calls of triangulations in space, open and periodic, and checks the
// triangulation after each call: is every point where it has to be, is the triangulation certified
// and valid, and does it have the cells of a fresh triangulation of CGAL's, or, where points are
// cospherical, cells with empty spheres? In periodic space, where the triangulation is unique, it
// has to be that of a fresh one, and at times exact fractions examine it: always where points are
// few.
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
#include "test/Dynamic_Delaunay_triangulation_2/periodic_space_operations.h"
#include "test/Dynamic_Delaunay_triangulation_2/space_operations.h"
#include "test/Dynamic_Delaunay_triangulation_2/space_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

using periodic_space_operations::Cell;
using robustness::operations_of_trial;

struct Options
{
  std::uint64_t operations = 1'000'000;
  std::uint64_t seed = 1;
  std::vector<std::uint64_t> trial; // the one that is repeated, if there is one
  std::string family, space;        // empty: all
  double time_limit = 60.0;         // seconds
};

struct Family
{
  std::string name;
  double extent, grid, thickness; // the grid is a share of the extent
  std::size_t most_points;
  bool is_exact_kernel = false;
  std::optional<periodic_space_operations::Setting> periodic = {}; // then extent to thickness are 1
  std::size_t crystal = 0; // most unit cells of a crystal along each vector, in the beginning
};

Family periodic(const std::string& name, std::size_t most_points,
                const periodic_space_operations::Setting& setting, std::size_t crystal = 0)
{
  return {"periodic_" + name, 1, 0, 1, most_points, false, setting, crystal};
}

// Cells, scales, grids, how far images are, how often points meet, and whether cells deform most.
std::vector<Family> periodic_families()
{
  const Cell unit(1, 1, 1);
  const Cell triclinic({1, 0.1, 0.2}, {0.5, -0.9, 0.1}, {1.3, 0.2, 1.1});
  const Cell long_vector({1, 0, 0}, {7.3, 0.9, 0.1}, {-0.4, 5.2, 1.1});
  const Cell film({1, 0.1, 0.2}, {0.5, -0.9, 0.1}), flat({1, 0, 0}, {0, 1, 0});
  const Cell wire(Cell::Coordinates{0.6, 0.2, -0.3}), duct(Cell::Coordinates{1, 0, 0});
  return {periodic("anywhere", 40, {triclinic}),
          periodic("hundreds", 500, {unit}),
          periodic("few", 9, {unit}),
          periodic("one_or_two", 3, {triclinic}),
          periodic("coarse_lattice", 40, {unit, 1, 0.25}),
          periodic("fine_lattice", 60, {unit, 1, 0.0625}),
          periodic("few_on_lattice", 12, {unit, 1, 0.5}),
          periodic("crystal", 60, {unit}, 3),
          periodic("sheared_crystal", 60, {triclinic, 1, 0, 2, 12, true}, 3),
          periodic("crystal_on_grid", 60, {unit, 1, 0.125, 2, 12, true}, 2),
          periodic("deforming", 60, {unit, 1, 0, 2, 12, true}),
          periodic("long_vectors", 40, {long_vector, 1, 0, 2, 12, true}),
          periodic("thin", 40, {Cell(1, 1, 0.03)}),
          periodic("long", 40, {Cell(1, 1, 20)}),
          periodic("unwrapped", 40, {triclinic, 1, 0, 10'000}),
          periodic("unwrapped_lattice", 40, {unit, 1, 0.25, 10'000}),
          periodic("coincident", 60, {triclinic, 1, 0, 2, 2}),
          periodic("coincident_on_grid", 60, {unit, 1, 0.125, 2, 2}),
          periodic("tiny", 40, {triclinic, 0x1p-160}),
          periodic("huge", 40, {triclinic, 0x1p160}),
          periodic("slab", 40, {film}),
          periodic("slab_hundreds", 300, {film}),
          periodic("slab_few", 6, {film}),
          periodic("slab_on_grid", 40, {flat, 1, 0.125}),
          periodic("slab_deforming", 60, {film, 1, 0, 2, 12, true}),
          periodic("slab_coincident", 60, {film, 1, 0, 2, 2}),
          periodic("slab_walls", 150, {flat, 1, 0, 2, 12, false, true}),
          periodic("wire", 40, {wire}),
          periodic("wire_hundreds", 300, {wire}),
          periodic("wire_few", 6, {wire}),
          periodic("wire_on_grid", 40, {duct, 1, 0.125}),
          periodic("wire_deforming", 60, {wire, 1, 0, 2, 12, true}),
          periodic("wire_coincident", 60, {wire, 1, 0, 2, 2}),
          periodic("wire_walls", 150, {duct, 1, 0, 2, 12, false, true})};
}

const std::vector<Family>& families()
{
  // Points may leave their cube by some powers of two.
  static const double huge = (std::min)(
      1e150, CGAL::Dynamic_Delaunay_triangulations_3::internal::coordinate_limit * 0x1p-20);
  static const std::vector<Family> in_open_space = {{"anywhere", 1, 0, 1, 40},
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
  static const std::vector<Family> all = [] {
    std::vector<Family> families = in_open_space;
    for (const Family& family : periodic_families()) {
      families.push_back(family);
    }
    return families;
  }();
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
    constexpr int name_width = 27, width = 11;
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
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < families().size(); ++i) {
      const Family& family = families()[i];
      if (m_options.family.empty()
              ? m_options.space.empty() || family.periodic.has_value() == is_space_periodic()
              : family.name == m_options.family) {
        chosen.push_back(i);
      }
    }
    return chosen[trial % chosen.size()];
  }
  bool is_space_periodic() const { return m_options.space == "periodic"; }

  void run_trial(std::size_t number, std::uint64_t seed)
  {
    const Family& family = families()[number];
    m_watched.seed = seed;
    m_watched.family = family.name.c_str();
    if (family.periodic) {
      run_periodic_trial(family, seed, m_results[number]);
    } else if (family.is_exact_kernel) {
      run_open_trial<CGAL::Exact_predicates_exact_constructions_kernel>(family, seed,
                                                                        m_results[number]);
    } else {
      run_open_trial<CGAL::Exact_predicates_inexact_constructions_kernel>(family, seed,
                                                                          m_results[number]);
    }
    m_watched.since = 0;
  }

  template <class Kernel>
  void run_open_trial(const Family& family, std::uint64_t seed, Results& results)
  {
    space_operations::Program<CGAL::Dynamic_Delaunay_triangulation_3<Kernel>> program(
        seed, family.extent, family.grid * family.extent, family.thickness);
    run_trial(
        family, seed, results, program, [&] { program.insert(seed % family.most_points); },
        [&](std::size_t number) {
          step(program, seed >> 8, number);
          ++results.operations;
          space_oracle::expect_exact(program.triangulation(), program.points());
        });
  }

  void run_periodic_trial(const Family& family, std::uint64_t seed, Results& results)
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    periodic_space_operations::Program<CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel>>
        program(std::mt19937_64(seed), *family.periodic);
    const auto begin_with = [&] {
      if (family.crystal != 0) {
        program.insert_crystal(1 + seed % family.crystal, (seed >> 8) % 3);
      } else {
        program.insert(seed % family.most_points);
      }
    };
    run_trial(family, seed, results, program, begin_with, [&](std::size_t number) {
      constexpr std::size_t few_points = 3, seldom = 16;
      if (program.points().size() < family.most_points / 4) { // more go than come
        program.insert(family.most_points / 4);
      }
      program.do_something();
      ++results.operations;
      program.expect_as_fresh();
      if (program.points().size() <= few_points || number % seldom == 0) {
        program.expect_exact();
      }
    });
  }

  // `operate(number)` does something, and expects the right result.
  template <class Program, class Begin_with, class Operate>
  void run_trial(const Family& family, std::uint64_t seed, Results& results, Program& program,
                 const Begin_with& begin_with, const Operate& operate)
  {
    std::size_t done = 0;
    try {
      begin(done);
      begin_with();
      const std::size_t most = operations_of_trial / (family.periodic ? 2 : 1);
      while (done < most && total() < m_options.operations) {
        begin(++done);
        operate(done);
        results.points += program.points().size();
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
      "Does random things to triangulations in space, open and periodic, and compares them with "
      "fresh ones after each of them.");
  common::add_option(app, "--operations", options.operations, "N",
                     "how many, of all families; default 1000000", CLI::Range(1.0, max_operations));
  common::add_option(app, "--seed", options.seed, "N", "what everything is drawn from; default 1");
  common::add_option(app, "--family", options.family, "NAME", "this one only",
                     CLI::IsMember(family_names()));
  common::add_option(app, "--space", options.space, "NAME",
                     "families of this space: open, periodic", CLI::IsMember({"open", "periodic"}));
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
