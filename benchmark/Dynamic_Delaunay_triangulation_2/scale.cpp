// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How do construction, frames and rebuilds grow with the number of points and of threads, what
// memory do they need, and how near does a frame come to what the machine's memory can move? All
// numbers of threads follow the same frames in one process, in turn, the order rotating; beyond
// three million points, for the sake of memory, one follows all of them after the other. All of the
// triangulation's work is done inside of a TBB arena with so many threads.
//
//   drift         all points move by the same hundredth of a spacing a frame
//   calm          Brownian motion with steps of 0.001 spacings
//   rough         the same with steps of 0.03 spacings
//   jumps         every hundredth point jumps anywhere, the others move as in calm frames
//   rebuild       the same, and the policy has every frame rebuilt
//   construction  of the first frame, into memory that is new
//   cell rough, cell construction   the same in a periodic cell, up to a million points
//
// Columns of the first table, wall-clock time in nanoseconds a point:
//   total         median over the frames; worst is the slowest of them
//   read, classify, repair, certify   the phases as speed.cpp has them, medians of their own; of a
//                 rebuild all that comes behind reading is repair, and a construction has no phases
//   flips         a point and frame, mean
//   times         how many times faster than with the first number of threads
//
// The bandwidth is that of STREAM's kernels, see scale/Stream_bandwidth.h. What a frame has to move
// is counted in scale/Scale_figures.h: skipping, if it proves edges by references alone, and
// passing, if it looks at every edge. The table has the shares of the time of a frame in which
// copying would have moved so much. Where all fits into the caches, it may exceed 1.
//
// Memory is what operator new gave, without the caller's points: after the construction, after
// calm and rough frames, and after a rebuild; beyond is that after rough frames minus that of
// CGAL's own triangulation of the points. Peaks are maxima over time; GB is the largest of them.
//
// With --serial one thread measures how much of its time it spends in parts, which threads would
// share, and how much elsewhere, phase by phase: decide looks at a sample of the edges; rest is all
// that has no name, such as the proof. serial is the time outside of parts, and share its part of
// the whole. x16 is how many times faster 16 threads would be that share the very same parts, each
// taking the next one as soon as it is free: an upper limit, without waking threads up, and as if
// caches and memory served them all at once. All figures are medians over the frames. --space has
// points in space instead, open and periodic; there, examine tests by exact predicates what
// floating point has not proved.
//
// Outside of the timing every frame has to be certified, all numbers of threads have to lead to the
// same edges with the same numbers, and up to 200,000 points the last frame has to agree with a
// fresh triangulation. From 10,000 points on no peak may be higher than 450 bytes a point. The
// first fault ends the program.

#include "common/Program.h"
#include "scale/Scale_memory.h"
#include "scale/Scale_motion.h"
#include "scale/Scale_output.h"
#include "scale/Scale_run.h"
#include "scale/Serial_share.h"
#include "scale/Serial_space.h"
#include "scale/Stream_bandwidth.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace scale;

struct Scale_options
{
  std::vector<std::size_t> points;
  std::vector<unsigned> threads{1, 2};
  std::filesystem::path output{RESULTS_DIR "/scale"};
  bool is_quick = false;
  bool is_serial = false;
  bool is_in_space = false;
};

const Motion_kind drift{"drift", 0.01, 0.0, 0.0, false};
const Motion_kind calm{"calm", 0.0, 0.001, 0.0, false};
const Motion_kind rough{"rough", 0.0, 0.03, 0.0, false};
const Motion_kind jumps{"jumps", 0.0, 0.001, 0.01, false};
const Motion_kind rebuild{"rebuild", 0.0, 0.03, 0.0, true};
const Motion_kind after_work{"calm after work", 0.0, 0.001, 0.0, false, 0.3};
const Motion_kind cell_rough{"cell rough", 0.0, 0.03, 0.0, false};

void add_options(CLI::App& app, Scale_options& options)
{
  constexpr int fewest_points = 10, most_points = 100'000'000, most_threads = 1024;
  app.description("Times frames, rebuilds and construction by the number of points and threads, "
                  "and measures memory and the machine's bandwidth.");
  common::add_option(app, "--points", options.points, "N...",
                     "how many; default 1000 10000 ... 10000000",
                     CLI::Range(fewest_points, most_points));
  common::add_option(app, "--threads", options.threads, "N...", "how many; default 1 2",
                     CLI::Range(1, most_threads));
  common::add_option(app, "--output", options.output, "DIR",
                     "where CSV files and the figure go; default build/dev/bench/scale");
  CLI::Option* const serial =
      app.add_flag("--serial", options.is_serial,
                   "on one thread, how much of the time threads could share, phase by phase");
  app.add_flag("--space", options.is_in_space, "the same of points in space")->needs(serial);
  app.add_flag("--quick", options.is_quick, "a first look, in some seconds");
}

// Enough for a median, and not too long for many points.
Frame_numbers frame_numbers(std::size_t points, bool is_quick)
{
  constexpr std::size_t work = 20'000'000;
  const std::size_t timed = std::clamp<std::size_t>(work / points, 8, 400);
  return is_quick ? Frame_numbers{2, 4} : Frame_numbers{timed / 4 + 2, timed};
}

