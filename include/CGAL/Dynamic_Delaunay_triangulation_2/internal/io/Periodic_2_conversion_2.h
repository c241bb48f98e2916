// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_2_CONVERSION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_2_CONVERSION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Wrapped_coordinate.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Converts a periodic triangulation to the form of CGAL's class: points in a square, and faces
// between their images by one side or none in each direction. Checks everything before it writes.
template <class Dynamic>
class Periodic_2_conversion_2
{
public:
  Periodic_2_conversion_2(const Dynamic& pt, const Position_2& corner)
    : m_pt(pt)
    , m_low(corner)
  {
    const Default_floating_point floating_point;
    check_certified(pt);
    find_domain();
    wrap_points();
    copy_faces();
  }

  template <class Target>
  typename Target::Iso_rectangle domain() const
  {
    return typename Target::Iso_rectangle(m_low.x, m_low.y, m_high.x, m_high.y);
  }

  // Fills an empty triangulation of the domain, and returns its vertices by ids.
  template <class Target>
  std::vector<typename Target::Vertex_handle> write(Target& target) const
  {
    std::vector<typename Target::Vertex_handle> vertices(m_pt.number_of_ids());
    if (m_faces.empty())
      return vertices;
    auto& tds = target.tds();
    tds.set_dimension(2);
    for (std::size_t id = 0; id < vertices.size(); ++id)
      if (m_pt.has_id(id) && m_pt.representative(id) == id) {
        vertices[id] = tds.create_vertex();
        vertices[id]->set_point(typename Target::Point(m_points[id].x, m_points[id].y));
      }
    write_faces(tds, vertices);
    for (std::size_t id = 0; id < vertices.size(); ++id)
      if (m_pt.has_id(id))
        vertices[id] = vertices[m_pt.representative(id)];
    return vertices;
  }

private:
  // CGAL's limit: then each circle around a face stays empty in one sheet, whatever is inserted.
  static constexpr double max_squared_edge = 0.166; // in squares of the domain's side

  struct Face
  {
    std::array<std::size_t, 3> ids;
    std::array<Periodic_shift_2, 3> offsets; // 0 or 1 each
  };
  // Source, target, face, and the corner that is opposite.
  using Edge = std::tuple<std::size_t, std::size_t, std::size_t, int>;

  // CELL AND POINTS -------------------------------------------------------------------------------

  void find_domain()
  {
    const Periodic_cell_2& cell = m_pt.cell();
    const bool is_along = cell.ay() == 0 && cell.bx() == 0;
    const bool is_exchanged = cell.ax() == 0 && cell.by() == 0;
    const Position_2 sides{cell.ax() + cell.bx(), cell.ay() + cell.by()};
    if (cell.is_slab() || !(is_along || is_exchanged) || std::abs(sides.x) != std::abs(sides.y))
      throw Periodic_cell_error_2(cell.ax(), cell.ay(), cell.bx(), cell.by(),
                                  "only a square with sides along the axes can be converted");
    m_is_exchanged = is_exchanged;
    m_signs = {sides.x > 0 ? 1 : -1, sides.y > 0 ? 1 : -1};
    m_side = std::abs(sides.x);
    m_high = {m_low.x + m_side, m_low.y + m_side};
    if (!is_exact_sum(m_low.x, m_side, m_high.x) || !is_exact_sum(m_low.y, m_side, m_high.y))
      refuse("the upper right corner of the domain from ", m_low, " has no coordinates of doubles");
  }

  // Wraps the points of representatives: other points have no vertices.
  void wrap_points()
  {
    m_points.resize(m_pt.number_of_ids());
    m_multiples.resize(m_pt.number_of_ids());
    for (std::size_t id = 0; id < m_points.size(); ++id)
      if (m_pt.has_id(id) && m_pt.representative(id) == id) {
        const auto p = m_pt.point(id);
        const auto [x, i] = wrapped(p.x(), m_low.x, m_high.x, m_side);
        const auto [y, j] = wrapped(p.y(), m_low.y, m_high.y, m_side);
        if (std::isnan(x) || std::isnan(y))
          refuse("point " + std::to_string(id) + " at ", {p.x(), p.y()},
                 " cannot be wrapped into the domain without rounding");
        m_points[id] = {x, y};
        m_multiples[id] = {i, j};
      }
  }

