// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_COVER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_COVER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_zone_2.h>

#include <algorithm>
#include <array>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Tests whether a zone covers the part of a disk where points can be: within the hull of all
// points. Disks of flat faces at the hull are large, but lie mostly beyond the hull. Boxes around
// disks are halved until each is proved to be in the zone, off the disk or beyond the hull.
template <class Kernel, class Outline>
class Distributed_cover_2
{
  using Question = Distributed_question_2;

public:
  explicit Distributed_cover_2(const Outline& outline)
    : m_outline(outline)
  {
  }

  bool is_covered(const Question& disk, const Distributed_zone_2& zone) const
  {
    if (zone.is_empty())
      return false;
    const Position_2 p = disk.corner(0);
    if (disk.is_narrow(zone.depth_around(p.x, p.y)))
      return true;
    const Box_2 box = disk.box_of_disk();
    if (zone.covers(box))
      return true;
    int budget = most_boxes;
    return is_covered(disk, zone, box.common_part(m_outline.box_for(disk)), budget);
  }

  // Adds all places closer than `margin` to the part of the disk within the hull to the zone, which
  // has no sums yet; up to rounding, and except for places that would take too many boxes.
  void extend(const Question& disk, Distributed_zone_2& zone, double margin) const
  {
    const Box_2 box = disk.box_of_disk();
    const double size = (std::max)(box.x_high - box.x_low, box.y_high - box.y_low);
    if (size <= 8 * zone.cell_size())
      return zone.add(box.enlarged(margin));
    int budget = most_boxes;
    extend(disk, zone, margin, box.common_part(m_outline.box_for(disk)).enlarged(margin), budget);
  }

private:
  // Disks of faces that are flat along the hull are as long as its edges. With only 4096 boxes
  // zones do not reach around them, and eight ranks ask about such faces in 80 of 100 calm frames.
  static constexpr int most_boxes = 1 << 15;

  static std::array<Box_2, 2> halves(const Box_2& box)
  {
    Box_2 first = box, second = box;
    if (box.x_high - box.x_low > box.y_high - box.y_low)
      first.x_high = second.x_low = box.x_low + (box.x_high - box.x_low) / 2;
    else
      first.y_high = second.y_low = box.y_low + (box.y_high - box.y_low) / 2;
    return {first, second};
  }

  static bool is_small(const Box_2& box, double size)
  {
    return (std::max)(box.x_high - box.x_low, box.y_high - box.y_low) <= size;
  }

  bool is_covered(const Question& disk, const Distributed_zone_2& zone, const Box_2& box,
                  int& budget) const
  {
    if (!disk.may_meet<Kernel>(box) || zone.covers(box) || m_outline.excludes(box))
      return true;
    if (is_small(box, zone.cell_size() / 4) || --budget < 0)
      return false;
    for (const Box_2& half : halves(box))
      if (!is_covered(disk, zone, half, budget))
        return false;
    return true;
  }

  void extend(const Question& disk, Distributed_zone_2& zone, double margin, const Box_2& box,
              int& budget) const
  {
    const Box_2 around = box.enlarged(margin);
    if (!disk.may_meet<Kernel>(around) || m_outline.excludes_about(around))
      return;
    if (is_small(box, zone.cell_size()))
      return zone.add(box);
    if (--budget < 0)
      return;
    for (const Box_2& half : halves(box))
      extend(disk, zone, margin, half, budget);
  }

  const Outline& m_outline;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_COVER_2_H
