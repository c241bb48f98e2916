// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_BORDER_SPLICE_REPAIR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_BORDER_SPLICE_REPAIR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Repairs

The border splice of the thesis (4.1.3 and 4.1.4): it triangulates only the classified vertices,
`padding` layers of neighbors around them and one layer of border. The new faces around the
classified and padded vertices replace the old ones. Where the boundaries of old and new faces
disagree, the region is enlarged until they agree, or everything is rebuilt. So no edge can be
missing.

With an exact classifier the splice is repeated around the edges that are still open, with more
padding each time.

\cgalModels{DelaunayRepair_2}
*/
class Border_splice_repair_2
{
public:
  /// \param padding the number of layers, 1 in the thesis; may be 0.
  explicit Border_splice_repair_2(unsigned padding = 1)
    : m_padding(padding)
  {
  }

  /// the number of layers.
  unsigned padding() const { return m_padding; }

  /// repairs.
  template <class Mender>
  void operator()(Mender& mender) const
  {
    constexpr unsigned rounds = 4;
    mender.splice_classified(m_padding);
    for (unsigned round = 1; round < rounds && mender.has_to_prove() && !mender.is_done(); ++round)
      mender.splice_open(m_padding + round);
  }

private:
  unsigned m_padding;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_BORDER_SPLICE_REPAIR_2_H
