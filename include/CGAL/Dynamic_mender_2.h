// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_MENDER_2_H
#define CGAL_DYNAMIC_MENDER_2_H

#include <CGAL/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Border_splice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distinct_numbers_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_examination_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Lawson_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Planar_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Population_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_editor_2.h>
#include <CGAL/Dynamic_frame_2.h>
#include <CGAL/Static_engine_2.h>
#include <CGAL/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The tools that a repair works with: it calls them in the order that it likes. A mender knows what
was classified and which edges are still *open*, that is, not yet proved Delaunay; each tool works
on these, and what it opens and cannot close again stays open. At the start the open edges are those
that the classifier named, and all edges of the vertices that it named.

\tparam Maintained an internal type.
*/
template <class Maintained>
class Dynamic_mender_2
{
  using Editor = Dynamic_Delaunay_triangulations_2::internal::Topology_editor_2<Maintained>;
  using Certificate = Dynamic_Delaunay_triangulations_2::internal::Certificate_2<Maintained>;
  using Edge_state = Dynamic_Delaunay_triangulations_2::internal::Edge_state_2;
  using Splice_result = Dynamic_Delaunay_triangulations_2::internal::Splice_result_2;

public:
  /// as in `Dynamic_frame_2`.
  using Index = Dynamic_Delaunay_triangulations_2::Index;

  /// \cond
  explicit Dynamic_mender_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_editor(maintained)
    , m_builder(maintained)
    , m_population(maintained, m_editor, m_builder)
    , m_splice(maintained)
  {
  }

  auto& population() { return m_population; }

  void set_engines(const Static_engines_2& engines)
  {
    m_builder.set_engine(engines.whole);
    m_splice.set_engine(engines.region);
  }

  // The triangulation becomes another one. Throws nothing.
  void exchange(Maintained& other)
  {
    m_builder.exchange(other);
    m_classification = Dynamic_classification_2<Maintained>();
    m_padded.clear();
    m_border.clear();
  }

  // Before the classifier is asked.
  Dynamic_classification_2<Maintained>& start(Update_report_2& report)
  {
    m_report = &report;
    m_is_planar = false;
    m_open.clear();
    m_illegal.clear();
    m_padded.clear();
    m_border.clear();
    m_classification.clear(m_maintained);
    return m_classification;
  }

  // Opens the edges that were triangulated anew, and those that got another opposite vertex by
  // that, without asking anybody.
  void open_news(bool has_to_prove)
  {
    m_has_to_prove = has_to_prove;
    m_was_certified = false;
    m_is_planar = false; // points may have come since that was proved
    const Dynamic_frame_2<Maintained> frame(m_maintained);
    frame.for_each_changed_edge([this](Index e) { m_open.push_back(e); });
    Dynamic_Delaunay_triangulations_2::internal::make_distinct(m_open);
  }

  // Classifies all edges that are not Delaunay.
  void classify_everything()
  {
    Circumcircle_classifier_2()(Dynamic_frame_2<Maintained>(m_maintained), m_classification);
    take_classification(true, false);
  }

  // Classifies the edges that see one of these points, and are not Delaunay.
  void classify_around(const std::vector<Index>& ids, bool has_to_prove)
  {
    const Dynamic_frame_2<Maintained> frame(m_maintained);
    std::vector<Index> edges;
    for (const Index id : ids)
      frame.for_each_edge_that_sees(frame.vertex(id), [&](Index e) { edges.push_back(e); });
    Dynamic_Delaunay_triangulations_2::internal::make_distinct(edges);
    Dynamic_Delaunay_triangulations_2::internal::examine_all(frame, edges, m_classification);
    take_classification(has_to_prove, false);
  }

  // After it has answered.
  void take_classification(bool has_to_prove, bool was_certified)
  {
    m_has_to_prove = has_to_prove;
    m_was_certified = was_certified;
    m_report->classified = m_classification.size();
    open_classified();
    m_is_planar = number_of_open_edges() == 0 && m_classification.hull_turns_once();
  }

  // Whether the last tool has proved that the faces tile the convex hull; if no tool was used,
  // whether the classifier has.
  bool is_planar() const { return m_is_planar; }
  const std::vector<Index>& padded() const { return m_padded; }
  const std::vector<Index>& border() const { return m_border; }
  /// \endcond

  /// \name What There Is to Do
  /// @{

  /// what the classifier picked.
  const Dynamic_classification_2<Maintained>& classification() const { return m_classification; }
  /// whether the update has to end with a proof: the classifier is exact. If it has, and edges are
  /// left open, the triangulation is rebuilt after the repair.
  bool has_to_prove() const { return m_has_to_prove; }
  /// the number of open edges.
  std::size_t number_of_open_edges() const { return m_open.size() + m_illegal.size(); }
  /// whether there are open edges other than those between faces that are known to be
  /// counterclockwise.
  bool has_inverted_edges() const { return !m_open.empty(); }
  /// the number of all edges.
  std::size_t number_of_edges() const { return m_maintained.mirror.number_of_edges(); }
  /// whether there is nothing left to do.
  bool is_done() const { return number_of_open_edges() == 0 || m_report->rebuilt(); }

