// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_triangulation_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Open_space_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Maintains the Delaunay triangulation of moving points in space. Every `update()` takes the new
positions of all points, repairs what the motion broke, and reports what it did.

Points have ids: 0, 1, 2, ... in the order in which they are given, as in
`Dynamic_Delaunay_triangulation_2`. `insert()` adds points, and `remove()` removes them. The id of a
removed point is free, and the next point that is inserted gets the smallest free id. Points that
coincide share a vertex as long as they do; their representative is the one that was there first,
and of those that are inserted together the one with the smallest id.

After every call the triangulation is <em>certified</em>: exact predicates have proved that its
cells are positively oriented, that they cover the convex hull once, and that each facet is locally
Delaunay. So it is a Delaunay triangulation of the points. Fewer than four points, and points in a
plane or on a line, have no cells; edges and facets are then those of a Delaunay triangulation in
their plane.

The method is \ref DynamicDelaunaySection_Space "hold, flip and release in space". Cost of an
update: one pass over the cells in floating point, and what its repair takes, never much more than
to triangulate all points anew. Memory: some 260 bytes a point, from the first frame on 300.

\tparam Traits a CGAL kernel with exact predicates, such as
  `Exact_predicates_inexact_constructions_kernel`; where its coordinates are not doubles, floating
  point proves nothing for coordinates that are rounded, and exact predicates do everything.
\tparam Options any of these, in any order:
  - `With_concurrency_2<ConcurrencyTag>`: `Sequential_tag`, the default, or `Parallel_tag`, which
    needs TBB: threads then share constructions and rebuilds, the passes over all points and
    cells, and flips (\ref SpaceThreads). Results do not depend on it.
  - `With_visitor_2<Visitor>`: is told which edges and facets come and go, such as
    `Edge_changes_visitor_3`: has the functions of `Delaunay_update_visitor_base_3`, the default,
    which costs nothing.
  - `With_policy_2<UpdatePolicy>`, a model of `DelaunayUpdatePolicy_2`: says which frames are
    rebuilt at once, such as those in which a program knows that all is new. By default
    `Always_dynamic_policy_2`.
