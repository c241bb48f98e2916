// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_TORUS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_TORUS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_reader_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_writer_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Writes a torus: its cell and basis, points with the multiples that take them to their vertices,
// and cells, each with the shifts of its last three vertices from the first one. In a slab infinite
// cells are among them, and the shifts of all four vertices are written: those of the infinite one
// say whether it is above or below. So they are in a wire, where all infinite ones are above, and a
// point of the axis as well.
template <class Traits, class ConcurrencyTag>
class Checkpoint_writer_3<Torus_state_3<Traits, ConcurrencyTag>>
{
  using State = Torus_state_3<Traits, ConcurrencyTag>;
  using Point = typename State::Point;
  using Checkpoint_output_2 = Dynamic_Delaunay_triangulations_2::internal::Checkpoint_output_2;

public:
  Checkpoint_writer_3(const State& state, Checkpoint_output_2& file)
    : m_state(state)
    , m_file(file)
  {
  }

  void write();

private:
  static std::array<double, 3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }
  static std::array<int, 3> numbers(const Torus_site_3& s)
  {
    if (s.is_infinite())
      return {0, 0, s.is_above() ? 1 : -1};
    const Multiples_3 m = s.shift.multiples();
    return {m[0], m[1], m[2]};
  }

  void write_cells()
  {
    const Torus_cells_3& arrays = m_state.arrays;
    m_file.line("cells", arrays.number_of_cells());
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
      const Vertices_3& v = arrays.vertices(c);
      const Torus_sites_3 s = arrays.sites(c);
      if (m_state.torus.dimension() < 3)
        m_file.line(v[0], v[1], v[2], v[3], numbers(s[0]), numbers(s[1]), numbers(s[2]),
                    numbers(s[3]));
      else
        m_file.line(v[0], v[1], v[2], v[3], numbers(s[1]), numbers(s[2]), numbers(s[3]));
    }
    const Index vertices = m_state.spans_space ? arrays.number_of_vertices() : Index(1);
    m_file.line("corners", vertices - 1);
    for (Vertex_index v(1); v < vertices; ++v)
      m_file.line(arrays.corner_of(v));
  }

  const State& m_state;
  Checkpoint_output_2& m_file;
};

// Not inline: see `Update_3`.
template <class Traits, class ConcurrencyTag>
void Checkpoint_writer_3<Torus_state_3<Traits, ConcurrencyTag>>::write()
{
  const Periodic_cell_3& cell = m_state.torus.cell();
  const Torus_3::Basis& basis = m_state.torus.basis();
  if (cell.is_wire()) {
    m_file.line("wire", cell.a());
    m_file.line("basis", basis[0][0]);
  } else if (cell.is_slab()) {
    m_file.line("slab", cell.a(), cell.b());
    m_file.line("basis", basis[0][0], basis[0][1], basis[1][0], basis[1][1]);
  } else {
    m_file.line("cell", cell.a(), cell.b(), cell.c());
    m_file.line("basis", basis);
  }
  m_file.line("reach", m_state.reach());
  Dynamic_Delaunay_triangulations_2::internal::write_points(
      m_file, m_state.ids,
      [this](Vertex_index v) {
        const Multiples_3& m = m_state.positions.multiples(v);
        return std::make_tuple(coordinates(m_state.point(v)), m[0], m[1], m[2]);
      },
      [](const Point& p) { return coordinates(p); });
  if (cell.is_wire())
    write_origin(m_file, m_state);
  write_cells();
}

