// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Triangulation_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Update_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/iterator.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_3::internal {

// What other headers of the package use of the class, and programs do not.
struct Access_3
{
  template <class Dynamic>
  static const auto& state(const Dynamic& dt)
  {
    return dt.m_core->state;
  }
};

} // namespace Dynamic_Delaunay_triangulations_3::internal

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Maintains the Delaunay triangulation of moving points in space. Every `update()` takes the new
positions of all points, repairs what the motion broke, and reports what it did.

Points have ids: 0, 1, 2, ... in the order in which they are given, as in
`Dynamic_Delaunay_triangulation_2`. `insert()` adds points, and `remove()` removes them. The id of a
removed point is free, and the next point that is inserted gets the smallest free id. Points that
coincide share a vertex as long as they do; their representative is the one that was there first.

After every call the triangulation is <em>certified</em>: exact predicates have proved that its
cells are positively oriented, that they cover the convex hull once, and that each facet is locally
Delaunay. So it is a Delaunay triangulation of the points. Fewer than four points, and points in a
plane or on a line, have no cells; edges and facets are then those of a Delaunay triangulation in
their plane.

The method is \ref DynamicDelaunaySection_Space "hold, flip and release in space". Cost of an
update: one pass over the cells in floating point, and what its repair takes, never much more than
to triangulate all points anew. Memory: some 300 bytes a point, from the first frame on 420.

\tparam Traits a CGAL kernel with exact predicates, such as
  `Exact_predicates_inexact_constructions_kernel`; where its coordinates are not doubles, floating
  point proves nothing for coordinates that are rounded, and exact predicates do everything.
\tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag`, which needs TBB: threads then share the
  passes over all points and cells. Results do not depend on it.
*/
template <class Traits, class ConcurrencyTag = Sequential_tag>
class Dynamic_Delaunay_triangulation_3
{
  friend Dynamic_Delaunay_triangulations_3::internal::Access_3;
  using State =
      Dynamic_Delaunay_triangulations_3::internal::Triangulation_state_3<Traits, ConcurrencyTag>;
  using Update = Dynamic_Delaunay_triangulations_3::internal::Update_3<State>;
  using Input = Dynamic_Delaunay_triangulations_3::internal::Input_3<State>;
  using Change = Dynamic_Delaunay_triangulations_3::internal::Change_3<typename Traits::Point_3>;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using Identity_map = boost::typed_identity_property_map<typename Traits::Point_3>;
  using Index = Dynamic_Delaunay_triangulations_3::Index;
  using Cell_index = Dynamic_Delaunay_triangulations_3::Cell_index;
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  template <class Range>
  using If_range = decltype(std::begin(std::declval<const Range&>()));
  template <class Map>
  using If_map = typename boost::property_traits<Map>::key_type;

public:
  /// \name Types
  /// @{

  /// the traits, or kernel.
  using Geom_traits = Traits;
  /// a point.
  using Point = typename Traits::Point_3;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// whether work is shared among threads.
  using Concurrency_tag = ConcurrencyTag;

  /// @}
  /// \name Creation
  /// @{

  /// creates an empty triangulation.
  explicit Dynamic_Delaunay_triangulation_3(const Traits& traits = Traits())
    : m_core(std::make_unique<Core>(traits))
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
                                   const Traits& traits = Traits())
    : Dynamic_Delaunay_triangulation_3(traits)
  {
    insert(first, beyond);
  }

  /// triangulates the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  explicit Dynamic_Delaunay_triangulation_3(const Range& range, const Traits& traits = Traits())
    : Dynamic_Delaunay_triangulation_3(std::begin(range), std::end(range), traits)
  {
  }

  /// copies everything. From then on the same calls have the same results for both. Cost: linear.
  Dynamic_Delaunay_triangulation_3(const Dynamic_Delaunay_triangulation_3& other)
    : m_core(std::make_unique<Core>(other.m_core->state.traits))
  {
    m_core->state = other.m_core->state;
    m_core->update.take_over(other.m_core->update);
  }
  /// takes everything from the other triangulation, and leaves it empty.
  Dynamic_Delaunay_triangulation_3(Dynamic_Delaunay_triangulation_3&& other)
    : m_core(std::make_unique<Core>(other.m_core->state.traits))
  {
    swap(other);
  }
  /// replaces this triangulation by the other one.
  Dynamic_Delaunay_triangulation_3& operator=(Dynamic_Delaunay_triangulation_3 other)
  {
    swap(other);
    return *this;
  }
  /// exchanges everything with the other triangulation.
  void swap(Dynamic_Delaunay_triangulation_3& other) noexcept { m_core.swap(other.m_core); }
  /// calls `a.swap(b)`.
  friend void swap(Dynamic_Delaunay_triangulation_3& a,
                   Dynamic_Delaunay_triangulation_3& b) noexcept
  {
    a.swap(b);
  }

  /// @}
  /// \name Motion
  /// @{

  /// moves point i to the i-th position of the range, for all points, and repairs the
  /// triangulation. The range has one position for each id; positions for ids of removed points are
  /// ignored.
  ///
  /// Nothing changes if it throws one of these, or if the range throws. If memory runs out later,
  /// the points have their new positions and there are no cells until the next call.
  /// \throws Point_count_error_2 if the number of positions is not `number_of_ids()`.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_3 if a coordinate is too large for this program.
  /// \post `is_certified()`
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`; by
  ///   default the values are points.
  template <class InputIterator, class PointMap = Identity_map, class = If_map<PointMap>>
  Update_report_3 update(InputIterator first, InputIterator beyond,
                         const PointMap& point_map = PointMap())
  {
    const Floating_point floating_point;
    Input::stage(first, beyond, point_map, m_core->state, m_core->update.staged());
    Change change;
    change.is_frame = true;
    return m_core->update.run(change);
  }

  /// moves all points to the positions of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_3 update(const Range& range)
  {
    return update(std::begin(range), std::end(range));
  }

  /// moves all points to the positions that `point_map` reads from a range.
  template <class Range, class PointMap, class = If_range<Range>, class = If_map<PointMap>>
  Update_report_3 update(const Range& range, const PointMap& point_map)
  {
    return update(std::begin(range), std::end(range), point_map);
  }

  /// moves some points, and repairs what that breaks; all others stay. Cost: about a tenth of a
  /// millisecond each, but never much more than to triangulate all points anew.
  ///
  /// Nothing changes if it throws one of these, or if the range throws.
  /// \tparam InputIterator its values are pairs of an id and a `Point`.
  /// \throws Unknown_id_error_2 if no point has one of the ids.
  /// \throws Repeated_id_error_2 if an id is there more than once.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_3 if a coordinate is too large for this program.
  /// \post `is_certified()`
  template <class InputIterator>
  Update_report_3 move(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    Change change;
    for (; first != beyond; ++first) {
      const auto& [id, point] = *first;
      check_id(size_type(id));
      Dynamic_Delaunay_triangulations_3::internal::checked_position<Point>(point, size_type(id));
      change.moved.emplace_back(id);
      change.moved_points.push_back(point);
    }
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(change.moved);
    return m_core->update.run(change);
  }

  /// moves one point.
  Update_report_3 move(size_type id, const Point& point)
  {
    const std::pair<size_type, Point> mover(id, point);
    return move(&mover, &mover + 1);
  }

  /// @}
  /// \name Insertion and Removal
  /// @{

  /// inserts a point. \return its id.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_3 if a coordinate is too large for this program.
  size_type insert(const Point& point)
  {
    size_type id = 0;
    insert(&point, &point + 1, &id);
    return id;
  }

  /// inserts the points of a range, and writes their ids, in the same order, to `ids`.
  /// \throws Non_finite_coordinate_error_3, Coordinate_range_error_3 as above; the error's id is
  ///   the one that the point would get. Then nothing has changed.
  /// \throws Point_limit_error_2 if there would be more points than 32 bits allow.
  template <class InputIterator, class OutputIterator = Emptyset_iterator>
  Update_report_3 insert(InputIterator first, InputIterator beyond,
                         OutputIterator ids = OutputIterator())
  {
    const Floating_point floating_point;
    Change change;
    Input::read_newcomers(first, beyond, m_core->state, change);
    const Update_report_3 report = m_core->update.run(change);
    for (const Point_id id : change.coming)
      *ids++ = size_type(id);
    return report;
  }

  /// removes a point; its id becomes free.
  /// \throws Unknown_id_error_2 if no point has this id.
  Update_report_3 remove(size_type id) { return remove(&id, &id + 1); }

  /// removes the points with the ids of a range. Cost: about ten times that of an insertion each,
  /// but never much more than to triangulate the remaining points anew.
  /// \throws Unknown_id_error_2 if one of them has no point.
  /// \throws Repeated_id_error_2 if an id is there more than once.
  template <class InputIterator>
  Update_report_3 remove(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    Change change;
    for (; first != beyond; ++first) {
      check_id(size_type(*first));
      change.gone.emplace_back(*first);
    }
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(change.gone);
    return m_core->update.run(change);
  }
  /// removes the points with these ids.
  Update_report_3 remove(std::initializer_list<size_type> ids)
  {
    return remove(ids.begin(), ids.end());
  }

  /// @}
  /// \name Certainty
  /// @{

  /// whether the triangulation is proved Delaunay: false only after a call that memory did not
  /// suffice for.
  bool is_certified() const { return m_core->update.is_certified(); }

  /// makes the triangulation Delaunay and certified after such a call. Else it does nothing.
  /// \post `is_certified()`
  Update_report_3 mend()
  {
    const Floating_point floating_point;
    Update_report_3 report;
    report.certified = true;
    return is_certified() ? report : m_core->update.run(Change());
  }

  /// tests everything again by exact predicates, with what floating point had proved: whether the
  /// cells fit together, each vertex has one, all are positive, cover space once, and are locally
  /// Delaunay; without cells, whether the points are coplanar. Cost: microseconds a point.
  /// \param verbose whether to print to `std::cerr` what is wrong.
  bool is_valid(bool verbose = false) const
  {
    const Floating_point floating_point;
    const char* const problem = m_core->update.problem();
    if (problem != nullptr && verbose)
      std::cerr << "Dynamic_Delaunay_triangulation_3: " << problem << '\n';
    return problem == nullptr;
  }

  /// @}
  /// \name Points and Ids
  /// @{

  /// the number of points, coincident ones included.
  size_type number_of_points() const { return ids().number_of_points(); }
  /// one more than the largest id ever in use. It never decreases.
  size_type number_of_ids() const { return ids().number_of_ids(); }
  /// whether a point has this id.
  bool has_id(size_type id) const { return ids().is_taken(id); }
  /// the number of vertices: less than the number of points if points coincide.
  size_type number_of_vertices() const { return ids().number_of_representatives(); }
  /// the number of finite cells. Cost: one pass over the cells.
  size_type number_of_cells() const
  {
    size_type number = 0;
    for_each_cell([&](const std::array<size_type, 4>&) { ++number; });
    return number;
  }
  /// -1 without points, 0 if all coincide, 1 if they are on a line, 2 in a plane, else 3.
  int dimension() const
  {
    const State& state = m_core->state;
    if (state.spans_space)
      return 3;
    if (!state.flat_triangles.empty())
      return 2;
    return !state.flat_edges.empty() ? 1 : number_of_points() > 0 ? 0 : -1;
  }

  /// the position of a point.
  /// \throws Unknown_id_error_2 if no point has this id.
  Point point(size_type id) const
  {
    check_id(id);
    return ids().is_representative(Point_id(id))
               ? Point(m_core->state.point(ids().vertex(Point_id(id))))
               : ids().covered_point(Point_id(id));
  }

  /// the id of the representative of this point: of all points that coincide with it, the one that
  /// was there first.
  /// \throws Unknown_id_error_2 if no point has this id.
  size_type representative(size_type id) const
  {
    check_id(id);
    return representative_of(ids().vertex(Point_id(id)));
  }

  /// @}
  /// \name Cells, Facets, Edges and Neighbors
  /// Functions get ids of representatives. They allocate memory only where this is said.
  /// @{

  /// calls `f(ids)` once for each finite cell, with an array of the ids of its four vertices,
  /// positively oriented. Cost: one pass over the cells.
  template <class Function>
  void for_each_cell(const Function& f) const
  {
    const auto& arrays = m_core->state.arrays;
    for (Cell_index c(0); c < cells(); ++c)
      if (!arrays.is_infinite(c))
        f(ids_of(arrays.vertices(c)));
  }

  /// calls `f(ids)` once for each finite facet, those on the hull included, with an array of the
  /// ids of its three vertices. Cost: one pass over the cells.
  template <class Function>
  void for_each_facet(const Function& f) const
  {
    const auto& arrays = m_core->state.arrays;
    for (const auto& triangle : m_core->state.flat_triangles)
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
    for (const auto& edge : m_core->state.flat_edges)
      f(representative_of(edge[0]), representative_of(edge[1]));
    if (cells() == 0)
      return;
    Star star;
    for (Vertex_index v(1); v <= m_core->state.number_of_vertices(); ++v)
      for (const Vertex_index w : star.neighbors(m_core->state, v))
        if (v < w)
          f(representative_of(v), representative_of(w));
  }

  /// calls `f(j)` once for each neighbor j of a point, or of its representative, in any order.
  /// Cost: proportional to the number of neighbors, for a list of which it allocates memory;
  /// without cells, to the number of points. \throws Unknown_id_error_2 if no point has this id.
  template <class Function>
  void for_each_neighbor(size_type id, const Function& f) const
  {
    check_id(id);
    const Vertex_index u = ids().vertex(Point_id(id));
    for (const auto& edge : m_core->state.flat_edges)
      for (const int i : {0, 1})
        if (edge[i] == u)
          f(representative_of(edge[1 - i]));
    if (cells() == 0)
      return;
    Star star;
    for (const Vertex_index v : star.neighbors(m_core->state, u))
      f(representative_of(v));
  }

  /// @}

private:
  // Must not move in memory: its parts refer to each other.
  struct Core
  {
    explicit Core(const Traits& traits)
      : state(traits)
    {
    }

    State state;
    Update update{state};
  };

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

  const typename State::Ids& ids() const { return m_core->state.ids; }
  Index cells() const
  {
    return m_core->state.spans_space ? m_core->state.arrays.number_of_cells() : 0;
  }
  void check_id(size_type id) const
  {
    if (!has_id(id))
      throw Unknown_id_error_2(id, number_of_ids());
  }

  size_type representative_of(Vertex_index v) const { return ids().representative(v); }
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
    const int infinite = m_core->state.arrays.place_of(
        c, Dynamic_Delaunay_triangulations_3::internal::infinite_index);
    return infinite == 4 || infinite == place;
  }
  std::array<size_type, 3> ids_without(Cell_index c, int place) const
  {
    std::array<size_type, 3> result;
    std::size_t number = 0;
    for (int i = 0; i < 4; ++i)
      if (i != place)
        result[number++] = representative_of(m_core->state.arrays.vertices(c)[i]);
    return result;
  }

  std::unique_ptr<Core> m_core;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H
