// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_SPACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_SPACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The other end of an edge, as seen from a point.
struct Voronoi_neighbor_2
{
  std::size_t id;
  Periodic_shift_2 shift; // 0 in the plane
  Position_2 vector;
  double error; // of its coordinates, as Voronoi_face_2 takes it
};

// A triangulation as Voronoi cells see it, in the plane and in periodic space. Cells are numbered
// as vertices are, in an order of space; points that coincide share one. Not every number is that
// of a cell. A cell is open, and so unbounded, if an edge at its point has a single face, or none.
template <class Dynamic>
class Voronoi_space_2
{
  using Frame = typename Dynamic::Frame;
  using Parts = typename Frame::Parts;
  using Arrays = Halfedge_arrays_2;
  using State = State_of_2<Dynamic>;
  using Site = typename State::Site;
  using Geometry = Site_geometry_2<State>;
  static_assert(Geometry::has_euclidean_circles,
                "these traits have circles of their own, and Voronoi cells are computed for the "
                "Euclidean ones");

public:
  static constexpr bool can_have_walls = Geometry::can_have_walls;
  template <class Function>
  static void show(const Periodic_shift_2& shift, const Function& f)
  {
    Geometry::show(shift, f);
  }

  // Throws unless the triangulation is certified.
  explicit Voronoi_space_2(const Dynamic& dt)
    : m_geometry(certified_state(dt))
    , m_frame(dt.frame())
    , m_cells_of_part(number_of_cells() / number_of_face_parts() + 1)
  {
  }

  Index number_of_ids() const { return m_frame.number_of_ids(); }
  bool has_id(std::size_t id) const { return m_frame.has_id(id); }
  bool is_representative(std::size_t id) const { return m_frame.id(m_frame.vertex(id)) == id; }
  Index number_of_cells() const { return m_frame.number_of_vertices() + 1; }
  Index cell(std::size_t id) const { return m_frame.vertex(id); }
  bool is_cell(Index c) const { return !m_frame.is_infinite(Vertex_index(c)); }
  std::size_t id_of_cell(Index c) const { return m_frame.id(Vertex_index(c)); }

  // Fetches what `cell(id)` reads.
  void prefetch(std::size_t id) const { state().ids().prefetch(Point_id(id)); }
  // Before every eighth cell, fetches the stars of the next eight, but none from `beyond` on.
  void prefetch_stars(Index c, Index beyond) const
  {
    const auto vertex = [](std::size_t i) { return Vertex_index(i == 0 ? 1 : i); }; // 0: no cell
    if (state().spans_plane())
      internal::prefetch_stars(state(), c, beyond, vertex);
  }

  // As the point was given: in periodic space duplicates may be given by other images.
  Position_2 position(std::size_t id) const { return m_geometry.given_position(Point_id(id)); }
  // From a point to an image of another one.
  Position_2 vector(std::size_t id, std::size_t other, const Periodic_shift_2& shift) const
  {
    double ignored = 0;
    return m_geometry.cell_vector(site(id), site(other, shift), ignored);
  }

  template <class Function>
  void for_each_duplicate(const Function& f) const
  {
    state().ids().for_each_covered([&](auto id, const auto&...) { f(id); });
  }

  // Calls f(number, first, beyond) for parts of the ids, or of the cells.
  static std::size_t number_of_ranges(std::size_t size) { return Parts::number(size); }
  template <class Function>
  static void for_each_range(std::size_t size, const Function& f)
  {
    Parts::for_each(size, [&](std::size_t number, std::size_t first, std::size_t beyond) {
      f(number, Index(first), Index(beyond));
    });
  }

  // Threads share the parts of the faces. Each part has some of the cells, most of them around its
  // own faces.
  std::size_t number_of_face_parts() const
  {
    return Parts::number(m_frame.number_of_faces(), faces_of_part());
  }
  bool has_cell(std::size_t part, Index c) const
  {
    return c - part * m_cells_of_part < m_cells_of_part; // unsigned: false if c is smaller
  }

