// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_FRAME_EXPERIMENT_H
#define THESIS_FRAME_EXPERIMENT_H

#include "../common/Csv_file.h"
#include "Experiment.h"
#include "Frame_case.h"
#include "Mean_and_extremes.h"
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
      write_bins(directory / (name() + ".csv"), remarks);
      write_physics(directory / (name() + "_physics.csv"), remarks);
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

  static std::vector<std::string> columns_of_case()
  {
    return {"scenario", "method", "points", "time_step"};
  }

  static std::vector<std::string> cells_of(const Frame_case& one)
  {
    return {one.trial().scenario, method_name(one.trial().method), common::csv_cell(one.points()),
            common::csv_cell(one.time_step())};
  }

  static void append(std::vector<std::string>& target, const std::vector<std::string>& more)
  {
    target.insert(target.end(), more.begin(), more.end());
  }

  void write_summary(const std::filesystem::path& path,
                     const std::vector<std::string>& remarks) const
  {
    std::vector<std::string> columns = columns_of_case();
    append(columns, {"trials", "frames"});
    append(columns, Frame_statistics::columns());
    append(columns, {"dynamic_mean", "classified", "flips", "rebuilt"});
    common::Csv_file file(path, remarks, columns);
    for (const Frame_case& one : cases()) {
      std::vector<std::string> cells = cells_of(one);
      append(cells,
             {common::csv_cell(one.number_of_trials()), common::csv_cell(one.plan().frames)});
      append(cells, one.whole().cells());
      for (const Mean_and_extremes* const value :
           {&one.dynamic(), &one.classified(), &one.flips(), &one.rebuilt()}) {
        cells.push_back(common::csv_cell(value->mean()));
      }
      file.write_line(cells);
    }
    file.finish();
  }

  void write_bins(const std::filesystem::path& path, const std::vector<std::string>& remarks) const
  {
    std::vector<std::string> columns = columns_of_case();
    append(columns, {"frame", "time"});
    append(columns, Frame_statistics::columns());
    common::Csv_file file(path, remarks, columns);
    for_each_bin([&](const Frame_bin& bin, std::vector<std::string> cells) {
      append(cells, bin.statistics.cells());
      file.write_line(cells);
    });
    file.finish();
  }

  void write_physics(const std::filesystem::path& path,
                     const std::vector<std::string>& remarks) const
  {
    std::vector<std::string> columns = columns_of_case();
    append(columns, {"frame", "time"});
    for (const std::string& name : Physics::names()) {
      Mean_and_extremes::append_columns(name, columns);
    }
    common::Csv_file file(path, remarks, columns);
    for_each_bin([&](const Frame_bin& bin, std::vector<std::string> cells) {
      for (const Mean_and_extremes& value : bin.physics) {
        value.append_cells(cells);
      }
      file.write_line(cells);
    });
    file.finish();
  }

  // Calls `use(bin, cells)` with the cells up to the time.
  template <class Use>
  void for_each_bin(Use use) const
  {
    for (const Frame_case& one : cases()) {
      for (std::size_t bin = 0; bin != one.bins().size(); ++bin) {
        std::vector<std::string> cells = cells_of(one);
        append(cells, {common::csv_cell(one.frame_of_bin(bin)),
                       common::csv_cell(one.bins()[bin].last_time)});
        use(one.bins()[bin], std::move(cells));
      }
    }
  }
};

} // namespace thesis

#endif // THESIS_FRAME_EXPERIMENT_H
