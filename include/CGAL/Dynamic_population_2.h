// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_POPULATION_2_H
#define CGAL_DYNAMIC_POPULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_triangulation_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/User_id_table.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdint>
#include <istream>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What a population takes from its triangulation. A periodic one has no vertex handles.
template <class Dynamic, class = void>
struct Population_traits_2
{
  struct Vertex_handle
  {
  };
  static constexpr std::string_view checkpoint_subject = "periodic Dynamic_population_2";
};
template <class Dynamic>
struct Population_traits_2<Dynamic, std::void_t<typename Dynamic::Vertex_handle>>
{
  using Vertex_handle = typename Dynamic::Vertex_handle;
  static constexpr std::string_view checkpoint_subject = "Dynamic_population_2";
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Maintains the Delaunay triangulation of a population that changes while it moves, as in tracking
data and crowds. Every frame lists the points that exist, by ids that the user chooses. Points with
new ids are inserted, points whose ids are missing are removed, and the others move.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2`, or a
  `Dynamic_periodic_Delaunay_triangulation_2`, which has no vertex handles.
\tparam UserId any integer type.
*/
template <class Dynamic, class UserId = std::int64_t>
class Dynamic_population_2
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
  using Access = Dynamic_Delaunay_triangulations_2::internal::Triangulation_access_2;
  using Traits = Dynamic_Delaunay_triangulations_2::internal::Population_traits_2<Dynamic>;

public:
  /// \name Types
  /// @{

  /// the triangulation.
  using Triangulation = Dynamic;
  /// an id of the user.
  using User_id = UserId;
  /// a point.
  using Point = typename Dynamic::Point;
  /// a vertex of the CGAL triangulation.
  using Vertex_handle = typename Traits::Vertex_handle;
  /// the type of counts, and of the ids in `triangulation()`.
  using size_type = std::size_t;

  /// @}
  /// \name Creation
  /// @{

  /// creates a population without points, with a triangulation constructed by default. A periodic
  /// triangulation has no default constructor.
  Dynamic_population_2()
    : Dynamic_population_2(Dynamic())
  {
  }

  /// creates a population without points.
  /// \param triangulation has the classifier, repair, engines, policy and visitor to be used, and
  ///   the cell of periodic space.
  /// \pre `triangulation` has no points.
  explicit Dynamic_population_2(Dynamic triangulation)
    : m_triangulation(std::move(triangulation))
  {
    CGAL_precondition(m_triangulation.number_of_points() == 0);
  }

  /// @}
  /// \name Change
  /// If one of these functions throws an exception that its documentation names, or if the range
  /// throws, nothing changes. After any other exception each point is either inserted (or removed)
  /// completely or not at all, and the triangulation may be uncertified; `mend()` certifies it
  /// again, and so does the next update if the classifier is exact.
  /// @{

  /// takes a whole frame: inserts the points whose ids are new, removes those whose ids are
  /// missing, and moves the others. The order of the range does not matter.
  ///
  /// This is one update, as by `Dynamic_Delaunay_triangulation_2::update()`: one classification,
  /// one repair, one certificate, and at most one rebuild. Missing points are removed before the
  /// repair, new ones are inserted after it. Cost: that of the update, and of looking up the ids,
  /// which is almost free for points that follow each other as in the last frame; for inserted and
  /// removed points, proportional to their number. Never much more than a rebuild.
  ///
  /// \tparam IdMap, PointMap models of `ReadablePropertyMap` from the range's values to `User_id`
  /// and
  ///   to `Point`; by default the values are pairs of both.
  /// \throws Repeated_id_error_2 if an id is given more than once.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite, or
  /// Coordinate_range_error_2 if it is too large, or in periodic space Periodic_range_error_2 if a
  /// point is too many cells from the origin; the `id()` of these is the place in the range,
  /// counted from 0. \throws Point_limit_error_2 if there are more points than 32 bits allow.
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>, class = If_map<IdMap>>
  Update_report_2 update(InputIterator first, InputIterator beyond, IdMap id_map = IdMap(),
                         PointMap point_map = PointMap())
  {
    return update_to(first, beyond, id_map, point_map);
  }

  /// takes a whole frame from a range with `begin()` and `end()`.
  template <class Range, class IdMap = First_of<If_range<Range>>,
            class PointMap = Second_of<If_range<Range>>, class = If_range<Range>,
            class = If_map<IdMap>>
  Update_report_2 update(const Range& range, IdMap id_map = IdMap(),
                         PointMap point_map = PointMap())
  {
    return update_to(std::begin(range), std::end(range), id_map, point_map);
  }

  /// takes a whole frame of a `Dynamic_periodic_Delaunay_triangulation_2`, in a cell that has
  /// changed. \throws Periodic_cell_error_2 as
  /// `Dynamic_periodic_Delaunay_triangulation_2::update()` does, before the range is read.
  template <class InputIterator, class IdMap, class PointMap>
  Update_report_2 update(InputIterator first, InputIterator beyond, IdMap id_map,
                         PointMap point_map, const Periodic_cell_2& cell)
  {
    return update_to(first, beyond, id_map, point_map, cell);
  }

  /// takes a whole frame of pairs of ids and points, in a cell that has changed.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond, const Periodic_cell_2& cell)
  {
    return update_to(first, beyond, First_of<InputIterator>(), Second_of<InputIterator>(), cell);
  }

  /// takes a whole frame, in a cell that has changed, from a range with `begin()` and `end()`.
  template <class Range, class IdMap, class PointMap, class = If_range<Range>>
  Update_report_2 update(const Range& range, IdMap id_map, PointMap point_map,
                         const Periodic_cell_2& cell)
  {
    return update_to(std::begin(range), std::end(range), id_map, point_map, cell);
  }

  /// takes a whole frame of pairs of ids and points, in a cell that has changed, from a range.
  template <class Range, class = If_range<Range>>
  Update_report_2 update(const Range& range, const Periodic_cell_2& cell)
  {
    return update(std::begin(range), std::end(range), cell);
  }

  /// adds a point. \throws Repeated_id_error_2 if a point has this id already.
  /// \throws Non_finite_coordinate_error_2, Coordinate_range_error_2 or Periodic_range_error_2 if
  /// `p` is not allowed; their `id()` is 0. \throws Point_limit_error_2 as `update()`.
  Update_report_2 insert(UserId user_id, const Point& p)
  {
    const std::pair<UserId, Point> newcomer(user_id, p);
    return insert(&newcomer, &newcomer + 1);
  }

  /// adds the points of a range, as `Dynamic_Delaunay_triangulation_2::insert()` does.
  /// The parameters are those of `update()`.
  /// \throws Repeated_id_error_2 if a point has one of these ids already, or if an id is given more
  /// than once. \throws Non_finite_coordinate_error_2, Coordinate_range_error_2,
  /// Periodic_range_error_2 or Point_limit_error_2 as `update()`.
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>>
  Update_report_2 insert(InputIterator first, InputIterator beyond, IdMap id_map = IdMap(),
                         PointMap point_map = PointMap())
  {
    Dynamic_Delaunay_triangulations_2::internal::length_within_limit(first, beyond, size());
    forget_newcomers();
    read_each(first, beyond, id_map, point_map, Access::position_check(m_triangulation),
              [this](UserId user_id, const Point& p) {
                if (has(user_id))
                  throw Repeated_id_error_2(user_id);
                note_newcomer(user_id, p, no_id);
              });
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(m_newcomers);
    return insert_newcomers();
  }

  /// adds the points of a range with `begin()` and `end()`.
  template <class Range, class IdMap = First_of<If_range<Range>>,
            class PointMap = Second_of<If_range<Range>>, class = If_range<Range>>
  Update_report_2 insert(const Range& range, IdMap id_map = IdMap(),
                         PointMap point_map = PointMap())
  {
    return insert(std::begin(range), std::end(range), id_map, point_map);
  }

  /// removes a point. \throws Unknown_user_id_error_2 if no point has this id.
  Update_report_2 remove(UserId user_id) { return remove(&user_id, &user_id + 1); }

  /// removes the points with these ids, as `Dynamic_Delaunay_triangulation_2::remove()` does.
  /// \tparam InputIterator its values are of the type `User_id`.
  /// \throws Unknown_user_id_error_2 if an id belongs to no point.
  /// \throws Repeated_id_error_2 if an id is given more than once.
  template <class InputIterator>
  Update_report_2 remove(InputIterator first, InputIterator beyond)
  {
    std::vector<UserId> user_ids;
    std::vector<size_type> gone;
    for (; first != beyond; ++first) {
      user_ids.push_back(UserId(*first));
      gone.push_back(id(user_ids.back()));
    }
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(user_ids);
    m_new_ids.clear();
    const At_exit record{[&] { forget_gone(gone); }};
    return m_triangulation.remove(gone.begin(), gone.end());
  }

  /// removes the points whose ids are in a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_2 remove(const Range& user_ids)
  {
    return remove(std::begin(user_ids), std::end(user_ids));
  }

  /// moves a point. \throws Unknown_user_id_error_2 if no point has this id.
  /// \throws Non_finite_coordinate_error_2, Coordinate_range_error_2 or Periodic_range_error_2 as
  /// `insert()`.
  Update_report_2 move(UserId user_id, const Point& p)
  {
    const std::pair<UserId, Point> mover(user_id, p);
    return move(&mover, &mover + 1);
  }

  /// moves some of the points, as `Dynamic_Delaunay_triangulation_2::move()` does.
  /// The parameters are those of `update()`.
  /// \throws Unknown_user_id_error_2 if an id belongs to no point.
  /// \throws Repeated_id_error_2 if an id is given more than once.
  /// \throws Non_finite_coordinate_error_2, Coordinate_range_error_2 or Periodic_range_error_2 if a
  /// position is not allowed; the `id()` of these errors is the place in the range, counted from 0.
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>>
  Update_report_2 move(InputIterator first, InputIterator beyond, IdMap id_map = IdMap(),
                       PointMap point_map = PointMap())
  {
    std::vector<UserId> user_ids;
    std::vector<std::pair<size_type, Point>> movers;
    read_each(first, beyond, id_map, point_map, Access::position_check(m_triangulation),
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
  Update_report_2 move(const Range& range, IdMap id_map = IdMap(), PointMap point_map = PointMap())
  {
    return move(std::begin(range), std::end(range), id_map, point_map);
  }

  /// calls `Dynamic_Delaunay_triangulation_2::mend()`.
  Update_report_2 mend() { return m_triangulation.mend(); }
  /// calls `Dynamic_Delaunay_triangulation_2::certify()`.
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
  size_type size() const { return m_ids.size(); }
  /// whether a point has this id.
  bool has(UserId user_id) const { return m_ids.find(user_id) != no_id; }

  /// the id of a point in `triangulation()`. It stays the same until the point is removed.
  /// \throws Unknown_user_id_error_2 if no point has this id.
  size_type id(UserId user_id) const
  {
    const size_type found = m_ids.find(user_id);
    if (found == no_id)
      throw Unknown_user_id_error_2(user_id);
    return found;
  }

  /// the user's id of the point `id` of `triangulation()`. \pre that point exists.
  UserId user_id(size_type id) const { return m_user_ids[id]; }
  /// the vertex of a point. \throws Unknown_user_id_error_2 if no point has this id.
  Vertex_handle vertex(UserId user_id) const { return m_triangulation.vertex(id(user_id)); }
  /// the position of a point. \throws Unknown_user_id_error_2 if no point has this id.
  decltype(auto) point(UserId user_id) const { return m_triangulation.point(id(user_id)); }
  /// the user's id of the point at a finite vertex. If several points share the vertex, this is the
  /// id of their representative, the one that was there first.
  UserId user_id(Vertex_handle vertex) const { return m_user_ids[m_triangulation.id(vertex)]; }

  /// @}
  /// \name Checkpoints
  /// @{

  /// writes the triangulation, as its own `write_checkpoint()` does, and the user's ids.
  /// \throws Checkpoint_error_2 as that function does.
  void write_checkpoint(std::ostream& out) const
  {
    Access::write_checkpoint(m_triangulation, out, Traits::checkpoint_subject, [this](auto& file) {
      file.line("user_ids", size());
      for (size_type id = 0; id < m_triangulation.number_of_ids(); ++id)
        if (m_triangulation.has_id(id))
          file.line(id, Widest(m_user_ids[id]));
    });
  }

  /// replaces this population by one from a file, as the triangulation's `read_checkpoint()` does.
  /// \throws Checkpoint_error_2 if the file is refused, also if a user's id does not fit into
  /// `User_id`. Whatever is thrown, nothing changes, unless the visitor throws it while it is told
  /// what changes.
  void read_checkpoint(std::istream& in)
  {
    Table ids;
    std::vector<UserId> user_ids;
    const auto read_more = [&](auto& file, const auto& ids_read) {
      read_user_ids(file, ids_read, ids, user_ids);
    };
    const auto exchange_more = [&] {
      m_ids.swap(ids);
      m_user_ids.swap(user_ids);
    };
    Access::read_checkpoint(m_triangulation, in, Traits::checkpoint_subject, read_more,
                            exchange_more);
  }

  /// writes a checkpoint. Where `write_checkpoint()` would throw `Checkpoint_error_2`, the stream
  /// fails.
  friend std::ostream& operator<<(std::ostream& out, const Dynamic_population_2& population)
  {
    return Dynamic_Delaunay_triangulations_2::internal::write_to_stream(out, population);
  }

  /// skips white space, then reads a checkpoint. Where `read_checkpoint()` would throw
  /// `Checkpoint_error_2`, the stream fails, and the population does not change.
  friend std::istream& operator>>(std::istream& in, Dynamic_population_2& population)
  {
    return Dynamic_Delaunay_triangulations_2::internal::read_from_stream(in, population);
  }

  /// @}

private:
  template <class InputIterator, class IdMap, class PointMap, class... Cell>
  Update_report_2 update_to(InputIterator first, InputIterator beyond, const IdMap& id_map,
                            const PointMap& point_map, const Cell&... cell)
  {
    read(first, beyond, id_map, point_map, Access::position_check(m_triangulation, cell...));
    find_missing();
    m_new_ids.clear();
    const At_exit record{[this] {
      forget_gone(m_missing);
      record_newcomers();
    }};
    expect_newcomers();
    return Access::update_population(m_triangulation, m_positions, m_missing, m_new_points,
                                     m_new_ids, cell...);
  }

  using Table = Dynamic_Delaunay_triangulations_2::internal::User_id_table<UserId>;

  static constexpr size_type no_id = Table::no_id;
  static constexpr size_type ahead = 8; // how many ids earlier the table is prefetched

  // The type as which files hold user ids, since a `User_id` may be of a character type or bool.
  using Widest = std::conditional_t<std::is_signed_v<UserId>, long long, unsigned long long>;

  // Runs `work` at the end of the scope, even after an exception.
  template <class Work>
  struct At_exit
  {
    Work work;
    ~At_exit() { work(); }
  };
  template <class Work>
  At_exit(Work) -> At_exit<Work>;

  // Reads one user id for each point.
  template <class File, class Ids>
  static void read_user_ids(File& file, const Ids& ids_read, Table& ids,
                            std::vector<UserId>& user_ids)
  {
    using Limits = std::numeric_limits<UserId>;
    const size_type points = ids_read.number_of_points();
    file.number_entry("user_ids", points, points);
    user_ids.resize(ids_read.number_of_ids());
    ids.reserve_extra(points);
    for (size_type id = 0; id < user_ids.size(); ++id) {
      if (!ids_read.is_taken(id))
        continue;
      file.next_line();
      file.number("the id", id, id);
      const Widest user_id =
          file.number("the user's id", Widest((Limits::min)()), Widest((Limits::max)()));
      file.end_line();
      user_ids[id] = UserId(user_id);
      if (ids.find(user_ids[id]) != no_id)
        file.refuse("the user's id " + std::to_string(user_id) + " is there more than once");
      ids.set(user_ids[id], id);
    }
  }

  // Separates the points of a frame into existing and new ones. Nothing else changes.
  template <class InputIterator, class IdMap, class PointMap, class Check>
  void read(InputIterator first, InputIterator beyond, const IdMap& id_map,
            const PointMap& point_map, const Check& check)
  {
    Dynamic_Delaunay_triangulations_2::internal::length_within_limit(first, beyond, 0);
    forget_newcomers();
    m_is_there.assign(m_triangulation.number_of_ids(), false);
    m_positions.resize(m_triangulation.number_of_ids());
    m_next_of.resize(m_triangulation.number_of_ids(), no_id);
    m_last = no_id;
    read_each(first, beyond, id_map, point_map, check, [this](UserId user_id, const Point& p) {
      const size_type id = find(user_id);
      if (id == no_id)
        return note_newcomer(user_id, p, m_last);
      if (m_is_there[id])
        throw Repeated_id_error_2(user_id);
      m_is_there[id] = true;
      m_positions[id] = p;
      note_order(id);
    });
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(m_newcomers);
  }

  // Calls f(user_id, p) for each value of a range, unless `check` throws because p is not allowed.
  template <class InputIterator, class IdMap, class PointMap, class Check, class Function>
  static void read_each(InputIterator first, InputIterator beyond, const IdMap& id_map,
                        const PointMap& point_map, const Check& check, const Function& f)
  {
    for (size_type place = 0; first != beyond; ++first, ++place) {
      auto&& value = *first;
      const auto user_id = UserId(get(id_map, value));
      const Point p = get(point_map, value);
      check(p, place);
      f(user_id, p);
    }
  }

  // Returns the id of the point with a user id, or no_id. Most points follow the same point as in
  // the last frame, directly or almost: these are found without a look-up in the table.
  size_type find(UserId user_id) const
  {
    constexpr int soon = 3;
    size_type expected = m_last;
    for (int i = 0; i < soon && expected < m_next_of.size(); ++i) {
      expected = m_next_of[expected];
      if (expected < m_user_ids.size() && m_user_ids[expected] == user_id &&
          m_triangulation.has_id(expected))
        return expected;
    }
    return m_ids.find(user_id);
  }

  void note_order(size_type id)
  {
    if (m_last != no_id)
      m_next_of[m_last] = id;
    m_last = id;
  }

  // Lists the missing points. Every id needs some position: these get their last ones.
  void find_missing()
  {
    m_missing.clear();
    for (size_type id = 0; id < m_is_there.size(); ++id)
      if (!m_is_there[id] && m_triangulation.has_id(id)) {
        m_missing.push_back(id);
        m_positions[id] = m_triangulation.point(id);
      }
  }

  // Removes the user ids of points that are gone. `missing` must be ascending if new points were
  // inserted meanwhile.
  void forget_gone(const std::vector<size_type>& missing)
  {
    auto next_new = m_new_ids.begin(); // a new point may have the id of a removed one
    for (size_type i = 0; i < missing.size(); ++i) {
      if (i + ahead < missing.size())
        m_ids.prefetch(m_user_ids[missing[i + ahead]]);
      while (next_new != m_new_ids.end() && *next_new < missing[i])
        ++next_new;
      const bool is_new = next_new != m_new_ids.end() && *next_new == missing[i];
      if (is_new || !m_triangulation.has_id(missing[i]))
        m_ids.erase(m_user_ids[missing[i]]);
    }
  }

  // Allocates memory for all new points before the first one is inserted.
  void expect_newcomers()
  {
    m_new_ids.clear();
    m_new_ids.reserve(m_newcomers.size());
    m_user_ids.resize(m_triangulation.number_of_ids() + m_newcomers.size());
    m_next_of.resize(m_user_ids.size(), no_id);
    m_ids.reserve_extra(m_newcomers.size());
  }

  Update_report_2 insert_newcomers()
  {
    const At_exit record{[this] { record_newcomers(); }};
    expect_newcomers();
    return m_triangulation.insert(m_new_points.begin(), m_new_points.end(),
                                  std::back_inserter(m_new_ids));
  }

  // Records the new points that were inserted: all, unless memory ran out. Goes from the last to
  // the first, so that m_next_of links points that follow the same one in the order of the frame.
  void record_newcomers()
  {
    for (size_type i = m_new_ids.size(); i-- > 0;) {
      const size_type id = m_new_ids[i], last = m_newcomers_follow[i];
      if (i >= ahead)
        m_ids.prefetch(m_newcomers[i - ahead]);
      if (!m_triangulation.has_id(id))
        continue;
      m_ids.set(m_newcomers[i], id);
      m_user_ids[id] = m_newcomers[i];
      m_next_of[id] = last == no_id ? no_id : std::exchange(m_next_of[last], id);
    }
  }

  void note_newcomer(UserId user_id, const Point& p, size_type last)
  {
    m_newcomers.push_back(user_id);
    m_newcomers_follow.push_back(last);
    m_new_points.push_back(p);
  }

  void forget_newcomers()
  {
    m_newcomers.clear();
    m_newcomers_follow.clear();
    m_new_points.clear();
  }

  Dynamic m_triangulation;
  Table m_ids;
  std::vector<UserId> m_user_ids; // of each id

  // about the frame that is being read:
  std::vector<size_type> m_next_of; // the next id, in this frame or else in the last
  size_type m_last = no_id;
  std::vector<bool> m_is_there;   // by id: whether the frame has it
  std::vector<Point> m_positions; // of each id
  std::vector<UserId> m_newcomers;
  std::vector<size_type> m_newcomers_follow; // the last existing point before each newcomer
  std::vector<Point> m_new_points;
  std::vector<size_type> m_new_ids; // ascending
  std::vector<size_type> m_missing; // ascending
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_POPULATION_2_H
