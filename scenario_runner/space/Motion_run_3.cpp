// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Motion_run_3.h"

#include "scenario_runner/Measurement.h"

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace run {

namespace {

using Point = Dynamic_3::Point;

struct As_point
{
  Point operator()(const scenario::Point_3& p) const { return Point(p[0], p[1], p[2]); }
};

// A motion's points as those of the triangulation, without a copy.
auto begin_of(const scenario::Motion_3& motion)
{
  return boost::make_transform_iterator(motion.points().begin(), As_point());
}
auto end_of(const scenario::Motion_3& motion)
{
  return boost::make_transform_iterator(motion.points().end(), As_point());
}

} // namespace

Any_policy_3 make_policy_3(const Policy_choice& choice)
{
  if (choice.name == "always_static") {
    return Any_policy_3(CGAL::Always_static_policy_2());
  }
  if (choice.name == "key_frames") {
    return Any_policy_3(CGAL::Key_frame_policy_2(*choice.parameter));
  }
  if (choice.name != "always_dynamic") {
    throw std::invalid_argument("--policy " + choice.name +
                                ": is for the plane, and the motion is in space");
  }
  return Any_policy_3();
}

Kept_motion_3::Kept_motion_3(const scenario::Motion_3& motion, const Any_policy_3& policy)
{
  if (motion.has_fixed_population()) {
    m_triangulation.emplace(begin_of(motion), end_of(motion), policy);
  } else {
    m_population.emplace(Dynamic_3(policy));
    update_population(motion);
  }
  find_places(motion);
}

CGAL::Update_report_3 Kept_motion_3::update(const scenario::Motion_3& motion)
{
  return m_population ? update_population(motion)
                      : m_triangulation->update(begin_of(motion), end_of(motion));
}

CGAL::Update_report_3 Kept_motion_3::update_population(const scenario::Motion_3& motion)
{
  using Place = boost::counting_iterator<std::size_t>;
  const auto id = [&](std::size_t place) { return motion.ids()[place]; };
  const auto point = [&](std::size_t place) { return As_point()(motion.points()[place]); };
  return m_population->update(Place(0), Place(motion.points().size()),
                              boost::make_function_property_map<std::size_t>(id),
                              boost::make_function_property_map<std::size_t>(point));
}

void Kept_motion_3::find_places(const scenario::Motion_3& motion)
{
  m_places.resize(triangulation().number_of_ids());
  for (std::size_t place = 0; place != motion.points().size(); ++place) {
    m_places[id(motion, place)] = static_cast<std::uint32_t>(place);
  }
}

Motion_run_3::Motion_run_3(scenario::Motion_3& motion, const Any_policy_3& policy)
  : m_motion(motion)
  , m_kept(motion, policy)
{
  with_frame_in_message([this] { begin_frame(); });
}

void Motion_run_3::check_first_frame()
{
  with_frame_in_message([this] {
    m_opponents.prepare(m_motion.points(), true);
    check();
  });
}

bool Motion_run_3::advance()
{
  bool is_there = false;
  ++m_record.frame;
  with_frame_in_message([&] {
    is_there = m_motion.advance(neighbors());
    if (is_there) {
      begin_frame();
      m_opponents.prepare(m_motion.points(), m_record.population_changed);
      time_all();
      if (m_record.population_changed) {
        m_kept.find_places(m_motion);
      }
      check();
    }
  });
  return is_there;
}

std::vector<Motion_run_3::Shown_cell_3> Motion_run_3::cells() const
{
  std::vector<Shown_cell_3> cells;
  triangulation().for_each_cell([&](const std::array<std::size_t, 4>& ids) {
    Shown_cell_3 cell{};
    std::transform(ids.begin(), ids.end(), cell.begin(),
                   [this](std::size_t id) { return m_kept.place(id); });
    cells.push_back(cell);
  });
  return cells;
}

// Pairs of places; none if the motion uses no neighbors.
const scenario::Neighbor_edges& Motion_run_3::neighbors()
{
  m_neighbors.clear();
  if (m_motion.uses_neighbors()) {
    triangulation().for_each_edge([this](std::size_t i, std::size_t j) {
      m_neighbors.emplace_back(m_kept.place(i), m_kept.place(j));
    });
  }
  return m_neighbors;
}

template <class Work>
void Motion_run_3::with_frame_in_message(const Work& work) const
{
  try {
    work();
  } catch (const std::exception& error) {
    const std::int64_t number =
        m_motion.frame_number().value_or(static_cast<std::int64_t>(m_record.frame));
    throw std::runtime_error("frame " + std::to_string(number) + ": " + error.what());
  }
}

void Motion_run_3::begin_frame()
{
  check_coordinates();
  m_record.number = m_motion.frame_number().value_or(static_cast<std::int64_t>(m_record.frame));
  m_record.time = m_motion.time();
  m_record.points = m_motion.points().size();
  m_record.population_changed = m_motion.population_changed();
  m_record.update = {};
}

// CGAL's static triangulation may never end on a coordinate that is no number.
void Motion_run_3::check_coordinates() const
{
  for (std::size_t i = 0; i != m_motion.points().size(); ++i) {
    const scenario::Point_3& point = m_motion.points()[i];
    if (!std::all_of(point.begin(), point.end(), [](double c) { return std::isfinite(c); })) {
      throw std::runtime_error("the point with id " + m_motion.id_text(i) +
                               " has left all bounds; a smaller time step may keep it");
    }
  }
}

// The order rotates: whoever comes first warms the caches for the others.
void Motion_run_3::time_all()
{
  constexpr std::size_t contestants = 3;
  for (std::size_t i = 0; i != contestants; ++i) {
    switch ((m_record.frame + i) % contestants) {
    case 0:
      time_dynamic();
      break;
    case 1:
      m_record.nanoseconds.static_insert = m_opponents.time_insert();
      break;
    default:
      m_record.nanoseconds.static_fastest = m_opponents.time_fastest();
    }
  }
}

void Motion_run_3::time_dynamic()
{
  m_record.nanoseconds.dynamic =
      nanoseconds_of([this] { m_record.update = m_kept.update(m_motion); });
}

void Motion_run_3::check()
{
  m_record.certified = triangulation().is_certified();
  if (!triangulation().is_valid()) {
    throw std::runtime_error("the triangulation is not Delaunay");
  }
}

} // namespace run
