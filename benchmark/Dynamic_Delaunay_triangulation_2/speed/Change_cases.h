// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_CHANGE_CASES_H
#define SPEED_CHANGE_CASES_H

#include "../common/Cases.h"
#include "../common/Contest.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace speed {

// A few points of a random cloud change, one call after the other: once in the maintained
// triangulation, once in CGAL's own, in turns.
class Change_case
{
public:
  enum class Kind { INSERT, REMOVE, MOVE_NEAR, MOVE_FAR };

  Change_case(std::size_t points, Kind kind)
    : m_kind(kind)
    , m_width(std::sqrt(static_cast<double>(points)))
  {
    const common::Points cloud = common::random_cloud<Point>(points, m_random);
    m_dynamic = Dynamic(cloud.begin(), cloud.end());
    for (const Point& point : cloud) {
      m_handles.push_back(m_static.insert(point));
    }
  }

  common::Figures measure()
  {
    constexpr std::size_t rounds = 25, changes = 40;
    std::vector<double> dynamic, own;
    for (std::size_t round = 0; round != rounds; ++round) {
      draw(changes);
      common::in_turn(round, 2, [&](std::size_t contestant) {
        contestant == 0 ? dynamic.push_back(time([this] { change_dynamic(); }))
                        : own.push_back(time([this] { change_static(); }));
      });
      restore();
    }
    common::require(m_dynamic.is_certified(), "the triangulation is not certified");
    common::require_equal(m_dynamic, m_static);
    common::Figures figures = {{"points", static_cast<double>(m_handles.size())},
                               {"CGAL", run::spread(own)->median}};
    common::add_spread(figures, "dynamic", "", dynamic);
    figures["vs_CGAL"] = figures["CGAL"] / figures["dynamic"];
    return figures;
  }

private:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>;
  using Point = run::Kernel::Point_2;
  using Handle = run::Static_triangulation::Vertex_handle;

  Point random_point()
  {
    const double x = m_random.uniform(0.0, m_width);
    return {x, m_random.uniform(0.0, m_width)};
  }

  Point near(const Point& p)
  {
    constexpr double step = 0.01;
    const double dx = step * m_random.gaussian();
    return {p.x() + dx, p.y() + step * m_random.gaussian()};
  }

  // Draws the points that change in this round, and their new places.
  void draw(std::size_t changes)
  {
    m_ids.clear();
    m_points.clear();
    std::vector<bool> is_drawn(m_handles.size());
    while (m_ids.size() != changes) {
      const auto id =
          static_cast<std::size_t>(m_random.uniform(0.0, static_cast<double>(m_handles.size())));
      if (!is_drawn[id]) {
        is_drawn[id] = true;
        m_ids.push_back(id);
        m_points.push_back(m_kind == Kind::MOVE_NEAR ? near(m_dynamic.point(id)) : random_point());
      }
    }
  }

  // Nanoseconds a change.
  template <class Work>
  double time(Work work) const
  {
    return run::nanoseconds_of(work) / static_cast<double>(m_ids.size());
  }

  void change_dynamic()
  {
    for (std::size_t i = 0; i != m_ids.size(); ++i) {
      switch (m_kind) {
      case Kind::INSERT:
        m_new_ids.push_back(m_dynamic.insert(m_points[i]));
        break;
      case Kind::REMOVE:
        m_dynamic.remove(m_ids[i]);
        break;
      default:
        m_dynamic.move(m_ids[i], m_points[i]);
      }
    }
  }

  void change_static()
  {
    for (std::size_t i = 0; i != m_ids.size(); ++i) {
      Handle& handle = m_handles[m_ids[i]];
      switch (m_kind) {
      case Kind::INSERT:
        m_new_handles.push_back(m_static.insert(m_points[i]));
        break;
      case Kind::REMOVE:
        m_removed.emplace_back(m_ids[i], handle->point());
        m_static.remove(handle);
        break;
      default:
        handle = m_static.move_if_no_collision(handle, m_points[i]);
      }
    }
  }

  // Undoes insertions and removals, untimed, so that there are as many points as before.
  void restore()
  {
    m_dynamic.remove(m_new_ids.begin(), m_new_ids.end());
    for (const Handle handle : m_new_handles) {
      m_static.remove(handle);
    }
    std::sort(m_removed.begin(), m_removed.end()); // free ids are given in this order
    for (const auto& [id, point] : m_removed) {
      m_handles[id] = m_static.insert(point);
      m_dynamic.insert(point);
    }
    m_new_ids.clear();
    m_new_handles.clear();
    m_removed.clear();
  }

  Kind m_kind;
  double m_width;
  scenario::Random_source m_random{1};
  Dynamic m_dynamic;
  run::Static_triangulation m_static;
  std::vector<Handle> m_handles; // of each id
  std::vector<std::size_t> m_ids;
  std::vector<Point> m_points;
  std::vector<std::size_t> m_new_ids;
  std::vector<Handle> m_new_handles;
  std::vector<std::pair<std::size_t, Point>> m_removed;
};

} // namespace speed

#endif // SPEED_CHANGE_CASES_H
