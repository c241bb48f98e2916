// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_ids_2.h>
#include <CGAL/number_type_basic.h>

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What an update works on: the CGAL triangulation, its mirror, and who is who in both. Positions
// are written here; topology is written by Topology_editor_2 alone.
template <class Traits_, class Tds_>
struct Maintained_triangulation_2
{
  using Traits = Traits_;
  using Tds = Tds_;
  using Triangulation = Delaunay_triangulation_2<Traits, Tds>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;
  using Point = typename Triangulation::Point;

  static constexpr bool coordinates_are_doubles =
      std::is_same_v<std::decay_t<decltype(std::declval<Point>().x())>, double>;

  explicit Maintained_triangulation_2(const Traits& traits = Traits())
    : triangulation(traits)
    , vertices(1, triangulation.infinite_vertex())
    , positions(1, nowhere())
  {
    ids.reset(0);
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
    if constexpr (coordinates_are_doubles)
      return Point(positions[vertex].x, positions[vertex].y);
    else
      return (points_are_written ? vertices[vertex]->point() : next_points[vertex]);
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
      if (vertices.size() < fewest_vertices_to_prefetch)
        write_all_points<false>();
      else
        write_all_points<true>();
    }
  }

  // Goes back to the points of CGAL's vertices.
  void restore_positions()
  {
    points_are_written = true;
    positions_are_exact = previous_positions_are_exact;
    for (Index v = 1; v < Index(vertices.size()); ++v)
      positions[v] = approximation(vertices[v]->point());
  }

  static Position_2 approximation(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
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
      if constexpr (coordinates_are_doubles)
        vertices[v]->set_point(Point(positions[v].x, positions[v].y));
      else
        vertices[v]->set_point(next_points[v]);
    }
  }

public:
  Triangulation triangulation;
  Neighborhood_mirror_2 mirror;
  std::vector<Vertex_handle> vertices; // of each vertex index
  std::vector<Face_handle> faces;      // of each face index
  Point_ids_2<Point> ids;

  std::vector<Position_2> positions; // of each vertex index
  std::vector<Point> next_points;    // the same, where coordinates are not doubles, to be written
  std::vector<typename Point_ids_2<Point>::Guest> next_guests;
  bool points_are_written = true;  // into CGAL's vertices
  bool positions_are_exact = true; // no coordinate was rounded on its way into the flat arrays
  bool previous_positions_are_exact = true;

  // What the last update triangulated anew: everything, or the edges with these indices.
  bool everything_is_new = true;
  std::vector<Index> new_edges;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H