  /// @}
  /// \name Tools
  /// @{

  /// flips edges from the open ones on until none that can be flipped violates the in-circle
  /// condition (Lawson). Expected cost: proportional to the number of flips. Leaves open what it
  /// cannot right: at inverted faces flips can get stuck.
  void flip()
  {
    if (!m_is_planar)
      flip_inverted();
    open_illegal();
    flip_open();
  }

  /// the same for those open edges only that may have inverted faces, and what is around them; the
  /// others stay open. If none is left, the faces tile the convex hull, which makes other flips
  /// cheaper: they cannot double an edge, so that need not be looked for.
  void flip_inverted()
  {
    if (m_report->rebuilt())
      return;
    flip_open();
    if (!m_open.empty()) {
      open_surroundings();
      flip_open();
    }
    m_is_planar = m_has_to_prove && m_open.empty() && Certificate(m_maintained).hull_turns_once();
  }

  /// splices around the classified vertices with `padding` layers; with a heuristic classifier all
  /// edges count as closed after it, looked at or not. Rebuilds if the region holds
  /// more than half of the vertices, also after it had to grow, or, with a heuristic classifier, if
  /// points in it coincide; with an exact one they become one vertex, and everything is looked at
  /// again.
  void splice_classified(unsigned padding)
  {
    open_illegal();
    if (splice(m_classification.vertices(), padding, m_has_to_prove)) {
      for (std::size_t i = 0; i < m_splice.number_of_padded(); ++i)
        m_padded.push_back(m_splice.padded(i));
      m_border.assign(m_splice.border().begin(), m_splice.border().end());
    }
  }

  /// splices around the vertices of the open edges with `padding` layers, and leaves those edges
  /// open that it could not prove. Rebuilds as `splice_classified()` does.
  void splice_open(unsigned padding)
  {
    open_illegal();
    splice_inverted(padding);
  }

  /// the same around those open edges only that may have inverted faces.
  void splice_inverted(unsigned padding)
  {
    std::vector<Index> vertices;
    for_each_open_vertex([&](Index v) { vertices.push_back(v); });
    splice(vertices, padding, true);
  }

  /// lets CGAL's `move_if_no_collision()` bring one vertex after the other from where it was a
  /// frame ago to where it is now. Rebuilds if the triangulation was not certified a frame ago, if
  /// it was rebuilt since, or if points coincide.
  void relocate()
  {
    if (!m_was_certified || m_maintained.points_are_written)
      return rebuild(Rebuild_reason_2::STUCK);
    const bool all_arrived = relocate_all();
    m_open.clear();
    m_illegal.clear();
    if (!all_arrived)
      rebuild(Rebuild_reason_2::COINCIDENCE);
    else if (!m_maintained.is_mirrored()) // nobody else can do anything without edges
      rebuild(Rebuild_reason_2::DIMENSION);
    else if (!Certificate(m_maintained).holds())
      rebuild(Rebuild_reason_2::STUCK);
  }

  /// triangulates everything anew, in the order of the last triangulation, and closes all edges.
  /// That may number the vertices anew, so the sets of classified, padded and border vertices are
  /// empty then.
  void rebuild(Rebuild_reason_2 reason)
  {
    m_builder.rebuild();
    m_report->rebuild_reason = m_maintained.is_mirrored() ? reason : Rebuild_reason_2::DIMENSION;
    m_open.clear();
    m_illegal.clear();
    m_padded.clear();
    m_border.clear();
    m_classification.clear(m_maintained);
  }

  /// @}

private:
  // The edges that the classifier has named.
  void open_classified()
  {
    m_open.clear();
    m_illegal.clear();
    if (m_classification.is_everything()) {
      m_open.resize(number_of_edges());
      std::iota(m_open.begin(), m_open.end(), Index(0));
      return;
    }
    const Dynamic_frame_2<Maintained> frame(m_maintained);
    for (const Index v : m_classification.whole_vertices())
      frame.for_each_incident_edge(v, [this](Index e) { m_open.push_back(e); });
    const auto& edges = m_classification.edges();
    const auto illegal = edges.end() - std::ptrdiff_t(m_classification.number_of_illegal_edges());
    m_open.insert(m_open.end(), edges.begin(), illegal);
    m_illegal.assign(illegal, edges.end());
  }

  void open_illegal()
  {
    m_open.insert(m_open.end(), m_illegal.begin(), m_illegal.end());
    m_illegal.clear();
  }

  // What hinders the flips of an open edge may be another edge nearby that is illegal.
  void open_surroundings()
  {
    const Dynamic_frame_2<Maintained> frame(m_maintained);
    std::vector<Index> edges;
    for_each_open_vertex(
        [&](Index v) { frame.for_each_edge_that_sees(v, [&](Index e) { edges.push_back(e); }); });
    m_open.insert(m_open.end(), edges.begin(), edges.end());
    Dynamic_Delaunay_triangulations_2::internal::make_distinct(m_open);
  }

