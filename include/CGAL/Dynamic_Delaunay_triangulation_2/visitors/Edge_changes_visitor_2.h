// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_CHANGES_VISITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_CHANGES_VISITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Collects changes of edges, positive for creations and negative for removals, and lists the edges
// that these have created or removed in the end.
template <class Edge>
class Edge_balance_2
{
public:
  void note(const Edge& edge, int sign)
  {
    m_changes.push_back({edge, sign});
    m_are_listed = false;
  }
  void clear()
  {
    m_changes.clear();
    m_are_listed = false;
  }
  // Calls f(edge), which may rename the edge, for each change.
  template <class Function>
  void rename(const Function& f)
  {
    for (Change& change : m_changes)
      f(change.edge);
    m_are_listed = false;
  }
  // Call it if `list()` would give edges other names than before.
  void forget_lists() { m_are_listed = false; }

  // Lists the edges whose changes do not cancel, as `name(edge)`, in ascending order. Does nothing
  // if they are listed already.
  template <class Name>
  void list(const Name& name)
  {
    if (m_are_listed)
      return;
    m_created.clear();
    m_removed.clear();
    std::sort(m_changes.begin(), m_changes.end(),
              [](const Change& a, const Change& b) { return a.edge < b.edge; });
    for (auto change = m_changes.begin(); change != m_changes.end();) {
      const Edge edge = change->edge;
      int sum = 0;
      for (; change != m_changes.end() && change->edge == edge; ++change)
        sum += change->sign;
      if (sum != 0)
        (sum > 0 ? m_created : m_removed).push_back(name(edge));
    }
    std::sort(m_created.begin(), m_created.end());
    std::sort(m_removed.begin(), m_removed.end());
    m_are_listed = true;
  }
  const std::vector<Edge>& created() const { return m_created; }
  const std::vector<Edge>& removed() const { return m_removed; }

private:
  struct Change
  {
    Edge edge;
    int sign;
  };

  std::vector<Change> m_changes;
  std::vector<Edge> m_created, m_removed;
  bool m_are_listed = true;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Visitors

Lists the finite edges that were created and removed since `clear()` was last called, or since the
visitor was constructed. An edge that was removed and created again in between is in neither list.
So the edges at that time, minus `removed_edges()` and plus `created_edges()`, are the current
edges, as `Dynamic_Delaunay_triangulation_2::for_each_edge()` lists them.

Cost: proportional to the number of flips and of created and removed faces; a rebuild counts as all
faces. Asking for the lists costs that number times its logarithm. Nothing is allocated if there was
as much to record before. The lists are computed when they are asked for, so several threads must
not ask at once.

\cgalModels{DelaunayUpdateVisitor_2}
*/
class Edge_changes_visitor_2 : public Delaunay_update_visitor_base_2
{
public:
  /// the ids of the two ends of an edge, the smaller one first.
  using Edge = std::pair<std::size_t, std::size_t>;

  /// the created edges, in ascending order.
  const std::vector<Edge>& created_edges() const { return listed().created(); }

  /// the removed edges, in ascending order. Their ids may belong to points that no longer exist, or
  /// to new points that got the same ids.
  const std::vector<Edge>& removed_edges() const { return listed().removed(); }

  /// forgets all recorded changes, and starts to record anew.
  void clear()
  {
    m_changes.clear();
    m_is_in_update = false;
  }

  /// \cond
  template <class Dynamic>
  void before_update(const Dynamic& dt)
  {
    if (!std::exchange(m_is_in_update, true)) // false after an exception
      note_line(dt, -whole);
  }

  template <class Dynamic>
  void after_update(const Dynamic& dt, const Update_report_2&)
  {
    m_is_in_update = false;
    note_line(dt, whole);
  }

  template <class Dynamic>
  void before_flip(const Dynamic& dt, const typename Dynamic::Edge& e)
  {
    note(dt, e.first, e.second, -whole);
  }

  template <class Dynamic>
  void after_flip(const Dynamic& dt, const typename Dynamic::Edge& e)
  {
    note(dt, e.first, e.second, whole);
  }

  template <class Dynamic>
  void before_face_removal(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    for (int i = 0; i < 3; ++i)
      note(dt, f, i, -half);
  }

  template <class Dynamic>
  void after_face_creation(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    for (int i = 0; i < 3; ++i)
      note(dt, f, i, half);
  }

  template <class Dynamic>
  void after_id_change(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id_before)
  {
    if (dt.tds().dimension() < 2)
      return;
    const auto first = dt.tds().incident_vertices(v);
    auto w = first;
    do {
      if (w != dt.infinite_vertex()) {
        note(id_before, dt.id(w), -whole);
        note(dt.id(v), dt.id(w), whole);
      }
    } while (++w != first);
  }

protected:
  // An edge has two faces, and each face contributes half of it.
  static constexpr int half = 1;
  static constexpr int whole = 2;

  void note(std::size_t i, std::size_t j, int sign) { m_changes.note(std::minmax(i, j), sign); }
  /// \endcond

private:
  using Changes = Dynamic_Delaunay_triangulations_2::internal::Edge_balance_2<Edge>;

  const Changes& listed() const
  {
    m_changes.list([](const Edge& edge) { return edge; });
    return m_changes;
  }

  // While there are no faces, notes all edges as removed before an update, and as created after it.
  template <class Dynamic>
  void note_line(const Dynamic& dt, int sign)
  {
    if (dt.tds().dimension() < 2)
      dt.for_each_edge([&](std::size_t i, std::size_t j) { note(i, j, sign); });
  }

  template <class Dynamic>
  void note(const Dynamic& dt, typename Dynamic::Face_handle f, int i, int sign)
  {
    const auto v = f->vertex(dt.tds().ccw(i)), w = f->vertex(dt.tds().cw(i));
    if (v != dt.infinite_vertex() && w != dt.infinite_vertex())
      note(dt.id(v), dt.id(w), sign);
  }

  mutable Changes m_changes;
  bool m_is_in_update = false;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_CHANGES_VISITOR_2_H
