// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DISTRIBUTED_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/distributed/Distributed_triangulation_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <mpi.h>

#include <iterator>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The Delaunay triangulation of points that move in a periodic space, and are spread over the ranks of
an MPI communicator: what `Dynamic_periodic_Delaunay_triangulation_2` is for one process, and
`Distributed_dynamic_Delaunay_triangulation_2` for the plane. The cell may be any parallelogram, and
may change with every frame: all ranks must give the same one. `Distributed_triangulation_base_2`
documents all members other than those for cells.

Where more than three images are on an empty circle, the diagonals go to the one with the smallest
id, and of images of that point to the leftmost, lowest one.

<b>Rounding.</b> So that images are exact points of the plane, the coordinates of points and of the
cell's vectors are rounded to multiples of a power of 2. That moves each coordinate by at most
2<sup>-45</sup> H, where H is the sum of the lengths of the two shortest vectors that span the
lattice. `owned_points()`, `point()` and `cell()` return the rounded points and cell, which are
triangulated. One process has the same edges for these, except where more than three images are on
an empty circle. Rounded points and cells are not rounded again.

There is one sheet, as in one process: `n` points in different places have `3n` edges and `2n`
faces, however few they are. Slabs are not supported.

\tparam Kernel a CGAL kernel with exact predicates whose points have coordinates of type `double`.

\cgalExample{Dynamic_Delaunay_triangulation_2/ranks/distributed_shear.cpp}

\sa `Distributed_neighbor_lists_2`
\sa `Distributed_periodic_edge_changes_2`
*/
template <class Kernel>
class Distributed_dynamic_periodic_Delaunay_triangulation_2
  : public Distributed_triangulation_base_2<
        Dynamic_Delaunay_triangulations_2::internal::Distributed_torus_2<Kernel>>
{
  using Space = Dynamic_Delaunay_triangulations_2::internal::Distributed_torus_2<Kernel>;
  using Base = Distributed_triangulation_base_2<Space>;
  using Base::m_core;
  using typename Base::Floating_point;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;

public:
  /// \name Types
  /// @{

  using typename Base::Id;
  using typename Base::Point;
  /// a vector.
  using Vector = typename Kernel::Vector_2;

  /// @}
  /// \name Creation
  /// @{

  /// triangulates the points of all ranks in the torus with this cell. Collective. Which rank owns
  /// a point, when points are distributed anew, what this costs, and what happens if a rank has bad
  /// arguments: all that is as for `Distributed_dynamic_Delaunay_triangulation_2`.
  /// \tparam InputIterator its values are pairs of an `Id` and a `Point`.
  /// \throws Parameter_error_2 if the load factor is less than 1 or NaN, or on all ranks if they
  /// give different ones; Periodic_cell_error_2 if the cell is a slab, or so thin or extreme that
  /// doubles cannot tell how far points are apart in it, or on all ranks if they give different
  /// cells; Non_finite_coordinate_error_2 or Coordinate_range_error_2 (`id()` is the place in the
  /// range); Periodic_range_error_2 likewise, if a point is 2<sup>16</sup> cells or about
  /// 2<sup>16</sup> H from the origin or more; Repeated_id_error_2, on all ranks.
  template <class InputIterator>
  Distributed_dynamic_periodic_Delaunay_triangulation_2(
      MPI_Comm communicator, InputIterator first, InputIterator beyond, const Periodic_cell_2& cell,
      double load_factor = Base::default_load_factor)
    : Base(communicator)
  {
    const Floating_point floating_point;
    m_core.begin([&] { return Space(cell); }, first, beyond, load_factor);
  }

  /// takes the points from a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Distributed_dynamic_periodic_Delaunay_triangulation_2(
      MPI_Comm communicator, const Range& range, const Periodic_cell_2& cell,
      double load_factor = Base::default_load_factor)
    : Distributed_dynamic_periodic_Delaunay_triangulation_2(communicator, std::begin(range),
                                                            std::end(range), cell, load_factor)
  {
  }

  /// @}
  /// \name Motion
  /// @{

  using Base::update;
  /// moves the points as `update(first, beyond)` does, in a cell that has changed since the last
  /// call: by deformation, by other vectors for the same lattice, as when a sheared cell is
  /// flipped, or by both.
  ///
  /// Ghosts follow a deformation. If the cell has been deformed by more than a factor of about 1.4
  /// in some direction, or sheared by that much, since the last distribution, points are
  /// distributed anew, as `number_of_distributions()` tells; with an infinite load factor each rank
  /// keeps its own points, and has to ask for all others.
  /// \throws Periodic_cell_error_2 as the constructor does, or what `update(first, beyond)` throws;
  /// nothing has changed then on any rank. \post `is_certified()`
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond, const Periodic_cell_2& cell)
  {
    const Floating_point floating_point;
    const auto make_space = [&] { return Space(cell, m_core.space()); };
    return m_core.update_in(make_space, first, beyond);
  }

  /// takes the positions from a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_2 update(const Range& range, const Periodic_cell_2& cell)
  {
    return update(std::begin(range), std::end(range), cell);
  }

  /// @}
  /// \name Access
  /// @{

  /// the vector from point i to the image of point j by `shift`, rounded. \pre `holds(i)` and
  /// `holds(j)`
  Vector vector(Id i, Id j, const Periodic_shift_2& shift) const
  {
    const Point p = this->point(i), q = this->point(j);
    return Vector(q.x() - p.x() + (shift[0] * cell().ax() + shift[1] * cell().bx()),
                  q.y() - p.y() + (shift[0] * cell().ay() + shift[1] * cell().by()));
  }
  /// the cell of the last frame, rounded.
  const Periodic_cell_2& cell() const { return m_core.space().cell(); }
  /// @}
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
