// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_MOTIONS_H
#define ROBUSTNESS_MOTIONS_H

#include "Decisions.h"
#include "Model.h"
#include "Place_sources.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace robustness {

// What becomes of points from one frame to the next: of all of them, or of a few.
enum class Motion {
  REST,
  CREEP,        // a millionth of the unit, and less
  STEP,         // a few hundredths
  JUMP,         // about the unit
  DISTURB,      // a few take a step
  FLY,          // a few go to new places, through everybody
  GRID_STEP,    // whole units, each point its own
  TELEPORT,     // to new places
  NEXT_DOUBLE,  // to the next numbers
  TRANSLATE,    // by the same whole units
  SCALE,        // by a power of two, one for each axis
  SHEAR,        // by whole units
  TURN,         // by a small angle
  QUARTER_TURN, // exactly
  HALF_TURN,    // exactly
  MIRROR,       // exactly
  INSIDE_OUT,   // near goes far, and far goes near
  WIND_TWICE,   // angles are doubled
  FLATTEN,      // onto a line
  SNAP,         // to whole units
  ONTO_CIRCLE,  // to places that are exactly cocircular
  SWAP,         // two change places
  SHUFFLE,      // all change places
  COLLAPSE,     // to one place
  ONTO_OTHERS,  // each to where somebody is
  PART          // those who share a place leave it, but for some
};

class Mover
{
public:
  Mover(const Field& field, Source source, const Places& all, Decisions& decisions)
    : m_field(field)
    , m_source(source)
    , m_all(all)
    , m_decisions(decisions)
  {
  }

  // `places` are some or all of `all`.
  void move(Motion motion, Places& places)
  {
    if (places.empty()) {
      return;
    }
    if (is_affine(motion)) {
      transform(motion, places);
    } else if (is_exchange(motion)) {
      exchange(motion, places);
    } else if (motion != Motion::PART && m_decisions.one_in(2)) {
      move_together(motion, places);
    } else {
      for (Place& place : places) {
        place = moved(motion, place);
      }
    }
  }

private:
  static bool is_affine(Motion motion)
  {
    return motion >= Motion::TRANSLATE && motion <= Motion::WIND_TWICE;
  }
  static bool is_exchange(Motion motion)
  {
    return motion >= Motion::SWAP && motion <= Motion::COLLAPSE;
  }

  // Those who share a place go on sharing it.
  void move_together(Motion motion, Places& places)
  {
    std::map<std::pair<double, double>, Place> moved_places;
    for (Place& place : places) {
      const std::pair<double, double> old(place.x, place.y);
      auto found = moved_places.find(old);
      if (found == moved_places.end()) {
        found = moved_places.emplace(old, moved(motion, place)).first;
      }
      place = found->second;
    }
  }

  // Each for itself.
  Place moved(Motion motion, const Place& place)
  {
    const double x = m_field.x(place), y = m_field.y(place);
    switch (motion) {
    case Motion::CREEP:
      return shifted(place, std::pow(10.0, m_decisions.whole(-12, -6)));
    case Motion::STEP:
      return shifted(place, 0.03);
    case Motion::JUMP:
      return shifted(place, 1.0);
    case Motion::DISTURB:
      return m_decisions.one_in(24) ? shifted(place, 0.5) : place;
    case Motion::FLY:
      return m_decisions.one_in(48) ? moved(Motion::TELEPORT, place) : place;
    case Motion::GRID_STEP: {
      const int dx = m_decisions.whole(-1, 1);
      return m_field.place(x + dx, y + m_decisions.whole(-1, 1));
    }
    case Motion::TELEPORT:
      return new_place(m_source, m_field, m_all, m_decisions);
    case Motion::NEXT_DOUBLE:
      return place_beside(place, m_field, m_decisions);
    case Motion::FLATTEN:
      return m_field.place(x, 1.0);
    case Motion::SNAP:
      return m_field.place(std::round(x), std::round(y));
    case Motion::ONTO_CIRCLE:
      return new_place(Source::CIRCLE, m_field, m_all, m_decisions);
    case Motion::ONTO_OTHERS:
      return m_decisions.any_of(m_all);
    case Motion::PART:
      return is_shared(place) && !m_decisions.one_in(3) ? shifted(place, 0.3) : place;
    default:
      return place;
    }
  }

