// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_FRAME_STATISTICS_H
#define THESIS_FRAME_STATISTICS_H

#include "../results/Csv_file.h"
#include "Mean_and_extremes.h"
#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"

#include <cstddef>
#include <string>
#include <vector>

namespace thesis {

// Of frames of several trials that belong together, all of them timed against the static opponents.
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
    std::vector<std::string> cells = {results::csv_cell(m_dynamic.size())};
    m_validity.append_cells(cells);
    for (const auto* const values : {&m_dynamic, &m_over_insert, &m_over_fastest}) {
      const run::Spread spread = *run::spread(*values);
      for (const double value : {spread.median, spread.low_quartile, spread.high_quartile}) {
        cells.push_back(results::csv_cell(value));
      }
    }
    for (const auto* const values : {&m_insert, &m_fastest}) {
      cells.push_back(results::csv_cell(run::spread(*values)->median));
    }
    return cells;
  }

private:
  Mean_and_extremes m_validity;
  std::vector<double> m_dynamic, m_insert, m_fastest; // nanoseconds a point
  std::vector<double> m_over_insert, m_over_fastest;
};

} // namespace thesis

#endif // THESIS_FRAME_STATISTICS_H
