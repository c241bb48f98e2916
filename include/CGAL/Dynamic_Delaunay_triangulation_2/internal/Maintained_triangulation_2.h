// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_ids_2.h>
#include <CGAL/number_utils.h>

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
    , previous_positions(1, nowhere())
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
  const Point& point(Index vertex) const { return vertices[vertex]->point(); }
  const Traits& traits() const { return triangulation.geom_traits(); }

  // Where a vertex goes when positions are exchanged.
  Point next_point(Index vertex) const
  {
    if constexpr (coordinates_are_doubles)
      return Point(previous_positions[vertex].x, previous_positions[vertex].y);
    else
      return previous_points[vertex];
  }

  // The mirror exists in dimension 2 only: below, every frame is a rebuild.
  bool is_mirrored() const { return triangulation.dimension() == 2; }

  // Makes the staged positions the current ones, and the current ones the previous.
  void exchange_positions()
  {
    std::swap(positions, previous_positions);
    std::swap(positions_are_exact, previous_positions_are_exact);
    if constexpr (coordinates_are_doubles) {
      if (vertices.size() < fewest_vertices_to_prefetch)
        write_points<false>();
      else
        write_points<true>();
    } else {
      for (Index v = 1; v < Index(vertices.size()); ++v) {
        Point current = vertices[v]->point();
        vertices[v]->set_point(previous_points[v]);
        previous_points[v] = std::move(current);
      }
    }
    std::swap(ids.guests(), previous_guests);
  }

private:
  // The vertices stand in memory as the points came at first: after much motion, anywhere.
  template <bool prefetches>
  void write_points()
  {
    constexpr Index ahead = 16;
    const Index bound = Index(vertices.size());
    for (Index v = 1; v < bound; ++v) {
      if (prefetches && v + ahead < bound)
        prefetch(&*vertices[v + ahead]);
      vertices[v]->set_point(Point(positions[v].x, positions[v].y));
    }
  }

public:
  Triangulation triangulation;
  Neighborhood_mirror_2 mirror;
  std::vector<Vertex_handle> vertices; // of each vertex index
  std::vector<Face_handle> faces;      // of each face index
  Point_ids_2<Point> ids;

  std::vector<Position_2> positions;          // of each vertex index
  std::vector<Position_2> previous_positions; // one frame ago; the staging place of the next frame
  std::vector<Point> previous_points;         // the same, where coordinates are not doubles
  std::vector<typename Point_ids_2<Point>::Guest> previous_guests;
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
