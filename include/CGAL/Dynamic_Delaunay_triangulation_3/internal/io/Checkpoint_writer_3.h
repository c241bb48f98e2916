// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_WRITER_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_WRITER_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_coordinate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Writes the point that cells at infinity are seen from, if there is one.
template <class State>
void write_origin(Dynamic_Delaunay_triangulations_2::internal::Checkpoint_output_2& file,
                  const State& state)
{
  if (state.has_origin)
    file.line("origin", state.origin.x, state.origin.y, state.origin.z);
  else
    file.line("origin none");
}

// Writes a certified triangulation. The manual's page on checkpoints describes the file. What can
// be computed again from the points, which cells are neighbors and what there is without cells, is
// not written.
template <class State>
class Checkpoint_writer_3
{
  using Point = typename State::Point;
  using FT = std::decay_t<decltype(std::declval<const Point&>().x())>;
  using Coordinate = Dynamic_Delaunay_triangulations_2::internal::Checkpoint_coordinate_2<FT>;
  using Checkpoint_output_2 = Dynamic_Delaunay_triangulations_2::internal::Checkpoint_output_2;

public:
  Checkpoint_writer_3(const State& state, Checkpoint_output_2& file)
    : m_state(state)
    , m_file(file)
  {
  }

  void write();

private:
  static auto coordinates(const Point& p)
  {
    return std::make_tuple(Coordinate::text(p.x()), Coordinate::text(p.y()),
                           Coordinate::text(p.z()));
  }
  // Rounded coordinates are written as well: how a number was rounded depends on how it was
  // computed, which is not kept.
  auto coordinates(Vertex_index v) const
  {
    if constexpr (is_three_doubles<Point>)
      return coordinates(m_state.point(v));
    else
      return std::make_tuple(coordinates(m_state.point(v)), numbers(m_state.positions.position(v)));
  }
  static std::array<double, 3> numbers(const Position_3& p) { return {p.x, p.y, p.z}; }

  void write_cells()
  {
    const Tetrahedra_arrays_3& arrays = m_state.arrays;
    write_origin(m_file, m_state);
    m_file.line("cells", arrays.number_of_cells());
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
      const Vertices_3& v = arrays.vertices(c);
      m_file.line(v[0], v[1], v[2], v[3]);
    }
    m_file.line("corners", arrays.number_of_vertices());
    for (Vertex_index v(0); v < arrays.number_of_vertices(); ++v)
      m_file.line(arrays.corner_of(v));
  }

  const State& m_state;
  Checkpoint_output_2& m_file;
};

// Not inline: see `Update_3`.
template <class State>
void Checkpoint_writer_3<State>::write()
{
  m_file.line("coordinates", Coordinate::kind);
  m_file.line("positions", m_state.positions_are_exact ? "exact" : "rounded");
  m_file.line("dimension", m_state.dimension());
  Dynamic_Delaunay_triangulations_2::internal::write_points(
      m_file, m_state.ids, [this](Vertex_index v) { return coordinates(v); },
      [](const Point& p) { return coordinates(p); });
  if (m_state.spans_space)
    write_cells();
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_WRITER_3_H
