// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_PERIODIC_CERTIFICATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_PERIODIC_CERTIFICATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What must be true of a periodic triangulation, evaluated from scratch in exact arithmetic: the
// manual's page on periodic space has the proof. Shifts that agree along the edges map the faces to
// the flat torus; the map's degree is the sum of the faces' areas, in areas of the cell.
template <class State>
class Periodic_certificate_2
{
  using Arrays = Halfedge_arrays_2;

public:
  explicit Periodic_certificate_2(const State& state)
    : m_state(state)
  {
  }

  // Whether this is a triangulation at all, also an inverted one: nothing is outside of all faces,
  // shifts agree, the degree is one, and duplicates are where their representatives are.
  bool is_triangulation() const
  {
    return is_full() && do_shifts_agree() && covers_once() && do_duplicates_coincide();
  }

  bool covers_once() const
  {
    const Torus_2& torus = m_state.torus();
    Torus_2::Polynomial<1> area{0, 0}, area_of_cell = torus.exact_double_area();
    for (Index h = 0; h < 3 * arrays().number_of_faces(); h += 3) {
      const auto face =
          torus.exact_double_area(m_state.image(h), m_state.image(h + 1), m_state.image(h + 2));
      area = {area[0] + face[0], area[1] + face[1]};
    }
    if (CGAL::is_negative(area_of_cell[0]))
      area_of_cell[0] = -area_of_cell[0];
    return m_state.number_of_vertices() == 0 || area == area_of_cell;
  }

  // Whether each face is counterclockwise, and each edge locally Delaunay.
  bool is_delaunay() const
  {
    const typename State::Edge_test test(m_state);
    return State::Parts::all_of(arrays().number_of_edges(),
                                [&](std::size_t first, std::size_t beyond) {
                                  for (std::size_t e = first; e < beyond; ++e)
                                    if (test.state(Index(e)) != Edge_state_2::DELAUNAY)
                                      return false;
                                  return true;
                                });
  }

private:
  const Arrays& arrays() const { return m_state.arrays(); }

  bool is_full() const
  {
    const Index n = m_state.number_of_vertices();
    const auto& ids = m_state.ids();
    bool is = arrays().number_of_faces() == 2 * n && arrays().number_of_edges() == 3 * n &&
              ids.number_of_representatives() == n;
    for (Index v = 1; is && v <= n; ++v)
      is = !arrays().is_outside(v) && ids.has_representative(v);
    for (Index f = 0; is && f < 2 * n; ++f)
      is = !arrays().is_empty_face(f);
    return is;
  }

  bool do_shifts_agree() const
  {
    for (Index h = 0; h < 3 * arrays().number_of_faces(); ++h) {
      const Index g = arrays().twin(h);
      if (arrays().twin(g) != h || arrays().source(h) != arrays().target(g) ||
          !are_equal(m_state.transition(h), no_shift - m_state.transition(g)))
        return false;
    }
    return true;
  }

  bool do_duplicates_coincide() const
  {
    const auto& ids = m_state.ids();
    return std::all_of(ids.duplicates().begin(), ids.duplicates().end(), [&](const auto& d) {
      return m_state.torus().coincide(d.point, m_state.positions()[ids.vertex(d.id)]);
    });
  }

  const State& m_state;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_PERIODIC_CERTIFICATE_2_H
