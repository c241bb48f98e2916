// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Patch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Provided_memory_2.h>
#include <CGAL/Triangulation_utils_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Writes topology piece by piece; `Topology_builder_2` does so for the whole, and nobody else does.
// Each operation changes the CGAL triangulation and the mirror together, keeps every vertex handle,
// and notes which edges are new.
template <class Maintained>
class Topology_editor_2
{
  using Point = typename Maintained::Point;
  using Vertex_handle = typename Maintained::Vertex_handle;
  using Face_handle = typename Maintained::Face_handle;
  using Edge = typename Maintained::Triangulation::Edge;

public:
  using Slot = Neighborhood_mirror_2::Slot;

  explicit Topology_editor_2(Maintained& maintained)
    : m_maintained(maintained)
  {
  }

  // A flip that doubles an edge would leave the simplicial complexes, where an edge is named by its
  // vertices; it is refused. Among these are all flips at vertices of degree 3. Two
  // counterclockwise faces at the edge do not rule it out: others may overlap them.
  bool can_flip(Index h) const { return !m_maintained.mirror.are_apexes_neighbors(h); }

  // Flips, one after the other, in the mirror at once; when the series ends, CGAL's structure takes
  // the same flips in the same order. What it touches is all over the memory: in a loop of its own
  // it can be fetched ahead.
  class Flip_series
  {
  public:
    explicit Flip_series(Topology_editor_2& editor)
      : m_editor(editor)
    {
    }
    Flip_series(const Flip_series&) = delete;
    Flip_series& operator=(const Flip_series&) = delete;
    ~Flip_series() { m_editor.write_flips(); }

    void flip(Index h)
    {
      Maintained& maintained = m_editor.m_maintained;
      maintained.new_edges.push_back(maintained.mirror.edge_of(h));
      m_editor.m_flipped.push_back(h); // nothing throws from here on
      maintained.mirror.flip(h);
    }

  private:
    Topology_editor_2& m_editor;
  };

  // Puts the faces of `patch` in place of `old_faces`, as many, with the same boundary: the
  // half-edge outside the i-th edge of the patch's boundary is `outside[i]`.
  void replace(const Index_set_2& old_faces, const Patch_2& patch,
               const std::vector<Index>& outside)
  {
    CGAL_precondition(old_faces.size() == patch.number_of_faces());
    CGAL_precondition(outside.size() == patch.boundary.size());
    collect_inner_edges(old_faces);
    auto& new_edges = m_maintained.new_edges;
    new_edges.insert(new_edges.end(), m_inner_edges.begin(), m_inner_edges.end());
    for (const Index f : old_faces) // nothing throws from here on
      m_maintained.visitor_calls.before_face_removal(m_maintained.faces[f]);
    write_faces(old_faces, patch);
    auto& mirror = m_maintained.mirror;
    const auto global = [&](Index h) { return 3 * old_faces[h / 3] + h % 3; };
    for (Index h = 0; h < Index(patch.twins.size()); ++h)
      if (patch.twins[h] != no_index && h < patch.twins[h])
        link(global(h), global(patch.twins[h]));
    for (std::size_t i = 0; i < outside.size(); ++i)
      link(global(patch.boundary[i].halfedge), outside[i]);
    auto edge = m_inner_edges.begin();
    for (Index h = 0; h < Index(patch.twins.size()); ++h)
      if (patch.twins[h] != no_index && h < patch.twins[h])
        mirror.set_edge(*edge++, global(h));
    for (const Index h : outside)
      mirror.set_edge(mirror.edge_of(h), h);
    for (const Index f : old_faces)
      m_maintained.visitor_calls.after_face_creation(m_maintained.faces[f]);
  }

  // OUT OF FACES AND INTO FACES. To take a vertex out, edges are flipped until it has three, and
  // its faces become one; to put one in, a face is split. All of that is right for any positions.
  // What it changes is Delaunay only by chance.

  // Takes v out of all faces. `place` is where the faces around v have it: that tells which flips
  // are good ones. `vacate()`, which must not throw, is called before v goes, when the visitor has
  // been told of its last faces. If this throws, the vertex is still there.
  template <class Vacate>
  Slot take_out(Index v, const Position_2& place, const Vacate& vacate)
  {
    CGAL_precondition(!m_maintained.mirror.is_outside(v));
    flip_down(v, place);
    provide(m_maintained.new_edges, 3);
    auto& mirror = m_maintained.mirror;
    mirror.for_each_corner(v, [&](Index h) { // nothing throws from here on
      m_maintained.new_edges.push_back(mirror.edge_of(h));
      m_maintained.visitor_calls.before_face_removal(m_maintained.faces[h / 3]);
    });
    vacate();
    const Index face = mirror.corner(v) / 3;
    const Slot slot = mirror.take_out(v);
    write_face(face);
    m_maintained.visitor_calls.after_face_creation(m_maintained.faces[face]);
    return slot;
  }

