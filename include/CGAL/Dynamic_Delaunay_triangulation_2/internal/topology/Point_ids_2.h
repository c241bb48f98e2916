// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_POINT_IDS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_POINT_IDS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The vertex of each id. Points that coincide share the vertex of one of them, its representative;
// the others are duplicates there. Ids of removed points are free, and reused from the smallest on.
template <class Point>
class Point_ids_2
{
public:
  struct Duplicate
  {
    Point_id id;
    Point point;
  };

  // One more than the largest id ever in use.
  Index number_of_ids() const { return Index(m_vertex_of_id.size()); }
  Index number_of_points() const
  {
    return number_of_representatives() + Index(m_duplicates.size());
  }
  bool has_representative(Vertex_index vertex) const
  {
    return m_representative[vertex] != null_index;
  }
  Index number_of_representatives() const { return Index(m_representative.size()) - 1; }
  bool is_taken(std::size_t id) const
  {
    return id < m_vertex_of_id.size() && m_vertex_of_id[Point_id(id)] != null_index;
  }
  Vertex_index vertex(Point_id id) const { return m_vertex_of_id[id]; }
  Point_id representative(Vertex_index vertex) const { return m_representative[vertex]; }
  // Indexed by vertices.
  const Point_id* representatives() const { return m_representative.data(); }
  // The id must be taken.
  bool is_representative(Point_id id) const { return m_representative[m_vertex_of_id[id]] == id; }
  const std::vector<Duplicate>& duplicates() const { return m_duplicates; }
  std::vector<Duplicate>& duplicates() { return m_duplicates; }

  const Duplicate& duplicate(Point_id id) const { return *find_duplicate(m_duplicates, id); }
  Duplicate& duplicate(Point_id id) { return *find_duplicate(m_duplicates, id); }

  // The ids of all points: the representatives in the order of their vertices, then the duplicates.
  std::vector<Point_id> representatives_and_duplicates() const
  {
    std::vector<Point_id> order(m_representative.begin() + 1, m_representative.end());
    for (const Duplicate& duplicate : m_duplicates)
      order.push_back(duplicate.id);
    return order;
  }

  // Lists the ids that the next points get, in this order. Cost: n log n for n ids.
  void list_next_ids(std::size_t number, std::vector<Point_id>& ids) const
  {
    ids.clear();
    const auto comes_later = [this](std::size_t i, std::size_t j) {
      return m_free_ids[i] > m_free_ids[j];
    };
    // a heap entry comes after its parent, so the search starts at the top of the heap
    std::vector<std::size_t> places;
    const auto consider = [&](std::size_t place) {
      if (place < m_free_ids.size()) {
        places.push_back(place);
        std::push_heap(places.begin(), places.end(), comes_later);
      }
    };
    ids.reserve(number);
    if (number == 1 && !m_free_ids.empty()) // most calls insert a single point
      ids.push_back(m_free_ids.front());
    else
      consider(0);
    while (ids.size() < number && !places.empty()) {
      std::pop_heap(places.begin(), places.end(), comes_later);
      const std::size_t place = places.back();
      places.pop_back();
      ids.push_back(m_free_ids[place]);
      consider(2 * place + 1);
      consider(2 * place + 2);
    }
    for (Point_id id(number_of_ids()); ids.size() < number; ++id)
      ids.push_back(id);
  }

  // Returns the ids that the next points get if the ids in `gone` are freed first.
  std::vector<Point_id> next_ids(std::size_t number, std::vector<Point_id> gone) const
  {
    std::vector<Point_id> free;
    list_next_ids(number, free);
    std::sort(gone.begin(), gone.end());
    std::vector<Point_id> ids(free.size() + gone.size());
    std::merge(free.begin(), free.end(), gone.begin(), gone.end(), ids.begin());
    ids.resize(number);
    return ids;
  }

  // NUMBERING FROM SCRATCH ------------------------------------------------------------------------

  // Starts with so many ids, none of them taken.
  void reset(Index ids)
  {
    m_vertex_of_id.assign(ids, null_index);
    m_representative.assign(1, null_index); // the infinite vertex has no point
    m_duplicates.clear();
    m_free_ids.clear();
  }

  // Makes `id` the representative of the next vertex.
  Vertex_index add_representative(Point_id id)
  {
    m_vertex_of_id[id] = Vertex_index(m_representative.size());
    m_representative.push_back(id);
    return m_vertex_of_id[id];
  }

  // Changes the number of vertices. Then set_representative() must be called for each of them.
  void resize(Index vertices) { m_representative.resize(vertices + std::size_t(1)); }
  void set_representative(Vertex_index vertex, Point_id id)
  {
    m_vertex_of_id[id] = vertex;
    m_representative[vertex] = id;
  }

  void add_duplicate(Point_id id, Point_id representative, const Point& point)
  {
    m_vertex_of_id[id] = m_vertex_of_id[representative];
    m_duplicates.push_back(Duplicate{id, point});
  }

  // Sorts the duplicates and collects the free ids. To be called after the last point was added.
  void finish_numbering()
  {
    const auto comes_before = [](const Duplicate& g, const Duplicate& h) { return g.id < h.id; };
    if (!std::is_sorted(m_duplicates.begin(), m_duplicates.end(), comes_before))
      std::sort(m_duplicates.begin(), m_duplicates.end(), comes_before);
    for (Point_id id(0); id < number_of_ids(); ++id)
      if (m_vertex_of_id[id] == null_index)
        m_free_ids.push_back(id); // ascending numbers are a heap
  }

