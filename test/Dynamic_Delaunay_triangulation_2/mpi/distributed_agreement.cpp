// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks, which do not do the same: they call different functions, or give different
// arguments where all have to give the same. All of them are told, and none waits forever: that
// would be a timeout of the test. Afterwards everything is as before.

#include "distributed_periodic_oracle.h"
#include "distributed_theme.h"
#include "distributed_uses.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_edge_changes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_periodic_edge_changes_2.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace distributed_agreement {

const Cell unit_cell(8, 8);

Population some_points()
{
  std::mt19937 random(41);
  return numbered(any_points(60, 8, random));
}

void load_factors_that_differ()
{
  const std::string told = "the same on all ranks";
  const double load = differing(no_balance, 1.5), other = differing(1.25, 1.5);
  for (const double factor : {load, other}) {
    expect(
        tells<CGAL::Parameter_error_2>([&] { distributed(some_points(), in_order, factor); }, told),
        "load factors of the plane that differ are refused on all ranks");
    expect(
        tells<CGAL::Parameter_error_2>(
            [&] { distributed<Distributed_periodic>(some_points(), in_order, unit_cell, factor); },
            told),
        "load factors of a torus that differ are refused on all ranks");
  }
}

void cells_that_differ()
{
  const Cell cell = differing(Cell(8, 9), unit_cell);
  const Population points = some_points();
  expect(tells<CGAL::Periodic_cell_error_2>(
             [&] { distributed<Distributed_periodic>(points, in_order, cell); },
             "the same on all ranks"),
         "cells that differ are refused on all ranks");
  auto dt = distributed<Distributed_periodic>(points, in_order, unit_cell);
  expect(tells<CGAL::Periodic_cell_error_2>([&] { update(dt, points, cell); },
                                            "the same on all ranks"),
         "cells of a frame that differ are refused on all ranks");
  expect_exact(dt, points, "after cells that differed");
}

// The last rank calls one function, and all others another one.
template <class Call, class Other>
void expect_different(const Call& of_last, const Other& of_others, const std::string& what)
{
  expect(tells<CGAL::Distributed_input_error_2>(
             [&] {
               if (is_last())
                 of_last();
               else
                 of_others();
             },
             "all ranks must call the same function"),
         what + ": all ranks are told");
}

// `last_update` moves the points as the last rank does it.
template <class Triangulation, class Changes, class Update>
void calls_that_differ(Triangulation& dt, const Population& points, const Update& last_update)
{
  Changes changes;
  const Newcomers more{{1000 + this_rank, Point(1, 1)}};
  const std::vector<Id> gone{0};
  const auto moves = [&] { update(dt, points); };
  const auto inserts = [&] { dt.insert(more.begin(), more.end()); };
  const auto removes = [&] { dt.remove(gone.begin(), gone.end()); };
  expect_different(inserts, moves, "an insertion among updates");
  expect_different(moves, removes, "an update among removals");
  expect_different([&] { last_update(); }, inserts, "a frame among insertions");
  expect_different([&] { dt.distribute(); }, moves, "a distribution among updates");
  expect_different([&] { dt.certify(); }, [&] { dt.is_valid(); }, "certify() and is_valid()");
  expect_different([&] { changes.compute(dt); }, moves, "edge changes among updates");
  expect_different([&] { dt.read_checkpoint("x"); }, [&] { dt.write_checkpoint("x"); },
                   "reading and writing");
  const std::size_t due = own_part(points, in_order).size();
  expect_different([&] { dt.carry(std::vector<float>(due)); },
                   [&] { dt.carry(std::vector<double>(due)); }, "data of different sizes");
  expect_exact(dt, points, "after calls that differed");
  moves();
  expect_exact(dt, points, "a frame after calls that differed");
}

void calls_that_differ()
{
  const Population points = some_points();
  auto plane = distributed(points, in_order);
  calls_that_differ<Distributed, CGAL::Distributed_edge_changes_2>(plane, points,
                                                                   [&] { update(plane, points); });
  auto torus = distributed<Distributed_periodic>(points, in_order, unit_cell);
  calls_that_differ<Distributed_periodic, CGAL::Distributed_periodic_edge_changes_2>(
      torus, points, [&] { update(torus, points, unit_cell); });
  expect_different([&] { update(torus, points, unit_cell); }, [&] { update(torus, points); },
                   "a cell on one rank only");
  expect_different([&] { distributed<Distributed_periodic>(points, in_order, unit_cell); },
                   [&] { distributed(points, in_order); }, "a torus on one rank only");
}

