// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_DELAUNAY_REFERENCE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_DELAUNAY_REFERENCE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
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

// A site of a reference triangulation: its number, and in periodic space the shift of its image.
using Reference_site_2 = std::pair<std::size_t, Periodic_shift_2>;

// Two faces whose four corners are on one circle, and what must be added to shifts in the second
// one to see it from the first.
struct Reference_tie_2
{
  std::size_t face, beyond;
  Periodic_shift_2 way;
};

inline Reference_site_2 shifted(const Reference_site_2& p, const Periodic_shift_2& shift)
{
  return {p.first, p.second + shift};
}

[[noreturn]] inline void throw_no_site()
{
  throw std::invalid_argument("delaunay_agreement: the maintained triangulation has a point that "
                              "the reference has not");
}

// The sites of a reference triangulation, and the edges and faces between them.
template <class Reference, bool is_periodic>
class Reference_sites_2;

// Those of a triangulation of CGAL are numbered in lexicographic order of the points.
template <class Reference>
class Reference_sites_2<Reference, false>
{
  using Point = typename Reference::Point;
  using Face_handle = typename Reference::Face_handle;

public:
  explicit Reference_sites_2(const Reference& reference)
    : m_reference(reference)
  {
    for (auto v = reference.finite_vertices_begin(); v != reference.finite_vertices_end(); ++v)
      m_points.push_back(v->point());
    std::sort(m_points.begin(), m_points.end(), is_before());
    for (auto v = reference.finite_vertices_begin(); v != reference.finite_vertices_end(); ++v)
      m_site_of_vertex[v] = site(v->point());
    for (auto f = reference.finite_faces_begin(); f != reference.finite_faces_end(); ++f) {
      m_number_of_face[f] = m_faces.size();
      m_faces.push_back(f);
    }
  }

  std::size_t size() const { return m_points.size(); }
  std::size_t number_of_faces() const { return m_faces.size(); }

  Reference_site_2 site(const Point& p) const
  {
    const auto found = std::lower_bound(m_points.begin(), m_points.end(), p, is_before());
    if (found == m_points.end() || !coincide(traits(), *found, p))
      throw_no_site();
    return {std::size_t(found - m_points.begin()), no_shift};
  }

  std::array<Reference_site_2, 3> corners(std::size_t face) const
  {
    return {site(m_faces[face], 0), site(m_faces[face], 1), site(m_faces[face], 2)};
  }

  // Calls f(source, target, tie), where `tie` is that of the faces at the edge, if there is one.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for (auto e = m_reference.finite_edges_begin(); e != m_reference.finite_edges_end(); ++e)
      f(site(e->first, Reference::cw(e->second)), site(e->first, Reference::ccw(e->second)),
        tie(e->first, e->second));
  }

private:
  std::optional<Reference_tie_2> tie(Face_handle f, int i) const
  {
    if (m_reference.dimension() < 2 || m_reference.is_infinite(f) ||
        m_reference.is_infinite(f->neighbor(i)) ||
        traits().side_of_oriented_circle_2_object()(
            f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
            m_reference.mirror_vertex(f, i)->point()) != ON_ORIENTED_BOUNDARY)
      return std::nullopt;
    return Reference_tie_2{m_number_of_face[f], m_number_of_face[f->neighbor(i)], no_shift};
  }

  const Reference_site_2& site(Face_handle f, int i) const
  {
    return m_site_of_vertex[f->vertex(i)];
  }

  const auto& traits() const { return m_reference.geom_traits(); }
  auto is_before() const
  {
    return [this](const Point& p, const Point& q) { return compare_xy(traits(), p, q) == SMALLER; };
  }

  const Reference& m_reference;
  std::vector<Point> m_points;
  std::vector<Face_handle> m_faces; // finite
  Unique_hash_map<typename Reference::Vertex_handle, Reference_site_2> m_site_of_vertex;
  Unique_hash_map<Face_handle, std::size_t> m_number_of_face;
};

// Those of a certified periodic triangulation have the smallest ids there as numbers.
template <class Reference>
class Reference_sites_2<Reference, true>
{
  using Arrays = Halfedge_arrays_2;
  using State = State_of_2<Reference>;

public:
  explicit Reference_sites_2(const Reference& reference)
    : m_reference(reference)
    , m_state(certified_state(reference))
    , m_queries(reference)
  {
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v)
      m_site_of_vertex.push_back(site(m_state.point(v)));
  }

  std::size_t size() const { return m_state.number_of_vertices(); }
  std::size_t number_of_faces() const { return m_state.arrays().number_of_faces(); }

  Reference_site_2 site(const typename Reference::Point& p) const
  {
    const std::optional<Reference_site_2> nearest = m_queries.nearest(p);
    if (!nearest || !m_state.torus().coincide(
                        {approximation(p), no_shift},
                        {approximation(m_reference.point(nearest->first)), nearest->second}))
      throw_no_site();
    return *nearest;
  }

  std::array<Reference_site_2, 3> corners(std::size_t face) const
  {
    const auto [h, i, k] = Arrays::halfedges_of(Face_index(face));
    return {corner(h), corner(i), corner(k)};
  }

  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for (Edge_index e(0); e < m_state.arrays().number_of_edges(); ++e) {
      const Halfedge_index h = m_state.arrays().halfedge(e);
      if (!m_state.are_across(Arrays::next(h), Arrays::previous(h)))
        f(corner(Arrays::next(h)), corner(Arrays::previous(h)), tie(h));
    }
  }

