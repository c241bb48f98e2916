// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of MPI that distributed triangulations use, with threads of one process as ranks: so a
// fuzzer sees what all ranks do, and a run takes milliseconds. `run_ranks(n, f)` calls f() on n
// ranks. Names are those of the standard, and each function does what the standard says, for the
// arguments that occur. An order that the standard leaves open depends only on how threads run.
// MPI_Test() and MPI_Testall() wait up to 1 ms for news. Functions for files are declared only.

#ifndef THREADS_AS_RANKS_MPI_H
#define THREADS_AS_RANKS_MPI_H

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace threads_as_ranks {

struct Sent_message
{
  int source, communicator, tag;
  std::vector<char> bytes;
  bool is_taken = false;
};
using Handle = std::shared_ptr<Sent_message>;

// A send, which ends when its message is taken, or a barrier, which ends when all have entered.
struct Request
{
  Handle sent;
  std::pair<int, int> barrier{-1, 0};
};

class World
{
public:
  explicit World(int size)
    : m_size(size)
    , m_boxes(std::size_t(size))
    , m_given(std::size_t(size))
    , m_news(std::size_t(size))
  {
  }

  int size() const { return m_size; }

  // All ranks call this; f(given) reads what all of them have given, before any of them goes on.
  template <class Function>
  void together(int rank, const void* given, const Function& f)
  {
    m_given[std::size_t(rank)] = given;
    meet();
    f(m_given);
    meet();
  }

  void send(int target, const Handle& message)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_boxes[std::size_t(target)].push_back(message);
    m_news[std::size_t(target)].tell();
  }

  Handle find(int rank, int communicator, int tag)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    auto& box = m_boxes[std::size_t(rank)];
    const auto found = std::find_if(box.begin(), box.end(), [&](const Handle& message) {
      return message->communicator == communicator && message->tag == tag;
    });
    if (found == box.end())
      return nullptr;
    const Handle message = *found;
    box.erase(found);
    return message;
  }

  void take(const Handle& message)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    message->is_taken = true;
    m_news[std::size_t(message->source)].tell();
  }

  void enter(const std::pair<int, int>& barrier)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (++m_entered[barrier] == m_size)
      for (News& news : m_news)
        news.tell();
  }

  bool is_over(const Request& request)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return request.sent ? request.sent->is_taken : m_entered[request.barrier] == m_size;
  }

  // Waits for news since the rank's last wait, at most 1 ms: it may have other things to do.
  void wait_for_news(int rank)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    News& news = m_news[std::size_t(rank)];
    news.is_there.wait_for(lock, std::chrono::milliseconds(1), [&] { return news.are_some; });
    news.are_some = false;
  }

private:
  // News for one rank: a message to it, a message from it that has been taken, or a barrier's end.
  struct News
  {
    std::condition_variable is_there;
    bool are_some = false;

    void tell()
    {
      are_some = true;
      is_there.notify_one();
    }
  };

  void meet()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    const std::size_t meeting = m_meetings;
    if (++m_there == m_size) {
      m_there = 0;
      ++m_meetings;
      m_all_there.notify_all();
    }
    m_all_there.wait(lock, [&] { return m_meetings != meeting; });
  }

  int m_size, m_there = 0;
  std::size_t m_meetings = 0;
  std::mutex m_mutex;
  std::condition_variable m_all_there;
  std::vector<std::deque<Handle>> m_boxes;      // by ranks
  std::vector<const void*> m_given;             // by ranks
  std::vector<News> m_news;                     // by ranks
  std::map<std::pair<int, int>, int> m_entered; // by barriers
};

// The state of the rank that this thread is.
inline thread_local World* world = nullptr;
inline thread_local int rank = 0, communicators = 0;
inline thread_local std::map<int, int> barriers; // entered so far, by communicators

template <class Function>
void run_ranks(int size, const Function& f)
{
  World all(size);
  std::vector<std::thread> threads;
  for (int r = 0; r < size; ++r)
    threads.emplace_back([&, r] {
      world = &all;
      rank = r;
      f();
    });
  for (std::thread& thread : threads)
    thread.join();
}

enum class Type : std::size_t { BYTE = 1, INT = 4, WORD = 8, SIGNED_WORD = 9, REAL = 10 };
enum class Operation { SUM, MIN, MAX };

inline std::size_t size_of(Type type)
{
  return (std::min)(std::size_t(type), std::size_t(8));
}

