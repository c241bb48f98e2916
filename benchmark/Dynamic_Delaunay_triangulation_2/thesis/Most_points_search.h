// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_MOST_POINTS_SEARCH_H
#define THESIS_MOST_POINTS_SEARCH_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace thesis {

// Times of frames, in milliseconds.
struct Frame_milliseconds
{
  std::size_t points;
  std::size_t frames; // of the scenario; the last of them is the last that was timed
  double median;
  double upper_quartile;
};

// Searches for the largest number of points with which three of four frames take up to 40 ms
// (thesis, 5.1.1): with cost nearly proportional to the number of points, each try tells where the
// next one belongs.
class Most_points_search
{
public:
  // At most `most` points are tried.
  Most_points_search(std::size_t first_try, std::size_t most)
    : m_next(first_try)
    , m_too_many(most + 1)
  {
  }

  // `measure(n)` times n points.
  template <class Measure>
  Frame_milliseconds run(Measure measure)
  {
    constexpr int most_tries = 7;
    for (int i = 0; i != most_tries && !is_near(); ++i) {
      take(measure(m_next));
    }
    return m_best;
  }

private:
  static constexpr double limit = 40.0; // milliseconds

  // True if the search has come as near to the limit as timing is precise.
  bool is_near() const
  {
    constexpr double near = 0.93;
    constexpr std::size_t narrow = 20;
    return m_best.upper_quartile >= near * limit ||
           m_too_many - m_best.points <= 1 + m_best.points / narrow;
  }

  void take(const Frame_milliseconds& times)
  {
    (times.upper_quartile <= limit ? m_best : m_worst) = times;
    if (times.upper_quartile > limit) {
      m_too_many = times.points;
    }
    const double next = std::ceil(prediction(times));
    m_next = m_best.points + (m_too_many - m_best.points) / 2; // unless the prediction is possible
    if (next > static_cast<double>(m_best.points) && next < static_cast<double>(m_too_many)) {
      m_next = static_cast<std::size_t>(next);
    }
  }

  // A number of points close to the limit. The time is taken for a power of the number of points,
  // by the tries on both sides of the limit; without tries on one side, for proportional to it.
  double prediction(const Frame_milliseconds& times) const
  {
    constexpr double aim = 0.97 * limit, most_growth = 20.0;
    if (m_best.points == 0 || m_worst.points == 0) {
      const double factor = (std::min)(most_growth, aim / times.upper_quartile);
      return factor * static_cast<double>(times.points);
    }
    const double growth = static_cast<double>(m_worst.points) / static_cast<double>(m_best.points);
    const double share = std::log(aim / m_best.upper_quartile) /
                         std::log(m_worst.upper_quartile / m_best.upper_quartile);
    return static_cast<double>(m_best.points) * std::pow(growth, share);
  }

  Frame_milliseconds m_best{0, 0, 0.0, 0.0};  // the most points within the limit
  Frame_milliseconds m_worst{0, 0, 0.0, 0.0}; // the fewest beyond it
  std::size_t m_next;
  std::size_t m_too_many;
};

} // namespace thesis

#endif // THESIS_MOST_POINTS_SEARCH_H
