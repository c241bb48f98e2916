// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_checkpoint_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_proof_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Update_report_2.h>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The Delaunay triangulation of moving points of the plane that are spread over the ranks of an MPI
communicator. Each rank owns some points, and holds copies of points of other ranks, its *ghosts*.
Functions that are called *collective* must be called by all ranks.

After construction and after each update every face with a corner that the rank owns is proved to be
one of the triangulation of all points: no point of any rank is strictly inside of its circumcircle,
and all points on that circle are held. Where more than three points are on an empty circle, the
diagonals go to the one with the smallest id, whatever rank asks. So edges and faces depend only on
points and ids, not on how many ranks there are or what they own. The page
\ref DynamicDelaunayTriangulation2Ranks describes the protocol, and proves this.

Each rank owns a stretch of a Hilbert curve through all points. When a rank holds too many points,
compared with what ranks held after the last distribution, `update()`, `insert()` or `remove()`
distributes all of them anew at its end: `number_of_distributions()` then is another one,
`owned_ids()` has other points in another order, and `carry()` brings the user's data along.

Of MPI it uses its own copy of the communicator, `MPI_Allreduce`, `MPI_Allgather(v)`, and
synchronous sends with a barrier that does not block; all calls are made by the thread that calls a
function of this class, so `MPI_THREAD_FUNNELED` is enough. MPI must be initialized before, and
finalized after the object is gone. An error of MPI ends the program, unless the user gave the
communicator another error handler. So does an exception on one rank alone that is not caught:
`mpirun` then ends the other ranks.

\tparam Kernel a CGAL kernel with exact predicates whose points have coordinates of type `double`.

\cgalExample{Dynamic_Delaunay_triangulation_2/ranks/distributed_dam_break.cpp}

\sa `Distributed_neighbor_lists_2`
\sa `Distributed_edge_changes_2`
*/
template <class Kernel>
class Distributed_dynamic_Delaunay_triangulation_2
{
  static_assert(
      Dynamic_Delaunay_triangulations_2::internal::has_double_coordinates<typename Kernel::Point_2>,
      "the coordinates of distributed points must be of type double");

  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Ranks = Dynamic_Delaunay_triangulations_2::internal::Distributed_ranks_2;
  using Points = Dynamic_Delaunay_triangulations_2::internal::Distributed_points_2<Kernel>;
  using Proof = Dynamic_Delaunay_triangulations_2::internal::Distributed_proof_2<Kernel>;
  using Cells = Dynamic_Delaunay_triangulations_2::internal::Distributed_cells_2<Kernel>;
  using Checkpoint = Dynamic_Delaunay_triangulations_2::internal::Distributed_checkpoint_2;
  using Order = Dynamic_Delaunay_triangulations_2::internal::Distributed_order_2;
  using Entry = Dynamic_Delaunay_triangulations_2::internal::Distributed_entry_2;
  using Message = Dynamic_Delaunay_triangulations_2::internal::Message_2;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2;

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
  using Held_triangulation = typename Points::Dynamic;

  /// @}
  /// \name Creation
  /// @{

  /// the load factor of objects that are given none.
  static constexpr double default_load_factor = 1.5;

  /// triangulates the points of all ranks. Collective. Any points may be given by any rank; they
  /// are distributed evenly, unless the load factor is infinite: then each rank owns the points
  /// that it was given, in their order, for as long as `distribute()` is not called.
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
  /// Parameter_error_2 on all ranks if the load factor is less than 1.
  template <class InputIterator>
  Distributed_dynamic_Delaunay_triangulation_2(MPI_Comm communicator, InputIterator first,
                                               InputIterator beyond,
                                               double load_factor = default_load_factor)
    : m_ranks(communicator)
    , m_points(m_ranks)
    , m_proof(m_ranks, m_points)
    , m_load_factor(load_factor)
  {
    const Floating_point floating_point;
    std::vector<Entry> entries;
    m_ranks.agree([&] {
      if (!(load_factor >= 1))
        throw Parameter_error_2("the load factor", load_factor, 1, infinity);
      entries = read(first, beyond);
    });
    refuse_repeated(seen_here(ids_of(entries)));
    reset(std::move(entries));
  }

  /// @}
  /// \name Motion
  /// @{

