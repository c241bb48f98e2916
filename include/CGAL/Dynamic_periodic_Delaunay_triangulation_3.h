// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_3_H
#define CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_triangulation_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_names_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_space_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The Delaunay triangulation of points that move in a periodic space of three dimensions, in which
everything is repeated by the vectors of a `Periodic_cell_3`: a flat torus. The cell may be any
parallelepiped, and may change with every frame.

Points may be given anywhere in space, wrapped into the cell or not. The images p + i a + j b + k c
of a point p, for integers i, j and k, are triangulated as real numbers, and never rounded. There is
one sheet, however few points there are: so a point can be a neighbor of its own images, and two
points can have several edges.

The cell may be a slab, with two vectors, as of a film or between walls. Then the cells fill the
convex hull of all images, which is the layer between two planes along the slab, through the points
that are farthest to either side. They cover it once; if all points are in one such plane, there are
no cells, only facets and edges of the Delaunay triangulation in that plane. All shifts have the
third number 0.

Or it is a wire, with one vector, as of a nanowire, a tube or a fiber, or in a pipe. The hull of all
images is then a prism without ends along that vector. If all points are in one plane along it,
there are no cells, and no facets, edges and neighbors either. The last two numbers of all shifts
are 0.

Points have ids as in `Dynamic_Delaunay_triangulation_3`: the i-th point of the range has id i, and
points that are inserted get the smallest free ids. Points that coincide, also by a translation of
the lattice, share a vertex.

After every call the triangulation is <em>certified</em>: exact predicates have proved that its
cells are positively oriented, that they cover the torus once, and that each facet is locally
Delaunay. Where five or more points are on an empty sphere, a symbolic perturbation that is the same
for all images chooses one of their triangulations: so it is unique.

\tparam Traits a CGAL kernel whose points have coordinates of type `double`, such as
  `Exact_predicates_inexact_constructions_kernel`.
\tparam Options those of `Dynamic_Delaunay_triangulation_3`, in any order: `With_concurrency_2<>`,
  `With_visitor_2<>` and `With_policy_2<>`. Visitors get edges and facets with shifts, such as
  `Periodic_edge_changes_visitor_3`.
