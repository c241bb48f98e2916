// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_PLACE_SOURCES_H
#define ROBUSTNESS_PLACE_SOURCES_H

#include "Decisions.h"
#include "Model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace robustness {

// Where new points are put.
enum class Source {
  SQUARE,       // anywhere
  GRID,         // whole numbers
  HEXAGONS,     // rows that are shifted against each other
  LINE,         // exactly collinear
  CIRCLE,       // exactly cocircular
  FAR_AWAY,     // a thousand times as far
  AT_ANOTHER,   // where somebody is
  NEAR_ANOTHER, // beside somebody, by 1e-9 to 1 of the unit
  NEXT_DOUBLE,  // a few of the next numbers from somebody, or of the smallest ones there are
  ANY_SCALE     // from 1e-150 to 1e150, each coordinate
};

// The part of the plane that a trial takes place in.
struct Field
{
  double unit = 1.0;
  double offset_x = 0.0, offset_y = 0.0;
  int extent = 10; // in units
  double limit = 1e150;

  // What is too far away stays at the limit.
  Place place(double x, double y) const { return kept({offset_x + unit * x, offset_y + unit * y}); }
  double x(const Place& place) const { return (place.x - offset_x) / unit; }
  double y(const Place& place) const { return (place.y - offset_y) / unit; }
  Place kept(const Place& place) const { return {kept(place.x), kept(place.y)}; }

private:
  double kept(double value) const
  {
    return std::isnan(value) ? 0.0 : (std::max)(-limit, (std::min)(limit, value));
  }
};

inline double neighboring_double(double value, Decisions& decisions)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (decisions.one_in(4)) {
    return value + decisions.whole(-2, 2) * std::numeric_limits<double>::denorm_min();
  }
  const double direction = decisions.one_in(2) ? infinity : -infinity;
  for (int steps = decisions.whole(0, 2); steps > 0; --steps) {
    value = std::nextafter(value, direction);
  }
  return value;
}

inline double any_scale(Decisions& decisions)
{
  const double size = std::pow(10.0, decisions.whole(-150, 149)) * decisions.real(1.0, 10.0);
  return decisions.one_in(2) ? size : -size;
}

inline const std::vector<Place>& whole_circle()
{
  static const std::vector<Place> places = [] {
    constexpr int radius = 65;
    std::vector<Place> circle;
    for (int x = -radius; x <= radius; ++x) {
      for (int y = -radius; y <= radius; ++y) {
        if (x * x + y * y == radius * radius) {
          circle.push_back({double(x), double(y)});
        }
      }
    }
    return circle;
  }();
  return places;
}

inline Place place_on_hexagons(const Field& field, Decisions& decisions)
{
  const int row = decisions.whole(0, field.extent);
  const double height = field.extent % 2 == 0 ? std::sqrt(3.0) / 2.0 : 0.875;
  return field.place(decisions.whole(0, field.extent) + 0.5 * (row % 2), height * row);
}

inline Place place_near(const Place& other, const Field& field, Decisions& decisions)
{
  const double step = field.unit * std::pow(10.0, decisions.whole(-9, 0));
  const double dx = step * decisions.deviation();
  return field.kept({other.x + dx, other.y + step * decisions.deviation()});
}

inline Place place_beside(const Place& other, const Field& field, Decisions& decisions)
{
  const double x = neighboring_double(other.x, decisions);
  return field.kept({x, neighboring_double(other.y, decisions)});
}

inline Place independent_place(Source source, const Field& field, Decisions& decisions)
{
  const double extent = field.extent;
  switch (source) {
  case Source::GRID: {
    const int x = decisions.whole(0, field.extent);
    return field.place(x, decisions.whole(0, field.extent));
  }
  case Source::HEXAGONS:
    return place_on_hexagons(field, decisions);
  case Source::LINE: {
    const int t = decisions.whole(-field.extent, field.extent);
    return field.place(3 * t, 2 * t + 1);
  }
  case Source::CIRCLE: {
    const Place& place = decisions.any_of(whole_circle());
    return field.place(place.x, place.y);
  }
  case Source::FAR_AWAY: {
    const double x = decisions.real(-1e3 * extent, 1e3 * extent);
    return field.place(x, decisions.real(-1e3 * extent, 1e3 * extent));
  }
  case Source::ANY_SCALE: {
    const double x = any_scale(decisions);
    return field.kept({x, any_scale(decisions)});
  }
  default: {
    const double x = decisions.real(0.0, extent);
    return field.place(x, decisions.real(0.0, extent));
  }
  }
}

// `others` are those who are there.
inline Place new_place(Source source, const Field& field, const Places& others,
                       Decisions& decisions)
{
  if (others.empty()) {
    return independent_place(source, field, decisions);
  }
  switch (source) {
  case Source::AT_ANOTHER:
    return decisions.any_of(others);
  case Source::NEAR_ANOTHER:
    return place_near(decisions.any_of(others), field, decisions);
  case Source::NEXT_DOUBLE:
    return place_beside(decisions.any_of(others), field, decisions);
  default:
    return independent_place(source, field, decisions);
  }
}

} // namespace robustness

#endif // ROBUSTNESS_PLACE_SOURCES_H