template <class T>
void reduce(const std::vector<const void*>& given, T* result, int count, Operation operation)
{
  for (int k = 0; k < count; ++k) {
    T all = static_cast<const T*>(given.front())[k];
    for (std::size_t r = 1; r < given.size(); ++r) {
      const T one = static_cast<const T*>(given[r])[k];
      all = operation == Operation::SUM   ? all + one
            : operation == Operation::MIN ? (std::min)(all, one)
                                          : (std::max)(all, one);
    }
    result[k] = all;
  }
}

} // namespace threads_as_ranks

using MPI_Comm = int;
using MPI_Datatype = threads_as_ranks::Type;
using MPI_Op = threads_as_ranks::Operation;
using MPI_Request = threads_as_ranks::Request;
using MPI_Message = threads_as_ranks::Handle;
using MPI_Offset = long long;
using MPI_File = int;
using MPI_Info = int;
struct MPI_Status
{
  int MPI_SOURCE;
  std::size_t bytes;
};

inline constexpr MPI_Comm MPI_COMM_WORLD = 0;
inline constexpr MPI_Datatype MPI_BYTE = threads_as_ranks::Type::BYTE;
inline constexpr MPI_Datatype MPI_INT = threads_as_ranks::Type::INT;
inline constexpr MPI_Datatype MPI_UINT64_T = threads_as_ranks::Type::WORD;
inline constexpr MPI_Datatype MPI_INT64_T = threads_as_ranks::Type::SIGNED_WORD;
inline constexpr MPI_Datatype MPI_DOUBLE = threads_as_ranks::Type::REAL;
inline constexpr MPI_Op MPI_SUM = threads_as_ranks::Operation::SUM;
inline constexpr MPI_Op MPI_MIN = threads_as_ranks::Operation::MIN;
inline constexpr MPI_Op MPI_MAX = threads_as_ranks::Operation::MAX;
inline const MPI_Request MPI_REQUEST_NULL;
inline constexpr int MPI_SUCCESS = 0, MPI_ANY_SOURCE = -1, MPI_INFO_NULL = 0;
inline constexpr int MPI_MODE_CREATE = 1, MPI_MODE_RDONLY = 2, MPI_MODE_WRONLY = 4;
inline MPI_Status* const MPI_STATUS_IGNORE = nullptr;
inline MPI_Status* const MPI_STATUSES_IGNORE = nullptr;

inline int MPI_Init(int*, char***)
{
  return MPI_SUCCESS;
}

inline int MPI_Comm_rank(MPI_Comm, int* rank)
{
  *rank = threads_as_ranks::rank;
  return MPI_SUCCESS;
}

inline int MPI_Comm_size(MPI_Comm, int* size)
{
  *size = threads_as_ranks::world->size();
  return MPI_SUCCESS;
}

// All ranks do this in the same order, so they all count alike.
inline int MPI_Comm_dup(MPI_Comm, MPI_Comm* copy)
{
  *copy = ++threads_as_ranks::communicators;
  return MPI_SUCCESS;
}

inline int MPI_Comm_free(MPI_Comm*)
{
  return MPI_SUCCESS;
}

inline int MPI_Finalized(int* is_over)
{
  *is_over = 0;
  return MPI_SUCCESS;
}

[[noreturn]] inline int MPI_Abort(MPI_Comm, int)
{
  std::abort();
}

