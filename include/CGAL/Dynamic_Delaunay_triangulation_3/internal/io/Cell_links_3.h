// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CELL_LINKS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CELL_LINKS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Finds the neighbors of cells that are given by their vertices alone: those with a common facet.
class Cell_links_3
{
public:
  explicit Cell_links_3(Tetrahedra_arrays_3& arrays)
    : m_arrays(arrays)
  {
  }

  // Returns null_index, or else a cell with a facet that not exactly two cells have. Then only some
  // are linked. Cost: that of sorting all facets.
  Cell_index link()
  {
    list_facets();
    std::sort(m_facets.begin(), m_facets.end(), [](const Facet& f, const Facet& g) {
      return f.vertices < g.vertices || (f.vertices == g.vertices && f.corner < g.corner);
    });
    for (std::size_t i = 0; i < m_facets.size(); i += 2) {
      if (!is_pair(i))
        return Tetrahedra_arrays_3::cell_of(m_facets[i].corner);
      m_arrays.connect(m_facets[i].corner, m_facets[i + 1].corner);
    }
    return null_index;
  }

private:
  struct Facet
  {
    Few<Vertex_index, 3> vertices; // ascending
    Corner_index corner;           // opposite to it
  };

  void list_facets()
  {
    m_facets.reserve(4 * std::size_t(m_arrays.number_of_cells()));
    for (Cell_index c(0); c < m_arrays.number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i) {
        const Vertices_3& v = m_arrays.vertices(c);
        Facet facet{{v[i == 0], v[i <= 1 ? 2 : 1], v[i <= 2 ? 3 : 2]}, m_arrays.corner(c, i)};
        std::sort(facet.vertices.begin(), facet.vertices.end());
        m_facets.push_back(facet);
      }
  }

  // Whether this facet and the next one are the same, and no third one is.
  bool is_pair(std::size_t i) const
  {
    const auto is_same = [this, i](std::size_t j) {
      return j < m_facets.size() && m_facets[j].vertices == m_facets[i].vertices;
    };
    return is_same(i + 1) && !is_same(i + 2);
  }

  Tetrahedra_arrays_3& m_arrays;
  std::vector<Facet> m_facets;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CELL_LINKS_3_H
