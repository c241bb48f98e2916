// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_STAR_POLYGON_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_STAR_POLYGON_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Vertices that may get other faces: all of them. A thread may have a part of them.
struct All_vertices_2
{
  bool operator()(Vertex_index) const { return true; }
};

// Before every eighth vertex of a list, fetches what the next eight have around them, but none from
// `beyond` on; the i-th is vertex(i). Walks around all of them in step, so that each step waits for
// memory once. Also fetches the edges, if `has_edges`: not where other threads take vertices out
// and put them in, because an edge opposite to the vertex may be theirs.
template <bool has_edges = false, class State, class Vertex_at>
void prefetch_stars(const State& state, std::size_t first, std::size_t beyond,
                    const Vertex_at& vertex)
{
  constexpr std::size_t stretch = 8, usual_degree = 6;
  if (first % stretch != 0)
    return;
  const Halfedge_arrays_2& arrays = state.arrays();
  std::array<Halfedge_index, stretch> corners;
  const std::size_t number = (std::min)(stretch, beyond - first);
  for (std::size_t i = 0; i < number; ++i) {
    corners[i] = arrays.corner(vertex(first + i));
    arrays.prefetch_face(corners[i]);
  }
  for (std::size_t step = 0; step < usual_degree; ++step)
    for (std::size_t i = 0; i < number; ++i) {
      const Halfedge_index h = corners[i];
      prefetch(state.positions().data() + arrays.source(h));
      if constexpr (has_edges) {
        arrays.prefetch_edge(arrays.edge_of(h));
        arrays.prefetch_edge(arrays.edge_of(Halfedge_arrays_2::previous(h)));
      }
      corners[i] = arrays.next_corner(h);
      arrays.prefetch_face(corners[i]);
    }
}

// The polygon of the neighbors of a vertex, its *center*. When the center is taken out, the faces
// of a triangulation of the polygon replace those around the center. The triangulation is a
// sequence of *ears*, triangles of three consecutive corners that are cut off one after the other.
// When the center is put in, faces around it replace those inside of the polygon.
//
//     d ----- c                d ----- c
//     | \   / |   take v out   | \     |
//     |   v   |  --------->    |   \   |     ears: (a, b, d), (b, c, d)
//     | /   \ |  <---------    |     \ |
//     a ----- b   put v in     a ----- b
//
// Corners are vertices as seen from the center: on a torus, images of vertices. On a torus of few
// vertices a polygon can meet itself; then it cannot be used.
template <class State>
class Star_polygon_2
{
  using Arrays = Halfedge_arrays_2;
  using Site = typename State::Site;
  using Chart = typename State::Chart;
  using Predicates = typename State::Predicates;

public:
  // Side i goes from the i-th corner of the polygon to the next, counterclockwise.
  struct Side
  {
    Site corner;
    Halfedge_index outer; // the half-edge on the other side
    Edge_index edge;
  };

  // The numbers of three corners. Cutting the ear off removes `tip` from the polygon.
  struct Ear
  {
    Index before, tip, after;
  };

  Vertex_index center() const { return m_center; }
  const Kept_list<Side>& sides() const { return m_sides; }
  const Kept_list<Ear>& ears() const { return m_ears; }
  bool is_triangulated() const { return m_ears.size() + 2 == m_sides.size(); }

  // Whether there are as many faces() and edges() as sides, which putting the center in needs.
  bool has_star() const { return m_faces.size() == m_sides.size(); }
  // The faces inside of the polygon, and the edges between them.
  const Kept_list<Face_index>& faces() const { return m_faces; }
  const Kept_list<Edge_index>& edges() const { return m_edges; }

  // THE POLYGON -----------------------------------------------------------------------------------

  // Reads the polygon around v, which must be in faces. Returns false if it meets itself.
  bool read(const State& state, Vertex_index v)
  {
    const Arrays& arrays = state.arrays();
    clear(v);
    arrays.for_each_corner(v, [&](Halfedge_index h) {
      const Site corner = state.site_in(Arrays::next(h), state.chart_at(h));
      m_sides.push_back({corner, arrays.twin(h), arrays.edge_of(h)});
      m_faces.push_back(Arrays::face_of(h));
      m_edges.push_back(arrays.edge_of(Arrays::previous(h)));
    });
    return !meets_itself();
  }

