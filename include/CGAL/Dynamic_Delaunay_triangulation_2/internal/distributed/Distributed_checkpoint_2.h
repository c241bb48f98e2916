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
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
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
//
// If some ranks cannot open a file that others can, MPI_File_open() may wait forever. So all ranks
// open it by themselves before. A file that is to be written begins with a random number by which
// ranks find out whether they see the same one: each may have a disk of its own.
template <class Space>
class Distributed_checkpoint_2
{
  using Entry = Distributed_entry_2;

public:
  using Parameters = typename Space::Parameters;

  // `data_size` is how many bytes of data each point has. Throws unless all ranks give the same
  // path and size.
  Distributed_checkpoint_2(Distributed_ranks_2& ranks, const std::string& path,
                           std::size_t data_size)
    : m_ranks(ranks)
    , m_path(path)
    , m_unfinished(path + ".unfinished")
    , m_data_size(data_size)
    , m_record(sizeof(Entry) + data_size)
  {
    refuse_different("the path", "'" + m_path + "'");
    refuse_different("the data", std::to_string(data_size) + " bytes of each point");
  }

  // `data` has `data_size` bytes for each point.
  void write(const Parameters& parameters, const std::vector<Entry>& entries, const char* data)
  {
    std::vector<char> bytes(entries.size() * m_record);
    for (std::size_t k = 0; k < entries.size(); ++k) {
      std::memcpy(&bytes[k * m_record], &entries[k], sizeof(Entry));
      if (m_data_size > 0)
        std::memcpy(&bytes[k * m_record + sizeof(Entry)], data + k * m_data_size, m_data_size);
    }
    Header header{{}, parameters};
    header.data_size = m_data_size;
    header.number_of_points = m_ranks.sum(entries.size());
    header.sum = m_ranks.sum(sum_of(bytes)) + sum_of(parameters);
    const std::vector<std::uint64_t> sizes =
        m_ranks.gather(std::vector<std::uint64_t>{bytes.size()}).values;
    std::uint64_t offset = sizeof(Header);
    for (int r = 0; r < m_ranks.rank(); ++r)
      offset += sizes[std::size_t(r)];

    refuse(trouble_with_kind());
    create();
    refuse_unfinished(write_parts(header, bytes, offset));
    const bool renames = m_ranks.rank() == 0;
    refuse_unfinished(renames && std::rename(m_unfinished.c_str(), m_path.c_str()) != 0
                          ? "cannot rename '" + m_unfinished + "': " + last_error()
                          : "");
  }

  // Appends an even share of the points to `entries`, and their data to `data`.
  void read(Parameters& parameters, std::vector<Entry>& entries, std::vector<char>& data)
  {
    refuse(trouble_with_kind());
    refuse(std::ifstream(m_path) ? "" : "cannot read it: " + last_error());
    MPI_File file;
    refuse(MPI_File_open(m_ranks.communicator(), m_path.c_str(), MPI_MODE_RDONLY, MPI_INFO_NULL,
                         &file) == MPI_SUCCESS
               ? ""
               : "MPI cannot read it");
    const std::string trouble = read_parts(file, parameters, entries, data);
    MPI_File_close(&file);
    refuse(trouble);
  }

  // Checks what was read: what `f()` throws about it is thrown as an error of this file.
  template <class Function>
  void check(const Function& f)
  {
    std::string trouble;
    try {
      f();
    } catch (const Dynamic_Delaunay_triangulation_error_2& error) {
      trouble = error.what();
    }
    refuse(trouble);
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

  static std::string last_error() { return std::generic_category().message(errno); }

  // Throws on all ranks if any of them has trouble: what the first one says.
  void refuse(const std::string& trouble)
  {
    if (!m_ranks.is_any(!trouble.empty()))
      return;
    const std::vector<std::string> all = m_ranks.texts(trouble);
    const auto first =
        std::find_if(all.begin(), all.end(), [](const auto& t) { return !t.empty(); });
    throw Checkpoint_error_2(0, "'" + m_path + "', rank " + std::to_string(first - all.begin()) +
                                    ": " + *first);
  }

  // The same, and there is no unfinished file any more.
  void refuse_unfinished(const std::string& trouble)
  {
    if (m_ranks.is_any(!trouble.empty()) && m_ranks.rank() == 0)
      std::remove(m_unfinished.c_str());
    refuse(trouble);
  }

  void refuse_different(const std::string& what, const std::string& given)
  {
    const std::vector<std::string> all = m_ranks.texts(given);
    for (std::size_t r = 0; r < all.size(); ++r)
      if (all[r] != all.front())
        throw Checkpoint_error_2(0, what + " must be the same on all ranks: rank 0 gives " +
                                        all.front() + ", rank " + std::to_string(r) + " " + all[r]);
  }

  // What is wrong if there is something of the path's name that is no usual file.
  std::string trouble_with_kind() const
  {
    std::error_code none;
    const std::filesystem::file_status status = std::filesystem::status(m_path, none);
    if (is_directory(status))
      return "it is a directory";
    return exists(status) && !is_regular_file(status) ? "it is no file, but a device or a pipe"
                                                      : "";
  }

  // Creates the unfinished file, and sees to it that all ranks can write it.
  void create()
  {
    std::random_device random;
    std::uint64_t mark = m_ranks.rank() == 0 ? std::uint64_t(random()) << 32 | random() : 0;
    mark = m_ranks.largest(mark);
    refuse(m_ranks.rank() == 0 ? trouble_with_creating(mark) : "");
    refuse_unfinished(trouble_with_finding(mark));
  }

  std::string trouble_with_creating(std::uint64_t mark) const
  {
    std::ofstream file(m_unfinished, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&mark), sizeof(mark)).flush();
    return file ? "" : "cannot write '" + m_unfinished + "': " + last_error();
  }

