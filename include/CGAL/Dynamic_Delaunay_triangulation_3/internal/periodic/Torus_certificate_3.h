// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CERTIFICATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CERTIFICATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_pass_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/wires/Wire_hull_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/wires/Wire_planes_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Proves that cells are the Delaunay triangulation of a torus: they fit together, all are positive,
// they cover the torus once, and all facets are legal.
//
// Cells that fit together and are positive cover every point equally often, but for those on
// facets; so how often they do is the sum of their volumes, divided by the torus' volume. It is an
// integer, and flips and motion do not change it while all cells stay positive.
//
// An infinite cell of a slab is the prism over its hull facet, along the normal. Far above the
// slab there are only those, with the point above; so the areas of their bases, as seen along the
// normal, take the place of volumes. What is above covers as often as what is below: the areas of a
// cell's facets, as seen from one side, add up to 0. So flips do not change that number either, and
// motion does not, as it is the degree of a map from the hull above to the torus of both vectors.
//
// A wire is covered as often as its hull goes round the axis (`Wire_hull_3`). It has no cells where
// all points are in a plane along it.
template <class State>
class Torus_certificate_3
{
  using Arrays = Torus_cells_3;

public:
  explicit Torus_certificate_3(State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  // Proves everything, by a pass of the filter first; `unproved` gets what that leaves.
  bool holds(Unproved_cells_3& unproved) const
  {
    if (is_wire_without_cells())
      return Wire_planes_3<State>(m_state).are_in_one();
    if (!is_combinatorially_valid())
      return false;
    find_unproved(m_state, unproved);
    const auto are_Delaunay = [this](const std::vector<Cell_index>& cells) {
      return std::all_of(cells.begin(), cells.end(),
                         [this](Cell_index c) { return is_Delaunay(c); });
    };
    return are_Delaunay(unproved.finite) && are_Delaunay(unproved.infinite) &&
           (m_state.number_of_vertices() == 0 || covers_once());
  }
  // What is wrong, or null, by exact predicates alone.
  const char* problem() const
  {
    if (is_wire_without_cells())
      return Wire_planes_3<State>(m_state).are_in_one()
                 ? nullptr
                 : "there are no cells, and the points are in no plane along the wire";
    if (!is_combinatorially_valid())
      return "the cells do not fit together, or a vertex has none";
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c)
      if (!is_Delaunay(c))
        return "it is not Delaunay";
    if (m_state.number_of_vertices() > 0 && !covers_once())
      return "the cells do not cover the torus once";
    return nullptr;
  }
  // Whether cells that covered the torus once, and have been positive before and after motion and
  // flips, do so still.
  bool go_on_to_cover_once()
  {
    if (m_state.goes_on_to_cover_once())
      return true;
    find_star(m_state.arrays, infinite_index, m_state.marks, m_star);
    return Wire_hull_3<State>(m_state).goes_round_once(m_star);
  }

  // Whether cells fit together, and each vertex has one of its own.
  bool is_combinatorially_valid() const
  {
    Column<Vertex_index, char> is_there(arrays().number_of_vertices(), 0);
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c) {
      if (arrays().is_free(c) || arrays().first_finite_site(c).shift != Torus_shift_3())
        return false;
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(c, i);
        is_there[arrays().vertex(k)] = 1;
        if (!fits(k))
          return false;
      }
    }
    for (Vertex_index v(1); v < arrays().number_of_vertices(); ++v)
      if (!is_there[v] || arrays().vertex(arrays().corner_of(v)) != v)
        return false;
    return arrays().number_of_vertices() == m_state.number_of_vertices() + 1 &&
           m_state.positions.number() == arrays().number_of_vertices();
  }

  // Whether cells, which fit together and are positive, cover the torus once: whether the sum of
  // their volumes is nearer to its volume than to all its multiples.
  bool covers_once() const
  {
    if (m_state.torus.is_wire())
      return Wire_hull_3<State>(m_state).goes_round_once(infinite_cells());
    if (m_state.torus.is_slab())
      return covers_slab_once();
    const double whole = 6 * m_state.torus.volume(), error = std::sqrt(m_state.squared_error);
    double sum = 0, uncertainty = 0;
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c) {
      const Torus_sites_3 sites = arrays().sites(c);
      const Position_3 a = m_state.position(sites[0]);
      Few<Points_in_lanes_3<double>, 3> v;
      double size = 0;
      for (int i = 0; i < 3; ++i) {
        const Position_3 way = m_state.position(sites[i + 1]) - a;
        v[i] = {way.x, way.y, way.z};
        size = (std::max)(size, squared_length(way));
      }
      sum += dot(v[0], cross(v[1], v[2]));
      const double length = std::sqrt(size) + error;
      uncertainty += length * length * (0x1p-49 * length + 4 * error);
    }
    // no number where an image is too far for rounded positions
    if (std::isfinite(sum) &&
        uncertainty + 0x1p-50 * double(arrays().number_of_cells()) * whole < whole / 16)
      return std::abs(sum - whole) < whole / 4;
    return covers_once_exactly();
  }

