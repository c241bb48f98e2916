// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_PERIODIC_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_PERIODIC_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Torus_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

template <class Maintained>
class Periodic_edge_test_2;

// A triangulation of a flat torus: its faces in one sheet, however few its points are. Reading is
// public; `Periodic_editor_2` alone writes.
//
// Each corner of a face, a half-edge with its apex, has a *shift*. The images of the three vertices
// by the shifts of a face are the corners of one triangle in the plane. Faces have frames of their
// own: the first corner of each has no shift. Along an edge, the frames of both faces differ by a
// translation, which follows from their shifts.
//
// An edge may go from a vertex to an image of the same vertex, and several may connect two
// vertices. There is no infinite vertex. Where the four corners of an edge have the same shift, the
// edge stands in the mirror as in the plane, so that the pass over the edges can test it there.
// Elsewhere all its vertices there are infinite: the pass in the plane never proves these.
template <class Point_>
class Maintained_periodic_triangulation_2
{
public:
  using Point = Point_;
  using Space = Plane_2; // of the edges without shifts
  using Edge_test = Periodic_edge_test_2<Maintained_periodic_triangulation_2>;
  using Ids = Point_ids_2<Position_2>;

  explicit Maintained_periodic_triangulation_2(const Periodic_cell_2& cell)
    : m_torus(cell)
  {
    m_ids.reset(0);
  }

  const Torus_2& torus() const { return m_torus; }
  const Neighborhood_mirror_2& mirror() const { return m_mirror; }
  const std::vector<Position_2>& positions() const { return m_positions; }
  const Ids& ids() const { return m_ids; }
  Index number_of_vertices() const { return Index(m_positions.size()) - 1; }

  const Periodic_shift_2& shift(Index corner) const { return m_shifts[corner]; }
  Image_2 image(Index corner) const
  {
    return {m_positions[m_mirror.apex(corner)], m_shifts[corner]};
  }

  // What is added to shifts in the face beyond h for shifts in the face of h.
  Periodic_shift_2 transition(Index h) const
  {
    using Mirror = Neighborhood_mirror_2;
    return m_shifts[Mirror::next(h)] - m_shifts[Mirror::previous(m_mirror.twin(h))];
  }

  // The corners of the faces at half-edge h, in the frame of its face.
  Edge_images_2 corners_at(Index h) const
  {
    using Mirror = Neighborhood_mirror_2;
    Image_2 right = image(m_mirror.twin(h));
    right.shift = right.shift + transition(h);
    return {image(h), image(Mirror::next(h)), image(Mirror::previous(h)), right};
  }

  bool is_shifted(Index e) const { return m_mirror.edge(e).source == infinite_index; }

  Position_2 position_of_id(Index id) const
  {
    return m_ids.is_representative(id) ? m_positions[m_ids.vertex(id)] : m_ids.duplicate(id).point;
  }

private:
  template <class Maintained>
  friend class Periodic_editor_2;

  Torus_2 m_torus;
  Neighborhood_mirror_2 m_mirror;
  std::vector<Periodic_shift_2> m_shifts; // indexed by half-edges
  std::vector<Position_2> m_positions = {nowhere()};
  Ids m_ids;
};

// The one test of an edge, as `Edge_test_2` is in the plane.
template <class Maintained>
class Periodic_edge_test_2
{
public:
  explicit Periodic_edge_test_2(const Maintained& maintained)
    : m_maintained(maintained)
  {
  }

  Edge_state_2 state(Index e) const
  {
    const auto& mirror = m_maintained.mirror();
    if (!m_maintained.is_shifted(e)) {
      using Space = typename Maintained::Space;
      const Edge_filter_2 filter(Space::corners(mirror.edge(e), m_maintained.positions()));
      if (filter.proves_delaunay())
        return Edge_state_2::DELAUNAY;
      if (filter.proves_illegal())
        return Edge_state_2::ILLEGAL;
    }
    return m_maintained.torus().edge_state(m_maintained.corners_at(mirror.halfedge(e)));
  }

  // Appends the edges that the filters do not prove Delaunay. Edges of empty slots are
  // left out.
  void append_unproved(std::vector<Index>& unproved) const
  {
    const std::size_t first = unproved.size();
    const auto& mirror = m_maintained.mirror();
    internal::append_unproved<typename Maintained::Space>(
        mirror.edges().data(), m_maintained.positions(), 0, mirror.number_of_edges(), unproved);
    const auto is_proved = [&](Index e) {
      return mirror.is_empty_edge(e) ||
             (m_maintained.is_shifted(e) && m_maintained.torus().filter_proves_delaunay(
                                                m_maintained.corners_at(mirror.halfedge(e))));
    };
    unproved.erase(
        std::remove_if(unproved.begin() + std::ptrdiff_t(first), unproved.end(), is_proved),
        unproved.end());
  }

private:
  const Maintained& m_maintained;
};

