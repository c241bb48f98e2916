// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Patch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulation_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/number_utils.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_utils_2.h>
#include <CGAL/Unique_hash_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
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
      m_editor.m_flipped.push_back(h);
      maintained.new_edges.push_back(maintained.mirror.edge_of(h));
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
    auto& new_edges = m_maintained.new_edges;
    new_edges.insert(new_edges.end(), m_inner_edges.begin(), m_inner_edges.end());
  }

  // The first triangulation of `points`.
  void build(const std::vector<Point>& points)
  {
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    build(std::move(order), [&](Index id) -> const Point& { return points[id]; });
  }

  // A fresh triangulation of the points where they are now, in the order of the last one.
  void rebuild()
  {
    build(m_maintained.ids.in_vertex_order(), [this](Index id) -> const Point& {
      const auto& ids = m_maintained.ids;
      return ids.is_host(id) ? m_maintained.point(ids.vertex(id)) : ids.guest(id).point;
    });
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

  template <class Point_of>
  void build(std::vector<Index> order, const Point_of& point_of)
  {
    if (is_spoilt(order, point_of))
      sort(order, point_of);
    Point_ids_2<Point> ids;
    triangulate(order, point_of, ids);
    take_vertices(ids, point_of);
    m_maintained.ids = std::move(ids);
    take_faces();
    m_maintained.everything_is_new = true;
  }

  // Whether walking from point to point has become more than twice as long, for the size of the
  // whole, as when the order was last renewed: insertion locates each point from the one before.
  template <class Point_of>
  bool is_spoilt(const std::vector<Index>& order, const Point_of& point_of) const
  {
    return !(walk(order, point_of) <= 2 * m_walk_when_sorted);
  }

  template <class Point_of>
  void sort(std::vector<Index>& order, const Point_of& point_of)
  {
    std::sort(order.begin(), order.end()); // so that the result depends on the positions alone
    const auto map = boost::make_function_property_map<Index, const Point&>(point_of);
    hilbert_sort(order.begin(), order.end(),
                 Spatial_sort_traits_adapter_2<Traits, std::decay_t<decltype(map)>>(
                     map, m_maintained.traits()));
    m_walk_when_sorted = walk(order, point_of);
  }

  template <class Point_of>
  static double walk(const std::vector<Index>& order, const Point_of& point_of)
  {
    if (order.empty())
      return 0;
    const auto at = [&](Index id) { return approximation(point_of(id)); };
    Position_2 last = at(order.front()), low = last, high = last;
    double length = 0;
    for (const Index id : order) {
      const Position_2 p = at(id);
      length += std::abs(p.x - last.x) + std::abs(p.y - last.y);
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
      last = p;
    }
    const double extent = (high.x - low.x) + (high.y - low.y);
    return extent > 0 ? length / extent : 0;
  }

  static Position_2 approximation(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
  }

  // Triangulates the points and tells hosts from guests. Whoever was a host is inserted before
  // those who were guests, so that it stays one.
  template <class Point_of>
  void triangulate(const std::vector<Index>& order, const Point_of& point_of,
                   Point_ids_2<Point>& ids)
  {
    m_static.clear();
    m_static_vertices.assign(order.size(), {});
    m_coincident.clear();
    const auto insert = [&](std::size_t i) {
      const auto [vertex, is_new] = m_static.insert(point_of(order[i]), order[i]);
      if (is_new)
        m_static_vertices[i] = vertex;
      else
        m_coincident.push_back({order[i], vertex});
    };
    const auto& old_ids = m_maintained.ids;
    const auto was_guest = [&](std::size_t i) {
      return order[i] < old_ids.number_of_points() && !old_ids.is_host(order[i]);
    };
    for_each_in_rounds(order.size(), [&](std::size_t i) {
      if (!was_guest(i))
        insert(i);
    });
    if (!old_ids.guests().empty())
      for (std::size_t i = 0; i < order.size(); ++i)
        if (was_guest(i))
          insert(i);
    number_vertices(order, point_of, ids);
  }

  // Numbers the vertices in the order of the points.
  template <class Point_of>
  void number_vertices(const std::vector<Index>& order, const Point_of& point_of,
                       Point_ids_2<Point>& ids) const
  {
    ids.reset(Index(order.size()));
    for (std::size_t i = 0; i < order.size(); ++i)
      if (m_static_vertices[i] != Static_vertex_handle())
        m_static_vertices[i]->info() = ids.add_host(order[i]);
    for (const auto& [id, vertex] : m_coincident)
      ids.add_guest(id, ids.host(vertex->info()), point_of(id));
    ids.sort_guests();
  }

  // Gives every host its vertex: the one that it had, if it had one of its own.
  template <class Point_of>
  void take_vertices(const Point_ids_2<Point>& ids, const Point_of& point_of)
  {
    auto& tds = m_maintained.triangulation.tds();
    const auto& old_ids = m_maintained.ids;
    std::vector<Vertex_handle> vertices(1, m_maintained.triangulation.infinite_vertex());
    std::vector<Position_2> positions(1, Maintained::nowhere());
    std::vector<Vertex_handle> idle = m_maintained.vertices;
    for (Index v = 1; v <= ids.number_of_hosts(); ++v) {
      const Index id = ids.host(v);
      const Point& p = point_of(id);
      Vertex_handle vertex;
      if (id < old_ids.number_of_points() && old_ids.is_host(id)) {
        std::swap(vertex, idle[old_ids.vertex(id)]);
      } else {
        vertex = tds.create_vertex();
        vertex->set_point(p);
      }
      vertex->set_mirror_index(v);
      vertices.push_back(vertex);
      positions.push_back(approximation(p));
    }
    for (Index v = 1; v < Index(idle.size()); ++v)
      if (idle[v] != Vertex_handle())
        tds.delete_vertex(idle[v]);
    m_maintained.vertices = std::move(vertices);
    m_maintained.positions = std::move(positions);
    m_maintained.previous_positions = m_maintained.positions;
    if constexpr (!Maintained::coordinates_are_doubles)
      m_maintained.previous_points.resize(m_maintained.vertices.size());
  }

  // Copies the topology of the static triangulation: into the mirror, and from there, face by face,
  // into CGAL's structure. Faces are numbered as they were created, which is along the plane.
  void take_faces()
  {
    using Static_face_handle = typename Static_triangulation::Face_handle;
    std::vector<Static_face_handle> static_faces;
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
    for (Index v = 0; v < Index(vertices.size()); ++v)
      vertices[v]->set_face(faces[mirror.corner(v) / 3]);
  }

  // Below dimension 2, where there is no mirror.
  template <class Static_face_handle>
  void copy_faces(const std::vector<Static_face_handle>& static_faces)
  {
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
  std::vector<Static_vertex_handle>
      m_static_vertices; // of each point in its order, if it is a host
  std::vector<std::pair<Index, Static_vertex_handle>>
      m_coincident; // who is not, and whose guest it is
  std::vector<Index> m_inner_edges;
  std::vector<Index> m_flipped; // half-edges, in the order of their flips
  double m_walk_when_sorted = 0;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
