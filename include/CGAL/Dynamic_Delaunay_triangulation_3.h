// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_options_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_update_visitor_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_frame_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_triangulation_settings_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_reader_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_writer_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Open_space_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Simplex_changes_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Update_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>
#include <CGAL/iterator.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iostream>
#include <istream>
#include <iterator>
#include <memory>
#include <ostream>
#include <string_view>
#include <type_traits>
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

  // What happens to a population, as `Dynamic_Delaunay_triangulation_3::update_population()` and
  // `insert_into_population()` do it.
  template <class Dynamic, class... Frame>
  static auto update_population(Dynamic& dt, Frame&&... frame)
  {
    return dt.update_population(std::forward<Frame>(frame)...);
  }
  template <class Dynamic, class... Newcomers>
  static auto insert_into_population(Dynamic& dt, Newcomers&&... newcomers)
  {
    return dt.insert_into_population(std::forward<Newcomers>(newcomers)...);
  }
  template <class Dynamic, class... Appendix>
  static void write_checkpoint(const Dynamic& dt, std::ostream& out, const Appendix&... appendix)
  {
    dt.write_file(out, appendix...);
  }
  template <class Dynamic, class... Appendix>
  static void read_checkpoint(Dynamic& dt, std::istream& in, const Appendix&... appendix)
  {
    dt.read_file(in, appendix...);
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
coincide share a vertex as long as they do; their representative is the one that was there first,
and of those that are inserted together the one with the smallest id.

After every call the triangulation is <em>certified</em>: exact predicates have proved that its
cells are positively oriented, that they cover the convex hull once, and that each facet is locally
Delaunay. So it is a Delaunay triangulation of the points. Fewer than four points, and points in a
plane or on a line, have no cells; edges and facets are then those of a Delaunay triangulation in
their plane.

The method is \ref DynamicDelaunaySection_Space "hold, flip and release in space". Cost of an
update: one pass over the cells in floating point, and what its repair takes, never much more than
to triangulate all points anew. Memory: some 280 bytes a point, from the first frame on 330.

\tparam Traits a CGAL kernel with exact predicates, such as
  `Exact_predicates_inexact_constructions_kernel`; where its coordinates are not doubles, floating
  point proves nothing for coordinates that are rounded, and exact predicates do everything.
\tparam Options any of these, in any order:
  - `With_concurrency_2<ConcurrencyTag>`: `Sequential_tag`, the default, or `Parallel_tag`, which
    needs TBB: threads then share the passes over all points and cells. Results do not depend on it.
  - `With_visitor_2<Visitor>`: is told which edges and facets come and go, such as
    `Edge_changes_visitor_3`: has the functions of `Delaunay_update_visitor_base_3`, the default,
    which costs nothing.
  - `With_policy_2<UpdatePolicy>`, a model of `DelaunayUpdatePolicy_2`: says which frames are
rebuilt at once, such as those in which a program knows that all is new. By default
    `Always_dynamic_policy_2`.
*/
template <class Traits, class... Options>
class Dynamic_Delaunay_triangulation_3
{
  static_assert(Dynamic_Delaunay_triangulations_3::internal::Options_check_3<Options...>::is_right);
  template <template <class> class Kind, class Usual>
  using Option =
      typename Dynamic_Delaunay_triangulations_2::internal::Option_2<Kind, Usual, Options...>::type;
  using ConcurrencyTag = Option<With_concurrency_2, Sequential_tag>;
  using Visitor = Option<With_visitor_2, Delaunay_update_visitor_base_3>;
  using Policy = Option<With_policy_2, Always_dynamic_policy_2>;

  friend Dynamic_Delaunay_triangulations_3::internal::Access_3;
  using Space = Dynamic_Delaunay_triangulations_3::internal::Open_space_3<Traits, ConcurrencyTag>;
  using State = typename Space::State;
  using Update = Dynamic_Delaunay_triangulations_3::internal::Update_3<Space>;
  using Chosen_rebuilds = typename Update::Chosen_rebuilds;
  using Input = Dynamic_Delaunay_triangulations_3::internal::Input_3<State>;
  using Change = Dynamic_Delaunay_triangulations_3::internal::Change_3<typename Traits::Point_3>;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using Identity_map = boost::typed_identity_property_map<typename Traits::Point_3>;
  using Index = Dynamic_Delaunay_triangulations_3::Index;
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
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// whether work is shared among threads.
  using Concurrency_tag = ConcurrencyTag;
  /// the policy and the visitor, in one object. A policy converts to it.
  using Settings = Dynamic_triangulation_settings_3<Policy, Visitor>;

  /// @}
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
    : m_core(std::make_unique<Core>(traits, settings))
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
    insert(first, beyond);
  }

  /// triangulates the points of a range with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  explicit Dynamic_Delaunay_triangulation_3(const Range& range,
                                            const Settings& settings = Settings(),
                                            const Traits& traits = Traits())
    : Dynamic_Delaunay_triangulation_3(std::begin(range), std::end(range), settings, traits)
  {
  }

  /// copies everything. From then on the same calls have the same results for both. Cost: linear.
  Dynamic_Delaunay_triangulation_3(const Dynamic_Delaunay_triangulation_3& other)
    : m_core(std::make_unique<Core>(other.m_core->state.traits, other.settings()))
  {
    m_core->state = other.m_core->state;
    m_core->changes = other.m_core->changes;
    m_core->kernel.take_over(other.m_core->kernel);
  }
  /// takes everything from the other triangulation, and leaves it empty, with copies of its policy
  /// and its visitor.
  Dynamic_Delaunay_triangulation_3(Dynamic_Delaunay_triangulation_3&& other)
    : m_core(std::make_unique<Core>(other.m_core->state.traits, other.settings()))
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
  /// Nothing changes if it throws one of these, or if the range or the policy throws. If memory
  /// runs out later, the points have their new positions and there are no cells until the next
  /// call. \throws Point_count_error_2 if the number of positions is not `number_of_ids()`. \throws
  /// Non_finite_coordinate_error_3 if a coordinate is NaN or infinite. \throws
  /// Coordinate_range_error_3 if a coordinate is too large for this program. \post `is_certified()`
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`; by
  ///   default the values are points.
  template <class InputIterator, class PointMap = Identity_map, class = If_map<PointMap>>
  Update_report_3 update(InputIterator first, InputIterator beyond,
                         const PointMap& point_map = PointMap())
  {
    const Floating_point floating_point;
    Input::stage(first, beyond, point_map, m_core->state, m_core->kernel.staged());
    Change change;
    change.is_frame = true;
    return run(change);
  }

  /// takes the positions from a range with `begin()` and `end()`.
  template <class Range, class PointMap = Identity_map, class = If_range<Range>,
            class = If_map<PointMap>>
  Update_report_3 update(const Range& range, const PointMap& point_map = PointMap())
  {
    return update(std::begin(range), std::end(range), point_map);
  }

  /// moves some points, and repairs what that breaks; all others stay. Cost of each: proportional
  /// to the number of its neighbors if it stays between them, elsewhere that of a removal and an
  /// insertion; but never much more than to triangulate all points anew.
  ///
  /// Nothing changes if it throws one of these, or if the range throws.
  /// \tparam IdMap, PointMap models of `ReadablePropertyMap` from the range's values to ids, any
  ///   integers, and to `Point`; by default the values are pairs of both.
  /// \throws Unknown_id_error_2 if no point has one of the ids.
  /// \throws Repeated_id_error_2 if an id is there more than once.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_3 if a coordinate is too large for this program.
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
    return run(change);
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
    return insert(first, beyond, Identity_map(), ids);
  }

  /// reads the points from the values of the range by `point_map`.
  template <class InputIterator, class PointMap, class OutputIterator>
  Update_report_3 insert(InputIterator first, InputIterator beyond, const PointMap& point_map,
                         OutputIterator ids)
  {
    const Floating_point floating_point;
    Change change;
    Input::read_newcomers(first, beyond, point_map, m_core->state, change);
    const Update_report_3 report = run(change);
    for (const Point_id id : change.coming)
      *ids++ = size_type(id);
    return report;
  }

  /// inserts the points of a range with `begin()` and `end()`.
  template <class Range, class OutputIterator = Emptyset_iterator, class = If_range<Range>>
  Update_report_3 insert(const Range& range, OutputIterator ids = OutputIterator())
  {
    return insert(std::begin(range), std::end(range), Identity_map(), ids);
  }

  /// reads the points by `point_map` from the values of a range with `begin()` and `end()`.
  template <class Range, class PointMap, class OutputIterator, class = If_range<Range>>
  Update_report_3 insert(const Range& range, const PointMap& point_map, OutputIterator ids)
  {
    return insert(std::begin(range), std::end(range), point_map, ids);
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
    return run(change);
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

  /// proves the triangulation again: one pass in floating point with proved bounds looks at all
  /// cells, and exact predicates at what it leaves. If that fails, which only damaged memory could
  /// cause, the triangulation is not certified, and the next call rebuilds it. Cost: that of the
  /// pass, some 0.1 to 0.2 microseconds a point; without cells, linear.
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

  /// tests everything again by exact predicates, with what floating point had proved: whether the
  /// cells fit together, each vertex has one, all are positive, cover space once, and are locally
  /// Delaunay; without cells, whether the points are coplanar. Cost: microseconds a point.
  /// \param verbose whether to print to `std::cerr` what is wrong.
  bool is_valid(bool verbose = false) const
  {
    const Floating_point floating_point;
    const char* const problem = m_core->kernel.problem();
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
  int dimension() const { return m_core->state.dimension(); }

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
  /// \name Policy and Visitor
  /// @{

  /// the update policy, a copy of the one in the settings.
  const Policy& policy() const { return m_core->policy; }
  /// the visitor.
  const Visitor& visitor() const { return m_core->visitor; }
  /// the visitor, in order to read and clear what it has recorded.
  Visitor& visitor() { return m_core->visitor; }

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
  /// Cost: it allocates two bytes for each cell, so it is linear; for many points use
  /// `Delaunay_neighbor_lists_3`. \throws Unknown_id_error_2 if no point has this id.
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

  /// \name Checkpoints
  /// Writes and reads the triangulation as a file, \ref DynamicDelaunayTriangulation2Checkpoints. A
  /// run continues from a checkpoint as if it had not been interrupted: equal calls have equal
  /// results. Coordinates have to be doubles, or fractions of integers as those of
  /// `Exact_predicates_exact_constructions_kernel`. Other types do not compile.
  /// @{

  /// writes the points with their ids, and the cells. Cost: linear, some 250 bytes a point.
  /// \throws Checkpoint_error_2 if the stream fails, after which the written part is unusable;
  /// also, before anything is written, if the triangulation is not certified, because memory did
  /// not suffice for the last call.
  void write_checkpoint(std::ostream& out) const
  {
    write_file(out, checkpoint_subject, [](auto&) {});
  }

  /// replaces everything but the policy and the visitor by what a file has.
  ///
  /// The file is validated: each number and id has to occur exactly once, cells have to fit
  /// together, and exact predicates have to prove that they are a Delaunay triangulation of the
  /// points. Reads exactly what was written, and leaves the rest of the stream unread. Cost: that
  /// of sorting the facets; memory in proportion to what is read, in addition to what this
  /// triangulation uses.
  /// \throws Checkpoint_error_2 if the file is refused. Whatever is thrown, nothing changes, unless
  /// the visitor throws it while it is told what has changed.
  /// \post `is_certified()`
  void read_checkpoint(std::istream& in)
  {
    read_file(
        in, checkpoint_subject, [](auto&, const auto&) {}, [] {});
  }

  /// writes a checkpoint, whatever mode CGAL's `set_mode()` has given to the stream. Where
  /// `write_checkpoint()` would throw `Checkpoint_error_2`, the stream fails (`failbit`).
  friend std::ostream& operator<<(std::ostream& out, const Dynamic_Delaunay_triangulation_3& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::write_to_stream(out, dt);
  }

  /// skips white space, then reads a checkpoint. Where `read_checkpoint()` would throw
  /// `Checkpoint_error_2`, the stream fails (`failbit`), and the triangulation does not change.
  friend std::istream& operator>>(std::istream& in, Dynamic_Delaunay_triangulation_3& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::read_from_stream(in, dt);
  }

  /// @}

private:
  static constexpr std::string_view checkpoint_subject = "Dynamic_Delaunay_triangulation_3";

  // Changes are recorded for those who want to know.
  static constexpr bool is_watched = !std::is_same_v<Visitor, Delaunay_update_visitor_base_3>;
  using Changes = Dynamic_Delaunay_triangulations_3::internal::Simplex_changes_3<State>;
  struct Nothing
  {
  };

  // Must not move in memory: its parts refer to each other.
  struct Core
  {
    Core(const Traits& traits, const Settings& settings)
      : state(traits)
      , policy(settings.policy)
      , visitor(settings.visitor)
    {
    }

    State state;
    Update kernel{state};
    Policy policy;
    Visitor visitor;
    std::conditional_t<is_watched, Changes, Nothing> changes;
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

  Settings settings() const { return Settings(m_core->policy, m_core->visitor); }

  Update_report_3 run(const Change& change)
  {
    start_visit();
    return run_and_tell(change);
  }
  Update_report_3 run_and_tell(const Change& change)
  {
    const Update_report_3 report = m_core->kernel.run(change, Chosen_rebuilds(m_core->policy));
    finish_visit(report);
    if (change.is_frame)
      m_core->policy.after_update(m_core->kernel.frame(), report);
    return report;
  }

  // To be called before any change.
  void start_visit()
  {
    if constexpr (is_watched) {
      m_core->changes.begin(m_core->state);
      m_core->visitor.before_update(*this);
    }
  }
  // Compares, then tells the visitor.
  void finish_visit([[maybe_unused]] const Update_report_3& report)
  {
    if constexpr (is_watched) {
      m_core->changes.end(m_core->state);
      tell(report);
    }
  }
  void tell(const Update_report_3& report)
  {
    Visitor& visitor = m_core->visitor;
    const auto &removed = m_core->changes.removed(), &created = m_core->changes.created();
    for (const auto& facet : removed.facets)
      visitor.after_facet_removal(*this, facet);
    for (const auto& edge : removed.edges)
      visitor.after_edge_removal(*this, edge[0], edge[1]);
    for (const auto& edge : created.edges)
      visitor.after_edge_creation(*this, edge[0], edge[1]);
    for (const auto& facet : created.facets)
      visitor.after_facet_creation(*this, facet);
    visitor.after_update(*this, report);
  }

  // A frame of a population: removes the points `gone`, moves the others to the positions by their
  // ids, and inserts points. All positions are checked. The ids of new points are written to
  // `coming_ids`, ascending, unless an exception ends this before all removals are done.
  Update_report_3 update_population(const std::vector<Point>& positions,
                                    const std::vector<size_type>& gone,
                                    const std::vector<Point>& coming,
                                    std::vector<size_type>& coming_ids)
  {
    Change change;
    change.is_frame = true;
    change.positions = &positions;
    for (const size_type id : gone)
      change.gone.emplace_back(id);
    return change_population(change, coming, coming_ids);
  }

  // Only inserts points.
  Update_report_3 insert_into_population(const std::vector<Point>& coming,
                                         std::vector<size_type>& coming_ids)
  {
    Change change;
    return change_population(change, coming, coming_ids);
  }

  Update_report_3 change_population(Change& change, const std::vector<Point>& coming,
                                    std::vector<size_type>& coming_ids)
  {
    const Floating_point floating_point;
    Input::check_number(number_of_points() - change.gone.size() + coming.size());
    change.coming = ids().next_ids(coming.size(), change.gone);
    change.coming_points = coming;
    std::vector<size_type> next_ids(change.coming.begin(), change.coming.end());
    start_visit();
    m_core->kernel.reserve(change);
    coming_ids.swap(next_ids); // from here on, points that go do so before anything is thrown
    return run_and_tell(change);
  }

  // Writes a checkpoint of this kind. `append` writes additional lines of the file.
  template <class Append>
  void write_file(std::ostream& out, std::string_view subject, const Append& append) const
  {
    const Floating_point floating_point;
    if (!is_certified())
      throw Checkpoint_error_2(0,
                               "the last call has left no cells, because memory did not suffice: "
                               "write after mend()");
    Dynamic_Delaunay_triangulations_2::internal::Checkpoint_output_2 file(out, subject);
    Dynamic_Delaunay_triangulations_3::internal::Checkpoint_writer_3(m_core->state, file).write();
    append(file);
    file.finish();
  }

  // Reads such a checkpoint. `read_more` reads the lines that `append` wrote. When the whole file
  // was accepted, `exchange_more` takes over what was read; it must not throw.
  template <class ReadAppendix, class Exchange>
  void read_file(std::istream& in, std::string_view subject, const ReadAppendix& read_more,
                 const Exchange& exchange_more)
  {
    const Floating_point floating_point;
    Dynamic_Delaunay_triangulations_2::internal::Checkpoint_input_2 file(in, subject);
    auto core = std::make_unique<Core>(m_core->state.traits, settings());
    Dynamic_Delaunay_triangulations_3::internal::Checkpoint_reader_3(core->state, file).read();
    read_more(file, core->state.ids);
    file.finish();
    if constexpr (is_watched) {
      core->visitor.before_update(*this);
      core->changes.compare(m_core->state, m_core->changes, core->state);
    }
    m_core.swap(core);
    exchange_more();
    if constexpr (is_watched) {
      Update_report_3 report;
      report.certified = true;
      tell(report);
    }
  }

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
