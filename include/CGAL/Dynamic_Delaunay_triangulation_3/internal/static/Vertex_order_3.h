// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The numbers of positions along a Hilbert curve.
inline std::vector<Index> order_along_curve(const std::vector<Position_3>& positions)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto point_of = [&positions](Index i) {
    const Position_3& p = positions[i];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  const auto map = boost::make_function_property_map<Index>(point_of);
  const Spatial_sort_traits_adapter_3<Kernel, decltype(map)> traits(map);
  hilbert_sort(order.begin(), order.end(), traits);
  return order;
}

// Vertices in rounds (Amenta, Choi and Rote 2003): one in eight, chosen at random, comes before the
// others, one in eight of these before the rest of them, and so on; within a round they follow
// their numbers.
inline constexpr std::size_t number_of_rounds = 10;

inline std::size_t round_of(Vertex_index v)
{
  constexpr std::uint64_t choices = 8;
  std::uint64_t bits = (std::uint64_t(Index(v)) * 0x9e3779b97f4a7c15u) >> 24;
  std::size_t round = number_of_rounds - 1;
  for (; round > 0 && bits % choices == 0; --round)
    bits /= choices;
  return round;
}

struct Order_of_rounds_3
{
  bool operator()(Vertex_index a, Vertex_index b) const
  {
    const std::size_t round = round_of(a), other = round_of(b);
    return round != other ? round < other : a < b;
  }
};

using Rounds_3 = std::array<std::vector<Vertex_index>, number_of_rounds>; // some may be empty

// Those from 1 to `vertices`.
inline Rounds_3 rounds_of(Index vertices)
{
  Rounds_3 rounds;
  for (Vertex_index v(1); v <= vertices; ++v)
    rounds[round_of(v)].push_back(v);
  return rounds;
}
inline std::vector<Vertex_index> one_after_the_other(const Rounds_3& rounds)
{
  std::vector<Vertex_index> order;
  for (const std::vector<Vertex_index>& round : rounds)
    order.insert(order.end(), round.begin(), round.end());
  return order;
}
inline std::vector<Vertex_index> order_by_rounds(Index vertices)
{
  return one_after_the_other(rounds_of(vertices));
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H
