// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_CHECKPOINT_READER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_CHECKPOINT_READER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Surface_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_memory_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Periodic_certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Reads a periodic triangulation that Periodic_checkpoint_writer_2 has written. Every value is
// validated before it is used, and memory is allocated only for what was read, whatever numbers the
// file announces.
template <class State>
class Periodic_checkpoint_reader_2
{
  using Arrays = Halfedge_arrays_2;

public:
  explicit Periodic_checkpoint_reader_2(Checkpoint_input_2& file)
    : m_file(file)
    , m_torus(read_cell())
  {
  }

  // Reads into an empty triangulation, which can only be discarded if this throws.
  void read(State& state)
  {
    read_head();
    m_points.read(
        0, max_vertices, [this] { return read_point(); }, [this] { return read_point(); },
        [this](const Position_2& p, const Position_2& q) { return m_torus.coincide(p, q); });
    read_faces();
    const std::size_t first_line_of_faces = m_file.line() + 1 - number_of_faces();
    read_corners();
    read_edges();
    check_surface(first_line_of_faces);
    state = State(m_torus.cell());
    Periodic_editor_2<State, false>(state).restore(m_faces, m_positions, m_ids, m_corners, m_edges);
    const Periodic_certificate_2<State> certificate(state);
    if (!certificate.covers_once())
      m_file.refuse("the faces above do not cover the space once");
    if (m_is_certified && !certificate.is_delaunay())
      m_file.refuse(m_certified_line, "the triangulation is not Delaunay, and cannot be certified");
  }

  bool is_certified() const { return m_is_certified; }
  const Periodic_memory_2& memory() const { return m_memory; }

private:
  // HEAD ----------------------------------------------------------------------------------------

  Periodic_cell_2 read_cell()
  {
    const bool is_slab = m_file.flag_entry("slab", "yes", "no");
    m_file.begin_entry("cell");
    const Position_2 a = read_vector(), b = is_slab ? Position_2{0, 0} : read_vector();
    m_file.end_line();
    try {
      const auto cell =
          is_slab ? Periodic_cell_2::slab(a.x, a.y) : Periodic_cell_2(a.x, a.y, b.x, b.y);
      check_cell(cell);
      return cell;
    } catch (const Periodic_cell_error_2& error) {
      m_file.refuse(error.what());
    }
  }

  Position_2 read_vector()
  {
    const double x = m_file.finite("the first coordinate");
    return {x, m_file.finite("the second coordinate")};
  }

  void read_head()
  {
    m_is_certified = m_file.flag_entry("certified", "yes", "no");
    m_certified_line = m_file.line();
    m_file.begin_entry("mean_way");
    m_memory.mean_way = {read_number(), read_number()};
    m_file.end_line();
    m_memory.hint = m_file.number_entry("walk_start", Index(1), max_vertices);
    m_points.read_number_of_ids();
  }

  // The mean of large coordinates may overflow.
  double read_number()
  {
    const std::string_view text = m_file.word("the coordinate");
    double number;
    if (!read_whole(text, number))
      m_file.refuse("the coordinate is " + Checkpoint_input_2::quoted(text) +
                    ", and has to be a number");
    return number;
  }

  Position_2 read_point()
  {
    const Position_2 p = read_vector(), multiples = m_torus.periodic(m_torus.multiples(p));
    if (!(std::abs(multiples.x) < max_shift && std::abs(multiples.y) < max_shift))
      m_file.refuse("the point is 2^20 cells or more from the origin, and has to be nearer");
    return p;
  }

  // TOPOLOGY ------------------------------------------------------------------------------------

  Index number_of_vertices() const { return Index(m_positions.size()); }
  Index number_of_faces() const { return 2 * number_of_vertices(); }
  Index number_of_halfedges() const { return 6 * number_of_vertices(); }
  Index number_of_edges() const { return 3 * number_of_vertices(); }

