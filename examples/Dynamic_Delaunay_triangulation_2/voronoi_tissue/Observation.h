// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VORONOI_TISSUE_OBSERVATION_H
#define VORONOI_TISSUE_OBSERVATION_H

#include "Displacements.h"
#include "Voronoi_tissue.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace tissue {

// Measurements at a time since the observation began.
struct Sample
{
  double time;
  double mean_square, cage_relative_mean_square; // displacements
  double self_overlap;
};

struct Observation
{
  std::vector<Sample> samples; // the last one at the end, and one at half the time
  double exchange_rate = 0;    // T1 events a cell and unit of time
  double shape_index = 0;      // mean over cells and samples
  std::size_t rebuilds = 0;    // of the triangulation
  bool is_certified = true;    // after each step

  // The diffusivity in the second half of the time, as a share of that of a cell that crawls alone.
  double effective_diffusivity(const Parameters& parameters) const
  {
    const double alone = parameters.speed * parameters.speed / (2 * parameters.rotation);
    const Sample &half = samples[samples.size() / 2 - 1], &end = samples.back();
    return (end.mean_square - half.mean_square) / (4 * (end.time - half.time)) / alone;
  }
};

// Lets a tissue settle for some time, then watches it. Calls `progress()` before every step.
template <class Progress>
Observation observe(const Parameters& parameters, double settling, double time,
                    const Progress& progress)
{
  constexpr std::size_t samples = 40;
  const auto steps_of = [&](double duration) {
    return std::size_t(duration / parameters.time_step + 0.5);
  };
  Voronoi_tissue tissue(parameters);
  for (std::size_t i = 0, steps = steps_of(settling); i < steps; ++i) {
    progress();
    tissue.step();
  }
  const Displacements displacements(tissue);
  Observation result;
  std::size_t step = 0, events = 0;
  for (std::size_t sample = 1; sample <= samples; ++sample) {
    const double end = time * double(sample) / double(samples);
    for (const std::size_t steps = steps_of(end); step < steps; ++step) {
      progress();
      const auto report = tissue.step();
      events += tissue.exchanges();
      result.rebuilds += report.rebuilt();
      result.is_certified = result.is_certified && report.certified;
    }
    const auto& positions = tissue.positions();
    result.samples.push_back({end, displacements.mean_square(positions),
                              displacements.cage_relative_mean_square(positions),
                              displacements.self_overlap(positions)});
    const auto& shapes = tissue.cells().shape_indices();
    result.shape_index +=
        std::accumulate(shapes.begin(), shapes.end(), 0.0) / double(shapes.size() * samples);
  }
  result.exchange_rate = double(events) / (time * double(parameters.cells));
  return result;
}

} // namespace tissue

#endif // VORONOI_TISSUE_OBSERVATION_H
