// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_MOTION_RUN_H
#define SCENARIO_RUNNER_MOTION_RUN_H

#include "scenario_runner/Cells_in_domains.h"
#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_population_2.h>
#include <CGAL/iterator.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace run {

// Reads the pairs of neighbors that a motion's physics needs. Keeps its memory.
class Neighbor_reader
{
public:
  // Returns pairs of ids, which are places in the motion; none if the motion uses no neighbors.
  template <class Dynamic>
  const scenario::Neighbor_edges& operator()(const scenario::Motion& motion, const Dynamic& dt)
  {
    m_edges.clear();
    if (motion.uses_neighbors()) {
      // in periodic space also by which image, and a point may be its own neighbor
      dt.for_each_edge([this](std::size_t i, std::size_t j, const auto&...) {
        if (i != j) {
          m_edges.emplace_back(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        }
      });
    }
    return m_edges;
  }

private:
  scenario::Neighbor_edges m_edges;
};

// The triangulation of a motion, from its first frame on. If points come and go, it knows them by
// the motion's ids, otherwise by their places. `Space::cell(motion)` is a tuple of what an update
// and a constructor take beside the points: nothing, or the cell of the frame.
template <class Dynamic, class Space>
class Kept_motion
{
public:
  // `empty` has no points yet.
  Kept_motion(const scenario::Motion& motion, Dynamic empty)
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
    const auto update_with = [&](const auto&... cell) {
      const auto& points = motion.points();
      return m_population
                 ? update_population(motion, cell...)
                 : m_triangulation->update(points.begin(), points.end(), Point_map(), cell...);
    };
    return std::apply(update_with, Space::cell(motion));
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

  template <class... Cell>
  CGAL::Update_report_2 update_population(const scenario::Motion& motion, const Cell&... cell)
  {
    using Place = boost::counting_iterator<std::size_t>;
    const auto id = [&](std::size_t place) { return motion.ids()[place]; };
    const auto point = [&](std::size_t place) { return get(Point_map(), motion.points()[place]); };
    return m_population->update(Place(0), Place(motion.points().size()),
                                boost::make_function_property_map<std::size_t>(id),
                                boost::make_function_property_map<std::size_t>(point), cell...);
  }

  // exactly one of them exists
  std::optional<Dynamic> m_triangulation;
  std::optional<Population> m_population;
};

// Lets a motion run and keeps its triangulation: times every frame against the static opponents,
// and checks the result outside of the timing.
template <class Kept_dynamic, class Space>
class Motion_run : public Run_view
{
public:
  using Dynamic = Kept_dynamic;

  template <class Classifier>
  Motion_run(scenario::Motion& motion, const Classifier& classifier, const Any_repair& repair,
             const CGAL::Static_engines_2& engines, const Any_policy& policy)
    : m_motion(motion)
  {
    const auto empty_triangulation = [&](const auto&... cell) {
      return Dynamic(cell..., typename Dynamic::Settings{classifier, repair, engines, policy});
    };
    with_frame_in_message([&] {
      begin_frame();
      m_kept.emplace(motion, std::apply(empty_triangulation, Space::cell(motion)));
    });
  }

  void check_first_frame()
  {
    with_frame_in_message([this] {
      prepare_opponents();
      m_opponents.time_insert();
      check();
    });
  }

  // Goes to the next frame, times all contestants there, and checks what came out. False at the end
  // of the motion.
  bool advance()
  {
    const bool is_there = measure();
    if (is_there) {
      with_frame_in_message([this] { check(); });
    }
    return is_there;
  }

  // Makes a step without checks, which can take longer than all else.
  bool measure()
  {
    return go_on([this] {
      prepare_opponents();
      time_all();
    });
  }

  // Makes a step without checks and opponents, on the way to frames that are measured. If `is_last`
  // the next one is measured, and opponents find the order for it in this frame.
  bool follow(bool is_last)
  {
    return go_on([this, is_last] {
      time_dynamic();
      if (is_last) {
        prepare_opponents();
      }
    });
  }

  const scenario::Motion& motion() const override { return m_motion; }

