// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Kept_periodic_motion_3.h"

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstdint>
#include <utility>

namespace run {

namespace {

using Point = Dynamic_periodic_3::Point;

Point point_of(const scenario::Point_3& p)
{
  return Point(p[0], p[1], p[2]);
}

// A motion's points as those of the triangulation, without a copy.
auto points_of(const scenario::Motion_3& motion)
{
  return boost::make_iterator_range(
      boost::make_transform_iterator(motion.points().begin(), point_of),
      boost::make_transform_iterator(motion.points().end(), point_of));
}

} // namespace

Kept_periodic_motion_3::Kept_periodic_motion_3(const scenario::Motion_3& motion,
                                               const Any_policy_3& policy)
{
  Dynamic_periodic_3 empty(periodic_cell(*motion.cell()), policy);
  if (motion.has_fixed_population()) {
    m_triangulation.emplace(std::move(empty));
    m_triangulation->insert(points_of(motion));
  } else {
    m_population.emplace(std::move(empty));
    update_population(motion);
  }
}

CGAL::Update_report_3 Kept_periodic_motion_3::update(const scenario::Motion_3& motion)
{
  return m_population ? update_population(motion)
                      : m_triangulation->update(points_of(motion), periodic_cell(*motion.cell()));
}

void Kept_periodic_motion_3::measure(const scenario::Motion_3&,
                                     CGAL::Voronoi_cell_measures_3& measures) const
{
  measures.compute(triangulation());
}

CGAL::Update_report_3 Kept_periodic_motion_3::update_population(const scenario::Motion_3& motion)
{
  const auto identified = [&](std::size_t place) {
    return std::pair<std::int64_t, Point>(motion.ids()[place], point_of(motion.points()[place]));
  };
  using Place = boost::counting_iterator<std::size_t>;
  return m_population->update(
      boost::make_iterator_range(
          boost::make_transform_iterator(Place(0), identified),
          boost::make_transform_iterator(Place(motion.points().size()), identified)),
      periodic_cell(*motion.cell()));
}

} // namespace run
