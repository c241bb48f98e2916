// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks in a periodic cell: points that come and go, points that are distributed,
// neighbor lists and measures, and checkpoints that other numbers of ranks read.

#include "distributed_periodic_oracle.h"
#include "distributed_theme.h"
#include "distributed_uses.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace distributed_periodic_uses {

const Cell skew_cell(12, 1, 4, 11);

Points random_points(std::size_t n, std::mt19937& random)
{
  std::uniform_real_distribution<double> part(-1, 2);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = part(random), t = part(random);
    points.push_back(Point(12 * s + 4 * t, s + 11 * t));
  }
  return points;
}

// Expects edges between the smallest ids at their places; coincident points list each other last.
void expect_neighbors(const Distributed_periodic& dt, const Population& population,
                      const std::string& what)
{
  CGAL::Distributed_neighbor_lists_2 lists;
  lists.compute(dt);
  expect(lists.shifts().size() == lists.neighbors().size(), what + ": each neighbor has a shift");
  const std::vector<Id> ids = dt.owned_ids();
  const double area = std::abs(dt.cell().ax() * dt.cell().by() - dt.cell().ay() * dt.cell().bx());
  const double scale = std::sqrt(area);
  Periodic_edges own;
  for (std::size_t k = 0; k < ids.size(); ++k)
    for (std::size_t n = lists.offsets()[k]; n < lists.offsets()[k + 1]; ++n) {
      const auto v = dt.vector(ids[k], lists.neighbors()[n], lists.shifts()[n]);
      if (std::sqrt(v.squared_length()) < 1e-9 * scale)
        expect(population.count(lists.neighbors()[n]) > 0, what + ": a duplicate is a point");
      else
        own.emplace_back(ids[k], lists.neighbors()[n], lists.shifts()[n]);
    }
  const Periodic_edges all = gathered(own);
  const Population points = triangulated(dt, population, what);
  if (this_rank > 0)
    return;
  Periodic_edges expected;
  for (const auto& [i, j, shift] : One_process(points, dt.cell()).edges()) {
    expected.emplace_back(i, j, shift);
    expected.emplace_back(j, i, Shift{0, 0} - shift);
  }
  std::sort(expected.begin(), expected.end());
  expect(all == expected, what + ": neighbors are the ends of edges");
}

void expect_duplicates(const Distributed_periodic& dt, const std::vector<Id>& group,
                       const std::string& what)
{
  std::uint64_t told = 0;
  const std::vector<Id> ids = dt.owned_ids();
  dt.for_each_duplicate([&](std::size_t k, Id j, const Shift& shift) {
    const auto v = dt.vector(ids[k], j, shift);
    expect(v.squared_length() == 0, what + ": duplicates are at one place");
    expect((ids[k] == group.front()) != (j == group.front()),
           what + ": the smallest id stands for all");
    ++told;
  });
  expect(sum(told) == 2 * (group.size() - 1), what + ": all duplicates are told");
}

void expect_measures(const Distributed_periodic& dt, const std::string& what)
{
  CGAL::Voronoi_cell_measures_2 measures;
  measures.compute(dt.held_triangulation());
  double own = 0, all = 0;
  for (const Id id : dt.owned_ids())
    own += measures.areas()[dt.held_id(id)];
  MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  expect(std::abs(all - dt.cell().area()) < 1e-9 * all,
         what + ": the Voronoi cells are as large as the cell");
}

void any_points_come_and_go(double load_factor)
{
  auto dt = distributed<Distributed_periodic>({}, in_order, skew_cell, load_factor);
  points_come_and_go(
      dt, 12,
      [](std::size_t frame, std::mt19937& random) {
        Points coming = random_points(frame % 6 == 0 ? 80 : 3, random);
        coming.push_back(Point(coming[0].x() + 12, coming[0].y() + 1));
        return coming;
      },
      [&](const Population& population, const std::string& what) {
        expect_neighbors(dt, population, what);
      });
}

void duplicates_and_measures()
{
  std::mt19937 random(17);
  Population population = numbered(random_points(100, random));
  population[200] = Point(1, 2);
  for (Id k = 1; k <= 5; ++k) // translated by vectors of the lattice, which are integers
    population[200 + k] = Point(1 + 12 * double(k) - 4, 2 + double(k) - 11);
  auto dt = distributed<Distributed_periodic>(population, in_turn, skew_cell);
  expect_exact(dt, population, "duplicates");
  expect_duplicates(dt, {200, 201, 202, 203, 204, 205}, "duplicates");
  remove(dt, population, {201, 202, 203, 204, 205}, 0);
  expect_measures(dt, "measures");
}

void points_that_mix_are_distributed_anew()
{
  std::mt19937 random(8);
  const Population population = numbered(random_points(600, random));
  auto dt = distributed<Distributed_periodic>(population, on_first, skew_cell);
  mixed_points_are_distributed_anew(
      dt, population, {8, 8, 4}, [](std::mt19937& any) { return random_points(1, any).front(); });
}

void calm_frames_need_no_questions()
{
  std::mt19937 random(6);
  std::normal_distribution<double> step(0, 0.00005);
  Population population = numbered(random_points(800, random));
  auto dt = distributed<Distributed_periodic>(population, in_turn, skew_cell);
  const auto shear_by = [&](double shear) {
    for (auto& [id, p] : population)
      p = Point(p.x() + 0.0002 * p.y() + step(random), p.y() + step(random));
    update(dt, population, Cell(12 + shear, 1, 4 + 11 * shear, 11));
  };
  shear_by(0);
  const auto rounds = dt.number_of_rounds();
  for (int frame = 1; frame <= 20; ++frame) {
    shear_by(0.0002 * frame);
    expect_exact(dt, population, "a calm frame");
  }
  expect(dt.number_of_rounds() == rounds, "calm frames of shear need no questions");
}

