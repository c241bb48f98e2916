// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_TRIANGLE_WALK_H
#define PYTHON_TRIANGLE_WALK_H

#include "bindings/python/src/Python_settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace python {

// Those of a Delaunay triangulation: three ids each, and the triangles opposite to these corners,
// or -1; and two coordinates of each id.
struct Flat_triangles
{
  const double* points;
  const std::int32_t* corners;
  const std::int32_t* neighbors;
  std::size_t size;
};

// The triangle of each query point, with its boundary; -1 outside of all.
std::vector<std::int32_t> triangles_at(const Rows& query_points, const Flat_triangles& triangles);

} // namespace python

#endif // PYTHON_TRIANGLE_WALK_H
