// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_WRITER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_WRITER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_costs_2.h>

#include <ostream>
#include <string_view>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Writes a maintained triangulation. The manual's page on checkpoints describes the file.
template <class State>
class Checkpoint_writer_2
{
  using Point = typename State::Point;
  using FT = std::decay_t<decltype(std::declval<Point>().x())>;
  using Coordinate = Checkpoint_coordinate_2<FT>;
  static_assert(is_made_of_x_and_y<Point>,
                "a checkpoint keeps x and y, which are not all of these points");

public:
  Checkpoint_writer_2(const State& state, bool is_certified, const Repair_experience_2& experience)
    : m_state(state)
    , m_is_certified(is_certified)
    , m_experience(experience)
  {
  }

  // `append(file)` adds the lines that are not part of the triangulation.
  template <class Append>
  void write(std::ostream& out, std::string_view subject, const Append& append) const
  {
    check_completeness();
    Checkpoint_output_2 file(out, subject);
    file.line("coordinates", Coordinate::kind);
    file.line("positions", m_state.positions_are_exact() ? "exact" : "rounded");
    file.line("certified", m_is_certified ? "yes" : "no");
    file.line("hopeless_share", m_experience.hopeless_share());
    file.line("dimension", m_state.triangulation().dimension());
    file.line("ids", m_state.ids().number_of_ids());
    write_checkpoint_points(
        file, m_state.ids(), [&](Index v) { write_vertex(file, v); },
        [&](const Point& p) {
          return std::make_pair(Coordinate::text(p.x()), Coordinate::text(p.y()));
        });
    if (m_state.spans_plane())
      write_topology(file);
    append(file);
    file.finish();
  }

private:
  void check_completeness() const
  {
    bool is_complete = m_is_certified || m_state.spans_plane();
    for (const auto& duplicate : m_state.ids().duplicates())
      is_complete =
          is_complete && duplicate.point == m_state.point(m_state.ids().vertex(duplicate.id));
    if (!is_complete)
      refuse_incomplete_triangulation();
  }

  // Rounded coordinates are written as well: how a number was rounded depends on how it was
  // computed, which is not kept.
  void write_vertex(Checkpoint_output_2& file, Index v) const
  {
    const Point& p = m_state.point(v);
    const Index id = m_state.ids().representative(v);
    const Position_2& position = m_state.positions()[v];
    if constexpr (State::coordinates_are_doubles)
      file.line(id, p.x(), p.y());
    else
      file.line(id, Coordinate::text(p.x()), Coordinate::text(p.y()), position.x, position.y);
  }

  void write_topology(Checkpoint_output_2& file) const
  {
    const auto& arrays = m_state.arrays();
    file.line("faces", arrays.number_of_faces());
    for (Index f = 0; f < arrays.number_of_faces(); ++f)
      file.line(arrays.apex(3 * f), arrays.apex(3 * f + 1), arrays.apex(3 * f + 2));
    file.line("corners", arrays.number_of_vertices());
    for (Index v = 0; v < arrays.number_of_vertices(); ++v)
      file.line(arrays.corner(v), arrays.corner(v) / 3);
    file.line("edges", arrays.number_of_edges());
    for (Index e = 0; e < arrays.number_of_edges(); ++e) {
      const Index h = arrays.halfedge(e);
      file.line(arrays.source(h) == arrays.edge(e).source ? h : arrays.twin(h), h);
    }
  }

  const State& m_state;
  bool m_is_certified;
  Repair_experience_2 m_experience;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_WRITER_2_H
