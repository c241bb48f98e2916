// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_POPULATION_FRAME_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_POPULATION_FRAME_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/User_id_table.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Runs `work` at the end of the scope, even after an exception.
template <class Work>
struct At_exit
{
  Work work;
  ~At_exit() { work(); }
};
template <class Work>
At_exit(Work) -> At_exit<Work>;

// Which ids of a triangulation the points of a population have, in any space, and what a frame
// changes: who stays, with positions by ids, who is missing, and who is new. `dt` is always the
// triangulation.
template <class UserId, class Point>
class Population_frame
{
  using Table = User_id_table<UserId>;

public:
  static constexpr std::size_t no_id = Table::no_id;

  std::size_t size() const { return m_ids.size(); }
  bool has(UserId user_id) const { return m_ids.find(user_id) != no_id; }
  // Throws if there is no such point.
  std::size_t id(UserId user_id) const
  {
    const std::size_t found = m_ids.find(user_id);
    if (found == no_id)
      throw Unknown_user_id_error_2(user_id);
    return found;
  }
  UserId user_id(std::size_t id) const { return m_user_ids[id]; }

  const std::vector<Point>& positions() const { return m_positions; }   // of each id
  const std::vector<std::size_t>& missing() const { return m_missing; } // ascending
  const std::vector<Point>& new_points() const { return m_new_points; }
  std::vector<std::size_t>& new_ids() { return m_new_ids; } // ascending, once they are known

  // READING ---------------------------------------------------------------------------------------

  // Separates the points of a frame into existing and new ones, and lists missing ones. The
  // population does not change.
  template <class InputIterator, class IdMap, class PointMap, class Check, class Dynamic>
  void read(InputIterator first, InputIterator beyond, const IdMap& id_map,
            const PointMap& point_map, const Check& check, const Dynamic& dt)
  {
    forget_newcomers();
    m_is_there.assign(dt.number_of_ids(), false);
    m_positions.resize(dt.number_of_ids());
    m_next_of.resize(dt.number_of_ids(), no_id);
    m_last = no_id;
    read_each(first, beyond, id_map, point_map, check, [&](UserId user_id, const Point& p) {
      const std::size_t id = find(user_id, dt);
      if (id == no_id)
        return note_newcomer(user_id, p, m_last);
      if (m_is_there[id])
        throw Repeated_id_error_2(user_id);
      m_is_there[id] = true;
      m_positions[id] = p;
      note_order(id);
    });
    check_distinct(m_newcomers);
    find_missing(dt);
  }

  // Reads points of which all have to be new.
  template <class InputIterator, class IdMap, class PointMap, class Check>
  void read_newcomers(InputIterator first, InputIterator beyond, const IdMap& id_map,
                      const PointMap& point_map, const Check& check)
  {
    forget_newcomers();
    read_each(first, beyond, id_map, point_map, check, [this](UserId user_id, const Point& p) {
      if (has(user_id))
        throw Repeated_id_error_2(user_id);
      note_newcomer(user_id, p, no_id);
    });
    check_distinct(m_newcomers);
  }

  // Calls f(user_id, p) for each value of a range, unless `check` throws because p is not allowed.
  template <class InputIterator, class IdMap, class PointMap, class Check, class Function>
  static void read_each(InputIterator first, InputIterator beyond, const IdMap& id_map,
                        const PointMap& point_map, const Check& check, const Function& f)
  {
    for (std::size_t place = 0; first != beyond; ++first, ++place) {
      auto&& value = *first;
      const auto user_id = UserId(get(id_map, value));
      const Point p = get(point_map, value);
      check(p, place);
      f(user_id, p);
    }
  }

  // TAKING OVER -----------------------------------------------------------------------------------

  // To be called before points are removed or inserted: says that no new point has an id yet, and
  // allocates memory for all of them, so that what follows throws nothing.
  template <class Dynamic>
  void expect(std::size_t newcomers, const Dynamic& dt)
  {
    m_new_ids.clear();
    m_new_ids.reserve(newcomers);
    m_user_ids.resize(dt.number_of_ids() + newcomers);
    m_next_of.resize(m_user_ids.size(), no_id);
    m_ids.reserve_extra(newcomers);
  }

  // Removes the user ids of points that are gone. `missing` must be ascending if new points were
  // inserted meanwhile.
  template <class Dynamic>
  void forget_gone(const std::vector<std::size_t>& missing, const Dynamic& dt)
  {
    auto next_new = m_new_ids.begin(); // a new point may have the id of a removed one
    for (std::size_t i = 0; i < missing.size(); ++i) {
      if (i + ahead < missing.size())
        m_ids.prefetch(m_user_ids[missing[i + ahead]]);
      while (next_new != m_new_ids.end() && *next_new < missing[i])
        ++next_new;
      const bool is_new = next_new != m_new_ids.end() && *next_new == missing[i];
      if (is_new || !dt.has_id(missing[i]))
        m_ids.erase(m_user_ids[missing[i]]);
    }
  }

