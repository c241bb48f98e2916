// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Patch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_numbering_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulator_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_order_2.h>
#include <CGAL/Triangulation_utils_2.h>
#include <CGAL/Unique_hash_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
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

public:
  explicit Topology_editor_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_vertex_order(maintained)
    , m_numbering(maintained)
    , m_triangulator(maintained)
  {
  }

  // For builds and rebuilds.
  void set_engine(Static_engine_2 engine) { m_triangulator.set_engine(engine); }

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
    m_maintained.everything_is_new = true; // also if memory runs out on the way
    m_numbering.number(points);
    take_vertices();
    triangulate(m_numbering.order());
  }

  // A fresh triangulation of the points where they are now. The vertices keep their numbers while
  // these fit the plane.
  void rebuild()
  {
    m_maintained.everything_is_new = true;
    if (sort_vertices())
      return triangulate(m_vertex_order.order());
    m_numbering.number();
    take_vertices();
    triangulate(m_numbering.order());
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
    m_maintained.everything_is_new = true;
    if (m_maintained.is_mirrored())
      read_faces();
    else
      m_maintained.mirror.clear();
  }

private:
  // BUILDING ------------------------------------------------------------------------------------

  // False if the vertices need new numbers: points have come together, or may part, or those that
  // follow each other in space have numbers far apart.
  bool sort_vertices()
  {
    if (!m_maintained.ids.guests().empty())
      return false;
    const boost::counting_iterator<Index> first(1), beyond(Index(m_maintained.vertices.size()));
    m_vertex_order.sort(first, beyond);
    return 8 * m_vertex_order.number_of_far_steps() <= m_maintained.vertices.size() &&
           !m_vertex_order.has_coincident_vertices();
  }

  // Gives every host its vertex: the one that it had, if it had one of its own.
  void take_vertices()
  {
    auto& tds = m_maintained.triangulation.tds();
    const auto &ids = m_numbering.ids(), &old_ids = m_maintained.ids;
    std::vector<Vertex_handle> vertices(1, m_maintained.triangulation.infinite_vertex());
    std::vector<Position_2> positions(1, Maintained::nowhere());
    vertices.reserve(ids.number_of_hosts() + 1);
    positions.reserve(ids.number_of_hosts() + 1);
    std::vector<Vertex_handle> idle = m_maintained.vertices;
    for (Index v = 1; v <= ids.number_of_hosts(); ++v) {
      const Index id = ids.host(v);
      const Point& p = m_numbering.point(v);
      Vertex_handle vertex;
      if (id < old_ids.number_of_points() && old_ids.is_host(id))
        std::swap(vertex, idle[old_ids.vertex(id)]);
      else
        vertex = tds.create_vertex();
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
    m_maintained.ids = ids;
    if constexpr (!Maintained::coordinates_are_doubles)
      m_maintained.next_points.resize(m_maintained.vertices.size());
  }

  // All vertices, in their order: into the mirror, and from there, face by face, into CGAL's
  // structure. What is only needed on the way would take as much memory as the triangulation.
  void triangulate(const Spatial_order_2& order)
  {
    m_triangulator.run(order);
    if (m_triangulator.faces().number_of_faces() > 0)
      take_faces(m_triangulator.faces());
    else
      triangulate_line();
    m_triangulator.release();
    m_numbering.release();
    m_vertex_order.release();
  }

  void take_faces(const Flat_faces_2& faces)
  {
    const Index number = faces.number_of_faces();
    provide_faces(number);
    auto& mirror = m_maintained.mirror;
    mirror.resize(m_maintained.number_of_vertices(), number);
    for (Index f = 0; f < number; ++f)
      for (Index i = 0; i < 3; ++i) {
        const Index h = Flat_faces_2::first_halfedge(f) + i;
        mirror.set_apex(3 * f + i, faces.apex(h));
        mirror.set_twin(3 * f + i, Flat_faces_2::number_in_mirror(faces.twin(h)));
      }
    mirror.number_edges();
    m_maintained.triangulation.tds().set_dimension(2);
    write_all_faces();
  }

  // Vertices that do not span the plane, by CGAL's insertion. There is no mirror then.
  void triangulate_line()
  {
    Static_triangulation line(m_maintained.traits());
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
      line.insert(m_maintained.point(v), v);
    std::vector<typename Static_triangulation::Face_handle> faces;
    for (auto f = line.faces().begin(); f != line.faces().end(); ++f) {
      f->info() = Index(faces.size());
      faces.push_back(f);
    }
    m_maintained.mirror.clear();
    provide_faces(faces.size());
    m_maintained.triangulation.tds().set_dimension(line.triangulation().dimension());
    copy_faces(faces);
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

  void read_faces()
  {
    const auto& faces = m_maintained.faces;
    Unique_hash_map<Face_handle, Index> number_of_face(no_index, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
      number_of_face[faces[f]] = Index(f);
    auto& mirror = m_maintained.mirror;
    mirror.resize(m_maintained.number_of_vertices(), Index(faces.size()));
    for (Index f = 0; f < Index(faces.size()); ++f)
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = faces[f]->neighbor(i);
        mirror.set_apex(3 * f + Index(i), faces[f]->vertex(i)->mirror_index());
        mirror.set_twin(3 * f + Index(i), 3 * number_of_face[g] + Index(g->index(faces[f])));
      }
    mirror.number_edges();
    for (Index v = 0; v < Index(m_maintained.vertices.size()); ++v)
      m_maintained.vertices[v]->set_face(faces[mirror.corner(v) / 3]);
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
      tds.flip(faces[m_flipped[i] / 3], int(m_flipped[i] % 3));
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
  Vertex_order_2<Maintained> m_vertex_order;
  Point_numbering_2<Maintained> m_numbering;
  Static_triangulator_2<Maintained> m_triangulator;
  std::vector<Index> m_inner_edges;
  std::vector<Index> m_flipped; // half-edges, in the order of their flips
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
