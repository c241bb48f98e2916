// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: what they have written, some of them read again, with the same edges; files
// that are not as they were written are refused.

#include "distributed_oracle.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <unistd.h>

struct Data // of a point
{
  Id id;
  double twice_x;
};

// One for all tests of this program, whatever the number of ranks.
std::string file_name()
{
  long process = getpid();
  MPI_Bcast(&process, 1, MPI_LONG, 0, MPI_COMM_WORLD);
  const std::string name = "distributed_checkpoint_" + std::to_string(process);
  return (std::filesystem::temp_directory_path() / name).string();
}

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

void expect_data(const Distributed& dt, const std::vector<Data>& data, const std::string& what)
{
  const std::vector<Data> expected = data_of(dt);
  expect(std::equal(
             data.begin(), data.end(), expected.begin(), expected.end(),
             [](const Data& a, const Data& b) { return a.id == b.id && a.twice_x == b.twice_x; }),
         what + ": the data of each point are its own");
}

// Ranks from 0 to `readers` read the file by themselves; the others own nothing.
void some_ranks_read(const std::string& path, const Population& population, int readers,
                     double load_factor)
{
  MPI_Comm some;
  MPI_Comm_split(MPI_COMM_WORLD, this_rank < readers, this_rank, &some);
  const std::vector<std::pair<Id, Point>> none;
  const std::string what = std::to_string(readers) + " ranks have read";
  {
    Distributed dt(some, none.begin(), none.end(), load_factor);
    if (this_rank < readers) {
      std::vector<Data> data;
      dt.read_checkpoint(path, data);
      expect_data(dt, data, what);
      expect(dt.is_valid(), what + ": valid");
    }
    expect_exact(dt, population, what);
  }
  MPI_Comm_free(&some);
}

bool is_refused(const std::string& path, std::string message)
{
  const Population before = numbered({{0, 0}, {1, 0}, {0, 1}, {2, 3}});
  const auto own = own_part(before, in_order);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  std::vector<Data> data;
  bool is_so = false;
  try {
    dt.read_checkpoint(path, data);
  } catch (const CGAL::Checkpoint_error_2& error) {
    is_so = std::string(error.what()).find(message) != std::string::npos ||
            std::string(error.what()).find("another rank") != std::string::npos;
  }
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
    expect(is_refused(bad, message), "a file is refused: " + message);
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
  expect(is_refused(bad, "cannot read"), "a file that is not there is refused");
}

int main(int argc, char** argv)
{
  start(argc, argv);
  const std::string path = file_name();
  const Population population = random_points();
  {
    const auto own = own_part(population, in_turn);
    Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
    bool is_so = false;
    try {
      dt.write_checkpoint("/no such directory/checkpoint");
    } catch (const CGAL::Checkpoint_error_2&) {
      is_so = true;
    }
    expect(is_so, "what cannot be written is told on all ranks");
    dt.write_checkpoint(path); // which the next one replaces
    dt.write_checkpoint(path, data_of(dt));
  }
  for (int readers = 1; readers <= number_of_ranks; ++readers)
    some_ranks_read(path, population, readers, Distributed::default_load_factor);
  some_ranks_read(path, population, number_of_ranks, no_balance);
  other_files_are_refused(path);
  if (this_rank == 0)
    std::remove(path.c_str());
  MPI_Finalize();
}
