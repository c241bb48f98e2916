// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Csv_writer.h"

#include <stdexcept>

namespace run {

namespace {

std::string quoted_where_needed(const std::string& cell)
{
  if (cell.find_first_of(",\"\r\n") == std::string::npos) {
    return cell;
  }
  std::string text = "\"";
  for (const char c : cell) {
    text += c;
    text += c == '"' ? "\"" : "";
  }
  return text + '"';
}

} // namespace

Csv_writer::Csv_writer(const std::string& path, const std::vector<std::string>& columns,
                       const std::vector<std::string>& remarks)
  : m_file(path)
  , m_path(path)
  , m_number_of_columns(columns.size())
{
  for (const std::string& remark : remarks) {
    m_file.stream() << "# " << remark << '\n';
  }
  write_row(columns);
}

void Csv_writer::write_row(const std::vector<std::string>& cells)
{
  if (cells.size() != m_number_of_columns) {
    throw std::logic_error(m_path + ": a row of " + std::to_string(cells.size()) +
                           " cells, allowed are " + std::to_string(m_number_of_columns));
  }
  const char* separator = "";
  for (const std::string& cell : cells) {
    m_file.stream() << separator << quoted_where_needed(cell);
    separator = ",";
  }
  m_file.stream() << '\n';
  m_file.check();
}

} // namespace run
