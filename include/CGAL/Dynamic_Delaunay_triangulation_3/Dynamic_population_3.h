// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_POPULATION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_POPULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_population_base.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>

#include <cstdint>
#include <string_view>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Maintains the Delaunay triangulation of a population in space that changes while it moves, as in
tracking data. Every frame lists the points that exist, by ids that the user chooses. Points with
new ids are inserted, points whose ids are missing are removed, and the others move: what
`Dynamic_population_2` does in the plane.

Removing a point costs some ten insertions. If memory runs out, there are no cells until the next
call; `mend()` makes them again.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_3` or a
`Dynamic_periodic_Delaunay_triangulation_3`. \tparam UserId any integer type.
*/
template <class Dynamic, class UserId = std::int64_t>
class Dynamic_population_3
  : public Dynamic_population_base<Dynamic_population_3<Dynamic, UserId>, Dynamic, UserId>
{
  using Base = Dynamic_population_base<Dynamic_population_3, Dynamic, UserId>;
  friend Base;
  static constexpr std::string_view checkpoint_subject = "Dynamic_population_3";

public:
  using Base::Base;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_POPULATION_3_H