// The only writer of a periodic triangulation. Every function leaves a triangulation of the torus
// whose shifts close up around each face and agree along each edge.
template <class Maintained>
class Periodic_editor_2
{
  using Mirror = Neighborhood_mirror_2;
  using Slot = Mirror::Slot;
  using Ids = typename Maintained::Ids;

public:
  explicit Periodic_editor_2(Maintained& maintained)
    : m_maintained(maintained)
  {
  }

  // POINTS --------------------------------------------------------------------------------------

  Ids& ids() { return m_maintained.m_ids; }
  void set_position(Index v, const Position_2& p) { m_maintained.m_positions[v] = p; }

  // The same for all vertices; the vector gets the positions before.
  void exchange_positions(std::vector<Position_2>& positions)
  {
    m_maintained.m_positions.swap(positions);
  }

  // To be called where the position of v was replaced by one that is about `shift` away: every
  // image of v stays where it is, about.
  void shift_images(Index v, const Periodic_shift_2& shift)
  {
    if (are_equal(shift, no_shift))
      return;
    mirror().for_each_corner(v, [&](Index h) { m_corners.push_back(h); });
    for (const Index h : m_corners)
      shifts()[h] = shifts()[h] - shift;
    for (const Index h : m_corners)
      write_face(h / 3);
    m_corners.clear();
  }

  // The lattice gets another cell. `multiples` are the vectors of the old cell in those of the new
  // one, integers with determinant 1 or -1; the rest is deformation.
  void set_cell(const Periodic_cell_2& cell, const std::array<Periodic_shift_2, 2>& multiples)
  {
    m_maintained.m_torus = Torus_2(cell);
    for (Periodic_shift_2& s : shifts())
      s = {s[0] * multiples[0][0] + s[1] * multiples[1][0],
           s[0] * multiples[0][1] + s[1] * multiples[1][1]};
  }

  // FLIPS ---------------------------------------------------------------------------------------

  // A flip needs two faces, and must give no edge that is there already, or has no length. Walks
  // around both ends of the new edge in step, because one of them may have many neighbors.
  bool can_flip(Index h) const
  {
    const Index g = mirror().twin(h);
    const Index a = mirror().apex(h), d = mirror().apex(g);
    const Periodic_shift_2 way = shifts()[g] + m_maintained.transition(h) - shifts()[h];
    if (h / 3 == g / 3 || (a == d && are_equal(way, no_shift)))
      return false;
    Index i = h, k = g;
    do {
      if (leads(i, d, way) || leads(k, a, no_shift - way))
        return false;
      i = mirror().next_corner(i);
      k = mirror().next_corner(k);
    } while (i != h && k != g);
    return true;
  }

  void flip(Index h)
  {
    const Index g = mirror().twin(h);
    const Edge_images_2 images = m_maintained.corners_at(h);
    mirror().flip_glued(h);
    shifts()[Mirror::previous(h)] = images.right.shift;
    shifts()[g] = images.right.shift;
    shifts()[Mirror::next(g)] = images.target.shift;
    shifts()[Mirror::previous(g)] = images.left.shift;
    write_face(h / 3);
    write_face(g / 3);
  }

  // As `Topology_editor_2` has it: calls f(flip).
  template <class Function>
  void flip_in_series(const Function& f)
  {
    f([this](Index h) { flip(h); });
  }

  // VERTICES ------------------------------------------------------------------------------------

  // Exchanges everything with another one.
  void swap(Maintained& other) { std::swap(m_maintained, other); }

  // Makes the only vertex, at p, with two faces over the basis r, t of the lattice, which is
  // counterclockwise.
  void start(const Position_2& p, const Periodic_shift_2& r, const Periodic_shift_2& t)
  {
    mirror().resize(1, 2);
    ids().append_vertex();
    m_maintained.m_positions.push_back(p);
    for (Index h = 0; h < 6; ++h)
      mirror().set_apex(h, 1);
    // the faces (0, r, r + t) and (0, r + t, t) of a parallelogram
    shifts() = {no_shift, r, r + t, no_shift, r + t, t};
    mirror().link(0, 4);
    mirror().link(1, 5);
    mirror().link(2, 3);
    mirror().number_edges();
    write_face(0);
    write_face(1);
  }

