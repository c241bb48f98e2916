// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: which rank owns which points, how the user's data follow them, and what
// ranks send.

#include "distributed_theme.h"
#include "distributed_uses.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

namespace distributed_distribution {

Population random_points(std::size_t n, std::mt19937& random)
{
  return numbered(any_points(n, std::sqrt(double(n)), random));
}

void points_of_one_rank_are_spread()
{
  std::mt19937 random(5);
  const Population population = random_points(2000, random);
  std::vector<Id> given;
  for (const auto& value : own_part(population, on_first))
    given.push_back(value.first);
  auto dt = distributed(population, on_first);
  expect_exact(dt, population, "spread points");
  expect(dt.carry(given) == dt.owned_ids(), "data follow their points");
  expect(largest(dt.number_of_owned_points()) <= about_equally_many(2000),
         "all ranks own about equally many points");
  for (int frame = 0; frame < 12; ++frame)
    update(dt, population);
  // A compact region of n of them has about 4 sqrt(n) at its boundary.
  const double boundary = 4 * std::sqrt(double(dt.number_of_owned_points()));
  expect(double(dt.number_of_ghosts()) < 8 * boundary, "ghosts are those near the boundary");
}

void calm_frames_need_no_questions()
{
  std::mt19937 random(6);
  Population population = random_points(3000, random);
  auto dt = distributed(population, in_turn);
  update(dt, population);
  const auto rounds = dt.number_of_rounds(), messages = dt.number_of_messages();
  for (int frame = 0; frame < 20; ++frame) {
    move_all(population, random, 0.0001);
    update(dt, population);
    expect_exact(dt, population, "a calm frame");
  }
  expect(dt.number_of_rounds() == rounds, "calm frames need no questions");
  expect(dt.number_of_messages() - messages <= 20 * std::size_t(number_of_ranks - 1),
         "a calm frame sends one message to each neighbor");
}

void ghosts_that_went_away_are_dropped()
{
  std::mt19937 random(7);
  Population population = random_points(1000, random);
  auto dt = distributed(population, in_turn, no_balance);
  // Owned in turn, so every rank holds nearly all points. Frame 0 moves each rank's points apart.
  for (int frame = 0; frame < 30; ++frame) {
    if (frame == 0)
      for (auto& [id, p] : population)
        p = Point(p.x() + 100 * double(id % number_of_ranks), p.y());
    update(dt, population);
    expect_exact(dt, population, "ranks apart");
  }
  expect(largest(dt.number_of_ghosts()) < 1000 / 2, "ghosts that are no longer needed are dropped");
}

void points_that_mix_are_distributed_anew()
{
  std::mt19937 random(8);
  const Population population = random_points(2000, random);
  auto dt = distributed(population, in_order);
  std::uniform_real_distribution<double> coordinate(0, 45);
  mixed_points_are_distributed_anew(dt, population, {12, 1, 2}, [&](std::mt19937& any) {
    return Point(coordinate(any), coordinate(any));
  });
}

void fast_points_are_not_distributed_in_every_frame()
{
  std::mt19937 random(9);
  Population population = random_points(1000, random);
  auto dt = distributed(population, in_order, 1);
  for (int frame = 0; frame < 40; ++frame) {
    for (auto& [id, p] : population)
      p = Point(1.05 * p.x(), 1.05 * p.y());
    update(dt, population);
  }
  expect_exact(dt, population, "fast points");
  expect(dt.number_of_distributions() <= 2, "fast points are seldom distributed");
}

void bad_load_factors_are_refused()
{
  expect(is_refused<CGAL::Parameter_error_2>(
             [] { distributed({}, in_order, 0.5); },
             [](const CGAL::Parameter_error_2& error) { return error.value() == 0.5; }),
         "a load factor below 1 is refused");
}

void run_theme()
{
  points_of_one_rank_are_spread();
  calm_frames_need_no_questions();
  ghosts_that_went_away_are_dropped();
  points_that_mix_are_distributed_anew();
  fast_points_are_not_distributed_in_every_frame();
  bad_load_factors_are_refused();
}

const Theme theme("distributed_distribution", run_theme);

} // namespace distributed_distribution
