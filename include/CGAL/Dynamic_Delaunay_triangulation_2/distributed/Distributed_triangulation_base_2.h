// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_TRIANGULATION_BASE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_TRIANGULATION_BASE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The common members of distributed triangulations of moving points on the ranks of an MPI
communicator. `Distributed_dynamic_Delaunay_triangulation_2` and
`Distributed_dynamic_periodic_Delaunay_triangulation_2` derive from this class. All ranks must call
a *collective* function together. If they call different functions of one object,
Distributed_input_error_2 says so on all ranks, and nothing has changed.

Each rank owns some points, and holds copies of points of other ranks, its *ghosts*; in periodic
space, ghosts are also other images of its own points. After construction and after each update
every face with a corner that the rank owns is proved to be a face of the triangulation of all
points: no point of any rank is strictly inside of its circumcircle, and the rank holds all points
on that circle. Edges and faces depend only on points and ids, and the cell of periodic space, not
on how many ranks there are or which points they own. The protocol is described, and this is proved,
on the page \ref DynamicDelaunayTriangulation2Ranks.

Each rank owns a stretch of a Hilbert curve through all points. When a rank holds too many points,
compared with what ranks held after the last distribution, `update()`, `insert()` or `remove()`
distributes all points anew at its end: `number_of_distributions()` then has grown, `owned_ids()`
returns other ids in another order, and `carry()` brings the user's data along.

This class uses MPI 3: its own copy of the communicator, `MPI_Allreduce`, `MPI_Allgather(v)`,
synchronous sends with a barrier that does not block, and, for checkpoints, `MPI_File`. The thread
that calls a function of this class makes all calls of MPI, so `MPI_THREAD_FUNNELED` is enough if
that is the main thread. MPI must be initialized before, and finalized after the object is gone. An
error of MPI ends the program, unless the user gave the communicator another error handler. An
exception that one rank alone throws and does not catch ends the program, too: `mpirun` then ends
the other ranks. The section \ref RanksErrors says what to do with exceptions.

\tparam Space an internal type: the plane or a torus.
*/
template <class Space>
class Distributed_triangulation_base_2
{
  using Kernel = typename Space::Kernel;

  static_assert(
      Dynamic_Delaunay_triangulations_2::internal::has_double_coordinates<typename Kernel::Point_2>,
      "the coordinates of distributed points must be of type double");

  using Core = Dynamic_Delaunay_triangulations_2::internal::Distributed_triangulation_2<Space>;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;

public:
  /// \name Types
  /// @{

  /// a point.
  using Point = typename Kernel::Point_2;
  /// an id, unique over all ranks; any number of 64 bits.
  using Id = std::int64_t;
  /// the type of counts.
  using size_type = std::size_t;
  /// the triangulation of all points that a rank holds.
  using Held_triangulation = typename Core::Points::Dynamic;

  /// @}
  /// \name Creation
  /// @{

  /// the default of the load factor.
  static constexpr double default_load_factor = 1.5;

  /// @}
  /// \name Motion
  /// @{

