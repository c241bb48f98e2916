// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_MOTION_H
#define SCENARIO_RUNNER_MOTION_H

#include "scenario_runner/Cell.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scenario {

// Edges of the maintained triangulation, as pairs of positions in Motion::points().
using Neighbor_edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// What motions in the plane and in space have in common: frames of points with ids. A new motion
// shows its first frame.
class Any_motion
{
public:
  explicit Any_motion(std::string name)
    : m_name(std::move(name))
  {
  }
  Any_motion(const Any_motion&) = delete;
  Any_motion& operator=(const Any_motion&) = delete;
  virtual ~Any_motion() = default;

  const std::string& name() const { return m_name; }

  // In ascending order.
  virtual const std::vector<std::int64_t>& ids() const = 0;
  virtual double time() const = 0;

  // The number that a recording has for the frame. Numbers ascend; without them frames are counted
  // from 0 on.
  virtual std::optional<std::int64_t> frame_number() const { return std::nullopt; }

  // What a recording calls the points, by their ids; null if it calls them by numbers. The same in
  // all frames.
  virtual const std::vector<std::string>* names() const { return nullptr; }

  // What the user calls the point in this place.
  std::string id_text(std::size_t place) const
  {
    const std::int64_t id = ids()[place];
    return names() ? (*names())[static_cast<std::size_t>(id)] : std::to_string(id);
  }

  // Goes to the next frame. False, and nothing changes, when there is none.
  virtual bool advance(const Neighbor_edges& neighbors) = 0;

  // Whether all frames have the same ids.
  virtual bool has_fixed_population() const { return true; }

  // Whether the last advance() changed which ids there are.
  virtual bool population_changed() const { return false; }

  // How many frames follow the first one: the usual length of a simulation, all that a recording
  // has.
  virtual std::size_t frames() const = 0;

  // Whether advance() looks at the edges; if not, it may be given none.
  virtual bool uses_neighbors() const { return false; }

  // Time steps, in the unit of scenario files. A recording has none.
  virtual std::optional<double> time_step() const { return std::nullopt; }
  virtual std::optional<double> largest_stable_time_step() const { return std::nullopt; }

private:
  std::string m_name;
};

// Points that move in the plane.
class Motion : public Any_motion
{
public:
  using Any_motion::Any_motion;

  // In the order of ids().
  virtual const std::vector<Point>& points() const = 0;

  // The cell of the frame; none where space is not periodic. Either all frames have a cell of one
  // kind, or none has one. Points need not lie in it: each stands for all its images.
  virtual std::optional<Cell> cell() const { return std::nullopt; }
};

} // namespace scenario

#endif // SCENARIO_RUNNER_MOTION_H
