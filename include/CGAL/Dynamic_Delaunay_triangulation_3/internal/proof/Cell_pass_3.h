// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CELL_PASS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CELL_PASS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Cell_slack_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The cells that a pass of the filter has not proved.
struct Unproved_cells_3
{
  void clear()
  {
    finite.clear();
    infinite.clear();
  }
  void append(const Unproved_cells_3& others)
  {
    finite.insert(finite.end(), others.finite.begin(), others.finite.end());
    infinite.insert(infinite.end(), others.infinite.begin(), others.infinite.end());
  }

  std::vector<Cell_index> finite;   // not proved positive, or one of their facets not legal
  std::vector<Cell_index> infinite; // all of them, but for safe ones
};

using Dynamic_Delaunay_triangulations_2::internal::prefetch;

// What a pass learns of cells beyond its answers: nothing,
struct Nothing_learned_3
{
  template <int lanes, class Filter, class Points>
  BOOST_FORCEINLINE void learn(const Few<Cell_index, lanes>&, unsigned, const Filter&,
                               const Points&, const Points&, const Points&,
                               const Few<Points, 4>&) const
  {
  }
};

// or slacks, for which f(cell, slack) is called: 0 for cells that it does not prove.
template <class Function>
class Slacks_learned_3
{
public:
  Slacks_learned_3(double error, const Function& f)
    : m_error(error)
    , m_f(f)
  {
  }

  template <int lanes, class Filter, class Points>
  BOOST_FORCEINLINE void learn(const Few<Cell_index, lanes>& some, unsigned unproved,
                               const Filter& filter, const Points& b, const Points& c,
                               const Points& d, const Few<Points, 4>& beyond) const
  {
    Cell_slack_in_lanes_3<Lanes<lanes>> slack(b, c, d, filter, Lanes<lanes>(m_error));
    for (const Points& e : beyond)
      slack.restrict_by(e);
    double slacks[lanes];
    const Lanes<lanes> all = slack.slack();
    std::memcpy(slacks, &all, sizeof(slacks));
    for (int i = 0; i < lanes; ++i)
      m_f(some[i], unproved >> i & 1 ? 0 : slacks[i]);
  }

private:
  double m_error;
  const Function& m_f;
};

// Appends those of some cells that a filter does not prove. `corners(place)` are vertices of the
// cells, `beyond(place)` those beyond their facets, and `of_filter` is what else the filter needs.
template <class Filter, int lanes, class Corners, class Beyond, class Learned, class... Of_filter>
BOOST_FORCEINLINE void test_in_lanes(const Few<Cell_index, lanes>& some, const Corners& corners,
                                     const Beyond& beyond, const Learned& learned,
                                     std::vector<Cell_index>& unproved,
                                     const Of_filter&... of_filter)
{
  const auto a = corners(0), b = corners(1) - a, c = corners(2) - a, d = corners(3) - a;
  const Few<std::decay_t<decltype(b)>, 4> e{
      {beyond(0) - a, beyond(1) - a, beyond(2) - a, beyond(3) - a}};
  const Filter filter(b, c, d, of_filter...);
  const auto are_unproved = filter.may_be_inverted() | filter.may_be_inside(e[0]) |
                            filter.may_be_inside(e[1]) | filter.may_be_inside(e[2]) |
                            filter.may_be_inside(e[3]);
  const unsigned answers = Dynamic_Delaunay_triangulations_2::internal::bits(are_unproved);
  learned.learn(some, answers, filter.of_cell(), b, c, d, e);
  for (int i = 0; answers != 0 && i < lanes; ++i)
    if (answers >> i & 1)
      unproved.push_back(some[i]);
}

