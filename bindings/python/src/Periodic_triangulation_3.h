// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_PERIODIC_TRIANGULATION_3_H
#define PYTHON_PERIODIC_TRIANGULATION_3_H

#include <pybind11/pybind11.h>

namespace python {

// Triangulations of points in periodic space.
void bind_periodic_triangulation_3(pybind11::module_& module);

} // namespace python

#endif // PYTHON_PERIODIC_TRIANGULATION_3_H
