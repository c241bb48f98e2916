// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Does millions of random things to triangulations, and looks at each of them after each of these:
// is it valid, is everybody where they have to be, is it certified if its classifier is exact, and
// is it equal to a fresh triangulation of CGAL's if it says that it is certified?
//
// A trial is a row of 200 operations on one triangulation, each of them one public call. Its seed
// decides everything about it: the family, which says what kinds of points and motions it has; the
// kernel, classifier with its parameter, repair, policy, engine, and who names the points; and all
// operations. Families stand in robustness/Families.h, the oracle in robustness/Checked_subject.h.
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
//   crashed      an exception that nobody has asked for
// A trial ends with its first fault. What kills the program, or takes it too long, is named with
// the trial. The program ends with success only if there are no faults.

#include "results/Command.h"
#include "robustness/Robustness_options.h"
#include "robustness/Robustness_run.h"
#include "robustness/Robustness_table.h"
#include "robustness/Watchdog.h"
#include "scenario_runner/Output_file.h"
#include "scenario_runner/Progress.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>

namespace {

using namespace robustness;

Results run(const Robustness_options& options)
{
  Robustness_run run(options);
  if (options.trial) {
    return run.repeat(*options.trial);
  }
  run::Progress_display progress(options.operations, true, "operation");
  return run.run([&](std::uint64_t operations) { progress.show(operations); });
}

void write_findings(const Results& results)
{
  constexpr std::size_t most = 20;
  const std::size_t shown = (std::min)(most, results.findings.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const Found& found = results.findings[i];
    std::cout << fault_name(found.fault) << " after " << found.operation
              << " operations: " << found.what << "\n  " << found.setup << "\n  --family "
              << found.family << " --trial " << found.seed << '\n';
  }
  if (shown < results.findings.size()) {
    std::cout << "and " << results.findings.size() - shown << " more\n";
  }
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
  Robustness_table(std::cout).write(results);
  std::cout << '\n';
  write_findings(results);
  const Counts total = results.total();
  std::cout << total.number_of_operations() << " operations, " << total[Fault::WRONG] << " wrong, "
            << total[Fault::LOST] << " lost, " << total[Fault::CRASHED] << " crashed; seed "
            << options.seed << ", " << seconds << " s\n"
            << command << '\n';
  if (options.report) {
    nlohmann::ordered_json report = json(results);
    report["seed"] = options.seed;
    report["command"] = command;
    report["seconds"] = seconds;
    write_report(*options.report, report);
  }
  return !total.has_faults();
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("", "robustness");
  try {
    const std::string command = results::command_of("robustness", argc, argv);
    return run_robustness(parse_options(app, argc, argv), command) ? 0 : 1;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    std::cerr << "robustness: " << error.what() << std::endl;
    return 1;
  }
}