  // Calls f(part, cells, face).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    if (state().spans_plane())
      Parts::for_each(m_frame.number_of_faces(), faces_of_part(),
                      [&](std::size_t part, std::size_t first, std::size_t beyond) {
                        for (std::size_t i = first; i < beyond; ++i)
                          call_with_face(part, Face_index(i), f);
                      });
  }

  // Cells beside the gap of a slab are open, those of a torus are all closed.
  template <class Function>
  void for_each_open_cell(const Function& f) const
  {
    m_geometry.for_each_vertex_at_border(f);
  }

  // Calls f(neighbor) counterclockwise.
  template <class Function>
  void for_each_neighbor(std::size_t id, const Function& f) const
  {
    const Site v = site(id);
    internal::for_each_neighbor(m_geometry, v, [&](const Site& w) {
      double error = 0;
      const Position_2 vector = m_geometry.cell_vector(v, w, error);
      f(Voronoi_neighbor_2{m_frame.id(State::vertex_of(w)), m_geometry.shift(w), vector, error});
    });
  }

  // Returns the face of a point and two neighbors, the second one left of the first, if any. Where
  // the cell is open, the angle between the neighbors is at least straight, so they make no face.
  std::optional<Voronoi_face_2> face(const Voronoi_neighbor_2& right,
                                     const Voronoi_neighbor_2& left) const
  {
    double error = (std::max)(right.error, left.error);
    const Position_2 side =
        m_geometry.cell_vector(site(right.id, right.shift), site(left.id, left.shift), error);
    const Voronoi_face_2 face({side, {-left.vector.x, -left.vector.y}, right.vector}, error);
    return face.is_flat() ? std::nullopt : std::optional<Voronoi_face_2>(face);
  }

private:
  // Fewer and larger parts have fewer faces between them.
  std::size_t faces_of_part() const
  {
    constexpr std::size_t max_parts = 32;
    return (std::max)(Parts::usual_size, std::size_t(m_frame.number_of_faces()) / max_parts);
  }

  template <class Function>
  BOOST_FORCEINLINE void call_with_face(std::size_t part, Face_index i, const Function& f) const
  {
    const Halfedge_index first = Arrays::halfedge_in(i, 0);
    const auto chart = state().chart_at(first);
    const Site a = state().site_in(first, chart), b = state().site_in(first + 1, chart),
               c = state().site_in(first + 2, chart);
    if (!m_geometry.are_inside(a, b) || !m_geometry.are_inside(a, c))
      return;
    double error = 0;
    const std::array<Position_2, 3> sides{m_geometry.cell_vector(b, c, error),
                                          m_geometry.cell_vector(c, a, error),
                                          m_geometry.cell_vector(a, b, error)};
    f(part, state().arrays().face(i), Voronoi_face_2(sides, error));
  }

  const State& state() const { return m_geometry.state(); }
  // A point, and an image of it.
  Site site(std::size_t id) const { return State::site_of(m_frame.vertex(id)); }
  Site site(std::size_t id, const Periodic_shift_2& shift) const
  {
    return m_geometry.neighbor(site(id), m_frame.vertex(id), shift);
  }

  const Geometry m_geometry;
  const Frame m_frame;
  const std::size_t m_cells_of_part;
};

// FACES AROUND A POINT ----------------------------------------------------------------------------

// Calls f(right, left, face) for each two consecutive neighbors of a point, counterclockwise. There
// is no face where the cell is open, or where rounding hides how flat the face is.
template <class Space, class Function>
void for_each_face_around(const Space& space, std::size_t id, const Function& f)
{
  std::optional<Voronoi_neighbor_2> first, last;
  space.for_each_neighbor(id, [&](const Voronoi_neighbor_2& next) {
    if (last)
      f(*last, next, space.face(*last, next));
    else
      first = next;
    last = next;
  });
  if (last)
    f(*last, *first, space.face(*last, *first));
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_SPACE_2_H
