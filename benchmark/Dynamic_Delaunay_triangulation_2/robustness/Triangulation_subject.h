// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_TRIANGULATION_SUBJECT_H
#define ROBUSTNESS_TRIANGULATION_SUBJECT_H

#include "Checked_subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace robustness {

// A triangulation by itself; its points are named by their ids.
template <class Maker>
class Triangulation_subject : public Checked_subject<Maker>
{
  using Base = Checked_subject<Maker>;
  using typename Base::Point;
  using typename Base::Report;

public:
  explicit Triangulation_subject(const Maker& maker)
    : Base(maker)
    , m_dynamic(maker.empty())
  {
  }

  Key_range names() const override { return {}; }

  void start(const Model& points) override
  {
    const std::vector<Point> all = this->points_at(places_of(points));
    m_dynamic = this->maker().of(all.begin(), all.end());
    this->forget_vertices();
  }

  Report insert(Keys& keys, const Places& places) override
  {
    const std::vector<Point> points = this->points_at(places);
    const std::vector<std::size_t> free_ids = next_ids(points.size());
    std::vector<std::size_t> ids;
    const Report report = m_dynamic.insert(points.begin(), points.end(), std::back_inserter(ids));
    require(ids == free_ids, Fault::LOST, "the new ids are not the smallest free ones");
    keys.assign(ids.begin(), ids.end());
    return report;
  }

  Key insert(const Place& place) override
  {
    const std::size_t free_id = next_ids(1).front();
    const std::size_t id = m_dynamic.insert(this->point(place));
    require(id == free_id, Fault::LOST, "the new id is not the smallest free one");
    return static_cast<Key>(id);
  }

  Report remove(const Keys& keys) override
  {
    return keys.size() == 1 ? m_dynamic.remove(std::size_t(keys.front()))
                            : m_dynamic.remove(keys.begin(), keys.end());
  }

  Report move(const Moves& moves) override
  {
    if (moves.size() == 1) {
      return m_dynamic.move(std::size_t(moves.front().first), this->point(moves.front().second));
    }
    return m_dynamic.move(moves.begin(), moves.end(),
                          CGAL::First_of_pair_property_map<Moves::value_type>(),
                          Point_map{this->maker()});
  }

  Report update(const Model& next) override
  {
    const std::vector<Point> positions = positions_of(next);
    return m_dynamic.update(positions.begin(), positions.end());
  }

  Report mend() override { return m_dynamic.mend(); }
  bool certify() override { return m_dynamic.certify(); }

  void hand_over() override
  {
    auto other = std::move(m_dynamic);
    m_dynamic = std::move(other);
  }

  bool refuses(Misuse misuse, const Model& points) override
  {
    try {
      misuse_it(misuse, positions_of(points));
      return false;
    } catch (const CGAL::Dynamic_Delaunay_triangulation_error_2&) {
      return true;
    }
  }

protected:
  const typename Base::Dynamic& dynamic() const override { return m_dynamic; }
  std::size_t id(Key key) const override { return static_cast<std::size_t>(key); }

private:
  struct Point_map
  {
    using key_type = Moves::value_type;
    using value_type = Point;
    using reference = value_type;
    using category = boost::readable_property_map_tag;

    const Maker& maker;

    friend value_type get(const Point_map& map, const key_type& move)
    {
      return map.maker.point(move.second);
    }
  };

  // Nobody looks at the positions of free ids, so there is none.
  std::vector<Point> positions_of(const Model& points) const
  {
    Point nowhere(0, 0);
    if constexpr (Base::has_nan) {
      nowhere = Base::broken_point(Misuse::NAN_COORDINATE);
    }
    std::vector<Point> positions(m_dynamic.number_of_ids(), nowhere);
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

  void misuse_it(Misuse misuse, std::vector<Point> positions)
  {
    std::vector<std::size_t> ids = {m_dynamic.number_of_ids()};
    switch (misuse) {
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
      positions.assign(2, Base::broken_point(misuse));
      m_dynamic.insert(positions.begin(), positions.end(), ids.begin());
    }
  }

  typename Base::Dynamic m_dynamic;
};

} // namespace robustness

#endif // ROBUSTNESS_TRIANGULATION_SUBJECT_H
