// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Motion_run_3.h"

#include "scenario_runner/Measurement.h"
#include "scenario_runner/space/Kept_motion_3.h"
#include "scenario_runner/space/Kept_periodic_motion_3.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace run {

namespace {

// `Kept` has the triangulation of a motion, in open or in periodic space.
template <class Kept>
class Motion_run_of_3 : public Motion_run_3
{
public:
  // `settings` are what Kept takes beside the motion.
  template <class... Settings>
  explicit Motion_run_of_3(scenario::Motion_3& motion, const Settings&... settings)
    : Motion_run_3(motion)
  {
    start([&] { m_kept.emplace(motion, settings...); });
    Motion_run_of_3::find_places();
  }

  std::vector<Shown_cell_3> cells() const override
  {
    const std::optional<scenario::Cell_3> box = motion().cell();
    std::vector<Shown_cell_3> cells;
    m_kept->for_each_cell(
        [&](const std::array<std::size_t, 4>& ids, const std::array<scenario::Shift_3, 4>& shifts) {
          Shown_cell_3 cell{{}, shifts};
          std::transform(ids.begin(), ids.end(), cell.places.begin(),
                         [this](std::size_t id) { return m_places[id]; });
          if (box && box->number_of_periodic_sides() < 3) {
            for (scenario::Shift_3& shift : cell.shifts) {
              shift = box->shift_of_periodic_sides(shift);
            }
          }
          cells.push_back(cell);
        });
    return cells;
  }

  std::vector<Measured_cell_3>
  measured_cells(CGAL::Voronoi_cell_measures_3& measures) const override
  {
    m_kept->measure(motion(), measures);
    std::vector<Measured_cell_3> cells;
    for (std::size_t place = 0; place != motion().points().size(); ++place) {
      const std::size_t id = m_kept->id(motion(), place);
      const std::size_t shared = m_kept->triangulation().representative(id);
      cells.push_back({measures.volumes()[id], measures.surface_areas()[id],
                       measures.offsets()[shared + 1] - measures.offsets()[shared]});
    }
    return cells;
  }

private:
  // A point may be a neighbor of its own image.
  void list_neighbors(scenario::Neighbor_edges& neighbors) const override
  {
    m_kept->triangulation().for_each_edge([&](std::size_t i, std::size_t j, const auto&...) {
      if (i != j) {
        neighbors.emplace_back(m_places[i], m_places[j]);
      }
    });
  }

  CGAL::Update_report_3 update() override { return m_kept->update(motion()); }

  void find_places() override
  {
    m_places.resize(m_kept->triangulation().number_of_ids());
    for (std::size_t place = 0; place != motion().points().size(); ++place) {
      m_places[m_kept->id(motion(), place)] = static_cast<std::uint32_t>(place);
    }
  }

  bool is_certified() const override { return m_kept->triangulation().is_certified(); }
  bool is_valid() const override { return m_kept->triangulation().is_valid(); }

  void prepare_opponents() override
  {
    if constexpr (std::is_same_v<Kept, Kept_motion_3>) {
      m_opponents.prepare(motion().points(), record().frame == 0 || record().population_changed);
    } else {
      m_opponents.prepare(motion(), m_kept->triangulation());
    }
  }
  double time_insert() override { return m_opponents.time_insert(); }
  double time_fastest() override { return m_opponents.time_fastest(); }

  std::optional<Kept> m_kept;
  std::vector<std::uint32_t> m_places; // by the triangulation's ids
  typename Kept::Opponents m_opponents;
};

} // namespace

std::unique_ptr<Motion_run_3> make_motion_run_3(scenario::Motion_3& motion,
                                                const Policy_choice& policy)
{
  const Any_policy_3 its_policy = make_policy_3(policy);
  if (!motion.cell()) {
    return std::make_unique<Motion_run_of_3<Kept_motion_3>>(motion, its_policy);
  }
  return std::make_unique<Motion_run_of_3<Kept_periodic_motion_3>>(motion, its_policy);
}

void Motion_run_3::check_first_frame()
{
  with_frame_in_message([this] {
    prepare_opponents();
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
      prepare_opponents();
      time_all();
      if (m_record.population_changed) {
        find_places();
      }
      check();
    }
  });
  return is_there;
}

// None if the motion uses no neighbors.
const scenario::Neighbor_edges& Motion_run_3::neighbors()
{
  m_neighbors.clear();
  if (m_motion.uses_neighbors()) {
    list_neighbors(m_neighbors);
  }
  return m_neighbors;
}

template <class Triangulate>
void Motion_run_3::start(const Triangulate& triangulate)
{
  with_frame_in_message([&] {
    begin_frame();
    triangulate();
  });
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
      m_record.nanoseconds.dynamic = nanoseconds_of([this] { m_record.update = update(); });
      break;
    case 1:
      m_record.nanoseconds.static_insert = time_insert();
      break;
    default:
      m_record.nanoseconds.static_fastest = time_fastest();
    }
  }
  if (m_motion.cell()) { // which way is faster depends on the cell
    auto& [dynamic, insert, fastest] = m_record.nanoseconds;
    fastest = (std::min)(fastest, insert);
  }
}

void Motion_run_3::check()
{
  m_record.certified = is_certified();
  if (!is_valid()) {
    throw std::runtime_error("the triangulation is not Delaunay");
  }
}

} // namespace run
