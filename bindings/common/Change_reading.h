// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_CHANGE_READING_H
#define BINDINGS_CHANGE_READING_H

#include "bindings/common/Recorded_changes.h"
#include "bindings/common/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_visitor_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace bindings {

// An edge that came or went, by the ids that are shown to the user.
template <class Id>
struct Changed_edge
{
  Id i, j;
  CGAL::Periodic_shift_2 shift; // zeros where space is not periodic

  friend bool operator<(const Changed_edge& e, const Changed_edge& f)
  {
    return std::tie(e.i, e.j, e.shift) < std::tie(f.i, f.j, f.shift);
  }
};

template <class Id>
Changed_edge<Id> in_order(const Changed_edge<Id>& edge)
{
  return edge.j < edge.i ? Changed_edge<Id>{edge.j, edge.i, {-edge.shift[0], -edge.shift[1]}}
                         : edge;
}

// `edge` is a pair, or an array of two ids.
template <class Id, class Edge, class Shown_id>
Changed_edge<Id> changed_edge(const Edge& edge, const Shown_id& shown_id)
{
  return in_order(
      Changed_edge<Id>{shown_id(std::get<0>(edge)), shown_id(std::get<1>(edge)), {0, 0}});
}
template <class Id, class Shown_id>
Changed_edge<Id> changed_edge(const CGAL::Periodic_edge_changes_visitor_2::Edge& edge,
                              const Shown_id& shown_id)
{
  return in_order(Changed_edge<Id>{shown_id(edge.i), shown_id(edge.j), edge.shift});
}

// In ascending order.
template <class Id, class Edges, class Shown_id>
std::vector<Changed_edge<Id>> changed_edges(const Edges& edges, const Shown_id& shown_id)
{
  std::vector<Changed_edge<Id>> changed;
  changed.reserve(edges.size());
  for (const auto& edge : edges) {
    changed.push_back(changed_edge<Id>(edge, shown_id));
  }
  std::sort(changed.begin(), changed.end());
  return changed;
}

// A point may leave and come back in one call, when a checkpoint is read.
template <class Id>
std::vector<Changed_edge<Id>> without(const std::vector<Changed_edge<Id>>& edges,
                                      const std::vector<Changed_edge<Id>>& others)
{
  std::vector<Changed_edge<Id>> left;
  std::set_difference(edges.begin(), edges.end(), others.begin(), others.end(),
                      std::back_inserter(left));
  return left;
}

template <class Id>
std::array<Array, 2> arrays_of(const std::vector<Changed_edge<Id>>& edges)
{
  std::vector<Id> ids;
  std::vector<std::int32_t> shifts;
  for (const auto& [i, j, shift] : edges) {
    ids.insert(ids.end(), {i, j});
    shifts.insert(shifts.end(), {shift[0], shift[1]});
  }
  return {{{std::move(ids), {2}}, {std::move(shifts), {2}}}};
}

// Created edges, removed edges, and the shifts of both, which are zeros where space is not
// periodic. `shown_id(id)` is what the user calls a point.
template <class Id, class Visitor, class Shown_id>
std::vector<Array> change_arrays(const Visitor& visitor, const Shown_id& shown_id)
{
  if constexpr (records_changes<Visitor>) {
    const auto created = changed_edges<Id>(visitor.created_edges(), shown_id),
               removed = changed_edges<Id>(visitor.removed_edges(), shown_id);
    auto [created_ids, created_shifts] = arrays_of(without(created, removed));
    auto [removed_ids, removed_shifts] = arrays_of(without(removed, created));
    return {std::move(created_ids), std::move(removed_ids), std::move(created_shifts),
            std::move(removed_shifts)};
  } else {
    throw std::invalid_argument("changed edges are recorded only with changes=True");
  }
}

} // namespace bindings

#endif // BINDINGS_CHANGE_READING_H
