// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does anything that can be done with a population, at random. The engine of random operations
// compares the triangulation with what must have come of it after each call.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H

#include "../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Trial.h"
#include "../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Triangulation_subject.h"
#include "oracle.h"

#include <cstddef>
#include <functional>
#include <type_traits>

// Where points may be: on a lattice, where they often meet, or anywhere in the square around it.
struct Playground
{
  int side;
  bool is_lattice;
};

// Makes a triangulation as a test wants it.
template <class Triangulation>
struct Test_maker
{
  using Dynamic = Triangulation;
  using Point = typename Dynamic::Point;

  std::function<Dynamic()> empty;

  Point point(const random_operations::Place& place) const { return Point(place.x, place.y); }

  template <class Iterator>
  Dynamic of(Iterator first, Iterator beyond) const
  {
    Dynamic dt = empty();
    for (; first != beyond; ++first)
      dt.insert(*first);
    return dt;
  }
};

template <class Dynamic>
class Population_player
{
public:
  Population_player(
      const Playground& ground, unsigned seed, std::size_t max_points = 80,
      const std::function<Dynamic()>& empty = [] { return Dynamic(); })
    : m_subject(Test_maker<Dynamic>{empty})
    , m_surroundings{field_of(ground), max_points,
                     !std::is_same_v<typename Dynamic::Geom_traits, Epick>, true}
    , m_decisions(seed)
    , m_trial(family_of(ground), m_surroundings, m_subject, m_decisions, m_counts)
  {
  }

  Dynamic& triangulation() { return m_subject.triangulation(); }

  // Both throw if the triangulation is not what it should be.
  void start() { m_trial.start(); }
  void play() { m_trial.step(); }

private:
  static random_operations::Field field_of(const Playground& ground)
  {
    random_operations::Field field;
    field.extent = ground.side - (ground.is_lattice ? 1 : 0);
    return field;
  }

  static const random_operations::Family& family_of(const Playground& ground)
  {
    using namespace random_operations;
    static const Family lattice =
        family("lattice", 1, {10, 10, 10, 10, 40, 20}, "grid grid grid grid grid at_another",
               "grid_step grid_step disturb gather fresh rest",
               "fresh fresh fresh grid_step gather onto_others trade");
    static const Family anywhere =
        family("anywhere", 1, {10, 10, 10, 10, 40, 20}, "square square square square at_another",
               "step step disturb part fresh rest",
               "fresh fresh fresh step gather part onto_others trade");
    return ground.is_lattice ? lattice : anywhere;
  }

  random_operations::Triangulation_subject<Test_maker<Dynamic>> m_subject;
  random_operations::Surroundings m_surroundings;
  random_operations::Random_decisions m_decisions;
  random_operations::Counts m_counts;
  random_operations::Trial m_trial;
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H
