// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_MOTIONS_H
#define RANDOM_OPERATIONS_MOTIONS_H

#include "Cloud.h"
#include "Named.h"
#include "Place_sources.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace random_operations {

// What a step keeps from frame to frame.
struct Memory
{
  std::size_t calls = 0;
  std::size_t number = 0; // of points
  std::vector<Id> ids{};
  Places points{};
};

// One step of one frame: what a motion sees and changes.
struct Moving
{
  Cloud& cloud;
  const Indices& chosen;
  const Places& others; // all places of points: those of the cloud, or more
  double size;
  Decisions& decisions;
  Memory& memory;
  std::size_t rarity = 1;      // one in so many of the chosen ones really moves
  bool keeps_together = false; // points that coincide go on coinciding

  Place& point(std::size_t index) const { return cloud.points[index]; }
  double distance() const { return cloud.field.unit * size * cloud.spacing; }
};

// How the chosen points change from one frame to the next.
struct Motion
{
  const char* name;
  const char* does;
  void (*move)(const Moving& moving);
  bool is_own = false; // each point moves on its own, and coincident points may do so together
};

namespace motions {

// Moves each chosen point from p to f(p).
template <class Function>
void for_chosen(const Moving& moving, const Function& f)
{
  const auto moved = [&](const Place& place) {
    return moving.rarity > 1 && !moving.decisions.one_in(moving.rarity) ? place : f(place);
  };
  std::map<std::pair<double, double>, Place> moved_places;
  for (const std::size_t index : moving.chosen) {
    Place& place = moving.point(index);
    if (!moving.keeps_together) {
      place = moved(place);
      continue;
    }
    const std::pair<double, double> old(place.x, place.y);
    auto found = moved_places.find(old);
    if (found == moved_places.end()) {
      found = moved_places.emplace(old, moved(place)).first;
    }
    place = found->second;
  }
}

// Transforms in coordinates from the middle of the box.
template <class Function>
void around_middle(const Moving& moving, const Function& f)
{
  const Place middle = moving.cloud.middle();
  const Field& field = moving.cloud.field;
  for_chosen(moving, [&](const Place& place) {
    const Place moved = f(Place{field.x(place) - middle.x, field.y(place) - middle.y});
    return field.place(middle.x + moved.x, middle.y + moved.y);
  });
}

inline void remember_chosen(const Moving& moving)
{
  moving.memory.ids.clear();
  moving.memory.points.clear();
  for (const std::size_t index : moving.chosen) {
    moving.memory.ids.push_back(moving.cloud.ids()[index]);
    moving.memory.points.push_back(moving.point(index));
  }
}

inline void bring_back(const Moving& moving)
{
  for (std::size_t i = 0; i != moving.memory.ids.size(); ++i) {
    if (const auto index = moving.cloud.index(moving.memory.ids[i])) {
      moving.point(*index) = moving.memory.points[i];
    }
  }
}

// Moves the chosen points in one frame, and brings them back in the next.
template <class Go>
void there_and_back(const Moving& moving, const Go& go)
{
  if (moving.memory.calls % 2 == 1) {
    bring_back(moving);
    return;
  }
  remember_chosen(moving);
  go();
}

inline void rest(const Moving& moving)
{
  for_chosen(moving, [](const Place& place) { return place; });
}

inline void go_fresh(const Moving& moving)
{
  for_chosen(moving, [&](const Place&) { return moving.cloud.fresh(moving.decisions); });
}

inline void jump(const Moving& moving)
{
  for_chosen(moving, [&](const Place& place) {
    return in_random_direction(place, moving.distance(), moving.decisions);
  });
}

inline Place shifted(const Moving& moving, const Place& place, double distance)
{
  const Field& field = moving.cloud.field;
  const double x = place.x + distance * moving.decisions.deviation();
  return field.kept({x, place.y + distance * moving.decisions.deviation()});
}

inline void diffuse(const Moving& moving)
{
  for_chosen(moving, [&](const Place& place) { return shifted(moving, place, moving.distance()); });
}

inline void creep(const Moving& moving)
{
  for_chosen(moving, [&](const Place& place) {
    const double step = moving.cloud.field.unit * std::pow(10.0, moving.decisions.whole(-12, -6));
    return shifted(moving, place, step);
  });
}

inline bool is_shared(const Place& place, const Places& all)
{
  return std::count_if(all.begin(), all.end(), [&](const Place& other) {
           return other.x == place.x && other.y == place.y;
         }) > 1;
}

inline void part(const Moving& moving)
{
  for_chosen(moving, [&](const Place& place) {
    return is_shared(place, moving.others) && !moving.decisions.one_in(3)
               ? shifted(moving, place, moving.distance())
               : place;
  });
}

inline void step_on_grid(const Moving& moving)
{
  const Field& field = moving.cloud.field;
  for_chosen(moving, [&](const Place& place) {
    const double x = field.x(place) + moving.decisions.whole(-1, 1);
    return field.place(x, field.y(place) + moving.decisions.whole(-1, 1));
  });
}

inline void go_to_next_double(const Moving& moving)
{
  for_chosen(moving, [&](const Place& place) {
    return sources::place_beside(place, moving.cloud.field, moving.decisions);
  });
}

inline void snap(const Moving& moving)
{
  const Field& field = moving.cloud.field;
  for_chosen(moving, [&](const Place& place) {
    return field.place(std::round(field.x(place)), std::round(field.y(place)));
  });
}

inline void go_onto_line(const Moving& moving)
{
  const Field& field = moving.cloud.field;
  for_chosen(moving, [&](const Place& place) { return field.place(field.x(place), 1.0); });
}

inline void go_onto_circle(const Moving& moving)
{
  for_chosen(moving, [&](const Place&) {
    return sources::on_circle(moving.cloud.field, moving.others, moving.decisions);
  });
}

inline void go_along(const Moving& moving)
{
  for_chosen(moving, [&](const Place& place) {
    return moving.cloud.along(place, moving.distance() * moving.decisions.real(-1.0, 1.0));
  });
}

inline void hop(const Moving& moving)
{
  for_chosen(moving, [&](const Place&) {
    const Place other = moving.decisions.any_of(moving.others);
    return in_random_direction(other, moving.distance(), moving.decisions);
  });
}

inline void go_onto_others(const Moving& moving)
{
  for_chosen(moving, [&](const Place&) { return moving.decisions.any_of(moving.others); });
}

inline void trade(const Moving& moving)
{
  const std::size_t first = moving.decisions.below(moving.chosen.size());
  const std::size_t second = moving.decisions.below(moving.chosen.size());
  if (!moving.chosen.empty()) {
    std::swap(moving.point(moving.chosen[first]), moving.point(moving.chosen[second]));
  }
}

inline void swap_pairs(const Moving& moving)
{
  for (std::size_t i = 0; i + 1 < moving.chosen.size(); i += 2) {
    std::swap(moving.point(moving.chosen[i]), moving.point(moving.chosen[i + 1]));
  }
}

inline void shuffle(const Moving& moving)
{
  for (std::size_t i = moving.chosen.size(); i > 1; --i) {
    std::swap(moving.point(moving.chosen[i - 1]),
              moving.point(moving.chosen[moving.decisions.below(i)]));
  }
}

// Two groups of coincident points exchange their places in each frame.
inline void swap_groups(const Moving& moving)
{
  Memory& memory = moving.memory;
  if (memory.calls == 0) {
    remember_chosen(moving);
  }
  if (memory.ids.size() < 2) {
    return;
  }
  for (std::size_t i = 0; i != memory.ids.size(); ++i) {
    if (const auto index = moving.cloud.index(memory.ids[i])) {
      moving.point(*index) = memory.points[(i + memory.calls) % 2];
    }
  }
}

inline double wrapped(double value, double low, double length)
{
  const double turns = std::floor((value - low) / length);
  return value - turns * length;
}

inline void drift(const Moving& moving)
{
  const Cloud& cloud = moving.cloud;
  for_chosen(moving, [&](const Place& place) {
    return Place{wrapped(place.x + moving.distance(), cloud.low.x, cloud.width()), place.y};
  });
}

inline void flow_by_height(const Moving& moving)
{
  const Cloud& cloud = moving.cloud;
  for_chosen(moving, [&](const Place& place) {
    const double speed = 2.0 * (place.y - cloud.middle().y) / cloud.height();
    return Place{wrapped(place.x + speed * moving.distance(), cloud.low.x, cloud.width()), place.y};
  });
}

inline void reinject(const Moving& moving)
{
  const Cloud& cloud = moving.cloud;
  for_chosen(moving, [&](const Place& place) {
    const double x = place.x + moving.distance();
    return x < cloud.high.x ? Place{x, place.y}
                            : Place{cloud.low.x, moving.decisions.real(cloud.low.y, cloud.high.y)};
  });
}

inline Place far_place(const Moving& moving)
{
  return in_random_direction(moving.cloud.middle(), moving.size * moving.cloud.width(),
                             moving.decisions);
}

inline void flock_far(const Moving& moving)
{
  there_and_back(moving, [&] {
    const Place target = far_place(moving);
    for_chosen(moving, [&](const Place&) {
      return in_random_direction(target, moving.cloud.spacing * moving.decisions.share(),
                                 moving.decisions);
    });
  });
}

inline void meet_far(const Moving& moving)
{
  there_and_back(moving, [&] {
    const Place target = far_place(moving);
    for_chosen(moving, [&](const Place&) { return target; });
  });
}

// The points that are away come back, and others go away.
inline void stray(const Moving& moving)
{
  bring_back(moving);
  remember_chosen(moving);
  for_chosen(moving, [&](const Place&) { return far_place(moving); });
}

// The second of each pair is with the first in every other frame; `part` says where else.
template <class Part>
void meet_in_pairs(const Moving& moving, const Part& part)
{
  Memory& memory = moving.memory;
  if (memory.calls == 0) {
    remember_chosen(moving);
  }
  for (std::size_t i = 0; i + 1 < memory.ids.size(); i += 2) {
    const auto first = moving.cloud.index(memory.ids[i]);
    const auto second = moving.cloud.index(memory.ids[i + 1]);
    if (first && second) {
      const Place meeting = moving.point(*first);
      moving.point(*second) = memory.calls % 2 == 1 ? meeting : part(meeting);
    }
  }
}

inline void meet_and_part(const Moving& moving)
{
  meet_in_pairs(moving, [&](const Place& place) {
    return in_random_direction(place, moving.distance(), moving.decisions);
  });
}

inline void meet_and_part_far(const Moving& moving)
{
  meet_in_pairs(moving, [&](const Place&) { return moving.cloud.fresh(moving.decisions); });
}

inline void mirror(const Moving& moving)
{
  around_middle(moving, [](const Place& place) { return Place{-place.x, place.y}; });
}

inline void quarter_turn(const Moving& moving)
{
  around_middle(moving, [](const Place& place) { return Place{-place.y, place.x}; });
}

inline void half_turn(const Moving& moving)
{
  around_middle(moving, [](const Place& place) { return Place{-place.x, -place.y}; });
}

inline Place turned(const Place& place, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * place.x - s * place.y, s * place.x + c * place.y};
}

