// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_PLANE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_PLANE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Plane_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Lazy_exact_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class FT>
const FT& exact_value(const FT& x)
{
  return x;
}
template <class ET>
const ET& exact_value(const Lazy_exact_nt<ET>& x)
{
  return x.exact();
}

// Writes a coordinate as a fraction of integers, so that exactly the same number is read back.
template <class FT>
class Checkpoint_coordinate_2
{
  using Exact = std::decay_t<decltype(exact_value(std::declval<const FT&>()))>;
  using Fraction = Fraction_traits<Exact>;
  using Numerator = typename Fraction::Numerator_type;
  using Denominator = typename Fraction::Denominator_type;
  template <class Integer>
  static constexpr bool is_integer =
      std::is_convertible_v<typename Algebraic_structure_traits<Integer>::Algebraic_category,
                            Euclidean_ring_tag>;
  static_assert(Fraction::Is_fraction::value && is_integer<Numerator> && is_integer<Denominator>,
                "a checkpoint needs coordinates that can be written exactly: doubles, or fractions "
                "of integers as in Exact_predicates_exact_constructions_kernel");

public:
  static constexpr const char* kind = "rational";
  static constexpr const char* meaning = "a fraction of integers";

  static std::string text(const FT& x)
  {
    Numerator numerator;
    Denominator denominator;
    typename Fraction::Decompose()(exact_value(x), numerator, denominator);
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << numerator;
    if (denominator != 1)
      out << '/' << denominator;
    return out.str();
  }

  // False if the text is not a number.
  static bool read(std::string_view text, FT& x)
  {
    const std::size_t bar = text.find('/');
    const std::string_view above = text.substr(0, bar);
    const std::string_view below = bar == text.npos ? "1" : text.substr(bar + 1);
    const bool is_negative = !above.empty() && above.front() == '-';
    if (!is_natural(above.substr(is_negative)) || !is_natural(below) || below == "0")
      return false;
    x = FT(typename Fraction::Compose()(integer<Numerator>(above), integer<Denominator>(below)));
    return true;
  }

private:
  // Rejects leading zeros, which would make some number types read octal digits.
  static bool is_natural(std::string_view text)
  {
    return !text.empty() && (text.front() != '0' || text == "0") &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  }

  template <class Integer>
  static Integer integer(std::string_view digits)
  {
    std::istringstream in{std::string(digits)};
    in.imbue(std::locale::classic());
    Integer result;
    in >> result;
    return result;
  }
};

template <>
class Checkpoint_coordinate_2<double>
{
public:
  static constexpr const char* kind = "double";
  static constexpr const char* meaning = "a finite number";

  static double text(double x) { return x; }
  static bool read(std::string_view text, double& x) { return read_finite(text, x); }
};

// What only checkpoints of the plane have: the kind of coordinates, the dimension, and the infinite
// vertex.
template <class State>
class Checkpoint_plane_2
{
public:
  using Point = typename State::Point;

  static constexpr Vertex_index first_vertex = infinite_index;
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
    const auto& duplicates = state.ids().duplicates();
    return (is_certified || state.spans_plane()) &&
           std::all_of(duplicates.begin(), duplicates.end(), [&](const auto& duplicate) {
             return duplicate.point == state.point(state.ids().vertex(duplicate.id));
           });
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
    const std::string_view kind = m_file.entry("coordinates");
    if (kind != Coordinate::kind)
      m_file.refuse("the coordinates are of the kind " + Checkpoint_input_2::quoted(kind) +
                    ", and those of the triangulation's points of the kind " +
                    Checkpoint_input_2::quoted(Coordinate::kind));
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
    FT x = read_coordinate("the first coordinate");
    FT y = read_coordinate("the second coordinate");
    return Point(x, y);
  }

  static bool coincide(const Point& p, const Point& q) { return p == q; }

  bool has_faces() const { return m_dimension == 2; }
  void read_rest_of_face(Face_index) const { m_file.end_line(); }

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
  FT read_coordinate(const char* name)
  {
    const std::string_view text = m_file.word(name);
    FT x;
    if (!Coordinate::read(text, x) || !is_within_limit(CGAL::to_double(x)))
      m_file.refuse(name, text, std::string(Coordinate::meaning) + ", not too large for a double");
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
    constexpr double error = 1e-3; // CGAL promises five correct digits
    const double rounded = m_file.finite(name), value = CGAL::to_double(x);
    const double most = error * std::abs(value) + (std::numeric_limits<double>::min)();
    if (m_kept.positions_are_exact ? FT(rounded) != x : !(std::abs(rounded - value) <= most))
      m_file.refuse(std::string(name) + " is something else than that");
    return rounded;
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
