// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_LATTICE_WINDOW_H
#define SCENARIO_RUNNER_LATTICE_WINDOW_H

#include "scenario_runner/Cell.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace run {

// The image of a point of the motion by a shift along the sides of its cell.
struct Image
{
  std::uint32_t place;
  scenario::Shift shift;
  scenario::Point point; // rounded
};

// A part of the plane that has one image of each point: a parallelogram of two short vectors of the
// lattice, or the strip between two images of a line across a slab.
class Lattice_window
{
public:
  // \throws std::runtime_error if the cell is too thin for short vectors to be found.
  explicit Lattice_window(const scenario::Cell& cell);

  // All images in the window and in a margin as wide as this around it, or a little wider.
  // \throws std::runtime_error if a point is too far from the cell.
  std::vector<Image> images(const std::vector<scenario::Point>& points, double margin) const;

  // Whether p is in the window, and not only in a margin.
  bool contains(const scenario::Point& p) const;

  // How far a disk goes beyond the window, or less than 0.
  double overhang(const scenario::Point& center, double radius) const;

  // A margin that is enough for every face with a corner in the window, whatever the points are:
  // its circle, if it is empty of these images, is empty of all.
  //
  // For two vectors u and v: any point has an image of any other one within (|u| + |v|) / 2. So
  // there is an image of the corner in each disk with a larger radius, also in one that touches the
  // circle at the corner from inside: an empty circle has no larger radius, and all images in it
  // are within |u| + |v| of the corner.
  //
  // For a slab and its vector u: the images of the corner on both sides are not in the circle, so
  // its center is within |u| / 2 of the corner, along u. Any other point that has an image in the
  // circle has one there within |u| / 2 of the center, so within |u| of the corner.
  double safe_margin() const;

  bool is_slab() const { return m_cell.is_slab(); }
  // Of a slab: the coordinate across it.
  double across(const scenario::Point& p) const;

private:
  // Coordinates of p as multiples of the vectors, from the corner.
  scenario::Point coordinates(const scenario::Point& p) const;
  void shorten_vectors();

  scenario::Cell m_cell;
  std::array<scenario::Shift, 2> m_shifts{};  // the vectors, in sides of the cell
  std::array<scenario::Point, 2> m_vectors{}; // the second one of a slab stands across
  std::array<double, 2> m_heights{};          // between opposite sides of the window
};

} // namespace run

#endif // SCENARIO_RUNNER_LATTICE_WINDOW_H
