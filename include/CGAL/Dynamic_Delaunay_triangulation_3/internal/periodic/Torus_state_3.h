// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_STATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_STATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_cells_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_predicates_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Where a vertex is: at `base` plus multiples of the basis, without rounding. The base is the point
// as it was given, so that one that is wrapped into the cell gets other multiples, and stays where
// it is; `position` is the sum, rounded.
struct Torus_place_3
{
  Torus_place_3() = default;
  explicit Torus_place_3(const Position_3& p)
    : position(p)
    , base(p)
  {
  }
  Torus_place_3(const Position_3& b, const Multiples_3& m, const Torus_3& torus)
    : position(b + torus.combination(m))
    , base(b)
    , multiples(m)
  {
  }

  Position_3 position{0, 0, 0}, base{0, 0, 0};
  Multiples_3 multiples{0, 0, 0};
};

// The places of the vertices, present or those of the last frame.
class Torus_positions_3
{
public:
  const Position_3* data() const { return m_positions.data(); }
  const Position_3& position(Vertex_index v) const { return m_positions[v]; }
  const Position_3& base(Vertex_index v) const { return m_bases[v].base; }
  const Multiples_3& multiples(Vertex_index v) const { return m_bases[v].multiples; }
  Index number() const { return Index(m_positions.size()); }
  Torus_place_3 place(Vertex_index v) const
  {
    Torus_place_3 place(m_positions[v]);
    place.base = m_bases[v].base;
    place.multiples = m_bases[v].multiples;
    return place;
  }

  void set(Vertex_index v, const Torus_place_3& place)
  {
    m_positions[v] = place.position;
    m_bases[v] = {place.base, place.multiples};
  }
  void resize(Index number)
  {
    m_positions.resize(number);
    m_bases.resize(number);
  }
  void swap(Torus_positions_3& other)
  {
    m_positions.swap(other.m_positions);
    m_bases.swap(other.m_bases);
  }

private:
  struct Base
  {
    Position_3 base;
    Multiples_3 multiples;
  };

  Column<Vertex_index, Position_3> m_positions;
  Column<Vertex_index, Base> m_bases;
};

// Points in periodic space, their ids and their cells.
template <class GeomTraits, class ConcurrencyTag>
class Torus_state_3
{
public:
  using Traits = GeomTraits;
  using Point = typename Traits::Point_3;
  using Place = Torus_place_3;
  using Positions = Torus_positions_3;
  using Arrays = Torus_cells_3;
  using Ids = Dynamic_Delaunay_triangulations_2::internal::Point_ids_2<Point>;
  using Parts = Dynamic_Delaunay_triangulations_2::internal::Parallel_parts<ConcurrencyTag>;

  static_assert(is_three_doubles<Point>,
                "the coordinates of points in periodic space must be of type double");

  explicit Torus_state_3(const Periodic_cell_3& cell)
    : torus(cell)
  {
    ids.reset(0);
    positions.resize(1);
    arrays.resize_vertices(1);
  }

  Index number_of_vertices() const { return ids.number_of_representatives(); }

  Torus_point_3 point(const Torus_site_3& site) const
  {
    const Multiples_3 shift = site.shift.multiples();
    return {positions.base(site.vertex), positions.multiples(site.vertex) + shift,
            rounded(site, shift)};
  }
  Position_3 position(const Torus_site_3& site) const
  {
    return site.shift == Torus_shift_3() ? positions.position(site.vertex)
                                         : rounded(site, site.shift.multiples());
  }

  // The image of a base that is next to a position.
  Place place_at(const Position_3& base, const Position_3& position) const
  {
    return Place(base, Torus_3::nearest(torus.fractions(position - base)), torus);
  }
  // Whether an image of a point is exactly where a vertex is.
  bool coincide(const Point& p, Vertex_index v) const
  {
    const Place place = place_at(approximation(p), positions.position(v));
    return torus.coincide({place.base, place.multiples, place.position},
                          point(Torus_site_3{v, {}}));
  }

