// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_ELEMENTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_ELEMENTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Index_of.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3 {

using Dynamic_Delaunay_triangulations_2::Index;
using Dynamic_Delaunay_triangulations_2::Index_of;
using Dynamic_Delaunay_triangulations_2::Point_id;
using Dynamic_Delaunay_triangulations_2::Vertex_index;

/// A tetrahedron, or a hull facet with the infinite vertex.
using Cell_index = Index_of<struct Cell_element>;
/// A vertex in its cell; it also stands for the facet opposite to it. Those of cell c have the
/// numbers 4c to 4c + 3.
using Corner_index = Index_of<struct Corner_element>;

/// The coordinates of a vertex: exact where the kernel's coordinates are doubles, the nearest
/// doubles elsewhere. Four doubles long, so that each loads into one register of AVX.
struct alignas(32) Position_3
{
  double x, y, z;
  double unused = 0;
};

namespace internal {

using Dynamic_Delaunay_triangulations_2::internal::Column;
using Dynamic_Delaunay_triangulations_2::internal::infinite_index;
using Dynamic_Delaunay_triangulations_2::internal::null_index;

// A few elements, such as the four vertices of a cell, which have places from 0 on.
template <class T, int number>
struct Few
{
  T elements[number];

  const T& operator[](int place) const { return elements[place]; }
  T& operator[](int place) { return elements[place]; }
  const T* begin() const { return elements; }
  const T* end() const { return elements + number; }
  T* begin() { return elements; }
  T* end() { return elements + number; }

  friend bool operator<(const Few& a, const Few& b)
  {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
  friend bool operator==(const Few& a, const Few& b)
  {
    return std::equal(a.begin(), a.end(), b.begin());
  }
};

template <class T>
Few<T, 4> permuted(const Few<T, 4>& few, const Few<std::uint8_t, 4>& places)
{
  return {few[places[0]], few[places[1]], few[places[2]], few[places[3]]};
}

using Vertices_3 = Few<Vertex_index, 4>;

// The places of a cell but one, in an order which is an even permutation after that place: so seen
// from there, they turn in the same direction.
inline constexpr std::uint8_t other_places[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};

// Whether the infinite vertex is among them, without branches, which would be mispredicted.
inline bool has_infinite(const Vertices_3& v)
{
  return (int(v[0] == infinite_index) | int(v[1] == infinite_index) | int(v[2] == infinite_index) |
          int(v[3] == infinite_index)) != 0;
}

// Writes nothing where both are equal, so that threads may read that meanwhile.
template <class T, int number>
void exchange_what_differs(Few<T, number>& a, Few<T, number>& b)
{
  for (int i = 0; i < number; ++i)
    if (!(a[i] == b[i]))
      std::swap(a[i], b[i]);
}

inline Position_3 operator+(const Position_3& p, const Position_3& v)
{
  return {p.x + v.x, p.y + v.y, p.z + v.z};
}
inline Position_3 operator-(const Position_3& p, const Position_3& q)
{
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
inline Position_3 operator*(double factor, const Position_3& v)
{
  return {factor * v.x, factor * v.y, factor * v.z};
}
inline bool is_same(const Position_3& p, const Position_3& q)
{
  return p.x == q.x && p.y == q.y && p.z == q.z;
}
inline double coordinate(const Position_3& p, int axis)
{
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}
inline double squared_length(const Position_3& v)
{
  return v.x * v.x + v.y * v.y + v.z * v.z;
}

} // namespace internal
} // namespace CGAL::Dynamic_Delaunay_triangulations_3

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_ELEMENTS_3_H
