// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_CLASSIFICATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_CLASSIFICATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Shared_marks.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The Classified set of a frame (thesis 4.1.3), which a classifier fills.

\tparam State an internal type.
*/
template <class State>
class Dynamic_classification_2
{
public:
  /// the type of all numbers, as in `Dynamic_frame_2`.
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index; ///< the number of a vertex.
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;     ///< the number of an edge.
  using Point_id = Dynamic_Delaunay_triangulations_2::Point_id;         ///< the id of a point.

  /// \cond
  void clear(const State& state)
  {
    m_state = &state;
    m_vertices.clear(state.positions().size());
    m_whole_vertices.clear(state.positions().size());
    m_edges.clear();
    m_number_of_illegal = 0;
    m_hull_turns_once = false;
  }
  /// \endcond

  /// returns an empty classification of the same frame, for classifiers that ask others.
  Dynamic_classification_2 empty_copy() const
  {
    Dynamic_classification_2 copy;
    copy.clear(*m_state);
    return copy;
  }

  /// classifies vertex `v`; does nothing if it is the infinite vertex. For every edge that is not
  /// Delaunay, an exact classifier must either classify one of its ends in this way, or pass the
  /// edge to `add_edge()`.
  /// \throws Unknown_index_error_2 if there is no such vertex.
  void add_vertex(Vertex_index v)
  {
    if (v >= m_state->positions().size())
      throw Unknown_index_error_2("vertex", v, m_state->positions().size());
    if (v != Dynamic_Delaunay_triangulations_2::internal::infinite_index) {
      m_vertices.insert(v);
      m_whole_vertices.insert(v);
    }
  }

  /// classifies the vertex of the point `id`.
  /// \throws Unknown_id_error_2 if no point has this id.
  void add_id(std::size_t id)
  {
    if (!m_state->ids().is_taken(id))
      throw Unknown_id_error_2(id, m_state->ids().number_of_ids());
    add_vertex(m_state->ids().vertex(Point_id(id)));
  }
  void add_id(Vertex_index) = delete; ///< a vertex is no id.

  /// classifies the four vertices of edge `e` because of that edge alone: repairs that work on
  /// edges start at `e`, and need not test the other edges of its vertices.
  /// \throws Unknown_index_error_2 if there is no such edge.
  void add_edge(Edge_index e) { add(e, false); }

  /// classifies all vertices, because of all edges. Cost: a few nanoseconds a vertex, less than
  /// adding them one by one.
  void add_everything()
  {
    const Index bound = Index(m_state->positions().size());
    m_vertices.fill(1, bound);
    m_whole_vertices.fill(1, bound);
  }

  /// classifies the four vertices of edge `e`, which must be in the state `ILLEGAL`, as
  /// `add_edge()` does. Flipping the edge costs less then.
  /// \throws Unknown_index_error_2 if there is no such edge.
  void add_illegal_edge(Edge_index e) { add(e, true); }

  /// classifies edge `e` of `frame` unless it is Delaunay. Decided exactly.
  template <class Frame>
  void add_unless_delaunay(const Frame& frame, Edge_index e)
  {
    using Dynamic_Delaunay_triangulations_2::Edge_state_2;
    const Edge_state_2 state = frame.edge_state(e);
    if (state != Edge_state_2::DELAUNAY)
      add(e, state == Edge_state_2::ILLEGAL);
  }

