// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_PYTHON_SETTINGS_H
#define PYTHON_PYTHON_SETTINGS_H

#include "bindings/common/Subject.h"

#include <memory>

namespace python {

using namespace bindings;

class Python_function;

struct Python_settings : Settings
{
  std::shared_ptr<const Python_function> function; // the classifier, if it is written in Python
};

// Without points.
std::unique_ptr<Subject> make_subject(const Python_settings& settings);

} // namespace python

#endif // PYTHON_PYTHON_SETTINGS_H
