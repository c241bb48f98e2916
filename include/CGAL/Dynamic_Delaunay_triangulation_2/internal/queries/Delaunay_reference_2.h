// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_DELAUNAY_REFERENCE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_DELAUNAY_REFERENCE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The number of a place with points, and in periodic space the shift of its image.
using Reference_place_2 = std::pair<std::size_t, Periodic_shift_2>;
using Reference_face_2 = std::array<Reference_place_2, 3>;

inline Reference_place_2 shifted(const Reference_place_2& p, const Periodic_shift_2& shift)
{
  return {p.first, p.second + shift};
}

[[noreturn]] inline void throw_no_place()
{
  throw std::invalid_argument("delaunay_agreement: the maintained triangulation has a point that "
                              "the reference has not");
}

// The places of a reference triangulation, and the edges and faces between them.
template <class Reference, bool is_periodic>
class Reference_places_2;

// The places of a triangulation of CGAL, numbered in lexicographic order of the points.
template <class Reference>
class Reference_places_2<Reference, false>
{
  using Point = typename Reference::Point;
  using Vertex_handle = typename Reference::Vertex_handle;

public:
  explicit Reference_places_2(const Reference& reference)
    : m_reference(reference)
  {
    for (auto v = reference.finite_vertices_begin(); v != reference.finite_vertices_end(); ++v)
      m_points.push_back(v->point());
    std::sort(m_points.begin(), m_points.end(), is_before());
    for (auto v = reference.finite_vertices_begin(); v != reference.finite_vertices_end(); ++v)
      m_place_of_vertex[v] = place(v->point());
  }

  std::size_t size() const { return m_points.size(); }

  Reference_place_2 place(const Point& p) const
  {
    const auto found = std::lower_bound(m_points.begin(), m_points.end(), p, is_before());
    if (found == m_points.end() || !coincide(traits(), *found, p))
      throw_no_place();
    return {std::size_t(found - m_points.begin()), no_shift};
  }

  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for (auto e = m_reference.finite_edges_begin(); e != m_reference.finite_edges_end(); ++e)
      f(m_place_of_vertex[e->first->vertex(m_reference.cw(e->second))],
        m_place_of_vertex[e->first->vertex(m_reference.ccw(e->second))]);
  }

  template <class Function>
  void for_each_face(const Function& f) const
  {
    for (auto g = m_reference.finite_faces_begin(); g != m_reference.finite_faces_end(); ++g)
      f(Reference_face_2{m_place_of_vertex[g->vertex(0)], m_place_of_vertex[g->vertex(1)],
                         m_place_of_vertex[g->vertex(2)]});
  }

  bool is_on_circle(const Reference_face_2& face, const Reference_place_2& p) const
  {
    return traits().side_of_oriented_circle_2_object()(
               m_points[face[0].first], m_points[face[1].first], m_points[face[2].first],
               m_points[p.first]) == ON_ORIENTED_BOUNDARY;
  }

private:
  const auto& traits() const { return m_reference.geom_traits(); }
  auto is_before() const
  {
    return [this](const Point& p, const Point& q) { return compare_xy(traits(), p, q) == SMALLER; };
  }

  const Reference& m_reference;
  std::vector<Point> m_points;
  Unique_hash_map<Vertex_handle, Reference_place_2> m_place_of_vertex;
};

// The places of a certified periodic triangulation. Their numbers are the smallest ids there.
template <class Reference>
class Reference_places_2<Reference, true>
{
  using Point = typename Reference::Point;

public:
  explicit Reference_places_2(const Reference& reference)
    : m_reference(reference)
    , m_torus(reference.cell())
    , m_queries(reference)
    , m_place_of_id(reference.number_of_ids())
  {
    for (std::size_t id = 0; id < m_place_of_id.size(); ++id)
      if (reference.has_id(id))
        m_place_of_id[id] = place(reference.point(id));
  }

  std::size_t size() const { return m_reference.number_of_vertices(); }

