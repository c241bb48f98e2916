// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_METHOD_NAME_H
#define THESIS_METHOD_NAME_H

#include "../classifiers/Classifier_run.h"
#include "scenario_runner/Repairs_and_policies.h"

#include <string>

namespace thesis {

// "circumcircle", "circumcircle/splice", "circumcircle/hybrid": with repair and policy where they
// are not the usual ones.
inline std::string method_name(const classifiers::Method& method)
{
  std::string name = method.classifier.text();
  if (method.repair != run::usual_repair(method.classifier)) {
    name += '/' + method.repair;
  }
  return method.policy.name == "always_dynamic" ? name : name + '/' + method.policy.name;
}

} // namespace thesis

#endif // THESIS_METHOD_NAME_H
