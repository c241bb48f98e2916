// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_BOUNDARY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_BOUNDARY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

enum class Cell_side_2 { NEIGHBOR, WALL, FREE };

// What `Bounded_voronoi_cells_2` calls a piece.
struct Cell_piece_2
{
  Cell_side_2 side;
  std::size_t other;
  Periodic_shift_2 shift;
  Position_2 from, to;
  double length;
  double angle;
};

struct Cell_measures_2
{
  double area;
  double perimeter;
  Position_2 centroid;
  double wall_length;
  double free_length;
};

// What the pieces on a side of a cell record.
struct Cell_label_2
{
  // Of pieces that are on no neighbor and no wall.
  static Cell_label_2 of_free(std::size_t id) { return {Cell_side_2::FREE, id, {0, 0}, 0}; }

  Cell_side_2 side;
  std::size_t other;
  Periodic_shift_2 shift;
  double radius; // of the neighbor
};

// Reads a boundary, chord by chord and arc by arc: adds up the measures of the cell of p, and lists
// its pieces. Chords and arcs are relative to an origin, which is p if there are arcs.
class Cell_boundary_2
{
public:
  // Lists no pieces where `pieces` is null.
  Cell_boundary_2(const Position_2& origin, const Position_2& p, std::size_t id, double radius,
                  std::vector<Cell_piece_2>* pieces)
    : m_origin(origin)
    , m_to_p(p - origin)
    , m_id(id)
    , m_radius(radius)
    , m_pieces(pieces)
    , m_measures{0, 0, p, 0, 0}
  {
  }

  // A chord of the line with the normal n and the distance h, as in Bounded_cell_2.
  void add_chord(const Cell_label_2& label, const Position_2& n, double h, double first,
                 double last)
  {
    const auto place = [&](double u) { return Position_2{h * n.x - u * n.y, h * n.y + u * n.x}; };
    const Position_2 from = place(first), to = place(last);
    const double doubled_area = h * (last - first);
    m_measures.area += doubled_area / 2;
    m_moment = {m_moment.x + doubled_area * (from.x + to.x) / 2,
                m_moment.y + doubled_area * (from.y + to.y) / 2};
    if (!(label.side == Cell_side_2::NEIGHBOR && label.radius < m_radius)) {
      if (first < last)
        add(label.side, label, from, to, last - first, 0);
      return;
    }
    // what the neighbor does not reach is free
    const double from_p = h - dot(n, m_to_p), middle = cross(n, m_to_p);
    const double half =
        label.radius > from_p ? std::sqrt((label.radius - from_p) * (label.radius + from_p)) : 0;
    const double contact_first = (std::min)((std::max)(first, middle - half), last);
    const double contact_last = (std::max)((std::min)(last, middle + half), contact_first);
    const auto add_part = [&](Cell_side_2 side, double u, double v) {
      if (u < v)
        add(side, label, place(u), place(v), v - u, 0);
    };
    add_part(Cell_side_2::FREE, first, contact_first);
    add_part(label.side, contact_first, contact_last);
    add_part(Cell_side_2::FREE, contact_last, last);
  }

  void add_arc(const Position_2& from, const Position_2& to, double angle)
  {
    const double squared = m_radius * m_radius;
    m_measures.area += squared * angle / 2;
    m_moment = {m_moment.x + squared * (to.y - from.y), m_moment.y - squared * (to.x - from.x)};
    add(Cell_side_2::FREE, Cell_label_2::of_free(m_id), from, to, m_radius * angle, angle);
  }

  Cell_measures_2 measures() const
  {
    Cell_measures_2 result = m_measures;
    result.area = (std::max)(result.area, 0.0); // rounding can make the sum negative
    if (const double weight = 3 * result.area; weight > 0)
      result.centroid = {m_origin.x + m_moment.x / weight, m_origin.y + m_moment.y / weight};
    return result;
  }

private:
  void add(Cell_side_2 side, const Cell_label_2& label, const Position_2& from,
           const Position_2& to, double length, double angle)
  {
    m_measures.perimeter += length;
    if (side == Cell_side_2::WALL)
      m_measures.wall_length += length;
    else if (side == Cell_side_2::FREE)
      m_measures.free_length += length;
    if (m_pieces == nullptr)
      return;
    Cell_piece_2& piece = m_pieces->emplace_back();
    piece.side = side;
    piece.other = label.other;
    piece.shift = label.shift;
    piece.from = {m_origin.x + from.x, m_origin.y + from.y};
    piece.to = {m_origin.x + to.x, m_origin.y + to.y};
    piece.length = length;
    piece.angle = angle;
  }

  const Position_2 m_origin, m_to_p;
  const std::size_t m_id;
  const double m_radius;
  std::vector<Cell_piece_2>* const m_pieces;
  Cell_measures_2 m_measures;
  Position_2 m_moment{0, 0}; // three times the area times the vector to the centroid
};

// Reads a polygon, corner by corner. Adds up the triangles at one corner, which are as small as the
// polygon, however far it is from the origin; so squares of coordinates do not overflow where cubes
// would. The centroid is a mean of places in the polygon. Without area it is p.
inline Cell_measures_2 measures_of_polygon(const std::vector<Position_2>& corners,
                                           const Position_2& origin, const Position_2& p)
{
  Cell_measures_2 measures{0, 0, p, 0, 0};
  double weight = 0;
  Position_2 mean{0, 0}; // of the triangles' centroids, relative to that corner
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Position_2& from = corners[i];
    const Position_2& to = corners[i + 1 < corners.size() ? i + 1 : 0];
    const Position_2 u = from - corners[0], v = to - corners[0];
    const double doubled_area = cross(u, v);
    measures.area += doubled_area / 2;
    measures.perimeter += distance(from, to);
    if (!(doubled_area > 0)) // rounding can invert triangles of thin cells
      continue;
    weight += doubled_area;
    const double share = doubled_area / weight;
    mean.x += share * ((u.x + v.x) / 3 - mean.x);
    mean.y += share * ((u.y + v.y) / 3 - mean.y);
  }
  measures.area = (std::max)(measures.area, 0.0); // rounding can make the sum negative
  if (weight > 0)
    measures.centroid = {origin.x + (corners[0].x + mean.x), origin.y + (corners[0].y + mean.y)};
  return measures;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_BOUNDARY_2_H
