// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does anything that can be done with a triangulation, or with a population whose user names the
// points, at random. The engine of random operations compares it with what must have come of it
// after each call.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H

#include "../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Population_subject.h"
#include "../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Trial.h"
#include "../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Triangulation_subject.h"
#include "oracle.h"

#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>

// Where points may be: on a lattice, where they often meet, or anywhere in the square around it.
struct Playground
{
  int side;
  bool is_lattice;
  bool changes_singly = false; // one point comes, goes or moves at a time
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

// Names points of the type `Name`, if it is one.
template <class Dynamic, class Name = void>
class Population_player
{
  using Maker = Test_maker<Dynamic>;
  static constexpr bool has_names = !std::is_void_v<Name>;

public:
  Population_player(
      const Playground& ground, unsigned seed, std::size_t max_points = 80,
      const std::function<Dynamic()>& empty = [] { return Dynamic(); })
    : m_subject(Maker{empty})
    , m_surroundings{field_of(ground), max_points,
                     !std::is_same_v<typename Dynamic::Geom_traits, Epick>, true,
                     ground.changes_singly}
    , m_decisions(seed)
    , m_trial(family_of(ground), m_surroundings, m_subject, m_decisions, m_counts)
  {
  }

  decltype(auto) triangulation()
  {
    if constexpr (has_names)
      return m_subject.population().triangulation();
    else
      return m_subject.triangulation();
  }
  const random_operations::Counts& counts() const { return m_counts; }

  // Both throw if the triangulation is not what it should be.
  void start() { m_trial.start(); }
  void play() { m_trial.step(); }

  // Starts, and plays so many turns. What a heuristic leaves is mended from time to time.
  void play(int turns, int turns_per_mending = 0)
  {
    ASSERT_NO_THROW(start());
    for (int turn = 1; turn <= turns; ++turn) {
      SCOPED_TRACE(testing::Message() << "turn " << turn);
      ASSERT_NO_THROW(play());
      if (testing::Test::HasFatalFailure())
        return;
      if (turns_per_mending > 0 && turn % turns_per_mending == 0) {
        ASSERT_TRUE(m_subject.answer({random_operations::Operation::MEND}).report->certified);
        ASSERT_NO_FATAL_FAILURE(expect_exact(triangulation(), model_of(triangulation())));
      }
    }
  }

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
    static const auto families = [](const Shares& shares) {
      return std::array<Family, 2>{
          family("anywhere", 1, shares, "square square square square at_another",
                 "step step disturb part fresh rest",
                 "fresh fresh fresh step gather part onto_others trade"),
          family("lattice", 1, shares, "grid grid grid grid grid at_another",
                 "grid_step grid_step disturb gather fresh rest",
                 "fresh fresh fresh grid_step gather onto_others trade")};
    };
    static const auto all = families({10, 10, 10, 10, 40, 20}),
                      single = families({25, 0, 25, 0, 50, 0});
    return (ground.changes_singly ? single : all)[ground.is_lattice];
  }

  std::conditional_t<has_names, random_operations::Population_subject<Maker, Name>,
                     random_operations::Triangulation_subject<Maker>>
      m_subject;
  random_operations::Surroundings m_surroundings;
  random_operations::Random_decisions m_decisions;
  random_operations::Counts m_counts;
  random_operations::Trial m_trial;
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_POPULATION_PLAYER_H
