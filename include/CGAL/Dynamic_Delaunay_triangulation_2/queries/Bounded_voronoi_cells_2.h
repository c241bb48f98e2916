// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_CELLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_CELLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Bounded_cell_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Exact_lines_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <mutex>
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
  using Index = Dynamic_Delaunay_triangulations_2::Index;

public:
  /// \name Types
  /// @{

  /// the type of ids.
  using size_type = std::size_t;
  /// a place: two doubles, `x` and `y`.
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;

  /// what is on the other side of a piece of a boundary.
  enum class Side {
    NEIGHBOR, ///< the cell of a neighbor.
    WALL,     ///< the outside of the domain.
    FREE      ///< no cell.
  };

  /// a piece of a boundary. In periodic space places are around the representative as it was given.
  struct Piece
  {
    Side side;              ///< what is on the other side.
    size_type other;        ///< the id of the neighbor whose bisector it is on, the number of the
                            ///< wall, or for an arc the id of the cell.
    Periodic_shift_2 shift; ///< by which the neighbor is translated; 0 in the plane.
    Position from;          ///< where it begins.
    Position to;            ///< where it ends.
    double length;          ///< the length of the segment or of the arc.
    double angle;           ///< the angle of an arc, at the point; 0 for a segment.
  };

  /// the measures of a cell.
  struct Measures
  {
    double area;        ///< the area.
    double perimeter;   ///< the whole length of the boundary.
    Position centroid;  ///< the centroid.
    double wall_length; ///< the length on walls.
    double free_length; ///< the free length.
  };
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
    check(corners);
    m_domain = std::move(corners);
    m_surroundings = surroundings();
    m_normals.clear();
    for (size_type i = 0; i < m_domain.size(); ++i) {
      const Position &p = m_domain[i], &q = m_domain[next(i)];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      m_normals.push_back({(q.y - p.y) / length, -(q.x - p.x) / length});
    }
  }
  /// sets the domain to a box.
  ///
  /// \throws Domain_error_2 if it has no area, is not finite, or is larger than 1e100; nothing
  /// changes.
  void set_domain(const Bbox_2& box)
  {
    using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
    const std::array<Point, 4> corners{Point(box.xmin(), box.ymin()), Point(box.xmax(), box.ymin()),
                                       Point(box.xmax(), box.ymax()),
                                       Point(box.xmin(), box.ymax())};
    set_domain(corners.begin(), corners.end());
  }
  /// removes the domain.
  void remove_domain()
  {
    m_domain.clear();
    m_surroundings = Surroundings();
  }
  /// whether a place is in the domain or on a wall, exactly; true if there is no domain.
  ///
  /// Cost: linear in the number of walls. \pre Its coordinates are finite.
  bool is_in_domain(const Position& p) const
  {
    using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
    const auto corner = [&](size_type i) { return Point(m_domain[i].x, m_domain[i].y); };
    for (size_type i = 0; i < m_domain.size(); ++i)
      if (orientation(corner(i), corner(next(i)), Point(p.x, p.y)) == RIGHT_TURN)
        return false;
    return true;
  }

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
    check_radius(radius);
    compute_with(dt, [=](size_type) { return radius; });
  }
  /// computes the cells of all points, with a radius for each id. The radii of removed ids are
  /// ignored.
  ///
  /// \throws Point_count_error_2 if there are not as many radii as ids; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const std::vector<double>& radii)
  {
    check_radii(dt, radii, !m_domain.empty());
    compute_with(dt, [&](size_type id) { return radii[id]; });
  }

  /// computes as `compute()` does, but lists no pieces. The measures are the same, in 0.6 to 0.9 of
  /// the time.
  template <class Dynamic>
  void compute_measures(const Dynamic& dt, double radius)
  {
    check_radius(radius);
    compute_with(
        dt, [=](size_type) { return radius; }, false);
  }
  /// computes the measures with a radius for each id.
  template <class Dynamic>
  void compute_measures(const Dynamic& dt, const std::vector<double>& radii)
  {
    check_radii(dt, radii, !m_domain.empty());
    compute_with(
        dt, [&](size_type id) { return radii[id]; }, false);
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
    check_radius(radius);
    check_space<Dynamic>();
    Part part;
    const Measures measures = measure_one(dt, id, radius, Walls_2{*this}, part);
    return {measures, std::move(part.pieces)};
  }

  /// @}
  /// \name Access
  /// @{

  /// the area of each id's cell.
  const std::vector<double>& areas() const { return m_areas; }
  /// the length of the whole boundary of each id's cell.
  const std::vector<double>& perimeters() const { return m_perimeters; }
  /// the centroid of each id's cell.
  const std::vector<Position>& centroids() const { return m_centroids; }
  /// the length on walls of each id's cell.
  const std::vector<double>& wall_lengths() const { return m_wall_lengths; }
  /// the free length of each id's cell. A cell is at the surface of the points if it is not 0.
  const std::vector<double>& free_lengths() const { return m_free_lengths; }

  /// whether `compute()` has listed pieces, which `compute_measures()` does not.
  bool has_pieces() const { return m_has_pieces; }
  /// the pieces of all cells: those of each id are consecutive.
  const std::vector<Piece>& pieces() const { return m_pieces; }
  /// the radius that was given for each id; 0 for removed ids.
  const std::vector<double>& radii() const { return m_radii; }
  /// the corners of the domain, or none.
  const std::vector<Position>& domain() const { return m_domain; }

  /// where the pieces of each id begin in `pieces()`; one more entry than there are ids.
  const std::vector<size_type>& first_pieces() const { return m_first_pieces; }

  /// @}

  /// \cond
