// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks in a periodic cell: the edges that come and go are those that the visitor of
// one process lists, called by the same shifts.

#include "distributed_periodic_oracle.h"
#include "distributed_theme.h"
#include "distributed_uses.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_periodic_edge_changes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_visitor_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace distributed_periodic_edge_changes {

using Changes = CGAL::Distributed_periodic_edge_changes_2;
using Visitor = CGAL::Periodic_edge_changes_visitor_2;
using Watched = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                                CGAL::With_visitor_2<Visitor>>;

constexpr double length = 20;

// On rank 0 the edges that all ranks list, ascending.
Periodic_edges told(const std::vector<Changes::Edge>& own)
{
  Periodic_edges edges;
  for (const Changes::Edge& e : gathered_data(own))
    edges.emplace_back(e.i, e.j, e.shift);
  std::sort(edges.begin(), edges.end());
  return edges;
}

Periodic_edges of_one_process(const std::vector<Visitor::Edge>& listed)
{
  Periodic_edges edges;
  for (const Visitor::Edge& e : listed)
    edges.emplace_back(Id(e.i), Id(e.j), e.shift);
  return edges;
}

void expect_changes(const Changes& changes, const Periodic_edges& created,
                    const Periodic_edges& removed, const std::string& what)
{
  const Periodic_edges come = told(changes.created_edges()), gone = told(changes.removed_edges());
  if (this_rank > 0)
    return;
  expect(come == created, what + ": the created edges");
  expect(gone == removed, what + ": the removed edges");
}

// Moves all points frame by frame, as `run_periodic()` does, next to one process. No four images
// may be on an empty circle. Each third frame points are distributed anew.
template <class Move, class Deform>
void expect_those_of_one_process(const std::string& what, const Points& points, int frames,
                                 double load_factor, const Deform& deform, const Move& move)
{
  Population population = numbered(points);
  auto dt = distributed<Distributed_periodic>(population, in_turn, deform(0), load_factor);
  std::optional<Watched> one; // on rank 0
  const auto positions = [&] {
    Points all;
    for (const auto& [id, p] : triangulated(dt, population, what))
      all.push_back(p);
    return all;
  };
  const auto compare = [&](Changes& changes, const std::string& when) {
    changes.compute(dt);
    expect_changes(changes, one ? of_one_process(one->visitor().created_edges()) : Periodic_edges(),
                   one ? of_one_process(one->visitor().removed_edges()) : Periodic_edges(), when);
  };
  Changes changes;
  const Points first = positions();
  if (this_rank == 0)
    one.emplace(first, dt.cell());
  compare(changes, what + ", at the start");
  std::uint64_t renewed = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    for (auto& [id, p] : population)
      p = move(std::size_t(id), p, frame);
    update(dt, population, deform(frame));
    if (frame % 3 == 0)
      dt.distribute();
    const Points all = positions();
    if (one) {
      one->visitor().clear();
      one->update(all, dt.cell());
    }
    compare(changes, what + ", frame " + std::to_string(frame));
    renewed += changes.created_edges().size();
  }
  expect(sum(renewed) > 0, what + ": edges come");
}

// Moves points to other images of themselves, or removes them and inserts them on another rank.
void no_edge_changes_where_images_do_not(const Points& points)
{
  Population population = numbered(points);
  auto dt = distributed<Distributed_periodic>(population, in_order, Cell(length, length));
  Changes changes;
  changes.compute(dt);
  const auto expect_none = [&](const std::string& what) {
    changes.compute(dt);
    expect_changes(changes, {}, {}, what);
  };
  expect_none("nothing has happened");
  for (auto& [id, p] : population)
    p = Point(p.x() + length * double(id % 7 - 3), p.y() + length * double(id % 5 - 2));
  update(dt, population);
  expect_none("points are wrapped");
  for (const Cell& other : {Cell(length, 0, length, length), Cell(0, length, -length, 0),
                            Cell(2 * length, length, length, length)}) {
    update(dt, population, other);
    expect_none("other vectors of the same lattice");
  }
  dt.distribute();
  expect_none("points have other owners");
  Newcomers back;
  for (const Id id : {3, 4, 5})
    back.emplace_back(id, Point(population.at(id).x() - 2 * length, population.at(id).y()));
  remove(dt, population, {3, 4, 5}, 0);
  insert(dt, population, back, 1);
  expect_none("points have gone, and come back by other images");
}

