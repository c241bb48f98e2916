// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_WRITER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_WRITER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <ostream>
#include <string_view>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Writes a maintained triangulation. The manual's page on checkpoints describes the file.
template <class State>
class Checkpoint_writer_2
{
  using Space = Checkpoint_space_2<State>;
  using Memory = typename Space::Memory;

public:
  Checkpoint_writer_2(const State& state, bool is_certified, const Memory& memory)
    : m_state(state)
    , m_is_certified(is_certified)
    , m_memory(memory)
  {
  }

  // `append(file)` adds the lines that are not part of the triangulation.
  template <class Append>
  void write(std::ostream& out, std::string_view subject, const Append& append) const
  {
    check_completeness();
    Checkpoint_output_2 file(out, subject);
    Space::write_kind(file, m_state);
    file.line("certified", m_is_certified ? "yes" : "no");
    Space::write_memory(file, m_state, m_memory);
    write_points(file);
    if (Space::has_faces(m_state))
      write_topology(file);
    append(file);
    file.finish();
  }

private:
  // An exception in the middle of an update can leave a state that the next update repairs. Such
  // a state must not be written, because no reader could tell it from a damaged file.
  void check_completeness() const
  {
    if (!Space::is_complete(m_state, m_is_certified))
      throw Checkpoint_error_2(0, "an exception has ended the last call before each point had its "
                                  "vertex: write after the next update()");
  }

  void write_points(Checkpoint_output_2& file) const
  {
    const auto& ids = m_state.ids();
    file.line("ids", ids.number_of_ids());
    file.line("vertices", ids.number_of_representatives());
    for (Vertex_index v = 1; v <= ids.number_of_representatives(); ++v)
      file.line(ids.representative(v), Space::coordinates(m_state, v));
    file.line("duplicates", ids.duplicates().size());
    for (const auto& duplicate : ids.duplicates())
      file.line(duplicate.id, ids.vertex(duplicate.id), Space::coordinates(duplicate.point));
    file.line("free_ids", ids.number_of_ids() - ids.number_of_points());
    for (Point_id id = 0; id < ids.number_of_ids(); ++id)
      if (!ids.is_taken(id))
        file.line(id);
  }

  void write_topology(Checkpoint_output_2& file) const
  {
    const auto& arrays = m_state.arrays();
    const Index beyond = m_state.number_of_vertices() + 1;
    file.line("faces", arrays.number_of_faces());
    for (Face_index f = 0; f < arrays.number_of_faces(); ++f)
      file.line(arrays.face(f), Space::rest_of_face(m_state, f));
    file.line("corners", beyond - Space::first_vertex);
    for (Vertex_index v = Space::first_vertex; v < beyond; ++v)
      file.line(arrays.corner(v), Space::rest_of_corner(arrays.corner(v)));
    file.line("edges", arrays.number_of_edges());
    for (Edge_index e = 0; e < arrays.number_of_edges(); ++e)
      file.line(Space::halfedges(arrays, e));
  }

  const State& m_state;
  bool m_is_certified;
  Memory m_memory;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_WRITER_2_H
