// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_TEXT_INPUT_H
#define SCENARIO_RUNNER_TEXT_INPUT_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

// What is wrong with a scenario or a recording, and where. Lines and columns count from 1; 0 stands
// for "not known".
class Scenario_error : public std::runtime_error
{
public:
  Scenario_error(const std::string& file, const std::string& message, std::size_t line = 0,
                 std::size_t column = 0);

  const std::string& file() const { return m_file; }
  std::size_t line() const { return m_line; }
  std::size_t column() const { return m_column; }

private:
  std::string m_file;
  std::size_t m_line;
  std::size_t m_column;
};

// positive_up_to() leaves its lower bound 0 out.
struct Range
{
  double low;
  double high;
  bool low_is_allowed = true;

  bool contains(double value) const
  {
    return (low_is_allowed ? value >= low : value > low) && value <= high;
  }
  std::string text() const;
};

inline Range positive_up_to(double high)
{
  return {0.0, high, false};
}

// A file as a whole; what is compressed by gzip, whatever its name, is unzipped.
std::string read_text_file(const std::string& path);
std::string read_standard_input(const std::string& name);

// The text behind its byte-order mark, if it has one.
// \throws Scenario_error, in which the text is called `file`, if the mark is that of UTF-16
std::string_view without_byte_order_mark(const std::string& file, std::string_view text);

std::string joined(const std::vector<std::string>& words);
std::string lower_case(std::string text);
bool is_blank(char c);
bool is_one_of(char c, std::string_view characters);
std::string_view trimmed(std::string_view text);
void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields);
void split_at(char separator, std::string_view line, std::vector<std::string_view>& fields);

// For messages, which a long line of foreign data must not drown.
std::string in_quotes(std::string_view text);

// Whether a text is a number as a whole. Strict, unlike strtoull(), to which "-1" is a large number
// and "010" is 8.
bool is_number(std::string_view text, double& value);
bool is_number(std::string_view text, std::uint64_t& value);

// Walks over the lines of a text that outlives it, and reads numbers with the current line as the
// place of every error.
class Text_scanner
{
public:
  Text_scanner(std::string file, std::string_view text);

  // The next line that is not blank, without blanks around it, or false at the end.
  bool next_line(std::string_view& line);

  // Also skips blank lines, but leaves the blanks around it: a tab may separate fields.
  bool next_whole_line(std::string_view& line);

  // The next line, also if it is blank.
  bool next_line_as_it_is(std::string_view& line);

  double number(std::string_view text, std::string_view what) const;
  std::int64_t integer(std::string_view text, std::string_view what) const;

  // An integer that may be written as 3.0 or 3e2, as programs do that know floating point alone.
  // Nothing if the text is no number at all.
  std::optional<std::int64_t> whole_number(std::string_view text, std::string_view what) const;

  // A coordinate of the point with this id.
  double coordinate(std::string_view text, std::string_view name, const std::string& id) const;

  [[noreturn]] void fail(const std::string& message) const;

  const std::string& file() const { return m_file; }
  std::size_t line_number() const { return m_line_number; }
  std::size_t bytes_left() const { return m_rest.size(); }

private:
  template <class Number>
  bool is_parsed(std::string_view text, std::string_view what, Number& value) const;

  template <class Number>
  Number parsed(std::string_view text, std::string_view what, const char* wanted) const;

  std::string m_file;
  std::string_view m_rest;
  std::size_t m_line_number = 0;
};

} // namespace scenario

#endif // SCENARIO_RUNNER_TEXT_INPUT_H
