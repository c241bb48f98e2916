// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_SET_FIGURES_H
#define MANUAL_FIGURES_SET_FIGURES_H

#include "Followed_motion.h"
#include "Panel.h"
#include "scenario_runner/Pictures.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace manual_figures {

using run::Vertex_set;
using Sets = std::vector<Vertex_set>;
using Ids = std::vector<std::size_t>;

// The colors of figure 4.1 of the thesis, somewhat darker.
inline std::string color_of(Vertex_set set)
{
  static const std::array<const char*, 4> colors = {"#666666", "#00b8d4", "#1b8a2f", "#d50000"};
  return colors[static_cast<std::size_t>(set)];
}

inline run::Bounds around(const Ids& ids, const std::vector<Point>& points, double margin)
{
  std::vector<Point> chosen;
  for (const std::size_t id : ids) {
    chosen.push_back(points[id]);
  }
  run::Bounds bounds = run::bounds_of(chosen);
  bounds.low = {bounds.low.x - margin, bounds.low.y - margin};
  bounds.high = {bounds.high.x + margin, bounds.high.y + margin};
  return bounds;
}

inline void draw_points(Panel& panel, const std::vector<Point>& points, const Sets& sets,
                        double radius)
{
  for (std::size_t id = 0; id != points.size(); ++id) {
    panel.dot(points[id], color_of(sets[id]), sets[id] == Vertex_set::none ? 0.6 * radius : radius);
  }
}

inline Ids ids_in_sets(const Sets& sets)
{
  Ids ids;
  for (std::size_t id = 0; id != sets.size(); ++id) {
    if (sets[id] != Vertex_set::none) {
      ids.push_back(id);
    }
  }
  return ids;
}

// The Classified, Padded and Border sets of a frame of the dam break: the first one from `first` on
// whose sets lie together.
inline Panel draw_sets(std::size_t first)
{
  using Classifier = CGAL::Point_distance_classifier_2;
  constexpr double widest = 15.0; // in diameters of a particle
  Followed_motion<Classifier> motion("dam_break", {}, Classifier(0.7));
  for (;;) {
    motion.advance();
    const CGAL::Update_report_2& update = motion.record().update;
    if (motion.frame() < first || update.rebuilt() || update.classified < 6) {
      continue;
    }
    const run::Bounds part = around(ids_in_sets(motion.sets()), motion.points(), 2.0);
    if (part.width() > widest || part.height() > widest) {
      continue;
    }
    Panel panel(part, "");
    for (const auto& [i, j] : motion.edges()) {
      panel.line(motion.points()[i], motion.points()[j], "#999999", 3.0);
    }
    draw_points(panel, motion.points(), motion.sets(), 15.0);
    return panel;
  }
}

// The points that are connected with a classified point: a cluster, which is spliced by itself.
class Cluster
{
public:
  Cluster(std::size_t start, const Edges& edges, const Sets& sets)
    : m_is_inside(sets.size(), false)
    , m_is_border(sets.size(), false)
  {
    m_is_inside[start] = true;
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto& [i, j] : edges) {
        grows = join(i, j, sets) || grows;
        grows = join(j, i, sets) || grows;
      }
    }
  }

  bool is_inside(std::size_t id) const { return m_is_inside[id]; }
  bool has(std::size_t id) const { return m_is_inside[id] || m_is_border[id]; }

  Ids ids() const
  {
    Ids ids;
    for (std::size_t id = 0; id != m_is_inside.size(); ++id) {
      if (has(id)) {
        ids.push_back(id);
      }
    }
    return ids;
  }

  std::size_t number_of(Vertex_set set, const Sets& sets) const
  {
    std::size_t number = 0;
    for (const std::size_t id : ids()) {
      number += sets[id] == set;
    }
    return number;
  }

private:
  // Adds `next` to the cluster if it belongs to it. True if it is new there.
  bool join(std::size_t inside, std::size_t next, const Sets& sets)
  {
    if (!m_is_inside[inside] || has(next)) {
      return false;
    }
    (sets[next] >= Vertex_set::padded ? m_is_inside : m_is_border)[next] = true;
    return true;
  }

  std::vector<bool> m_is_inside;
  std::vector<bool> m_is_border;
};

