// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the tables in the folder `cases`: each line is what is given, and the line below it, after
// two blanks, what is expected, as the message that refuses it.
//
//     # a remark
//     = TEXT          the text that the changes below change
//     WHAT => BY      the text with BY in place of WHAT
//     .. {a|b} ..     two cases, one for each word; {} stands for the word in what is expected
//     < NAME TEXT     a file of this name
//
// \n, \t, \r, \\ and \x0A are characters, a backslash at the end of a line is nothing, and [...]
// in a message stands for any text.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CASE_TABLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CASE_TABLE_H

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

struct Case
{
  std::string given;
  std::string expected;
};

struct Case_table
{
  std::vector<Case> cases;
  std::map<std::string, std::string> files; // texts by names
};

inline std::string unescaped(const std::string& line)
{
  static const std::string letters = "ntr\\", characters = "\n\t\r\\";
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t letter = line[i] == '\\' ? letters.find(line[i + 1]) : letters.npos;
    if (line[i] != '\\') {
      text += line[i];
    } else if (letter != letters.npos) {
      text += characters[letter];
      ++i;
    } else if (line[i + 1] == 'x') {
      text += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
      i += 3;
    }
  }
  return text;
}

inline std::string with_replaced_part(std::string text, const std::string& what,
                                      const std::string& by)
{
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what << " is not in " << text;
  return place == std::string::npos ? text : text.replace(place, what.size(), by);
}

// One for each of the words in braces, or the case itself.
inline std::vector<Case> alternatives(const Case& one)
{
  static const std::regex braces("\\{([^{}]*\\|[^{}]*)\\}"), bar("\\|");
  std::smatch found;
  if (!std::regex_search(one.given, found, braces)) {
    return {one};
  }
  std::vector<Case> all;
  const std::string words = found[1].str() + "|";
  for (std::sregex_token_iterator word(words.begin(), words.end(), bar, -1), end; word != end;
       ++word) {
    all.push_back({found.prefix().str() + word->str() + found.suffix().str(),
                   std::regex_replace(one.expected, std::regex("\\{\\}"), word->str())});
  }
  return all;
}

inline Case_table read_cases(const std::string& name)
{
  std::ifstream in(CASES_FOLDER "/" + name + ".txt");
  EXPECT_TRUE(in.is_open()) << name;
  Case_table table;
  const std::string arrow = " => ";
  std::string given, expected, base;
  while (std::getline(in, given)) {
    if (given.empty() || given[0] == '#') {
      continue;
    }
    if (given[0] == '=') {
      base = unescaped(given.substr(2));
    } else if (given[0] == '<') {
      const std::size_t blank = given.find(' ', 2);
      table.files[given.substr(2, blank - 2)] = unescaped(given.substr(blank + 1));
    } else if (std::getline(in, expected)) {
      EXPECT_EQ(expected.rfind("  ", 0), 0u) << given;
      for (const Case& one : alternatives({given, expected.substr(2)})) {
        const std::size_t place = one.given.find(arrow);
        const std::string text = unescaped(one.given.substr(0, place));
        table.cases.push_back(
            {place == std::string::npos
                 ? text
                 : with_replaced_part(base, text,
                                      unescaped(one.given.substr(place + arrow.size()))),
             one.expected});
      }
    }
  }
  EXPECT_FALSE(table.cases.empty()) << name;
  return table;
}

// Whether the text is the message, in which [...] stands for any text.
inline bool says(const std::string& text, const std::string& message)
{
  static const std::string any = "[...]";
  const std::size_t begin = message.find(any);
  if (begin == std::string::npos) {
    return text == message;
  }
  if (text.compare(0, begin, message, 0, begin) != 0) {
    return false;
  }
  const std::string rest = message.substr(begin + any.size());
  for (std::size_t place = begin; place <= text.size(); ++place) {
    if (says(text.substr(place), rest)) {
      return true;
    }
  }
  return false;
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CASE_TABLE_H
