// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CERTIFIED_STATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CERTIFIED_STATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_triangulation_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>

#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

template <class Dynamic>
using State_of_3 =
    std::decay_t<decltype(Triangulation_access::state(std::declval<const Dynamic&>()))>;

template <class Dynamic>
constexpr bool is_periodic_3 = Site_charts_3<typename State_of_3<Dynamic>::Arrays>::is_periodic;

// What queries read. Throws where nothing is proved.
template <class Dynamic>
const State_of_3<Dynamic>& certified_state(const Dynamic& dt)
{
  if (!dt.is_certified())
    throw Uncertified_triangulation_error_2(
        "there are no cells, since an exception has ended the last call: call mend()");
  return Triangulation_access::state(dt);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CERTIFIED_STATE_3_H
