// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/version_macros.h>

/// \file CGAL/Dynamic_Delaunay_triangulation_2/version.h
/// The version of this package. CMake reads it from here, so it is written nowhere else.

/// \ingroup PkgDynamicDelaunayTriangulation2Ref
/// grows when programs that use the package have to change
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_MAJOR 2

/// \ingroup PkgDynamicDelaunayTriangulation2Ref
/// grows when something is added
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_MINOR 0

/// \ingroup PkgDynamicDelaunayTriangulation2Ref
/// grows when something is only mended; at most 9
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_PATCH 0

/// \ingroup PkgDynamicDelaunayTriangulation2Ref
/// the version as text: `"1.2.3"`
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION                                              \
  CGAL_STR(CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_MAJOR)                                    \
  "." CGAL_STR(CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_MINOR) "." CGAL_STR(                  \
      CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_PATCH)

/// \ingroup PkgDynamicDelaunayTriangulation2Ref
/// the version as a number to compare with, in the form of `CGAL_VERSION_NR`: 1010231000 is 1.2.3
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_NR                                           \
  (1000001000 + CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_MAJOR * 10000000 +                   \
   CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_MINOR * 100000 +                                  \
   CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_PATCH * 10000)

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION_H