  // Finds the polygon to put v in so that everything stays Delaunay, as it must be before. v is in
  // no face; its point is strictly inside of the finite face f, whose chart as seen from v is
  // `chart`. Returns false if the polygon would have more than `most` faces, meets itself, or has a
  // corner that is not free: `is_free(w)` is asked before anything around w is read, but for faces.
  //
  // It consists of the faces that flips would remove, if v divided f in three (C. Lawson 1977;
  // Guibas and Stolfi 1985): only edges opposite to v can be illegal, and such an edge is illegal
  // if v is inside of the circle of the face beyond. An edge from v to w comes into being when a
  // face with corner w that was Delaunay before is divided or flipped away. Then v is strictly
  // inside of the circle of that face: inside of the face, or beyond an illegal edge. The circle
  // through v that touches that circle in w from inside contains no other vertex, so the edge is
  // Delaunay in every triangulation with v. All other faces stay Delaunay. Faces are
  // counterclockwise all the time, and those around v surround it once, so no two edges go from v
  // in the same direction: all corners are different.
  //
  // On a torus all images of v are put in. If the polygon does not meet itself, the polygons of
  // different images have no face and no side in common. So the face beyond each side stays, v is
  // not inside of its circle, and all edges are locally Delaunay.
  template <class Is_free = All_vertices_2>
  bool find_as_delaunay(const State& state, Face_index f, const Chart& chart, Vertex_index v,
                        std::size_t most, const Is_free& is_free = Is_free())
  {
    const Arrays& arrays = state.arrays();
    const Predicates predicates(state);
    const Site center = state.site_of(v);
    const auto is_in_circle = [&](Halfedge_index outer, const Chart& beyond) {
      return arrays.apex(outer) != infinite_index &&
             predicates.side_of_circle(
                 state.site_in(outer, beyond), state.site_in(Arrays::next(outer), beyond),
                 state.site_in(Arrays::previous(outer), beyond), center) == ON_POSITIVE_SIDE;
    };
    clear(v);
    for (const Vertex_index w : arrays.face(f))
      if (!is_free(w))
        return false;
    m_faces.push_back(f);
    m_open.clear();
    for (const Halfedge_index h :
         {Arrays::halfedge_in(f, 2), Arrays::halfedge_in(f, 1), Arrays::halfedge_in(f, 0)})
      open(arrays, h, chart);
    // a point beside a slab reaches all along its side, and past its own images without an end
    std::size_t next_look = 64;
    while (!m_open.empty() && m_faces.size() <= most) {
      if (m_faces.size() >= next_look) {
        if (meets_itself())
          return false;
        next_look *= 2;
      }
      const Open side = m_open.back();
      const Halfedge_index outer = arrays.twin(side.halfedge);
      const Chart beyond = state.chart_beyond(side.halfedge, side.chart);
      m_open.pop_back();
      if (is_in_circle(outer, beyond)) {
        if (!is_free(arrays.apex(outer)))
          return false;
        m_faces.push_back(Arrays::face_of(outer));
        m_edges.push_back(arrays.edge_of(outer));
        open(arrays, Arrays::previous(outer), beyond);
        open(arrays, Arrays::next(outer), beyond);
      } else
        m_sides.push_back(
            {state.site_in(Arrays::next(side.halfedge), side.chart), outer, arrays.edge_of(outer)});
    }
    return m_faces.size() <= most && !meets_itself();
  }

  // Adds the faces and edges of the center's slot.
  void add(const Arrays::Slot& slot)
  {
    for (const Face_index f : slot.faces)
      m_faces.push_back(f);
    for (const Edge_index e : slot.edges)
      m_edges.push_back(e);
  }

  // TRIANGULATIONS --------------------------------------------------------------------------------

