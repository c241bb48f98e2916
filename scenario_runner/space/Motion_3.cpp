// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Motion_3.h"

#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace scenario {

namespace {

// The numbers of the sides that are periodic, in words.
std::string periodic_sides_text(const Cell_3& box)
{
  constexpr std::array<const char*, 3> words = {"first", "second", "third"};
  std::string text;
  for (std::size_t i = 0; i != 3; ++i) {
    if (box.is_periodic[i]) {
      text += std::string(text.empty() ? "" : " and its ") + words[i];
    }
  }
  return text;
}

// Why space cannot be repeated by a box; empty if it can.
std::string flaw_of(const Cell_3& box)
{
  if (!box.is_finite()) {
    return "the sides of whose box are too long for a number";
  }
  if (box.repeats_space()) {
    return "";
  }
  const std::string periodic = "whose box is periodic along its " + periodic_sides_text(box);
  return box.is_wire()   ? periodic + " side, whose length is 0"
         : box.is_slab() ? periodic + " side, which are parallel"
                         : "whose box has no volume";
}

void check_frame(const std::string& file, const Recorded_frame& frame, const std::string& advice)
{
  if (frame.flaw_in_space) {
    throw Scenario_error(file, frame.flaw_in_space->message + advice, frame.flaw_in_space->line);
  }
  if (const std::string flaw = frame.box ? flaw_of(*frame.box) : ""; !flaw.empty()) {
    throw Scenario_error(file, "is in space, and has the frame " + std::to_string(frame.number) +
                                   ", " + flaw + advice);
  }
  const auto wrong = std::find_if(frame.heights.begin(), frame.heights.end(),
                                  [](double z) { return !std::isfinite(z); });
  if (wrong != frame.heights.end()) {
    const std::int64_t id = frame.ids[static_cast<std::size_t>(wrong - frame.heights.begin())];
    const std::string text =
        frame.names ? in_quotes((*frame.names)[static_cast<std::size_t>(id)]) : std::to_string(id);
    throw Scenario_error(file, "is in space, and z of id " + text + " in frame " +
                                   std::to_string(frame.number) + " is no finite number" + advice);
  }
}

} // namespace

bool is_in_space(const Recording& recording)
{
  std::optional<double> first;
  for (const Recorded_frame& frame : recording) {
    for (std::size_t i = 0; i != frame.ids.size(); ++i) {
      const double z = frame.heights.empty() ? 0.0 : frame.heights[i];
      if (std::isfinite(z) && first.value_or(z) != z) {
        return true;
      }
      first = std::isfinite(z) ? z : first;
    }
  }
  return false;
}

void check_in_space(const std::string& file, const Recording& recording, const std::string& choice)
{
  const std::string advice = "; " + choice + " takes x and y alone";
  for (const Recorded_frame& frame : recording) {
    check_frame(file, frame, advice);
    if (frame.box.has_value() != recording.front().box.has_value()) {
      throw Scenario_error(file, "is in space, and the box of some frames is periodic, that of "
                                 "others is not" +
                                     advice);
    }
    if (frame.box && frame.box->is_periodic != recording.front().box->is_periodic) {
      throw Scenario_error(file, "is in space, and the boxes of its frames are periodic along "
                                 "different sides, that of the frame " +
                                     std::to_string(frame.number) + " along its " +
                                     periodic_sides_text(*frame.box) + " side" + advice);
    }
  }
}

Recorded_motion_3::Recorded_motion_3(const std::string& file, const std::string& name,
                                     Recording recording)
  : Played_motion<Motion_3>(name, std::move(recording))
{
  check_in_space(file, all_frames(), "--dimension 2");
  read_points();
}

bool Recorded_motion_3::advance(const Neighbor_edges& neighbors)
{
  const bool is_there = Played_motion<Motion_3>::advance(neighbors);
  if (is_there) {
    read_points();
  }
  return is_there;
}

void Recorded_motion_3::read_points()
{
  m_points.clear();
  for (std::size_t i = 0; i != frame().points.size(); ++i) {
    const auto& [x, y] = frame().points[i];
    m_points.push_back({x, y, frame().heights.empty() ? 0.0 : frame().heights[i]});
  }
}

} // namespace scenario
