// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_VISITOR_CALLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_VISITOR_CALLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// One change of a periodic triangulation: an entry of the editor's log, in the words of
// `PeriodicUpdateVisitor_2`. It names points by ids, because vertices are renumbered.
struct Periodic_change_2
{
  enum class Kind { EDGE_REMOVED, EDGE_CREATED, POINT_TRANSLATED, CELL_EXCHANGED };

  static Periodic_change_2 edge(Kind kind, Point_id i, Point_id j, const Periodic_shift_2& shift)
  {
    return {kind, i, j, {shift, no_shift}};
  }
  static Periodic_change_2 translation(Point_id id, const Periodic_shift_2& shift)
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
  Point_id i, j;
  std::array<Periodic_shift_2, 2> shifts; // the first one alone, unless a cell was exchanged
};

// Logs changes until a call has ended, and then tells the user's visitor, which is hidden behind a
// function as in `Visitor_calls_2`. If it does not listen, nothing is logged.
class Periodic_visitor_calls_2
{
public:
  // Call this first: both objects may be at other addresses than in the last call.
  template <class Visitor, class Dynamic>
  void start(Visitor& visitor, const Dynamic* dynamic, bool is_listening)
  {
    m_is_heard = is_listening;
    m_visitor = &visitor;
    m_dynamic = dynamic;
    m_tell = [](void* v, const void* d, const Periodic_change_2& change) {
      change.tell(*static_cast<Visitor*>(v), *static_cast<const Dynamic*>(d));
    };
  }

  // Whether the visitor listens to this call, or has listened to the last one.
  bool is_heard() const { return m_is_heard; }

  // Tells all changes since the last finish(), including those of a call that an exception has
  // ended. If the visitor throws, the changes that follow are never told.
  void finish()
  {
    m_told.clear();
    m_told.swap(m_log);
    for (const Periodic_change_2& change : m_told)
      m_tell(m_visitor, m_dynamic, change);
  }

  std::vector<Periodic_change_2>& log() { return m_log; }

  // Reserves memory for this number of changes, beyond those of keep_memory_for().
  void reserve(std::size_t changes)
  {
    if (is_heard())
      reserve_extra(m_log, changes + m_kept);
  }
  void keep_memory_for(std::size_t changes)
  {
    m_kept = changes;
    reserve(0);
  }

private:
  bool m_is_heard = false;
  void* m_visitor = nullptr;
  const void* m_dynamic = nullptr;
  void (*m_tell)(void*, const void*, const Periodic_change_2&) = nullptr;
  std::vector<Periodic_change_2> m_log, m_told;
  std::size_t m_kept = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_VISITOR_CALLS_2_H
