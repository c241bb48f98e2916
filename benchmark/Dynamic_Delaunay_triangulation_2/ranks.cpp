// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How much ranks hold, send and wait, for points that are spread over MPI processes, all of them on
// this machine. `./dev bench ranks` runs it with 1, 2, 4 and 8 processes.
//
// Columns, means over ranks and frames unless it says otherwise:
//
//   own         points that a rank owns
//   ghosts      points of others, or other images, that it holds; `needed` of them are neighbors
//               of its own points
//   depth       ghosts over 4 sqrt(own): how many layers around a square of unit spacing they are
//   messages    messages between two ranks, of a frame
//   bytes       in these messages; `ideal` is 16 bytes for each ghost, in a periodic cell 24, also
//               for images of a rank's own points, which need no message
//   gathered    bytes of a frame that each rank receives from all ranks by collective calls
//   asking      the share of frames in which any rank had to ask, in percent
//   ms          milliseconds of a frame, until the last rank has ended it: median over the frames,
//               `q1` and `q3` its quartiles, and `worst` the slowest frame
//   comm        the share of all frames in which a rank sends, receives or waits, in percent
//   over        the share in which it does other things while messages that it has sent may be
//               under way, in percent
//
// With more processes than cores the last six columns are meaningless.
//
// With `--speed` the ranks share the points, and only the median of `ms` is printed, for Brownian
// 0.01 in the plane and on a torus. One rank takes turns with the classes of one process, `plain`,
// which are given the points in the order in which the rank owns them.

#include <CGAL/Distributed_dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Distributed_dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "scenario_runner/Measurement.h"
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Distributed = CGAL::Distributed_dynamic_Delaunay_triangulation_2<Kernel>;
using Distributed_periodic = CGAL::Distributed_dynamic_periodic_Delaunay_triangulation_2<Kernel>;

int this_rank = 0, number_of_ranks = 1;

