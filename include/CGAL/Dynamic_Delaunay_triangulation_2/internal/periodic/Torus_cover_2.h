// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_COVER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_COVER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/number_utils.h>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Tests in exact arithmetic whether faces cover a torus once; the manual's page on periodic space
// has the proof. Shifts that agree along the edges map the faces to the torus. The map's degree is
// the sum of the faces' areas, negative for clockwise faces, divided by the area of the cell.
template <class Space>
class Torus_cover_2
{
  using Arrays = Halfedge_arrays_2;

public:
  explicit Torus_cover_2(const Space& space)
    : m_space(space)
  {
  }

  bool is_single() const { return do_shifts_agree() && do_areas_sum_up(); }

  bool do_areas_sum_up() const
  {
    const Torus_2& torus = m_space.torus();
    Torus_2::Polynomial<1> area{0, 0}, area_of_cell = torus.exact_double_area();
    for (Halfedge_index h(0); h < arrays().number_of_halfedges(); h += 3) {
      const auto face =
          torus.exact_double_area(m_space.image(h), m_space.image(h + 1), m_space.image(h + 2));
      area = {area[0] + face[0], area[1] + face[1]};
    }
    if (CGAL::is_negative(area_of_cell[0]))
      area_of_cell[0] = -area_of_cell[0];
    return m_space.number_of_vertices() == 0 || area == area_of_cell;
  }

private:
  const Arrays& arrays() const { return m_space.arrays(); }

  bool do_shifts_agree() const
  {
    for (Halfedge_index h(0); h < arrays().number_of_halfedges(); ++h)
      if (!are_equal(m_space.transition(h), no_shift - m_space.transition(arrays().twin(h))))
        return false;
    return true;
  }

  const Space& m_space;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_COVER_2_H
