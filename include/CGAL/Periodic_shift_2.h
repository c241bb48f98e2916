// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PERIODIC_SHIFT_2_H
#define CGAL_PERIODIC_SHIFT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <array>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

A translation of the lattice: `shift[0]` times the cell's first vector plus `shift[1]` times its
second one. In a slab the second number is 0.
*/
using Periodic_shift_2 = std::array<int, 2>;

} // namespace CGAL

#endif // CGAL_PERIODIC_SHIFT_2_H
