// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/Spaces.h"
#include "python/src/Python_settings.h"

namespace python {

std::unique_ptr<Subject> make_planar_exact(const Python_settings& settings)
{
  return make_exact_in<Plane>(settings);
}

} // namespace python