private:
  std::optional<Reference_tie_2> tie(Halfedge_index h) const
  {
    const Face_index f = Arrays::face_of(h), g = Arrays::face_of(m_state.arrays().twin(h));
    const auto [a, b, c, d] = m_state.corners_at(h);
    if (m_state.is_in_gap(f) || m_state.is_in_gap(g) ||
        m_state.torus().side_of_circle(a, b, c, d) != ON_ORIENTED_BOUNDARY)
      return std::nullopt;
    return Reference_tie_2{f, g, m_state.transition(h)};
  }

  Reference_site_2 corner(Halfedge_index h) const
  {
    return shifted(m_site_of_vertex[m_state.arrays().apex(h) - 1], m_state.shift(h));
  }

  const Reference& m_reference;
  const State& m_state;
  const Delaunay_point_queries_2<Reference> m_queries;
  std::vector<Reference_site_2> m_site_of_vertex; // from vertex 1 on
};

// The edges of a Delaunay triangulation, and the pairs of sites that may be joined instead, because
// more than three sites are on an empty circle.
template <class Reference, bool is_periodic>
class Delaunay_reference_2
{
public:
  using Site = Reference_site_2;
  // The numbers of two sites, and the shift of the second one as seen from the first.
  using Edge = std::tuple<std::size_t, std::size_t, Periodic_shift_2>;

  explicit Delaunay_reference_2(const Reference& reference)
    : m_sites(reference)
  {
    std::vector<Edge> chords;
    std::vector<std::vector<Neighbor>> neighbors(m_sites.number_of_faces());
    m_sites.for_each_edge(
        [&](const Site& p, const Site& q, const std::optional<Reference_tie_2>& tie) {
          (tie ? chords : m_edges).push_back(edge(p, q));
          if (tie) {
            neighbors[tie->face].push_back({tie->beyond, tie->way});
            neighbors[tie->beyond].push_back({tie->face, no_shift - tie->way});
          }
        });
    std::sort(m_edges.begin(), m_edges.end());
    find_clusters(neighbors);
    for (const Edge& chord : chords)
      ++m_required_chords[common_cluster(chord)];
    m_required = m_edges.size() + chords.size();
  }

  // Throws std::invalid_argument if the reference has no point at p.
  Site site(const typename Reference::Point& p) const { return m_sites.site(p); }

  // Either direction gives the same edge.
  static Edge edge(const Site& p, const Site& q)
  {
    return (std::min)(directed_edge(p, q), directed_edge(q, p));
  }

  struct Comparison
  {
    std::size_t right, wrong, missing, sites;
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
    return {right, edges.size() - right, m_required - (std::min)(m_required, right),
            m_sites.size()};
  }

private:
  // A face across a tie, and what is added to its shifts to see it from this side.
  using Neighbor = std::pair<std::size_t, Periodic_shift_2>;
  // The number of a site in a cluster, the number of the cluster, and the site's shift there.
  using Member = std::tuple<std::size_t, std::size_t, Periodic_shift_2>;

  static Edge directed_edge(const Site& p, const Site& q)
  {
    return {p.first, q.first, q.second - p.second};
  }

  // Faces that are connected across ties make a cluster: any chord of it is a Delaunay edge.
  void find_clusters(const std::vector<std::vector<Neighbor>>& neighbors)
  {
    std::vector<bool> is_in_cluster(neighbors.size());
    std::size_t clusters = 0;
    for (std::size_t f = 0; f < neighbors.size(); ++f)
      if (!neighbors[f].empty() && !is_in_cluster[f])
        add_cluster(f, ++clusters, neighbors, is_in_cluster);
    std::sort(m_members.begin(), m_members.end());
    m_members.erase(std::unique(m_members.begin(), m_members.end()), m_members.end());
  }

  void add_cluster(std::size_t face, std::size_t cluster,
                   const std::vector<std::vector<Neighbor>>& neighbors,
                   std::vector<bool>& is_in_cluster)
  {
    std::vector<Neighbor> open{{face, no_shift}};
    is_in_cluster[face] = true;
    while (!open.empty()) {
      const auto [f, way] = open.back();
      open.pop_back();
      for (const auto& [number, shift] : m_sites.corners(f))
        m_members.emplace_back(number, cluster, shift + way);
      for (const auto& [g, step] : neighbors[f])
        if (!is_in_cluster[g]) {
          is_in_cluster[g] = true;
          open.push_back({g, way + step});
        }
    }
  }

  // The cluster that both ends of an edge belong to, 0 if none. Two clusters share at most the two
  // ends of an edge between them, and that edge is no chord of either.
  std::size_t common_cluster(const Edge& edge) const
  {
    const auto& [p, q, shift] = edge;
    auto member = std::lower_bound(m_members.begin(), m_members.end(), Member(p, 0, no_shift));
    for (; member != m_members.end() && std::get<0>(*member) == p; ++member) {
      const auto& [number, cluster, its_shift] = *member;
      if (std::binary_search(m_members.begin(), m_members.end(),
                             Member(q, cluster, its_shift + shift)))
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

  // Of the chords of a cluster only the number is required; every other edge is required itself.
  const Reference_sites_2<Reference, is_periodic> m_sites;
  std::vector<Edge> m_edges;                            // required themselves
  std::vector<Member> m_members;                        // sorted
  std::map<std::size_t, std::size_t> m_required_chords; // of each cluster
  std::size_t m_required = 0;                           // edges and chords
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_DELAUNAY_REFERENCE_2_H
