// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_PHASE_MARKS_H
#define SPEED_PHASE_MARKS_H

#include <chrono>
#include <optional>

namespace speed {

// Nanoseconds of an update.
struct Phase_times
{
  double read = 0.0; // reading, checking and writing the positions
  double classify = 0.0;
  double repair = 0.0;
  double certify = 0.0; // all the rest
};

// When an update entered and left its classifier and its repair.
class Phase_marks
{
public:
  void start()
  {
    m_classify.reset();
    m_repair.reset();
    m_start = Clock::now();
  }

  template <class Work>
  void classify(Work work)
  {
    m_classify = span_of(work);
  }

  template <class Work>
  void repair(Work work)
  {
    m_repair = span_of(work);
  }

  // An update that has not come to its classifier is a rebuild, and counts as repair.
  Phase_times times(double total) const
  {
    Phase_times times;
    if (!m_classify) {
      times.repair = total;
      return times;
    }
    times.read = nanoseconds(m_start, m_classify->begin);
    times.classify = nanoseconds(m_classify->begin, m_classify->end);
    times.repair = m_repair ? nanoseconds(m_repair->begin, m_repair->end) : 0.0;
    times.certify = total - times.read - times.classify - times.repair;
    return times;
  }

private:
  using Clock = std::chrono::steady_clock;

  struct Span
  {
    Clock::time_point begin;
    Clock::time_point end;
  };

  template <class Work>
  static Span span_of(Work& work)
  {
    Span span;
    span.begin = Clock::now();
    work();
    span.end = Clock::now();
    return span;
  }

  static double nanoseconds(Clock::time_point begin, Clock::time_point end)
  {
    return std::chrono::duration<double, std::nano>(end - begin).count();
  }

  Clock::time_point m_start;
  std::optional<Span> m_classify;
  std::optional<Span> m_repair;
};

} // namespace speed

#endif // SPEED_PHASE_MARKS_H
