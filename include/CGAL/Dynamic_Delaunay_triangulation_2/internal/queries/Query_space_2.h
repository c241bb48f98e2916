// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_SPACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_SPACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/check_certified_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Image_distances_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <cstddef>
#include <limits>
#include <set>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A triangulation as seen from the place of a query, by the same functions in plane and periodic
// space. A search moves from *site* to site: vertices in the plane, images of vertices in periodic
// space. An *answer* is a point at a site: an id in the plane, an id and a shift in periodic space.
template <class Dynamic, bool = Dynamic::Frame::is_periodic>
class Query_space_2;

// THE PLANE ---------------------------------------------------------------------------------------

template <class Dynamic>
class Query_space_2<Dynamic, false>
{
public:
  using FT = typename Dynamic::Geom_traits::FT;
  using Answer = std::size_t;
  using Site = Index;
  using Sites = Index_set_2;

  // Throws unless the triangulation is certified and the place is a valid point: the error calls
  // the place `number`. The place must outlive this object.
  Query_space_2(const Dynamic& dt, const typename Dynamic::Point& place, std::size_t number = 0)
    : m_distances(dt, place, number)
    , m_frame(dt.frame())
  {
  }

  void clear(Sites& sites) const { sites.clear(m_frame.number_of_vertices() + 1); }
  static bool contains(const Sites& sites, Site v) { return sites.contains(v); }

  static Answer answer(std::size_t id) { return id; }
  static Site vertex(Site v) { return v; }
  static Site site(Vertex_index v) { return v; }

  double approximate_square(Site v) const { return m_distances.approximate_square(v); }
  Comparison_result compare(Site v, Site w) const { return m_distances.compare(v, w); }
  Comparison_result compare_square(Site v, const FT& square) const
  {
    return m_distances.compare_square(v, square);
  }

  template <class Function>
  void for_each_neighbor(Site v, const Function& f) const
  {
    m_frame.state().for_each_finite_neighbor(v, f);
  }

  // Calls f(answer) for all points at the sites, coincident ones included.
  template <class Function>
  void for_each_point(const Sites& sites, const Function& f) const
  {
    for (const Site v : sites)
      f(Answer(m_frame.id(v)));
    m_frame.for_each_duplicate([&](Point_id id) {
      if (sites.contains(m_frame.vertex(id)))
        f(Answer(id));
    });
  }

private:
  const Distances_2<Dynamic> m_distances;
  const typename Dynamic::Frame m_frame;
};

// PERIODIC SPACE ----------------------------------------------------------------------------------

template <class Dynamic>
class Query_space_2<Dynamic, true>
{
public:
  using FT = double;
  using Answer = std::pair<std::size_t, Periodic_shift_2>;
  using Site = Answer; // with the id of a representative
  using Sites = std::set<Site>;

  // Throws as in the plane.
  Query_space_2(const Dynamic& dt, const typename Dynamic::Point& place, std::size_t number = 0)
    : m_dt(dt)
    , m_frame(dt.frame())
    , m_torus(dt.cell())
    , m_place(checked(dt, m_torus, place, number))
    , m_distances(m_torus, m_place)
  {
  }
  Query_space_2(const Query_space_2&) = delete; // distances refer to the torus
  Query_space_2& operator=(const Query_space_2&) = delete;

  static void clear(Sites& sites) { sites.clear(); }
  static bool contains(const Sites& sites, const Site& v) { return sites.count(v) != 0; }

  static Answer answer(std::size_t id) { return {id, no_shift}; }
  Vertex_index vertex(const Site& v) const { return m_frame.vertex(v.first); }
  // The image of a vertex near the place; exactly at the place if one of its images is there.
  Site site(Vertex_index v) const
  {
    return {m_frame.id(v), shift_to(m_place, m_frame.position(v))};
  }

  double approximate_square(const Site& v) const
  {
    return m_distances.approximate_square(image(v));
  }
  Comparison_result compare(const Site& v, const Site& w) const
  {
    return m_distances.compare(image(v), image(w));
  }
  Comparison_result compare_square(const Site& v, double square) const
  {
    return m_distances.compare_square(image(v), square);
  }

  template <class Function>
  void for_each_neighbor(const Site& v, const Function& f) const
  {
    m_dt.for_each_neighbor(v.first, [&](std::size_t id, const Periodic_shift_2& shift) {
      f(Site(id, v.second + shift));
    });
  }

  // A duplicate's point may be another image of its representative's point.
  template <class Function>
  void for_each_point(const Sites& sites, const Function& f) const
  {
    for (const Site& v : sites)
      f(v);
    m_frame.for_each_duplicate([&](Point_id id) {
      const auto p = m_dt.point(id);
      const std::size_t v = m_frame.id(m_frame.vertex(id));
      const Periodic_shift_2 shift = shift_to(position(v), {p.x(), p.y()});
      constexpr int least = (std::numeric_limits<int>::min)();
      for (auto site = sites.lower_bound(Site(v, {least, least}));
           site != sites.end() && site->first == v; ++site)
        f(Answer(id, site->second + shift));
    });
  }

private:
  static Position_2 checked(const Dynamic& dt, const Torus_2& torus,
                            const typename Dynamic::Point& place, std::size_t number)
  {
    check_certified(dt);
    return checked_position(place, number, torus);
  }

  // By how much q must be shifted to be near p.
  Periodic_shift_2 shift_to(const Position_2& p, const Position_2& q) const
  {
    return m_torus.nearest_shift(m_torus.multiples(p - q));
  }

  const Position_2& position(std::size_t id) const { return m_frame.position(m_frame.vertex(id)); }
  Image_2 image(const Site& v) const { return {position(v.first), v.second}; }

  const Default_floating_point_2 m_floating_point; // while distances are compared
  const Dynamic& m_dt;
  const typename Dynamic::Frame m_frame;
  const Torus_2 m_torus;
  const Position_2 m_place;
  const Image_distances_2 m_distances;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_QUERY_SPACE_2_H
