// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PLANE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PLANE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_deformation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_outline_2.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The open plane, as a space of distributed points. Each point has one image, itself.
template <class Kernel_>
class Distributed_plane_2
{
public:
  using Kernel = Kernel_;
  using Shift = No_shift_2;
  using Image = Distributed_image_2<Shift>;
  template <class Points>
  using Outline = Distributed_outline_2<Points>;

  static constexpr bool is_periodic = false;
  // The number of vertices, minus edges, plus finite faces: that of a disk.
  static constexpr std::uint64_t euler_characteristic = 1;

  // What a checkpoint stores about the space.
  struct Parameters
  {
  };
  static constexpr std::array<char, 24> file_name = checkpoint_name("distributed Delaunay 1\n");

  Distributed_plane_2() = default;
  explicit Distributed_plane_2(const Parameters&) {}
  Parameters parameters() const { return {}; }
  // Throws unless all ranks were given the same space. Collective.
  void agree(Distributed_ranks_2&) const {}

  // Returns the position that is triangulated for a point of the user. Throws if it is refused.
  template <class Point>
  Position_2 checked(const Point& p, std::size_t place) const
  {
    return checked_position(p, place);
  }

  // The image of a point that its owner holds: of a new point, and of one that has moved.
  Image first_image(const Position_2& given) const { return {{}, given.x, given.y}; }
  Image next_image(const Position_2& given, const Position_2&, const Distributed_plane_2&) const
  {
    return first_image(given);
  }
  // The position that the user gave for the point of such an image.
  Position_2 given(const Image& image) const { return {image.x, image.y}; }

  // The vector of a shift, an image moved by that vector, and whether the vector is 0.
  Position_2 vector(const Shift&) const { return {0, 0}; }
  Image translated(const Image& image, const Shift&) const { return image; }
  bool is_none(const Shift&) const { return true; }
  // Calls f(shift) for each shift that may move a place of the first box into the second one.
  template <class Function>
  void for_each_shift(const Box_2&, const Box_2&, const Function& f) const
  {
    f(Shift());
  }

  // The vectors that are deformed with the space.
  Basis_2 basis() const { return unit_basis; }
  // The size of the smallest cells of a zone, divided by the largest coordinate.
  static constexpr double finest_zone = 0x1p-40;

  // Whether ghosts and zones that ranks have sent each other in the other space stay of use.
  bool continues(const Distributed_plane_2&) const { return true; }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_PLANE_2_H
