// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_MOTION_FIGURE_H
#define MANUAL_FIGURES_MOTION_FIGURE_H

#include "Followed_motion.h"
#include "scenario_runner/Pictures.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace manual_figures {

// The dam break as a picture that moves: some of its frames one after the other, again and again,
// by CSS alone. Who wants no motion on the screen sees the first one.
class Motion_figure
{
public:
  static std::string draw(std::size_t points, std::size_t pictures, std::size_t every)
  {
    scenario::Overrides overrides;
    overrides.points = points;
    Followed_motion<CGAL::Circumcircle_classifier_2> motion("dam_break", overrides, {});
    std::vector<Picture> all;
    std::vector<Point> everywhere;
    for (std::size_t k = 0; k != pictures; ++k) {
      for (std::size_t i = 0; k != 0 && i != every; ++i) {
        motion.advance();
      }
      all.push_back({motion.points(), motion.edges()});
      everywhere.insert(everywhere.end(), motion.points().begin(), motion.points().end());
    }
    return svg_of(all, run::Picture_view(run::bounds_of(everywhere)));
  }

private:
  using Point = scenario::Point;

  struct Picture
  {
    std::vector<Point> points;
    Edges edges;
  };

  static constexpr double pictures_per_second = 12.0;
  static constexpr double scale = 0.75;

  static std::string svg_of(const std::vector<Picture>& pictures, const run::Picture_view& view)
  {
    const double share = 100.0 / static_cast<double>(pictures.size());
    const double seconds = static_cast<double>(pictures.size()) / pictures_per_second;
    std::ostringstream out;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << std::lround(scale * view.width())
        << "\" height=\"" << std::lround(scale * view.height()) << "\" viewBox=\"0 0 "
        << std::lround(view.width()) << ' ' << std::lround(view.height()) << "\">\n<style>\n"
        << "path { fill: none; stroke: #999; stroke-width: 2 }\n"
        << ".n { stroke: #d97a00; stroke-width: 5 }\n"
        << ".p { stroke: #1b5fd5; stroke-width: 11; stroke-linecap: round }\n"
        << "g { visibility: hidden; animation: shown " << seconds << "s step-end infinite }\n"
        << "@keyframes shown { 0% { visibility: visible } " << share
        << "% { visibility: hidden } }\n"
        << "@media (prefers-reduced-motion) { g { animation: none } #g0 { visibility: visible } }\n"
        << "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t k = 0; k != pictures.size(); ++k) {
      const Edges& before = pictures[k == 0 ? 0 : k - 1].edges;
      out << "<g id=\"g" << k
          << "\" style=\"animation-delay: " << static_cast<double>(k) / pictures_per_second
          << "s\">\n"
          << lines(pictures[k], before, true, view) << lines(pictures[k], before, false, view)
          << dots(pictures[k], view) << "</g>\n";
    }
    out << "</svg>\n";
    return out.str();
  }

  // The lines of the old edges, or of the new ones. Whole numbers are fine enough.
  static std::string lines(const Picture& picture, const Edges& before, bool were_there,
                           const run::Picture_view& view)
  {
    std::ostringstream out;
    out << (were_there ? "<path d=\"" : "<path class=\"n\" d=\"");
    for (const auto& [i, j] : picture.edges) {
      if ((before.count({i, j}) != 0) == were_there) {
        const auto [x, y] = on_paper(picture.points[i], view);
        const auto [to_x, to_y] = on_paper(picture.points[j], view);
        out << 'M' << x << ' ' << y << 'l' << to_x - x << ' ' << to_y - y;
      }
    }
    out << "\"/>\n";
    return out.str();
  }

  static std::string dots(const Picture& picture, const run::Picture_view& view)
  {
    std::ostringstream out;
    out << "<path class=\"p\" d=\"";
    for (const Point& p : picture.points) {
      const auto [x, y] = on_paper(p, view);
      out << 'M' << x << ' ' << y << "h0";
    }
    out << "\"/>\n";
    return out.str();
  }

  static std::pair<long, long> on_paper(const Point& p, const run::Picture_view& view)
  {
    return {std::lround(view.x(p)), std::lround(view.y(p))};
  }
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_MOTION_FIGURE_H
