// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: neighbor lists, measures of Voronoi cells and changes of edges are those of
// one process; validity and certificates.

#include "distributed_oracle.h"
#include "distributed_theme.h"
#include "distributed_uses.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_edge_changes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace distributed_queries {

void expect_neighbors(const Distributed& dt, const Population& population, const std::string& what)
{
  CGAL::Distributed_neighbor_lists_2 lists;
  lists.compute(dt);
  std::map<Id, std::vector<Id>> expected, duplicates;
  for (const auto& [i, j] : expected_edges(population)) {
    expected[i].push_back(j);
    expected[j].push_back(i);
  }
  std::map<Point, Id> labels;
  for (const auto& [id, p] : population) {
    const auto [label, is_new] = labels.emplace(p, id);
    if (!is_new) {
      duplicates[label->second].push_back(id);
      duplicates[id].push_back(label->second);
    }
  }
  const std::vector<Id> ids = dt.owned_ids();
  for (std::size_t k = 0; k < ids.size(); ++k) {
    std::vector<Id>& list = expected[ids[k]];
    std::sort(list.begin(), list.end());
    list.insert(list.end(), duplicates[ids[k]].begin(), duplicates[ids[k]].end());
    const auto own = lists.neighbors(k);
    expect(std::equal(own.begin(), own.end(), list.begin(), list.end()),
           what + ": the neighbors of point " + std::to_string(ids[k]));
  }
}

void expect_measures(const Distributed& dt, const Population& population, const std::string& what)
{
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> all;
  std::map<Id, std::size_t> places;
  for (const auto& [id, p] : population)
    places[id] = all.insert(p);
  CGAL::Voronoi_cell_measures_2 expected, own;
  expected.compute(all);
  own.compute(dt.held_triangulation());
  for (const Id id : dt.owned_ids()) {
    const double area = own.areas()[dt.held_id(id)], wanted = expected.areas()[places[id]];
    expect(area == wanted || std::abs(area - wanted) < 1e-9 * (1 + std::abs(wanted)),
           what + ": the area of the cell of point " + std::to_string(id));
  }
}

void expect_changes(const CGAL::Distributed_edge_changes_2& changes, Edges& edges,
                    const Population& population, const std::string& what)
{
  const Edges created = gathered(changes.created_edges()),
              removed = gathered(changes.removed_edges());
  if (this_rank > 0)
    return;
  const Edges now = expected_edges(population);
  expect(created == difference(now, edges), what + ": the created edges");
  expect(removed == difference(edges, now), what + ": the removed edges");
  edges = now;
}

void expect_queries(const std::string& what, const Points& points, double spread, int frames)
{
  std::mt19937 random(17); // the same on all ranks
  std::normal_distribution<double> step(0, 1);
  Population population = numbered(points);
  auto dt = distributed(population, in_turn, 1.1);
  CGAL::Distributed_edge_changes_2 changes;
  Edges edges;
  for (int frame = 0; frame < frames; ++frame) {
    changes.compute(dt);
    expect_changes(changes, edges, population, what);
    expect_neighbors(dt, population, what);
    expect_measures(dt, population, what);
    expect(dt.is_valid(), what + ": valid");
    if (frame % 4 == 1)
      dt.distribute();
    if (frame % 4 == 2) { // a point is removed by one rank, and comes back by another
      const Newcomers back{{frame, population.at(frame)}};
      remove(dt, population, {frame}, 0);
      insert(dt, population, back, 1);
    }
    for (auto& [id, p] : population)
      p = Point(p.x() + spread * step(random), p.y() + spread * step(random));
    update(dt, population);
  }
  expect(dt.certify(), what + ": certified without trust in zones");
  expect_exact(dt, population, what + ", certified anew");
}

void run_theme()
{
  std::mt19937 random(19); // the same on all ranks
  const Points cloud = any_points(400, 20, random);
  Points grid, line;
  for (int i = 0; i < 400; ++i) {
    grid.push_back(Point(7 * i % 20, i / 40)); // each of them twice
    line.push_back(Point(i % 40, 2 * (i % 40)));
  }
  expect_queries("a cloud", cloud, 0.1, 12);
  expect_queries("a grid", grid, 0, 4);
  expect_queries("a line", Points(line.begin(), line.begin() + 60), 0, 4);
  expect_queries("few points", Points(cloud.begin(), cloud.begin() + 4), 0.1, 4);
}

const Theme theme("distributed_queries", run_theme);

} // namespace distributed_queries
