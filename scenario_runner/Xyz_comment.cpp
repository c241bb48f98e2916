// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Xyz_comment.h"

#include "scenario_runner/Frame_reading.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>

namespace scenario {

namespace {

constexpr std::string_view blanks = " \t\r";

// The keys that are read, as the format's specification and other programs spell them.
constexpr std::array<std::string_view, 6> keys = {"Lattice",    "pbc",  "Origin",
                                                  "Properties", "Time", "Frame"};

bool is_key(const std::string& word)
{
  return std::any_of(keys.begin(), keys.end(), [&word](std::string_view key) {
    return lower_case(std::string(key)) == lower_case(word);
  });
}

bool is_letter_or_digit(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// Whether any of the keys is followed by a =, be it the end of another word or before a stray
// character: a line that gives a key must not be taken for a remark.
bool gives_a_key(std::string_view line)
{
  const std::string text = lower_case(std::string(line));
  for (const std::string_view key : keys) {
    const std::string name = lower_case(std::string(key));
    for (auto place = text.find(name); place != text.npos; place = text.find(name, place + 1)) {
      const auto next =
          std::find_if(text.begin() + static_cast<std::ptrdiff_t>(place + name.size()), text.end(),
                       [](char c) { return c == '=' || is_letter_or_digit(c); });
      if (next != text.end() && *next == '=') {
        return true;
      }
    }
  }
  return false;
}

// A word without colons, quotes and other characters around it.
std::string bare(const std::string& word)
{
  const auto begin = std::find_if(word.begin(), word.end(), is_letter_or_digit);
  const auto end = std::find_if(word.rbegin(), word.rend(), is_letter_or_digit).base();
  return begin < end ? std::string(begin, end) : std::string();
}

// Whether a word looks like the beginning of a value, as numbers and arrays do.
bool begins_value(std::string_view word)
{
  return is_one_of(word.front(), "0123456789+-.\"'[{=") || word == "T" || word == "F" ||
         word.find(':') != word.npos;
}

} // namespace

// Takes a line apart.
class Xyz_comment::Reader
{
public:
  Reader(Xyz_comment& comment, std::string_view line)
    : m_comment(comment)
    , m_rest(line)
  {
  }

  void read_pairs()
  {
    skip(blanks);
    bool is_separate = true; // from what was taken before
    while (!m_rest.empty()) {
      const std::string name = key();
      const bool has_blank = skip(blanks);
      if (!m_rest.empty() && m_rest.front() == '=') {
        m_rest.remove_prefix(1);
        skip(blanks);
        keep(name, value(name));
        is_separate = skip(blanks);
      } else if (!is_separate) {
        fail("the value before " + in_quotes(name) + " goes on after its end");
      } else if (is_key(bare(name))) {
        fail_without_value(bare(name));
      } else {
        is_separate = has_blank;
      }
    }
  }

  // Where a line has no pair that is read: the keys that a person may have meant to give.
  void check_remark()
  {
    std::vector<std::string_view> words;
    split_at_blanks(m_rest, words);
    for (std::size_t i = 0; i != words.size(); ++i) {
      const std::string word = bare(std::string(words[i]));
      const std::string name = lower_case(word);
      if (name != "lattice" && name != "pbc" && name != "properties") {
        continue;
      }
      if (std::find(keys.begin(), keys.end(), word) != keys.end() ||
          (i + 1 != words.size() && begins_value(words[i + 1]))) {
        fail_without_value(word);
      }
    }
  }

private:
  bool skip(std::string_view characters)
  {
    const std::size_t end = (std::min)(m_rest.find_first_not_of(characters), m_rest.size());
    m_rest.remove_prefix(end);
    return end != 0;
  }

  std::string key()
  {
    if (m_rest.front() == '=') {
      fail("a = has no key before it");
    }
    return m_rest.front() == '"' ? enclosed('"') : bare_word("a key");
  }

  Value value(const std::string& name)
  {
    if (m_rest.empty()) {
      fail_without_value(name);
    }
    switch (m_rest.front()) {
    case '"':
    case '\'':
      return {enclosed(m_rest.front()), false};
    case '{':
      return {enclosed('}'), false};
    case '[':
      return {array(), true};
    default:
      return {bare_value(name), false};
    }
  }