  Place shifted(const Place& place, double step)
  {
    const double dx = m_field.unit * step * m_decisions.deviation();
    return m_field.kept({place.x + dx, place.y + m_field.unit * step * m_decisions.deviation()});
  }

  bool is_shared(const Place& place) const
  {
    const auto is_here = [&](const Place& other) {
      return other.x == place.x && other.y == place.y;
    };
    return std::count_if(m_all.begin(), m_all.end(), is_here) > 1;
  }

  // All in the same way: (x, y) goes to what `f` makes of it, as seen from the middle.
  template <class Function>
  void for_all(Places& places, const Function& f) const
  {
    const double middle = m_field.extent / 2;
    for (Place& place : places) {
      const auto [x, y] = f(m_field.x(place) - middle, m_field.y(place) - middle);
      place = m_field.place(middle + x, middle + y);
    }
  }

  void transform(Motion motion, Places& places)
  {
    using Pair = std::pair<double, double>;
    switch (motion) {
    case Motion::TRANSLATE: {
      const int dx = m_decisions.whole(-3, 3), dy = m_decisions.whole(-3, 3);
      return for_all(places, [=](double x, double y) { return Pair(x + dx, y + dy); });
    }
    case Motion::SCALE: {
      const double fx = std::ldexp(1.0, m_decisions.whole(-3, 3));
      const double fy = m_decisions.one_in(2) ? fx : std::ldexp(1.0, m_decisions.whole(-3, 3));
      return for_all(places, [=](double x, double y) { return Pair(fx * x, fy * y); });
    }
    case Motion::SHEAR: {
      const int steps = m_decisions.whole(-2, 2);
      return for_all(places, [=](double x, double y) { return Pair(x + steps * y, y); });
    }
    case Motion::TURN: {
      const double angle = m_decisions.real(-0.1, 0.1), c = std::cos(angle), s = std::sin(angle);
      return for_all(places,
                     [=](double x, double y) { return Pair(c * x - s * y, s * x + c * y); });
    }
    case Motion::QUARTER_TURN:
      return for_all(places, [](double x, double y) { return Pair(-y, x); });
    case Motion::HALF_TURN:
      return for_all(places, [](double x, double y) { return Pair(-x, -y); });
    case Motion::MIRROR:
      return for_all(places, [](double x, double y) { return Pair(-x, y); });
    default:
      return bend(motion, places);
    }
  }

  void bend(Motion motion, Places& places) const
  {
    using Pair = std::pair<double, double>;
    const double radius = m_field.extent;
    for_all(places, [=](double x, double y) {
      const double squared_distance = x * x + y * y;
      if (!(squared_distance > 0.0)) {
        return Pair(x, y);
      }
      if (motion == Motion::INSIDE_OUT) {
        const double factor = radius * radius / squared_distance / 4.0;
        return Pair(factor * x, factor * y);
      }
      const double distance = std::sqrt(squared_distance);
      return Pair((x * x - y * y) / distance, 2.0 * x * y / distance);
    });
  }

  void exchange(Motion motion, Places& places)
  {
    switch (motion) {
    case Motion::SWAP: {
      const std::size_t first = m_decisions.below(places.size());
      std::swap(places[first], places[m_decisions.below(places.size())]);
      return;
    }
    case Motion::SHUFFLE:
      for (std::size_t i = places.size(); i > 1; --i) {
        std::swap(places[i - 1], places[m_decisions.below(i)]);
      }
      return;
    default:
      std::fill(places.begin(), places.end(), Place(m_decisions.any_of(places)));
    }
  }

  const Field& m_field;
  Source m_source;
  const Places& m_all;
  Decisions& m_decisions;
};

} // namespace robustness

#endif // ROBUSTNESS_MOTIONS_H
