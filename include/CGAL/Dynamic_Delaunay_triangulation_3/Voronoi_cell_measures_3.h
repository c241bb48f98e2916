// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_MEASURES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_MEASURES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Boxed_cell_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Measured_cells_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/certified_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Rows_by_id_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The volumes, surface areas and centroids of the Voronoi cells of points in space, and the areas of
the facets between them: of whole cells, in open or in periodic space, or of what is in a box. The
volume of a cell is the space that its point has for itself; its inverse is the local density.

Volumes are in the cubed unit of the coordinates, areas in the squared unit, centroids in that unit.

- *Neighbors* are points whose cells share a facet with an area. Exact predicates decide this for
  whole cells, also for those that are clipped later; so it does not depend on which of several
  Delaunay triangulations of cospherical points is there. In a cubic lattice each cell has six.
- Points that coincide share a cell. Each gets an equal share of its volume, so that the volumes
  still add up, and the whole surface area and centroid. Only the first of them, their
  representative, has facets, and only it is a neighbor of others.
- An unbounded cell has infinite volume and surface area, and so has each facet that is unbounded.
  The cells of all points on the hull are unbounded; so are all cells if the points do not span
  space.
- An unbounded cell, and a clipped one without volume, have no centroid. The point's own position
  takes its place: a relaxation leaves the point where it is.
- In periodic space all cells are bounded, however few points there are, and their volumes add up to
  that of the periodic cell. Neighbors are images, and `shifts()` tells which: a point can be a
  neighbor of its own images, and of another point's several times. The centroid of each point, also
  of one that coincides with another by a translation, is near the point as it was given, wrapped or
  not. There are no boxes. In a slab the cells of the highest and of the lowest points are
  unbounded, as those of points on the hull are in open space.
- A facet with a neighbor that does not reach into the box has the area 0. Where a cell touches the
  box only from outside, rounding may leave it a tiny volume, and so a centroid there.
- Removed ids have 0 for all measures, and no neighbors.

<b>Whole cells.</b> With \f$u = 2^{-53}\f$, each corner of a cell, the circumcenter of a Delaunay
cell, is off by at most \f$10^5 u\f$ times its distance from the point, mostly by some \f$u\f$;
where a Delaunay cell is too flat for that, rational numbers place it. All vectors are differences
to the point, so the distance from the origin does not matter. Volumes and areas are sums without
cancellation; they are as accurate as the corners. A facet between corners that are much farther
away than it is wide is less accurate in proportion. Measures that are too large for doubles are
infinite.

<b>Clipped cells.</b> The box is cut by the bisectors of the point and its neighbors, unless all
corners of the whole cell are in the box. With \f$D\f$ the diameter of the box, corners are off by
some \f$u D\f$ across their facets, and volumes by some \f$u D^3\f$, however far away the points
are: if they are two diameters away, rational numbers place their bisectors. So volumes add up to
that of the box but for rounding. Volumes are never negative, and centroids are never outside of the
range of the corners. Facets whose planes include a small angle are less accurate in proportion;
their sum is not.

Coordinates that are no doubles are subtracted first, then rounded. Points may be anywhere, but
lengths below \f$10^{-50}\f$ times the largest coordinate are not measured accurately; in periodic
space, \f$10^{-50}\f$ times the size of the cell. There vectors between images are not rounded more
than others, however many cells away from the origin the points were given.

\cgalExample{Dynamic_Delaunay_triangulation_2/space_volumes.cpp}

\sa `Voronoi_cell_volumes_3`, `Delaunay_neighbor_lists_3`
*/
class Voronoi_cell_measures_3
{
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  using Box = Dynamic_Delaunay_triangulations_3::internal::Box_3;

public:
  /// \name Types
  /// @{

  /// an id in the arrays: 32 bits, as inside the triangulation.
  using Id = std::uint32_t;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// a place: three doubles, `x`, `y` and `z`.
  using Position = Dynamic_Delaunay_triangulations_3::Position_3;

