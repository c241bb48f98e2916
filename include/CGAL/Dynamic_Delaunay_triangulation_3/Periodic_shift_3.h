// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_SHIFT_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_SHIFT_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <array>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

A translation of a lattice in space: `shift[0]`, `shift[1]` and `shift[2]` times the cell's first,
second and third vector.
*/
using Periodic_shift_3 = std::array<int, 3>;

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_SHIFT_3_H
