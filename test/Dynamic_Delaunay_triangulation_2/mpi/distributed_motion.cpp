// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: the union of their edges is the triangulation of all points, in each frame.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Distributed_dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Distributed = CGAL::Distributed_dynamic_Delaunay_triangulation_2<Kernel>;
using Id = Distributed::Id;
using Points = std::vector<Point>;
using Edges = std::vector<std::pair<Id, Id>>; // ascending

int rank, ranks;

void expect(bool is_so, const std::string& what)
{
  if (is_so)
    return;
  std::fprintf(stderr, "rank %d of %d: not so: %s\n", rank, ranks, what.c_str());
  MPI_Abort(MPI_COMM_WORLD, 1);
}

// All edges on rank 0; nothing elsewhere.
Edges gathered(const Edges& own)
{
  std::vector<Id> flat, all;
  for (const auto& [i, j] : own)
    flat.insert(flat.end(), {i, j});
  const int size = int(flat.size());
  std::vector<int> sizes(std::size_t(ranks), 0), places(std::size_t(ranks), 0);
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  for (std::size_t r = 1; r < places.size(); ++r)
    places[r] = places[r - 1] + sizes[r - 1];
  all.resize(std::size_t(places.back() + sizes.back()));
  MPI_Gatherv(flat.data(), size, MPI_INT64_T, all.data(), sizes.data(), places.data(), MPI_INT64_T,
              0, MPI_COMM_WORLD);
  Edges edges;
  for (std::size_t k = 0; k < all.size(); k += 2)
    edges.emplace_back(all[k], all[k + 1]);
  std::sort(edges.begin(), edges.end());
  return edges;
}

// By CGAL alone. A diagonal of four or more points on one circle is replaced by those that go to
// the smallest id.
Edges expected_edges(const Points& points)
{
  using Base = CGAL::Triangulation_vertex_base_with_info_2<Id, Kernel>;
  CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Base>> dt;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto before = dt.number_of_vertices();
    const auto v = dt.insert(points[i]);
    if (dt.number_of_vertices() > before)
      v->info() = Id(i);
  }
  using Face = decltype(dt.finite_faces_begin()->neighbor(0));
  const auto is_inner = [&](Face f, int i) {
    return !dt.is_infinite(f->neighbor(i)) &&
           dt.side_of_oriented_circle(f, dt.mirror_vertex(f, i)->point(), false) ==
               CGAL::ON_ORIENTED_BOUNDARY;
  };
  std::set<std::pair<Id, Id>> edges;
  std::set<Face> seen;
  const auto note = [&](Id i, Id j) { edges.insert(std::minmax(i, j)); };
  if (dt.dimension() < 2)
    for (auto e = dt.finite_edges_begin(); e != dt.finite_edges_end(); ++e)
      note(e->first->vertex(0)->info(), e->first->vertex(1)->info());
  for (auto f = dt.finite_faces_begin(); dt.dimension() == 2 && f != dt.finite_faces_end(); ++f) {
    std::vector<Face> waiting{Face(f)};
    std::set<Id> corners;
    while (!waiting.empty()) {
      const Face g = waiting.back();
      waiting.pop_back();
      if (!seen.insert(g).second)
        continue;
      for (int i = 0; i < 3; ++i) {
        corners.insert(g->vertex(i)->info());
        if (is_inner(g, i))
          waiting.push_back(g->neighbor(i));
        else
          note(g->vertex(dt.ccw(i))->info(), g->vertex(dt.cw(i))->info());
      }
    }
    for (const Id corner : corners)
      if (corner != *corners.begin())
        note(*corners.begin(), corner);
  }
  return Edges(edges.begin(), edges.end());
}

bool is_own(std::size_t i, std::size_t size, bool to_first)
{
  return to_first ? rank == 0 : int(i * std::size_t(ranks) / size) == rank;
}

std::vector<std::pair<Id, Point>> own_part(const Points& points, bool to_first)
{
  std::vector<std::pair<Id, Point>> own;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_own(i, points.size(), to_first))
      own.emplace_back(Id(i), points[i]);
  return own;
}

