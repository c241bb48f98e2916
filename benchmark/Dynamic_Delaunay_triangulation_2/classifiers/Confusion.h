// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_CONFUSION_H
#define CLASSIFIERS_CONFUSION_H

#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace classifiers {

// What motion has broken before it is mended, by the kernel's exact predicates: the edges of
// the last topology that are not Delaunay at the new positions, and the vertices that have one in
// their star, which is made of the edges at a vertex and of those opposite to it. These are the
// vertices whose neighbors change when the edge is flipped.
class Classification_truth
{
public:
  // To be called between two updates. Vertices and edges have the indices that the classifier sees
  // in the next update.
  template <class Frame>
  void find(const Frame& frame, const std::vector<scenario::Point>& points)
  {
    m_places.assign(frame.number_of_vertices() + 1, Place(0, 0));
    for (typename Frame::Vertex_index v(1); v <= frame.number_of_vertices(); ++v) {
      const scenario::Point& point = points[frame.id(v)];
      m_places[v] = {point.x, point.y};
    }
    m_is_vertex_broken.assign(m_places.size(), false);
    m_broken_edges.clear();
    for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const auto& edge = frame.edge(e);
      if (is_broken<Frame>(edge)) {
        m_broken_edges.push_back(e);
        for (const auto v : {edge.source, edge.target, edge.left, edge.right}) {
          m_is_vertex_broken[v] = true;
        }
      }
    }
    m_is_vertex_broken[0] = false; // the one at infinity
  }

  const std::vector<std::size_t>& broken_edges() const { return m_broken_edges; }
  bool is_vertex_broken(std::size_t v) const { return m_is_vertex_broken[v]; }
  std::size_t number_of_vertices() const { return m_places.size() - 1; }

private:
  using Place = run::Kernel::Point_2;

  template <class Frame>
  bool is_broken(const typename Frame::Edge& edge) const
  {
    if (Frame::is_infinite(edge.source)) {
      return breaks_hull(edge.left, edge.target, edge.right);
    }
    if (Frame::is_infinite(edge.target)) {
      return breaks_hull(edge.right, edge.source, edge.left);
    }
    const bool has_left = !Frame::is_infinite(edge.left);
    const bool has_right = !Frame::is_infinite(edge.right);
    if (has_left && turn(edge.left, edge.source, edge.target) != CGAL::LEFT_TURN) {
      return true;
    }
    if (has_right && turn(edge.right, edge.target, edge.source) != CGAL::LEFT_TURN) {
      return true;
    }
    return has_left && has_right &&
           run::Kernel().side_of_oriented_circle_2_object()(
               m_places[edge.left], m_places[edge.source], m_places[edge.target],
               m_places[edge.right]) == CGAL::ON_POSITIVE_SIDE;
  }

  // True if the hull is not convex at v, between its neighbors on the hull.
  bool breaks_hull(std::size_t before, std::size_t v, std::size_t after) const
  {
    const CGAL::Orientation orientation = turn(before, v, after);
    return orientation == CGAL::RIGHT_TURN ||
           (orientation == CGAL::COLLINEAR &&
            !run::Kernel().collinear_are_strictly_ordered_along_line_2_object()(
                m_places[before], m_places[v], m_places[after]));
  }

  CGAL::Orientation turn(std::size_t a, std::size_t b, std::size_t c) const
  {
    return run::Kernel().orientation_2_object()(m_places[a], m_places[b], m_places[c]);
  }

  std::vector<Place> m_places; // of each vertex
  std::vector<bool> m_is_vertex_broken;
  std::vector<std::size_t> m_broken_edges;
};

// Nanoseconds of an update, by the terms of the thesis's cost model (4.2.1).
struct Cost_terms
{
  double classify = 0.0;
  double after_update = 0.0; // the rest of the classifier's cost
  double repair = 0.0;
  double total = 0.0;
};

// What was classified in an update, and what it took.
struct Observation
{
  Cost_terms terms{};
  double aside = 0.0; // nanoseconds of the observing itself
  bool was_asked = false;
  bool keeps_sets = true;
  std::vector<std::size_t> vertices{};
  std::vector<std::size_t> whole_vertices{};
  std::vector<std::size_t> edges{};

  template <class Classification>
  void take(const Classification& classified)
  {
    was_asked = true;
    if (keeps_sets) {
      vertices.assign(classified.vertices().begin(), classified.vertices().end());
      whole_vertices.assign(classified.whole_vertices().begin(), classified.whole_vertices().end());
      edges.assign(classified.edges().begin(), classified.edges().end());
    }
  }
};

template <class Classifier>
class Observed_classifier
{
public:
  bool is_exact() const { return CGAL::is_classifier_exact(m_classifier); }

  Observed_classifier(Classifier classifier, Observation& observation)
    : m_classifier(std::move(classifier))
    , m_observation(&observation)
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_observation->terms.classify = run::nanoseconds_of([&] { m_classifier(frame, classified); });
    m_observation->aside = run::nanoseconds_of([&] { m_observation->take(classified); });
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    m_observation->terms.after_update =
        run::nanoseconds_of([&] { m_classifier.after_update(frame); });
  }

private:
  Classifier m_classifier;
  Observation* m_observation;
};

// The matrix of "this vertex needs mending", summed up over frames.
struct Confusion
{
  double true_positives = 0.0;
  double false_positives = 0.0;
  double false_negatives = 0.0;
  double true_negatives = 0.0;
  double broken_edges = 0.0;
  double found_edges = 0.0; // of these, handed to the repair: named, or at a named vertex

  double precision() const { return ratio(true_positives, true_positives + false_positives); }
  double recall() const { return ratio(true_positives, true_positives + false_negatives); }
  double false_discovery_rate() const
  {
    return ratio(false_positives, true_positives + false_positives);
  }
  double edge_recall() const { return ratio(found_edges, broken_edges); }

private:
  static double ratio(double part, double whole)
  {
    return whole == 0.0 ? std::numeric_limits<double>::quiet_NaN() : part / whole;
  }
};

inline std::vector<bool> flags(const std::vector<std::size_t>& members, std::size_t size)
{
  std::vector<bool> flags(size, false);
  for (const std::size_t member : members) {
    flags[member] = true;
  }
  return flags;
}

// `edges` are those of the frame that was classified.
template <class Edges>
void count(const Classification_truth& truth, const Observation& observation, const Edges& edges,
           Confusion& confusion)
{
  const std::size_t bound = truth.number_of_vertices() + 1;
  const std::vector<bool> is_classified = flags(observation.vertices, bound);
  for (std::size_t v = 1; v != bound; ++v) {
    const bool is_broken = truth.is_vertex_broken(v);
    confusion.true_positives += is_broken && is_classified[v];
    confusion.false_positives += !is_broken && is_classified[v];
    confusion.false_negatives += is_broken && !is_classified[v];
    confusion.true_negatives += !is_broken && !is_classified[v];
  }
  const std::vector<bool> is_whole = flags(observation.whole_vertices, bound);
  const std::vector<bool> is_named = flags(observation.edges, edges.size());
  for (const std::size_t e : truth.broken_edges()) {
    confusion.found_edges += is_named[e] || is_whole[edges[e].source] || is_whole[edges[e].target];
  }
  confusion.broken_edges += static_cast<double>(truth.broken_edges().size());
}

} // namespace classifiers

#endif // CLASSIFIERS_CONFUSION_H