  std::string trouble_with_finding(std::uint64_t mark) const
  {
    std::uint64_t found = 0;
    std::fstream file(m_unfinished, std::ios::binary | std::ios::in | std::ios::out);
    if (!file)
      return "cannot write '" + m_unfinished + "', which rank 0 has created: " + last_error();
    file.read(reinterpret_cast<char*>(&found), sizeof(found));
    return found == mark ? "" : "'" + m_unfinished + "' is not the file that rank 0 has created";
  }

  // Writes all of the unfinished file. Returns what goes wrong on this rank.
  std::string write_parts(const Header& header, const std::vector<char>& bytes,
                          std::uint64_t offset)
  {
    MPI_File file;
    refuse_unfinished(MPI_File_open(m_ranks.communicator(), m_unfinished.c_str(), MPI_MODE_WRONLY,
                                    MPI_INFO_NULL, &file) == MPI_SUCCESS
                          ? ""
                          : "MPI cannot write '" + m_unfinished + "'");
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
    return is_written ? "" : "cannot write all of '" + m_unfinished + "'";
  }

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
                         std::vector<char>& data)
  {
    Header header{};
    MPI_Offset bytes_of_file = 0;
    MPI_Status status;
    header.name.fill(0);
    const bool is_read =
        MPI_File_get_size(file, &bytes_of_file) == MPI_SUCCESS &&
        std::size_t(bytes_of_file) >= sizeof(Header) &&
        MPI_File_read_at(file, 0, &header, sizeof(Header), MPI_BYTE, &status) == MPI_SUCCESS;
    const Beginning expected;
    std::string error;
    if (!is_read || header.name != expected.name)
      error = "this is no checkpoint of distributed points of this kind";
    else if (header.byte_order != expected.byte_order)
      error = "it was written on a machine with another order of bytes";
    else if (header.data_size != m_data_size)
      error = "each point has " + std::to_string(header.data_size) +
              " bytes of data, expected are " + std::to_string(m_data_size);
    else if ((std::uint64_t(bytes_of_file) - sizeof(Header)) / m_record !=
                 header.number_of_points ||
             (std::uint64_t(bytes_of_file) - sizeof(Header)) % m_record != 0)
      error = "it was cut off, or something was appended";
    if (m_ranks.is_any(!error.empty()))
      return error;

    const auto rank = std::uint64_t(m_ranks.rank());
    const std::uint64_t first = header.number_of_points * rank / m_ranks.size();
    const std::uint64_t beyond = header.number_of_points * (rank + 1) / m_ranks.size();
    std::vector<char> bytes((beyond - first) * m_record);
    const bool are_read = for_each_part(bytes.size(), [&](std::size_t place, int n) {
      return MPI_File_read_at_all(file, MPI_Offset(sizeof(Header) + first * m_record + place),
                                  bytes.data() + place, n, MPI_BYTE, &status);
    });
    parameters = header;
    const std::uint64_t sum = m_ranks.sum(sum_of(bytes)) + sum_of(parameters);
    if (!are_read || sum != header.sum)
      return "its points are not those that were written";
    for (std::size_t place = 0; place < bytes.size(); place += m_record) {
      entries.emplace_back();
      std::memcpy(&entries.back(), &bytes[place], sizeof(Entry));
      data.insert(data.end(), bytes.begin() + std::ptrdiff_t(place + sizeof(Entry)),
                  bytes.begin() + std::ptrdiff_t(place + m_record));
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
  std::uint64_t sum_of(const std::vector<char>& bytes) const { return sum_of(bytes, m_record); }
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
  std::string m_path, m_unfinished;
  std::size_t m_data_size, m_record;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHECKPOINT_2_H