inline void turn(const Moving& moving)
{
  around_middle(moving, [&](const Place& place) { return turned(place, moving.size); });
}

inline void rock(const Moving& moving)
{
  const double angle = moving.decisions.real(-moving.size, moving.size);
  around_middle(moving, [&](const Place& place) { return turned(place, angle); });
}

inline void swirl(const Moving& moving)
{
  around_middle(moving, [&](const Place& place) {
    return turned(place, moving.size * std::sin(std::atan2(place.y, place.x)));
  });
}

inline void wind_twice(const Moving& moving)
{
  around_middle(moving, [](const Place& place) {
    const double distance = std::sqrt(place.x * place.x + place.y * place.y);
    return distance > 0.0 ? Place{(place.x * place.x - place.y * place.y) / distance,
                                  2.0 * place.x * place.y / distance}
                          : place;
  });
}

inline void turn_inside_out(const Moving& moving)
{
  const double diameter = moving.cloud.width();
  around_middle(moving, [=](const Place& place) {
    const double squared_distance = place.x * place.x + place.y * place.y;
    const double factor = diameter * diameter / squared_distance / 4.0;
    return squared_distance > 0.0 ? Place{factor * place.x, factor * place.y} : place;
  });
}

inline void scale(const Moving& moving)
{
  there_and_back(moving, [&] {
    around_middle(moving, [&](const Place& place) {
      return Place{moving.size * place.x, moving.size * place.y};
    });
  });
}

