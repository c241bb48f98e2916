// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_AGREEMENT_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_AGREEMENT_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/enum.h>
#include <CGAL/Union_find.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

How far the edges of a maintained triangulation agree with those of a Delaunay triangulation of the
same points, as the confusion matrix of "these two points are Delaunay neighbors" over all pairs of
points (thesis 5.1.1).
*/
class Delaunay_agreement
{
public:
  /// \cond
  Delaunay_agreement(std::size_t true_positives, std::size_t false_positives,
                     std::size_t false_negatives, std::size_t points)
    : m_true_positives(true_positives)
    , m_false_positives(false_positives)
    , m_false_negatives(false_negatives)
  {
    const std::size_t pairs = points < 2 ? 0 : points * (points - 1) / 2;
    const std::size_t named = true_positives + false_positives + false_negatives;
    m_true_negatives = pairs > named ? pairs - named : 0;
  }
  /// \endcond

  /// maintained edges that are Delaunay.
  std::size_t true_positives() const { return m_true_positives; }
  /// maintained edges that are not Delaunay.
  std::size_t false_positives() const { return m_false_positives; }
  /// Delaunay edges that are missing.
  std::size_t false_negatives() const { return m_false_negatives; }
  /// pairs of points that are neighbors in neither triangulation.
  std::size_t true_negatives() const { return m_true_negatives; }

  /// whether the two triangulations agree in every edge.
  bool is_perfect() const { return m_false_positives == 0 && m_false_negatives == 0; }

  /// the *validity* of the thesis: exactly 1 if all edges agree, 0 for agreement by chance, -1 for
  /// complete disagreement. By convention 0 if a row or column of the matrix is empty and the
  /// agreement is not perfect.
  double matthews_correlation_coefficient() const
  {
    if (is_perfect())
      return 1;
    const double tp = double(m_true_positives), fp = double(m_false_positives);
    const double fn = double(m_false_negatives), tn = double(m_true_negatives);
    const double product =
        std::sqrt(tp + fp) * std::sqrt(tp + fn) * std::sqrt(tn + fp) * std::sqrt(tn + fn);
    return product == 0 ? 0 : (tp * tn - fp * fn) / product;
  }

private:
  std::size_t m_true_positives, m_false_positives, m_false_negatives, m_true_negatives = 0;
};

/// \cond
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The places of a Delaunay triangulation, and the pairs of them that may be joined. Places are
// numbered in lexicographic order of the points, so the numbers of different triangulations can be
// compared.
template <class Triangulation>
class Delaunay_reference_2
{
  using Point = typename Triangulation::Point;
  using Face_handle = typename Triangulation::Face_handle;
  using Vertex_handle = typename Triangulation::Vertex_handle;

public:
  using Edge = std::pair<std::size_t, std::size_t>;

  explicit Delaunay_reference_2(const Triangulation& reference)
    : m_traits(reference.geom_traits())
  {
    for (auto v = reference.finite_vertices_begin(); v != reference.finite_vertices_end(); ++v)
      m_points.push_back(v->point());
    std::sort(m_points.begin(), m_points.end(), is_before());
    for (auto v = reference.finite_vertices_begin(); v != reference.finite_vertices_end(); ++v)
      m_place_of_vertex[v] = place(v->point());
    find_clusters(reference);
    for (auto e = reference.finite_edges_begin(); e != reference.finite_edges_end(); ++e)
      add_edge(reference, *e);
    std::sort(m_edges.begin(), m_edges.end());
  }

  std::size_t number_of_places() const { return m_points.size(); }

  std::size_t place(const Point& p) const
  {
    const auto found = std::lower_bound(m_points.begin(), m_points.end(), p, is_before());
    if (found == m_points.end() || !coincide(m_traits, *found, p))
      throw std::invalid_argument("delaunay_agreement: the maintained triangulation has a point "
                                  "that the reference has not");
    return std::size_t(found - m_points.begin());
  }

  // Counts the right and the wrong edges among `edges`, and the required edges that are missing.
  Delaunay_agreement compare(std::vector<Edge> edges) const
  {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::size_t right = 0;
    std::map<std::size_t, std::size_t> chords = m_required_chords; // of each cluster, still missing
    std::size_t wrong = 0;
    for (const Edge& edge : edges)
      if (std::binary_search(m_edges.begin(), m_edges.end(), edge))
        ++right;
      else if (take_chord(edge, chords))
        ++right;
      else
        ++wrong;
    const std::size_t required = m_edges.size() + m_number_of_chords;
    return Delaunay_agreement(right, wrong, required - (std::min)(required, right),
                              m_points.size());
  }

private:
  auto is_before() const
  {
    return [this](const Point& p, const Point& q) { return compare_xy(m_traits, p, q) == SMALLER; };
  }

