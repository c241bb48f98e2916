// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_MEASURED_CELLS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_MEASURED_CELLS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Boxed_cell_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Voronoi_vertices_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Flat_neighbors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Rows_by_id_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_images_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The box of the user, unless it is empty or too large for the cube of its extents.
inline Box_3 checked_box(const Bbox_3& box)
{
  using Dynamic_Delaunay_triangulations_2::internal::check_extent;
  constexpr double largest = 1e100;
  check_extent("the extent of the box along x", box.xmax() - box.xmin(), largest);
  check_extent("the extent of the box along y", box.ymax() - box.ymin(), largest);
  check_extent("the extent of the box along z", box.zmax() - box.zmin(), largest);
  return {{box.xmin(), box.ymin(), box.zmin()}, {box.xmax(), box.ymax(), box.zmax()}};
}

// A box of the kernel with its corners rounded.
template <class Iso_cuboid>
Bbox_3 rounded_box(const Iso_cuboid& box)
{
  return Bbox_3(CGAL::to_double(box.xmin()), CGAL::to_double(box.ymin()),
                CGAL::to_double(box.zmin()), CGAL::to_double(box.xmax()),
                CGAL::to_double(box.ymax()), CGAL::to_double(box.zmax()));
}

// The Voronoi cells of all vertices, whole or in a box, for all parts of the vertices at once. On a
// torus there are no boxes.
template <class State>
class Measured_cells_3
{
  using Charts = Site_charts_3<typename State::Arrays>;
  using Sites = Scaled_sites_3<State>;
  using Parts = typename State::Parts;

public:
  // What measure() found last in a part.
  struct Cell
  {
    // The centroid of the cell of a point that is given here: the point itself, if there is none.
    Position_3 centroid(const Position_3& given) const
    {
      const Position_3 c = is_clipped ? measures.centroid : given + measures.centroid;
      return measures.volume > 0 && measures.volume < infinity && is_finite(c) ? c : given;
    }

    Cell_measures_3 measures; // in units of the coordinates
    bool is_bounded = false;
    bool is_clipped = false; // then the measured centroid is not relative to the vertex
    std::vector<Cell_neighbor_3<typename Charts::Site>> neighbors; // in units of the sites
    Whole_cell_3<State> whole;
    Boxed_cell_3<State> boxed;
  };

  // The triangulation stays as it is while this is used.
  Measured_cells_3(const State& state, const Box_3* box)
    : m_sites(sites_for(state, box))
    , m_cells(Parts::number(state.number_of_vertices(), least_stars<Parts>))
  {
    if (state.spans_space)
      m_corners.emplace(m_sites);
    else if constexpr (!Charts::is_periodic)
      m_flat.list_cells(state);
    if (box != nullptr)
      m_box = Box_3{m_sites.scaled(box->low), m_sites.scaled(box->high)};
  }

  const Sites& sites() const { return m_sites; }

  const Cell& measure(Vertex_index v, std::size_t part)
  {
    Cell& cell = m_cells[part];
    measure_whole(v, cell);
    if constexpr (!Charts::is_periodic)
      clip(v, cell);
    const double unit = m_sites.unit();
    cell.measures = {cell.measures.volume * unit * unit * unit, cell.measures.surface * unit * unit,
                     unit * cell.measures.centroid};
    return cell;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The unit suits the box, too.
  static Sites sites_for(const State& state, const Box_3* box)
  {
    if constexpr (Charts::is_periodic)
      return Sites(state);
    else
      return Sites(state, box == nullptr ? 0.0
                                         : (std::max)(largest_coordinate(box->low),
                                                      largest_coordinate(box->high)));
  }

  void measure_whole(Vertex_index v, Cell& cell)
  {
    if (m_corners) {
      cell.measures = cell.whole.measure(*m_corners, v);
      cell.is_bounded = cell.whole.is_bounded();
      cell.neighbors = cell.whole.neighbors();
      return;
    }
    cell.measures = {infinity, infinity};
    cell.is_bounded = false;
    cell.neighbors.clear();
    if constexpr (!Charts::is_periodic)
      m_flat.for_each_neighbor(v, [&](Vertex_index w) {
        cell.neighbors.push_back({Charts::site(w), infinity});
      });
  }

  // Leaves a whole cell what is in the box.
  void clip(Vertex_index v, Cell& cell)
  {
    cell.is_clipped = m_box && !(cell.is_bounded && m_box->contains(m_sites.at(v), cell.whole.low(),
                                                                    cell.whole.high()));
    if (!cell.is_clipped)
      return;
    cell.measures = cell.boxed.measure(m_sites, v, *m_box, cell.neighbors);
    cell.is_bounded = true;
  }

  const Sites m_sites;
  std::optional<Voronoi_vertices_3<State>> m_corners; // unless there are no cells
  Flat_neighbors_3 m_flat;                            // in open space, if there are none
  std::optional<Box_3> m_box;                         // in units of the sites
  std::vector<Cell> m_cells;                          // of each part
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_MEASURED_CELLS_3_H
