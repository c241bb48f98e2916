// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_CONFUSION_H
#define CLASSIFIERS_CONFUSION_H

#include "Classification_truth.h"
#include "Observed_update.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace classifiers {

// The matrix of "this vertex needs mending", summed up over frames.
struct Confusion
{
  double true_positives = 0.0;
  double false_positives = 0.0;
  double false_negatives = 0.0;
  double true_negatives = 0.0;
  double broken_edges = 0.0;
  double found_edges = 0.0; // of these, handed to the repair: named, or at a vertex that was

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
