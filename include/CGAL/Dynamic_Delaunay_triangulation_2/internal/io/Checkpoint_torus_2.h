// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_TORUS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_TORUS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_cover_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Validity_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What only checkpoints of a torus or a slab have: the cell, and the shifts of corners. There is no
// infinite vertex. Several edges can connect the same vertices, so the twins do not follow from the
// faces.
template <class State>
class Checkpoint_torus_2
{
  using Arrays = Halfedge_arrays_2;

public:
  using Point = typename State::Point;

  static constexpr Vertex_index first_vertex = infinite_index + 1;
  static constexpr const char* wrong_corner = "this is no corner of vertex ";

  // WRITING -------------------------------------------------------------------------------------

  static bool is_complete(const State& state, bool is_certified)
  {
    return is_certified || Validity_check_2<State>(state, false).passes(0, false);
  }

  static void write_kind(Checkpoint_output_2& file, const State& state)
  {
    const Periodic_cell_2& cell = state.torus().cell();
    file.line("slab", cell.is_slab() ? "yes" : "no");
    if (cell.is_slab())
      file.line("cell", cell.ax(), cell.ay());
    else
      file.line("cell", cell.ax(), cell.ay(), cell.bx(), cell.by());
  }

  static void write_dimension(Checkpoint_output_2&, const State&) {}

  static std::array<double, 2> coordinates(const Point& p) { return {p.x(), p.y()}; }
  static std::array<double, 2> coordinates(const State& state, Vertex_index v)
  {
    return {state.positions()[v].x, state.positions()[v].y};
  }

  static bool has_faces(const State&) { return true; }

  // Returns the shifts of the other two corners: the first corner has no shift.
  static std::array<Periodic_shift_2, 2> rest_of_face(const State& state, Face_index f)
  {
    return {state.shift(Arrays::halfedge_in(f, 1)), state.shift(Arrays::halfedge_in(f, 2))};
  }
  static std::tuple<> rest_of_corner(Halfedge_index) { return {}; }

  static std::array<Halfedge_index, 2> halfedges(const Arrays& arrays, Edge_index e)
  {
    return {arrays.halfedge(e), arrays.twin(arrays.halfedge(e))};
  }

  // READING -------------------------------------------------------------------------------------

  // Reads the cell.
  Checkpoint_torus_2(Checkpoint_input_2& file, Checkpoint_arrays_2<Point>& kept)
    : m_file(file)
    , m_kept(kept)
    , m_torus(read_cell())
  {
  }

  static void read_dimension(bool) {}

  static Index fewest_vertices() { return 0; }
  static Index most_vertices() { return max_vertices; }
  void read_vertex() { m_kept.points.push_back(read_point()); }

  Point read_point()
  {
    const Position_2 p = read_vector(), multiples = m_torus.periodic(m_torus.multiples(p));
    if (!(std::abs(multiples.x) < max_shift && std::abs(multiples.y) < max_shift))
      m_file.refuse("the point is 2^20 cells or more from the origin, and has to be nearer");
    return Point(p.x, p.y);
  }

  bool coincide(const Point& p, const Point& q) const
  {
    return m_torus.coincide(approximation(p), approximation(q));
  }

  static bool has_faces() { return true; }

  void read_rest_of_face(Face_index f)
  {
    m_shifts.insert(m_shifts.end(), {no_shift, read_shift(), read_shift()});
    m_file.end_line();
    for (const Halfedge_index h : Arrays::halfedges_of(f))
      if (source(h) == target(h) && are_equal(side(h), no_shift))
        m_file.refuse("the face has a corner twice");
  }

  static bool read_rest_of_corner(Vertex_index) { return true; }

  // Links two half-edges, which have to run along each other in opposite directions, also by their
  // shifts. Returns the second one.
  Halfedge_index checked_twin(Halfedge_index h, Halfedge_index g, const std::vector<bool>& is_listed)
  {
    if (h == g || is_listed[h] || is_listed[g])
      m_file.refuse("a half-edge is there more than once");
    if (source(h) != target(g) || target(h) != source(g) || !are_equal(side(h), no_shift - side(g)))
      m_file.refuse("these are half-edges of two edges");
    m_kept.faces.link(Flat_faces_2::from_arrays(h), Flat_faces_2::from_arrays(g));
    return g;
  }

  void restore(State& state) const
  {
    Torus_builder_2<State>(state).restore(m_torus, m_kept, m_shifts);
    if (!Torus_cover_2<State>(state).do_areas_sum_up())
      m_file.refuse("the faces above do not cover the space once");
  }

  static bool is_delaunay(const State& state) { return Certificate_2<State>(state).holds(); }

private:
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

  Periodic_shift_2 read_shift()
  {
    constexpr int most = int(max_shift_in_face) - 1;
    const int first = m_file.number("the shift", -most, most);
    return {first, m_file.number("the shift", -most, most)};
  }

  // Returns the shift from the source of a half-edge to its target.
  Periodic_shift_2 side(Halfedge_index h) const
  {
    return m_shifts[Arrays::previous(h)] - m_shifts[Arrays::next(h)];
  }
  Vertex_index source(Halfedge_index h) const
  {
    return m_kept.faces.source(Flat_faces_2::from_arrays(h));
  }
  Vertex_index target(Halfedge_index h) const
  {
    return m_kept.faces.target(Flat_faces_2::from_arrays(h));
  }

  Checkpoint_input_2& m_file;
  Checkpoint_arrays_2<Point>& m_kept;
  Torus_2 m_torus;
  typename State::Shifts m_shifts; // of the apex of each half-edge
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_TORUS_2_H
