// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_SET_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_SET_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <limits>
#include <set>
#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A set of sites. It keeps its memory in the plane, where sites are vertices.
template <class State>
class Site_set_2
{
public:
  using Site = typename State::Site;

  void clear(const State& state)
  {
    if constexpr (State::is_periodic)
      m_sites.clear();
    else
      m_sites.clear(state.number_of_vertices() + 1);
  }
  void insert(const Site& site) { m_sites.insert(site); }

  bool contains(const Site& site) const
  {
    if constexpr (State::is_periodic)
      return m_sites.count(site) != 0;
    else
      return m_sites.contains(site);
  }

  // Calls f(site) for the members at a vertex.
  template <class Function>
  void for_each_at(Vertex_index v, const Function& f) const
  {
    if constexpr (State::is_periodic) {
      constexpr int least = (std::numeric_limits<int>::min)();
      auto site = m_sites.lower_bound({v, {least, least}});
      for (; site != m_sites.end() && site->vertex == v; ++site)
        f(*site);
    } else if (m_sites.contains(v))
      f(v);
  }

  bool empty() const { return m_sites.empty(); }
  auto begin() const { return m_sites.begin(); }
  auto end() const { return m_sites.end(); }

private:
  std::conditional_t<State::is_periodic, std::set<Site>, Index_set<Vertex_index>> m_sites;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_SITE_SET_2_H
