// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: all of them write a checkpoint, and any number of them read it back with
// the same edges; files that have been altered are refused.

#include "distributed_theme.h"
#include "distributed_uses.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>

namespace distributed_checkpoint {

struct Data // of a point
{
  Id id;
  double twice_x;

  friend bool operator==(const Data& a, const Data& b)
  {
    return a.id == b.id && a.twice_x == b.twice_x;
  }
};

Population random_points()
{
  std::mt19937 random(23);
  std::uniform_real_distribution<double> coordinate(0, 20);
  Points points;
  for (int i = 0; i < 300; ++i)
    points.push_back(i % 10 == 9 ? points.back() : Point(coordinate(random), coordinate(random)));
  return numbered(points);
}

std::vector<Data> data_of(const Distributed& dt)
{
  std::vector<Data> data;
  for (const Id id : dt.owned_ids())
    data.push_back({id, 2 * dt.point(id).x()});
  return data;
}

bool refuses(const std::string& path, const std::string& message)
{
  const Population before = numbered({{0, 0}, {1, 0}, {0, 1}, {2, 3}});
  auto dt = distributed(before, in_order);
  std::vector<Data> data;
  const bool is_so =
      tells<CGAL::Checkpoint_error_2>([&] { dt.read_checkpoint(path, data); }, message);
  expect_exact(dt, before, "after a refusal");
  return is_so;
}

void other_files_are_refused(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::string bad = path + "_bad";
  const auto expect_refusal = [&](const std::string& bytes, const std::string& message) {
    if (this_rank == 0)
      std::ofstream(bad, std::ios::binary) << bytes;
    MPI_Barrier(MPI_COMM_WORLD);
    expect(refuses(bad, message), "a file is refused: " + message);
    MPI_Barrier(MPI_COMM_WORLD);
  };
  expect(good.size() > 1000, "the file is there");
  expect_refusal("", "no checkpoint");
  expect_refusal("x" + good.substr(1), "no checkpoint");
  expect_refusal(good.substr(0, good.size() - 1), "cut off");
  expect_refusal(good + "x", "appended");
  for (const std::size_t place : {std::size_t(80), good.size() / 2, good.size() - 1}) {
    std::string changed = good;
    changed[place] = char(changed[place] ^ 1);
    expect_refusal(changed, "not those that were written");
  }
  std::string other_size = good;
  other_size[32] = char(other_size[32] ^ 8);
  expect_refusal(other_size, "bytes of data");
  if (this_rank == 0)
    std::remove(bad.c_str());
  MPI_Barrier(MPI_COMM_WORLD);
  expect(refuses(bad, "cannot read"), "a file that is not there is refused");
}

void run_theme()
{
  const std::string path = file_name("distributed_checkpoint");
  const Population population = random_points();
  {
    auto dt = distributed(population, in_turn);
    expect(is_refused<CGAL::Checkpoint_error_2>(
               [&] { dt.write_checkpoint("/no such directory/checkpoint"); }),
           "what cannot be written is told on all ranks");
    dt.write_checkpoint(path); // replaced by the next one
    dt.write_checkpoint(path, data_of(dt));
  }
  for (int readers = 1; readers <= number_of_ranks; ++readers)
    some_ranks_read<Distributed>(path, population, readers, data_of);
  some_ranks_read<Distributed>(path, population, number_of_ranks, data_of, no_balance);
  other_files_are_refused(path);
  if (this_rank == 0)
    std::remove(path.c_str());
}

const Theme theme("distributed_checkpoint", run_theme);

} // namespace distributed_checkpoint
