// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Patch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_location_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Provided_memory_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_predicates_2.h>
#include <CGAL/Triangulation_utils_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <unordered_set>
#include <utility>
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
  explicit Topology_editor_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_predicates(maintained)
    , m_location(maintained)
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

  // COMING AND GOING. For a point that comes, a face is split; for one that goes, edges are flipped
  // until its vertex has three, and its faces become one. All of that is right for any positions.
  // What it changes is Delaunay only by chance.

  // Puts the point `id` at p: into a vertex of its own, or to the one that is there already. `id`
  // is the next id, or that of a guest. Looks for the place from `near` on. Returns the vertex. If
  // it throws, nothing has changed.
  Index insert(Index id, const Point& p, Index near)
  {
    CGAL_precondition(m_maintained.is_mirrored());
    m_maintained.ids.provide_for_point();
    m_maintained.mirror.provide_for_vertex();
    auto& new_edges = m_maintained.new_edges;
    provide(new_edges, 6);
    m_maintained.append_vertex(p);
    const Index v = m_maintained.number_of_vertices();
    Place_2 place;
    std::array<Face_handle, 2> new_faces;
    try {
      place = m_location.locate(v, near);
      if (place.vertex == no_index)
        new_faces = create_two_faces();
    } catch (...) {
      m_maintained.drop_last_vertex();
      throw;
    }
    if (place.vertex != no_index) {
      m_maintained.drop_last_vertex();
      m_maintained.ids.place_guest(id, place.vertex, p);
      return place.vertex;
    }
    m_maintained.ids.place_host(id);
    m_maintained.renumberings.vertices.note_growth(v);
    m_maintained.visitor_calls.after_vertex_creation(m_maintained.vertices[v], id);
    split_face(place.face, v, new_faces);
    return v;
  }

  // Takes out vertices, one after the other.
  class Removal_series
  {
  public:
    // Of at most `number` vertices. All that can throw and spoil is done here.
    Removal_series(Topology_editor_2& editor, std::size_t number)
      : m_editor(editor)
    {
      auto& maintained = editor.m_maintained;
      m_is_new.insert(maintained.new_edges.begin(), maintained.new_edges.end());
      maintained.renumberings.provide_for_removals(number);
    }
    Removal_series(const Removal_series&) = delete;
    Removal_series& operator=(const Removal_series&) = delete;
    // After an exception nobody knows what the new edges are called.
    ~Removal_series()
    {
      if (!m_is_finished)
        m_editor.m_maintained.everything_is_new = true;
    }

    // `vacate()`, which must not throw, is called before v goes, when the visitor has been told of
    // its faces: nobody may be there then. If this throws, the vertex is still there.
    template <class Vacate>
    void remove(Index v, const Vacate& vacate)
    {
      prepare(v);
      m_editor.tell_of_faces_at(v);
      vacate();
      m_editor.delete_faces(m_editor.take_out(v, renaming()));
      m_editor.drop(v);
    }

    // Takes v out, and puts it in again at p. If another vertex w is there already, `join(w)`,
    // which must not throw, is called instead: nobody may be at v then.
    template <class Join>
    void reinsert(Index v, const Point& p, const Join& join)
    {
      prepare(v);
      const Index near = m_editor.finite_neighbor_of(v);
      m_editor.tell_of_faces_at(v);
      const auto faces = m_editor.take_out(v, renaming());
      m_editor.m_maintained.move_vertex(v, p);
      Place_2 place;
      try {
        place = m_editor.m_location.locate(v, near);
      } catch (...) { // a place that is as good as any
        m_editor.split_face(0, v, faces);
        throw;
      }
      if (place.vertex == no_index)
        return m_editor.split_face(place.face, v, faces);
      join(place.vertex);
      m_editor.delete_faces(faces);
      m_editor.drop(v);
    }

    // What the edges that are new are called now.
    void finish()
    {
      auto& new_edges = m_editor.m_maintained.new_edges;
      m_is_new.insert(new_edges.begin(), new_edges.end());
      new_edges.assign(m_is_new.begin(), m_is_new.end());
      std::sort(new_edges.begin(), new_edges.end());
      m_is_finished = true;
    }

  private:
    void prepare(Index v)
    {
      auto& maintained = m_editor.m_maintained;
      CGAL_precondition(maintained.number_of_vertices() > 3);
      provide(maintained.new_edges, 6);
      m_editor.flip_down(v);
      m_is_new.insert(maintained.new_edges.begin(), maintained.new_edges.end());
      for (const Index e : m_editor.edges_around(v))
        m_is_new.insert(e);
      maintained.new_edges.clear();
    }

    auto renaming()
    {
      return [this](Index from, Index to) { rename(from, to); };
    }

    // Edge `to` is no more, and `from`, if it is another one, takes its number.
    void rename(Index from, Index to)
    {
      m_is_new.erase(to);
      auto node = m_is_new.extract(from);
      if (!node.empty()) {
        node.value() = to;
        m_is_new.insert(std::move(node));
      }
    }

    Topology_editor_2& m_editor;
    std::unordered_set<Index> m_is_new;
    bool m_is_finished = false;
  };

