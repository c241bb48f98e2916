// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Planar.h"
#include "python/src/Python_classifier.h"
#include "scenario_runner/Classifiers.h"

namespace python {

std::unique_ptr<Subject> make_heuristic(const Settings& settings, bool is_population)
{
  using Named_classifier = run::All_classifiers::Classifier;
  using Classifier = run::Any_classifier<Named_classifier, Python_classifier>;
  if (settings.function) {
    return make_planar(Classifier(Python_classifier(settings.function)), "splice", settings,
                       is_population);
  }
  const run::Classifier_choice choice = run::classifier_choice(settings.classifier);
  return make_planar(Classifier(run::All_classifiers::make(choice, {settings.seed})),
                     run::usual_repair(choice), settings, is_population);
}

} // namespace python
