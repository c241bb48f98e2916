// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/web/wasm/Subjects.h"

namespace page {

std::unique_ptr<Subject> make_planar_by_names(const Settings& settings)
{
  const run::Classifier_choice choice = run::classifier_choice(settings.classifier);
  return bindings::make_by_names<bindings::Plane, Few_kinds>(
      run::make_classifier(choice, {settings.seed}), run::usual_repair(choice), settings);
}

} // namespace page
