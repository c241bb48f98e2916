// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_FLIP_REPAIR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_FLIP_REPAIR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Repairs

Flips edges (Lawson), and does nothing else. Where flips get stuck at inverted faces, an update with
an exact classifier rebuilds; one with a heuristic classifier leaves these faces.

\cgalModels{DelaunayRepair_2}
*/
class Flip_repair_2
{
public:
  /// repairs.
  template <class Mender>
  void operator()(Mender& mender) const
  {
    mender.flip();
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_FLIP_REPAIR_2_H
