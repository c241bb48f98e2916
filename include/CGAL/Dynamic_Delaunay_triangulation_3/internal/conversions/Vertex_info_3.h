// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_CONVERSIONS_VERTEX_INFO_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_CONVERSIONS_VERTEX_INFO_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Whether vertices of one of CGAL's triangulations have an `info()`.
template <class Vertex, class = void>
constexpr bool has_info = false;
template <class Vertex>
constexpr bool has_info<Vertex, std::void_t<decltype(std::declval<Vertex&>().info())>> = true;

template <class VertexHandle>
void set_info([[maybe_unused]] VertexHandle vertex, [[maybe_unused]] std::size_t id)
{
  using Vertex = std::decay_t<decltype(*vertex)>;
  if constexpr (has_info<Vertex>)
    vertex->info() = static_cast<std::decay_t<decltype(vertex->info())>>(id);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_CONVERSIONS_VERTEX_INFO_3_H
