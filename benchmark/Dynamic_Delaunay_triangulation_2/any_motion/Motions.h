// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_MOTIONS_H
#define ANY_MOTION_MOTIONS_H

#include "Cloud.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace any_motion {

// What a step keeps from frame to frame.
struct Memory
{
  std::size_t calls = 0;
  std::size_t number = 0; // of points
  std::vector<Id> ids{};
  std::vector<Point> points{};
};

// One step of one frame: what a motion sees and changes.
struct Moving
{
  Cloud& cloud;
  const Places& chosen;
  double size;
  Random& random;
  Memory& memory;

  Point& point(std::size_t place) const { return cloud.points[place]; }
  double distance() const { return size * cloud.spacing; }
};

// What becomes of the chosen points from one frame to the next.
struct Motion
{
  const char* name;
  const char* does;
  void (*move)(const Moving& moving);
};

namespace motions {

// Each chosen point goes to what `f` makes of it.
template <class Function>
void for_chosen(const Moving& moving, const Function& f)
{
  for (const std::size_t place : moving.chosen) {
    moving.point(place) = f(moving.point(place));
  }
}

// The same in coordinates from the middle of the box.
template <class Function>
void around_middle(const Moving& moving, const Function& f)
{
  const Point middle = moving.cloud.middle();
  for_chosen(moving, [&](const Point& point) {
    const Point moved = f(Point{point.x - middle.x, point.y - middle.y});
    return Point{middle.x + moved.x, middle.y + moved.y};
  });
}

inline void remember_chosen(const Moving& moving)
{
  moving.memory.ids.clear();
  moving.memory.points.clear();
  for (const std::size_t place : moving.chosen) {
    moving.memory.ids.push_back(moving.cloud.ids()[place]);
    moving.memory.points.push_back(moving.point(place));
  }
}

inline void bring_back(const Moving& moving)
{
  for (std::size_t i = 0; i != moving.memory.ids.size(); ++i) {
    if (const auto place = moving.cloud.place(moving.memory.ids[i])) {
      moving.point(*place) = moving.memory.points[i];
    }
  }
}

// They go in one frame, and are where they were in the next.
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

inline void go_fresh(const Moving& moving)
{
  for_chosen(moving, [&](const Point&) { return moving.cloud.fresh(moving.random); });
}

inline void jump(const Moving& moving)
{
  for_chosen(moving, [&](const Point& point) {
    return in_random_direction(point, moving.distance(), moving.random);
  });
}

inline void diffuse(const Moving& moving)
{
  for_chosen(moving, [&](const Point& point) {
    const double x = point.x + moving.distance() * moving.random.gaussian();
    return Point{x, point.y + moving.distance() * moving.random.gaussian()};
  });
}

inline void go_along(const Moving& moving)
{
  for_chosen(moving, [&](const Point& point) {
    return moving.cloud.along(point, moving.distance() * moving.random.uniform(-1.0, 1.0));
  });
}

inline void hop(const Moving& moving)
{
  for_chosen(moving, [&](const Point&) {
    const Point other = moving.point(any_below(moving.cloud.size(), moving.random));
    return in_random_direction(other, moving.distance(), moving.random);
  });
}

inline void go_onto_others(const Moving& moving)
{
  for_chosen(moving, [&](const Point&) {
    return moving.point(any_below(moving.cloud.size(), moving.random));
  });
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
              moving.point(moving.chosen[any_below(i, moving.random)]));
  }
}

// Two groups, each in one place, which they exchange.
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
    if (const auto place = moving.cloud.place(memory.ids[i])) {
      moving.point(*place) = memory.points[(i + memory.calls) % 2];
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
  for_chosen(moving, [&](const Point& point) {
    return Point{wrapped(point.x + moving.distance(), cloud.low.x, cloud.width()), point.y};
  });
}

inline void flow_by_height(const Moving& moving)
{
  const Cloud& cloud = moving.cloud;
  for_chosen(moving, [&](const Point& point) {
    const double speed = 2.0 * (point.y - cloud.middle().y) / cloud.height();
    return Point{wrapped(point.x + speed * moving.distance(), cloud.low.x, cloud.width()), point.y};
  });
}

inline void reinject(const Moving& moving)
{
  const Cloud& cloud = moving.cloud;
  for_chosen(moving, [&](const Point& point) {
    const double x = point.x + moving.distance();
    return x < cloud.high.x ? Point{x, point.y}
                            : Point{cloud.low.x, moving.random.uniform(cloud.low.y, cloud.high.y)};
  });
}

inline Point far_place(const Moving& moving)
{
  return in_random_direction(moving.cloud.middle(), moving.size * moving.cloud.width(),
                             moving.random);
}

inline void flock_far(const Moving& moving)
{
  there_and_back(moving, [&] {
    const Point target = far_place(moving);
    for_chosen(moving, [&](const Point&) {
      return in_random_direction(target, moving.cloud.spacing * moving.random.uniform(),
                                 moving.random);
    });
  });
}

inline void meet_far(const Moving& moving)
{
  there_and_back(moving, [&] {
    const Point target = far_place(moving);
    for_chosen(moving, [&](const Point&) { return target; });
  });
}

