// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_POPULATION_BASE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_POPULATION_BASE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Population_frame.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Triangulation_access.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>

#include <cstddef>
#include <istream>
#include <iterator>
#include <ostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_2::internal {

// The cell of a periodic triangulation, or a type of which there is no object.
template <class Dynamic, class = void>
class Cell_of_triangulation
{
public:
  class type
  {
    type() = delete;
  };
};
template <class Dynamic>
class Cell_of_triangulation<Dynamic, std::void_t<decltype(std::declval<const Dynamic&>().cell())>>
{
public:
  using type = std::decay_t<decltype(std::declval<const Dynamic&>().cell())>;
};

} // namespace Dynamic_Delaunay_triangulations_2::internal

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What `Dynamic_population_2` and `Dynamic_population_3` have in common: frames of points that come
and go, by ids of the user. Programs use it as a part of these classes alone.

\tparam Derived the class of populations.
\tparam Dynamic the class of triangulations.
\tparam UserId any integer type.
*/
template <class Derived, class Dynamic, class UserId>
class Dynamic_population_base
{
  static_assert(std::is_integral_v<UserId>, "the ids of a population are integers");
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;
  template <class Iterator>
  using First_of = Dynamic_Delaunay_triangulations_2::internal::First_of<Iterator>;
  template <class Iterator>
  using Second_of = Dynamic_Delaunay_triangulations_2::internal::Second_of<Iterator>;
  template <class Map>
  using If_map = Dynamic_Delaunay_triangulations_2::internal::If_map<Map>;
  using Access = Dynamic_Delaunay_triangulations_2::internal::Triangulation_access;

public:
  /// \name Types
  /// @{

  /// the triangulation.
  using Triangulation = Dynamic;
  /// an id of the user.
  using User_id = UserId;
  /// a point.
  using Point = typename Dynamic::Point;
  /// the type of counts, and of the ids in `triangulation()`.
  using size_type = std::size_t;
  /// what a call returns that changes points.
  using Update_report = typename Dynamic::Update_report;
  /// the cell of a periodic triangulation.
  using Periodic_cell =
      typename Dynamic_Delaunay_triangulations_2::internal::Cell_of_triangulation<Dynamic>::type;

  /// @}
  /// \name Creation
  /// @{

  /// creates a population without points, with a triangulation constructed by default. A periodic
  /// triangulation has no default constructor.
  template <class D = Dynamic, class = std::enable_if_t<std::is_default_constructible_v<D>>>
  Dynamic_population_base()
    : Dynamic_population_base(Dynamic())
  {
  }

  /// creates a population without points.
  /// \param triangulation has the settings to be used, and the cell of periodic space.
  /// \pre `triangulation` has no points.
  explicit Dynamic_population_base(Dynamic triangulation)
    : m_triangulation(std::move(triangulation))
  {
    CGAL_precondition(m_triangulation.number_of_points() == 0);
  }

  /// @}
  /// \name Change
  /// If one of these functions throws an exception that its documentation names, or if the range
  /// throws, nothing changes. After any other exception each point is either inserted (or removed)
  /// completely or not at all, and the triangulation may be uncertified; `mend()` certifies it
  /// again, and so does the next update, in the plane if the classifier is exact. The exceptions
  /// for coordinates are those of the triangulation's functions.
  /// @{

  /// takes a whole frame: inserts the points whose ids are new, removes those whose ids are
  /// missing, and moves the others. The order of the range does not matter.
  ///
  /// This is one update, as by the triangulation's `update()`: one repair, one certificate, and at
  /// most one rebuild. Missing points are removed before the repair, new ones are inserted after
  /// it. Cost: that of the update, and of looking up the ids, which is almost free for points that
  /// follow each other as in the last frame; for inserted and removed points, proportional to their
  /// number. Never much more than a rebuild.
  ///
  /// \tparam IdMap, PointMap models of `ReadablePropertyMap` from the range's values to `User_id`
  ///   and to `Point`; by default the values are pairs of both.
  /// \throws Repeated_id_error_2 if an id is given more than once.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite,
  ///   Coordinate_range_error_2 if it is too large, or in periodic space Periodic_range_error_2 if
  ///   a point is too many cells from the origin; in space the errors of the same names that end
  ///   with
  ///   `_3`. The `id()` of these is the place in the range, counted from 0.
  /// \throws Point_limit_error_2 if there are more points than the triangulation can have.
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>, class = If_map<IdMap>>
  Update_report update(InputIterator first, InputIterator beyond, IdMap id_map = IdMap(),
                       PointMap point_map = PointMap())
  {
    return update_to(first, beyond, id_map, point_map);
  }

  /// takes a whole frame from a range with `begin()` and `end()`.
  template <class Range, class IdMap = First_of<If_range<Range>>,
            class PointMap = Second_of<If_range<Range>>, class = If_range<Range>,
            class = If_map<IdMap>>
  Update_report update(const Range& range, IdMap id_map = IdMap(), PointMap point_map = PointMap())
  {
    return update_to(std::begin(range), std::end(range), id_map, point_map);
  }

