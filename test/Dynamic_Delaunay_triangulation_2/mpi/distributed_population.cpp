// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: points that are inserted and removed by their ids, whatever rank asks.

#include "distributed_theme.h"
#include "distributed_uses.h"

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace distributed_population {

void any_points_come_and_go(double load_factor)
{
  std::uniform_real_distribution<double> coordinate(0, 20);
  auto dt = distributed({}, in_order, load_factor);
  points_come_and_go(
      dt, 30,
      [&](std::size_t frame, std::mt19937& random) {
        Points coming;
        for (std::size_t k = 0; k < (frame % 10 == 0 ? 150 : 3); ++k)
          coming.push_back(k % 10 == 9 ? coming.back()
                                       : Point(coordinate(random), coordinate(random)));
        return coming;
      },
      [&](const Population&, const std::string& what) { expect(dt.is_valid(), what + ": valid"); });
}

// True if all ranks throw an error that names the id.
template <class Error, class Call>
bool is_refused_everywhere(const Call& call, const std::string& id)
{
  return is_refused<Error>(call, [&](const Error& error) { return error.id() == id; });
}

void bad_ids_are_refused()
{
  const Population points = numbered({{0, 0}, {1, 0}, {0, 1}, {1, 1.5}, {2, 3}, {3, 1}});
  auto dt = distributed(points, in_order);
  const Newcomers known{{4, Point(9, 9)}}, twins{{8, Point(9, 9)}, {8, Point(7, 7)}};
  const std::vector<Id> unknown{2, 6}, repeated{2, 2};
  const auto refuses_to_insert = [&](const Newcomers& all) {
    const Newcomers given = given_here(all);
    return is_refused_everywhere<CGAL::Repeated_id_error_2>(
        [&] { dt.insert(given.begin(), given.end()); }, std::to_string(all.back().first));
  };
  expect(refuses_to_insert(known), "an id that is taken is refused on all ranks");
  expect(refuses_to_insert(twins), "new points with one id are refused on all ranks");
  const std::vector<Id> some_unknown = given_here(unknown), some_repeated = given_here(repeated);
  expect(is_refused_everywhere<CGAL::Unknown_user_id_error_2>(
             [&] { dt.remove(some_unknown.begin(), some_unknown.end()); }, "6"),
         "an id of no point is refused on all ranks");
  expect(is_refused_everywhere<CGAL::Repeated_id_error_2>(
             [&] { dt.remove(some_repeated.begin(), some_repeated.end()); }, "2"),
         "an id that is removed twice is refused on all ranks");
  expect(is_refused_everywhere<CGAL::Repeated_id_error_2>(
             [&] {
               const Newcomers given = given_here(twins);
               Distributed(MPI_COMM_WORLD, given.begin(), given.end());
             },
             "8"),
         "points with one id are refused on all ranks");
  expect_exact(dt, points, "after refusals");
}

void run_theme()
{
  any_points_come_and_go(Distributed::default_load_factor);
  any_points_come_and_go(no_balance);
  bad_ids_are_refused();
}

const Theme theme("distributed_population", run_theme);

} // namespace distributed_population
