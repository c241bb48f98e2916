// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_SUBJECT_IN_SPACE_H
#define PYTHON_SUBJECT_IN_SPACE_H

#include "bindings/common/Spaces.h"
#include "bindings/python/src/Python_classifier.h"
#include "bindings/python/src/Python_settings.h"

#include <memory>

namespace python {

// With a classifier by its name, or one that is written in Python.
template <class Space>
std::unique_ptr<Subject> make_subject_in(const Python_settings& settings)
{
  using Classifier = CGAL::Chosen_classifier_2<run::Any_classifier, Python_classifier>;
  if (settings.function) {
    return make_by_names<Space>(Classifier(Python_classifier(settings.function)), "splice",
                                settings);
  }
  const run::Classifier_choice choice = run::classifier_choice(settings.classifier);
  return make_by_names<Space>(Classifier(run::make_classifier(choice, {settings.seed})),
                              run::usual_repair(choice), settings);
}

} // namespace python

#endif // PYTHON_SUBJECT_IN_SPACE_H
