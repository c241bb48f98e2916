// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_PICTURE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_PICTURE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Draws a periodic triangulation into a scene, which has the functions of CGAL's viewers: each face
// once, by its image whose first corner is in the cell, each vertex in the cell, and the cell.
template <class Dynamic, class Scene>
class Periodic_picture_2
{
  using Point = typename Dynamic::Point;

public:
  Periodic_picture_2(const Dynamic& pt, Scene& scene)
    : m_pt(pt)
    , m_scene(scene)
    , m_torus(pt.cell())
  {
    check_certified(pt);
  }

  void draw(bool are_faces_filled) const
  {
    const Default_floating_point floating_point;
    for (std::size_t id = 0; id < m_pt.number_of_ids(); ++id)
      if (m_pt.has_id(id) && m_pt.representative(id) == id)
        m_scene.add_point(in_cell(id));
    m_pt.for_each_face(
        [&](const std::array<std::size_t, 3>& ids, const std::array<Periodic_shift_2, 3>& shifts) {
          const Point p = in_cell(ids[0]);
          draw_face({p, p + m_pt.vector(ids[0], ids[1], shifts[1]),
                     p + m_pt.vector(ids[0], ids[2], shifts[2])},
                    are_faces_filled);
        });
    if (m_pt.number_of_faces() == 0) // all points of a slab are on a line
      m_pt.for_each_edge([&](std::size_t i, std::size_t j, const Periodic_shift_2& shift) {
        const Point p = in_cell(i);
        m_scene.add_segment(p, p + m_pt.vector(i, j, shift));
      });
    draw_cell();
  }

private:
  Point in_cell(std::size_t id) const
  {
    const Point p = m_pt.point(id);
    return point(m_torus.wrapped({p.x(), p.y()}));
  }
  static Point point(const Position_2& p) { return Point(p.x, p.y); }

  void draw_face(const std::array<Point, 3>& corners, bool is_filled) const
  {
    for (std::size_t i = 0; i < 3; ++i)
      m_scene.add_segment(corners[i], corners[(i + 1) % 3]);
    if (!is_filled)
      return;
    m_scene.face_begin(CGAL::IO::Color(190, 220, 240));
    for (const Point& corner : corners)
      m_scene.add_point_in_face(corner);
    m_scene.face_end();
  }

  // Draws the cell. That of a slab ends at the outermost points.
  void draw_cell() const
  {
    double low = 0, high = 1;
    if (m_torus.cell().is_slab()) {
      low = std::numeric_limits<double>::infinity();
      high = -low;
      for (std::size_t id = 0; id < m_pt.number_of_ids(); ++id)
        if (m_pt.has_id(id)) {
          const Point p = m_pt.point(id);
          const double height = m_torus.multiples({p.x(), p.y()}).y;
          low = (std::min)(low, height);
          high = (std::max)(high, height);
        }
    }
    if (low > high)
      return;
    const std::array<Point, 4> corners{
        point(m_torus.vector({0, low})), point(m_torus.vector({1, low})),
        point(m_torus.vector({1, high})), point(m_torus.vector({0, high}))};
    for (std::size_t i = 0; i < 4; ++i)
      m_scene.add_segment(corners[i], corners[(i + 1) % 4], CGAL::IO::Color(200, 40, 40));
  }

  const Dynamic& m_pt;
  Scene& m_scene;
  const Torus_2 m_torus;
};

template <class Dynamic, class Scene>
void draw_periodic(const Dynamic& pt, Scene& scene, bool are_faces_filled)
{
  Periodic_picture_2<Dynamic, Scene>(pt, scene).draw(are_faces_filled);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_PICTURE_2_H