inline void stretch(const Moving& moving)
{
  Decisions& decisions = moving.decisions;
  const double fx = std::ldexp(1.0, decisions.whole(-3, 3));
  const double fy = decisions.one_in(2) ? fx : std::ldexp(1.0, decisions.whole(-3, 3));
  around_middle(moving, [=](const Place& place) { return Place{fx * place.x, fy * place.y}; });
}

inline void shear(const Moving& moving)
{
  there_and_back(moving, [&] {
    around_middle(moving, [&](const Place& place) {
      return Place{place.x + moving.size * place.y, place.y};
    });
  });
}

inline void skew(const Moving& moving)
{
  const int steps = moving.decisions.whole(-2, 2);
  around_middle(moving, [=](const Place& place) {
    return Place{place.x + steps * place.y, place.y};
  });
}

inline void translate(const Moving& moving)
{
  there_and_back(moving, [&] {
    for_chosen(moving, [&](const Place& place) {
      return Place{place.x + moving.size * moving.cloud.width(), place.y};
    });
  });
}

inline void glide(const Moving& moving)
{
  const int dx = moving.decisions.whole(-3, 3), dy = moving.decisions.whole(-3, 3);
  around_middle(moving, [=](const Place& place) { return Place{place.x + dx, place.y + dy}; });
}