  // Two faces at an edge belong to one cluster if their four vertices are cocircular: any chord of
  // a cluster is a Delaunay edge.
  void find_clusters(const Triangulation& reference)
  {
    if (reference.dimension() < 2)
      return;
    Union_find<Face_handle> faces;
    Unique_hash_map<Face_handle, typename Union_find<Face_handle>::handle> handle_of_face;
    for (auto f = reference.finite_faces_begin(); f != reference.finite_faces_end(); ++f)
      handle_of_face[f] = faces.make_set(f);
    for (auto e = reference.finite_edges_begin(); e != reference.finite_edges_end(); ++e)
      if (is_tie(reference, *e))
        faces.unify_sets(handle_of_face[e->first], handle_of_face[e->first->neighbor(e->second)]);
    Unique_hash_map<Face_handle, std::size_t> number_of_cluster(0);
    std::size_t clusters = 0;
    for (auto f = reference.finite_faces_begin(); f != reference.finite_faces_end(); ++f) {
      const auto set = handle_of_face[f];
      if (faces.size(set) == 1)
        continue;
      const Face_handle representative = *faces.find(set);
      std::size_t& number = number_of_cluster[representative];
      if (number == 0)
        number = ++clusters;
      for (int i = 0; i < 3; ++i)
        m_clusters_of_place.push_back({m_place_of_vertex[f->vertex(i)], number});
    }
    std::sort(m_clusters_of_place.begin(), m_clusters_of_place.end());
    m_clusters_of_place.erase(std::unique(m_clusters_of_place.begin(), m_clusters_of_place.end()),
                              m_clusters_of_place.end());
  }

  static bool is_tie(const Triangulation& reference, const typename Triangulation::Edge& e)
  {
    const Face_handle f = e.first, g = f->neighbor(e.second);
    if (reference.dimension() < 2 || reference.is_infinite(f) || reference.is_infinite(g))
      return false;
    return reference.geom_traits().side_of_oriented_circle_2_object()(
               f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point(),
               g->vertex(g->index(f))->point()) == ON_ORIENTED_BOUNDARY;
  }

  // Of the chords of a cluster only the number is required; every other edge is required itself.
  void add_edge(const Triangulation& reference, const typename Triangulation::Edge& e)
  {
    const std::size_t i = m_place_of_vertex[e.first->vertex(reference.cw(e.second))];
    const std::size_t j = m_place_of_vertex[e.first->vertex(reference.ccw(e.second))];
    const Edge edge((std::min)(i, j), (std::max)(i, j));
    if (!is_tie(reference, e)) {
      m_edges.push_back(edge);
      return;
    }
    ++m_required_chords[common_cluster(edge)];
    ++m_number_of_chords;
  }

  // The cluster that both ends of an edge belong to, 0 if none. Two clusters share at most the two
  // ends of an edge between them, and that edge is no chord of either.
  std::size_t common_cluster(const Edge& edge) const
  {
    auto i = first_cluster(edge.first), j = first_cluster(edge.second);
    const auto end = m_clusters_of_place.end();
    while (i != end && j != end && i->first == edge.first && j->first == edge.second)
      if (i->second == j->second)
        return i->second;
      else if (i->second < j->second)
        ++i;
      else
        ++j;
    return 0;
  }

  std::vector<std::pair<std::size_t, std::size_t>>::const_iterator
  first_cluster(std::size_t place) const
  {
    return std::lower_bound(m_clusters_of_place.begin(), m_clusters_of_place.end(),
                            std::pair<std::size_t, std::size_t>(place, 0));
  }

  bool take_chord(const Edge& edge, std::map<std::size_t, std::size_t>& chords) const
  {
    const auto wanted = chords.find(common_cluster(edge));
    if (wanted == chords.end() || wanted->second == 0)
      return false;
    --wanted->second;
    return true;
  }

  const typename Triangulation::Geom_traits m_traits;
  std::vector<Point> m_points; // of each place
  Unique_hash_map<Vertex_handle, std::size_t> m_place_of_vertex;
  std::vector<Edge> m_edges; // required themselves
  std::vector<std::pair<std::size_t, std::size_t>> m_clusters_of_place;
  std::map<std::size_t, std::size_t> m_required_chords; // of each cluster
  std::size_t m_number_of_chords = 0;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
/// \endcond

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

compares the edges of a maintained triangulation with those of a Delaunay triangulation of the same
points, which is assumed to be correct.

Ties are not errors: where four or more points lie on one circle, any chord between them counts as a
Delaunay edge, as long as there are not more of them than a triangulation has room for.

Cost: O(n log n) for n points.

\tparam Maintained a `Dynamic_Delaunay_triangulation_2`, certified or not.
\tparam Reference a `Delaunay_triangulation_2` with the same point type.
\param maintained the maintained triangulation.
\param reference the correct triangulation.
\throws std::invalid_argument if a point of `maintained` is not in `reference`.
*/
template <class Maintained, class Reference>
Delaunay_agreement delaunay_agreement(const Maintained& maintained, const Reference& reference)
{
  using Places = Dynamic_Delaunay_triangulations_2::internal::Delaunay_reference_2<Reference>;
  const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2 floating_point;
  const Places places(reference);
  std::vector<typename Places::Edge> edges;
  const auto& tds = maintained.tds();
  const auto infinite = maintained.infinite_vertex();
  for (auto e = tds.edges_begin(); e != tds.edges_end(); ++e) {
    const auto v = e->first->vertex(tds.cw(e->second)), w = e->first->vertex(tds.ccw(e->second));
    if (v == infinite || w == infinite)
      continue;
    const std::size_t i = places.place(v->point()), j = places.place(w->point());
    edges.push_back({(std::min)(i, j), (std::max)(i, j)});
  }
  return places.compare(std::move(edges));
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_AGREEMENT_H
