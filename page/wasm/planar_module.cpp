// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/wasm/Subjects.h"

namespace page {

std::unique_ptr<Subject> make_subject(const Settings& settings)
{
  return make_planar_usual(settings);
}

} // namespace page