*/
template <class Traits, class... Options>
class Dynamic_periodic_Delaunay_triangulation_3
  : public Dynamic_triangulation_base_3<
        Dynamic_periodic_Delaunay_triangulation_3<Traits, Options...>,
        Dynamic_Delaunay_triangulations_3::internal::Torus_space_3<
            Traits, typename Dynamic_Delaunay_triangulations_3::internal::Chosen_types_3<
                        Options...>::Concurrency_tag>,
        Options...>
{
  using Base = Dynamic_triangulation_base_3<
      Dynamic_periodic_Delaunay_triangulation_3,
      Dynamic_Delaunay_triangulations_3::internal::Torus_space_3<
          Traits, typename Dynamic_Delaunay_triangulations_3::internal::Chosen_types_3<
                      Options...>::Concurrency_tag>,
      Options...>;
  friend Base;
  friend Dynamic_Delaunay_triangulations_3::internal::Triangulation_access;
  using Base::ids;
  using Base::state;
  using typename Base::Cell_index;
  using typename Base::Floating_point;
  using typename Base::Point_id;
  using typename Base::State;
  using typename Base::Vertex_index;
  using Multiples = Dynamic_Delaunay_triangulations_3::internal::Multiples_3;
  using Site = Dynamic_Delaunay_triangulations_3::internal::Torus_site_3;
  using Identity_map = boost::typed_identity_property_map<typename Traits::Point_3>;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;
  template <class Map>
  using If_map = Dynamic_Delaunay_triangulations_2::internal::If_map<Map>;

public:
  using typename Base::Point;
  using typename Base::Settings;
  using typename Base::size_type;
  /// a vector.
  using Vector = typename Traits::Vector_3;

  /// \name Creation
  /// @{

  /// creates an empty triangulation of the torus with this cell, and with these settings, which may
  /// be a policy alone.
  /// \throws Periodic_cell_error_3 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it.
  explicit Dynamic_periodic_Delaunay_triangulation_3(const Periodic_cell_3& cell,
                                                     const Settings& settings = Settings())
    : Base(empty_state(cell), settings)
  {
  }

  /// triangulates the points of the range; the i-th one has id i.
  /// \tparam InputIterator its values are convertible to `Point`.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_3 if a point is 2<sup>20</sup> cells or more from the origin; in
  /// a wire in any direction, in lengths of its vector.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow.
  /// \throws Periodic_cell_error_3 as above.
  template <class InputIterator>
  Dynamic_periodic_Delaunay_triangulation_3(InputIterator first, InputIterator beyond,
                                            const Periodic_cell_3& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_3(cell, settings)
  {
    this->insert(first, beyond);
  }

  /// triangulates the points that `point_map` reads from the values of the range.
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`.
  template <class InputIterator, class PointMap, class = If_map<PointMap>>
  Dynamic_periodic_Delaunay_triangulation_3(InputIterator first, InputIterator beyond,
                                            const PointMap& point_map, const Periodic_cell_3& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_3(cell, settings)
  {
    this->insert(first, beyond, point_map, Emptyset_iterator());
  }

  /// triangulates the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Dynamic_periodic_Delaunay_triangulation_3(const Range& range, const Periodic_cell_3& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_3(std::begin(range), std::end(range), cell, settings)
  {
  }

  /// triangulates the points that `point_map` reads from a range with `begin()` and `end()`.
  template <class Range, class PointMap, class = If_range<Range>, class = If_map<PointMap>>
  Dynamic_periodic_Delaunay_triangulation_3(const Range& range, const PointMap& point_map,
                                            const Periodic_cell_3& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_3(std::begin(range), std::end(range), point_map, cell,
                                                settings)
  {
  }

  /// @}
  /// \name Motion
  /// @{

  using Base::update;

  /// moves the points as `update(first, beyond)` does, in a cell that has changed since the last
  /// call: by deformation, by other vectors for the same lattice, as when a sheared cell is
  /// flipped, or by both.
  /// \throws Periodic_cell_error_3 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it, or if it has not as many vectors as the last one; else what
  /// `update(first, beyond)` throws. Nothing has changed then.
  template <class InputIterator>
  Update_report_3 update(InputIterator first, InputIterator beyond, const Periodic_cell_3& cell)
  {
    return update(first, beyond, Identity_map(), cell);
  }

  /// takes the positions from a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_3 update(const Range& points, const Periodic_cell_3& cell)
  {
    return update(std::begin(points), std::end(points), cell);
  }

  /// reads the positions from the values of the range by `point_map`.
  template <class InputIterator, class PointMap, class = If_map<PointMap>>
  Update_report_3 update(InputIterator first, InputIterator beyond, const PointMap& point_map,
                         const Periodic_cell_3& cell)
  {
    return this->update_frame(first, beyond, point_map, cell);
  }

  /// reads the positions by `point_map` from the values of a range with `begin()` and `end()`.
  template <class Range, class PointMap, class = If_range<Range>, class = If_map<PointMap>>
  Update_report_3 update(const Range& range, const PointMap& point_map, const Periodic_cell_3& cell)
  {
    return update(std::begin(range), std::end(range), point_map, cell);
  }

  /// @}
  /// \name Sizes and Vectors
  /// @{

  /// the cell of the last frame.
  const Periodic_cell_3& cell() const { return state().torus.cell(); }
  /// the number of cells. Cost: in a slab or a wire one pass over the cells, also below.
  size_type number_of_cells() const { return all_cells() - number_of_hull_facets(); }
  /// the number of facets: two for each cell, and in a slab or a wire half of those on its hull
  /// more.
  size_type number_of_facets() const { return 2 * number_of_cells() + number_of_hull_facets() / 2; }
  /// the number of edges: as many as vertices and cells, and in a slab or a wire half of the facets
  /// on its hull more. None without cells in a wire.
  size_type number_of_edges() const
  {
    const size_type hull_facets = number_of_hull_facets();
    return all_cells() > 0 ? this->number_of_vertices() + all_cells() - hull_facets / 2 : 0;
  }

  /// the vector from point i to the image of point j by `shift`, rounded.
  /// \throws Unknown_id_error_2 if no point has one of these ids.
  Vector vector(size_type i, size_type j, const Periodic_shift_3& shift) const
  {
    const Point p = this->point(i), q = this->point(j);
    std::array<double, 3> way{q.x() - p.x(), q.y() - p.y(), q.z() - p.z()};
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t k = 0; k < 3; ++k)
        way[k] += shift[n] * cell().vector(n)[k];
    return Vector(way[0], way[1], way[2]);
  }

  /// @}
  /// \name Cells, Edges and Neighbors
  /// Functions get ids of representatives. A shift is that of an image: the image of point j by
  /// `shift` is at `point(j)` plus `shift[0]`, `shift[1]` and `shift[2]` times the cell's vectors.
  /// @{

  /// calls `f(ids, shifts)` once for each cell, with arrays of four ids and four shifts: the images
  /// of these points are the vertices of a positively oriented tetrahedron. The first shift is (0,
  /// 0, 0). Cost: one pass over the cells.
  template <class Function>
  void for_each_cell(const Function& f) const
  {
    const auto& arrays = state().arrays;
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
      if (arrays.is_infinite(c))
        continue;
      const auto sites = arrays.sites(c);
      std::array<size_type, 4> cell_ids;
      std::array<Periodic_shift_3, 4> shifts;
      for (int i = 0; i < 4; ++i) {
        cell_ids[std::size_t(i)] = id_of(sites[i]);
        shifts[std::size_t(i)] = shift_between(sites[0], sites[i]);
      }
      f(cell_ids, shifts);
    }
  }

  /// calls `f(i, j, shift)` once for each edge: the image of point j by `shift` is a neighbor of
  /// point i. Cost: one pass over the stars of all vertices; in all it allocates a list of some
  /// neighbors.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    Star star;
    for (Vertex_index v(1); v <= state().number_of_vertices() && all_cells() > 0; ++v) {
      const Site site{v, {}};
      for (const Site& neighbor : star.neighbors(state(), v))
        if (site < neighbor)
          f(id_of(site), id_of(neighbor), shift_between(site, neighbor));
    }
  }

  /// calls `f(j, shift)` once for each neighbor of a point, or of its representative, in any order:
  /// the image of point j by `shift`. Cost: it allocates two bytes for each cell, so it is linear;
  /// for many points use `Delaunay_neighbor_lists_3`. \throws Unknown_id_error_2 if no point has
  /// this id.
  template <class Function>
  void for_each_neighbor(size_type id, const Function& f) const
  {
    this->check_id(id);
    if (all_cells() == 0)
      return;
    const Site site{ids().vertex(Point_id(id)), {}};
    Star star;
    for (const Site& neighbor : star.neighbors(state(), site.vertex))
      f(id_of(neighbor), shift_between(site, neighbor));
  }

  /// @}

private:
  // Finds neighbors of vertices, one after the other.
  class Star
  {
  public:
    const std::vector<Site>& neighbors(const State& state, Vertex_index v)
    {
      find_star(state.arrays, v, m_marks, m_cells);
      m_neighbors.clear();
      for (const Cell_index c : m_cells) {
        const auto sites = state.arrays.sites(c);
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j)
            if (i != j && sites[i].vertex == v && !sites[j].is_infinite())
              m_neighbors.push_back({sites[j].vertex, sites[j].shift - sites[i].shift});
      }
      std::sort(m_neighbors.begin(), m_neighbors.end());
      m_neighbors.erase(std::unique(m_neighbors.begin(), m_neighbors.end()), m_neighbors.end());
      return m_neighbors;
    }

  private:
    Dynamic_Delaunay_triangulations_3::internal::Cell_marks_3 m_marks;
    std::vector<Cell_index> m_cells;
    std::vector<Site> m_neighbors;
  };

  static State empty_state(const Periodic_cell_3& cell)
  {
    const Floating_point floating_point;
    return State(cell);
  }

  // With infinite ones.
  size_type all_cells() const { return state().arrays.number_of_cells(); }
  // Each belongs to an infinite cell. One without a finite cell beneath, where all points are in a
  // plane, counts twice.
  size_type number_of_hull_facets() const
  {
    size_type number = 0;
    if (cell().dimension() < 3)
      for (Cell_index c(0); c < all_cells(); ++c)
        number += state().arrays.is_infinite(c);
    return number;
  }

  size_type id_of(const Site& site) const { return size_type(ids().representative(site.vertex)); }

  // The shift of the second site's point where that of the first one is not shifted.
  Periodic_shift_3 shift_between(const Site& from, const Site& to) const
  {
    const auto& positions = state().positions;
    const Multiples first = positions.multiples(from.vertex) + from.shift.multiples();
    const Multiples second = positions.multiples(to.vertex) + to.shift.multiples();
    return state().torus.in_vectors_of_cell(second - first);
  }
};

CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE_3(Torus_space_3)

} // namespace CGAL

#endif // CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_3_H
