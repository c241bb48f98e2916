// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_RANKS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_RANKS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Message_exchange_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
template <class Space>
class Distributed_triangulation_base_2;
}

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The values that all ranks gave, one rank after the other.
template <class T>
struct Gathered_2
{
  std::vector<T> values;
  std::vector<std::size_t> offsets; // where the values of each rank begin, and the end
};

// The ranks of a copy of a communicator, so that messages of the program do not get mixed up with
// those of this class. All functions that communicate are collective.
class Distributed_ranks_2
{
public:
  explicit Distributed_ranks_2(MPI_Comm communicator)
    : m_communicator(copy(communicator))
    , m_exchange(m_communicator)
  {
    MPI_Comm_rank(m_communicator, &m_rank);
    MPI_Comm_size(m_communicator, &m_size);
  }
  Distributed_ranks_2(const Distributed_ranks_2&) = delete;
  Distributed_ranks_2& operator=(const Distributed_ranks_2&) = delete;
  ~Distributed_ranks_2()
  {
    int is_over = 0;
    MPI_Finalized(&is_over);
    if (!is_over)
      MPI_Comm_free(&m_communicator);
  }

  MPI_Comm communicator() const { return m_communicator; }
  int rank() const { return m_rank; }
  std::size_t size() const { return std::size_t(m_size); }
  const Message_exchange_2& exchange() const { return m_exchange; }
  Message_exchange_2& exchange() { return m_exchange; }
  // The number of bytes that `gather()` has returned.
  std::size_t gathered_bytes() const { return m_gathered_bytes; }

  std::uint64_t sum(std::uint64_t value) { return reduced(value, MPI_UINT64_T, MPI_SUM); }
  std::uint64_t largest(std::uint64_t value) { return reduced(value, MPI_UINT64_T, MPI_MAX); }
  std::int64_t lowest(std::int64_t value) { return reduced(value, MPI_INT64_T, MPI_MIN); }
  template <std::size_t n>
  std::array<std::int64_t, n> lowest(const std::array<std::int64_t, n>& values)
  {
    return reduced(values, MPI_INT64_T, MPI_MIN, int(n));
  }
  double largest(double value) { return reduced(value, MPI_DOUBLE, MPI_MAX); }
  template <std::size_t n>
  std::array<std::uint64_t, n> largest(const std::array<std::uint64_t, n>& values)
  {
    return reduced(values, MPI_UINT64_T, MPI_MAX, int(n));
  }
  bool is_any(bool is_so) { return largest(std::uint64_t(is_so)) != 0; }

  template <class T>
  Gathered_2<T> gather(const std::vector<T>& own)
  {
    static_assert(std::is_trivially_copyable_v<T>, "only plain data can be sent");
    const double begin = MPI_Wtime();
    const std::uint64_t size = own.size();
    std::vector<std::uint64_t> sizes(this->size());
    MPI_Allgather(&size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, m_communicator);
    Gathered_2<T> all;
    all.offsets.push_back(0);
    std::vector<int> bytes, places;
    for (const std::uint64_t n : sizes) {
      places.push_back(int(all.offsets.back() * sizeof(T)));
      bytes.push_back(int(n * sizeof(T)));
      all.offsets.push_back(all.offsets.back() + n);
      if (all.offsets.back() > std::size_t((std::numeric_limits<int>::max)()) / sizeof(T))
        throw std::length_error("what all ranks have to know is longer than 2 GB");
    }
    all.values.resize(all.offsets.back());
    m_gathered_bytes += all.values.size() * sizeof(T);
    if (!all.values.empty())
      MPI_Allgatherv(own.data(), int(size * sizeof(T)), MPI_BYTE, all.values.data(), bytes.data(),
                     places.data(), MPI_BYTE, m_communicator);
    m_exchange.add_seconds(MPI_Wtime() - begin);
    return all;
  }

