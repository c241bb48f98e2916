// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PICTURE_LEGEND_H
#define RUN_PICTURE_LEGEND_H

#include "Vertex_sets.h"

#include <array>
#include <cstddef>

namespace run {

// How a picture shows the points of a set, and what they are.
struct Set_legend
{
  Vertex_set set;
  const char* color;
  const char* name;
  const char* meaning;
};

// In the colors of figure 4.1 of the thesis; a picture draws the later ones over the others.
constexpr std::array<Set_legend, 4> set_legends = {
    {{Vertex_set::none, "#333333", "other", "all other points"},
     {Vertex_set::border, "cyan", "border", "the layer of neighbors beyond the padded points"},
     {Vertex_set::padded, "green", "padded", "layers of neighbors around the classified points"},
     {Vertex_set::classified, "red", "classified",
      "points that the classifier found, whose edges may be broken"}}};

constexpr const char* edge_color = "#888888";

} // namespace run

#endif // RUN_PICTURE_LEGEND_H
