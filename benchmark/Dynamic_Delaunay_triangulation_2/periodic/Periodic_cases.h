// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_PERIODIC_CASES_H
#define PERIODIC_PERIODIC_CASES_H

#include "Periodic_run.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace periodic {

// What a person asks for.
struct Periodic_options
{
  std::vector<std::size_t> chosen_points{};
  std::vector<double> steps{0.001, 0.01, 0.03, 0.1};
  std::size_t frames = 0; // as many as fit to the number of points
  std::size_t repetitions = 1;
  std::string csv{};
  bool is_quick = false;

  std::vector<std::size_t> points() const
  {
    if (!chosen_points.empty()) {
      return chosen_points;
    }
    return is_quick ? std::vector<std::size_t>{1'000}
                    : std::vector<std::size_t>{1'000, 10'000, 100'000};
  }
};

// How many frames of how many points can be waited for.
inline std::size_t usual_frames(std::size_t points, bool is_quick)
{
  const std::size_t frames = points <= 1'000     ? 600
                             : points <= 10'000  ? 150
                             : points <= 100'000 ? 40
                                                 : 10;
  return is_quick ? frames / 10 : frames;
}

// CGAL's periodic triangulation takes long.
inline std::size_t usual_cgal_frames(std::size_t points, bool is_quick)
{
  constexpr std::size_t most = 20, all_points = 200'000;
  return is_quick ? 2 : std::clamp(all_points / points, std::size_t(1), most);
}

inline Periodic_case periodic_case(const Periodic_options& options, std::size_t points, double step,
                                   std::uint64_t seed)
{
  constexpr std::size_t warm_up = 3;
  const std::size_t frames =
      options.frames != 0 ? options.frames : usual_frames(points, options.is_quick);
  return {points, step, seed, warm_up, frames, usual_cgal_frames(points, options.is_quick)};
}

} // namespace periodic

#endif // PERIODIC_PERIODIC_CASES_H