inline double MPI_Wtime()
{
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

inline int MPI_Allreduce(const void* own, void* result, int count, MPI_Datatype type,
                         MPI_Op operation, MPI_Comm)
{
  using namespace threads_as_ranks;
  world->together(rank, own, [&](const std::vector<const void*>& given) {
    if (type == MPI_UINT64_T)
      reduce(given, static_cast<std::uint64_t*>(result), count, operation);
    else if (type == MPI_INT64_T)
      reduce(given, static_cast<std::int64_t*>(result), count, operation);
    else
      reduce(given, static_cast<double*>(result), count, operation);
  });
  return MPI_SUCCESS;
}

inline int MPI_Allgatherv(const void* own, int, MPI_Datatype type, void* result, const int* counts,
                          const int* places, MPI_Datatype, MPI_Comm)
{
  using namespace threads_as_ranks;
  world->together(rank, own, [&](const std::vector<const void*>& given) {
    for (std::size_t r = 0; r < given.size(); ++r)
      if (counts[r] > 0)
        std::memcpy(static_cast<char*>(result) + std::size_t(places[r]) * size_of(type), given[r],
                    std::size_t(counts[r]) * size_of(type));
  });
  return MPI_SUCCESS;
}

inline int MPI_Allgather(const void* own, int count, MPI_Datatype type, void* result, int,
                         MPI_Datatype, MPI_Comm communicator)
{
  std::vector<int> counts(std::size_t(threads_as_ranks::world->size()), count), places;
  for (std::size_t r = 0; r < counts.size(); ++r)
    places.push_back(int(r) * count);
  return MPI_Allgatherv(own, count, type, result, counts.data(), places.data(), type, communicator);
}

inline int MPI_Gatherv(const void* own, int count, MPI_Datatype type, void* result,
                       const int* counts, const int* places, MPI_Datatype, int root,
                       MPI_Comm communicator)
{
  const std::vector<int> none(std::size_t(threads_as_ranks::world->size()), 0);
  const bool is_root = threads_as_ranks::rank == root;
  return MPI_Allgatherv(own, count, type, result, is_root ? counts : none.data(),
                        is_root ? places : none.data(), type, communicator);
}

inline int MPI_Gather(const void* own, int count, MPI_Datatype type, void* result, int,
                      MPI_Datatype, int root, MPI_Comm communicator)
{
  std::vector<int> counts(std::size_t(threads_as_ranks::world->size()), count), places;
  for (std::size_t r = 0; r < counts.size(); ++r)
    places.push_back(int(r) * count);
  return MPI_Gatherv(own, count, type, result, counts.data(), places.data(), type, root,
                     communicator);
}

inline int MPI_Issend(const void* data, int count, MPI_Datatype type, int target, int tag,
                      MPI_Comm communicator, MPI_Request* request)
{
  using namespace threads_as_ranks;
  const char* const bytes = static_cast<const char*>(data);
  const auto message = std::make_shared<Sent_message>();
  *message = {rank, communicator, tag,
              std::vector<char>(bytes, bytes + std::size_t(count) * size_of(type)), false};
  request->sent = message;
  world->send(target, message);
  return MPI_SUCCESS;
}

inline int MPI_Improbe(int, int tag, MPI_Comm communicator, int* is_there, MPI_Message* message,
                       MPI_Status* status)
{
  using namespace threads_as_ranks;
  *message = world->find(rank, communicator, tag);
  *is_there = *message != nullptr;
  if (*is_there)
    *status = {(*message)->source, (*message)->bytes.size()};
  return MPI_SUCCESS;
}

inline int MPI_Get_count(const MPI_Status* status, MPI_Datatype type, int* count)
{
  *count = int(status->bytes / threads_as_ranks::size_of(type));
  return MPI_SUCCESS;
}

inline int MPI_Mrecv(void* data, int, MPI_Datatype, MPI_Message* message, MPI_Status*)
{
  if (!(*message)->bytes.empty())
    std::memcpy(data, (*message)->bytes.data(), (*message)->bytes.size());
  threads_as_ranks::world->take(*message);
  return MPI_SUCCESS;
}

inline int MPI_Ibarrier(MPI_Comm communicator, MPI_Request* request)
{
  using namespace threads_as_ranks;
  *request = {nullptr, {communicator, barriers[communicator]++}};
  world->enter(request->barrier);
  return MPI_SUCCESS;
}

inline int MPI_Test(MPI_Request* request, int* is_over, MPI_Status*)
{
  *is_over = threads_as_ranks::world->is_over(*request);
  if (!*is_over)
    threads_as_ranks::world->wait_for_news(threads_as_ranks::rank);
  return MPI_SUCCESS;
}

inline int MPI_Testall(int count, MPI_Request* requests, int* are_over, MPI_Status*)
{
  *are_over = std::all_of(requests, requests + count, [](const MPI_Request& request) {
    return threads_as_ranks::world->is_over(request);
  });
  if (!*are_over)
    threads_as_ranks::world->wait_for_news(threads_as_ranks::rank);
  return MPI_SUCCESS;
}

int MPI_File_open(MPI_Comm, const char*, int, MPI_Info, MPI_File*);
int MPI_File_close(MPI_File*);
int MPI_File_get_size(MPI_File, MPI_Offset*);
int MPI_File_set_size(MPI_File, MPI_Offset);
int MPI_File_sync(MPI_File);
int MPI_File_read_at(MPI_File, MPI_Offset, void*, int, MPI_Datatype, MPI_Status*);
int MPI_File_read_at_all(MPI_File, MPI_Offset, void*, int, MPI_Datatype, MPI_Status*);
int MPI_File_write_at(MPI_File, MPI_Offset, const void*, int, MPI_Datatype, MPI_Status*);
int MPI_File_write_at_all(MPI_File, MPI_Offset, const void*, int, MPI_Datatype, MPI_Status*);

#endif // THREADS_AS_RANKS_MPI_H
