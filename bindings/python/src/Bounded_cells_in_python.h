// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_BOUNDED_CELLS_IN_PYTHON_H
#define PYTHON_BOUNDED_CELLS_IN_PYTHON_H

#include "bindings/common/Bounded_cells.h"
#include "bindings/python/src/Python_settings.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <vector>

namespace python {

// What Python holds. It does not change.
struct Bounded_cells_in_python
{
  Bounded_cells bounded;
  std::uint64_t version; // of the triangulation
};

// By positions and by radii.
std::vector<Array> gradient_arrays(const Bounded_cells& bounded,
                                   const CGAL::Bounded_voronoi_gradients_2& gradients);

void bind_bounded_cells(pybind11::module_& module);

} // namespace python

#endif // PYTHON_BOUNDED_CELLS_IN_PYTHON_H
