// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does anything that can be done with a population, at random, and knows what must come of it.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H

#include "oracle.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

// Where points may be: on a lattice, where they often meet, or anywhere in the square around it.
struct Playground
{
  int side;
  bool is_lattice;
};

template <class Dynamic>
class Population_player
{
public:
  using Point = typename Dynamic::Point;

  Population_player(Dynamic& dt, const Playground& ground, unsigned seed)
    : m_dt(dt)
    , m_ground(ground)
    , m_random(seed)
  {
  }

  const Model<Dynamic>& model() const { return m_model; }

  void play()
  {
    switch (random(m_model.empty() ? 2 : 10)) {
    case 0:
      return insert(1);
    case 1:
      return insert(1 + random(6));
    case 2:
      return remove(1);
    case 3:
      return remove(1 + random(6));
    case 4:
      return move(1, true);
    case 5:
      return move(1 + random(4), true);
    case 6:
      return move(1 + random(m_model.size()), random(2) == 0);
    case 7:
      return meet();
    default:
      return update();
    }
  }

  void insert(std::size_t number)
  {
    std::vector<Point> points;
    for (std::size_t i = 0; i < number; ++i)
      points.push_back(place());
    std::vector<std::size_t> ids;
    m_report = m_dt.insert(points.begin(), points.end(), std::back_inserter(ids));
    for (std::size_t i = 0; i < number; ++i)
      ASSERT_TRUE(m_model.emplace(ids[i], points[i]).second) << "id " << ids[i];
    ASSERT_EQ(m_report.inserted, number);
  }

  void remove(std::size_t number)
  {
    const auto ids = some_ids(number);
    m_report = m_dt.remove(ids.begin(), ids.end());
    for (const std::size_t id : ids)
      m_model.erase(id);
    ASSERT_EQ(m_report.removed, ids.size());
  }

  void move(std::size_t number, bool is_far)
  {
    std::vector<std::pair<std::size_t, Point>> movers;
    for (const std::size_t id : some_ids(number)) {
      movers.emplace_back(id, is_far ? place() : near(m_model.at(id)));
      m_model[id] = movers.back().second;
    }
    m_report = m_dt.move(movers.begin(), movers.end());
  }

  // Some points come to one place, by an update.
  void meet()
  {
    const Point p = place();
    for (const std::size_t id : some_ids(1 + random(4)))
      m_model[id] = p;
    update_to_model();
  }

  void update()
  {
    const bool is_far = random(8) == 0;
    for (auto& [id, p] : m_model)
      if (random(3) == 0)
        p = is_far ? place() : near(p);
    update_to_model();
  }

  // The ids of nobody are given what is no place, where the kernel has such.
  void update_to_model()
  {
    std::vector<Point> points(m_dt.number_of_ids(), no_place());
    for (const auto& [id, p] : m_model)
      points[id] = p;
    m_report = m_dt.update(points.begin(), points.end());
  }

  // Of the last call.
  const CGAL::Update_report_2& report() const { return m_report; }

private:
  std::size_t random(std::size_t bound) { return m_random() % bound; }

  double coordinate()
  {
    if (m_ground.is_lattice)
      return double(random(std::size_t(m_ground.side)));
    return std::uniform_real_distribution<double>(0, m_ground.side)(m_random);
  }

  Point place()
  {
    if (random(6) == 0 && !m_model.empty())
      return std::next(m_model.begin(), std::ptrdiff_t(random(m_model.size())))->second;
    const double x = coordinate();
    return Point(x, coordinate());
  }

  static Point no_place()
  {
    if constexpr (std::is_same_v<Point, Epick::Point_2>)
      return Point(std::numeric_limits<double>::quiet_NaN(), 1);
    else
      return Point(1e300, 1);
  }

  Point near(const Point& p)
  {
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    if (m_ground.is_lattice)
      return random(2) == 0 ? Point(x + double(random(3)) - 1, y) : p;
    std::normal_distribution<double> step(0, 0.05);
    const double dx = step(m_random);
    return Point(x + dx, y + step(m_random));
  }

  // In any order.
  std::vector<std::size_t> some_ids(std::size_t number)
  {
    std::vector<std::size_t> ids;
    for (const auto& [id, p] : m_model)
      ids.push_back(id);
    std::shuffle(ids.begin(), ids.end(), m_random);
    ids.resize((std::min)(number, ids.size()));
    return ids;
  }

  Dynamic& m_dt;
  Playground m_ground;
  std::mt19937 m_random;
  Model<Dynamic> m_model;
  CGAL::Update_report_2 m_report;
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H