  /// classifies those edges of a list that are not Delaunay. Prefetches their data.
  template <class Frame>
  void add_unless_delaunay(const Frame& frame, const std::vector<Edge_index>& edges)
  {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      prefetch_some(edges, i);
      add_unless_delaunay(frame, edges[i]);
    }
  }

  /// classifies those edges of several lists that are not Delaunay: first those that are not
  /// illegal, each time in the order of the lists. If there are several, the vertices are
  /// ascending. Threads share the work if there are many lists and the triangulation has the
  /// `Parallel_tag`.
  template <class Frame>
  void add_unless_delaunay(const Frame& frame, const std::vector<std::vector<Edge_index>>& lists)
  {
    if (lists.size() == 1)
      return add_unless_delaunay(frame, lists.front());
    using Parts = typename Frame::Parts;
    m_broken.resize((std::max)(lists.size(), m_broken.size()));
    m_marks.reserve(m_state->positions().size());
    try {
      Parts::run(lists.size(),
                 [&](std::size_t part) { find_broken(frame, lists[part], m_broken[part]); });
      m_vertices.template insert_words<Parts>(
          [this](std::size_t word) { return m_marks.take(word); });
    } catch (...) {
      m_marks.clear();
      throw;
    }
    list_broken<Parts>(lists.size());
    if (m_edges.size() > m_state->positions().size()) // the repair needs the memory
      std::vector<Broken_edges>().swap(m_broken);
  }

  /// records that the classifier has proved that the hull turns around once, so that this is not
  /// tested again.
  void set_hull_turns_once() { m_hull_turns_once = true; }

  /// whether all vertices are classified because of all their edges.
  bool is_everything() const { return m_whole_vertices.size() + 1 == m_state->positions().size(); }
  /// how many of `edges()` were given to `add_illegal_edge()`; they are the last ones.
  std::size_t number_of_illegal_edges() const { return m_number_of_illegal; }
  /// whether `set_hull_turns_once()` was called.
  bool hull_turns_once() const { return m_hull_turns_once; }

  /// whether nothing is classified.
  bool empty() const { return m_vertices.empty(); }
  /// the number of classified vertices.
  std::size_t size() const { return m_vertices.size(); }
  /// the classified vertices, in the order of their classification.
  const std::vector<Vertex_index>& vertices() const { return m_vertices.members(); }
  /// the vertices given to `add_vertex()` or `add_id()`.
  const std::vector<Vertex_index>& whole_vertices() const { return m_whole_vertices.members(); }
  /// whether vertex `v` was given to `add_vertex()` or `add_id()`.
  bool is_whole_vertex(Vertex_index v) const { return m_whole_vertices.contains(v); }
  /// the edges given to `add_edge()` or `add_illegal_edge()`; see `number_of_illegal_edges()` for
  /// their order.
  const std::vector<Edge_index>& edges() const { return m_edges; }

