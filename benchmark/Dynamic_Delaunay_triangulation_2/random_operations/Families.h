// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_FAMILIES_H
#define RANDOM_OPERATIONS_FAMILIES_H

#include "Decisions.h"
#include "Motions.h"
#include "Named.h"
#include "Place_sources.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace random_operations {

enum class Numbers { ORDINARY, ANY_UNIT, HUGE_OFFSET };

// The relative frequencies of operations.
struct Shares
{
  unsigned insert, insert_range, remove, remove_range, move, update;
};

// A motion of a family, of one in `rarity` of the points that it is given.
struct Family_motion
{
  std::string name;
  const Motion* motion;
  double size;
  std::size_t rarity = 1;
};

// A kind of trials: what they draw from.
struct Family
{
  std::string name;
  unsigned share; // of the trials
  Shares shares;
  std::vector<const Source*> sources;
  std::vector<Family_motion> motions; // of whole frames
  std::vector<Family_motion> moves;   // of a few points
  std::size_t max_points;
  bool has_names; // a population with names of the user's own
  std::vector<Numbers> numbers;
};

inline std::vector<const Source*> sources_in(const std::string& names)
{
  std::vector<const Source*> sources;
  for (const std::string& name : words_in(names)) {
    sources.push_back(&source_named(name));
  }
  return sources;
}

// By names of their own, or by those of motions.
inline std::vector<Family_motion> family_motions_in(const std::string& names)
{
  static const std::vector<Family_motion> own = {{"step", &motion_named("brownian"), 0.03},
                                                 {"leap", &motion_named("brownian"), 1.0},
                                                 {"disturb", &motion_named("brownian"), 0.5, 24},
                                                 {"fly", &motion_named("fresh"), 1.0, 48},
                                                 {"part", &motion_named("part"), 0.3},
                                                 {"rock", &motion_named("rock"), 0.1}};
  std::vector<Family_motion> motions;
  for (const std::string& name : words_in(names)) {
    const auto found = std::find_if(own.begin(), own.end(),
                                    [&](const Family_motion& one) { return one.name == name; });
    motions.push_back(found != own.end() ? *found : Family_motion{name, &motion_named(name), 1.0});
  }
  return motions;
}

inline Family family(const char* name, unsigned share, const Shares& shares,
                     const std::string& sources, const std::string& motions,
                     const std::string& moves, std::size_t max_points = 120, bool has_names = false,
                     const std::vector<Numbers>& numbers = {Numbers::ORDINARY})
{
  return {name,
          share,
          shares,
          sources_in(sources),
          family_motions_in(motions),
          family_motions_in(moves),
          max_points,
          has_names,
          numbers};
}

inline const std::vector<Family>& families()
{
  static const std::string everywhere =
      "square square grid hexagons line circle far_away at_another "
      "square at_another near_another next_double";
  static const std::string all_motions =
      "rest creep step leap disturb disturb fly grid_step fresh skew "
      "glide stretch rock quarter_turn mirror inside_out half_turn "
      "wind_twice onto_line snap trade shuffle next_double gather part "
      "onto_others onto_circle";
  static const std::vector<Numbers> any_numbers = {Numbers::ORDINARY, Numbers::ORDINARY,
                                                   Numbers::ORDINARY, Numbers::ANY_UNIT,
                                                   Numbers::HUGE_OFFSET};
  static const std::vector<Family> families = {
      family("population", 20, {30, 10, 30, 10, 5, 15},
             "square grid near_another far_away square at_another", "rest creep step disturb leap",
             "step fresh"),
      family("tracks", 20, {5, 5, 5, 5, 10, 70}, everywhere,
             "creep step step disturb disturb fly leap fresh grid_step shuffle",
             "step fresh trade onto_others", 120, true),
      family("few_move", 20, {3, 0, 3, 0, 84, 10}, "square grid square hexagons circle at_another",
             "step leap creep disturb fly snap",
             "creep step leap fresh trade onto_others grid_step shuffle "
             "next_double part"),
      family("coincident", 20, {8, 4, 8, 4, 26, 50},
             "at_another at_another square square grid next_double",
             "rest creep step leap glide part part disturb disturb fly gather "
             "onto_others snap mirror shuffle",
             "part part onto_others onto_others gather step fresh trade "
             "next_double"),
      family("dimensions", 20, {20, 6, 20, 6, 18, 30}, "line line line square grid at_another",
             "onto_line onto_line gather fresh step rock snap shuffle stretch "
             "onto_circle quarter_turn part",
             "onto_line fresh step onto_others trade next_double", 12),
      family("cocircular", 20, {12, 3, 12, 3, 30, 40},
             "circle circle circle circle square at_another",
             "rest glide quarter_turn half_turn mirror shuffle onto_circle "
             "stretch next_double creep trade wind_twice",
             "onto_circle onto_circle trade next_double grid_step fresh snap"),
      family("lattices", 20, {10, 4, 10, 4, 32, 40}, "grid grid hexagons hexagons line",
             "rest grid_step glide quarter_turn half_turn mirror skew stretch "
             "shuffle snap fresh creep step disturb fly fly next_double",
             "grid_step grid_step trade snap step next_double fresh part"),
      family("inside_out", 20, {3, 1, 3, 1, 22, 70}, "square square grid circle far_away",
             "mirror inside_out half_turn wind_twice shuffle trade fresh fly "
             "fly rock stretch skew leap rest",
             "mirror inside_out wind_twice shuffle trade fresh half_turn"),
      family("calm_motion", 20, {2, 1, 2, 1, 4, 90}, "square square grid hexagons circle",
             "rest creep creep creep creep creep creep creep creep step "
             "disturb glide next_double",
             "creep step leap"),
      family("any_unit", 20, {10, 3, 10, 3, 24, 50}, everywhere,
             "creep step leap fresh disturb fly stretch glide mirror "
             "next_double snap grid_step shuffle",
             "step leap next_double onto_others fresh", 60, false,
             {Numbers::ANY_UNIT, Numbers::HUGE_OFFSET}),
      family("mixed_scales", 20, {10, 3, 10, 3, 24, 50},
             "any_scale any_scale next_double square at_another",
             "next_double fresh disturb fly stretch mirror rest shuffle "
             "quarter_turn trade",
             "next_double fresh onto_others trade", 60, false,
             {Numbers::ORDINARY, Numbers::ANY_UNIT}),
      family("everything", 20, {10, 4, 10, 4, 32, 40}, everywhere, all_motions, all_motions, 120,
             false, any_numbers),
      family("hundreds", 5, {10, 5, 10, 5, 30, 40},
             "square square square grid hexagons at_another near_another",
             "creep creep step disturb disturb disturb fly fly fly trade part "
             "snap mirror glide leap",
             "creep step leap fresh trade onto_others part", 500),
      // so many points that a few that jump are put in again one by one
      family("jumps", 5, {4, 2, 4, 2, 18, 70}, "square square grid hexagons circle near_another",
             "fly fly fly disturb trade trade rest creep", "fresh trade shuffle onto_others fly",
             500),
      family("jumping_tracks", 5, {2, 2, 2, 2, 12, 80},
             "square square square grid at_another far_away",
             "fly fly disturb trade part rest creep", "fresh trade onto_others part", 400, true)};
  return families;
}

inline const Family& any_family(Decisions& decisions)
{
  std::size_t shares = 0;
  for (const Family& family : families()) {
    shares += family.share;
  }
  std::size_t drawn = decisions.below(shares), i = 0;
  while (drawn >= families()[i].share) {
    drawn -= families()[i++].share;
  }
  return families()[i];
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_FAMILIES_H
