// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: which rank owns which points, how the user's data follow them, and what
// ranks send.

#include "distributed_oracle.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

std::uint64_t largest(std::uint64_t count)
{
  std::uint64_t most = 0;
  MPI_Allreduce(&count, &most, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  return most;
}

Population random_points(std::size_t n, std::mt19937& random)
{
  std::uniform_real_distribution<double> coordinate(0, std::sqrt(double(n)));
  Points points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(Point(coordinate(random), coordinate(random)));
  return numbered(points);
}

void move_all(Population& population, std::mt19937& random, double spread)
{
  std::normal_distribution<double> step(0, spread);
  for (auto& [id, p] : population)
    p = Point(p.x() + step(random), p.y() + step(random));
}

void update(Distributed& dt, const Population& population)
{
  const Points next = own_positions(dt, population);
  dt.update(next.begin(), next.end());
}

// What the user knows of a point, its id here, follows it wherever it goes.
void expect_data_follow(Distributed& dt, const std::vector<Id>& before, const std::string& what)
{
  expect(dt.carry(before) == dt.owned_ids(), what + ": data follow their points");
}

void points_of_one_rank_are_spread()
{
  std::mt19937 random(5);
  const Population population = random_points(2000, random);
  const auto own = own_part(population, on_first);
  std::vector<Id> given;
  for (const auto& value : own)
    given.push_back(value.first);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  expect_exact(dt, population, "spread points");
  expect_data_follow(dt, given, "spread points");
  expect(largest(dt.number_of_owned_points()) <=
             2000 / std::uint64_t(number_of_ranks) + 2000 / 64 + 1,
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
  const auto own = own_part(population, in_turn);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
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
  const auto own = own_part(population, in_turn);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end(), no_balance);
  // In turn: every rank holds nearly all points. Then each rank's points are by themselves.
  for (int frame = 0; frame < 30; ++frame) {
    if (frame == 0)
      for (auto& [id, p] : population)
        p = Point(p.x() + 100 * double(id % number_of_ranks), p.y());
    update(dt, population);
    expect_exact(dt, population, "ranks apart");
  }
  expect(largest(dt.number_of_ghosts()) < 1000 / 2, "ghosts that are no longer needed are dropped");
}

void mixed_points_are_distributed_anew()
{
  std::mt19937 random(8);
  Population population = random_points(2000, random);
  const auto own = own_part(population, in_order);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  std::size_t distributions = 0;
  std::uniform_real_distribution<double> coordinate(0, 45);
  for (int frame = 0; frame < 48; ++frame) {
    const std::vector<Id> before = dt.owned_ids();
    for (auto& [id, p] : population)
      if (frame >= 12 && random() % 5 == 0)
        p = Point(coordinate(random), coordinate(random));
    update(dt, population);
    expect_exact(dt, population, "mixing");
    if (dt.number_of_distributions() != distributions)
      expect_data_follow(dt, before, "mixing");
    else
      expect(dt.owned_ids() == before, "owned points change only where they are distributed");
    distributions = dt.number_of_distributions();
  }
  expect(number_of_ranks == 1 || distributions > 0, "points that mix are distributed anew");
  dt.distribute();
  expect_exact(dt, population, "distributed by hand");
}

void fast_points_are_not_distributed_in_every_frame()
{
  std::mt19937 random(9);
  Population population = random_points(1000, random);
  const auto own = own_part(population, in_order);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end(), 1);
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
  const std::vector<std::pair<Id, Point>> none;
  bool is_refused = false;
  try {
    Distributed(MPI_COMM_WORLD, none.begin(), none.end(), 0.5);
  } catch (const CGAL::Parameter_error_2& error) {
    is_refused = error.value() == 0.5;
  }
  expect(is_refused, "a load factor below 1 is refused");
}

int main(int argc, char** argv)
{
  start(argc, argv);
  points_of_one_rank_are_spread();
  calm_frames_need_no_questions();
  ghosts_that_went_away_are_dropped();
  mixed_points_are_distributed_anew();
  fast_points_are_not_distributed_in_every_frame();
  bad_load_factors_are_refused();
  MPI_Finalize();
}
