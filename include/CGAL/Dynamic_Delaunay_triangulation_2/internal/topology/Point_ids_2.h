// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_POINT_IDS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_POINT_IDS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The vertex of each id. Points that coincide share the vertex of one of them, its representative;
// the others are covered there. The covered points at a vertex form a ring, so that they take
// memory only where there are any, and that vertices merge and points part in constant time, but
// for what is written into each of the points that get another vertex. Ids of removed points are
// free, and reused from the smallest on.
template <class Point>
class Point_ids_2
{
public:
  // One more than the largest id ever in use.
  Index number_of_ids() const { return Index(m_vertex_or_ring.size()); }
  Index number_of_covered() const { return Index(m_covered.size()); }
  Index number_of_points() const { return number_of_representatives() + number_of_covered(); }
  bool has_representative(Vertex_index vertex) const
  {
    return m_representative[vertex] != null_index;
  }
  Index number_of_representatives() const { return Index(m_representative.size()) - 1; }
  bool is_taken(std::size_t id) const
  {
    return id < m_vertex_or_ring.size() && m_vertex_or_ring[Point_id(id)] != null_index;
  }
  // The vertex of an id, which must be taken.
  Vertex_index vertex(Point_id id) const
  {
    return is_in_ring(id) ? m_covered[number_in_ring(id)].vertex
                          : Vertex_index(m_vertex_or_ring[id]);
  }
  // Fetches what `vertex()` reads first.
  void prefetch(Point_id id) const { internal::prefetch(&m_vertex_or_ring[id]); }
  Point_id representative(Vertex_index vertex) const { return m_representative[vertex]; }
  // Indexed by vertices.
  const Point_id* representatives() const { return m_representative.data(); }
  // The id must be taken.
  bool is_representative(Point_id id) const
  {
    return !is_in_ring(id) || m_covered[number_in_ring(id)].id != id;
  }

  // Whether the point of an id, which must be taken, is the only one of its vertex.
  bool is_alone(Point_id id) const { return !is_in_ring(id); }

  // Covered points have numbers, which change when others come or go.
  Index covered_number(Point_id id) const { return number_in_ring(id); }
  Point_id covered_id(Index number) const { return m_covered[number].id; }
  const Point& covered_point(Point_id id) const { return m_covered_points[covered_number(id)]; }
  Point& covered_point(Point_id id) { return m_covered_points[covered_number(id)]; }
  // By these numbers.
  const std::vector<Point>& covered_points() const { return m_covered_points; }
  std::vector<Point>& covered_points() { return m_covered_points; }

  // Calls f(id, vertex, point) for all covered points, in any order.
  template <class Function>
  void for_each_covered(const Function& f) const
  {
    for (Index i = 0; i < number_of_covered(); ++i)
      f(m_covered[i].id, m_covered[i].vertex, m_covered_points[i]);
  }

  // Calls f(id, point) for the covered points at a vertex, in any order.
  template <class Function>
  void for_each_covered_at(Vertex_index vertex, const Function& f) const
  {
    for_each_in_ring(vertex, [&](Index i) { f(m_covered[i].id, m_covered_points[i]); });
  }

  // The smallest id of the covered points at a vertex for which `pleases(point)` is true, or
  // `null_index`.
  template <class Predicate>
  Point_id find_covered_at(Vertex_index vertex, const Predicate& pleases) const
  {
    Point_id smallest = null_index;
    for_each_covered_at(vertex, [&](Point_id id, const Point& point) {
      if (id < smallest && pleases(point))
        smallest = id;
    });
    return smallest;
  }

  // The ids of the covered points, ascending.
  std::vector<Point_id> covered_ids() const
  {
    std::vector<Point_id> ids;
    ids.reserve(m_covered.size());
    for (const Covered& covered : m_covered)
      ids.push_back(covered.id);
    make_distinct(ids);
    return ids;
  }

  // The ids of all points: the representatives in the order of their vertices, then those of the
  // covered points, ascending.
  std::vector<Point_id> representatives_and_covered() const
  {
    std::vector<Point_id> order(m_representative.begin() + 1, m_representative.end());
    const std::vector<Point_id> covered = covered_ids();
    order.insert(order.end(), covered.begin(), covered.end());
    return order;
  }

