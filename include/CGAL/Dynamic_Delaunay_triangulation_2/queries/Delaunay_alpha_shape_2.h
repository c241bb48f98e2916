// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_ALPHA_SHAPE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_ALPHA_SHAPE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Exact_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Rounded_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Tests exactly whether the smallest circles through faces and edges have at most a given radius.
template <class Dynamic>
class Radius_test_2
{
  using Arrays = Halfedge_arrays_2;
  using State = State_of_2<Dynamic>;
  using Site = typename State::Site;
  using Geometry = Site_geometry_2<State>;
  using Exact = typename Geometry::Exact;
  using Vector = Exact_vector_2<Exact>;
  static_assert(Geometry::has_euclidean_circles,
                "these traits have circles of their own, and areas are those of Euclidean ones");

public:
  // `square` is that of the radius. Throws unless the triangulation is certified, and if the square
  // is negative or not finite.
  template <class FT>
  Radius_test_2(const Dynamic& dt, const FT& square)
    : m_geometry(certified_state(dt))
    , m_square(CGAL::to_double(square))
    , m_exact_square(Exact_number_2<FT>::of(checked(square)))
    , m_is_rounded(m_exact_square != Exact(m_square))
  {
  }

  // Whether the face is not outside, and its circle is small enough.
  bool has_face(Face_index f) const
  {
    if (is_outside(m_geometry, f))
      return false;
    const std::array<Site, 3> corners = corners_at(Arrays::halfedge_in(f, 0));
    const Rounded_face_2 face(m_geometry, corners[0], corners[1], corners[2]);
    const double excess = face.squared_radius() - m_square;
    if (!m_is_rounded && std::abs(excess) > 1.1 * face.error_of_squared_radius())
      return excess < 0;
    return has_face_exactly(corners);
  }

  // Whether the edge is not outside, and the circle on it as a diameter is small enough and without
  // a point inside.
  bool has_edge(Halfedge_index h) const
  {
    const auto [apex, source, target] = corners_at(h);
    return m_geometry.are_inside(source, target) && is_short(source, target) && !is_attached(h) &&
           !is_attached(state().arrays().twin(h));
  }

private:
  template <class FT>
  static const FT& checked(const FT& square)
  {
    check_extent("the squared radius", CGAL::to_double(square));
    return square;
  }

  const State& state() const { return m_geometry.state(); }

  // The corners of the half-edge's face: the apex of the half-edge, its source and its target.
  std::array<Site, 3> corners_at(Halfedge_index h) const
  {
    const auto chart = state().chart_at(h);
    return {state().site_in(h, chart), state().site_in(Arrays::next(h), chart),
            state().site_in(Arrays::previous(h), chart)};
  }

  // Whether a^2 b^2 c^2 <= 4 D^2 square, for the sides and the doubled area D of the face.
  BOOST_NOINLINE bool has_face_exactly(const std::array<Site, 3>& corners) const
  {
    const Vector a = m_geometry.exact_vector(corners[0], corners[1]);
    const Vector b = m_geometry.exact_vector(corners[1], corners[2]);
    const Vector c = m_geometry.exact_vector(corners[2], corners[0]);
    const Exact doubled_area = cross(a, b);
    return Exact(dot(a, a) * dot(b, b) * dot(c, c)) <=
           Exact(Exact(4) * doubled_area * doubled_area * m_exact_square);
  }

  bool is_short(const Site& source, const Site& target) const
  {
    double e = 0;
    const Position_2 v = m_geometry.vector(source, target, e);
    const double excess = dot(v, v) - 4 * m_square;
    if (!m_is_rounded && std::abs(excess) > error_of_product(v, v, e))
      return excess < 0;
    const Vector exact = m_geometry.exact_vector(source, target);
    return dot(exact, exact) <= Exact(Exact(4) * m_exact_square);
  }

  // Whether the apex is inside of the circle on the half-edge as a diameter: then the angle at the
  // apex is obtuse. False if the face is outside.
  bool is_attached(Halfedge_index h) const
  {
    if (is_outside(m_geometry, Arrays::face_of(h)))
      return false;
    const auto [apex, source, target] = corners_at(h);
    double e = 0;
    const Position_2 v = m_geometry.vector(apex, source, e), w = m_geometry.vector(apex, target, e);
    const double product = dot(v, w);
    if (std::abs(product) > error_of_product(v, w, e))
      return product < 0;
    return dot(m_geometry.exact_vector(apex, source), m_geometry.exact_vector(apex, target)) <
           Exact(0);
  }

  const Geometry m_geometry;
  const double m_square;
  const Exact m_exact_square;
  const bool m_is_rounded;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The alpha shape of the points for one alpha, a squared radius: the part of the triangulation that
remains when a disc of that radius erases everything it can reach without covering a point. Each
face, edge and point has the class that `Alpha_shape_2` gives it in its general mode. The points may
be in the plane, in a periodic cell or in a slab:

- `EXTERIOR`: not in the alpha complex.
- `SINGULAR`: in the complex, and in the boundary of the shape, but at no face of the complex.
- `REGULAR`: in the boundary of the shape, and at a face of the complex.
- `INTERIOR`: in the complex, and not in the boundary.

A face is in the complex, and `INTERIOR`, if the square of its circumradius is alpha or less. An
edge without such a face is `SINGULAR` if the circle on it as a diameter has no point inside, and no
larger squared radius than alpha. A point without such a face is `SINGULAR`. The shape in the
regularized mode consists of the elements that are `REGULAR` or `INTERIOR`.

All classes are exact: they are decided in doubles with bounds on the errors, and without rounding
where these bounds do not suffice. The shape does not depend on which diagonals the triangulation
has between cocircular points, but such a diagonal itself is `INTERIOR` or `EXTERIOR`.

Edges and faces have the numbers that they have in `Dynamic_frame_2`, which change with the
triangulation. The triangulation must be certified. An object keeps its memory.

`Bounded_voronoi_surface_2` has the boundary of the union of the discs as lines: the cells along
them are those of the points that are not `INTERIOR`.

\sa `Bounded_voronoi_surface_2`
*/
class Delaunay_alpha_shape_2
{
public:
  /// \name Types
  /// @{

