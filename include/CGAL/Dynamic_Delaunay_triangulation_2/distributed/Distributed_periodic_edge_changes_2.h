// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_PERIODIC_EDGE_CHANGES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_PERIODIC_EDGE_CHANGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_edge_changes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_base.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Converts the shifts of edges from one frame of a periodic space to the next: finds the shifts by
// which points were wrapped, and the cell's last vectors in multiples of its present ones.
//
// As in one process, a point is taken to have gone the shortest way, in multiples of the cell's
// vectors; the rest of its step is a shift. A rank compares positions of points that it owned then
// and owns now; those of another point are both sent to one rank. So the shifts depend on given
// positions alone. All ranks hear of the points that were wrapped. Cost: a pass over the own
// points; messages about points that were wrapped or have another owner now.
class Distributed_translations_2
{
public:
  using Id = Distributed_id_2;
  using Entry = Distributed_entry_2;

  // Compares own points, as they were given, with those of the last call. Collective.
  void compute(Distributed_ranks_2& ranks, const Periodic_cell_2& cell, std::vector<Entry> own)
  {
    std::sort(own.begin(), own.end(), [](const Entry& e, const Entry& f) { return e.id < f.id; });
    const Torus_2 last(m_cell), now(cell);
    const bool is_same = cell == m_cell;
    m_multiples = is_same ? unit_multiples : multiples_in_new_cell(last, now);
    const std::vector<Translation> found =
        translations(ranks, own, [&](const Entry& from, const Entry& to) {
          return is_same ? step_in_cell(now, from, to) : step_to_new_cell(last, now, from, to);
        });
    m_translations.clear();
    for (const Translation& t : ranks.gather(found).values)
      m_translations[t.id] = t.shift;
    m_cell = cell;
    m_own = std::move(own);
  }

  // The present shift of an edge from i to j that had this shift before the last `compute()`.
  Periodic_shift_2 renamed(Id i, Id j, const Periodic_shift_2& shift) const
  {
    const Periodic_shift_2 of_i = translation(i), of_j = translation(j);
    Periodic_shift_2 s;
    for (std::size_t k = 0; k < 2; ++k)
      s[k] = shift[0] * m_multiples[0][k] + shift[1] * m_multiples[1][k] + of_i[k] - of_j[k];
    return s;
  }

private:
  struct Translation
  {
    Id id;
    Periodic_shift_2 shift;
  };
  struct Sighting // of a point that the sender owned then, or owns now
  {
    Entry entry;
    std::uint64_t is_now;
  };

  Periodic_shift_2 translation(Id id) const
  {
    const auto found = m_translations.find(id);
    return found != m_translations.end() ? found->second : no_shift;
  }

  static Periodic_shift_2 step_in_cell(const Torus_2& now, const Entry& from, const Entry& to)
  {
    const Position_2 step = now.multiples({to.x - from.x, to.y - from.y});
    const bool is_short = std::abs(step.x) <= 0.5 && std::abs(step.y) <= 0.5;
    return is_short ? no_shift : now.nearest_shift(step);
  }

  Periodic_shift_2 step_to_new_cell(const Torus_2& last, const Torus_2& now, const Entry& from,
                                    const Entry& to) const
  {
    const Position_2 s = last.multiples({from.x, from.y}), t = now.multiples({to.x, to.y});
    return now.nearest_shift({t.x - (s.x * m_multiples[0][0] + s.y * m_multiples[1][0]),
                              t.y - (s.x * m_multiples[0][1] + s.y * m_multiples[1][1])});
  }

