// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PAGE_WASM_SUBJECTS_H
#define PAGE_WASM_SUBJECTS_H

#include "bindings/common/Spaces.h"
#include "bindings/common/Subject.h"

#include <memory>

namespace page {

using bindings::Settings;
using bindings::Subject;

// As few types as there can be: they are loaded over a network.
struct Few_kinds
{
  static constexpr bool has_populations = false;
  static constexpr bool has_extras = false;
};

// Without points. Each module has its own: of the plane or of periodic space with the usual method,
// or all of them.
std::unique_ptr<Subject> make_subject(const Settings& settings);

// Each of them is compiled by itself.
std::unique_ptr<Subject> make_planar_usual(const Settings& settings);
std::unique_ptr<Subject> make_planar_by_names(const Settings& settings);
std::unique_ptr<Subject> make_periodic_usual(const Settings& settings);
std::unique_ptr<Subject> make_periodic_by_names(const Settings& settings);

} // namespace page

#endif // PAGE_WASM_SUBJECTS_H
