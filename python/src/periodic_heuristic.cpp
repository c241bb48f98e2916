// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Heuristic_subject.h"

namespace python {

std::unique_ptr<Subject> make_periodic_heuristic(const Python_settings& settings)
{
  return make_heuristic_in<Periodic_space>(settings);
}

} // namespace python