void expect_exact(const Distributed& dt, const Points& points, const std::string& what)
{
  Edges own;
  dt.for_each_edge([&](Id i, Id j) { own.emplace_back(i, j); });
  std::uint64_t faces = 0, all_faces = 0;
  dt.for_each_face([&](const auto&) { ++faces; });
  MPI_Reduce(&faces, &all_faces, 1, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  expect(dt.is_certified(), what + ": certified");
  const Edges all = gathered(own);
  if (rank > 0)
    return;
  expect(all == expected_edges(points), what + ": the edges of all ranks are those of one");
  std::set<Id> ends;
  for (const auto& [i, j] : all)
    ends.insert({i, j});
  if (all_faces > 0) // Euler's formula
    expect(ends.size() + all_faces + 1 == all.size() + 2,
           what + ": as many faces as the edges have");
}

template <class Move>
void run(const std::string& what, Points points, int frames, const Move& move,
         bool to_first = false)
{
  const auto own = own_part(points, to_first);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  expect_exact(dt, points, what + ", at the start");
  for (int frame = 1; frame <= frames; ++frame) {
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = move(i, points[i], frame);
    Points next;
    for (const auto& [i, p] : own)
      next.push_back(points[std::size_t(i)]);
    dt.update(next.begin(), next.end());
    expect_exact(dt, points, what + ", frame " + std::to_string(frame));
  }
}

void refuse_bad_input()
{
  const Points points{{0, 0}, {1, 0}, {0, 1}, {1, 1.5}, {2, 3}, {3, 1}, {4, 2}, {5, 5}};
  const auto own = own_part(points, false);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  Points next;
  for (const auto& [i, p] : own)
    next.push_back(p);
  if (rank == 0)
    next[0] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
  bool is_refused = false;
  try {
    dt.update(next.begin(), next.end());
  } catch (const CGAL::Non_finite_coordinate_error_2&) {
    is_refused = rank == 0;
  } catch (const CGAL::Distributed_input_error_2& error) {
    is_refused = rank != 0 && error.rank() == 0;
  }
  expect(is_refused, "NaN on rank 0 is refused on all ranks");
  expect_exact(dt, points, "after a refusal");
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_FRAMES");
  const int frames = wanted ? std::atoi(wanted) : 20;

  std::mt19937 random(7); // the same on all ranks
  std::uniform_real_distribution<double> coordinate(0, 20);
  std::normal_distribution<double> step(0, 0.05);
  Points cloud, grid, line;
  for (int i = 0; i < 400; ++i) {
    cloud.push_back(Point(coordinate(random), coordinate(random)));
    grid.push_back(Point(i % 20, i / 20));
    line.push_back(Point(i % 40, 2 * (i % 40)));
  }
  std::sort(cloud.begin(), cloud.end());
  const auto rest = [](std::size_t, const Point& p, int) { return p; };
  run("Brownian motion", cloud, frames, [&](std::size_t, const Point& p, int) {
    return Point(p.x() + step(random), p.y() + step(random));
  });
  run("jumps", cloud, frames, [&](std::size_t, const Point& p, int) {
    return random() % 20 ? p : Point(coordinate(random), coordinate(random));
  });
  run("an explosion", cloud, frames, [](std::size_t, const Point& p, int) {
    return Point(10 + 1.1 * (p.x() - 10), 10 + 1.1 * (p.y() - 10));
  });
  run("a grid that comes and goes", grid, frames, [&](std::size_t i, const Point&, int frame) {
    return frame % 2 ? Point(double(i % 20) + step(random), double(i / 20)) : grid[i];
  });
  run("points on a line that coincide", line, 2, rest);
  run("a point that leaves the line", Points(line.begin(), line.begin() + 40), 2,
      [](std::size_t i, const Point& p, int frame) {
        return i == 39 && frame == 1 ? Point(3, 4.5) : p;
      });
  run("a rank that owns all", cloud, 2, rest, true);
  run("three points", Points(cloud.begin(), cloud.begin() + 3), 2, rest);
  run("one point", Points(cloud.begin(), cloud.begin() + 1), 2, rest);
  run("no point", {}, 2, rest);
  refuse_bad_input();
  MPI_Finalize();
}
