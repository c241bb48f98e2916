// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_PLANE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_PLANE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_coordinate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Surface_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Plane_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What only checkpoints of the plane have: the kind of coordinates, the dimension, and the infinite
// vertex.
template <class State>
class Checkpoint_plane_2
{
public:
  using Point = typename State::Point;

  static constexpr Index missing_pairs = 1; // of faces, which are no more than twice the points
  static constexpr const char* wrong_corner = "these are no corner and no face of vertex ";

private:
  using FT = std::decay_t<decltype(std::declval<Point>().x())>;
  using Coordinate = Checkpoint_coordinate_2<FT>;
  static_assert(is_made_of_x_and_y<Point>,
                "a checkpoint keeps x and y, which are not all of these points");

public:
  // WRITING -------------------------------------------------------------------------------------

  static bool is_complete(const State& state, bool is_certified)
  {
    return is_certified || state.spans_plane();
  }

  static void write_kind(Checkpoint_output_2& file, const State& state)
  {
    file.line("coordinates", Coordinate::kind);
    file.line("positions", state.are_coordinates_rounded() ? "rounded" : "exact");
  }

  static void write_dimension(Checkpoint_output_2& file, const State& state)
  {
    file.line("dimension", state.triangulation().dimension());
  }

  static auto coordinates(const Point& p)
  {
    return std::make_pair(Coordinate::text(p.x()), Coordinate::text(p.y()));
  }
  // Rounded coordinates are written as well: how a number was rounded depends on how it was
  // computed, which is not kept.
  static auto coordinates(const State& state, Vertex_index v)
  {
    if constexpr (State::coordinates_are_doubles)
      return coordinates(state.point(v));
    else
      return std::make_tuple(coordinates(state.point(v)), state.positions()[v].x,
                             state.positions()[v].y);
  }

  static bool has_faces(const State& state) { return state.spans_plane(); }
  static std::tuple<> rest_of_face(const State&, Face_index) { return {}; }
  static Face_index rest_of_corner(Halfedge_index h) { return Halfedge_arrays_2::face_of(h); }

  static std::array<Halfedge_index, 2> halfedges(const Halfedge_arrays_2& arrays, Edge_index e)
  {
    const Halfedge_index h = arrays.halfedge(e);
    return {arrays.source(h) == arrays.edge(e).source ? h : arrays.twin(h), h};
  }

  // READING -------------------------------------------------------------------------------------

  // Reads the kind of coordinates.
  Checkpoint_plane_2(Checkpoint_input_2& file, Checkpoint_arrays_2<Point>& kept)
    : m_file(file)
    , m_kept(kept)
  {
    check_kind_of_coordinates<FT>(m_file);
    m_kept.positions_are_exact = m_file.flag_entry("positions", "exact", "rounded");
    if (State::coordinates_are_doubles && !m_kept.positions_are_exact)
      m_file.refuse("doubles are exact, and cannot be rounded");
  }

  void read_dimension(bool is_certified)
  {
    m_dimension = m_file.number_entry("dimension", -1, 2);
    if (m_dimension < 2 && !is_certified)
      m_file.refuse("in this dimension the triangulation has to be certified");
  }

  Index fewest_vertices() const { return Index(m_dimension + 1); }
  Index most_vertices() const { return m_dimension < 1 ? fewest_vertices() : max_vertices; }

  void read_vertex()
  {
    m_kept.points.push_back(read_point());
    m_kept.positions.push_back(read_position(m_kept.points.back()));
  }

  Point read_point()
  {
    FT x = read_coordinate<FT>(m_file, "the first coordinate", coordinate_limit);
    FT y = read_coordinate<FT>(m_file, "the second coordinate", coordinate_limit);
    return Point(x, y);
  }

  static bool coincide(const Point& p, const Point& q) { return p == q; }

  bool has_faces() const { return m_dimension == 2; }
  void read_rest_of_face(Face_index) const { m_file.end_line(); }

  // The vertices of faces determine which ones are neighbors.
  static Surface_check_2::Flaw link_faces(Surface_check_2& check) { return check.link_and_run(); }
  static Surface_check_2::Flaw check_links(Surface_check_2&) { return {}; }

  // Reads a face. True if v is one of its vertices.
  bool read_rest_of_corner(Vertex_index v)
  {
    const Face_index f(m_file.number("the face", Index(0), m_kept.faces.number_of_faces() - 1));
    const Flat_halfedge_index h = Flat_faces_2::first_halfedge(f);
    return m_kept.faces.apex(h) == v || m_kept.faces.apex(h + 1) == v ||
           m_kept.faces.apex(h + 2) == v;
  }

  // Returns the twin of `forward`. `halfedge` must be `forward` or the twin.
  Halfedge_index checked_twin(Halfedge_index forward, Halfedge_index halfedge,
                              const std::vector<bool>& is_listed) const
  {
    const Halfedge_index twin =
        Flat_faces_2::number_in_arrays(m_kept.faces.twin(Flat_faces_2::from_arrays(forward)));
    if (halfedge != forward && halfedge != twin)
      m_file.refuse("these are half-edges of two edges");
    if (is_listed[forward])
      m_file.refuse("this edge is there more than once");
    return twin;
  }

  void restore(State& state) const
  {
    if (!has_faces())
      check_line(state);
    Plane_builder_2<State>(state).restore(m_kept);
  }

  // True in lower dimensions, where every triangulation is Delaunay.
  bool is_delaunay(const State& state) const
  {
    return !has_faces() || Certificate_2<State>(state).holds();
  }

private:
  Position_2 read_position(const Point& p)
  {
    if constexpr (State::coordinates_are_doubles)
      return {p.x(), p.y()};
    else
      return {read_rounded_coordinate(m_file, "the first coordinate as a double", p.x(),
                                      m_kept.positions_are_exact),
              read_rounded_coordinate(m_file, "the second coordinate as a double", p.y(),
                                      m_kept.positions_are_exact)};
  }

  // Checks that the points are distinct and collinear.
  void check_line(const State& state) const
  {
    const auto& traits = state.traits();
    std::vector<Point> points = m_kept.points;
    std::sort(points.begin(), points.end(), traits.less_xy_2_object());
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i - 1] == points[i])
        m_file.refuse("two vertices are in the same place, above");
      if (traits.orientation_2_object()(points.front(), points[i], points.back()) != COLLINEAR)
        m_file.refuse("the points above span the plane, and the dimension is less than 2");
    }
  }

  Checkpoint_input_2& m_file;
  Checkpoint_arrays_2<Point>& m_kept;
  int m_dimension = -1;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_PLANE_2_H
