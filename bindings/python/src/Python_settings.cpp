// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Python_settings.h"

namespace python {

std::unique_ptr<Subject> make_planar(const Python_settings& settings);
std::unique_ptr<Subject> make_periodic(const Python_settings& settings);

std::unique_ptr<Subject> make_subject(const Python_settings& settings)
{
  return settings.cell ? make_periodic(settings) : make_planar(settings);
}

} // namespace python
