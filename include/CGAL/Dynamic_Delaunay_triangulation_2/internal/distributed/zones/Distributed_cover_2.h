// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_COVER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_COVER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_zone_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Where points are so dense, deep in a zone, that no face can reach out of it. Own points are added
// while positions of ghosts are under way.
//
// In the coordinates of the zone, which has been deformed, let b be the side of a block. Disks are
// ellipses there, whose longer axis is k times as long as the shorter one. A point p is *dense* if
// each of the 7 x 7 blocks around it has a point, and all cells of the zone within 2.83 k^2 b of
// its block are in the zone. Then the disk of each Delaunay face with the corner p is in the zone:
// an ellipse with the axes l and l / k contains the circle of diameter l / k^2 that touches it in
// p, as no radius of curvature of the ellipse is smaller. If that diameter were more than
// d = 2.83 b, the disk of diameter d within, with p on its circle, would contain a square of side
// d / sqrt(2) > 2 b, and so a whole block; that block is within d < 3 b of p, and has a point, but
// a Delaunay disk has none inside. So l is at most 2.83 k^2 b, and all of the ellipse is within
// that distance of p. A half plane beyond an edge of the hull would contain such a disk, too: a
// dense point is not at the hull. The error of the sides of blocks, 2^-22 cells, is covered as
// 2.83 > 2 sqrt(2).
class Distributed_density_2
{
public:
  void set_zone(const Distributed_zone_2& zone)
  {
    const double cells = 2.83 * double(Distributed_zone_2::cells_per_block) *
                         zone.deformation().squared_distortion() * (1 + 0x1p-20);
    const long around = (std::max)(3 * Distributed_zone_2::cells_per_block, long(cells) + 1);
    m_are_deep.clear();
    for (long row = 0; row < zone.block_rows(); ++row)
      for (long column = 0; column < zone.block_columns(); ++column)
        m_are_deep.push_back(zone.is_deep_block(column, row, around));
  }

  // Forgets the own points; so many of them will be added.
  void clear(std::size_t number)
  {
    m_have_own.assign(m_are_deep.size() + 1, 0);
    m_own_blocks.resize(number);
  }
  // Adds the k-th own point.
  void add_own(std::size_t k, const Distributed_zone_2& zone, const Position_2& p)
  {
    m_own_blocks[k] = zone.block(p.x, p.y);
    m_have_own[m_own_blocks[k]] = 1;
  }

  // Finds the dense blocks. `for_each_ghost(f)` calls f(p) for the position p of each ghost.
  template <class For_each_ghost>
  void find_dense(const Distributed_zone_2& zone, const For_each_ghost& for_each_ghost)
  {
    m_are_dense = m_have_own;
    for_each_ghost([&](const Position_2& p) { m_are_dense[zone.block(p.x, p.y)] = 1; });
    m_are_dense.back() = 0;
    keep_surrounded(1);
    keep_surrounded(std::size_t(zone.block_columns()));
    for (std::size_t k = 0; k < m_are_deep.size(); ++k)
      m_are_dense[k] = m_are_dense[k] & m_are_deep[k];
  }
  // Whether the k-th own point was dense in the last `find_dense()`.
  bool is_dense(std::size_t k) const { return m_are_dense[m_own_blocks[k]] != 0; }

private:
  // Keeps the marks of blocks whose three blocks before and three behind, at distances of `step`,
  // are marked too. These may be in other rows only for blocks with less than three blocks around
  // them, which are not deep.
  void keep_surrounded(std::size_t step)
  {
    const std::size_t blocks = m_are_deep.size(), around = 3 * step;
    if (blocks <= 2 * around)
      return m_are_dense.assign(blocks + 1, 0);
    m_are_surrounded.assign(blocks + 1, 0);
    const std::uint8_t* const before = m_are_dense.data();
    std::uint8_t* const after = m_are_surrounded.data() + around;
    for (std::size_t k = 0; k + 2 * around < blocks; ++k)
      after[k] = before[k] & before[k + step] & before[k + 2 * step] & before[k + 3 * step] &
                 before[k + 4 * step] & before[k + 5 * step] & before[k + 6 * step];
    m_are_dense.swap(m_are_surrounded);
  }

  std::vector<std::uint8_t> m_are_deep;       // by blocks
  std::vector<std::uint8_t> m_have_own;       // by blocks, then for places in none: own points?
  std::vector<std::uint32_t> m_own_blocks;    // by own points
  std::vector<std::uint8_t> m_are_dense;      // by blocks, then 0 for places in none
  std::vector<std::uint8_t> m_are_surrounded; // the next `m_are_dense`, while it is computed
};

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
    if (box.longer_side() <= 8 * zone.cell_size())
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
    if (box.width() > box.height())
      first.x_high = second.x_low = box.x_low + box.width() / 2;
    else
      first.y_high = second.y_low = box.y_low + box.height() / 2;
    return {first, second};
  }

  bool is_covered(const Question& disk, const Distributed_zone_2& zone, const Box_2& box,
                  int& budget) const
  {
    if (!disk.may_meet<Kernel>(box) || zone.covers(box) || m_outline.excludes(box))
      return true;
    if (box.longer_side() <= zone.cell_size() / 4 || --budget < 0)
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
    if (box.longer_side() <= zone.cell_size())
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
