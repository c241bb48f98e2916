// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A visitor of a `CGAL::Dynamic_periodic_Delaunay_triangulation_2` is told of all edges that come and
go, with their shifts, and of all shifts that are numbered anew. So it can keep a list of all edges
without asking the triangulation. `CGAL::Delaunay_update_visitor_base_2` has all functions, and is
a base for visitors that need only some of them. It may have a member `bool is_listening() const`,
as `DelaunayUpdateVisitor_2` says.

Every call that can change the triangulation begins with `before_update()`. When everything is done,
the visitor is told what has happened, in the order in which it happened, and at last
`after_update()` is called. So each of the functions can ask the triangulation anything: it is the
old one in the first, and the new one in all others, certified unless a heuristic classifier has
left it uncertified. An edge may come and go several times in one call. Where everything is
triangulated anew, or read from a checkpoint, all edges are removed and created; those that a
checkpoint replaces are removed with the shifts that they had in the old cell.

Edges are given as by `for_each_edge()`, in either direction: (i, j, shift) and (j, i, -shift) are
the same edge. The ids may be those of points that are no longer there.

If a visitor throws in `before_update()`, nothing changes. If it throws later, the change is
complete, and the rest is not told.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_update_visitor_base_2}
\cgalHasModels{CGAL::Periodic_edge_changes_visitor_2}
\cgalHasModelsEnd
*/
class PeriodicUpdateVisitor_2
{
public:
  /// is called after the input of a call was read and accepted, before anything changes.
  template <class Dynamic>
  void before_update(const Dynamic& dt);

  /// is called at the end of a call, with the report that it returns.
  template <class Dynamic>
  void after_update(const Dynamic& dt, const CGAL::Update_report_2& report);

  /// is told that an edge was removed.
  template <class Dynamic>
  void after_edge_removal(const Dynamic& dt, std::size_t i, std::size_t j,
                          const CGAL::Periodic_shift_2& shift);

  /// is told that an edge was created.
  template <class Dynamic>
  void after_edge_creation(const Dynamic& dt, std::size_t i, std::size_t j,
                           const CGAL::Periodic_shift_2& shift);

  /// is told that point `i` is given by another image, as where it is wrapped, about `shift` from
  /// the one before: from now on its edges (i, j, s) with j ≠ i are called (i, j, s + shift). No
  /// edge comes or goes by that.
  template <class Dynamic>
  void after_translation(const Dynamic& dt, std::size_t i, const CGAL::Periodic_shift_2& shift);

  /// is told that other vectors are used for the same lattice: from now on the shift s is called
  /// `s[0] * multiples[0] + s[1] * multiples[1]`, for all edges. No edge comes or goes by that.
  template <class Dynamic>
  void after_cell_exchange(const Dynamic& dt,
                           const std::array<CGAL::Periodic_shift_2, 2>& multiples);
};
