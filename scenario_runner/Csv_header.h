// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CSV_HEADER_H
#define SCENARIO_RUNNER_CSV_HEADER_H

#include "scenario_runner/Csv_fields.h"
#include "scenario_runner/Recorded_motion.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

enum Csv_column : std::size_t { frame, time, id, x, y, z };
constexpr std::array<std::string_view, 6> csv_column_names = {"frame", "time", "id", "x", "y", "z"};

// How the rows of a table are split, and where the columns are in a row.
struct Csv_layout
{
  static constexpr std::size_t none = std::string::npos;

  Separator separator = Separator::comma;
  std::size_t number_of_fields = 0;
  std::array<std::size_t, csv_column_names.size()> positions = {none, none, none, none, none, none};
  std::size_t more_header_lines = 0;   // at most so many lines without numbers follow the header
  std::vector<std::size_t> constant{}; // where all rows have to have the same text

  bool has(Csv_column column) const { return positions[column] != none; }
};

// What one program calls the columns, in lower case. Where it has no frames, points of one time are
// a frame.
struct Csv_dialect
{
  std::array<std::string, csv_column_names.size()> names;
  std::size_t more_header_lines = 0;
};

// The line that names the columns, and the separator at which it and all rows are split.
class Csv_header
{
public:
  // `separators`: the possible ones, the preferred ones first. Blanks, at which any text can be
  // split, are chosen only if no other separator finds two columns.
  Csv_header(const std::string& file, std::string_view line, std::size_t line_number,
             const std::vector<Separator>& separators, const Table_columns& columns);

  // How many columns of one dialect it names, and whether these are all that are needed.
  std::size_t known() const { return m_split.known; }
  bool is_complete() const { return m_split.is_complete; }
  bool has_numbers() const;

  // \throws Scenario_error if a column is missing or is there twice.
  Csv_layout layout() const;

private:
  struct Split
  {
    Separator separator = Separator::comma;
    std::vector<std::string> titles{};
    Csv_dialect dialect{}; // the one of which most columns are there
    std::size_t known = 0;
    bool is_complete = false;
    std::string problem{};
  };

  Split split_at(Separator separator, std::string_view line) const;
  void choose_dialect(Split& split) const;
  bool is_complete(const Csv_dialect& dialect, const std::vector<std::string>& titles) const;
  static bool is_better(const Split& split, const Split& than);
  Csv_dialect renamed(Csv_dialect dialect) const;
  std::size_t position_of(Csv_column column) const;
  void check_given_titles() const;
  void check_units(const std::string& x_title, const std::string& y_title) const;
  [[noreturn]] void fail_missing() const;
  std::string what_it_has() const;
  [[noreturn]] void fail(const std::string& message) const;

  std::string m_file;
  std::size_t m_line_number;
  Table_columns m_columns;
  Split m_split;
};

// The layout of a table whose columns are named in their order, by its first row.
// \throws Scenario_error if the row has fewer fields.
Csv_layout layout_in_order(const std::string& file, std::string_view row, std::size_t line_number,
                           const Table_columns& columns);

// The layout of JuPedSim's and PedPy's files, which need no header: id, frame, x, y, and others.
// Nothing if the row has too few fields.
std::optional<Csv_layout> layout_of_jupedsim(std::string_view row);

} // namespace scenario

#endif // SCENARIO_RUNNER_CSV_HEADER_H
