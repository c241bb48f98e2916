// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_NAMES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_NAMES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Site_names_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What visitors call the sites of a torus: an image of a representative, by the shift from where
// that point was given, in vectors of the cell. Former names are those of the present points and
// the present cell.
template <class State>
class Torus_names_3
{
public:
  struct Name
  {
    std::size_t id;
    Periodic_shift_3 shift;

    friend bool operator<(const Name& a, const Name& b)
    {
      return std::tie(a.id, a.shift) < std::tie(b.id, b.shift);
    }
    friend bool operator==(const Name& a, const Name& b)
    {
      return a.id == b.id && a.shift == b.shift;
    }
  };

  static bool is_infinite(const Torus_site_3& s) { return s.is_infinite(); }
  // Of all images of a simplex, whose names are in order, takes that whose first shift is 0.
  template <class Simplex>
  static void normalize(Simplex& simplex)
  {
    const Periodic_shift_3 first = simplex[0].shift;
    for (Name& name : simplex)
      name.shift = difference(name.shift, first);
  }

  void begin(State& state)
  {
    m_former.resize(state.positions.number());
    for (Vertex_index v(1); v < state.positions.number(); ++v)
      m_former[v] = {state.ids.representative(v), state.positions.multiples(v)};
    m_torus = state.torus;
    state.translations.begin();
  }
  static void end(State& state) { state.translations.end(); }
  static void hand_over(State& from, State& to) { to.translations = from.translations; }

  Name former(const State& state, const Torus_site_3& site) const
  {
    const auto& [id, multiples] = m_former[site.vertex];
    return {id, state.translations.now(
                    id, m_torus->in_vectors_of_cell(multiples + site.shift.multiples()))};
  }
  static Name present(const State& state, const Torus_site_3& site)
  {
    return {state.ids.representative(site.vertex),
            state.torus.in_vectors_of_cell(state.positions.multiples(site.vertex) +
                                           site.shift.multiples())};
  }

  // Calls f(i, j, shift of j), or f(ids, shifts) of a facet.
  template <class Function>
  static void apply(const std::array<Name, 2>& edge, const Function& f)
  {
    f(edge[0].id, edge[1].id, edge[1].shift);
  }
  template <class Function>
  static void apply(const std::array<Name, 3>& facet, const Function& f)
  {
    f(std::array<std::size_t, 3>{facet[0].id, facet[1].id, facet[2].id},
      std::array<Periodic_shift_3, 3>{facet[0].shift, facet[1].shift, facet[2].shift});
  }
  // Tells a visitor how names have changed.
  template <class Visitor, class Dynamic>
  static void tell(const State& state, Visitor& visitor, const Dynamic& dynamic)
  {
    if (state.translations.has_exchanged_cell())
      visitor.after_cell_exchange(dynamic, state.translations.rows());
    for (const auto& [id, translation] : state.translations.of_points())
      visitor.after_translation(dynamic, std::size_t(id), difference({0, 0, 0}, translation));
  }

  template <class Simplices>
  static void append_flat(const State&, Simplices&)
  {
  }

private:
  struct Former
  {
    Point_id id;
    Multiples_3 multiples;
  };

  Column<Vertex_index, Former> m_former;
  std::optional<Torus_3> m_torus;
};

template <class Traits, class ConcurrencyTag>
class Site_names_3<Torus_state_3<Traits, ConcurrencyTag>>
  : public Torus_names_3<Torus_state_3<Traits, ConcurrencyTag>>
{
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_NAMES_3_H
