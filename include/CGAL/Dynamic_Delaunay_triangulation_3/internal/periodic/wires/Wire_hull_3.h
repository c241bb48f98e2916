// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_HULL_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_HULL_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/wires/Wire_signs_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Counts how often the hull of a wire goes round its axis.
//
// Cells that fit together and are positive cover every point equally often. Far away there are only
// infinite ones, so that number is how often the hull goes round the axis: the number of facets
// that a ray from the axis leaves, less that of those through which it comes back.
template <class State>
class Wire_hull_3
{
public:
  explicit Wire_hull_3(const State& state)
    : m_state(state)
    , m_signs(state, Torus_predicates_3(state.torus, state.squared_error))
  {
  }

  // Whether the hull goes round the axis once. All infinite cells, which are listed, are positive.
  bool goes_round_once(const std::vector<Cell_index>& infinite)
  {
    if (!measure_facets(infinite))
      return false;
    // a ray that meets an edge does not count: another one is tried
    for (int attempt = 0; attempt < 32; ++attempt)
      if (const std::optional<int> number = count(attempt))
        return *number == 1;
    return false;
  }

private:
  static constexpr double most_height = 16; // shifts have to be below 2^9

  struct Facet
  {
    Torus_facet_3 sites;
    double low, high; // in multiples of the vector, from the point of the axis
  };

  // False if there are none, or images that are too far for rounded positions.
  bool measure_facets(const std::vector<Cell_index>& infinite)
  {
    m_axis = m_signs.point_of_axis();
    m_radius = -1;
    m_facets.clear();
    for (const Cell_index c : infinite) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const Torus_sites_3 sites = m_state.arrays.sites(c);
      Facet f{hull_facet(sites, infinite_place(sites)), infinity, -infinity};
      for (int i = 0; i < 3; ++i) {
        const Position_3 way = m_state.position(f.sites[i]) - m_axis;
        const double height = m_state.torus.fractions(way).x;
        const double radius = std::sqrt(squared_length(across(way)));
        if (!(std::abs(height) < most_height && std::isfinite(radius)))
          return false;
        f.low = (std::min)(f.low, height);
        f.high = (std::max)(f.high, height);
        if (radius > m_radius) {
          m_radius = radius;
          m_farthest = {f.sites[i], f.sites[(i + 1) % 3], f.sites[(i + 2) % 3]};
        }
      }
      m_facets.push_back(f);
    }
    return m_radius > 0;
  }
  Position_3 across(const Position_3& way) const
  {
    return way - m_state.torus.fractions(way).x * m_state.torus.vector(0);
  }

  // A point away from the axis, near to the farthest vertex; not as high along the wire as the
  // point of the axis, as all vertices may be.
  Position_3 target(int attempt) const
  {
    const auto way = [&](int i) { return across(m_state.position(m_farthest[i]) - m_axis); };
    return m_axis + (0.83 * way(0) + ((0.13 + 0.001 * attempt) * way(1) + 0.04 * way(2))) +
           (0.137 + 0.043 * attempt) * m_state.torus.vector(0);
  }

  // How often a ray from the axis leaves the hull; nothing if it meets an edge, or if that is not
  // to be told.
  std::optional<int> count(int attempt) const
  {
    const Position_3 end = target(attempt), way = end - m_axis;
    const double length = std::sqrt(squared_length(across(way)));
    // The ray is within the hull up to this height; heights are off by less than a hundredth, as
    // points are less than 2^20 |a| from the origin.
    const double reach = 1.01 * m_state.torus.fractions(way).x * m_radius / length;
    if (!(std::abs(reach) < most_height))
      return std::nullopt;
    const double low = (std::min)(reach, 0.0) - 0.01, high = (std::max)(reach, 0.0) + 0.01;
    int number = 0;
    for (const Facet& f : m_facets)
      for (double shift = std::ceil(low - f.high); shift <= high - f.low; ++shift) {
        const std::optional<int> crossing = side_of_ray(f.sites, int(shift), end);
        if (!crossing)
          return std::nullopt;
        number += *crossing;
      }
    return number;
  }

  // 1 if the ray leaves the hull through an image of a facet, -1 if it comes back, 0 if it does not
  // meet it; nothing if it meets its border.
  std::optional<int> side_of_ray(const Torus_facet_3& f, int shift, const Position_3& end) const
  {
    const Torus_shift_3 by = Torus_shift_3::of({shift, 0, 0});
    const Torus_facet_3 image{f[0] + by, f[1] + by, f[2] + by};
    const Torus_point_3 target(end.x, end.y, end.z);
    int positive = 0, negative = 0;
    for (int i = 0; i < 3; ++i) {
      const int side = m_signs.orientation_from_axis(image[i], image[(i + 1) % 3], target);
      positive += side > 0;
      negative += side < 0;
      if (positive > 0 && negative > 0)
        return 0;
    }
    // as the plane of the facet sees the axis; else the line meets it before the axis
    const int beneath = m_signs.orientation_from_axis(image[0], image[1], image[2]);
    if (positive + negative < 3 || beneath == 0)
      return std::nullopt;
    return positive == 3 ? int(beneath > 0) : -int(beneath < 0);
  }

  const State& m_state;
  const Wire_signs_3<State> m_signs;
  std::vector<Facet> m_facets;
  Position_3 m_axis{0, 0, 0}; // a point of it
  double m_radius = 0;        // of the farthest vertex of the hull
  Torus_facet_3 m_farthest{}; // a facet of it, which comes first
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_HULL_3_H
