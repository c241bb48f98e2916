// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SITE_CHARTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SITE_CHARTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_cells_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <cstdint>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// How queries see cells. In open space there is one way, and sites are vertices. On a torus a cell
// is seen in a chart, which is a translation of its own one, and sites are images of vertices. This
// is all that walks have to know.
template <class Arrays>
struct Site_charts_3;

template <>
struct Site_charts_3<Tetrahedra_arrays_3>
{
  using Arrays = Tetrahedra_arrays_3;
  using Site = Vertex_index;
  using Seen_cell = Cell_index;
  using Key = Vertex_index;    // of a site, in sets
  using Cell_key = Cell_index; // of a cell as it is seen

  static constexpr bool is_periodic = false;

  static Site site(Vertex_index v) { return v; }
  static Vertex_index vertex_of(Site s) { return s; }
  static Key key(Site s) { return s; }
  static Cell_key key_of_cell(Seen_cell c) { return c; }
  static bool is_infinite(Site s) { return s == infinite_index; }
  static bool is_infinite(const Arrays& arrays, Cell_index c) { return arrays.is_infinite(c); }

  // The sites of a cell, in its own chart.
  static const Vertices_3& sites(const Arrays& arrays, Cell_index c) { return arrays.vertices(c); }
  static Cell_index cell_of(Seen_cell c) { return c; }
  static Site site(const Arrays& arrays, Seen_cell c, int place)
  {
    return arrays.vertices(c)[place];
  }
  static Site in_own_chart(Seen_cell, Site s) { return s; }
  static Seen_cell in_own_chart(Cell_index c) { return c; }
  // A site as seen from another one, at whose vertex it is not shifted.
  static Site seen_from(Site, Site s) { return s; }

  // A cell of a site.
  static Seen_cell first_cell(const Arrays& arrays, Site s)
  {
    return Arrays::cell_of(arrays.corner_of(s));
  }
  // The cell beyond the facet opposite to a place; `mirror` is the corner opposite to it there.
  static Seen_cell beyond(const Arrays&, Seen_cell, int, Corner_index mirror)
  {
    return Arrays::cell_of(mirror);
  }
  static int place_of(const Arrays& arrays, Seen_cell c, Site s) { return arrays.place_of(c, s); }
  static int place_of_known(const Arrays& arrays, Seen_cell c, Site s)
  {
    return Arrays::place_of_known(arrays.cell(c), s);
  }
};

template <>
struct Site_charts_3<Torus_cells_3>
{
  using Arrays = Torus_cells_3;
  using Site = Torus_site_3;
  using Key = std::uint64_t;
  using Cell_key = std::uint64_t;

  struct Seen_cell
  {
    Cell_index cell;
    Torus_shift_3 chart; // what takes its own chart to this one

    friend bool operator!=(const Seen_cell& c, const Seen_cell& d)
    {
      return c.cell != d.cell || c.chart != d.chart;
    }
  };

  static constexpr bool is_periodic = true;

  static Site site(Vertex_index v) { return {v, {}}; }
  static Vertex_index vertex_of(const Site& s) { return s.vertex; }
  static Key key(const Site& s) { return key(s.vertex, s.shift); }
  static Cell_key key_of_cell(const Seen_cell& c) { return key(c.cell, c.chart); }
  static bool is_infinite(const Site& s) { return s.is_infinite(); }
  static bool is_infinite(const Arrays& arrays, Cell_index c) { return arrays.is_infinite(c); }

  static Torus_sites_3 sites(const Arrays& arrays, Cell_index c) { return arrays.sites(c); }
  static Cell_index cell_of(const Seen_cell& c) { return c.cell; }
  static Site site(const Arrays& arrays, const Seen_cell& c, int place)
  {
    return arrays.site(Arrays::corner(c.cell, place)) + c.chart;
  }
  static Site in_own_chart(const Seen_cell& c, const Site& s) { return s - c.chart; }
  static Seen_cell in_own_chart(Cell_index c) { return {c, {}}; }
  static Site seen_from(const Site& from, const Site& s) { return s - from.shift; }

  static Seen_cell first_cell(const Arrays& arrays, const Site& s)
  {
    const Corner_index k = arrays.corner_of(s.vertex);
    return {Arrays::cell_of(k), s.shift - arrays.site(k).shift};
  }
  static Seen_cell beyond(const Arrays& arrays, const Seen_cell& c, int place, Corner_index mirror)
  {
    return {Arrays::cell_of(mirror), c.chart + arrays.translation(Arrays::corner(c.cell, place))};
  }
  static int place_of(const Arrays& arrays, const Seen_cell& c, const Site& s)
  {
    return arrays.place_of(c.cell, in_own_chart(c, s));
  }
  // Without branches.
  static int place_of_known(const Arrays& arrays, const Seen_cell& c, const Site& s)
  {
    const Arrays::Cell& cell = arrays.cell(c.cell);
    const Torus_shift_3 own = in_own_chart(c, s).shift;
    const auto is_at = [&](int place) {
      return int(cell.vertices[place] == s.vertex) & int(cell.shifts[place] == own);
    };
    return is_at(1) + 2 * is_at(2) + 3 * is_at(3);
  }

private:
  static std::uint64_t key(Index number, Torus_shift_3 shift)
  {
    return std::uint64_t(number) | std::uint64_t(std::uint32_t(shift.code)) << 32;
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SITE_CHARTS_3_H