  [[noreturn]] static void refuse(const std::string& what, const Position_2& p,
                                  const std::string& why)
  {
    throw Periodic_conversion_error_2(message_text(what, "(", p.x, ", ", p.y, ")", why));
  }

  // FACES -----------------------------------------------------------------------------------------

  // Checks that all edges are short: then the offsets of a face differ by at most one side, and no
  // two edges have the same ends.
  void copy_faces()
  {
    m_pt.for_each_face([this](const std::array<std::size_t, 3>& ids,
                              const std::array<Periodic_shift_2, 3>& shifts) {
      Face face{ids, {}};
      for (std::size_t i = 0; i < 3; ++i)
        face.offsets[i] = m_multiples[ids[i]] + along_axes(shifts[i]);
      const Periodic_shift_2 least{least_of(face, 0), least_of(face, 1)};
      for (Periodic_shift_2& offset : face.offsets)
        offset = offset - least;
      check_edges(face);
      m_faces.push_back(face);
    });
  }

  Periodic_shift_2 along_axes(const Periodic_shift_2& shift) const
  {
    return {m_signs[0] * shift[m_is_exchanged ? 1 : 0], m_signs[1] * shift[m_is_exchanged ? 0 : 1]};
  }

  static int least_of(const Face& face, std::size_t axis)
  {
    return (std::min)({face.offsets[0][axis], face.offsets[1][axis], face.offsets[2][axis]});
  }

  void check_edges(const Face& face) const
  {
    const double longest = max_squared_edge * CGAL::square(m_side);
    for (std::size_t i = 0; i < 3; ++i) {
      const Position_2 p = corner(face, i), q = corner(face, (i + 1) % 3);
      const double squared = CGAL::square(q.x - p.x) + CGAL::square(q.y - p.y);
      if (squared < (1 - 0x1p-40) * longest)
        continue;
      throw Periodic_conversion_error_2(message_text(
          "one sheet is not enough for CGAL's periodic triangulation: the edge from point ",
          face.ids[i], " to an image of point ", face.ids[(i + 1) % 3], " has the length ",
          std::sqrt(squared), ", and must be shorter than ", std::sqrt(longest)));
    }
  }

  Position_2 corner(const Face& face, std::size_t i) const
  {
    const Position_2& p = m_points[face.ids[i]];
    return {p.x + face.offsets[i][0] * m_side, p.y + face.offsets[i][1] * m_side};
  }

  // WRITING ---------------------------------------------------------------------------------------

  template <class Data_structure, class Vertices>
  void write_faces(Data_structure& tds, const Vertices& vertices) const
  {
    std::vector<typename Data_structure::Face_handle> faces;
    std::vector<Edge> edges;
    for (const Face& face : m_faces) {
      const auto& v = face.ids;
      const auto written = tds.create_face(vertices[v[0]], vertices[v[1]], vertices[v[2]]);
      written->set_offsets(bits(face.offsets[0]), bits(face.offsets[1]), bits(face.offsets[2]));
      for (int i = 0; i < 3; ++i) {
        vertices[v[std::size_t(i)]]->set_face(written);
        edges.emplace_back(v[std::size_t(i + 1) % 3], v[std::size_t(i + 2) % 3], faces.size(), i);
      }
      faces.push_back(written);
    }
    std::sort(edges.begin(), edges.end());
    for (const auto& [source, target, face, opposite] : edges) {
      const Edge& twin = *std::lower_bound(edges.begin(), edges.end(), Edge(target, source, 0, 0));
      faces[face]->set_neighbor(opposite, faces[std::get<2>(twin)]);
    }
  }

  static unsigned int bits(const Periodic_shift_2& offset)
  {
    return unsigned(2 * offset[0] + offset[1]);
  }

  const Dynamic& m_pt;
  Position_2 m_low, m_high{0, 0}; // of the domain
  double m_side = 0;
  bool m_is_exchanged = false;               // whether the cell's first vector is vertical
  std::array<int, 2> m_signs{1, 1};          // of the sides in the cell
  std::vector<Position_2> m_points;          // in the domain, by ids
  std::vector<Periodic_shift_2> m_multiples; // of the sides, from m_points to the given points
  std::vector<Face> m_faces;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_2_CONVERSION_2_H
