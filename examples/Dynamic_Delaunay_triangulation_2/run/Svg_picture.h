// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_SVG_PICTURE_H
#define RUN_SVG_PICTURE_H

#include "../scenario/Motion.h"
#include "Picture_view.h"
#include "Vertex_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <vector>

namespace run {

// A frame in the colours of figure 4.1 of the thesis.
template <class Dynamic>
class Svg_picture
{
public:
  Svg_picture(const Dynamic& triangulation, const Picture_view& view)
    : m_triangulation(triangulation)
    , m_view(view)
  {
  }

  // `sets`: of each vertex.
  void write(std::ostream& out, const std::vector<Vertex_set>& sets) const
  {
    out << std::fixed << std::setprecision(2);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << m_view.width() << "\" height=\""
        << m_view.height() << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    write_edges(out);
    write_points(out, sets);
    out << "</svg>\n";
  }

private:
  // Of each set.
  static constexpr std::array<const char*, 4> colors = {"#333333", "cyan", "green", "red"};

  void write_edges(std::ostream& out) const
  {
    out << "<path stroke=\"#888888\" stroke-width=\"" << (std::min)(0.8, 0.5 * radius())
        << "\" fill=\"none\" d=\"";
    m_triangulation.for_each_edge([&](std::size_t i, std::size_t j) {
      write_place(out << 'M', place(i));
      write_place(out << 'L', place(j));
    });
    out << "\"/>\n";
  }

  void write_place(std::ostream& out, const scenario::Point& point) const
  {
    out << m_view.x(point) << ' ' << m_view.y(point) << '\n';
  }

  scenario::Point place(std::size_t id) const
  {
    const auto& point = m_triangulation.point(id);
    return {point.x(), point.y()};
  }

  // The colourful ones last, over the others.
  void write_points(std::ostream& out, const std::vector<Vertex_set>& sets) const
  {
    const auto frame = m_triangulation.frame();
    using Index = typename Dynamic::Frame::Index;
    for (std::size_t set = 0; set != colors.size(); ++set) {
      out << "<g fill=\"" << colors[set] << "\">\n";
      for (Index id = 0; id != frame.number_of_ids(); ++id) {
        if (frame.has_id(id) && sets[frame.vertex(id)] == static_cast<Vertex_set>(set)) {
          out << "<circle cx=\"" << m_view.x(place(id)) << "\" cy=\"" << m_view.y(place(id))
              << "\" r=\"" << radius() << "\"/>\n";
        }
      }
      out << "</g>\n";
    }
  }

  // As large as room between the points allows.
  double radius() const
  {
    const double room = std::sqrt(m_view.width() * m_view.height() /
                                  static_cast<double>(m_triangulation.number_of_points() + 1));
    return std::clamp(0.1 * room, 0.5, 4.0);
  }

  const Dynamic& m_triangulation;
  const Picture_view& m_view;
};

} // namespace run

#endif // RUN_SVG_PICTURE_H