  // Makes a vertex outside of all faces. Its point has no id yet.
  Slot make_slot()
  {
    mirror().provide_for_slot();
    ids().provide_for_vertex();
    provide(shifts(), 6);
    provide(m_maintained.m_positions, 1);
    ids().append_vertex();
    shifts().resize(shifts().size() + 6);
    m_maintained.m_positions.push_back(nowhere());
    return mirror().append_slot();
  }

  // Puts the slot's vertex into face f, at the image of p by `shift` in the frame of f.
  void put_in(const Slot& slot, const Position_2& p, const Periodic_shift_2& shift, Index f)
  {
    const Index g = slot.faces[0], k = slot.faces[1];
    const Periodic_shift_2 a = shifts()[3 * f], b = shifts()[3 * f + 1], c = shifts()[3 * f + 2];
    mirror().put_in(slot, f);
    set_position(slot.vertex, p);
    set_shifts(f, shift, b, c);
    set_shifts(g, a, shift, c);
    set_shifts(k, a, b, shift);
    for (const Index face : {f, g, k})
      write_face(face);
  }

  // Takes a vertex of degree 3 out of its faces.
  Slot take_out(Index v)
  {
    const Index h = mirror().corner(v), g = mirror().next_corner(h);
    const Periodic_shift_2 a = shifts()[Mirror::next(h)], b = shifts()[Mirror::previous(h)];
    const Periodic_shift_2 c = shifts()[Mirror::previous(g)] + shifts()[h] - shifts()[g];
    const Slot slot = mirror().take_out(v);
    shifts()[h] = c;
    shifts()[Mirror::next(h)] = a;
    shifts()[Mirror::previous(h)] = b;
    write_face(h / 3);
    return slot;
  }

  // Deletes the vertices of all slots, which have no points. The last vertices, edges and faces
  // take their numbers.
  void drop(const std::vector<Slot>& empty_slots)
  {
    std::vector<Index> vertices, faces, edges;
    for (const Slot& slot : empty_slots) {
      vertices.push_back(slot.vertex);
      faces.insert(faces.end(), slot.faces.begin(), slot.faces.end());
      edges.insert(edges.end(), slot.edges.begin(), slot.edges.end());
    }
    for (auto* numbers : {&vertices, &faces, &edges}) // from the last on, which thus is not empty
      std::sort(numbers->rbegin(), numbers->rend());
    for (const Index f : faces) {
      const Index last = 3 * (mirror().number_of_faces() - 1);
      set_shifts(f, shifts()[last], shifts()[last + 1], shifts()[last + 2]);
      mirror().move_last_face_to(f);
      shifts().resize(last);
    }
    for (const Index e : edges)
      mirror().move_last_edge_to(e);
    for (const Index v : vertices) {
      mirror().move_last_vertex_to(v);
      ids().move_last_vertex_to(v);
      set_position(v, m_maintained.m_positions.back());
      m_maintained.m_positions.pop_back();
    }
  }

private:
  Neighborhood_mirror_2& mirror() { return m_maintained.m_mirror; }
  const Neighborhood_mirror_2& mirror() const { return m_maintained.m_mirror; }
  std::vector<Periodic_shift_2>& shifts() { return m_maintained.m_shifts; }
  const std::vector<Periodic_shift_2>& shifts() const { return m_maintained.m_shifts; }

  // Whether the next edge at this corner goes to the image of v by `way`.
  bool leads(Index corner, Index v, const Periodic_shift_2& way) const
  {
    const Index end = Mirror::next(corner);
    return mirror().apex(end) == v && are_equal(shifts()[end] - shifts()[corner], way);
  }

  void set_shifts(Index f, Periodic_shift_2 a, Periodic_shift_2 b, Periodic_shift_2 c)
  {
    shifts()[3 * f] = a;
    shifts()[3 * f + 1] = b;
    shifts()[3 * f + 2] = c;
  }

  // Moves the frame of face f to its first corner, and writes its edges.
  void write_face(Index f)
  {
    const Periodic_shift_2 first = shifts()[3 * f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      shifts()[h] = shifts()[h] - first;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const auto [a, b, c, d] = m_maintained.corners_at(h);
      const Index e = mirror().edge_of(h);
      if (are_equal(a.shift, b.shift) && are_equal(b.shift, c.shift) && are_equal(c.shift, d.shift))
        mirror().set_edge(e, mirror().halfedge(e));
      else
        mirror().hide_edge(e);
    }
  }

  Maintained& m_maintained;
  std::vector<Index> m_corners;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_PERIODIC_TRIANGULATION_2_H
