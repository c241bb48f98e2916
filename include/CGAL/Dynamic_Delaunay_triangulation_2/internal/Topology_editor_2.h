// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Hilbert_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Patch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulation_2.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Triangulation_utils_2.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The one room that writes topology. Each operation changes the CGAL triangulation and the mirror
// together, keeps every vertex handle, and notes which edges are new.
template <class Maintained>
class Topology_editor_2
{
  using Traits = typename Maintained::Traits;
  using Point = typename Maintained::Point;
  using Vertex_handle = typename Maintained::Vertex_handle;
  using Face_handle = typename Maintained::Face_handle;
  using Static_triangulation = Static_triangulation_2<Traits>;
  using Static_vertex_handle = typename Static_triangulation::Vertex_handle;
  using Numbered_point = typename Hilbert_order_2<Traits>::Numbered_point;

public:
  explicit Topology_editor_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_static(maintained.traits())
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
    write_faces(old_faces, patch); // nothing throws from here on
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
  }

  // The first triangulation of `points`.
  void build(const std::vector<Point>& points)
  {
    m_points.clear();
    m_points.reserve(points.size());
    for (const Point& p : points)
      m_points.emplace_back(p, Index(m_points.size()));
    build();
  }

  // A fresh triangulation of the points where they are now, in the order of the last one.
  void rebuild()
  {
    const auto& ids = m_maintained.ids;
    m_points.clear();
    m_points.reserve(ids.number_of_points());
    if (ids.guests().empty())
      for (Index v = 1; v < Index(m_maintained.vertices.size()); ++v)
        m_points.emplace_back(m_maintained.point(v), ids.host(v));
    else
      for (const Index id : ids.in_vertex_order())
        m_points.emplace_back(
            ids.is_host(id) ? m_maintained.point(ids.vertex(id)) : ids.guest(id).point, id);
    build();
  }

  // Moves vertex v to p by CGAL's own means, in a Delaunay triangulation: false if another vertex
  // is there. The mirror is out of step until `read_back()`.
  bool relocate(Index v, const Point& p)
  {
    const Vertex_handle vertex = m_maintained.vertices[v];
    return m_maintained.triangulation.move_if_no_collision(vertex, p) == vertex;
  }

  // Reads the topology into the mirror after CGAL has changed it.
  void read_back()
  {
    auto& faces = m_maintained.faces;
    auto& triangulation = m_maintained.triangulation;
    faces.clear();
    auto& stored = triangulation.tds().faces();
    for (auto f = stored.begin(); f != stored.end(); ++f)
      faces.push_back(f);
    Unique_hash_map<Face_handle, Index> number_of_face(no_index, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
      number_of_face[faces[f]] = Index(f);
    m_maintained.everything_is_new = true;
    fill_mirror(
        faces, triangulation.dimension(), [](Vertex_handle v) { return Index(v->mirror_index()); },
        [&](Face_handle f) { return number_of_face[f]; });
    if (m_maintained.is_mirrored())
      for (Index v = 0; v < Index(m_maintained.vertices.size()); ++v)
        m_maintained.vertices[v]->set_face(faces[m_maintained.mirror.corner(v) / 3]);
  }

private:
  // BUILDING ------------------------------------------------------------------------------------

  // Of m_points.
  void build()
  {
    m_maintained.everything_is_new = true; // also if memory runs out on the way
    const bool is_sorted_anew = renew_order();
    triangulate();
    if (is_sorted_anew || !has_a_vertex_each())
      number_points();
    take_faces();
    // what was copied from would take as much memory as the triangulation
    m_static.clear();
    std::vector<Numbered_point>().swap(m_points);
    std::vector<Static_vertex_handle>().swap(m_static_vertices);
  }

  // Sorts the points anew if walking from one to the next has become more than twice as long, for
  // the size of the whole, as when they were last sorted: insertion locates each from the one
  // before. It starts from the order of the ids, so that the result depends on the positions alone.
  bool renew_order()
  {
    if (walk() <= 2 * m_walk_when_sorted)
      return false;
    std::vector<Numbered_point> by_id(m_points.size());
    for (Numbered_point& point : m_points) {
      const Index id = point.second;
      by_id[id] = std::move(point);
    }
    m_points.swap(by_id);
    Hilbert_order_2<Traits>(m_maintained.traits()).sort(m_points);
    m_walk_when_sorted = walk();
    return true;
  }

  // Whether the points had a vertex each, in their present order, and have it again.
  bool has_a_vertex_each() const
  {
    return m_coincident.empty() && m_maintained.number_of_vertices() == m_points.size();
  }

  // Its length, divided by the extent of the points; a NaN if it overflows.
  double walk() const
  {
    if (m_points.empty())
      return 0;
    Position_2 last = Maintained::approximation(m_points.front().first), low = last, high = last;
    double length = 0;
    for (const Numbered_point& point : m_points) {
      const Position_2 p = Maintained::approximation(point.first);
      length += std::abs(p.x - last.x) + std::abs(p.y - last.y);
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
      last = p;
    }
    const double extent = (high.x - low.x) + (high.y - low.y);
    return extent > 0 ? length / extent : 0;
  }

  // Triangulates the points and tells hosts from guests. Whoever was a host is inserted before
  // those who were guests, so that it stays one.
  void triangulate()
  {
    m_static.clear();
    m_static_vertices.assign(m_points.size(), {});
    m_coincident.clear();
    const auto insert = [&](std::size_t i) {
      const auto [vertex, is_new] = m_static.insert(m_points[i].first, Index(i + 1));
      if (is_new)
        m_static_vertices[i] = vertex;
      else
        m_coincident.push_back({i, vertex});
    };
    const auto& old_ids = m_maintained.ids;
    const bool were_guests = !old_ids.guests().empty();
    const auto was_guest = [&](std::size_t i) {
      const Index id = m_points[i].second;
      return were_guests && id < old_ids.number_of_points() && !old_ids.is_host(id);
    };
    for_each_in_rounds(m_points.size(), [&](std::size_t i) {
      if (!was_guest(i))
        insert(i);
    });
    if (were_guests)
      for (std::size_t i = 0; i < m_points.size(); ++i)
        if (was_guest(i))
          insert(i);
  }

  // Of the points that are built.
  bool is_host(std::size_t i) const { return m_static_vertices[i] != Static_vertex_handle(); }

  // Numbers the vertices in the order of the points.
  void number_points()
  {
    Point_ids_2<Point> ids;
    ids.reset(Index(m_points.size()));
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (is_host(i))
        ids.add_host(m_points[i].second);
    if (!m_coincident.empty())
      for (std::size_t i = 0; i < m_points.size(); ++i)
        if (is_host(i))
          m_static_vertices[i]->info() = ids.vertex(m_points[i].second);
    for (const auto& [i, vertex] : m_coincident)
      ids.add_guest(m_points[i].second, ids.host(vertex->info()), m_points[i].first);
    ids.sort_guests();
    take_vertices(ids);
    m_maintained.ids = std::move(ids);
  }

  // Gives every host its vertex: the one that it had, if it had one of its own.
  void take_vertices(const Point_ids_2<Point>& ids)
  {
    auto& tds = m_maintained.triangulation.tds();
    const auto& old_ids = m_maintained.ids;
    std::vector<Vertex_handle> vertices(1, m_maintained.triangulation.infinite_vertex());
    std::vector<Position_2> positions(1, Maintained::nowhere());
    vertices.reserve(ids.number_of_hosts() + 1);
    positions.reserve(ids.number_of_hosts() + 1);
    std::vector<Vertex_handle> idle = m_maintained.vertices;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      if (!is_host(i))
        continue;
      const auto& [p, id] = m_points[i];
      Vertex_handle vertex;
      if (id < old_ids.number_of_points() && old_ids.is_host(id)) {
        std::swap(vertex, idle[old_ids.vertex(id)]);
      } else {
        vertex = tds.create_vertex();
      }
      vertex->set_point(p);
      vertices.push_back(vertex);
      positions.push_back(Maintained::approximation(p));
    }
    for (Index v = 1; v < Index(idle.size()); ++v)
      if (idle[v] != Vertex_handle())
        tds.delete_vertex(idle[v]);
    m_maintained.vertices = std::move(vertices);
    m_maintained.positions = std::move(positions);
    m_maintained.points_are_written = true;
    if constexpr (!Maintained::coordinates_are_doubles)
      m_maintained.next_points.resize(m_maintained.vertices.size());
  }

  // Copies the topology of the static triangulation: into the mirror, and from there, face by face,
  // into CGAL's structure. Faces are numbered as they were created, which is along the plane.
  void take_faces()
  {
    using Static_face_handle = typename Static_triangulation::Face_handle;
    std::vector<Static_face_handle> static_faces;
    static_faces.reserve(m_static.faces().size());
    auto& stored = m_static.faces();
    for (auto f = stored.begin(); f != stored.end(); ++f) {
      f->info() = Index(static_faces.size());
      static_faces.push_back(f);
    }
    const int dimension = m_static.triangulation().dimension();
    fill_mirror(
        static_faces, dimension, [](auto v) { return v->info(); },
        [](auto f) { return f->info(); });
    provide_faces(static_faces.size());
    m_maintained.triangulation.tds().set_dimension(dimension);
    if (dimension == 2)
      write_all_faces();
    else
      copy_faces(static_faces);
  }

  void provide_faces(std::size_t number)
  {
    auto& tds = m_maintained.triangulation.tds();
    auto& faces = m_maintained.faces;
    faces.reserve(number);
    while (faces.size() > number) {
      tds.delete_face(faces.back());
      faces.pop_back();
    }
    while (faces.size() < number)
      faces.push_back(tds.create_face());
  }

  // From the mirror.
  void write_all_faces()
  {
    const auto& mirror = m_maintained.mirror;
    const auto& vertices = m_maintained.vertices;
    const auto& faces = m_maintained.faces;
    for (Index f = 0; f < Index(faces.size()); ++f) {
      const Index h = 3 * f;
      faces[f]->set_vertices(vertices[mirror.apex(h)], vertices[mirror.apex(h + 1)],
                             vertices[mirror.apex(h + 2)]);
      faces[f]->set_neighbors(faces[mirror.twin(h) / 3], faces[mirror.twin(h + 1) / 3],
                              faces[mirror.twin(h + 2) / 3]);
    }
    // a vertex stays where it is in memory, wherever it has gone in the plane
    constexpr Index ahead = 16;
    for (Index v = 0; v < Index(vertices.size()); ++v) {
      if (v + ahead < Index(vertices.size()))
        prefetch(&*vertices[v + ahead]);
      vertices[v]->set_mirror_index(v);
      vertices[v]->set_face(faces[mirror.corner(v) / 3]);
    }
  }

  // Below dimension 2, where there is no mirror.
  template <class Static_face_handle>
  void copy_faces(const std::vector<Static_face_handle>& static_faces)
  {
    for (Index v = 0; v < Index(m_maintained.vertices.size()); ++v)
      m_maintained.vertices[v]->set_mirror_index(v);
    const auto& faces = m_maintained.faces;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const auto v = static_faces[f]->vertex(i);
        const auto g = static_faces[f]->neighbor(i);
        const bool has_vertex = v != typename Static_triangulation::Vertex_handle();
        const bool has_neighbor = g != Static_face_handle();
        faces[f]->set_vertex(i, has_vertex ? m_maintained.vertices[v->info()] : Vertex_handle());
        faces[f]->set_neighbor(i, has_neighbor ? faces[g->info()] : Face_handle());
        if (has_vertex)
          faces[f]->vertex(i)->set_face(faces[f]);
      }
  }

  // Writes the mirror from faces in their numbering.
  template <class Any_face_handle, class Number_of_vertex, class Number_of_face>
  void fill_mirror(const std::vector<Any_face_handle>& faces, int dimension,
                   const Number_of_vertex& number_of_vertex, const Number_of_face& number_of_face)
  {
    auto& mirror = m_maintained.mirror;
    if (dimension < 2) {
      mirror.clear();
      return;
    }
    mirror.resize(m_maintained.number_of_vertices(), Index(faces.size()));
    for (Index f = 0; f < Index(faces.size()); ++f)
      for (int i = 0; i < 3; ++i) {
        const Any_face_handle g = faces[f]->neighbor(i);
        // g->index(faces[f]), which branches
        const Index place =
            Index(g->neighbor(1) == faces[f]) + 2 * Index(g->neighbor(2) == faces[f]);
        mirror.set_apex(3 * f + Index(i), number_of_vertex(faces[f]->vertex(i)));
        mirror.set_twin(3 * f + Index(i), 3 * number_of_face(g) + place);
      }
    mirror.number_edges();
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
    const std::size_t flips = m_flipped.size();
    for (std::size_t i = 0; i < flips; ++i) {
      prefetch_flip(i);
      tds.flip(faces[m_flipped[i] / 3], int(m_flipped[i] % 3));
    }
    m_flipped.clear();
  }

  // In steps, each of which reads what the one before has fetched. An earlier flip may yet change
  // what is read: then something else is fetched, and nothing is wrong.
  void prefetch_flip(std::size_t i) const
  {
    constexpr std::size_t step = 4;
    const auto& faces = m_maintained.faces;
    const std::size_t flips = m_flipped.size();
    if (i + 4 * step < flips)
      prefetch(&faces[m_flipped[i + 4 * step] / 3]);
    if (i + 3 * step < flips)
      prefetch_face(faces[m_flipped[i + 3 * step] / 3]);
    if (i + 2 * step < flips) {
      const Index h = m_flipped[i + 2 * step];
      const Face_handle f = faces[h / 3];
      prefetch_face(f->neighbor(int(h % 3)));
      prefetch_face(f->neighbor(Triangulation_cw_ccw_2::ccw(int(h % 3))));
      prefetch(&*f->vertex(Triangulation_cw_ccw_2::cw(int(h % 3))));
      prefetch(&*f->vertex(Triangulation_cw_ccw_2::ccw(int(h % 3))));
    }
    if (i + step < flips) {
      const Index h = m_flipped[i + step];
      const Face_handle f = faces[h / 3];
      const Face_handle g = f->neighbor(int(h % 3));
      prefetch_face(g->neighbor(Triangulation_cw_ccw_2::ccw(g->index(f))));
    }
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

  Maintained& m_maintained;
  Static_triangulation m_static;
  // what is built, in the order of insertion's rounds
  std::vector<Numbered_point> m_points;
  std::vector<Static_vertex_handle> m_static_vertices; // of each of m_points, if it is a host
  std::vector<std::pair<std::size_t, Static_vertex_handle>> m_coincident; // guests, and with whom
  std::vector<Index> m_inner_edges;
  std::vector<Index> m_flipped; // half-edges, in the order of their flips
  double m_walk_when_sorted = 0;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
