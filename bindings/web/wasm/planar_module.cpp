// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/web/wasm/Subjects.h"

#include <emscripten/emscripten.h>

namespace page {

std::unique_ptr<Subject> make_subject(const Settings& settings)
{
  return make_planar_usual(settings);
}

// Of which kind of triangulations this module is.
extern "C" EMSCRIPTEN_KEEPALIVE const char* dd_kind()
{
  return "plane";
}

} // namespace page
