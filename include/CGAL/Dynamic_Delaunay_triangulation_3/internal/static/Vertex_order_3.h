// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>

#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The numbers of positions along a Hilbert curve, the same ones with and without threads.
template <class ConcurrencyTag = Sequential_tag>
std::vector<Index> order_along_curve(const std::vector<Position_3>& positions)
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
  using Tag = // CGAL knows no others
      std::conditional_t<std::is_same_v<ConcurrencyTag, Parallel_tag>, Parallel_tag,
                         Sequential_tag>;
  const auto sort = [&] { hilbert_sort<Tag>(order.begin(), order.end(), traits); };
#ifdef CGAL_LINKED_WITH_TBB
  tbb::this_task_arena::isolate(sort); // so that it takes no work of the caller
#else
  sort();
#endif
  return order;
}

// The vertices from 1 to `vertices` in rounds (Amenta, Choi and Rote 2003): one in eight, chosen at
// random, comes before the others, one in eight of these before the rest of them, and so on; within
// a round they follow their numbers. Rounds may be empty.
inline std::array<std::vector<Vertex_index>, 10> rounds_of(Index vertices)
{
  constexpr std::uint64_t choices = 8;
  std::array<std::vector<Vertex_index>, 10> rounds;
  for (Vertex_index v(1); v <= vertices; ++v) {
    std::uint64_t bits = (std::uint64_t(Index(v)) * 0x9e3779b97f4a7c15u) >> 24;
    std::size_t round = 0;
    for (; round + 1 < rounds.size() && bits % choices == 0; ++round)
      bits /= choices;
    rounds[rounds.size() - 1 - round].push_back(v);
  }
  return rounds;
}
inline std::vector<Vertex_index> order_by_rounds(Index vertices)
{
  std::vector<Vertex_index> order;
  order.reserve(vertices);
  for (const std::vector<Vertex_index>& round : rounds_of(vertices))
    order.insert(order.end(), round.begin(), round.end());
  return order;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H
