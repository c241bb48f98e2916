// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Follows frames natively, for page.mjs, until its input ends. Of each frame it reads the number of
// coordinates (a double) and these (doubles), and answers with the nanoseconds that the update took
// and the number of edges (doubles); all in the machine's own byte order.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool read(void* place, std::size_t size)
{
  return std::fread(place, 1, size, stdin) == size;
}

} // namespace

int main()
{
  using Clock = std::chrono::steady_clock;
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> triangulation;
  std::vector<Kernel::Point_2> points;
  for (double length = 0; read(&length, sizeof length);) {
    points.resize(static_cast<std::size_t>(length) / 2);
    for (Kernel::Point_2& point : points) {
      std::array<double, 2> coordinates{};
      if (!read(coordinates.data(), sizeof coordinates)) {
        return 1;
      }
      point = {coordinates[0], coordinates[1]};
    }
    const auto begin = Clock::now();
    if (triangulation.number_of_points() == points.size()) {
      triangulation.update(points);
    } else {
      triangulation = decltype(triangulation)(points.begin(), points.end());
    }
    const double nanoseconds =
        std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
    double edges = 0;
    triangulation.for_each_edge([&](std::size_t, std::size_t) { ++edges; });
    const std::array<double, 2> answer{nanoseconds, edges};
    std::fwrite(answer.data(), sizeof answer, 1, stdout);
    std::fflush(stdout);
  }
}