double mean(double own)
{
  double sum = 0;
  MPI_Allreduce(&own, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return sum / number_of_ranks;
}

template <class Triangulation>
double number_of_needed_ghosts(const Triangulation& dt)
{
  const auto& held = dt.held_triangulation();
  std::vector<bool> are_own(held.number_of_ids(), false), are_needed = are_own;
  for (const std::int64_t id : dt.owned_ids())
    are_own[dt.held_id(id)] = true;
  held.for_each_edge([&](std::size_t i, std::size_t j) {
    if (are_own[i] != are_own[j])
      are_needed[are_own[i] ? j : i] = true;
  });
  return double(std::count(are_needed.begin(), are_needed.end(), true));
}

// A frame's mean of something that is counted.
class Frame_mean
{
public:
  Frame_mean(double count, int frames)
    : m_count(count)
    , m_frames(frames)
  {
  }
  double until(double count) const { return mean((count - m_count) / m_frames); }

private:
  double m_count;
  int m_frames;
};

struct Figures
{
  double own, ghosts, needed, messages, bytes, ideal, gathered, asking;
  double seconds, communication, overlap;            // of a frame and rank, means
  double median, low_quartile, high_quartile, worst; // of the frames, in seconds
};

const auto in_the_same_space = [](auto& dt, const std::vector<Point>& next) {
  dt.update(next.begin(), next.end());
};
constexpr double bytes_of_point = 16, bytes_of_image = 24;

constexpr int first_frames = 12; // they drop the superfluous ghosts of construction

// How long this rank takes for a frame in which the points go from where they are to `next`.
template <class Triangulation, class Update>
double seconds_of_frame(Triangulation& dt, const std::vector<Point>& next, const Update& update)
{
  MPI_Barrier(MPI_COMM_WORLD);
  const double begin = MPI_Wtime();
  update(dt, next);
  return MPI_Wtime() - begin;
}

// The times of all frames until the last rank has ended them.
run::Spread spread_of_frames(std::vector<double>& seconds)
{
  MPI_Allreduce(MPI_IN_PLACE, seconds.data(), int(seconds.size()), MPI_DOUBLE, MPI_MAX,
                MPI_COMM_WORLD);
  return *run::spread(seconds);
}

template <class Triangulation, class Move, class Update>
Figures measure(Triangulation& dt, int frames, double bytes_of_ghost, const Move& move,
                const Update& update)
{
  const auto run_frames = [&](int number) {
    std::vector<double> seconds;
    for (int frame = 0; frame < number; ++frame) {
      std::vector<Point> next = dt.owned_points();
      for (Point& p : next)
        p = move(p);
      seconds.push_back(seconds_of_frame(dt, next, update));
    }
    return seconds;
  };
  run_frames(first_frames);
  const Frame_mean messages(double(dt.number_of_messages()), frames);
  const Frame_mean bytes(double(dt.number_of_bytes()), frames);
  const Frame_mean gathered(double(dt.number_of_gathered_bytes()), frames);
  const Frame_mean asking(double(dt.number_of_asking_frames()), frames);
  const Frame_mean communication(dt.communication_seconds(), frames);
  const Frame_mean overlap(dt.overlapped_seconds(), frames);
  std::vector<double> seconds = run_frames(frames);
  const double own_mean = std::accumulate(seconds.begin(), seconds.end(), 0.0) / frames;
  const run::Spread spread = spread_of_frames(seconds);
  return {mean(double(dt.number_of_owned_points())),
          mean(double(dt.number_of_ghosts())),
          mean(number_of_needed_ghosts(dt)),
          messages.until(double(dt.number_of_messages())),
          bytes.until(double(dt.number_of_bytes())),
          bytes_of_ghost * mean(double(dt.number_of_ghosts())),
          gathered.until(double(dt.number_of_gathered_bytes())),
          asking.until(double(dt.number_of_asking_frames())),
          mean(own_mean),
          communication.until(dt.communication_seconds()),
          overlap.until(dt.overlapped_seconds()),
          spread.median,
          spread.low_quartile,
          spread.high_quartile,
          *std::max_element(seconds.begin(), seconds.end())};
}

void print(const std::string& name, const Figures& f)
{
  if (this_rank > 0)
    return;
  std::printf("%5d %-16s %8.0f %7.0f %7.0f %6.2f %8.2f %9.0f %9.0f %9.0f %7.1f %8.2f %8.2f %8.2f "
              "%8.2f %5.0f %5.0f\n",
              number_of_ranks, name.c_str(), f.own, f.ghosts, f.needed,
              f.ghosts / (4 * std::sqrt(f.own)), f.messages, f.bytes, f.ideal, f.gathered,
              100 * f.asking, 1000 * f.median, 1000 * f.low_quartile, 1000 * f.high_quartile,
              1000 * f.worst, 100 * f.communication / f.seconds, 100 * f.overlap / f.seconds);
}

// Weak scaling, from the figures of this run. Assumed: a square of evenly spread points, cut into
// squares, one process to a core; a message takes 2 microseconds and 10 GB/s; a collective call
// takes 2 microseconds for each doubling of the number of ranks, and 10 GB/s for what it gathers; a
// frame has 6 of them. Each held point takes as much time as in this run. Ghosts and questions are
// in proportion to the boundary of a rank, as many as in this run; if no frame of this run asked,
// one of them counts as if it had. An asking frame has 2 exchanges and 4 collective calls more for
// each round, of which there is one. It gathers 16 boxes of each rank, and a zone of 6 bytes for
// each spacing of its boundary. The efficiency is relative to ranks that need no others, but do
// prove all faces.
void print_model(const Figures& f, int frames, double points_per_rank)
{
  const double latency = 2e-6, bandwidth = 1e10;
  const double per_point = (f.seconds - f.communication) / (f.own + f.ghosts);
  const double boundary = std::sqrt(points_per_rank / f.own);
  const double ghosts = f.ghosts * boundary;
  const double asking_of_one =
      1 - std::pow((std::max)(1 - (std::max)(f.asking, 1.0 / frames), 1e-3),
                   boundary / double(number_of_ranks));
  std::printf("\nweak scaling by a model, %.0f points a rank, %.1f ns a point and frame\n",
              points_per_rank, 1e9 * per_point);
  std::printf("%6s %12s %9s %9s %9s %9s %11s\n", "ranks", "points", "asking %", "ms", "halo ms",
              "network ms", "efficiency %");
  for (int ranks = 1; ranks <= 16384; ranks *= 4) {
    const double doublings = std::log2(double(ranks)), some = ranks > 1;
    const double asking = some * (1 - std::pow(1 - asking_of_one, ranks));
    const double own = points_per_rank * per_point, halo = some * ghosts * per_point;
    const double calm = some * (8 * latency + 16 * ghosts / bandwidth) + 6 * latency * doublings +
                        8.0 * ranks / bandwidth;
    const double told = 512.0 * ranks + asking_of_one * ranks * 24 * std::sqrt(points_per_rank);
    const double rough = asking * (16 * latency + 4 * latency * doublings + told / bandwidth);
    const double all = own + halo + calm + rough;
    std::printf("%6d %12.3g %9.1f %9.2f %9.2f %9.2f %11.1f\n", ranks, ranks * points_per_rank,
                100 * asking, 1000 * all, 1000 * halo, 1000 * (calm + rough), 100 * own / all);
  }
}

// Brownian motion, and shear as fast as in the plane, in a square cell.
bool measure_periodic(const std::vector<std::pair<std::int64_t, Point>>& given, double side,
                      int frames)
{
  std::mt19937_64 random(unsigned(this_rank) + 1);
  std::normal_distribution<double> step(0, 0.01);
  double strain = 0;
  Distributed_periodic dt(MPI_COMM_WORLD, given.begin(), given.end(),
                          CGAL::Periodic_cell_2(side, side));
  print("periodic 0.01",
        measure(
            dt, frames, bytes_of_image,
            [&](const Point& p) { return Point(p.x() + step(random), p.y() + step(random)); },
            [](Distributed_periodic& pt, const std::vector<Point>& next) {
              pt.update(next.begin(), next.end());
            }));
  print("periodic shear", measure(
                              dt, frames, bytes_of_image,
                              [&](const Point& p) { return Point(p.x() + 0.0002 * p.y(), p.y()); },
                              [&](Distributed_periodic& pt, const std::vector<Point>& next) {
                                strain += 0.0002;
                                pt.update(next.begin(), next.end(),
                                          CGAL::Periodic_cell_2(side, 0, strain * side, side));
                              }));
  return dt.is_certified() && dt.is_valid();
}

// The same motion by a class of one process and by the ranks, frame by frame in turn, so that the
// machine is the same for both. `plain` is null where other ranks would wait for it.
template <class Plain, class Triangulation>
std::array<double, 2> median_milliseconds(Plain* plain, Triangulation& dt, int frames)
{
  std::mt19937_64 random(unsigned(this_rank) + 1);
  std::normal_distribution<double> step(0, 0.01);
  std::vector<double> of_plain, of_ranks;
  for (int frame = 0; frame < first_frames + frames; ++frame) {
    std::vector<Point> next = dt.owned_points();
    for (Point& p : next)
      p = Point(p.x() + step(random), p.y() + step(random));
    const double plain_seconds = plain ? seconds_of_frame(*plain, next, in_the_same_space) : 0;
    const double seconds = seconds_of_frame(dt, next, in_the_same_space);
    if (frame >= first_frames) {
      of_plain.push_back(plain_seconds);
      of_ranks.push_back(seconds);
    }
  }
  return {1000 * spread_of_frames(of_plain).median, 1000 * spread_of_frames(of_ranks).median};
}

void print_milliseconds(const std::string& name, double plane, double torus)
{
  if (this_rank == 0)
    std::printf("%-10s %10.2f %10.2f\n", name.c_str(), plane, torus);
}

// One or two rows of a table of strong scaling: the ranks share the points.
bool measure_speed(const std::vector<std::pair<std::int64_t, Point>>& given, double side,
                   int frames)
{
  const CGAL::Periodic_cell_2 cell(side, side);
  Distributed dt(MPI_COMM_WORLD, given.begin(), given.end());
  Distributed_periodic pt(MPI_COMM_WORLD, given.begin(), given.end(), cell);
  std::array<double, 2> plane, torus;
  if (number_of_ranks == 1) {
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel> plain(dt.owned_points());
    CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel> plain_pt(pt.owned_points(), cell);
    plane = median_milliseconds(&plain, dt, frames);
    torus = median_milliseconds(&plain_pt, pt, frames);
    std::printf("\n%zu points in all, milliseconds of a frame\n%-10s %10s %10s\n", given.size(), "",
                "plane", "torus");
    print_milliseconds("plain", plane[0], torus[0]);
  } else {
    plane = median_milliseconds<Distributed>(nullptr, dt, frames);
    torus = median_milliseconds<Distributed_periodic>(nullptr, pt, frames);
  }
  print_milliseconds(std::to_string(number_of_ranks) + (number_of_ranks == 1 ? " rank" : " ranks"),
                     plane[1], torus[1]);
  return dt.is_certified() && dt.is_valid() && pt.is_certified() && pt.is_valid();
}

} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &this_rank);
  MPI_Comm_size(MPI_COMM_WORLD, &number_of_ranks);
  const int points = argc > 1 ? std::atoi(argv[1]) : 20000;
  const int frames = argc > 2 ? (std::max)(std::atoi(argv[2]), 1) : 50;
  const std::string mode = argc > 3 ? argv[3] : "";
  const bool has_model = mode == "--model", is_about_speed = mode == "--speed";
  const int share = is_about_speed ? points / number_of_ranks : points;

  std::mt19937_64 random(unsigned(this_rank) + 1);
  const double side = std::sqrt(double(share) * number_of_ranks);
  std::uniform_real_distribution<double> coordinate(0, side);
  std::normal_distribution<double> step(0, 1);
  const auto brownian = [&](double spread) {
    return [&, spread](const Point& p) {
      return Point(p.x() + spread * step(random), p.y() + spread * step(random));
    };
  };
  std::vector<std::pair<std::int64_t, Point>> given;
  for (int i = 0; i < share; ++i)
    given.emplace_back(std::int64_t(this_rank) * share + i,
                       Point(coordinate(random), coordinate(random)));
  if (is_about_speed) {
    const bool is_good = measure_speed(given, side, frames);
    MPI_Finalize();
    return is_good ? 0 : 1;
  }
  Distributed dt(MPI_COMM_WORLD, given.begin(), given.end());
  if (this_rank == 0)
    std::printf("%5s %-16s %8s %7s %7s %6s %8s %9s %9s %9s %7s %8s %8s %8s %8s %5s %5s\n", "ranks",
                "motion", "own", "ghosts", "needed", "depth", "messages", "bytes", "ideal",
                "gathered", "asking", "ms", "q1", "q3", "worst", "comm", "over");
  const auto measure_in_plane = [&](const auto& move) {
    return measure(dt, frames, bytes_of_point, move, in_the_same_space);
  };
  print("Brownian 0.001", measure_in_plane(brownian(0.001)));
  const Figures usual = measure_in_plane(brownian(0.01));
  print("Brownian 0.01", usual);
  print("Brownian 0.1", measure_in_plane(brownian(0.1)));
  print("shear 0.0002", measure_in_plane([&](const Point& p) {
          return Point(p.x() + 0.0002 * (p.y() - side / 2), p.y());
        }));
  print("expansion 0.01",
        measure_in_plane([](const Point& p) { return Point(1.01 * p.x(), 1.01 * p.y()); }));
  bool is_good = dt.is_certified() && dt.is_valid();
  is_good = measure_periodic(given, side, frames) && is_good;
  if (this_rank == 0 && !is_good)
    std::fprintf(stderr, "the triangulation is not valid\n");
  if (this_rank == 0 && has_model && number_of_ranks > 1)
    for (const double points_per_rank : {1e5, 1e6, 1e7})
      print_model(usual, frames, points_per_rank);
  MPI_Finalize();
  return is_good ? 0 : 1;
}