// The edges of the Delaunay triangulation of some points alone.
inline Edges triangulate_alone(const Ids& ids, const std::vector<Point>& points)
{
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, run::Kernel>;
  using Tds = CGAL::Triangulation_data_structure_2<Vertex>;
  CGAL::Delaunay_triangulation_2<run::Kernel, Tds> triangulation;
  for (const std::size_t id : ids) {
    triangulation.insert({points[id].x, points[id].y})->info() = id;
  }
  Edges edges;
  for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e) {
    edges.insert(in_order(e->first->vertex(triangulation.cw(e->second))->info(),
                          e->first->vertex(triangulation.ccw(e->second))->info()));
  }
  return edges;
}

// A border splice: what motion has broken, the Triangulation set alone, and the result.
class Splice_figure
{
public:
  static std::string draw()
  {
    scenario::Overrides overrides;
    overrides.points = 2000;
    overrides.time_step = 0.003; // in spacings
    Followed_motion<Classifier, CGAL::Border_splice_repair_2> motion("brownian", overrides,
                                                                     Classifier());
    for (;;) {
      motion.advance();
      const CGAL::Update_report_2& update = motion.record().update;
      if (update.rebuilt() || update.splices != 1 || update.enlargements != 0) {
        continue;
      }
      const Sets sets = motion.sets();
      std::vector<bool> is_seen(sets.size(), false);
      for (std::size_t id = 0; id != sets.size(); ++id) {
        if (sets[id] == Vertex_set::classified && !is_seen[id]) {
          const Cluster cluster(id, motion.previous_edges(), sets);
          if (is_fit(cluster, motion.points(), sets)) {
            return draw(motion, cluster, sets);
          }
          for (const std::size_t member : cluster.ids()) {
            is_seen[member] = true;
          }
        }
      }
    }
  }

private:
  using Classifier = CGAL::Circumcircle_classifier_2;

  // True if the cluster is small, compact, and away from the hull.
  static bool is_fit(const Cluster& cluster, const std::vector<Point>& points, const Sets& sets)
  {
    const run::Bounds part = around(cluster.ids(), points, 0.0);
    const std::size_t classified = cluster.number_of(Vertex_set::classified, sets);
    return classified >= 5 && classified <= 8 && part.width() < 1.3 * part.height() &&
           part.height() < 1.3 * part.width() && part.low.x > 0.1 && part.low.y > 0.1 &&
           part.high.x < 0.9 && part.high.y < 0.9;
  }

  template <class Motion>
  static std::string draw(const Motion& motion, const Cluster& cluster, const Sets& all_sets)
  {
    const std::vector<Point>& points = motion.points();
    const Edges before = motion.previous_edges();
    const Edges after = motion.edges();
    const Edges alone = triangulate_alone(cluster.ids(), points);
    const run::Bounds part = around(cluster.ids(), points, 0.012);
    Sets sets(all_sets.size(), Vertex_set::none); // of this cluster
    for (const std::size_t id : cluster.ids()) {
      sets[id] = cluster.is_inside(id) ? all_sets[id] : Vertex_set::border;
    }

    Panel broken(part, "(a) after the motion");
    Panel set(part, "(b) the Triangulation set alone");
    Panel mended(part, "(c) after the splice");
    draw_edges(broken, before, after, points, "#d50000");
    for (const auto& [i, j] : alone) {
      if (cluster.is_inside(i) || cluster.is_inside(j)) {
        set.line(points[i], points[j], "#666666", 4.0);
      } else {
        set.line(points[i], points[j], "#999999", 3.0, "4 10");
      }
    }
    draw_edges(mended, after, before, points, "#1b5fd5");
    draw_points(broken, points, sets, 16.0);
    for (const std::size_t id : cluster.ids()) {
      set.dot(points[id], color_of(sets[id]), 16.0);
    }
    draw_points(mended, points, sets, 16.0);
    return svg_of({&broken, &set, &mended});
  }

  // Draws `edges`, in color those that are not among `others`.
  static void draw_edges(Panel& panel, const Edges& edges, const Edges& others,
                         const std::vector<Point>& points, const std::string& color)
  {
    for (const bool is_other : {false, true}) {
      for (const auto& [i, j] : edges) {
        if ((others.count({i, j}) == 0) == is_other) {
          panel.line(points[i], points[j], is_other ? color : "#999999", is_other ? 9.0 : 3.0);
        }
      }
    }
  }
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_SET_FIGURES_H
