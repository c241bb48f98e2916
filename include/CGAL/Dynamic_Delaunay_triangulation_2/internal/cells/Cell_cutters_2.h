// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_CUTTERS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_CUTTERS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Bounded_cell_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_boundary_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Exact_lines_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What cuts cells: discs, the bisectors with the neighbors in a star, and the walls of a convex
// domain. Polygonal_domain_2 is a domain of any other shape.

// THE DISC ----------------------------------------------------------------------------------------

// The radius of each id: one for all, or one each.
class Cell_radii_2
{
public:
  // Both throw unless radii, except those of removed ids, are in range. The vector must stay.
  Cell_radii_2(double radius, bool may_be_infinite)
    : m_one(radius)
  {
    check(radius, may_be_infinite);
  }
  template <class Dynamic>
  Cell_radii_2(const Dynamic& dt, const std::vector<double>& radii, bool may_be_infinite)
    : m_each(&radii)
  {
    if (radii.size() != dt.number_of_ids())
      throw Point_count_error_2(dt.number_of_ids(), radii.size());
    for (std::size_t id = 0; id < radii.size(); ++id)
      if (dt.has_id(id))
        check(radii[id], may_be_infinite);
  }

  double operator()(std::size_t id) const { return m_each == nullptr ? m_one : (*m_each)[id]; }

private:
  static void check(double radius, bool may_be_infinite)
  {
    constexpr double least = (std::numeric_limits<double>::min)(), most = 1e100;
    if (!(radius >= least && (radius <= most || (may_be_infinite && std::isinf(radius)))))
      throw Parameter_error_2("the radius", radius, least, most);
  }

  const std::vector<double>* m_each = nullptr;
  double m_one = 0;
};

// A cell while it is cut: a polygon in a disc, relative to an origin, and the labels of its sides.
struct Cut_cell_2
{
  void add_label(const Voronoi_neighbor_2& neighbor, double radius)
  {
    Cell_label_2& label = labels.emplace_back(); // filled in place, as the sides of the polygon are
    label.side = Cell_side_2::NEIGHBOR;
    label.other = neighbor.id;
    label.shift = neighbor.shift;
    label.radius = radius;
  }

  // Reads the boundary of the cell of p.
  Cell_measures_2 measures(const Position_2& p, std::size_t id, double radius,
                           std::vector<Cell_piece_2>* pieces)
  {
    Cell_boundary_2 boundary(origin, p, id, radius, pieces);
    polygon.for_each_piece(
        [&](std::size_t number, const Position_2& n, double h, double first, double last) {
          boundary.add_chord(labels[number], n, h, first, last);
        },
        [&](const Position_2& from, const Position_2& to, double angle) {
          boundary.add_arc(from, to, angle);
        });
    return boundary.measures();
  }

  Position_2 origin{0, 0};
  Bounded_cell_2 polygon{};
  std::vector<Cell_label_2> labels{};
};

// BISECTORS ---------------------------------------------------------------------------------------

// Squares of tiny vectors underflow, and those of huge ones overflow.
BOOST_NOINLINE inline double length_of_tiny_or_huge(const Position_2& way)
{
  return std::hypot(way.x, way.y);
}
inline double length_of(const Position_2& way)
{
  const double square = dot(way, way);
  const bool is_usual = square > 1e-300 && square < 1e300;
  return BOOST_LIKELY(is_usual) ? std::sqrt(square) : length_of_tiny_or_huge(way);
}

// Makes the cell the polygon of the bisectors with all neighbors, in their order. False where they
// do not close.
template <class Space>
bool is_closed_by_star(const Space& space, std::size_t id, const Cell_radii_2& radii,
                       Cut_cell_2& cell)
{
  cell.labels.clear();
  cell.polygon.start(radii(id));
  space.for_each_neighbor(id, [&](const Voronoi_neighbor_2& neighbor) {
    const Position_2& way = neighbor.vector;
    const double length = length_of(way);
    cell.polygon.add_side({way.x / length, way.y / length}, length / 2, cell.labels.size());
    cell.add_label(neighbor, radii(neighbor.id));
  });
  return cell.polygon.close();
}

