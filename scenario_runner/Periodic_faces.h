// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PERIODIC_FACES_H
#define SCENARIO_RUNNER_PERIODIC_FACES_H

#include "scenario_runner/Cell.h"

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace run {

// Corners at the images of points by shifts along the sides of the motion's cell.
struct Periodic_face
{
  std::array<std::uint32_t, 3> places;
  std::array<scenario::Shift, 3> shifts;

  friend bool operator<(const Periodic_face& f, const Periodic_face& g)
  {
    return std::tie(f.places, f.shifts) < std::tie(g.places, g.shifts);
  }
  friend bool operator==(const Periodic_face& f, const Periodic_face& g)
  {
    return f.places == g.places && f.shifts == g.shifts;
  }
};

// Images of a face, and orders of its corners, have one normal form. Faces are sorted in ascending
// order, each once.
Periodic_face normal(const Periodic_face& face);
void sort_once(std::vector<Periodic_face>& faces);

// The Matthews correlation coefficient of the edges of these faces, as against those of a
// reference: 1 if they agree. Another choice among edges that doubles cannot tell apart, such as
// the diagonals of four points on a circle, is no error. Both are normal, and sorted.
double agreement_of(const std::vector<Periodic_face>& faces,
                    const std::vector<Periodic_face>& reference,
                    const std::vector<scenario::Point>& points, const scenario::Cell& cell);

} // namespace run

#endif // SCENARIO_RUNNER_PERIODIC_FACES_H
