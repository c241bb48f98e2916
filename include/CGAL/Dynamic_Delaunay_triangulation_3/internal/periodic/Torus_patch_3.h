// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PATCH_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PATCH_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Vertex_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_predicates_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A finite set of images, as points of open space: what insertion there asks of a state.
class Patch_state_3
{
public:
  using Traits = Torus_predicates_3;
  using Point = Torus_point_3;

  explicit Patch_state_3(const Traits& predicates)
    : traits(predicates)
    , positions{points}
  {
  }

  const Point& point(Vertex_index v) const { return points[v]; }
  bool coincide(const Point& p, const Point& q) const { return traits.coincide(p, q); }

  Traits traits;
  Column<Vertex_index, Point> points;
  Position_3 origin{0, 0, 0};                        // insertion does not depend on it
  static constexpr bool positions_are_exact = false; // these predicates have a filter of their own
  struct
  {
    const Column<Vertex_index, Point>& points;
    const Position_3& position(Vertex_index v) const { return points[v].rounded; }
  } positions;
};

// The Delaunay triangulation of a finite set of images in open space. Its vertices have the numbers
// from 1 on.
//
// Points at infinity may be the last sites, where all images are in a plane along a slab. Points on
// their sides of that plane stand for them, at a distance of H. An empty circle in the plane, with
// a radius r and a center at the distance d from under these points, has an empty sphere through
// each of them, if that does not contain the other one: if d^2 + H^2 > r^2.
template <class State>
class Torus_patch_3
{
  using Arrays = Tetrahedra_arrays_3;

public:
  explicit Torus_patch_3(const State& state)
    : m_state(state)
    , m_images(Torus_predicates_3(state.torus, state.squared_error))
    , m_insertion(m_images, m_arrays)
  {
  }
  Torus_patch_3(const Torus_patch_3&) = delete;
  Torus_patch_3& operator=(const Torus_patch_3&) = delete;

  const Arrays& arrays() const { return m_arrays; }
  Cell_marks_3& marks() { return m_marks; } // of these cells
  const Torus_site_3& site(Vertex_index v) const { return m_sites[v]; }
  Torus_sites_3 sites(Cell_index c) const
  {
    Torus_sites_3 sites;
    for (int i = 0; i < 4; ++i)
      sites[i] = m_sites[m_arrays.vertices(c)[i]];
    return sites;
  }

  // Triangulates sites, inserted in their order, in which neighbors should be near to each other.
  // Calls coincides(i, j) if the i-th site is where the j-th one is already. False if all are
  // coplanar.
  template <class Function>
  bool triangulate(const std::vector<Torus_site_3>& sites, const Function& coincides)
  {
    m_sites.assign(sites.size() + 1, Torus_site_3());
    m_images.points.assign(sites.size() + 1, Torus_point_3());
    std::vector<Vertex_index> first;
    for (Vertex_index v(1); v <= sites.size(); ++v) {
      m_sites[v] = sites[v - 1];
      m_images.points[v] = m_sites[v].is_infinite() ? end_beside(sites, m_sites[v].is_above())
                                                    : m_state.image(m_sites[v]);
      first.push_back(v);
    }
    if (!begins_with_a_cell(m_images, first))
      return false;
    m_arrays.reset(Index(sites.size() + 1));
    m_insertion.begin({first[0], first[1], first[2], first[3]});
    for (Vertex_index v(1); v <= sites.size(); ++v) {
      if (std::find(first.begin(), first.begin() + 4, v) != first.begin() + 4)
        continue;
      if (const Vertex_index other = m_insertion.insert(v); other != null_index)
        coincides(v - 1, other - 1);
    }
    m_arrays.close_gaps();
    return true;
  }

private:
  // A point above the sites of a slab, or below them, as far away as images by their shifts are.
  Torus_point_3 end_beside(const std::vector<Torus_site_3>& sites, bool is_above) const
  {
    const Torus_3& torus = m_state.torus;
    double reach = 0;
    for (const Torus_site_3& s : sites)
      if (!s.is_infinite()) {
        const Multiples_3 m = s.shift.multiples();
        reach = (std::max)(reach,
                           (1.0 + std::abs(m[0])) * std::sqrt(squared_length(torus.vector(0))) +
                               (1.0 + std::abs(m[1])) * std::sqrt(squared_length(torus.vector(1))));
      }
    const Position_3 p =
        m_state.positions.position(sites[0].vertex) + (is_above ? reach : -reach) * torus.vector(2);
    return Torus_point_3(p.x, p.y, p.z);
  }

  const State& m_state;
  Patch_state_3 m_images;
  Arrays m_arrays;
  Cell_marks_3 m_marks;
  Vertex_insertion_3<Patch_state_3> m_insertion;
  Column<Vertex_index, Torus_site_3> m_sites;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PATCH_3_H
