// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Planar.h"
#include "scenario_runner/Classifiers.h"

namespace python {

std::unique_ptr<Subject> make_exact(const Settings& settings, bool is_population)
{
  const run::Classifier_choice choice = run::classifier_choice(settings.classifier);
  return make_planar(run::Exact_classifiers::make(choice, {settings.seed}),
                     run::usual_repair(choice), settings, is_population);
}

} // namespace python
