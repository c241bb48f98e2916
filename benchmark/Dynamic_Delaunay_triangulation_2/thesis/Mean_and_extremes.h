// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_MEAN_AND_EXTREMES_H
#define THESIS_MEAN_AND_EXTREMES_H

#include "../common/Csv_file.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace thesis {

// The mean, minimum and maximum of numbers, which are not stored.
class Mean_and_extremes
{
public:
  void add(double value)
  {
    m_sum += value;
    m_low = (std::min)(m_low, value);
    m_high = (std::max)(m_high, value);
    ++m_number;
  }

  double mean() const { return m_sum / static_cast<double>(m_number); }

  static void append_columns(const std::string& name, std::vector<std::string>& columns)
  {
    columns.insert(columns.end(), {name, name + "_min", name + "_max"});
  }

  // Where nothing was added the cells are empty.
  void append_cells(std::vector<std::string>& cells) const
  {
    for (const double value : {mean(), m_low, m_high}) {
      cells.push_back(m_number == 0 ? "" : common::csv_cell(value));
    }
  }

private:
  double m_sum = 0.0;
  double m_low = std::numeric_limits<double>::infinity();
  double m_high = -std::numeric_limits<double>::infinity();
  std::size_t m_number = 0;
};

} // namespace thesis

#endif // THESIS_MEAN_AND_EXTREMES_H
