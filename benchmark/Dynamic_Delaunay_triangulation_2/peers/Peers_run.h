// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEERS_RUN_H
#define PEERS_PEERS_RUN_H

#include "../common/Contest.h"
#include "Boost_polygon_peer.h"
#include "Cgal_peer.h"
#include "Delaunator_peer.h"
#include "Dynamic_peer.h"
#include "Grid_motion.h"
#include "Peer.h"
#include "Peer_cases.h"
#include "Peer_output.h"
#include "Qhull_peer.h"
#include "scenario_runner/Measurement.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
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

  // None wins where the ranges between the quartiles overlap.
  const char* result(const Peer_record& peer) const
  {
    const run::Spread ours = peers.front().spread(), theirs = peer.spread();
    return ours.high_quartile < theirs.low_quartile   ? "win"
           : theirs.high_quartile < ours.low_quartile ? "loss"
                                                      : "even";
  }
};

// Lets all peers triangulate the frames of cases, in turn, and compares what comes out.
class Peers_run
{
public:
  using Progress = std::function<void(std::size_t work)>;

  // `delaunator` may be missing.
  Peers_run(std::shared_ptr<Delaunator_peer> delaunator, Progress progress)
    : m_delaunator(std::move(delaunator))
    , m_progress(std::move(progress))
  {
  }

  Case_record run(const Peer_case& wanted)
  {
    Grid_motion motion(wanted.open());
    pass_over(motion, wanted);
    start(wanted, motion.snapped());
    for (std::size_t frame = 0; frame != wanted.warm_up + wanted.frames; ++frame) {
      motion.advance();
      const Grid_points& points = motion.snapped();
      const std::vector<double> times = time_all(points, frame);
      if (frame >= wanted.warm_up) {
        check(points, times);
      }
      report(wanted.points);
    }
    m_peers.clear(); // the next case needs the memory
    return {wanted.motion, wanted.points, m_records};
  }

private:
  void pass_over(Grid_motion& motion, const Peer_case& wanted)
  {
    for (std::size_t frame = 0; frame != wanted.passed_over; ++frame) {
      motion.advance();
      report(wanted.passed_over_work(1));
    }
  }

  void start(const Peer_case& wanted, const Grid_points& points)
  {
    m_peers = {std::make_shared<Exact_peer>("this package exact"),
               std::make_shared<Heuristic_peer>("this package heuristic"),
               std::make_shared<Cgal_insertion_peer>(),
               std::make_shared<Cgal_ordered_peer>(!wanted.has_lasting_order),
               std::make_shared<Cgal_move_peer>(),
               std::make_shared<Boost_polygon_peer>(),
               std::make_shared<Qhull_peer>()};
    if (m_delaunator) {
      m_peers.push_back(m_delaunator);
    }
    m_records.clear();
    for (const auto& peer : m_peers) {
      peer->start(points);
      m_records.push_back({peer->name(), peer->promise()});
    }
  }

  // In ns a point.
  std::vector<double> time_all(const Grid_points& points, std::size_t frame)
  {
    std::vector<double> times(m_peers.size());
    common::in_turn(frame, m_peers.size(), [&](std::size_t i) {
      m_peers[i]->prepare(points);
      times[i] = m_peers[i]->triangulate() / static_cast<double>(points.points.size());
    });
    return times;
  }

  void check(const Grid_points& points, const std::vector<double>& times)
  {
    const Frame_truth truth(points.points);
    for (std::size_t i = 0; i != m_peers.size(); ++i) {
      Peer_output output(truth);
      m_peers[i]->write(output);
      const Peer_output::Verdict verdict = output.verdict();
      if (m_peers[i]->promise() == Promise::EXACT && !verdict.is_equal) {
        throw std::runtime_error(m_peers[i]->name() + ": differs from the reference");
      }
      m_records[i].add(times[i], verdict);
    }
  }

  void report(std::size_t work)
  {
    m_work += work;
    m_progress(m_work);
  }

  std::shared_ptr<Delaunator_peer> m_delaunator;
  Progress m_progress;
  std::size_t m_work = 0;
  std::vector<std::shared_ptr<Peer>> m_peers;
  std::vector<Peer_record> m_records;
};

} // namespace peers

#endif // PEERS_PEERS_RUN_H
