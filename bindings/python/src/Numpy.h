// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_NUMPY_H
#define PYTHON_NUMPY_H

#include "bindings/python/src/Python_settings.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <vector>

namespace python {

// An array, and its numbers where they are. Only numbers of another type are converted.
struct Input
{
  pybind11::array array; // keeps the numbers alive
  Rows rows{};
};

// Of the shape (n, dimension), which is 2 or 3. `name` is for messages.
Input points_input(pybind11::handle object, const std::string& name = "points", int dimension = 2);

// The numbers are copied.
Input copied_points_input(pybind11::handle object);

// Integers of the shape (n,).
Input ids_input(pybind11::handle object, const std::string& name = "ids");
Input ids_input(pybind11::handle object, std::size_t size, const std::string& name = "ids");

// Real numbers of the shape (n,).
Input numbers_input(pybind11::handle object, const std::string& name);

// A read-only array that owns the numbers. Nothing is copied.
pybind11::array to_numpy(Array array);
pybind11::tuple to_numpy(std::vector<Array> arrays);

} // namespace python

#endif // PYTHON_NUMPY_H
