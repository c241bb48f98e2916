// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Csv_header.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

namespace {

[[noreturn]] void fail(const std::string& text, const std::string& why)
{
  throw std::invalid_argument(
      in_quotes(text) + " " + why +
      ", allowed are frame, time, id, x, y and z, and a dash for any other, in "
      "the order of the columns, or with their titles, as frame=t,id=label");
}

bool is_column(const std::string& word)
{
  return std::find(csv_column_names.begin(), csv_column_names.end(), word) !=
         csv_column_names.end();
}

// Whether a text names columns; each at most once.
void check_words(const std::string& text, std::vector<std::string> words)
{
  for (const std::string& word : words) {
    if (!is_column(word) && word != "-") {
      fail(text, "has the word " + in_quotes(word));
    }
  }
  words.erase(std::remove(words.begin(), words.end(), "-"), words.end());
  std::sort(words.begin(), words.end());
  const auto twice = std::adjacent_find(words.begin(), words.end());
  if (twice != words.end()) {
    fail(text, "names " + *twice + " twice");
  }
}

void check_order(const std::string& text, const std::vector<std::string>& words)
{
  const auto has = [&words](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  if (!has("id") || !has("x") || !has("y") || !(has("frame") || has("time"))) {
    fail(text, "does not name id, x, y, and frame or time");
  }
}

} // namespace

Table_columns table_columns(const std::string& text)
{
  Table_columns columns;
  std::vector<std::string> words;
  std::vector<std::string_view> items;
  split_at(',', text, items);
  for (const std::string_view item : items) {
    const std::size_t sign = item.find('=');
    words.push_back(lower_case(std::string(trimmed(item.substr(0, sign)))));
    if (sign == item.npos) {
      columns.in_order.push_back(words.back());
      continue;
    }
    columns.by_title.emplace_back(words.back(), trimmed(item.substr(sign + 1)));
    if (columns.by_title.back().second.empty() || words.back() == "-") {
      fail(text, "gives no title for " + in_quotes(words.back()));
    }
  }
  check_words(text, words);
  if (!columns.in_order.empty()) {
    if (!columns.by_title.empty()) {
      fail(text, "has columns with and without titles");
    }
    check_order(text, words);
  }
  return columns;
}

} // namespace scenario
