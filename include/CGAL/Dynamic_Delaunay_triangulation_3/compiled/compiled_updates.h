// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_COMPILED_UPDATES_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_COMPILED_UPDATES_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

// Include this header in exactly one source file of a program that defines
// CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED in all its files. It compiles for all of them what
// updates and checkpoints need in open and in periodic space, with the usual kernel, whatever the
// policy and the visitor are; also for `Parallel_tag` if all files define
// CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_PARALLEL, too. To compile it in several source
// files, define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_PART in each of them: as 1 or 2, and
// for `Parallel_tag` as 3 or 4. CMake's targets `Dynamic_Delaunay_triangulation_2::compiled_3` and
// `compiled_3_parallel` do that. For the plane there is a header of the same name.
#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED
#error                                                                                             \
    "compiled_updates.h is for programs that define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED in all files"
#endif

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_PART
#define CGAL_DYNAMIC_DELAUNAY_HAS_PART_3(i)                                                        \
  (CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_PART == i)
#else
#define CGAL_DYNAMIC_DELAUNAY_HAS_PART_3(i) 1
#endif

/// \cond
namespace CGAL {

#if CGAL_DYNAMIC_DELAUNAY_HAS_PART_3(1)
CGAL_DYNAMIC_DELAUNAY_COMPILE_3(, Open_space_3, Sequential_tag);
#endif
#if CGAL_DYNAMIC_DELAUNAY_HAS_PART_3(2)
CGAL_DYNAMIC_DELAUNAY_COMPILE_3(, Torus_space_3, Sequential_tag);
#endif
#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_PARALLEL
#if CGAL_DYNAMIC_DELAUNAY_HAS_PART_3(3)
CGAL_DYNAMIC_DELAUNAY_COMPILE_3(, Open_space_3, Parallel_tag);
#endif
#if CGAL_DYNAMIC_DELAUNAY_HAS_PART_3(4)
CGAL_DYNAMIC_DELAUNAY_COMPILE_3(, Torus_space_3, Parallel_tag);
#endif
#endif

} // namespace CGAL
/// \endcond

#undef CGAL_DYNAMIC_DELAUNAY_HAS_PART_3

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_COMPILED_UPDATES_H
