// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_PERIODIC_POPULATION_3_H
#define SCENARIO_RUNNER_SPACE_PERIODIC_POPULATION_3_H

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace run {

// Points in periodic space that come and go, by any integers as ids: what Dynamic_population_3 is
// in open space, by the public functions of the triangulation alone.
//
// A call that throws changes nothing. Errors about positions have, as `id()`, the place in the
// range. Where points come or go, an update copies the triangulation before, so that it can be
// taken back, and is two or three calls of the triangulation; its report has the sums. Where less
// than a third of the points stays, all are triangulated anew.
template <class Dynamic>
class Periodic_population_3
{
public:
  using Point = typename Dynamic::Point;
  using User_id = std::int64_t;
  using Report = CGAL::Update_report_3;

  // `triangulation` has no points.
  explicit Periodic_population_3(Dynamic triangulation)
    : m_triangulation(std::move(triangulation))
  {
  }

  // Takes a whole frame: a range of pairs of an id and a position, in any order.
  // \throws CGAL::Repeated_id_error_2 if an id is given more than once; else what the
  // triangulation throws.
  template <class Range>
  Report update(const Range& range, const CGAL::Periodic_cell_3& cell)
  {
    const Frame frame = read(range);
    const std::vector<User_id> gone = missing_in(frame);
    const Frame coming = newcomers_of(frame);
    const std::size_t staying = frame.ids.size() - coming.ids.size();
    if (3 * staying < frame.ids.size() || staying == 0) {
      return replace_all(frame, gone.size(), coming.ids.size(), cell);
    }
    if (gone.empty() && coming.ids.empty()) {
      return move_all(frame, cell);
    }
    return with_copy([&] {
      Report report = gone.empty() ? Report() : remove_known(gone);
      add(report, move_all(frame, cell));
      if (!coming.ids.empty()) {
        add(report, insert_new(coming));
      }
      return report;
    });
  }

  // \throws CGAL::Repeated_id_error_2 if a point has one of the ids already.
  template <class Iterator>
  Report insert(Iterator first, Iterator beyond)
  {
    const Frame coming = read(first, beyond);
    for (const User_id user_id : coming.ids) {
      if (has(user_id)) {
        throw CGAL::Repeated_id_error_2(user_id);
      }
    }
    return with_copy([&] { return insert_new(coming); });
  }
  template <class Range>
  Report insert(const Range& range)
  {
    return insert(std::begin(range), std::end(range));
  }

  // \throws CGAL::Unknown_user_id_error_2 if an id belongs to no point.
  // \throws CGAL::Repeated_id_error_2 if an id is given more than once.
  template <class Iterator>
  Report remove(Iterator first, Iterator beyond)
  {
    std::vector<User_id> gone;
    std::unordered_set<User_id> seen;
    for (; first != beyond; ++first) {
      gone.push_back(*first);
      id(gone.back());
      check_is_new(gone.back(), seen);
    }
    return remove_known(gone);
  }

  // \throws as remove(), and what the triangulation throws.
  template <class Iterator>
  Report move(Iterator first, Iterator beyond)
  {
    const Frame movers = read(first, beyond);
    std::vector<std::pair<std::size_t, Point>> moves;
    for (std::size_t i = 0; i != movers.ids.size(); ++i) {
      moves.emplace_back(id(movers.ids[i]), movers.points[i]);
    }
    return with_places(movers, [&] { return m_triangulation.move(moves.begin(), moves.end()); });
  }

  Report mend() { return m_triangulation.mend(); }
  bool certify() { return m_triangulation.certify(); }

  const Dynamic& triangulation() const { return m_triangulation; }
  bool has(User_id user_id) const { return m_ids.count(user_id) != 0; }
  // The id in the triangulation.
  // \throws CGAL::Unknown_user_id_error_2 if no point has this id.
  std::size_t id(User_id user_id) const
  {
    const auto found = m_ids.find(user_id);
    if (found == m_ids.end()) {
      throw CGAL::Unknown_user_id_error_2(user_id);
    }
    return found->second;
  }
  // Of a point that is there.
  User_id user_id(std::size_t id) const { return m_user_ids[id]; }

private:
  struct Frame
  {
    std::vector<User_id> ids;
    std::vector<Point> points;
    std::vector<std::size_t> places; // in the user's range
  };

  static void check_is_new(User_id user_id, std::unordered_set<User_id>& seen)
  {
    if (!seen.insert(user_id).second) {
      throw CGAL::Repeated_id_error_2(user_id);
    }
  }

  // What all calls check first.
  template <class Iterator>
  static Frame read(Iterator first, Iterator beyond)
  {
    Frame frame;
    std::unordered_set<User_id> seen;
    for (; first != beyond; ++first) {
      const std::pair<User_id, Point> value = *first;
      const auto& [user_id, p] = value;
      check_is_new(user_id, seen);
      if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
        throw CGAL::Non_finite_coordinate_error_3(frame.ids.size(), p.x(), p.y(), p.z());
      }
      frame.places.push_back(frame.ids.size());
      frame.ids.push_back(user_id);
      frame.points.push_back(p);
    }
    return frame;
  }
  template <class Range>
  static Frame read(const Range& range)
  {
    return read(std::begin(range), std::end(range));
  }

  std::vector<User_id> missing_in(const Frame& frame) const
  {
    const std::unordered_set<User_id> there(frame.ids.begin(), frame.ids.end());
    std::vector<User_id> missing;
    for (std::size_t i = 0; i != m_triangulation.number_of_ids(); ++i) {
      if (m_triangulation.has_id(i) && there.count(user_id(i)) == 0) {
        missing.push_back(user_id(i));
      }
    }
    return missing;
  }

  Frame newcomers_of(const Frame& frame) const
  {
    Frame coming;
    for (std::size_t i = 0; i != frame.ids.size(); ++i) {
      if (!has(frame.ids[i])) {
        coming.ids.push_back(frame.ids[i]);
        coming.points.push_back(frame.points[i]);
        coming.places.push_back(i);
      }
    }
    return coming;
  }

  // The points that are there already; at the origin, which no error is about, where no point is.
  Report move_all(const Frame& frame, const CGAL::Periodic_cell_3& cell)
  {
    std::vector<Point> positions(m_triangulation.number_of_ids(), Point(0, 0, 0));
    for (std::size_t i = 0; i != frame.ids.size(); ++i) {
      if (const auto found = m_ids.find(frame.ids[i]); found != m_ids.end()) {
        positions[found->second] = frame.points[i];
      }
    }
    return with_places(frame, [&] { return m_triangulation.update(positions, cell); });
  }

  Report insert_new(const Frame& coming)
  {
    std::vector<std::size_t> given;
    Report report;
    try {
      report = m_triangulation.insert(coming.points.begin(), coming.points.end(),
                                      std::back_inserter(given));
    } catch (const CGAL::Periodic_range_error_3& error) {
      throw_with_place(coming, error);
    }
    m_user_ids.resize(m_triangulation.number_of_ids());
    for (std::size_t i = 0; i != given.size(); ++i) {
      m_ids[coming.ids[i]] = given[i];
      m_user_ids[given[i]] = coming.ids[i];
    }
    return report;
  }

  Report remove_known(const std::vector<User_id>& gone)
  {
    std::vector<std::size_t> ids;
    for (const User_id user_id : gone) {
      ids.push_back(id(user_id));
    }
    const Report report = m_triangulation.remove(ids.begin(), ids.end());
    for (const User_id user_id : gone) {
      m_ids.erase(user_id);
    }
    return report;
  }

  Report replace_all(const Frame& frame, std::size_t removed, std::size_t inserted,
                     const CGAL::Periodic_cell_3& cell)
  {
    Periodic_population_3 fresh{Dynamic(cell)};
    Report report = fresh.insert_new(frame);
    report.removed = removed;
    report.inserted = inserted;
    swap(fresh);
    return report;
  }

  void swap(Periodic_population_3& other) noexcept
  {
    m_triangulation.swap(other.m_triangulation);
    m_ids.swap(other.m_ids);
    m_user_ids.swap(other.m_user_ids);
  }

  // Takes everything back if the work throws.
  template <class Work>
  Report with_copy(const Work& work)
  {
    Periodic_population_3 before = *this;
    try {
      return work();
    } catch (...) {
      swap(before);
      throw;
    }
  }

  // Of an error about a point that is there already.
  template <class Work>
  Report with_places(const Frame& frame, const Work& work) const
  {
    try {
      return work();
    } catch (const CGAL::Periodic_range_error_3& error) {
      throw_with_place(frame, error);
    }
  }

  // The error's id is that of the triangulation, of a point that is there or would be; the place is
  // that of the point with these coordinates.
  [[noreturn]] static void throw_with_place(const Frame& frame,
                                            const CGAL::Periodic_range_error_3& error)
  {
    std::size_t i = 0;
    while (i + 1 < frame.points.size() &&
           frame.points[i] != Point(error.x(), error.y(), error.z())) {
      ++i;
    }
    throw CGAL::Periodic_range_error_3(frame.places[i], error.x(), error.y(), error.z(),
                                       double(1 << 20));
  }

  static void add(Report& sum, const Report& report)
  {
    sum.unproved += report.unproved;
    sum.flips += report.flips;
    sum.held += report.held;
    sum.relocated += report.relocated;
    sum.inserted += report.inserted;
    sum.removed += report.removed;
    sum.merged += report.merged;
    sum.parted += report.parted;
    sum.certified = report.certified;
    if (report.rebuilt()) {
      sum.rebuild_reason = report.rebuild_reason;
    }
  }

  Dynamic m_triangulation;
  std::unordered_map<User_id, std::size_t> m_ids;
  std::vector<User_id> m_user_ids; // by the triangulation's ids
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_PERIODIC_POPULATION_3_H
