// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A repair without its name, a visitor given twice, a data structure in periodic space, and a tag
// without its name in space of three dimensions: each must be refused by a message of its own.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Visitor = CGAL::With_visitor_2<CGAL::Default>;

using Unnamed =
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Flip_repair_2>::Point;
using Twice =
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Default, Visitor, Visitor>::Point;
using Elsewhere = CGAL::Dynamic_periodic_Delaunay_triangulation_2<
    Kernel, CGAL::Default, CGAL::With_data_structure_2<CGAL::Default>>::Point;
using In_space = CGAL::Dynamic_Delaunay_triangulation_3<Kernel, CGAL::Sequential_tag>::Point;
