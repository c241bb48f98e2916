// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_REFINED_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_REFINED_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

/// \cond
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Whether both of two classifiers are exact, told by the type if both types tell it.
template <class First, class Second,
          bool are_known = (Knows_exactness<First>::value && Knows_exactness<Second>::value)>
struct Exactness_of_two_2
{
  static constexpr bool is_exact = First::is_exact && Second::is_exact;

  Exactness_of_two_2(const First&, const Second&) {}
};
template <class First, class Second>
class Exactness_of_two_2<First, Second, false>
{
public:
  Exactness_of_two_2(const First& first, const Second& second)
    : m_is_exact(is_classifier_exact(first) && is_classifier_exact(second))
  {
  }

  bool is_exact() const { return m_is_exact; }

private:
  bool m_is_exact;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
/// \endcond

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Reduces the picks of one classifier to those that a second classifier picks, too (thesis 7.2.1). A
classifier <em>picks</em> the vertices and edges that it names, and all edges of these vertices. The
result has
- the vertices that both name,
- the edges that one names and the other one picks,
- if both are exact, also the edges that one picks for one end, and the other one for the other end.

It is *exact* if both are: then both pick each edge that is not Delaunay, and every such edge is in
the above list.

Cost: that of the first classifier, and that of the second one at the edges that the first one
picks, if the second one has `names_edge()`; otherwise that of both in full. Allocates one or two
classifications in every frame.

\tparam First a model of `DelaunayClassifier_2`
\tparam Second a model of `DelaunayClassifier_2`

\cgalModels{DelaunayClassifier_2}
*/
template <class First, class Second>
class Refined_classifier_2
  : public Dynamic_Delaunay_triangulations_2::internal::Exactness_of_two_2<First, Second>
{
public:
#ifdef DOXYGEN_RUNNING
  /// whether it misses no edge, which is so if neither of the two does; a function if one of these
  /// is known only while a program runs.
  static constexpr bool is_exact;
#endif

  /// \param first the classifier whose picks are reduced.
  /// \param second the classifier that has to pick them, too.
  explicit Refined_classifier_2(const First& first = First(), const Second& second = Second())
    : Exactness(first, second)
    , m_first(first)
    , m_second(second)
  {
  }

  /// the classifier whose picks are reduced.
  const First& first() const
  {
    return m_first;
  }
  /// the classifier that has to pick them, too.
  const Second& second() const
  {
    return m_second;
  }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    Classification first = classified.empty_copy();
    m_first(frame, first);
    if (first.hull_turns_once())
      classified.set_hull_turns_once();
    using Dynamic_Delaunay_triangulations_2::internal::Has_names_edge;
    if constexpr (Has_names_edge<Second, Frame>::value)
      ask_edge_by_edge(frame, first, classified);
    else
      ask(frame, first, classified);
  }

  /// informs both classifiers.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    inform_classifier(m_first, frame);
    inform_classifier(m_second, frame);
  }

private:
  using Exactness = Dynamic_Delaunay_triangulations_2::internal::Exactness_of_two_2<First, Second>;
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;

  // Asks a second classifier that has names_edge(), and so names edges only.
  template <class Frame, class Classification>
  void ask_edge_by_edge(const Frame& frame, const Classification& first, Classification& classified)
  {
    if (frame.has_changes())
      inform_classifier(m_second, frame); // as its operator() would do
    m_seen.clear(frame.number_of_edges());
    const std::size_t first_illegal = first.edges().size() - first.number_of_illegal_edges();
    for (std::size_t i = 0; i < first.edges().size(); ++i) {
      const Edge_index e = first.edges()[i];
      if (m_seen.insert(e) && m_second.names_edge(frame, e))
        add_edge(e, i >= first_illegal, classified);
    }
    for (const Vertex_index v : first.whole_vertices())
      frame.for_each_incident_edge(v, [&](Edge_index e) {
        if (m_seen.insert(e) && m_second.names_edge(frame, e))
          classified.add_edge(e);
      });
  }

  template <class Frame, class Classification>
  void ask(const Frame& frame, const Classification& first, Classification& classified)
  {
    Classification second = classified.empty_copy();
    m_second(frame, second);
    for (const Vertex_index v : first.whole_vertices())
      if (second.is_whole_vertex(v))
        classified.add_vertex(v);
    m_seen.clear(frame.number_of_edges());
    m_named.clear(frame.number_of_edges());
    for (const Edge_index e : second.edges())
      m_named.insert(e);
    keep_named(
        frame, first, second, [this](Edge_index e) { return m_named.contains(e); }, classified);
    keep_named(
        frame, second, first, [](Edge_index) { return false; },
        classified); // edges that both name are in already
    if (is_classifier_exact(*this))
      keep_of_opposite_ends(frame, first, second, classified);
    if (second.hull_turns_once())
      classified.set_hull_turns_once();
  }

  // Adds the edges that `namer` names, if `other` names them, too, or names one of their ends.
  template <class Frame, class Classification, class Is_named>
  void keep_named(const Frame& frame, const Classification& namer, const Classification& other,
                  Is_named is_named, Classification& classified)
  {
    const auto& edges = namer.edges();
    const std::size_t first_illegal = edges.size() - namer.number_of_illegal_edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto& edge = frame.edge(edges[i]);
      const bool is_picked = is_named(edges[i]) || other.is_whole_vertex(edge.source) ||
                             other.is_whole_vertex(edge.target);
      if (is_picked && m_seen.insert(edges[i]))
        add_edge(edges[i], i >= first_illegal, classified);
    }
  }

  template <class Classification>
  static void add_edge(Edge_index e, bool is_illegal, Classification& classified)
  {
    if (is_illegal)
      classified.add_illegal_edge(e);
    else
      classified.add_edge(e);
  }

  template <class Frame, class Classification>
  void keep_of_opposite_ends(const Frame& frame, const Classification& first,
                             const Classification& second, Classification& classified)
  {
    for (const Vertex_index v : first.whole_vertices())
      if (!second.is_whole_vertex(v))
        frame.for_each_incident_edge(v, [&](Edge_index e) {
          const auto& edge = frame.edge(e);
          const Vertex_index w = edge.source == v ? edge.target : edge.source;
          if (second.is_whole_vertex(w) && !first.is_whole_vertex(w) && m_seen.insert(e))
            classified.add_edge(e);
        });
  }

  First m_first;
  Second m_second;
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Edge_index> m_seen;  // edges
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Edge_index> m_named; // edges, by the second one
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_REFINED_CLASSIFIER_2_H