*/
template <class Traits, class... Options>
class Dynamic_Delaunay_triangulation_3
  : public Dynamic_triangulation_base_3<
        Dynamic_Delaunay_triangulation_3<Traits, Options...>,
        Dynamic_Delaunay_triangulations_3::internal::Open_space_3<
            Traits, typename Dynamic_Delaunay_triangulations_3::internal::Chosen_types_3<
                        Options...>::Concurrency_tag>,
        Options...>
{
  using Base = Dynamic_triangulation_base_3<
      Dynamic_Delaunay_triangulation_3,
      Dynamic_Delaunay_triangulations_3::internal::Open_space_3<
          Traits, typename Dynamic_Delaunay_triangulations_3::internal::Chosen_types_3<
                      Options...>::Concurrency_tag>,
      Options...>;
  friend Base;
  friend Dynamic_Delaunay_triangulations_3::internal::Triangulation_access;
  using Base::cells;
  using Base::ids;
  using Base::representative_of;
  using Base::state;
  using typename Base::Cell_index;
  using typename Base::Index;
  using typename Base::Point_id;
  using typename Base::State;
  using typename Base::Vertex_index;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;
  template <class Map>
  using If_map = Dynamic_Delaunay_triangulations_2::internal::If_map<Map>;

public:
  using typename Base::Settings;
  using typename Base::size_type;

  /// \name Creation
  /// @{

  /// creates an empty triangulation, with the defaults of its policy and visitor.
  Dynamic_Delaunay_triangulation_3()
    : Dynamic_Delaunay_triangulation_3(Settings())
  {
  }

  /// creates an empty triangulation with these settings, which may be a policy alone.
  explicit Dynamic_Delaunay_triangulation_3(const Settings& settings,
                                            const Traits& traits = Traits())
    : Base(State(traits), settings)
  {
  }

  /// triangulates the points of the range; the i-th one has id i.
  ///
  /// Cost: that of CGAL's insertion of a range of points, or less.
  /// \tparam InputIterator its values are convertible to `Point`.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_3 if a coordinate is too large for this program.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow: 134,217,727.
  template <class InputIterator>
  Dynamic_Delaunay_triangulation_3(InputIterator first, InputIterator beyond,
                                   const Settings& settings = Settings(),
                                   const Traits& traits = Traits())
    : Dynamic_Delaunay_triangulation_3(settings, traits)
  {
    this->insert(first, beyond);
  }

  /// triangulates the points that `point_map` reads from the values of the range.
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`.
  template <class InputIterator, class PointMap, class = If_map<PointMap>>
  Dynamic_Delaunay_triangulation_3(InputIterator first, InputIterator beyond,
                                   const PointMap& point_map, const Settings& settings = Settings(),
                                   const Traits& traits = Traits())
    : Dynamic_Delaunay_triangulation_3(settings, traits)
  {
    this->insert(first, beyond, point_map, Emptyset_iterator());
  }

  /// triangulates the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  explicit Dynamic_Delaunay_triangulation_3(const Range& range,
                                            const Settings& settings = Settings(),
                                            const Traits& traits = Traits())
    : Dynamic_Delaunay_triangulation_3(std::begin(range), std::end(range), settings, traits)
  {
  }

  /// triangulates the points that `point_map` reads from a range with `begin()` and `end()`.
  template <class Range, class PointMap, class = If_range<Range>, class = If_map<PointMap>>
  Dynamic_Delaunay_triangulation_3(const Range& range, const PointMap& point_map,
                                   const Settings& settings = Settings(),
                                   const Traits& traits = Traits())
    : Dynamic_Delaunay_triangulation_3(std::begin(range), std::end(range), point_map, settings,
                                       traits)
  {
  }

  /// @}
  /// \name Cells, Facets, Edges and Neighbors
  /// Functions get ids of representatives. They allocate memory only where this is said.
  /// @{

  /// the number of finite cells. Cost: one pass over the cells.
  size_type number_of_cells() const
  {
    size_type number = 0;
    for_each_cell([&](const std::array<size_type, 4>&) { ++number; });
    return number;
  }
  /// -1 without points, 0 if all coincide, 1 if they are on a line, 2 in a plane, else 3.
  int dimension() const { return state().dimension(); }

  /// calls `f(ids)` once for each finite cell, with an array of the ids of its four vertices,
  /// positively oriented. Cost: one pass over the cells.
  template <class Function>
  void for_each_cell(const Function& f) const
  {
    const auto& arrays = state().arrays;
    for (Cell_index c(0); c < cells(); ++c)
      if (!arrays.is_infinite(c))
        f(ids_of(arrays.vertices(c)));
  }

  /// calls `f(ids)` once for each finite facet, those on the hull included, with an array of the
  /// ids of its three vertices. Cost: one pass over the cells.
  template <class Function>
  void for_each_facet(const Function& f) const
  {
    const auto& arrays = state().arrays;
    for (const auto& triangle : state().flat_triangles)
      f(ids_of(triangle));
    for (Cell_index c(0); c < cells(); ++c)
      for (int i = 0; i < 4; ++i) {
        const auto k = arrays.corner(c, i);
        if (k < arrays.mirror(k) && is_finite_without(c, i))
          f(ids_without(c, i));
      }
  }

  /// calls `f(i, j)` once for each finite edge. Cost: one pass over the stars of all vertices; in
  /// all it allocates a list of some neighbors.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for (const auto& edge : state().flat_edges)
      f(representative_of(edge[0]), representative_of(edge[1]));
    if (cells() == 0)
      return;
    Star star;
    for (Vertex_index v(1); v <= state().number_of_vertices(); ++v)
      for (const Vertex_index w : star.neighbors(state(), v))
        if (v < w)
          f(representative_of(v), representative_of(w));
  }

  /// calls `f(j)` once for each neighbor j of a point, or of its representative, in any order.
  /// Cost: it allocates two bytes for each cell, so it is linear; for many points use
  /// `Delaunay_neighbor_lists_3`. \throws Unknown_id_error_2 if no point has this id.
  template <class Function>
  void for_each_neighbor(size_type id, const Function& f) const
  {
    this->check_id(id);
    const Vertex_index u = ids().vertex(Point_id(id));
    for (const auto& edge : state().flat_edges)
      for (const int i : {0, 1})
        if (edge[i] == u)
          f(representative_of(edge[1 - i]));
    if (cells() == 0)
      return;
    Star star;
    for (const Vertex_index v : star.neighbors(state(), u))
      f(representative_of(v));
  }

  /// @}

private:
  // Finds neighbors of vertices, one after the other.
  class Star
  {
  public:
    const std::vector<Vertex_index>& neighbors(const State& state, Vertex_index v)
    {
      Dynamic_Delaunay_triangulations_3::internal::find_star(state.arrays, v, m_marks, m_cells);
      m_neighbors.clear();
      for (const Cell_index c : m_cells)
        for (const Vertex_index w : state.arrays.vertices(c))
          if (w != v && w != Dynamic_Delaunay_triangulations_3::internal::infinite_index)
            m_neighbors.push_back(w);
      std::sort(m_neighbors.begin(), m_neighbors.end());
      m_neighbors.erase(std::unique(m_neighbors.begin(), m_neighbors.end()), m_neighbors.end());
      return m_neighbors;
    }

  private:
    Dynamic_Delaunay_triangulations_3::internal::Cell_marks_3 m_marks;
    std::vector<Cell_index> m_cells;
    std::vector<Vertex_index> m_neighbors;
  };

  template <int n>
  auto
  ids_of(const Dynamic_Delaunay_triangulations_3::internal::Few<Vertex_index, n>& vertices) const
  {
    std::array<size_type, n> result;
    std::transform(vertices.begin(), vertices.end(), result.begin(),
                   [this](Vertex_index v) { return representative_of(v); });
    return result;
  }
  bool is_finite_without(Cell_index c, int place) const
  {
    const int infinite =
        state().arrays.place_of(c, Dynamic_Delaunay_triangulations_3::internal::infinite_index);
    return infinite == 4 || infinite == place;
  }
  std::array<size_type, 3> ids_without(Cell_index c, int place) const
  {
    std::array<size_type, 3> result;
    std::size_t number = 0;
    for (int i = 0; i < 4; ++i)
      if (i != place)
        result[number++] = representative_of(state().arrays.vertices(c)[i]);
    return result;
  }
};

CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE_3(Open_space_3)

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H
