// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_INFLATION_AWARE_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_INFLATION_AWARE_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies both ends of an edge that has grown differently from the edges around it (thesis 4.2.4).
Where everything expands, shrinks or turns as one, no vertex is classified. With `L` the length of
the edge and `M` the root mean square of the lengths of all other edges at its ends, the *relative
growth* of the edge in a frame is the growth of `L / M`. Both ends are classified when the product
of its relative growths, over all frames since the edge was last triangulated, has left the range
from `x` to `2 - x`.

The edges around an edge change with the triangulation. Such a change does not count as growth,
since the growth in a frame is measured with the same edges before and after it. It is a
<em>heuristic</em> classifier.

Cost: two passes over all edges; memory for two doubles an edge and one a vertex.

\cgalModels{DelaunayClassifier_2}
*/
class Inflation_aware_classifier_2
{
public:
  /// it may miss edges.
  static constexpr bool is_exact = false;

  /// \param x the relative growth that an edge may shrink to, from 0 to 1. With 1 it is most
  ///   sensitive: rounding alone is then enough to classify an edge.
  /// \throws Parameter_error_2 if `x` is out of this range.
  explicit Inflation_aware_classifier_2(double x = 0.7)
    : m_x(x)
  {
    if (!(x >= 0 && x <= 1))
      throw Parameter_error_2("the parameter x of inflation_aware", x, 0, 1);
  }

  /// the parameter.
  double x() const { return m_x; }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    sum_up(frame);
    if (frame.has_changes())
      after_update(frame);
    // all values are squared; at the infinite vertex they are NaN, and no comparison holds
    const double lowest = m_x * m_x, highest = (2 - m_x) * (2 - m_x);
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const double growth = relative_square(frame, e) / m_references[e];
      m_growths[e] = growth;
      if (growth < lowest || growth > highest) {
        classified.add_vertex(frame.edge(e).source);
        classified.add_vertex(frame.edge(e).target);
      }
    }
  }

  /// resets the growth of the edges that were triangulated anew. The growth of the edges around
  /// them continues from its current value.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    if (frame.everything_is_new()) {
      m_growths.assign(frame.number_of_edges(), 1);
      m_references.resize(frame.number_of_edges());
      sum_up(frame);
      for (Edge_index e(0); e < frame.number_of_edges(); ++e)
        m_references[e] = relative_square(frame, e);
      return;
    }
    frame.follow_edges(m_growths);
    frame.follow_edges(m_references);
    frame.follow_vertices(m_sums, [](Vertex_index) { return 0.; });
    m_changed.clear(frame.positions().size());
    for (const Edge_index e : frame.new_edges()) {
      m_growths[e] = 1;
      // every vertex that gained or lost an edge is a vertex of a new edge's faces
      const auto& edge = frame.edge(e);
      for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right})
        if (!frame.is_infinite(v))
          m_changed.insert(v);
    }
    for (const Vertex_index v : m_changed)
      sum_up_around(frame, v);
    for (const Vertex_index v : m_changed)
      frame.for_each_incident_edge(
          v, [&](Edge_index e) { m_references[e] = relative_square(frame, e) / m_growths[e]; });
  }

private:
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;

  template <class Frame>
  static double squared_length(const Frame& frame, Edge_index e)
  {
    const auto way = frame.edge_vector(e);
    return Dynamic_Delaunay_triangulations_2::internal::dot(way, way);
  }

  // Sums up the squared lengths of the edges at each vertex.
  template <class Frame>
  void sum_up(const Frame& frame)
  {
    m_sums.assign(frame.positions().size(), 0);
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const double square = finite_squared_length(frame, e);
      m_sums[frame.edge(e).source] += square;
      m_sums[frame.edge(e).target] += square;
    }
  }

  template <class Frame>
  void sum_up_around(const Frame& frame, Vertex_index v)
  {
    m_sums[v] = 0;
    frame.for_each_incident_edge(
        v, [&](Edge_index e) { m_sums[v] += finite_squared_length(frame, e); });
  }

  // Returns 0 for an edge to the infinite vertex, whose length is NaN.
  template <class Frame>
  static double finite_squared_length(const Frame& frame, Edge_index e)
  {
    const double square = squared_length(frame, e);
    return square >= 0 ? square : 0;
  }

  // The square of L / M, except for the factor of the number of surrounding edges, which is equal
  // for any two values that are compared.
  template <class Frame>
  double relative_square(const Frame& frame, Edge_index e) const
  {
    const double square = squared_length(frame, e);
    return square / (m_sums[frame.edge(e).source] + m_sums[frame.edge(e).target] - 2 * square);
  }

  double m_x;
  std::vector<double> m_growths;    // of each edge, squared, in the last classified frame
  std::vector<double> m_references; // what relative_square() is compared with
  std::vector<double> m_sums;       // of each vertex
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Vertex_index> m_changed;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_INFLATION_AWARE_CLASSIFIER_2_H