  // Triangulates the polygon so that everything stays Delaunay, as it must be before, except that
  // the center may have moved since. Returns false, without ears, if the predicates are known to be
  // inexact, or if the center is at the hull or has many neighbors.
  //
  // The apex of the face at each side is sought on the left of the side: the circle through the
  // side and the apex contains no other corner there. Let S be the points without the center v.
  //   - All faces but those of v stay Delaunay, as their circles have no point of S inside. So S
  //     has a Delaunay triangulation that differs from the old one in the polygon P alone.
  //   - The face of this triangulation at a side, or at an edge that divides P, has its apex among
  //     the corners of that part of P. Its circle C contains no point of S, so only another corner
  //     on C can win the search instead.
  //   - Such a corner w will do, too, if it sees the side inside of P: then the corners on C that
  //     belong to this part of P form a convex polygon in it, and any triangulation of that is
  //     Delaunay. Otherwise a side (p, q) of P with both ends on C separates w from the side of the
  //     search, and from v, which is on the left of each side. v is not outside of C: otherwise the
  //     face of C would be Delaunay beside v, too, but the faces of v cover P, and Delaunay faces
  //     that overlap have the same circle. If v is inside of C, w is inside of the circle through
  //     v, p and q, which was empty. If v is on C, the edges from v to w and from p to q cross.
  //     Neither can be.
  //   - A corner in a circle of the search is on the left of the side, because on the right of the
  //     side such a circle is inside of C.
  // So the search finds Delaunay faces that tile P.
  bool triangulate_as_delaunay(const State& state)
  {
    if constexpr (State::predicates_are_exact) {
      if (m_sides.size() > State::max_degree_to_divide || is_at_infinity())
        return false;
      divide(Predicates(state), 0, Index(m_sides.size() - 1));
      return true;
    }
    return false;
  }

  // Triangulates the polygon in any way that doubles no edge. The corners must be different
  // vertices. The new faces are counterclockwise where the faces around the center, which is at
  // `place`, allow it. They are Delaunay only by chance.
  //
  // There is always an ear whose third edge does not exist yet: if the third edge of an ear exists
  // elsewhere, it separates the third edges of other ears.
  void triangulate_anyhow(const State& state, const Position_2& place)
  {
    link_corners();
    for (const Kind kind : {Kind::CONVEX, Kind::AT_INFINITY, Kind::ANY})
      cut_ears(state, place, kind);
    cut(m_last);
    CGAL_postcondition(is_triangulated());
  }

  // Whether the corners and the center are images of different vertices.
  bool has_different_vertices()
  {
    if constexpr (sites_are_vertices)
      return true;
    m_numbers.clear();
    m_numbers.push_back(m_center);
    for (const Side& side : m_sides)
      m_numbers.push_back(State::vertex_of(side.corner));
    std::sort(m_numbers.begin(), m_numbers.end());
    return std::adjacent_find(m_numbers.begin(), m_numbers.end()) == m_numbers.end();
  }

private:
  // Whether a vertex has no other images, so that no polygon meets itself.
  static constexpr bool sites_are_vertices = std::is_convertible_v<Site, Vertex_index>;

  // A half-edge of a face inside of the polygon; the face beyond is to be examined.
  struct Open
  {
    Halfedge_index halfedge;
    Chart chart;
  };

  // Has the face beyond h examined later, when its data have come.
  void open(const Arrays& arrays, Halfedge_index h, const Chart& chart)
  {
    arrays.prefetch_face(arrays.twin(h));
    m_open.push_back({h, chart});
  }

  // Whether a face inside of the polygon is there twice, or is also beyond a side: then it is
  // inside of the polygon of another image of the center, too.
  bool meets_itself()
  {
    if constexpr (sites_are_vertices)
      return false;
    m_numbers.assign(m_faces.begin(), m_faces.end());
    std::sort(m_numbers.begin(), m_numbers.end());
    return std::adjacent_find(m_numbers.begin(), m_numbers.end()) != m_numbers.end() ||
           std::any_of(m_sides.begin(), m_sides.end(), [this](const Side& side) {
             return std::binary_search(m_numbers.begin(), m_numbers.end(),
                                       Arrays::face_of(side.outer));
           });
  }

  void clear(Vertex_index center)
  {
    m_center = center;
    m_sides.clear();
    m_faces.clear();
    m_edges.clear();
    m_ears.clear();
  }

  // DELAUNAY FACES --------------------------------------------------------------------------------

  static bool is_infinite(const Site& corner) { return State::vertex_of(corner) == infinite_index; }

  bool is_at_infinity() const
  {
    return std::any_of(m_sides.begin(), m_sides.end(),
                       [](const Side& side) { return is_infinite(side.corner); });
  }

  // Triangulates the part of the polygon from corner `first` to corner `last`, which is on the left
  // of the edge from `last` to `first`.
  void divide(const Predicates& predicates, Index first, Index last)
  {
    if (last - first < 2)
      return;
    const Index apex = find_apex(predicates, first, last);
    divide(predicates, first, apex);
    divide(predicates, apex, last);
    m_ears.push_back({first, apex, last});
  }