  // The texts of all ranks.
  std::vector<std::string> texts(const std::string& own)
  {
    const Gathered_2<char> all = gather(std::vector<char>(own.begin(), own.end()));
    std::vector<std::string> texts;
    for (std::size_t r = 0; r < size(); ++r)
      texts.emplace_back(all.values.begin() + std::ptrdiff_t(all.offsets[r]),
                         all.values.begin() + std::ptrdiff_t(all.offsets[r + 1]));
    return texts;
  }

  // Whether all ranks give the same value.
  template <class T>
  bool is_same(const T& value)
  {
    const std::vector<T> all = gather(std::vector<T>{value}).values;
    return std::count(all.begin(), all.end(), value) == m_size;
  }

  // One empty message to each rank, for `send()`. Messages that stay empty are not sent.
  std::vector<Message_2> empty_messages() const
  {
    std::vector<Message_2> messages;
    for (int r = 0; r < m_size; ++r)
      messages.emplace_back(r);
    return messages;
  }
  std::vector<Message_2> send(std::vector<Message_2> messages)
  {
    m_exchange.start();
    for (Message_2& message : messages)
      m_exchange.send(std::move(message));
    return m_exchange.finish();
  }

  // Sends values, each to one rank: `fill(post)` calls post(rank, value). Returns the values that
  // arrive here, ascending by senders; those of one sender are in the order in which it sent them.
  template <class T, class Fill>
  std::vector<T> delivered(const Fill& fill)
  {
    std::vector<Message_2> messages = empty_messages();
    fill([&](std::size_t rank, const T& value) { messages[rank].write(value); });
    std::vector<T> arrived;
    for (Message_2& message : send(std::move(messages)))
      while (!message.is_read())
        arrived.push_back(message.template read<T>());
    return arrived;
  }

  // Begins a collective call, by its name, with reading its input. If that throws on any rank it
  // throws on all of them; and so it does if ranks have begun different calls, which would wait for
  // each other forever. So each collective call has to begin with this.
  template <class Read>
  void agree(const std::string& call, const Read& read)
  {
    std::exception_ptr error;
    try {
      read();
    } catch (...) {
      error = std::current_exception();
    }
    const auto key = std::int64_t(std::hash<std::string>()(call));
    const auto [first, lowest_key, lowest_inverse] =
        lowest(std::array<std::int64_t, 3>{error ? m_rank : m_size, key, ~key});
    if (lowest_key != ~lowest_inverse)
      refuse_different(texts(call));
    if (error)
      std::rethrow_exception(error);
    if (first < m_size)
      throw Distributed_input_error_2(int(first));
  }
  void agree(const std::string& call)
  {
    agree(call, [] {});
  }

private:
  [[noreturn]] static void refuse_different(const std::vector<std::string>& calls)
  {
    const auto other = std::find_if(calls.begin(), calls.end(),
                                    [&](const std::string& call) { return call != calls.front(); });
    throw Distributed_input_error_2(int(other - calls.begin()), calls.front(), *other);
  }

  static MPI_Comm copy(MPI_Comm communicator)
  {
    MPI_Comm copied;
    MPI_Comm_dup(communicator, &copied);
    return copied;
  }

  // T is a number, or an array of `count` numbers.
  template <class T>
  T reduced(const T& values, MPI_Datatype type, MPI_Op operation, int count = 1)
  {
    if (m_size == 1)
      return values;
    const double begin = MPI_Wtime();
    T result;
    MPI_Allreduce(&values, &result, count, type, operation, m_communicator);
    m_exchange.add_seconds(MPI_Wtime() - begin);
    return result;
  }

  MPI_Comm m_communicator;
  Message_exchange_2 m_exchange;
  int m_rank = 0, m_size = 1;
  std::size_t m_gathered_bytes = 0;
};

// What other headers of the package use of distributed triangulations, and programs do not.
struct Distributed_access_2
{
  template <class Space>
  static auto& ranks(Distributed_triangulation_base_2<Space>& dt)
  {
    return dt.m_core.ranks();
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_RANKS_2_H
