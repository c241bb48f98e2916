// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_BOUNDED_CELL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_BOUNDED_CELL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The intersection of a disc around the origin with half-planes: the part of a Voronoi cell in the
// disc, with the cell's point in the origin.
//
//            side                          The convex polygon of the half-planes has corners, and a
//          __________                      side after each. `for_each_piece()` gives the part of
//         /  chord   \     chord: the      each side within the disc, a chord, and the arcs that
//        (            )    part of a       connect chords.
//     arc \__________/     side inside
//
// A line is given by its unit normal n, which points out of the half-plane, and its distance h from
// the origin: n x <= h inside. A place on it is h n + u t, where t is n turned left. Chords are
// intervals of u, and their triangles with the origin have the area h (u' - u) / 2: nothing cancels
// where the origin is inside. Corners are computed from the lines of both their sides, so earlier
// cuts add no error.
class Bounded_cell_2
{
public:
  static constexpr std::size_t no_label = std::size_t(-1);

  // Begins with a box. Its sides have no label. If the polygon may be flat, cuts leave also a side
  // or a corner.
  void start_box(double radius, const Position_2& low, const Position_2& high, bool may_be_flat)
  {
    m_radius = radius;
    m_may_be_flat = may_be_flat;
    m_corners = {low, {high.x, low.y}, high, {low.x, high.y}};
    m_sides = {{{0, -1}, -low.y, no_label},
               {{1, 0}, high.x, no_label},
               {{0, 1}, high.y, no_label},
               {{-1, 0}, -low.x, no_label}};
  }

  // Begins as a copy of another cell.
  void start(const Bounded_cell_2& cell)
  {
    m_radius = cell.m_radius;
    m_may_be_flat = cell.m_may_be_flat;
    m_corners = cell.m_corners;
    m_sides = cell.m_sides;
  }

  // Begins without sides, for add_side() and close().
  void start(double radius)
  {
    m_radius = radius;
    m_may_be_flat = false;
    m_corners.clear();
    m_sides.clear();
  }
  // Adds the next side counterclockwise, toward the next neighbor of the cell's point.
  void add_side(const Position_2& normal, double distance, std::size_t label)
  {
    // Filled in place, like chords: copying a side waits until each member is stored, which took a
    // quarter of the time of a cell.
    Side& side = m_sides.emplace_back();
    side.normal = normal;
    side.distance = distance;
    side.label = label;
  }
  // Finds the corners between the sides. False where two sides may not meet, as at a corner of the
  // hull: then the polygon has to be cut out of another one.
  bool close()
  {
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
      const Side &side = m_sides[i == 0 ? m_sides.size() - 1 : i - 1], &next = m_sides[i];
      const double sine = cross(side.normal, next.normal);
      if (!(sine > parallel))
        return false;
      m_corners.push_back(meeting_place(side, next, sine));
    }
    return m_sides.size() > 2;
  }

  // Whether no corner is beyond a line, or the line is outside of the disc.
  bool is_within(const Position_2& normal, double distance) const
  {
    return distance >= m_radius ||
           std::none_of(m_corners.begin(), m_corners.end(),
                        [&](const Position_2& corner) { return dot(normal, corner) > distance; });
  }

  // The part of a line in the polygon and the disc, between u and v; empty unless first < last.
  struct Interval
  {
    double first, last;
  };
  Interval part_of_line(const Position_2& normal, double distance, double u, double v) const
  {
    if (!(std::abs(distance) < m_radius))
      return {0, 0};
    const double half = std::sqrt((m_radius - distance) * (m_radius + distance));
    Interval part{(std::max)(u, -half), (std::min)(v, half)};
    const Position_2 t = turned_left(normal);
    for (const Side& side : m_sides) {
      const double slope = dot(side.normal, t);
      const double rest = side.distance - distance * dot(side.normal, normal);
      if (slope > 0)
        part.last = (std::min)(part.last, rest / slope);
      else if (slope < 0)
        part.first = (std::max)(part.first, rest / slope);
      else if (rest < 0)
        return {0, 0};
    }
    return part;
  }

  // Cuts off what is beyond a line; the new side gets the label. If only a side or a corner would
  // be left, on the line, nothing is left, unless the polygon may be flat.
  void cut(const Position_2& normal, double distance, std::size_t label)
  {
    const Side cutting{normal, distance, label};
    m_excess.clear();
    for (const Position_2& corner : m_corners)
      m_excess.push_back(dot(normal, corner) - distance);
    const auto is_beyond = [](double excess) { return excess > 0; };
    if (std::none_of(m_excess.begin(), m_excess.end(), is_beyond))
      return;
    const auto is_before = [](double excess) { return excess < 0; };
    if (!m_may_be_flat && std::none_of(m_excess.begin(), m_excess.end(), is_before)) {
      m_corners.clear();
      m_sides.clear();
      return;
    }
    m_new_corners.clear();
    m_new_sides.clear();
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const std::size_t next = i + 1 < m_corners.size() ? i + 1 : 0;
      if (!is_beyond(m_excess[i]))
        append(m_corners[i], m_sides[i]);
      if (is_beyond(m_excess[i]) != is_beyond(m_excess[next]))
        append(meeting_place(i, next, cutting), is_beyond(m_excess[i]) ? m_sides[i] : cutting);
    }
    m_corners.swap(m_new_corners);
    m_sides.swap(m_new_sides);
  }

  // Calls chord(label, normal, distance, u, u') and arc(from, to, angle) along the boundary,
  // counterclockwise. An arc that is the whole circle begins and ends on the x-axis.
  template <class Chord_function, class Arc_function>
  void for_each_piece(const Chord_function& chord, const Arc_function& arc)
  {
    const std::size_t chords = find_chords();
    if (chords == 0) {
      if (is_disc_inside())
        arc(Position_2{m_radius, 0}, Position_2{m_radius, 0}, full_turn);
      return;
    }
    for (std::size_t i = 0; i < chords; ++i) {
      const Chord& here = m_chords[i];
      const Chord& next = m_chords[i + 1 < chords ? i + 1 : 0];
      const Side& side = m_sides[here.side];
      chord(side.label, side.normal, side.distance, here.first, here.last);
      if (next.is_after_arc) {
        const Position_2 from = place(here.side, here.last), to = place(next.side, next.first);
        if (const double angle = angle_around(here.side, from, next.side, to); angle > 0)
          arc(from, to, angle);
      }
    }
  }

  struct Side
  {
    Position_2 normal;
    double distance;
    std::size_t label;
  };
  const std::vector<Side>& sides() const { return m_sides; }
  const std::vector<Position_2>& corners() const { return m_corners; }
  double radius() const { return m_radius; }