// Reads the same into a state without points. What it throws leaves that unusable.
template <class Traits, class ConcurrencyTag>
class Checkpoint_reader_3<Torus_state_3<Traits, ConcurrencyTag>>
  : private Checkpoint_reader_base_3<Checkpoint_reader_3<Torus_state_3<Traits, ConcurrencyTag>>,
                                     Torus_state_3<Traits, ConcurrencyTag>>
{
  using State = Torus_state_3<Traits, ConcurrencyTag>;
  using Base = Checkpoint_reader_base_3<Checkpoint_reader_3, State>;
  friend Base;
  using Base::m_file;
  using Base::m_places;
  using Base::m_points;
  using Base::m_state;
  using typename Base::Checkpoint_input_2;
  using typename Base::Point;

public:
  Checkpoint_reader_3(State& state, Checkpoint_input_2& file)
    : Base(state, file)
  {
  }

  void read();

  // POINTS ----------------------------------------------------------------------------------------

  static Index fewest_vertices() { return 0; }
  static Index most_vertices() { return Index(Input_3<State>::max_points); }

  void read_vertex()
  {
    const Point p = read_point();
    Multiples_3 multiples;
    for (int i = 0; i < 3; ++i) {
      const int most = i < m_state.torus.dimension() ? most_multiple : 0;
      multiples[i] = m_file.number("the multiple", -most, most);
    }
    m_points.push_back(p);
    m_places.emplace_back(approximation(p), multiples, m_state.torus);
    if (m_state.torus.is_far_out(m_places.back().position))
      m_file.refuse("the vertex is farther from the cell than those of a torus may be");
  }

  Point read_point()
  {
    const double x = m_file.finite("the first coordinate");
    const double y = m_file.finite("the second coordinate");
    const Point p(x, y, m_file.finite("the third coordinate"));
    if (!m_state.torus.is_in_range(approximation(p)))
      m_file.refuse("the point is 2^20 cells or more from the origin, and has to be nearer");
    return p;
  }

  bool coincide(const Point& p, const Point& q) const
  {
    const Position_3 a = approximation(p), b = approximation(q);
    const Torus_place_3 closest(a, Torus_3::nearest(m_state.torus.fractions(b - a)), m_state.torus);
    return m_state.torus.coincide({closest.base, closest.multiples, closest.position},
                                  {b, Multiples_3{0, 0, 0}, b});
  }

private:
  static constexpr int most_multiple = 0x400000, most_shift = 255;

  Torus_3 read_torus()
  {
    m_file.next_line();
    const std::string_view kind = m_file.word("the cell");
    const std::size_t dimension = kind == "cell" ? 3 : kind == "slab" ? 2 : 1;
    if (dimension == 1 && kind != "wire")
      m_file.refuse("the first word", kind, "cell, slab or wire");
    std::array<std::array<double, 3>, 3> vectors{};
    for (std::size_t i = 0; i < dimension; ++i)
      for (double& x : vectors[i])
        x = m_file.finite("the coordinate of a vector");
    m_file.end_line();
    m_file.begin_entry("basis");
    Torus_3::Basis basis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const int most = int(Torus_3::max_multiple) - 1;
    for (std::size_t i = 0; i < dimension; ++i)
      for (std::size_t j = 0; j < dimension; ++j)
        basis[i][j] = m_file.number("the number of the basis", -most, most);
    m_file.end_line();
    try {
      const Periodic_cell_3 cell = dimension == 3
                                       ? Periodic_cell_3(vectors[0], vectors[1], vectors[2])
                                   : dimension == 2 ? Periodic_cell_3(vectors[0], vectors[1])
                                                    : Periodic_cell_3(vectors[0]);
      if (const std::optional<Torus_3> torus = Torus_3::with_basis(cell, basis))
        return *torus;
    } catch (const Periodic_cell_error_3& error) {
      m_file.refuse(error.what());
    }
    m_file.refuse("this is no basis of the cell's lattice, or too long a one");
  }

  // CELLS -----------------------------------------------------------------------------------------

  // A cell's facet. Its sites are in ascending order, moved so that the first finite one has no
  // shift.
  struct Facet
  {
    Few<Torus_site_3, 3> sites;
    Torus_shift_3 shift; // of that one before
    Corner_index corner; // opposite to it
  };

  void read_cells()
  {
    m_state.arrays.reset(m_state.number_of_vertices() + 1);
    const Index number = m_file.number_entry("cells", Index(0), Index(Torus_cells_3::max_cells));
    const std::size_t line = m_file.line();
    for (Index i = 0; i < number; ++i)
      read_cell();
    link(line);
    m_state.spans_space = m_state.number_of_vertices() > 0 && (number > 0 || !is_wire());
    this->read_corners(Vertex_index(1),
                       m_state.spans_space ? m_state.number_of_vertices() : Index(0));
    Unproved_cells_3 unproved;
    if (!Torus_certificate_3<State>(m_state).holds(unproved))
      m_file.refuse(line, "the cells are not a Delaunay triangulation");
  }

  void read_cell()
  {
    m_file.next_line();
    const bool is_open = m_state.torus.dimension() < 3;
    const Index first(is_open ? 0 : 1);
    Torus_sites_3 sites;
    for (Torus_site_3& s : sites)
      s.vertex = Vertex_index(m_file.number("the vertex", first, m_state.number_of_vertices()));
    sites[0].shift = {};
    for (int i = is_open ? 0 : 1; i < 4; ++i)
      read_shift(sites[i]);
    m_file.end_line();
    int infinite = 0;
    for (const Torus_site_3& s : sites) {
      infinite += s.is_infinite();
      if (std::count(sites.begin(), sites.end(), s) > 1 || infinite > 1)
        m_file.refuse("the cell has an image of a vertex twice");
    }
    m_state.arrays.set_sites(m_state.arrays.make_cell(), sites);
  }
  void read_shift(Torus_site_3& s)
  {
    Multiples_3 m;
    for (int& number : m)
      number = m_file.number("the shift", -most_shift, most_shift);
    s.shift = Torus_shift_3::of(m);
    if (s.is_infinite()) {
      if (m[0] != 0 || m[1] != 0 || (m[2] != 1 && (m[2] != -1 || is_wire())))
        m_file.refuse(is_wire() ? "the shift of the infinite vertex has to be 0 0 1"
                                : "the shift of the infinite vertex has to be 0 0 1 or 0 0 -1");
      s = m[2] > 0 ? Torus_site_3::above() : Torus_site_3::below();
    } else if (m_state.torus.dimension() < 3 && m[2] != 0) {
      m_file.refuse("the third number of a shift in a slab or a wire has to be 0");
    } else if (is_wire() && m[1] != 0) {
      m_file.refuse("the second number of a shift in a wire has to be 0");
    }
  }
  bool is_wire() const { return m_state.torus.is_wire(); }

  // Finds the mirrors of corners: each facet belongs to two of them, also of one cell.
  void link(std::size_t line)
  {
    const std::vector<Facet> facets = sorted_facets();
    const auto is_same = [&](std::size_t i, std::size_t j) {
      return j < facets.size() && facets[i].sites == facets[j].sites;
    };
    for (std::size_t i = 0; i < facets.size(); i += 2) {
      const Cell_index c = Torus_cells_3::cell_of(facets[i].corner);
      if (!is_same(i, i + 1) || is_same(i, i + 2))
        m_file.refuse(line + 1 + c, "not exactly two cells have one of the facets");
      m_state.arrays.connect(facets[i].corner, facets[i + 1].corner,
                             facets[i].shift - facets[i + 1].shift);
    }
  }
  std::vector<Facet> sorted_facets() const
  {
    std::vector<Facet> facets;
    facets.reserve(4 * std::size_t(m_state.arrays.number_of_cells()));
    for (Cell_index c(0); c < m_state.arrays.number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i) {
        const Torus_sites_3 s = m_state.arrays.sites(c);
        Facet facet{
            {s[i == 0], s[i <= 1 ? 2 : 1], s[i <= 2 ? 3 : 2]}, {}, m_state.arrays.corner(c, i)};
        std::sort(facet.sites.begin(), facet.sites.end());
        facet.shift = facet.sites[facet.sites[0].is_infinite() ? 1 : 0].shift;
        for (Torus_site_3& site : facet.sites)
          site = site - facet.shift;
        facets.push_back(facet);
      }
    std::sort(facets.begin(), facets.end(), [](const Facet& f, const Facet& g) {
      return f.sites < g.sites || (f.sites == g.sites && f.corner < g.corner);
    });
    return facets;
  }
};

// Not inline: see `Update_3`.
template <class Traits, class ConcurrencyTag>
void Checkpoint_reader_3<Torus_state_3<Traits, ConcurrencyTag>>::read()
{
  m_state.torus = read_torus();
  m_file.begin_entry("reach");
  const double largest = m_file.finite("the largest coordinate");
  const double sum = m_file.finite("the sum of multiples");
  m_file.end_line();
  this->read_points();
  if (!m_state.set_reach({largest, sum}))
    m_file.refuse("the numbers after \"reach\", above, are too small for these points");
  if (is_wire()) {
    this->read_origin();
    if (m_state.has_origin && !m_state.torus.is_in_range(m_state.origin))
      m_file.refuse("the origin is too far away");
  }
  read_cells();
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_IO_CHECKPOINT_TORUS_3_H
