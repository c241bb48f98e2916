// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_SPEED_TABLE_REPORTER_H
#define SPEED_SPEED_TABLE_REPORTER_H

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace speed {

// Of a user counter, whose name is the column's head.
struct Column
{
  std::string name;
  int width;
  int decimals;
};

struct Table
{
  std::string title;
  std::vector<Column> columns;
};

// By the names of the benchmarks.
using Tables = std::map<std::string, const Table*>;

// Google Benchmark's own table has a column for every counter, in alphabetical order, behind three
// that say nothing here. This one has a title and the columns of a group of cases in their order.
class Speed_table_reporter : public benchmark::ConsoleReporter
{
public:
  explicit Speed_table_reporter(const Tables& tables)
    : ConsoleReporter(OO_None)
    , m_tables(tables)
  {
    for (const auto& [name, table] : tables) {
      m_name_width = (std::max)(m_name_width, name.size());
    }
  }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs) {
      if (run.aggregate_unit == benchmark::kPercentage) {
        continue; // of repetitions; it does not fit the columns
      }
      const Table& table = *m_tables.at(run.run_name.function_name);
      if (m_last_table != &table) {
        write_heads(table);
        m_last_table = &table;
      }
      write_row(table, run);
    }
    GetOutputStream().flush();
  }

private:
  void write_heads(const Table& table)
  {
    std::ostream& out = GetOutputStream();
    out << '\n' << table.title << '\n' << std::string(m_name_width, ' ');
    for (const Column& column : table.columns) {
      out << std::right << std::setw(column.width) << column.name;
    }
    out << '\n';
  }

  void write_row(const Table& table, const Run& run)
  {
    std::string name = run.run_name.function_name;
    if (run.run_type == Run::RT_Aggregate) {
      name += ' ' + run.aggregate_name;
    }
    std::ostream& out = GetOutputStream();
    out << std::left << std::setw(static_cast<int>(m_name_width)) << name;
    if (run.error_occurred) {
      out << "  " << run.error_message << '\n';
      return;
    }
    for (const Column& column : table.columns) {
      out << std::right << std::setw(column.width) << value_text(column, run);
    }
    out << (run.report_label.empty() ? "" : "  ") << run.report_label << '\n';
  }

  static std::string value_text(const Column& column, const Run& run)
  {
    const auto counter = run.counters.find(column.name);
    if (counter == run.counters.end()) {
      return "-";
    }
    std::ostringstream text;
    text << std::fixed << std::setprecision(column.decimals) << counter->second.value;
    return text.str();
  }

  const Tables& m_tables;
  std::size_t m_name_width = 0;
  const Table* m_last_table = nullptr;
};

} // namespace speed

#endif // SPEED_SPEED_TABLE_REPORTER_H
