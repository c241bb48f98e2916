// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/web/wasm/Subjects.h"

namespace page {

std::unique_ptr<Subject> make_planar_usual(const Settings& settings)
{
  return bindings::make_usual_in<bindings::Plane, Few_kinds>(settings);
}

} // namespace page
