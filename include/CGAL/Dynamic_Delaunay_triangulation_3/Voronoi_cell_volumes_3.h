// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_VOLUMES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_VOLUMES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Volume_shares_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/certified_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Part_stars_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_images_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The volumes of the Voronoi cells of points in space, open or periodic, and nothing else: in a
fraction of the time that `Voronoi_cell_measures_3` takes, which also has surfaces, centroids,
neighbors, facets and boxes.

- Points that coincide share a cell. Each gets an equal share of its volume.
- An unbounded cell has infinite volume: those of points on the hull, so those of all points if they
  do not span space, and in a slab or a wire those of the outermost points.
- In periodic space the volumes add up to that of the periodic cell, but for rounding.
- Removed ids have the volume 0.

Each Delaunay facet adds a share to the cells of its vertices; shares are of either sign. With
\f$u = 2^{-53}\f$ and \f$D\f$ the distance from a point to the farthest corner of its cell, a volume
is off by some \f$u D^3\f$; where Delaunay cells are flat, as `Voronoi_cell_measures_3` says of
corners, by more. So the volume of a cell that is much longer than wide is less accurate here.
Volumes are never negative, and infinite where they are too large for doubles. Else what is said
there of coordinates and their sizes holds here, too.

\sa `Voronoi_cell_measures_3`
*/
class Voronoi_cell_volumes_3
{
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  using Cell_index = Dynamic_Delaunay_triangulations_3::Cell_index;

public:
  /// the type of ids and counts.
  using size_type = std::size_t;

  /// computes all volumes. Threads share the work if the triangulation has the `Parallel_tag`; the
  /// result does not depend on their number. If memory runs out, there are no volumes.
  ///
  /// Cost: linear, about one microsecond a point. Rational numbers take about ten microseconds
  /// for each very flat Delaunay cell.
  ///
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_3` or a
  ///   `Dynamic_periodic_Delaunay_triangulation_3`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point floating_point;
    const auto& state = Dynamic_Delaunay_triangulations_3::internal::certified_state(dt);
    try {
      m_volumes.assign(state.ids.number_of_ids(), 0);
      if (state.spans_space)
        add_shares(state);
      else
        store(state, [](Vertex_index) { return infinity; });
    } catch (...) {
      m_volumes.clear();
      throw;
    }
  }

  /// one more than the largest id ever in use.
  size_type number_of_ids() const { return m_volumes.size(); }
  /// the volume of each id, in the cubed unit of the coordinates.
  const std::vector<double>& volumes() const { return m_volumes; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  template <class State>
  void add_shares(const State& state)
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    const Scaled_sites_3<State> sites(state);
    const Volume_shares_3<State> shares(sites);
    const Cells_of_parts_3<State> cells(state);
    Column<Vertex_index, double> volumes(state.positions.number(), 0.0);
    State::Parts::run(cells.number_of_parts(), [&](std::size_t part) {
      const auto [first, beyond] = cells.vertices(part);
      cells.for_each_cell(part, [&, first = first, beyond = beyond](Cell_index c) {
        const auto& vertices = state.arrays.vertices(c);
        const bool is_infinite = state.arrays.is_infinite(c);
        for (int i = 0; i < 4; ++i)
          if (vertices[i] >= first && vertices[i] < beyond)
            volumes[vertices[i]] += is_infinite ? infinity : shares.of(c)[i];
      });
    });
    const double unit = sites.unit();
    store(state, [&](Vertex_index v) {
      const double volume = volumes[v]; // NaN where a corner is too distant for doubles
      return volume < infinity ? (std::max)(volume, 0.0) * unit * unit * unit : infinity;
    });
  }

  // Points that coincide get equal shares.
  template <class State, class Volume>
  void store(const State& state, const Volume& volume)
  {
    State::Parts::for_each_element(state.number_of_vertices(), [&](std::size_t i) {
      const Vertex_index v(i + 1);
      double points = 1;
      state.ids.for_each_covered_at(v, [&](const auto&...) { ++points; });
      const double share = volume(v) / points;
      m_volumes[state.ids.representative(v)] = share;
      state.ids.for_each_covered_at(v, [&](Point_id id, const auto&) { m_volumes[id] = share; });
    });
  }

  std::vector<double> m_volumes;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_VOLUMES_3_H
