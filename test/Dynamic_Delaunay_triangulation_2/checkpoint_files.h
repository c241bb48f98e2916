// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What tests of checkpoints do with files of any kind: read, edit and forge them, and run out of
// disk and memory. Only one file of a program may include this header: it replaces the heap.
// `Checkpoint_files` tests what holds in every space.

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

// Forges the file of a triangulation. What is not refused goes on as a copy of it does:
// `expect_common_future(dt, copy, i)` says so of the i-th one.
template <class Dynamic, class Expect>
void expect_forgeries_to_be_harmless(const std::string& original, const Dynamic& empty,
                                     unsigned seed, int number, const Expect& expect_common_future)
{
  Forger forger(original, seed);
  int accepted = 0;
  for (int i = 0; i < number; ++i) {
    const std::string text = forger.forged();
    Dynamic dt = empty;
    if (refusal(dt, text).line() > 0) {
      ASSERT_EQ(dt.number_of_points(), 0u);
      continue;
    }
    ++accepted;
    Dynamic other = empty;
    read(other, checkpoint_of(dt));
    ASSERT_EQ(checkpoint_of(dt), checkpoint_of(other));
    ASSERT_NO_FATAL_FAILURE(expect_common_future(dt, other, i)) << text;
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, number);
}

// A space has an `empty()` triangulation, a small `specimen()` whose checkpoint has everything that
// a file can have, and an `other_one()`.
template <class Space>
class Checkpoint_files : public testing::Test
{
protected:
  static std::string text() { return checkpoint_of(Space::specimen()); }

  // Where a file is refused by a triangulation, which it leaves empty; 0 if it is not. One
  // triangulation refuses all files of a test.
  std::size_t line_of_refusal(const std::string& text)
  {
    const std::size_t line = refusal(m_dt, text).line();
    EXPECT_EQ(m_dt.number_of_points(), 0u);
    return line;
  }

private:
  decltype(Space::empty()) m_dt = Space::empty();
};
TYPED_TEST_SUITE_P(Checkpoint_files);

TYPED_TEST_P(Checkpoint_files, that_are_cut_off_anywhere_are_refused)
{
  const std::string text = this->text();
  for (std::size_t size = 0; size < text.size(); ++size)
    ASSERT_GT(this->line_of_refusal(text.substr(0, size)), 0u) << size;
}

TYPED_TEST_P(Checkpoint_files, with_any_byte_changed_or_missing_are_refused)
{
  const std::string text = this->text();
  for (std::size_t place = 0; place < text.size(); ++place) {
    for (const char c : {'0', '1', '7', ' ', '\n', '-', '.', 'e', 'x', '\0', '\xff'}) {
      std::string edited = text;
      edited[place] = c;
      if (edited != text) {
        ASSERT_GT(this->line_of_refusal(edited), 0u) << place << " " << int(c);
      }
    }
    std::string shorter = text;
    shorter.erase(place, 1);
    ASSERT_GT(this->line_of_refusal(shorter), 0u) << place;
  }
}

TYPED_TEST_P(Checkpoint_files, that_announce_much_need_no_memory)
{
  const std::string text = this->text();
  for (const char* announced : {"700000000", "4000000000", "1000000000000000000",
                                "99999999999999999999999999", "-1", "715827882"})
    for (const char* name :
         {"ids", "vertices", "duplicates", "free_ids", "faces", "corners", "edges"}) {
      const std::size_t place = text.find(std::string(1, '\n') + name + ' ') + 1;
      std::string edited = text;
      edited.replace(place, text.find('\n', place) - place, std::string(name) + ' ' + announced);
      edited = resealed(edited);
      replaced_heap::largest_allocation = 0;
      ASSERT_GT(this->line_of_refusal(edited), 0u) << name << " " << announced;
      EXPECT_LT(replaced_heap::largest_allocation, 100000u) << name << " " << announced;
    }
}

TYPED_TEST_P(Checkpoint_files, change_nothing_if_they_are_refused)
{
  const std::string text = this->text();
  auto dt = TypeParam::other_one();
  for (std::size_t size = 0; size < text.size(); size += 7)
    ASSERT_TRUE(state_after_reading(dt, text.substr(0, size)) & std::ios::failbit) << size;
  EXPECT_EQ(state_after_reading(dt, "garbage\n" + text), std::ios::failbit);
}

TYPED_TEST_P(Checkpoint_files, change_nothing_if_memory_runs_out)
{
  auto dt = TypeParam::other_one();
  expect_nothing_to_change_without_memory(dt, this->text());
  EXPECT_TRUE(dt.is_valid());
}

TYPED_TEST_P(Checkpoint_files, say_where_a_disk_is_full)
{
  const auto dt = TypeParam::specimen();
  const std::size_t size = checkpoint_of(dt).size();
  for (std::size_t bytes = 0; bytes <= size; ++bytes) {
    Full_disk disk(bytes), other_disk(bytes);
    std::ostream out(&disk), other_out(&other_disk);
    if (bytes < size) {
      ASSERT_THROW(dt.write_checkpoint(out), CGAL::Checkpoint_error_2) << bytes;
    } else {
      EXPECT_NO_THROW(dt.write_checkpoint(out));
    }
    other_out << dt;
    ASSERT_EQ(other_out.fail(), bytes < size) << bytes;
  }
}

REGISTER_TYPED_TEST_SUITE_P(Checkpoint_files, that_are_cut_off_anywhere_are_refused,
                            with_any_byte_changed_or_missing_are_refused,
                            that_announce_much_need_no_memory, change_nothing_if_they_are_refused,
                            change_nothing_if_memory_runs_out, say_where_a_disk_is_full);

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CHECKPOINT_FILES_H