  // Puts the slot's vertex into a face. Nothing throws if everything is new, or if there is memory
  // for six new edges.
  void put_in(const Slot& slot, Index f)
  {
    auto& mirror = m_maintained.mirror;
    auto& new_edges = m_maintained.new_edges;
    if (!m_maintained.everything_is_new)
      provide(new_edges, 6);
    auto& visitor_calls = m_maintained.visitor_calls;
    visitor_calls.before_face_removal(m_maintained.faces[f]);
    mirror.put_in(slot, f);
    const std::array<Index, 3> faces{f, slot.faces[0], slot.faces[1]};
    for (const Index g : faces)
      write_face(g);
    if (!m_maintained.everything_is_new) {
      new_edges.insert(new_edges.end(), slot.edges.begin(), slot.edges.end());
      mirror.for_each_corner(slot.vertex, [&](Index h) { new_edges.push_back(mirror.edge_of(h)); });
    }
    for (const Index g : faces)
      visitor_calls.after_face_creation(m_maintained.faces[g]);
  }

  // A slot with the next numbers and a vertex at p that nobody is at. If it throws, nothing has
  // changed.
  Slot make_slot(const Point& p)
  {
    auto& mirror = m_maintained.mirror;
    auto& tds = m_maintained.triangulation.tds();
    mirror.provide_for_slot();
    m_maintained.ids.provide_for_vertex();
    provide(m_maintained.faces, 2);
    m_maintained.append_vertex(p);
    std::array<Face_handle, 2> faces;
    try {
      faces[0] = tds.create_face();
      try {
        faces[1] = tds.create_face();
      } catch (...) {
        tds.delete_face(faces[0]);
        throw;
      }
    } catch (...) {
      m_maintained.drop_last_vertex();
      throw;
    }
    const Slot slot = mirror.append_slot();
    m_maintained.ids.append_vertex();
    m_maintained.renumberings.vertices.note_appended(slot.vertex);
    m_maintained.renumberings.edges.note_appended(slot.edges[0]);
    m_maintained.renumberings.faces.note_appended(slot.faces[0]);
    m_maintained.faces.push_back(faces[0]);
    m_maintained.faces.push_back(faces[1]);
    return slot;
  }

  // A fresh vertex at p, in place of the slot's, that nobody was at. If it throws, nothing has
  // changed.
  void renew_vertex(const Slot& slot, const Point& p)
  {
    auto& tds = m_maintained.triangulation.tds();
    m_maintained.renumberings.vertices.provide(1);
    const Vertex_handle fresh = tds.create_vertex();
    try {
      m_maintained.place_vertex(slot.vertex, fresh, p);
    } catch (...) {
      tds.delete_vertex(fresh);
      throw;
    }
    m_maintained.renumberings.vertices.note_replacement(slot.vertex);
  }

  // The vertices of these slots, which nobody is at, are no more; the last vertices, edges and
  // faces take the numbers that get free. No other slots may be there. If it throws, nothing has
  // changed.
  void drop(const std::vector<Slot>& empty_slots)
  {
    collect_numbers(empty_slots);
    const std::size_t kept_edges = m_maintained.mirror.number_of_edges() - m_empty_edges.size();
    std::vector<Index> number_of_edge(m_empty_edges.size(), no_index); // from `kept_edges` on
    m_maintained.renumberings.provide_for_removals(empty_slots.size());
    const auto note = [&](Index from, Index to) { number_of_edge[from - kept_edges] = to; };
    drop_collected(note); // nothing throws from here on
    auto& new_edges = m_maintained.new_edges;
    if (m_maintained.everything_is_new) // and nobody knows what some of these were called
      return new_edges.clear();
    for (Index& e : new_edges)
      while (e != no_index && e >= kept_edges)
        e = number_of_edge[e - kept_edges];
    new_edges.erase(std::remove(new_edges.begin(), new_edges.end(), no_index), new_edges.end());
  }

  // The same where memory has run out: nothing throws, and everything is new.
  void drop_in_need(const std::vector<Slot>& empty_slots)
  {
    m_maintained.everything_is_new = true;
    collect_numbers(empty_slots);
    drop_collected([](Index, Index) {});
  }

  // Memory for drop_in_need() with so many slots.
  void provide_for_drop(std::size_t number)
  {
    m_empty_vertices.reserve(number);
    m_empty_faces.reserve(2 * number);
    m_empty_edges.reserve(3 * number);
  }

private:
  // OUT OF FACES AND INTO FACES -------------------------------------------------------------------

