// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WALLS_TORUS_HULL_VIEW_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WALLS_TORUS_HULL_VIEW_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Hull_pass_3.h>

#include <boost/config.hpp>

#include <cmath>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The hull of a slab is seen along the normal, that of a wire from its axis (`Wire_signs_3`). The
// triangulation of a flat wall is that by circles.
template <class Traits, class ConcurrencyTag>
class Hull_view_3<Torus_state_3<Traits, ConcurrencyTag>>
{
  using State = Torus_state_3<Traits, ConcurrencyTag>;

public:
  static constexpr bool has_circles_in_walls = true;

  explicit Hull_view_3(const State& state)
    : m_state(state)
    , m_in_wire(state, Torus_predicates_3(state.torus, state.squared_error))
  {
  }

  BOOST_FORCEINLINE Position_3 position(const Torus_site_3& s) const { return m_state.position(s); }

  void restrict_by_sight(const Torus_facet_3& facet, const Torus_site_3& infinite,
                         Hull_slack_3& slack) const
  {
    if (m_state.torus.is_wire()) {
      restrict_by_axis(facet, slack);
      return;
    }
    const Rounded_normal_3& normal = m_state.torus.normal();
    slack.restrict_by_area(vector(infinite.is_above() ? normal.direction : -1.0 * normal.direction),
                           normal.error);
  }
  // Over a side of a wire's facet, between images of vertices on two lines along it.
  bool restrict_by_lines(const Torus_facet_3& facet, const Torus_site_3& beyond,
                         Hull_slack_3& slack) const
  {
    if (!m_state.torus.is_wire())
      return false;
    for (int i = 0; i < 3; ++i)
      if (facet[i].vertex == facet[(i + 1) % 3].vertex &&
          facet[(i + 2) % 3].vertex == beyond.vertex) {
        slack.restrict_by(m_in_wire.slack_beside(facet, i, beyond));
        return true;
      }
    return false;
  }

private:
  static Hull_slack_3::Vector vector(const Position_3& v) { return {v.x, v.y, v.z}; }

  // For vectors from the axis see `Wire_signs_3`.
  void restrict_by_axis(const Torus_facet_3& facet, Hull_slack_3& slack) const
  {
    for (const Torus_site_3& s : facet) {
      const auto across = m_in_wire.across(s);
      slack.restrict_by_volume(vector(across.way), 1.01 * std::sqrt(across.squared_error));
    }
  }

  const State& m_state;
  Wire_signs_3<State> m_in_wire;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WALLS_TORUS_HULL_VIEW_3_H
