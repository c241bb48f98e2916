// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: checkpoints that some ranks do not see, or see otherwise, such as on disks
// of their own, and files that are right as files but contain what no triangulation has. All ranks
// refuse them, and keep what they had; none waits forever: that would be a timeout of the test.

#include "distributed_periodic_oracle.h"
#include "distributed_theme.h"
#include "distributed_uses.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace distributed_files {

namespace fs = std::filesystem;

const Cell cell(8, 8);
const std::string name = "checkpoint";

Population some_points(unsigned seed)
{
  std::mt19937 random(seed);
  return numbered(any_points(50, 8, random));
}

void write(const fs::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

// Each rank works in a directory of its own, as on a disk of its own.
class Own_directory
{
public:
  Own_directory()
    : m_before(fs::current_path())
    , m_path(file_name("distributed_files") + "_" + std::to_string(this_rank))
  {
    fs::create_directory(m_path);
    fs::current_path(m_path);
  }
  Own_directory(const Own_directory&) = delete;
  Own_directory& operator=(const Own_directory&) = delete;
  ~Own_directory()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    fs::current_path(m_before);
    fs::remove_all(m_path);
  }

private:
  fs::path m_before, m_path;
};

template <class Call>
void expect_refusal(const Call& call, const std::string& message, const std::string& what)
{
  expect(tells<CGAL::Checkpoint_error_2>(call, message), what + " is refused on all ranks");
}

template <class Triangulation>
void arguments_that_differ(Triangulation& dt)
{
  const std::string path = differing<std::string>("there", "here");
  const std::string told = "the path must be the same on all ranks: rank 0 gives 'here'";
  expect_refusal([&] { dt.write_checkpoint(path); }, told, "writing at paths that differ");
  expect_refusal([&] { dt.read_checkpoint(path); }, told, "reading at paths that differ");
  std::vector<Id> ids = dt.owned_ids();
  std::vector<char> short_data(ids.size());
  const std::string other = "the data must be the same on all ranks: rank 0 gives 8 bytes";
  const auto either = [&](const auto& last, const auto& others) { is_last() ? last() : others(); };
  const auto writes = [&] { dt.write_checkpoint(name, ids); };
  const auto reads = [&] { dt.read_checkpoint(name, ids); };
  expect_refusal([&] { either([&] { dt.write_checkpoint(name); }, writes); }, other,
                 "writing data of some ranks");
  expect_refusal([&] { either([&] { dt.write_checkpoint(name, short_data); }, writes); }, other,
                 "writing data of other sizes");
  expect_refusal([&] { either([&] { dt.read_checkpoint(name); }, reads); }, other,
                 "reading data on some ranks");
  expect_refusal([&] { either([&] { dt.read_checkpoint(name, short_data); }, reads); }, other,
                 "reading data of other sizes");
}

// Only rank 0 sees its files.
template <class Triangulation>
void files_on_own_disks(Triangulation& dt, const std::string& good, const std::string& other)
{
  const auto writes = [&] { dt.write_checkpoint(name); };
  const auto reads = [&] { dt.read_checkpoint(name); };
  expect_refusal(writes, "rank 1: cannot write 'checkpoint.unfinished', which rank 0 has created",
                 "writing on disks of ranks");
  write(name, good);
  if (this_rank > 0)
    write(name + ".unfinished", good);
  MPI_Barrier(MPI_COMM_WORLD);
  expect_refusal(writes, "rank 1: 'checkpoint.unfinished' is not the file that rank 0 has created",
                 "writing into other files");
  expect(this_rank > 0 || !fs::exists(name + ".unfinished"), "no unfinished file is left");
  reads(); // all of them see the same
  write(name, is_last() ? other : good);
  expect_refusal(reads, "its points are not those that were written", "a file of other points");
  write(name, is_last() ? good.substr(1) : good);
  expect_refusal(reads, "this is no checkpoint", "a damaged file on one rank");
  write(name, is_last() ? good.substr(0, good.size() - 1) : good);
  expect_refusal(reads, "cut off", "a shorter file on one rank");
  if (is_last())
    fs::remove(name);
  expect_refusal(reads, "rank " + std::to_string(number_of_ranks - 1) + ": cannot read it",
                 "a file that one rank does not see");
}

template <class Triangulation>
void no_files(Triangulation& dt)
{
  fs::create_directory("directory");
  fs::create_directory("taken.unfinished");
  mkfifo("pipe", 0600);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string pipe = "it is no file, but a device or a pipe", directory = "is a directory";
  for (const std::string& path : {std::string("directory"), std::string(".")}) {
    expect_refusal([&] { dt.read_checkpoint(path); }, directory, "reading a directory");
    expect_refusal([&] { dt.write_checkpoint(path); }, directory, "writing a directory");
  }
  expect_refusal([&] { dt.read_checkpoint("pipe"); }, pipe, "reading a pipe");
  expect_refusal([&] { dt.write_checkpoint("pipe"); }, pipe, "writing a pipe");
  expect_refusal([&] { dt.write_checkpoint("taken"); }, "cannot write 'taken.unfinished'",
                 "writing where a directory is");
  expect_refusal([&] { dt.read_checkpoint(""); }, "cannot read it", "reading at no path");
  expect_refusal([&] { dt.write_checkpoint("no/file"); }, "cannot write 'no/file.unfinished'",
                 "writing in no directory");
}

