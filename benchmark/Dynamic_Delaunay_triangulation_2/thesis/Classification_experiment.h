// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_CLASSIFICATION_EXPERIMENT_H
#define THESIS_CLASSIFICATION_EXPERIMENT_H

#include "../classifiers/Classifier_figures.h"
#include "../classifiers/Classifier_run.h"
#include "../results/Csv_file.h"
#include "Experiment.h"
#include "Frame_experiment.h"
#include "Mean_and_extremes.h"
#include "Settings.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace thesis {

// How well classifiers find what the motion broke, held against the truth by exact predicates: all
// follow the same motion, which an exact triangulation drives.
class Classification_experiment : public Experiment
{
public:
  Classification_experiment(std::string name, const Settings& settings, std::size_t usual_trials,
                            std::size_t frames)
    : Experiment(std::move(name))
    , m_trials(settings.number_of_trials(usual_trials))
    , m_first_seed(settings.seed)
    , m_frames(frames)
  {
  }

  void add(const std::string& scenario, const std::vector<Method>& methods)
  {
    m_scenarios.push_back({scenario, {}});
    for (const Method& method : methods) {
      m_scenarios.back().rows.push_back({method, {}});
    }
  }

  std::vector<Job> jobs() override
  {
    constexpr double seconds_per_frame = 1.1e-3;
    std::vector<Job> jobs;
    for (std::size_t trial = 0; trial != m_trials; ++trial) {
      for (Scenario_rows& one : m_scenarios) {
        jobs.push_back({static_cast<double>(m_frames * one.rows.size()) * seconds_per_frame,
                        [this, &one, seed = m_first_seed + trial] { run(one, seed); }});
      }
    }
    return jobs;
  }

  void write(const std::filesystem::path& directory,
             const std::vector<std::string>& remarks) const override
  {
    std::vector<std::string> columns = {"scenario", "method", "trials", "frames"};
    for (const std::string& name : names()) {
      Mean_and_extremes::append_columns(name, columns);
    }
    results::Csv_file file(directory / (name() + ".csv"), remarks, columns);
    for (const Scenario_rows& one : m_scenarios) {
      for (const Row& row : one.rows) {
        std::vector<std::string> cells = {one.scenario, method_name(row.method),
                                          results::csv_cell(m_trials), results::csv_cell(m_frames)};
        for (const Mean_and_extremes& value : row.values) {
          value.append_cells(cells);
        }
        file.write_line(cells);
      }
    }
    file.finish();
  }

private:
  static constexpr std::size_t number_of_values = 11;

  // Those of `./dev bench classifiers`, whose source explains them.
  static std::array<std::string, number_of_values> names()
  {
    return {"TP",    "FP", "FN", "precision", "recall", "FDR",
            "edges", "CC", "TC", "MCC_mean",  "MCC_min"};
  }

  struct Row
  {
    Method method;
    std::array<Mean_and_extremes, number_of_values> values;
  };

  struct Scenario_rows
  {
    std::string scenario;
    std::vector<Row> rows;
  };

  void run(Scenario_rows& one, std::uint64_t seed) const
  {
    constexpr std::size_t stride = 5;
    const auto motion = open({one.scenario, {}, seed});
    const classifiers::Recorded_frames recording = classifiers::record(*motion, m_frames);
    for (Row& row : one.rows) {
      Method method = row.method;
      method.seed = seed;
      const classifiers::Classifier_record record =
          classifiers::run_method(recording, method, 1, stride);
      const speed::Figures figures = classifiers::classifier_result(recording, record).figures;
      for (std::size_t i = 0; i != number_of_values; ++i) {
        const auto figure = figures.find(names()[i]);
        if (figure != figures.end()) {
          row.values[i].add(figure->second);
        }
      }
    }
  }

  std::size_t m_trials;
  std::uint64_t m_first_seed;
  std::size_t m_frames;
  std::list<Scenario_rows> m_scenarios; // they stay where they are
};

} // namespace thesis

#endif // THESIS_CLASSIFICATION_EXPERIMENT_H
