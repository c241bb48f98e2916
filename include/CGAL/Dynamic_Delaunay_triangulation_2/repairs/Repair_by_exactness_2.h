// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_REPAIR_BY_EXACTNESS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_REPAIR_BY_EXACTNESS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Repairs

What is usual for a classifier of which it is known only while a program runs whether it is exact:
`Hold_and_flip_repair_2` if the update has to end with a proof, else `Border_splice_repair_2`.

\cgalModels{DelaunayRepair_2}
*/
class Repair_by_exactness_2 : public Hold_and_flip_repair_2
{
public:
  using Hold_and_flip_repair_2::Hold_and_flip_repair_2;

  /// repairs.
  template <class Mender>
  void operator()(Mender& mender) const
  {
    if (mender.has_to_prove())
      return Hold_and_flip_repair_2::operator()(mender);
    const Border_splice_repair_2 splice(padding());
    splice(mender);
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_REPAIR_BY_EXACTNESS_2_H
