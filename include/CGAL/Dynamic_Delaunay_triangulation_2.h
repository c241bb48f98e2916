// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Default.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_triangulation_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_plane_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Validity_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Plane_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Plane_editing_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Plane_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/accepts_inexact_predicates_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Indexed_triangulation_data_structure_2.h>
#include <CGAL/tags.h>

#include <array>
#include <iterator>
#include <string>
#include <string_view>

namespace CGAL {

template <class Traits, class Classifier, class... Options>
class Dynamic_Delaunay_triangulation_2;

namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

template <class Traits, class ChosenClassifier, class... Options>
struct Triangulation_types_2<Dynamic_Delaunay_triangulation_2<Traits, ChosenClassifier, Options...>>
  : Chosen_types_2<ChosenClassifier, Options...>
{
  static constexpr bool is_exact = !Are_known_to_be_inexact_2<Traits>::value;
  static_assert(is_exact || accepts_inexact_predicates_2<Traits>,
                "the predicates of these traits are rounded, so nothing could be certified: take "
                "Exact_predicates_inexact_constructions_kernel, or see "
                "accepts_inexact_predicates_2");

  using Geom_traits = Traits;
  using Tds = typename Option_2<With_data_structure_2,
                                Indexed_triangulation_data_structure_2<Traits>, Options...>::type;
  using State = Triangulation_state_2<Plane_space_2<Traits, Tds>,
                                      typename Triangulation_types_2::Concurrency_tag>;
  using Input = Input_frame_2<State>;
  using Checkpoint = Checkpoint_plane_2<State>;
  static constexpr std::string_view checkpoint_subject = "Dynamic_Delaunay_triangulation_2";
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Maintains the Delaunay triangulation of moving points. Every `update()` takes the new positions of
all points, finds what the motion broke, repairs it, and reports what it did.

Points have ids: 0, 1, 2, ... in the order in which they are given. An id keeps its vertex through
all updates, unless its point coincides with another one: points share a vertex as long as they
coincide. `insert()` adds points, and `remove()` removes them. The id of a removed point is free,
and the next point that is inserted gets the smallest free id. `Dynamic_population_2` is for ids
that the user chooses. Handles of vertices and faces hold indices: they are valid until the next
call that changes the triangulation.

After construction, and after every update with an exact classifier, the triangulation is
<em>certified</em>: exact predicates have proved that its faces are counterclockwise, that its hull
is convex and turns around once, and that each of its edges is locally Delaunay. An update with a
heuristic classifier leaves it uncertified, unless that update rebuilds it. An uncertified
triangulation is still a valid triangulated sphere with all its vertices.

\tparam Traits a model of `DynamicDelaunayTraits_2`: a CGAL kernel with exact predicates, such as
  `Exact_predicates_inexact_constructions_kernel`, or `Projection_traits_xy_3` of one.
\tparam Classifier a model of `DelaunayClassifier_2`, which finds the edges that may be broken;
  `Default` for `Circumcircle_classifier_2`.
\tparam Options any of these, in any order, each at most once:
  - `With_repair_2<Repair>`: a model of `DelaunayRepair_2`, which repairs what the classifier found.
    Without it, the classifier's `Usual_repair` if it has one; else `Hold_and_flip_repair_2` if the
    classifier is exact, `Border_splice_repair_2` if it is not, and `Repair_by_exactness_2` if that
    is known only while a program runs.
  - `With_data_structure_2<Tds>`: an `Indexed_triangulation_data_structure_2` of these traits.
    Without it, one that has no data of the user. Data that the user stores in a vertex stay in it.
    The vertices of a face change; a visitor is told when.
  - `With_policy_2<Policy>`: a model of `DelaunayUpdatePolicy_2`, which chooses the frames that are
    rebuilt. Without it, `Always_dynamic_policy_2`.
  - `With_visitor_2<Visitor>`: a model of `DelaunayUpdateVisitor_2`, which is told what changes.
    Without it, `Delaunay_update_visitor_base_2`, which ignores all calls.
  - `With_concurrency_2<Tag>`: `Sequential_tag`, as without it, or `Parallel_tag`, which needs TBB:
    with it, the threads of the TBB arena in which a function is called share its passes over many
    points, edges or faces (\ref DynamicDelaunaySubsection_Threads). The threads use iterators of
    random-access ranges, and property maps of points, at the same time. No result depends on the
    tag.
*/
template <class Traits, class Classifier = Circumcircle_classifier_2, class... Options>
class Dynamic_Delaunay_triangulation_2
  : public Dynamic_triangulation_base_2<
        Dynamic_Delaunay_triangulation_2<Traits, Classifier, Options...>>
{
  using Base = Dynamic_triangulation_base_2<Dynamic_Delaunay_triangulation_2>;
  friend Dynamic_Delaunay_triangulations_2::internal::Triangulation_access;
  using typename Base::Face_index;
  using typename Base::Point_id;
  using typename Base::State;
  using typename Base::Vertex_index;
  template <class Range>
  using If_range = typename Base::template If_range<Range>;
  template <class Map>
  using If_map = typename Base::template If_map<Map>;
  using Base::m_core;

public:
  /// \name Types
  /// @{

  using typename Base::Delaunay_classifier;
  using typename Base::Frame;
  using typename Base::Point;
  using typename Base::Settings;
  using typename Base::size_type;
  /// the visitor.
  using Delaunay_update_visitor = typename Base::Update_visitor;
  /// the CGAL triangulation that is maintained.
  using Triangulation = typename State::Triangulation;
  /// the data structure of that triangulation.
  using Triangulation_data_structure = typename State::Tds;
  /// a vertex of the CGAL triangulation; valid until the next call that changes it.
  using Vertex_handle = typename Triangulation::Vertex_handle;
  /// a face of the CGAL triangulation; valid until the next call that changes it.
  using Face_handle = typename Triangulation::Face_handle;
  /// an edge as CGAL represents it: a face, and the index of the vertex opposite to the edge.
  using Edge = typename Triangulation::Edge;

  /// @}
  /// \name Creation
  /// @{

  /// creates an empty triangulation.
  Dynamic_Delaunay_triangulation_2()
    : Dynamic_Delaunay_triangulation_2(Settings())
  {
  }

  /// creates an empty triangulation with these settings, which may be a classifier alone.
  explicit Dynamic_Delaunay_triangulation_2(const Settings& settings)
    : Base(settings, Traits())
  {
  }

  /// triangulates the points of the range; the i-th one has id i. The visitor is copied, and the
  /// copy is told of all vertices and faces.
  ///
  /// Cost: O(n log n), less than CGAL's insertion of a range of points.
  /// \tparam InputIterator its values are convertible to `Point`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow.
  template <class InputIterator>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                   const Settings& settings = Settings())
    : Dynamic_Delaunay_triangulation_2(settings)
  {
    this->insert(first, beyond);
  }

  /// triangulates the points that `point_map` reads from the values of the range.
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`.
  template <class InputIterator, class PointMap, class = If_map<PointMap>>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond, PointMap point_map,
                                   const Settings& settings = Settings())
    : Dynamic_Delaunay_triangulation_2(settings)
  {
    this->insert(first, beyond, point_map, Emptyset_iterator());
  }

  /// triangulates the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  explicit Dynamic_Delaunay_triangulation_2(const Range& range,
                                            const Settings& settings = Settings())
    : Dynamic_Delaunay_triangulation_2(std::begin(range), std::end(range), settings)
  {
  }

  /// triangulates the points that `point_map` reads from a range with `begin()` and `end()`.
  template <class Range, class PointMap, class = If_range<Range>, class = If_map<PointMap>>
  Dynamic_Delaunay_triangulation_2(const Range& range, PointMap point_map,
                                   const Settings& settings = Settings())
    : Dynamic_Delaunay_triangulation_2(std::begin(range), std::end(range), point_map, settings)
  {
  }

  /// @}
  /// \name Access
  /// @{

  /// the CGAL triangulation.
  /// \throws Uncertified_triangulation_error_2 unless `is_certified()`: CGAL's queries are not safe
  /// on a triangulation with inverted faces.
  const Triangulation& triangulation() const
  {
    if (!this->is_certified())
      throw Uncertified_triangulation_error_2();
    return m_core->state.triangulation();
  }

  /// the data structure of the CGAL triangulation. It is a valid triangulated sphere even when the
  /// triangulation is not certified.
  const Triangulation_data_structure& tds() const { return m_core->state.triangulation().tds(); }

  /// the infinite vertex of `tds()`.
  Vertex_handle infinite_vertex() const
  {
    return m_core->state.vertex_handle(Dynamic_Delaunay_triangulations_2::internal::infinite_index);
  }

  /// the vertex of a point. The handle is valid until the next call that changes the triangulation.
  /// \throws Unknown_id_error_2 if no point has this id.
  Vertex_handle vertex(size_type id) const
  {
    return m_core->state.vertex_handle(this->vertex_of(id));
  }

  /// the position of a point.
  /// \throws Unknown_id_error_2 if no point has this id.
  const Point& point(size_type id) const
  {
    const Vertex_handle representative = vertex(id);
    const auto& ids = m_core->state.ids();
    return ids.is_representative(Point_id(id)) ? representative->point()
                                               : ids.covered_point(Point_id(id));
  }

  /// the id of the point at a finite vertex. If several points share the vertex, this is the id of
  /// their representative, the one that was there first.
  size_type id(Vertex_handle vertex) const
  {
    return m_core->state.ids().representative(vertex.index());
  }

  /// calls `f(i, j)` with the ids of both ends of every finite edge. Where points share a vertex,
  /// only their representative has edges. Cost: one pass over the edges; no allocation.
  template <class Function>
  void for_each_edge(Function&& f) const
  {
    const auto& tds = this->tds();
    if (!m_core->state.spans_plane()) {
      for (auto e = tds.edges_begin(); e != tds.edges_end(); ++e)
        call_with_ids(f, e->first->vertex(tds.cw(e->second)).index(),
                      e->first->vertex(tds.ccw(e->second)).index());
      return;
    }
    for (const auto& edge : this->frame().edges())
      call_with_ids(f, edge.source, edge.target);
  }

  /// calls `f(ids)` once for each finite face, with an array of the ids of its three corners. They
  /// are counterclockwise, unless the triangulation is not certified. Cost: one pass over the
  /// faces; no allocation.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    const auto& state = m_core->state;
    if (!state.spans_plane())
      return;
    for (Face_index face(0); face < state.arrays().number_of_faces(); ++face) {
      const auto [u, v, w] = state.face(face);
      if (!Frame::is_infinite(u) && !Frame::is_infinite(v) && !Frame::is_infinite(w))
        f(std::array<size_type, 3>{state.ids().representative(u), state.ids().representative(v),
                                   state.ids().representative(w)});
    }
  }

  /// adds a property to the vertices, with `value` for all present and future vertices, as
  /// `Indexed_triangulation_data_structure_2::add_vertex_property()` does. A vertex keeps its
  /// values as long as it exists; `read_checkpoint()` makes all vertices new. The map is valid
  /// until this object is destroyed or assigned to; if it is moved or swapped, the map belongs to
  /// the other object. \return the map, and whether it is new. Cost: linear.
  template <class T>
  auto add_vertex_property(const std::string& name, const T& value = T())
  {
    return m_core->state.vertex_properties().template add<T>(name, value);
  }
  /// adds a property to the faces. The vertices of a face change; a visitor is told when.
  template <class T>
  auto add_face_property(const std::string& name, const T& value = T())
  {
    return m_core->state.face_properties().template add<T>(name, value);
  }

  /// @}

private:
  // Returns a function of a point and its place in a frame, which throws if the position is not
  // allowed.
  static auto position_check()
  {
    return [](const Point& p, size_type place) {
      Dynamic_Delaunay_triangulations_2::internal::checked_position(p, place);
    };
  }

  template <class Function>
  void call_with_ids(Function& f, Vertex_index v, Vertex_index w) const
  {
    const auto& ids = m_core->state.ids();
    if (!Frame::is_infinite(v) && !Frame::is_infinite(w))
      f(size_type(ids.representative(v)), size_type(ids.representative(w)));
  }
};

CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE(Dynamic_Delaunay_triangulation_2)

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
