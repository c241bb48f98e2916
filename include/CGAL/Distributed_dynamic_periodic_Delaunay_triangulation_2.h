// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DISTRIBUTED_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The Delaunay triangulation of points that move in a periodic space, and are spread over the ranks of
an MPI communicator: what `Dynamic_periodic_Delaunay_triangulation_2` is for one process, and
`Distributed_dynamic_Delaunay_triangulation_2` for the plane. The cell may be any parallelogram, and
may change with every frame. Functions that are called *collective* must be called by all ranks,
with the same cell where they take one.

Each rank owns some points, one image of each, and holds other images of points, its own ones
included, as *ghosts*. After construction and after each update every face with a corner that the
rank owns is proved to be one of the triangulation of all images of all points. Where more than
three images are on an empty circle, the diagonals go to the one with the smallest id, and of images
of that point to the leftmost, lowest one. So edges and faces depend only on points, ids and the
cell, not on how many ranks there are or what they own. The page
\ref DynamicDelaunayTriangulation2Ranks describes the protocol, and proves this.

<b>Rounding.</b> So that images are exact points of the plane, the coordinates of points and of the
cell's vectors are rounded to multiples of a power of 2. That moves them by at most 2<sup>-45</sup>
times the sum of the lengths of the lattice's two shortest vectors that span it. `owned_points()`,
`point()` and `cell()` return what is triangulated: one process has the same edges for these, but
where more than three images are on an empty circle. Given back as they are, they are not rounded
again.

There is one sheet, as in one process: `n` points in different places have `3n` edges and `2n`
faces, however few they are. Slabs are not supported.

What is needed of MPI, and what errors do, is as in the plane.

\tparam Kernel a CGAL kernel with exact predicates whose points have coordinates of type `double`.

\cgalExample{Dynamic_Delaunay_triangulation_2/ranks/distributed_shear.cpp}

\sa `Distributed_neighbor_lists_2`
\sa `Distributed_periodic_edge_changes_2`
*/
template <class Kernel>
class Distributed_dynamic_periodic_Delaunay_triangulation_2
{
  static_assert(
      Dynamic_Delaunay_triangulations_2::internal::has_double_coordinates<typename Kernel::Point_2>,
      "the coordinates of distributed points must be of type double");

  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Space = Dynamic_Delaunay_triangulations_2::internal::Distributed_torus_2<Kernel>;
  using Core = Dynamic_Delaunay_triangulations_2::internal::Distributed_triangulation_2<Space>;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2;

public:
  /// \name Types
  /// @{

  /// a point.
  using Point = typename Kernel::Point_2;
  /// a vector.
  using Vector = typename Kernel::Vector_2;
  /// an id, unique over all ranks; any number of 64 bits.
  using Id = std::int64_t;
  /// the type of counts.
  using size_type = std::size_t;
  /// the triangulation of all images that a rank holds, in the plane.
  using Held_triangulation = typename Core::Points::Dynamic;

  /// @}
  /// \name Creation
  /// @{

  /// the load factor of objects that are given none.
  static constexpr double default_load_factor = 1.5;

  /// triangulates the points of all ranks in the torus with this cell. Collective. Any points may
  /// be given by any rank; they are distributed evenly, unless the load factor is infinite: then
  /// each rank owns the points that it was given, in their order, for as long as `distribute()` is
  /// not called.
  ///
  /// The load factor says how many times as many points a rank may hold as the fullest rank did
  /// when that was least since the last distribution, and may own as a rank does on average; with
  /// more, and with 64 points more, all are distributed anew; for points that are held, only after
  /// 32 calls without a distribution.
  ///
  /// Cost: sorting, sending and triangulating all points once, and some rounds of questions.
  /// \tparam InputIterator its values are pairs of an `Id` and a `Point`.
  /// \throws Non_finite_coordinate_error_2 or Coordinate_range_error_2 (`id()` is the place in the
  /// range), or Distributed_input_error_2 on the other ranks; Repeated_id_error_2 on all ranks;
  /// Periodic_range_error_2 like the first ones, if a point is 2<sup>16</sup> cells or more from
  /// the origin; Parameter_error_2 on all ranks if the load factor is less than 1;
  /// Periodic_cell_error_2 on all ranks if the cell is a slab, if ranks give different cells, or if
  /// it is so thin or extreme that doubles cannot tell how far points are apart in it.
  template <class InputIterator>
  Distributed_dynamic_periodic_Delaunay_triangulation_2(MPI_Comm communicator, InputIterator first,
                                                        InputIterator beyond,
                                                        const Periodic_cell_2& cell,
                                                        double load_factor = default_load_factor)
    : m_core(communicator)
  {
    const Floating_point floating_point;
    m_core.begin([&] { return Space(cell); }, first, beyond, load_factor);
  }

