// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Default.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/inform_classifier.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_plane_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_reader_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_writer_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Validity_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Usual_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/accepts_inexact_predicates_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_settings_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Dynamic_frame_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Indexed_triangulation_data_structure_2.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <istream>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Maintains the Delaunay triangulation of moving points. Every `update()` takes the new positions of
all points, finds what the motion broke, repairs it, and reports what it did.

Points have ids: 0, 1, 2, ... in the order in which they are given. An id keeps its vertex through
all updates, unless its point coincides with another one: points that coincide share a vertex as
long as they do. `insert()` adds points, and `remove()` removes them. The id of a removed point is
free, and the next point that is inserted gets the smallest free id. `Dynamic_population_2` is for
ids that the user chooses. Handles of vertices and faces are indices: they are valid until the next
call that changes the triangulation.

After construction, and after every update with an exact classifier, the triangulation is
<em>certified</em>: exact predicates have proved that its faces are counterclockwise, that its hull
is convex and turns around once, and that each of its edges is locally Delaunay. After an update
with a heuristic classifier it is not certified, unless that update rebuilt it. It is then still a
valid triangulated sphere with all its vertices.

\tparam Traits a model of `DynamicDelaunayTraits_2`: a CGAL kernel with exact predicates, such as
  `Exact_predicates_inexact_constructions_kernel`, or `Projection_traits_xy_3` of one.
\tparam Classifier a model of `DelaunayClassifier_2`, which finds what may be broken; `Default` for
  `Circumcircle_classifier_2`.
\tparam Repair a model of `DelaunayRepair_2`, which repairs it. `Default` stands for the
  classifier's `Usual_repair` if it has one; else for `Flip_and_splice_repair_2` if the classifier
  is exact, and for `Border_splice_repair_2` if it is not.
\tparam Tds an `Indexed_triangulation_data_structure_2` of these traits; `Default` for one without
  data of the user. Data that the user stores in a vertex stay in it. The vertices of a face change;
  a visitor is told when.
\tparam UpdatePolicy a model of `DelaunayUpdatePolicy_2`, which decides which frames are rebuilt
  instead; `Default` for `Always_dynamic_policy_2`.
\tparam Visitor a model of `DelaunayUpdateVisitor_2`, which is told what changes; `Default` for
  `Delaunay_update_visitor_base_2`, which ignores it.
\tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag`, which needs TBB: with it, the threads of
  the TBB arena in which a function is called share its passes over many points, edges or faces
  (\ref DynamicDelaunaySubsection_Threads). They use the iterators of random-access ranges, and
  property maps of points, at the same time. No result depends on it.
*/
template <class Traits, class Classifier = Circumcircle_classifier_2, class Repair = Default,
          class Tds = Default, class UpdatePolicy = Always_dynamic_policy_2,
          class Visitor = Delaunay_update_visitor_base_2, class ConcurrencyTag = Sequential_tag>
class Dynamic_Delaunay_triangulation_2
{
  static constexpr bool is_exact =
      !Dynamic_Delaunay_triangulations_2::internal::Are_known_to_be_inexact_2<Traits>::value;
  static_assert(is_exact || accepts_inexact_predicates_2<Traits>,
                "the predicates of these traits are rounded, so nothing could be certified: take "
                "Exact_predicates_inexact_constructions_kernel, or see "
                "accepts_inexact_predicates_2");

  using Chosen_classifier = typename Default::Get<Classifier, Circumcircle_classifier_2>::type;
  using Chosen_visitor = typename Default::Get<Visitor, Delaunay_update_visitor_base_2>::type;
  using Default_repair =
      typename Dynamic_Delaunay_triangulations_2::internal::Usual_repair_2<Chosen_classifier>::type;
  using Data_structure =
      typename Default::Get<Tds, Indexed_triangulation_data_structure_2<Traits>>::type;
  using Policy = typename Default::Get<UpdatePolicy, Always_dynamic_policy_2>::type;
  using Shown_to_visitor =
      std::conditional_t<std::is_same_v<Chosen_visitor, Delaunay_update_visitor_base_2>, void,
                         Dynamic_Delaunay_triangulation_2>;
  using State = Dynamic_Delaunay_triangulations_2::internal::Triangulation_state_2<
      Traits, Data_structure,
      Dynamic_Delaunay_triangulations_2::internal::Visitor_calls_2<Chosen_visitor,
                                                                   Shown_to_visitor>,
      ConcurrencyTag>;
  using Update = Dynamic_Delaunay_triangulations_2::internal::Update_2<State>;
  using Input = Dynamic_Delaunay_triangulations_2::internal::Input_frame_2<State>;
  using Population_input = Dynamic_Delaunay_triangulations_2::internal::Population_input_2<State>;
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;

public:
  /// \name Types
  /// @{

  /// the traits.
  using Geom_traits = Traits;
  /// the classifier.
  using Delaunay_classifier = Chosen_classifier;
  /// the repair.
  using Delaunay_repair = typename Default::Get<Repair, Default_repair>::type;
  /// the update policy.
  using Delaunay_update_policy = Policy;
  /// the visitor.
  using Delaunay_update_visitor = Chosen_visitor;
  /// classifier, repair, engines, policy and visitor, as one object.
  using Settings =
      Dynamic_triangulation_settings_2<Chosen_classifier, Delaunay_repair, Policy, Chosen_visitor>;
  /// whether work is shared among threads.
  using Concurrency_tag = ConcurrencyTag;
  /// the CGAL triangulation that is maintained.
  using Triangulation = typename State::Triangulation;
  /// the data structure of that triangulation.
  using Triangulation_data_structure = Data_structure;
  /// a point.
  using Point = typename Triangulation::Point;
  /// a vertex of the CGAL triangulation; valid until the next call that changes it.
  using Vertex_handle = typename Triangulation::Vertex_handle;
  /// a face, for as long.
  using Face_handle = typename Triangulation::Face_handle;
  /// an edge as CGAL represents it: a face, and the index of the vertex opposite to the edge.
  using Edge = typename Triangulation::Edge;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// the read-only view that classifiers get.
  using Frame = Dynamic_frame_2<State>;

  /// @}
  /// \name Creation
  /// @{

  /// creates an empty triangulation.
  Dynamic_Delaunay_triangulation_2()
    : Dynamic_Delaunay_triangulation_2(Settings())
  {
  }

  /// creates an empty triangulation with a classifier.
  explicit Dynamic_Delaunay_triangulation_2(const Delaunay_classifier& classifier)
    : Dynamic_Delaunay_triangulation_2(Settings{classifier})
  {
  }

  /// creates an empty triangulation with these settings.
  explicit Dynamic_Delaunay_triangulation_2(const Settings& settings)
    : m_classifier(settings.classifier)
    , m_repair(settings.repair)
    , m_policy(settings.policy)
    , m_visitor(settings.visitor)
    , m_core(std::make_unique<Core>())
  {
    m_core->update.tools().set_engines(settings.engines);
  }

  /// triangulates the points of the range; the i-th one has id i. Cost: O(n log n), about as much
  /// as CGAL's insertion of a range of points. \tparam InputIterator its values are convertible to
  /// `Point`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow.
  template <class InputIterator>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond)
    : Dynamic_Delaunay_triangulation_2(first, beyond, Identity_map(), Settings())
  {
  }

  /// the same, but with a classifier.
  template <class InputIterator>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                   const Delaunay_classifier& classifier)
    : Dynamic_Delaunay_triangulation_2(first, beyond, Identity_map(), Settings{classifier})
  {
  }

  /// the same, but with these settings. The visitor is copied, and the copy is told of all vertices
  /// and faces.
  template <class InputIterator>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                   const Settings& settings)
    : Dynamic_Delaunay_triangulation_2(first, beyond, Identity_map(), settings)
  {
  }

  /// the same, but takes the range as a whole: anything with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  explicit Dynamic_Delaunay_triangulation_2(const Range& points)
    : Dynamic_Delaunay_triangulation_2(std::begin(points), std::end(points))
  {
  }

  /// triangulates the points that `point_map` reads from the values of the range.
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow.
  template <class InputIterator, class PointMap,
            class = typename boost::property_traits<PointMap>::key_type>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond, PointMap point_map)
    : Dynamic_Delaunay_triangulation_2(first, beyond, point_map, Settings())
  {
  }

  /// the same, but with a classifier.
  template <class InputIterator, class PointMap,
            class = typename boost::property_traits<PointMap>::key_type>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond, PointMap point_map,
                                   const Delaunay_classifier& classifier)
    : Dynamic_Delaunay_triangulation_2(first, beyond, point_map, Settings{classifier})
  {
  }

  /// the same, but with these settings.
  template <class InputIterator, class PointMap,
            class = typename boost::property_traits<PointMap>::key_type>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond, PointMap point_map,
                                   const Settings& settings)
    : Dynamic_Delaunay_triangulation_2(settings)
  {
    insert(first, beyond, point_map, Emptyset_iterator());
  }

  /// copies everything: points, ids, topology, numbers, the user's data in vertices and faces, and
  /// whether it is certified. From then on the same calls have the same results for both.
  /// Classifier, repair, policy and visitor are copied too, but the visitor is not told of
  /// anything. The copy has its own vertex and face handles, and its sets of the last update are
  /// empty. Cost: linear.
  Dynamic_Delaunay_triangulation_2(const Dynamic_Delaunay_triangulation_2& other)
    : m_classifier(other.m_classifier)
    , m_repair(other.m_repair)
    , m_policy(other.m_policy)
    , m_visitor(other.m_visitor)
    , m_core(std::make_unique<Core>())
    , m_is_classifier_informed(other.m_is_classifier_informed)
  {
    m_core->update.copy(other.m_core->state, other.m_core->update);
  }
  /// the same, but replaces this triangulation. If it throws, nothing has changed.
  Dynamic_Delaunay_triangulation_2& operator=(const Dynamic_Delaunay_triangulation_2& other)
  {
    Dynamic_Delaunay_triangulation_2 copy(other);
    swap(copy);
    return *this;
  }

  /// takes everything from the other triangulation. That one is then empty, with the same
  /// classifier, repair and policy, and with a visitor that was moved from. Handles stay valid.
  /// Allocates memory for the empty triangulation and for copies of the classifier, the repair and
  /// the policy.
  Dynamic_Delaunay_triangulation_2(Dynamic_Delaunay_triangulation_2&& other)
    : Dynamic_Delaunay_triangulation_2(other, std::make_unique<Core>())
  {
  }
  /// the same, but replaces this triangulation. Moving an object to itself changes nothing.
  Dynamic_Delaunay_triangulation_2& operator=(Dynamic_Delaunay_triangulation_2&& other)
  {
    Dynamic_Delaunay_triangulation_2 taken(std::move(other));
    swap(taken);
    return *this;
  }

  /// exchanges everything with the other triangulation. Handles stay valid.
  void swap(Dynamic_Delaunay_triangulation_2& other)
  {
    using std::swap;
    swap(m_classifier, other.m_classifier);
    swap(m_repair, other.m_repair);
    swap(m_policy, other.m_policy);
    swap(m_visitor, other.m_visitor);
    swap(m_core, other.m_core);
    swap(m_is_classifier_informed, other.m_is_classifier_informed);
  }
  /// calls `a.swap(b)`.
  friend void swap(Dynamic_Delaunay_triangulation_2& a, Dynamic_Delaunay_triangulation_2& b)
  {
    a.swap(b);
  }

  /// @}
  /// \name Motion
  /// @{

  /// moves point i to the i-th position of the range, for all points, and repairs the
  /// triangulation. The range has one position for each id; positions for ids of removed points are
  /// ignored.
  ///
  /// Cost: one pass over all ids, free ones included; the classifier's pass; and the repair of what
  /// it classified, which for points that jump is proportional to their number. The total is never
  /// much more than the cost of a rebuild. Where nothing breaks nothing is allocated, except in the
  /// first frame, and when the circumcircle classifier skips edges for the first time (16 bytes a
  /// vertex each).
  /// \throws Point_count_error_2 if the number of positions is not `number_of_ids()`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program.
  ///
  /// Nothing changes if it throws one of these, or if the range throws, or if the policy or the
  /// classifier throws when it is asked. If the policy or the classifier throws in
  /// `after_update()`, the update itself is complete. After any other exception the points have
  /// their new positions and the triangulation is not certified; the next update, or `mend()`,
  /// certifies it again. \post `is_certified()`, if the classifier is exact.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    return update(first, beyond, Identity_map());
  }

  /// the same, but takes the range as a whole: anything with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_2 update(const Range& points)
  {
    return update(std::begin(points), std::end(points));
  }

  /// the same, but `point_map` reads the positions from the values of the range.
  template <class InputIterator, class PointMap>
  Update_report_2 update(InputIterator first, InputIterator beyond, PointMap point_map)
  {
    const Floating_point floating_point;
    m_core->input.stage(first, beyond, point_map);
    Change& change = begin_change();
    change.is_frame = true;
    return run(change);
  }

  /// the same, but takes the range as a whole.
  template <class Range, class PointMap, class = If_range<Range>,
            class = typename boost::property_traits<PointMap>::key_type>
  Update_report_2 update(const Range& range, PointMap point_map)
  {
    return update(std::begin(range), std::end(range), point_map);
  }

  /// moves some points, and repairs what that breaks. All other points stay where they are. The
  /// repair uses exact predicates, whatever the classifier is; the policy is not asked.
  ///
  /// Cost: proportional to the number of points in the range and to what they break, plus a walk
  /// around the hull if it changes; if points coincide, also proportional to the number of those.
  ///
  /// \tparam InputIterator its values are pairs of an id, which is an integer, and a `Point`.
  /// \throws Unknown_id_error_2 if an id belongs to no point.
  /// \throws Repeated_id_error_2 if an id is given more than once.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program.
  ///
  /// Nothing changes if it throws one of these, or if the range throws. After any other exception
  /// the triangulation is not certified; `mend()` certifies it again. \post `is_certified()`, if it
  /// was, or if the classifier is exact.
  template <class InputIterator>
  Update_report_2 move(InputIterator first, InputIterator beyond)
  {
    using Value = typename std::iterator_traits<InputIterator>::value_type;
    return move(first, beyond, First_of_pair_property_map<Value>(),
                Second_of_pair_property_map<Value>());
  }

  /// the same, but takes the range as a whole.
  template <class Range, class = If_range<Range>>
  Update_report_2 move(const Range& movers)
  {
    return move(std::begin(movers), std::end(movers));
  }

  /// the same, but property maps read the ids and points from the values of the range.
  template <class InputIterator, class IdMap, class PointMap>
  Update_report_2 move(InputIterator first, InputIterator beyond, IdMap id_map, PointMap point_map)
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_movers(first, beyond, id_map, point_map, m_core->state, change);
    return run(change);
  }

  /// the same, but for one point.
  Update_report_2 move(size_type id, const Point& p)
  {
    const std::pair<size_type, Point> mover(id, p);
    return move(&mover, &mover + 1);
  }

  /// @}
  /// \name Population
  /// Inserts and removes points. What that breaks is repaired by exact predicates, whatever the
  /// classifier is. If memory runs out, each point is either inserted (or removed) completely or
  /// not at all, and the triangulation is not certified; `mend()` certifies it again.
  /// @{

  /// adds a point, and returns its id: the smallest free one. If it coincides with another point,
  /// it shares that one's vertex. Cost: O(n<sup>1/3</sup>) expected for evenly spread points to
  /// find its place, plus the repair of what it breaks, plus a walk around the hull if it changes;
  /// a rebuild while the points do not span the plane.
  ///
  /// \throws Non_finite_coordinate_error_2 or Coordinate_range_error_2 if a coordinate cannot be
  /// used, Point_limit_error_2 if there would be too many points; nothing changes.
  /// \post `is_certified()`, if it was, or if the classifier is exact.
  size_type insert(const Point& p)
  {
    size_type id = 0;
    insert(&p, &p + 1, &id);
    return id;
  }

  /// adds the points of the range. Their ids are written to `ids` first. If there are more than
  /// about one of them for nine vertices, everything is triangulated anew.
  template <class InputIterator, class OutputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond, OutputIterator ids)
  {
    return insert(first, beyond, Identity_map(), ids);
  }

  /// the same, but takes the range as a whole.
  template <class Range, class OutputIterator, class = If_range<Range>>
  Update_report_2 insert(const Range& points, OutputIterator ids)
  {
    return insert(std::begin(points), std::end(points), ids);
  }

  /// the same, but `point_map` reads the points from the values of the range.
  template <class InputIterator, class PointMap, class OutputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond, PointMap point_map,
                         OutputIterator ids)
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_newcomers(first, beyond, point_map, m_core->state, change);
    for (const Index id : change.coming)
      *ids++ = id;
    return run(change);
  }

  /// removes a point; its id is free from then on. Cost: proportional to the number of its
  /// neighbors and to what that breaks, plus a walk around the hull if it changes; if points
  /// coincide, also proportional to the number of those; a rebuild if the points do not span the
  /// plane before or after.
  ///
  /// \throws Unknown_id_error_2 if no point has this id; nothing changes.
  /// \post `is_certified()`, if it was, or if the classifier is exact.
  Update_report_2 remove(size_type id) { return remove(&id, &id + 1); }

  /// removes the points with these ids. If they are more than about one in nine vertices,
  /// everything is triangulated anew. \tparam InputIterator its values are integers.
  /// \throws Unknown_id_error_2 if an id belongs to no point; nothing changes.
  /// \throws Repeated_id_error_2 if an id is given more than once; nothing changes.
  template <class InputIterator>
  Update_report_2 remove(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_ids(first, beyond, m_core->state, change.gone);
    return run(change);
  }

  /// the same, but takes the range as a whole.
  template <class Range, class = If_range<Range>>
  Update_report_2 remove(const Range& ids)
  {
    return remove(std::begin(ids), std::end(ids));
  }

  /// \cond
  // For `Dynamic_population_2`: a function of a point and its place in a frame, which throws if no
  // point can be there.
  static auto position_check()
  {
    return [](const Point& p, size_type place) {
      Dynamic_Delaunay_triangulations_2::internal::checked_position(p, place);
    };
  }

  // Updates a whole frame of Dynamic_population_2. The range has a position for every id, also for
  // those that are removed; `gone` has the ids to remove, all of which exist; `coming` has the
  // points to insert. Their ids are written to `coming_ids`, ascending; nothing is written if an
  // exception ends this before all removals are done.
  template <class InputIterator>
  Update_report_2
  update_population(InputIterator first, InputIterator beyond, const std::vector<size_type>& gone,
                    const std::vector<Point>& coming, std::vector<size_type>& coming_ids)
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_newcomers(coming.begin(), coming.end(), Identity_map(), m_core->state,
                                     change);
    change.is_frame = true;
    change.gone.assign(gone.begin(), gone.end());
    change.coming = m_core->state.ids().next_ids(coming.size(), change.gone);
    const std::vector<size_type> ids(change.coming.begin(), change.coming.end());
    m_core->input.stage(first, beyond, Identity_map());
    try {
      const Update_report_2 report = run(change);
      coming_ids = ids;
      return report;
    } catch (...) {
      if (m_core->update.has_removed())
        coming_ids = ids;
      throw;
    }
  }
  /// \endcond

  /// @}
  /// \name Certainty
  /// @{

  /// makes the triangulation Delaunay and certified, whatever the classifier is: the circumcircle
  /// classifier finds what is broken, and `Flip_and_splice_repair_2` repairs it. Does nothing if
  /// the triangulation is certified already. \post `is_certified()`
  Update_report_2 mend()
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    change.is_mending = true;
    if (!is_certified())
      return run(change);
    Update_report_2 report;
    report.certified = true;
    return report;
  }

  /// tests whether the triangulation is Delaunay, by exact predicates at every edge, and certifies
  /// it if so. Changes nothing else. The result is false as long as an exception has left points
  /// without their own vertices, or a triangulation that does not span the plane. Cost: one pass
  /// over all edges; none if it is certified already.
  bool certify()
  {
    const Floating_point floating_point;
    return is_exact && m_core->update.certify();
  }

  /// @}
  /// \name Access
  /// @{

  /// whether the triangulation is proved Delaunay. Cost: none.
  bool is_certified() const { return is_exact && m_core->update.is_certified(); }

  /// the CGAL triangulation.
  /// \throws Uncertified_triangulation_error_2 unless `is_certified()`: CGAL's queries are not safe
  /// on a triangulation with inverted faces.
  const Triangulation& triangulation() const
  {
    if (!is_certified())
      throw Uncertified_triangulation_error_2();
    return m_core->state.triangulation();
  }

  /// the data structure of the CGAL triangulation. It is a valid triangulated sphere even when the
  /// triangulation is not certified.
  const Triangulation_data_structure& tds() const { return m_core->state.triangulation().tds(); }

  /// the infinite vertex of `tds()`.
  Vertex_handle infinite_vertex() const { return m_core->state.vertex_handle(0); }

  /// the number of points.
  size_type number_of_points() const { return m_core->state.ids().number_of_points(); }
  /// one more than the largest id ever in use. It never decreases.
  size_type number_of_ids() const { return m_core->state.ids().number_of_ids(); }
  /// whether a point has this id.
  bool has_id(size_type id) const { return m_core->state.ids().is_taken(id); }
  /// the number of finite vertices: less than the number of points if points coincide.
  size_type number_of_vertices() const { return m_core->state.number_of_vertices(); }

  /// the vertex of a point. The handle is valid until the next call that changes the triangulation.
  /// \throws Unknown_id_error_2 if no point has this id.
  Vertex_handle vertex(size_type id) const
  {
    if (!has_id(id))
      throw Unknown_id_error_2(id, number_of_ids());
    return m_core->state.vertex_handle(m_core->state.ids().vertex(Index(id)));
  }

  /// the position of a point.
  /// \throws Unknown_id_error_2 if no point has this id.
  const Point& point(size_type id) const
  {
    const Vertex_handle representative = vertex(id);
    const auto& ids = m_core->state.ids();
    return ids.is_representative(Index(id)) ? representative->point()
                                            : ids.duplicate(Index(id)).point;
  }

  /// the id of the point at a finite vertex. If several points share the vertex: the id of their
  /// representative, which was there first.
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
    for (const auto& edge : frame().edges())
      call_with_ids(f, edge.source, edge.target);
  }

  /// adds a property to the vertices, with `value` for all of them and all that come, as
  /// `Indexed_triangulation_data_structure_2::add_vertex_property()` does. A vertex keeps its
  /// values as long as it lives. The map is valid until this object is destroyed or assigned to; if
  /// it is moved or swapped, the map belongs to the other object. \return the map, and whether it
  /// is new. Cost: linear.
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

  /// the points, edges and faces as flat arrays.
  Frame frame() const { return Frame(m_core->state); }

  /// the classifier.
  const Delaunay_classifier& classifier() const { return m_classifier; }
  /// the repair.
  const Delaunay_repair& repair() const { return m_repair; }
  /// the update policy.
  const Policy& policy() const { return m_policy; }
  /// the visitor.
  const Delaunay_update_visitor& visitor() const { return m_visitor; }
  /// the visitor, in order to read and clear what it has recorded.
  Delaunay_update_visitor& visitor() { return m_visitor; }

  /// the Classified set of the last update, as vertices of `frame()`. Empty after a rebuild that
  /// preceded classification.
  const std::vector<Index>& classified_vertices() const
  {
    return tools().classification().vertices();
  }
  /// the Padded set of the last update that spliced around the Classified set.
  const std::vector<Index>& padded_vertices() const { return tools().padded(); }
  /// the Border set of the same splice.
  const std::vector<Index>& border_vertices() const { return tools().border(); }

  /// @}
  /// \name Checkpoints
  /// Writes and reads the triangulation as a file, \ref DynamicDelaunayTriangulation2Checkpoints. A
  /// run continues from a checkpoint as if it had not been interrupted. `Point` has to be the
  /// `Point_2` of a kernel. Coordinates have to be doubles, or fractions of integers as those of
  /// `Exact_predicates_exact_constructions_kernel`. Other types do not compile, since they may hold
  /// more than a checkpoint would keep.
  /// @{

  /// writes the triangulation, the ids of its points, all numbers in `frame()`, and whether it is
  /// certified. Not written are the state of the classifier, the repair and the policy, and the
  /// user's data in vertices and faces. Cost: linear, about 150 bytes a point.
  /// \throws Checkpoint_error_2 if the stream fails; what was written is then unusable. It is also
  /// thrown, before anything is written, if an exception ended the last update before each point
  /// had its vertex.
  void write_checkpoint(std::ostream& out) const
  {
    write_checkpoint(out, checkpoint_subject, [](auto&) {});
  }

  /// The file is validated: its faces must be a triangulated sphere with all points, each number
  /// and id must occur exactly once, and a triangulation that is marked as certified must be
  /// Delaunay by exact predicates. Reads exactly what was written, and leaves the rest of the
  /// stream unread. Cost: linear; memory in proportion to what is read, in addition to what this
  /// triangulation uses.
  /// \throws Checkpoint_error_2 if the file is refused. Whatever is thrown, nothing changes, unless
  /// the visitor throws it while it is told what changes.
  void read_checkpoint(std::istream& in)
  {
    read_checkpoint(
        in, checkpoint_subject, [](auto&, const auto&) {}, [] {});
  }

  /// writes a checkpoint, whatever mode CGAL's `set_mode()` has given to the stream. Where
  /// `write_checkpoint()` would throw `Checkpoint_error_2`, the stream fails (`failbit`).
  friend std::ostream& operator<<(std::ostream& out, const Dynamic_Delaunay_triangulation_2& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::write_to_stream(out, dt);
  }

  /// skips white space, then reads a checkpoint. Where `read_checkpoint()` would throw
  /// `Checkpoint_error_2`, the stream fails (`failbit`), and the triangulation does not change.
  friend std::istream& operator>>(std::istream& in, Dynamic_Delaunay_triangulation_2& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::read_from_stream(in, dt);
  }

  /// \cond
  // The same, but `append` writes, and `read_more` reads, additional lines of the file; when
  // nothing can be refused any more, `exchange_more` takes what they say, and throws nothing.
  template <class Append>
  void write_checkpoint(std::ostream& out, std::string_view subject, const Append& append) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Floating_point floating_point;
    Checkpoint_writer_2<State>(m_core->state, is_certified(), m_core->update.experience())
        .write(out, subject, append);
  }

  template <class ReadAppendix, class Exchange>
  void read_checkpoint(std::istream& in, std::string_view subject, const ReadAppendix& read_more,
                       const Exchange& exchange_more)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Floating_point floating_point;
    Checkpoint_input_2 file(in, subject);
    Checkpoint_reader_2<State> reader(file);
    State state(m_core->state.traits());
    reader.read(state);
    read_more(file, state.ids());
    file.finish();
    Delaunay_classifier classifier = m_classifier;
    inform_classifier(classifier, Frame(state));
    m_core->update.tools().reserve_for_exchange(state);
    start_visit();
    m_classifier = std::move(classifier); // nothing throws from here on
    m_core->update.tools().exchange(state);
    m_core->update.restore(reader.is_certified(), reader.memory());
    m_is_classifier_informed = true;
    exchange_more();
    Update_report_2 report;
    report.certified = is_certified();
    finish_visit(report);
  }
  /// \endcond

  /// @}
  /// \name Checking
  /// @{

  /// whether the object is valid: the data structure is, no point is lost, no handle has set a
  /// point, a vertex or a neighbor since everything was built last, and the certificate holds if
  /// `is_certified()`. Cost: linear. \param verbose whether to print to `std::cerr` what is wrong.
  /// \param level is passed to the data structure's `is_valid()`.
  bool is_valid(bool verbose = false, int level = 0) const
  {
    using Check = Dynamic_Delaunay_triangulations_2::internal::Validity_check_2<State>;
    const Floating_point floating_point;
    return Check(m_core->state, verbose).passes(level, is_certified());
  }

  /// @}

private:
  using Identity_map = boost::typed_identity_property_map<Point>;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2;

  static constexpr std::string_view checkpoint_subject = "Dynamic_Delaunay_triangulation_2";

  using Change = Dynamic_Delaunay_triangulations_2::internal::Change_2<Point>;

  // Must not move in memory: its parts refer to each other.
  struct Core
  {
    State state;
    Input input{state};
    Update update{state};
    Change change; // of the present call, or the last one
  };

  // Takes everything from the other one, which gets an empty core that its classifier knows nothing
  // of. Classifier, repair and policy are copied, not moved, since both objects go on using them.
  Dynamic_Delaunay_triangulation_2(Dynamic_Delaunay_triangulation_2& other,
                                   std::unique_ptr<Core> empty)
    : m_classifier(other.m_classifier)
    , m_repair(other.m_repair)
    , m_policy(other.m_policy)
    , m_visitor(std::move(other.m_visitor))
    , m_core(std::exchange(other.m_core, std::move(empty)))
    , m_is_classifier_informed(std::exchange(other.m_is_classifier_informed, false))
  {
  }

  // An empty one.
  Change& begin_change()
  {
    m_core->change.clear();
    return m_core->change;
  }

  const auto& tools() const { return std::as_const(m_core->update).tools(); }

  // Every change of the triangulation runs through here, after its input was read and checked.
  Update_report_2 run(Change& change)
  {
    const auto take_back = [&] {
      if (change.is_frame)
        m_core->input.take_back();
      return change.moved.empty();
    };
    m_core->update.enter();
    start_visit(); // an exception leaves a frame that was read unused
    if (change.is_frame)
      m_core->input.accept();
    try {
      const Update_report_2 report = run_phases(change, take_back);
      finish_visit(report);
      return report;
    } catch (...) {
      m_core->input.settle();
      throw;
    }
  }

  template <class Take_back>
  Update_report_2 run_phases(Change& change, const Take_back& take_back)
  {
    const bool is_informed = std::exchange(m_is_classifier_informed, false);
    Update_report_2 report =
        m_core->update.run(change, m_classifier, m_repair, m_policy, is_informed, take_back);
    inform_classifier(m_classifier, frame());
    m_is_classifier_informed = true;
    report.certified = is_certified();
    if (change.is_frame)
      m_policy.after_update(frame(), report);
    m_core->input.settle();
    return report;
  }

  // Calls `before_update()`; if that throws, nothing has changed yet.
  void start_visit()
  {
    m_visitor.before_update(std::as_const(*this));
    m_core->update.tools().editor().start_visit(m_visitor, this);
  }

  // Ends the visit when everything is done. Rethrows now what the visitor has thrown in between.
  void finish_visit(const Update_report_2& report)
  {
    m_core->update.tools().editor().finish_visit();
    m_visitor.after_update(std::as_const(*this), report);
  }

  template <class Function>
  void call_with_ids(Function& f, Index v, Index w) const
  {
    const auto& ids = m_core->state.ids();
    if (!Frame::is_infinite(v) && !Frame::is_infinite(w))
      f(size_type(ids.representative(v)), size_type(ids.representative(w)));
  }

  Delaunay_classifier m_classifier;
  Delaunay_repair m_repair;
  Policy m_policy;
  Delaunay_update_visitor m_visitor;
  std::unique_ptr<Core> m_core;
  bool m_is_classifier_informed = true;
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

A `Dynamic_Delaunay_triangulation_2` with a visitor, a model of `DelaunayUpdateVisitor_2`, and
defaults for everything else.
*/
template <class Traits, class Visitor, class Classifier = Circumcircle_classifier_2>
using Dynamic_Delaunay_triangulation_with_visitor_2 =
    Dynamic_Delaunay_triangulation_2<Traits, Classifier, Default, Default, Default, Visitor>;

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