private:
  struct Broken_edges
  {
    std::vector<Edge_index> illegal, others;
  };

  // Finds the edges that are not Delaunay, and marks their vertices.
  template <class Frame>
  void find_broken(const Frame& frame, const std::vector<Edge_index>& edges, Broken_edges& broken)
  {
    using Dynamic_Delaunay_triangulations_2::Edge_state_2;
    broken.illegal.clear();
    broken.others.clear();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      prefetch_some(edges, i);
      const Edge_state_2 state = frame.edge_state(edges[i]);
      if (state == Edge_state_2::DELAUNAY)
        continue;
      (state == Edge_state_2::ILLEGAL ? broken.illegal : broken.others).push_back(edges[i]);
      for_each_finite(vertices_of(edges[i]), [this](Vertex_index v) { m_marks.mark(v); });
    }
  }

  // Illegal edges are the last ones.
  template <class Parts>
  void list_broken(std::size_t lists)
  {
    using Dynamic_Delaunay_triangulations_2::internal::append_lists;
    const auto before = m_edges.end() - std::ptrdiff_t(m_number_of_illegal);
    const std::vector<Edge_index> illegal(before, m_edges.end());
    m_edges.erase(before, m_edges.end());
    append_lists<Parts>(
        lists, [this](std::size_t i) -> const auto& { return m_broken[i].others; }, m_edges);
    m_edges.insert(m_edges.end(), illegal.begin(), illegal.end());
    const std::size_t size = m_edges.size();
    append_lists<Parts>(
        lists, [this](std::size_t i) -> const auto& { return m_broken[i].illegal; }, m_edges);
    m_number_of_illegal += m_edges.size() - size;
  }

  // Prefetches the data of the edges that a pass over `edges` will test soon after edge i.
  void prefetch_some(const std::vector<Edge_index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 8;
    const auto& arrays = m_state->arrays();
    if (i + 2 * ahead < edges.size())
      arrays.prefetch_edge(edges[i + 2 * ahead]);
    if (i + ahead < edges.size())
      Dynamic_Delaunay_triangulations_2::internal::prefetch_corners(arrays.edge(edges[i + ahead]),
                                                                    m_state->positions().data());
  }

  void add(Edge_index e, bool is_illegal)
  {
    if (e >= m_state->arrays().number_of_edges())
      throw Unknown_index_error_2("edge", e, m_state->arrays().number_of_edges());
    list(e, is_illegal);
    for_each_finite(vertices_of(e), [this](Vertex_index v) { m_vertices.insert(v); });
  }

  void list(Edge_index e, bool is_illegal)
  {
    m_edges.push_back(e);
    if (is_illegal)
      ++m_number_of_illegal;
    else // illegal edges are the last ones
      std::swap(m_edges.back(), m_edges[m_edges.size() - 1 - m_number_of_illegal]);
  }

  std::array<Vertex_index, 4> vertices_of(Edge_index e) const
  {
    const auto& edge = m_state->edge(e);
    return {edge.source, edge.target, edge.left, edge.right};
  }

  template <class Function>
  static void for_each_finite(const std::array<Vertex_index, 4>& vertices, const Function& f)
  {
    for (const Vertex_index v : vertices)
      if (v != Dynamic_Delaunay_triangulations_2::internal::infinite_index)
        f(v);
  }

  const State* m_state = nullptr;
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Vertex_index> m_vertices;
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Vertex_index> m_whole_vertices;
  std::vector<Edge_index> m_edges;
  Dynamic_Delaunay_triangulations_2::internal::Shared_marks<Vertex_index> m_marks;
  std::vector<Broken_edges> m_broken; // of each list
  std::size_t m_number_of_illegal = 0;
  bool m_hull_turns_once = false;
};

/// \cond
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

template <class Classifier, class Frame, class = void>
struct Wants_to_be_informed : std::false_type
{
};
template <class Classifier, class Frame>
struct Wants_to_be_informed<
    Classifier, Frame,
    std::void_t<decltype(std::declval<Classifier&>().after_update(std::declval<const Frame&>()))>>
  : std::true_type
{
};

// Whether a type of classifiers tells if they are exact. If not, each object does.
template <class Classifier, class = void>
struct Knows_exactness : std::false_type
{
};
template <class Classifier>
struct Knows_exactness<
    Classifier,
    std::enable_if_t<std::is_same_v<std::decay_t<decltype(Classifier::is_exact)>, bool>>>
  : std::true_type
{
};

template <class Classifier, class Frame, class = void>
struct Has_names_edge : std::false_type
{
};
template <class Classifier, class Frame>
struct Has_names_edge<Classifier, Frame,
                      std::void_t<decltype(std::declval<const Classifier&>().names_edge(
                          std::declval<const Frame&>(), Edge_index()))>> : std::true_type
{
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
/// \endcond

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

returns whether a classifier is exact, where its type may not tell. For classifiers that ask other
classifiers.
*/
template <class Classifier>
bool is_classifier_exact([[maybe_unused]] const Classifier& classifier)
{
  using namespace Dynamic_Delaunay_triangulations_2::internal;
  if constexpr (Knows_exactness<Classifier>::value)
    return Classifier::is_exact;
  else
    return classifier.is_exact();
}

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

calls the classifier's `after_update(frame)`, which is optional in `DelaunayClassifier_2`, if it has
one. For classifiers that ask other classifiers.
*/
template <class Classifier, class Frame>
void inform_classifier(Classifier& classifier, const Frame& frame)
{
  using namespace Dynamic_Delaunay_triangulations_2::internal;
  if constexpr (Wants_to_be_informed<Classifier, Frame>::value)
    classifier.after_update(frame);
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_CLASSIFICATION_2_H