  // Computes anew what rounding moves sites by, with vertices that are held between these positions
  // and those of the last frame.
  void set_error(const Positions* previous)
  {
    double largest = 0, sum = 0;
    for (const Positions* const some : {static_cast<const Positions*>(&positions), previous})
      if (some != nullptr)
        for (Vertex_index v(1); v < some->number(); ++v) {
          largest = (std::max)(largest, largest_coordinate(some->base(v)));
          largest = (std::max)(largest, largest_coordinate(some->position(v)));
          const Multiples_3& m = some->multiples(v);
          sum = (std::max)(sum, double(std::abs(m[0])) + std::abs(m[1]) + std::abs(m[2]));
        }
    // a vertex that is held is carried by others' ways: at most twice as far as all go
    squared_error = torus.squared_error(previous == nullptr ? largest : 4 * largest, sum);
  }

  // Gives up all cells. The last vertices take the numbers of those that have no point. Allocates
  // nothing, if there is memory for all free ids.
  void drop_cells()
  {
    arrays.clear_cells();
    for (Vertex_index v(1); v <= ids.number_of_representatives();) {
      const Vertex_index last(ids.number_of_representatives());
      if (ids.has_representative(v)) {
        ++v;
        continue;
      }
      if (ids.has_representative(last)) {
        positions.set(v, positions.place(last));
        ids.move_points(last, v);
      }
      ids.resize(last - 1);
    }
    positions.resize(ids.number_of_representatives() + 1);
    ids.find_free_ids();
  }

  Torus_3 torus;
  double squared_error = 0; // by which filters have to reckon
  Ids ids;
  Positions positions;
  Arrays arrays;
  Cell_marks_3 marks;         // of these cells; each tool clears them before it uses them
  Position_3 origin{0, 0, 0}; // nothing depends on it: there are no infinite cells

private:
  // NaN, of which a filter proves nothing, where the bound of the error does not hold.
  Position_3 rounded(const Torus_site_3& site, const Multiples_3& shift) const
  {
    const Position_3& p = positions.position(site.vertex);
    if (site.shift == Torus_shift_3())
      return p;
    if (!Torus_3::is_in_filter(shift)) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      return {nan, nan, nan};
    }
    return p + torus.combination(shift);
  }
  static double largest_coordinate(const Position_3& p)
  {
    return (std::max)((std::max)(std::abs(p.x), std::abs(p.y)), std::abs(p.z));
  }
};

// The exact signs that decide cells and facets.
template <class State>
class Torus_signs_3
{
public:
  explicit Torus_signs_3(const State& state)
    : m_state(state)
    , m_predicates(state.torus, state.squared_error)
  {
  }

  const Torus_predicates_3& predicates() const { return m_predicates; }

  // 1 if the cell is positive, -1 if it is inverted, 0 if it is flat.
  int of(const Torus_sites_3& s) const
  {
    if (const int sign = m_predicates.filtered_orientation(position(s[0]), position(s[1]),
                                                           position(s[2]), position(s[3])))
      return sign;
    return m_predicates.exact_orientation(point(s[0]), point(s[1]), point(s[2]), point(s[3]));
  }
  bool is_positive(const Torus_sites_3& s) const { return of(s) > 0; }

  // The sign of the cell if `other` took one of the places.
  int with(Torus_sites_3 s, int place, const Torus_site_3& other) const
  {
    s[place] = other;
    return of(s);
  }

  // 1 if `other` is inside of the sphere of a positive cell, -1 if it is outside.
  int side_of_sphere(const Torus_sites_3& s, const Torus_site_3& other) const
  {
    if (const int sign = m_predicates.filtered_side_of_sphere(
            position(s[0]), position(s[1]), position(s[2]), position(s[3]), position(other)))
      return sign;
    return m_predicates.exact_side_of_sphere(point(s[0]), point(s[1]), point(s[2]), point(s[3]),
                                             point(other));
  }

private:
  Torus_point_3 point(const Torus_site_3& site) const { return m_state.point(site); }
  Position_3 position(const Torus_site_3& site) const { return m_state.position(site); }

  const State& m_state;
  Torus_predicates_3 m_predicates;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_STATE_3_H
