// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_TEXT_SCANNER_H
#define SCENARIO_TEXT_SCANNER_H

#include "Scenario_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace scenario {

inline bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

inline std::string_view trimmed(std::string_view text)
{
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

// For messages, which a long line of foreign data must not drown.
inline std::string in_quotes(std::string_view text)
{
  constexpr std::size_t longest = 40;
  return "'" + std::string(text.substr(0, longest)) + (text.size() > longest ? "...'" : "'");
}

inline void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields)
{
  constexpr std::string_view blanks = " \t\r";
  fields.clear();
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(blanks)) != std::string_view::npos) {
    line.remove_prefix(begin);
    const std::size_t end = line.find_first_of(blanks);
    fields.push_back(line.substr(0, end));
    line.remove_prefix(end == std::string_view::npos ? line.size() : end);
  }
}

// Walks over the lines of a text that outlives it, and reads numbers with the current line as the
// place of every error.
class Text_scanner
{
public:
  Text_scanner(std::string file, std::string_view text)
    : m_file(std::move(file))
    , m_rest(text)
  {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (m_rest.substr(0, byte_order_mark.size()) == byte_order_mark) {
      m_rest.remove_prefix(byte_order_mark.size());
    }
    const std::string_view start = m_rest.substr(0, 2);
    if (start == "\xFF\xFE" || start == "\xFE\xFF") {
      throw Scenario_error(m_file, "is UTF-16 text, expected UTF-8", 1);
    }
  }

  // The next line that is not blank, without blanks around it, or false at the end.
  bool next_line(std::string_view& line)
  {
    const bool is_there = next_whole_line(line);
    line = trimmed(line);
    return is_there;
  }

  // The same with the blanks around it, of which a tab may separate fields.
  bool next_whole_line(std::string_view& line)
  {
    while (!m_rest.empty()) {
      ++m_line_number;
      const std::size_t end = m_rest.find('\n');
      line = m_rest.substr(0, end);
      m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
      if (!std::all_of(line.begin(), line.end(), is_blank)) {
        return true;
      }
    }
    return false;
  }

  double number(std::string_view text, std::string_view what) const
  {
    return parsed<double>(text, what, "a number");
  }

  std::int64_t integer(std::string_view text, std::string_view what) const
  {
    return parsed<std::int64_t>(text, what, "an integer");
  }

  // An integer that may be written as 3.0 or 3e2, as programs do that know floating point alone.
  // Nothing if the text is no number at all.
  std::optional<std::int64_t> whole_number(std::string_view text, std::string_view what) const
  {
    std::int64_t integer{};
    if (is_parsed(text, what, integer)) {
      return integer;
    }
    double value{};
    if (!is_parsed(text, what, value)) {
      return std::nullopt;
    }
    if (!(std::trunc(value) == value)) {
      fail(std::string(what) + " " + in_quotes(text) + " is not an integer");
    }
    constexpr double most = 9007199254740992.0; // beyond it not all integers are doubles
    if (std::abs(value) > most) {
      fail(std::string(what) + " " + in_quotes(text) + " is out of range");
    }
    return static_cast<std::int64_t>(value);
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Scenario_error(m_file, message, m_line_number);
  }

  const std::string& file() const { return m_file; }
  std::size_t line_number() const { return m_line_number; }
  std::size_t bytes_left() const { return m_rest.size(); }

private:
  template <class Number>
  Number parsed(std::string_view text, std::string_view what, const char* wanted) const
  {
    Number value{};
    if (!is_parsed(text, what, value)) {
      fail(std::string(what) + " " + in_quotes(text) + " is not " + wanted);
    }
    return value;
  }

  template <class Number>
  bool is_parsed(std::string_view text, std::string_view what, Number& value) const
  {
    const std::string_view digits =
        text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size()) {
      return false;
    }
    if (error == std::errc::result_out_of_range) {
      fail(std::string(what) + " " + in_quotes(text) + " is out of range");
    }
    return error == std::errc();
  }

  std::string m_file;
  std::string_view m_rest;
  std::size_t m_line_number = 0;
};

// A coordinate of the point with this id.
inline double coordinate(const Text_scanner& scanner, std::string_view text, std::string_view name,
                         std::int64_t id)
{
  const double value = scanner.number(text, name);
  if (!std::isfinite(value)) {
    scanner.fail(std::string(name) + " of id " + std::to_string(id) + " is " + in_quotes(text) +
                 ", not a finite number");
  }
  return value;
}

} // namespace scenario

#endif // SCENARIO_TEXT_SCANNER_H