  // Lists the ids that the next points get, in this order. Cost: n log n for n ids.
  void list_next_ids(std::size_t number, std::vector<Point_id>& ids) const
  {
    ids.clear();
    if (are_many(number)) {
      ids = m_free_ids;
      make_distinct(ids);
      ids.resize((std::min)(number, ids.size()));
    }
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
    else if (ids.empty())
      consider(0);
    while (ids.size() < number && !places.empty()) {
      std::pop_heap(places.begin(), places.end(), comes_later);
      const std::size_t place = places.back();
      places.pop_back();
      ids.push_back(m_free_ids[place]);
      consider(2 * place + 1);
      consider(2 * place + 2);
    }
    const auto reused = std::ptrdiff_t(ids.size());
    ids.resize(number);
    std::iota(ids.begin() + reused, ids.end(), Point_id(number_of_ids()));
  }

  // Returns the ids that the next points get if the ids in `gone` are freed first.
  std::vector<Point_id> next_ids(std::size_t number, std::vector<Point_id> gone) const
  {
    std::vector<Point_id> free;
    list_next_ids(number, free);
    boost::sort::pdqsort(gone.begin(), gone.end()); // a population lists them in order
    std::vector<Point_id> ids(free.size() + gone.size());
    std::merge(free.begin(), free.end(), gone.begin(), gone.end(), ids.begin());
    ids.resize(number);
    return ids;
  }

  // NUMBERING FROM SCRATCH ------------------------------------------------------------------------

  // Starts with so many ids, none of them taken.
  template <class Parts = Parallel_parts<Sequential_tag>>
  void reset(Index ids)
  {
    m_vertex_or_ring.resize(ids);
    Parts::for_each(ids, [this](std::size_t, std::size_t first, std::size_t beyond) {
      std::fill(m_vertex_or_ring.data() + first, m_vertex_or_ring.data() + beyond, null_index);
    });
    m_representative.assign(1, null_index); // the infinite vertex has no point
    m_covered.clear();
    m_covered_points.clear();
    m_free_ids.clear();
  }

  // Makes `id` the representative of the next vertex.
  Vertex_index add_representative(Point_id id)
  {
    const Vertex_index vertex(m_representative.size());
    m_vertex_or_ring[id] = vertex;
    m_representative.push_back(id);
    return vertex;
  }

  // Changes the number of vertices. Then set_representative() must be called for each of them.
  void resize(Index vertices) { m_representative.resize(vertices + std::size_t(1)); }
  void set_representative(Vertex_index vertex, Point_id id)
  {
    m_vertex_or_ring[id] = vertex;
    m_representative[vertex] = id;
  }

  // Covers a point, which has no vertex yet, at a vertex that has a representative.
  void cover(Point_id id, Vertex_index vertex, const Point& point)
  {
    const Index i = number_of_covered();
    m_covered.push_back({id, vertex, i, i});
    m_covered_points.push_back(point);
    m_vertex_or_ring[id] = first_in_ring + i;
    join_ring(i, vertex);
  }

  // Collects the free ids. To be called after the last point was added.
  void finish_numbering()
  {
    for (Point_id id(0); id < number_of_ids(); ++id)
      if (m_vertex_or_ring[id] == null_index)
        m_free_ids.push_back(id); // ascending numbers are a heap
  }

  // INSERTION AND REMOVAL -------------------------------------------------------------------------

