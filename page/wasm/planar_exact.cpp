// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/wasm/Subjects.h"

namespace page {

std::unique_ptr<Subject> make_planar_exact(const Settings& settings)
{
  return bindings::make_exact_in<bindings::Plane, Few_kinds>(settings);
}

} // namespace page
