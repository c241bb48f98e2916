// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_FLAT_WALLS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_FLAT_WALLS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The coordinate along an axis of the outermost positions on the side of a sign, if several have it
// exactly in common: that of a flat wall. Otherwise it is infinite.
template <class Positions>
double flat_wall(const Positions& positions, int axis, double sign)
{
  constexpr std::size_t few_on_wall = 4;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double outermost = -infinity;
  std::size_t number = 0;
  for (Vertex_index v(1); v < positions.number(); ++v) {
    const double x = sign * coordinate(positions.position(v), axis);
    number = x > outermost ? 1 : number + (x == outermost);
    outermost = (std::max)(outermost, x);
  }
  return sign * (number < few_on_wall ? infinity : outermost);
}

// Flat walls of the hull: planes across coordinate axes in which several vertices are, and beyond
// which none was when they were found. Walls may move; a vertex stays on one as long as it has its
// coordinate exactly in common with the others.
template <class State>
class Flat_walls_3
{
  using Positions = typename State::Positions;

public:
  void clear() { m_walls.clear(); }

  // Whether vertices with this coordinate are on one of them.
  bool has(int axis, double level) const
  {
    return std::any_of(m_walls.begin(), m_walls.end(),
                       [&](const Wall& wall) { return wall.axis == axis && wall.level == level; });
  }

  // Adds those of the present positions that are not known yet.
  void find(const State& state)
  {
    for (int axis = 0; axis < 3; ++axis)
      if (state.has_levels(axis))
        for (const double sign : {-1.0, 1.0}) {
          const double level = flat_wall(state.positions, axis, sign);
          if (std::abs(level) < std::numeric_limits<double>::infinity() && !has(axis, level))
            m_walls.push_back({axis, level});
        }
  }

  // Goes on to the present positions of a frame, and lists the vertices that have left a wall since
  // the last one. False if too many have, whatever that wall is: then it is none any more.
  bool follow(const State& state, const Positions& previous, std::vector<Vertex_index>& left)
  {
    left.clear();
    bool go_on = true;
    for (Wall& wall : m_walls) {
      const std::size_t before = left.size(), most = before + few_left + previous.number() / 64;
      const double level = new_level(wall, state, previous);
      for (Vertex_index v(1); v < previous.number() && left.size() <= most; ++v)
        if (coordinate(previous.position(v), wall.axis) == wall.level &&
            !(coordinate(state.positions.position(v), wall.axis) == level))
          left.push_back(v);
      go_on = go_on && left.size() <= most;
      wall.level = level;
    }
    if (!go_on)
      clear();
    m_walls.erase(std::remove_if(m_walls.begin(), m_walls.end(),
                                 [](const Wall& wall) { return wall.level != wall.level; }),
                  m_walls.end()); // no vertex was on them
    return go_on;
  }

private:
  struct Wall
  {
    int axis;
    double level;
  };

  // The middle one of the new coordinates of the first three vertices: one of them may leave.
  static double new_level(const Wall& wall, const State& state, const Positions& previous)
  {
    std::array<double, 3> levels{};
    std::size_t number = 0;
    for (Vertex_index v(1); v < previous.number() && number < 3; ++v)
      if (coordinate(previous.position(v), wall.axis) == wall.level)
        levels[number++] = coordinate(state.positions.position(v), wall.axis);
    std::sort(levels.begin(), levels.begin() + std::ptrdiff_t(number));
    return number == 0 ? std::numeric_limits<double>::quiet_NaN() : levels[number / 2];
  }

  static constexpr std::size_t few_left = 16;

  std::vector<Wall> m_walls;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_FLAT_WALLS_3_H
