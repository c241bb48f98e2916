// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/Always_dynamic_policy_2.h>
#include <CGAL/Border_splice_repair_2.h>
#include <CGAL/Circumcircle_classifier_2.h>
#include <CGAL/Default.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Input_frame_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Validity_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_vertex_base_2.h>
#include <CGAL/Dynamic_frame_2.h>
#include <CGAL/Dynamic_mender_2.h>
#include <CGAL/Flip_and_splice_repair_2.h>
#include <CGAL/inform_classifier.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Update_report_2.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2

Keeps a Delaunay triangulation right while its points move. Every `update()` takes the new positions
of all points, finds what the motion broke, mends that, and reports what it did.

Points have ids: 0, 1, 2, ... in the order in which they were given. An id keeps its vertex through
all updates. Points that coincide share a vertex while they do.

After construction, and after every update with an exact classifier, the triangulation is
*certified*: its faces are counterclockwise, its hull is convex and turns around once, and each of
its edges is locally Delaunay, all by exact predicates. After an update with a heuristic classifier
it is not, unless it was rebuilt; it is then still a valid triangulated sphere with all its
vertices.

\tparam Traits a CGAL kernel with exact predicates whose points have `x()` and `y()`, such as
  `Exact_predicates_inexact_constructions_kernel`.
\tparam Classifier a model of `DelaunayClassifier_2`, what may be broken.
\tparam Repair a model of `DelaunayRepair_2`, what mends it. `Default` stands for the classifier's
  `Usual_repair` if it has one; else for `Flip_and_splice_repair_2` if the classifier is exact, and
  for `Border_splice_repair_2` if it is not.
\tparam Tds a triangulation data structure whose vertex base is
  `Dynamic_Delaunay_triangulation_vertex_base_2` or derives from it; `Default` for a plain one.
\tparam Policy a model of `DelaunayUpdatePolicy_2`, which frames are rebuilt instead.
*/
template <class Traits, class Classifier = Circumcircle_classifier_2, class Repair = Default,
          class Tds = Default, class Policy = Always_dynamic_policy_2>
class Dynamic_Delaunay_triangulation_2
{
  template <class C, class = void>
  struct Usual_repair
  {
    using type = std::conditional_t<C::is_exact, Flip_and_splice_repair_2, Border_splice_repair_2>;
  };
  template <class C>
  struct Usual_repair<C, std::void_t<typename C::Usual_repair>>
  {
    using type = typename C::Usual_repair;
  };
  using Default_repair = typename Usual_repair<Classifier>::type;
  using Default_tds =
      Triangulation_data_structure_2<Dynamic_Delaunay_triangulation_vertex_base_2<Traits>,
                                     Triangulation_face_base_2<Traits>>;
  using Data_structure = typename Default::Get<Tds, Default_tds>::type;
  using Maintained =
      Dynamic_Delaunay_triangulations_2::internal::Maintained_triangulation_2<Traits,
                                                                              Data_structure>;
  using Mender = Dynamic_mender_2<Maintained>;
  using Index = Dynamic_Delaunay_triangulations_2::Index;

public:
  /// \name Types
  /// @{

  /// the traits.
  using Geom_traits = Traits;
  /// the classifier.
  using Delaunay_classifier = Classifier;
  /// the repair.
  using Delaunay_repair = typename Default::Get<Repair, Default_repair>::type;
  /// the update policy.
  using Delaunay_update_policy = Policy;
  /// the CGAL triangulation that is maintained.
  using Triangulation = typename Maintained::Triangulation;
  /// its data structure.
  using Triangulation_data_structure = Data_structure;
  /// a point.
  using Point = typename Triangulation::Point;
  /// a vertex of the CGAL triangulation.
  using Vertex_handle = typename Triangulation::Vertex_handle;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// the view that classifiers get.
  using Frame = Dynamic_frame_2<Maintained>;

  /// @}
  /// \name Creation
  /// @{

  /// an empty triangulation, with a classifier and a repair by default.
  Dynamic_Delaunay_triangulation_2()
    : Dynamic_Delaunay_triangulation_2(Classifier())
  {
  }

