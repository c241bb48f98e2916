// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROVIDED_MEMORY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROVIDED_MEMORY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Makes room for so many elements more: appending them then throws nothing. Grows by doubling,
// which `reserve()` alone does not.
template <class T>
void provide(std::vector<T>& data, std::size_t more)
{
  if (data.capacity() < data.size() + more)
    data.reserve(2 * data.size() + more);
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROVIDED_MEMORY_2_H
