// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_CLASSIFICATION_EXPERIMENT_H
#define THESIS_CLASSIFICATION_EXPERIMENT_H

#include "../classifiers/Classifier_figures.h"
#include "../classifiers/Classifier_run.h"
#include "../classifiers/Recorded_scenario.h"
#include "../common/Csv_file.h"
#include "Experiment.h"
#include "Mean_and_extremes.h"
#include "Trial.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace thesis {

// The columns of `./dev bench classifiers` that are kept; its source explains them.
inline const std::vector<std::string>& classification_columns()
{
  static const std::vector<std::string> names = {"TP",    "FP", "FN", "precision", "recall", "FDR",
                                                 "edges", "CC", "TC", "MCC_mean",  "MCC_min"};
  return names;
}

// A scenario, and what came out of each method on it.
struct Scenario_rows
{
  struct Row
  {
    Method method;
    std::vector<Mean_and_extremes> values =
        std::vector<Mean_and_extremes>(classification_columns().size());
  };

  std::string scenario;
  std::vector<Row> rows;
};

// How well classifiers find the edges that the motion broke, compared with exact predicates. All
// classifiers follow the same motion, which an exact triangulation drives.
class Classification_experiment : public Repeated_experiment<Scenario_rows>
{
public:
  Classification_experiment(std::string name, const Settings& settings, std::size_t usual_trials,
                            std::size_t frames)
    : Repeated_experiment(std::move(name), settings, usual_trials)
    , m_frames(frames)
  {
  }

  void add(const std::string& scenario, const std::vector<Method>& methods)
  {
    Scenario_rows rows{scenario, {}};
    for (const Method& method : methods) {
      rows.rows.push_back({method});
    }
    add_case(std::move(rows));
  }

  void write(const std::filesystem::path& directory,
             const std::vector<std::string>& remarks) const override
  {
    std::vector<std::string> columns = {"scenario", "method", "trials", "frames"};
    for (const std::string& name : classification_columns()) {
      Mean_and_extremes::append_columns(name, columns);
    }
    common::Csv_file file(directory / (name() + ".csv"), remarks, columns);
    for (const Scenario_rows& one : cases()) {
      for (const Scenario_rows::Row& row : one.rows) {
        std::vector<std::string> cells =
            common::csv_cells(one.scenario, method_name(row.method), number_of_trials(), m_frames);
        for (const Mean_and_extremes& value : row.values) {
          value.append_cells(cells);
        }
        file.write_line(cells);
      }
    }
    file.finish();
  }

private:
  double seconds_of(const Scenario_rows& one) const override
  {
    constexpr double seconds_per_frame = 1.1e-3;
    return static_cast<double>(m_frames * one.rows.size()) * seconds_per_frame;
  }

  void run(Scenario_rows& one, std::uint64_t seed) const override
  {
    constexpr std::size_t stride = 5;
    const auto motion = open({one.scenario, {}, seed});
    const classifiers::Recorded_frames recording = classifiers::record(*motion, m_frames);
    for (Scenario_rows::Row& row : one.rows) {
      Method method = row.method;
      method.seed = seed;
      const classifiers::Classifier_record record =
          classifiers::run_method(recording, method, 1, stride);
      const common::Figures figures = classifiers::classifier_result(recording, record).figures;
      for (std::size_t i = 0; i != row.values.size(); ++i) {
        const auto figure = figures.find(classification_columns()[i]);
        if (figure != figures.end()) {
          row.values[i].add(figure->second);
        }
      }
    }
  }

  std::size_t m_frames;
};

} // namespace thesis

#endif // THESIS_CLASSIFICATION_EXPERIMENT_H
