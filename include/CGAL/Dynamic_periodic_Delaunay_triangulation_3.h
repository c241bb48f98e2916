// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_3_H
#define CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_options_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_space_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Update_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>
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
struct Access_3; // of queries
}

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The Delaunay triangulation of points that move in a periodic space of three dimensions, in which
everything is repeated by the vectors of a `Periodic_cell_3`: a flat torus. The cell may be any
parallelepiped, and may change with every frame.

Points may be given anywhere in space, wrapped into the cell or not. The images p + i a + j b + k c
of a point p, for integers i, j and k, are triangulated as real numbers, and never rounded. There is
one sheet, however few points there are: so a point can be a neighbor of its own images, and two
points can have several edges.

Points have ids as in `Dynamic_Delaunay_triangulation_3`: the i-th point of the range has id i, and
points that are inserted get the smallest free ids. Points that coincide, also by a translation of
the lattice, share a vertex.

After every call the triangulation is <em>certified</em>: exact predicates have proved that its
cells are positively oriented, that they cover the torus once, and that each facet is locally
Delaunay. Where five or more points are on an empty sphere, a symbolic perturbation that is the same
for all images chooses one of their triangulations: so it is unique.

\tparam Traits a CGAL kernel whose points have coordinates of type `double`, such as
  `Exact_predicates_inexact_constructions_kernel`.
\tparam Options none, or `With_concurrency_2<ConcurrencyTag>`: `Sequential_tag`, the default, or
  `Parallel_tag`, which needs TBB: threads then share the passes over all cells. Results do not
  depend on it.
*/
template <class Traits, class... Options>
class Dynamic_periodic_Delaunay_triangulation_3
{
  friend Dynamic_Delaunay_triangulations_3::internal::Access_3;
  static_assert(sizeof...(Options) <= 1 &&
                    Dynamic_Delaunay_triangulations_2::internal::number_of_options<
                        With_concurrency_2, Options...> == sizeof...(Options),
                "after the traits, a triangulation in periodic space takes the option "
                "With_concurrency_2<>, and nothing else");
  using ConcurrencyTag = typename Dynamic_Delaunay_triangulations_2::internal::Option_2<
      With_concurrency_2, Sequential_tag, Options...>::type;
  using Space = Dynamic_Delaunay_triangulations_3::internal::Torus_space_3<Traits, ConcurrencyTag>;
  using State = typename Space::State;
  using Update = Dynamic_Delaunay_triangulations_3::internal::Update_3<Space>;
  using Input = Dynamic_Delaunay_triangulations_3::internal::Input_3<State>;
  using Change = Dynamic_Delaunay_triangulations_3::internal::Change_3<typename Traits::Point_3>;
  using Multiples = Dynamic_Delaunay_triangulations_3::internal::Multiples_3;
  using Site = Dynamic_Delaunay_triangulations_3::internal::Torus_site_3;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using Identity_map = boost::typed_identity_property_map<typename Traits::Point_3>;
  using Cell_index = Dynamic_Delaunay_triangulations_3::Cell_index;
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;
  template <class Map>
  using If_map = Dynamic_Delaunay_triangulations_2::internal::If_map<Map>;
  template <class Iterator>
  using First_of = Dynamic_Delaunay_triangulations_2::internal::First_of<Iterator>;
  template <class Iterator>
  using Second_of = Dynamic_Delaunay_triangulations_2::internal::Second_of<Iterator>;

public:
  /// \name Types
  /// @{

  /// the traits, or kernel.
  using Geom_traits = Traits;
  /// a point.
  using Point = typename Traits::Point_3;
  /// a vector.
  using Vector = typename Traits::Vector_3;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// whether work is shared among threads.
  using Concurrency_tag = ConcurrencyTag;

  /// @}
  /// \name Creation
  /// @{

  /// creates an empty triangulation of the torus with this cell.
  /// \throws Periodic_cell_error_3 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it.
  explicit Dynamic_periodic_Delaunay_triangulation_3(const Periodic_cell_3& cell)
    : m_core(make_core(cell))
  {
  }

