// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TISSUE_TISSUE_SWEEP_H
#define TISSUE_TISSUE_SWEEP_H

#include "../common/Statistics.h"
#include "examples/Dynamic_Delaunay_triangulation_2/voronoi_tissue/Observation.h"
#include "scenario_runner/Progress.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tissue {

// What a person asks for.
struct Sweep_options
{
  std::vector<double> shapes{3.5, 3.6, 3.65, 3.7, 3.75, 3.78, 3.8, 3.82, 3.85, 3.9, 4.0};
  std::size_t cells = 400;
  double speed = 0.1;
  double time = 3000;
  double settling = 1000;
  double time_step = 0.1;
  unsigned seeds = 4;
  std::filesystem::path output = std::filesystem::path(RESULTS_DIR) / "tissue";
  bool is_quick = false;

  Parameters parameters(double shape, unsigned seed) const
  {
    Parameters parameters;
    parameters.cells = cells;
    parameters.target_shape = shape;
    parameters.speed = speed;
    parameters.time_step = time_step;
    parameters.seed = seed;
    return parameters;
  }

  void be_quick()
  {
    shapes = {3.5, 3.95};
    cells = 60;
    settling = 10;
    time = 40;
    seeds = 1;
  }
};

// All seeds of one preferred shape.
struct Shape_record
{
  double shape;
  std::vector<Observation> observations{};
  std::vector<double> diffusivities{}; // effective ones

  template <class Value>
  double mean(const Value& value) const
  {
    return common::mean(common::values_of(observations, value));
  }

  double diffusivity() const { return common::mean(diffusivities); }
};

inline Shape_record observe_shape(const Sweep_options& options, double shape)
{
  Shape_record record{shape};
  for (unsigned seed = 1; seed <= options.seeds; ++seed) {
    const Parameters parameters = options.parameters(shape, seed);
    const auto steps =
        static_cast<std::size_t>((options.settling + options.time) / options.time_step);
    run::Progress_display progress(steps, true, "step");
    std::size_t step = 0;
    record.observations.push_back(
        observe(parameters, options.settling, options.time, [&] { progress.show(step++); }));
    if (!record.observations.back().is_certified) {
      throw std::runtime_error("seed " + std::to_string(seed) + ": a step was not certified");
    }
    record.diffusivities.push_back(record.observations.back().effective_diffusivity(parameters));
  }
  return record;
}

// The effective diffusivity from which on a tissue counts as a fluid.
constexpr double fluid_diffusivity = 1e-3;

// The preferred shape at which the diffusivity passes this limit, interpolated between two
// neighbors in the sweep by its logarithm.
inline std::optional<double> transition(const std::vector<Shape_record>& records)
{
  constexpr double least = 1e-6; // of a glass, which rounding or rattling can make negative
  const auto height = [&](const Shape_record& record) {
    return std::log((std::max)(record.diffusivity(), least) / fluid_diffusivity);
  };
  for (std::size_t i = 1; i < records.size(); ++i) {
    const double before = height(records[i - 1]), after = height(records[i]);
    if (before < 0.0 && after >= 0.0) {
      return records[i - 1].shape +
             (records[i].shape - records[i - 1].shape) * before / (before - after);
    }
  }
  return std::nullopt;
}

} // namespace tissue

#endif // TISSUE_TISSUE_SWEEP_H
