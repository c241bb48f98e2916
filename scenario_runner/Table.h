// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_TABLE_H
#define SCENARIO_RUNNER_TABLE_H

#include "scenario_runner/Number_text.h"

#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace run {

// Rows of cells for people, columns as wide as their widest cells. The first column is aligned
// left.
class Table
{
public:
  enum class Align { LEFT, RIGHT };

  // Without headings there is no line of them. `others`: alignment of columns after the first one.
  explicit Table(std::vector<std::string> headings = {}, Align others = Align::RIGHT);

  // Texts, whole numbers, and other numbers as readable() has them. Rows may differ in length.
  template <class... Cells>
  void add(const Cells&... cells)
  {
    m_rows.push_back({text_of(cells)...});
  }

  void write(std::ostream& out) const;

private:
  template <class Cell>
  static std::string text_of(const Cell& cell)
  {
    if constexpr (std::is_integral_v<Cell>) {
      return std::to_string(cell);
    } else if constexpr (std::is_convertible_v<Cell, std::string>) {
      return cell;
    } else {
      return readable(cell);
    }
  }

  Align m_others;
  std::vector<std::vector<std::string>> m_rows;
};

} // namespace run

#endif // SCENARIO_RUNNER_TABLE_H
