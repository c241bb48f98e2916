// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/wasm/Subjects.h"

namespace page {

std::unique_ptr<Subject> make_periodic_exact(const Settings& settings)
{
  return bindings::make_exact_in<bindings::Periodic_space, Few_kinds>(settings);
}

} // namespace page
