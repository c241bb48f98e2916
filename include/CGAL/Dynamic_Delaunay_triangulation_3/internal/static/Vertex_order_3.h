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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Orders positions along a curve. Many of them are cut into blocks of equal numbers, one next to
// the other, each of which has a Hilbert curve of its own, so that threads can share them.
template <class Parts>
class Order_along_curve_3
{
public:
  explicit Order_along_curve_3(const std::vector<Position_3>& positions)
    : m_positions(positions)
    , m_order(positions.size())
  {
  }

  // The numbers of the positions. Once for an object.
  std::vector<Index> run()
  {
    std::iota(m_order.begin(), m_order.end(), Index(0));
    std::size_t blocks = 1;
    if (m_positions.size() >= many)
      for (const Coordinate along : {&Position_3::x, &Position_3::y, &Position_3::z})
        for (const bool is_first : {true, false}) {
          halve(blocks, along, is_first);
          blocks *= 2;
        }
    Parts::run(blocks, [&](std::size_t block) { sort(block, blocks); });
    return std::move(m_order);
  }

private:
  using Coordinate = double Position_3::*;
  using Iterator = std::vector<Index>::iterator;

  static constexpr std::size_t many = Parts::least_shared * Parts::usual_size;

  Iterator begin(std::size_t block, std::size_t blocks)
  {
    return m_order.begin() + std::ptrdiff_t(m_order.size() * block / blocks);
  }

  // Cuts each of so many blocks into two. The second time along an axis they make rows of four, of
  // which every second one goes downwards, so that it begins where the one before ends.
  void halve(std::size_t blocks, Coordinate along, bool is_first)
  {
    Parts::run_long(blocks, [&](std::size_t block) {
      const bool is_upwards = (is_first ? block : block / 2) % 2 == 0;
      std::nth_element(begin(block, blocks), begin(2 * block + 1, 2 * blocks),
                       begin(block + 1, blocks), [&](Index i, Index j) {
                         const double a = m_positions[i].*along, b = m_positions[j].*along;
                         return is_upwards ? a < b : b < a;
                       });
    });
  }

  void sort(std::size_t block, std::size_t blocks)
  {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const auto point_of = [this](Index i) {
      const Position_3& p = m_positions[i];
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    const auto map = boost::make_function_property_map<Index>(point_of);
    const Spatial_sort_traits_adapter_3<Kernel, decltype(map)> traits(map);
    hilbert_sort(begin(block, blocks), begin(block + 1, blocks), traits);
  }

  const std::vector<Position_3>& m_positions;
  std::vector<Index> m_order;
};

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