private:
  // COMING AND GOING ----------------------------------------------------------------------------

  std::array<Face_handle, 2> create_two_faces()
  {
    auto& tds = m_maintained.triangulation.tds();
    provide(m_maintained.faces, 2);
    const Face_handle first = tds.create_face();
    try {
      return {first, tds.create_face()};
    } catch (...) {
      tds.delete_face(first);
      throw;
    }
  }

  // Vertex v goes into face f.
  void split_face(Index f, Index v, const std::array<Face_handle, 2>& new_faces)
  {
    auto& mirror = m_maintained.mirror;
    auto& visitor_calls = m_maintained.visitor_calls;
    const Index faces = mirror.number_of_faces(), edges = mirror.number_of_edges();
    visitor_calls.before_face_removal(m_maintained.faces[f]);
    m_maintained.renumberings.edges.note_growth(edges);
    m_maintained.renumberings.faces.note_growth(faces);
    mirror.split_face(f, v);
    m_maintained.faces.push_back(new_faces[0]);
    m_maintained.faces.push_back(new_faces[1]);
    for (const Index g : {f, faces, faces + 1})
      write_face(g);
    for (Index e = edges; e < edges + 3; ++e)
      m_maintained.new_edges.push_back(e);
    for (const Index h : {3 * f, 3 * faces + 1, 3 * (faces + 1) + 2})
      m_maintained.new_edges.push_back(mirror.edge_of(h));
    for (const Index g : {f, faces, faces + 1})
      visitor_calls.after_face_creation(m_maintained.faces[g]);
  }

  // Flips edges at v until it has three. There always is one to flip: if one of the triangles of
  // neighbors that follow each other has its third edge elsewhere already, that parts the others
  // from each other. Where the faces around v tell it, the new ones are counterclockwise.
  void flip_down(Index v)
  {
    Index degree = degree_of(v);
    m_flipped.reserve(degree);
    m_maintained.new_edges.reserve(m_maintained.new_edges.size() + degree);
    Flip_series series(*this);
    for (const Ear ear : {Ear::CONVEX, Ear::AT_INFINITY, Ear::ANY})
      degree -= cut_ears(v, degree, ear, series);
    CGAL_postcondition(degree == 3);
  }

  Index degree_of(Index v) const
  {
    Index degree = 0;
    m_maintained.mirror.for_each_corner(v, [&](Index) { ++degree; });
    return degree;
  }

  enum class Ear { CONVEX, AT_INFINITY, ANY };

  // Cuts off every other ear of this kind in each round, until there is none or v has three edges:
  // one after the other, their edges would all end at one vertex. Those at infinity all do so in
  // any case, and stand side by side. Returns how many.
  Index cut_ears(Index v, Index degree, Ear kind, Flip_series& series)
  {
    const auto& mirror = m_maintained.mirror;
    Index cut = 0;
    Index corner = mirror.corner(v);
    for (Index left = degree; left > 0 && degree - cut > 3; --left) {
      const Index h = Neighborhood_mirror_2::next(corner); // from the tip of the ear to v
      if (is_ear(h, kind) && can_flip(h)) {
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

  // Whether h goes from the tip of an ear of this kind to the vertex.
  bool is_ear(Index h, Ear kind) const
  {
    const auto& mirror = m_maintained.mirror;
    const Index before = mirror.apex(h), tip = mirror.source(h), v = mirror.target(h);
    const Index after = mirror.apex(mirror.twin(h));
    const bool ends_at_infinity = before == infinite_index || after == infinite_index;
    switch (kind) {
    case Ear::CONVEX:
      return tip != infinite_index && !ends_at_infinity &&
             m_predicates.orientation(before, tip, after) == LEFT_TURN &&
             m_predicates.orientation(v, before, after) != RIGHT_TURN;
    case Ear::AT_INFINITY:
      return tip != infinite_index && ends_at_infinity;
    default:
      return true;
    }
  }

  Index finite_neighbor_of(Index v) const
  {
    Index neighbor = infinite_index;
    m_maintained.mirror.for_each_neighbor(
        v, [&](Index w) { neighbor = w == infinite_index ? neighbor : w; });
    return neighbor;
  }

  // The edges opposite to v.
  std::array<Index, 3> edges_around(Index v) const
  {
    const auto& mirror = m_maintained.mirror;
    const Index h = mirror.corner(v), g = mirror.next_corner(h);
    return {mirror.edge_of(h), mirror.edge_of(g), mirror.edge_of(mirror.next_corner(g))};
  }

  // That they will be no more.
  void tell_of_faces_at(Index v)
  {
    m_maintained.mirror.for_each_corner(v, [&](Index h) {
      m_maintained.visitor_calls.before_face_removal(m_maintained.faces[h / 3]);
    });
  }

  // Afterwards v, which must have three edges, is in no face. `rename(from, to)` is told that edge
  // `to` is no more, and that edge `from`, if it is another one, takes its number. Returns the
  // faces that are left over.
  template <class Rename>
  std::array<Face_handle, 2> take_out(Index v, const Rename& rename)
  {
    auto& mirror = m_maintained.mirror;
    auto& renumberings = m_maintained.renumberings;
    auto left = mirror.merge_faces_at(mirror.corner(v));
    write_face(left.face);
    const Face_handle merged = m_maintained.faces[left.face];
    const std::array<Face_handle, 2> faces{m_maintained.faces[left.faces[0]],
                                           m_maintained.faces[left.faces[1]]};
    std::sort(left.faces.begin(), left.faces.end(), std::greater<Index>());
    for (const Index f : left.faces) {
      renumberings.faces.note_move(mirror.number_of_faces() - 1, f);
      m_maintained.faces[f] = m_maintained.faces.back();
      m_maintained.faces.pop_back();
      mirror.move_last_face_to(f);
    }
    std::sort(left.edges.begin(), left.edges.end(), std::greater<Index>());
    for (const Index e : left.edges) {
      const Index last = mirror.number_of_edges() - 1;
      renumberings.edges.note_move(last, e);
      rename(last, e);
      mirror.move_last_edge_to(e);
    }
    m_maintained.visitor_calls.after_face_creation(merged);
    return faces;
  }

  void delete_faces(const std::array<Face_handle, 2>& faces)
  {
    for (const Face_handle f : faces)
      m_maintained.triangulation.tds().delete_face(f);
  }

  // Deletes a vertex that is in no face, and that nobody is at.
  void drop(Index v)
  {
    auto& mirror = m_maintained.mirror;
    const Vertex_handle vertex = m_maintained.vertices[v];
    m_maintained.renumberings.vertices.note_move(m_maintained.number_of_vertices(), v);
    mirror.move_last_vertex_to(v);
    m_maintained.ids.move_last_vertex_to(v);
    m_maintained.move_last_vertex_to(v);
    m_maintained.triangulation.tds().delete_vertex(vertex);
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
  Vertex_predicates_2<Maintained> m_predicates;
  Point_location_2<Maintained> m_location;
  std::vector<Index> m_inner_edges;
  std::vector<Index> m_flipped; // half-edges, in the order of their flips
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
