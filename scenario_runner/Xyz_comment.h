// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_XYZ_COMMENT_H
#define SCENARIO_RUNNER_XYZ_COMMENT_H

#include "scenario_runner/Text_input.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

// The second line of a frame in an XYZ file. In the extended format it has pairs key=value, where
// blanks may stand around the =. A value is a word, a text in quotes, or an array: [1, 2, 3],
// [[1, 2], [3, 4]], {1 2 3} or "1 2 3". Words alone are remarks, and so is the whole line if it has
// none of the keys that are read, which may be in upper or lower case.
//
// No such key is overlooked: a line that has one has to be right as a whole, and a key without a
// value is an error. All functions throw Scenario_error, with the scanner's line.
class Xyz_comment
{
public:
  Xyz_comment(const Text_scanner& scanner, std::string_view line);

  bool has(const std::string& key) const { return m_values.count(key) != 0; }

  // Of keys that are there, in lower case.
  const std::string& text(const std::string& key) const { return m_values.at(key).text; }
  double number(const std::string& key) const;
  std::int64_t integer(const std::string& key) const;
  std::vector<double> numbers(const std::string& key, std::size_t size) const;
  std::vector<double> matrix(const std::string& key) const; // three rows of three numbers
  std::vector<bool> truths(const std::string& key, std::size_t size) const;

private:
  // A value without what encloses it.
  struct Value
  {
    std::string text;
    bool is_array; // in brackets
  };
  using Words = std::vector<std::string>;

  class Reader;

  std::vector<Words> rows(const std::string& key) const;
  Words row(const std::string& key) const;
  Words words(const std::string& key, std::string_view text) const;
  std::vector<double> as_numbers(const std::string& key, const Words& words) const;
  bool truth(const std::string& key, const std::string& word) const;

  const Text_scanner& m_scanner;
  std::map<std::string, Value> m_values;
};

// Numbers whose exponent begins with a D, as Fortran writes them.
bool may_be_of_fortran(std::string_view number);
std::string with_usual_exponent(std::string_view number);

} // namespace scenario

#endif // SCENARIO_RUNNER_XYZ_COMMENT_H
