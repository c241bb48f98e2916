// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TISSUE_TISSUE_OUTPUT_H
#define TISSUE_TISSUE_OUTPUT_H

#include "../common/Csv_file.h"
#include "../common/Table.h"
#include "Tissue_sweep.h"

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace tissue {

// For people: a line for each preferred shape.
class Shape_table
{
public:
  explicit Shape_table(std::ostream& out)
    : m_table(out, 6,
              {{"msd", 10, 4},
               {"to cage", 10, 4},
               {"staying", 10, 3},
               {"D_eff", 11, 6},
               {"least", 11, 6},
               {"most", 11, 6},
               {"T1 rate", 11, 6},
               {"shape", 9, 4},
               {"rebuilds", 10, 1}})
  {
    m_table.write_head("p0");
  }

  void write_row(const Shape_record& record)
  {
    const auto [least, most] =
        std::minmax_element(record.diffusivities.begin(), record.diffusivities.end());
    const auto at_end = [&](double Sample::*value) {
      return record.mean(
          [&](const Observation& observation) { return observation.samples.back().*value; });
    };
    m_table.write_row(common::csv_cell(record.shape), at_end(&Sample::mean_square),
                      at_end(&Sample::cage_relative_mean_square), at_end(&Sample::self_overlap),
                      record.diffusivity(), *least, *most, record.mean(&Observation::exchange_rate),
                      record.mean(&Observation::shape_index), record.mean(&Observation::rebuilds));
  }

private:
  common::Table m_table;
};

// tissue.csv has a line for each seed, motion.csv one for each sample of it.
inline void write_csv(const Sweep_options& options, const std::string& command,
                      const std::vector<Shape_record>& records)
{
  const std::vector<std::string> remarks{"command: " + command};
  common::Csv_file runs(options.output / "tissue.csv", remarks,
                        {"p0", "seed", "effective_diffusivity", "exchange_rate", "shape_index"});
  common::Csv_file motion(
      options.output / "motion.csv", remarks,
      {"p0", "seed", "time", "mean_square", "cage_relative_mean_square", "self_overlap"});
  for (const Shape_record& record : records) {
    for (std::size_t i = 0; i < record.observations.size(); ++i) {
      const Observation& observation = record.observations[i];
      runs.write_row(record.shape, i + 1, record.diffusivities[i], observation.exchange_rate,
                     observation.shape_index);
      for (const Sample& sample : observation.samples) {
        motion.write_row(record.shape, i + 1, sample.time, sample.mean_square,
                         sample.cage_relative_mean_square, sample.self_overlap);
      }
    }
  }
  runs.finish();
  motion.finish();
}

} // namespace tissue

#endif // TISSUE_TISSUE_OUTPUT_H
