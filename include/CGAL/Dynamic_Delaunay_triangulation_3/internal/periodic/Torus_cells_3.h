// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CELLS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CELLS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_arrays_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A cell of a torus, in one line of a cache.
struct alignas(64) Torus_cell_3
{
  using Site = Torus_site_3;
  using Sites = Torus_sites_3;
  static constexpr bool may_repeat_vertices = true;

  Site site(int place) const { return {vertices[place], shifts[place]}; }

  Sites sites() const
  {
    Sites sites;
    for (int i = 0; i < 4; ++i)
      sites[i] = site(i);
    return sites;
  }
  static bool is_free(const Sites& sites) { return sites[0].vertex == null_index; }
  // With its sites in another order, in the chart in which the first one, a finite one, has the
  // shift 0.
  Torus_cell_3 turned(const Few<std::uint8_t, 4>& places) const
  {
    Torus_cell_3 cell{permuted(vertices, places), permuted(mirrors, places),
                      permuted(shifts, places), permuted(beyond, places)};
    cell.move_chart(-cell.shifts[0]);
    return cell;
  }
  // Adds a translation to all but the point at infinity.
  void move_chart(Torus_shift_3 translation)
  {
    for (int i = 0; i < 4; ++i) {
      if (vertices[i] != infinite_index)
        shifts[i] = shifts[i] + translation;
      beyond[i] = beyond[i] + translation;
    }
  }
  void exchange(Torus_cell_3& other)
  {
    exchange_what_differs(vertices, other.vertices);
    exchange_what_differs(mirrors, other.mirrors);
    exchange_what_differs(shifts, other.shifts);
    exchange_what_differs(beyond, other.beyond);
  }

  Vertices_3 vertices;
  Few<Corner_index, 4> mirrors;
  Shifts_3 shifts; // of these vertices
  Shifts_3 beyond; // of the vertices of the mirrors
};

// A triangulated torus of three dimensions: one cell for each class of cells in space that are
// images of each other. Vertices have the numbers from 1 on.
//
// Each cell has a chart of its own, in which its vertices have shifts; that of the first finite one
// is 0. At each corner it knows the mirror corner in the neighbor, and which shift the vertex there
// has in its own chart. That tells the translation that takes the neighbor's chart to its own: a
// site of the neighbor with the shift s has the shift s + translation here. So nothing has to be
// found by comparing vertices, and a cell may have several images of a vertex, or be another's
// neighbor several times; it is never its own (see `Lawson_flips_3.h`). And a cell says alone
// whether all that a pass tests of it has no shift, as in most cells.
//
// In a slab there are infinite cells, too: each facet of the hull has one with the point at
// infinity that is above or below. Translations leave these two points where they are; only what is
// stored beyond a facet is shifted, so that it tells the translation.
class Torus_cells_3 : public Cell_arrays_3<Torus_cell_3>
{
public:
  using Site = Torus_site_3;
  using Sites = Torus_sites_3;
  using Translation = Torus_shift_3;

  static Vertex_index vertex_of(const Site& s) { return s.vertex; }
  static bool is_infinite(const Site& s) { return s.is_infinite(); }
  bool is_infinite(Cell_index c) const { return has_infinite(vertices(c)); }
  // A site as seen in the chart that the translation takes to this one.
  static Site translated_back(const Site& s, Translation translation) { return s - translation; }
  // What takes a finite site of one chart to another image of it.
  static Translation translation(const Site& from, const Site& to) { return to.shift - from.shift; }
  // What takes the chart of the neighbor opposite to a corner to that of the corner's cell.
  Translation translation(Corner_index k) const
  {
    const Corner_index l = mirror(k);
    return m_cells[cell_of(k)].beyond[place_of(k)] - m_cells[cell_of(l)].shifts[place_of(l)];
  }

  // In the chart of the corner's cell.
  Torus_site_3 site(Corner_index k) const { return m_cells[cell_of(k)].site(place_of(k)); }
  Torus_site_3 apex_site(Corner_index k) const
  {
    const Torus_site_3 there = site(mirror(k));
    return {there.vertex,
            there.is_infinite() ? there.shift : m_cells[cell_of(k)].beyond[place_of(k)]};
  }
  // The place of a finite vertex, of which every cell has three.
  static int first_finite_place(const Vertices_3& v) { return v[0] == infinite_index ? 1 : 0; }
  // That with the shift 0.
  Torus_site_3 first_finite_site(Cell_index c) const
  {
    return site(corner(c, first_finite_place(vertices(c))));
  }
  Torus_sites_3 sites(Cell_index c) const { return m_cells[c].sites(); }
  // The place of a site in a cell, or 4.
  using Cell_arrays_3::place_of;
  int place_of(Cell_index c, const Torus_site_3& s) const
  {
    int place = 0;
    while (place < 4 && !(site(corner(c, place)) == s))
      ++place;
    return place;
  }

