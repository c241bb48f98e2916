// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_TWINS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_TWINS_H

#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

// Two triangulations in space that have to be the same after every change, though only one may
// leave out cells that are safe.
namespace space_twins {

namespace internal = CGAL::Dynamic_Delaunay_triangulations_3::internal;

using space_points::Points;

// What is kept, beside a copy that has to test every cell in each frame.
template <class Dynamic>
class Twins
{
public:
  explicit Twins(const Dynamic& dt)
    : m_kept(dt)
    , m_other(dt)
  {
  }

  const Dynamic& kept() const { return m_kept; }
  bool leaves_out() const { return safe_cells(m_kept).is_on(); }
  std::size_t frames_left_out() const { return m_left_out; }

  // Calls f for both, and compares what they report and have then.
  template <class Function>
  void change(const Function& f)
  {
    forget(m_other);
    const CGAL::Update_report_3 report = f(m_kept), expected = f(m_other);
    ASSERT_EQ(report.unproved, expected.unproved);
    ASSERT_EQ(report.flips, expected.flips);
    ASSERT_EQ(report.held, expected.held);
    ASSERT_EQ(report.relocated, expected.relocated);
    ASSERT_EQ(report.rebuilt(), expected.rebuilt());
    ASSERT_TRUE(m_kept.is_valid(true));
    ASSERT_TRUE(cells(m_kept) == cells(m_other));
    m_left_out += leaves_out();
  }

  // How many infinite cells will not be tested in a frame in which nothing moves.
  std::size_t safe_infinite_cells() const
  {
    const auto& arrays = state(m_kept).arrays;
    if (!arrays.safe_cells().is_on())
      return 0;
    std::vector<CGAL::Dynamic_Delaunay_triangulations_3::Cell_index> doubtful;
    arrays.safe_cells().list_doubtful(0, arrays.number_of_cells(), doubtful);
    std::size_t infinite = 0;
    for (CGAL::Dynamic_Delaunay_triangulations_3::Cell_index c(0); c < arrays.number_of_cells();
         ++c)
      infinite += arrays.is_infinite(c);
    for (const auto c : doubtful)
      infinite -= arrays.is_infinite(c);
    return infinite;
  }

private:
  using Safe_cells = internal::Safe_cells_3;

  static const auto& state(const Dynamic& dt) { return internal::Triangulation_access::state(dt); }
  static const Safe_cells& safe_cells(const Dynamic& dt) { return state(dt).arrays.safe_cells(); }
  static void forget(Dynamic& dt) { const_cast<Safe_cells&>(safe_cells(dt)).stop(); }

  // Infinite ones, too.
  static auto cells(const Dynamic& dt)
  {
    const auto& arrays = state(dt).arrays;
    std::vector<std::decay_t<decltype(arrays.sites({}))>> cells;
    for (CGAL::Dynamic_Delaunay_triangulations_3::Cell_index c(0); c < arrays.number_of_cells();
         ++c)
      cells.push_back(arrays.sites(c));
    return cells;
  }

  Dynamic m_kept, m_other;
  std::size_t m_left_out = 0;
};

template <class Dynamic>
void follow(Twins<Dynamic>& twins, const Points& points)
{
  twins.change([&](Dynamic& dt) { return dt.update(points); });
}

// Follows frames, each of which moves the points. Most of them have to be calm.
template <class Dynamic>
void follow(Twins<Dynamic> twins, Points points, int frames, std::size_t calm,
            const std::function<void(Points&, int)>& move)
{
  for (int frame = 0; frame < frames; ++frame) {
    move(points, frame);
    ASSERT_NO_FATAL_FAILURE(follow(twins, points)) << "frame " << frame;
  }
  EXPECT_GE(twins.frames_left_out(), calm);
}

} // namespace space_twins

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_TWINS_H