  /// takes a whole frame of a periodic triangulation, in a cell that has changed. Throws what the
  /// triangulation's `update()` with a cell throws, before the range is read.
  template <class InputIterator, class IdMap, class PointMap>
  Update_report update(InputIterator first, InputIterator beyond, IdMap id_map, PointMap point_map,
                       const Periodic_cell& cell)
  {
    return update_to(first, beyond, id_map, point_map, cell);
  }

  /// takes a whole frame of pairs of ids and points, in a cell that has changed.
  template <class InputIterator>
  Update_report update(InputIterator first, InputIterator beyond, const Periodic_cell& cell)
  {
    return update_to(first, beyond, First_of<InputIterator>(), Second_of<InputIterator>(), cell);
  }

  /// takes a whole frame, in a cell that has changed, from a range with `begin()` and `end()`.
  template <class Range, class IdMap, class PointMap, class = If_range<Range>>
  Update_report update(const Range& range, IdMap id_map, PointMap point_map,
                       const Periodic_cell& cell)
  {
    return update_to(std::begin(range), std::end(range), id_map, point_map, cell);
  }

  /// takes a whole frame of pairs of ids and points, in a cell that has changed, from a range.
  template <class Range, class = If_range<Range>>
  Update_report update(const Range& range, const Periodic_cell& cell)
  {
    return update(std::begin(range), std::end(range), cell);
  }

  /// adds a point. \throws Repeated_id_error_2 if a point has this id already. For the other
  /// errors of `update()`, the place in the range is 0.
  Update_report insert(UserId user_id, const Point& p)
  {
    const std::pair<UserId, Point> newcomer(user_id, p);
    return insert(&newcomer, &newcomer + 1);
  }

  /// adds the points of a range, as the triangulation's `insert()` does. The parameters and errors
  /// are those of `update()`; \throws Repeated_id_error_2 also if a point has one of these ids
  /// already.
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>>
  Update_report insert(InputIterator first, InputIterator beyond, IdMap id_map = IdMap(),
                       PointMap point_map = PointMap())
  {
    check_length(first, beyond, size());
    m_frame.read_newcomers(first, beyond, id_map, point_map,
                           Access::position_check(m_triangulation));
    m_frame.expect(m_frame.new_points().size(), m_triangulation);
    const Dynamic_Delaunay_triangulations_2::internal::At_exit record{
        [this] { m_frame.record_newcomers(m_triangulation); }};
    return m_triangulation.insert(m_frame.new_points().begin(), m_frame.new_points().end(),
                                  std::back_inserter(m_frame.new_ids()));
  }

  /// adds the points of a range with `begin()` and `end()`.
  template <class Range, class IdMap = First_of<If_range<Range>>,
            class PointMap = Second_of<If_range<Range>>, class = If_range<Range>>
  Update_report insert(const Range& range, IdMap id_map = IdMap(), PointMap point_map = PointMap())
  {
    return insert(std::begin(range), std::end(range), id_map, point_map);
  }

  /// removes a point. \throws Unknown_user_id_error_2 if no point has this id.
  Update_report remove(UserId user_id) { return remove(&user_id, &user_id + 1); }

  /// removes the points with these ids, as the triangulation's `remove()` does.
  /// \tparam InputIterator its values are of the type `User_id`.
  /// \throws Unknown_user_id_error_2 if an id belongs to no point.
  /// \throws Repeated_id_error_2 if an id is given more than once.
  template <class InputIterator>
  Update_report remove(InputIterator first, InputIterator beyond)
  {
    std::vector<UserId> user_ids;
    std::vector<size_type> gone;
    for (; first != beyond; ++first) {
      user_ids.push_back(UserId(*first));
      gone.push_back(id(user_ids.back()));
    }
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(user_ids);
    m_frame.expect(0, m_triangulation);
    const Dynamic_Delaunay_triangulations_2::internal::At_exit record{
        [&] { m_frame.forget_gone(gone, m_triangulation); }};
    return m_triangulation.remove(gone.begin(), gone.end());
  }

  /// removes the points whose ids are in a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report remove(const Range& user_ids)
  {
    return remove(std::begin(user_ids), std::end(user_ids));
  }

  /// moves a point. \throws Unknown_user_id_error_2 if no point has this id. For the other errors
  /// of `update()`, the place in the range is 0.
  Update_report move(UserId user_id, const Point& p)
  {
    const std::pair<UserId, Point> mover(user_id, p);
    return move(&mover, &mover + 1);
  }

  /// moves some of the points, as the triangulation's `move()` does. The parameters and errors are
  /// those of `update()`.
  /// \throws Unknown_user_id_error_2 if an id belongs to no point.
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>>
  Update_report move(InputIterator first, InputIterator beyond, IdMap id_map = IdMap(),
                     PointMap point_map = PointMap())
  {
    std::vector<UserId> user_ids;
    std::vector<std::pair<size_type, Point>> movers;
    Frame::read_each(first, beyond, id_map, point_map, Access::position_check(m_triangulation),
                     [&](UserId user_id, const Point& p) {
                       movers.emplace_back(id(user_id), p);
                       user_ids.push_back(user_id);
                     });
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(user_ids);
    return m_triangulation.move(movers.begin(), movers.end());
  }