  Reference_place_2 place(const Point& p) const
  {
    const std::optional<Reference_place_2> nearest = m_queries.nearest(p);
    if (!nearest || !m_torus.coincide({approximation(p), no_shift}, image(*nearest)))
      throw_no_place();
    return *nearest;
  }

  template <class Function>
  void for_each_edge(const Function& f) const
  {
    m_reference.for_each_edge([&](std::size_t i, std::size_t j, const Periodic_shift_2& shift) {
      f(m_place_of_id[i], shifted(m_place_of_id[j], shift));
    });
  }

  template <class Function>
  void for_each_face(const Function& f) const
  {
    m_reference.for_each_face(
        [&](const std::array<std::size_t, 3>& ids, const std::array<Periodic_shift_2, 3>& shifts) {
          Reference_face_2 face;
          for (std::size_t k = 0; k < 3; ++k)
            face[k] = shifted(m_place_of_id[ids[k]], shifts[k]);
          f(face);
        });
  }

  bool is_on_circle(const Reference_face_2& face, const Reference_place_2& p) const
  {
    return m_torus.side_of_circle(image(face[0]), image(face[1]), image(face[2]), image(p)) ==
           ON_ORIENTED_BOUNDARY;
  }

private:
  Image_2 image(const Reference_place_2& p) const
  {
    return {approximation(m_reference.point(p.first)), p.second};
  }

  const Reference& m_reference;
  const Torus_2 m_torus;
  const Delaunay_point_queries_2<Reference> m_queries;
  std::vector<Reference_place_2> m_place_of_id;
};

// The edges of a Delaunay triangulation, and the pairs of places that may be joined instead,
// because more than three places are on an empty circle.
template <class Reference, bool is_periodic>
class Delaunay_reference_2
{
public:
  using Place = Reference_place_2;
  // Two places, and the shift of the second one as seen from the first.
  using Edge = std::tuple<std::size_t, std::size_t, Periodic_shift_2>;

  explicit Delaunay_reference_2(const Reference& reference)
    : m_places(reference)
  {
    m_places.for_each_face([&](const Reference_face_2& face) { m_faces.push_back(face); });
    find_ties();
    find_clusters();
    m_places.for_each_edge([&](const Place& p, const Place& q) { add_edge(edge(p, q)); });
    std::sort(m_edges.begin(), m_edges.end());
  }

  // Throws std::invalid_argument if the reference has no point there.
  Place place(const typename Reference::Point& p) const { return m_places.place(p); }

  // Either direction gives the same edge.
  static Edge edge(const Place& p, const Place& q)
  {
    return (std::min)(directed_edge(p, q), directed_edge(q, p));
  }

  struct Comparison
  {
    std::size_t right, wrong, missing, places;
  };

  // Counts the right and the wrong edges among `edges`, and the required edges that are missing.
  Comparison compare(std::vector<Edge> edges) const
  {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::size_t right = 0;
    std::map<std::size_t, std::size_t> chords = m_required_chords; // of each cluster, still missing
    for (const Edge& edge : edges)
      if (std::binary_search(m_edges.begin(), m_edges.end(), edge) || take_chord(edge, chords))
        ++right;
    const std::size_t required = m_edges.size() + m_ties.size();
    return {right, edges.size() - right, required - (std::min)(required, right), m_places.size()};
  }

private:
  // An edge of a face, the opposite corner, and the shift of the edge's first end in the face.
  struct Side
  {
    Edge edge;
    std::size_t face;
    Place opposite;
    Periodic_shift_2 shift;
  };
  // The face across a side, and what is added to its shifts to see it from this side.
  using Neighbor = std::pair<std::size_t, Periodic_shift_2>;
  // A place that is a corner of a cluster, the number of the cluster, and the place's shift there.
  using Corner = std::tuple<std::size_t, std::size_t, Periodic_shift_2>;

  static Edge directed_edge(const Place& p, const Place& q)
  {
    return {p.first, q.first, q.second - p.second};
  }

  Side side(std::size_t face, std::size_t opposite) const
  {
    const Place& p = m_faces[face][(opposite + 1) % 3];
    const Place& q = m_faces[face][(opposite + 2) % 3];
    const Edge its_edge = edge(p, q);
    return {its_edge, face, m_faces[face][opposite],
            its_edge == directed_edge(p, q) ? p.second : q.second};
  }

