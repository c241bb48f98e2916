// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_POPULATION_SUBJECT_H
#define RANDOM_OPERATIONS_POPULATION_SUBJECT_H

#include "Checked_subject.h"

#include <CGAL/Dynamic_population_2.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace random_operations {

// A population, whose points the user names.
template <class Maker, class Name>
class Population_subject : public Checked_subject<Maker>
{
  using Base = Checked_subject<Maker>;
  using typename Base::Point;
  using Population = CGAL::Dynamic_population_2<typename Base::Dynamic, Name>;
  using Named_points = std::vector<std::pair<Name, Point>>;

public:
  explicit Population_subject(const Maker& maker)
    : Base(maker)
    , m_population(maker.empty())
  {
  }

  Population& population() { return m_population; }

  // Negative names wrap around to large ones where names are unsigned.
  Key_range names() const override
  {
    using Limits = std::numeric_limits<Name>;
    if constexpr (sizeof(Name) < sizeof(Key)) {
      return {(Limits::min)(), (Limits::max)()};
    } else {
      constexpr Key most = (std::numeric_limits<std::int32_t>::max)();
      return {-most, most};
    }
  }

  Answer answer(const Call& call) override
  {
    switch (call.operation) {
    case Operation::START:
      m_population = Population(this->maker().empty());
      this->forget_vertices();
      update(named_points(call.points));
      return {};
    case Operation::INSERT:
    case Operation::INSERT_RANGE:
    case Operation::REMOVE:
    case Operation::REMOVE_RANGE:
      return {change(call)};
    case Operation::MOVE: {
      const Named_points moves = named_points(call.points);
      return {m_population.move(moves.begin(), moves.end())};
    }
    case Operation::UPDATE:
      return {update(named_points(call.points))};
    case Operation::MEND:
      return {m_population.mend()};
    case Operation::CERTIFY:
      return {{}, {}, m_population.certify()};
    case Operation::HAND_OVER: {
      Population other = std::move(m_population);
      m_population = std::move(other);
      return {};
    }
    default:
      return {{}, {}, Base::is_refused([&] { misuse(call.misuse, named_points(call.points)); })};
    }
  }

  void check(const Model& points) override
  {
    require(m_population.size() == points.size(), Fault::LOST, "names are missing");
    Base::check(points);
  }

protected:
  const typename Base::Dynamic& dynamic() const override { return m_population.triangulation(); }

  std::size_t id(Key key) const override
  {
    require(m_population.has(name(key)), Fault::LOST, "a name is lost");
    const std::size_t id = m_population.id(name(key));
    require(m_population.user_id(id) == name(key), Fault::LOST, "a point has another's name");
    return id;
  }

private:
  static Name name(Key key) { return static_cast<Name>(key); }

  Named_points named_points(const Entries& entries) const
  {
    Named_points points;
    for (const auto& [key, place] : entries) {
      points.emplace_back(name(key), this->point(place));
    }
    return points;
  }

  // One by one.
  CGAL::Update_report_2 change(const Call& call)
  {
    CGAL::Update_report_2 report;
    for (const auto& [key, place] : call.points) {
      report += is_insertion(call.operation) ? m_population.insert(name(key), this->point(place))
                                             : m_population.remove(name(key));
    }
    report.certified = this->is_certified();
    return report;
  }

  // Points that stay keep their ids; new ones get the smallest that are free after all removals.
  CGAL::Update_report_2 update(const Named_points& points)
  {
    std::map<Name, std::size_t> ids;
    std::set<std::size_t> taken;
    for (const auto& [name, point] : points) {
      if (m_population.has(name)) {
        taken.insert(ids[name] = m_population.id(name));
      }
    }
    const auto report = m_population.update(points.begin(), points.end());
    std::size_t free_id = 0;
    for (const auto& [name, point] : points) {
      if (ids.count(name) == 0) {
        while (!taken.insert(free_id).second) {
          ++free_id;
        }
        ids[name] = free_id;
      }
      require(m_population.id(name) == ids[name], Fault::LOST, "a point has another id");
    }
    return report;
  }

  void misuse(Misuse way, Named_points entries)
  {
    switch (way) {
    case Misuse::WRONG_COUNT: // any count is right: no point is there but twice
    case Misuse::REPEATED_ID:
      entries.emplace_back(Name(1), Point(0, 0));
      entries.emplace_back(Name(1), Point(0, 1));
      update(entries);
      return;
    case Misuse::UNKNOWN_ID:
      m_population.remove(unknown_name());
      return;
    default:
      entries.emplace_back(Name(1), Base::broken_point(way));
      update(entries);
    }
  }

  Name unknown_name() const
  {
    Name name = 0;
    while (m_population.has(name)) {
      ++name;
    }
    return name;
  }

  Population m_population;
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_POPULATION_SUBJECT_H
