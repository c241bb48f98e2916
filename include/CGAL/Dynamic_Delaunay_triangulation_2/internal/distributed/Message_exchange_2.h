// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_MESSAGE_EXCHANGE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_MESSAGE_EXCHANGE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A message from one rank to another, in words of 64 bits: the sender writes numbers and small
// structures one after the other, and the receiver reads them in the same order.
class Message_2
{
public:
  explicit Message_2(int rank = 0)
    : m_rank(rank)
  {
  }

  // The rank that the message goes to, or comes from.
  int rank() const { return m_rank; }
  bool is_empty() const { return m_words.empty(); }
  bool is_read() const { return m_next == m_words.size(); }
  std::vector<std::uint64_t>& words() { return m_words; }

  template <class T>
  void write(const T& value)
  {
    const std::size_t place = m_words.size();
    m_words.resize(place + words_of<T>());
    if constexpr (words_of<T>() > 0)
      std::memcpy(&m_words[place], &value, sizeof(T));
  }

  template <class T>
  T read()
  {
    if (m_words.size() - m_next < words_of<T>())
      throw std::runtime_error("a message between ranks is too short: they run different programs");
    T value;
    if constexpr (words_of<T>() > 0)
      std::memcpy(static_cast<void*>(&value), &m_words[m_next], sizeof(T));
    m_next += words_of<T>();
    return value;
  }

private:
  template <class T>
  static constexpr std::size_t words_of()
  {
    static_assert(std::is_trivially_copyable_v<T>, "only plain data can be sent");
    return std::is_empty_v<T> ? 0 : (sizeof(T) + 7) / 8;
  }

  int m_rank;
  std::vector<std::uint64_t> m_words;
  std::size_t m_next = 0;
};

// Exchanges messages between ranks that do not know what they will receive. All ranks call
// `start()`, then `send()` as often as they like, then `finish()`. A synchronous send ends when its
// message has been taken. When all its sends have ended a rank enters a barrier; once all ranks
// have, no message is left: Hoefler, Siebert, Lumsdaine, *Scalable communication protocols for
// dynamic sparse data exchange*, 2010. Cost: the messages themselves, and one barrier.
//
// What a rank sends to itself is received at once, without MPI.
//
// While messages are under way the program goes on; MPI may carry them on only when it is called,
// so a program that has much to do calls `progress()` now and then.
class Message_exchange_2
{
public:
  explicit Message_exchange_2(MPI_Comm communicator)
    : m_communicator(communicator)
  {
    MPI_Comm_rank(communicator, &m_rank);
    MPI_Comm_size(communicator, &m_size);
  }
  Message_exchange_2(const Message_exchange_2&) = delete;
  Message_exchange_2& operator=(const Message_exchange_2&) = delete;

  void start()
  {
    // A rank that has left the barrier may send in the next exchange while others still look for
    // messages of the last one: two tags in turn keep them apart.
    m_tag = 1 - m_tag;
    m_is_started = true;
  }

  // Starts to send a message, unless it is empty.
  void send(Message_2 message)
  {
    if (message.is_empty())
      return;
    const std::size_t size = message.words().size();
    if (size > std::size_t((std::numeric_limits<int>::max)()))
      throw std::length_error("a message between two ranks is longer than 16 GB");
    if (message.rank() == m_rank)
      return m_incoming.push_back(std::move(message));
    const double begin = MPI_Wtime();
    m_outgoing.push_back(std::move(message));
    m_requests.emplace_back();
    MPI_Issend(m_outgoing.back().words().data(), int(size), MPI_UINT64_T, m_outgoing.back().rank(),
               m_tag, m_communicator, &m_requests.back());
    m_are_taken = false;
    m_sent_messages += 1;
    m_sent_bytes += 8 * size;
    note_communication(begin);
  }

  // Lets MPI carry on what is under way, if anything is.
  void progress()
  {
    if (!m_is_started || m_size == 1)
      return;
    const double begin = MPI_Wtime();
    take();
    are_taken();
    note_communication(begin);
  }

  // Waits for all messages. Returns those to this rank, ascending by senders; those of one sender
  // are in the order in which it sent them.
  std::vector<Message_2> finish()
  {
    if (m_size > 1)
      wait();
    m_is_started = false;
    m_outgoing.clear();
    m_requests.clear();
    std::vector<Message_2> incoming = std::exchange(m_incoming, {});
    std::stable_sort(incoming.begin(), incoming.end(),
                     [](const Message_2& m, const Message_2& n) { return m.rank() < n.rank(); });
    return incoming;
  }

  // Since construction: messages and bytes that this rank has sent to others, seconds in which it
  // has sent, received or waited, and seconds in which it has done other things while messages that
  // it had sent were, for all it knew, under way.
  std::size_t sent_messages() const { return m_sent_messages; }
  std::size_t sent_bytes() const { return m_sent_bytes; }
  double seconds() const { return m_seconds; }
  double overlapped_seconds() const { return m_overlapped_seconds; }
  void add_seconds(double seconds) { m_seconds += seconds; }

private:
  // Adds the time since `begin`, when this rank turned from other things to communication.
  void note_communication(double begin)
  {
    const double end = MPI_Wtime();
    m_seconds += end - begin;
    if (m_is_under_way)
      m_overlapped_seconds += begin - m_latest;
    m_is_under_way = !m_are_taken;
    m_latest = end;
  }

  void wait()
  {
    const double begin = MPI_Wtime();
    MPI_Request barrier = MPI_REQUEST_NULL;
    bool is_in_barrier = false;
    for (int is_over = 0; !is_over;) {
      take();
      if (is_in_barrier) {
        MPI_Test(&barrier, &is_over, MPI_STATUS_IGNORE);
      } else if (are_taken()) {
        MPI_Ibarrier(m_communicator, &barrier);
        is_in_barrier = true;
      }
    }
    note_communication(begin);
  }

  bool are_taken()
  {
    int are_so = 0;
    MPI_Testall(int(m_requests.size()), m_requests.data(), &are_so, MPI_STATUSES_IGNORE);
    m_are_taken = are_so != 0;
    return m_are_taken;
  }

  void take()
  {
    for (;;) {
      int is_there = 0;
      MPI_Message handle;
      MPI_Status status;
      MPI_Improbe(MPI_ANY_SOURCE, m_tag, m_communicator, &is_there, &handle, &status);
      if (!is_there)
        return;
      int size = 0;
      MPI_Get_count(&status, MPI_UINT64_T, &size);
      Message_2 message(status.MPI_SOURCE);
      message.words().resize(std::size_t(size));
      MPI_Mrecv(message.words().data(), size, MPI_UINT64_T, &handle, MPI_STATUS_IGNORE);
      m_incoming.push_back(std::move(message));
    }
  }

  MPI_Comm m_communicator;
  int m_rank = 0, m_size = 1;
  int m_tag = 0;
  bool m_is_started = false;
  std::deque<Message_2> m_outgoing;
  std::vector<MPI_Request> m_requests; // of the messages above
  bool m_are_taken = true;             // all of them, as far as this rank knows
  std::vector<Message_2> m_incoming;
  std::size_t m_sent_messages = 0, m_sent_bytes = 0;
  double m_seconds = 0, m_overlapped_seconds = 0;
  double m_latest = 0;         // when it has sent, received or waited last
  bool m_is_under_way = false; // whether something was under way then
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_MESSAGE_EXCHANGE_2_H