  void read_faces()
  {
    m_file.number_entry("faces", number_of_faces(), number_of_faces());
    for (Index f = 0; f < number_of_faces(); ++f) {
      m_file.next_line();
      for (int i = 0; i < 3; ++i)
        m_faces.apexes.push_back(m_file.number("the vertex", Index(1), number_of_vertices()));
      m_faces.shifts.push_back(no_shift);
      for (int i = 1; i < 3; ++i)
        m_faces.shifts.push_back(read_shift());
      m_file.end_line();
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (m_faces.apexes[h] == m_faces.apexes[Arrays::next(h)] &&
            are_equal(side(Arrays::previous(h)), no_shift))
          m_file.refuse("the face has a corner twice");
    }
  }

  // Shifts of a face are differences of numbers below max_shift, of points and of basis vectors.
  Periodic_shift_2 read_shift()
  {
    constexpr int most = 4 * int(max_shift) - 1;
    const int first = m_file.number("the shift", -most, most);
    return {first, m_file.number("the shift", -most, most)};
  }

  // From the source of a half-edge to its target.
  Periodic_shift_2 side(Index h) const
  {
    return m_faces.shifts[Arrays::previous(h)] - m_faces.shifts[Arrays::next(h)];
  }

  void read_corners()
  {
    m_file.number_entry("corners", number_of_vertices(), number_of_vertices());
    for (Index v = 1; v <= number_of_vertices(); ++v) {
      m_file.next_line();
      m_corners.push_back(read_halfedge());
      m_file.end_line();
      if (m_faces.apexes[m_corners.back()] != v)
        m_file.refuse("this is no corner of vertex " + std::to_string(v));
    }
  }

  // There are as many edges as pairs of half-edges, so it is enough that no half-edge occurs twice.
  void read_edges()
  {
    m_file.number_entry("edges", number_of_edges(), number_of_edges());
    m_faces.twins.assign(number_of_halfedges(), null_index);
    for (Index e = 0; e < number_of_edges(); ++e) {
      m_file.next_line();
      const Index h = read_halfedge(), g = read_halfedge();
      m_file.end_line();
      if (h == g || m_faces.twins[h] != null_index || m_faces.twins[g] != null_index)
        m_file.refuse("a half-edge is there more than once");
      if (!run_along_each_other(h, g))
        m_file.refuse("these are half-edges of two edges");
      m_faces.twins[h] = g;
      m_faces.twins[g] = h;
      m_edges.push_back(h);
    }
  }

  Index read_halfedge()
  {
    return m_file.number("the half-edge", Index(0), number_of_halfedges() - 1);
  }

  // In opposite directions, also by their shifts.
  bool run_along_each_other(Index h, Index g) const
  {
    const auto& apexes = m_faces.apexes;
    return apexes[Arrays::next(h)] == apexes[Arrays::previous(g)] &&
           apexes[Arrays::previous(h)] == apexes[Arrays::next(g)] &&
           are_equal(side(h), no_shift - side(g));
  }

  // There is no infinite vertex, so vertex 1 is number 0 here.
  void check_surface(std::size_t first_line_of_faces) const
  {
    if (number_of_vertices() == 0)
      return;
    const auto flat = [](Index h) { return Flat_faces_2::first_halfedge(h / 3) + h % 3; };
    Flat_faces_2 faces;
    faces.resize(number_of_faces());
    for (Index h = 0; h < number_of_halfedges(); ++h) {
      faces.set_apex(flat(h), m_faces.apexes[h] - 1);
      faces.set_twin(flat(h), flat(m_faces.twins[h]));
    }
    const Surface_check_2::Flaw flaw = Surface_check_2(faces, number_of_vertices()).run();
    if (flaw.what)
      m_file.refuse(first_line_of_faces + flaw.face, flaw.what);
  }

  Checkpoint_input_2& m_file;
  Torus_2 m_torus;
  bool m_is_certified = false;
  std::size_t m_certified_line = 0;
  Periodic_memory_2 m_memory;
  std::vector<Position_2> m_positions; // of the vertices
  Point_ids_2<Position_2> m_ids;
  Checkpoint_points_2<Position_2> m_points{m_file, m_positions, m_ids};
  Periodic_faces_2 m_faces;
  std::vector<Index> m_corners; // of the vertices
  std::vector<Index> m_edges;   // a half-edge of each
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_PERIODIC_CHECKPOINT_READER_2_H