  /// @}
  /// \name Computation
  /// Threads share the work if the triangulation has the `Parallel_tag`; the result does not depend
  /// on their number. If memory runs out, there are no measures. The results take some 250 bytes a
  /// point, and while they run, these functions take 500 more.
  /// @{

  /// measures the whole cells.
  ///
  /// Cost: linear, some four microseconds a point: one walk around each edge, from both of its
  /// ends. Rational numbers take about ten more for each very flat Delaunay cell, and exact
  /// predicates about one for each facet between cospherical ones.
  ///
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_3` or a
  ///   `Dynamic_periodic_Delaunay_triangulation_3`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    measure(dt, nullptr);
  }

  /// measures the parts of the cells in a box. Surface areas include what lies on the boundary of
  /// the box. Points may be outside of the box; a cell that does not reach into it has the volume
  /// and the surface area 0. If there is any point, the volumes add up to the volume of the box,
  /// and the mean of the centroids, weighted by volumes, is its center.
  ///
  /// Cost: as above; for a point whose cell has corners outside of the box, some ten microseconds
  /// more: proportional to the number of its neighbors times the number of its cell's corners.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_3`. No other compiles.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \throws Parameter_error_2 unless the extents of the box are from 0 to 1e100; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const Bbox_3& box)
  {
    static_assert(!Dynamic_Delaunay_triangulations_3::internal::is_periodic_3<Dynamic>,
                  "in periodic space there are no boxes: compute(dt) measures whole cells");
    const Box bounds = Dynamic_Delaunay_triangulations_3::internal::checked_box(box);
    measure(dt, &bounds);
  }

  /// measures the parts of the cells in a box of the kernel, whose corners are rounded to doubles.
  template <class Dynamic>
  void compute(const Dynamic& dt, const typename Dynamic::Geom_traits::Iso_cuboid_3& box)
  {
    compute(dt, Dynamic_Delaunay_triangulations_3::internal::rounded_box(box));
  }

  /// @}
  /// \name Access
  /// @{

  /// one more than the largest id ever in use.
  size_type number_of_ids() const { return m_volumes.size(); }
  /// the volume of each id.
  const std::vector<double>& volumes() const { return m_volumes; }
  /// the surface area of each id.
  const std::vector<double>& surface_areas() const { return m_surface_areas; }
  /// the centroid of each id.
  const std::vector<Position>& centroids() const { return m_centroids; }
  /// whether the cell of a point is bounded, as all cells in a box are; false for a removed id.
  /// \pre `id < number_of_ids()`
  bool is_bounded(size_type id) const
  {
    CGAL_precondition(id < number_of_ids());
    return m_is_bounded[id] != 0;
  }

  /// where the facets of each id begin in `neighbors()` and `facet_areas()`, and where the last
  /// ones end: `number_of_ids() + 1` numbers.
  const std::vector<size_type>& offsets() const { return m_rows.offsets(); }
  /// the neighbors of all points, smaller ids first for each, then smaller shifts, as arrays are
  /// compared. Those of `id` are from `offsets()[id]` to before `offsets()[id + 1]`.
  const std::vector<Id>& neighbors() const { return m_neighbors; }
  /// in periodic space, the shift of each entry of `neighbors()`: which image it is, as
  /// `Dynamic_periodic_Delaunay_triangulation_3::for_each_neighbor()` says. Empty in open space.
  const std::vector<Periodic_shift_3>& shifts() const { return m_shifts; }
  /// the area of the facet with each entry of `neighbors()`, the same seen from both sides.
  const std::vector<double>& facet_areas() const { return m_facet_areas; }

  /// @}