  /// an empty triangulation.
  explicit Dynamic_Delaunay_triangulation_2(const Classifier& classifier,
                                            const Delaunay_repair& repair = Delaunay_repair(),
                                            const Static_engines_2& engines = {},
                                            const Policy& policy = Policy())
    : m_classifier(classifier)
    , m_repair(repair)
    , m_policy(policy)
    , m_core(std::make_unique<Core>())
  {
    m_core->mender.set_engines(engines);
  }

  /// triangulates the points of the range; the i-th one has id i. Cost: O(n log n); about that of
  /// CGAL's insertion of a range of points. \tparam InputIterator its values are convertible to
  /// `Point`. \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  template <class InputIterator>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond)
    : Dynamic_Delaunay_triangulation_2(first, beyond, Identity_map(), Classifier())
  {
  }

  /// the same, with a classifier, a repair, the engines that triangulate anew, and a policy.
  template <class InputIterator>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                   const Classifier& classifier,
                                   const Delaunay_repair& repair = Delaunay_repair(),
                                   const Static_engines_2& engines = {},
                                   const Policy& policy = Policy())
    : Dynamic_Delaunay_triangulation_2(first, beyond, Identity_map(), classifier, repair, engines,
                                       policy)
  {
  }

  /// triangulates the points that `point_map` reads from the values of the range.
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  template <class InputIterator, class PointMap,
            class = typename boost::property_traits<PointMap>::key_type>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond, PointMap point_map)
    : Dynamic_Delaunay_triangulation_2(first, beyond, point_map, Classifier())
  {
  }

  /// the same, with a classifier, a repair, the engines that triangulate anew, and a policy.
  template <class InputIterator, class PointMap,
            class = typename boost::property_traits<PointMap>::key_type>
  Dynamic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond, PointMap point_map,
                                   const Classifier& classifier,
                                   const Delaunay_repair& repair = Delaunay_repair(),
                                   const Static_engines_2& engines = {},
                                   const Policy& policy = Policy())
    : Dynamic_Delaunay_triangulation_2(classifier, repair, engines, policy)
  {
    m_core->mender.editor().build(
        m_core->input.read_all(first, beyond, point_map, m_core->maintained));
    spread_news();
  }

  /// the moved-from object can only be assigned to or destroyed.
  Dynamic_Delaunay_triangulation_2(Dynamic_Delaunay_triangulation_2&&) = default;
  /// the same.
  Dynamic_Delaunay_triangulation_2& operator=(Dynamic_Delaunay_triangulation_2&&) = default;

  /// @}
  /// \name Motion
  /// @{

  /// moves point i to the i-th position of the range, for all points, and mends the triangulation.
  ///
  /// Cost: one pass over all points and one of the classifier, and the repair of what it
  /// classified; never much more than that of a rebuild. Nothing is allocated where nothing breaks,
  /// but for the first time that the circumcircle classifier skips edges (16 bytes a vertex).
  /// \throws Point_count_error_2 if there are not `number_of_points()` positions.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  ///
  /// Nothing changes if it throws one of these, or if the range, the policy or the classifier
  /// throws. After any other exception the positions are the new ones and the triangulation is not
  /// certified; the next update, or `mend()`, certifies it again. \post `is_certified()`, if the
  /// classifier is exact.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    return update(first, beyond, Identity_map());
  }

  /// moves point i to what `point_map` reads from the i-th value of the range.
  template <class InputIterator, class PointMap>
  Update_report_2 update(InputIterator first, InputIterator beyond, PointMap point_map)
  {
    Maintained& maintained = m_core->maintained;
    m_core->input.stage(first, beyond, point_map, maintained);
    const bool was_certified = std::exchange(m_is_certified, false);
    const Point_writer writer{maintained};
    forget_news();
    Update_report_2 report;
    if (!maintained.is_mirrored())
      rebuild(report, Rebuild_reason_2::DIMENSION);
    else if (m_core->input.coincident_points_part(maintained))
      rebuild(report, Rebuild_reason_2::COINCIDENCE);
    else if (ask([&] { return m_policy.wants_rebuild(frame()); }, was_certified))
      rebuild(report, Rebuild_reason_2::POLICY);
    else {
      ask([&] { m_classifier(frame(), m_core->mender.start(report)); }, was_certified);
      m_core->mender.take_classification(Classifier::is_exact, was_certified);
      if (!m_core->mender.classification().empty())
        m_repair(m_core->mender);
      prove(report, Classifier::is_exact);
    }
    finish(report);
    m_policy.after_update(frame(), report);
    return report;
  }

  /// makes the triangulation Delaunay and certified, whatever the classifier is: the circumcircle
  /// classifier finds what is broken, and `Flip_and_splice_repair_2` mends it. Does nothing if it
  /// is certified already. \post `is_certified()`
  Update_report_2 mend()
  {
    Update_report_2 report;
    report.certified = true;
    if (m_is_certified)
      return report;
    forget_news();
    Circumcircle_classifier_2()(frame(), m_core->mender.start(report));
    m_core->mender.take_classification(true, false);
    Flip_and_splice_repair_2()(m_core->mender);
    prove(report, true);
    finish(report);
    return report;
  }

  /// finds out whether the triangulation is Delaunay, by exact predicates at every edge; changes
  /// nothing else. Cost: one pass over all edges, none if it is certified already.
  bool certify()
  {
    m_is_certified = m_is_certified || m_core->certificate().holds();
    return m_is_certified;
  }

  /// @}
  /// \name Access
  /// @{

  /// whether the triangulation is proved Delaunay. Cost: none.
  bool is_certified() const { return m_is_certified; }

  /// the CGAL triangulation.
  /// \throws Uncertified_triangulation_error_2 unless `is_certified()`: CGAL's queries are not safe
  /// on a triangulation with inverted faces.
  const Triangulation& triangulation() const
  {
    if (!m_is_certified)
      throw Uncertified_triangulation_error_2();
    return m_core->maintained.triangulation;
  }

  /// the topology of the CGAL triangulation, which is a valid triangulated sphere also when it is
  /// not certified.
  const Triangulation_data_structure& tds() const { return m_core->maintained.triangulation.tds(); }

  /// the infinite vertex of `tds()`.
  Vertex_handle infinite_vertex() const { return m_core->maintained.vertices.front(); }

  /// the number of points.
  size_type number_of_points() const { return m_core->maintained.ids.number_of_points(); }
  /// the number of finite vertices: fewer, if points coincide.
  size_type number_of_vertices() const { return m_core->maintained.number_of_vertices(); }

  /// the vertex of a point. It stays the same as long as the point does not coincide with others.
  /// \throws Unknown_id_error_2 if there is no such point.
  Vertex_handle vertex(size_type id) const
  {
    if (id >= number_of_points())
      throw Unknown_id_error_2(id, number_of_points());
    return m_core->maintained.vertices[m_core->maintained.ids.vertex(Index(id))];
  }

  /// where a point is.
  /// \throws Unknown_id_error_2 if there is no such point.
  const Point& point(size_type id) const { return vertex(id)->point(); }

  /// the id of a point at a finite vertex; of the one that was there first, if several are.
  size_type id(Vertex_handle vertex) const
  {
    return m_core->maintained.ids.host(vertex->mirror_index());
  }

  /// calls `f(i, j)` with the ids of both ends of every finite edge. Points that share a vertex
  /// with another have no edges of their own. Cost: one pass over the edges; no allocation.
  template <class Function>
  void for_each_edge(Function&& f) const
  {
    const auto& tds = this->tds();
    if (!m_core->maintained.is_mirrored()) {
      for (auto e = tds.edges_begin(); e != tds.edges_end(); ++e)
        call_with_ids(f, e->first->vertex(tds.cw(e->second))->mirror_index(),
                      e->first->vertex(tds.ccw(e->second))->mirror_index());
      return;
    }
    for (const auto& edge : frame().edges())
      call_with_ids(f, edge.source, edge.target);
  }

  /// the points, edges and faces as flat arrays.
  Frame frame() const { return Frame(m_core->maintained); }

  /// the classifier.
  const Classifier& classifier() const { return m_classifier; }
  /// the repair.
  const Delaunay_repair& repair() const { return m_repair; }
  /// the update policy.
  const Policy& policy() const { return m_policy; }

  /// the Classified set of the last update, as vertices of `frame()`. Empty after a rebuild that
  /// came before classification.
  const std::vector<Index>& classified_vertices() const
  {
    return m_core->mender.classification().vertices();
  }
  /// the Padded set of the last update with a border splice around the Classified set.
  const std::vector<Index>& padded_vertices() const { return m_core->mender.padded(); }
  /// the Border set of the same splice.
  const std::vector<Index>& border_vertices() const { return m_core->mender.border(); }

  /// @}
  /// \name Checking
  /// @{

  /// whether everything is as it should be: a valid data structure, the flat arrays in step with
  /// it, no point lost, and the certificate if `is_certified()`. Cost: linear. \param verbose
  /// whether to say on `std::cerr` what is wrong. \param level handed on to the data structure's
  /// `is_valid()`.
  bool is_valid(bool verbose = false, int level = 0) const
  {
    using Check = Dynamic_Delaunay_triangulations_2::internal::Validity_check_2<Maintained>;
    return Check(m_core->maintained, verbose).passes(level, m_is_certified);
  }

  /// @}

