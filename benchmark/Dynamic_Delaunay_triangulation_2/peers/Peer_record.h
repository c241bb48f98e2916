// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEER_RECORD_H
#define PEERS_PEER_RECORD_H

#include "Peer.h"
#include "Peer_output.h"
#include "scenario_runner/Measurement.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace peers {

// What a peer has done in the frames of a case.
struct Peer_record
{
  std::string peer;
  Promise promise;
  std::vector<double> nanoseconds{}; // a point, of each frame
  std::vector<double> validities{};  // Matthews correlation coefficients
  std::size_t equal_frames = 0;
  std::size_t wrong_edges = 0;
  std::size_t missing_edges = 0;

  void add(double time, const Peer_output::Verdict& verdict)
  {
    nanoseconds.push_back(time);
    validities.push_back(verdict.agreement.matthews_correlation_coefficient());
    equal_frames += verdict.is_equal ? 1 : 0;
    wrong_edges += verdict.agreement.false_positives();
    missing_edges += verdict.agreement.false_negatives();
  }

  std::size_t frames() const { return nanoseconds.size(); }
  run::Spread spread() const { return *run::spread(nanoseconds); }
  double smallest_validity() const
  {
    return *std::min_element(validities.begin(), validities.end());
  }

  double mean_validity() const
  {
    return std::accumulate(validities.begin(), validities.end(), 0.0) /
           static_cast<double>(validities.size());
  }
};

struct Case_record
{
  std::string motion;
  std::size_t points;
  std::vector<Peer_record> peers; // this package's exact one first

  // How many times longer than this package's exact update a peer takes.
  double ratio(const Peer_record& peer) const
  {
    return peer.spread().median / peers.front().spread().median;
  }

  // Where the middle halves of both overlap nobody wins.
  const char* result(const Peer_record& peer) const
  {
    const run::Spread ours = peers.front().spread(), theirs = peer.spread();
    return ours.high_quartile < theirs.low_quartile   ? "win"
           : theirs.high_quartile < ours.low_quartile ? "loss"
                                                      : "even";
  }
};

} // namespace peers

#endif // PEERS_PEER_RECORD_H