  // CHANGES ---------------------------------------------------------------------------------------

  void set_sites(Cell_index c, const Torus_sites_3& sites, std::size_t part = whole)
  {
    record(c, part);
    note(c, part);
    for (int i = 0; i < 4; ++i) {
      m_cells[c].vertices[i] = sites[i].vertex;
      m_cells[c].shifts[i] = sites[i].shift;
      note_corner(corner(c, i), part);
    }
  }

  // Makes two corners, whose cells have got their sites, each other's mirror. The translation takes
  // the chart of l's cell to k's.
  void connect(Corner_index k, Corner_index l, Torus_shift_3 translation, std::size_t part = whole)
  {
    meet(cell_of(k), part);
    meet(cell_of(l), part);
    set_mirror(k, l, translation);
    set_mirror(l, k, -translation);
  }

  // Replaces the two different cells at the facet opposite to k by three around the edge from the
  // vertex of k to the one beyond.
  Flipped flip_2_3(Corner_index k, std::size_t part = whole)
  {
    const Cell_index first = cell_of(k), second = cell_of(mirror(k));
    CGAL_precondition(first != second);
    const int top = place_of(k);
    const Torus_sites_3 a = sites(first);
    const Torus_site_3 beyond = apex_site(k);
    const Torus_shift_3 of_second = translation(k);
    Few<int, 3> around;
    for (int i = 0, n = 0; i < 4; ++i)
      if (i != top)
        around[n++] = i;
    Flipped flipped{{first, second, make_cell(part)}, 3, {}};
    Few<Outer_facet, 6> outer;
    for (int n = 0; n < 3; ++n) {
      const Torus_site_3 s = a[around[n]];
      const int below = place_of(second, s - of_second);
      outer[2 * n] = {corner(first, around[n]), corner(flipped.cells[n], around[n]), {}};
      outer[2 * n + 1] = {corner(second, below), corner(flipped.cells[n], top), of_second};
    }
    read_mirrors(outer);
    for (int n = 0; n < 3; ++n) {
      Torus_sites_3 s = a;
      s[around[n]] = beyond;
      set_sites(flipped.cells[n], s, part);
    }
    for (int n = 0; n < 3; ++n)
      for (int m = 0; m < n; ++m)
        connect(corner(flipped.cells[n], around[m]), corner(flipped.cells[m], around[n]), {}, part);
    connect_outer(
        outer, [=](Cell_index c) { return c == first || c == second; }, part);
    for (const Cell_index c : flipped.cells)
      normalize(c, part);
    flipped.outer = new_corners(outer);
    return flipped;
  }

  // Replaces the three different cells around an edge by two: the two at the facet opposite to k,
  // and their common neighbor opposite to the vertex at `side` in the cell of k. The edge joins the
  // other two vertices.
  Flipped flip_3_2(Corner_index k, int side, std::size_t part = whole)
  {
    const Cell_index first = cell_of(k), second = cell_of(mirror(k)), third = neighbor(first, side);
    CGAL_precondition(first != second && first != third && second != third);
    const int top = place_of(k);
    const Torus_sites_3 a = sites(first);
    const Torus_site_3 beyond = apex_site(k);
    const Torus_shift_3 of_second = translation(k), of_third = translation(corner(first, side));
    int p = 0;
    while (p == top || p == side)
      ++p;
    const int q = 6 - top - side - p;
    const auto opposite_to = [&](Cell_index c, Torus_shift_3 shift, const Torus_site_3& s) {
      return corner(c, place_of(c, s - shift));
    };
    Few<Outer_facet, 6> outer{{
        {corner(first, q), corner(first, q), {}},
        {opposite_to(second, of_second, a[q]), corner(first, top), of_second},
        {opposite_to(third, of_third, a[q]), corner(first, side), of_third},
        {corner(first, p), corner(second, p), {}},
        {opposite_to(second, of_second, a[p]), corner(second, top), of_second},
        {opposite_to(third, of_third, a[p]), corner(second, side), of_third},
    }};
    read_mirrors(outer);
    Torus_sites_3 s = a, t = a;
    s[q] = beyond;
    t[p] = beyond;
    drop_cell(third, part);
    set_sites(first, s, part);
    set_sites(second, t, part);
    connect(corner(first, p), corner(second, q), {}, part);
    connect_outer(
        outer, [=](Cell_index c) { return c == first || c == second || c == third; }, part);
    normalize(first, part);
    normalize(second, part);
    return {{first, second, null_index}, 2, new_corners(outer)};
  }

