// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_SVG_PICTURE_H
#define RUN_SVG_PICTURE_H

#include "../scenario/Motion.h"
#include "Picture_view.h"

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

  // `shows_sets`: whether the vertices still have the numbers that they were classified under.
  void write(std::ostream& out, bool shows_sets) const
  {
    out << std::fixed << std::setprecision(2);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << m_view.width() << "\" height=\""
        << m_view.height() << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    write_edges(out);
    write_points(out, shows_sets ? roles() : std::vector<Role>(number_of_roles(), other));
    out << "</svg>\n";
  }

private:
  enum Role : std::size_t { other, border, padded, classified };
  static constexpr std::array<const char*, 4> colors = {"#333333", "cyan", "green", "red"};

  std::size_t number_of_roles() const { return m_triangulation.number_of_vertices() + 1; }

  // Of each vertex of the frame.
  std::vector<Role> roles() const
  {
    std::vector<Role> roles(number_of_roles(), other);
    for (const auto v : m_triangulation.border_vertices()) {
      roles[v] = border;
    }
    for (const auto v : m_triangulation.padded_vertices()) {
      roles[v] = padded;
    }
    for (const auto v : m_triangulation.classified_vertices()) {
      roles[v] = classified;
    }
    return roles;
  }

  void write_edges(std::ostream& out) const
  {
    out << "<path stroke=\"#888888\" stroke-width=\"" << std::min(0.8, 0.5 * radius())
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
  void write_points(std::ostream& out, const std::vector<Role>& roles) const
  {
    const auto frame = m_triangulation.frame();
    using Index = typename Dynamic::Frame::Index;
    for (std::size_t role = other; role != colors.size(); ++role) {
      out << "<g fill=\"" << colors[role] << "\">\n";
      for (Index id = 0; id != frame.number_of_ids(); ++id) {
        if (frame.has_id(id) && roles[frame.vertex(id)] == role) {
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
