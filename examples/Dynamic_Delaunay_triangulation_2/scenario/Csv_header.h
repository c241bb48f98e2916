// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_CSV_HEADER_H
#define SCENARIO_CSV_HEADER_H

#include "Field_splitter.h"
#include "Motion_file.h"
#include "Scenario_error.h"
#include "Text_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace scenario {

enum Csv_column : std::size_t { frame, time, id, x, y };
constexpr std::array<std::string_view, 5> csv_column_names = {"frame", "time", "id", "x", "y"};

// What a column is called: `x`, or `X/m`, `x [m]`, `x (m)`. A name with something else behind it,
// as in the quotient `x/y`, is the name of something else.
class Csv_title
{
public:
  explicit Csv_title(std::string_view title)
    : m_name(lower_case(std::string(trimmed(title.substr(0, title.find_first_of("/[("))))))
    , m_unit(title.substr((std::min)(title.find_first_of("/[("), title.size())))
  {
    m_unit.erase(std::remove_if(m_unit.begin(), m_unit.end(),
                                [](char c) { return is_blank(c) || is_one_of(c, "/[]()"); }),
                 m_unit.end());
    const auto alias = std::find_if(aliases.begin(), aliases.end(),
                                    [this](const auto& names) { return m_name == names.first; });
    m_name = alias == aliases.end() ? m_name : alias->second;
  }

  bool names(std::string_view column) const { return m_name == column && has_known_unit(); }
  const std::string& unit() const { return m_unit; }

private:
  // Those of PeTrack and JuPedSim.
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 2> aliases = {
      {{"persid", "id"}, {"fr", "frame"}}};
  static constexpr std::array<std::string_view, 24> units = {
      "",   "m",  "dm",    "cm",     "mm",  "um", "\xC2\xB5m", "\xCE\xBCm", "nm", "km", "ft",  "in",
      "px", "au", "pixel", "pixels", "deg", "s",  "sec",       "ms",        "us", "ns", "min", "h"};

  static bool is_one_of(char c, std::string_view characters)
  {
    return characters.find(c) != std::string_view::npos;
  }

  bool has_known_unit() const
  {
    return std::find(units.begin(), units.end(), lower_case(m_unit)) != units.end();
  }

  std::string m_name;
  std::string m_unit;
};

// The line that names the columns, and the separator at which it and all rows are split.
class Csv_header
{
public:
  // `separators`: those that may be, the preferred ones first. Blanks, at which anything can be
  // split, are taken where no other one finds two columns.
  Csv_header(const std::string& file, std::string_view line, std::size_t line_number,
             std::initializer_list<Separator> separators)
    : m_file(file)
    , m_line_number(line_number)
  {
    for (const Separator separator : separators) {
      const Split split = split_at(separator, line);
      if (m_split.titles.empty() || is_better(split, m_split)) {
        m_split = split;
      }
    }
  }

  Separator separator() const { return m_split.separator; }
  std::size_t number_of_fields() const { return m_split.titles.size(); }

  // Whether it can be one.
  bool names_any_column() const { return m_split.known != 0; }
  bool has_numbers() const
  {
    return std::any_of(m_split.titles.begin(), m_split.titles.end(), is_number);
  }

  // Where the fields of the columns are; that of `time` is none if it is not there.
  static constexpr std::size_t none = std::string::npos;
  std::array<std::size_t, csv_column_names.size()> positions() const
  {
    if (!m_split.problem.empty()) {
      fail("field " + std::to_string(m_split.titles.size() + 1) + " " + m_split.problem);
    }
    std::array<std::size_t, csv_column_names.size()> positions{};
    std::vector<std::string> missing;
    for (std::size_t column = 0; column != csv_column_names.size(); ++column) {
      positions[column] = position_of(csv_column_names[column]);
      if (positions[column] == none && column != Csv_column::time) {
        missing.push_back(in_quotes(csv_column_names[column]));
      }
    }
    if (!missing.empty()) {
      fail_missing(missing);
    }
    check_units(m_split.titles[positions[Csv_column::x]], m_split.titles[positions[Csv_column::y]]);
    return positions;
  }

private:
  struct Split
  {
    Separator separator = Separator::comma;
    std::vector<std::string> titles{};
    std::size_t known = 0; // how many titles name a column
    std::string problem{};
  };

  static Split split_at(Separator separator, std::string_view line)
  {
    Split split{separator};
    std::vector<std::string_view> fields;
    Field_splitter splitter(separator);
    split.problem = splitter.split(line, fields);
    split.titles.assign(fields.begin(), fields.end());
    for (const std::string_view name : csv_column_names) {
      split.known += std::any_of(fields.begin(), fields.end(), [&](std::string_view title) {
        return Csv_title(title).names(name);
      });
    }
    return split;
  }

  static bool is_better(const Split& split, const Split& than)
  {
    if (split.separator == Separator::blanks && than.known >= 2) {
      return false;
    }
    return std::pair(split.known, split.titles.size()) > std::pair(than.known, than.titles.size());
  }

  static bool is_number(std::string_view text)
  {
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
  }

  std::size_t position_of(std::string_view name) const
  {
    const auto is_it = [name](const std::string& title) { return Csv_title(title).names(name); };
    const auto& titles = m_split.titles;
    const auto found = std::find_if(titles.begin(), titles.end(), is_it);
    if (found == titles.end()) {
      return none;
    }
    const auto again = std::find_if(found + 1, titles.end(), is_it);
    if (again != titles.end()) {
      fail("column '" + std::string(name) + "' is there twice, as " + in_quotes(*found) + " and " +
           in_quotes(*again));
    }
    return static_cast<std::size_t>(found - titles.begin());
  }

  void check_units(const std::string& x_title, const std::string& y_title) const
  {
    if (Csv_title(x_title).unit() != Csv_title(y_title).unit()) {
      fail("the columns " + in_quotes(x_title) + " and " + in_quotes(y_title) +
           " have different units, allowed are equal ones");
    }
  }

  [[noreturn]] void fail_missing(const std::vector<std::string>& names) const
  {
    std::string text = names.size() == 1 ? "column " : "columns ";
    for (std::size_t i = 0; i != names.size(); ++i) {
      text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    }
    fail(text + (names.size() == 1 ? " is" : " are") +
         " missing, needed are frame, id, x and y; the header has " + what_it_has());
  }

  // As much of it as a message can hold.
  std::string what_it_has() const
  {
    constexpr std::size_t max_characters = 80;
    const auto& titles = m_split.titles;
    if (titles.size() == 1) {
      return "one column, " + in_quotes(titles.front()) +
             ", as separators are commas, semicolons, tabs or blanks";
    }
    std::string list;
    for (const std::string& title : titles) {
      if (list.size() + title.size() > max_characters && !list.empty()) {
        list += ", ...";
        break;
      }
      list += (list.empty() ? "" : ", ") + in_quotes(title);
    }
    return std::to_string(titles.size()) + " columns, split at " + place_of(m_split.separator) +
           ": " + list;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Scenario_error(m_file, message, m_line_number);
  }

  std::string m_file;
  std::size_t m_line_number;
  Split m_split;
};

} // namespace scenario

#endif // SCENARIO_CSV_HEADER_H
