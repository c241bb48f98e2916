// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Surface_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_experience_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What is different in the checkpoints of each space, a class `Space` says: `Checkpoint_plane_2` or
// `Checkpoint_torus_2`. A writer calls its static functions. A reader owns an object, whose
// constructor reads the first lines.

// Writes a maintained triangulation. The manual's page on checkpoints describes the file.
template <class State, class Space>
class Checkpoint_writer_2
{
public:
  Checkpoint_writer_2(const State& state, bool is_certified, const Repair_experience_2& memory)
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
    file.line("hopeless_share", m_memory.hopeless_share());
    Space::write_dimension(file, m_state);
    write_points(
        file, m_state.ids(), [this](Vertex_index v) { return Space::coordinates(m_state, v); },
        [](const auto& p) { return Space::coordinates(p); });
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
    bool is_complete = Space::is_complete(m_state, m_is_certified);
    m_state.ids().for_each_covered([&](Point_id, Vertex_index v, const auto& p) {
      is_complete = is_complete && m_state.is_at(p, v);
    });
    if (!is_complete)
      throw Checkpoint_error_2(0, "an exception has ended the last call before each point had its "
                                  "vertex: write after the next update()");
  }

  void write_topology(Checkpoint_output_2& file) const
  {
    const auto& arrays = m_state.arrays();
    const Index beyond = m_state.number_of_vertices() + 1;
    file.line("faces", arrays.number_of_faces());
    for (Face_index f(0); f < arrays.number_of_faces(); ++f)
      file.line(arrays.face(f), Space::rest_of_face(m_state, f));
    file.line("corners", beyond - State::first_vertex);
    for (Vertex_index v = State::first_vertex; v < beyond; ++v)
      file.line(arrays.corner(v), Space::rest_of_corner(arrays.corner(v)));
    file.line("edges", arrays.number_of_edges());
    for (Edge_index e(0); e < arrays.number_of_edges(); ++e)
      file.line(Space::halfedges(arrays, e));
  }

  const State& m_state;
  bool m_is_certified;
  Repair_experience_2 m_memory;
};

// Reads a triangulation that Checkpoint_writer_2 has written. Every value is validated before it is
// used, and memory is allocated only for what was read, whatever numbers the file announces.
template <class State, class Space>
class Checkpoint_reader_2
{
  using Point = typename Space::Point;

public:
  explicit Checkpoint_reader_2(Checkpoint_input_2& file)
    : m_file(file)
  {
  }

  // Reads into an empty triangulation, which can only be discarded if this throws.
  void read(State& state)
  {
    m_is_certified = m_file.flag_entry("certified", "yes", "no");
    const std::size_t line = m_file.line();
    m_memory.restore(
        m_file.number_entry("hopeless_share", std::size_t(1), Repair_experience_2::all));
    m_space.read_dimension(m_is_certified);
    Checkpoint_points_reader_2(m_file, m_space, m_kept.points, m_kept.ids).read();
    if (m_space.has_faces())
      read_topology();
    m_space.restore(state);
    if (m_is_certified && !m_space.is_delaunay(state))
      m_file.refuse(line, "the triangulation is not Delaunay, and cannot be certified");
  }

  bool is_certified() const { return m_is_certified; }
  const Repair_experience_2& memory() const { return m_memory; }

private:
  Index number_of_vertices() const { return Index(m_kept.points.size()); }

  // TOPOLOGY ------------------------------------------------------------------------------------

  // Which faces are neighbors, the space finds when the faces are read, or when the edges are.
  void read_topology()
  {
    read_faces();
    const std::size_t first_line = m_file.line() + 1 - m_kept.faces.number_of_faces();
    Surface_check_2 check(m_kept.faces, number_of_vertices() + 1, State::first_vertex);
    refuse(first_line, m_space.link_faces(check));
    read_corners();
    read_edges();
    refuse(first_line, m_space.check_links(check));
  }

  void refuse(std::size_t first_line, const Surface_check_2::Flaw& flaw) const
  {
    if (flaw.what)
      m_file.refuse(first_line + flaw.face, flaw.what);
  }

  // By Euler's formula.
  Index number_of_faces() const { return 2 * (number_of_vertices() - Space::missing_pairs); }
  Index number_of_halfedges() const { return 3 * number_of_faces(); }

  // Reads the number of lines that follow, which has to be `number`.
  Index read_number(const char* name, Index number)
  {
    return m_file.number_entry(name, number, number);
  }

  void read_faces()
  {
    const Index number = read_number("faces", number_of_faces());
    for (Face_index f(0); f < number; ++f) {
      m_file.next_line();
      m_kept.faces.resize(f + std::size_t(1));
      for (Index i = 0; i < 3; ++i)
        m_kept.faces.set_apex(Flat_faces_2::first_halfedge(f) + i,
                              Vertex_index(m_file.number("the vertex", Index(State::first_vertex),
                                                         number_of_vertices())));
      m_space.read_rest_of_face(f);
    }
  }

  void read_corners()
  {
    Vertex_index v = State::first_vertex;
    const Index beyond = v + read_number("corners", number_of_vertices() + 1 - v);
    for (; v < beyond; ++v) {
      m_file.next_line();
      const Halfedge_index h = read_halfedge();
      const bool is_rest_right = m_space.read_rest_of_corner(v);
      m_file.end_line();
      if (!is_rest_right || m_kept.faces.apex(Flat_faces_2::from_arrays(h)) != v)
        m_file.refuse(Space::wrong_corner + std::to_string(v));
      m_kept.corners.push_back(h);
    }
  }

  // There are as many edges as pairs of half-edges, so it is enough that no half-edge occurs twice.
  void read_edges()
  {
    const Index number = read_number("edges", number_of_halfedges() / 2);
    std::vector<bool> is_listed(number_of_halfedges());
    for (Edge_index e(0); e < number; ++e) {
      m_file.next_line();
      const Halfedge_index h = read_halfedge(), g = read_halfedge();
      m_file.end_line();
      const Halfedge_index twin = m_space.checked_twin(h, g, is_listed);
      is_listed[h] = is_listed[twin] = true;
      m_kept.forward_halfedges.push_back(h);
      m_kept.halfedges.push_back(g);
    }
  }

  Halfedge_index read_halfedge()
  {
    return Halfedge_index(m_file.number("the half-edge", Index(0), number_of_halfedges() - 1));
  }

  Checkpoint_input_2& m_file;
  Checkpoint_arrays_2<Point> m_kept;
  Space m_space{m_file, m_kept};
  Repair_experience_2 m_memory;
  bool m_is_certified = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_2_H
