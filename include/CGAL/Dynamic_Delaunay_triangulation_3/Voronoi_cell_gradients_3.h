// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_GRADIENTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_GRADIENTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

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
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

How the volumes of the Voronoi cells of points in space change when the points move: the volume of
each cell, whole, in open or in periodic space, or in a box, differentiated by the position of its
own point and by those of its neighbors. All other points leave it as it is. Tissues and foams move
by such forces.

Let \f$V_i\f$ be the volume of the cell of point \f$i\f$, and \f$E\f$ a function of all volumes.
With the weights \f$a_i = \partial E / \partial V_i\f$, which the caller computes from
`Voronoi_cell_measures_3`, `gradients()` finds for every point \f$k\f$
\f[ \frac{\partial E}{\partial x_k} = \sum_i a_i \frac{\partial V_i}{\partial x_k} . \f]
The force is the negative of that. `compute()` finds the derivatives of all volumes, once for any
number of weights.

<b>Derivation.</b> Let \f$A_{ij}\f$ be the area of the facet between the cells of \f$i\f$ and
\f$j\f$, \f$c_{ij}\f$ its centroid, and \f$d = x_j - x_i\f$, which is normal to it and leaves the
cell of \f$i\f$. A point \f$y\f$ of the facet keeps \f$|y - x_i|^2 = |y - x_j|^2\f$. If \f$x_j\f$
moves, that is \f$\dot y \cdot d = (x_j - y) \cdot \dot x_j\f$, so the facet moves outward by
\f$(x_j - y) \cdot \dot x_j / |d|\f$ at \f$y\f$; if \f$x_i\f$ moves, by
\f$(y - x_i) \cdot \dot x_i / |d|\f$. What moves across the boundary of a cell changes its volume,
and what the rims of facets do beside that is of second order (Reynolds' transport theorem). The
integrals over the facet are
\f[ \frac{\partial V_i}{\partial x_j} = \frac{A_{ij}}{|d|} (x_j - c_{ij}), \qquad
    \frac{\partial V_i}{\partial x_i} = \sum_j \frac{A_{ij}}{|d|} (c_{ij} - x_i) . \f]
M. Serrano and P. Español (*Thermodynamically consistent mesoscopic fluid particle model*, Physical
Review E 64, 046115, 2001) have the same. Where a box clips a cell, the facets are those parts that
are in the box; its walls do not move, so they add nothing.

- The derivatives of a whole cell add up to 0 but for rounding, as its volume stays where all points
  move alike. Those of a clipped cell add up to the area of the walls that it has, as a vector that
  points into the box.
- An unbounded cell has derivatives 0, and contributes nothing: its weights are ignored, whatever
  they are. In a box all cells are bounded.
- In periodic space neighbors are images, and `shifts()` tells which. A derivative is that by the
  position of one image, while all others stay; `gradients()` adds up those of all images of a
  point, itself included, as these move together.
- Points that coincide share a cell, as in `Voronoi_cell_measures_3`. Only their representative has
  derivatives, those of the whole cell's volume by the position of all of them together. Of
  `gradients()`, where the volume of each is an equal share of the cell's, each gets an equal
  share. (If one of them moves alone, the cell is split, and there is no derivative.)
- Removed ids have 0 for all derivatives, no neighbors, and their weights are ignored.

The derivatives stay continuous where cells flip. They jump where points part, and where one of the
bisectors lies in a wall of the box.

Areas and centroids of facets are as accurate as `Voronoi_cell_measures_3` says; a derivative is
them, divided by the distance of two points. Where that makes it too large for a double, it is not
finite.

\sa `Voronoi_cell_measures_3`
*/
class Voronoi_cell_gradients_3
{
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  using Box = Dynamic_Delaunay_triangulations_3::internal::Box_3;

public:
  /// \name Types
  /// @{

  /// an id in the arrays: 32 bits, as inside the triangulation.
  using Id = std::uint32_t;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// a vector: three doubles, `x`, `y` and `z`.
  using Vector = Dynamic_Delaunay_triangulations_3::Position_3;

  /// @}
  /// \name Computation
  /// Threads share the work of `compute()` if the triangulation has the `Parallel_tag`; the result
  /// does not depend on their number. If memory runs out, there are no derivatives.
  /// @{

  /// computes the derivatives of the volumes of whole cells.
  ///
  /// Cost: about that of `Voronoi_cell_measures_3::compute()`.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_3` or a
  ///   `Dynamic_periodic_Delaunay_triangulation_3`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    differentiate(dt, nullptr);
  }

  /// computes the derivatives of the volumes of the parts of the cells in a box.
  ///
  /// Cost: about that of `Voronoi_cell_measures_3::compute()` with this box.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_3`. No other compiles.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \throws Parameter_error_2 unless the extents of the box are from 0 to 1e100; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const Bbox_3& box)
  {
    static_assert(!Dynamic_Delaunay_triangulations_3::internal::is_periodic_3<Dynamic>,
                  "in periodic space there are no boxes: compute(dt) takes whole cells");
    const Box bounds = Dynamic_Delaunay_triangulations_3::internal::checked_box(box);
    differentiate(dt, &bounds);
  }

  /// does so for a box of the kernel, whose corners are rounded to doubles.
  template <class Dynamic>
  void compute(const Dynamic& dt, const typename Dynamic::Geom_traits::Iso_cuboid_3& box)
  {
    compute(dt, Dynamic_Delaunay_triangulations_3::internal::rounded_box(box));
  }

  /// returns the gradient of an energy by the position of each id, in units of energy by length.
  /// There is one weight for each id, the derivative of the energy by its volume.
  ///
  /// Cost: linear, one pass over the derivatives.
  /// \throws Point_count_error_2 if there are not as many weights as ids.
  std::vector<Vector> gradients(const std::vector<double>& volume_weights) const
  {
    if (volume_weights.size() != number_of_ids())
      throw Point_count_error_2(number_of_ids(), volume_weights.size());
    std::vector<double> weights(number_of_ids(), 0), points(number_of_ids(), 0);
    for (size_type id = 0; id < number_of_ids(); ++id)
      if (const size_type first = m_representatives[id]; first != removed) {
        ++points[first];
        weights[first] += (volume_weights[id] - weights[first]) / points[first]; // the mean
      }
    std::vector<Vector> result(number_of_ids(), Vector{0, 0, 0});
    for (size_type id = 0; id < number_of_ids(); ++id)
      if (m_is_bounded[id])
        add_cell(id, weights[id], result);
    share(points, result);
    return result;
  }

  /// @}
  /// \name Access
  /// @{

  /// one more than the largest id ever in use.
  size_type number_of_ids() const { return m_by_positions.size(); }
  /// the derivative of the volume of each id by its own position, in units of area.
  const std::vector<Vector>& by_positions() const { return m_by_positions; }

  /// where the neighbors of each id begin in `neighbors()` and `by_neighbors()`, and where the last
  /// ones end: `number_of_ids() + 1` numbers.
  const std::vector<size_type>& offsets() const { return m_rows.offsets(); }
  /// the neighbors of all points, as in `Voronoi_cell_measures_3`. Those of `id` are from
  /// `offsets()[id]` to before `offsets()[id + 1]`.
  const std::vector<Id>& neighbors() const { return m_neighbors; }
  /// in periodic space, the shift of each entry of `neighbors()`. Empty in open space.
  const std::vector<Periodic_shift_3>& shifts() const { return m_shifts; }
  /// the derivative of the volume of an id by the position of each entry of `neighbors()`.
  const std::vector<Vector>& by_neighbors() const { return m_by_neighbors; }

  /// @}

private:
  struct Facet
  {
    Dynamic_Delaunay_triangulations_3::internal::Neighbor_entry_3 neighbor;
    double x, y, z; // the derivative; sorting aligned vectors makes GCC tell of its ABI
  };

  static constexpr Id removed = Id(-1);

  void resize(size_type number)
  {
    m_by_positions.assign(number, Vector{0, 0, 0});
    m_representatives.assign(number, removed);
    m_is_bounded.assign(number, false);
  }

  void clear()
  {
    m_rows.clear();
    m_neighbors.clear();
    m_shifts.clear();
    m_by_neighbors.clear();
    resize(0);
  }

  template <class Dynamic>
  void differentiate(const Dynamic& dt, const Box* box)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point floating_point;
    const auto& state = Dynamic_Delaunay_triangulations_3::internal::certified_state(dt);
    try {
      resize(state.ids.number_of_ids());
      differentiate_cells(state, box);
      state.ids.for_each_covered([&](size_type id, Vertex_index v, const auto&) {
        m_representatives[id] = state.ids.representative(v);
      });
    } catch (...) {
      clear();
      throw;
    }
  }

  template <class State>
  void differentiate_cells(const State& state, const Box* box)
  {
    using Dynamic_Delaunay_triangulations_3::internal::Measured_cells_3;
    Measured_cells_3<State> cells(state, box);
    m_rows.compute(
        state, 0,
        [&](Vertex_index v, size_type part, std::vector<Facet>& facets) {
          const Id id = state.ids.representative(v);
          const auto& cell = cells.measure(v, part);
          m_representatives[id] = id;
          m_is_bounded[id] = cell.is_bounded;
          const auto begin = std::ptrdiff_t(facets.size());
          for (const auto& neighbor : cell.neighbors) {
            facets.push_back({cells.sites().entry(neighbor.site), 0, 0, 0});
            if (cell.is_bounded)
              differentiate_facet(cells.sites(), v, neighbor, m_by_positions[id], facets.back());
          }
          std::sort(facets.begin() + begin, facets.end(), [&](const Facet& f, const Facet& g) {
            return cells.sites().is_before(v, f.neighbor, g.neighbor);
          });
        },
        [&](size_type number) {
          m_neighbors.resize(number);
          m_shifts.resize(cells.sites().shown_shifts * number);
          m_by_neighbors.resize(number);
        },
        [&](Vertex_index v, size_type entry, const Facet& facet) {
          m_neighbors[entry] = facet.neighbor.id;
          cells.sites().show_shift(v, facet.neighbor,
                                   [&](const Periodic_shift_3& s) { m_shifts[entry] = s; });
          m_by_neighbors[entry] = {facet.x, facet.y, facet.z};
        });
  }

  // Adds what a facet of the cell of v contributes.
  template <class Sites, class Neighbor>
  static void differentiate_facet(const Sites& sites, Vertex_index v, const Neighbor& neighbor,
                                  Vector& by_position, Facet& facet)
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    const double unit = sites.unit() * sites.unit();
    const Vector way = sites.vector(sites.site(v), neighbor.site);
    const double length = length_of(way);
    by_position = by_position + unit * divided(neighbor.moment, length);
    const Vector by = unit * divided(neighbor.area * way - neighbor.moment, length);
    facet = {facet.neighbor, by.x, by.y, by.z};
  }

  void add_cell(size_type id, double weight, std::vector<Vector>& sums) const
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    sums[id] = sums[id] + weight * m_by_positions[id];
    for (size_type entry = offsets()[id]; entry < offsets()[id + 1]; ++entry) {
      Vector& sum = sums[m_neighbors[entry]];
      sum = sum + weight * m_by_neighbors[entry];
    }
  }

  // Gives points that coincide their shares.
  void share(const std::vector<double>& points, std::vector<Vector>& sums) const
  {
    using namespace Dynamic_Delaunay_triangulations_3::internal;
    for (size_type id = 0; id < sums.size(); ++id)
      if (points[id] > 1)
        sums[id] = divided(sums[id], points[id]);
    for (size_type id = 0; id < sums.size(); ++id)
      if (m_representatives[id] != removed)
        sums[id] = sums[m_representatives[id]];
  }

  std::vector<Vector> m_by_positions;
  std::vector<Id> m_representatives;
  std::vector<unsigned char> m_is_bounded; // threads write them
  Dynamic_Delaunay_triangulations_3::internal::Rows_by_id_3<Facet> m_rows;
  std::vector<Id> m_neighbors;
  std::vector<Periodic_shift_3> m_shifts;
  std::vector<Vector> m_by_neighbors;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VORONOI_CELL_GRADIENTS_3_H
