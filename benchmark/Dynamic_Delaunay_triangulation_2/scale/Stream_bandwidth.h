// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_STREAM_BANDWIDTH_H
#define SCALE_STREAM_BANDWIDTH_H

#include "scenario_runner/Measurement.h"
#include "scenario_runner/Threads.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scale {

// Bytes a nanosecond, which is gigabytes a second.
struct Bandwidth
{
  double copy;
  double triad;
};

// The machine's bandwidth by the kernels of STREAM (J. McCalpin, IEEE TCCA Newsletter, December
// 1995): copy, a = b, and triad, a = b + s c, over arrays that no cache holds. Counted is what the
// program reads and writes, 16 and 24 bytes an element, not what the memory moves besides, such as
// lines that are fetched only to be overwritten. The fastest of some rounds counts.
class Stream_bandwidth
{
public:
  explicit Stream_bandwidth(std::size_t elements)
    : m_a(elements, 1.0)
    , m_b(elements, 2.0)
    , m_c(elements, 3.0)
  {
  }

  Bandwidth measure(unsigned threads)
  {
    Bandwidth bandwidth{0.0, 0.0};
    run::Threads(threads).execute([&] {
      for (int round = 0; round != rounds; ++round) {
        bandwidth.copy = (std::max)(bandwidth.copy, copy());
        bandwidth.triad = (std::max)(bandwidth.triad, triad());
      }
    });
    return bandwidth;
  }

private:
  static constexpr int rounds = 10;
  static constexpr double number = 8.0; // bytes

  double copy()
  {
    return 2.0 * number * elements_a_nanosecond([this](std::size_t i) { m_a[i] = m_b[i]; });
  }

  double triad()
  {
    constexpr double scalar = 3.0;
    return 3.0 * number *
           elements_a_nanosecond([this](std::size_t i) { m_b[i] = m_a[i] + scalar * m_c[i]; });
  }

  template <class Work>
  double elements_a_nanosecond(const Work& work) const
  {
    using Range = tbb::blocked_range<std::size_t>;
    const double time = run::nanoseconds_of([&] {
      tbb::parallel_for(
          Range(0, m_a.size()),
          [&](const Range& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) {
              work(i);
            }
          },
          tbb::static_partitioner());
    });
    return static_cast<double>(m_a.size()) / time;
  }

  std::vector<double> m_a;
  std::vector<double> m_b;
  std::vector<double> m_c;
};

} // namespace scale

#endif // SCALE_STREAM_BANDWIDTH_H