  /// moves the points that this rank owns to these positions, in the order of `owned_ids()`.
  /// Collective.
  ///
  /// Each rank sends the positions of points that others hold as ghosts, and updates its own
  /// triangulation. If that does not prove all its faces, it asks the ranks that may have points in
  /// their circumcircles; what they answer becomes ghosts, until there are no questions.
  /// \throws Point_count_error_2, Non_finite_coordinate_error_2 or Coordinate_range_error_2, or
  /// Distributed_input_error_2 on the other ranks; nothing has changed then on any rank.
  /// \post `is_certified()`
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    std::vector<Point> next;
    m_ranks.agree([&] {
      const size_type n = number_of_owned_points();
      next.reserve(n);
      for (; first != beyond; ++first) {
        if (next.size() == n)
          throw Point_count_error_2(n, n + 1);
        const Point& p = *first;
        check(p, next.size());
        next.push_back(p);
      }
      if (next.size() != n)
        throw Point_count_error_2(n, next.size());
    });
    m_is_certified = false;
    m_points.move(next);
    return complete(Update_report_2());
  }

  /// @}
  /// \name Population
  /// @{

  /// adds points, which the rank that is given them owns, after those that it owns already.
  /// Collective; a rank may give none.
  ///
  /// Cost: as an update in which the points jump to where they are, and every rank hears of all new
  /// ids. \tparam InputIterator its values are pairs of an `Id` and a `Point`.
  /// \throws Non_finite_coordinate_error_2 or Coordinate_range_error_2 (`id()` is the place in the
  /// range), or Distributed_input_error_2 on the other ranks; Repeated_id_error_2 on all ranks.
  /// Nothing has changed then on any rank.
  /// \post `is_certified()`
  template <class InputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    std::vector<Entry> entries;
    m_ranks.agree([&] { entries = read(first, beyond); });
    check_new(ids_of(entries));
    m_is_certified = false;
    return complete(m_points.insert(entries));
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
    std::vector<Id> given;
    m_ranks.agree([&] { given.assign(first, beyond); });
    const std::vector<Index> own = own_places(given);
    m_is_certified = false;
    return complete(m_points.remove(own));
  }

  /// @}
  /// \name Distribution
  /// @{

  /// makes each rank own a stretch of the Hilbert curve, with about equally many points.
  /// Collective. Cost: as construction.
  void distribute()
  {
    const Floating_point floating_point;
    m_is_certified = false;
    settle(m_order.distribute(m_ranks, owned_entries()));
    ++m_distributions;
  }

  /// how often points were distributed since construction. Where this has changed, owned points
  /// are other ones, in another order.
  size_type number_of_distributions() const { return m_distributions; }

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
    m_ranks.agree([&] {
      if (data.size() != m_order.size_before())
        throw Point_count_error_2(m_order.size_before(), data.size());
    });
    return m_order.carry(m_ranks, data);
  }

  /// @}
  /// \name Access
  /// @{

  /// the ids of the points that this rank owns, in the order of updates.
  std::vector<Id> owned_ids() const
  {
    std::vector<Id> ids;
    for (const Index place : m_points.owned())
      ids.push_back(m_points.id(place));
    return ids;
  }
  /// their positions, in the same order.
  std::vector<Point> owned_points() const
  {
    std::vector<Point> points;
    for (const Index place : m_points.owned())
      points.push_back(m_points.point(place));
    return points;
  }
  /// the number of points that this rank owns.
  size_type number_of_owned_points() const { return m_points.owned().size(); }
  /// the number of points of other ranks that this one holds.
  size_type number_of_ghosts() const { return m_points.number_of_ghosts(); }
  /// whether this rank holds the point, as its own or as a ghost.
  bool holds(Id id) const { return m_points.holds(id); }
  /// the position of a point. \pre `holds(id)`
  const Point& point(Id id) const { return m_points.point(m_points.place(id)); }

  /// the triangulation of the points that this rank holds. Its faces with an owned corner are those
  /// of all points; the others may not be. So what it tells about owned points, such as
  /// `Voronoi_cell_measures_2`, is true for all points. Where four points or more are on a circle
  /// its diagonals may be others than those of `for_each_edge()`.
  const Held_triangulation& held_triangulation() const { return m_points.dt(); }
  /// the id of a held point in `held_triangulation()`, until the next call that changes points.
  /// \pre `holds(id)`
  size_type held_id(Id id) const { return m_points.place(id); }

  /// whether every face with an owned corner is proved. False only if an exception ended a call.
  bool is_certified() const { return m_is_certified; }

  /// calls `f(i, j)` for each finite edge whose smaller id, `i`, this rank owns: over all ranks,
  /// once for each edge. Of points that coincide, the one with the smallest id has the edges.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    const Floating_point floating_point;
    Cells(m_points).for_each_edge([&](Index i, Index j) {
      if (m_points.id(j) < m_points.id(i))
        std::swap(i, j);
      if (m_points.is_owned(i))
        f(m_points.id(i), m_points.id(j));
    });
  }

  /// calls `f(ids)` for each finite face whose smallest id this rank owns: over all ranks, once for
  /// each face. `ids` is an array of three ids, counterclockwise.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    const Floating_point floating_point;
    Cells(m_points).for_each_face([&](Index i, Index j, Index k) {
      if (m_points.is_owned(i))
        f(std::array<Id, 3>{m_points.id(i), m_points.id(j), m_points.id(k)});
    });
  }

  /// calls `f(k, j)` for each point that this rank owns, the `k`-th of `owned_ids()`, and the id
  /// `j` of each of its neighbors. Of points that coincide, the one with the smallest id has
  /// neighbors.
  template <class Function>
  void for_each_neighbor(const Function& f) const
  {
    const Floating_point floating_point;
    const std::vector<Index> order = m_points.order();
    Cells(m_points).for_each_edge([&](Index i, Index j) {
      if (m_points.is_owned(i))
        f(size_type(order[i]), m_points.id(j));
      if (m_points.is_owned(j))
        f(size_type(order[j]), m_points.id(i));
    });
  }

  /// calls `f(k, j)` for each point that this rank owns, the `k`-th of `owned_ids()`, that
  /// coincides with one of a smaller id, `j` being the smallest; and for the one with the smallest
  /// id, if this rank owns it, with the ids `j` of each of the others.
  template <class Function>
  void for_each_duplicate(const Function& f) const
  {
    const Cells cells(m_points);
    const std::vector<Index> order = m_points.order();
    m_points.for_each_held([&](Index i) {
      const Index label = cells.label(i);
      if (label != i && m_points.is_owned(i))
        f(size_type(order[i]), m_points.id(label));
      if (label != i && m_points.is_owned(label))
        f(size_type(order[label]), m_points.id(i));
    });
  }

  /// @}
  /// \name Checkpoints
  /// Positions and ids of all points in one file, which all ranks write and read together, by
  /// `MPI_File`. Edges and faces depend on nothing else, so a run continues with the same ones, on
  /// any number of ranks.
  ///
  /// A file is written under its name with `.unfinished` appended, and renamed when it is complete.
  /// So the last checkpoint stays readable, whenever a rank dies.
  /// @{

  /// writes all points. Collective. Cost: 24 bytes a point. \throws Checkpoint_error_2 on all ranks
  /// if that is impossible; what had the name before is still there.
  void write_checkpoint(const std::string& path) { write_checkpoint(path, nullptr, 0); }

  /// the same, with the user's data of each point that this rank owns, in the order of
  /// `owned_ids()`. \tparam T trivially copyable. \throws Point_count_error_2 if there are not as
  /// many as owned points, or Distributed_input_error_2 on the other ranks.
  template <class T>
  void write_checkpoint(const std::string& path, const std::vector<T>& data)
  {
    static_assert(std::is_trivially_copyable_v<T>, "only plain data can be written");
    m_ranks.agree([&] {
      if (data.size() != number_of_owned_points())
        throw Point_count_error_2(number_of_owned_points(), data.size());
    });
    write_checkpoint(path, reinterpret_cast<const char*>(data.data()), sizeof(T));
  }

  /// replaces all points by those in a file, and distributes them as the constructor does.
  /// Collective. \throws Checkpoint_error_2 on all ranks if there is no such file, or if it is not
  /// as it was written; nothing has changed then on any rank. \post `is_certified()`
  void read_checkpoint(const std::string& path)
  {
    std::vector<char> data;
    read_checkpoint(path, data, 0);
  }

  /// the same, and replaces `data` by the user's data of the points that this rank owns.
  template <class T>
  void read_checkpoint(const std::string& path, std::vector<T>& data)
  {
    static_assert(std::is_trivially_copyable_v<T>, "only plain data can be read");
    std::vector<char> bytes;
    read_checkpoint(path, bytes, sizeof(T));
    std::vector<T> read(bytes.size() / sizeof(T));
    if (!read.empty())
      std::memcpy(read.data(), bytes.data(), bytes.size());
    data = m_load_factor < infinity ? m_order.carry(m_ranks, read) : read;
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
    m_proof.run(false);
    const bool is_proved = m_points.certify();
    m_is_certified = !m_ranks.is_any(!is_proved);
    return m_is_certified;
  }

  /// whether what all ranks hold is valid: their triangulations are, both sides of each link
  /// between ranks hold the same points, no id is owned twice, and vertices, edges and faces of all
  /// ranks satisfy Euler's formula. Collective, with the same result on all ranks. Cost: linear,
  /// and as many bytes as ghosts and ids have.
  bool is_valid()
  {
    const Floating_point floating_point;
    std::vector<Id> ids = seen_here(owned_ids());
    std::sort(ids.begin(), ids.end());
    bool is_valid = std::adjacent_find(ids.begin(), ids.end()) == ids.end();
    is_valid = m_points.links_are_valid() && is_valid;
    is_valid = m_points.dt().is_valid() && is_valid;
    std::uint64_t vertices = number_of_owned_points(), edges = 0, faces = 0;
    for_each_duplicate(
        [&](size_type k, Id label) { vertices -= label < m_points.id(m_points.owned()[k]); });
    for_each_edge([&](Id, Id) { ++edges; });
    for_each_face([&](const auto&) { ++faces; });
    vertices = m_ranks.sum(vertices);
    edges = m_ranks.sum(edges);
    faces = m_ranks.sum(faces);
    const bool is_a_disk = vertices == 0 ? edges == 0 && faces == 0 : vertices + faces == edges + 1;
    return !m_ranks.is_any(!is_valid) && is_a_disk;
  }

  /// @}
  /// \name Figures
  /// Of this rank, since construction.
  /// @{

  /// how many calls needed questions of any rank.
  size_type number_of_asking_frames() const { return m_proof.number_of_asking_frames(); }
  /// how often ranks have asked each other.
  size_type number_of_rounds() const { return m_proof.number_of_rounds(); }
  /// messages that this rank has sent, collective calls of MPI not counted.
  size_type number_of_messages() const { return m_ranks.exchange().sent_messages(); }
  /// the same in bytes.
  size_type number_of_bytes() const { return m_ranks.exchange().sent_bytes(); }
  /// bytes that all ranks have told all others, in collective calls: outlines, zones and boxes.
  size_type number_of_gathered_bytes() const { return m_ranks.gathered_bytes(); }
  /// seconds in which this rank has sent, received or waited.
  double communication_seconds() const { return m_ranks.exchange().seconds(); }

  /// @}

  /// \cond
  Ranks& ranks() { return m_ranks; }
  /// \endcond

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // So many points more are never too many.
  static constexpr double spare_load = 64;
  // Where points move so fast that ranks ask in every frame, they hold many ghosts whatever they
  // own: it is not tried in vain too often.
  static constexpr int calls_between_distributions = 32;

  static void check(const Point& p, size_type place)
  {
    Dynamic_Delaunay_triangulations_2::internal::checked_position(p, place);
  }

  template <class InputIterator>
  static std::vector<Entry> read(InputIterator first, InputIterator beyond)
  {
    std::vector<Entry> entries;
    for (; first != beyond; ++first) {
      auto&& value = *first;
      const Point& p = value.second;
      check(p, entries.size());
      entries.push_back({Id(value.first), p.x(), p.y()});
    }
    return entries;
  }

  std::vector<Entry> owned_entries() const
  {
    std::vector<Entry> entries;
    for (const Index place : m_points.owned())
      entries.push_back({m_points.id(place), m_points.point(place).x(), m_points.point(place).y()});
    return entries;
  }

  // Owns these points from now on, or, distributed, others.
  void reset(std::vector<Entry> entries)
  {
    m_is_certified = false;
    if (m_load_factor < infinity)
      entries = m_order.distribute(m_ranks, entries);
    settle(entries);
  }

  void settle(const std::vector<Entry>& entries)
  {
    m_points.reset(entries);
    m_proof.forget_zone();
    prove();
    m_settled_load = double(m_ranks.largest(load())[0]);
    m_calls_since_distribution = 0;
  }

  void write_checkpoint(const std::string& path, const char* data, size_type size)
  {
    Checkpoint(m_ranks, path).write(owned_entries(), data, size);
  }

  void read_checkpoint(const std::string& path, std::vector<char>& data, size_type size)
  {
    const Floating_point floating_point;
    std::vector<Entry> entries;
    Checkpoint(m_ranks, path).read(entries, data, size);
    m_ranks.agree([&] {
      for (size_type k = 0; k < entries.size(); ++k)
        check(Point(entries[k].x, entries[k].y), k);
    });
    refuse_repeated(seen_here(ids_of(entries)));
    reset(std::move(entries));
    ++m_distributions;
  }

  static std::vector<Id> ids_of(const std::vector<Entry>& entries)
  {
    std::vector<Id> ids;
    for (const Entry& entry : entries)
      ids.push_back(entry.id);
    return ids;
  }

  // Each id is seen by one rank, which hears of it twice if it is given twice.
  std::vector<Id> seen_here(const std::vector<Id>& ids)
  {
    std::vector<Message> messages = m_ranks.empty_messages();
    for (const Id id : ids)
      messages[std::uint64_t(id) % m_ranks.size()].write(id);
    std::vector<Id> seen;
    for (Message& message : m_ranks.send(std::move(messages)))
      while (!message.is_read())
        seen.push_back(message.template read<Id>());
    return seen;
  }

  // Throws on all ranks if any of them sees an id twice.
  void refuse_repeated(std::vector<Id> ids)
  {
    std::sort(ids.begin(), ids.end());
    const auto repeated = std::adjacent_find(ids.begin(), ids.end());
    const bool is_any = m_ranks.is_any(repeated != ids.end());
    const Id none = (std::numeric_limits<Id>::max)();
    const Id lowest = m_ranks.lowest(repeated != ids.end() ? *repeated : none);
    if (is_any)
      throw Repeated_id_error_2(lowest);
  }

  void check_new(const std::vector<Id>& ids)
  {
    std::vector<Id> all = m_ranks.gather(ids).values;
    const std::vector<Id> given = all;
    for (const Id id : given)
      if (is_own(id))
        all.push_back(id);
    refuse_repeated(std::move(all));
  }

  bool is_own(Id id) const { return holds(id) && m_points.is_owned(m_points.place(id)); }

  // Of all ids that any rank has given, those of this rank's points.
  std::vector<Index> own_places(const std::vector<Id>& given)
  {
    std::vector<Id> all = m_ranks.gather(given).values;
    refuse_repeated(all);
    std::vector<Index> places;
    std::vector<Id> own;
    for (const Id id : all)
      if (is_own(id)) {
        places.push_back(m_points.place(id));
        own.push_back(id);
      }
    std::vector<Id> known = m_ranks.gather(own).values;
    std::sort(known.begin(), known.end());
    std::sort(all.begin(), all.end());
    const auto first = std::mismatch(known.begin(), known.end(), all.begin()).second;
    if (first != all.end())
      throw Unknown_user_id_error_2(*first);
    return places;
  }

  // What follows when own points have changed.
  Update_report_2 complete(Update_report_2 report)
  {
    report += m_points.exchange();
    report += prove();
    balance();
    return report;
  }

  Update_report_2 prove()
  {
    Update_report_2 report = m_proof.run();
    report.certified = m_is_certified = m_points.dt().is_certified();
    return report;
  }

  // Distributes points if a rank has too many of them.
  void balance()
  {
    if (!(m_load_factor < infinity))
      return;
    const std::array<std::uint64_t, 2> most = m_ranks.largest(load());
    const double owned = double(m_ranks.sum(number_of_owned_points())) / double(m_ranks.size());
    const bool holds_many = double(most[0]) > m_load_factor * m_settled_load + spare_load;
    const bool owns_many = double(most[1]) > m_load_factor * owned + spare_load;
    if (owns_many || (holds_many && m_calls_since_distribution >= calls_between_distributions))
      return distribute();
    ++m_calls_since_distribution;
    // ghosts that questions have brought are dropped where they are not needed
    m_settled_load = (std::min)(m_settled_load, double(most[0]));
  }

  // Held points, and own ones.
  std::array<std::uint64_t, 2> load() const
  {
    const std::uint64_t own = number_of_owned_points();
    return {own + number_of_ghosts(), own};
  }

  Ranks m_ranks;
  Points m_points;
  Proof m_proof;
  Order m_order;
  double m_load_factor;
  double m_settled_load = 0; // the most points that a rank holds, at its lowest since distribution
  int m_calls_since_distribution = 0;
  size_type m_distributions = 0;
  bool m_is_certified = false;
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
