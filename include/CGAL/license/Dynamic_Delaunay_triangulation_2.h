// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_LICENSE_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

// What CGAL's packages tell of their licences, by the same macros: nothing, but with
// CGAL_LICENSE_WARNING a warning, and with CGAL_LICENSE_ERROR an error, unless
// CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMMERCIAL_LICENSE is the date of a licence that is valid.

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMMERCIAL_LICENSE

#if CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE
#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("The commercial license of 2D Dynamic Delaunay Triangulation that is defined "
                    "is older than this release.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "The commercial license of 2D Dynamic Delaunay Triangulation is older than this release."
#endif
#endif

#else

#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMMERCIAL_LICENSE is not defined: "
                    "2D Dynamic Delaunay Triangulation is used under the terms of the GPLv3+.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "2D Dynamic Delaunay Triangulation would be used under the GPLv3+, see CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMMERCIAL_LICENSE

#endif // CGAL_LICENSE_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