  // The finite ones, some of them more than once.
  template <class Function>
  void for_each_open_vertex(const Function& f) const
  {
    for (const Index e : m_open) {
      const auto& edge = m_maintained.mirror.edge(e);
      for (const Index v : {edge.source, edge.target, edge.left, edge.right})
        if (!Dynamic_frame_2<Maintained>::is_infinite(v))
          f(v);
    }
  }

  void flip_open()
  {
    // the neighborhoods that it has looked at count as triangulated anew
    auto& new_edges = m_maintained.new_edges;
    new_edges.insert(new_edges.end(), m_open.begin(), m_open.end());
    m_report->flips += m_lawson.run(m_maintained, m_editor, m_open, m_is_planar);
  }

  // False if it has rebuilt or merged instead; then vertices may have other numbers.
  bool splice(const std::vector<Index>& vertices, unsigned padding, bool has_to_look)
  {
    m_is_planar = false;
    std::size_t growths = 0;
    const Splice_result result = m_splice.run(m_editor, vertices, padding, growths);
    m_report->growths += growths;
    if (result == Splice_result::TOO_LARGE)
      rebuild(growths == 0 ? Rebuild_reason_2::TOO_MUCH_BROKEN : Rebuild_reason_2::STUCK);
    else if (result == Splice_result::COINCIDENCE)
      merge();
    if (result != Splice_result::DONE)
      return false;
    ++m_report->splices;
    m_report->padded += m_splice.number_of_padded();
    m_report->border += m_splice.number_of_border();
    m_report->spliced += m_splice.number_of_vertices();
    if (has_to_look)
      reopen();
    else
      m_open.clear();
    return true;
  }

  // The spliced faces are Delaunay among themselves; what lies across their boundary may not be.
  // Open edges elsewhere stay open.
  void reopen()
  {
    const Certificate certificate(m_maintained);
    const auto& boundary = m_splice.boundary_edges();
    m_open.insert(m_open.end(), boundary.begin(), boundary.end());
    Dynamic_Delaunay_triangulations_2::internal::make_distinct(m_open);
    m_open.erase(
        std::remove_if(m_open.begin(), m_open.end(),
                       [&](Index e) { return certificate.state(e) == Edge_state::DELAUNAY; }),
        m_open.end());
  }

  // Vertices that have come to coincide become one; then all edges are looked at.
  void merge()
  {
    std::vector<Index> candidates = m_splice.region();
    for_each_open_vertex([&](Index v) { candidates.push_back(v); });
    Dynamic_Delaunay_triangulations_2::internal::make_distinct(candidates);
    const std::size_t merged = m_has_to_prove ? m_population.merge(candidates) : 0;
    if (merged == 0)
      return rebuild(Rebuild_reason_2::COINCIDENCE);
    m_report->merged += merged;
    m_padded.clear();
    m_border.clear();
    m_classification.clear(m_maintained);
    std::vector<Index> edges;
    const Dynamic_frame_2<Maintained> frame(m_maintained);
    Dynamic_Delaunay_triangulations_2::internal::find_unproved(frame, edges);
    Dynamic_Delaunay_triangulations_2::internal::examine_all(frame, edges, m_classification);
    open_classified();
  }

  // By CGAL's means, and reads back what it has made of the faces. False if some vertices could not
  // go: others are, or stay, where they have to.
  bool relocate_all()
  {
    const Dynamic_Delaunay_triangulations_2::internal::All_faces_anew_2<Maintained> anew(
        m_maintained);
    const bool all_arrived = relocate_one_by_one();
    m_maintained.write_points();
    m_builder.read_back();
    return all_arrived;
  }

  bool relocate_one_by_one()
  {
    using Dynamic_Delaunay_triangulations_2::internal::coincide;
    std::vector<Index> waiting;
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
      if (!coincide(m_maintained.traits(), m_maintained.point(v), m_maintained.previous_point(v)))
        waiting.push_back(v);
    // whoever finds its place taken tries again when the others have moved on
    for (std::size_t before = waiting.size() + 1; !waiting.empty() && waiting.size() < before;) {
      before = waiting.size();
      waiting.erase(std::remove_if(waiting.begin(), waiting.end(),
                                   [this](Index v) {
                                     const bool arrived =
                                         m_builder.relocate(v, m_maintained.point(v));
                                     m_report->relocated += arrived;
                                     return arrived;
                                   }),
                    waiting.end());
    }
    return waiting.empty();
  }

  Maintained& m_maintained;
  Editor m_editor;
  Dynamic_Delaunay_triangulations_2::internal::Topology_builder_2<Maintained> m_builder;
  Dynamic_Delaunay_triangulations_2::internal::Population_editor_2<Maintained> m_population;
  Dynamic_Delaunay_triangulations_2::internal::Lawson_flips_2 m_lawson;
  Dynamic_Delaunay_triangulations_2::internal::Border_splice_2<Maintained> m_splice;
  Dynamic_classification_2<Maintained> m_classification;
  // the open edges: those that are known to be illegal between counterclockwise faces, and others
  std::vector<Index> m_open, m_illegal;
  std::vector<Index> m_padded, m_border;
  Update_report_2* m_report = nullptr;
  bool m_has_to_prove = false;
  bool m_was_certified = false;
  bool m_is_planar = false;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_MENDER_2_H