  /// moves the points that this rank owns to these positions, in the order of `owned_ids()`.
  /// Collective. In periodic space points may be given wrapped into the cell or not: a point that
  /// moves by more than half the cell is taken to have moved to the nearest image of its new
  /// position.
  ///
  /// Each rank sends the positions of points that others hold as ghosts, moves its other points
  /// while these are under way, and updates its own triangulation. If that does not prove all its
  /// faces, it asks the ranks that may have points in their circumcircles, and takes the answers as
  /// ghosts, until no question is left. \throws Point_count_error_2, Non_finite_coordinate_error_2,
  /// Coordinate_range_error_2 or, in periodic space, Periodic_range_error_2 (`id()` is the place in
  /// the range), or Distributed_input_error_2 on the other ranks; nothing has changed then on any
  /// rank. \post `is_certified()`
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    return m_core.update(first, beyond);
  }

  /// takes the positions from a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_2 update(const Range& range)
  {
    return update(std::begin(range), std::end(range));
  }

  /// @}
  /// \name Population
  /// @{

  /// adds points. The rank that is given them owns them, after its other points in the order of
  /// updates, unless all points are distributed anew. Collective; a rank may give none.
  ///
  /// Cost: that of an update in which these points jump; every rank hears of all new ids.
  /// \tparam InputIterator its values are pairs of an `Id` and a `Point`.
  /// \throws Non_finite_coordinate_error_2, Coordinate_range_error_2 or, in periodic space,
  /// Periodic_range_error_2 (`id()` is the place in the range), or Distributed_input_error_2 on the
  /// other ranks; Repeated_id_error_2 on all ranks. Nothing has changed then on any rank.
  /// \post `is_certified()`
  template <class InputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    return m_core.insert(first, beyond);
  }

  /// adds the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_2 insert(const Range& range)
  {
    return insert(std::begin(range), std::end(range));
  }

  /// removes points, whichever ranks own them. Collective; a rank may give none.
  ///
  /// Cost: that of an update; every rank hears of all these ids.
  /// \tparam InputIterator its values are ids.
  /// \throws Repeated_id_error_2 if two ranks, or one rank twice, give the same id,
  /// Unknown_user_id_error_2 if no point has a given id: on all ranks; nothing has changed then.
  /// \post `is_certified()`
  template <class InputIterator>
  Update_report_2 remove(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    return m_core.remove(first, beyond);
  }

  /// removes the points whose ids are in a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_2 remove(const Range& ids)
  {
    return remove(std::begin(ids), std::end(ids));
  }

  /// @}
  /// \name Distribution
  /// @{

  /// makes each rank own a stretch of a Hilbert curve, with about equally many points. Collective.
  /// Cost: that of construction.
  void distribute()
  {
    const Floating_point floating_point;
    m_core.distribute();
  }

  /// how often points were distributed since construction, or replaced by `read_checkpoint()`. If
  /// this has changed, the rank owns other points, in another order.
  size_type number_of_distributions() const { return m_core.number_of_distributions(); }

  /// data of the points that this rank owns, given data of those that it owned before the last
  /// distribution, each in the order of `owned_ids()` at that time. Collective. Call it before
  /// points are inserted or removed. After construction, the points before are those that the rank
  /// was given; after `read_checkpoint()`, those that it owns, so that their data stay as they are.
  /// \tparam T trivially copyable.
  /// \throws Point_count_error_2 if there are not as many data as points before, or
  /// Distributed_input_error_2 on the other ranks; Distributed_input_error_2 on all ranks if T has
  /// not the same size on all of them.
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
  /// their positions as they were given last, in periodic space rounded, in the same order.
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
  /// the number of points of other ranks, and in periodic space also of other images of its own
  /// ones, that this rank holds.
  size_type number_of_ghosts() const { return points().number_of_ghosts(); }
  /// whether this rank holds the point or an image of it, as its own or as a ghost.
  bool holds(Id id) const { return points().holds(id); }
  /// the position of a point as it was given last, in periodic space rounded. \pre `holds(id)`
  Point point(Id id) const
  {
    const Floating_point floating_point;
    const auto entry = points().entry(points().place(id));
    return Point(entry.x, entry.y);
  }

  /// calls `f(i, j)` for each finite edge whose smaller id, `i`, this rank owns: over all ranks,
  /// once for each edge. Of points that coincide, the one with the smallest id has the edges. In
  /// periodic space it calls `f(i, j, shift)`, also for edges from a point to its own image: as in
  /// one process, the image of point j by `shift`, a `Periodic_shift_2`, is a neighbor of point i,
  /// both as they were given last.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_edge([&](Index i, Index j) { call(f, points().id(i), i, j); });
  }

  /// calls `f(ids)` for each finite face whose smallest id this rank owns: over all ranks, once for
  /// each face. `ids` is an array of three ids, counterclockwise. In periodic space it calls
  /// `f(ids, shifts)`: the images of these points by these shifts are the corners; the first id is
  /// the smallest one, and its shift is (0, 0).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_face([&](Index i, Index j, Index k) {
      const std::array<Id, 3> ids{points().id(i), points().id(j), points().id(k)};
      const std::array<typename Space::Shift, 3> shifts{shift_between(i, i), shift_between(i, j),
                                                        shift_between(i, k)};
      Space::show(shifts, [&](const auto&... their) { f(ids, their...); });
    });
  }

  /// calls `f(k, j)`, in periodic space `f(k, j, shift)`, for each point that this rank owns, the
  /// `k`-th of `owned_ids()`, and the id `j` of each of its neighbors. An edge from a point to its
  /// own image is met at both of its ends. Of points that coincide, the one with the smallest id
  /// has neighbors.
  template <class Function>
  void for_each_neighbor(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_neighbor([&](size_type k, Index i, Index j) { call(f, k, i, j); });
  }

  /// calls `f(k, j)`, in periodic space `f(k, j, shift)`, for each point that this rank owns, the
  /// `k`-th of `owned_ids()`, that coincides with other points, or their images by `shift`. `j` is
  /// the smallest id of these points; but if the `k`-th point has that id itself, `f` is called for
  /// the id `j` of each of the others.
  template <class Function>
  void for_each_duplicate(const Function& f) const
  {
    const Floating_point floating_point;
    m_core.for_each_duplicate([&](size_type k, Index i, Index j) { call(f, k, i, j); });
  }

  /// the triangulation of the points that this rank holds: of their images in periodic space, as
  /// points of the plane. Its faces at the points that the rank owns, whose ids there `held_id()`
  /// returns, are faces of the triangulation of all points; its other faces may not be. So
  /// properties of these points, such as `Voronoi_cell_measures_2`, are those in the triangulation
  /// of all points. Where four points or more are on a circle its diagonals may differ from those
  /// of `for_each_edge()`.
  const Held_triangulation& held_triangulation() const { return points().dt(); }
  /// the id of a held point in `held_triangulation()`, until the next call that changes points. In
  /// periodic space it is that of the image that this rank owns, or else of a ghost.
  /// \pre `holds(id)`
  size_type held_id(Id id) const { return points().place(id); }

  /// whether every face with an owned corner is proved. False only if an exception ended a call.
  bool is_certified() const { return m_core.is_certified(); }

  /// @}
  /// \name Checkpoints
  /// Positions and ids of all points, and the cell of periodic space, in one file, which all ranks
  /// write and read together, by `MPI_File`. Edges and faces depend on nothing else, so a run
  /// continues with the same edges and faces, on any number of ranks.
  ///
  /// A file is written under its name with `.unfinished` appended, and renamed when it is complete.
  /// So the last checkpoint stays readable, whenever a rank dies. The path, and whether there are
  /// data and how large those of a point are, must be the same on all ranks, and all ranks must see
  /// the same file; that is checked before, and Checkpoint_error_2 on all ranks says what is wrong
  /// on which rank.
  /// @{

  /// writes the points and the cell as they are triangulated. Collective. Cost: 24 bytes a point.
  /// \throws Checkpoint_error_2 on all ranks if writing fails, if a rank does not see the file that
  /// rank 0 has created, as on a disk of its own, or if there is a directory, a device or a pipe of
  /// this name; a file that had this name before is still there.
  void write_checkpoint(const std::string& path)
  {
    const Floating_point floating_point;
    m_core.write_checkpoint(path);
  }

  /// writes the points and the cell, with the user's data of each point that this rank owns, in the
  /// order of `owned_ids()`.
  /// \tparam T trivially copyable.
  /// \throws Point_count_error_2 if there are not as many data as owned points, or
  /// Distributed_input_error_2 on the other ranks; else as above.
  template <class T>
  void write_checkpoint(const std::string& path, const std::vector<T>& data)
  {
    const Floating_point floating_point;
    m_core.write_checkpoint(path, data);
  }

  /// replaces points and cell by those in a file, and distributes points as the constructor does.
  /// Collective. \throws Checkpoint_error_2 on all ranks if one of them cannot read such a file, if
  /// it is no intact checkpoint of this class, or contains what no program has written, such as a
  /// coordinate that is not finite or an id twice, or if it has data of the user; nothing has
  /// changed then on any rank. \post `is_certified()`
  void read_checkpoint(const std::string& path)
  {
    const Floating_point floating_point;
    m_core.read_checkpoint(path);
  }

  /// replaces points and cell by those in a file, and `data` by the user's data of the points that
  /// this rank owns then. Collective. \throws Checkpoint_error_2 as above, and if the data in the
  /// file have not the size of T.
  template <class T>
  void read_checkpoint(const std::string& path, std::vector<T>& data)
  {
    const Floating_point floating_point;
    m_core.read_checkpoint(path, data);
  }

  /// @}
  /// \name Checking
  /// @{

  /// proves all faces with an owned corner anew, without relying on the zones that ranks have
  /// agreed on. Collective, with the same result on all ranks. Cost: a pass over all faces, and
  /// questions as after a distribution.
  bool certify()
  {
    const Floating_point floating_point;
    return m_core.certify();
  }

  /// whether the data of all ranks are valid: their triangulations are valid, both sides of each
  /// link between ranks hold the same points, no id is owned twice, and vertices, edges and faces
  /// of all ranks satisfy Euler's formula. Collective, with the same result on all ranks. Cost:
  /// linear, and as many bytes as ghosts and ids have.
  bool is_valid()
  {
    const Floating_point floating_point;
    return m_core.is_valid();
  }

  /// @}
  /// \name Figures
  /// Of this rank, since construction.
  /// @{

  /// the number of calls in which any rank had questions.
  size_type number_of_asking_frames() const { return m_core.proof().number_of_asking_frames(); }
  /// the number of rounds in which ranks have asked each other.
  size_type number_of_rounds() const { return m_core.proof().number_of_rounds(); }
  /// messages that this rank has sent to others, collective calls of MPI not counted.
  size_type number_of_messages() const { return m_core.ranks().exchange().sent_messages(); }
  /// bytes that this rank has sent to others, collective calls of MPI not counted.
  size_type number_of_bytes() const { return m_core.ranks().exchange().sent_bytes(); }
  /// bytes that all ranks have told all others, in collective calls: such as zones, boxes, inserted
  /// and removed ids and, in the plane, outlines.
  size_type number_of_gathered_bytes() const { return m_core.ranks().gathered_bytes(); }
  /// seconds in which this rank has sent, received or waited.
  double communication_seconds() const { return m_core.ranks().exchange().seconds(); }
  /// seconds in which this rank has done other things while messages that it had sent were, for all
  /// it knew, under way.
  double overlapped_seconds() const { return m_core.ranks().exchange().overlapped_seconds(); }

  /// @}

protected:
  /// \cond
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;

  explicit Distributed_triangulation_base_2(MPI_Comm communicator)
    : m_core(communicator)
  {
  }

  Core m_core;
  /// \endcond

private:
  friend Dynamic_Delaunay_triangulations_2::internal::Distributed_access_2;
  using Index = Dynamic_Delaunay_triangulations_2::Index;

  const typename Core::Points& points() const { return m_core.points(); }

  // Calls f with the id at place j, and in periodic space with the shift from that at place i.
  template <class Function, class First>
  void call(const Function& f, First first, Index i, Index j) const
  {
    Space::show(shift_between(i, j),
                [&](const auto&... shift) { f(first, points().id(j), shift...); });
  }

  // The shift of the image at place j after both are moved to have that at i where it was given.
  typename Space::Shift shift_between(Index i, Index j) const
  {
    return Space::difference(points().shift(j), points().shift(i));
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_TRIANGULATION_BASE_2_H
