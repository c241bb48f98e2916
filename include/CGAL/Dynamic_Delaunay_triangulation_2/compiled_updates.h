// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_UPDATES_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_UPDATES_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

// Include this header in exactly one source file of a program that defines
// CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED in all its files. It compiles for all of them what
// updates need in the plane and in periodic space, with the usual kernel and without data of users,
// whatever the classifier, the repair, the policy and the visitor are; also for `Parallel_tag` if
// all files define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PARALLEL, too. To compile it in
// several source files, define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PART in each of them:
// as 1 or 2, and for `Parallel_tag` as 3 or 4. CMake's targets
// `Dynamic_Delaunay_triangulation_2::compiled` and `compiled_parallel` do that.
#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED
#error                                                                                             \
    "compiled_updates.h is for programs that define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED in all files"
#endif

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PART
#define CGAL_DYNAMIC_DELAUNAY_HAS_PART(i) (CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PART == i)
#else
#define CGAL_DYNAMIC_DELAUNAY_HAS_PART(i) 1
#endif

/// \cond
namespace CGAL {

#if CGAL_DYNAMIC_DELAUNAY_HAS_PART(1)
CGAL_DYNAMIC_DELAUNAY_COMPILE(, Dynamic_Delaunay_triangulation_2, Sequential_tag);
#endif
#if CGAL_DYNAMIC_DELAUNAY_HAS_PART(2)
CGAL_DYNAMIC_DELAUNAY_COMPILE(, Dynamic_periodic_Delaunay_triangulation_2, Sequential_tag);
#endif
#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PARALLEL
#if CGAL_DYNAMIC_DELAUNAY_HAS_PART(3)
CGAL_DYNAMIC_DELAUNAY_COMPILE(, Dynamic_Delaunay_triangulation_2, Parallel_tag);
#endif
#if CGAL_DYNAMIC_DELAUNAY_HAS_PART(4)
CGAL_DYNAMIC_DELAUNAY_COMPILE(, Dynamic_periodic_Delaunay_triangulation_2, Parallel_tag);
#endif
#endif

} // namespace CGAL
/// \endcond

#undef CGAL_DYNAMIC_DELAUNAY_HAS_PART

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_UPDATES_H