  // Replaces cells, which form a ball without sites inside, no two of them images of each other, by
  // cells over its border that have an image of the vertex v in common. What is beyond the border
  // stays. `border` is as in open space; `shifts` are those that the image of v has in the charts
  // of its cells. Returns a new cell. `star` is memory that is used anew each time; parts have one
  // each.
  Cell_index replace_by_star(const std::vector<Cell_index>& ball,
                             const std::vector<Corner_index>& border,
                             const std::vector<Torus_shift_3>& shifts, Vertex_index v,
                             std::vector<Star_cell>& star, std::size_t part = whole)
  {
    prepare_star(ball, border, star, part, [&](Star_cell& made, std::size_t n) {
      move_to_chart_of_star(made, v, shifts[n]);
    });
    for (const Star_cell& made : star)
      write(made, part);
    for (const Star_cell& made : star)
      connect_written(made, part);
    for (const Star_cell& made : star)
      normalize(made.number, part);
    return star.back().number;
  }

  // A facet between cells that are replaced and others, or images of themselves: the corner
  // opposite to it in a cell that goes, and in one that comes. The shift takes the chart of the
  // former to that of the latter.
  struct Outer_facet
  {
    Corner_index from, to;
    Torus_shift_3 shift;
    Corner_index mirror = Corner_index(null_index); // of `from`, and the translation
    Torus_shift_3 translation = {};
  };

  // Reads what is behind outer facets, before cells are overwritten.
  template <class Outer_facets>
  void read_mirrors(Outer_facets& outer) const
  {
    for (Outer_facet& facet : outer) {
      facet.mirror = mirror(facet.from);
      facet.translation = translation(facet.from) + facet.shift;
    }
  }
  // Connects new cells with what is behind outer facets: a cell that stays, or a new one, if what
  // was there is replaced, too.
  template <class Outer_facets, class Predicate>
  void connect_outer(const Outer_facets& outer, const Predicate& is_replaced,
                     std::size_t part = whole)
  {
    for (const Outer_facet& facet : outer) {
      const Outer_facet* other = nullptr;
      if (is_replaced(cell_of(facet.mirror)))
        for (const Outer_facet& candidate : outer)
          if (candidate.from == facet.mirror)
            other = &candidate;
      if (other == nullptr)
        connect(facet.to, facet.mirror, facet.translation, part);
      else
        connect(facet.to, other->to, facet.translation - other->shift, part);
    }
  }

  // Moves the chart of a cell, so that its first finite vertex has the shift 0.
  void normalize(Cell_index c, std::size_t part = whole)
  {
    const Torus_shift_3 shift = first_finite_site(c).shift;
    if (shift == Torus_shift_3())
      return;
    record(c, part);
    Cell& cell = m_cells[c];
    cell.move_chart(-shift);
    for (int i = 0; i < 4; ++i)
      if (cell.vertices[i] == infinite_index) {
        const Corner_index l = cell.mirrors[i];
        record(cell_of(l), part);
        Torus_shift_3& beyond = m_cells[cell_of(l)].beyond[place_of(l)];
        beyond = beyond + shift;
      }
  }

  // Adds shifts to the images of all vertices; that of the infinite one must be 0.
  void shift_vertices(const Column<Vertex_index, Torus_shift_3>& shifts)
  {
    for (Cell& cell : m_cells)
      for (int i = 0; i < 4; ++i) {
        cell.shifts[i] = cell.shifts[i] + shifts[cell.vertices[i]];
        cell.beyond[i] = cell.beyond[i] + shifts[vertex(cell.mirrors[i])];
      }
    for (Cell_index c(0); c < number_of_cells(); ++c)
      normalize(c);
  }

private:
  // That in which the site in the middle has no shift.
  static void move_to_chart_of_star(Star_cell& made, Vertex_index v, Torus_shift_3 shift)
  {
    Cell& cell = made.cell;
    cell.move_chart(-shift);
    cell.vertices[made.tip] = v;
    cell.shifts[made.tip] = {};
  }
  // Connects a cell of a star, all in one chart, with what is beyond the border; and takes over
  // what is beyond its other facets.
  void connect_written(const Star_cell& made, std::size_t part)
  {
    for (const std::uint8_t place : other_places[made.tip]) {
      const Corner_index l = made.cell.mirrors[place];
      m_cells[made.number].beyond[place] = m_cells[cell_of(l)].shifts[place_of(l)];
    }
    const Corner_index outer = made.cell.mirrors[made.tip];
    const Torus_shift_3 translation =
        made.cell.beyond[made.tip] - m_cells[cell_of(outer)].shifts[place_of(outer)];
    connect(corner(made.number, made.tip), outer, translation, part);
  }

  void set_mirror(Corner_index k, Corner_index l, Torus_shift_3 translation)
  {
    Cell& cell = m_cells[cell_of(k)];
    cell.mirrors[place_of(k)] = l;
    cell.beyond[place_of(k)] = m_cells[cell_of(l)].shifts[place_of(l)] + translation;
  }

  static Few<Corner_index, 6> new_corners(const Few<Outer_facet, 6>& outer)
  {
    Few<Corner_index, 6> corners;
    std::transform(outer.begin(), outer.end(), corners.begin(),
                   [](const Outer_facet& facet) { return facet.to; });
    return corners;
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CELLS_3_H