private:
  const Arrays& arrays() const { return m_state.arrays; }
  bool is_wire_without_cells() const { return m_state.torus.is_wire() && !m_state.spans_space; }
  std::vector<Cell_index> infinite_cells() const
  {
    std::vector<Cell_index> infinite;
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c)
      if (arrays().is_infinite(c))
        infinite.push_back(c);
    return infinite;
  }

  // Whether the two cells at a facet share its sites, with opposite orientations.
  bool fits(Corner_index k) const
  {
    const Corner_index l = arrays().mirror(k);
    if (l == k || Arrays::cell_of(l) >= arrays().number_of_cells() || arrays().mirror(l) != k ||
        arrays().translation(l) != -arrays().translation(k))
      return false;
    Few<int, 4> places;
    for (int i = 0; i < 4; ++i) {
      if (i == Arrays::place_of(k)) {
        places[i] = Arrays::place_of(l);
        continue;
      }
      const Torus_site_3 s = arrays().site(Arrays::corner(Arrays::cell_of(k), i));
      places[i] = arrays().place_of(Arrays::cell_of(l), s - arrays().translation(k));
      if (places[i] == 4 || places[i] == Arrays::place_of(l))
        return false;
    }
    return !is_even(places);
  }

  bool is_Delaunay(Cell_index c) const
  {
    const Torus_sites_3 sites = arrays().sites(c);
    if (!m_signs.is_positive(sites))
      return false;
    for (int i = 0; i < 4; ++i)
      if (m_signs.side_of_sphere(sites, arrays().apex_site(Arrays::corner(c, i))) > 0)
        return false;
    return true;
  }

  bool covers_once_exactly() const
  {
    Exact_number_3 sum = 0;
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c) {
      const Torus_sites_3 s = arrays().sites(c);
      const Torus_point_3 a = m_state.image(s[0]);
      const auto way = [&](int i) { return m_state.torus.exact_vector(a, m_state.image(s[i])); };
      sum = sum + dot(way(1), cross(way(2), way(3)));
    }
    const Torus_3& torus = m_state.torus;
    const Exact_number_3 whole =
        Exact_number_3(6) *
        dot(torus.exact_vector(0), cross(torus.exact_vector(1), torus.exact_vector(2)));
    return sum == whole || CGAL::is_zero(sum + whole);
  }

  // The same of a slab, by the doubled areas of the prisms' bases above it. Where rounding does not
  // tell, it is exact.
  bool covers_slab_once() const
  {
    const Torus_3& torus = m_state.torus;
    const double whole = 2 * torus.volume(), error = std::sqrt(m_state.squared_error);
    const Position_3& n = torus.vector(2);
    double sum = 0, uncertainty = 0;
    for_each_base_above([&](const Torus_facet_3& s) {
      const Position_3 a = m_state.position(s[0]), u = m_state.position(s[1]) - a,
                       v = m_state.position(s[2]) - a;
      sum += n.x * (u.y * v.z - u.z * v.y) + n.y * (u.z * v.x - u.x * v.z) +
             n.z * (u.x * v.y - u.y * v.x);
      const double length = std::sqrt((std::max)(squared_length(u), squared_length(v))) + error;
      uncertainty += length * (0x1p-9 * length + 4 * error);
    });
    // the normal of a measurable basis is off by less than 2^-10
    if (std::isfinite(sum) && uncertainty < whole / 16)
      return std::abs(sum - whole) < whole / 4;
    return covers_slab_once_exactly();
  }
  bool covers_slab_once_exactly() const
  {
    const Torus_3& torus = m_state.torus;
    const Exact_vector_3& n = torus.exact_vector(2);
    Exact_number_3 sum = 0;
    for_each_base_above([&](const Torus_facet_3& s) {
      const Torus_point_3 a = m_state.image(s[0]);
      sum = sum + dot(n, cross(torus.exact_vector(a, m_state.image(s[1])),
                               torus.exact_vector(a, m_state.image(s[2]))));
    });
    return sum == Exact_number_3(2) * dot(n, n);
  }
  // Calls f(sites) for the base of each infinite cell above the slab, counterclockwise as seen from
  // there.
  template <class Function>
  void for_each_base_above(const Function& f) const
  {
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c) {
      if (const int place = arrays().place_of(c, Torus_site_3::above()); place < 4)
        f(hull_facet(arrays().sites(c), place));
    }
  }

  State& m_state;
  Torus_signs_3<State> m_signs;
  std::vector<Cell_index> m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CERTIFICATE_3_H