inline void flatten(const Moving& moving)
{
  there_and_back(moving, [&] {
    around_middle(moving, [&](const Place& place) { return Place{moving.size * place.x, 0.0}; });
  });
}

inline void collapse(const Moving& moving)
{
  there_and_back(moving, [&] {
    const Place target = moving.cloud.middle();
    for_chosen(moving, [&](const Place&) { return target; });
  });
}

inline void gather(const Moving& moving)
{
  const std::size_t host = moving.decisions.below(moving.chosen.size());
  if (!moving.chosen.empty()) {
    const Place target = moving.point(moving.chosen[host]);
    for_chosen(moving, [&](const Place&) { return target; });
  }
}

// Removes the chosen points, and adds as many new ones.
inline void replace(const Moving& moving)
{
  const std::size_t number = moving.chosen.size();
  moving.cloud.remove(moving.chosen);
  for (std::size_t i = 0; i != number; ++i) {
    moving.cloud.add(moving.cloud.fresh(moving.decisions));
  }
}

inline void leave(const Moving& moving)
{
  constexpr std::size_t fewest = 10;
  if (moving.cloud.size() >= moving.chosen.size() + fewest) {
    moving.cloud.remove(moving.chosen);
  }
}

inline void come(const Moving& moving)
{
  for (std::size_t i = moving.chosen.size(); i != 0; --i) {
    moving.cloud.add(moving.cloud.fresh(moving.decisions));
  }
}

inline void come_and_leave(const Moving& moving)
{
  Memory& memory = moving.memory;
  if (memory.calls % 2 == 0) {
    memory.number = moving.chosen.size();
    come(moving);
    return;
  }
  Indices oldest;
  for (std::size_t i = 0; i != (std::min)(memory.number, moving.cloud.size()); ++i) {
    oldest.push_back(i);
  }
  leave({moving.cloud, oldest, moving.others, moving.size, moving.decisions, memory});
}

