// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEERS_TABLE_H
#define PEERS_PEERS_TABLE_H

#include "Peer_record.h"
#include "scenario_runner/Number_text.h"

#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace peers {

// For people: a block for each case, a line for each peer, and the score.
class Peers_table
{
public:
  explicit Peers_table(std::ostream& out)
    : m_out(out)
  {
  }

  void write(const std::vector<Case_record>& records)
  {
    for (const Case_record& record : records) {
      write_head(record);
      for (const Peer_record& peer : record.peers) {
        write_row(record, peer);
      }
      m_out << '\n';
    }
    write_score(records);
  }

private:
  void write_head(const Case_record& record)
  {
    m_out << std::left << std::setw(name_width)
          << record.motion + ", " + std::to_string(record.points) << std::right << std::setw(8)
          << "ns/point" << std::setw(8) << "q1" << std::setw(8) << "q3" << std::setw(9) << "to ours"
          << std::setw(6) << "" << std::setw(8) << "equal" << std::setw(10) << "validity" << '\n';
  }

  void write_row(const Case_record& record, const Peer_record& peer)
  {
    const run::Spread spread = peer.spread();
    const bool is_ours = &peer == &record.peers.front();
    m_out << std::left << std::setw(name_width) << peer.peer << std::right << std::setw(8)
          << run::readable(spread.median) << std::setw(8) << run::readable(spread.low_quartile)
          << std::setw(8) << run::readable(spread.high_quartile) << std::setw(9)
          << run::readable(record.ratio(peer)) << std::setw(6)
          << (is_ours ? "" : record.result(peer)) << std::setw(8)
          << std::to_string(peer.equal_frames) + '/' + std::to_string(peer.frames())
          << std::setw(10) << run::readable_validity(peer.mean_validity()) << '\n';
  }

  void write_score(const std::vector<Case_record>& records)
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
    m_out << std::left << std::setw(name_width) << "this package exact against" << std::right;
    write_cells("wins", "even", "losses");
    for (const std::string& name : names) {
      m_out << std::left << std::setw(name_width) << name << std::right;
      write_cells(score[name]["win"], score[name]["even"], score[name]["loss"]);
    }
  }

  template <class Cell>
  void write_cells(Cell wins, Cell even, Cell losses)
  {
    m_out << std::setw(8) << wins << std::setw(8) << even << std::setw(8) << losses << '\n';
  }

  static constexpr int name_width = 30;

  std::ostream& m_out;
};

} // namespace peers

#endif // PEERS_PEERS_TABLE_H
