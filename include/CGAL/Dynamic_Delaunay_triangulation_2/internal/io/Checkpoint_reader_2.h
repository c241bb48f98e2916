// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_READER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_READER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Surface_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_costs_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Reads a triangulation that Checkpoint_writer_2 has written. Every value is validated before it is
// used, and memory is allocated only for what was read, whatever numbers the file announces.
template <class State>
class Checkpoint_reader_2
{
  using Point = typename State::Point;
  using FT = std::decay_t<decltype(std::declval<Point>().x())>;
  using Coordinate = Checkpoint_coordinate_2<FT>;
  static_assert(is_made_of_x_and_y<Point>,
                "a checkpoint keeps x and y, which are not all of these points");

public:
  explicit Checkpoint_reader_2(Checkpoint_input_2& file)
    : m_file(file)
  {
  }

  // Reads into an empty triangulation, which can only be discarded if this throws.
  void read(State& state)
  {
    read_head();
    read_points();
    if (m_dimension == 2)
      read_topology();
    else
      check_line(state);
    Topology_builder_2<State>(state).restore(m_kept);
    if (m_is_certified && m_dimension == 2 && !Certificate_2<State>(state).holds())
      m_file.refuse(m_certified_line, "the triangulation is not Delaunay, and cannot be certified");
  }

  bool is_certified() const { return m_is_certified; }
  const Repair_experience_2& memory() const { return m_experience; }

private:
  void read_head()
  {
    const std::string_view kind = m_file.entry("coordinates");
    if (kind != Coordinate::kind)
      m_file.refuse("the coordinates are of the kind " + Checkpoint_input_2::quoted(kind) +
                    ", and those of the triangulation's points of the kind " +
                    Checkpoint_input_2::quoted(Coordinate::kind));
    m_kept.positions_are_exact = m_file.flag_entry("positions", "exact", "rounded");
    if (State::coordinates_are_doubles && !m_kept.positions_are_exact)
      m_file.refuse("doubles are exact, and cannot be rounded");
    m_is_certified = m_file.flag_entry("certified", "yes", "no");
    m_certified_line = m_file.line();
    m_experience.restore(
        m_file.number_entry("hopeless_share", std::size_t(1), Repair_experience_2::all));
    m_dimension = m_file.number_entry("dimension", -1, 2);
    if (m_dimension < 2 && !m_is_certified)
      m_file.refuse("in this dimension the triangulation has to be certified");
    m_points.read_number_of_ids();
  }

  // POINTS --------------------------------------------------------------------------------------

  void read_points()
  {
    constexpr std::array<Index, 4> fewest{0, 1, 2, 3}, most{0, 1, max_vertices, max_vertices};
    const std::size_t i = std::size_t(m_dimension + 1);
    const auto read_vertex = [this] {
      const Point p = read_point();
      m_kept.positions.push_back(read_position(p));
      return p;
    };
    m_points.read(
        fewest[i], most[i], read_vertex, [this] { return read_point(); },
        [](const Point& p, const Point& q) { return p == q; });
  }

  Index number_of_vertices() const { return Index(m_kept.points.size()); }

  Point read_point()
  {
    FT x = read_coordinate("the first coordinate");
    FT y = read_coordinate("the second coordinate");
    return Point(x, y);
  }

  FT read_coordinate(const char* name)
  {
    const std::string_view text = m_file.word(name);
    FT x;
    if (!Coordinate::read(text, x) || !is_within_limit(CGAL::to_double(x)))
      m_file.refuse(std::string(name) + " is " + Checkpoint_input_2::quoted(text) +
                    ", and has to be " + Coordinate::meaning + ", not too large for a double");
    return x;
  }

  Position_2 read_position(const Point& p)
  {
    if constexpr (State::coordinates_are_doubles)
      return {p.x(), p.y()};
    else
      return {read_rounded("the first coordinate as a double", p.x()),
              read_rounded("the second coordinate as a double", p.y())};
  }