// Points on a grid, many of them twice. The expected changes are differences of sets of all edges.
void changes_of_a_population(const Points& points)
{
  Population population = numbered(points);
  auto dt = distributed<Distributed_periodic>(population, in_turn, Cell(8, 8));
  Changes changes;
  Periodic_edges edges; // on rank 0
  Id next = 1000;
  for (int frame = 0; frame < 8; ++frame) {
    changes.compute(dt);
    const std::string what = "a grid, frame " + std::to_string(frame);
    const Population all = triangulated(dt, population, what);
    Periodic_edges now;
    if (this_rank == 0)
      now = One_process(all, dt.cell()).edges();
    expect_changes(changes, difference(now, edges), difference(edges, now), what);
    edges = now;
    remove(dt, population, {population.begin()->first, std::next(population.begin())->first}, 0);
    insert(dt, population, {{next++, Point(frame, 2.5)}}, 1);
  }
}

void run_theme()
{
  std::mt19937 random(11); // the same on all ranks
  std::uniform_real_distribution<double> coordinate(0, length);
  std::normal_distribution<double> step(0, 1);
  const Points cloud = any_points(200, length, random), few = any_points(3, length, random);
  Points grid;
  for (int i = 0; i < 100; ++i)
    grid.push_back(Point(7 * i % 8, i / 8 % 8));
  const auto wrapped = [](double x) { return x - length * std::floor(x / length); };
  const auto at_first = always(Cell(length, length));
  const auto brownian_in_cell = [&](double spread) {
    return [&, spread](std::size_t, const Point& p, int) {
      return Point(wrapped(p.x() + spread * step(random)), wrapped(p.y() + spread * step(random)));
    };
  };
  for (const double load_factor : {no_balance, Distributed_periodic::default_load_factor}) {
    expect_those_of_one_process("Brownian motion, wrapped", cloud, 12, load_factor, at_first,
                                brownian_in_cell(0.2));
    expect_those_of_one_process("three points", few, 20, load_factor, at_first,
                                brownian_in_cell(2));
    expect_those_of_one_process("a stream that is not wrapped", cloud, 12, load_factor, at_first,
                                [&](std::size_t i, const Point& p, int) {
                                  return Point(p.x() + 3 + 0.01 * double(i % 9),
                                               p.y() + 0.1 * p.x());
                                });
    expect_those_of_one_process(
        "jumps", cloud, 12, load_factor, at_first, [&](std::size_t, const Point& p, int) {
          return random() % 20 ? p : Point(coordinate(random), coordinate(random));
        });
    expect_those_of_one_process(
        "shear, with cells that are flipped", cloud, 24, load_factor,
        [](int frame) {
          const double shear = 0.07 * frame;
          return Cell(length, 0, length * (shear - std::round(shear)), length);
        },
        [&](std::size_t, const Point& p, int) {
          return Point(wrapped(p.x() + 0.07 * p.y() + 0.02 * step(random)),
                       p.y() + 0.02 * step(random));
        });
    expect_those_of_one_process(
        "shear past the short vectors, and growth", cloud, 24, load_factor,
        [](int frame) {
          const double s = length * std::pow(1.02, frame);
          return Cell(s, 0, 0.1 * frame * s, s);
        },
        [&](std::size_t, const Point& p, int) {
          return Point(1.02 * (p.x() + 0.1 * p.y()), 1.02 * p.y());
        });
  }
  no_edge_changes_where_images_do_not(cloud);
  changes_of_a_population(grid);
}

const Theme theme("distributed_periodic_edge_changes", run_theme);

} // namespace distributed_periodic_edge_changes
