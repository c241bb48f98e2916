// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_ALPHA_SHAPE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_ALPHA_SHAPE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Radius_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <cstddef>
#include <vector>

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
    const Default_floating_point_2 floating_point;
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

  // Calls f(i) for all numbers below `size`.
  template <class Dynamic, class Function>
  static void for_each(std::size_t size, const Function& f)
  {
    Dynamic::Frame::Parts::for_each(size, [&](std::size_t, std::size_t i, std::size_t beyond) {
      for (; i < beyond; ++i)
        f(Dynamic_Delaunay_triangulations_2::Index(i));
    });
  }

  template <class Dynamic, class Test>
  void classify_faces(const Dynamic& dt, const Test& test)
  {
    m_faces.resize(dt.frame().number_of_faces());
    for_each<Dynamic>(m_faces.size(),
                      [&](auto f) { m_faces[f] = test.has_face(f) ? INTERIOR : EXTERIOR; });
  }

  template <class Dynamic, class Test>
  void classify_edges(const Dynamic& dt, const Test& test)
  {
    const Arrays& arrays = dt.frame().state().arrays();
    m_edges.resize(dt.frame().number_of_edges());
    for_each<Dynamic>(m_edges.size(), [&](auto e) {
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
    for_each<Dynamic>(frame.number_of_vertices(), [&](auto i) {
      bool some_are_in = false, some_are_out = false;
      if (!m_faces.empty())
        arrays.for_each_corner(i + 1, [&](auto h) {
          const bool is_in = m_faces[Arrays::face_of(h)] == INTERIOR;
          some_are_in = some_are_in || is_in;
          some_are_out = some_are_out || !is_in;
        });
      m_points[frame.id(i + 1)] = at_faces(some_are_in, some_are_out, true);
    });
    frame.for_each_duplicate([&](auto id) { m_points[id] = m_points[frame.id(frame.vertex(id))]; });
  }

  Classes m_faces, m_edges, m_points;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_ALPHA_SHAPE_2_H
