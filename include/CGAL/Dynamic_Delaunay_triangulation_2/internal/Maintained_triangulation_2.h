// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Planar_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Provided_memory_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Renumbering_2.h>
#include <CGAL/number_type_basic.h>

#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What an update works on: the CGAL triangulation, its mirror, and who is who in both. Positions
// are written here, topology by Topology_editor_2 and Topology_builder_2 alone.
template <class Traits_, class Tds_, class Visitor_calls>
struct Maintained_triangulation_2
{
  using Traits = Traits_;
  using Tds = Tds_;
  using Triangulation = Delaunay_triangulation_2<Traits, Tds>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;
  using Point = typename Triangulation::Point;

  static constexpr bool coordinates_are_doubles = has_double_coordinates<Point>;
  static constexpr bool points_are_two_doubles = is_two_doubles<Point>;

  explicit Maintained_triangulation_2(const Traits& traits = Traits())
    : triangulation(traits)
    , vertices(1, triangulation.infinite_vertex())
    , positions(1, nowhere())
  {
    ids.reset(0);
    if constexpr (!points_are_two_doubles)
      next_points.resize(1);
    auto& stored = triangulation.tds().faces(); // an empty triangulation has one, of dimension -1
    for (auto f = stored.begin(); f != stored.end(); ++f)
      faces.push_back(f);
  }

  static Position_2 nowhere()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }

  Index number_of_vertices() const { return Index(vertices.size()) - 1; }

  // Where a vertex is. While a frame is on its way, CGAL's vertex still has the point of the last
  // one.
  decltype(auto) point(Index vertex) const
  {
    if constexpr (points_are_two_doubles)
      return Point(positions[vertex].x, positions[vertex].y);
    else
      return (points_are_written ? vertices[vertex]->point() : next_points[vertex]);
  }

  // Where a point is.
  Point point_of_id(Index id) const
  {
    return ids.is_representative(id) ? point(ids.vertex(id)) : ids.duplicate(id).point;
  }

  const Traits& traits() const { return triangulation.geom_traits(); }

  // Where it was a frame ago, while the points are not written.
  const Point& previous_point(Index vertex) const { return vertices[vertex]->point(); }

  // The mirror exists in dimension 2 only: below, every frame is a rebuild.
  bool is_mirrored() const { return triangulation.dimension() == 2; }

  // Gives CGAL's vertices the points of the frame.
  void write_points()
  {
    if (!std::exchange(points_are_written, true)) {
      if (vertices.size() < min_vertices_to_prefetch)
        write_all_points<false>();
      else
        write_all_points<true>();
    }
  }

  // The same where only the points with these ids have moved. Some of them may be no more.
  void write_points_of(const std::vector<Index>& moved_ids)
  {
    if (std::exchange(points_are_written, true))
      return;
    for (const Index id : moved_ids)
      if (ids.is_taken(id))
        write_point(ids.vertex(id));
  }

  // Goes back to the points of CGAL's vertices.
  void restore_positions()
  {
    points_are_written = true;
    positions_are_exact = previous_positions_are_exact;
    for (Index v = 1; v < Index(vertices.size()); ++v)
      stage_vertex(v, vertices[v]->point());
  }

  void forget_changes()
  {
    everything_is_new = false;
    new_edges.clear();
    relocated.clear();
    renumberings.clear();
  }

  static Position_2 approximation(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
  }

  // What there is of each vertex besides its neighborhood.
  struct Vertex_arrays
  {
    std::vector<Vertex_handle> vertices;
    std::vector<Position_2> positions;
    std::vector<Point> points; // where these are more than two doubles
    bool points_are_written = false;

    void reserve(std::size_t number)
    {
      vertices.reserve(number);
      positions.reserve(number);
      if constexpr (!points_are_two_doubles)
        points.reserve(number);
    }

    void append(Vertex_handle infinite_vertex)
    {
      vertices.push_back(infinite_vertex);
      positions.push_back(nowhere());
      if constexpr (!points_are_two_doubles)
        points.emplace_back();
    }

    void append(Vertex_handle vertex, const Point& p)
    {
      vertices.push_back(vertex);
      positions.push_back(approximation(p));
      if constexpr (!points_are_two_doubles)
        points.push_back(p);
    }
  };

  // Takes other vertices, and gives its own away.
  void exchange_vertices(Vertex_arrays& others, Point_ids_2<Point>& other_ids)
  {
    vertices.swap(others.vertices);
    positions.swap(others.positions);
    if constexpr (!points_are_two_doubles)
      next_points.swap(others.points);
    std::swap(ids, other_ids);
    std::swap(points_are_written, others.points_are_written);
  }

  // Between two frames. Whoever refers to one of the two has the other's from then on.
  void swap(Maintained_triangulation_2& other)
  {
    triangulation.swap(other.triangulation);
    vertices.swap(other.vertices);
    faces.swap(other.faces);
    positions.swap(other.positions);
    next_points.swap(other.next_points);
    next_duplicates.swap(other.next_duplicates);
    new_edges.swap(other.new_edges);
    relocated.swap(other.relocated);
    std::swap(mirror, other.mirror);
    std::swap(ids, other.ids);
    std::swap(renumberings, other.renumberings);
    std::swap(positions_are_exact, other.positions_are_exact);
    std::swap(everything_is_new, other.everything_is_new);
  }

  // Where the points are in the arrays alone, until they are written.
  void stage_vertex(Index v, const Point& p)
  {
    positions[v] = approximation(p);
    if constexpr (!points_are_two_doubles)
      next_points[v] = p;
  }

  // In the arrays and in CGAL's vertex.
  void move_vertex(Index v, const Point& p)
  {
    vertices[v]->set_point(p);
    stage_vertex(v, p);
  }

  // Lets a duplicate at v be the representative, so that v has its point, and the representative a
  // duplicate at p.
  void hand_over(Index duplicate, Index v, const Point& p)
  {
    const Index representative = ids.representative(v);
    const Point point = ids.duplicate(duplicate).point;
    ids.hand_over(duplicate, p);
    if (points_are_written)
      move_vertex(v, point);
    else
      stage_vertex(v, point);
    visitor_calls.after_id_change(vertices[v], representative);
  }

  // Another vertex with this number, at p.
  void place_vertex(Index v, Vertex_handle vertex, const Point& p)
  {
    vertex->set_point(p);
    stage_vertex(v, p);
    vertex->set_mirror_index(v);
    std::swap(vertices[v], vertex);
    triangulation.tds().delete_vertex(vertex);
  }

  // A vertex at p, with the next number, that is in no face and that nobody is at. If it throws,
  // nothing has changed.
  void append_vertex(const Point& p)
  {
    provide(vertices, 1);
    provide(positions, 1);
    if constexpr (!points_are_two_doubles)
      provide(next_points, 1);
    const Vertex_handle vertex = triangulation.tds().create_vertex();
    vertex->set_mirror_index(Index(vertices.size()));
    vertices.push_back(vertex);
    try {
      vertex->set_point(p);
      positions.push_back(approximation(p));
      if constexpr (!points_are_two_doubles)
        next_points.push_back(p);
    } catch (...) {
      drop_last_vertex();
      throw;
    }
  }

  // Takes that back.
  void drop_last_vertex()
  {
    triangulation.tds().delete_vertex(vertices.back());
    vertices.pop_back();
    positions.resize(vertices.size());
    if constexpr (!points_are_two_doubles)
      next_points.resize(vertices.size());
  }

  // The last vertex takes the number of one that is no more.
  void move_last_vertex_to(Index v)
  {
    vertices[v] = vertices.back();
    vertices[v]->set_mirror_index(v);
    vertices.pop_back();
    positions[v] = positions.back();
    positions.pop_back();
    if constexpr (!points_are_two_doubles) {
      next_points[v] = next_points.back();
      next_points.pop_back();
    }
  }

