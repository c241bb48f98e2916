// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_ANY_REPAIR_H
#define RUN_ANY_REPAIR_H

#include "../scenario/Json_object_reader.h"
#include "Classifier_choice.h"

#include <CGAL/Border_splice_repair_2.h>
#include <CGAL/Flip_and_splice_repair_2.h>
#include <CGAL/Flip_repair_2.h>
#include <CGAL/Rebuild_repair_2.h>
#include <CGAL/Relocation_repair_2.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace run {

// One of the repairs, chosen while the program runs.
class Any_repair
{
public:
  Any_repair() = default;

  template <class Repair>
  explicit Any_repair(Repair repair)
    : m_repair(std::move(repair))
  {
  }

  template <class Mender>
  void operator()(Mender& mender) const
  {
    std::visit([&](const auto& repair) { repair(mender); }, m_repair);
  }

private:
  std::variant<CGAL::Flip_and_splice_repair_2, CGAL::Border_splice_repair_2, CGAL::Flip_repair_2,
               CGAL::Relocation_repair_2, CGAL::Rebuild_repair_2>
      m_repair;
};

inline const std::vector<std::string>& repair_names()
{
  static const std::vector<std::string> names = {"flip_and_splice", "splice", "flip", "relocate",
                                                 "rebuild"};
  return names;
}

inline std::string usual_repair(const Classifier_choice& classifier)
{
  const bool needs_flips = classifier.is_exact || classifier.name == "nearly_delaunay";
  return needs_flips ? "flip_and_splice" : "splice";
}

inline void check_repair_name(const std::string& name)
{
  const auto& names = repair_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw std::invalid_argument("there is no repair '" + name + "'; there are " +
                                scenario::joined(names));
  }
}

inline Any_repair make_repair(const std::string& name, unsigned padding)
{
  if (name == "splice") {
    return Any_repair(CGAL::Border_splice_repair_2(padding));
  }
  if (name == "flip") {
    return Any_repair(CGAL::Flip_repair_2());
  }
  if (name == "relocate") {
    return Any_repair(CGAL::Relocation_repair_2());
  }
  if (name == "rebuild") {
    return Any_repair(CGAL::Rebuild_repair_2());
  }
  return Any_repair(CGAL::Flip_and_splice_repair_2(padding));
}

} // namespace run

#endif // RUN_ANY_REPAIR_H