  double read_rounded(const char* name, const FT& x)
  {
    const double rounded = m_file.finite(name);
    if (m_kept.positions_are_exact ? FT(rounded) != x : !is_near(rounded, CGAL::to_double(x)))
      m_file.refuse(std::string(name) + " is something else than that");
    return rounded;
  }

  // Whether `rounded` may be x rounded to a double. CGAL promises five correct digits.
  static bool is_near(double rounded, double x)
  {
    constexpr double error = 1e-3;
    return std::abs(rounded - x) <= error * std::abs(x) + (std::numeric_limits<double>::min)();
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

  // TOPOLOGY ------------------------------------------------------------------------------------

  void read_topology()
  {
    read_faces();
    read_corners();
    read_edges();
  }

  // By Euler's formula.
  Index number_of_faces() const { return 2 * number_of_vertices() - 2; }
  Index number_of_halfedges() const { return 3 * number_of_faces(); }
  Index number_of_edges() const { return number_of_halfedges() / 2; }

  void read_faces()
  {
    m_file.number_entry("faces", number_of_faces(), number_of_faces());
    const std::size_t first_line = m_file.line() + 1;
    Flat_faces_2& faces = m_kept.faces;
    for (Index f = 0; f < number_of_faces(); ++f) {
      m_file.next_line();
      faces.resize(f + std::size_t(1));
      for (Index i = 0; i < 3; ++i)
        faces.set_apex(Flat_faces_2::first_halfedge(f) + i,
                       m_file.number("the vertex", Index(0), number_of_vertices()));
      m_file.end_line();
    }
    const Surface_check_2::Flaw flaw =
        Surface_check_2(faces, number_of_vertices() + 1).link_and_run();
    if (flaw.what)
      m_file.refuse(first_line + flaw.face, flaw.what);
  }

  void read_corners()
  {
    const Index number = number_of_vertices() + 1;
    m_file.number_entry("corners", number, number);
    for (Index v = 0; v < number; ++v) {
      m_file.next_line();
      const Index h = read_halfedge();
      const Index f = m_file.number("the face", Index(0), number_of_faces() - 1);
      m_file.end_line();
      if (m_kept.faces.apex(flat(h)) != v || !has_vertex(f, v))
        m_file.refuse("these are no corner and no face of vertex " + std::to_string(v));
      m_kept.corners.push_back({h, f});
    }
  }

  void read_edges()
  {
    m_file.number_entry("edges", number_of_edges(), number_of_edges());
    std::vector<bool> has_edge(number_of_halfedges());
    for (Index e = 0; e < number_of_edges(); ++e) {
      m_file.next_line();
      const Index forward = read_halfedge();
      const Index halfedge = read_halfedge();
      m_file.end_line();
      const Index twin = Flat_faces_2::number_in_arrays(m_kept.faces.twin(flat(forward)));
      if (halfedge != forward && halfedge != twin)
        m_file.refuse("these are half-edges of two edges");
      if (has_edge[forward])
        m_file.refuse("this edge is there more than once");
      has_edge[forward] = has_edge[twin] = true;
      m_kept.edges.push_back({forward, halfedge});
    }
  }

  Index read_halfedge()
  {
    return m_file.number("the half-edge", Index(0), number_of_halfedges() - 1);
  }

  static Index flat(Index h) { return Flat_faces_2::first_halfedge(h / 3) + h % 3; }

  bool has_vertex(Index face, Index v) const
  {
    const Index h = Flat_faces_2::first_halfedge(face);
    return m_kept.faces.apex(h) == v || m_kept.faces.apex(h + 1) == v ||
           m_kept.faces.apex(h + 2) == v;
  }

  Checkpoint_input_2& m_file;
  int m_dimension = -1;
  bool m_is_certified = false;
  Repair_experience_2 m_experience;
  std::size_t m_certified_line = 0;
  Checkpoint_arrays_2<Point> m_kept;
  Checkpoint_points_2<Point> m_points{m_file, m_kept.points, m_kept.ids};
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_READER_2_H
