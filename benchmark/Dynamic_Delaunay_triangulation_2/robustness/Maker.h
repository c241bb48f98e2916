// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_MAKER_H
#define ROBUSTNESS_MAKER_H

#include "Model.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "Setup.h"

#include <CGAL/Default.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Static_engine_2.h>

namespace robustness {

// What an empty triangulation is made with.
template <class Kernel, class Classifier>
struct Maker
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier, run::Any_repair,
                                                         CGAL::Default, run::Any_policy>;
  using Point = typename Dynamic::Point;

  Classifier classifier;
  run::Any_repair repair;
  CGAL::Static_engines_2 engines;
  run::Any_policy policy;
  int divisor;

  Maker(const Classifier& its_classifier, const Setup& setup)
    : classifier(its_classifier)
    , repair(run::make_repair(setup.repair, setup.padding))
    , engines(run::engines_named(setup.engine))
    , policy(run::make_policy(setup.policy))
    , divisor(setup.divisor)
  {
  }

  Point point(const Place& place) const
  {
    using Number = typename Kernel::FT;
    return divisor == 1 ? Point(place.x, place.y)
                        : Point(Number(place.x) / divisor, Number(place.y) / divisor);
  }

  Dynamic empty() const { return Dynamic(classifier, repair, engines, policy); }
  template <class Iterator>
  Dynamic of(Iterator first, Iterator beyond) const
  {
    return Dynamic(first, beyond, classifier, repair, engines, policy);
  }
};

} // namespace robustness

#endif // ROBUSTNESS_MAKER_H