  // Finds the edges between two faces whose four corners are on one circle.
  void find_ties()
  {
    std::vector<Side> sides;
    for (std::size_t f = 0; f < m_faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        sides.push_back(side(f, k));
    std::sort(sides.begin(), sides.end(),
              [](const Side& s, const Side& t) { return s.edge < t.edge; });
    m_neighbors.resize(m_faces.size());
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (sides[i - 1].edge == sides[i].edge)
        join_if_tie(sides[i - 1], sides[i]);
  }

  void join_if_tie(const Side& s, const Side& t)
  {
    const Periodic_shift_2 way = s.shift - t.shift;
    if (!m_places.is_on_circle(m_faces[s.face], shifted(t.opposite, way)))
      return;
    m_ties.push_back(s.edge);
    m_neighbors[s.face].push_back({t.face, way});
    m_neighbors[t.face].push_back({s.face, no_shift - way});
  }

  // Faces that are connected across ties make a cluster: any chord of it is a Delaunay edge.
  void find_clusters()
  {
    std::vector<bool> is_in_cluster(m_faces.size());
    std::size_t clusters = 0;
    for (std::size_t f = 0; f < m_faces.size(); ++f)
      if (!m_neighbors[f].empty() && !is_in_cluster[f])
        add_cluster(f, ++clusters, is_in_cluster);
    std::sort(m_corners.begin(), m_corners.end());
    m_corners.erase(std::unique(m_corners.begin(), m_corners.end()), m_corners.end());
  }

  void add_cluster(std::size_t face, std::size_t cluster, std::vector<bool>& is_in_cluster)
  {
    std::vector<Neighbor> open{{face, no_shift}};
    is_in_cluster[face] = true;
    while (!open.empty()) {
      const auto [f, way] = open.back();
      open.pop_back();
      for (const Place& p : m_faces[f])
        m_corners.emplace_back(p.first, cluster, p.second + way);
      for (const auto& [g, step] : m_neighbors[f])
        if (!is_in_cluster[g]) {
          is_in_cluster[g] = true;
          open.push_back({g, way + step});
        }
    }
  }

  // Of the chords of a cluster only the number is required; every other edge is required itself.
  void add_edge(const Edge& edge)
  {
    if (std::binary_search(m_ties.begin(), m_ties.end(), edge)) // found in sorted order
      ++m_required_chords[common_cluster(edge)];
    else
      m_edges.push_back(edge);
  }

  // The cluster that both ends of an edge belong to, 0 if none. Two clusters share at most the two
  // ends of an edge between them, and that edge is no chord of either.
  std::size_t common_cluster(const Edge& edge) const
  {
    const auto& [p, q, shift] = edge;
    auto corner = std::lower_bound(m_corners.begin(), m_corners.end(), Corner(p, 0, no_shift));
    for (; corner != m_corners.end() && std::get<0>(*corner) == p; ++corner) {
      const auto& [place, cluster, its_shift] = *corner;
      if (std::binary_search(m_corners.begin(), m_corners.end(),
                             Corner(q, cluster, its_shift + shift)))
        return cluster;
    }
    return 0;
  }

  bool take_chord(const Edge& edge, std::map<std::size_t, std::size_t>& chords) const
  {
    const auto wanted = chords.find(common_cluster(edge));
    if (wanted == chords.end() || wanted->second == 0)
      return false;
    --wanted->second;
    return true;
  }

  const Reference_places_2<Reference, is_periodic> m_places;
  std::vector<Reference_face_2> m_faces;
  std::vector<std::vector<Neighbor>> m_neighbors;       // of each face, across ties
  std::vector<Edge> m_ties;                             // sorted
  std::vector<Edge> m_edges;                            // required themselves
  std::vector<Corner> m_corners;                        // sorted
  std::map<std::size_t, std::size_t> m_required_chords; // of each cluster
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_DELAUNAY_REFERENCE_2_H
