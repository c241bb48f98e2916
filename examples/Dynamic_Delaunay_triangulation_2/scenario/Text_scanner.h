// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_TEXT_SCANNER_H
#define SCENARIO_TEXT_SCANNER_H

#include "Scenario_error.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace scenario {

inline std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

// For messages, which a long line of foreign data must not drown.
inline std::string in_quotes(std::string_view text)
{
  constexpr std::size_t longest = 40;
  return "'" + std::string(text.substr(0, longest)) + (text.size() > longest ? "...'" : "'");
}

inline void split_at_commas(std::string_view line, std::vector<std::string_view>& fields)
{
  fields.clear();
  std::size_t comma = 0;
  while ((comma = line.find(',')) != std::string_view::npos) {
    fields.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  fields.push_back(trimmed(line));
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
  }

  // The next line that is not blank, or false at the end.
  bool next_line(std::string_view& line)
  {
    while (!m_rest.empty()) {
      ++m_line_number;
      const std::size_t end = m_rest.find('\n');
      line = trimmed(m_rest.substr(0, end));
      m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
      if (!line.empty()) {
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
    const std::string_view digits =
        text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
    Number value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range) {
      fail(std::string(what) + " " + in_quotes(text) + " is out of range");
    }
    if (error != std::errc() || end != digits.data() + digits.size()) {
      fail(std::string(what) + " " + in_quotes(text) + " is not " + wanted);
    }
    return value;
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
