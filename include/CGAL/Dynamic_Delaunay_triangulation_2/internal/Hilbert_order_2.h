// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_HILBERT_ORDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_HILBERT_ORDER_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The place of the cell (x, y) on the Hilbert curve through 2^16 by 2^16 cells. From the largest
// quadrants to the smallest; in each the curve is the whole one, its axes exchanged, or turned by
// half a turn, or both.
inline std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y)
{
  std::uint32_t place = 0, are_exchanged = 0, is_turned = 0;
  for (int i = 15; i >= 0; --i) {
    const std::uint32_t x_bit = x >> i & 1, y_bit = y >> i & 1;
    const std::uint32_t exchange = (x_bit ^ y_bit) & are_exchanged;
    const std::uint32_t right = x_bit ^ exchange ^ is_turned, upper = y_bit ^ exchange ^ is_turned;
    place = place << 2 | ((3 * right) ^ upper);
    is_turned ^= right & ~upper;
    are_exchanged ^= 1 ^ upper;
  }
  return place;
}

// Sorts points along a Hilbert curve: by the cells of a grid over them, which takes a third of the
// time of CGAL::hilbert_sort(); and by that one where many points share a cell, or their extent is
// no finite number. The result depends on the points and their order alone.
template <class Traits>
class Hilbert_order_2
{
public:
  using Point = typename Traits::Point_2;
  using Numbered_point = std::pair<Point, Index>;

  explicit Hilbert_order_2(const Traits& traits)
    : m_traits(traits)
  {
  }

  void sort(std::vector<Numbered_point>& points)
  {
    find_places(points);
    boost::sort::spreadsort::integer_sort(m_places.begin(), m_places.end());
    if (is_too_coarse())
      CGAL::hilbert_sort(points.begin(), points.end(), Adapter(Map(), m_traits));
    else
      apply_to(points);
    std::vector<std::uint64_t>().swap(m_places);
  }

private:
  using Map = First_of_pair_property_map<Numbered_point>;
  using Adapter = Spatial_sort_traits_adapter_2<Traits, Map>;

  static Position_2 approximation(const Numbered_point& point)
  {
    return {CGAL::to_double(point.first.x()), CGAL::to_double(point.first.y())};
  }

  // Of each point, its number in the lower half; nothing without a finite extent.
  void find_places(const std::vector<Numbered_point>& points)
  {
    m_places.clear();
    if (points.empty())
      return;
    Position_2 low = approximation(points.front()), high = low;
    for (const Numbered_point& point : points) {
      const Position_2 p = approximation(point);
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
    }
    const double extent = (std::max)(high.x - low.x, high.y - low.y);
    const double scale = 65535 / extent;
    if (!std::isfinite(extent) || !std::isfinite(scale) || scale == 0)
      return;
    for (const Numbered_point& point : points) {
      const Position_2 p = approximation(point);
      const std::uint64_t place =
          hilbert_place(std::uint32_t((p.x - low.x) * scale), std::uint32_t((p.y - low.y) * scale));
      m_places.push_back(place << 32 | m_places.size());
    }
  }

  // Whether more than one in eight points share a cell with the point before.
  bool is_too_coarse() const
  {
    std::size_t shared = 0;
    for (std::size_t i = 1; i < m_places.size(); ++i)
      shared += m_places[i] >> 32 == m_places[i - 1] >> 32;
    return m_places.empty() || 8 * shared > m_places.size();
  }

  void apply_to(std::vector<Numbered_point>& points) const
  {
    std::vector<Numbered_point> sorted;
    sorted.reserve(points.size());
    for (const std::uint64_t place : m_places)
      sorted.push_back(points[std::uint32_t(place)]);
    points = std::move(sorted);
  }

  const Traits& m_traits;
  std::vector<std::uint64_t> m_places;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_HILBERT_ORDER_2_H