  // Reserves the next ids for points to be inserted. If it throws, nothing has changed.
  void reserve(const std::vector<Point_id>& next_ids)
  {
    reserve_extra(m_free_ids, next_ids.size());
    reserve_extra(m_vertex_or_ring, next_ids.size());
    auto next = next_ids.begin();
    if (are_many(next_ids.size())) { // they are the smallest, and ascending numbers are a heap
      const std::size_t reused = (std::min)(next_ids.size(), m_free_ids.size());
      make_distinct(m_free_ids);
      CGAL_precondition(std::equal(next, next + std::ptrdiff_t(reused), m_free_ids.begin()));
      m_free_ids.erase(m_free_ids.begin(), m_free_ids.begin() + std::ptrdiff_t(reused));
      next += std::ptrdiff_t(reused);
    }
    for (; next != next_ids.end(); ++next)
      if (const Point_id id = *next; id == number_of_ids()) {
        m_vertex_or_ring.push_back(null_index);
      } else {
        CGAL_precondition(id == m_free_ids.front());
        std::pop_heap(m_free_ids.begin(), m_free_ids.end(), std::greater<Index>());
        m_free_ids.pop_back();
      }
  }

  // Finds the free ids anew, where some that were reserved are not used. Allocates nothing if there
  // is memory for them.
  void find_free_ids()
  {
    m_free_ids.clear();
    finish_numbering();
  }

  // Frees a reserved id.
  void release(Point_id id)
  {
    m_free_ids.push_back(id);
    std::push_heap(m_free_ids.begin(), m_free_ids.end(), std::greater<Index>());
  }
  // Frees many, if end_releases() follows, with the number of all of them.
  void release(const std::vector<Point_id>& ids)
  {
    m_free_ids.insert(m_free_ids.end(), ids.begin(), ids.end());
  }
  void end_releases(std::size_t number)
  {
    if (number == 0)
      return;
    try {
      if (make_distinct_by_bits(m_free_ids)) // ascending numbers are a heap, in half the time
        return;
    } catch (const std::bad_alloc&) { // a heap needs no memory
    }
    std::make_heap(m_free_ids.begin(), m_free_ids.end(), std::greater<Index>());
  }

  // Reserve memory for more vertices, for more covered points, or for more free ids. Then nothing
  // below throws.
  void reserve_for_vertices(std::size_t number) { reserve_extra(m_representative, number); }
  void reserve_for_covered(std::size_t number)
  {
    reserve_extra(m_covered, number);
    reserve_extra(m_covered_points, number);
  }
  void reserve_for_removals(std::size_t number) { reserve_extra(m_free_ids, number); }

  // Append vertices without representatives.
  void append_vertex() { append_vertices(1); }
  void append_vertices(std::size_t number)
  {
    m_representative.resize(m_representative.size() + number, null_index);
  }

  // Makes `id`, a reserved id or that of a covered point, the representative of a vertex that has
  // none.
  void place_representative(Point_id id, Vertex_index vertex)
  {
    leave(id);
    set_representative(vertex, id);
  }

  // Covers the point `id`, which is reserved or covered elsewhere, at `vertex`.
  void place_covered(Point_id id, Vertex_index vertex, const Point& point)
  {
    leave(id);
    cover(id, vertex, point);
  }

  // Removes a covered point and frees its id.
  void remove_covered(Point_id id)
  {
    leave(id);
    m_vertex_or_ring[id] = null_index;
    release(id);
  }

  // Removes a representative that covers none and frees its id. Its vertex then has none.
  void remove_representative(Point_id id)
  {
    vacate(id);
    release(id);
  }
  // Does so, but leaves it to the caller to release the id. Threads may do this at the same time.
  void vacate(Point_id id)
  {
    CGAL_precondition(!is_in_ring(id));
    m_representative[vertex(id)] = null_index;
    m_vertex_or_ring[id] = null_index;
  }

  // Makes a covered point the representative of its vertex, and covers the representative, whose
  // point is `point`.
  void exchange_representative(Point_id covered, const Point& point)
  {
    const Index i = number_in_ring(covered);
    Point_id& representative = m_representative[m_covered[i].vertex];
    m_covered[i].id = representative;
    m_covered_points[i] = point;
    m_vertex_or_ring[representative] = first_in_ring + i;
    representative = covered; // m_vertex_or_ring[covered] is right already
  }

  // Covers all points of vertex `other` at `vertex`. `point` is that of its representative.
  void merge(Vertex_index other, Vertex_index vertex, const Point& point)
  {
    const Point_id id = m_representative[other];
    for_each_in_ring(other, [&](Index i) { m_covered[i].vertex = vertex; });
    if (is_in_ring(id))
      join_ring(number_in_ring(id), vertex);
    cover(id, vertex, point);
    m_representative[other] = null_index;
  }

