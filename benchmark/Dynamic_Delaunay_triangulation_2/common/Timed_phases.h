// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_TIMED_PHASES_H
#define COMMON_TIMED_PHASES_H

#include "scenario_runner/Measurement.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>

#include <chrono>
#include <optional>
#include <utility>

namespace common {

// Nanoseconds of an update.
struct Phase_times
{
  double read = 0.0; // reading, checking and writing the positions
  double classify = 0.0;
  double repair = 0.0;
  double certify = 0.0; // all the rest
};

// When an update asked its policy, and entered and left its classifier and its repair.
class Phase_marks
{
public:
  void start()
  {
    m_asked.reset();
    m_classify.reset();
    m_repair.reset();
    m_start = Clock::now();
  }

  void ask_policy() { m_asked = Clock::now(); }

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

  // An update that has not come to its classifier is a rebuild, or was taken in steps. It counts as
  // repair, from its policy on if that was asked.
  Phase_times times(double total) const
  {
    Phase_times times;
    if (!m_classify) {
      times.read = m_asked ? nanoseconds(m_start, *m_asked) : 0.0;
      times.repair = total - times.read;
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
  std::optional<Clock::time_point> m_asked;
  std::optional<Span> m_classify;
  std::optional<Span> m_repair;
};

// The default classifier, timed. It derives, so that whatever else the triangulation looks for in a
// classifier is found here if and only if it is there.
class Timed_classifier : public CGAL::Circumcircle_classifier_2
{
public:
  explicit Timed_classifier(Phase_marks& marks)
    : m_marks(&marks)
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_marks->classify([&] { CGAL::Circumcircle_classifier_2::operator()(frame, classified); });
  }

private:
  Phase_marks* m_marks;
};

// The default repair of exact use, timed.
class Timed_repair : public CGAL::Hold_and_flip_repair_2
{
public:
  explicit Timed_repair(Phase_marks& marks)
    : m_marks(&marks)
  {
  }

  template <class Mender>
  void operator()(Mender& mender) const
  {
    m_marks->repair([&] { CGAL::Hold_and_flip_repair_2::operator()(mender); });
  }

private:
  Phase_marks* m_marks;
};

// Any repair, which notes how many nanoseconds its last call took.
template <class Repair>
class Clocked_repair
{
public:
  Clocked_repair(Repair repair, double& nanoseconds)
    : m_repair(std::move(repair))
    , m_nanoseconds(&nanoseconds)
  {
  }

  template <class Mender>
  void operator()(Mender& mender)
  {
    *m_nanoseconds = run::nanoseconds_of([&] { m_repair(mender); });
  }

private:
  Repair m_repair;
  double* m_nanoseconds;
};

} // namespace common

#endif // COMMON_TIMED_PHASES_H