private:
  using Identity_map = boost::typed_identity_property_map<Point>;

  // What must not move in memory: its parts refer to each other.
  struct Core
  {
    Maintained maintained;
    Mender mender{maintained};
    Dynamic_Delaunay_triangulations_2::internal::Input_frame_2<Maintained> input;

    auto certificate() const
    {
      return Dynamic_Delaunay_triangulations_2::internal::Certificate_2<Maintained>(maintained);
    }
  };

  // Gives CGAL's vertices their points in the end, also if a repair throws.
  struct Point_writer
  {
    Maintained& maintained;
    ~Point_writer() { maintained.write_points(); }
  };

  // Asks the policy or the classifier. If it throws, the points go back to where they were.
  template <class Question>
  auto ask(const Question& question, bool was_certified)
  {
    try {
      return question();
    } catch (...) {
      m_core->input.unstage(m_core->maintained);
      m_is_certified = was_certified;
      throw;
    }
  }

  // Rebuilds if there has to be a proof and the repair has not brought it to an end.
  void prove(Update_report_2& report, bool has_to)
  {
    if (has_to && !report.rebuilt() && !(m_core->mender.is_done() && is_planar()))
      m_core->mender.rebuild(Rebuild_reason_2::STUCK);
    m_is_certified = has_to || report.rebuilt();
  }

  bool is_planar() const
  {
    return m_core->mender.is_planar() || !m_core->maintained.is_mirrored() ||
           m_core->certificate().hull_turns_once();
  }

  void rebuild(Update_report_2& report, Rebuild_reason_2 reason)
  {
    m_core->mender.start(report);
    m_core->mender.rebuild(reason);
    m_is_certified = true;
  }

  void finish(Update_report_2& report)
  {
    spread_news();
    report.certified = m_is_certified;
  }

  void forget_news()
  {
    if (!m_is_classifier_informed)
      return;
    m_core->maintained.everything_is_new = false;
    m_core->maintained.new_edges.clear();
    m_is_classifier_informed = false;
  }

  void spread_news()
  {
    inform_classifier(m_classifier, frame());
    m_is_classifier_informed = true;
  }

  template <class Function>
  void call_with_ids(Function& f, Index v, Index w) const
  {
    const auto& ids = m_core->maintained.ids;
    if (!Frame::is_infinite(v) && !Frame::is_infinite(w))
      f(size_type(ids.host(v)), size_type(ids.host(w)));
  }

  Classifier m_classifier;
  Delaunay_repair m_repair;
  Policy m_policy;
  std::unique_ptr<Core> m_core;
  bool m_is_certified = true;
  bool m_is_classifier_informed = true;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
