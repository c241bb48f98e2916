// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_CHANGE_READING_H
#define BINDINGS_CHANGE_READING_H

#include "bindings/common/Recorded_changes.h"
#include "bindings/common/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_base.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/Periodic_shift_2.h>

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
template <class Id, class Shift>
struct Changed_edge
{
  Id i, j;
  Shift shift; // zeros where space is not periodic

  friend bool operator<(const Changed_edge& e, const Changed_edge& f)
  {
    return std::tie(e.i, e.j, e.shift) < std::tie(f.i, f.j, f.shift);
  }
};

template <class Id, class Shift>
Changed_edge<Id, Shift> in_order(Changed_edge<Id, Shift> edge)
{
  if (edge.j < edge.i) {
    std::swap(edge.i, edge.j);
    for (int& number : edge.shift) {
      number = -number;
    }
  }
  return edge;
}

// The edges of visitors: pairs, or arrays of two ids, where space is not periodic.
template <class Edge>
CGAL::Periodic_shift_2 shift_of(const Edge&)
{
  return {0, 0};
}
template <class Id, class Shift>
Shift shift_of(const CGAL::Periodic_edge<Id, Shift>& edge)
{
  return edge.shift;
}

template <class Edge>
std::array<std::size_t, 2> ends_of(const Edge& edge)
{
  return {std::size_t(std::get<0>(edge)), std::size_t(std::get<1>(edge))};
}
template <class Id, class Shift>
std::array<std::size_t, 2> ends_of(const CGAL::Periodic_edge<Id, Shift>& edge)
{
  return {edge.i, edge.j};
}

// In ascending order.
template <class Id, class Edge, class Shown_id>
auto changed_edges(const std::vector<Edge>& edges, const Shown_id& shown_id)
{
  using Shift = decltype(shift_of(std::declval<const Edge&>()));
  std::vector<Changed_edge<Id, Shift>> changed;
  changed.reserve(edges.size());
  for (const Edge& edge : edges) {
    const auto [i, j] = ends_of(edge);
    changed.push_back(in_order(Changed_edge<Id, Shift>{shown_id(i), shown_id(j), shift_of(edge)}));
  }
  std::sort(changed.begin(), changed.end());
  return changed;
}

// A point may leave and come back in one call, when a checkpoint is read.
template <class Edge>
std::vector<Edge> without(const std::vector<Edge>& edges, const std::vector<Edge>& others)
{
  std::vector<Edge> left;
  std::set_difference(edges.begin(), edges.end(), others.begin(), others.end(),
                      std::back_inserter(left));
  return left;
}

template <class Id, class Shift>
std::array<Array, 2> arrays_of(const std::vector<Changed_edge<Id, Shift>>& edges)
{
  std::vector<Id> ids;
  std::vector<std::int32_t> shifts;
  for (const auto& [i, j, shift] : edges) {
    ids.insert(ids.end(), {i, j});
    shifts.insert(shifts.end(), shift.begin(), shift.end());
  }
  return {{{std::move(ids), {2}}, {std::move(shifts), {std::tuple_size_v<Shift>}}}};
}

// Created edges, removed edges, and the shifts of both, which are zeros where space is not
// periodic. `shown_id(id)` is what the user calls a point.
template <class Id, class Visitor, class Shown_id>
std::vector<Array> change_arrays(const Visitor& visitor, const Shown_id& shown_id)
{
  if (!visitor.is_listening()) {
    throw std::invalid_argument("changed edges are recorded only with changes=True");
  }
  const auto created = changed_edges<Id>(visitor.created_edges(), shown_id),
             removed = changed_edges<Id>(visitor.removed_edges(), shown_id);
  auto [created_ids, created_shifts] = arrays_of(without(created, removed));
  auto [removed_ids, removed_shifts] = arrays_of(without(removed, created));
  return {std::move(created_ids), std::move(removed_ids), std::move(created_shifts),
          std::move(removed_shifts)};
}

} // namespace bindings

#endif // BINDINGS_CHANGE_READING_H