  /// triangulates the points of the range; the i-th one has id i.
  /// \tparam InputIterator its values are convertible to `Point`.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_3 if a point is 2<sup>20</sup> cells or more from the origin.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow.
  /// \throws Periodic_cell_error_3 as above.
  template <class InputIterator>
  Dynamic_periodic_Delaunay_triangulation_3(InputIterator first, InputIterator beyond,
                                            const Periodic_cell_3& cell)
    : Dynamic_periodic_Delaunay_triangulation_3(cell)
  {
    insert(first, beyond);
  }

  /// triangulates the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Dynamic_periodic_Delaunay_triangulation_3(const Range& range, const Periodic_cell_3& cell)
    : Dynamic_periodic_Delaunay_triangulation_3(std::begin(range), std::end(range), cell)
  {
  }

  /// copies everything. From then on the same calls have the same results for both. Cost: linear.
  Dynamic_periodic_Delaunay_triangulation_3(const Dynamic_periodic_Delaunay_triangulation_3& other)
    : m_core(std::make_unique<Core>(other.m_core->state))
  {
    m_core->kernel.take_over(other.m_core->kernel);
  }
  /// takes everything from the other triangulation, and leaves it empty, with the same cell.
  Dynamic_periodic_Delaunay_triangulation_3(Dynamic_periodic_Delaunay_triangulation_3&& other)
    : Dynamic_periodic_Delaunay_triangulation_3(other.cell())
  {
    swap(other);
  }
  /// replaces this triangulation by the other one.
  Dynamic_periodic_Delaunay_triangulation_3&
  operator=(Dynamic_periodic_Delaunay_triangulation_3 other)
  {
    swap(other);
    return *this;
  }
  /// exchanges everything with the other triangulation.
  void swap(Dynamic_periodic_Delaunay_triangulation_3& other) noexcept
  {
    m_core.swap(other.m_core);
  }
  /// calls `a.swap(b)`.
  friend void swap(Dynamic_periodic_Delaunay_triangulation_3& a,
                   Dynamic_periodic_Delaunay_triangulation_3& b) noexcept
  {
    a.swap(b);
  }

  /// @}
  /// \name Motion
  /// @{

  /// moves point i to the i-th position of the range, for all points, and repairs the
  /// triangulation. The range has one position for each id; positions for ids of removed points are
  /// ignored. A point that is given at another of its images, as by wrapping it into the cell,
  /// counts as moved to the image that is nearest to where it was.
  ///
  /// Nothing changes if it throws one of these, or if the range throws. If memory runs out later,
  /// the points have their new positions and there are no cells until the next call.
  /// \throws Point_count_error_2 if the number of positions is not `number_of_ids()`.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_3 if a point is 2<sup>20</sup> cells or more from the origin.
  /// \post `is_certified()`
  template <class InputIterator, class PointMap = Identity_map, class = If_map<PointMap>>
  Update_report_3 update(InputIterator first, InputIterator beyond,
                         const PointMap& point_map = PointMap())
  {
    return update(first, beyond, point_map, cell());
  }

  /// takes the positions from a range with `begin()` and `end()`.
  template <class Range, class PointMap = Identity_map, class = If_range<Range>,
            class = If_map<PointMap>>
  Update_report_3 update(const Range& range, const PointMap& point_map = PointMap())
  {
    return update(std::begin(range), std::end(range), point_map);
  }

