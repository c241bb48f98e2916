// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHECKPOINT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHECKPOINT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Writes and reads a checkpoint: the space, and ids, positions and the user's data of the points of
// all ranks, in one file that all ranks write and read together. The file has a header and a record
// of equal size for each point, both as they are in memory.
//
// A file is written under another name, and renamed when all of it is on the disk. So a file under
// the final name is always complete, whenever a rank dies. All functions are collective, and throw
// on all ranks or on none.
template <class Space>
class Distributed_checkpoint_2
{
  using Entry = Distributed_entry_2;

public:
  using Parameters = typename Space::Parameters;

  Distributed_checkpoint_2(Distributed_ranks_2& ranks, const std::string& path)
    : m_ranks(ranks)
    , m_path(path)
  {
  }

  // `data` has `size` bytes for each point.
  void write(const Parameters& parameters, const std::vector<Entry>& entries, const char* data,
             std::size_t size)
  {
    const std::size_t record = sizeof(Entry) + size;
    std::vector<char> bytes(entries.size() * record);
    for (std::size_t k = 0; k < entries.size(); ++k) {
      std::memcpy(&bytes[k * record], &entries[k], sizeof(Entry));
      if (size > 0)
        std::memcpy(&bytes[k * record + sizeof(Entry)], data + k * size, size);
    }
    Header header{{}, parameters};
    header.data_size = size;
    header.number_of_points = m_ranks.sum(entries.size());
    header.sum = m_ranks.sum(sum_of(bytes, record)) + sum_of(parameters);
    const std::vector<std::uint64_t> sizes =
        m_ranks.gather(std::vector<std::uint64_t>{bytes.size()}).values;
    std::uint64_t offset = sizeof(Header);
    for (int r = 0; r < m_ranks.rank(); ++r)
      offset += sizes[std::size_t(r)];

    const std::string unfinished = m_path + ".unfinished";
    MPI_File file;
    if (is_any_error(MPI_File_open(m_ranks.communicator(), unfinished.c_str(),
                                   MPI_MODE_CREATE | MPI_MODE_WRONLY, MPI_INFO_NULL, &file)))
      throw Checkpoint_error_2(0, "cannot write '" + unfinished + "'");
    MPI_Status status;
    bool is_written = MPI_File_set_size(file, 0) == MPI_SUCCESS;
    if (m_ranks.rank() == 0)
      is_written =
          MPI_File_write_at(file, 0, &header, sizeof(Header), MPI_BYTE, &status) == MPI_SUCCESS &&
          is_written;
    is_written =
        for_each_part(bytes.size(),
                      [&](std::size_t place, int n) {
                        return MPI_File_write_at_all(file, MPI_Offset(offset + place),
                                                     bytes.data() + place, n, MPI_BYTE, &status);
                      }) &&
        is_written;
    is_written = MPI_File_sync(file) == MPI_SUCCESS && is_written;
    is_written = MPI_File_close(&file) == MPI_SUCCESS && is_written;
    if (m_ranks.is_any(!is_written))
      throw Checkpoint_error_2(0, "cannot write all of '" + unfinished + "'");
    if (m_ranks.is_any(m_ranks.rank() == 0 && std::rename(unfinished.c_str(), m_path.c_str()) != 0))
      throw Checkpoint_error_2(0, "cannot rename '" + unfinished + "' to '" + m_path + "'");
  }

  // Appends an even share of the points to `entries`, and their data to `data`.
  void read(Parameters& parameters, std::vector<Entry>& entries, std::vector<char>& data,
            std::size_t size)
  {
    MPI_File file;
    if (is_any_error(MPI_File_open(m_ranks.communicator(), m_path.c_str(), MPI_MODE_RDONLY,
                                   MPI_INFO_NULL, &file)))
      throw Checkpoint_error_2(0, "cannot read '" + m_path + "'");
    const std::string error = read_parts(file, parameters, entries, data, size);
    MPI_File_close(&file);
    if (m_ranks.is_any(!error.empty()))
      throw Checkpoint_error_2(
          0, "'" + m_path + "': " + (error.empty() ? "another rank cannot read it" : error));
  }

private:
  struct Beginning
  {
    std::array<char, 24> name = Space::file_name;
    std::uint64_t byte_order = 0x0102030405060708;
    std::uint64_t data_size = 0;
    std::uint64_t number_of_points = 0;
    std::uint64_t sum = 0; // of the hashes of the records, in any order, and of the parameters
  };
  struct Header : Beginning, Parameters
  {
  };

