// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_FRAME_CASE_H
#define THESIS_FRAME_CASE_H

#include "../common/Csv_file.h"
#include "Mean_and_extremes.h"
#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"
#include "Trial.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace thesis {

// Quantities of all particles together, not of single ones, by which the course of a simulation can
// be judged.
struct Physics
{
  static constexpr std::size_t size = 5;

  static std::vector<std::string> columns()
  {
    std::vector<std::string> columns;
    for (const char* const name : {"kinetic", "energy", "center_x", "center_y", "front"}) {
      Mean_and_extremes::append_columns(name, columns);
    }
    return columns;
  }

  // Energies in units of mass, stiffness and diameter; the front is the largest x coordinate.
  std::array<double, size> values;
};

// The energy is that of all contacts there are, whether the simulation has noticed them or not: its
// neighbors come from a fresh Delaunay triangulation.
inline Physics physics_of(scenario::Particle_motion& motion)
{
  const auto& points = motion.points();
  scenario::Static_neighbors neighbors;
  const scenario::Energy energy = motion.energy(neighbors(points));
  double x = 0.0;
  double y = 0.0;
  double front = std::numeric_limits<double>::lowest();
  for (const scenario::Point& point : points) {
    x += point.x;
    y += point.y;
    front = (std::max)(front, point.x);
  }
  const auto number = static_cast<double>(points.size());
  return {{energy.kinetic, energy.total(), x / number, y / number, front}};
}

// Statistics of frames of several trials, all of them timed against the static opponents.
class Frame_statistics
{
public:
  void add(const run::Frame_record& frame, bool was_compared)
  {
    const auto points = static_cast<double>(frame.points);
    const run::Frame_times& times = frame.nanoseconds;
    m_dynamic.push_back(times.dynamic / points);
    m_insert.push_back(times.static_insert / points);
    m_fastest.push_back(times.static_fastest / points);
    m_over_insert.push_back(times.static_insert / times.dynamic);
    m_over_fastest.push_back(times.static_fastest / times.dynamic);
    if (was_compared) {
      m_validity.add(frame.validity);
    }
  }

  // The validity with its mean and its extremes; times in nanoseconds a point and speedups with
  // their median and quartiles, those of the opponents with their median.
  static std::vector<std::string> columns()
  {
    std::vector<std::string> columns = {"samples"};
    Mean_and_extremes::append_columns("validity", columns);
    for (const char* const name : {"dynamic", "over_insert", "over_fastest"}) {
      columns.insert(columns.end(), {name, std::string(name) + "_q1", std::string(name) + "_q3"});
    }
    columns.insert(columns.end(), {"insert", "fastest"});
    return columns;
  }

  std::vector<std::string> cells() const
  {
    std::vector<std::string> cells = {common::csv_cell(m_dynamic.size())};
    m_validity.append_cells(cells);
    for (const auto* const values : {&m_dynamic, &m_over_insert, &m_over_fastest}) {
      const run::Spread spread = *run::spread(*values);
      for (const double value : {spread.median, spread.low_quartile, spread.high_quartile}) {
        cells.push_back(common::csv_cell(value));
      }
    }
    for (const auto* const values : {&m_insert, &m_fastest}) {
      cells.push_back(common::csv_cell(run::spread(*values)->median));
    }
    return cells;
  }

private:
  Mean_and_extremes m_validity;
  std::vector<double> m_dynamic, m_insert, m_fastest; // nanoseconds a point
  std::vector<double> m_over_insert, m_over_fastest;
};

// Which frames of a trial are looked at.
struct Frame_plan
{
  std::size_t frames;       // after the first one
  std::size_t samples;      // so many of them, evenly spread; all others are followed alone
  std::size_t bins;         // that the samples are sorted into by their time
  bool compares_all = true; // all samples with fresh triangulations, or the last one alone
};

// The results of the samples in one bin of frames.
struct Frame_bin
{
  Frame_statistics statistics{};
  std::array<Mean_and_extremes, Physics::size> physics{};
  double last_time = 0.0; // of the motion

