// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_CSV_FILE_H
#define COMMON_CSV_FILE_H

#include "scenario_runner/Csv_writer.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace common {

// Five digits: more than any timing has, and small files.
template <class Value>
std::string csv_cell(const Value& value, int digits = 5)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

// Numbers and texts as cells.
template <class... Values>
std::vector<std::string> csv_cells(const Values&... values)
{
  return {csv_cell(values)...};
}

// Results of a benchmark, for people, plots and version control. Lines that start with `#` say what
// made them.
class Csv_file
{
public:
  // `remarks` are lines of their own at the top, such as the command that wrote the file.
  Csv_file(const std::filesystem::path& path, const std::vector<std::string>& remarks,
           const std::vector<std::string>& columns)
    : m_path(path.string())
    , m_writer(m_path, columns, remarks)
  {
  }

  // Numbers and texts, one for each column.
  template <class... Values>
  void write_row(const Values&... values)
  {
    write_line(csv_cells(values...));
  }

  // Cells that would need quotation marks are refused: not all plotting programs read them.
  void write_line(const std::vector<std::string>& cells)
  {
    for (const std::string& cell : cells) {
      if (cell.find_first_of(",\"\n") != std::string::npos) {
        throw std::logic_error(m_path + ": the cell '" + cell + "' would need quotation marks");
      }
    }
    m_writer.write_row(cells);
  }

  void finish() { m_writer.finish(); }

private:
  std::string m_path;
  run::Csv_writer m_writer;
};

} // namespace common

#endif // COMMON_CSV_FILE_H
