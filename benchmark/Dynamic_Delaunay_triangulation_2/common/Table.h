// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_TABLE_H
#define COMMON_TABLE_H

#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace common {

struct Column
{
  std::string name;
  int width;
  int decimals = 0; // of floating-point numbers
};

template <class Value>
std::string cell(const Value& value, int decimals)
{
  std::ostringstream text;
  if constexpr (std::is_floating_point_v<Value>) {
    text << std::fixed << std::setprecision(decimals);
  }
  text << value;
  return text.str();
}

// For people: rows with a name, and right-aligned cells behind it.
class Table
{
public:
  Table(std::ostream& out, int name_width, std::vector<Column> columns)
    : m_out(out)
    , m_name_width(name_width)
    , m_columns(std::move(columns))
  {
  }

  const std::vector<Column>& columns() const { return m_columns; }

  void write_head(const std::string& title)
  {
    std::vector<std::string> names;
    for (const Column& column : m_columns) {
      names.push_back(column.name);
    }
    write_cells(title, names);
  }

  // One value for each column.
  template <class... Values>
  void write_row(const std::string& name, const Values&... values)
  {
    auto column = m_columns.begin();
    write_cells(name, {cell(values, (column++)->decimals)...});
  }

  // Writes cells, which may be fewer than the columns; `note` follows them.
  void write_cells(const std::string& name, const std::vector<std::string>& cells,
                   const std::string& note = "")
  {
    m_out << std::left << std::setw(m_name_width) << name << std::right;
    for (std::size_t i = 0; i != cells.size(); ++i) {
      m_out << std::setw(m_columns[i].width) << cells[i];
    }
    m_out << note << std::endl;
  }

private:
  std::ostream& m_out;
  int m_name_width;
  std::vector<Column> m_columns;
};

} // namespace common

#endif // COMMON_TABLE_H