  // Commas and semicolons may stand between pairs, as in i = 0, time = 0.5.
  std::string bare_value(const std::string& name)
  {
    std::string text = bare_word("the value of " + in_quotes(name));
    if (!m_rest.empty() && m_rest.front() == '=') {
      fail("the value of " + in_quotes(name) + " has a = in it, and is not in quotes");
    }
    if (!text.empty() && is_one_of(text.back(), ",;")) {
      text.pop_back();
    }
    return text;
  }

  // Takes a word up to a blank or a =, unless a backslash stands before it.
  std::string bare_word(const std::string& what)
  {
    std::string text;
    while (!m_rest.empty() && !is_blank(m_rest.front()) && m_rest.front() != '=') {
      if (is_one_of(m_rest.front(), "\"{}[]")) {
        fail(what + " has a " + std::string(1, m_rest.front()) + " in it, and is not in quotes");
      }
      text += taken();
    }
    return text;
  }

  // Takes a character, or the one after a backslash.
  char taken()
  {
    const bool is_escaped = m_rest.size() > 1 && m_rest.front() == '\\';
    const char c = m_rest[is_escaped ? 1 : 0];
    m_rest.remove_prefix(is_escaped ? 2 : 1);
    return is_escaped && c == 'n' ? '\n' : c;
  }

  // Takes a text and what encloses it.
  std::string enclosed(char end)
  {
    const char begin = m_rest.front();
    m_rest.remove_prefix(1);
    std::string text;
    while (!m_rest.empty() && m_rest.front() != end) {
      text += taken();
    }
    if (m_rest.empty()) {
      fail_without_end(begin);
    }
    m_rest.remove_prefix(1);
    return text;
  }

  // Takes an array, of which the text between the outer brackets is left. Arrays may have rows, and
  // brackets in quotes.
  std::string array()
  {
    std::size_t depth = 0;
    std::string text;
    do {
      if (m_rest.empty()) {
        fail_without_end('[');
      }
      const char c = m_rest.front();
      depth += c == '[' ? 1 : 0;
      depth -= c == ']' ? 1 : 0;
      if (depth > 2) {
        fail("an array has more than two dimensions");
      }
      if (c == '"') {
        text += '"' + enclosed('"') + '"';
      } else {
        text += c;
        m_rest.remove_prefix(1);
      }
    } while (depth != 0);
    return text.substr(1, text.size() - 2);
  }

  // A key that is not read may be there as often as it likes.
  void keep(const std::string& name, Value value)
  {
    if (!is_key(name)) {
      if (is_key(bare(name))) {
        fail(in_quotes(name) + " is not a key, expected " + in_quotes(bare(name)));
      }
    } else if (!m_comment.m_values.emplace(lower_case(name), std::move(value)).second) {
      fail(in_quotes(name) + " is there twice");
    }
  }

  [[noreturn]] void fail_without_value(const std::string& name) const
  {
    fail(in_quotes(name) + " has no value: expected " + in_quotes(name + "=...") +
         ", or, in a remark, another word");
  }

  [[noreturn]] void fail_without_end(char begin) const
  {
    fail("a value begins with " + std::string(1, begin) + " and has no end");
  }

  [[noreturn]] void fail(const std::string& message) const { m_comment.m_scanner.fail(message); }