  /// moves the points as `update(first, beyond)` does, in a cell that has changed since the last
  /// call: by deformation, by other vectors for the same lattice, as when a sheared cell is
  /// flipped, or by both.
  /// \throws Periodic_cell_error_3 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it; else what `update(first, beyond)` throws. Nothing has changed
  /// then.
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
    const Floating_point floating_point;
    m_core->kernel.staged().set_cell(m_core->state.torus, cell);
    Input::stage(first, beyond, point_map, m_core->state, m_core->kernel.staged());
    Change change;
    change.is_frame = true;
    return m_core->kernel.run(change);
  }

  /// moves some points, and repairs what that breaks; all others stay.
  ///
  /// Nothing changes if it throws one of these, or if the range throws.
  /// \tparam IdMap, PointMap models of `ReadablePropertyMap` from the range's values to ids, any
  ///   integers, and to `Point`; by default the values are pairs of both.
  /// \throws Unknown_id_error_2 if no point has one of the ids.
  /// \throws Repeated_id_error_2 if an id is there more than once.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_3 if a point is 2<sup>20</sup> cells or more from the origin.
  /// \post `is_certified()`
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>>
  Update_report_3 move(InputIterator first, InputIterator beyond, const IdMap& id_map = IdMap(),
                       const PointMap& point_map = PointMap())
  {
    const Floating_point floating_point;
    Change change;
    for (; first != beyond; ++first) {
      auto&& value = *first;
      const auto id = size_type(get(id_map, value));
      check_id(id);
      change.moved.emplace_back(id);
      change.moved_points.push_back(get(point_map, value));
      m_core->state.check(change.moved_points.back(), id);
    }
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(change.moved);
    return m_core->kernel.run(change);
  }

  /// moves the points of a range with `begin()` and `end()`.
  template <class Range, class IdMap = First_of<If_range<Range>>,
            class PointMap = Second_of<If_range<Range>>, class = If_range<Range>>
  Update_report_3 move(const Range& range, const IdMap& id_map = IdMap(),
                       const PointMap& point_map = PointMap())
  {
    return move(std::begin(range), std::end(range), id_map, point_map);
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
  /// \throws Periodic_range_error_3 if it is 2<sup>20</sup> cells or more from the origin.
  size_type insert(const Point& point)
  {
    size_type id = 0;
    insert(&point, &point + 1, &id);
    return id;
  }

  /// inserts the points of a range, and writes their ids, in the same order, to `ids`.
  /// \throws Non_finite_coordinate_error_3, Periodic_range_error_3 as above; the error's id is the
  ///   one that the point would get. Then nothing has changed.
  /// \throws Point_limit_error_2 if there would be more points than 32 bits allow.
  template <class InputIterator, class OutputIterator = Emptyset_iterator>
  Update_report_3 insert(InputIterator first, InputIterator beyond,
                         OutputIterator ids = OutputIterator())
  {
    const Floating_point floating_point;
    Change change;
    Input::read_newcomers(first, beyond, Identity_map(), m_core->state, change);
    const Update_report_3 report = m_core->kernel.run(change);
    for (const Point_id id : change.coming)
      *ids++ = size_type(id);
    return report;
  }

  /// inserts the points of a range with `begin()` and `end()`.
  template <class Range, class OutputIterator = Emptyset_iterator, class = If_range<Range>>
  Update_report_3 insert(const Range& range, OutputIterator ids = OutputIterator())
  {
    return insert(std::begin(range), std::end(range), ids);
  }

  /// removes a point; its id becomes free.
  /// \throws Unknown_id_error_2 if no point has this id.
  Update_report_3 remove(size_type id) { return remove(&id, &id + 1); }

  /// removes the points with the ids of a range.
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
    return m_core->kernel.run(change);
  }
  /// removes the points whose ids are in a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Update_report_3 remove(const Range& ids)
  {
    return remove(std::begin(ids), std::end(ids));
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
  bool is_certified() const { return m_core->kernel.is_certified(); }

  /// proves the triangulation again: that the cells fit together, by a pass in floating point and
  /// exact predicates for what it leaves that they are Delaunay, and that they cover the torus
  /// once. If that fails, which only damaged memory could cause, the triangulation is not
  /// certified, and the next call rebuilds it.
  /// \return whether it is certified: false, as before, if the last call ran out of memory.
  bool certify()
  {
    const Floating_point floating_point;
    return m_core->kernel.certify();
  }

  /// makes the triangulation Delaunay and certified after such a call. Else it does nothing.
  /// \post `is_certified()`
  Update_report_3 mend()
  {
    const Floating_point floating_point;
    Update_report_3 report;
    report.certified = true;
    return is_certified() ? report : m_core->kernel.run(Change());
  }

  /// tests everything again by exact predicates, with what floating point had proved. Cost: many
  /// microseconds a point where there are ties.
  /// \param verbose whether to print to `std::cerr` what is wrong.
  bool is_valid(bool verbose = false) const
  {
    const Floating_point floating_point;
    const char* const problem = m_core->kernel.problem();
    if (problem != nullptr && verbose)
      std::cerr << "Dynamic_periodic_Delaunay_triangulation_3: " << problem << '\n';
    return problem == nullptr;
  }

  /// @}
  /// \name Points and Ids
  /// @{

  /// the cell of the last frame.
  const Periodic_cell_3& cell() const { return m_core->state.torus.cell(); }
  /// the number of points, coincident ones included.
  size_type number_of_points() const { return ids().number_of_points(); }
  /// one more than the largest id ever in use. It never decreases.
  size_type number_of_ids() const { return ids().number_of_ids(); }
  /// whether a point has this id.
  bool has_id(size_type id) const { return ids().is_taken(id); }
  /// the number of vertices: less than the number of points if points coincide.
  size_type number_of_vertices() const { return ids().number_of_representatives(); }
  /// the number of cells.
  size_type number_of_cells() const { return m_core->state.arrays.number_of_cells(); }
  /// the number of facets: two for each cell.
  size_type number_of_facets() const { return 2 * number_of_cells(); }
  /// the number of edges: as many as vertices and cells.
  size_type number_of_edges() const
  {
    return number_of_cells() > 0 ? number_of_vertices() + number_of_cells() : 0;
  }

  /// the point with this id, as it was given last.
  /// \throws Unknown_id_error_2 if no point has this id.
  Point point(size_type id) const
  {
    check_id(id);
    if (!ids().is_representative(Point_id(id)))
      return ids().covered_point(Point_id(id));
    return m_core->state.point(ids().vertex(Point_id(id)));
  }

  /// the id of the representative of this point: of all points that coincide with it, the one that
  /// was there first.
  /// \throws Unknown_id_error_2 if no point has this id.
  size_type representative(size_type id) const
  {
    check_id(id);
    return size_type(ids().representative(ids().vertex(Point_id(id))));
  }

  /// the vector from point i to the image of point j by `shift`, rounded.
  /// \throws Unknown_id_error_2 if no point has one of these ids.
  Vector vector(size_type i, size_type j, const Periodic_shift_3& shift) const
  {
    const Point p = point(i), q = point(j);
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
    const auto& arrays = m_core->state.arrays;
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
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
    for (Vertex_index v(1); v <= m_core->state.number_of_vertices() && number_of_cells() > 0; ++v) {
      const Site site{v, {}};
      for (const Site& neighbor : star.neighbors(m_core->state, v))
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
    check_id(id);
    if (number_of_cells() == 0)
      return;
    const Site site{ids().vertex(Point_id(id)), {}};
    Star star;
    for (const Site& neighbor : star.neighbors(m_core->state, site.vertex))
      f(id_of(neighbor), shift_between(site, neighbor));
  }

  /// @}

private:
  // Must not move in memory: its parts refer to each other.
  struct Core
  {
    explicit Core(const Periodic_cell_3& cell)
      : state(cell)
    {
    }
    explicit Core(const State& other)
      : state(other)
    {
    }

    State state;
    Update kernel{state};
  };

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
            if (i != j && sites[i].vertex == v)
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

  static std::unique_ptr<Core> make_core(const Periodic_cell_3& cell)
  {
    const Floating_point floating_point;
    return std::make_unique<Core>(cell);
  }

  const typename State::Ids& ids() const { return m_core->state.ids; }
  void check_id(size_type id) const
  {
    if (!has_id(id))
      throw Unknown_id_error_2(id, number_of_ids());
  }
  size_type id_of(const Site& site) const { return size_type(ids().representative(site.vertex)); }

  // The shift of the second site's point where that of the first one is not shifted.
  Periodic_shift_3 shift_between(const Site& from, const Site& to) const
  {
    const auto& positions = m_core->state.positions;
    const Multiples first = positions.multiples(from.vertex) + from.shift.multiples();
    const Multiples second = positions.multiples(to.vertex) + to.shift.multiples();
    return m_core->state.torus.in_vectors_of_cell(second - first);
  }

  std::unique_ptr<Core> m_core;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_3_H
