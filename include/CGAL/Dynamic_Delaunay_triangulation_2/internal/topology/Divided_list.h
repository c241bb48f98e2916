// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_DIVIDED_LIST_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_DIVIDED_LIST_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The elements of a list, part by part, in the order of the list within each part.
template <class Element>
class Divided_list
{
public:
  static constexpr std::size_t max_parts = 33; // those of a triangulation, and what is in none

  // Copies a list, the i-th element of which belongs to part_of(i). Threads share the work.
  template <class Parts, class Part_of>
  void divide(const std::vector<Element>& list, std::size_t parts, const Part_of& part_of)
  {
    divide<Parts>(
        list.size(), parts, [&](std::size_t i) -> const Element& { return list[i]; }, part_of);
  }
  // The same of the elements element(i) for all i below `size`.
  template <class Parts, class Element_at, class Part_of>
  void divide(std::size_t size, std::size_t parts, const Element_at& element,
              const Part_of& part_of)
  {
    constexpr std::size_t least = Parts::size_for(64);
    std::vector<std::array<Index, max_parts>> next(Parts::number(size, least));
    m_part_of.resize(size);
    m_elements.resize(size);
    Parts::for_each(size, least, [&](std::size_t range, std::size_t i, std::size_t beyond) {
      for (; i < beyond; ++i) {
        m_part_of[i] = std::uint8_t(part_of(i));
        ++next[range][m_part_of[i]];
      }
    });
    Index sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      m_begins[part] = sum;
      for (auto& of_range : next)
        sum += std::exchange(of_range[part], sum);
    }
    m_begins[parts] = sum;
    Parts::for_each(size, least, [&](std::size_t range, std::size_t i, std::size_t beyond) {
      for (; i < beyond; ++i)
        m_elements[next[range][m_part_of[i]]++] = element(i);
    });
  }

  // The elements of a part.
  Element* begin(std::size_t part) { return m_elements.data() + m_begins[part]; }
  Element* end(std::size_t part) { return begin(part + 1); }
  std::size_t size(std::size_t part) const { return m_begins[part + 1] - m_begins[part]; }

private:
  Uninitialized_vector<std::uint8_t> m_part_of;
  Uninitialized_vector<Element> m_elements;
  std::array<Index, max_parts + 1> m_begins;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_DIVIDED_LIST_H