  // Flips edges at v until it has three. There always is one to flip: if one of the triangles of
  // neighbors that follow each other has its third edge elsewhere already, that parts the others
  // from each other. Where the faces around v tell it, the new ones are counterclockwise.
  void flip_down(Index v, const Position_2& place)
  {
    Index degree = m_maintained.mirror.degree(v);
    provide(m_flipped, degree);
    provide(m_maintained.new_edges, degree);
    Flip_series series(*this);
    for (const Ear ear : {Ear::CONVEX, Ear::AT_INFINITY, Ear::ANY})
      degree -= cut_ears(v, place, degree, ear, series);
    CGAL_postcondition(degree == 3);
  }

  enum class Ear { CONVEX, AT_INFINITY, ANY };

  // Cuts off every other ear of this kind in each round, until there is none or v has three edges:
  // one after the other, their edges would all end at one vertex. Those at infinity all do so in
  // any case, and stand side by side. Where each round finds one ear that the one before has made,
  // as at a vertex beside a line of a thousand, it gives up, for any ears are right in the end.
  // Returns how many.
  Index cut_ears(Index v, const Position_2& place, Index degree, Ear kind, Flip_series& series)
  {
    const auto& mirror = m_maintained.mirror;
    constexpr Index max_rounds = 4;
    Index cut = 0, looks = kind == Ear::ANY ? no_index : max_rounds * degree;
    Index corner = mirror.corner(v);
    for (Index left = degree; left > 0 && looks > 0 && degree - cut > 3; --left, --looks) {
      const Index h = Neighborhood_mirror_2::next(corner); // from the tip of the ear to v
      if (is_ear(h, place, kind) && can_flip(h)) {
        series.flip(h);
        ++cut;
        left = degree - cut + 1;
        corner = mirror.corner(v);
        if (kind == Ear::AT_INFINITY)
          continue;
      }
      corner = mirror.next_corner(corner);
    }
    return cut;
  }

  // Whether h goes from the tip of an ear of this kind to the vertex. Any answer is right, so plain
  // floating point is good enough.
  bool is_ear(Index h, const Position_2& place, Ear kind) const
  {
    const auto& mirror = m_maintained.mirror;
    const Index before = mirror.apex(h), tip = mirror.source(h);
    const Index after = mirror.apex(mirror.twin(h));
    const bool ends_at_infinity = before == infinite_index || after == infinite_index;
    switch (kind) {
    case Ear::CONVEX: {
      if (tip == infinite_index || ends_at_infinity)
        return false;
      const auto& positions = m_maintained.positions;
      const Position_2 &p = positions[before], &q = positions[tip], &r = positions[after];
      return cross(q - p, r - p) > 0 && cross(p - place, r - place) >= 0;
    }
    case Ear::AT_INFINITY:
      return tip != infinite_index && ends_at_infinity;
    default:
      return true;
    }
  }

  // In descending order: the last one is then never empty, unless it is the one that goes.
  void collect_numbers(const std::vector<Slot>& empty_slots)
  {
    m_empty_vertices.clear();
    m_empty_faces.clear();
    m_empty_edges.clear();
    for (const Slot& slot : empty_slots) {
      m_empty_vertices.push_back(slot.vertex);
      m_empty_faces.insert(m_empty_faces.end(), slot.faces.begin(), slot.faces.end());
      m_empty_edges.insert(m_empty_edges.end(), slot.edges.begin(), slot.edges.end());
    }
    for (std::vector<Index>* numbers : {&m_empty_vertices, &m_empty_faces, &m_empty_edges})
      std::sort(numbers->begin(), numbers->end(), std::greater<Index>());
  }

  // `note(from, to)` is told that edge `from` takes the number `to`.
  template <class Note>
  void drop_collected(const Note& note)
  {
    auto& mirror = m_maintained.mirror;
    auto& renumberings = m_maintained.renumberings;
    const bool are_noted = !m_maintained.everything_is_new;
    for (const Index f : m_empty_faces) {
      if (are_noted)
        renumberings.faces.note_move(mirror.number_of_faces() - 1, f);
      m_maintained.triangulation.tds().delete_face(m_maintained.faces[f]);
      m_maintained.faces[f] = m_maintained.faces.back();
      m_maintained.faces.pop_back();
      mirror.move_last_face_to(f);
    }
    for (const Index e : m_empty_edges) {
      const Index last = mirror.number_of_edges() - 1;
      if (are_noted)
        renumberings.edges.note_move(last, e);
      if (last != e)
        note(last, e);
      mirror.move_last_edge_to(e);
    }
    for (const Index v : m_empty_vertices) {
      if (are_noted)
        renumberings.vertices.note_move(m_maintained.number_of_vertices(), v);
      const Vertex_handle vertex = m_maintained.vertices[v];
      mirror.move_last_vertex_to(v);
      m_maintained.ids.move_last_vertex_to(v);
      m_maintained.move_last_vertex_to(v);
      m_maintained.triangulation.tds().delete_vertex(vertex);
    }
  }