template <int lanes, class Learned>
BOOST_FORCEINLINE void append_unproved(const Tetrahedra_arrays_3::Cell* all,
                                       const Position_3* positions,
                                       const Few<Cell_index, lanes>& some, const Learned& learned,
                                       std::vector<Cell_index>& unproved)
{
  const auto corners = [&](int place) CGAL_DYNAMIC_DELAUNAY_INLINE {
    return points_in_lanes<lanes>([&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Position_3& {
      return positions[all[some[i]].vertices[place]];
    });
  };
  const auto beyond = [&](int place) CGAL_DYNAMIC_DELAUNAY_INLINE {
    return points_in_lanes<lanes>([&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Position_3& {
      const Index k = all[some[i]].mirrors[place];
      return positions[all[k / 4].vertices[k % 4]];
    });
  };
  test_in_lanes<Cell_filter_in_lanes_3<Lanes<lanes>>>(some, corners, beyond, learned, unproved);
}

// Tests so many cells, the i-th of which is cell_at(i). Finite ones are collected until all lanes
// have one.
template <int lanes, class Cell_at, class Learned>
BOOST_FORCEINLINE void append_unproved_in_lanes(const Tetrahedra_arrays_3& arrays,
                                                const Position_3* positions, std::size_t number,
                                                const Cell_at& cell_at, const Learned& learned,
                                                Unproved_cells_3& unproved)
{
  const Tetrahedra_arrays_3::Cell* const cells = arrays.cells();
  // Neighbors are fetched ahead: of 10,000 and 100,000 points a calm frame takes two fifths of the
  // time that it takes without, 100 instead of 235 nanoseconds a point, and 158 instead of 382.
  constexpr std::size_t ahead = 16;
  Few<Cell_index, lanes> some{};
  int collected = 0;
  for (std::size_t n = 0; n < number; ++n) {
    const Cell_index c = cell_at(n);
    const Vertices_3& v = cells[c].vertices;
    if (n + 2 * ahead < number)
      prefetch(cells + cell_at(n + 2 * ahead));
    if (n + ahead < number)
      for (const Corner_index k : cells[cell_at(n + ahead)].mirrors)
        prefetch(cells + k / 4);
    if (has_infinite(v)) {
      unproved.infinite.push_back(c);
      continue;
    }
    some[collected++] = c;
    if (collected < lanes)
      continue;
    append_unproved<lanes>(cells, positions, some, learned, unproved.finite);
    collected = 0;
  }
  for (int i = 0; i < collected; ++i)
    append_unproved<1>(cells, positions, {some[i]}, learned, unproved.finite);
}

// What a pass over open space reads.
template <class State>
struct Pass_view_3
{
  explicit Pass_view_3(const State& state)
    : arrays(state.arrays)
    , positions(state.positions.data())
  {
  }
  static double error_of(const State&) { return 0; } // of vectors between rounded positions

  template <class Cell_at, class Learned>
  void append_unproved(std::size_t number, const Cell_at& cell_at, const Learned& learned,
                       Unproved_cells_3& unproved) const
  {
    call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      append_unproved_in_lanes<lanes>(arrays, positions, number, cell_at, learned, unproved);
    });
  }

  const Tetrahedra_arrays_3& arrays;
  const Position_3* positions;
};

// Calls append(first, beyond, list) for parts of a range, on threads, and appends these lists in
// order.
template <class Parts, class List, class Append>
void append_by_parts(std::size_t size, std::size_t least, const Append& append, List& all)
{
  const std::size_t parts = Parts::number(size, least);
  std::array<List, Parts::max_parts> lists;
  Parts::for_each(size, least, [&](std::size_t part, std::size_t first, std::size_t beyond) {
    append(first, beyond, parts == 1 ? all : lists[part]);
  });
  for (std::size_t part = 0; part < parts && parts > 1; ++part)
    all.append(lists[part]);
}
template <class State, class Append>
void append_by_parts(const State& state, const Append& append, Unproved_cells_3& unproved)
{
  using Parts = typename State::Parts;
  append_by_parts<Parts>(state.arrays.number_of_cells(), Parts::usual_size, append, unproved);
}

// Finds the cells that floating point does not prove positive with legal facets, on threads; each
// facet is tested from both of its cells. Where positions are rounded, nothing is proved.
template <class State>
void find_unproved(const State& state, Unproved_cells_3& unproved)
{
  unproved.clear();
  if (!state.positions_are_exact) {
    for (Cell_index c(0); c < state.arrays.number_of_cells(); ++c)
      (state.arrays.is_infinite(c) ? unproved.infinite : unproved.finite).push_back(c);
    return;
  }
  const Pass_view_3<State> view(state);
  const auto append = [&](std::size_t first, std::size_t beyond, Unproved_cells_3& list) {
    view.append_unproved(
        beyond - first, [first](std::size_t n) { return Cell_index(first + n); },
        Nothing_learned_3(), list);
  };
  append_by_parts(state, append, unproved);
}

// The same, but leaves out cells that are safe, and learns the slacks of the others. Returns their
// number.
template <class State>
std::size_t find_unproved_unless_safe(State& state, Unproved_cells_3& unproved)
{
  unproved.clear();
  std::atomic<std::size_t> tested{0};
  Safe_cells_3& safe_cells = state.arrays.safe_cells();
  const Pass_view_3<State> view(state);
  const double error = view.error_of(state);
  const auto set_slack = [&](Cell_index c, double slack) { safe_cells.set_slack(c, slack); };
  const auto append = [&](std::size_t first, std::size_t beyond, Unproved_cells_3& list) {
    std::vector<Cell_index> doubtful;
    safe_cells.list_doubtful(first, beyond, doubtful);
    view.append_unproved(
        doubtful.size(), [&](std::size_t n) { return doubtful[n]; },
        Slacks_learned_3(error, set_slack), list);
    tested += doubtful.size();
  };
  append_by_parts(state, append, unproved);
  return tested;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CELL_PASS_3_H
