// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SCALE_RUN_H
#define SCALE_SCALE_RUN_H

#include "../common/Contest.h"
#include "Scale_motion.h"
#include "scenario_runner/Measurement.h"
#include "Threaded_triangulation.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace scale {

// What a number of threads did in the frames of a motion.
struct Series
{
  unsigned threads;
  std::vector<Frame_times> frames{};
};

struct Case_record
{
  std::size_t points;
  std::string motion;
  std::vector<Series> series; // of each number of threads
};

// How many frames are followed before the first timed one, and how many are timed.
struct Frame_numbers
{
  std::size_t warm_up;
  std::size_t timed;
};

// Lets one triangulation for each number of threads follow the same frames, in turn, the order
// rotating. Where memory might not hold all of them, one follows all frames after the other.
template <class Space>
class Scale_run
{
public:
  Scale_run(std::size_t points, std::vector<unsigned> threads)
    : m_points(points)
    , m_threads(std::move(threads))
  {
  }

  Case_record follow(const Motion_kind& kind, const Frame_numbers& frames) const
  {
    return in_groups(kind.name, [&](const Group& group, const std::vector<Series*>& series) {
      Scale_motion motion(m_points);
      for (const auto& triangulation : group) {
        triangulation->build(motion.points());
      }
      for (std::size_t frame = 0; frame != frames.warm_up + frames.timed; ++frame) {
        motion.advance(kind);
        common::in_turn(frame, group.size(), [&](std::size_t i) {
          if (kind.seconds_alone > 0) {
            compute_alone(kind.seconds_alone);
          }
          const Frame_times times = group[i]->update(motion.points(), kind.rebuilds);
          if (frame >= frames.warm_up) {
            series[i]->frames.push_back(times);
          }
        });
      }
      check(group, motion.points());
    });
  }

  Case_record construct(const std::string& name, std::size_t times) const
  {
    return in_groups(name, [&](const Group& group, const std::vector<Series*>& series) {
      const Points points = Scale_motion(m_points).points();
      for (std::size_t round = 0; round != times; ++round) {
        common::in_turn(round, group.size(), [&](std::size_t i) {
          Frame_times frame;
          frame.total = group[i]->build(points);
          series[i]->frames.push_back(frame);
          group[i]->clear();
        });
      }
    });
  }

private:
  using Group = std::vector<std::unique_ptr<Threaded_triangulation<Space>>>;

  static constexpr std::size_t most_side_by_side = 3'000'000;
  static constexpr std::size_t most_to_compare = 200'000;

  template <class Work>
  Case_record in_groups(const std::string& name, const Work& work) const
  {
    Case_record record{m_points, name, {}};
    for (const unsigned threads : m_threads) {
      record.series.push_back({threads});
    }
    Group group;
    std::vector<Series*> series;
    for (Series& one : record.series) {
      group.push_back(std::make_unique<Threaded_triangulation<Space>>(one.threads));
      series.push_back(&one);
      if (m_points > most_side_by_side || &one == &record.series.back()) {
        work(group, series);
        group.clear();
        series.clear();
      }
    }
    return record;
  }

  // Requires triangulations that are equal, bit by bit, and right.
  static void check(const Group& group, const Points& points)
  {
    const auto& first = group.front()->dynamic();
    if (points.size() <= most_to_compare) {
      Space::require_right(first, points);
    }
    for (const auto& other : group) {
      common::require(have_equal_edges(first.frame(), other->dynamic().frame()),
                      "the number of threads has changed the result");
    }
  }

  template <class Frame>
  static bool have_equal_edges(const Frame& first, const Frame& other)
  {
    bool are_equal = first.number_of_edges() == other.number_of_edges();
    for (std::uint32_t i = 0; are_equal && i != first.number_of_edges(); ++i) {
      const auto e = first.edge(typename Frame::Edge_index(i)),
                 f = other.edge(typename Frame::Edge_index(i));
      are_equal =
          e.source == f.source && e.target == f.target && e.left == f.left && e.right == f.right;
    }
    return are_equal;
  }

  std::size_t m_points;
  std::vector<unsigned> m_threads;
};

} // namespace scale

#endif // SCALE_SCALE_RUN_H
