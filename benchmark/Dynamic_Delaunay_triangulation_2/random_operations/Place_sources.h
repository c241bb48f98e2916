// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_PLACE_SOURCES_H
#define RANDOM_OPERATIONS_PLACE_SOURCES_H

#include "Cloud.h"
#include "Named.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace random_operations {

// Where new points are put; `others` are the places of the existing ones.
struct Source
{
  const char* name;
  const char* is;
  Place (*place)(const Field& field, const Places& others, Decisions& decisions);
};

namespace sources {

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

inline Place place_beside(const Place& other, const Field& field, Decisions& decisions)
{
  const double x = neighboring_double(other.x, decisions);
  return field.kept({x, neighboring_double(other.y, decisions)});
}

// All integer points with the distance 65 from the origin.
inline const Places& whole_circle()
{
  static const Places places = [] {
    constexpr int radius = 65;
    Places circle;
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

inline Place within(double low, double high, const Field& field, Decisions& decisions)
{
  const double x = decisions.real(low, high);
  return field.place(x, decisions.real(low, high));
}

inline Place in_square(const Field& field, const Places&, Decisions& decisions)
{
  return within(0.0, field.extent, field, decisions);
}

inline Place far_away(const Field& field, const Places&, Decisions& decisions)
{
  return within(-1e3 * field.extent, 1e3 * field.extent, field, decisions);
}

inline Place on_grid(const Field& field, const Places&, Decisions& decisions)
{
  const int x = decisions.whole(0, field.extent);
  return field.place(x, decisions.whole(0, field.extent));
}

inline Place on_hexagons(const Field& field, const Places&, Decisions& decisions)
{
  const int row = decisions.whole(0, field.extent);
  const double height = field.extent % 2 == 0 ? std::sqrt(3.0) / 2.0 : 0.875;
  return field.place(decisions.whole(0, field.extent) + 0.5 * (row % 2), height * row);
}

inline Place on_line(const Field& field, const Places&, Decisions& decisions)
{
  const int t = decisions.whole(-field.extent, field.extent);
  return field.place(3 * t, 2 * t + 1);
}

inline Place on_circle(const Field& field, const Places&, Decisions& decisions)
{
  const Place& place = decisions.any_of(whole_circle());
  return field.place(place.x, place.y);
}

inline double any_magnitude(Decisions& decisions)
{
  const double size = std::pow(10.0, decisions.whole(-150, 149)) * decisions.real(1.0, 10.0);
  return decisions.one_in(2) ? size : -size;
}

inline Place of_any_scale(const Field& field, const Places&, Decisions& decisions)
{
  const double x = any_magnitude(decisions);
  return field.kept({x, any_magnitude(decisions)});
}

inline Place at_another(const Field& field, const Places& others, Decisions& decisions)
{
  return others.empty() ? in_square(field, others, decisions) : decisions.any_of(others);
}

inline Place near_another(const Field& field, const Places& others, Decisions& decisions)
{
  if (others.empty()) {
    return in_square(field, others, decisions);
  }
  const Place& other = decisions.any_of(others);
  const double step = field.unit * std::pow(10.0, decisions.whole(-9, 0));
  const double dx = step * decisions.deviation();
  return field.kept({other.x + dx, other.y + step * decisions.deviation()});
}

inline Place beside_another(const Field& field, const Places& others, Decisions& decisions)
{
  return others.empty() ? in_square(field, others, decisions)
                        : place_beside(decisions.any_of(others), field, decisions);
}

} // namespace sources

inline const std::vector<Source>& all_sources()
{
  using namespace sources;
  static const std::vector<Source> all = {
      {"square", "anywhere in a square", in_square},
      {"grid", "at whole numbers", on_grid},
      {"hexagons", "in rows that are shifted against each other", on_hexagons},
      {"line", "exactly collinear", on_line},
      {"circle", "exactly cocircular", on_circle},
      {"far_away", "in a square a thousand times as large", far_away},
      {"at_another", "where a point is", at_another},
      {"near_another", "beside a point, by 1e-9 to 1 of the unit", near_another},
      {"next_double", "a few of the next numbers from a point", beside_another},
      {"any_scale", "each coordinate from 1e-150 to 1e150", of_any_scale}};
  return all;
}

// \throws std::invalid_argument if there is none.
inline const Source& source_named(const std::string& name)
{
  return named(all_sources(), name, "source of places");
}

} // namespace random_operations

#endif // RANDOM_OPERATIONS_PLACE_SOURCES_H
