// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_SVG_PICTURE_H
#define RUN_SVG_PICTURE_H

#include "../scenario/Motion.h"
#include "Frame_record.h"
#include "Picture_legend.h"
#include "Picture_view.h"
#include "Rounded_number.h"
#include "Vertex_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <vector>

namespace run {

// A frame, with its number and time above and a legend below. It has no size of its own, and fills
// what it is shown in.
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
  void write(std::ostream& out, const Frame_record& record,
             const std::vector<Vertex_set>& sets) const
  {
    out << std::fixed << std::setprecision(2);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width() << ' ' << height()
        << "\" font-family=\"sans-serif\" font-size=\"" << font_size << "\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    write_caption(out, record);
    out << "<g transform=\"translate(" << 0.5 * (width() - m_view.width()) << ' ' << line_height
        << ")\">\n";
    write_edges(out);
    write_points(out, sets);
    out << "</g>\n";
    write_legend(out);
    out << "</svg>\n";
  }

private:
  // Letters that can still be read on a phone, where the picture is 390 wide.
  static constexpr double font_size = 28.0;
  static constexpr double line_height = 44.0;
  static constexpr double least_width = 1000.0; // that of the legend

  double width() const { return (std::max)(m_view.width(), least_width); }
  double height() const { return m_view.height() + 2.0 * line_height; }

  void write_caption(std::ostream& out, const Frame_record& record) const
  {
    out << "<text x=\"20\" y=\"" << font_size + 4.0 << "\">frame " << record.frame << ", time "
        << Rounded_number{record.time} << (record.update.rebuilt() ? ", triangulated anew" : "")
        << "</text>\n";
  }

  // The sets, from left to right, and edges.
  void write_legend(std::ostream& out) const
  {
    const double y = height() - 0.5 * line_height;
    double x = 30.0;
    for (auto entry = set_legends.rbegin(); entry != set_legends.rend(); ++entry) {
      out << "<g><title>" << entry->meaning << "</title><circle cx=\"" << x << "\" cy=\"" << y
          << "\" r=\"8\" fill=\"" << entry->color << "\"/>";
      write_label(out, x + 18.0, y, entry->name);
      x += 210.0;
    }
    out << "<g><title>edges of the triangulation</title><path d=\"M" << x - 10.0 << ' ' << y
        << "h30"
        << "\" stroke=\"" << edge_color << "\" stroke-width=\"3\"/>";
    write_label(out, x + 30.0, y, "edge");
  }

  static void write_label(std::ostream& out, double x, double y, const char* text)
  {
    out << "<text x=\"" << x << "\" y=\"" << y + 0.35 * font_size << "\">" << text
        << "</text></g>\n";
  }

  void write_edges(std::ostream& out) const
  {
    out << "<path stroke=\"" << edge_color << "\" stroke-width=\""
        << (std::min)(0.8, 0.5 * radius()) << "\" fill=\"none\" d=\"";
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

  void write_points(std::ostream& out, const std::vector<Vertex_set>& sets) const
  {
    const auto frame = m_triangulation.frame();
    using Index = typename Dynamic::Frame::Index;
    for (const Set_legend& legend : set_legends) {
      out << "<g fill=\"" << legend.color << "\">\n";
      for (Index id = 0; id != frame.number_of_ids(); ++id) {
        if (frame.has_id(id) && sets[frame.vertex(id)] == legend.set) {
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
