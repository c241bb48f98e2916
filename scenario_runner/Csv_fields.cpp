// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Csv_fields.h"

#include "scenario_runner/Text_input.h"

#include <algorithm>

namespace scenario {

std::string place_of(Separator separator)
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

std::string_view Field_splitter::split(std::string_view line, std::vector<std::string_view>& fields)
{
  fields.clear();
  m_unescaped.clear();
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

void Field_splitter::take_unquoted(std::string_view& line,
                                   std::vector<std::string_view>& fields) const
{
  const std::size_t end = separator_in(line);
  fields.push_back(trimmed(line.substr(0, end)));
  line.remove_prefix(end);
}

std::string_view Field_splitter::take_quoted(std::string_view& line,
                                             std::vector<std::string_view>& fields)
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

std::string_view Field_splitter::unescaped(std::string_view content)
{
  std::string& text = m_unescaped.emplace_back();
  for (std::size_t i = 0; i != content.size(); ++i) {
    text += content[i];
    i += content[i] == '"' ? 1 : 0;
  }
  return text;
}

// The place of the next separator, or the end of the line.
std::size_t Field_splitter::separator_in(std::string_view line) const
{
  const std::size_t place = m_separator == Separator::blanks
                                ? line.find_first_of(" \t\r")
                                : line.find(static_cast<char>(m_separator));
  return (std::min)(place, line.size());
}

// Removes a separator. True if there was one and a field follows it.
bool Field_splitter::take_separator(std::string_view& line) const
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

// Where tabs separate fields they are not blanks.
void Field_splitter::skip_blanks(std::string_view& line) const
{
  while (!line.empty() && is_blank(line.front()) &&
         (m_separator != Separator::tab || line.front() != '\t')) {
    line.remove_prefix(1);
  }
}

} // namespace scenario
