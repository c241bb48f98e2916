// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_CHECK_CERTIFIED_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_CHECK_CERTIFIED_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Throws unless the periodic triangulation is certified.
template <class Dynamic>
void check_certified(const Dynamic& pt)
{
  if (!pt.is_certified())
    throw Uncertified_triangulation_error_2(
        "the periodic triangulation is not certified after a heuristic update, or after a change "
        "that was interrupted: call mend() to make it Delaunay");
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_CHECK_CERTIFIED_2_H