private:
  struct Facet
  {
    Dynamic_Delaunay_triangulations_3::internal::Neighbor_entry_3 neighbor;
    double area;
  };

  void resize(size_type number)
  {
    for (std::vector<double>* measures : {&m_volumes, &m_surface_areas})
      measures->assign(number, 0);
    m_centroids.assign(number, Position{0, 0, 0});
    m_is_bounded.assign(number, false);
  }

  void clear()
  {
    m_rows.clear();
    m_neighbors.clear();
    m_shifts.clear();
    m_facet_areas.clear();
    resize(0);
  }

  template <class Dynamic>
  void measure(const Dynamic& dt, const Box* box)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point floating_point;
    const auto& state = Dynamic_Delaunay_triangulations_3::internal::certified_state(dt);
    try {
      resize(state.ids.number_of_ids());
      measure_vertices(state, box);
      share_facets<typename std::decay_t<decltype(state)>::Parts>();
    } catch (...) {
      clear();
      throw;
    }
  }

  template <class State>
  void measure_vertices(const State& state, const Box* box)
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    Measured_cells_3<State> cells(state, box);
    const auto& sites = cells.sites();
    const double unit = sites.unit();
    m_rows.compute(
        state, 0,
        [&](Vertex_index v, size_type part, std::vector<Facet>& facets) {
          const auto& cell = cells.measure(v, part);
          store(sites, v, cell);
          const auto begin = std::ptrdiff_t(facets.size());
          for (const auto& neighbor : cell.neighbors)
            facets.push_back({sites.entry(neighbor.site), neighbor.area * unit * unit});
          std::sort(facets.begin() + begin, facets.end(), [&](const Facet& f, const Facet& g) {
            return sites.is_before(v, f.neighbor, g.neighbor);
          });
        },
        [&](size_type number) {
          m_neighbors.resize(number);
          m_shifts.resize(sites.shown_shifts * number);
          m_facet_areas.resize(number);
        },
        [&](Vertex_index v, size_type entry, const Facet& facet) {
          m_neighbors[entry] = facet.neighbor.id;
          sites.show_shift(v, facet.neighbor,
                           [&](const Periodic_shift_3& shift) { m_shifts[entry] = shift; });
          m_facet_areas[entry] = facet.area;
        });
  }

  // Points that coincide get equal shares of the volume.
  template <class Sites, class Cell>
  void store(const Sites& sites, Vertex_index v, const Cell& cell)
  {
    const auto& ids = sites.state().ids;
    double points = 1;
    ids.for_each_covered_at(v, [&](const auto&...) { ++points; });
    const auto store_at = [&](Point_id id, const Position& given) {
      m_volumes[id] = cell.measures.volume / points;
      m_surface_areas[id] = cell.measures.surface;
      m_is_bounded[id] = cell.is_bounded;
      m_centroids[id] = cell.centroid(given);
    };
    store_at(ids.representative(v), sites.given_position(v));
    ids.for_each_covered_at(
        v, [&](Point_id id, const auto& point) { store_at(id, sites.given_position(v, point)); });
  }

  // Takes the area of each facet from the cell of the smaller id, or of the smaller shift.
  template <class Parts>
  void share_facets()
  {
    Parts::for_each_element(number_of_ids(), [&](size_type id) {
      for (size_type entry = offsets()[id]; entry < offsets()[id + 1]; ++entry) {
        if (m_neighbors[entry] > id)
          break;
        if (const size_type twin = twin_of(id, entry); twin < entry)
          m_facet_areas[entry] = m_facet_areas[twin];
      }
    });
  }

  // The entry of the same facet in the row of the neighbor.
  size_type twin_of(size_type id, size_type entry) const
  {
    const size_type other = m_neighbors[entry];
    const auto row = m_neighbors.begin();
    const auto first =
        std::lower_bound(row + std::ptrdiff_t(offsets()[other]),
                         row + std::ptrdiff_t(offsets()[other + 1]), static_cast<Id>(id));
    auto twin = size_type(first - row);
    if (m_shifts.empty())
      return twin;
    const Periodic_shift_3& shift = m_shifts[entry];
    while (m_shifts[twin] != Periodic_shift_3{-shift[0], -shift[1], -shift[2]})
      ++twin;
    return twin;
  }

  std::vector<double> m_volumes, m_surface_areas;
  std::vector<Position> m_centroids;
  std::vector<unsigned char> m_is_bounded; // threads write them
  Dynamic_Delaunay_triangulations_3::internal::Rows_by_id_3<Facet> m_rows;
  std::vector<Id> m_neighbors;
  std::vector<Periodic_shift_3> m_shifts;
  std::vector<double> m_facet_areas;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_MEASURES_3_H
