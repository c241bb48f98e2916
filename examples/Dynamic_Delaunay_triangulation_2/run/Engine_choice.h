// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_ENGINE_CHOICE_H
#define RUN_ENGINE_CHOICE_H

#include "../scenario/Json_object_reader.h"

#include <CGAL/Static_engine_2.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace run {

// What triangulates anew, the default first.
inline const std::vector<std::pair<std::string, CGAL::Static_engine_2>>& engines()
{
  static const std::vector<std::pair<std::string, CGAL::Static_engine_2>> all = {
      {"guibas_stolfi", CGAL::Static_engine_2::GUIBAS_STOLFI},
      {"insertion", CGAL::Static_engine_2::INSERTION},
      {"bowyer_watson", CGAL::Static_engine_2::BOWYER_WATSON}};
  return all;
}

inline std::vector<std::string> engine_names()
{
  std::vector<std::string> names;
  for (const auto& [name, engine] : engines()) {
    names.push_back(name);
  }
  return names;
}

// The same one for the whole and for regions.
inline CGAL::Static_engines_2 engines_named(const std::string& name)
{
  for (const auto& [its_name, engine] : engines()) {
    if (its_name == name) {
      return {engine, engine};
    }
  }
  throw std::invalid_argument("there is no engine '" + name + "'; there are " +
                              scenario::joined(engine_names()));
}

} // namespace run

#endif // RUN_ENGINE_CHOICE_H
