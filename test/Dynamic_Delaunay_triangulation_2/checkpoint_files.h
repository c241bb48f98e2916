// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What tests of checkpoints do with files of any kind: read, edit and forge them, and run out of
// disk and memory. Only one file of a program may include this header: it replaces the heap.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CHECKPOINT_FILES_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CHECKPOINT_FILES_H

#include "replaced_heap.h"
#include "sealed_checkpoint.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <ios>
#include <new>
#include <random>
#include <sstream>
#include <streambuf>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

template <class Read>
void read(Read& target, const std::string& text)
{
  std::istringstream in(text);
  target.read_checkpoint(in);
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t place = text.find(what);
  EXPECT_NE(place, text.npos) << what;
  return resealed(text.replace(place, what.size(), by));
}

// The error with which the text is refused; an error of line 0 if it is accepted.
template <class Read>
CGAL::Checkpoint_error_2 refusal(Read& target, const std::string& text)
{
  try {
    read(target, text);
  } catch (const CGAL::Checkpoint_error_2& error) {
    return error;
  }
  return CGAL::Checkpoint_error_2(0, "accepted");
}

inline auto all_of(const CGAL::Update_report_2& r)
{
  return std::tie(r.classified, r.padded, r.border, r.flips, r.splices, r.spliced, r.enlargements,
                  r.relocated, r.inserted, r.removed, r.merged, r.parted, r.rebuild_reason,
                  r.certified);
}

inline std::string line_below(const std::string& text, const std::string& name)
{
  const std::size_t begin = text.find('\n', text.find('\n' + name + ' ') + 1) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

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

// The state of the stream after a failing read, which must leave the target unchanged.
template <class Read>
std::ios_base::iostate state_after_reading(Read& target, const std::string& text)
{
  const std::string before = checkpoint_of(target);
  std::istringstream in(text);
  in >> target;
  EXPECT_EQ(checkpoint_of(target), before);
  return in.rdstate();
}

template <class Read>
void expect_nothing_to_change_without_memory(Read& target, const std::string& text)
{
  const std::string before = checkpoint_of(target);
  bool is_read = false;
  for (long allocations = 0; !is_read; ++allocations) {
    std::istringstream in(text);
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      target.read_checkpoint(in);
      is_read = true;
    } catch (const std::bad_alloc&) {
    } catch (const CGAL::Checkpoint_error_2&) { // the stream has caught the std::bad_alloc
    }
    ASSERT_EQ(checkpoint_of(target), is_read ? text : before);
  }
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CHECKPOINT_FILES_H
