// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the triangulation of several ranks with CGAL's triangulation of all points on one rank.

#ifndef DISTRIBUTED_ORACLE_H
#define DISTRIBUTED_ORACLE_H

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
#include <functional>
#include <iterator>
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
using Newcomers = std::vector<std::pair<Id, Point>>;
using Edges = std::vector<std::pair<Id, Id>>; // ascending

// All points, equal on all ranks. It has a type of this file, so that templates find the
// expect_exact() of every space.
struct Population : std::map<Id, Point>
{
  using std::map<Id, Point>::map;
};

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

inline std::uint64_t largest(std::uint64_t count)
{
  std::uint64_t most = 0;
  MPI_Allreduce(&count, &most, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  return most;
}

// On rank 0 the data of all ranks, in the order of ranks; empty on the others.
template <class T>
std::vector<T> gathered_data(const std::vector<T>& own)
{
  const int size = int(own.size() * sizeof(T));
  std::vector<int> sizes(std::size_t(number_of_ranks), 0), places(std::size_t(number_of_ranks), 0);
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  for (std::size_t r = 1; r < places.size(); ++r)
    places[r] = places[r - 1] + sizes[r - 1];
  std::vector<T> all(std::size_t(places.back() + sizes.back()) / sizeof(T));
  MPI_Gatherv(own.data(), size, MPI_BYTE, all.data(), sizes.data(), places.data(), MPI_BYTE, 0,
              MPI_COMM_WORLD);
  return all;
}

// On rank 0 the data of all ranks, ascending; empty on the others.
template <class T>
std::vector<T> gathered(const std::vector<T>& own)
{
  std::vector<T> all = gathered_data(own);
  std::sort(all.begin(), all.end());
  return all;
}

// Found by CGAL alone. Four or more points on one circle get the diagonals from their smallest id,
// in place of CGAL's; of points that coincide the smallest id has the edges.
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

// Points of a square at the origin.
inline Points any_points(std::size_t number, double side, std::mt19937& random)
{
  std::uniform_real_distribution<double> coordinate(0, side);
  Points points;
  for (std::size_t i = 0; i < number; ++i)
    points.push_back(Point(coordinate(random), coordinate(random)));
  return points;
}

inline Population numbered(const Points& points)
{
  Population population;
  for (const Point& p : points)
    population.emplace(Id(population.size()), p);
  return population;
}

// All points with integer coordinates on a circle around the origin, and a few outside of it.
inline Points points_on_one_circle(long squared_radius, double outside)
{
  Points points;
  const long radius = long(std::sqrt(double(squared_radius)));
  for (long x = -radius; x <= radius; ++x) {
    const long y = std::lround(std::sqrt(double(squared_radius - x * x)));
    if (x * x + y * y == squared_radius) {
      points.push_back(Point(double(x), double(y)));
      points.push_back(Point(double(x), -double(y)));
    }
  }
  for (int k = 0; k < 8; ++k)
    points.push_back(Point(outside * std::cos(k), outside * std::sin(k)));
  return points;
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

inline Newcomers own_part(const Population& population, Owner owner)
{
  Newcomers own;
  std::size_t i = 0;
  for (const auto& value : population)
    if (owner(i++, population.size()) == this_rank)
      own.push_back(value);
  return own;
}

// The part of a list that this rank gives: it is cut differently for each `salt`.
template <class Value>
std::vector<Value> given_here(const std::vector<Value>& all, std::size_t salt = 0)
{
  std::vector<Value> given;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (in_turn(7 * k + salt, all.size()) == this_rank)
      given.push_back(all[k]);
  return given;
}

// Constructs a triangulation over all ranks. `arguments` follow the points: the cell of a periodic
// triangulation, and a load factor.
template <class Triangulation = Distributed, class... Arguments>
Triangulation distributed(const Population& population, Owner owner, const Arguments&... arguments)
{
  const Newcomers own = own_part(population, owner);
  return Triangulation(MPI_COMM_WORLD, own, arguments...);
}

template <class Triangulation>
Points own_positions(const Triangulation& dt, const Population& population)
{
  Points positions;
  for (const Id id : dt.owned_ids())
    positions.push_back(population.at(id));
  return positions;
}

// Moves points to where the population has them, in another cell, if one is given.
template <class Triangulation, class... Cell>
void update(Triangulation& dt, const Population& population, const Cell&... cell)
{
  const Points next = own_positions(dt, population);
  dt.update(next, cell...);
}

// True if `call` throws an `Error` for which `is_right` holds.
template <class Error, class Call>
bool is_refused(
    const Call& call,
    const std::function<bool(const Error&)>& is_right = [](const Error&) { return true; })
{
  try {
    call();
  } catch (const Error& error) {
    return is_right(error);
  }
  return false;
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

// What is in one of two ascending lists and not in the other one.
template <class List>
List difference(const List& list, const List& other)
{
  List result;
  std::set_difference(list.begin(), list.end(), other.begin(), other.end(),
                      std::back_inserter(result));
  return result;
}

// How points begin on ranks, and when they are distributed anew.
struct Ownership
{
  Owner owner = in_order;
  double load_factor = Distributed::default_load_factor;
};

// A load factor: each rank owns what it was given.
inline constexpr double no_balance = std::numeric_limits<double>::infinity();

inline const Ownership ownerships[] = {{in_order, no_balance}, {in_turn, no_balance}, {in_order}};

// Moves all points frame by frame: `move(i, p, frame)` is called for all of them on all ranks, then
// `go(population, frame)`.
template <class Triangulation, class Move, class Go>
void follow(const Triangulation& dt, Population population, const std::string& what, int frames,
            const Move& move, const Go& go)
{
  expect_exact(dt, population, what + ", at the start");
  for (int frame = 1; frame <= frames; ++frame) {
    for (auto& [id, p] : population)
      p = move(std::size_t(id), p, frame);
    go(population, frame);
    expect_exact(dt, population, what + ", frame " + std::to_string(frame));
  }
}

template <class Move>
void run(const std::string& what, const Points& points, int frames, const Ownership& ownership,
         const Move& move)
{
  const Population population = numbered(points);
  auto dt = distributed(population, ownership.owner, ownership.load_factor);
  follow(dt, population, what, frames, move,
         [&](const Population& moved, int) { update(dt, moved); });
}

inline const auto at_rest = [](std::size_t, const Point& p, int) { return p; };

#endif // DISTRIBUTED_ORACLE_H
