// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_CHANGE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_CHANGE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What happened to a periodic triangulation: one entry of the editor's log, in the words of
// `PeriodicUpdateVisitor_2`. Ids, since vertices get other numbers.
struct Periodic_change_2
{
  enum class Kind { EDGE_REMOVED, EDGE_CREATED, POINT_TRANSLATED, CELL_EXCHANGED };

  static Periodic_change_2 edge(Kind kind, Index i, Index j, const Periodic_shift_2& shift)
  {
    return {kind, i, j, {shift, no_shift}};
  }
  static Periodic_change_2 translation(Index id, const Periodic_shift_2& shift)
  {
    return {Kind::POINT_TRANSLATED, id, null_index, {shift, no_shift}};
  }
  static Periodic_change_2 exchange(const std::array<Periodic_shift_2, 2>& multiples)
  {
    return {Kind::CELL_EXCHANGED, null_index, null_index, multiples};
  }

  // Calls the visitor's function for this change.
  template <class Visitor, class Dynamic>
  void tell(Visitor& visitor, const Dynamic& dynamic) const
  {
    const std::size_t id = i, other = j;
    if (kind == Kind::CELL_EXCHANGED)
      visitor.after_cell_exchange(dynamic, shifts);
    else if (kind == Kind::POINT_TRANSLATED)
      visitor.after_translation(dynamic, id, shifts[0]);
    else if (kind == Kind::EDGE_REMOVED)
      visitor.after_edge_removal(dynamic, id, other, shifts[0]);
    else
      visitor.after_edge_creation(dynamic, id, other, shifts[0]);
  }

  Kind kind;
  Index i, j;
  std::array<Periodic_shift_2, 2> shifts; // the first one alone, unless a cell was exchanged
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_CHANGE_2_H
