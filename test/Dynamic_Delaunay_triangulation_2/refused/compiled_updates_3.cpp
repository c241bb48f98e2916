// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// As for the plane.
#include <CGAL/Dynamic_Delaunay_triangulation_3/compiled/compiled_updates.h>
