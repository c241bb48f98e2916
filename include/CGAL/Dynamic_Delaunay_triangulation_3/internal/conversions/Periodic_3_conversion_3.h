// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_CONVERSIONS_PERIODIC_3_CONVERSION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_CONVERSIONS_PERIODIC_3_CONVERSION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Wrapped_coordinate.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/conversions/Vertex_info_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/certified_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_images_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Converts a periodic triangulation to the form of CGAL's class: points in a cube, and cells
// between their images by one side or none in each direction. Checks everything before it writes.
template <class Dynamic>
class Periodic_3_conversion_3
{
  using State = State_of_3<Dynamic>;
  using Arrays = typename State::Arrays;
  using Charts = Site_charts_3<Arrays>;
  using Site = typename Charts::Site;
  using Seen_cell = typename Charts::Seen_cell;
  using Wrapped = Dynamic_Delaunay_triangulations_2::internal::Wrapped_coordinate;
  using Coordinates = std::array<double, 3>;

public:
  Periodic_3_conversion_3(const Dynamic& pt, const Coordinates& corner)
    : m_pt(pt)
    , m_state(certified_state(pt))
    , m_low(corner)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Default_floating_point floating_point;
    find_domain();
    wrap_points();
    copy_cells();
  }

  // Fills a triangulation, and returns its vertices by ids.
  template <class Target>
  std::vector<typename Target::Vertex_handle> convert(Target& target) const
  {
    const typename Target::Iso_cuboid domain(m_low[0], m_low[1], m_low[2], m_high[0], m_high[1],
                                             m_high[2]);
    target.set_domain(domain);
    std::vector<typename Target::Vertex_handle> vertices(m_pt.number_of_ids());
    if (m_is_one_sheet_enough && m_pt.number_of_vertices() > 0)
      write(target, vertices);
    if (!m_is_one_sheet_enough || (m_has_ties && !target.is_valid())) {
      target.clear();
      insert_points(target, vertices);
    }
    for (std::size_t id = 0; id < vertices.size(); ++id)
      if (m_pt.has_id(id))
        vertices[id] = vertices[m_pt.representative(id)];
    return vertices;
  }