protected:
  using Polygon = Dynamic_Delaunay_triangulations_2::internal::Bounded_cell_2;
  using Surroundings = Dynamic_Delaunay_triangulations_2::internal::Surroundings_2;

  // What the pieces on a side of a cell record.
  struct Label
  {
    Side side;
    size_type other;
    Periodic_shift_2 shift;
    double radius; // of the neighbor
  };

  // A closed line of pieces; `first` is the number of the first one.
  struct Ring
  {
    size_type first;
    double area; // negative around a hole
  };

  // The pieces and rings of some cells, and memory that one cell after the other uses.
  struct Part
  {
    bool has_pieces = true;
    std::vector<Piece> pieces{};
    std::vector<Ring> rings{};
    Polygon polygon{};
    std::vector<Label> labels{};
  };

  // Where the pieces and rings of a cell are in a part, until they are in the order of ids.
  struct Source
  {
    size_type part, first_piece, first_ring, pieces, rings;
  };

  // Adds up the measures of the cell of p, piece by piece, and lists the pieces. These are relative
  // to an origin, which is p if there are arcs.
  class Boundary_2
  {
  public:
    Boundary_2(const Position& origin, const Position& p, size_type id, double radius,
               std::vector<Piece>* pieces)
      : m_origin(origin)
      , m_to_p{p.x - origin.x, p.y - origin.y}
      , m_id(id)
      , m_radius(radius)
      , m_pieces(pieces)
      , m_measures{0, 0, p, 0, 0}
    {
    }

    void add_chord(const Label& label, const Position& n, double h, double first, double last)
    {
      const auto place = [&](double u) { return Position{h * n.x - u * n.y, h * n.y + u * n.x}; };
      const Position from = place(first), to = place(last);
      const double doubled_area = h * (last - first);
      m_measures.area += doubled_area / 2;
      m_moment = {m_moment.x + doubled_area * (from.x + to.x) / 2,
                  m_moment.y + doubled_area * (from.y + to.y) / 2};
      // what the neighbor does not reach is free
      double contact_first = first, contact_last = last;
      if (label.side == Side::NEIGHBOR && label.radius < m_radius) {
        using namespace Dynamic_Delaunay_triangulations_2::internal;
        const double from_p = h - dot(n, m_to_p), middle = cross(n, m_to_p);
        const double half = label.radius > from_p
                                ? std::sqrt((label.radius - from_p) * (label.radius + from_p))
                                : 0;
        contact_first = (std::min)((std::max)(first, middle - half), last);
        contact_last = (std::max)((std::min)(last, middle + half), contact_first);
      }
      const auto add_part = [&](Side side, double u, double v) {
        if (u < v)
          add(side, label, place(u), place(v), v - u, 0);
      };
      add_part(Side::FREE, first, contact_first);
      add_part(label.side, contact_first, contact_last);
      add_part(Side::FREE, contact_last, last);
    }

    void add_arc(const Position& from, const Position& to, double angle)
    {
      const double squared = m_radius * m_radius;
      m_measures.area += squared * angle / 2;
      m_moment = {m_moment.x + squared * (to.y - from.y), m_moment.y - squared * (to.x - from.x)};
      add(Side::FREE, free_label(m_id), from, to, m_radius * angle, angle);
    }

    Measures measures() const
    {
      Measures result = m_measures;
      result.area = (std::max)(result.area, 0.0); // rounding can make the sum negative
      if (const double weight = 3 * result.area; weight > 0)
        result.centroid = {m_origin.x + m_moment.x / weight, m_origin.y + m_moment.y / weight};
      return result;
    }

  private:
    void add(Side side, const Label& label, const Position& from, const Position& to, double length,
             double angle)
    {
      m_measures.perimeter += length;
      if (side == Side::WALL)
        m_measures.wall_length += length;
      else if (side == Side::FREE)
        m_measures.free_length += length;
      if (m_pieces == nullptr)
        return;
      Piece& piece = m_pieces->emplace_back();
      piece.side = side;
      piece.other = label.other;
      piece.shift = label.shift;
      piece.from = {m_origin.x + from.x, m_origin.y + from.y};
      piece.to = {m_origin.x + to.x, m_origin.y + to.y};
      piece.length = length;
      piece.angle = angle;
    }

    const Position m_origin, m_to_p;
    const size_type m_id;
    const double m_radius;
    std::vector<Piece>* const m_pieces; // null: none are listed
    Measures m_measures;
    Position m_moment{0, 0}; // three times the area times the vector to the centroid
  };

  // The label of pieces that are on no neighbor and no wall.
  static Label free_label(size_type id) { return {Side::FREE, id, {0, 0}, 0}; }

  static void check_radius(double radius, bool may_be_infinite)
  {
    constexpr double least = (std::numeric_limits<double>::min)(), most = 1e100;
    if (!(radius >= least && (radius <= most || (may_be_infinite && std::isinf(radius)))))
      throw Parameter_error_2("the radius", radius, least, most);
  }
  void check_radius(double radius) const { check_radius(radius, !m_domain.empty()); }

  template <class Dynamic>
  static void check_radii(const Dynamic& dt, const std::vector<double>& radii, bool may_be_infinite)
  {
    if (radii.size() != dt.number_of_ids())
      throw Point_count_error_2(dt.number_of_ids(), radii.size());
    for (size_type id = 0; id < radii.size(); ++id)
      if (dt.has_id(id))
        check_radius(radii[id], may_be_infinite);
  }

  static void check(const std::vector<Position>& corners)
  {
    using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
    if (corners.size() < 3)
      throw Domain_error_2(corners.size(), "there are no more, and a domain has at least three");
    const auto point = [&](size_type i) {
      return Point(corners[i % corners.size()].x, corners[i % corners.size()].y);
    };
    double turned = 0;
    for (size_type i = 0; i < corners.size(); ++i)
      Dynamic_Delaunay_triangulations_2::internal::check_domain_corner(i, corners[i], corners[0]);
    for (size_type i = 0; i < corners.size(); ++i) {
      const Point p = point(i + corners.size() - 1), q = point(i), r = point(i + 1);
      if (orientation(p, q, r) != LEFT_TURN)
        throw Domain_error_2(i, "it must be a left turn");
      turned += std::atan2((q.x() - p.x()) * (r.y() - q.y()) - (q.y() - p.y()) * (r.x() - q.x()),
                           (q.x() - p.x()) * (r.x() - q.x()) + (q.y() - p.y()) * (r.y() - q.y()));
    }
    if (turned > 7) // a full turn is 6.28
      throw Domain_error_2(0, "the corners turn around more than once");
  }

  // Cuts cells by the convex domain.
  struct Walls_2
  {
    template <class Space, class Radius>
    Measures operator()(const Space& space, size_type id, const Radius& radius, Part& part) const
    {
      const Position p = space.position(id);
      if (cells.m_surroundings.are_seen_from_afar(p, radius(id)))
        return cells.measure_from_afar(space, id, radius, part);
      cut_cell(
          space, id, radius, [&] { return cells.reach(p); }, part.polygon, part.labels);
      cells.cut_by_walls(p, part.polygon, part.labels);
      return measure(p, p, id, radius(id), part);
    }
    const Bounded_voronoi_cells_2& cells;
  };

  // Cuts and measures a cell relative to the center of the domain.
  template <class Space, class Radius>
  Measures measure_from_afar(const Space& space, size_type id, const Radius& radius,
                             Part& part) const
  {
    cut_from_afar(space, id, radius, m_surroundings, part.polygon, part.labels);
    cut_by_walls(m_surroundings.center, part.polygon, part.labels);
    return measure(m_surroundings.center, space.position(id), id, radius(id), part);
  }

  template <class Dynamic>
  void check_space() const
  {
    if (Dynamic::Frame::is_periodic && !m_domain.empty())
      throw Domain_error_2(0, "there is none in periodic space");
  }

  template <class Dynamic, class Radius>
  void compute_with(const Dynamic& dt, const Radius& radius, bool lists_pieces = true)
  {
    check_space<Dynamic>();
    const Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic> space(dt);
    m_has_pieces = lists_pieces;
    compute_in(space, radius, Walls_2{*this});
  }

  // Computes all cells. `cutter(space, id, radius, part)` appends the pieces of a cell to the part,
  // and returns the measures of the cell. Each range of cells has its own copy of the cutter.
  template <class Space, class Radius, class Cutter>
  void compute_in(const Space& space, const Radius& radius, const Cutter& cutter)
  {
    try {
      cut_cells(space, radius, cutter);
      collect_pieces();
      share_areas(space);
    } catch (...) {
      clear();
      throw;
    }
  }

  template <class Dynamic, class Cutter>
  static Measures measure_one(const Dynamic& dt, size_type id, double radius, const Cutter& cutter,
                              Part& part)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic> space(dt);
    if (!space.has_id(id))
      throw Unknown_id_error_2(id, space.number_of_ids());
    const auto representative = [&](size_type i) { return space.id_of_cell(space.cell(i)); };
    Cutter own_cutter(cutter);
    Measures measures = own_cutter(
        space, representative(id), [=](size_type) { return radius; }, part);
    double sharers = 1;
    space.for_each_duplicate(
        [&](size_type i) { sharers += representative(i) == representative(id); });
    measures.area /= sharers;
    return measures;
  }

  // Throws nothing.
  void clear()
  {
    m_pieces.clear();
    for (std::vector<double>* measures :
         {&m_radii, &m_areas, &m_perimeters, &m_wall_lengths, &m_free_lengths})
      measures->clear();
    m_centroids.clear();
    m_first_pieces.clear();
  }

  template <class Space, class Radius, class Cutter>
  void cut_cells(const Space& space, const Radius& radius, const Cutter& cutter)
  {
    start(space.number_of_ids());
    for (size_type id = 0; id < space.number_of_ids(); ++id)
      m_radii[id] = space.has_id(id) ? radius(id) : 0;
    std::mutex taking;
    size_type used = 0;
    space.for_each_range(space.number_of_cells(), [&](size_type first, size_type beyond) {
      const size_type number = take_part(used, taking);
      Part& part = m_parts[number];
      part.has_pieces = m_has_pieces;
      part.pieces.clear();
      part.rings.clear();
      Cutter cutter_of_part(cutter);
      for (size_type c = first; c < beyond; ++c)
        if (space.is_cell(Index(c))) {
          const size_type id = space.id_of_cell(Index(c));
          const size_type pieces = part.pieces.size(), rings = part.rings.size();
          set_measures(id, cutter_of_part(space, id, radius, part));
          if (m_has_pieces)
            m_sources[id] = {number, pieces, rings, part.pieces.size() - pieces,
                             part.rings.size() - rings};
        }
    });
  }

  void set_measures(size_type id, const Measures& measures)
  {
    m_areas[id] = measures.area;
    m_perimeters[id] = measures.perimeter;
    m_centroids[id] = measures.centroid;
    m_wall_lengths[id] = measures.wall_length;
    m_free_lengths[id] = measures.free_length;
  }

  // Returns the number of an unused part. Parts keep their memory, and adding one moves no other.
  size_type take_part(size_type& used, std::mutex& taking)
  {
    const std::lock_guard<std::mutex> lock(taking);
    if (used == m_parts.size())
      m_parts.emplace_back();
    return used++;
  }

  void start(size_type ids)
  {
    m_pieces.clear();
    for (std::vector<double>* measures :
         {&m_radii, &m_areas, &m_perimeters, &m_wall_lengths, &m_free_lengths})
      measures->assign(ids, 0);
    m_centroids.assign(ids, {0, 0});
    m_first_pieces.clear();
    m_sources.assign(m_has_pieces ? ids : 0, {0, 0, 0, 0, 0});
  }

  // Makes `cell` the polygon of the bisectors with all neighbors, in their order. If these do not
  // close, cuts it out of a square by the bisectors within the radius. The square is larger than
  // the disc, or if the radius is infinite, than the disc with the radius reach().
  template <class Space, class Radius, class Reach>
  static void cut_cell(const Space& space, size_type id, const Radius& radius, const Reach& reach,
                       Polygon& cell, std::vector<Label>& labels)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const double r = radius(id);
    const auto add_label = [&](const Voronoi_neighbor_2& neighbor) {
      Label& label = labels.emplace_back();
      label.side = Side::NEIGHBOR;
      label.other = neighbor.id;
      label.shift = neighbor.shift;
      label.radius = neighbor.is_infinite() ? 0 : radius(neighbor.id);
    };
    labels.clear();
    bool is_around = true;
    cell.start(r);
    for_each_bisector(
        space, id,
        [&](const Voronoi_neighbor_2& neighbor, const Position& normal, double distance) {
          is_around = is_around && !neighbor.is_infinite();
          cell.add_side(normal, distance, labels.size());
          add_label(neighbor);
        });
    if (!(is_around && cell.close())) {
      cell.start(r, 2 * (std::isinf(r) ? reach() : r));
      labels.clear();
      for_each_bisector(
          space, id,
          [&](const Voronoi_neighbor_2& neighbor, const Position& normal, double distance) {
            if (neighbor.is_infinite() || distance >= r)
              return;
            cell.cut(normal, distance, labels.size());
            add_label(neighbor);
          });
    }
  }

  // Makes `cell` the part of a Voronoi cell around a domain that the cell's point sees from afar,
  // relative to the center of the domain. The walls still have to cut it.
  template <class Space, class Radius>
  static void cut_from_afar(const Space& space, size_type id, const Radius& radius,
                            const Surroundings& domain, Polygon& cell, std::vector<Label>& labels)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Position p = space.position(id);
    bool is_empty = false;
    labels.clear();
    cell.start(std::numeric_limits<double>::infinity(), 2 * domain.reach);
    space.for_each_neighbor(id, [&](const Voronoi_neighbor_2& neighbor) {
      if (neighbor.is_infinite() || is_empty)
        return;
      const Position q = space.position(neighbor.id);
      const Division_2 sides =
          division(p - domain.center, q - domain.center, neighbor.vector, domain.reach);
      is_empty = sides == Division_2::ALL_BEYOND;
      if (sides != Division_2::UNKNOWN)
        return;
      const auto [way, product] = exact_bisector(p, q, neighbor.vector, domain.center);
      const double length = length_of(way);
      cell.cut({way.x / length, way.y / length}, product / length, labels.size());
      labels.push_back({Side::NEIGHBOR, neighbor.id, neighbor.shift, radius(neighbor.id)});
    });
    if (is_empty)
      cell.start(std::numeric_limits<double>::infinity());
  }

  // Squares of tiny vectors underflow.
  static double length_of(const Position& way)
  {
    const double square = Dynamic_Delaunay_triangulations_2::internal::dot(way, way);
    return BOOST_LIKELY(square > 1e-300) ? std::sqrt(square) : length_of_tiny(way);
  }
  BOOST_NOINLINE static double length_of_tiny(const Position& way)
  {
    return std::hypot(way.x, way.y);
  }

  template <class Space, class Function>
  static void for_each_bisector(const Space& space, size_type id, const Function& f)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    space.for_each_neighbor(id, [&](const Voronoi_neighbor_2& neighbor) {
      const Position& way = neighbor.vector;
      const double length = length_of(way);
      f(neighbor, Position{way.x / length, way.y / length}, length / 2);
    });
  }

  void cut_by_walls(const Position& p, Polygon& cell, std::vector<Label>& labels) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    for (size_type i = 0; i < m_domain.size(); ++i) {
      const Position from = m_domain[i] - p;
      const Position& normal = m_normals[i];
      const double distance = dot(normal, from);
      if (cell.is_within(normal, distance))
        continue;
      cell.cut(normal, distance, labels.size());
      labels.push_back({Side::WALL, i, {0, 0}, 0});
    }
  }

  size_type next(size_type corner) const { return corner + 1 < m_domain.size() ? corner + 1 : 0; }

  Surroundings surroundings() const
  {
    Position least = m_domain.front(), most = least;
    for (const Position& corner : m_domain) {
      least = {(std::min)(least.x, corner.x), (std::min)(least.y, corner.y)};
      most = {(std::max)(most.x, corner.x), (std::max)(most.y, corner.y)};
    }
    return {least, most};
  }

  // Returns the distance from p to the farthest corner of the domain.
  double reach(const Position& p) const
  {
    double farthest = 0;
    for (const Position& corner : m_domain)
      farthest = (std::max)(farthest, std::hypot(corner.x - p.x, corner.y - p.y));
    return farthest;
  }

  // Returns the measures of the polygon of p, relative to the origin, and appends its pieces.
  static Measures measure(const Position& origin, const Position& p, size_type id, double radius,
                          Part& part)
  {
    Boundary_2 boundary(origin, p, id, radius, part.has_pieces ? &part.pieces : nullptr);
    part.polygon.for_each_piece(
        [&](size_type number, const Position& n, double h, double first, double last) {
          boundary.add_chord(part.labels[number], n, h, first, last);
        },
        [&](const Position& from, const Position& to, double angle) {
          boundary.add_arc(from, to, angle);
        });
    return boundary.measures();
  }

  // Brings the pieces of all parts into the order of ids.
  void collect_pieces()
  {
    if (!m_has_pieces)
      return m_first_pieces.assign(m_areas.size() + 1, 0);
    m_first_pieces.push_back(0);
    for (const Source& source : m_sources) {
      if (source.pieces > 0) {
        const auto first = m_parts[source.part].pieces.begin() + std::ptrdiff_t(source.first_piece);
        m_pieces.insert(m_pieces.end(), first, first + std::ptrdiff_t(source.pieces));
      }
      m_first_pieces.push_back(m_pieces.size());
    }
  }

  // Divides areas among points that coincide, and copies all measures to duplicates.
  template <class Space>
  void share_areas(const Space& space)
  {
    const auto representative = [&](size_type id) { return space.id_of_cell(space.cell(id)); };
    m_sharers.assign(space.number_of_ids(), 1);
    space.for_each_duplicate([&](size_type id) { ++m_sharers[representative(id)]; });
    for (size_type id = 0; id < m_areas.size(); ++id)
      m_areas[id] /= m_sharers[id];
    space.for_each_duplicate([&](size_type id) {
      const size_type its_representative = representative(id);
      for (std::vector<double>* measures :
           {&m_areas, &m_perimeters, &m_wall_lengths, &m_free_lengths})
        (*measures)[id] = (*measures)[its_representative];
      m_centroids[id] = m_centroids[its_representative];
    });
  }

private:
  std::vector<Position> m_domain;  // its corners, or none
  std::vector<Position> m_normals; // of the walls, outward
  Surroundings m_surroundings;
  std::vector<double> m_radii, m_areas, m_perimeters, m_wall_lengths, m_free_lengths;
  std::vector<Position> m_centroids;
  std::vector<Piece> m_pieces;
  std::vector<size_type> m_first_pieces;
  bool m_has_pieces = true;
  std::vector<double> m_sharers; // the number of points that share the cell, by representative

protected:
  std::vector<Source> m_sources; // of each id
  std::deque<Part> m_parts;
  /// \endcond
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_CELLS_2_H