private:
  static constexpr double parallel = 1e-6; // the largest sine between lines that count as parallel
  static constexpr double full_turn = boost::math::constants::two_pi<double>();

  struct Chord
  {
    std::size_t side;
    double first, last;
    bool is_after_arc;
  };

  void append(const Position_2& corner, const Side& side)
  {
    m_new_corners.push_back(corner);
    m_new_sides.push_back(side);
  }

  // The place where two lines meet.
  static Position_2 meeting_place(const Side& side, const Side& line, double sine)
  {
    return {(side.distance * line.normal.y - line.distance * side.normal.y) / sine,
            (line.distance * side.normal.x - side.distance * line.normal.x) / sine};
  }

  // The place where the side from corner i to corner `next` meets a line. If they are about
  // parallel, the coordinate along them is uncertain in any case; it stays between the corners.
  Position_2 meeting_place(std::size_t i, std::size_t next, const Side& line) const
  {
    const Side& side = m_sides[i];
    const double sine = cross(side.normal, line.normal);
    if (std::abs(sine) > parallel)
      return meeting_place(side, line, sine);
    const double t = m_excess[i] / (m_excess[i] - m_excess[next]);
    const Position_2 &p = m_corners[i], &q = m_corners[next];
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }

  static Position_2 turned_left(const Position_2& v) { return {-v.y, v.x}; }

  Position_2 place(std::size_t i, double u) const
  {
    const auto& [normal, distance, label] = m_sides[i];
    const Position_2 t = turned_left(normal);
    return {distance * normal.x + u * t.x, distance * normal.y + u * t.y};
  }

  // An arc is where a side, or the end of one, is outside of the disc. Corners do not show this: a
  // chord may end at a corner on the circle, with arcs and sides outside before the next chord.
  //
  // Returns the number of chords. Branch-free: which sides reach into the disc, and whether they
  // end in it, is as random as the points are, so most branches would be mispredicted. A side
  // without chord writes one that the next side overwrites.
  std::size_t find_chords()
  {
    m_chords.resize((std::max)(m_chords.size(), m_corners.size() + 1));
    std::size_t chords = 0;
    bool is_outside = false; // somewhere since the last chord
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const Side& side = m_sides[i];
      const Position_2 t = turned_left(side.normal);
      const double from = dot(m_corners[i], t);
      const double to = dot(m_corners[i + 1 < m_corners.size() ? i + 1 : 0], t);
      const bool reaches_in = (side.label != no_label) & (std::abs(side.distance) < m_radius);
      const double square = (m_radius - side.distance) * (m_radius + side.distance);
      const double half = std::sqrt((std::max)(square, 0.0));
      const bool exists = from < to; // otherwise by rounding only
      const double first = (std::max)(from, -half), last = (std::min)(to, half);
      const bool is_chord = reaches_in & exists & (first < last);
      is_outside |= (!reaches_in) | (exists & (from < -half));
      Chord& chord = m_chords[chords];
      chord.side = i;
      chord.first = first;
      chord.last = last;
      chord.is_after_arc = is_outside;
      chords += is_chord;
      is_outside = (is_outside & (!is_chord)) | (reaches_in & exists & (to > half));
    }
    m_chords.front().is_after_arc |= is_outside;
    return chords;
  }

  bool is_disc_inside() const
  {
    return !m_corners.empty() && std::all_of(m_sides.begin(), m_sides.end(),
                                             [](const Side& side) { return side.distance >= 0; });
  }

  static double angle(const Position_2& from, const Position_2& to)
  {
    return std::atan2(cross(from, to), dot(from, to));
  }

  // The angle of the arc from a place on side i to one on side k. If rounding could confuse no turn
  // with a full turn, the corners in between, which are outside of the disc, decide.
  double angle_around(std::size_t i, const Position_2& from, std::size_t k,
                      const Position_2& to) const
  {
    constexpr double least = 1e-3;
    double turn = angle(from, to);
    if (turn < 0)
      turn += full_turn;
    if (turn > least && turn < full_turn - least)
      return turn;
    double sum = 0;
    Position_2 last = from;
    std::size_t corner = i;
    do {
      corner = corner + 1 < m_corners.size() ? corner + 1 : 0;
      sum += angle(last, m_corners[corner]);
      last = m_corners[corner];
    } while (corner != k);
    sum += angle(last, to);
    return (std::max)(turn + full_turn * std::round((sum - turn) / full_turn), 0.0);
  }

  double m_radius = 0;
  bool m_may_be_flat = false;
  std::vector<Position_2> m_corners, m_new_corners;
  std::vector<Side> m_sides, m_new_sides; // each after its corner
  std::vector<double> m_excess;           // of the corners
  std::vector<Chord> m_chords;            // and room for more
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_BOUNDED_CELL_2_H