private:
  // CGAL's limit: then each sphere around a cell stays empty in one sheet, whatever is inserted.
  static constexpr double max_squared_edge = 0.166; // in squares of the domain's side

  // CELL AND POINTS -------------------------------------------------------------------------------

  void find_domain()
  {
    const Periodic_cell_3& cell = m_pt.cell();
    if (cell.dimension() < 3)
      Torus_3::refuse(cell, "only a cube can be converted");
    std::array<bool, 3> is_taken{false, false, false};
    for (std::size_t i = 0; i < 3; ++i) {
      const Coordinates& v = cell.vector(i);
      std::size_t axis = 0;
      while (axis < 2 && v[axis] == 0)
        ++axis;
      const double side = std::abs(v[axis]);
      if (v[(axis + 1) % 3] != 0 || v[(axis + 2) % 3] != 0 || is_taken[axis] ||
          (i > 0 && side != m_side))
        throw Periodic_cell_error_3(cell.a(), cell.b(), cell.c(),
                                    "only a cube with edges along the axes can be converted");
      is_taken[axis] = true;
      m_side = side;
      m_axes[i] = axis;
      m_signs[i] = v[axis] > 0 ? 1 : -1;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      m_high[axis] = m_low[axis] + m_side;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!Dynamic_Delaunay_triangulations_2::internal::is_exact_sum(m_low[axis], m_side,
                                                                     m_high[axis]))
        refuse("the upper corner of the domain from ", m_low, " has no coordinates of doubles");
  }

  // Wraps the points of representatives: other points have no vertices.
  void wrap_points()
  {
    m_points.resize(m_pt.number_of_ids());
    m_sides.resize(m_pt.number_of_ids());
    for (std::size_t id = 0; id < m_points.size(); ++id) {
      if (!m_pt.has_id(id) || m_pt.representative(id) != id)
        continue;
      const auto p = m_pt.point(id);
      const Coordinates given{p.x(), p.y(), p.z()};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Wrapped wrapped = Dynamic_Delaunay_triangulations_2::internal::wrapped(
            given[axis], m_low[axis], m_high[axis], m_side);
        if (std::isnan(wrapped.value))
          refuse("point " + std::to_string(id) + " at ", given,
                 " cannot be wrapped into the domain without rounding");
        m_points[id][axis] = wrapped.value;
        m_sides[id][axis] = wrapped.sides;
      }
    }
  }

  [[noreturn]] static void refuse(const std::string& what, const Coordinates& p,
                                  const std::string& why)
  {
    throw Periodic_conversion_error_2(Dynamic_Delaunay_triangulations_2::internal::message_text(
        what, "(", p[0], ", ", p[1], ", ", p[2], ")", why));
  }

  // CELLS -----------------------------------------------------------------------------------------

  // Offsets from the points in the domain, all 0 or 1. This needs short edges: then the offsets of
  // a cell differ by at most one side, and no two edges have the same ends.
  using Offsets = Few<Periodic_shift_3, 4>;

  void copy_cells()
  {
    const Arrays& arrays = m_state.arrays;
    const Scaled_sites_3<State> geometry(m_state);
    m_offsets.reserve(arrays.number_of_cells());
    for (Cell_index c(0); c < arrays.number_of_cells() && m_is_one_sheet_enough; ++c) {
      const auto sites = Charts::sites(arrays, c);
      Offsets offsets;
      for (int i = 0; i < 4; ++i)
        offsets[i] = sum(m_sides[id_of(sites[i])], along_axes(geometry.shift(sites[0], sites[i])));
      Periodic_shift_3 least = offsets[0];
      for (const Periodic_shift_3& offset : offsets)
        for (std::size_t axis = 0; axis < 3; ++axis)
          least[axis] = (std::min)(least[axis], offset[axis]);
      for (Periodic_shift_3& offset : offsets)
        for (std::size_t axis = 0; axis < 3; ++axis)
          offset[axis] -= least[axis];
      m_is_one_sheet_enough = has_short_edges(sites, offsets);
      m_has_ties = m_has_ties || has_tie(c, sites, geometry);
      m_offsets.push_back(offsets);
    }
  }

  std::size_t id_of(const Site& site) const
  {
    return m_state.ids.representative(Charts::vertex_of(site));
  }
  Periodic_shift_3 along_axes(const Periodic_shift_3& shift) const
  {
    Periodic_shift_3 result;
    for (std::size_t i = 0; i < 3; ++i)
      result[m_axes[i]] = m_signs[i] * shift[i];
    return result;
  }
  static Periodic_shift_3 sum(const Periodic_shift_3& s, const Periodic_shift_3& t)
  {
    return {s[0] + t[0], s[1] + t[1], s[2] + t[2]};
  }

  template <class Sites>
  bool has_short_edges(const Sites& sites, const Offsets& offsets) const
  {
    const double longest = max_squared_edge * m_side * m_side;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) {
        double square = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double way = m_points[id_of(sites[i])][axis] - m_points[id_of(sites[j])][axis] +
                             (offsets[i][axis] - offsets[j][axis]) * m_side;
          square += way * way;
        }
        if (!(square < (1 - 0x1p-40) * longest))
          return false;
      }
    return true;
  }

  // Whether another vertex is on the sphere of a cell.
  template <class Sites>
  bool has_tie(Cell_index c, const Sites& sites, const Scaled_sites_3<State>& geometry) const
  {
    const Arrays& arrays = m_state.arrays;
    const Seen_cell own{c, {}};
    for (int i = 0; i < 4; ++i) {
      const Corner_index mirror = arrays.mirror(Arrays::corner(c, i));
      const Seen_cell other = Charts::beyond(arrays, own, i, mirror);
      if (geometry.are_on_a_sphere(sites, Charts::site(arrays, other, Arrays::place_of(mirror))))
        return true;
    }
    return false;
  }

  // WRITING ---------------------------------------------------------------------------------------

  template <class Target>
  void write(Target& target, std::vector<typename Target::Vertex_handle>& vertices) const
  {
    const Arrays& arrays = m_state.arrays;
    auto& tds = target.tds();
    tds.set_dimension(3);
    target.set_cover({1, 1, 1});
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v) {
      const std::size_t id = m_state.ids.representative(v);
      vertices[id] = tds.create_vertex();
      vertices[id]->set_point(point<Target>(id));
      set_info(vertices[id], id);
    }
    std::vector<typename Target::Cell_handle> cells;
    cells.reserve(m_offsets.size());
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
      const auto sites = Charts::sites(arrays, c);
      const auto vertex = [&](int i) { return vertices[id_of(sites[i])]; };
      const auto cell = tds.create_cell(vertex(0), vertex(1), vertex(2), vertex(3));
      const Offsets& offsets = m_offsets[c];
      cell->set_offsets(bits(offsets[0]), bits(offsets[1]), bits(offsets[2]), bits(offsets[3]));
      for (int i = 0; i < 4; ++i)
        vertex(i)->set_cell(cell);
      cells.push_back(cell);
    }
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i)
        cells[c]->set_neighbor(i, cells[arrays.neighbor(c, i)]);
  }

  static int bits(const Periodic_shift_3& offset)
  {
    return 4 * offset[0] + 2 * offset[1] + offset[2];
  }
  template <class Target>
  typename Target::Point point(std::size_t id) const
  {
    return typename Target::Point(m_points[id][0], m_points[id][1], m_points[id][2]);
  }

  // Lets CGAL insert the points: in rounds, each with twice as many as the one before, so that all
  // are spread over the domain, and along the curve that the numbers of vertices follow.
  template <class Target>
  void insert_points(Target& target, std::vector<typename Target::Vertex_handle>& vertices) const
  {
    std::size_t step = 1;
    while (2 * step <= m_state.number_of_vertices())
      step *= 2;
    typename Target::Vertex_handle last;
    for (; step > 0; step /= 2)
      for (std::size_t n = step; n <= m_state.number_of_vertices(); n += 2 * step) {
        const std::size_t id = m_state.ids.representative(Vertex_index(n));
        last = last == typename Target::Vertex_handle()
                   ? target.insert(point<Target>(id))
                   : target.insert(point<Target>(id), last->cell());
        vertices[id] = last;
        set_info(last, id);
      }
    if constexpr (has_info<typename Target::Vertex>)
      for (auto v = target.vertices_begin(); v != target.vertices_end(); ++v)
        v->info() = target.original_vertex(v).first->info();
  }

  const Dynamic& m_pt;
  const State& m_state;
  Coordinates m_low, m_high{0, 0, 0}; // of the domain
  double m_side = 0;
  std::array<std::size_t, 3> m_axes{0, 1, 2}; // of the cell's vectors
  std::array<int, 3> m_signs{1, 1, 1};
  std::vector<Coordinates> m_points;     // in the domain, by ids
  std::vector<Periodic_shift_3> m_sides; // from m_points to the given points
  std::vector<Offsets> m_offsets;        // of all cells, if one sheet is enough
  bool m_is_one_sheet_enough = true, m_has_ties = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_CONVERSIONS_PERIODIC_3_CONVERSION_3_H
