// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A block of soft discs falls over in a box, as water from a broken dam does. The discs are spread
// over the ranks of MPI; each rank computes the forces on its own ones. Forces are summed up in the
// order of ids, so positions are the same, bit for bit, on any number of ranks.
//
//   mpirun -n 4 distributed_dam_break [--points N] [--frames N] [--checkpoint FILE] [--quiet]
//
// With a checkpoint the run is written to the file every 500 frames, and continues from it if it is
// there.

#include <CGAL/Distributed_dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_neighbor_lists_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Distributed = CGAL::Distributed_dynamic_Delaunay_triangulation_2<Kernel>;

struct Options
{
  int points = 1008, frames = 1000;
  std::string checkpoint;
  bool is_quiet = false;
};

Options read_options(int argc, char** argv)
{
  Options options;
  for (int k = 1; k < argc; ++k) {
    const std::string name = argv[k];
    if (name == "--quiet") {
      options.is_quiet = true;
      continue;
    }
    const bool is_number = name == "--points" || name == "--frames";
    if ((!is_number && name != "--checkpoint") || k + 1 == argc)
      throw std::runtime_error("'" + name +
                               "' is no option, or has no value; options are --points N, "
                               "--frames N, --checkpoint FILE and --quiet");
    const std::string value = argv[++k];
    if (!is_number)
      options.checkpoint = value;
    else if (value.empty() || value.size() > 9 ||
             value.find_first_not_of("0123456789") != std::string::npos)
      throw std::runtime_error("'" + value + "' is no number for " + name);
    else
      (name == "--points" ? options.points : options.frames) = std::stoi(value);
  }
  return options;
}

// The data of each disc that a rank owns, except for the position.
struct Disc
{
  double vx, vy;
  std::int64_t frame;
};

std::vector<std::pair<std::int64_t, Point>> block_of_discs(int number, int columns)
{
  std::vector<std::pair<std::int64_t, Point>> block;
  for (int i = 0; i < number; ++i) // not quite a lattice, or it would stand for ever
    block.emplace_back(i, Point(0.5 + i % columns + 0.01 * std::sin(i), 0.5 + i / columns));
  return block;
}

// Discs of diameter and mass 1 push each other away where they overlap, and walls do.
void move(Distributed& dt, std::vector<Disc>& discs, double side)
{
  const double time_step = 0.3, stiffness = 1, gravity = 0.0005, drag = 0.002;
  const auto wall = [&](double x) {
    return stiffness * ((std::max)(0.0, 0.5 - x) - (std::max)(0.0, x - (side - 0.5)));
  };
  CGAL::Distributed_neighbor_lists_2 lists;
  lists.compute(dt);
  std::vector<Point> points = dt.owned_points(), next = points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    Vector force(wall(points[k].x()), wall(points[k].y()) - gravity);
    for (const std::int64_t neighbor : lists.neighbors(k)) {
      const Vector apart = points[k] - dt.point(neighbor);
      const double distance = std::sqrt(apart.squared_length());
      if (distance > 0 && distance < 1)
        force = force + (stiffness * (1 - distance) / distance) * apart;
    }
    Disc& disc = discs[k];
    disc.vx = (1 - drag) * disc.vx + time_step * force.x();
    disc.vy = (1 - drag) * disc.vy + time_step * force.y();
    ++disc.frame;
    next[k] = Point(points[k].x() + time_step * disc.vx, points[k].y() + time_step * disc.vy);
  }
  const std::size_t distributions = dt.number_of_distributions();
  dt.update(next.begin(), next.end());
  if (dt.number_of_distributions() != distributions)
    discs = dt.carry(discs);
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

void report(const Distributed& dt, int rank, int ranks, int frames, double seconds)
{
  const double count = (std::max)(frames, 1);
  const double own[] = {double(dt.number_of_owned_points()),
                        double(dt.number_of_ghosts()),
                        double(dt.number_of_messages()) / count,
                        double(dt.number_of_bytes()) / count,
                        1000 * seconds / count,
                        100 * dt.communication_seconds() / seconds};
  std::vector<double> all(std::size_t(ranks) * 6);
  MPI_Gather(own, 6, MPI_DOUBLE, all.data(), 6, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  const std::uint64_t bits = fingerprint(dt);
  if (rank > 0)
    return;
  std::printf("rank  points  ghosts  messages/frame  bytes/frame  ms/frame  communicating\n");
  for (std::size_t r = 0; r < std::size_t(ranks); ++r) {
    const double* const f = &all[6 * r];
    std::printf("%4zu %7.0f %7.0f %15.2f %12.0f %9.3f %12.0f %%\n", r, f[0], f[1], f[2], f[3], f[4],
                f[5]);
  }
  std::printf("%d frames, %zu of them with questions; points were distributed anew %zu times\n",
              frames, dt.number_of_asking_frames(), dt.number_of_distributions());
  std::printf("fingerprint of all positions: %016llx\n", static_cast<unsigned long long>(bits));
}

bool run(const Options& options, int rank, int ranks)
{
  const int columns = (std::max)(1, int(std::lround(std::sqrt(options.points * 28 / 36.0))));
  const bool continues = !options.checkpoint.empty() && std::ifstream(options.checkpoint).is_open();
  // One rank has all discs at first; they are spread when they are triangulated.
  const auto given = block_of_discs(rank == 0 && !continues ? options.points : 0, columns);
  Distributed dt(MPI_COMM_WORLD, given.begin(), given.end());
  std::vector<Disc> discs(dt.number_of_owned_points(), Disc{0, 0, 0});
  if (continues)
    dt.read_checkpoint(options.checkpoint, discs);
  std::int64_t own_frame = discs.empty() ? 0 : discs[0].frame, frame = 0;
  MPI_Allreduce(&own_frame, &frame, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);

  bool all_certified = dt.is_certified();
  double seconds = 0;
  int frames = 0;
  for (; frame < options.frames; ++frame, ++frames) {
    const double begin = MPI_Wtime();
    move(dt, discs, 2.5 * columns);
    seconds += MPI_Wtime() - begin;
    all_certified = dt.is_certified() && all_certified;
    if (!options.checkpoint.empty() && (frame + 1) % 500 == 0)
      dt.write_checkpoint(options.checkpoint, discs);
    if (rank == 0 && !options.is_quiet && (frame + 1) % 200 == 0)
      std::printf("frame %lld of %d\n", static_cast<long long>(frame + 1), options.frames);
  }
  report(dt, rank, ranks, frames, seconds);
  const bool is_valid = dt.is_valid();
  if (rank == 0)
    std::printf("%s, %s\n", all_certified ? "all frames certified" : "not all frames certified",
                is_valid ? "valid over all ranks" : "not valid");
  return all_certified && is_valid;
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  bool is_good = false;
  try {
    is_good = run(read_options(argc, argv), rank, ranks);
  } catch (const std::exception& error) { // others may wait for this rank: it ends them, too
    std::fprintf(stderr, "rank %d: %s\n", rank, error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return is_good ? 0 : 1;
}