  /// the class of a face, an edge or a point.
  enum class Classification_type : unsigned char { EXTERIOR, SINGULAR, REGULAR, INTERIOR };
  /// of all elements of a kind, by their numbers.
  using Classes = std::vector<Classification_type>;

  /// @}
  /// \name Computation
  /// @{

  /// classifies all faces, edges and points. Cost: linear, three passes, which threads share if the
  /// triangulation has the `Parallel_tag`.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_2` whose circles are Euclidean, or a
  ///   `Dynamic_periodic_Delaunay_triangulation_2`.
  /// \tparam FT the number type of its coordinates.
  /// \throws Uncertified_triangulation_error_2 unless the triangulation is certified.
  /// \throws Parameter_error_2 if alpha is negative or not a finite number.
  template <class Dynamic, class FT>
  void compute(const Dynamic& dt, const FT& alpha)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Default_floating_point floating_point;
    const Radius_test_2<Dynamic> test(dt, alpha);
    classify_faces(dt, test);
    classify_edges(dt, test);
    classify_points(dt);
  }

  /// @}
  /// \name Access
  /// @{

  /// the classes of the faces: `INTERIOR` or `EXTERIOR`, also for those at the infinite vertex or
  /// beside a slab. Empty if the points do not span the plane.
  const Classes& faces() const { return m_faces; }
  /// the classes of the edges. Empty if the points do not span the plane.
  const Classes& edges() const { return m_edges; }
  /// the classes of the points, by their ids. Points that coincide have the same one; removed ids
  /// are `EXTERIOR`.
  const Classes& points() const { return m_points; }

  /// @}

private:
  using Arrays = Dynamic_Delaunay_triangulations_2::internal::Halfedge_arrays_2;
  static constexpr auto EXTERIOR = Classification_type::EXTERIOR;
  static constexpr auto SINGULAR = Classification_type::SINGULAR;
  static constexpr auto REGULAR = Classification_type::REGULAR;
  static constexpr auto INTERIOR = Classification_type::INTERIOR;

  // Returns the class of an edge or a point, by whether some of its faces are in the complex, some
  // are not, and whether it is in the complex without them.
  static Classification_type at_faces(bool some_are_in, bool some_are_out, bool is_alone)
  {
    return some_are_in ? some_are_out ? REGULAR : INTERIOR : is_alone ? SINGULAR : EXTERIOR;
  }

  // Calls f(i) for all numbers i of one kind below `size`.
  template <class Index_of_kind, class Dynamic, class Function>
  static void for_each(std::size_t size, const Function& f)
  {
    Dynamic::Frame::Parts::for_each(size, [&](std::size_t, std::size_t i, std::size_t beyond) {
      for (; i < beyond; ++i)
        f(Index_of_kind(i));
    });
  }

  template <class Dynamic, class Test>
  void classify_faces(const Dynamic& dt, const Test& test)
  {
    m_faces.resize(dt.frame().number_of_faces());
    for_each<typename Dynamic::Frame::Face_index, Dynamic>(
        m_faces.size(), [&](auto f) { m_faces[f] = test.has_face(f) ? INTERIOR : EXTERIOR; });
  }

  template <class Dynamic, class Test>
  void classify_edges(const Dynamic& dt, const Test& test)
  {
    const Arrays& arrays = dt.frame().state().arrays();
    m_edges.resize(dt.frame().number_of_edges());
    for_each<typename Dynamic::Frame::Edge_index, Dynamic>(m_edges.size(), [&](auto e) {
      const auto h = arrays.halfedge(e);
      const bool is_left = m_faces[Arrays::face_of(h)] == INTERIOR;
      const bool is_right = m_faces[Arrays::face_of(arrays.twin(h))] == INTERIOR;
      m_edges[e] = at_faces(is_left || is_right, !is_left || !is_right,
                            !is_left && !is_right && test.has_edge(h));
    });
  }

  template <class Dynamic>
  void classify_points(const Dynamic& dt)
  {
    const auto frame = dt.frame();
    const Arrays& arrays = frame.state().arrays();
    m_points.assign(frame.number_of_ids(), EXTERIOR);
    using Vertex_index = typename Dynamic::Frame::Vertex_index;
    for_each<Vertex_index, Dynamic>(frame.number_of_vertices(), [&](auto i) {
      const Vertex_index v = i + 1; // the infinite vertex has no point
      bool some_are_in = false, some_are_out = false;
      if (!m_faces.empty())
        arrays.for_each_corner(v, [&](auto h) {
          const bool is_in = m_faces[Arrays::face_of(h)] == INTERIOR;
          some_are_in = some_are_in || is_in;
          some_are_out = some_are_out || !is_in;
        });
      m_points[frame.id(v)] = at_faces(some_are_in, some_are_out, true);
    });
    frame.for_each_duplicate([&](auto id) { m_points[id] = m_points[frame.id(frame.vertex(id))]; });
  }

  Classes m_faces, m_edges, m_points;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_ALPHA_SHAPE_2_H