  /// @}
  /// \name Motion
  /// @{

  /// moves the points that this rank owns to these positions, in the order of `owned_ids()`.
  /// Collective.
  ///
  /// Points may be given wrapped into the cell or not: of a point that moves by more than half the
  /// cell, the image nearest to where it was is taken to be where it has gone.
  /// \throws Point_count_error_2, Non_finite_coordinate_error_2, Coordinate_range_error_2 or
  /// Periodic_range_error_2, or Distributed_input_error_2 on the other ranks; nothing has changed
  /// then on any rank. \post `is_certified()`
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    return m_core.update(first, beyond);
  }

  /// the same, in a cell that has changed since the last call: by deformation, by other vectors for
  /// the same lattice, as where a sheared cell is flipped, or by both.
  ///
  /// Ghosts follow a deformation. Where the cell has been deformed by more than a factor of about
  /// 1.4 in some direction, or sheared by that much, since points were distributed last, they are
  /// distributed anew, as `number_of_distributions()` says; with an infinite load factor each rank
  /// keeps its own points, and has to ask for all others.
  /// \throws Periodic_cell_error_2 as the constructor does, or the above; nothing has changed then
  /// on any rank. \post `is_certified()`
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond, const Periodic_cell_2& cell)
  {
    const Floating_point floating_point;
    const auto make_space = [&] { return Space(cell, m_core.space()); };
    return m_core.update_in(make_space, first, beyond);
  }

  /// @}
  /// \name Population
  /// @{

  /// adds points, which the rank that is given them owns, after those that it owns already.
  /// Collective; a rank may give none.
  ///
  /// Cost: as an update in which the points jump to where they are, and every rank hears of all new
  /// ids. \tparam InputIterator its values are pairs of an `Id` and a `Point`.
  /// \throws Non_finite_coordinate_error_2, Coordinate_range_error_2 or Periodic_range_error_2
  /// (`id()` is the place in the range), or Distributed_input_error_2 on the other ranks;
  /// Repeated_id_error_2 on all ranks. Nothing has changed then on any rank.
  /// \post `is_certified()`
  template <class InputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    return m_core.insert(first, beyond);
  }

  /// removes points, whatever ranks own them. Collective; a rank may give none.
  ///
  /// Cost: as an update, and every rank hears of all these ids. \tparam InputIterator its values
  /// are ids.
  /// \throws Repeated_id_error_2 if two ranks, or one rank twice, give the same id,
  /// Unknown_user_id_error_2 if no point has it: on all ranks, and nothing has changed on any.
  /// \post `is_certified()`
  template <class InputIterator>
  Update_report_2 remove(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    return m_core.remove(first, beyond);
  }

  /// @}
  /// \name Distribution
  /// @{

  /// makes each rank own a stretch of a Hilbert curve through the cell, with about equally many
  /// points. Collective. Cost: as construction.
  void distribute()
  {
    const Floating_point floating_point;
    m_core.distribute();
  }

  /// how often points were distributed since construction. Where this has changed, owned points
  /// are other ones, in another order.
  size_type number_of_distributions() const { return m_core.number_of_distributions(); }

  /// data of the points that this rank owns, given data of those that it owned before the last
  /// distribution, each in the order of `owned_ids()` at that time. Collective. To be called before
  /// points are inserted or removed. After construction, "before" are the points that the rank was
  /// given.
  /// \tparam T trivially copyable.
  /// \throws Point_count_error_2 if there are not as many as points before, or
  /// Distributed_input_error_2 on the other ranks.
  template <class T>
  std::vector<T> carry(const std::vector<T>& data)
  {
    return m_core.carry(data);
  }

  /// @}
  /// \name Access
  /// @{

  /// the ids of the points that this rank owns, in the order of updates.
  std::vector<Id> owned_ids() const { return m_core.owned_ids(); }
  /// their positions as they were given last, rounded, in the same order.
  std::vector<Point> owned_points() const
  {
    const Floating_point floating_point;
    std::vector<Point> points;
    for (const auto& entry : m_core.owned_entries())
      points.push_back(Point(entry.x, entry.y));
    return points;
  }
  /// the number of points that this rank owns.
  size_type number_of_owned_points() const { return points().owned().size(); }
  /// the number of images that this rank holds beside one of each point that it owns.
  size_type number_of_ghosts() const { return points().number_of_ghosts(); }
  /// whether this rank holds the point or an image of it.
  bool holds(Id id) const { return points().holds(id); }
  /// the position of a point as it was given last, rounded. \pre `holds(id)`
  Point point(Id id) const
  {
    const Floating_point floating_point;
    const auto entry = points().entry(points().place(id));
    return Point(entry.x, entry.y);
  }
  /// the vector from the first point to the image of the second one by `shift`, rounded. \pre
  /// `holds(i)` and `holds(j)`
  Vector vector(Id i, Id j, const Periodic_shift_2& shift) const
  {
    const Point p = point(i), q = point(j);
    return Vector(q.x() - p.x() + (shift[0] * cell().ax() + shift[1] * cell().bx()),
                  q.y() - p.y() + (shift[0] * cell().ay() + shift[1] * cell().by()));
  }
  /// the cell of the last frame, rounded.
  const Periodic_cell_2& cell() const { return m_core.space().cell(); }

  /// the triangulation of the images that this rank holds. Its faces with the corner of a point
  /// that this rank owns, at `held_id()`, are those of all images; the others may not be. So what
  /// it tells about these vertices, such as `Voronoi_cell_measures_2`, is true for all points.
  /// Where four images or more are on a circle its diagonals may be others than those of
  /// `for_each_edge()`.
  const Held_triangulation& held_triangulation() const { return points().dt(); }
  /// the id of a held point in `held_triangulation()`, until the next call that changes points: of
  /// the image that this rank owns, or of a ghost, if it is not its own. \pre `holds(id)`
  size_type held_id(Id id) const { return points().place(id); }

  /// whether every face with an owned corner is proved. False only if an exception ended a call.
  bool is_certified() const { return m_core.is_certified(); }

  /// calls `f(i, j, shift)` for each edge whose smaller id, `i`, this rank owns: over all ranks,
  /// once for each edge, also from a point to its own image. As in one process, the image of point
  /// j by `shift`, a `Periodic_shift_2`, is a neighbor of point i: where they were given last. Of
  /// points that coincide, the one with the smallest id has the edges.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_edge(
        [&](Index i, Index j) { f(points().id(i), points().id(j), shift_between(i, j)); });
  }

  /// calls `f(ids, shifts)` for each face whose smallest id this rank owns: over all ranks, once
  /// for each face. The images of these three points by these shifts are its corners,
  /// counterclockwise. The first id is the smallest one, and its shift is (0, 0).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_face([&](Index i, Index j, Index k) {
      f(std::array<Id, 3>{points().id(i), points().id(j), points().id(k)},
        std::array<Periodic_shift_2, 3>{shift_between(i, i), shift_between(i, j),
                                        shift_between(i, k)});
    });
  }

  /// calls `f(k, j, shift)` for each point that this rank owns, the `k`-th of `owned_ids()`, and
  /// the id `j` and shift of each of its neighbors. An edge from a point to its own image is met at
  /// both of its ends. Of points that coincide, the one with the smallest id has neighbors.
  template <class Function>
  void for_each_neighbor(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_neighbor(
        [&](size_type k, Index i, Index j) { f(k, points().id(j), shift_between(i, j)); });
  }

  /// calls `f(k, j, shift)` for each point that this rank owns, the `k`-th of `owned_ids()`, that
  /// coincides with the image by `shift` of one of a smaller id, `j` being the smallest; and for
  /// the one with the smallest id, if this rank owns it, with each of the others.
  template <class Function>
  void for_each_duplicate(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_duplicate(
        [&](size_type k, Index i, Index j) { f(k, points().id(j), shift_between(i, j)); });
  }

  /// @}
  /// \name Checkpoints
  /// The cell, and positions and ids of all points, in one file, which all ranks write and read
  /// together, by `MPI_File`. Edges and faces depend on nothing else, so a run continues with the
  /// same ones, on any number of ranks.
  ///
  /// A file is written under its name with `.unfinished` appended, and renamed when it is complete.
  /// So the last checkpoint stays readable, whenever a rank dies.
  /// @{

  /// writes the cell and all points. Collective. Cost: 24 bytes a point. \throws Checkpoint_error_2
  /// on all ranks if that is impossible; what had the name before is still there.
  void write_checkpoint(const std::string& path)
  {
    const Floating_point floating_point;
    m_core.write_checkpoint(path);
  }

  /// the same, with the user's data of each point that this rank owns, in the order of
  /// `owned_ids()`. \tparam T trivially copyable. \throws Point_count_error_2 if there are not as
  /// many as owned points, or Distributed_input_error_2 on the other ranks.
  template <class T>
  void write_checkpoint(const std::string& path, const std::vector<T>& data)
  {
    const Floating_point floating_point;
    m_core.write_checkpoint(path, data);
  }

  /// replaces the cell and all points by those in a file, and distributes them as the constructor
  /// does. Collective. \throws Checkpoint_error_2 on all ranks if there is no such file, or if it
  /// is not as it was written; nothing has changed then on any rank. \post `is_certified()`
  void read_checkpoint(const std::string& path)
  {
    const Floating_point floating_point;
    m_core.read_checkpoint(path);
  }

  /// the same, and replaces `data` by the user's data of the points that this rank owns.
  template <class T>
  void read_checkpoint(const std::string& path, std::vector<T>& data)
  {
    const Floating_point floating_point;
    m_core.read_checkpoint(path, data);
  }

  /// @}
  /// \name Checking
  /// @{

  /// proves all faces with an owned corner anew, without trust in what ranks have agreed to send.
  /// Collective, with the same result on all ranks. Cost: a pass over all faces, and questions as
  /// after a distribution.
  bool certify()
  {
    const Floating_point floating_point;
    return m_core.certify();
  }

  /// whether what all ranks hold is valid: their triangulations are, both sides of each link
  /// between ranks hold the same points, no id is owned twice, and vertices, edges and faces of all
  /// ranks satisfy Euler's formula. Collective, with the same result on all ranks. Cost: linear,
  /// and as many bytes as ghosts and ids have.
  bool is_valid()
  {
    const Floating_point floating_point;
    return m_core.is_valid();
  }

  /// @}
  /// \name Figures
  /// Of this rank, since construction.
  /// @{

  /// how many calls needed questions of any rank.
  size_type number_of_asking_frames() const { return m_core.proof().number_of_asking_frames(); }
  /// how often ranks have asked each other.
  size_type number_of_rounds() const { return m_core.proof().number_of_rounds(); }
  /// messages that this rank has sent, collective calls of MPI not counted.
  size_type number_of_messages() const { return m_core.ranks().exchange().sent_messages(); }
  /// the same in bytes.
  size_type number_of_bytes() const { return m_core.ranks().exchange().sent_bytes(); }
  /// bytes that all ranks have told all others, in collective calls: zones and boxes.
  size_type number_of_gathered_bytes() const { return m_core.ranks().gathered_bytes(); }
  /// seconds in which this rank has sent, received or waited.
  double communication_seconds() const { return m_core.ranks().exchange().seconds(); }
  /// seconds in which this rank has done other things while messages were under way that it had
  /// sent, for all it knew.
  double overlapped_seconds() const { return m_core.ranks().exchange().overlapped_seconds(); }

  /// @}

  /// \cond
  auto& ranks() { return m_core.ranks(); }
  /// \endcond

private:
  const typename Core::Points& points() const { return m_core.points(); }

  // From what was given for the point at the first place to the image of the second one.
  Periodic_shift_2 shift_between(Index i, Index j) const
  {
    const Periodic_shift_2 &s = points().shift(i), &t = points().shift(j);
    return {t[0] - s[0], t[1] - s[1]};
  }

  Core m_core;
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
