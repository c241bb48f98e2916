// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can happen to a checkpoint: somebody edits it, or the disk is full.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FORGED_CHECKPOINT_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FORGED_CHECKPOINT_H

#include "sealed_checkpoint.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <sstream>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

// Random edits of words and lines, each with the right checksum.
class Forger
{
public:
  Forger(const std::string& text, unsigned seed)
    : m_random(seed)
  {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      m_lines.push_back(line);
  }

  std::string forged()
  {
    std::vector<std::string> lines = m_lines;
    for (std::size_t edits = 1 + below(3); edits > 0; --edits)
      edit(lines);
    std::string text;
    for (const std::string& line : lines)
      text += line + '\n';
    return resealed(text);
  }

private:
  void edit(std::vector<std::string>& lines)
  {
    const std::size_t i = 1 + below(lines.size() - 2), j = 1 + below(lines.size() - 2);
    switch (below(8)) {
    case 0:
      return std::swap(lines[i], lines[j]);
    case 1:
      lines[i] = lines[j];
      return;
    case 2:
      return std::reverse(lines[i].begin(), lines[i].end());
    case 3:
      lines.erase(lines.begin() + std::ptrdiff_t(i));
      return;
    default:
      return edit_digit(lines[i]);
    }
  }

  void edit_digit(std::string& line)
  {
    const std::size_t place = line.find_first_of("0123456789", below(line.size() + 1));
    if (place != line.npos)
      line[place] = char('0' + below(10));
  }

  std::size_t below(std::size_t end) { return m_random() % end; }

  std::mt19937 m_random;
  std::vector<std::string> m_lines;
};

// A disk that is full after the given number of bytes.
class Full_disk : public std::streambuf
{
public:
  explicit Full_disk(std::size_t bytes)
    : m_left(bytes)
  {
  }

private:
  int_type overflow(int_type c) override
  {
    return m_left-- > 0 ? traits_type::not_eof(c) : (m_left = 0, traits_type::eof());
  }

  std::size_t m_left;
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FORGED_CHECKPOINT_H
