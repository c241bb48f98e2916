// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Must not compile: nothing that this kernel says can be certified.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>

int main()
{
  CGAL::Dynamic_Delaunay_triangulation_2<CGAL::Simple_cartesian<double>> dt;
}