// Cuts what the cell has now, relative to the cell's point or the center of a domain.
template <class Space>
void cut_by_bisectors(const Space& space, std::size_t id, const Cell_radii_2& radii,
                      Cut_cell_2& cell)
{
  cell.labels.clear();
  space.for_each_neighbor(id, [&](const Voronoi_neighbor_2& neighbor) {
    const Position_2& way = neighbor.vector;
    const double length = length_of(way);
    if (length / 2 >= cell.polygon.radius())
      return;
    cell.polygon.cut({way.x / length, way.y / length}, length / 2, cell.labels.size());
    cell.add_label(neighbor, radii(neighbor.id));
  });
}

// The same, relative to the center of a domain that the cell's point sees from afar. If nothing of
// the cell is there, its polygon has no sides.
template <class Space>
void cut_by_bisectors_from_afar(const Space& space, std::size_t id, const Cell_radii_2& radii,
                                const Surroundings_2& domain, Cut_cell_2& cell)
{
  const Position_2 p = space.position(id);
  cell.labels.clear();
  space.for_each_neighbor(id, [&](const Voronoi_neighbor_2& neighbor) {
    if (cell.polygon.sides().empty())
      return;
    const Position_2 q = space.position(neighbor.id);
    const Division_2 sides =
        division(p - domain.center, q - domain.center, neighbor.vector, domain.reach);
    if (sides == Division_2::ALL_BEYOND)
      cell.polygon.start(cell.polygon.radius());
    if (sides != Division_2::UNKNOWN)
      return;
    const auto [way, product] = exact_bisector(p, q, neighbor.vector, domain.center);
    const double length = length_of(way);
    cell.polygon.cut({way.x / length, way.y / length}, product / length, cell.labels.size());
    cell.add_label(neighbor, radii(neighbor.id));
  });
}

// Makes the cell the polygon of all bisectors. Where these do not close, or `suffices(cell)` is
// false, makes it what they leave of another polygon, with which `begin(cell, radius, reach)`
// begins; the reach is that of the disc, or of the domain if the radius is infinite. The cell is
// relative to its point, or if that point sees the domain from afar, to the domain's center.
// Returns whether it does.
template <class Space, class Begin, class Suffices>
bool cut_by_star(const Space& space, std::size_t id, const Cell_radii_2& radii,
                 const Surroundings_2& domain, Cut_cell_2& cell, const Begin& begin,
                 const Suffices& suffices)
{
  const Position_2 p = space.position(id);
  const bool is_afar = domain.are_seen_from_afar(p, radii(id));
  cell.origin = is_afar ? domain.center : p;
  if (is_afar) {
    begin(cell, std::numeric_limits<double>::infinity(), domain.reach);
    cut_by_bisectors_from_afar(space, id, radii, domain, cell);
  } else if (!(is_closed_by_star(space, id, radii, cell) && suffices(cell))) {
    const double radius = radii(id);
    begin(cell, radius, std::isinf(radius) ? domain.reach_from(p) : radius);
    cut_by_bisectors(space, id, radii, cell);
  }
  return is_afar;
}

// Makes the cell the part of a Voronoi cell in its disc, or if the radius is infinite, one that is
// still to be cut by the domain.
template <class Space>
bool cut_by_star(const Space& space, std::size_t id, const Cell_radii_2& radii,
                 const Surroundings_2& domain, Cut_cell_2& cell)
{
  return cut_by_star(
      space, id, radii, domain, cell,
      [](Cut_cell_2& square, double radius, double reach) {
        square.polygon.start_box(radius, {-2 * reach, -2 * reach}, {2 * reach, 2 * reach}, false);
      },
      [](const Cut_cell_2&) { return true; });
}

