// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_FUNCTION_IN_PYTHON_H
#define PYTHON_FUNCTION_IN_PYTHON_H

#include "bindings/python/src/Python_classifier.h"

#include <pybind11/pybind11.h>

#include <memory>

namespace python {

// The only reference to an object of Python, which several objects of C++ share. The garbage
// collector can count it, and replace it by None.
using Shared_reference = std::shared_ptr<pybind11::object>;

std::shared_ptr<const Python_function> function_in_python(Shared_reference function);

// What the function is called with.
void bind_classifier_frame(pybind11::module_& module);

} // namespace python

#endif // PYTHON_FUNCTION_IN_PYTHON_H
