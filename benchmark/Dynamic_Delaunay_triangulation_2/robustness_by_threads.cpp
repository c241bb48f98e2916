// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The trials of robustness.cpp, of the same seeds, but by triangulations with the Parallel_tag, and
// with so few points in a part that threads share the passes over as few points as trials have.
// Each of the threads that run trials shares them with those of TBB.

#define CGAL_DYNAMIC_DELAUNAY_POINTS_OF_PART 8
#define ROBUSTNESS_PROGRAM "robustness_by_threads"

#include "robustness.cpp"