// Points move with the sheared cell. In each frame they move as far as some are apart, and in a few
// frames by more than a zone's margin.
void zones_follow_shear()
{
  constexpr double length = 40, shear = 0.02;
  std::mt19937 random(33);
  Population population = numbered(any_points(1600, length, random));
  auto dt = distributed<Distributed_periodic>(population, in_turn, Cell(length, length));
  const auto asked_before = dt.number_of_asking_frames();
  constexpr int frames = 40;
  for (int frame = 1; frame <= frames; ++frame) {
    for (auto& [id, p] : population)
      p = Point(p.x() + shear * p.y(), p.y());
    update(dt, population, Cell(length, 0, length * shear * frame, length));
    if (frame % 10 == 0)
      expect_exact(dt, population, "a zone that follows shear");
  }
  const auto asking = dt.number_of_asking_frames() - asked_before;
  expect(4 * asking <= frames, "zones follow shear: " + std::to_string(asking) + " frames asked");
}

void other_ranks_read_checkpoints()
{
  const std::string path = file_name("distributed_periodic_uses");
  std::mt19937 random(23);
  Population population = numbered(random_points(150, random));
  {
    auto dt = distributed<Distributed_periodic>(population, in_turn, Cell(12.1, 1, 4, 10.9));
    dt.write_checkpoint(path); // replaced by the next one
    dt.write_checkpoint(path, dt.owned_points());
  }
  const auto data_of = [](const Distributed_periodic& dt) { return dt.owned_points(); };
  for (int readers = 1; readers <= number_of_ranks; ++readers)
    some_ranks_read<Distributed_periodic>(path, population, readers, data_of, Cell(1, 1));
  auto plane = distributed({}, in_order);
  expect(is_refused<CGAL::Checkpoint_error_2>([&] { plane.read_checkpoint(path); }),
         "the plane refuses points of a periodic cell");
  if (this_rank == 0) {
    std::FILE* const file = std::fopen(path.c_str(), "r+b");
    std::fseek(file, 24 + 4 * 8 + 3, SEEK_SET); // in the cell
    std::fputc(1, file);
    std::fclose(file);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  auto dt = distributed<Distributed_periodic>({}, in_order, Cell(1, 1));
  expect(is_refused<CGAL::Checkpoint_error_2>([&] { dt.read_checkpoint(path); }),
         "another cell is not that which was written");
  MPI_Barrier(MPI_COMM_WORLD);
  if (this_rank == 0)
    std::remove(path.c_str());
}

// Past a strain of the square root of 2 the short vectors of the lattice are found anew, and points
// are distributed anew for them.
void sheared_cells_are_followed_for_long()
{
  std::mt19937 random(31);
  Population population = numbered(random_points(40, random));
  constexpr double loads_do_not_matter = 1000;
  auto dt =
      distributed<Distributed_periodic>(population, in_turn, Cell(11, 11), loads_do_not_matter);
  for (int frame = 1; frame <= 60; ++frame) {
    const double strain = 0.05 * frame;
    for (auto& [id, p] : population)
      p = Point(p.x() + 0.05 * p.y(), p.y());
    const std::vector<Id> before = dt.owned_ids();
    const auto distributions = dt.number_of_distributions();
    update(dt, population, Cell(11, 0, 11 * strain, 11));
    if (dt.number_of_distributions() > distributions)
      expect(dt.carry(before) == dt.owned_ids(), "data follow points into another cell");
    if (strain < 1.6)
      expect(dt.number_of_distributions() == (strain < std::sqrt(2) ? 0 : 1),
             "points are distributed anew where the strain passes 1.41");
    expect_exact(dt, population, "shear at a strain of " + std::to_string(strain));
  }
  expect(dt.number_of_distributions() > 1, "and again");
}

// Positions and cells that have been rounded once are not rounded again.
void points_can_be_given_back()
{
  std::mt19937 random(29);
  const Population population = numbered(random_points(60, random));
  // Rounding the last cell brings it to where the grid is twice as coarse.
  const Cell next_to_a_power_of_2(1 - 0x1p-44 - 0x1p-46, 1 + 0x1p-44);
  for (const Cell& cell : {Cell(0.1, 0.7), Cell(1 / 3.0, 0.1, 7e-3, 3), Cell(1e10 / 3, 1e9 / 7),
                           next_to_a_power_of_2}) {
    auto dt = distributed<Distributed_periodic>(population, in_order, cell, no_balance);
    const Points before = dt.owned_points();
    const Cell cell_before = dt.cell();
    dt.update(before.begin(), before.end(), cell_before);
    expect(dt.cell() == cell_before && dt.owned_points() == before,
           "points and cells that are given back are not rounded again");
  }
}

void run_theme()
{
  any_points_come_and_go(Distributed_periodic::default_load_factor);
  any_points_come_and_go(no_balance);
  duplicates_and_measures();
  points_that_mix_are_distributed_anew();
  calm_frames_need_no_questions();
  zones_follow_shear();
  other_ranks_read_checkpoints();
  sheared_cells_are_followed_for_long();
  points_can_be_given_back();
}

const Theme theme("distributed_periodic_uses", run_theme);

} // namespace distributed_periodic_uses