struct Record
{
  Id id;
  double x, y;
};

std::uint64_t hash_of(const void* data, std::size_t size)
{
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t k = 0; k < size; ++k)
    hash = (hash ^ static_cast<const unsigned char*>(data)[k]) * 0x100000001b3;
  return hash;
}

// A file with a right sum.
std::string forged(const std::string& kind, const std::vector<double>& vectors,
                   const std::vector<Record>& records)
{
  std::array<std::uint64_t, 4> words{0x0102030405060708, 0, records.size(), 0};
  for (const Record& record : records)
    words[3] += hash_of(&record, sizeof(record));
  const std::size_t size = vectors.size() * sizeof(double);
  words[3] += vectors.empty() ? 0 : hash_of(vectors.data(), size);
  std::string bytes = "distributed " + kind + " 1\n";
  bytes.resize(24);
  bytes.append(reinterpret_cast<const char*>(words.data()), sizeof(words));
  bytes.append(reinterpret_cast<const char*>(vectors.data()), size);
  bytes.append(reinterpret_cast<const char*>(records.data()), records.size() * sizeof(Record));
  return bytes;
}

const double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<Record> good_records{{5, 0.1, 0.2}, {3, 1.3, 0.4}, {4, 0.5, 1.7}, {9, 3, 3.3}};

std::vector<Record> with(const Record& last)
{
  std::vector<Record> records = good_records;
  records.push_back(last);
  return records;
}

template <class Triangulation>
void forged_files(Triangulation& dt, const std::string& kind, const std::vector<double>& vectors)
{
  const auto reads = [&](const std::vector<double>& cell_vectors,
                         const std::vector<Record>& records) {
    return [&dt, bytes = forged(kind, cell_vectors, records)] {
      write(name, bytes);
      dt.read_checkpoint(name);
    };
  };
  const std::string number = "both must be finite numbers";
  expect_refusal(reads(vectors, with({7, nan, 0})), number, "a forged position");
  expect_refusal(reads(vectors, with({7, 0, HUGE_VAL})), number, "a forged infinite position");
  expect_refusal(reads(vectors, with({3, 2, 2})), "the id 3 is there more than once",
                 "a forged id");
  if (vectors.empty())
    return;
  expect_refusal(reads(vectors, with({7, 1e9, 0})), "multiples", "a forged position far away");
  expect_refusal(reads({1, 2, 2, 4}, good_records), "must not be parallel", "a forged cell");
  expect_refusal(reads({1, nan, 2, 4}, good_records), "must be finite", "a forged cell of NaN");
  expect_refusal(reads({1, 0, 0, 1e-14}, good_records), "so thin", "a forged thin cell");
  expect_refusal(reads({1e-300, 0, 0, 1e-300}, good_records), "how far points are apart",
                 "a forged extreme cell");
}

// Whatever is read although no program has written it is triangulated as well.
template <class Triangulation>
void forged_files_that_are_read(Triangulation& dt, const std::string& kind,
                                const std::vector<double>& vectors)
{
  write(name, forged(kind, vectors, good_records));
  dt.read_checkpoint(name);
  Population points;
  for (const Record& record : good_records)
    points.emplace(record.id, Point(record.x, record.y));
  expect_exact(dt, points, "points of a forged file");
  expect(dt.is_valid(), "a forged file is valid");
}

// `vectors` are those of the cell in a forged file; there are none in the plane.
template <class Triangulation, class... Arguments>
void files(const std::string& kind, const std::vector<double>& vectors,
           const Arguments&... arguments)
{
  const Own_directory directory;
  const Population points = some_points(3);
  const std::string path = file_name("distributed_files_of_all");
  const auto written = [&](const Population& population) {
    distributed<Triangulation>(population, in_order, arguments...).write_checkpoint(path);
    std::ifstream in(path, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  };
  const std::string other = written(some_points(4)), good = written(points);
  auto dt = distributed<Triangulation>(points, in_order, arguments...);
  no_files(dt);
  forged_files(dt, kind, vectors);
  if (number_of_ranks > 1) {
    arguments_that_differ(dt);
    files_on_own_disks(dt, good, other);
  }
  expect_exact(dt, points, kind + ": after refusals");
  forged_files_that_are_read(dt, kind, vectors);
  if (this_rank == 0)
    fs::remove(path);
}

void run_theme()
{
  files<Distributed>("Delaunay", {});
  files<Distributed_periodic>("periodic", {10.1, 0.3, 0.1, 9.7}, cell);
}

const Theme theme("distributed_files", run_theme);

} // namespace distributed_files
