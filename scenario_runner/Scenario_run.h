// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SCENARIO_RUN_H
#define SCENARIO_RUNNER_SCENARIO_RUN_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/delaunay_agreement.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/iterator.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace run {

// Who is whose neighbor in a triangulation, as a motion's physics asks for it. Keeps its memory.
class Neighbor_reader
{
public:
  // Ids are places in the motion. A motion that does not ask gets none.
  template <class Dynamic>
  const scenario::Neighbor_edges& operator()(const scenario::Motion& motion, const Dynamic& dt)
  {
    m_edges.clear();
    if (motion.uses_neighbors()) {
      dt.for_each_edge([this](std::size_t i, std::size_t j) {
        m_edges.emplace_back(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      });
    }
    return m_edges;
  }

private:
  scenario::Neighbor_edges m_edges;
};

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

// Lets a motion run and keeps its triangulation: times every frame against the static opponents,
// and checks the result outside of the timing.
template <class Classifier>
class Scenario_run : public Run_view
{
public:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier, Any_repair,
                                                         CGAL::Default, Any_policy>;

  Scenario_run(scenario::Motion& motion, const Classifier& classifier, const Any_repair& repair,
               const CGAL::Static_engines_2& engines, const Any_policy& policy)
    : m_motion(motion)
  {
    with_frame_in_message([&] {
      begin_frame();
      m_kept.emplace(motion,
                     Dynamic(typename Dynamic::Settings{classifier, repair, engines, policy}));
    });
  }

  void check_first_frame()
  {
    with_frame_in_message([this] {
      m_opponents.prepare(m_motion.points(), m_record.population_changed);
      m_opponents.time_insert();
      check();
    });
  }

  // Goes to the next frame, times everybody there, and checks what came out. False at the end of
  // the motion.
  bool advance()
  {
    const bool is_there = measure();
    if (is_there) {
      with_frame_in_message([this] { check(); });
    }
    return is_there;
  }

  // The same without the checks, where they would take longer than all else.
  bool measure()
  {
    return go_on([this] {
      m_opponents.prepare(m_motion.points(), m_record.population_changed);
      time_all();
    });
  }

  // The same without the checks and the opponents, on the way to the frames that count. Their order
  // for the opponents comes from the frame before the next one that is measured, if `is_last`.
  bool follow(bool is_last)
  {
    return go_on([this, is_last] {
      time_dynamic();
      if (is_last) {
        m_opponents.prepare(m_motion.points(), m_record.population_changed);
      }
    });
  }

  const scenario::Motion& motion() const override { return m_motion; }
  const Frame_record& record() const override { return m_record; }
  const Dynamic& triangulation() const { return m_kept->triangulation(); }

  std::vector<Vertex_set> sets() const override
  {
    const std::vector<Vertex_set> sets_of_its_vertices = sets_of_vertices(*this);
    std::vector<Vertex_set> sets;
    for (std::size_t place = 0; place != m_motion.points().size(); ++place) {
      sets.push_back(sets_of_its_vertices[vertex(place)]);
    }
    return sets;
  }

  scenario::Neighbor_edges edges() const override
  {
    const std::vector<std::uint32_t> places = places_of_vertices();
    const auto frame = triangulation().frame();
    scenario::Neighbor_edges edges;
    triangulation().for_each_edge([&](std::size_t i, std::size_t j) {
      edges.emplace_back(places[frame.vertex(static_cast<Index>(i))],
                         places[frame.vertex(static_cast<Index>(j))]);
    });
    return edges;
  }

  std::vector<Shown_triangle> triangles() const override
  {
    const std::vector<std::uint32_t> places = places_of_vertices();
    const auto frame = triangulation().frame();
    std::vector<bool> are_delaunay(frame.number_of_faces(), true);
    for (Index e = 0; e != frame.number_of_edges(); ++e) {
      if (!frame.is_delaunay(e)) {
        for (const Index f : frame.faces_at(e)) {
          are_delaunay[f] = false;
        }
      }
    }
    std::vector<Shown_triangle> triangles;
    for (Index f = 0; f != frame.number_of_faces(); ++f) {
      const auto [a, b, c] = frame.face(f);
      if (!Frame::is_infinite(a) && !Frame::is_infinite(b) && !Frame::is_infinite(c)) {
        triangles.push_back({{places[a], places[b], places[c]}, are_delaunay[f]});
      }
    }
    return triangles;
  }

private:
  using Frame = typename Dynamic::Frame;
  using Index = typename Frame::Index;

  // The vertex, in the frame of the triangulation, of the point in this place of the motion.
  Index vertex(std::size_t place) const
  {
    return triangulation().frame().vertex(static_cast<Index>(m_kept->id(m_motion, place)));
  }

  // Of the first of the points that coincide there.
  std::vector<std::uint32_t> places_of_vertices() const
  {
    std::vector<std::uint32_t> places(triangulation().number_of_vertices() + 1);
    for (std::size_t place = m_motion.points().size(); place-- != 0;) {
      places[vertex(place)] = static_cast<std::uint32_t>(place);
    }
    return places;
  }

  template <class Work>
  void with_frame_in_message(Work work) const
  {
    try {
      work();
    } catch (const std::exception& error) {
      throw std::runtime_error("frame " + std::to_string(m_record.frame) + ": " + error.what());
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

  void begin_frame()
  {
    check_coordinates();
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
        throw std::runtime_error("the point with id " + std::to_string(m_motion.ids()[i]) +
                                 " has left all bounds; a smaller time step may keep it");
      }
    }
  }

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
    m_record.validity = CGAL::delaunay_agreement(triangulation(), m_opponents.reference())
                            .matthews_correlation_coefficient();
  }

  scenario::Motion& m_motion;
  std::optional<Kept_triangulation<Dynamic>> m_kept;
  Static_opponents m_opponents;
  Neighbor_reader m_neighbors;
  Frame_record m_record;
};

} // namespace run

#endif // SCENARIO_RUNNER_SCENARIO_RUN_H