  /// moves the points of a range with `begin()` and `end()`.
  template <class Range, class IdMap = First_of<If_range<Range>>,
            class PointMap = Second_of<If_range<Range>>, class = If_range<Range>>
  Update_report move(const Range& range, IdMap id_map = IdMap(), PointMap point_map = PointMap())
  {
    return move(std::begin(range), std::end(range), id_map, point_map);
  }

  /// calls the triangulation's `mend()`.
  Update_report mend() { return m_triangulation.mend(); }
  /// calls the triangulation's `certify()`.
  bool certify() { return m_triangulation.certify(); }

  /// @}
  /// \name Access
  /// @{

  /// the triangulation. Its ids are not those of the user.
  const Dynamic& triangulation() const { return m_triangulation; }
  /// the visitor of the triangulation. An update of the population is one update of the
  /// triangulation.
  const auto& visitor() const { return m_triangulation.visitor(); }
  /// the visitor, in order to read and clear what it has recorded.
  auto& visitor() { return m_triangulation.visitor(); }
  /// the number of points.
  size_type size() const { return m_frame.size(); }
  /// whether a point has this id.
  bool has(UserId user_id) const { return m_frame.has(user_id); }

  /// the id of a point in `triangulation()`. It stays the same until the point is removed.
  /// \throws Unknown_user_id_error_2 if no point has this id.
  size_type id(UserId user_id) const { return m_frame.id(user_id); }

  /// the user's id of the point `id` of `triangulation()`. \pre that point exists.
  UserId user_id(size_type id) const { return m_frame.user_id(id); }
  /// the position of a point. \throws Unknown_user_id_error_2 if no point has this id.
  decltype(auto) point(UserId user_id) const { return m_triangulation.point(id(user_id)); }

  /// @}
  /// \name Checkpoints
  /// @{

  /// writes the triangulation, as its own `write_checkpoint()` does, and the user's ids.
  /// \throws Checkpoint_error_2 as that function does.
  void write_checkpoint(std::ostream& out) const
  {
    Access::write_checkpoint(m_triangulation, out, Derived::checkpoint_subject,
                             [this](auto& file) { m_frame.write_file(file, m_triangulation); });
  }

  /// replaces this population by one from a file, as the triangulation's `read_checkpoint()` does.
  /// \throws Checkpoint_error_2 if the file is refused, also if a user's id does not fit into
  /// `User_id`. Whatever is thrown, nothing changes, unless the visitor throws it while it is told
  /// what changes.
  void read_checkpoint(std::istream& in)
  {
    Frame frame;
    const auto read_more = [&](auto& file, const auto& ids_read) {
      frame.read_file(file, ids_read);
    };
    const auto exchange_more = [&] { m_frame.take_over(frame); };
    Access::read_checkpoint(m_triangulation, in, Derived::checkpoint_subject, read_more,
                            exchange_more);
  }

  /// writes a checkpoint. Where `write_checkpoint()` would throw `Checkpoint_error_2`, the stream
  /// fails.
  friend std::ostream& operator<<(std::ostream& out, const Derived& population)
  {
    return Dynamic_Delaunay_triangulations_2::internal::write_to_stream(out, population);
  }

  /// skips white space, then reads a checkpoint. Where `read_checkpoint()` would throw
  /// `Checkpoint_error_2`, the stream fails, and the population does not change.
  friend std::istream& operator>>(std::istream& in, Derived& population)
  {
    return Dynamic_Delaunay_triangulations_2::internal::read_from_stream(in, population);
  }

  /// @}

private:
  using Frame = Dynamic_Delaunay_triangulations_2::internal::Population_frame<UserId, Point>;

  // Takes a frame, in another cell if there is one more argument.
  template <class InputIterator, class IdMap, class PointMap, class... Cell>
  Update_report update_to(InputIterator first, InputIterator beyond, const IdMap& id_map,
                          const PointMap& point_map, const Cell&... cell)
  {
    check_length(first, beyond, 0);
    m_frame.read(first, beyond, id_map, point_map, Access::position_check(m_triangulation, cell...),
                 m_triangulation);
    m_frame.expect(m_frame.new_points().size(), m_triangulation);
    const Dynamic_Delaunay_triangulations_2::internal::At_exit record{[this] {
      m_frame.forget_gone(m_frame.missing(), m_triangulation);
      m_frame.record_newcomers(m_triangulation);
    }};
    return Access::update_population(m_triangulation, m_frame.positions(), m_frame.missing(),
                                     m_frame.new_points(), m_frame.new_ids(), cell...);
  }

  // Throws if the triangulation cannot have these points and `others` more, if they can be counted
  // before they are read.
  template <class InputIterator>
  void check_length(const InputIterator& first, const InputIterator& beyond, size_type others) const
  {
    if constexpr (Dynamic_Delaunay_triangulations_2::internal::is_random_access<InputIterator>)
      Access::check_number_of_points(m_triangulation, others + size_type(beyond - first));
  }

  Dynamic m_triangulation;
  Frame m_frame;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_POPULATION_BASE_H
