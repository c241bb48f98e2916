// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_LAWSON_FLIPS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_LAWSON_FLIPS_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_proofs_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_editor_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Lawson's flips, started from some edges. Every edge that a flip touches is examined again, so
// what is not returned as open has been examined since its neighborhood last changed, and is
// proved.
class Lawson_flips_2
{
public:
  // Flips from the edges of `open`, and leaves those there that it could not prove. Returns the
  // number of flips.
  template <class Maintained>
  std::size_t run(const Maintained& maintained, Topology_editor_2<Maintained>& editor,
                  std::vector<Index>& open)
  {
    // Lawson's proof of termination needs counterclockwise faces; with inverted ones flips can go
    // round in circles. Recorded motion took at most 3 flips an edge to begin with.
    const std::size_t limit = 100 + 20 * open.size();
    std::size_t flips = 0;
    start(maintained.mirror.number_of_edges(), open);
    open.clear();
    while (has_edges() && flips < limit)
      if (examine(maintained, editor, take(maintained), open))
        ++flips;
    while (has_edges())
      open.push_back(take(maintained));
    keep_unproved(maintained, open);
    return flips;
  }

private:
  void start(std::size_t number_of_edges, const std::vector<Index>& edges)
  {
    m_is_waiting.resize(number_of_edges, false);
    m_queue.clear();
    m_head = 0;
    for (const Index e : edges)
      add(e, m_queue);
  }

  void add(Index e, std::vector<Index>& edges)
  {
    if (m_is_waiting[e])
      return;
    m_is_waiting[e] = true;
    edges.push_back(e);
  }

  bool has_edges() const { return !m_touched.empty() || m_head < m_queue.size(); }

  // What flips have touched comes first, while it is in the cache.
  template <class Maintained>
  Index take(const Maintained& maintained)
  {
    Index e;
    if (m_touched.empty()) {
      prefetch_ahead(maintained);
      e = m_queue[m_head++];
    } else {
      e = m_touched.back();
      m_touched.pop_back();
    }
    m_is_waiting[e] = false;
    return e;
  }

  // What the next edges in the queue need is all over the memory: at 10^5 points fetching it ahead
  // takes off an eighth of the time of a flip, at 10^6 a quarter.
  template <class Maintained>
  void prefetch_ahead(const Maintained& maintained) const
  {
    if (m_head + 8 < m_queue.size())
      maintained.mirror.prefetch_edge(m_queue[m_head + 8]);
    if (m_head + 4 < m_queue.size()) {
      const Index e = m_queue[m_head + 4];
      maintained.mirror.prefetch_face_at(e);
      prefetch_corners(maintained.mirror.edge(e), maintained.positions.data());
    }
  }

  // Flips e if it is illegal and can be flipped; notes it as open if it is not Delaunay and cannot.
  template <class Maintained>
  bool examine(const Maintained& maintained, Topology_editor_2<Maintained>& editor, Index e,
               std::vector<Index>& open)
  {
    const Edge_state_2 state = Certificate_2<Maintained>(maintained).state(e);
    if (state == Edge_state_2::DELAUNAY)
      return false;
    const auto& mirror = maintained.mirror;
    const Index h = mirror.halfedge(e);
    if (state == Edge_state_2::TWISTED || !editor.can_flip(h)) {
      open.push_back(e);
      return false;
    }
    editor.flip(h);
    const Index diagonal = mirror.halfedge(e);
    const Index twin = mirror.twin(diagonal);
    for (const Index side : {mirror.next(diagonal), mirror.previous(diagonal), mirror.next(twin),
                             mirror.previous(twin)})
      add(mirror.edge_of(side), m_touched);
    // between counterclockwise faces the quadrilateral is convex, and the new diagonal Delaunay
    if (state == Edge_state_2::CROSSED)
      add(e, m_touched);
    return true;
  }

  // What was open for want of a flip may have been righted by a later one.
  template <class Maintained>
  static void keep_unproved(const Maintained& maintained, std::vector<Index>& open)
  {
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
    const Certificate_2<Maintained> certificate(maintained);
    open.erase(
        std::remove_if(open.begin(), open.end(),
                       [&](Index e) { return certificate.state(e) == Edge_state_2::DELAUNAY; }),
        open.end());
  }

  std::vector<Index> m_queue; // the edges to start from
  std::size_t m_head = 0;     // the next of them
  std::vector<Index> m_touched;
  std::vector<char> m_is_waiting; // of each edge, in either list
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_LAWSON_FLIPS_2_H