// Makes the cell the part of a Voronoi cell in a box, which may have no inside.
template <class Space>
void cut_out_of_box(const Space& space, std::size_t id, const Position_2& low,
                    const Position_2& high, Cut_cell_2& cell)
{
  cut_by_star(
      space, id, Cell_radii_2(std::numeric_limits<double>::infinity(), true), {low, high}, cell,
      [&](Cut_cell_2& box, double radius, double) {
        box.polygon.start_box(radius, low - box.origin, high - box.origin, true);
      },
      [&](const Cut_cell_2& closed) {
        const Position_2 least = low - closed.origin, most = high - closed.origin;
        return std::all_of(closed.polygon.corners().begin(), closed.polygon.corners().end(),
                           [&](const Position_2& p) {
                             return p.x >= least.x && p.y >= least.y && p.x <= most.x &&
                                    p.y <= most.y;
                           });
      });
}

// CONVEX DOMAINS ----------------------------------------------------------------------------------

// The walls of a convex polygon; everything, if there are none. Wall i begins at corner i.
class Convex_domain_2
{
  using Point = Exact_predicates_inexact_constructions_kernel::Point_2;

public:
  Convex_domain_2() = default;
  // Throws Domain_error_2 unless the polygon is convex and counterclockwise.
  explicit Convex_domain_2(std::vector<Position_2> corners)
    : m_corners(std::move(corners))
  {
    check();
    Position_2 least = m_corners.front(), most = least;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const Position_2 &p = m_corners[i], &q = m_corners[next(i)];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      m_normals.push_back({(q.y - p.y) / length, -(q.x - p.x) / length});
      least = {(std::min)(least.x, p.x), (std::min)(least.y, p.y)};
      most = {(std::max)(most.x, p.x), (std::max)(most.y, p.y)};
    }
    m_surroundings = {least, most};
  }

  bool has_walls() const { return !m_corners.empty(); }
  const std::vector<Position_2>& corners() const { return m_corners; }
  const Surroundings_2& surroundings() const { return m_surroundings; }

  // Whether a place is inside or on a wall, exactly.
  bool contains(const Position_2& p) const
  {
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      if (orientation(corner(i), corner(next(i)), Point(p.x, p.y)) == RIGHT_TURN)
        return false;
    return true;
  }

  void cut(Cut_cell_2& cell) const
  {
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const Position_2& normal = m_normals[i]; // outward
      const double distance = dot(normal, m_corners[i] - cell.origin);
      if (cell.polygon.is_within(normal, distance))
        continue;
      cell.polygon.cut(normal, distance, cell.labels.size());
      cell.labels.push_back({Cell_side_2::WALL, i, {0, 0}, 0});
    }
  }

private:
  std::size_t next(std::size_t i) const { return i + 1 < m_corners.size() ? i + 1 : 0; }
  Point corner(std::size_t i) const { return Point(m_corners[i].x, m_corners[i].y); }

  void check() const
  {
    const std::size_t size = m_corners.size();
    if (size < 3)
      throw Domain_error_2(size, "there are no more, and a domain has at least three");
    for (std::size_t i = 0; i < size; ++i)
      check_domain_corner(i, m_corners[i], m_corners[0]);
    double turned = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t before = i > 0 ? i - 1 : size - 1;
      if (orientation(corner(before), corner(i), corner(next(i))) != LEFT_TURN)
        throw Domain_error_2(i, "it must be a left turn");
      const Position_2 u = m_corners[i] - m_corners[before], v = m_corners[next(i)] - m_corners[i];
      turned += std::atan2(cross(u, v), dot(u, v));
    }
    if (turned > 7) // a full turn is 6.28
      throw Domain_error_2(0, "the corners turn around more than once");
  }

  std::vector<Position_2> m_corners, m_normals;
  Surroundings_2 m_surroundings;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_CUTTERS_2_H
