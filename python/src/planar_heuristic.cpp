// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Spaces.h"

namespace python {

std::unique_ptr<Subject> make_planar_heuristic(const Settings& settings)
{
  return make_heuristic_in<Plane>(settings);
}

} // namespace python
