// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELLS_IN_DOMAIN_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELLS_IN_DOMAIN_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_boundary_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_cutters_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_in_domain_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_pass_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Polygonal_domain_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The points' Voronoi cells in a domain that is any simple polygon with holes, such as a hall with
walls and pillars; only in the plane. Cells may also end at a radius, one for all or one per id.

A wall can divide the part of a cell that is in the domain. A *rule* says what counts:

- `WHOLE`: the whole part, perhaps in several components. So each place of the domain belongs to the
  nearest point, and without radii the areas add up to that of the domain;
- `CONNECTED`: the component that has the point. So a cell does not continue behind a wall, but may
  reach around a corner. This is the rule of PedPy (`compute_individual_voronoi_polygons`,
  <https://github.com/PedestrianDynamics/PedPy>), which measures the density of crowds;
- `VISIBLE`: the places in line of sight from the point. Such cells are star-shaped, without holes.

The boundary of a cell consists of *rings*: of each component the outer boundary, counterclockwise,
and then the boundaries of its holes, clockwise. A ring consists of pieces as in
`Bounded_voronoi_cells_2`; each begins where the last one ends, so the places where pieces begin are
the corners. Lines of sight, beyond which a wall hides places that are nearest to the point, are
free pieces, too; their `other` is the id of the cell. Wall 0 is the one after the first corner of
the outer boundary; the walls of holes follow.

Lengths and radii are in the unit of the coordinates, areas in the squared unit. Every measure has
an entry for each id.

- A point may be on a wall, or outside of the domain. The cell of a point outside is, by `WHOLE`,
  the part of its Voronoi cell in the domain, and empty by the other rules: nothing is connected
  with the point, or seen.
- An empty cell has area and lengths 0, its point for the centroid, and no rings.
- By `CONNECTED` and `VISIBLE` a contact is the cell's part of the bisector; the neighbor's cell may
  have less of it, or nothing.
- Components that touch in a single place are two components. If an opening is narrower than 2^-48
  of its distance from the point, or if a wall is on a bisector, rounding decides.
- A wall that is seen edge-on is on the boundary of a visible cell.
- Points that coincide share a cell: each gets an equal share of its area, and the whole of its
  lengths and its centroid. The pieces are those of the representative; the others have none.
- Removed ids have no pieces, and 0 for all measures.

Method: the domain is triangulated once, and each cell is cut by the triangles that it reaches,
starting at its point. Accuracy: areas have a relative error of a few roundings for each piece. If
walls cut the cell, the error is larger by the ratio of the squared extent of the cell, measured
from its point, to its area; for a point that is two extents of the domain away, and has all of it
within its radius, of the squared extent of the domain to that area. Areas are never negative. Exact
predicates find what walls hide.

An object keeps its memory, but for what cutting by the domain takes. Threads share the points if the triangulation has the `Parallel_tag`;
the result is the same. Nothing of this is compiled unless its header is included.

\cgalExample{Dynamic_Delaunay_triangulation_2/crowd_densities.cpp}

\sa `Bounded_voronoi_cells_2`
*/
class Voronoi_cells_in_domain_2
{
  using Base = Bounded_voronoi_cells_2;
  using Domain = Dynamic_Delaunay_triangulations_2::internal::Polygonal_domain_2;
  using Radii = Dynamic_Delaunay_triangulations_2::internal::Cell_radii_2;
  using Pass = Dynamic_Delaunay_triangulations_2::internal::Cell_pass_2;
  using Part = Dynamic_Delaunay_triangulations_2::internal::Cell_part_2;
  template <class Dynamic>
  using Space = Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic>;

public:
  /// \name Types
  /// @{

  /// the type of ids.
  using size_type = std::size_t;
  /// a place: two doubles, `x` and `y`.
  using Position = Base::Position;
  /// what is on the other side of a piece of a boundary.
  using Side = Base::Side;
  /// a piece of a boundary.
  using Piece = Base::Piece;
  /// area, perimeter, centroid, and the lengths on walls and of free pieces.
  using Measures = Base::Measures;

  /// what of a Voronoi cell counts.
  enum class Rule {
    WHOLE,     ///< all that is in the domain.
    CONNECTED, ///< the component that has the point.
    VISIBLE    ///< the places in line of sight from the point.
  };

  /// a cell by itself.
  struct Cell : Measures
  {
    std::vector<Piece> pieces; ///< its boundary, ring after ring.
    std::vector<size_type>
        first_pieces;               ///< where rings begin; one more entry than there are rings.
    std::vector<double> ring_areas; ///< the area that each ring encloses, negative of a hole.
  };

  /// @}
  /// \name The Domain
  /// @{

  /// sets the domain to a polygon with holes, of any kernel, whose coordinates are doubles or
  /// converted to them. Its boundaries may turn either way. Cost: \f$O(n \log n)\f$ for n corners.
  ///
  /// \throws Domain_error_2 with the number of a corner, unless it has an outer boundary, all
  /// corners are finite and within 1e100 of the first one, all boundaries are simple, and holes are
  /// inside of the outer boundary, outside of each other, and do not touch.
  template <class Kernel, class Container>
  explicit Voronoi_cells_in_domain_2(const Polygon_with_holes_2<Kernel, Container>& domain,
                                     Rule rule = Rule::WHOLE)
    : m_rule(rule)
  {
    set_domain(domain);
  }

  /// sets another domain. The cells stay until they are computed again.
  ///
  /// \throws Domain_error_2 as the constructor; nothing changes.
  template <class Kernel, class Container>
  void set_domain(const Polygon_with_holes_2<Kernel, Container>& domain)
  {
    std::vector<Domain::Ring> rings;
    const auto add = [&](const auto& polygon) {
      rings.emplace_back();
      for (auto p = polygon.vertices_begin(); p != polygon.vertices_end(); ++p)
        rings.back().push_back({CGAL::to_double(p->x()), CGAL::to_double(p->y())});
    };
    add(domain.outer_boundary());
    for (auto hole = domain.holes_begin(); hole != domain.holes_end(); ++hole)
      add(*hole);
    m_domain = std::make_shared<const Domain>(rings);
  }

  /// whether a place is in the domain or on a wall, exactly.
  ///
  /// Cost: on average \f$O(\sqrt{n})\f$ for n corners. \pre Its coordinates are finite.
  bool is_in_domain(const Position& p) const
  {
    Face_handle last;
    return m_domain->locate(Domain::Point(p.x, p.y), last)->info().is_inside;
  }

  /// sets the rule for cells that are computed from now on.
  void set_rule(Rule rule) { m_rule = rule; }
  /// the rule.
  Rule rule() const { return m_rule; }

  /// @}
  /// \name Computation
  /// If memory runs out, there are no cells.
  /// @{

  /// computes the cells of all points, which end at the radius if one is given.
  ///
  /// Cost: as for `Bounded_voronoi_cells_2`, and for cells that walls cut, proportional to the
  /// number of the domain's triangles that the cell reaches, times the number of its corners; for
  /// points outside of the domain's convex hull, also to the number of the domain's corners.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_2`.
  /// \throws Parameter_error_2 unless the radius is from 2.2e-308, the smallest normal double, to
  /// 1e100, or infinite.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`. Nothing changes if one
  /// of these is thrown.
  template <class Dynamic>
  void compute(const Dynamic& dt, double radius = std::numeric_limits<double>::infinity())
  {
    compute(dt, Radii(radius, true));
  }
  /// computes the cells of all points, with a radius for each id. The radii of removed ids are
  /// ignored.
  ///
  /// \throws Point_count_error_2 if there are not as many radii as ids; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const std::vector<double>& radii)
  {
    compute(dt, Radii(dt, radii, true));
  }

  /// returns the cell of one point, which `compute()` would give if all points had this radius. If
  /// the point coincides with others, the cell has its share of the area, and the pieces of the
  /// representative. Nothing changes.
  ///
  /// Cost: that of `compute()` for this point; also linear in the size of the domain, and in the
  /// number of duplicates.
  /// \throws Parameter_error_2 or Uncertified_triangulation_error_2 as `compute()`.
  /// \throws Unknown_id_error_2 if no point has this id.
  template <class Dynamic>
  Cell cell(const Dynamic& dt, size_type id,
            double radius = std::numeric_limits<double>::infinity()) const
  {
    const Radii radii(radius, true);
    Part part;
    const Measures measures =
        Pass::measure_one(space_of(dt), id, radii, Cutter_2(*m_domain, m_rule), part);
    Cell cell{measures, std::move(part.pieces), {}, {}};
    for (const auto& ring : part.rings) {
      cell.first_pieces.push_back(ring.first);
      cell.ring_areas.push_back(ring.area);
    }
    cell.first_pieces.push_back(cell.pieces.size());
    return cell;
  }

  /// @}
  /// \name Access
  /// @{

  /// the area of each id's cell.
  const std::vector<double>& areas() const { return m_cells.areas(); }
  /// the length of the whole boundary of each id's cell, holes included.
  const std::vector<double>& perimeters() const { return m_cells.perimeters(); }
  /// the centroid of each id's cell. It may be outside of the cell.
  const std::vector<Position>& centroids() const { return m_cells.centroids(); }
  /// the length on walls of each id's cell.
  const std::vector<double>& wall_lengths() const { return m_cells.wall_lengths(); }
  /// the free length of each id's cell.
  const std::vector<double>& free_lengths() const { return m_cells.free_lengths(); }
  /// the radius that was given for each id; 0 for removed ids.
  const std::vector<double>& radii() const { return m_cells.radii(); }

  /// where the rings of each id begin; one more entry than there are ids.
  const std::vector<size_type>& first_rings() const { return m_cells.first_rings(); }
  /// where the pieces of each ring begin in `pieces()`; one more entry than there are rings.
  const std::vector<size_type>& first_pieces() const { return m_cells.first_pieces_of_rings(); }
  /// the area that each ring encloses, negative of a hole.
  const std::vector<double>& ring_areas() const { return m_cells.ring_areas(); }
  /// the pieces of all rings.
  const std::vector<Piece>& pieces() const { return m_cells.pieces(); }

  /// @}

private:
  using Face_handle = Domain::Face_handle;
  using Clipped = Dynamic_Delaunay_triangulations_2::internal::Cell_in_domain_2;
  using Boundary = Dynamic_Delaunay_triangulations_2::internal::Cell_boundary_2;
  using Label = Dynamic_Delaunay_triangulations_2::internal::Cell_label_2;

  // Cuts cells, and adds their pieces and rings to a part.
  class Cutter_2
  {
  public:
    Cutter_2(const Domain& domain, Rule rule)
      : m_domain(domain)
      , m_rule(rule)
      , m_clipped(domain)
    {
    }

    template <class Its_space>
    Measures operator()(const Its_space& space, size_type id, const Radii& radii, Part& part)
    {
      const Position p = space.position(id);
      const Face_handle face = m_domain.locate(Domain::Point(p.x, p.y), m_last_face);
      if (m_rule != Rule::WHOLE && !face->info().is_inside)
        return {0, 0, p, 0, 0};
      const bool is_afar = cut_by_star(space, id, radii, m_domain.surroundings(), part.cell);
      if (part.cell.polygon.sides().empty())
        return {0, 0, p, 0, 0};
      if (m_clipped.start(part.cell.origin, face, part.cell.polygon) || is_afar)
        return measure_clipped(p, id, radii(id), part);
      part.rings.push_back({part.pieces.size(), 0});
      const Measures measures = part.cell.measures(p, id, radii(id), &part.pieces);
      part.rings.back().area = measures.area;
      return measures;
    }

  private:
    Measures measure_clipped(const Position& p, size_type id, double radius, Part& part)
    {
      if (m_rule == Rule::WHOLE)
        m_clipped.take_all();
      else if (m_rule == Rule::VISIBLE)
        m_clipped.take_visible();
      Boundary boundary(part.cell.origin, p, id, radius, &part.pieces);
      m_clipped.for_each_ring([&](double area, const std::vector<Clipped::Piece>& pieces) {
        part.rings.push_back({part.pieces.size(), area});
        for (const Clipped::Piece& piece : pieces)
          if (piece.kind == Clipped::Kind::ARC)
            boundary.add_arc(piece.from, piece.to, piece.angle);
          else
            boundary.add_chord(label(piece, id, part), piece.normal, piece.distance, piece.first,
                               piece.last);
      });
      return boundary.measures();
    }

    static Label label(const Clipped::Piece& piece, size_type id, const Part& part)
    {
      if (piece.kind == Clipped::Kind::CELL)
        return part.cell.labels[piece.number];
      if (piece.kind == Clipped::Kind::WALL)
        return {Side::WALL, piece.number, {0, 0}, 0};
      return Label::of_free(id);
    }

    const Domain& m_domain;
    const Rule m_rule;
    Face_handle m_last_face; // where the next search begins
    Clipped m_clipped;
  };

  template <class Dynamic>
  static Space<Dynamic> space_of(const Dynamic& dt)
  {
    static_assert(Space<Dynamic>::can_have_walls, "domains with walls are in the plane");
    return Space<Dynamic>(dt);
  }

  template <class Dynamic>
  void compute(const Dynamic& dt, const Radii& radii)
  {
    m_cells.run(space_of(dt), radii, Cutter_2(*m_domain, m_rule), true);
  }

  std::shared_ptr<const Domain> m_domain; // copies share it
  Rule m_rule;
  Pass m_cells;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELLS_IN_DOMAIN_2_H
