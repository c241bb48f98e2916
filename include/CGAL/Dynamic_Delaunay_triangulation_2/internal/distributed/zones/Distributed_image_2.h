// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_IMAGE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_IMAGE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

using Distributed_id_2 = std::int64_t;

// How messages begin that are about a point of a range, whose number follows: that is no id.
constexpr const char* point_at_place = "the point at place";

// A point as the user gave it, or as it is triangulated.
struct Distributed_entry_2
{
  Distributed_id_2 id;
  double x, y;
};

// The characters with which the checkpoints of a space begin.
template <std::size_t size>
constexpr std::array<char, size> checkpoint_name(const char (&name)[size])
{
  std::array<char, size> characters{};
  for (std::size_t i = 0; i < size; ++i)
    characters[i] = name[i];
  return characters;
}

// The shift of spaces in which each point has only one image.
struct No_shift_2
{
  friend bool operator<(const No_shift_2&, const No_shift_2&) { return false; }
};

// An image of a point: its position, and its shift from the position that the user gave.
template <class Shift>
struct Distributed_image_2 : Shift
{
  double x, y;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_ZONES_DISTRIBUTED_IMAGE_2_H
