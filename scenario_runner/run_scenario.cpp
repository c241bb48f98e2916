// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs a scenario, checks the maintained triangulation on every frame, and compares its cost with
// that of fresh triangulations: run_scenario --help.

#include "scenario_runner/Cell_log.h"
#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Output_formats.h"
#include "scenario_runner/Periodic_run.h"
#include "scenario_runner/Pictures.h"
#include "scenario_runner/Player_page.h"
#include "scenario_runner/Progress.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Run_options.h"
#include "scenario_runner/Run_report.h"
#include "scenario_runner/Scenario_run.h"
#include "scenario_runner/space/Outputs_3.h"
#include "scenario_runner/space/Run_report_3.h"
#include "scenario_runner/Threads.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

// All outputs of frames, which are written while they pass. Files are opened before the first
// frame, so that a wrong path is reported at once.
class Outputs
{
public:
  Outputs(const run::Run_options& options, const run::Run_subject& subject, std::size_t frames,
          const std::optional<scenario::Box>& box)
    : m_progress(frames, !options.quiet)
  {
    if (options.report) {
      m_report.emplace(*options.report);
    }
    const auto seen =
        options.every ? run::Frame_choice(frames, *options.every) : run::about_thirty(frames);
    const run::Frame_choice recorded(frames, options.every.value_or(1));
    using Format = run::Point_file::Format;
    add<run::Frame_log>(options.csv);
    add<run::Picture_series>(options.svg, subject.scenario, seen, box);
    add<run::Player_page>(options.html, subject.scenario, run::method_text(subject), recorded);
    add<run::Vtk_series>(options.vtk, seen);
    add<run::Point_log>(options.xyz, Format::EXTENDED_XYZ, recorded, box);
    add<run::Point_log>(options.lammps, Format::LAMMPS_DUMP, recorded, box);
    add<run::Cell_log>(options.cells, recorded, options.radius, options.domain,
                       options.cell_rule.value_or(run::Cell_rule::WHOLE));
  }

  void take(const run::Run_view& run)
  {
    for (const auto& output : m_outputs) {
      output->take(run);
    }
    m_progress.show(run.record().frame);
  }

  void finish(const run::Run_subject& subject, const run::Run_summary& summary)
  {
    for (const auto& output : m_outputs) {
      output->finish();
    }
    if (m_report) {
      run::write_report(m_report->stream(), subject, summary);
      m_report->finish();
    }
  }

private:
  template <class Output, class... Settings>
  void add(const std::optional<std::string>& path, const Settings&... settings)
  {
    if (path) {
      m_outputs.push_back(std::make_unique<Output>(*path, settings...));
    }
  }

  std::optional<run::Output_file> m_report;
  std::vector<std::unique_ptr<run::Frame_output>> m_outputs;
  run::Progress_display m_progress;
};

run::Run_subject run_subject(const run::Run_options& options, const scenario::Motion& motion,
                             const scenario::Scenario_facts& facts)
{
  const bool is_random = facts.seed || options.classifier.uses_chance();
  const std::uint64_t seed = options.overrides.seed.value_or(facts.seed.value_or(0));
  run::Run_subject subject{motion.name(),
                           options.classifier,
                           options.repair_name(),
                           options.policy,
                           options.padding,
                           options.engine,
                           options.threads,
                           motion.time_step(),
                           is_random ? std::optional(seed) : std::nullopt,
                           options.overrides.packing ? options.overrides.packing : facts.packing};
  if (motion.cell()) {
    subject.cell = motion.cell()->is_slab() ? "slab" : "torus";
  }
  return subject;
}

// Runs all frames, and summarizes them.
template <class Run, class Run_outputs>
auto run_all(Run& run, std::size_t frames, Run_outputs& outputs)
{
  run.check_first_frame();
  const std::size_t points_of_first_frame = run.motion().points().size();
  std::vector<std::decay_t<decltype(run.record())>> records;
  outputs.take(run);
  while (records.size() != frames && !run::interruption::has_come() && run.advance()) {
    records.push_back(run.record());
    outputs.take(run);
  }
  return run::summarize(points_of_first_frame, records);
}

// Runs the frames of a motion in the plane or in periodic space.
template <template <class> class Run, class Classifier>
run::Run_summary run_frames_of(scenario::Motion& motion, const Classifier& classifier,
                               const run::Run_subject& subject, std::size_t frames,
                               Outputs& outputs)
{
  Run<Classifier> run(motion, classifier, run::make_repair(subject.repair, subject.padding),
                      run::engines_named(subject.engine), run::make_policy(subject.policy));
  return run_all(run, frames, outputs);
}

