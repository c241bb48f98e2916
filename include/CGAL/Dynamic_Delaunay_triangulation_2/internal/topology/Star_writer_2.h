// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_STAR_WRITER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_STAR_WRITER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Writes the faces inside of a star polygon, for the editors of all spaces. `set_corner(h, corner)`
// makes `corner` the corner at half-edge h.
template <class State>
class Star_writer_2
{
  using Slot = Halfedge_arrays_2::Slot;
  using Polygon = Star_polygon_2<State>;

public:
  explicit Star_writer_2(Halfedge_arrays_2& arrays)
    : m_arrays(arrays)
  {
  }

  // Reserves memory for write_ears().
  void reserve(const Polygon& polygon) { m_open_sides.resize(polygon.sides().size()); }

  // Replaces the faces around the center by the ears. The i-th ear gets the number of the polygon's
  // i-th face, and the edge that cuts it off that of the i-th edge. Returns the center's slot.
  template <class Set_corner>
  Slot write_ears(const Polygon& polygon, const Set_corner& set_corner)
  {
    const auto& sides = polygon.sides();
    const auto& ears = polygon.ears();
    for (std::size_t i = 0; i < sides.size(); ++i)
      m_open_sides[i] = {sides[i].outer, sides[i].edge};
    for (std::size_t i = 0; i < ears.size(); ++i) {
      const auto& ear = ears[i];
      const Face_index f = polygon.faces()[i];
      set_corner(Halfedge_arrays_2::halfedge_in(f, 0), sides[ear.before].corner);
      set_corner(Halfedge_arrays_2::halfedge_in(f, 1), sides[ear.tip].corner);
      set_corner(Halfedge_arrays_2::halfedge_in(f, 2), sides[ear.after].corner);
      close(m_open_sides[ear.before], Halfedge_arrays_2::halfedge_in(f, 2));
      close(m_open_sides[ear.tip], Halfedge_arrays_2::halfedge_in(f, 0));
      m_open_sides[ear.before] = {Halfedge_arrays_2::halfedge_in(f, 1), polygon.edges()[i]};
    }
    // the last ear is a triangle that has a side of the polygon for its third edge
    close(m_open_sides[ears.back().after],
          Halfedge_arrays_2::halfedge_in(polygon.faces()[ears.size() - 1], 1));
    const Slot slot = slot_left_by(polygon);
    m_arrays.empty(slot);
    return slot;
  }

  // Replaces the faces inside by those around the center. The face at the i-th side gets the number
  // of the i-th face, and the edge from the center to the end of the side that of the i-th edge.
  template <class Set_corner>
  void write_star(const Polygon& polygon, const Set_corner& set_corner)
  {
    const auto& sides = polygon.sides();
    const std::size_t degree = sides.size();
    for (std::size_t i = 0; i < degree; ++i) {
      const Halfedge_index h = Halfedge_arrays_2::halfedge_in(polygon.faces()[i], 0);
      set_corner(h, State::corner_of(polygon.center()));
      set_corner(h + 1, sides[i].corner);
      set_corner(h + 2, sides[i + 1 < degree ? i + 1 : 0].corner);
    }
    for (std::size_t i = 0; i < degree; ++i) {
      const Halfedge_index h = Halfedge_arrays_2::halfedge_in(polygon.faces()[i], 0);
      close({sides[i].outer, sides[i].edge}, h);
      m_arrays.link(h + 1,
                    Halfedge_arrays_2::halfedge_in(polygon.faces()[i + 1 < degree ? i + 1 : 0], 2));
      m_arrays.set_edge(polygon.edges()[i], h + 1);
    }
  }

  // Calls f(e) for the edges that write_ears() has made, and for all edges of the last face, which
  // has no new edge if it is the only face.
  template <class Function>
  void for_each_edge_of_ears(const Polygon& polygon, const Function& f) const
  {
    const auto& edges = polygon.edges();
    for (std::size_t i = 0; i + 3 < edges.size(); ++i)
      f(edges[i]);
    const Index last = polygon.faces()[polygon.ears().size() - 1];
    for (const Halfedge_index h : Halfedge_arrays_2::halfedges_of(last))
      f(m_arrays.edge_of(h));
  }

private:
  // A side of a polygon while ears are cut off: the half-edge outside of it, and its edge.
  struct Open_side
  {
    Halfedge_index outer;
    Edge_index edge;
  };

  // Makes h the inner half-edge of an open side. The face of h must have its vertices.
  void close(const Open_side& side, Halfedge_index h)
  {
    m_arrays.link(h, side.outer);
    m_arrays.set_edge(side.edge, h);
  }

  // The numbers that write_ears() does not use.
  static Slot slot_left_by(const Polygon& polygon)
  {
    const auto face = polygon.faces().end();
    const auto edge = polygon.edges().end();
    return {polygon.center(), {face[-2], face[-1]}, {edge[-3], edge[-2], edge[-1]}};
  }

  Halfedge_arrays_2& m_arrays;
  std::vector<Open_side> m_open_sides;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_STAR_WRITER_2_H
