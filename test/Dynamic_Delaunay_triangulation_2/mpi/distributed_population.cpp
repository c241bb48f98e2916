// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: points that are inserted and removed by their ids, whatever rank asks.

#include "distributed_oracle.h"

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

using Newcomers = std::vector<std::pair<Id, Point>>;

// The part of a list that this rank gives: it is cut differently for each `salt`.
template <class Value>
std::vector<Value> given_here(const std::vector<Value>& all, std::size_t salt)
{
  std::vector<Value> given;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (int((k * 7 + salt) % std::size_t(number_of_ranks)) == this_rank)
      given.push_back(all[k]);
  return given;
}

void insert(Distributed& dt, Population& population, const Newcomers& all, std::size_t salt)
{
  const Newcomers given = given_here(all, salt);
  dt.insert(given.begin(), given.end());
  population.insert(all.begin(), all.end());
}

void remove(Distributed& dt, Population& population, const std::vector<Id>& all, std::size_t salt)
{
  const std::vector<Id> given = given_here(all, salt);
  dt.remove(given.begin(), given.end());
  for (const Id id : all)
    population.erase(id);
}

void points_come_and_go(double load_factor)
{
  std::mt19937 random(13); // the same on all ranks
  std::uniform_real_distribution<double> coordinate(0, 20);
  std::normal_distribution<double> step(0, 0.05);
  const Newcomers none;
  Distributed dt(MPI_COMM_WORLD, none.begin(), none.end(), load_factor);
  Population population;
  expect_exact(dt, population, "no points");
  Id next = -5; // any numbers are ids
  for (std::size_t frame = 0; frame < 30; ++frame) {
    Newcomers coming;
    for (std::size_t k = 0; k < (frame % 10 == 0 ? 150 : 3); ++k)
      coming.emplace_back(next += 1 + Id(random() % 1000),
                          k % 10 == 9 ? coming.back().second // coincident
                                      : Point(coordinate(random), coordinate(random)));
    insert(dt, population, coming, frame);
    expect_exact(dt, population, "points have come");
    std::vector<Id> going;
    for (const auto& value : population)
      if (random() % (frame % 7 == 0 ? 3 : 30) == 0)
        going.push_back(value.first);
    remove(dt, population, going, frame + 1);
    expect_exact(dt, population, "points have gone");
    for (auto& [id, p] : population)
      p = Point(p.x() + step(random), p.y() + step(random));
    const Points positions = own_positions(dt, population);
    dt.update(positions.begin(), positions.end());
    expect_exact(dt, population, "points have moved");
  }
  std::vector<Id> all;
  for (const auto& value : population)
    all.push_back(value.first);
  remove(dt, population, all, 0);
  expect_exact(dt, population, "all points have gone");
  insert(dt, population, {{7, Point(0, 0)}, {3, Point(1, 0)}, {5, Point(0, 1)}}, 1);
  expect_exact(dt, population, "points after none");
}

template <class Error, class Call>
bool is_refused_everywhere(const Call& call, const std::string& id)
{
  try {
    call();
  } catch (const Error& error) {
    return error.id() == id;
  }
  return false;
}

void bad_ids_are_refused()
{
  const Population points = numbered({{0, 0}, {1, 0}, {0, 1}, {1, 1.5}, {2, 3}, {3, 1}});
  const auto own = own_part(points, in_order);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  const Newcomers known{{4, Point(9, 9)}}, twins{{8, Point(9, 9)}, {8, Point(7, 7)}};
  const std::vector<Id> unknown{2, 6}, repeated{2, 2};
  const auto refuses_to_insert = [&](const Newcomers& all) {
    const Newcomers given = given_here(all, 0);
    return is_refused_everywhere<CGAL::Repeated_id_error_2>(
        [&] { dt.insert(given.begin(), given.end()); }, std::to_string(all.back().first));
  };
  expect(refuses_to_insert(known), "an id that is taken is refused on all ranks");
  expect(refuses_to_insert(twins), "new points with one id are refused on all ranks");
  const std::vector<Id> some_unknown = given_here(unknown, 0),
                        some_repeated = given_here(repeated, 0);
  expect(is_refused_everywhere<CGAL::Unknown_user_id_error_2>(
             [&] { dt.remove(some_unknown.begin(), some_unknown.end()); }, "6"),
         "an id of no point is refused on all ranks");
  expect(is_refused_everywhere<CGAL::Repeated_id_error_2>(
             [&] { dt.remove(some_repeated.begin(), some_repeated.end()); }, "2"),
         "an id that is removed twice is refused on all ranks");
  expect(is_refused_everywhere<CGAL::Repeated_id_error_2>(
             [&] {
               const Newcomers given = given_here(twins, 0);
               Distributed(MPI_COMM_WORLD, given.begin(), given.end());
             },
             "8"),
         "points with one id are refused on all ranks");
  expect_exact(dt, points, "after refusals");
}

int main(int argc, char** argv)
{
  start(argc, argv);
  points_come_and_go(Distributed::default_load_factor);
  points_come_and_go(no_balance);
  bad_ids_are_refused();
  MPI_Finalize();
}
