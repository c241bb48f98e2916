// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_INDEX_OF_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_INDEX_OF_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {

/// The number of an element: of a vertex, a half-edge, an edge or a face in the flat arrays.
using Index = std::uint32_t;

/// The number of an element of one kind. An integer becomes one by a constructor alone, as in
/// `Vertex_index(1)`; it converts to `Index`. It is never given, nor compared with, where the
/// number of another kind is asked for.
template <class Element>
class Index_of
{
public:
  Index_of() = default;
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  constexpr explicit Index_of(Integer number)
    : m_number(Index(number))
  {
  }

  constexpr operator Index() const { return m_number; }
  Index_of& operator++()
  {
    ++m_number;
    return *this;
  }
  Index_of operator++(int) { return Index_of(m_number++); }
  Index_of& operator+=(Index step)
  {
    m_number += step;
    return *this;
  }
  // Longer integers get a sum as long as themselves.
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer> &&
                                                    sizeof(Integer) <= sizeof(Index)>>
  friend constexpr Index_of operator+(Index_of i, Integer step)
  {
    return Index_of(i.m_number + Index(step));
  }

private:
  Index m_number;
};

template <class A, class B, class = std::enable_if_t<!std::is_same_v<A, B>>>
bool operator==(Index_of<A>, Index_of<B>) = delete;
template <class A, class B, class = std::enable_if_t<!std::is_same_v<A, B>>>
bool operator!=(Index_of<A>, Index_of<B>) = delete;
template <class A, class B, class = std::enable_if_t<!std::is_same_v<A, B>>>
bool operator<(Index_of<A>, Index_of<B>) = delete;

/// \name Indices of each kind
/// @{
using Vertex_index = Index_of<struct Vertex_element>;
using Halfedge_index = Index_of<struct Halfedge_element>;
using Edge_index = Index_of<struct Edge_element>;
using Face_index = Index_of<struct Face_element>;
using Point_id = Index_of<struct Point_element>; ///< of a point, not of its vertex
/// @}

namespace internal {

constexpr Vertex_index infinite_index(0);

// No element, of whatever kind.
struct Null_index
{
  constexpr operator Index() const { return (std::numeric_limits<Index>::max)(); }
  template <class Element>
  constexpr operator Index_of<Element>() const
  {
    return Index_of<Element>(Index(*this));
  }
};
constexpr Null_index null_index{};

// The most vertices whose half-edges have numbers that fit into Index: static engines number eight
// of them per vertex.
constexpr Index max_vertices = null_index / 8;

// An array with an entry for each element of one kind.
template <class Index_of_kind, class T, class Vector = std::vector<T>>
class Column : public Vector
{
public:
  using Vector::Vector;

  const T& operator[](Index_of_kind i) const { return Vector::operator[](i); }
  T& operator[](Index_of_kind i) { return Vector::operator[](i); }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_INDEX_OF_H
