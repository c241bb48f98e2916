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
#include <optional>
#include <utility>

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
      m_triangulation.emplace(std::move(empty));
      m_triangulation->insert(points.begin(), points.end(), Point_map(), CGAL::Emptyset_iterator());
    } else {
      m_population.emplace(std::move(empty));
      update(motion);
    }
  }

  CGAL::Update_report_2 update(const scenario::Motion& motion)
  {
    const auto& points = motion.points();
    return m_population ? update_population(motion)
                        : m_triangulation->update(points.begin(), points.end(), Point_map());
  }

  bool certify() { return m_population ? m_population->certify() : m_triangulation->certify(); }

  const Dynamic& triangulation() const
  {
    return m_population ? m_population->triangulation() : *m_triangulation;
  }

  // The id in the triangulation of the point in this place of the motion.
  std::size_t id(const scenario::Motion& motion, std::size_t place) const
  {
    return m_population ? m_population->id(motion.ids()[place]) : place;
  }

private:
  using Population = CGAL::Dynamic_population_2<Dynamic, std::int64_t>;

  CGAL::Update_report_2 update_population(const scenario::Motion& motion)
  {
    using Place = boost::counting_iterator<std::size_t>;
    const auto id = [&](std::size_t place) { return motion.ids()[place]; };
    const auto point = [&](std::size_t place) { return get(Point_map(), motion.points()[place]); };
    return m_population->update(Place(0), Place(motion.points().size()),
                                boost::make_function_property_map<std::size_t>(id),
                                boost::make_function_property_map<std::size_t>(point));
  }

  // one of them
  std::optional<Dynamic> m_triangulation;
  std::optional<Population> m_population;
};

} // namespace run

#endif // RUN_KEPT_TRIANGULATION_H