run::Run_summary run_frames(scenario::Motion& motion, const run::Any_classifier& classifier,
                            const run::Run_subject& subject, std::size_t frames, Outputs& outputs)
{
  return motion.cell()
             ? run_frames_of<run::Periodic_run>(motion, classifier, subject, frames, outputs)
             : run_frames_of<run::Scenario_run>(motion, classifier, subject, frames, outputs);
}

run::Run_summary run_frames(const run::Run_subject& subject, scenario::Motion& motion,
                            std::size_t frames, Outputs& outputs)
{
  const run::Classifier_settings settings{subject.seed.value_or(0)};
  return run_frames(motion, run::make_classifier(subject.classifier, settings), subject, frames,
                    outputs);
}

scenario::Opened_motion open(const std::string& path, const run::Run_options& options,
                             bool is_recording)
{
  scenario::Overrides overrides = options.overrides;
  if (is_recording) {
    overrides.seed.reset(); // only the random classifier needs it
  }
  return scenario::open_any_motion(path, overrides, options.columns, options.dimension);
}

// Prints the table, and throws if the output cannot be written.
template <class Subject, class Summary>
void print(const Subject& subject, const Summary& summary)
{
  errno = 0;
  run::write_table(std::cout, subject, summary);
  std::cout.flush();
  if (!std::cout) {
    throw std::runtime_error(std::string("standard output: cannot be written: ") +
                             std::strerror(errno));
  }
}

// Prints what came out. Returns the program's exit code.
template <class Subject, class Summary>
int end(const run::Run_options& options, const Subject& subject, const Summary& summary,
        std::size_t frames)
{
  if (!options.quiet) {
    print(subject, summary);
  }
  if (run::interruption::has_come()) {
    std::cerr << "run_scenario: interrupted: what was written is of the " << summary.frames
              << " frames that were done, of " << frames << std::endl;
    return run::interruption::exit_code();
  }
  return 0;
}

int run_in_plane(const run::Run_options& options, scenario::Motion& motion,
                 const scenario::Scenario_facts& facts, std::size_t frames)
{
  if (options.domain && motion.cell()) {
    throw std::invalid_argument("--domain: is for the plane, and the motion is in a periodic cell");
  }
  if (options.cells && !options.radius && !options.domain) {
    throw std::invalid_argument("--cells: needs --radius, --domain or both, as cells may have no "
                                "end");
  }
  const run::Run_subject subject = run_subject(options, motion, facts);
  run::Run_summary summary;
  {
    Outputs outputs(options, subject, frames, facts.box);
    summary = run::Threads(options.threads).execute([&] {
      return run_frames(subject, motion, frames, outputs);
    });
    outputs.finish(subject, summary);
  }
  return end(options, subject, summary, frames);
}

int run_in_space(const run::Run_options& options, scenario::Motion_3& motion,
                 const scenario::Scenario_facts& facts, std::size_t frames)
{
  if (!options.given_for_plane.empty()) {
    throw std::invalid_argument(options.given_for_plane.front() +
                                ": is for the plane, and the motion is in space");
  }
  run::Run_subject_3 subject{motion.name(),      options.policy, options.threads,
                             motion.time_step(), facts.seed,     std::nullopt};
  if (motion.cell()) {
    subject.cell = motion.cell()->kind();
  }
  run::Run_summary_3 summary;
  {
    std::optional<run::Output_file> report;
    if (options.report) {
      report.emplace(*options.report);
    }
    run::Outputs_3 outputs(options, frames);
    summary = run::Threads(options.threads).execute([&] {
      const auto run = run::make_motion_run_3(motion, options.policy);
      return run_all(*run, frames, outputs);
    });
    outputs.finish();
    if (report) {
      run::write_report(report->stream(), subject, summary);
      report->finish();
    }
  }
  return end(options, subject, summary, frames);
}

int run_scenario(const run::Run_options& options)
{
  const std::string path = scenario::scenario_path(options.scenario);
  scenario::Scenario_facts facts = scenario::scenario_facts(path, options.overrides.points);
  const scenario::Opened_motion motion = open(path, options, !facts.seed);
  const std::size_t usual = motion.in_space ? motion.in_space->frames() : motion.in_plane->frames();
  std::size_t frames = options.frames.value_or(usual);
  if (!facts.seed) {
    frames = (std::min)(frames, usual); // a recording ends
  } else if (options.overrides.seed) {
    facts.seed = options.overrides.seed;
  }
  return motion.in_space ? run_in_space(options, *motion.in_space, facts, frames)
                         : run_in_plane(options, *motion.in_plane, facts, frames);
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::optional<run::Run_options> options = run::parse_options(argc, argv);
    if (!options) {
      return 0;
    }
    run::interruption::expect();
    return run_scenario(*options);
  } catch (const std::exception& error) {
    std::cerr << "run_scenario: " << error.what() << std::endl;
    return 1;
  }
}
