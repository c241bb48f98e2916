// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_MAKE_SUBJECT_H
#define RANDOM_OPERATIONS_MAKE_SUBJECT_H

#include "Population_subject.h"
#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "Setup.h"
#include "Subject.h"
#include "test/Dynamic_Delaunay_triangulation_2/stamps.h"
#include "Triangulation_subject.h"

#include <CGAL/Default.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Predictive_point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace random_operations {

// Threads share the work only where the program makes parts of a few points.
#ifdef CGAL_DYNAMIC_DELAUNAY_POINTS_OF_PART
using Concurrency = CGAL::Parallel_tag;
#else
using Concurrency = CGAL::Sequential_tag;
#endif

// What a triangulation is made with.
template <class Kernel, class Classifier>
struct Maker
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<
      Kernel, Classifier, CGAL::With_repair_2<run::Any_repair>,
      CGAL::With_data_structure_2<Stamped_data_structure<Kernel>>,
      CGAL::With_policy_2<run::Any_policy>, CGAL::With_concurrency_2<Concurrency>>;
  using Point = typename Dynamic::Point;

  typename Dynamic::Settings settings;
  int divisor;

  Maker(const Classifier& classifier, const Setup& setup)
    : settings{classifier, run::make_repair(setup.repair, setup.padding),
               run::engines_named(setup.engine), run::make_policy(setup.policy)}
    , divisor(setup.divisor)
  {
  }

  Point point(const Place& place) const
  {
    using Number = typename Kernel::FT;
    return divisor == 1 ? Point(place.x, place.y)
                        : Point(Number(place.x) / divisor, Number(place.y) / divisor);
  }

  Dynamic empty() const { return Dynamic(settings); }
  template <class Iterator>
  Dynamic of(Iterator first, Iterator beyond) const
  {
    return Dynamic(first, beyond, settings);
  }
};

// Velocities that are mostly wrong about where points go.
struct Steady_velocity
{
  struct Vector
  {
    double x, y;
  };

  Vector operator()(std::size_t id) const { return {0.001 * static_cast<double>(id % 7), 0.01}; }
};

using Predictive_classifier = CGAL::Predictive_point_distance_classifier_2<Steady_velocity>;
using Classifier = CGAL::Chosen_classifier_2<run::Any_classifier, Predictive_classifier>;

inline Classifier make_classifier(const Setup& setup)
{
  if (setup.is_predictive) {
    return Predictive_classifier(Steady_velocity(), *setup.classifier.parameter);
  }
  return run::make_classifier(setup.classifier, {setup.seed});
}

template <class Kernel>
std::unique_ptr<Subject> make_subject(const Setup& setup)
{
  using Its_maker = Maker<Kernel, Classifier>;
  const Its_maker maker(make_classifier(setup), setup);
  switch (setup.naming) {
  case Naming::IDS:
    return std::make_unique<Triangulation_subject<Its_maker>>(maker);
  case Naming::INT64:
    return std::make_unique<Population_subject<Its_maker, std::int64_t>>(maker);
  case Naming::UINT64:
    return std::make_unique<Population_subject<Its_maker, std::uint64_t>>(maker);
  default:
    return std::make_unique<Population_subject<Its_maker, std::uint8_t>>(maker);
  }
}

inline std::unique_ptr<Subject> make_subject(const Setup& setup)
{
  return setup.constructs_exactly
             ? make_subject<CGAL::Exact_predicates_exact_constructions_kernel>(setup)
             : make_subject<CGAL::Exact_predicates_inexact_constructions_kernel>(setup);
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_MAKE_SUBJECT_H
