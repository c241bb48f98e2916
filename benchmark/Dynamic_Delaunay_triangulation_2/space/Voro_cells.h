// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_VORO_CELLS_H
#define SPACE_VORO_CELLS_H

#ifdef HAS_VORO

#include "Space_points.h"

#include <CGAL/Bbox_3.h>
#include <voro++/voro++.hh>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace space {

// The Voronoi cells of points in a box by voro++ (Rycroft 2009), which cuts each cell out of the
// box by itself, and has no triangulation. Its grid is as it proposes.
class Voro_cells
{
public:
  Voro_cells(const Points& points, const CGAL::Bbox_3& box)
    : m_volumes(points.size())
  {
    voro::pre_container read(box.xmin(), box.xmax(), box.ymin(), box.ymax(), box.zmin(), box.zmax(),
                             false, false, false);
    for (std::size_t i = 0; i != points.size(); ++i) {
      read.put(int(i), points[i].x(), points[i].y(), points[i].z());
    }
    constexpr int points_in_a_block = 8; // for a start
    int nx = 0, ny = 0, nz = 0;
    read.guess_optimal(nx, ny, nz);
    m_container = std::make_unique<voro::container>(box.xmin(), box.xmax(), box.ymin(), box.ymax(),
                                                    box.zmin(), box.zmax(), nx, ny, nz, false,
                                                    false, false, points_in_a_block);
    read.setup(*m_container);
  }

  // Volumes alone.
  const std::vector<double>& volumes()
  {
    for_each_cell<voro::voronoicell>(
        [this](std::size_t id, voro::voronoicell& cell) { m_volumes[id] = cell.volume(); });
    return m_volumes;
  }

  // What Voronoi_cell_measures_3 measures.
  void measure()
  {
    m_facet_areas.clear();
    m_neighbors.clear();
    m_surface_areas.resize(m_volumes.size());
    m_centroids.resize(m_volumes.size());
    std::vector<double> areas;
    std::vector<int> neighbors;
    for_each_cell<voro::voronoicell_neighbor>(
        [&](std::size_t id, voro::voronoicell_neighbor& cell) {
          m_volumes[id] = cell.volume();
          m_surface_areas[id] = cell.surface_area();
          double x = 0, y = 0, z = 0;
          cell.centroid(x, y, z); // from the point
          m_centroids[id] = Point(x, y, z);
          cell.neighbors(neighbors);
          cell.face_areas(areas);
          m_neighbors.insert(m_neighbors.end(), neighbors.begin(), neighbors.end());
          m_facet_areas.insert(m_facet_areas.end(), areas.begin(), areas.end());
        });
  }

private:
  template <class Cell, class Function>
  void for_each_cell(const Function& f)
  {
    Cell cell;
    voro::c_loop_all loop(*m_container);
    if (loop.start()) {
      do {
        if (m_container->compute_cell(cell, loop)) {
          f(std::size_t(loop.pid()), cell);
        }
      } while (loop.inc());
    }
  }

  std::unique_ptr<voro::container> m_container;
  std::vector<double> m_volumes, m_surface_areas, m_facet_areas;
  Points m_centroids;
  std::vector<int> m_neighbors;
};

} // namespace space

#endif // HAS_VORO

#endif // SPACE_VORO_CELLS_H
