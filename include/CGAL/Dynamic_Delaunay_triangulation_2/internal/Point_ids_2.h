// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_IDS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_IDS_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Which vertex each id has. Points that coincide share the vertex of one of them, its host; the
// others are guests there.
template <class Point>
class Point_ids_2
{
public:
  struct Guest
  {
    Index id;
    Point point;
  };

  Index number_of_points() const { return Index(m_vertex_of_id.size()); }
  Index number_of_hosts() const { return Index(m_host.size()) - 1; }
  Index vertex(Index id) const { return m_vertex_of_id[id]; }
  Index host(Index vertex) const { return m_host[vertex]; }
  // Of each vertex.
  const Index* hosts() const { return m_host.data(); }
  bool is_host(Index id) const { return m_host[m_vertex_of_id[id]] == id; }
  const std::vector<Guest>& guests() const { return m_guests; }
  std::vector<Guest>& guests() { return m_guests; }

  const Guest& guest(Index id) const
  {
    return *std::lower_bound(m_guests.begin(), m_guests.end(), id,
                             [](const Guest& guest, Index i) { return guest.id < i; });
  }

  // All points: the hosts in the order of their vertices, then the guests.
  std::vector<Index> hosts_and_guests() const
  {
    std::vector<Index> order(m_host.begin() + 1, m_host.end());
    for (const Guest& guest : m_guests)
      order.push_back(guest.id);
    return order;
  }

  void reset(Index points)
  {
    m_vertex_of_id.assign(points, no_index);
    m_host.reserve(points + std::size_t(1));
    m_host.assign(1, no_index); // the infinite vertex has no point
    m_guests.clear();
  }

  // Gives `id` the next vertex, of which it is the host.
  Index add_host(Index id)
  {
    m_vertex_of_id[id] = Index(m_host.size());
    m_host.push_back(id);
    return m_vertex_of_id[id];
  }

  void add_guest(Index id, Index host, const Point& point)
  {
    m_vertex_of_id[id] = m_vertex_of_id[host];
    m_guests.push_back(Guest{id, point});
  }

  void sort_guests()
  {
    std::sort(m_guests.begin(), m_guests.end(),
              [](const Guest& g, const Guest& h) { return g.id < h.id; });
  }

private:
  std::vector<Index> m_vertex_of_id;
  std::vector<Index> m_host;
  std::vector<Guest> m_guests;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_IDS_2_H
