// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RUN_RECORDING_H
#define SCENARIO_RUNNER_RUN_RECORDING_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Packed_bytes.h"
#include "scenario_runner/Pictures.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace run {

// What the player shows of a run: points, sets, edges and triangles of each frame, most of them as
// changes since the frame before. Positions are rounded to multiples of a quantum, which is the
// longer side of what is drawn, divided by 2^20. Edges, triangles and sets are those of the run.
// bindings/web/player/recording.js reads it, and says how it is written.
//
// A point has a number from the frame in which it comes to the one in which it goes. In periodic
// space it is followed: of its images the one that is nearest to that of the frame before is taken,
// so that neither its way nor its edges change because it leaves the cell.
class Run_recording
{
public:
  static constexpr double steps_of_longer_side = 1 << 20;

  void add(const Run_view& run);

  // One JSON object, in which no letter ends a script. `method`: what kept the triangulation.
  void write(std::ostream& out, const std::string& name, const std::string& method) const;

private:
  using Number = std::uint32_t;
  using Shift = scenario::Shift;

  // Both ends, and the shift of the second one.
  using Edge = std::array<std::int64_t, 4>;
  // The corners, and the shifts of the second and the third one, where the first one is.
  using Triangle = std::array<std::int64_t, 7>;

  struct Followed_point
  {
    std::int64_t id;
    scenario::Point position;
    Vertex_set set;
    bool is_there;
  };

  struct Frame_positions
  {
    std::vector<Number> numbers; // ascending
    std::vector<scenario::Point> points;
  };

  // The numbers and shifts of the points of a frame, by their places.
  struct Places
  {
    std::vector<Number> numbers;
    std::vector<Shift> shifts; // from the point to the image that is followed
  };

  Places follow(const scenario::Motion& motion);
  void remove_gone(const std::vector<std::int64_t>& ids);
  Shift shift_of(const scenario::Motion& motion, std::size_t place, const Followed_point* before);
  void add_positions(const scenario::Motion& motion, const Places& places);
  void add_speed(const std::vector<double>& squared_distances, double time);
  void add_sets(const std::vector<Vertex_set>& sets, const Places& places);
  void add_edges(const std::vector<Shown_edge>& edges, const Places& places);
  void add_triangles(const std::vector<Shown_triangle>& triangles, const Places& places);
  void take_bounds(const std::vector<scenario::Point>& points);
  double quantum() const;
  std::string packed_positions() const;

  std::vector<Followed_point> m_points; // by number
  std::vector<Number> m_numbers;        // of the ids of the last frame, in their order
  std::vector<std::int64_t> m_ids;
  std::vector<std::string> m_names; // by id, where ids are text
  std::vector<Edge> m_edges;        // of the last frame, ascending
  std::vector<Triangle> m_triangles;
  Packed_bytes m_changes;
  std::vector<Frame_positions> m_positions;
  std::vector<Frame_record> m_records;
  std::vector<std::optional<scenario::Cell>> m_cells;
  std::optional<Bounds> m_bounds;
  double m_speed_scale = 0.0;
};

} // namespace run

#endif // SCENARIO_RUNNER_RUN_RECORDING_H
