// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_HOLD_AND_FLIP_REPAIR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_HOLD_AND_FLIP_REPAIR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Repairs

The default for exact classifiers. If so much is classified that mending would cost more than a
rebuild, it rebuilds at once. Otherwise it holds, flips and releases: vertices that would turn a
face over are held back, so that flips end with the Delaunay triangulation of the positions as they
stand; then the held vertices move on, and those that cannot arrive are taken out and inserted where
they belong (\ref DynamicDelaunayTriangulation2HoldFlipRelease). What is open even so, because a
vertex at a side of a slab cannot be taken out, it flips and splices.

An update with this repair and an exact classifier first looks at a sample of the edges. Where that
shows that a rebuild costs less, it rebuilds. Where much is broken, it takes the frame in two to
four equal steps, and calls the repair in each of them: all points stop on their ways, and
`Circumcircle_classifier_2` stands in for the classifier.

Where it is not known how the points have moved, as after a frame of a heuristic classifier, it
flips edges, and splices around the edges that flips cannot repair. It rebuilds if edges are still
open after that, or if the limit of cost is reached. So no edge stays open, not even with a
heuristic classifier.

\cgalModels{DelaunayRepair_2}
*/
class Hold_and_flip_repair_2
{
public:
  /// \param padding the number of padding layers of the second splice, which follows if the first
  ///   one, without padding, leaves edges open. Each further splice has one more layer.
  explicit Hold_and_flip_repair_2(unsigned padding = 1)
    : m_padding(padding)
  {
  }

  /// the number of layers.
  unsigned padding() const { return m_padding; }

  /// repairs.
  template <class Mender>
  void operator()(Mender& mender) const
  {
    if (mender.is_rebuild_cheaper())
      return mender.rebuild(Rebuild_reason_2::TOO_MUCH_BROKEN);
    mender.limit_cost();
    if (!mender.can_hold())
      return mend(mender);
    mender.hold();
    mender.flip();
    mender.release();
    if (!mender.is_done())
      mend(mender);
  }

  /// flips and splices, however much is classified; rebuilds if edges are open in the end.
  template <class Mender>
  void mend(Mender& mender) const
  {
    constexpr unsigned rounds = 6;
    mender.flip();
    for (unsigned round = 0; round < rounds && !mender.is_done(); ++round) {
      mender.splice_open(layers(round));
      mender.flip();
    }
    if (!mender.is_done())
      mender.rebuild(Rebuild_reason_2::STUCK);
  }

private:
  unsigned layers(unsigned round) const { return round == 0 ? 0 : m_padding + round - 1; }

  unsigned m_padding;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_HOLD_AND_FLIP_REPAIR_2_H
