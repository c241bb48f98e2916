// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Spaces.h"

namespace python {

// Of the types that a program in C++ has by default, which look at some edges before they decide
// how to repair.
std::unique_ptr<Subject> make_planar_usual(const Settings& settings)
{
  return make_in<Plane>(CGAL::Circumcircle_classifier_2(), CGAL::Flip_and_splice_repair_2(),
                        CGAL::Always_dynamic_policy_2(), settings);
}

} // namespace python