  std::vector<Vertex_set> sets() const override
  {
    const std::vector<Vertex_set> sets_of_its_vertices = sets_of_vertices(*this);
    std::vector<Vertex_set> sets;
    for (std::size_t place = 0; place != m_motion.points().size(); ++place) {
      sets.push_back(sets_of_its_vertices[vertex(place)]);
    }
    return sets;
  }
  std::vector<Shown_cell> cells(Cells_in_domains& bounded, double radius) const override
  {
    compute_cells(bounded, triangulation(), radius);
    std::vector<Shown_cell> shown;
    const auto show = [&](const auto& cells) {
      for (std::size_t place = 0; place != m_motion.points().size(); ++place) {
        const std::size_t id = m_kept->id(m_motion, place);
        shown.push_back({cells.areas()[id], cells.perimeters()[id],
                         number_of_contacts(cells, triangulation().representative(id)),
                         cells.free_lengths()[id], cells.wall_lengths()[id]});
      }
    };
    std::visit(show, bounded);
    return shown;
  }
  const Frame_record& record() const override { return m_record; }
  const Dynamic& triangulation() const { return m_kept->triangulation(); }

protected:
  using Kept = Kept_motion<Dynamic, Space>;
  using Opponents = typename Space::Opponents;

  const Kept& kept() const { return *m_kept; }
  Opponents& opponents() { return m_opponents; }

  // The vertex, in the frame of the triangulation, of the point in this place of the motion.
  auto vertex(std::size_t place) const
  {
    return triangulation().frame().vertex(m_kept->id(m_motion, place));
  }

  // The Matthews correlation coefficient as against an opponent's triangulation of the frame.
  virtual double agreement() = 0;

private:
  // The number of images of points that a cell touches. Walls may divide a contact into pieces.
  template <class Cells>
  static std::size_t number_of_contacts(const Cells& cells, std::size_t id)
  {
    std::set<std::pair<std::size_t, CGAL::Periodic_shift_2>> neighbors;
    for (std::size_t i = first_piece(cells, id); i != first_piece(cells, id + 1); ++i) {
      const auto& piece = cells.pieces()[i];
      if (piece.side == Cells::Side::NEIGHBOR) {
        neighbors.emplace(piece.other, piece.shift);
      }
    }
    return neighbors.size();
  }

  template <class Work>
  void with_frame_in_message(Work work) const
  {
    try {
      work();
    } catch (const std::exception& error) {
      throw std::runtime_error("frame " + std::to_string(frame_number()) + ": " + error.what());
    }
  }

  template <class Work>
  bool go_on(Work work)
  {
    ++m_record.frame;
    bool is_there = false;
    with_frame_in_message([&] {
      is_there = m_motion.advance(m_neighbors(m_motion, triangulation()));
      if (is_there) {
        begin_frame();
        work();
      }
    });
    return is_there;
  }

  std::int64_t frame_number() const
  {
    return m_motion.frame_number().value_or(static_cast<std::int64_t>(m_record.frame));
  }

  void begin_frame()
  {
    check_coordinates();
    m_record.number = frame_number();
    m_record.time = m_motion.time();
    m_record.points = m_motion.points().size();
    m_record.population_changed = m_motion.population_changed();
    m_record.update = {};
  }

  // CGAL's static triangulation may never end on a coordinate that is no number.
  void check_coordinates() const
  {
    for (std::size_t i = 0; i != m_motion.points().size(); ++i) {
      const scenario::Point& point = m_motion.points()[i];
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        throw std::runtime_error("the point with id " + m_motion.id_text(i) +
                                 " has left all bounds; a smaller time step may keep it");
      }
    }
  }

  void prepare_opponents() { Space::prepare(m_opponents, m_motion, m_record.population_changed); }

  // The order rotates: whoever comes first warms the caches for the others.
  void time_all()
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

  void time_dynamic()
  {
    m_record.nanoseconds.dynamic =
        nanoseconds_of([this] { m_record.update = m_kept->update(m_motion); });
  }

  void check()
  {
    // before certify(): what claims to be certified is checked for it too
    if (!triangulation().is_valid()) {
      throw std::runtime_error("the triangulation is not valid");
    }
    m_record.certified = m_kept->certify();
    m_record.validity = agreement();
  }

  scenario::Motion& m_motion;
  std::optional<Kept> m_kept;
  Opponents m_opponents;
  Neighbor_reader m_neighbors;
  Frame_record m_record;
};

} // namespace run

#endif // SCENARIO_RUNNER_MOTION_RUN_H
