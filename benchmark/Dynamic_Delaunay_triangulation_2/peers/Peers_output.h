// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEERS_OUTPUT_H
#define PEERS_PEERS_OUTPUT_H

#include "../common/Csv_file.h"
#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Peers_run.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Run_report.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace peers {

inline void write_csv(const std::string& path, const std::vector<std::string>& remarks,
                      const std::vector<Case_record>& records)
{
  common::Csv_file file(path, remarks,
                        {"motion", "points", "peer", "frames", "ns_per_point", "q1", "q3",
                         "times_ours", "result", "equal_frames", "wrong_edges", "missing_edges",
                         "validity_mean", "validity_min"});
  for (const Case_record& record : records) {
    for (const Peer_record& peer : record.peers) {
      const run::Spread spread = peer.spread();
      const bool is_ours = &peer == &record.peers.front();
      file.write_row(record.motion, record.points, peer.peer, peer.frames(), spread.median,
                     spread.low_quartile, spread.high_quartile, record.ratio(peer),
                     is_ours ? "-" : record.result(peer), peer.equal_frames, peer.wrong_edges,
                     peer.missing_edges, common::mean(peer.validities),
                     *std::min_element(peer.validities.begin(), peer.validities.end()));
    }
  }
  file.finish();
}

// Wins, even cases and losses of this package's exact update against each peer.
inline void write_score(std::ostream& out, int name_width, const std::vector<Case_record>& records)
{
  std::vector<std::string> names;
  std::map<std::string, std::map<std::string, std::size_t>> score;
  for (const Case_record& record : records) {
    for (std::size_t i = 1; i < record.peers.size(); ++i) {
      const Peer_record& peer = record.peers[i];
      if (score.count(peer.peer) == 0) {
        names.push_back(peer.peer);
      }
      ++score[peer.peer][record.result(peer)];
    }
  }
  common::Table table(out, name_width, {{"wins", 8}, {"even", 8}, {"losses", 8}});
  table.write_head("this package exact against");
  for (const std::string& name : names) {
    table.write_row(name, score[name]["win"], score[name]["even"], score[name]["loss"]);
  }
}

// For people: a block for each case, a line for each peer, and the score.
inline void write_tables(std::ostream& out, const std::vector<Case_record>& records)
{
  constexpr int name_width = 30;
  common::Table table(out, name_width,
                      {{"ns/point", 8},
                       {"q1", 8},
                       {"q3", 8},
                       {"to ours", 9},
                       {"", 6},
                       {"equal", 8},
                       {"validity", 10}});
  for (const Case_record& record : records) {
    table.write_head(record.motion + ", " + std::to_string(record.points));
    for (const Peer_record& peer : record.peers) {
      const run::Spread spread = peer.spread();
      const bool is_ours = &peer == &record.peers.front();
      table.write_row(peer.peer, run::readable(spread.median), run::readable(spread.low_quartile),
                      run::readable(spread.high_quartile), run::readable(record.ratio(peer)),
                      is_ours ? "" : record.result(peer),
                      std::to_string(peer.equal_frames) + '/' + std::to_string(peer.frames()),
                      run::readable_validity(common::mean(peer.validities)));
    }
    out << '\n';
  }
  write_score(out, name_width, records);
}

} // namespace peers

#endif // PEERS_PEERS_OUTPUT_H
