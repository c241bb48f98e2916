// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes millions of random calls of triangulations, and checks the triangulation after each call:
// is it valid, is every point where it has to be, is it certified if its classifier is exact, and
// is it equal to a fresh triangulation of CGAL's if it says that it is certified?
//
// A trial is a row of 200 operations on one triangulation, each of them one public call. Its seed
// decides everything about it: the family, which says what kinds of points and motions it has; the
// kernel, classifier with its parameter, repair, policy, engine, and who names the points; and all
// operations. Families stand in random_operations/Families.h, the oracle in
// random_operations/Checked_subject.h.
//
// Columns of the tables, all of them counts:
//   operations   public calls that change something
//   insert, remove, move, frames   those that do so; frames are updates of all points
//   mend         mend() and certify()
//   misuse       calls with bad input, which have to be refused without any change
//   points       those that were looked at, over all operations
//   flips to rebuilds   from the reports
//   certified    operations after which the triangulation was
//   wrong        not Delaunay, not valid, or not what it says to be
//   lost         a point, an id or a vertex is not where it has to be
//   crashed      an exception that was not asked for
// A trial ends with its first fault. If an operation crashes the program or takes too long, it is
// reported with its trial. The program ends with success only if there are no faults.

#ifndef ROBUSTNESS_PROGRAM
#define ROBUSTNESS_PROGRAM "robustness"
#endif

#include "common/Program.h"
#include "robustness/Robustness_report.h"
#include "robustness/Robustness_run.h"
#include "robustness/Watchdog.h"
#include "scenario_runner/Output_file.h"
#include "scenario_runner/Progress.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string>

namespace {

using namespace robustness;

void add_options(CLI::App& app, Robustness_options& options)
{
  constexpr double max_operations = 1e12, max_threads = 1024, max_time_limit = 1e6;
  app.description("Does random things to triangulations, and compares them with fresh ones of "
                  "CGAL's after each of them.");
  common::add_option(app, "--operations", options.operations, "N",
                     "how many, of all families; default 10000000",
                     CLI::Range(1.0, max_operations));
  common::add_option(app, "--seed", options.seed, "N", "what everything is drawn from; default 1");
  common::add_option(app, "--threads", options.threads, "N",
                     "which nothing that is counted depends on; default as many as the machine has",
                     CLI::Range(1.0, max_threads));
  common::add_option(app, "--family", options.family, "NAME", "this one only",
                     CLI::IsMember(names_of(families())));
  app.add_option("--trial", options.trial, "repeat one trial, with --family as it was reported")
      ->type_name("SEED")
      ->expected(1);
  common::add_option(app, "--time_limit", options.time_limit, "SECONDS",
                     "an operation that takes longer ends the program; default 20",
                     CLI::Range((std::numeric_limits<double>::min)(), max_time_limit));
  common::add_option(app, "--arithmetic", options.arithmetic, "NAME",
                     "what the caller's is; default usual",
                     CLI::IsMember(names_of(all_arithmetic())));
  common::add_option(app, "--report", options.report, "FILE.json",
                     "write what came out, as one JSON object");
}

Results run(const Robustness_options& options)
{
  Robustness_run run(options);
  if (!options.trial.empty()) {
    return run.repeat(options.trial.front());
  }
  run::Progress_display progress(options.operations, true, "operation");
  return run.run([&](std::uint64_t operations) { progress.show(operations); });
}

void write_report(const std::string& path, const nlohmann::ordered_json& report)
{
  run::Output_file file(path);
  file.stream() << report.dump(2) << '\n';
  file.finish();
}

// Whether everything was right.
bool run_robustness(const Robustness_options& options, const std::string& command)
{
  using Clock = std::chrono::steady_clock;
  watch_signals();
  const Clock::time_point start = Clock::now();
  const Results results = run(options);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  write_tables(std::cout, results);
  std::cout << '\n';
  write_findings(std::cout, results);
  const Counts total = results.total();
  std::cout << total.number_of_operations() << " operations, " << total[Fault::WRONG] << " wrong, "
            << total[Fault::LOST] << " lost, " << total[Fault::CRASHED] << " crashed; seed "
            << options.seed << ", " << seconds << " s\n"
            << command << '\n';
  if (!options.report.empty()) {
    nlohmann::ordered_json report = json(results);
    report["seed"] = options.seed;
    report["command"] = command;
    report["seconds"] = seconds;
    write_report(options.report, report);
  }
  return !total.has_faults();
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Robustness_options>(ROBUSTNESS_PROGRAM, argc, argv, add_options,
                                                 run_robustness);
}
