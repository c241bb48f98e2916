// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_SAFETY_FIGURES_H
#define MANUAL_FIGURES_SAFETY_FIGURES_H

#include "Followed_motion.h"
#include "Panel.h"
#include "scenario_runner/Pictures.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace manual_figures {

// Draws the edges of one frame of the dam break in hexagonal packing, and their tolerances.
class Safety_figures
{
public:
  explicit Safety_figures(std::size_t frame)
    : m_motion("dam_break_hexagonal", {}, CGAL::Circumcircle_classifier_2())
  {
    while (m_motion.frame() != frame) {
      m_motion.advance();
    }
    measure();
  }

  // Draws one edge, and the annulus of which the edge is safe.
  std::string draw_edge() const
  {
    const Frame frame = m_motion.triangulation().frame();
    const Frame_edge edge = frame.edge(choose_edge());
    const Point a = place(edge.left), b = place(edge.source), c = place(edge.target),
                d = place(edge.right);
    const Point o = center(a, b, c, d);
    const double inner = (std::max)(distance(o, b), distance(o, c));
    const double outer = (std::min)(distance(o, a), distance(o, d));
    const double t = 0.5 * (outer - inner);
    const double reach = outer + 0.35;
    Panel panel({{o.x - reach, o.y - reach}, {o.x + reach, o.y + reach}}, "");
    draw_edges(panel, [](Edge_index) { return false; });
    panel.circle(o, inner, "#1b8a2f", 4.0, "14 10");
    panel.circle(o, outer, "#1b8a2f", 4.0, "14 10");
    panel.circle(o, 0.5 * (inner + outer), "#1b8a2f", 7.0);
    for (const Point& p : {a, b, c, d}) {
      panel.disk(p, t, "rgba(27,95,213,0.25)");
      panel.dot(p, "#1b5fd5", 14.0);
    }
    panel.line(b, c, "#1b5fd5", 9.0);
    panel.dot(o, "#1b8a2f", 10.0);
    panel.letter(a, o, "a");
    panel.letter(b, o, "b");
    panel.letter(c, o, "c");
    panel.letter(d, o, "d");
    panel.letter(o, b, "o");
    panel.letter({o.x, o.y - 0.5 * (inner + outer)}, {o.x, o.y - 2.0 * outer}, "D");
    return svg_of({&panel});
  }

  // Draws how far the vertices of a part may go: each by its own tolerance, or all by the same one,
  // below which is the tolerance of one inner edge in `share`.
  std::string draw_tolerances(std::size_t share) const
  {
    const Frame frame = m_motion.triangulation().frame();
    const run::Bounds all = run::bounds_of(m_motion.points());
    const double side = 8.0;
    const Point corner{all.low.x + 3.0, all.low.y + 3.0};
    const run::Bounds part{corner, {corner.x + side, corner.y + side}};
    Panel own(part, "(a) a tolerance for each vertex");
    Panel common(part, "(b) one for all, and tight edges");
    const double t = tolerance_of_all(share);
    draw_edges(own, [](Edge_index) { return false; });
    draw_edges(common, [this, t](Edge_index e) { return m_tolerances[e] < t; });
    for (Vertex_index v(1); v <= frame.number_of_vertices(); ++v) {
      own.disk(place(v), (std::max)(0.0, tolerance_of(v)), disk_color);
      own.dot(place(v), "#333333", 4.0);
      common.disk(place(v), t, disk_color);
    }
    return svg_of({&own, &common});
  }

private:
  using Motion = Followed_motion<CGAL::Circumcircle_classifier_2>;
  using Frame = typename Motion::Dynamic::Frame;
  using Edge_index = typename Frame::Edge_index;
  using Vertex_index = typename Frame::Vertex_index;
  using Frame_edge = typename Frame::Edge;

  static constexpr const char* disk_color = "rgba(27,95,213,0.45)";

  static double distance(const Point& p, const Point& q)
  {
    return std::hypot(p.x - q.x, p.y - q.y);
  }

  // Where the bisectors of bc and ad meet.
  static Point center(const Point& a, const Point& b, const Point& c, const Point& d)
  {
    const double ux = c.x - b.x, uy = c.y - b.y;
    const double vx = d.x - a.x, vy = d.y - a.y;
    const double bc = 0.5 * (ux * (b.x + c.x) + uy * (b.y + c.y));
    const double ad = 0.5 * (vx * (a.x + d.x) + vy * (a.y + d.y));
    const double determinant = ux * vy - uy * vx;
    return {(bc * vy - ad * uy) / determinant, (ux * ad - vx * bc) / determinant};
  }

  Point place(Vertex_index v) const
  {
    const auto& position = m_motion.triangulation().frame().position(v);
    return {position.x, position.y};
  }

  void measure()
  {
    using CGAL::Dynamic_Delaunay_triangulations_2::internal::Edge_slack_2;
    const Frame frame = m_motion.triangulation().frame();
    for (Edge_index e(0); e != frame.number_of_edges(); ++e) {
      m_tolerances.push_back(Edge_slack_2(frame.edge(e), frame.corners(e)).tolerance());
    }
  }

  // A tolerance chosen as by the circumcircle classifier, but from all edges instead of a sample.
  double tolerance_of_all(std::size_t share) const
  {
    const Frame frame = m_motion.triangulation().frame();
    std::vector<double> sorted;
    for (Edge_index e(0); e != frame.number_of_edges(); ++e) {
      if (is_inner(frame.edge(e))) {
        sorted.push_back(m_tolerances[e]);
      }
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / share];
  }

  static bool is_inner(const Frame_edge& edge)
  {
    return !Frame::is_infinite(edge) && !Frame::is_infinite(edge.left) &&
           !Frame::is_infinite(edge.right);
  }

  // The smallest tolerance of the edges of which v is an end, or to which it is opposite.
  double tolerance_of(Vertex_index v) const
  {
    const Frame frame = m_motion.triangulation().frame();
    double smallest = (std::numeric_limits<double>::max)();
    frame.for_each_incident_edge(v, [&](Edge_index e) {
      smallest = (std::min)(smallest, m_tolerances[e]);
      frame.for_each_side(e, [&](Edge_index side) {
        const Frame_edge& edge = frame.edge(side);
        for (const Vertex_index w : {edge.source, edge.target, edge.left, edge.right}) {
          smallest = w == v ? (std::min)(smallest, m_tolerances[side]) : smallest;
        }
      });
    });
    return smallest;
  }

  // An inner edge with an annulus neither too thin nor too thick to be seen: the middle one of all.
  Edge_index choose_edge() const
  {
    const Frame frame = m_motion.triangulation().frame();
    std::vector<Edge_index> edges;
    for (Edge_index e(0); e != frame.number_of_edges(); ++e) {
      const Frame_edge& edge = frame.edge(e);
      if (is_inner(edge) && m_tolerances[e] > 0.1 && m_tolerances[e] < 0.14) {
        edges.push_back(e);
      }
    }
    return edges.at(edges.size() / 2);
  }

  template <class Is_tight>
  void draw_edges(Panel& panel, const Is_tight& is_tight) const
  {
    const Frame frame = m_motion.triangulation().frame();
    for (Edge_index e(0); e != frame.number_of_edges(); ++e) {
      const Frame_edge& edge = frame.edge(e);
      if (!Frame::is_infinite(edge)) {
        panel.line(place(edge.source), place(edge.target), is_tight(e) ? "#d50000" : "#aaaaaa",
                   is_tight(e) ? 8.0 : 3.0);
      }
    }
  }

  Motion m_motion;
  std::vector<double> m_tolerances; // of each edge
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_SAFETY_FIGURES_H
