// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_triangulation_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_editing_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Reinsertion_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>
#include <CGAL/iterator.h>
#include <CGAL/Periodic_cell_2.h>
#include <CGAL/tags.h>

#include <array>
#include <iterator>
#include <string_view>

namespace CGAL {

template <class Kernel, class Classifier, class... Options>
class Dynamic_periodic_Delaunay_triangulation_2;

namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

template <class Kernel, class ChosenClassifier, class... Options>
struct Triangulation_types_2<
    Dynamic_periodic_Delaunay_triangulation_2<Kernel, ChosenClassifier, Options...>>
  : Chosen_types_2<ChosenClassifier, Options...>
{
  static_assert(number_of_options<With_data_structure_2, Options...> == 0,
                "With_data_structure_2<> is an option of triangulations in the plane only");
  static_assert(has_double_coordinates<typename Kernel::Point_2>,
                "the coordinates of points in periodic space must be of type double");

  using Geom_traits = Kernel;
  using State = Triangulation_state_2<Torus_space_2<typename Kernel::Point_2>,
                                      typename Triangulation_types_2::Concurrency_tag>;
  using Input = Periodic_input_2<State>;
  using Checkpoint = Checkpoint_torus_2<State>;
  static constexpr std::string_view checkpoint_subject =
      "Dynamic_periodic_Delaunay_triangulation_2";
  static constexpr bool is_exact = true; // the predicates are the package's own
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The Delaunay triangulation of points that move in a periodic space: a plane in which everything is
repeated by the vectors of a `Periodic_cell_2`, that is, a flat torus. The cell may be any
parallelogram, and may change with every frame.

Points may be given anywhere in the plane, wrapped into the cell or not. The images p + i a + j b of
a point p, for integers i and j, are triangulated as real numbers, and never rounded. There is one
sheet: n points in different places have 3n edges and 2n faces, however few they are. So a point can
be a neighbor of its own images, and two points can have several edges.

In a slab, which is periodic in one direction and open in the other, the faces fill the strip
between the outermost points. It has fewer edges and faces, and no face if all points are on one
line along the slab.

Points have ids as in `Dynamic_Delaunay_triangulation_2`: the i-th point of the range has id i, and
points that are inserted get the smallest free ids. Points that coincide, also by a translation of
the lattice, share a vertex.

After construction, and after every call with an exact classifier, the triangulation is
<em>certified</em>: exact predicates have proved that each face is counterclockwise, and that each
edge is locally Delaunay. Under flips, insertions and removals the faces go on covering the torus
exactly once (see the manual). By default an update tests all edges except those that are proved
safe, and mends around the broken ones, or rebuilds if that costs less. A frame with a heuristic
classifier leaves the triangulation uncertified, unless the repair had to examine everything or to
rebuild. An uncertified triangulation is still a torus of 3n edges and 2n faces, and the next call
that inserts, removes or moves single points makes it Delaunay first.

Classifiers, repairs and policies are the same as in the plane; `Dynamic_frame_2` and
`Dynamic_mender_2` say what differs for them.

\tparam Kernel a CGAL kernel whose points have coordinates of type `double`, such as
  `Exact_predicates_inexact_constructions_kernel`.
\tparam Classifier a model of `DelaunayClassifier_2`; `Default` for `Circumcircle_classifier_2`.
\tparam Options as those of `Dynamic_Delaunay_triangulation_2`, in any order, each at most once:
  `With_repair_2`, `With_policy_2`, `With_concurrency_2`, and `With_visitor_2` of a model of
  `PeriodicUpdateVisitor_2`, which is told of all changes of edges.
*/
template <class Kernel, class Classifier = Circumcircle_classifier_2, class... Options>
class Dynamic_periodic_Delaunay_triangulation_2
  : public Dynamic_triangulation_base_2<
        Dynamic_periodic_Delaunay_triangulation_2<Kernel, Classifier, Options...>>
{
  using Base = Dynamic_triangulation_base_2<Dynamic_periodic_Delaunay_triangulation_2>;
  friend Dynamic_Delaunay_triangulations_2::internal::Triangulation_access;
  using Arrays = Dynamic_Delaunay_triangulations_2::internal::Halfedge_arrays_2;
  using typename Base::Edge_index;
  using typename Base::Face_index;
  using typename Base::Floating_point;
  using typename Base::Halfedge_index;
  using typename Base::Identity_map;
  using typename Base::Point_id;
  template <class Range>
  using If_range = typename Base::template If_range<Range>;
  template <class Map>
  using If_map = typename Base::template If_map<Map>;
  using Base::m_core;

public:
  /// \name Types
  /// @{

  using typename Base::Delaunay_classifier;
  using typename Base::Point;
  using typename Base::Settings;
  using typename Base::size_type;
  /// a vector.
  using Vector = typename Kernel::Vector_2;
  /// the visitor.
  using Periodic_update_visitor = typename Base::Update_visitor;

  /// @}
  /// \name Creation
  /// @{

  /// creates an empty triangulation of the torus with this cell, and with these settings, which may
  /// be a classifier alone.
  /// \throws Periodic_cell_error_2 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it.
  explicit Dynamic_periodic_Delaunay_triangulation_2(const Periodic_cell_2& cell,
                                                     const Settings& settings = Settings())
    : Base(settings, checked(cell))
  {
  }

  /// triangulates the points of the range; the i-th one has id i. Cost: O(n log n).
  /// \tparam InputIterator its values are convertible to `Point`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_2 if a point is 2<sup>20</sup> cells or more from the origin.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow.
  /// \throws Periodic_cell_error_2 as above.
  template <class InputIterator>
  Dynamic_periodic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                            const Periodic_cell_2& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_2(cell, settings)
  {
    this->insert(first, beyond);
  }

  /// triangulates the points that `point_map` reads from the values of the range.
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`.
  template <class InputIterator, class PointMap, class = If_map<PointMap>>
  Dynamic_periodic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                            PointMap point_map, const Periodic_cell_2& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_2(cell, settings)
  {
    this->insert(first, beyond, point_map, Emptyset_iterator());
  }

  /// triangulates the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Dynamic_periodic_Delaunay_triangulation_2(const Range& range, const Periodic_cell_2& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_2(std::begin(range), std::end(range), cell, settings)
  {
  }

  /// triangulates the points that `point_map` reads from a range with `begin()` and `end()`.
  template <class Range, class PointMap, class = If_range<Range>, class = If_map<PointMap>>
  Dynamic_periodic_Delaunay_triangulation_2(const Range& range, PointMap point_map,
                                            const Periodic_cell_2& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_2(std::begin(range), std::end(range), point_map, cell,
                                                settings)
  {
  }

  /// @}
  /// \name Motion
  /// @{

  using Base::update;

  /// moves the points as `update(first, beyond)` does, in a cell that has changed since the last
  /// call: by deformation, by other vectors for the same lattice, as when a sheared cell is
  /// flipped, or by both.
  /// \throws Periodic_cell_error_2 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it, or if only one of this cell and the last one is a slab; else what
  /// `update(first, beyond)` throws. Nothing has changed then.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond, const Periodic_cell_2& cell)
  {
    return update(first, beyond, Identity_map(), cell);
  }

  /// takes the positions from a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_2 update(const Range& points, const Periodic_cell_2& cell)
  {
    return update(std::begin(points), std::end(points), cell);
  }

  /// reads the positions from the values of the range by `point_map`.
  template <class InputIterator, class PointMap, class = If_map<PointMap>>
  Update_report_2 update(InputIterator first, InputIterator beyond, PointMap point_map,
                         const Periodic_cell_2& cell)
  {
    const Floating_point floating_point;
    m_core->input.stage(first, beyond, point_map, cell);
    return this->run_frame();
  }

  /// reads the positions by `point_map` from the values of a range with `begin()` and `end()`.
  template <class Range, class PointMap, class = If_range<Range>, class = If_map<PointMap>>
  Update_report_2 update(const Range& range, PointMap point_map, const Periodic_cell_2& cell)
  {
    return update(std::begin(range), std::end(range), point_map, cell);
  }

  /// @}
  /// \name Access
  /// @{

  /// the cell of the last frame.
  const Periodic_cell_2& cell() const { return m_core->state.torus().cell(); }
  /// the number of edges: three for each vertex; fewer in a slab, where counting them takes a pass.
  size_type number_of_edges() const
  {
    if (!cell().is_slab())
      return 3 * this->number_of_vertices();
    size_type edges = 0;
    for_each_edge([&](size_type, size_type, const Periodic_shift_2&) { ++edges; });
    return edges;
  }
  /// the number of faces: two for each vertex; fewer in a slab, where counting them takes a pass.
  size_type number_of_faces() const
  {
    if (!cell().is_slab())
      return 2 * this->number_of_vertices();
    size_type faces = 0;
    for (Face_index f(0); f < m_core->state.arrays().number_of_faces(); ++f)
      faces += !m_core->state.is_in_gap(f);
    return faces;
  }
  /// the point with this id, as it was given last. \throws Unknown_id_error_2
  Point point(size_type id) const
  {
    this->vertex_of(id); // throws if no point has this id
    return m_core->state.point_of_id(Point_id(id));
  }

  /// the vector from point i to the image of point j by `shift`, rounded.
  /// \throws Unknown_id_error_2 if no point has one of these ids.
  Vector vector(size_type i, size_type j, const Periodic_shift_2& shift) const
  {
    const Point p = point(i), q = point(j);
    return Vector(q.x() - p.x() + (shift[0] * cell().ax() + shift[1] * cell().bx()),
                  q.y() - p.y() + (shift[0] * cell().ay() + shift[1] * cell().by()));
  }

  /// calls `f(i, j, shift)` once for each edge: the image of point j by `shift`, at `point(j)` plus
  /// `shift[0]` times the cell's first vector plus `shift[1]` times its second one, is a neighbor
  /// of point i. Where points share a vertex, only their representative has edges.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    const auto& state = m_core->state;
    for (Edge_index e(0); e < state.arrays().number_of_edges(); ++e) {
      const Halfedge_index h = state.arrays().halfedge(e);
      const Halfedge_index from = Arrays::next(h), to = Arrays::previous(h);
      if (!state.are_across(from, to))
        f(size_type(state.id_at(from)), size_type(state.id_at(to)), state.shift_between(from, to));
    }
  }

  /// calls `f(i, j, shift)` once for each edge of the two sides of a slab's boundary; on the way
  /// from point i to point j, the strip is on the left. If all points are on one line, each edge is
  /// visited in both directions. A torus has no boundary.
  template <class Function>
  void for_each_boundary_edge(const Function& f) const
  {
    const auto& state = m_core->state;
    for (Halfedge_index h(0); h < state.arrays().number_of_halfedges(); ++h) {
      const Halfedge_index from = Arrays::previous(h), to = Arrays::next(h);
      if (state.is_in_gap(Arrays::face_of(h)) && !state.are_across(from, to))
        f(size_type(state.id_at(from)), size_type(state.id_at(to)), state.shift_between(from, to));
    }
  }

  /// calls `f(ids, shifts)` once for each face, with arrays of three ids and three shifts: the
  /// images of these points are the corners of a counterclockwise triangle. The first shift is (0,
  /// 0).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    const auto& state = m_core->state;
    for (Halfedge_index h(0); h < state.arrays().number_of_halfedges(); h += 3)
      if (!state.is_in_gap(Arrays::face_of(h)))
        f(std::array<size_type, 3>{state.id_at(h), state.id_at(h + 1), state.id_at(h + 2)},
          std::array<Periodic_shift_2, 3>{state.shift_between(h, h), state.shift_between(h, h + 1),
                                          state.shift_between(h, h + 2)});
  }

  /// @}

private:
  // A function of a point and its place in a frame, which throws if the
  // position is not allowed. While it lives, floating-point arithmetic is in its default state.
  class Position_check
  {
  public:
    explicit Position_check(const Periodic_cell_2& cell)
      : m_torus(cell)
    {
    }
    void operator()(const Point& p, size_type place) const
    {
      Dynamic_Delaunay_triangulations_2::internal::checked_position(p, place, m_torus);
    }

  private:
    Floating_point m_floating_point;
    Dynamic_Delaunay_triangulations_2::internal::Torus_2 m_torus;
  };
  Position_check position_check() const { return Position_check(cell()); }
  Position_check position_check(const Periodic_cell_2& next) const
  {
    const Floating_point floating_point;
    m_core->input.check_next(next);
    return Position_check(next);
  }

  static const Periodic_cell_2& checked(const Periodic_cell_2& cell)
  {
    const Floating_point floating_point;
    Dynamic_Delaunay_triangulations_2::internal::check_cell(cell);
    return cell;
  }
};

CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE(Dynamic_periodic_Delaunay_triangulation_2)

} // namespace CGAL

#endif // CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
