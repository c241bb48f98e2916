// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CSV_WRITER_H
#define SCENARIO_RUNNER_CSV_WRITER_H

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Output_file.h"

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace run {

// Writes comma separated values to a file that exists as a whole or not at all.
class Csv_writer
{
public:
  // `remarks` stand above the columns, in lines that begin with #.
  Csv_writer(const std::string& path, const std::vector<std::string>& columns,
             const std::vector<std::string>& remarks = {});

  // Writes a cell for each column: texts, whole numbers, bools as 0 and 1, other numbers with all
  // their digits, and optional numbers, empty for none.
  // \throws std::logic_error if their number is another one
  template <class... Cells>
  void write(const Cells&... cells)
  {
    write_row({text_of(cells)...});
  }
  void write_row(const std::vector<std::string>& cells);

  void finish() { m_file.finish(); }

private:
  template <class Cell>
  static std::string text_of(const Cell& cell)
  {
    if constexpr (std::is_integral_v<Cell>) {
      return std::to_string(cell);
    } else if constexpr (std::is_floating_point_v<Cell>) {
      return number_text(cell);
    } else {
      return cell;
    }
  }

  template <class Cell>
  static std::string text_of(const std::optional<Cell>& cell)
  {
    return cell ? text_of(*cell) : std::string();
  }

  Output_file m_file;
  std::string m_path;
  std::size_t m_number_of_columns;
};

} // namespace run

#endif // SCENARIO_RUNNER_CSV_WRITER_H
