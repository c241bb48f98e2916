// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_FRAME_EXPERIMENT_H
#define THESIS_FRAME_EXPERIMENT_H

#include "../common/Csv_file.h"
#include "Experiment.h"
#include "Frame_case.h"
#include "Trial.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace thesis {

// Frames of scenarios, timed and compared. It writes NAME_summary.csv with a row for each case;
// where cases have bins also NAME.csv with a row for each bin, and NAME_physics.csv.
class Frame_experiment : public Repeated_experiment<Frame_case>
{
public:
  using Repeated_experiment::Repeated_experiment;

  void add(Trial trial, const Frame_plan& plan) { add_case({std::move(trial), plan}); }

  void write(const std::filesystem::path& directory,
             const std::vector<std::string>& remarks) const override
  {
    write_summary(directory / (name() + "_summary.csv"), remarks);
    if (cases().front().plan().bins > 1) {
      write_bins(directory / (name() + ".csv"), remarks, Frame_statistics::columns(),
                 [](const Frame_bin& bin) { return bin.statistics.cells(); });
      write_bins(directory / (name() + "_physics.csv"), remarks, Physics::columns(),
                 [](const Frame_bin& bin) { return bin.physics_cells(); });
    }
  }

private:
  double seconds_of(const Frame_case& one) const override
  {
    constexpr double follow = 1.0e-7, measure = 1.5e-6, compare = 2.5e-6; // a point
    const Frame_plan& plan = one.plan();
    const auto samples = static_cast<double>(plan.samples);
    const double compared = plan.compares_all ? samples : 1.0;
    const auto points = static_cast<double>(one.trial().points.value_or(1000));
    return points *
           (follow * static_cast<double>(plan.frames) + measure * samples + compare * compared);
  }

  void run(Frame_case& one, std::uint64_t seed) const override { one.run(seed); }

  using Cells = std::vector<std::string>;

  static Cells joined(Cells first, const Cells& second, const Cells& third,
                      const Cells& fourth = {})
  {
    for (const Cells* const more : {&second, &third, &fourth}) {
      first.insert(first.end(), more->begin(), more->end());
    }
    return first;
  }

  static Cells columns_of_case() { return {"scenario", "method", "points", "time_step"}; }

  static Cells cells_of(const Frame_case& one)
  {
    return common::csv_cells(one.trial().scenario, method_name(one.trial().method), one.points(),
                             one.time_step());
  }

  void write_summary(const std::filesystem::path& path, const Cells& remarks) const
  {
    common::Csv_file file(path, remarks,
                          joined(columns_of_case(), {"trials", "frames"},
                                 Frame_statistics::columns(),
                                 {"dynamic_mean", "classified", "flips", "rebuilt"}));
    for (const Frame_case& one : cases()) {
      file.write_line(joined(cells_of(one),
                             common::csv_cells(one.number_of_trials(), one.plan().frames),
                             one.whole().cells(), one.cells_of_means()));
    }
    file.finish();
  }

  // Writes `cells_of_bin(bin)` of all bins.
  template <class Cells_of_bin>
  void write_bins(const std::filesystem::path& path, const Cells& remarks, const Cells& columns,
                  const Cells_of_bin& cells_of_bin) const
  {
    common::Csv_file file(path, remarks, joined(columns_of_case(), {"frame", "time"}, columns));
    for (const Frame_case& one : cases()) {
      for (std::size_t bin = 0; bin != one.bins().size(); ++bin) {
        const Frame_bin& results = one.bins()[bin];
        file.write_line(joined(cells_of(one),
                               common::csv_cells(one.frame_of_bin(bin), results.last_time),
                               cells_of_bin(results)));
      }
    }
    file.finish();
  }
};

} // namespace thesis

#endif // THESIS_FRAME_EXPERIMENT_H