  // INSERTION AND REMOVAL -------------------------------------------------------------------------

  // Reserves the next ids for points to be inserted. If it throws, nothing has changed.
  void reserve(const std::vector<Point_id>& next_ids)
  {
    reserve_extra(m_free_ids, next_ids.size());
    reserve_extra(m_vertex_of_id, next_ids.size());
    for (const Point_id id : next_ids)
      if (id == number_of_ids()) {
        m_vertex_of_id.push_back(null_index);
      } else {
        CGAL_precondition(id == m_free_ids.front());
        std::pop_heap(m_free_ids.begin(), m_free_ids.end(), std::greater<Index>());
        m_free_ids.pop_back();
      }
  }

  // Frees a reserved id.
  void release(Point_id id)
  {
    m_free_ids.push_back(id);
    std::push_heap(m_free_ids.begin(), m_free_ids.end(), std::greater<Index>());
  }

  // Reserve memory for one more vertex, for more duplicates, or for more free ids. Then nothing
  // below throws.
  void reserve_for_vertex() { reserve_extra(m_representative, 1); }
  void reserve_for_duplicates(std::size_t number) { reserve_extra(m_duplicates, number); }
  void reserve_for_removals(std::size_t number) { reserve_extra(m_free_ids, number); }

  // Appends a vertex without representative.
  void append_vertex() { m_representative.push_back(null_index); }

  // Makes `id`, a reserved id or that of a duplicate, the representative of a vertex that has none.
  void place_representative(Point_id id, Vertex_index vertex)
  {
    leave(id);
    m_vertex_of_id[id] = vertex;
    m_representative[vertex] = id;
  }

  // Makes `id`, a reserved id or that of a duplicate, a duplicate at `vertex`.
  void place_duplicate(Point_id id, Vertex_index vertex, const Point& point)
  {
    leave(id);
    m_vertex_of_id[id] = vertex;
    m_duplicates.insert(find_duplicate(m_duplicates, id), Duplicate{id, point});
  }

  // Removes a duplicate and frees its id.
  void remove_duplicate(Point_id id)
  {
    m_duplicates.erase(find_duplicate(m_duplicates, id));
    free(id);
  }

  // Removes a representative without duplicates and frees its id. Its vertex then has none.
  void remove_representative(Point_id id)
  {
    m_representative[m_vertex_of_id[id]] = null_index;
    free(id);
  }

  // The smallest id of the duplicates at `vertex` for which `pleases` is true, or `null_index`.
  template <class Predicate>
  Point_id find_duplicate_at(Vertex_index vertex, const Predicate& pleases) const
  {
    for (const Duplicate& duplicate : m_duplicates)
      if (m_vertex_of_id[duplicate.id] == vertex && pleases(duplicate))
        return duplicate.id;
    return null_index;
  }

  // Makes a duplicate the representative of its vertex, and the representative, whose point is
  // `point`, a duplicate.
  void exchange_representative(Point_id duplicate, const Point& point)
  {
    const Vertex_index vertex = m_vertex_of_id[duplicate];
    const Point_id representative = m_representative[vertex];
    m_duplicates.erase(find_duplicate(m_duplicates, duplicate));
    m_duplicates.insert(find_duplicate(m_duplicates, representative),
                        Duplicate{representative, point});
    m_representative[vertex] = duplicate;
  }

  // Makes the representative and the duplicates of vertex `other` duplicates at `vertex`. `point`
  // is the representative's point.
  void merge(Vertex_index other, Vertex_index vertex, const Point& point)
  {
    for (const Duplicate& duplicate : m_duplicates)
      if (m_vertex_of_id[duplicate.id] == other)
        m_vertex_of_id[duplicate.id] = vertex;
    const Point_id id = m_representative[other];
    m_vertex_of_id[id] = vertex;
    m_duplicates.insert(find_duplicate(m_duplicates, id), Duplicate{id, point});
    m_representative[other] = null_index;
  }

  // Moves the points of the last vertex to `vertex`, which must have none, and drops the last one.
  void move_last_vertex_to(Vertex_index vertex)
  {
    const Vertex_index last(number_of_representatives());
    CGAL_precondition(!has_representative(vertex));
    if (vertex != last) {
      m_representative[vertex] = m_representative[last];
      m_vertex_of_id[m_representative[vertex]] = vertex;
      for (const Duplicate& duplicate : m_duplicates)
        if (m_vertex_of_id[duplicate.id] == last)
          m_vertex_of_id[duplicate.id] = vertex;
    }
    m_representative.pop_back();
  }

private:
  // The place of a duplicate in the list, or where to insert it.
  template <class Duplicates>
  static auto find_duplicate(Duplicates& duplicates, Point_id id)
  {
    return std::lower_bound(duplicates.begin(), duplicates.end(), id,
                            [](const Duplicate& duplicate, Point_id i) { return duplicate.id < i; });
  }

  // Removes a duplicate from its vertex. A reserved id has no vertex to leave.
  void leave(Point_id id)
  {
    if (is_taken(id))
      m_duplicates.erase(find_duplicate(m_duplicates, id));
  }

  void free(Point_id id)
  {
    m_vertex_of_id[id] = null_index;
    release(id);
  }

  Column<Point_id, Vertex_index> m_vertex_of_id; // null_index for free ids
  Column<Vertex_index, Point_id> m_representative;
  std::vector<Duplicate> m_duplicates; // sorted by id
  std::vector<Point_id> m_free_ids;       // a heap, the smallest on top
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_POINT_IDS_2_H
