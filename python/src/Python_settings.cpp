// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Python_settings.h"

#include "scenario_runner/Method_choice.h"

namespace python {

std::unique_ptr<Subject> make_planar_usual(const Python_settings& settings);
std::unique_ptr<Subject> make_planar_exact(const Python_settings& settings);
std::unique_ptr<Subject> make_planar_heuristic(const Python_settings& settings);
std::unique_ptr<Subject> make_periodic_exact(const Python_settings& settings);
std::unique_ptr<Subject> make_periodic_heuristic(const Python_settings& settings);

std::unique_ptr<Subject> make_subject(const Python_settings& settings)
{
  const bool is_named = settings.function == nullptr;
  const bool is_usual = settings.classifier == "circumcircle" &&
                        (settings.repair.empty() || settings.repair == "hold_and_flip") &&
                        settings.policy == "always_dynamic";
  const bool is_exact = is_named && run::classifier_choice(settings.classifier).is_exact;
  if (settings.cell) {
    return is_exact ? make_periodic_exact(settings) : make_periodic_heuristic(settings);
  }
  if (is_named && is_usual) {
    return make_planar_usual(settings);
  }
  return is_exact ? make_planar_exact(settings) : make_planar_heuristic(settings);
}

} // namespace python
