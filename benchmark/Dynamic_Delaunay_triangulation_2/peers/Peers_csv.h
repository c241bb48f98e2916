// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEERS_CSV_H
#define PEERS_PEERS_CSV_H

#include "../results/Csv_file.h"
#include "Peer_record.h"

#include <string>
#include <vector>

namespace peers {

inline void write_csv(const std::string& path, const std::vector<std::string>& remarks,
                      const std::vector<Case_record>& records)
{
  results::Csv_file file(path, remarks,
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
                     peer.missing_edges, peer.mean_validity(), peer.smallest_validity());
    }
  }
  file.finish();
}

} // namespace peers

#endif // PEERS_PEERS_CSV_H
