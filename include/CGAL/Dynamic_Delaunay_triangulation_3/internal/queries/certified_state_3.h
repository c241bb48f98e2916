// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CERTIFIED_STATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CERTIFIED_STATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What queries read. Throws where nothing is proved.
template <class Dynamic>
const auto& certified_state(const Dynamic& dt)
{
  if (!dt.is_certified())
    throw Uncertified_triangulation_error_2(
        "there are no cells, since an exception has ended the last call: call mend()");
  return Access_3::state(dt);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CERTIFIED_STATE_3_H
