// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What several ranks say together, compared with CGAL's triangulation of all points on one of them.

#ifndef DISTRIBUTED_ORACLE_H
#define DISTRIBUTED_ORACLE_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Distributed_dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Distributed = CGAL::Distributed_dynamic_Delaunay_triangulation_2<Kernel>;
using Id = Distributed::Id;
using Points = std::vector<Point>;
using Population = std::map<Id, Point>;       // the same on all ranks
using Edges = std::vector<std::pair<Id, Id>>; // ascending

inline thread_local int this_rank, number_of_ranks; // a thread may be a rank

inline void start(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &this_rank);
  MPI_Comm_size(MPI_COMM_WORLD, &number_of_ranks);
}

inline void expect(bool is_so, const std::string& what)
{
  if (is_so)
    return;
  std::fprintf(stderr, "rank %d of %d: not so: %s\n", this_rank, number_of_ranks, what.c_str());
  MPI_Abort(MPI_COMM_WORLD, 1);
}

inline std::uint64_t sum(std::uint64_t count)
{
  std::uint64_t all = 0;
  MPI_Allreduce(&count, &all, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

// All pairs of all ranks, ascending, on rank 0; nothing elsewhere.
inline Edges gathered(const Edges& own)
{
  std::vector<Id> flat, all;
  for (const auto& [i, j] : own)
    flat.insert(flat.end(), {i, j});
  const int size = int(flat.size());
  std::vector<int> sizes(std::size_t(number_of_ranks), 0), places(std::size_t(number_of_ranks), 0);
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
// the smallest id; of points that coincide the smallest id has the edges.
inline Edges expected_edges(const Population& population)
{
  using Base = CGAL::Triangulation_vertex_base_with_info_2<Id, Kernel>;
  CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Base>> dt;
  for (const auto& [id, p] : population) {
    const auto before = dt.number_of_vertices();
    const auto v = dt.insert(p);
    if (dt.number_of_vertices() > before)
      v->info() = id;
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

inline Population numbered(const Points& points)
{
  Population population;
  for (const Point& p : points)
    population.emplace(Id(population.size()), p);
  return population;
}

// Which rank begins with point `i` of `size`.
using Owner = int (*)(std::size_t i, std::size_t size);
inline int in_order(std::size_t i, std::size_t size)
{
  return int(i * std::size_t(number_of_ranks) / size);
}
inline int in_turn(std::size_t i, std::size_t)
{
  return int(i % std::size_t(number_of_ranks));
}
inline int on_first(std::size_t, std::size_t)
{
  return 0;
}

inline std::vector<std::pair<Id, Point>> own_part(const Population& population, Owner owner)
{
  std::vector<std::pair<Id, Point>> own;
  std::size_t i = 0;
  for (const auto& value : population)
    if (owner(i++, population.size()) == this_rank)
      own.push_back(value);
  return own;
}

inline Points own_positions(const Distributed& dt, const Population& population)
{
  Points positions;
  for (const Id id : dt.owned_ids())
    positions.push_back(population.at(id));
  return positions;
}

inline void expect_exact(const Distributed& dt, const Population& population,
                         const std::string& what)
{
  Edges own, of_faces;
  dt.for_each_edge([&](Id i, Id j) { own.emplace_back(i, j); });
  std::uint64_t faces = 0;
  dt.for_each_face([&](const auto& ids) {
    ++faces;
    for (std::size_t k = 0; k < 3; ++k)
      of_faces.push_back(std::minmax(ids[k], ids[(k + 1) % 3]));
  });
  expect(dt.is_certified(), what + ": certified");
  expect(sum(dt.number_of_owned_points()) == population.size(), what + ": all points are owned");
  faces = sum(faces);
  const Edges all = gathered(own), sides = gathered(of_faces);
  if (this_rank > 0)
    return;
  expect(all == expected_edges(population), what + ": the edges of all ranks are those of one");
  std::set<Id> ends;
  for (const auto& [i, j] : all)
    ends.insert({i, j});
  if (faces == 0)
    return;
  expect(ends.size() + faces + 1 == all.size() + 2, what + ": as many faces as the edges have");
  for (const auto& side : sides)
    expect(std::binary_search(all.begin(), all.end(), side), what + ": sides of faces are edges");
}

// Moves all points frame by frame: `move(i, p, frame)` is called for all of them on all ranks.
template <class Move>
void run(const std::string& what, const Points& points, int frames, const Move& move,
         Owner owner = in_order, double load_factor = Distributed::default_load_factor)
{
  Population population = numbered(points);
  const auto own = own_part(population, owner);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end(), load_factor);
  expect_exact(dt, population, what + ", at the start");
  for (int frame = 1; frame <= frames; ++frame) {
    for (auto& [id, p] : population)
      p = move(std::size_t(id), p, frame);
    const Points next = own_positions(dt, population);
    dt.update(next.begin(), next.end());
    expect_exact(dt, population, what + ", frame " + std::to_string(frame));
  }
}

// A load factor: each rank owns what it was given.
inline constexpr double no_balance = std::numeric_limits<double>::infinity();

inline const auto at_rest = [](std::size_t, const Point& p, int) { return p; };

#endif // DISTRIBUTED_ORACLE_H