  std::vector<std::string> physics_cells() const
  {
    std::vector<std::string> cells;
    for (const Mean_and_extremes& value : physics) {
      value.append_cells(cells);
    }
    return cells;
  }
};

// Trials that differ in their seed alone.
class Frame_case
{
public:
  Frame_case(Trial trial, const Frame_plan& plan)
    : m_trial(std::move(trial))
    , m_plan(plan)
    , m_bins(plan.bins)
  {
  }

  void run(std::uint64_t seed)
  {
    Trial trial = m_trial;
    trial.seed = seed;
    const auto motion = open(trial);
    m_points = motion->points().size();
    m_time_step = motion->time_step().value_or(0.0);
    with_run(trial, *motion, [&](auto& run) {
      for (std::size_t sample = 0; sample != m_plan.samples; ++sample) {
        follow_to(frame_of(sample) - 1, run);
        take(sample, run, *motion);
      }
    });
    ++m_number_of_trials;
  }

  const Trial& trial() const { return m_trial; }
  const Frame_plan& plan() const { return m_plan; }
  const std::vector<Frame_bin>& bins() const { return m_bins; }
  const Frame_statistics& whole() const { return m_whole; }
  std::size_t frame_of_bin(std::size_t bin) const
  {
    return m_plan.frames * (bin + 1) / m_plan.bins;
  }
  std::size_t points() const { return m_points; }
  double time_step() const { return m_time_step; }
  std::size_t number_of_trials() const { return m_number_of_trials; }

  // Means over all frames of all trials, also those that were followed alone.
  std::vector<std::string> cells_of_means() const
  {
    return common::csv_cells(m_dynamic.mean(), m_classified.mean(), m_flips.mean(),
                             m_rebuilt.mean());
  }

private:
  std::size_t frame_of(std::size_t sample) const
  {
    return m_plan.frames * (sample + 1) / m_plan.samples;
  }

  template <class Run>
  void follow_to(std::size_t frame, Run& run)
  {
    while (run.record().frame < frame) {
      run.follow(run.record().frame + 1 == frame);
      count(run.record());
    }
  }

  template <class Run>
  void take(std::size_t sample, Run& run, scenario::Motion& motion)
  {
    const bool compares = m_plan.compares_all || sample + 1 == m_plan.samples;
    compares ? run.advance() : run.measure();
    count(run.record());
    Frame_bin& bin = m_bins[sample * m_plan.bins / m_plan.samples];
    bin.statistics.add(run.record(), compares);
    bin.last_time = run.record().time;
    m_whole.add(run.record(), compares);
    auto* const particles = dynamic_cast<scenario::Particle_motion*>(&motion);
    if (particles != nullptr && m_plan.bins > 1) {
      const Physics physics = physics_of(*particles);
      for (std::size_t i = 0; i != Physics::size; ++i) {
        bin.physics[i].add(physics.values[i]);
      }
    }
  }

  void count(const run::Frame_record& frame)
  {
    if (m_trial.method.classifier.is_exact && !frame.update.certified) {
      throw std::runtime_error(m_trial.scenario + ", frame " + std::to_string(frame.frame) +
                               ": the triangulation is not certified");
    }
    m_dynamic.add(frame.nanoseconds.dynamic / static_cast<double>(frame.points));
    m_classified.add(static_cast<double>(frame.update.classified));
    m_flips.add(static_cast<double>(frame.update.flips));
    m_rebuilt.add(frame.update.rebuilt() ? 1.0 : 0.0);
  }

  Trial m_trial;
  Frame_plan m_plan;
  std::vector<Frame_bin> m_bins;
  Frame_statistics m_whole;
  Mean_and_extremes m_dynamic; // nanoseconds a point
  Mean_and_extremes m_classified, m_flips, m_rebuilt;
  std::size_t m_points = 0;
  double m_time_step = 0.0;
  std::size_t m_number_of_trials = 0;
};

} // namespace thesis

#endif // THESIS_FRAME_CASE_H
