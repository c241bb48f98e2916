// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_CSV_TABLES_H
#define CLASSIFIERS_CSV_TABLES_H

#include "../speed/Speed_summary.h"
#include "../speed/Speed_table_reporter.h"
#include "scenario_runner/Output_file.h"

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace classifiers {

// Collects the rows of each table, and writes each table into a file of its own, as comma separated
// values: all digits, and nothing where there is no figure.
class Csv_tables
{
public:
  void add(const speed::Table& table, const std::string& name, const speed::Figures& figures)
  {
    m_rows[&table].emplace_back(name, figures);
  }

  bool has(const speed::Table& table) const { return m_rows.count(&table) != 0; }

  void write(const speed::Table& table, const std::string& path) const
  {
    run::Output_file file(path);
    std::ostream& out = file.stream();
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "name";
    for (const speed::Column& column : table.columns) {
      out << ',' << column.name;
    }
    out << '\n';
    for (const auto& [name, figures] : m_rows.at(&table)) {
      write_row(out, table, name, figures);
    }
    file.finish();
  }

private:
  static void write_row(std::ostream& out, const speed::Table& table, const std::string& name,
                        const speed::Figures& figures)
  {
    out << name;
    for (const speed::Column& column : table.columns) {
      out << ',';
      const auto figure = figures.find(column.name);
      if (figure != figures.end()) {
        out << figure->second;
      }
    }
    out << '\n';
  }

  std::map<const speed::Table*, std::vector<std::pair<std::string, speed::Figures>>> m_rows;
};

} // namespace classifiers

#endif // CLASSIFIERS_CSV_TABLES_H