  bool is_any_error(int result) { return m_ranks.is_any(result != MPI_SUCCESS); }

  // Calls f(place, n) for pieces of at most 2^30 bytes, so that MPI can count them; on all ranks
  // equally often. True if all calls succeed.
  template <class Function>
  bool for_each_part(std::size_t size, const Function& f)
  {
    constexpr std::size_t most = std::size_t(1) << 30;
    const std::uint64_t parts = m_ranks.largest(std::uint64_t((size + most - 1) / most));
    bool are_done = true;
    for (std::uint64_t k = 0; k < parts; ++k) {
      const std::size_t first = (std::min)(size, std::size_t(k) * most);
      are_done = f(first, int((std::min)(most, size - first))) == MPI_SUCCESS && are_done;
    }
    return are_done;
  }

  // Returns what this rank finds wrong with the file, or an empty text.
  std::string read_parts(MPI_File file, Parameters& parameters, std::vector<Entry>& entries,
                         std::vector<char>& data, std::size_t size)
  {
    Header header{};
    MPI_Offset bytes_of_file = 0;
    MPI_Status status;
    header.byte_order = 0;
    const bool is_read =
        MPI_File_get_size(file, &bytes_of_file) == MPI_SUCCESS &&
        std::size_t(bytes_of_file) >= sizeof(Header) &&
        MPI_File_read_at(file, 0, &header, sizeof(Header), MPI_BYTE, &status) == MPI_SUCCESS;
    const Beginning expected;
    std::string error;
    const std::size_t record = sizeof(Entry) + size;
    if (!is_read || header.name != expected.name)
      error = "this is no checkpoint of distributed points of this kind";
    else if (header.byte_order != expected.byte_order)
      error = "it was written on a machine with another order of bytes";
    else if (header.data_size != size)
      error = "each point has " + std::to_string(header.data_size) +
              " bytes of data, expected are " + std::to_string(size);
    else if ((std::uint64_t(bytes_of_file) - sizeof(Header)) / record != header.number_of_points ||
             (std::uint64_t(bytes_of_file) - sizeof(Header)) % record != 0)
      error = "it was cut off, or something was appended";
    if (m_ranks.is_any(!error.empty()))
      return error;

    const auto rank = std::uint64_t(m_ranks.rank());
    const std::uint64_t first = header.number_of_points * rank / m_ranks.size();
    const std::uint64_t beyond = header.number_of_points * (rank + 1) / m_ranks.size();
    std::vector<char> bytes((beyond - first) * record);
    const bool are_read = for_each_part(bytes.size(), [&](std::size_t place, int n) {
      return MPI_File_read_at_all(file, MPI_Offset(sizeof(Header) + first * record + place),
                                  bytes.data() + place, n, MPI_BYTE, &status);
    });
    parameters = header;
    const std::uint64_t sum = m_ranks.sum(sum_of(bytes, record)) + sum_of(parameters);
    if (!are_read || sum != header.sum)
      return "its points are not those that were written";
    for (std::size_t place = 0; place < bytes.size(); place += record) {
      entries.emplace_back();
      std::memcpy(&entries.back(), &bytes[place], sizeof(Entry));
      data.insert(data.end(), bytes.begin() + std::ptrdiff_t(place + sizeof(Entry)),
                  bytes.begin() + std::ptrdiff_t(place + record));
    }
    return error;
  }

  static std::uint64_t sum_of(const Parameters& parameters)
  {
    if constexpr (std::is_empty_v<Parameters>)
      return 0;
    std::vector<char> bytes(sizeof(Parameters));
    std::memcpy(bytes.data(), &parameters, bytes.size());
    return sum_of(bytes, bytes.size());
  }

  // Returns the sum of the FNV-1a hashes of all records.
  static std::uint64_t sum_of(const std::vector<char>& bytes, std::size_t record)
  {
    std::uint64_t sum = 0;
    for (std::size_t place = 0; place < bytes.size(); place += record) {
      std::uint64_t hash = 0xcbf29ce484222325;
      for (std::size_t k = place; k < place + record; ++k)
        hash = (hash ^ std::uint8_t(bytes[k])) * 0x100000001b3;
      sum += hash;
    }
    return sum;
  }

  Distributed_ranks_2& m_ranks;
  std::string m_path;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHECKPOINT_2_H
