// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/web/wasm/Subjects.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/Number_text.h"

#include <emscripten/emscripten.h>

#include <string>

namespace page {

std::unique_ptr<Subject> make_subject(const Settings& settings)
{
  return settings.cell ? make_periodic_by_names(settings) : make_planar_by_names(settings);
}

// Of which kind of triangulations this module is.
extern "C" EMSCRIPTEN_KEEPALIVE const char* dd_kind()
{
  return "all";
}

// Lines of what can be chosen: classifiers with `exact` or `heuristic`, and the letter and the
// usual value of a parameter; repairs; and one line of policies.
extern "C" EMSCRIPTEN_KEEPALIVE const char* dd_choices()
{
  static const std::string choices = [] {
    std::string text;
    for (const run::Classifier_kind& kind : run::classifier_kinds()) {
      text += "classifier " + kind.name + (kind.is_exact ? " exact" : " heuristic");
      if (kind.parameter) {
        text += ' ' + kind.parameter->letter + ' ' + run::number_text(kind.parameter->usual, 6);
      }
      text += '\n';
    }
    for (const std::string& repair : run::repair_names()) {
      text += "repair " + repair + '\n';
    }
    return text + "policies " + run::policy_list() + '\n';
  }();
  return choices.c_str();
}

} // namespace page
