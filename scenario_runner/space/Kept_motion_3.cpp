// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Kept_motion_3.h"

#include <CGAL/Bbox_3.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

namespace run {

namespace {

// A motion's points as those of the triangulation, without a copy.
auto begin_of(const scenario::Motion_3& motion)
{
  return boost::make_transform_iterator(motion.points().begin(), As_point_3());
}
auto end_of(const scenario::Motion_3& motion)
{
  return boost::make_transform_iterator(motion.points().end(), As_point_3());
}

} // namespace

Kept_motion_3::Kept_motion_3(const scenario::Motion_3& motion, const Any_policy_3& policy)
{
  if (motion.has_fixed_population()) {
    m_triangulation.emplace(begin_of(motion), end_of(motion), policy);
  } else {
    m_population.emplace(Dynamic_3(policy));
    update_population(motion);
  }
}

CGAL::Update_report_3 Kept_motion_3::update(const scenario::Motion_3& motion)
{
  return m_population ? update_population(motion)
                      : m_triangulation->update(begin_of(motion), end_of(motion));
}

void Kept_motion_3::measure(const scenario::Motion_3& motion,
                            CGAL::Voronoi_cell_measures_3& measures) const
{
  if (const auto box = motion.box()) {
    measures.compute(triangulation(), CGAL::Bbox_3(0.0, 0.0, 0.0, (*box)[0], (*box)[1], (*box)[2]));
  } else {
    measures.compute(triangulation());
  }
}

CGAL::Update_report_3 Kept_motion_3::update_population(const scenario::Motion_3& motion)
{
  using Place = boost::counting_iterator<std::size_t>;
  const auto id = [&](std::size_t place) { return motion.ids()[place]; };
  const auto point = [&](std::size_t place) { return As_point_3()(motion.points()[place]); };
  return m_population->update(Place(0), Place(motion.points().size()),
                              boost::make_function_property_map<std::size_t>(id),
                              boost::make_function_property_map<std::size_t>(point));
}

} // namespace run
