// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_READER_BASE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_READER_BASE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What readers of files have in common in open and in periodic space. `Reader` reads a vertex, by
// `read_vertex()`, into the two arrays.
template <class Reader, class State>
class Checkpoint_reader_base_3
{
protected:
  using Point = typename State::Point;
  using Place = typename State::Place;
  using Checkpoint_input_2 = Dynamic_Delaunay_triangulations_2::internal::Checkpoint_input_2;

  Checkpoint_reader_base_3(State& state, Checkpoint_input_2& file)
    : m_state(state)
    , m_file(file)
  {
  }

  void read_points()
  {
    Dynamic_Delaunay_triangulations_2::internal::Checkpoint_points_reader_2(
        m_file, static_cast<Reader&>(*this), m_points, m_state.ids)
        .read();
    if (m_state.ids.number_of_points() > Input_3<State>::max_points)
      m_file.refuse("there are more points than 32 bits allow, above");
    m_state.positions.resize(m_state.number_of_vertices() + 1);
    for (std::size_t i = 0; i < m_places.size(); ++i)
      m_state.positions.set(Vertex_index(i + 1), m_places[i]);
  }

  void read_origin()
  {
    m_file.begin_entry("origin");
    const std::string_view word = m_file.word("the origin");
    m_state.has_origin = word != "none";
    if (m_state.has_origin) {
      using Dynamic_Delaunay_triangulations_2::internal::read_finite;
      if (!read_finite(word, m_state.origin.x))
        m_file.refuse("the origin", word, "none or a finite number");
      m_state.origin.y = m_file.finite("the origin");
      m_state.origin.z = m_file.finite("the origin");
    }
    m_file.end_line();
  }

  // The corners of the vertices from the first one to the last one. Each has to have a cell, so it
  // is enough that its corner is one of it.
  void read_corners(Vertex_index first, Index last)
  {
    auto& arrays = m_state.arrays;
    const Index number = last + 1 - first, corners = 4 * arrays.number_of_cells();
    m_file.number_entry("corners", number, number);
    for (Vertex_index v = first; v <= last; ++v) {
      m_file.next_line();
      if (corners == 0)
        m_file.refuse("there are points, and no cells");
      const Corner_index k(m_file.number("the corner", Index(0), corners - 1));
      m_file.end_line();
      if (arrays.vertex(k) != v)
        m_file.refuse("this is no corner of vertex " + std::to_string(v));
      arrays.set_corner(k);
    }
  }

  State& m_state;
  Checkpoint_input_2& m_file;
  std::vector<Point> m_points; // of vertices, from the first one on
  std::vector<Place> m_places; // of the same
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_READER_BASE_3_H
