// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_IDS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_IDS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Provided_memory_2.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Which vertex each id has. Points that coincide share the vertex of one of them, its host; the
// others are guests there. Ids of removed points are free, and given again, the smallest first.
template <class Point>
class Point_ids_2
{
public:
  struct Guest
  {
    Index id;
    Point point;
  };

  // Ids are smaller than this.
  Index number_of_ids() const { return Index(m_vertex_of_id.size()); }
  Index number_of_points() const { return number_of_hosts() + Index(m_guests.size()); }
  bool has_host(Index vertex) const { return m_host[vertex] != no_index; }
  Index number_of_hosts() const { return Index(m_host.size()) - 1; }
  bool is_taken(std::size_t id) const
  {
    return id < m_vertex_of_id.size() && m_vertex_of_id[id] != no_index;
  }
  Index vertex(Index id) const { return m_vertex_of_id[id]; }
  Index host(Index vertex) const { return m_host[vertex]; }
  // Of each vertex.
  const Index* hosts() const { return m_host.data(); }
  // Of an id that is taken.
  bool is_host(Index id) const { return m_host[m_vertex_of_id[id]] == id; }
  const std::vector<Guest>& guests() const { return m_guests; }
  std::vector<Guest>& guests() { return m_guests; }

  const Guest& guest(Index id) const { return *find_guest(m_guests, id); }
  Guest& guest(Index id) { return *find_guest(m_guests, id); }

  // All points: the hosts in the order of their vertices, then the guests.
  std::vector<Index> hosts_and_guests() const
  {
    std::vector<Index> order(m_host.begin() + 1, m_host.end());
    for (const Guest& guest : m_guests)
      order.push_back(guest.id);
    return order;
  }

  // The ids that the next points get, one after the other. Cost: proportional to their number,
  // times its logarithm.
  std::vector<Index> next_ids(std::size_t number) const
  {
    std::vector<Index> ids;
    const auto comes_later = [this](std::size_t i, std::size_t j) {
      return m_free_ids[i] > m_free_ids[j];
    };
    // from the top of the heap on: what may come next is below what came before
    std::vector<std::size_t> places;
    const auto consider = [&](std::size_t place) {
      if (place < m_free_ids.size()) {
        places.push_back(place);
        std::push_heap(places.begin(), places.end(), comes_later);
      }
    };
    consider(0);
    while (ids.size() < number && !places.empty()) {
      std::pop_heap(places.begin(), places.end(), comes_later);
      const std::size_t place = places.back();
      places.pop_back();
      ids.push_back(m_free_ids[place]);
      consider(2 * place + 1);
      consider(2 * place + 2);
    }
    for (Index id = number_of_ids(); ids.size() < number; ++id)
      ids.push_back(id);
    return ids;
  }

  // The same if these points go first.
  std::vector<Index> next_ids(std::size_t number, std::vector<Index> gone) const
  {
    const std::vector<Index> free = next_ids(number);
    std::sort(gone.begin(), gone.end());
    std::vector<Index> ids(free.size() + gone.size());
    std::merge(free.begin(), free.end(), gone.begin(), gone.end(), ids.begin());
    ids.resize(number);
    return ids;
  }

  // NUMBERING ANEW ------------------------------------------------------------------------------

