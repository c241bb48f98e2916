// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Soft disks in a periodic cell that is sheared further and further, spread over the ranks of MPI.
// Forces are summed up in the order of ids, so positions are the same, bit for bit, on any
// number of ranks.
//
//   mpirun -n 4 distributed_shear

#include <CGAL/Distributed_dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_neighbor_lists_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <mpi.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <random>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Distributed = CGAL::Distributed_dynamic_periodic_Delaunay_triangulation_2<Kernel>;

constexpr std::int64_t number_of_disks = 400;
constexpr double cell_side = 19, strain_of_step = 0.01;

// One rank has all disks at first; they are spread when they are triangulated.
std::vector<std::pair<std::int64_t, Point>> random_disks(int rank)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, cell_side);
  std::vector<std::pair<std::int64_t, Point>> disks;
  for (std::int64_t id = 0; id < number_of_disks && rank == 0; ++id) {
    const double x = coordinate(random);
    disks.emplace_back(id, Point(x, coordinate(random)));
  }
  return disks;
}

// Disks with diameter 1 push each other away where they overlap, and follow the shear.
std::vector<Point> next_positions(const Distributed& dt)
{
  CGAL::Distributed_neighbor_lists_2 lists;
  lists.compute(dt);
  const std::vector<std::int64_t> ids = dt.owned_ids();
  std::vector<Point> next;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    Vector push(0, 0);
    for (std::size_t n = lists.offsets()[k]; n < lists.offsets()[k + 1]; ++n) {
      const Vector v = dt.vector(ids[k], lists.neighbors()[n], lists.shifts()[n]);
      const double length = std::sqrt(v.squared_length());
      if (length < 1 && length > 0)
        push = push - v * ((1 - length) / length);
    }
    const Point p = dt.point(ids[k]) + 0.25 * push;
    next.push_back(Point(p.x() + strain_of_step * p.y(), p.y()));
  }
  return next;
}

// A hash of the points, which does not depend on the ranks that own them.
std::uint64_t fingerprint(const Distributed& dt)
{
  std::uint64_t sum = 0, all = 0;
  for (const std::int64_t id : dt.owned_ids())
    for (const double coordinate : {dt.point(id).x(), dt.point(id).y()}) {
      std::uint64_t bits;
      std::memcpy(&bits, &coordinate, sizeof bits);
      sum += (bits ^ std::uint64_t(id)) * 0x9e3779b97f4a7c15;
    }
  MPI_Allreduce(&sum, &all, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

bool run(int rank)
{
  const auto given = random_disks(rank);
  Distributed dt(MPI_COMM_WORLD, given.begin(), given.end(),
                 CGAL::Periodic_cell_2(cell_side, cell_side));
  double skew = 0;
  bool all_certified = dt.is_certified();
  for (int step = 1; step <= 300; ++step) {
    const std::vector<Point> next = next_positions(dt);
    skew += strain_of_step * cell_side;
    if (skew > cell_side / 2)
      skew -= cell_side; // the same lattice with less skew vectors, as Lees and Edwards have it
    dt.update(next.begin(), next.end(), CGAL::Periodic_cell_2(cell_side, 0, skew, cell_side));
    all_certified = dt.is_certified() && all_certified;
    if (rank == 0 && step % 100 == 0)
      std::printf("strain %g: rank 0 owns %zu points, and holds %zu more images\n",
                  step * strain_of_step, dt.number_of_owned_points(), dt.number_of_ghosts());
  }
  const bool is_valid = dt.is_valid();
  const std::uint64_t bits = fingerprint(dt);
  if (rank == 0) {
    std::printf("points were distributed anew %zu times\n", dt.number_of_distributions());
    std::printf("fingerprint of all positions: %016llx\n", static_cast<unsigned long long>(bits));
    std::printf("%s, %s\n", all_certified ? "all frames certified" : "not all frames certified",
                is_valid ? "valid over all ranks" : "not valid");
  }
  return all_certified && is_valid;
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  bool is_good = false;
  try {
    is_good = run(rank);
  } catch (const std::exception& error) { // others may wait for this rank: it ends them, too
    std::fprintf(stderr, "rank %d: %s\n", rank, error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return is_good ? 0 : 1;
}
