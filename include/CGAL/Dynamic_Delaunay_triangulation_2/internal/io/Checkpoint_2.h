// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Surface_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_experience_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Writes a maintained triangulation. The manual's page on checkpoints describes the file.
template <class State>
class Checkpoint_writer_2
{
  using Space = Checkpoint_space_2<State>;

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
    for (Vertex_index v(1); v <= ids.number_of_representatives(); ++v)
      file.line(ids.representative(v), Space::coordinates(m_state, v));
    file.line("duplicates", ids.duplicates().size());
    for (const auto& duplicate : ids.duplicates())
      file.line(duplicate.id, ids.vertex(duplicate.id), Space::coordinates(duplicate.point));
    file.line("free_ids", ids.number_of_ids() - ids.number_of_points());
    for (Point_id id(0); id < ids.number_of_ids(); ++id)
      if (!ids.is_taken(id))
        file.line(id);
  }

  void write_topology(Checkpoint_output_2& file) const
  {
    const auto& arrays = m_state.arrays();
    const Index beyond = m_state.number_of_vertices() + 1;
    file.line("faces", arrays.number_of_faces());
    for (Face_index f(0); f < arrays.number_of_faces(); ++f)
      file.line(arrays.face(f), Space::rest_of_face(m_state, f));
    file.line("corners", beyond - Space::first_vertex);
    for (Vertex_index v = Space::first_vertex; v < beyond; ++v)
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
template <class State>
class Checkpoint_reader_2
{
  using Space = Checkpoint_space_2<State>;
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
    read_points();
    if (m_space.has_faces())
      read_topology();
    m_space.restore(state);
    if (m_is_certified && !m_space.is_delaunay(state))
      m_file.refuse(line, "the triangulation is not Delaunay, and cannot be certified");
  }

  bool is_certified() const { return m_is_certified; }
  const Repair_experience_2& memory() const { return m_memory; }

private:
  // POINTS --------------------------------------------------------------------------------------

  // Ids must be smaller than `null_index`. The limit for vertices is lower (`max_vertices`),
  // because Flat_faces_2 numbers eight half-edges per vertex.
  static constexpr Index max_ids = null_index - 1;

  void read_points()
  {
    m_number_of_ids = m_file.number_entry("ids", Index(0), max_ids);
    read_vertices();
    read_duplicates();
    read_free_ids();
    check_ids();
    m_kept.ids.reset(m_number_of_ids);
    auto id = m_ids.begin();
    for (Index i = 0; i < number_of_vertices(); ++i)
      m_kept.ids.add_representative(*id++);
    for (const auto& [vertex, point] : m_duplicates)
      m_kept.ids.add_duplicate(*id++, m_ids[vertex - 1], point);
    m_kept.ids.finish_numbering();
  }

  Index number_of_vertices() const { return Index(m_kept.points.size()); }

  void read_vertices()
  {
    const Index number =
        m_file.number_entry("vertices", m_space.fewest_vertices(), m_space.most_vertices());
    for (Vertex_index v(1); v <= number; ++v) {
      read_id();
      m_space.read_vertex();
      m_file.end_line();
    }
  }

  // Reads the id at the beginning of a line.
  void read_id()
  {
    m_file.next_line();
    if (m_number_of_ids == 0)
      m_file.refuse("a point is here, and there are no ids");
    m_ids.emplace_back(m_file.number("the id", Index(0), m_number_of_ids - 1));
  }

  void read_duplicates()
  {
    const Index number = m_file.number_entry("duplicates", Index(0), m_number_of_ids);
    if (number > 0 && number_of_vertices() == 0)
      m_file.refuse("there are duplicates, and no vertices");
    for (Index i = 0; i < number; ++i) {
      read_id();
      const Vertex_index vertex(m_file.number("the vertex", Index(1), number_of_vertices()));
      const Point p = m_space.read_point();
      m_file.end_line();
      if (!m_space.coincide(p, m_kept.points[vertex - 1]))
        m_file.refuse("the duplicate is not where its vertex is");
      m_duplicates.emplace_back(vertex, p);
    }
  }

  void read_free_ids()
  {
    const std::size_t points = m_ids.size();
    const auto number = m_file.number_entry("free_ids", std::size_t(0), std::size_t(max_ids));
    if (points + number != m_number_of_ids)
      m_file.refuse("of " + std::to_string(m_number_of_ids) + " ids " + std::to_string(points) +
                    " are taken, and " + std::to_string(number) + " cannot be free");
    for (std::size_t i = 0; i < number; ++i) {
      read_id();
      m_file.end_line();
    }
  }

  // As many ids were read as there are, so it is enough that no id occurs twice.
  void check_ids() const
  {
    std::vector<bool> is_there(m_number_of_ids);
    for (const Point_id id : m_ids) {
      if (is_there[id])
        m_file.refuse("the id " + std::to_string(id) + " is there more than once, above");
      is_there[id] = true;
    }
  }

  // TOPOLOGY ------------------------------------------------------------------------------------

  // In the plane the vertices of faces determine which faces are neighbors. In a torus the edges
  // do, because several edges may connect the same vertices.
  void read_topology()
  {
    read_faces();
    const std::size_t first_line = m_file.line() + 1 - m_kept.faces.number_of_faces();
    if (!State::is_periodic)
      check_surface(first_line);
    read_corners();
    read_edges();
    if (State::is_periodic)
      check_surface(first_line);
  }

  // By Euler's formula.
  Index number_of_faces() const { return 2 * number_of_vertices() - (State::is_periodic ? 0 : 2); }
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
        m_kept.faces.set_apex(
            Flat_faces_2::first_halfedge(f) + i,
            Vertex_index(m_file.number("the vertex", Index(Space::first_vertex), number_of_vertices())));
      m_space.read_rest_of_face(f);
    }
  }

  void check_surface(std::size_t first_line)
  {
    if (number_of_vertices() == 0)
      return;
    Surface_check_2 check(m_kept.faces, number_of_vertices() + 1, Space::first_vertex);
    const Surface_check_2::Flaw flaw = State::is_periodic ? check.run() : check.link_and_run();
    if (flaw.what)
      m_file.refuse(first_line + flaw.face, flaw.what);
  }

  void read_corners()
  {
    Vertex_index v = Space::first_vertex;
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
  Index m_number_of_ids = 0;
  std::vector<Point_id> m_ids; // of the representatives, then of the duplicates, then the free ones
  std::vector<std::pair<Vertex_index, Point>> m_duplicates; // their vertices, and their points
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_2_H