// Those who were out come back, and others go.
inline void stray(const Moving& moving)
{
  bring_back(moving);
  remember_chosen(moving);
  for_chosen(moving, [&](const Point&) { return far_place(moving); });
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
    const auto first = moving.cloud.place(memory.ids[i]);
    const auto second = moving.cloud.place(memory.ids[i + 1]);
    if (first && second) {
      const Point meeting = moving.point(*first);
      moving.point(*second) = memory.calls % 2 == 1 ? meeting : part(meeting);
    }
  }
}

inline void meet_and_part(const Moving& moving)
{
  meet_in_pairs(moving, [&](const Point& point) {
    return in_random_direction(point, moving.distance(), moving.random);
  });
}

inline void meet_and_part_far(const Moving& moving)
{
  meet_in_pairs(moving, [&](const Point&) { return moving.cloud.fresh(moving.random); });
}

inline void mirror(const Moving& moving)
{
  around_middle(moving, [](const Point& point) { return Point{-point.x, point.y}; });
}

inline void quarter_turn(const Moving& moving)
{
  around_middle(moving, [](const Point& point) { return Point{-point.y, point.x}; });
}

inline Point turned(const Point& point, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * point.x - s * point.y, s * point.x + c * point.y};
}

inline void turn(const Moving& moving)
{
  around_middle(moving, [&](const Point& point) { return turned(point, moving.size); });
}

inline void swirl(const Moving& moving)
{
  around_middle(moving, [&](const Point& point) {
    return turned(point, moving.size * std::sin(std::atan2(point.y, point.x)));
  });
}

inline void scale(const Moving& moving)
{
  there_and_back(moving, [&] {
    around_middle(moving, [&](const Point& point) {
      return Point{moving.size * point.x, moving.size * point.y};
    });
  });
}

inline void shear(const Moving& moving)
{
  there_and_back(moving, [&] {
    around_middle(moving, [&](const Point& point) {
      return Point{point.x + moving.size * point.y, point.y};
    });
  });
}

inline void translate(const Moving& moving)
{
  there_and_back(moving, [&] {
    for_chosen(moving, [&](const Point& point) {
      return Point{point.x + moving.size * moving.cloud.width(), point.y};
    });
  });
}

inline void turn_inside_out(const Moving& moving)
{
  const double radius = 0.5 * moving.cloud.width();
  const double nearest = 1e-9 * radius;
  around_middle(moving, [&](const Point& point) {
    const double distance = (std::max)(std::hypot(point.x, point.y), nearest);
    const double factor = radius / distance * (radius / distance);
    return Point{factor * point.x, factor * point.y};
  });
}

inline void flatten(const Moving& moving)
{
  there_and_back(moving, [&] {
    around_middle(moving, [&](const Point& point) { return Point{moving.size * point.x, 0.0}; });
  });
}

inline void collapse(const Moving& moving)
{
  there_and_back(moving, [&] {
    const Point target = moving.cloud.middle();
    for_chosen(moving, [&](const Point&) { return target; });
  });
}

// As many come as have gone.
inline void replace(const Moving& moving)
{
  const std::size_t number = moving.chosen.size();
  moving.cloud.remove(moving.chosen);
  for (std::size_t i = 0; i != number; ++i) {
    moving.cloud.add(moving.cloud.fresh(moving.random));
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
    moving.cloud.add(moving.cloud.fresh(moving.random));
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
  Places places;
  for (std::size_t i = 0; i != (std::min)(memory.number, moving.cloud.size()); ++i) {
    places.push_back(i); // those who have been there for longest
  }
  leave({moving.cloud, places, moving.size, moving.random, memory});
}

// All drift; who leaves on the right is gone, and somebody else enters on the left.
inline void stream(const Moving& moving)
{
  Cloud& cloud = moving.cloud;
  Places gone;
  for_chosen(moving, [&](const Point& point) {
    return Point{point.x + moving.distance(), point.y};
  });
  for (std::size_t i = 0; i != cloud.size(); ++i) {
    if (cloud.points[i].x >= cloud.high.x) {
      gone.push_back(i);
    }
  }
  cloud.remove(gone);
  for (std::size_t i = 0; i != gone.size(); ++i) {
    const double x = cloud.low.x + moving.distance() * moving.random.uniform();
    cloud.add({x, moving.random.uniform(cloud.low.y, cloud.high.y)});
  }
}

} // namespace motions

inline const std::vector<Motion>& all_motions()
{
  using namespace motions;
  static const std::vector<Motion> all = {
      {"fresh", "to fresh places", go_fresh},
      {"jump", "by SIZE spacings in random directions", jump},
      {"brownian", "normally distributed steps of SIZE spacings", diffuse},
      {"along", "along their curve, by up to SIZE spacings", go_along},
      {"hop", "next to somebody else, SIZE spacings away", hop},
      {"onto_others", "exactly to where somebody is", go_onto_others},
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
      {"turn", "by SIZE radians around the middle", turn},
      {"swirl", "by up to SIZE radians, depending on the angle", swirl},
      {"scale", "by the factor SIZE, and back", scale},
      {"shear", "x by SIZE times y, and back", shear},
      {"translate", "by SIZE boxes, and back", translate},
      {"inside_out", "near goes far, and far goes near", turn_inside_out},
      {"flatten", "onto a line, of SIZE times its length, and back", flatten},
      {"collapse", "onto one place, and back", collapse},
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
  const auto& all = all_motions();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Motion& motion) { return motion.name == name; });
  if (found == all.end()) {
    throw std::invalid_argument("there is no motion '" + name + "'");
  }
  return *found;
}

} // namespace any_motion

#endif // ANY_MOTION_MOTIONS_H