  // Moves the points of a vertex to another one, which must have none. Threads may do this with
  // different vertices at the same time.
  void move_points(Vertex_index from, Vertex_index to)
  {
    CGAL_precondition(!has_representative(to));
    const Point_id id = m_representative[from];
    for_each_in_ring(from, [&](Index i) { m_covered[i].vertex = to; });
    m_representative[to] = id;
    if (!is_in_ring(id))
      m_vertex_or_ring[id] = to;
  }

private:
  struct Covered
  {
    Point_id id;
    Vertex_index vertex;
    Index next, previous; // in the ring of those at the vertex
  };

  // Whether so many of the free ids are many, so that all are sorted.
  bool are_many(std::size_t number) const
  {
    constexpr std::size_t few = 16, part = 16;
    return number > few && number >= m_free_ids.size() / part;
  }

  // THE RING OF A VERTEX --------------------------------------------------------------------------

  // Whether an id, which must be taken, is that of a covered point, or of a representative that
  // covers some.
  bool is_in_ring(Point_id id) const { return m_vertex_or_ring[id] >= first_in_ring; }
  // The number of the covered point itself, or of one that the representative covers.
  Index number_in_ring(Point_id id) const { return m_vertex_or_ring[id] - first_in_ring; }

  // Calls f(number) for the covered points at a vertex.
  template <class Function>
  void for_each_in_ring(Vertex_index vertex, const Function& f) const
  {
    const Point_id representative = m_representative[vertex];
    if (!is_in_ring(representative))
      return;
    const Index first = number_in_ring(representative);
    Index i = first;
    do {
      f(i);
      i = m_covered[i].next;
    } while (i != first);
  }

  // Joins the ring of i with that of a vertex.
  void join_ring(Index i, Vertex_index vertex)
  {
    const Point_id representative = m_representative[vertex];
    if (is_in_ring(representative))
      exchange_next(number_in_ring(representative), i);
    m_vertex_or_ring[representative] = first_in_ring + i;
  }

  // Makes one ring of two, or two of one.
  void exchange_next(Index i, Index j)
  {
    std::swap(m_covered[i].next, m_covered[j].next);
    m_covered[m_covered[i].next].previous = i;
    m_covered[m_covered[j].next].previous = j;
  }

  // Takes a covered point from its vertex. A reserved id has no vertex to leave.
  void leave(Point_id id)
  {
    if (!is_taken(id))
      return;
    const Index i = number_in_ring(id), previous = m_covered[i].previous;
    const Vertex_index vertex = m_covered[i].vertex;
    m_vertex_or_ring[m_representative[vertex]] =
        previous == i ? Index(vertex) : first_in_ring + previous;
    exchange_next(previous, i);
    move_last_covered_to(i);
  }

  // Gives the last covered point the number of one that is alone in its ring and goes.
  void move_last_covered_to(Index i)
  {
    const Index last = number_of_covered() - 1;
    if (i != last) {
      exchange_next(i, m_covered[last].previous);
      exchange_next(i, last);
      m_covered[i].id = m_covered[last].id;
      m_covered[i].vertex = m_covered[last].vertex;
      m_covered_points[i] = m_covered_points[last];
      m_vertex_or_ring[m_covered[i].id] = first_in_ring + i;
      m_vertex_or_ring[m_representative[m_covered[i].vertex]] = first_in_ring + i;
    }
    m_covered.pop_back();
    m_covered_points.pop_back();
  }

  static constexpr Index first_in_ring = Index(1) << 31;
  static_assert(max_vertices < first_in_ring);

  // By ids: null_index if free, a vertex, or from first_in_ring on the number of a covered point.
  Uninitialized_column<Point_id, Index> m_vertex_or_ring;
  Uninitialized_column<Vertex_index, Point_id> m_representative;
  std::vector<Covered> m_covered;
  std::vector<Point> m_covered_points;
  std::vector<Point_id> m_free_ids; // a heap, the smallest on top
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_POINT_IDS_2_H