// Data right after construction, and after a checkpoint was read, follow their points.
template <class Triangulation, class... Arguments>
void data_follow_from_the_start(const std::string& what, const Arguments&... arguments)
{
  const Population points = some_points();
  std::vector<Id> given;
  for (const auto& value : own_part(points, in_turn))
    given.push_back(value.first);
  auto dt = distributed<Triangulation>(points, in_turn, arguments...);
  expect(dt.carry(given) == dt.owned_ids(), what + ": data follow right after construction");
  const std::string path = file_name("distributed_agreement");
  dt.write_checkpoint(path, dt.owned_ids());
  std::vector<Id> ids;
  dt.read_checkpoint(path, ids);
  expect(ids == dt.owned_ids(), what + ": data are read with their points");
  expect(dt.carry(ids) == dt.owned_ids(), what + ": data that were read stay with their points");
  dt.distribute();
  expect(dt.carry(ids) == dt.owned_ids(), what + ": data follow a distribution");
  MPI_Barrier(MPI_COMM_WORLD);
  if (this_rank == 0)
    std::remove(path.c_str());
}

void messages_say_what_ranks_mean()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Population points = some_points();
  auto dt = distributed(points, in_order);
  const auto moves_to = [&](const Points& next) {
    return [&dt, next] { dt.update(next.begin(), next.end()); };
  };
  Points next = own_positions(dt, points);
  next[3] = Point(nan, 0);
  expect(tells<CGAL::Non_finite_coordinate_error_2>(moves_to(next), "the point at place 3 has"),
         "a place is no id");
  next.pop_back();
  next[3] = Point(0, 0);
  expect(tells<CGAL::Point_count_error_2>(moves_to(next), "for each point that this rank owns"),
         "positions are due for own points");
  expect(tells<CGAL::Point_count_error_2>([&] { dt.carry(std::vector<int>(1000)); },
                                          "owned before the last distribution"),
         "data are due for the points before");
  const std::vector<Id> unknown(this_rank == 0 ? 1 : 0, 77777);
  expect(is_refused<CGAL::Unknown_user_id_error_2>(
             [&] { dt.remove(unknown.begin(), unknown.end()); },
             [](const auto& error) {
               return std::string(error.what()) == "there is no point with id 77777";
             }),
         "an id of no point");
  expect(tells<CGAL::Periodic_cell_error_2>(
             [&] { distributed<Distributed_periodic>(points, in_order, Cell(1, 1e-14)); },
             "it is so thin"),
         "a thin cell is called thin");
  auto torus = distributed<Distributed_periodic>(points, in_order, unit_cell);
  Points far = own_positions(torus, points);
  far[2] = Point(1e9, 0);
  expect(tells<CGAL::Periodic_range_error_2>([&] { torus.update(far.begin(), far.end()); },
                                             "the point at place 2 has"),
         "a place of a torus is no id");
  expect(is_refused<CGAL::Precondition_exception>([&] { dt.point(77777); }) &&
             is_refused<CGAL::Precondition_exception>([&] { torus.point(77777); }) &&
             is_refused<CGAL::Precondition_exception>([&] { dt.held_id(77777); }),
         "points that are not held have no position");
  expect_exact(dt, points, "after refusals");
}

void run_theme()
{
  data_follow_from_the_start<Distributed>("plane");
  data_follow_from_the_start<Distributed>("plane, no balance", no_balance);
  data_follow_from_the_start<Distributed_periodic>("torus", unit_cell);
  data_follow_from_the_start<Distributed_periodic>("torus, no balance", unit_cell, no_balance);
  messages_say_what_ranks_mean();
  if (number_of_ranks == 1)
    return;
  load_factors_that_differ();
  cells_that_differ();
  calls_that_differ();
}

const Theme theme("distributed_agreement", run_theme);

} // namespace distributed_agreement
