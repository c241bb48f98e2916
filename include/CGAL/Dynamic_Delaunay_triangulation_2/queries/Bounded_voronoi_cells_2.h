// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_CELLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_CELLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_boundary_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_cutters_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_pass_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The points' Voronoi cells, bounded: each cell ends at a *radius* around its point, at the walls of a
convex *domain*, or at both. Cells that end at a radius are those of the finite Voronoi model of
tissue (J. Huang, H. Levine, D. Bi: *Soft Matter* 19, 2023). They work in the plane and in periodic
space, domains only in the plane.

The boundary of a cell consists of *pieces*, counterclockwise around it:

- on a *neighbor*: a segment where the cell touches that of a neighbor, a contact. Both cells have
  it, with the same length but for rounding. Neighbors without such a segment have no contact, also
  where four points lie on a circle;
- on a *wall*: a segment of an edge of the domain. Wall 0 is the one after the first corner;
- *free*: an arc at the radius. If radii differ, also a segment where the cell ends at the bisector
  with a neighbor that does not reach so far.

Lengths and radii are in the unit of the coordinates, areas in the squared unit, angles in radians.
Every measure has an entry for each id.

- Points that coincide share a cell, with the radius of their representative. Each gets an equal
  share of its area, and the whole of its lengths and its centroid. The pieces are those of the
  representative; the others have none.
- A point may be outside of the domain. Then its cell is the part of its Voronoi cell in the domain,
  or empty.
- If a wall lies on a bisector, rounding decides which of them a piece is on.
- An empty cell has area and lengths 0, and its point for the centroid.
- Removed ids have no pieces, and 0 for all measures.

Accuracy: a chord at the distance h from the point, from u to u', adds h (u' - u) / 2 to the area,
and an arc with the angle w adds r^2 w / 2. If the point is inside of the domain all of these are
positive, so the area has a relative error of a few roundings for each piece, however thin the cell
is; walls are off by a few roundings of the domain's extent. The cell of a point outside has an area
that is off by a few roundings of the squared extent of the domain, however far away the point is,
or of the squared radius, if the point is two extents away and the domain is not within the radius.
Areas are never negative. Lengths have errors of a few roundings of the radius, except where curves
are nearly tangent: two discs that touch may have a contact of 10^-8 radii, or none.

An object keeps its memory. Threads share the points if the triangulation has the `Parallel_tag`;
the result is the same.

\sa `Bounded_voronoi_gradients_2`
\sa `Bounded_voronoi_surface_2`
\sa `Voronoi_cell_measures_2`
*/
class Bounded_voronoi_cells_2
{
public:
  /// \name Types
  /// @{

  /// the type of ids.
  using size_type = std::size_t;
  /// a place: two doubles, `x` and `y`.
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;

  /// what is on the other side of a piece of a boundary: `Side::NEIGHBOR`, the cell of a neighbor;
  /// `Side::WALL`, the outside of the domain; or `Side::FREE`, no cell.
  using Side = Dynamic_Delaunay_triangulations_2::internal::Cell_side_2;

  /// a piece of a boundary, with these members. In periodic space places are around the
  /// representative as it was given.
  /// - `Side side`: what is on the other side;
  /// - `size_type other`: the id of the neighbor whose bisector it is on, the number of the wall,
  /// or
  ///   for an arc the id of the cell;
  /// - `Periodic_shift_2 shift`, by which the neighbor is translated; 0 in the plane;
  /// - `Position from`, `Position to`: where it begins and ends;
  /// - `double length`: the length of the segment or of the arc;
  /// - `double angle`: the angle of an arc, at the point; 0 for a segment.
  using Piece = Dynamic_Delaunay_triangulations_2::internal::Cell_piece_2;

  /// the measures of a cell: `area`, `perimeter`, the whole length of the boundary, `centroid`,
  /// `wall_length`, the length on walls, and `free_length`.
  using Measures = Dynamic_Delaunay_triangulations_2::internal::Cell_measures_2;
  /// a cell by itself.
  struct Cell : Measures
  {
    std::vector<Piece> pieces; ///< its boundary, counterclockwise.
  };

  /// @}
  /// \name The Domain
  /// Without a domain cells end at their radius only.
  /// @{

  /// sets the domain to a convex polygon, whose corners have `x()` and `y()`, counterclockwise.
  ///
  /// \throws Domain_error_2 if there are fewer than three corners, if one of them is not finite, is
  /// farther than 1e100 from the first one, or is no left turn, or if they turn around more than
  /// once; nothing changes.
  template <class InputIterator>
  void set_domain(InputIterator first, InputIterator beyond)
  {
    std::vector<Position> corners;
    for (; first != beyond; ++first)
      corners.push_back({CGAL::to_double(first->x()), CGAL::to_double(first->y())});
    m_domain = Domain(std::move(corners));
  }
  /// sets the domain to a box.
  ///
  /// \throws Domain_error_2 if it has no area, is not finite, or is larger than 1e100; nothing
  /// changes.
  void set_domain(const Bbox_2& box)
  {
    m_domain = Domain({{box.xmin(), box.ymin()},
                       {box.xmax(), box.ymin()},
                       {box.xmax(), box.ymax()},
                       {box.xmin(), box.ymax()}});
  }
  /// removes the domain.
  void remove_domain() { m_domain = Domain(); }
  /// whether a place is in the domain or on a wall, exactly; true if there is no domain.
  ///
  /// Cost: linear in the number of walls. \pre Its coordinates are finite.
  bool is_in_domain(const Position& p) const { return m_domain.contains(p); }

