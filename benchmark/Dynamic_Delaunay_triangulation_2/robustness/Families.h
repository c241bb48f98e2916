// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_FAMILIES_H
#define ROBUSTNESS_FAMILIES_H

#include "Decisions.h"
#include "Motions.h"
#include "Place_sources.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace robustness {

enum class Numbers { ORDINARY, ANY_UNIT, HUGE_OFFSET };

// How often what is done, relative to each other.
struct Shares
{
  unsigned insert, insert_range, remove, remove_range, move, update;
};

// A kind of trials: what they draw from.
struct Family
{
  std::string name;
  unsigned share; // of the trials
  Shares shares;
  std::vector<Source> sources;
  std::vector<Motion> motions; // of whole frames
  std::vector<Motion> moves;   // of a few points
  std::size_t max_points = 120;
  bool has_names = false; // a population with names of the user's own
  std::vector<Numbers> numbers = {Numbers::ORDINARY};
};

inline std::vector<Family> all_families()
{
  using S = Source;
  using M = Motion;
  const std::vector<S> everywhere = {S::SQUARE, S::SQUARE,     S::GRID,         S::HEXAGONS,
                                     S::LINE,   S::CIRCLE,     S::FAR_AWAY,     S::AT_ANOTHER,
                                     S::SQUARE, S::AT_ANOTHER, S::NEAR_ANOTHER, S::NEXT_DOUBLE};
  const std::vector<M> all_motions = {
      M::REST,    M::CREEP,        M::STEP,       M::JUMP,       M::DISTURB,     M::DISTURB,
      M::FLY,     M::GRID_STEP,    M::TELEPORT,   M::SHEAR,      M::TRANSLATE,   M::SCALE,
      M::TURN,    M::QUARTER_TURN, M::MIRROR,     M::INSIDE_OUT, M::HALF_TURN,   M::WIND_TWICE,
      M::FLATTEN, M::SNAP,         M::SWAP,       M::SHUFFLE,    M::NEXT_DOUBLE, M::COLLAPSE,
      M::PART,    M::ONTO_OTHERS,  M::ONTO_CIRCLE};
  const std::vector<Numbers> any_numbers = {Numbers::ORDINARY, Numbers::ORDINARY, Numbers::ORDINARY,
                                            Numbers::ANY_UNIT, Numbers::HUGE_OFFSET};
  std::vector<Family> families;
  families.push_back({"population",
                      20,
                      {30, 10, 30, 10, 5, 15},
                      {S::SQUARE, S::GRID, S::NEAR_ANOTHER, S::FAR_AWAY, S::SQUARE, S::AT_ANOTHER},
                      {M::REST, M::CREEP, M::STEP, M::DISTURB, M::JUMP},
                      {M::STEP, M::TELEPORT}});
  families.push_back({"tracks",
                      20,
                      {5, 5, 5, 5, 10, 70},
                      everywhere,
                      {M::CREEP, M::STEP, M::STEP, M::DISTURB, M::DISTURB, M::FLY, M::JUMP,
                       M::TELEPORT, M::GRID_STEP, M::SHUFFLE},
                      {M::STEP, M::TELEPORT, M::SWAP, M::ONTO_OTHERS},
                      120,
                      true});
  families.push_back({"few_move",
                      20,
                      {3, 0, 3, 0, 84, 10},
                      {S::SQUARE, S::GRID, S::SQUARE, S::HEXAGONS, S::CIRCLE, S::AT_ANOTHER},
                      {M::STEP, M::JUMP, M::CREEP, M::DISTURB, M::FLY, M::SNAP},
                      {M::CREEP, M::STEP, M::JUMP, M::TELEPORT, M::SWAP, M::ONTO_OTHERS,
                       M::GRID_STEP, M::SHUFFLE, M::NEXT_DOUBLE, M::PART}});
  families.push_back(
      {"coincident",
       20,
       {8, 4, 8, 4, 26, 50},
       {S::AT_ANOTHER, S::AT_ANOTHER, S::SQUARE, S::SQUARE, S::GRID, S::NEXT_DOUBLE},
       {M::REST, M::CREEP, M::STEP, M::JUMP, M::TRANSLATE, M::PART, M::PART, M::DISTURB, M::DISTURB,
        M::FLY, M::COLLAPSE, M::ONTO_OTHERS, M::SNAP, M::MIRROR, M::SHUFFLE},
       {M::PART, M::PART, M::ONTO_OTHERS, M::ONTO_OTHERS, M::COLLAPSE, M::STEP, M::TELEPORT,
        M::SWAP, M::NEXT_DOUBLE}});
  families.push_back({"dimensions",
                      20,
                      {20, 6, 20, 6, 18, 30},
                      {S::LINE, S::LINE, S::LINE, S::SQUARE, S::GRID, S::AT_ANOTHER},
                      {M::FLATTEN, M::FLATTEN, M::COLLAPSE, M::TELEPORT, M::STEP, M::TURN, M::SNAP,
                       M::SHUFFLE, M::SCALE, M::ONTO_CIRCLE, M::QUARTER_TURN, M::PART},
                      {M::FLATTEN, M::TELEPORT, M::STEP, M::ONTO_OTHERS, M::SWAP, M::NEXT_DOUBLE},
                      12});
  families.push_back({"cocircular",
                      20,
                      {12, 3, 12, 3, 30, 40},
                      {S::CIRCLE, S::CIRCLE, S::CIRCLE, S::CIRCLE, S::SQUARE, S::AT_ANOTHER},
                      {M::REST, M::TRANSLATE, M::QUARTER_TURN, M::HALF_TURN, M::MIRROR, M::SHUFFLE,
                       M::ONTO_CIRCLE, M::SCALE, M::NEXT_DOUBLE, M::CREEP, M::SWAP, M::WIND_TWICE},
                      {M::ONTO_CIRCLE, M::ONTO_CIRCLE, M::SWAP, M::NEXT_DOUBLE, M::GRID_STEP,
                       M::TELEPORT, M::SNAP}});
  families.push_back({"lattices",
                      20,
                      {10, 4, 10, 4, 32, 40},
                      {S::GRID, S::GRID, S::HEXAGONS, S::HEXAGONS, S::LINE},
                      {M::REST, M::GRID_STEP, M::TRANSLATE, M::QUARTER_TURN, M::HALF_TURN,
                       M::MIRROR, M::SHEAR, M::SCALE, M::SHUFFLE, M::SNAP, M::TELEPORT, M::CREEP,
                       M::STEP, M::DISTURB, M::FLY, M::FLY, M::NEXT_DOUBLE},
                      {M::GRID_STEP, M::GRID_STEP, M::SWAP, M::SNAP, M::STEP, M::NEXT_DOUBLE,
                       M::TELEPORT, M::PART}});
  families.push_back(
      {"inside_out",
       20,
       {3, 1, 3, 1, 22, 70},
       {S::SQUARE, S::SQUARE, S::GRID, S::CIRCLE, S::FAR_AWAY},
       {M::MIRROR, M::INSIDE_OUT, M::HALF_TURN, M::WIND_TWICE, M::SHUFFLE, M::SWAP, M::TELEPORT,
        M::FLY, M::FLY, M::TURN, M::SCALE, M::SHEAR, M::JUMP, M::REST},
       {M::MIRROR, M::INSIDE_OUT, M::WIND_TWICE, M::SHUFFLE, M::SWAP, M::TELEPORT, M::HALF_TURN}});
  families.push_back({"calm_motion",
                      20,
                      {2, 1, 2, 1, 4, 90},
                      {S::SQUARE, S::SQUARE, S::GRID, S::HEXAGONS, S::CIRCLE},
                      {M::REST, M::CREEP, M::CREEP, M::CREEP, M::CREEP, M::CREEP, M::CREEP,
                       M::CREEP, M::CREEP, M::STEP, M::DISTURB, M::TRANSLATE, M::NEXT_DOUBLE},
                      {M::CREEP, M::STEP, M::JUMP}});
  families.push_back({"any_unit",
                      20,
                      {10, 3, 10, 3, 24, 50},
                      everywhere,
                      {M::CREEP, M::STEP, M::JUMP, M::TELEPORT, M::DISTURB, M::FLY, M::SCALE,
                       M::TRANSLATE, M::MIRROR, M::NEXT_DOUBLE, M::SNAP, M::GRID_STEP, M::SHUFFLE},
                      {M::STEP, M::JUMP, M::NEXT_DOUBLE, M::ONTO_OTHERS, M::TELEPORT},
                      60,
                      false,
                      {Numbers::ANY_UNIT, Numbers::HUGE_OFFSET}});
  families.push_back({"mixed_scales",
                      20,
                      {10, 3, 10, 3, 24, 50},
                      {S::ANY_SCALE, S::ANY_SCALE, S::NEXT_DOUBLE, S::SQUARE, S::AT_ANOTHER},
                      {M::NEXT_DOUBLE, M::TELEPORT, M::DISTURB, M::FLY, M::SCALE, M::MIRROR,
                       M::REST, M::SHUFFLE, M::QUARTER_TURN, M::SWAP},
                      {M::NEXT_DOUBLE, M::TELEPORT, M::ONTO_OTHERS, M::SWAP},
                      60,
                      false,
                      {Numbers::ORDINARY, Numbers::ANY_UNIT}});
  families.push_back({"everything",
                      20,
                      {10, 4, 10, 4, 32, 40},
                      everywhere,
                      all_motions,
                      all_motions,
                      120,
                      false,
                      any_numbers});
  families.push_back(
      {"hundreds",
       5,
       {10, 5, 10, 5, 30, 40},
       {S::SQUARE, S::SQUARE, S::SQUARE, S::GRID, S::HEXAGONS, S::AT_ANOTHER, S::NEAR_ANOTHER},
       {M::CREEP, M::CREEP, M::STEP, M::DISTURB, M::DISTURB, M::DISTURB, M::FLY, M::FLY, M::FLY,
        M::SWAP, M::PART, M::SNAP, M::MIRROR, M::TRANSLATE, M::JUMP},
       {M::CREEP, M::STEP, M::JUMP, M::TELEPORT, M::SWAP, M::ONTO_OTHERS, M::PART},
       500});
  // so many points that a few that jump are put in again one by one
  families.push_back({"jumps",
                      5,
                      {4, 2, 4, 2, 18, 70},
                      {S::SQUARE, S::SQUARE, S::GRID, S::HEXAGONS, S::CIRCLE, S::NEAR_ANOTHER},
                      {M::FLY, M::FLY, M::FLY, M::DISTURB, M::SWAP, M::SWAP, M::REST, M::CREEP},
                      {M::TELEPORT, M::SWAP, M::SHUFFLE, M::ONTO_OTHERS, M::FLY},
                      500});
  families.push_back({"jumping_tracks",
                      5,
                      {2, 2, 2, 2, 12, 80},
                      {S::SQUARE, S::SQUARE, S::SQUARE, S::GRID, S::AT_ANOTHER, S::FAR_AWAY},
                      {M::FLY, M::FLY, M::DISTURB, M::SWAP, M::PART, M::REST, M::CREEP},
                      {M::TELEPORT, M::SWAP, M::ONTO_OTHERS, M::PART},
                      400,
                      true});
  return families;
}

inline const std::vector<Family>& families()
{
  static const std::vector<Family> families = all_families();
  return families;
}

inline std::size_t family_named(const std::string& name)
{
  std::string names;
  for (std::size_t i = 0; i < families().size(); ++i) {
    if (families()[i].name == name) {
      return i;
    }
    names += (i == 0 ? "" : ", ") + families()[i].name;
  }
  throw std::invalid_argument("there is no family '" + name + "'; there are " + names);
}

inline std::size_t any_family(Decisions& decisions)
{
  std::size_t shares = 0;
  for (const Family& family : families()) {
    shares += family.share;
  }
  std::size_t drawn = decisions.below(shares), i = 0;
  while (drawn >= families()[i].share) {
    drawn -= families()[i++].share;
  }
  return i;
}

} // namespace robustness

#endif // ROBUSTNESS_FAMILIES_H
