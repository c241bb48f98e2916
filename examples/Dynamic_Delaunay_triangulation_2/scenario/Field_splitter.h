// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_FIELD_SPLITTER_H
#define SCENARIO_FIELD_SPLITTER_H

#include "Text_scanner.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

// Of the fields of a line. Blanks are spaces and tabs, any number of them.
enum class Separator : char { comma = ',', semicolon = ';', tab = '\t', blanks = ' ' };

// As a message says where a line is split.
inline std::string place_of(Separator separator)
{
  switch (separator) {
  case Separator::comma:
    return "commas";
  case Separator::semicolon:
    return "semicolons";
  case Separator::tab:
    return "tabs";
  default:
    return "blanks";
  }
}

// Splits a line into fields. One that begins with a double quote ends with the next single one, and
// may hold separators; two of them stand for one. Blanks around the content of fields are no part
// of it, quoted or not.
class Field_splitter
{
public:
  explicit Field_splitter(Separator separator)
    : m_separator(separator)
  {
  }

  Separator separator() const { return m_separator; }

  // Says what is wrong with the field that follows those in `fields`, or nothing if all is well.
  // The fields live as long as the line, those with two quotes in them until the next call.
  std::string_view split(std::string_view line, std::vector<std::string_view>& fields)
  {
    fields.clear();
    m_unescaped.clear();
    if (line.find('"') == std::string_view::npos) {
      split_unquoted(line, fields);
      return {};
    }
    return split_quoted(line, fields);
  }

private:
  void split_unquoted(std::string_view line, std::vector<std::string_view>& fields) const
  {
    if (m_separator == Separator::blanks) {
      split_at_blanks(line, fields);
      return;
    }
    std::size_t end = 0;
    while ((end = line.find(static_cast<char>(m_separator))) != std::string_view::npos) {
      fields.push_back(trimmed(line.substr(0, end)));
      line.remove_prefix(end + 1);
    }
    fields.push_back(trimmed(line));
  }

  std::string_view split_quoted(std::string_view line, std::vector<std::string_view>& fields)
  {
    skip_blanks(line);
    do {
      if (line.empty() || line.front() != '"') {
        take_unquoted(line, fields);
      } else if (const auto problem = take_quoted(line, fields); !problem.empty()) {
        return problem;
      }
    } while (take_separator(line));
    return {};
  }

  // Both leave the line from the next separator on.
  void take_unquoted(std::string_view& line, std::vector<std::string_view>& fields) const
  {
    const std::size_t end = separator_in(line);
    fields.push_back(trimmed(line.substr(0, end)));
    line.remove_prefix(end);
  }

  std::string_view take_quoted(std::string_view& line, std::vector<std::string_view>& fields)
  {
    line.remove_prefix(1);
    bool is_escaped = false;
    std::size_t length = line.find('"');
    while (length != std::string_view::npos && line.substr(length, 2) == "\"\"") {
      is_escaped = true;
      length = line.find('"', length + 2);
    }
    if (length == std::string_view::npos) {
      return "begins with a quote that does not end in its line";
    }
    const std::string_view content = line.substr(0, length);
    line.remove_prefix(length + 1);
    const std::size_t end = separator_in(line);
    if (!trimmed(line.substr(0, end)).empty()) {
      return "goes on after its closing quote";
    }
    line.remove_prefix(end);
    fields.push_back(trimmed(is_escaped ? unescaped(content) : content));
    return {};
  }

  std::string_view unescaped(std::string_view content)
  {
    std::string& text = m_unescaped.emplace_back();
    for (std::size_t i = 0; i != content.size(); ++i) {
      text += content[i];
      i += content[i] == '"' ? 1 : 0;
    }
    return text;
  }

  // The end of the line stands for one, too.
  std::size_t separator_in(std::string_view line) const
  {
    const std::size_t place = m_separator == Separator::blanks
                                  ? line.find_first_of(" \t")
                                  : line.find(static_cast<char>(m_separator));
    return (std::min)(place, line.size());
  }

  // Whether there is one, and a field behind it.
  bool take_separator(std::string_view& line) const
  {
    if (line.empty()) {
      return false;
    }
    if (m_separator != Separator::blanks) {
      line.remove_prefix(1);
    }
    skip_blanks(line);
    return m_separator != Separator::blanks || !line.empty();
  }

  // A tab that separates is none.
  void skip_blanks(std::string_view& line) const
  {
    while (!line.empty() && is_blank(line.front()) &&
           (m_separator != Separator::tab || line.front() != '\t')) {
      line.remove_prefix(1);
    }
  }

  Separator m_separator;
  std::deque<std::string> m_unescaped;
};

} // namespace scenario

#endif // SCENARIO_FIELD_SPLITTER_H
