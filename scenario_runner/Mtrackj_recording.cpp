// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Frame_reading.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

namespace {

// A data file is a list: assemblies have clusters, these have tracks, these have points. Each is
// numbered anew in what it belongs to.
class Mtrackj_parser
{
public:
  Mtrackj_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Recording parse()
  {
    std::string_view line;
    if (!m_scanner.next_line(line) || line.substr(0, 7) != "MTrackJ") {
      throw Scenario_error(m_scanner.file(), "does not begin as a data file of MTrackJ", 1);
    }
    while (m_scanner.next_line(line) && line.substr(0, 14) != "End of MTrackJ") {
      read(line);
      line = {};
    }
    if (line.empty()) {
      m_scanner.fail("the file is truncated: End of MTrackJ Data File is missing");
    }
    if (m_rows.empty()) {
      throw Scenario_error(m_scanner.file(), "has no points");
    }
    return recording();
  }

private:
  struct Track
  {
    std::int64_t assembly;
    std::int64_t cluster;
    std::int64_t number;
  };

  void read(std::string_view line)
  {
    split_at_blanks(line, m_fields);
    const std::string_view word = m_fields.front();
    if (word == "Assembly") {
      m_assembly = number("Assembly");
      m_level = 1;
    } else if (m_level == 0) {
      return; // settings of the program
    } else if (word == "Cluster") {
      m_cluster = number("Cluster");
      m_level = 2;
    } else if (word == "Track" && m_level >= 2) {
      m_tracks.push_back({m_assembly, m_cluster, number("Track")});
      m_level = 3;
    } else if (word == "Point" && m_level == 3) {
      read_point();
    } else {
      m_scanner.fail("expected a Cluster, Track or Point where it belongs, found " +
                     in_quotes(line));
    }
  }

  std::int64_t number(const char* what) const
  {
    if (m_fields.size() < 2) {
      m_scanner.fail(std::string(what) + " has no number");
    }
    return m_scanner.integer(m_fields[1], std::string(what) + " number");
  }

  // Point, its number, x, y, z, the frame, and the channel. Rows know the place of their track.
  void read_point()
  {
    constexpr std::size_t fields = 7;
    if (m_fields.size() != fields) {
      m_scanner.fail("the point has " + std::to_string(m_fields.size()) +
                     " fields, expected Point, its number, x, y, z, t and a channel");
    }
    const auto frame = m_scanner.whole_number(m_fields[5], "t");
    if (!frame) {
      m_scanner.fail("t " + in_quotes(m_fields[5]) + " is not an integer");
    }
    const std::string name = std::to_string(m_tracks.back().number);
    m_rows.add({*frame,
                static_cast<std::int64_t>(m_tracks.size() - 1),
                static_cast<double>(*frame),
                {m_scanner.coordinate(m_fields[2], "x", name),
                 m_scanner.coordinate(m_fields[3], "y", name)},
                0.0, // z counts slices
                m_scanner.line_number()});
  }

  // An id is the number of the track, or, if there are several clusters, those of the cluster and
  // the track, as in 2:1, or of the assembly too.
  Recording recording()
  {
    const bool has_assemblies = differ(&Track::assembly);
    const bool has_names = has_assemblies || differ(&Track::cluster);
    Point_names names;
    const auto name = [&](const Track& track) {
      return (has_assemblies ? std::to_string(track.assembly) + ":" : "") +
             std::to_string(track.cluster) + ":" + std::to_string(track.number);
    };
    m_rows.rename([&](std::int64_t place) {
      const Track& track = m_tracks[static_cast<std::size_t>(place)];
      return has_names ? names.id(name(track)) : track.number;
    });
    Recording frames = m_rows.recording(m_scanner, [&](std::int64_t id) {
      return has_names ? in_quotes(names.name(id)) : std::to_string(id);
    });
    if (has_names) {
      set_names(frames, names);
    }
    return frames;
  }

  bool differ(std::int64_t Track::*number) const
  {
    for (const Track& track : m_tracks) {
      if (track.*number != m_tracks.front().*number) {
        return true;
      }
    }
    return false;
  }

  Text_scanner m_scanner;
  std::vector<std::string_view> m_fields;
  int m_level = 0; // 1 in an assembly, 2 in a cluster, 3 in a track
  std::int64_t m_assembly = 0;
  std::int64_t m_cluster = 0;
  std::vector<Track> m_tracks;
  Recording_rows m_rows;
};

} // namespace

Recording parse_mtrackj(const std::string& file, std::string_view text)
{
  return Mtrackj_parser(file, text).parse();
}

} // namespace scenario
