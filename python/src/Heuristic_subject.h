// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_HEURISTIC_SUBJECT_H
#define PYTHON_HEURISTIC_SUBJECT_H

#include "bindings/Spaces.h"
#include "python/src/Python_classifier.h"
#include "python/src/Python_settings.h"

#include <memory>

namespace python {

// With any classifier, also one in Python.
template <class Space>
std::unique_ptr<Subject> make_heuristic_in(const Python_settings& settings)
{
  using Named_classifier = run::All_classifiers::Classifier;
  using Classifier = run::Any_classifier<Named_classifier, Python_classifier>;
  if (settings.function) {
    return make_by_names<Space>(Classifier(Python_classifier(settings.function)), "splice",
                                settings);
  }
  const run::Classifier_choice choice = run::classifier_choice(settings.classifier);
  return make_by_names<Space>(Classifier(run::All_classifiers::make(choice, {settings.seed})),
                              run::usual_repair(choice), settings);
}

} // namespace python

#endif // PYTHON_HEURISTIC_SUBJECT_H
