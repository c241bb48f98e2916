// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_FRAME_RECORD_H
#define SCENARIO_RUNNER_FRAME_RECORD_H

#include "scenario_runner/Cells_in_domains.h"
#include "scenario_runner/Motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace run {

// Nanoseconds.
struct Frame_times
{
  double dynamic = 0.0;
  double static_insert = 0.0;
  double static_fastest = 0.0;
};

// What is told of a frame in the plane and in space.
struct Frame_facts
{
  std::size_t frame = 0;   // how many came before it
  std::int64_t number = 0; // that the motion's recording has for it, or else the same
  double time = 0.0;       // of the motion
  std::size_t points = 0;
  bool population_changed = false;
  bool certified = false;
  Frame_times nanoseconds{};
};

struct Frame_record : Frame_facts
{
  CGAL::Update_report_2 update{};
  double validity = 1.0;
};

// The sets of thesis 4.1.3, by the numbers that files have for them.
enum class Vertex_set : std::uint8_t { none, border, padded, classified };

// An edge. In periodic space it ends at an image of `to`, as triangles have corners at images: at
// the points shifted by the sides of the motion's cell.
struct Shown_edge
{
  std::size_t from;
  std::size_t to;
  bool is_delaunay; // needs no repair
  scenario::Shift shift{};
};

struct Shown_triangle
{
  std::array<std::size_t, 3> corners;
  bool is_delaunay; // none of its edges needs repair
  std::array<scenario::Shift, 3> shifts{};
};

// The measures of the part of a point's Voronoi cell that is within a radius or a domain.
struct Shown_cell
{
  double area;
  double perimeter;
  std::size_t contacts; // neighbors that it touches
  double free_length;
  double wall_length;
};

// The current frame of a run, for pictures and files. Points are known by their places in the
// motion; coincident points share the edges and triangles of the first of them.
class Run_view
{
public:
  virtual ~Run_view() = default;

  virtual const scenario::Motion& motion() const = 0;
  virtual const Frame_record& record() const = 0;
  virtual std::vector<Vertex_set> sets() const = 0; // of each point
  virtual std::vector<Shown_edge> edges() const = 0;
  virtual std::vector<Shown_triangle> triangles() const = 0;
  // The cell of each point, in the domain of `bounded`. The frame must be certified.
  virtual std::vector<Shown_cell> cells(Cells_in_domains& bounded, double radius) const = 0;
};

// The set of each vertex of a run's frame. A rebuild numbers vertices anew after they have been
// classified: then no vertex is in a set.
template <class Run>
std::vector<Vertex_set> sets_of_vertices(const Run& run)
{
  const auto& triangulation = run.triangulation();
  std::vector<Vertex_set> sets(triangulation.number_of_vertices() + 1, Vertex_set::none);
  if (run.record().update.rebuilt()) {
    return sets;
  }
  for (const auto v : triangulation.border_vertices()) {
    sets[v] = Vertex_set::border;
  }
  for (const auto v : triangulation.padded_vertices()) {
    sets[v] = Vertex_set::padded;
  }
  for (const auto v : triangulation.classified_vertices()) {
    sets[v] = Vertex_set::classified;
  }
  return sets;
}

// Of each face, whether all its edges are Delaunay.
template <class Frame>
std::vector<bool> are_faces_delaunay(const Frame& frame)
{
  using Edge_index = typename Frame::Edge_index;
  using Face_index = typename Frame::Face_index;
  std::vector<bool> are_delaunay(frame.number_of_faces(), true);
  for (Edge_index e(0); e != frame.number_of_edges(); ++e) {
    if (!frame.is_delaunay(e)) {
      for (const Face_index f : frame.faces_at(e)) {
        are_delaunay[f] = false;
      }
    }
  }
  return are_delaunay;
}

} // namespace run

#endif // SCENARIO_RUNNER_FRAME_RECORD_H