std::vector<Case_record> run_cases(const Scale_options& options, Time_table& table)
{
  constexpr std::size_t most_in_a_cell = 1'000'000, fewest_shared = 100'000,
                        most_after_work = 1'000'000;
  std::vector<Case_record> records;
  for (const std::size_t points : options.points) {
    const Scale_run<In_the_plane> run(points, options.threads);
    const Frame_numbers frames = frame_numbers(points, options.is_quick);
    const auto take = [&](Case_record record) {
      table.write_rows(record);
      records.push_back(std::move(record));
    };
    for (const Motion_kind& kind : {drift, calm, rough, jumps}) {
      take(run.follow(kind, frames));
    }
    if (points >= fewest_shared && points <= most_after_work && !options.is_quick) {
      take(run.follow(after_work, {2, 20}));
    }
    const std::size_t rebuilds = (std::min)(frames.timed, std::size_t(3) + frames.timed / 8);
    take(run.follow(rebuild, {1, rebuilds}));
    take(run.construct("construction", rebuilds));
    if (points <= most_in_a_cell) {
      const Scale_run<In_a_cell> cell_run(points, options.threads);
      take(cell_run.follow(cell_rough, frames));
      take(cell_run.construct("cell construction", rebuilds));
    }
  }
  return records;
}

template <class Space>
void write_serial_shares(Serial_table& table, const std::string& space, std::size_t points,
                         std::size_t frames)
{
  Serial_run<Space> run(points, frames);
  const auto name = [&](const std::string& what) {
    return space + what + '/' + std::to_string(points);
  };
  for (const double step : {0.001, 0.01, 0.03, 0.1}) {
    const Motion_kind kind{"steps of " + common::cell(step, 3), 0.0, step, 0.0, false};
    table.write(name(kind.name), points, run.follow(kind));
  }
  table.write(name(rebuild.name), points, run.follow(rebuild));
  table.write(name("5 % exchanged"), points, run.exchange(5));
  table.write(name("construction"), points, run.construct());
}

void write_serial_shares(const Scale_options& options)
{
  Serial_table table(std::cout);
  for (const std::size_t points : options.points) {
    const std::size_t frames = options.is_quick ? 3 : 9;
    if (options.is_in_space) {
      write_serial_shares_in_space<Measured_in_open_space>(table, "", points, frames);
      write_serial_shares_in_space<Measured_in_periodic_space>(table, "cell ", points, frames);
      continue;
    }
    write_serial_shares<Measured_in_the_plane>(table, "", points, frames);
    write_serial_shares<Measured_in_a_cell>(table, "cell ", points, frames);
  }
}

Bandwidths measure_bandwidths(const Scale_options& options)
{
  constexpr std::size_t elements = 16'000'000, few_elements = 1'000'000;
  Stream_bandwidth stream(options.is_quick ? few_elements : elements);
  Bandwidths bandwidths;
  for (const unsigned threads : options.threads) {
    bandwidths[threads] = stream.measure(threads);
  }
  return bandwidths;
}

std::vector<Memory_record> measure_memory(const Scale_options& options)
{
  constexpr std::size_t frames = 4;
  std::vector<Memory_record> records;
  for (const std::size_t points : options.points) {
    for (const unsigned threads : options.threads) {
      records.push_back(Memory_run(points, threads).measure(calm, rough, frames));
    }
  }
  return records;
}

std::vector<std::size_t> serial_points(bool is_in_space)
{
  return is_in_space ? std::vector<std::size_t>{10'000, 100'000}
                     : std::vector<std::size_t>{100'000, 1'000'000};
}

bool run_scale(Scale_options options, const std::string& command)
{
  if (options.points.empty()) {
    options.points = options.is_quick ? std::vector<std::size_t>{1000, 20'000}
                     : options.is_serial
                         ? serial_points(options.is_in_space)
                         : std::vector<std::size_t>{1000, 10'000, 100'000, 1'000'000, 10'000'000};
  }
  if (options.is_serial) {
    write_serial_shares(options);
    std::cout << '\n' << command << std::endl;
    return true;
  }
  std::filesystem::create_directories(options.output);
  const Bandwidths bandwidths = measure_bandwidths(options);
  Time_table table(std::cout);
  const std::vector<Case_record> records = run_cases(options, table);
  std::vector<Case_record> calm_records;
  std::copy_if(records.begin(), records.end(), std::back_inserter(calm_records),
               [](const Case_record& record) {
                 return record.motion == drift.name || record.motion == calm.name;
               });
  write_bandwidths(std::cout, bandwidths, calm_records);
  const std::vector<Memory_record> memory = measure_memory(options);
  write_memory(std::cout, memory);
  write_csv(options.output, command, records, bandwidths, memory);
  std::cout << '\n' << command << std::endl;
  std::cerr << "CSV: " << (options.output / "scale.csv").string() << '\n';
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Scale_options>("scale", argc, argv, add_options, run_scale);
}