  Index find_apex(const Predicates& predicates, Index first, Index last) const
  {
    if (last - first == 2) // a triangle
      return first + 1;
    const Site &source = m_sides[last].corner, &target = m_sides[first].corner;
    const auto is_on_left = [&](const Site& corner) {
      return predicates.orientation(source, target, corner) == LEFT_TURN;
    };
    Index apex = first + 1;
    while (apex + 1 < last && !is_on_left(m_sides[apex].corner))
      ++apex;
    for (Index i = apex + 1; i < last; ++i) {
      if (predicates.side_of_circle(m_sides[apex].corner, source, target, m_sides[i].corner) ==
          ON_POSITIVE_SIDE)
        apex = i;
    }
    return apex;
  }

  // ANY FACES -------------------------------------------------------------------------------------

  enum class Kind { CONVEX, AT_INFINITY, ANY };

  struct Links
  {
    Index before, after;
  };

  void link_corners()
  {
    const Index size = Index(m_sides.size());
    m_links.resize(size);
    for (Index i = 0; i < size; ++i)
      m_links[i] = {i == 0 ? size - 1 : i - 1, i + 1 == size ? 0 : i + 1};
    m_last = 0;
  }

  // The number of corners that are left.
  std::size_t size() const { return m_sides.size() - m_ears.size(); }

  // Cuts off the ear after corner i.
  void cut(Index i)
  {
    const Index tip = m_links[i].after, after = m_links[tip].after;
    m_ears.push_back({i, tip, after});
    m_links[i].after = after;
    m_links[after].before = i;
    m_last = i;
  }

  // Cuts off every other ear of this kind in each round, until there is none or a triangle is left.
  // If ears were cut side by side, their third edges would all end at one vertex. At infinity they
  // do so anyway, so no ear is left out. Gives up after a few rounds, unless `kind` is ANY: a round
  // may find only the ear that the last one has made, as at a vertex beside a line of a thousand.
  void cut_ears(const State& state, const Position_2& place, Kind kind)
  {
    constexpr std::size_t max_rounds = 4;
    std::size_t looks = kind == Kind::ANY ? std::size_t(-1) : max_rounds * size();
    Index i = m_last;
    for (std::size_t left = size(); left > 0 && looks > 0 && size() > 3; --left, --looks) {
      if (is_ear(state, place, i, kind)) {
        cut(i);
        left = size() + 1;
        if (kind == Kind::AT_INFINITY)
          continue;
      }
      i = m_links[i].after;
    }
  }

  // Whether the ear after corner i is of this kind, and its third edge does not exist. Plain
  // floating point may decide the kind, because ears of any kind are valid.
  bool is_ear(const State& state, const Position_2& place, Index i, Kind kind) const
  {
    const Index k = m_links[i].after;
    const Site &before = m_sides[i].corner, &tip = m_sides[k].corner;
    const Site& after = m_sides[m_links[k].after].corner;
    const bool ends_at_infinity = is_infinite(before) || is_infinite(after);
    if (kind == Kind::AT_INFINITY && (is_infinite(tip) || !ends_at_infinity))
      return false;
    if (kind == Kind::CONVEX) {
      if (is_infinite(tip) || ends_at_infinity)
        return false;
      const Position_2 p = state.rounded_position(before), q = state.rounded_position(tip),
                       r = state.rounded_position(after);
      if (!(cross(q - p, r - p) > 0 && cross(p - place, r - place) >= 0))
        return false;
    }
    return !state.are_neighbors(before, after);
  }

  Vertex_index m_center = null_index;
  Kept_list<Side> m_sides;
  Kept_list<Face_index> m_faces;
  Kept_list<Edge_index> m_edges;
  Kept_list<Open> m_open;
  Kept_list<Ear> m_ears;
  std::vector<Links> m_links;   // of the corners that are left
  Index m_last = 0;             // one of these corners
  std::vector<Index> m_numbers; // of faces or vertices, sorted
};

// Writes the faces inside of a star polygon, for the editors of all spaces. `set_corner(h, corner)`
// makes `corner` the corner at half-edge h.
template <class State>
class Star_writer_2
{
  using Slot = Halfedge_arrays_2::Slot;
  using Polygon = Star_polygon_2<State>;

public:
  explicit Star_writer_2(Writable_halfedge_arrays_2& arrays)
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
      set_corner(h, State::site_of(polygon.center()));
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
    const Face_index last = polygon.faces()[polygon.ears().size() - 1];
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

  Writable_halfedge_arrays_2& m_arrays;
  std::vector<Open_side> m_open_sides;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_STAR_POLYGON_2_H
