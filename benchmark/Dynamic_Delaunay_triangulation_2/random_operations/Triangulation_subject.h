// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_TRIANGULATION_SUBJECT_H
#define RANDOM_OPERATIONS_TRIANGULATION_SUBJECT_H

#include "Checked_subject.h"

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace random_operations {

// A triangulation by itself; its points are named by their ids.
template <class Maker>
class Triangulation_subject : public Checked_subject<Maker>
{
  using Base = Checked_subject<Maker>;
  using typename Base::Point;

public:
  explicit Triangulation_subject(const Maker& maker)
    : Base(maker)
    , m_dynamic(maker.empty())
  {
  }

  typename Base::Dynamic& triangulation() { return m_dynamic; }

  Key_range names() const override { return {}; }

  Answer answer(const Call& call) override
  {
    switch (call.operation) {
    case Operation::START:
      start(call.points);
      return {};
    case Operation::INSERT:
      return insert(call.points.front().second);
    case Operation::INSERT_RANGE:
      return insert(call.points);
    case Operation::REMOVE:
      return {m_dynamic.remove(std::size_t(call.points.front().first))};
    case Operation::REMOVE_RANGE:
      return {remove(call.points)};
    case Operation::MOVE:
      return {move(call.points)};
    case Operation::UPDATE: {
      const std::vector<Point> positions = positions_of(call.points);
      return {m_dynamic.update(positions.begin(), positions.end())};
    }
    case Operation::MEND:
      return {m_dynamic.mend()};
    case Operation::CERTIFY:
      return {{}, {}, m_dynamic.certify()};
    case Operation::HAND_OVER: {
      auto other = std::move(m_dynamic);
      m_dynamic = std::move(other);
      return {};
    }
    default:
      return {{}, {}, Base::is_refused([&] { misuse(call.misuse, positions_of(call.points)); })};
    }
  }

protected:
  const typename Base::Dynamic& dynamic() const override { return m_dynamic; }
  std::size_t id(Key key) const override { return static_cast<std::size_t>(key); }

private:
  void start(const Entries& entries)
  {
    const std::vector<Point> all = this->points_of(entries);
    m_dynamic = this->maker().of(all.begin(), all.end());
    this->forget_vertices();
  }

  Answer insert(const Place& place)
  {
    const std::size_t free_id = next_ids(1).front();
    const std::size_t id = m_dynamic.insert(this->point(place));
    require(id == free_id, Fault::LOST, "the new id is not the smallest free one");
    return {{}, {static_cast<Key>(id)}};
  }

  Answer insert(const Entries& entries)
  {
    const std::vector<Point> points = this->points_of(entries);
    const std::vector<std::size_t> free_ids = next_ids(points.size());
    std::vector<std::size_t> ids;
    const auto report = m_dynamic.insert(points.begin(), points.end(), std::back_inserter(ids));
    require(ids == free_ids, Fault::LOST, "the new ids are not the smallest free ones");
    return {report, Keys(ids.begin(), ids.end())};
  }

  CGAL::Update_report_2 remove(const Entries& entries)
  {
    std::vector<std::size_t> ids;
    for (const auto& [key, place] : entries) {
      ids.push_back(static_cast<std::size_t>(key));
    }
    return ids.size() == 1 ? m_dynamic.remove(ids.front())
                           : m_dynamic.remove(ids.begin(), ids.end());
  }

  CGAL::Update_report_2 move(const Entries& moves)
  {
    if (moves.size() == 1) {
      return m_dynamic.move(std::size_t(moves.front().first), this->point(moves.front().second));
    }
    return m_dynamic.move(moves.begin(), moves.end(),
                          CGAL::First_of_pair_property_map<Entries::value_type>(),
                          Point_map{this->maker()});
  }

  struct Point_map
  {
    using key_type = Entries::value_type;
    using value_type = Point;
    using reference = value_type;
    using category = boost::readable_property_map_tag;

    const Maker& maker;

    friend value_type get(const Point_map& map, const key_type& move)
    {
      return map.maker.point(move.second);
    }
  };

  // Positions by ids. Those of free ids must not be read, so they are NaN where kernels have that.
  std::vector<Point> positions_of(const Entries& points) const
  {
    Point nan_point(0, 0);
    if constexpr (Base::has_nan) {
      nan_point = Base::broken_point(Misuse::NAN_COORDINATE);
    }
    std::vector<Point> positions(m_dynamic.number_of_ids(), nan_point);
    for (const auto& [key, place] : points) {
      positions[static_cast<std::size_t>(key)] = this->point(place);
    }
    return positions;
  }

  std::vector<std::size_t> next_ids(std::size_t number) const
  {
    std::vector<std::size_t> ids;
    for (std::size_t id = 0; ids.size() < number; ++id) {
      if (!m_dynamic.has_id(id)) {
        ids.push_back(id);
      }
    }
    return ids;
  }

  void misuse(Misuse way, std::vector<Point> positions)
  {
    std::vector<std::size_t> ids = {m_dynamic.number_of_ids()};
    switch (way) {
    case Misuse::WRONG_COUNT:
      positions.emplace_back(0, 0);
      m_dynamic.update(positions.begin(), positions.end());
      return;
    case Misuse::UNKNOWN_ID:
      m_dynamic.remove(ids.front());
      return;
    case Misuse::REPEATED_ID:
      ids = {0, 0}; // unknown, if there is no such point
      m_dynamic.remove(ids.begin(), ids.end());
      return;
    default:
      positions.assign(2, Base::broken_point(way));
      m_dynamic.insert(positions.begin(), positions.end(), ids.begin());
    }
  }

  typename Base::Dynamic m_dynamic;
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_TRIANGULATION_SUBJECT_H
