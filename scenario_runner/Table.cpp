// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace run {

Table::Table(std::vector<std::string> headings, Align others)
  : m_others(others)
{
  if (!headings.empty()) {
    m_rows.push_back(std::move(headings));
  }
}

void Table::write(std::ostream& out) const
{
  std::vector<std::size_t> widths;
  for (const auto& row : m_rows) {
    widths.resize((std::max)(widths.size(), row.size()));
    for (std::size_t i = 0; i != row.size(); ++i) {
      widths[i] = (std::max)(widths[i], row[i].size());
    }
  }
  for (const auto& row : m_rows) {
    std::string line;
    for (std::size_t i = 0; i != row.size(); ++i) {
      const std::string padding(widths[i] - row[i].size(), ' ');
      const bool is_left = i == 0 || m_others == Align::LEFT;
      line += (i == 0 ? "" : "  ") + (is_left ? row[i] + padding : padding + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

} // namespace run