  /// @}
  /// \name Computation
  /// If memory runs out, there are no cells.
  /// @{

  /// computes the cells of all points, with one radius. It may be infinite if there is a domain.
  ///
  /// Cost: for each point, proportional to the number of its neighbors, and of the domain's walls,
  /// times the number of its cell's corners.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_2` or
  /// `Dynamic_periodic_Delaunay_triangulation_2`.
  /// \throws Parameter_error_2 unless the radius is from 2.2e-308, the smallest normal double, to
  /// 1e100, or infinite with a domain; nothing changes.
  /// \throws Domain_error_2 in periodic space if there is a domain; nothing changes.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, double radius)
  {
    compute(dt, Radii(radius, m_domain.has_walls()), true);
  }
  /// computes the cells of all points, with a radius for each id. The radii of removed ids are
  /// ignored.
  ///
  /// \throws Point_count_error_2 if there are not as many radii as ids; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const std::vector<double>& radii)
  {
    compute(dt, Radii(dt, radii, m_domain.has_walls()), true);
  }

  /// computes as `compute()` does, but lists no pieces. The measures are the same, in 0.6 to 0.9 of
  /// the time.
  template <class Dynamic>
  void compute_measures(const Dynamic& dt, double radius)
  {
    compute(dt, Radii(radius, m_domain.has_walls()), false);
  }
  /// computes the measures with a radius for each id.
  template <class Dynamic>
  void compute_measures(const Dynamic& dt, const std::vector<double>& radii)
  {
    compute(dt, Radii(dt, radii, m_domain.has_walls()), false);
  }

  /// returns the cell of one point, which `compute()` would give if all points had this radius. If
  /// the point coincides with others, the cell has its share of the area, and the pieces of the
  /// representative. Nothing changes.
  ///
  /// Cost: that of `compute()` for this point; also linear in the number of duplicates.
  /// \throws Parameter_error_2, Domain_error_2 or Uncertified_triangulation_error_2 as `compute()`.
  /// \throws Unknown_id_error_2 if no point has this id.
  template <class Dynamic>
  Cell cell(const Dynamic& dt, size_type id, double radius) const
  {
    const Radii radii(radius, m_domain.has_walls());
    Part part;
    const Measures measures = Pass::measure_one(space_of(dt), id, radii, Cutter_2{m_domain}, part);
    return {measures, std::move(part.pieces)};
  }

  /// @}
  /// \name Access
  /// @{

  /// the area of each id's cell.
  const std::vector<double>& areas() const { return m_cells.areas(); }
  /// the length of the whole boundary of each id's cell.
  const std::vector<double>& perimeters() const { return m_cells.perimeters(); }
  /// the centroid of each id's cell.
  const std::vector<Position>& centroids() const { return m_cells.centroids(); }
  /// the length on walls of each id's cell.
  const std::vector<double>& wall_lengths() const { return m_cells.wall_lengths(); }
  /// the free length of each id's cell. A cell is at the surface of the points if it is not 0.
  const std::vector<double>& free_lengths() const { return m_cells.free_lengths(); }

  /// whether `compute()` has listed pieces, which `compute_measures()` does not.
  bool has_pieces() const { return m_cells.has_pieces(); }
  /// the pieces of all cells: those of each id are consecutive.
  const std::vector<Piece>& pieces() const { return m_cells.pieces(); }
  /// the radius that was given for each id; 0 for removed ids.
  const std::vector<double>& radii() const { return m_cells.radii(); }
  /// the corners of the domain, or none.
  const std::vector<Position>& domain() const { return m_domain.corners(); }

  /// where the pieces of each id begin in `pieces()`; one more entry than there are ids.
  const std::vector<size_type>& first_pieces() const { return m_cells.first_pieces(); }

  /// @}

private:
  using Domain = Dynamic_Delaunay_triangulations_2::internal::Convex_domain_2;
  using Radii = Dynamic_Delaunay_triangulations_2::internal::Cell_radii_2;
  using Pass = Dynamic_Delaunay_triangulations_2::internal::Cell_pass_2;
  using Part = Dynamic_Delaunay_triangulations_2::internal::Cell_part_2;
  template <class Dynamic>
  using Space = Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic>;

  struct Cutter_2
  {
    template <class Its_space>
    Measures operator()(const Its_space& space, size_type id, const Radii& radii, Part& part) const
    {
      cut_by_star(space, id, radii, domain.surroundings(), part.cell);
      domain.cut(part.cell);
      return part.cell.measures(space.position(id), id, radii(id), part.listed_pieces());
    }
    const Domain& domain;
  };

  template <class Dynamic>
  Space<Dynamic> space_of(const Dynamic& dt) const
  {
    if (!Space<Dynamic>::can_have_walls && m_domain.has_walls())
      throw Domain_error_2(0, "there is none in periodic space");
    return Space<Dynamic>(dt);
  }

  template <class Dynamic>
  void compute(const Dynamic& dt, const Radii& radii, bool lists_pieces)
  {
    m_cells.run(space_of(dt), radii, Cutter_2{m_domain}, lists_pieces);
  }

  Domain m_domain;
  Pass m_cells;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_CELLS_2_H
