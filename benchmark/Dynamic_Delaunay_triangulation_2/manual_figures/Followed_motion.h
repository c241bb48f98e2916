// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_FOLLOWED_MOTION_H
#define MANUAL_FIGURES_FOLLOWED_MOTION_H

#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Pictures.h"
#include "scenario_runner/Scenario_file.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace manual_figures {

using Id_pair = std::pair<std::size_t, std::size_t>;
using Edges = std::set<Id_pair>;

inline Id_pair in_order(std::size_t i, std::size_t j)
{
  return {(std::min)(i, j), (std::max)(i, j)};
}

// A scenario, and the triangulation that follows it and gives it its neighbors.
template <class Classifier, class Repair = CGAL::Default>
class Followed_motion
{
public:
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel, Classifier, CGAL::With_repair_2<Repair>>;

  // The part of run::Frame_record that sets_of_vertices() reads.
  struct Record
  {
    CGAL::Update_report_2 update;
  };

  Followed_motion(const std::string& name, const scenario::Overrides& overrides,
                  const Classifier& classifier)
    : m_motion(scenario::open_motion(scenario::scenario_file(name), overrides))
    , m_triangulation(m_motion->points().begin(), m_motion->points().end(), run::Point_map(),
                      classifier)
  {
  }

  void advance()
  {
    m_previous_edges = edges();
    const scenario::Neighbor_edges neighbors(m_previous_edges.begin(), m_previous_edges.end());
    if (!m_motion->advance(neighbors)) {
      throw std::runtime_error("the motion has ended");
    }
    m_record.update = m_triangulation.update(points().begin(), points().end(), run::Point_map());
    ++m_frame;
  }

  const Dynamic& triangulation() const { return m_triangulation; }
  const std::vector<scenario::Point>& points() const { return m_motion->points(); }
  const Record& record() const { return m_record; }
  std::size_t frame() const { return m_frame; }

  // The edges of the frame before, and those of this one, as pairs of ids.
  const Edges& previous_edges() const { return m_previous_edges; }
  Edges edges() const
  {
    Edges edges;
    m_triangulation.for_each_edge(
        [&edges](std::size_t i, std::size_t j) { edges.insert(in_order(i, j)); });
    return edges;
  }

  // The set to which each point belongs, by ids.
  std::vector<run::Vertex_set> sets() const
  {
    const std::vector<run::Vertex_set> of_vertices = run::sets_of_vertices(*this);
    std::vector<run::Vertex_set> sets;
    for (std::uint32_t id = 0; id != points().size(); ++id) {
      sets.push_back(of_vertices[m_triangulation.frame().vertex(id)]);
    }
    return sets;
  }

private:
  std::unique_ptr<scenario::Motion> m_motion;
  Dynamic m_triangulation;
  Record m_record;
  Edges m_previous_edges;
  std::size_t m_frame = 0;
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_FOLLOWED_MOTION_H
