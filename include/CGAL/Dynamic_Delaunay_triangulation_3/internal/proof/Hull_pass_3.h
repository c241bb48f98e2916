// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_HULL_PASS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_HULL_PASS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Hull_slack_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Flat_walls_3.h>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// How a space sees its hull: open space from the origin. Ridges in flat walls are legal there.
template <class State>
class Hull_view_3
{
public:
  static constexpr bool has_circles_in_walls = false;

  explicit Hull_view_3(const State& state)
    : m_state(state)
  {
  }

  const Position_3& position(Vertex_index v) const { return m_state.positions.position(v); }
  // What has to stay as it is for a cell with this facet to be positive.
  void restrict_by_sight(const Few<Vertex_index, 3>& facet, Vertex_index, Hull_slack_3& slack) const
  {
    const Position_3 x = position(facet[0]) - m_state.origin;
    slack.restrict_by_volume({x.x, x.y, x.z}, 0);
  }
  // The same for the facet over a side to be legal, if other things tell than in general.
  static bool restrict_by_lines(const Few<Vertex_index, 3>&, Vertex_index, Hull_slack_3&)
  {
    return false;
  }

private:
  const State& m_state;
};

// Tests infinite cells: one that is positive, and has legal facets to other infinite cells, is
// *right*. Floating point proves most of them, and tells their slacks; of the others, those need no
// test whose vertices are exactly where they were; exact predicates decide the rest. So which cells
// are left out does not depend on the slacks that are kept.
template <class State>
class Hull_pass_3
{
  using Arrays = typename State::Arrays;
  using Site = typename Arrays::Site;
  using Sites = typename Arrays::Sites;
  using Positions = typename State::Positions;
  using Signs = typename Signs_of_3<State>::type;
  using View = Hull_view_3<State>;

public:
  // `walls`: those that are followed. Without slacks, answers are no ways.
  Hull_pass_3(const State& state, const Flat_walls_3<State>& walls, bool has_slacks)
    : m_arrays(state.arrays)
    , m_walls(walls)
    , m_has_slacks(has_slacks)
    , m_can_tell(state.positions_are_exact && state.has_origin)
    , m_error(Pass_view_3<State>::error_of(state))
    , m_has_levels{state.has_levels(0), state.has_levels(1), state.has_levels(2)}
    , m_view(state)
    , m_signs(state)
  {
  }

  // How far an infinite cell is proved by floating point: what its slack is, and whether it counts
  // for later frames, because all walls are followed that it relies on.
  struct Answer
  {
    double slack = 0; // nothing is proved unless it is positive
    bool lasts = true;
    double slack_of_sight = 0; // for the cell to be positive

    double lasting_slack() const { return lasts && slack > 0 ? slack : 0; }
  };
  Answer answer(Cell_index c) const
  {
    if (!m_can_tell)
      return {};
    const Sites s = m_arrays.sites(c);
    const int infinite = infinite_place(c);
    const Few<int, 3> places = places_of_facet(infinite);
    const Few<Site, 3> facet{s[places[0]], s[places[1]], s[places[2]]};
    const Position_3 p = m_view.position(facet[0]), q = m_view.position(facet[1]),
                     r = m_view.position(facet[2]);
    Hull_slack_3 slack(way(p, q), way(p, r), m_error, m_has_slacks);
    m_view.restrict_by_sight(facet, s[infinite], slack);
    const double slack_of_sight = slack.slack();
    const Few<bool, 3> is_level{m_has_levels[0] && p.x == q.x && p.x == r.x,
                                m_has_levels[1] && p.y == q.y && p.y == r.y,
                                m_has_levels[2] && p.z == q.z && p.z == r.z};
    bool lasts = true;
    for (int i = 0; i < 3; ++i) {
      const Site beyond = m_arrays.apex_site(Arrays::corner(c, places[i]));
      if (m_view.restrict_by_lines(facet, beyond, slack))
        continue;
      const Position_3 e = m_view.position(beyond);
      const int axis = is_level[0] && p.x == e.x   ? 0
                       : is_level[1] && p.y == e.y ? 1
                       : is_level[2] && p.z == e.z ? 2
                                                   : 3;
      if (axis == 3) {
        slack.restrict_by_volume(way(e, p), m_error);
        continue;
      }
      lasts = lasts && m_walls.has(axis, coordinate(p, axis));
      if (View::has_circles_in_walls)
        slack.restrict_by_circle(way(p, e), axis);
    }
    return {slack.slack(), lasts, slack_of_sight};
  }

  // Whether an infinite cell that was right at `previous` and at an origin has nothing to be tested
  // because its vertices have not moved. Facets to cells with others are tested from there.
  bool has_rested(const State& state, const Positions& previous, const Position_3& old_origin,
                  Cell_index c) const
  {
    for (const Vertex_index v : m_arrays.vertices(c))
      if (v != infinite_index && !state.positions.has_same(v, previous))
        return false;
    return is_same(state.origin, old_origin) || m_signs.is_positive(m_arrays.sites(c));
  }
  // By exact predicates.
  bool is_right(Cell_index c) const
  {
    const Sites s = m_arrays.sites(c);
    if (!m_signs.is_positive(s))
      return false;
    const int infinite = infinite_place(c);
    for (int i = 0; i < 4; ++i)
      if (i != infinite && m_signs.is_illegal(s, m_arrays.apex_site(Arrays::corner(c, i))))
        return false;
    return true;
  }

private:
  static Hull_slack_3::Vector way(const Position_3& from, const Position_3& to)
  {
    return {to.x - from.x, to.y - from.y, to.z - from.z};
  }

  int infinite_place(Cell_index c) const
  {
    int place = 0;
    while (m_arrays.vertices(c)[place] != infinite_index)
      ++place;
    return place;
  }
  // Those of the hull facet, counterclockwise as seen from outside.
  static Few<int, 3> places_of_facet(int infinite)
  {
    const auto place = [&](int n) { return (infinite + n) % 4; };
    return infinite % 2 == 0 ? Few<int, 3>{place(1), place(3), place(2)}
                             : Few<int, 3>{place(1), place(2), place(3)};
  }

  const Arrays& m_arrays;
  const Flat_walls_3<State>& m_walls;
  bool m_has_slacks, m_can_tell;
  double m_error;
  Few<bool, 3> m_has_levels;
  View m_view;
  Signs m_signs;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_HULL_PASS_3_H
