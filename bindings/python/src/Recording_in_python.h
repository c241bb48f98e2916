// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_RECORDING_IN_PYTHON_H
#define PYTHON_RECORDING_IN_PYTHON_H

#include <pybind11/pybind11.h>

namespace python {

// Recordings, and the columns of tables, as the scenario runner reads them.
void bind_recordings(pybind11::module_& module);

} // namespace python

#endif // PYTHON_RECORDING_IN_PYTHON_H
