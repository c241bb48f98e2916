// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_KEPT_TRIANGULATION_H
#define RUN_KEPT_TRIANGULATION_H

#include "../scenario/Motion.h"
#include "Kernel.h"

#include <CGAL/Dynamic_population_2.h>
#include <CGAL/iterator.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>

namespace run {

// The triangulation of a motion, from its first frame on. Where points come and go it knows them by
// the motion's ids; elsewhere their places are ids enough.
template <class Dynamic>
class Kept_triangulation
{
public:
  // `empty` has no points yet.
  Kept_triangulation(const scenario::Motion& motion, Dynamic empty)
  {
    if (motion.has_fixed_population()) {
      const auto& points = motion.points();
      empty.insert(points.begin(), points.end(), Point_map(), CGAL::Emptyset_iterator());
      m_kept.template emplace<Dynamic>(std::move(empty));
    } else {
      update(m_kept.template emplace<Population>(std::move(empty)), motion);
    }
  }

  CGAL::Update_report_2 update(const scenario::Motion& motion)
  {
    if (Population* const population = std::get_if<Population>(&m_kept)) {
      return update(*population, motion);
    }
    Dynamic& triangulation = std::get<Dynamic>(m_kept);
    const auto& points = motion.points();
    return triangulation.update(points.begin(), points.end(), Point_map());
  }

  bool certify()
  {
    return std::visit([](auto& kept) { return kept.certify(); }, m_kept);
  }

  const Dynamic& triangulation() const
  {
    const Population* const population = std::get_if<Population>(&m_kept);
    return population ? population->triangulation() : std::get<Dynamic>(m_kept);
  }

private:
  using Population = CGAL::Dynamic_population_2<Dynamic, std::int64_t>;

  static CGAL::Update_report_2 update(Population& population, const scenario::Motion& motion)
  {
    using Place = boost::counting_iterator<std::size_t>;
    const auto id = [&](std::size_t place) { return motion.ids()[place]; };
    const auto point = [&](std::size_t place) { return get(Point_map(), motion.points()[place]); };
    return population.update(Place(0), Place(motion.points().size()),
                             boost::make_function_property_map<std::size_t>(id),
                             boost::make_function_property_map<std::size_t>(point));
  }

  std::variant<Dynamic, Population> m_kept;
};

} // namespace run

#endif // RUN_KEPT_TRIANGULATION_H
