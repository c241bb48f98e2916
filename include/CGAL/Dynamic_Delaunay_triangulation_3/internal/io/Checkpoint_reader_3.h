// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_READER_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_READER_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_coordinate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Cell_links_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_reader_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Filtered_certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Static_triangulator_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Reads what a writer has written into the state of an empty triangulation, which can only be
// discarded if this throws. Checks everything: each number, that cells fit together, and that they
// are Delaunay.
template <class State>
class Checkpoint_reader_3 : private Checkpoint_reader_base_3<Checkpoint_reader_3<State>, State>
{
  using Base = Checkpoint_reader_base_3<Checkpoint_reader_3, State>;
  friend Base;
  using typename Base::Checkpoint_input_2;
  using typename Base::Place;
  using typename Base::Point;
  using FT = std::decay_t<decltype(std::declval<const Point&>().x())>;
  using Base::m_file;
  using Base::m_places;
  using Base::m_points;
  using Base::m_state;

public:
  Checkpoint_reader_3(State& state, Checkpoint_input_2& file)
    : Base(state, file)
  {
  }

  void read();

  // POINTS ----------------------------------------------------------------------------------------

  Index fewest_vertices() const { return Index(m_dimension + 1); }
  static Index most_vertices() { return Index(Input_3<State>::max_points); }

  void read_vertex()
  {
    m_points.push_back(read_point());
    m_places.push_back(Place(read_position(m_points.back()), m_points.back()));
  }

  Point read_point()
  {
    const FT x = read_coordinate("the first coordinate");
    const FT y = read_coordinate("the second coordinate");
    return Point(x, y, read_coordinate("the third coordinate"));
  }

  bool coincide(const Point& p, const Point& q) const { return m_state.coincide(p, q); }

private:
  FT read_coordinate(const char* name)
  {
    using Dynamic_Delaunay_triangulations_2::internal::read_coordinate;
    return read_coordinate<FT>(m_file, name, coordinate_limit);
  }

  Position_3 read_position(const Point& p)
  {
    if constexpr (is_three_doubles<Point>)
      return approximation(p);
    else
      return {read_rounded("the first coordinate as a double", p.x()),
              read_rounded("the second coordinate as a double", p.y()),
              read_rounded("the third coordinate as a double", p.z())};
  }
  double read_rounded(const char* name, const FT& x)
  {
    using Dynamic_Delaunay_triangulations_2::internal::read_rounded_coordinate;
    return read_rounded_coordinate(m_file, name, x, m_state.positions_are_exact);
  }

  // What there is without cells depends on the points alone.
  void triangulate_plane()
  {
    std::vector<std::pair<Vertex_index, Vertex_index>> covered;
    Static_triangulator_3<State>(m_state).triangulate(covered);
    if (!covered.empty())
      m_file.refuse("two vertices are in the same place, above");
    if (m_state.dimension() != m_dimension)
      m_file.refuse("the points above have the dimension " + std::to_string(m_state.dimension()));
  }

  // CELLS -----------------------------------------------------------------------------------------

  void read_cells()
  {
    this->read_origin();
    m_state.arrays.reset(m_state.number_of_vertices() + 1);
    const Index number =
        m_file.number_entry("cells", Index(5), Index(Tetrahedra_arrays_3::max_cells));
    const std::size_t line = m_file.line();
    for (Index i = 0; i < number; ++i)
      read_cell();
    const Cell_index unlinked = Cell_links_3(m_state.arrays).link();
    if (unlinked != null_index)
      m_file.refuse(line + 1 + unlinked, "not exactly two cells have one of the facets");
    this->read_corners(Vertex_index(0), m_state.number_of_vertices());
    if (!Certificate_3<State>(m_state).is_combinatorially_valid())
      m_file.refuse(line, "the cells do not fit together");
    Unproved_cells_3 unproved;
    if (!Filtered_certificate_3<State>(m_state).holds(unproved))
      m_file.refuse(line, "the cells are not a Delaunay triangulation");
  }

  void read_cell()
  {
    m_file.next_line();
    Vertices_3 v;
    for (Vertex_index& vertex : v)
      vertex = Vertex_index(m_file.number("the vertex", Index(0), m_state.number_of_vertices()));
    m_file.end_line();
    for (int i = 0; i < 4; ++i)
      if (std::count(v.begin(), v.end(), v[i]) > 1)
        m_file.refuse("the cell has a vertex twice");
    m_state.arrays.set_vertices(m_state.arrays.make_cell(), v);
  }

  int m_dimension = -1;
};

// Not inline: see `Update_3`.
template <class State>
void Checkpoint_reader_3<State>::read()
{
  Dynamic_Delaunay_triangulations_2::internal::check_kind_of_coordinates<FT>(m_file);
  m_state.positions_are_exact = m_file.flag_entry("positions", "exact", "rounded");
  if (is_three_doubles<Point> && !m_state.positions_are_exact)
    m_file.refuse("doubles are exact, and cannot be rounded");
  m_dimension = m_file.number_entry("dimension", -1, 3);
  m_state.spans_space = m_dimension == 3;
  this->read_points();
  if (m_state.spans_space)
    read_cells();
  else
    triangulate_plane();
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_READER_3_H
