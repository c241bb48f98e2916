// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_SIMPLEX_CHANGES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_SIMPLEX_CHANGES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Site_names_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_arrays_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Finite edges and facets, by what `Names` calls their sites, in the order of these.
template <class Names>
struct Simplices_3
{
  using Name = typename Names::Name;
  using Edge = std::array<Name, 2>;
  using Facet = std::array<Name, 3>;

  void clear()
  {
    edges.clear();
    facets.clear();
  }

  // `name(site)` is the name of a site.
  template <class Site, class Name_of>
  void append_cell(const Few<Site, 4>& s, const Name_of& name)
  {
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j)
        append(edges, Few<Site, 2>{s[i], s[j]}, name);
      append(facets, Few<Site, 3>{s[(i + 1) % 4], s[(i + 2) % 4], s[(i + 3) % 4]}, name);
    }
  }
  template <class Site, class Name_of>
  void append_edge(const Few<Site, 2>& edge, const Name_of& name)
  {
    append(edges, edge, name);
  }
  template <class Site, class Name_of>
  void append_facet(const Few<Site, 3>& facet, const Name_of& name)
  {
    append(facets, facet, name);
  }

  void make_distinct()
  {
    make_distinct(edges);
    make_distinct(facets);
  }

  // Those of `a` that are not among those of `b`; both are distinct.
  void assign_difference(const Simplices_3& a, const Simplices_3& b)
  {
    clear();
    std::set_difference(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(),
                        std::back_inserter(edges));
    std::set_difference(a.facets.begin(), a.facets.end(), b.facets.begin(), b.facets.end(),
                        std::back_inserter(facets));
  }

  std::vector<Edge> edges;
  std::vector<Facet> facets;

private:
  template <class Simplex, class Sites, class Name_of>
  static void append(std::vector<Simplex>& list, const Sites& sites, const Name_of& name)
  {
    for (const auto& s : sites)
      if (Names::is_infinite(s))
        return;
    Simplex simplex;
    std::transform(sites.begin(), sites.end(), simplex.begin(), name);
    std::sort(simplex.begin(), simplex.end());
    Names::normalize(simplex);
    list.push_back(simplex);
  }
  template <class Simplex>
  static void make_distinct(std::vector<Simplex>& list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
};

// Which finite edges and facets an update removes and creates: the difference of those of the cells
// that have changed, before and after it. (A simplex of cells that have changed and of others is on
// the boundary of both, so it is in neither.) What a call that has failed has changed belongs to
// the next one.
template <class State>
class Simplex_changes_3
{
  using Site = typename State::Arrays::Site;
  using Sites = typename State::Arrays::Sites;

public:
  using Names = Site_names_3<State>;
  using Simplices = Simplices_3<Names>;

  // To be called before a change.
  void begin(State& state);

  // To be called after it. If it throws, it can be called again.
  void end(State& state);
  // To be called when all that there is to tell was told.
  void close(State& state) { m_names.end(state); }

  // Compares a state that goes, whose `changes` may be those of a call that has failed, with
  // another one.
  void compare(State& before, const Simplex_changes_3& changes, State& now);

  const Simplices& removed() const { return m_removed; }
  const Simplices& created() const { return m_created; }

private:
  void append_former(const State& state, const Sites& sites)
  {
    m_before.append_cell(sites, [&](const Site& s) { return m_names.former(state, s); });
  }

  static void append_cell(const State& state, Cell_index c, Simplices& simplices)
  {
    simplices.append_cell(state.arrays.sites(c),
                          [&](const Site& s) { return Names::present(state, s); });
  }

  void append_changed(State& state)
  {
    state.arrays.history().for_each_changed([&](Cell_index c) {
      if (c < state.arrays.number_of_cells())
        append_cell(state, c, m_now);
    });
  }

  static void append_all(const State& state, Simplices& simplices)
  {
    Names::append_flat(state, simplices);
    for (Cell_index c(0); state.spans_space && c < state.arrays.number_of_cells(); ++c)
      append_cell(state, c, simplices);
  }

  void compare()
  {
    m_before.make_distinct();
    m_now.make_distinct();
    m_removed.assign_difference(m_before, m_now);
    m_created.assign_difference(m_now, m_before);
  }

  bool m_is_open = false;
  Names m_names; // when it began
  Simplices m_before, m_now, m_removed, m_created;
};

// Not inline: see `Update_3`.
template <class State>
void Simplex_changes_3<State>::begin(State& state)
{
  if (m_is_open)
    return;
  m_names.begin(state);
  m_before.clear();
  Names::append_flat(state, m_before);
  state.arrays.history().begin();
  m_is_open = true;
}

template <class State>
void Simplex_changes_3<State>::end(State& state)
{
  state.arrays.history().finish();
  state.arrays.history().for_each_former([&](const Sites& sites) { append_former(state, sites); });
  m_now.clear();
  if (state.arrays.history().are_given_up())
    append_all(state, m_now);
  else
    append_changed(state);
  compare();
  state.arrays.history().end();
  m_is_open = false;
}

template <class State>
void Simplex_changes_3<State>::compare(State& before, const Simplex_changes_3& changes, State& now)
{
  m_before.clear();
  if (changes.m_is_open) {
    m_before = changes.m_before; // flat ones
    m_names = changes.m_names;
    Names::hand_over(before, now);
    before.arrays.history().finish();
    before.arrays.for_each_former_of_all([&](const Sites& sites) { append_former(before, sites); });
  } else {
    append_all(before, m_before);
  }
  m_now.clear();
  append_all(now, m_now);
  compare();
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_SIMPLEX_CHANGES_3_H
