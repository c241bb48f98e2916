// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_CHECKPOINT_WRITER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_CHECKPOINT_WRITER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_memory_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Periodic_certificate_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <ostream>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Writes a periodic triangulation. The manual's page on checkpoints describes the file.
template <class State>
class Periodic_checkpoint_writer_2
{
public:
  Periodic_checkpoint_writer_2(const State& state, bool is_certified,
                               const Periodic_memory_2& memory)
    : m_state(state)
    , m_is_certified(is_certified)
    , m_memory(memory)
  {
  }

  // `append(file)` adds the lines that are not part of the triangulation.
  template <class Append>
  void write(std::ostream& out, std::string_view subject, const Append& append) const
  {
    if (!m_is_certified && !Periodic_certificate_2<State>(m_state).is_triangulation())
      refuse_incomplete_triangulation();
    Checkpoint_output_2 file(out, subject);
    write_cell(file);
    file.line("certified", m_is_certified ? "yes" : "no");
    file.line("mean_way", m_memory.mean_way.x, m_memory.mean_way.y);
    file.line("walk_start", m_memory.hint);
    file.line("ids", m_state.ids().number_of_ids());
    const auto write_vertex = [&](Index v) {
      const Position_2& p = m_state.positions()[v];
      file.line(m_state.ids().representative(v), p.x, p.y);
    };
    write_checkpoint_points(file, m_state.ids(), write_vertex,
                            [](const Position_2& p) { return std::make_pair(p.x, p.y); });
    write_topology(file);
    append(file);
    file.finish();
  }

private:
  void write_cell(Checkpoint_output_2& file) const
  {
    const Periodic_cell_2& cell = m_state.torus().cell();
    file.line("slab", cell.is_slab() ? "yes" : "no");
    if (cell.is_slab())
      file.line("cell", cell.ax(), cell.ay());
    else
      file.line("cell", cell.ax(), cell.ay(), cell.bx(), cell.by());
  }

  // The first corner of a face has no shift. Two vertices can have several edges, so the twins do
  // not follow from the faces.
  void write_topology(Checkpoint_output_2& file) const
  {
    const auto& arrays = m_state.arrays();
    file.line("faces", arrays.number_of_faces());
    for (Index h = 0; h < 3 * arrays.number_of_faces(); h += 3) {
      const Periodic_shift_2 &s = m_state.shift(h + 1), &t = m_state.shift(h + 2);
      file.line(arrays.apex(h), arrays.apex(h + 1), arrays.apex(h + 2), s[0], s[1], t[0], t[1]);
    }
    file.line("corners", m_state.number_of_vertices());
    for (Index v = 1; v <= m_state.number_of_vertices(); ++v)
      file.line(arrays.corner(v));
    file.line("edges", arrays.number_of_edges());
    for (Index e = 0; e < arrays.number_of_edges(); ++e)
      file.line(arrays.halfedge(e), arrays.twin(arrays.halfedge(e)));
  }

  const State& m_state;
  bool m_is_certified;
  Periodic_memory_2 m_memory;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_CHECKPOINT_WRITER_2_H
