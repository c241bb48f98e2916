// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_AXIS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_AXIS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Chooses the axis of a wire.
template <class State>
class Wire_axis_3
{
public:
  // Of cells that fit together, the infinite ones of which are listed.
  Wire_axis_3(State& state, const std::vector<Cell_index>& infinite)
    : m_state(state)
    , m_signs(state)
    , m_infinite(infinite)
  {
  }

  // Chooses a line strictly inside of the hull: through a point with doubles as coordinates, or
  // else without an origin. False if infinite cells are not all positive even so.
  bool choose()
  {
    m_state.has_origin = true;
    const auto [middle, extent] = middle_and_extent();
    // off the center of symmetry, so that it is not in a plane with vertices of a lattice
    for (const double factor : {0.01, 0.0001, 0.0})
      if (is_inside(middle + Position_3{factor * 0.618 * extent.x, factor * -0.717 * extent.y,
                                        factor * 0.865 * extent.z}))
        return true;
    const std::size_t cells = m_state.arrays.number_of_cells();
    for (std::size_t i = 0; i < 64; ++i)
      if (is_inside(middle_of(Cell_index(cells * i / 64))))
        return true;
    m_state.has_origin = false;
    return is_inside({0, 0, 0});
  }

private:
  bool is_inside(const Position_3& origin)
  {
    m_state.set_origin(origin);
    return is_finite(origin) &&
           std::all_of(m_infinite.begin(), m_infinite.end(), [this](Cell_index c) {
             return m_signs.is_positive(m_state.arrays.sites(c));
           });
  }

  // The mean of the vertices of the hull, and their extent along each coordinate axis.
  std::pair<Position_3, Position_3> middle_and_extent() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Position_3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    Position_3 sum{0, 0, 0};
    const double share = 1 / (3 * double(m_infinite.size()));
    for (const Cell_index c : m_infinite)
      for (const Vertex_index v : m_state.arrays.vertices(c))
        if (v != infinite_index) {
          const Position_3& p = m_state.positions.position(v);
          low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
          high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
          sum = sum + share * p;
        }
    return {sum, high - low};
  }

  // NaN of an infinite cell.
  Position_3 middle_of(Cell_index c) const
  {
    Position_3 sum{0, 0, 0};
    for (const Torus_site_3& s : m_state.arrays.sites(c))
      sum = sum + 0.25 * m_state.position(s);
    return sum;
  }

  State& m_state;
  const Torus_signs_3<State> m_signs;
  const std::vector<Cell_index>& m_infinite;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_AXIS_3_H
