// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_POPULATION_SUBJECT_H
#define ROBUSTNESS_POPULATION_SUBJECT_H

#include "Checked_subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace robustness {

// A population, whose points the user names.
template <class Maker, class Name>
class Population_subject : public Checked_subject<Maker>
{
  using Base = Checked_subject<Maker>;
  using typename Base::Point;
  using typename Base::Report;
  using Population = CGAL::Dynamic_population_2<typename Base::Dynamic, Name>;
  using Entries = std::vector<std::pair<Name, Point>>;

public:
  explicit Population_subject(const Maker& maker)
    : Base(maker)
    , m_population(maker.empty())
  {
  }

  // Large ones wrap around where names have no sign.
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

  void start(const Model& points) override
  {
    m_population = Population(this->maker().empty());
    this->forget_vertices();
    update(points);
  }

  Report insert(Keys& keys, const Places& places) override
  {
    Report report;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      report += m_population.insert(name(keys[i]), this->point(places[i]));
    }
    report.certified = this->is_certified();
    return report;
  }

  Key insert(const Place&) override { throw std::logic_error("a point needs a name"); }

  Report remove(const Keys& keys) override
  {
    Report report;
    for (const Key key : keys) {
      report += m_population.remove(name(key));
    }
    report.certified = this->is_certified();
    return report;
  }

  Report move(const Moves& moves) override
  {
    Entries entries;
    for (const auto& [key, place] : moves) {
      entries.emplace_back(name(key), this->point(place));
    }
    return m_population.move(entries.begin(), entries.end());
  }

  Report update(const Model& next) override
  {
    const Entries entries = entries_of(next);
    return m_population.update(entries.begin(), entries.end());
  }

  Report mend() override { return m_population.mend(); }
  bool certify() override { return m_population.certify(); }

  void hand_over() override
  {
    Population other = std::move(m_population);
    m_population = std::move(other);
  }

  bool refuses(Misuse misuse, const Model& points) override
  {
    try {
      misuse_it(misuse, entries_of(points));
      return false;
    } catch (const CGAL::Dynamic_Delaunay_triangulation_error_2&) {
      return true;
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

  Entries entries_of(const Model& points) const
  {
    Entries entries;
    for (const auto& [key, place] : points) {
      entries.emplace_back(name(key), this->point(place));
    }
    return entries;
  }

  void misuse_it(Misuse misuse, Entries entries)
  {
    switch (misuse) {
    case Misuse::WRONG_COUNT: // any count is right: nobody is there, but twice
    case Misuse::REPEATED_ID:
      entries.emplace_back(Name(1), Point(0, 0));
      entries.emplace_back(Name(1), Point(0, 1));
      m_population.update(entries.begin(), entries.end());
      return;
    case Misuse::UNKNOWN_ID:
      m_population.remove(unknown_name());
      return;
    default:
      entries.emplace_back(Name(1), Base::broken_point(misuse));
      m_population.update(entries.begin(), entries.end());
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

} // namespace robustness

#endif // ROBUSTNESS_POPULATION_SUBJECT_H