  // No id is taken.
  void reset(Index ids)
  {
    m_vertex_of_id.assign(ids, no_index);
    m_host.assign(1, no_index); // the infinite vertex has no point
    m_guests.clear();
    m_free_ids.clear();
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

  // After the last one was added.
  void settle()
  {
    const auto comes_before = [](const Guest& g, const Guest& h) { return g.id < h.id; };
    if (!std::is_sorted(m_guests.begin(), m_guests.end(), comes_before))
      std::sort(m_guests.begin(), m_guests.end(), comes_before);
    for (Index id = 0; id < number_of_ids(); ++id)
      if (m_vertex_of_id[id] == no_index)
        m_free_ids.push_back(id); // ascending numbers are a heap
  }

  // COMING AND GOING ----------------------------------------------------------------------------

  // Sets the next ids aside, for points that are about to come. If it throws, nothing has changed.
  void reserve(const std::vector<Index>& next_ids)
  {
    provide(m_free_ids, next_ids.size());
    provide(m_vertex_of_id, next_ids.size());
    for (const Index id : next_ids)
      if (id == number_of_ids()) {
        m_vertex_of_id.push_back(no_index);
      } else {
        CGAL_precondition(id == m_free_ids.front());
        std::pop_heap(m_free_ids.begin(), m_free_ids.end(), std::greater<Index>());
        m_free_ids.pop_back();
      }
  }

  // Makes an id free again that was set aside.
  void release(Index id)
  {
    m_free_ids.push_back(id);
    std::push_heap(m_free_ids.begin(), m_free_ids.end(), std::greater<Index>());
  }

  // Memory for a vertex more, for so many guests more, and for so many ids to become free: then
  // nothing below throws.
  void provide_for_vertex() { provide(m_host, 1); }
  void provide_for_guests(std::size_t number) { provide(m_guests, number); }
  void provide_for_removals(std::size_t number) { provide(m_free_ids, number); }

  // The next vertex, that nobody is at.
  void append_vertex() { m_host.push_back(no_index); }

  // Makes `id` the host of a vertex that nobody is at, whether it was set aside or is that of a
  // guest.
  void place_host(Index id, Index vertex)
  {
    leave(id);
    m_vertex_of_id[id] = vertex;
    m_host[vertex] = id;
  }

  // Makes `id` a guest at `vertex`, in the same way.
  void place_guest(Index id, Index vertex, const Point& point)
  {
    leave(id);
    m_vertex_of_id[id] = vertex;
    m_guests.insert(find_guest(m_guests, id), Guest{id, point});
  }

  // Frees the id of a guest.
  void remove_guest(Index id)
  {
    m_guests.erase(find_guest(m_guests, id));
    free(id);
  }

  // Frees the id of a host that has no guests; its vertex then has nobody.
  void remove_host(Index id)
  {
    m_host[m_vertex_of_id[id]] = no_index;
    free(id);
  }

  // The guest with the smallest id among those at `vertex` that `pleases`; `no_index` if there is
  // none.
  template <class Predicate>
  Index find_guest_at(Index vertex, const Predicate& pleases) const
  {
    for (const Guest& guest : m_guests)
      if (m_vertex_of_id[guest.id] == vertex && pleases(guest))
        return guest.id;
    return no_index;
  }

  // Lets a guest be the host, and the host, who is at `point`, its guest.
  void hand_over(Index guest, const Point& point)
  {
    const Index vertex = m_vertex_of_id[guest], host = m_host[vertex];
    m_guests.erase(find_guest(m_guests, guest));
    m_guests.insert(find_guest(m_guests, host), Guest{host, point});
    m_host[vertex] = guest;
  }

  // Makes guests at `vertex` of the host and the guests of another one, who are at `point`.
  void merge(Index other, Index vertex, const Point& point)
  {
    for (const Guest& guest : m_guests)
      if (m_vertex_of_id[guest.id] == other)
        m_vertex_of_id[guest.id] = vertex;
    const Index id = m_host[other];
    m_vertex_of_id[id] = vertex;
    m_guests.insert(find_guest(m_guests, id), Guest{id, point});
    m_host[other] = no_index;
  }

  // The points of the last vertex go to one that has nobody.
  void move_last_vertex_to(Index vertex)
  {
    const Index last = number_of_hosts();
    CGAL_precondition(!has_host(vertex));
    if (vertex != last) {
      m_host[vertex] = m_host[last];
      m_vertex_of_id[m_host[vertex]] = vertex;
      for (const Guest& guest : m_guests)
        if (m_vertex_of_id[guest.id] == last)
          m_vertex_of_id[guest.id] = vertex;
    }
    m_host.pop_back();
  }

private:
  // Where a guest is in the list, or would have to be.
  template <class Guests>
  static auto find_guest(Guests& guests, Index id)
  {
    return std::lower_bound(guests.begin(), guests.end(), id,
                            [](const Guest& guest, Index i) { return guest.id < i; });
  }

  // A guest leaves its vertex; an id that was set aside has none.
  void leave(Index id)
  {
    if (is_taken(id))
      m_guests.erase(find_guest(m_guests, id));
  }

  void free(Index id)
  {
    m_vertex_of_id[id] = no_index;
    release(id);
  }

  std::vector<Index> m_vertex_of_id; // no_index where an id is free
  std::vector<Index> m_host;
  std::vector<Guest> m_guests;   // by their ids
  std::vector<Index> m_free_ids; // a heap, the smallest first
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_IDS_2_H
