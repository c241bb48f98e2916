// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CSV_FIELDS_H
#define SCENARIO_RUNNER_CSV_FIELDS_H

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

// What separates the fields of a line. Blanks are spaces and tabs, any number of them.
enum class Separator : char { comma = ',', semicolon = ';', tab = '\t', blanks = ' ' };

// How messages call the separators of a line.
std::string place_of(Separator separator);

// Splits a line into fields. A field that begins with a double quote ends with the next single
// one, and may contain separators; two double quotes in it stand for one. Blanks around the content
// of fields are not part of it, quoted or not.
class Field_splitter
{
public:
  explicit Field_splitter(Separator separator)
    : m_separator(separator)
  {
  }

  Separator separator() const { return m_separator; }

  // Returns what is wrong with the field that follows those in `fields`, or an empty text if all is
  // well. Fields refer to the line; those with doubled quotes are valid until the next call.
  std::string_view split(std::string_view line, std::vector<std::string_view>& fields);

private:
  // Both functions remove the field from the line, which then begins with the next separator.
  void take_unquoted(std::string_view& line, std::vector<std::string_view>& fields) const;
  std::string_view take_quoted(std::string_view& line, std::vector<std::string_view>& fields);

  std::string_view unescaped(std::string_view content);
  std::size_t separator_in(std::string_view line) const;
  bool take_separator(std::string_view& line) const;
  void skip_blanks(std::string_view& line) const;

  Separator m_separator;
  std::deque<std::string> m_unescaped;
};

} // namespace scenario

#endif // SCENARIO_RUNNER_CSV_FIELDS_H