  // Face f and its neighbors, which refer to it by the right number, into CGAL's structure.
  void write_face(Index f)
  {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      write_vertex(h);
      write_neighbors(h);
      m_maintained.vertices[m_maintained.mirror.apex(h)]->set_face(m_maintained.faces[f]);
    }
  }

  // REPLACING -----------------------------------------------------------------------------------

  void collect_inner_edges(const Index_set_2& faces)
  {
    const auto& mirror = m_maintained.mirror;
    m_inner_edges.clear();
    for (const Index f : faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (h < mirror.twin(h) && faces.contains(mirror.twin(h) / 3))
          m_inner_edges.push_back(mirror.edge_of(h));
  }

  void write_faces(const Index_set_2& old_faces, const Patch_2& patch)
  {
    for (Index k = 0; k < patch.number_of_faces(); ++k) {
      const Index f = old_faces[k];
      for (Index i = 0; i < 3; ++i) {
        const Index v = patch.apexes[3 * k + i];
        m_maintained.mirror.set_apex(3 * f + i, v);
        write_vertex(3 * f + i);
        m_maintained.vertices[v]->set_face(m_maintained.faces[f]);
      }
    }
  }

  void link(Index h, Index g)
  {
    m_maintained.mirror.link(h, g);
    write_neighbors(h);
  }

  // CGAL ----------------------------------------------------------------------------------------

  void write_flips()
  {
    auto& tds = m_maintained.triangulation.tds();
    const auto& faces = m_maintained.faces;
    for (std::size_t i = 0; i < m_flipped.size(); ++i) {
      if (i % stretch == 0)
        prefetch_stretch(i);
      const Face_handle f = faces[m_flipped[i] / 3];
      const int place = int(m_flipped[i] % 3);
      m_maintained.visitor_calls.before_flip(Edge(f, place));
      tds.flip(f, place);
      m_maintained.visitor_calls.after_flip(Edge(f, Triangulation_cw_ccw_2::ccw(place)));
    }
    m_flipped.clear();
  }

  // In steps, each of which reads what the one before has fetched. A flip of the stretch may yet
  // change what is read: then something else is fetched, and nothing is wrong.
  void prefetch_stretch(std::size_t first) const
  {
    using Place = Triangulation_cw_ccw_2;
    const auto& faces = m_maintained.faces;
    const auto for_each_flip = [&](const auto& f) {
      const std::size_t beyond = (std::min)(first + stretch, m_flipped.size());
      for (std::size_t i = first; i < beyond; ++i)
        f(m_flipped[i]);
    };
    for_each_flip([&](Index h) { prefetch(&faces[h / 3]); });
    for_each_flip([&](Index h) { prefetch_face(faces[h / 3]); });
    for_each_flip([&](Index h) {
      const Face_handle f = faces[h / 3];
      const int i = int(h % 3);
      prefetch_face(f->neighbor(i));
      prefetch_face(f->neighbor(Place::ccw(i)));
      prefetch(&*f->vertex(Place::cw(i)));
      prefetch(&*f->vertex(Place::ccw(i)));
    });
    for_each_flip([&](Index h) {
      const Face_handle f = faces[h / 3], g = f->neighbor(int(h % 3));
      prefetch_face(g->neighbor(Place::ccw(g->index(f))));
    });
  }

  static void prefetch_face(Face_handle f)
  {
    prefetch(&*f);
    prefetch(reinterpret_cast<const char*>(&*f) + sizeof(*f) - 1);
  }

  void write_vertex(Index h)
  {
    m_maintained.faces[h / 3]->set_vertex(int(h % 3),
                                          m_maintained.vertices[m_maintained.mirror.apex(h)]);
  }

  // Both faces at h.
  void write_neighbors(Index h)
  {
    const Index g = m_maintained.mirror.twin(h);
    m_maintained.faces[h / 3]->set_neighbor(int(h % 3), m_maintained.faces[g / 3]);
    m_maintained.faces[g / 3]->set_neighbor(int(g % 3), m_maintained.faces[h / 3]);
  }

  static constexpr std::size_t stretch = 16; // of flips that are fetched together

  Maintained& m_maintained;
  std::vector<Index> m_inner_edges;
  std::vector<Index> m_flipped; // half-edges, in the order of their flips
  std::vector<Index> m_empty_vertices, m_empty_faces, m_empty_edges; // that are dropped
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