// All points drift to the right; those that leave the box are removed, and as many enter it.
inline void stream(const Moving& moving)
{
  Cloud& cloud = moving.cloud;
  Indices gone;
  for_chosen(moving, [&](const Place& place) {
    return Place{place.x + moving.distance(), place.y};
  });
  for (std::size_t i = 0; i != cloud.size(); ++i) {
    if (cloud.points[i].x >= cloud.high.x) {
      gone.push_back(i);
    }
  }
  cloud.remove(gone);
  for (std::size_t i = 0; i != gone.size(); ++i) {
    const double x = cloud.low.x + moving.distance() * moving.decisions.share();
    cloud.add({x, moving.decisions.real(cloud.low.y, cloud.high.y)});
  }
}

} // namespace motions

inline const std::vector<Motion>& all_motions()
{
  using namespace motions;
  static const std::vector<Motion> all = {
      {"rest", "nothing", rest, true},
      {"fresh", "to fresh places", go_fresh, true},
      {"jump", "by SIZE spacings in random directions", jump, true},
      {"brownian", "normally distributed steps of SIZE spacings", diffuse, true},
      {"creep", "steps from 1e-12 to 1e-6 units", creep, true},
      {"part", "those who share a place leave it by SIZE spacings, but for some", part},
      {"grid_step", "to neighboring places of a grid of units", step_on_grid, true},
      {"next_double", "to the next numbers", go_to_next_double, true},
      {"snap", "to whole units", snap, true},
      {"onto_line", "onto a line", go_onto_line, true},
      {"onto_circle", "to places that are exactly cocircular", go_onto_circle, true},
      {"along", "along their curve, by up to SIZE spacings", go_along, true},
      {"hop", "next to another point, SIZE spacings away", hop, true},
      {"onto_others", "exactly to where another point is", go_onto_others, true},
      {"trade", "two of them exchange their places", trade},
      {"swap", "two by two exchange their places", swap_pairs},
      {"shuffle", "all exchange their places", shuffle},
      {"swap_groups", "two groups at one place each exchange them", swap_groups},
      {"drift", "right by SIZE spacings, and around", drift},
      {"shear_flow", "right above and left below, by up to SIZE spacings, and around",
       flow_by_height},
      {"reinject", "right by SIZE spacings, from the end to the left edge", reinject},
      {"flock_far", "all near to one place SIZE boxes away, and back", flock_far},
      {"meet_far", "all to one place SIZE boxes away, and back", meet_far},
      {"stray", "each SIZE boxes away for one frame", stray},
      {"meet", "pairs meet in one place, and part by SIZE spacings", meet_and_part},
      {"meet_and_leave", "pairs meet in one place, and part to fresh places", meet_and_part_far},
      {"mirror", "x to -x", mirror},
      {"quarter_turn", "exactly", quarter_turn},
      {"half_turn", "exactly", half_turn},
      {"turn", "by SIZE radians around the middle", turn},
      {"rock", "by up to SIZE radians around the middle", rock},
      {"swirl", "by up to SIZE radians, depending on the angle", swirl},
      {"wind_twice", "angles are doubled", wind_twice},
      {"inside_out", "near goes far, and far goes near", turn_inside_out},
      {"scale", "by the factor SIZE, and back", scale},
      {"stretch", "by powers of two, one for each axis", stretch},
      {"shear", "x by SIZE times y, and back", shear},
      {"skew", "x by a few times y", skew},
      {"translate", "by SIZE boxes, and back", translate},
      {"glide", "all by the same whole units", glide},
      {"flatten", "onto a line, of SIZE times its length, and back", flatten},
      {"collapse", "onto one place, and back", collapse},
      {"gather", "to the place of one of them", gather},
      {"replace", "they go, and others come to fresh places", replace},
      {"leave", "they go", leave},
      {"come", "as many others come to fresh places", come},
      {"come_and_leave", "as many others come, and in the next frame as many go", come_and_leave},
      {"stream", "right by SIZE spacings, out of the box, others come in", stream}};
  return all;
}

// \throws std::invalid_argument if there is none.
inline const Motion& motion_named(const std::string& name)
{
  return named(all_motions(), name, "motion");
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_MOTIONS_H