  // Records the new points that were inserted: all, unless memory ran out. Goes from the last to
  // the first, so that m_next_of links points that follow the same one in the order of the frame.
  template <class Dynamic>
  void record_newcomers(const Dynamic& dt)
  {
    for (std::size_t i = m_new_ids.size(); i-- > 0;) {
      const std::size_t id = m_new_ids[i], last = m_newcomers_follow[i];
      if (i >= ahead)
        m_ids.prefetch(m_newcomers[i - ahead]);
      if (!dt.has_id(id))
        continue;
      m_ids.set(m_newcomers[i], id);
      m_user_ids[id] = m_newcomers[i];
      m_next_of[id] = last == no_id ? no_id : std::exchange(m_next_of[last], id);
    }
  }

  // FILES -----------------------------------------------------------------------------------------

  // Writes one user id for each point.
  template <class File, class Dynamic>
  void write_file(File& file, const Dynamic& dt) const
  {
    file.line("user_ids", size());
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
      if (dt.has_id(id))
        file.line(id, Widest(m_user_ids[id]));
  }

  // Reads user ids for these ids into a new frame.
  template <class File, class Ids>
  void read_file(File& file, const Ids& ids_read)
  {
    using Limits = std::numeric_limits<UserId>;
    const std::size_t points = ids_read.number_of_points();
    file.number_entry("user_ids", points, points);
    m_user_ids.resize(ids_read.number_of_ids());
    m_ids.reserve_extra(points);
    for (std::size_t id = 0; id < m_user_ids.size(); ++id) {
      if (!ids_read.is_taken(id))
        continue;
      file.next_line();
      file.number("the id", id, id);
      const Widest user_id =
          file.number("the user's id", Widest((Limits::min)()), Widest((Limits::max)()));
      file.end_line();
      m_user_ids[id] = UserId(user_id);
      if (m_ids.find(m_user_ids[id]) != no_id)
        file.refuse("the user's id " + std::to_string(user_id) + " is there more than once");
      m_ids.set(m_user_ids[id], id);
    }
  }

  // Takes over the user ids that another frame has read.
  void take_over(Population_frame& other) noexcept
  {
    m_ids.swap(other.m_ids);
    m_user_ids.swap(other.m_user_ids);
  }

private:
  static constexpr std::size_t ahead = 8; // how many ids earlier the table is prefetched

  // The type as which files hold user ids, since a `User_id` may be of a character type or bool.
  using Widest = std::conditional_t<std::is_signed_v<UserId>, long long, unsigned long long>;

  // Returns the id of the point with a user id, or no_id. Most points follow the same point as in
  // the last frame, directly or almost: these are found without a look-up in the table.
  template <class Dynamic>
  std::size_t find(UserId user_id, const Dynamic& dt) const
  {
    constexpr int soon = 3;
    std::size_t expected = m_last;
    for (int i = 0; i < soon && expected < m_next_of.size(); ++i) {
      expected = m_next_of[expected];
      if (expected < m_user_ids.size() && m_user_ids[expected] == user_id && dt.has_id(expected))
        return expected;
    }
    return m_ids.find(user_id);
  }

  void note_order(std::size_t id)
  {
    if (m_last != no_id)
      m_next_of[m_last] = id;
    m_last = id;
  }

  // Lists the missing points. Every id needs some position: these get their last ones.
  template <class Dynamic>
  void find_missing(const Dynamic& dt)
  {
    m_missing.clear();
    for (std::size_t id = 0; id < m_is_there.size(); ++id)
      if (!m_is_there[id] && dt.has_id(id)) {
        m_missing.push_back(id);
        m_positions[id] = dt.point(id);
      }
  }

  void note_newcomer(UserId user_id, const Point& p, std::size_t last)
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

  Table m_ids;
  std::vector<UserId> m_user_ids; // of each id

  // about the frame that is being read:
  std::vector<std::size_t> m_next_of; // the next id, in this frame or else in the last
  std::size_t m_last = no_id;
  std::vector<bool> m_is_there;   // by id: whether the frame has it
  std::vector<Point> m_positions; // of each id
  std::vector<UserId> m_newcomers;
  std::vector<std::size_t> m_newcomers_follow; // the last existing point before each newcomer
  std::vector<Point> m_new_points;
  std::vector<std::size_t> m_new_ids; // ascending
  std::vector<std::size_t> m_missing; // ascending
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_POPULATION_FRAME_H
