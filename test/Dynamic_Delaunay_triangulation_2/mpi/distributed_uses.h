// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What programs do with points over ranks in any space: they insert and remove them, distribute
// them anew, and read checkpoints that other ranks have written.

#ifndef DISTRIBUTED_USES_H
#define DISTRIBUTED_USES_H

#include "distributed_oracle.h"

#include <filesystem>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

// True if `call` throws an `Error` with this part of a message.
template <class Error, class Call>
bool tells(const Call& call, const std::string& message)
{
  return is_refused<Error>(call, [&](const Error& error) {
    const bool is_told = std::string(error.what()).find(message) != std::string::npos;
    if (!is_told)
      std::fprintf(stderr, "rank %d: '%s', not '%s'\n", this_rank, error.what(), message.c_str());
    return is_told;
  });
}

inline bool is_last()
{
  return this_rank == number_of_ranks - 1;
}

// What the last rank gives, and what the others give.
template <class T>
T differing(const T& of_last, const T& of_others)
{
  return is_last() ? of_last : of_others;
}

inline void move_all(Population& population, std::mt19937& random, double spread)
{
  std::normal_distribution<double> step(0, spread);
  for (auto& [id, p] : population)
    p = Point(p.x() + step(random), p.y() + step(random));
}

template <class Triangulation>
void insert(Triangulation& dt, Population& population, const Newcomers& all, std::size_t salt)
{
  const Newcomers given = given_here(all, salt);
  dt.insert(given);
  population.insert(all.begin(), all.end());
}

template <class Triangulation>
void remove(Triangulation& dt, Population& population, const std::vector<Id>& all, std::size_t salt)
{
  const std::vector<Id> given = given_here(all, salt);
  dt.remove(given);
  for (const Id id : all)
    population.erase(id);
}

// Inserts, removes and moves points of a triangulation that begins empty. `coming(frame, random)`
// returns the new points, without ids; `look(population, what)` is called after their insertion.
template <class Triangulation, class Coming, class Look>
void points_come_and_go(Triangulation& dt, std::size_t frames, const Coming& coming,
                        const Look& look)
{
  std::mt19937 random(13); // the same on all ranks
  Population population;
  expect_exact(dt, population, "no points");
  Id next = -5; // any numbers are ids
  for (std::size_t frame = 0; frame < frames; ++frame) {
    Newcomers newcomers;
    for (const Point& p : coming(frame, random))
      newcomers.emplace_back(next += 1 + Id(random() % 1000), p);
    insert(dt, population, newcomers, frame);
    expect_exact(dt, population, "points have come");
    look(population, "points have come");
    std::vector<Id> going;
    for (const auto& value : population)
      if (random() % (frame % 7 == 0 ? 3 : 30) == 0)
        going.push_back(value.first);
    remove(dt, population, going, frame + 1);
    expect_exact(dt, population, "points have gone");
    move_all(population, random, 0.05);
    update(dt, population);
    expect_exact(dt, population, "points have moved");
  }
  std::vector<Id> all;
  for (const auto& value : population)
    all.push_back(value.first);
  remove(dt, population, all, 0);
  expect_exact(dt, population, "all points have gone");
  expect(dt.is_valid(), "no points are valid");
  insert(dt, population, {{7, Point(0, 0)}, {3, Point(1, 0)}, {5, Point(0, 1)}}, 1);
  expect_exact(dt, population, "points after none");
}

inline std::uint64_t about_equally_many(std::size_t points)
{
  return points / std::size_t(number_of_ranks) + points / 64 + 1;
}

struct Mixing
{
  int calm;         // frames before the first one in which a fifth of all points jump
  int looked_at;    // compared each so many frames
  int enough_ranks; // for points to be distributed anew
};

// Points jump to `place(random)`, which makes ranks distribute all points anew.
template <class Triangulation, class Place>
void mixed_points_are_distributed_anew(Triangulation& dt, Population population,
                                       const Mixing& mixing, const Place& place)
{
  std::mt19937 random(8);
  std::size_t distributions = 0;
  for (int frame = 0; frame < 48; ++frame) {
    const std::vector<Id> before = dt.owned_ids();
    for (auto& [id, p] : population)
      if (frame >= mixing.calm && random() % 5 == 0)
        p = place(random);
    update(dt, population);
    if (frame % mixing.looked_at == 0)
      expect_exact(dt, population, "mixing");
    if (dt.number_of_distributions() != distributions)
      expect(dt.carry(before) == dt.owned_ids(), "data follow their points");
    else
      expect(dt.owned_ids() == before, "owned points change only where they are distributed");
    distributions = dt.number_of_distributions();
  }
  expect(number_of_ranks < mixing.enough_ranks || distributions > 0,
         "points that mix are distributed anew");
  const std::vector<Id> before = dt.owned_ids();
  dt.distribute();
  expect(dt.carry(before) == dt.owned_ids(), "data follow points that are distributed by hand");
  expect_exact(dt, population, "distributed by hand");
  expect(largest(dt.number_of_owned_points()) <= about_equally_many(population.size()),
         "all ranks own about equally many points");
}

// The same name on all ranks, and another one for each run of the program.
inline std::string file_name(const std::string& program)
{
  long process = getpid();
  MPI_Bcast(&process, 1, MPI_LONG, 0, MPI_COMM_WORLD);
  const std::string name = program + "_" + std::to_string(process);
  return (std::filesystem::temp_directory_path() / name).string();
}

// The first `readers` ranks read the file by themselves, and the others own nothing. `data_of(dt)`
// has been written with the points.
template <class Triangulation, class Data_of, class... Arguments>
void some_ranks_read(const std::string& path, const Population& population, int readers,
                     const Data_of& data_of, const Arguments&... arguments)
{
  MPI_Comm some;
  MPI_Comm_split(MPI_COMM_WORLD, this_rank < readers, this_rank, &some);
  const Newcomers none;
  const std::string what = std::to_string(readers) + " ranks have read";
  {
    Triangulation dt(some, none.begin(), none.end(), arguments...);
    if (this_rank < readers) {
      decltype(data_of(dt)) data;
      dt.read_checkpoint(path, data);
      expect(data == data_of(dt), what + ": the data of each point are its own");
      expect(dt.is_valid(), what + ": valid");
    }
    expect_exact(dt, population, what);
    std::vector<char> other;
    expect(is_refused<CGAL::Checkpoint_error_2>([&] { dt.read_checkpoint(path, other); }),
           what + ": other data are refused");
  }
  MPI_Comm_free(&some);
}

#endif // DISTRIBUTED_USES_H
