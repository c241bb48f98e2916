// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_WATCHDOG_H
#define ROBUSTNESS_WATCHDOG_H

#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <list>
#include <mutex>
#include <thread>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace robustness {

// The operation that a thread performs, to be reported if the program has to end.
struct Watched_thread
{
  std::atomic<std::uint64_t> seed{0};
  std::atomic<const char*> family{""};
  std::atomic<std::uint64_t> operation{0};
  std::atomic<std::int64_t> since{0}; // milliseconds; 0 if the thread is idle

  static std::int64_t now()
  {
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
  }
};

// A line of text made without allocation: a signal may have interrupted an allocation.
class Last_words
{
public:
  Last_words& operator<<(const char* text)
  {
    while (*text != '\0' && m_size < sizeof(m_text)) {
      m_text[m_size++] = *text++;
    }
    return *this;
  }

  Last_words& operator<<(std::uint64_t number)
  {
    char digits[21] = {}; // one more than any number has: zeros end the text
    std::to_chars(digits, digits + 20, number);
    return *this << digits;
  }

  void say() const
  {
#ifdef _WIN32
    _write(2, m_text, static_cast<unsigned>(m_size));
#else
    if (::write(STDERR_FILENO, m_text, m_size) < 0) {
      return; // nothing listens
    }
#endif
  }

private:
  char m_text[512] = {};
  std::size_t m_size = 0;
};

inline void say_where(const Watched_thread& thread, const char* what)
{
  Last_words words;
  words << "\nrobustness: " << what << " in operation " << thread.operation.load()
        << " of the trial that --family " << thread.family.load() << " --trial "
        << thread.seed.load() << " repeats\n";
  words.say();
}

inline thread_local Watched_thread* this_thread_watched = nullptr;

extern "C" inline void robustness_take_signal(int signal)
{
  if (this_thread_watched != nullptr) {
    say_where(*this_thread_watched, signal == SIGSEGV   ? "invalid memory (SIGSEGV)"
                                    : signal == SIGABRT ? "aborted (SIGABRT)"
                                                        : "killed by a signal");
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

inline void watch_signals()
{
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL}) {
    std::signal(signal, robustness_take_signal);
  }
}

// Ends the program if an operation takes too long.
class Watchdog
{
public:
  explicit Watchdog(double time_limit_in_seconds)
    : m_time_limit(static_cast<std::int64_t>(1000.0 * time_limit_in_seconds))
    , m_thread([this] { watch(); })
  {
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  ~Watchdog()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
    }
    m_end.notify_all();
    m_thread.join();
  }

  // Adds a thread. The reference stays valid.
  Watched_thread& add_thread()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_watched.emplace_back();
  }

private:
  void watch()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    while (!m_end.wait_for(lock, std::chrono::milliseconds(200), [this] { return m_is_over; })) {
      for (const Watched_thread& thread : m_watched) {
        const std::int64_t since = thread.since;
        if (since != 0 && Watched_thread::now() - since > m_time_limit) {
          say_where(thread, "no end");
          std::_Exit(EXIT_FAILURE);
        }
      }
    }
  }

  std::int64_t m_time_limit; // milliseconds
  std::mutex m_mutex;
  std::condition_variable m_end;
  bool m_is_over = false;
  std::list<Watched_thread> m_watched;
  std::thread m_thread; // the last one: it uses the others
};

} // namespace robustness

#endif // ROBUSTNESS_WATCHDOG_H
