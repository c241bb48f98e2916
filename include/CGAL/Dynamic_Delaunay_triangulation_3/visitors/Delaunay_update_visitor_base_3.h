// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_DELAUNAY_UPDATE_VISITOR_BASE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_DELAUNAY_UPDATE_VISITOR_BASE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>

#include <array>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Visitors

A visitor of points in space that ignores everything. It is the default, which costs nothing, and a
base for your own visitors, which then define only the functions that they need. Each has the
triangulation, a `Dynamic_Delaunay_triangulation_3`, as its first argument, which must not change
it.

Visitors are default constructible and copyable. They are told of each call that changes points, and
of `read_checkpoint()`: after the change, which edges and facets are gone and which are new, each in
ascending order; those that were replaced and came back are not mentioned. Ends are ids of
representatives, ascending; those of removed ones may belong to points that no longer exist, or to
new points with the same ids. If memory does not suffice for a call, what it has changed is told
after the next one. What a visitor throws, the caller gets; what would follow is not told. One that
has a member `bool is_listening() const` is told of calls alone, and costs nothing else, while that
is false; its answer may change between calls, but not after one that has failed, until another one
has succeeded.

Cost: proportional to the number of cells that have changed, times its logarithm, and four bytes a
point to be copied; a rebuild changes all cells.
*/
class Delaunay_update_visitor_base_3
{
public:
  /// does nothing. Called before a change.
  template <class Dynamic>
  void before_update(const Dynamic&)
  {
  }

  /// does nothing. Called for each facet that is gone, with the ids of its vertices.
  template <class Dynamic>
  void after_facet_removal(const Dynamic&, const std::array<std::size_t, 3>&)
  {
  }

  /// does nothing. Called for each edge that is gone, with the ids of its ends.
  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t, std::size_t)
  {
  }

  /// does nothing. Called for each new edge.
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t, std::size_t)
  {
  }

  /// does nothing. Called for each new facet.
  template <class Dynamic>
  void after_facet_creation(const Dynamic&, const std::array<std::size_t, 3>&)
  {
  }

  /// \name Periodic Space
  /// In periodic space the functions above are replaced by these. A shift is that of an image from
  /// where its point is given. All shifts, also those of what is gone, are for the present points
  /// and the present cell. Those that say how shifts change are called before all others.
  /// @{

  /// does nothing. Called for each facet that is gone, with the ids of its vertices and their
  /// shifts, of which the first is (0, 0, 0).
  template <class Dynamic>
  void after_facet_removal(const Dynamic&, const std::array<std::size_t, 3>&,
                           const std::array<Periodic_shift_3, 3>&)
  {
  }

  /// does nothing. Called for each edge that is gone, with the ids of its ends and the shift of the
  /// second one.
  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t, std::size_t, const Periodic_shift_3&)
  {
  }

  /// does nothing. Called for each new edge.
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t, std::size_t, const Periodic_shift_3&)
  {
  }

  /// does nothing. Called for each new facet.
  template <class Dynamic>
  void after_facet_creation(const Dynamic&, const std::array<std::size_t, 3>&,
                            const std::array<Periodic_shift_3, 3>&)
  {
  }

  /// does nothing. Called for each point that is now given at another image than where it went, as
  /// by wrapping it into the cell, with its id and how far it was translated: what was its image by
  /// s is now that by s minus this shift.
  template <class Dynamic>
  void after_translation(const Dynamic&, std::size_t, const Periodic_shift_3&)
  {
  }

  /// does nothing. Called if the cell has other vectors for the same lattice than before, as when a
  /// sheared cell is flipped, with what each of the former vectors is in the present ones. All
  /// shifts change so.
  template <class Dynamic>
  void after_cell_exchange(const Dynamic&, const std::array<Periodic_shift_3, 3>&)
  {
  }

  /// @}

  /// does nothing. Called in the end.
  template <class Dynamic>
  void after_update(const Dynamic&, const Update_report_3&)
  {
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_DELAUNAY_UPDATE_VISITOR_BASE_3_H