private:
  // The vertices stand in memory as the points came at first: after much motion, anywhere.
  template <bool prefetches>
  void write_all_points()
  {
    constexpr Index ahead = 16;
    const Index bound = Index(vertices.size());
    for (Index v = 1; v < bound; ++v) {
      if (prefetches && v + ahead < bound)
        prefetch(&*vertices[v + ahead]);
      write_point(v);
    }
  }

  void write_point(Index v)
  {
    if constexpr (points_are_two_doubles)
      vertices[v]->set_point(Point(positions[v].x, positions[v].y));
    else
      vertices[v]->set_point(next_points[v]);
  }

public:
  Triangulation triangulation;
  Neighborhood_mirror_2 mirror;
  std::vector<Vertex_handle> vertices; // of each vertex index
  std::vector<Face_handle> faces;      // of each face index
  Point_ids_2<Point> ids;

  std::vector<Position_2> positions; // of each vertex index
  std::vector<Point> next_points; // the same, where points are more than two doubles, to be written
  std::vector<typename Point_ids_2<Point>::Duplicate> next_duplicates;
  bool points_are_written = true;  // into CGAL's vertices
  bool positions_are_exact = true; // no coordinate was rounded on its way into the flat arrays
  bool previous_positions_are_exact = true;

  Visitor_calls visitor_calls; // the user's, who stays when all else is swapped

  // What the last update triangulated anew: everything, or the edges with these indices.
  bool everything_is_new = true;
  std::vector<Index> new_edges;
  std::vector<Index> relocated; // the vertices that were put in elsewhere
  Renumberings_2 renumberings;  // of what is not new
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H
