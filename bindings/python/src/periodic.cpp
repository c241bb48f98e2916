// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Subject_in_space.h"

namespace python {

std::unique_ptr<Subject> make_periodic(const Python_settings& settings)
{
  return make_subject_in<Periodic_space>(settings);
}

} // namespace python
