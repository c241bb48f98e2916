// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_triangulation_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_plane_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>

#include <mpi.h>

#include <iterator>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The Delaunay triangulation of moving points of the plane that are spread over the ranks of an MPI
communicator: what `Dynamic_Delaunay_triangulation_2` is for one process.
`Distributed_triangulation_base_2` documents all members but the constructor.

Where more than three points are on an empty circle, the diagonals go to the one with the smallest
id, on all ranks.

\tparam Kernel a CGAL kernel with exact predicates whose points have coordinates of type `double`.

\cgalExample{Dynamic_Delaunay_triangulation_2/ranks/distributed_dam_break.cpp}

\sa `Distributed_neighbor_lists_2`
\sa `Distributed_edge_changes_2`
*/
template <class Kernel>
class Distributed_dynamic_Delaunay_triangulation_2
  : public Distributed_triangulation_base_2<
        Dynamic_Delaunay_triangulations_2::internal::Distributed_plane_2<Kernel>>
{
  using Space = Dynamic_Delaunay_triangulations_2::internal::Distributed_plane_2<Kernel>;
  using Base = Distributed_triangulation_base_2<Space>;
  using Base::m_core;
  using typename Base::Floating_point;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;

public:
  /// \name Creation
  /// @{

  /// triangulates the points of all ranks. Collective. Any points may be given by any rank; they
  /// are distributed evenly, unless the load factor is infinite: then each rank owns the points
  /// that it was given, in their order, for as long as `distribute()` is not called.
  ///
  /// Points are distributed anew if a rank owns more points than the load factor times the average,
  /// plus 64; or, from 32 calls after the last distribution on, if a rank holds more points than
  /// the load factor times m, plus 64, where m is the least number of points that the fullest rank
  /// has held since then.
  ///
  /// Cost: sorting, sending and triangulating all points once, and some rounds of questions. The
  /// arguments are checked before anything is sent: a rank with bad ones throws its own error, and
  /// all other ranks throw Distributed_input_error_2.
  /// \tparam InputIterator its values are pairs of an `Id` and a `Point`.
  /// \throws Parameter_error_2 if the load factor is less than 1 or NaN, or on all ranks if they
  /// give different ones; Non_finite_coordinate_error_2 or Coordinate_range_error_2 (`id()` is the
  /// place in the range); Repeated_id_error_2, on all ranks.
  template <class InputIterator>
  Distributed_dynamic_Delaunay_triangulation_2(MPI_Comm communicator, InputIterator first,
                                               InputIterator beyond,
                                               double load_factor = Base::default_load_factor)
    : Base(communicator)
  {
    const Floating_point floating_point;
    m_core.begin([] { return Space(); }, first, beyond, load_factor);
  }

  /// takes the points from a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Distributed_dynamic_Delaunay_triangulation_2(MPI_Comm communicator, const Range& range,
                                               double load_factor = Base::default_load_factor)
    : Distributed_dynamic_Delaunay_triangulation_2(communicator, std::begin(range), std::end(range),
                                                   load_factor)
  {
  }

  /// @}
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