  template <class Step>
  std::vector<Translation> translations(Distributed_ranks_2& ranks, const std::vector<Entry>& own,
                                        const Step& step) const
  {
    std::vector<Translation> found;
    const auto compare = [&](const Entry& from, const Entry& to) {
      const Periodic_shift_2 shift = step(from, to);
      if (!are_equal(shift, no_shift))
        found.push_back({to.id, shift});
    };
    const auto sightings = ranks.delivered<Sighting>([&](const auto& post) {
      const auto tell = [&](const Entry& entry, bool is_now) {
        post(std::uint64_t(entry.id) % ranks.size(), {entry, is_now});
      };
      auto then = m_own.begin();
      for (const Entry& entry : own) {
        for (; then != m_own.end() && then->id < entry.id; ++then)
          tell(*then, false);
        if (then != m_own.end() && then->id == entry.id)
          compare(*then++, entry);
        else
          tell(entry, true);
      }
      for (; then != m_own.end(); ++then)
        tell(*then, false);
    });
    std::map<Id, Entry> left, arrived;
    for (const auto& [entry, is_now] : sightings)
      (is_now != 0 ? arrived : left).emplace(entry.id, entry);
    for (const auto& [id, entry] : left) {
      const auto to = arrived.find(id);
      if (to != arrived.end())
        compare(entry, to->second);
    }
    return found;
  }

  Periodic_cell_2 m_cell = Periodic_cell_2(1, 1);
  std::vector<Entry> m_own; // ascending by ids
  std::array<Periodic_shift_2, 2> m_multiples = unit_multiples;
  std::map<Id, Periodic_shift_2> m_translations; // of all ranks' points, those that were wrapped
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

Lists the edges of a `Distributed_dynamic_periodic_Delaunay_triangulation_2` that were created and
removed since the last `compute()`: what `Periodic_edge_changes_visitor_2` is for one process. Each
such edge is in the list of one rank; an edge that has only changed its owner is in no list.

All shifts, also those of removed edges, are for the present positions and the present cell: a point
that is wrapped, or a cell that is exchanged for another one of the same lattice, changes no edge.
Points are taken to have gone the shortest way since the last call, in multiples of the cell's
vectors, and the cell's present vectors to be those nearest to the former ones, as in one frame of
one process. So if `compute()` is called after each frame, the lists are those of one process,
except where more than three images are on an empty circle.

Cost: points and edges of each rank are sorted; the changes are sent, and every rank hears of all
points that were wrapped.

\sa `Distributed_edge_changes_2`
*/
class Distributed_periodic_edge_changes_2
{
public:
  /// an edge from point `i` to the image of point `j` by `shift`, with ids of 64 bits with a sign.
  using Edge = Periodic_edge<std::int64_t, Periodic_shift_2>;

  /// compares the edges with those at the last call. At the first call all edges count as created.
  /// Collective.
  /// \tparam Distributed a `Distributed_dynamic_periodic_Delaunay_triangulation_2`, always the same
  /// one.
  template <class Distributed>
  void compute(Distributed& dt)
  {
    const Floating_point floating_point;
    auto& ranks = Dynamic_Delaunay_triangulations_2::internal::Distributed_access_2::ranks(dt);
    ranks.agree("Distributed_periodic_edge_changes_2::compute()");
    const std::vector<std::int64_t> ids = dt.owned_ids();
    const auto points = dt.owned_points();
    std::vector<Translations::Entry> own;
    for (std::size_t k = 0; k < ids.size(); ++k)
      own.push_back({ids[k], points[k].x(), points[k].y()});
    m_translations.compute(ranks, dt.cell(), std::move(own));
    m_edges.rename([&](const Edge& e) {
      return Edge{e.i, e.j, m_translations.renamed(e.i, e.j, e.shift)}.in_order();
    });
    std::vector<Edge> edges;
    dt.for_each_edge([&](std::int64_t i, std::int64_t j, const Periodic_shift_2& shift) {
      edges.push_back(Edge{i, j, shift}.in_order());
    });
    m_edges.compare(ranks, std::move(edges));
  }

  /// the created edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& created_edges() const { return m_edges.created(); }
  /// the removed edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& removed_edges() const { return m_edges.removed(); }

private:
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using Translations = Dynamic_Delaunay_triangulations_2::internal::Distributed_translations_2;

  struct Traits
  {
    using Edge = Distributed_periodic_edge_changes_2::Edge;

    static std::int64_t end(const Edge& edge) { return edge.i; }
    static Edge sent(const Edge& edge) { return edge; }
    static Edge received(const Edge& edge) { return edge; }
  };

  Translations m_translations;
  Dynamic_Delaunay_triangulations_2::internal::Distributed_edge_comparison_2<Traits> m_edges;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_PERIODIC_EDGE_CHANGES_2_H
