// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_CHANGES_VISITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_CHANGES_VISITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_balance.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

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
  using Changes = Dynamic_Delaunay_triangulations_2::internal::Edge_balance<Edge>;

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
