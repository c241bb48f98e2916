// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A box for cells in periodic space, which has no boxes.

#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  const CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel> dt(CGAL::Periodic_cell_3(1, 1, 1));
  CGAL::Voronoi_cell_measures_3().compute(dt, CGAL::Bbox_3(0, 0, 0, 1, 1, 1));
}
