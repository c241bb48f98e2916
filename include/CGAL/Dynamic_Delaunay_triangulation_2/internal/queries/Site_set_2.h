// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_SET_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_SET_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>

#include <cstddef>
#include <limits>
#include <set>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A set of sites. Where these are vertices, it keeps its memory.
template <class Site>
class Site_set_2
{
public:
  template <class State>
  void clear(const State& state)
  {
    m_vertices.clear(state.number_of_vertices() + std::size_t(1));
  }
  void insert(Site v) { m_vertices.insert(v); }
  bool contains(Site v) const { return m_vertices.contains(v); }

  // Calls f(site) for the members at a vertex.
  template <class Function>
  void for_each_at(Vertex_index v, const Function& f) const
  {
    if (contains(v))
      f(v);
  }

  bool empty() const { return m_vertices.empty(); }
  auto begin() const { return m_vertices.begin(); }
  auto end() const { return m_vertices.end(); }

private:
  Index_set<Vertex_index> m_vertices;
};

template <>
class Site_set_2<Periodic_site_2> : public std::set<Periodic_site_2>
{
public:
  template <class State>
  void clear(const State&)
  {
    std::set<Periodic_site_2>::clear();
  }
  bool contains(const Periodic_site_2& site) const { return count(site) != 0; }

  template <class Function>
  void for_each_at(Vertex_index v, const Function& f) const
  {
    constexpr int least = (std::numeric_limits<int>::min)();
    for (auto site = lower_bound({v, {least, least}}); site != end() && site->vertex == v; ++site)
      f(*site);
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_SET_2_H