  Xyz_comment& m_comment;
  std::string_view m_rest;
};

Xyz_comment::Xyz_comment(const Text_scanner& scanner, std::string_view line)
  : m_scanner(scanner)
{
  Reader reader(*this, line);
  if (gives_a_key(line)) {
    reader.read_pairs();
  } else {
    reader.check_remark();
  }
}

double Xyz_comment::number(const std::string& key) const
{
  return numbers(key, 1)[0];
}

std::int64_t Xyz_comment::integer(const std::string& key) const
{
  const Words word = row(key);
  const auto number =
      word.size() == 1 ? m_scanner.whole_number(word[0], key) : std::optional<std::int64_t>();
  if (!number) {
    m_scanner.fail(key + " " + in_quotes(text(key)) + " is not an integer");
  }
  return *number;
}

std::vector<double> Xyz_comment::numbers(const std::string& key, std::size_t size) const
{
  const Words words = row(key);
  if (words.size() != size) {
    m_scanner.fail(key + " has " + std::to_string(words.size()) + " numbers instead of " +
                   std::to_string(size));
  }
  return as_numbers(key, words);
}

std::vector<double> Xyz_comment::matrix(const std::string& key) const
{
  const std::vector<Words> all = rows(key);
  if (all.size() == 1) {
    return numbers(key, 9);
  }
  Words words;
  for (const Words& row : all) {
    if (all.size() != 3 || row.size() != 3) {
      m_scanner.fail(key + " has " + std::to_string(all.size()) +
                     " rows, expected three of three numbers each");
    }
    words.insert(words.end(), row.begin(), row.end());
  }
  return as_numbers(key, words);
}

std::vector<bool> Xyz_comment::truths(const std::string& key, std::size_t size) const
{
  const Words words = row(key);
  if (words.size() != size) {
    m_scanner.fail(key + " is " + in_quotes(text(key)) + ", expected three of T and F");
  }
  std::vector<bool> truths;
  for (const std::string& word : words) {
    truths.push_back(truth(key, word));
  }
  return truths;
}

bool Xyz_comment::truth(const std::string& key, const std::string& word) const
{
  const std::string name = lower_case(word);
  if (name == "t" || name == "true" || name == "1") {
    return true;
  }
  if (name == "f" || name == "false" || name == "0") {
    return false;
  }
  m_scanner.fail(key + " has " + in_quotes(word) + ", expected T or F");
}

// The rows of an array; one row of anything else.
std::vector<Xyz_comment::Words> Xyz_comment::rows(const std::string& key) const
{
  const Value& value = m_values.at(key);
  std::string_view rest = trimmed(value.text);
  if (!value.is_array || rest.empty() || rest.front() != '[') {
    return {words(key, rest)};
  }
  std::vector<Words> rows;
  while (true) {
    const std::size_t end = rest.find(']');
    if (rest.empty() || rest.front() != '[' || end == rest.npos) {
      m_scanner.fail(key + " is " + in_quotes(value.text) + ", expected rows as [1, 2], [3, 4]");
    }
    rows.push_back(words(key, rest.substr(1, end - 1)));
    rest = trimmed(rest.substr(end + 1));
    if (rest.empty()) {
      return rows;
    }
    rest = rest.front() == ',' ? trimmed(rest.substr(1)) : rest.substr(0, 0);
  }
}

Xyz_comment::Words Xyz_comment::row(const std::string& key) const
{
  const std::vector<Words> all = rows(key);
  if (all.size() != 1) {
    m_scanner.fail(key + " has " + std::to_string(all.size()) + " rows, expected one");
  }
  return all[0];
}

// Words between blanks, or between commas, of which no two follow each other.
Xyz_comment::Words Xyz_comment::words(const std::string& key, std::string_view text) const
{
  Words words;
  std::vector<std::string_view> parts;
  std::vector<std::string_view> fields;
  split_at(',', text, parts);
  for (const std::string_view part : parts) {
    split_at_blanks(part, fields);
    if (fields.empty()) {
      m_scanner.fail(key + " is " + in_quotes(text) + ", where a value is missing");
    }
    words.insert(words.end(), fields.begin(), fields.end());
  }
  return words;
}

std::vector<double> Xyz_comment::as_numbers(const std::string& key, const Words& words) const
{
  std::vector<double> numbers;
  for (const std::string& word : words) {
    numbers.push_back(finite_number(m_scanner, with_usual_exponent(word), key));
  }
  return numbers;
}

bool may_be_of_fortran(std::string_view number)
{
  const std::size_t place = number.find_first_of("dD");
  return place != number.npos && place != 0 && is_one_of(number[place - 1], "0123456789.");
}

std::string with_usual_exponent(std::string_view number)
{
  std::string text(number);
  if (may_be_of_fortran(number)) {
    text[text.find_first_of("dD")] = 'e';
  }
  return text;
}

} // namespace scenario
