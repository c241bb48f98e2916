// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_PANEL_H
#define MANUAL_FIGURES_PANEL_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Pictures.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace manual_figures {

using scenario::Point;

// A part of the plane with lines and dots in it, and a line of text below. Lines and dots are
// thick: a figure is as wide as a phone, where it is scaled down to a third.
class Panel
{
public:
  Panel(const run::Bounds& part, std::string caption)
    : m_part(part)
    , m_view(part)
    , m_caption(std::move(caption))
  {
    m_svg << std::fixed << std::setprecision(1);
  }

  // Lines out of sight are left out.
  void line(const Point& p, const Point& q, const std::string& color, double width,
            const std::string& dashes = "")
  {
    if (!is_near(p) && !is_near(q)) {
      return;
    }
    m_svg << "<path d=\"M" << m_view.x(p) << ' ' << m_view.y(p) << 'L' << m_view.x(q) << ' '
          << m_view.y(q) << "\" stroke=\"" << color << "\" stroke-width=\"" << width << '"';
    if (!dashes.empty()) {
      m_svg << " stroke-dasharray=\"" << dashes << '"';
    }
    m_svg << "/>\n";
  }

  // Many lines, wherever they are, in few bytes.
  void lines(const std::vector<std::pair<Point, Point>>& ends, const std::string& color,
             double width)
  {
    m_svg << "<path stroke=\"" << color << "\" stroke-width=\"" << width << "\" d=\"";
    for (const auto& [p, q] : ends) {
      m_svg << 'M' << m_view.x(p) << ' ' << m_view.y(p) << 'L' << m_view.x(q) << ' ' << m_view.y(q);
    }
    m_svg << "\"/>\n";
  }

  // Fills the area between polygons, one of which is in another.
  void area(const std::vector<std::vector<Point>>& rings, const std::string& color)
  {
    m_svg << "<path fill-rule=\"evenodd\" fill=\"" << color << "\" d=\"";
    for (const std::vector<Point>& ring : rings) {
      char command = 'M';
      for (const Point& p : ring) {
        m_svg << command << m_view.x(p) << ' ' << m_view.y(p);
        command = 'L';
      }
      m_svg << 'Z';
    }
    m_svg << "\"/>\n";
  }

  // Of a radius on paper.
  void dot(const Point& p, const std::string& color, double radius)
  {
    if (is_near(p)) {
      circle_on_paper(p, radius, "fill=\"" + color + '"');
    }
  }

  // Of a radius in the plane.
  void disk(const Point& p, double radius, const std::string& color)
  {
    if (is_near(p)) {
      circle_on_paper(p, on_paper(radius), "fill=\"" + color + '"');
    }
  }

  void circle(const Point& center, double radius, const std::string& color, double width,
              const std::string& dashes = "")
  {
    std::ostringstream style;
    style << "fill=\"none\" stroke=\"" << color << "\" stroke-width=\"" << width
          << "\" stroke-dasharray=\"" << (dashes.empty() ? "none" : dashes) << '"';
    circle_on_paper(center, on_paper(radius), style.str());
  }

  // Writes a letter beside p, away from another point.
  void letter(const Point& p, const Point& other, const std::string& text)
  {
    constexpr double room = 62.0;
    const double dx = m_view.x(p) - m_view.x(other), dy = m_view.y(p) - m_view.y(other);
    const double length = std::hypot(dx, dy);
    m_svg << "<text x=\"" << m_view.x(p) + room * dx / length << "\" y=\""
          << m_view.y(p) + room * dy / length + 14.0
          << "\" text-anchor=\"middle\" font-size=\"48\" font-style=\"italic\">" << text
          << "</text>\n";
  }

  double height() const { return m_view.height() + (m_caption.empty() ? 0.0 : caption_height); }
  double width() const { return m_view.width(); }

  // The panel as a part of an SVG picture, `down` below its upper side.
  std::string text(double down) const
  {
    std::ostringstream out;
    out << std::fixed << std::setprecision(1);
    out << "<svg x=\"0\" y=\"" << down << "\" width=\"" << width() << "\" height=\""
        << m_view.height() << "\">\n"
        << m_svg.str() << "</svg>\n";
    if (!m_caption.empty()) {
      out << "<text x=\"" << 0.5 * width() << "\" y=\"" << down + m_view.height() + 36.0
          << "\" text-anchor=\"middle\">" << m_caption << "</text>\n";
    }
    return out.str();
  }

private:
  static constexpr double caption_height = 70.0;

  double on_paper(double length) const
  {
    return m_view.x({m_part.low.x + length, 0.0}) - m_view.x(m_part.low);
  }

  bool is_near(const Point& p) const
  {
    const double margin = 0.05 * (m_part.width() + m_part.height());
    return p.x > m_part.low.x - margin && p.x < m_part.high.x + margin &&
           p.y > m_part.low.y - margin && p.y < m_part.high.y + margin;
  }

  void circle_on_paper(const Point& p, double radius, const std::string& style)
  {
    m_svg << "<circle cx=\"" << m_view.x(p) << "\" cy=\"" << m_view.y(p) << "\" r=\"" << radius
          << "\" " << style << "/>\n";
  }

  run::Bounds m_part;
  run::Picture_view m_view;
  std::string m_caption;
  std::ostringstream m_svg;
};

// The panels, one below the other.
inline std::string svg_of(std::initializer_list<const Panel*> panels, double scale = 0.48)
{
  std::string inside;
  double height = 0.0;
  double width = 0.0;
  for (const Panel* panel : panels) {
    inside += panel->text(height);
    height += panel->height();
    width = (std::max)(width, panel->width());
  }
  std::ostringstream out;
  out << std::fixed << std::setprecision(0);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << scale * width << "\" height=\""
      << scale * height << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\" font-family=\"sans-serif\" font-size=\"36\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      << inside << "</svg>\n";
  return out.str();
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_PANEL_H
