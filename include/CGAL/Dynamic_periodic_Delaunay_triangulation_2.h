// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Default.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/inform_classifier.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_reader_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_writer_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_change_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_update_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Usual_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_settings_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_update_visitor_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <iterator>
#include <memory>
#include <ostream>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

The Delaunay triangulation of points that move in a periodic space: a plane in which everything is
repeated by the vectors of a `Periodic_cell_2`, that is, a flat torus. The cell may be any
parallelogram, and may change with every frame.

The triangulation is of the points as they are given, anywhere in the plane, wrapped into the cell
or not: of the real numbers p + i a + j b for all points p and integers i and j, never of rounded
images. It is one sheet: n points in different places have 3n edges and 2n faces, however few they
are. So a point can be a neighbor of its own images, and two points can have several edges.

In a slab, which is periodic in one direction and open in the other, the faces fill the strip
between the outermost points. There are fewer of them, and none if all points are on one line along
it.

Points have ids as in `Dynamic_Delaunay_triangulation_2`: the i-th point of the range has id i, and
points that are inserted get the smallest free ids. Points that coincide, also by a translation of
the lattice, share a vertex.

After construction, and after every call with an exact classifier, the triangulation is
<em>certified</em>: exact predicates have proved that each face is counterclockwise, and that each
edge is locally Delaunay. Flips, insertions and removals keep it a triangulation of the torus that
covers it once (see the manual). By default all edges are tested but those that are proved safe, the
broken ones are flipped, points that jump are inserted anew, and where that does not help everything
is triangulated anew. After a frame with a heuristic classifier it is not certified, unless the
repair had to examine everything. It is then still a torus of 3n edges and 2n faces, and the next
call that inserts, removes or moves single points makes it Delaunay first.

Classifiers, repairs and policies are the same as in the plane; `Dynamic_frame_2` and
`Dynamic_mender_2` say what differs for them.

\tparam Kernel a CGAL kernel whose points have coordinates of type `double`, such as
  `Exact_predicates_inexact_constructions_kernel`.
\tparam Classifier a model of `DelaunayClassifier_2`; `Default` for `Circumcircle_classifier_2`.
\tparam Repair a model of `DelaunayRepair_2`; `Default` as in `Dynamic_Delaunay_triangulation_2`.
\tparam UpdatePolicy a model of `DelaunayUpdatePolicy_2`; `Default` for `Always_dynamic_policy_2`.
\tparam Visitor a model of `PeriodicUpdateVisitor_2`, which is told of all changes of edges;
  `Default` for `Periodic_update_visitor_base_2`, which ignores them.
\tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`, as for a triangulation of the
  plane.
*/
template <class Kernel, class Classifier = Circumcircle_classifier_2, class Repair = Default,
          class UpdatePolicy = Always_dynamic_policy_2,
          class Visitor = Periodic_update_visitor_base_2, class ConcurrencyTag = Sequential_tag>
class Dynamic_periodic_Delaunay_triangulation_2
{
  static_assert(
      Dynamic_Delaunay_triangulations_2::internal::has_double_coordinates<typename Kernel::Point_2>,
      "the coordinates of points in periodic space must be of type double");

  using State = Dynamic_Delaunay_triangulations_2::internal::Periodic_triangulation_state_2<
      typename Kernel::Point_2, ConcurrencyTag>;
  using Chosen_classifier = typename Default::Get<Classifier, Circumcircle_classifier_2>::type;
  using Chosen_visitor = typename Default::Get<Visitor, Periodic_update_visitor_base_2>::type;
  using Default_repair =
      typename Dynamic_Delaunay_triangulations_2::internal::Usual_repair_2<Chosen_classifier>::type;
  using Policy = typename Default::Get<UpdatePolicy, Always_dynamic_policy_2>::type;
  static constexpr bool has_visitor =
      !std::is_same_v<Chosen_visitor, Periodic_update_visitor_base_2>;
  using Editor = Dynamic_Delaunay_triangulations_2::internal::Periodic_editor_2<State, has_visitor>;
  using Update = Dynamic_Delaunay_triangulations_2::internal::Periodic_update_2<State, Editor>;
  using Change = Dynamic_Delaunay_triangulations_2::internal::Change_2<typename Kernel::Point_2>;
  using Change_of_edges = Dynamic_Delaunay_triangulations_2::internal::Periodic_change_2;
  using Population_input = Dynamic_Delaunay_triangulations_2::internal::Population_input_2<State>;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2;
  using Arrays = Dynamic_Delaunay_triangulations_2::internal::Halfedge_arrays_2;
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;
  template <class Range>
  using If_range = Dynamic_Delaunay_triangulations_2::internal::If_range<Range>;

public:
  /// \name Types
  /// @{

  /// the kernel.
  using Geom_traits = Kernel;
  /// a point.
  using Point = typename Kernel::Point_2;
  /// a vector.
  using Vector = typename Kernel::Vector_2;
  /// the type of ids and counts.
  using size_type = std::size_t;
  /// the classifier.
  using Delaunay_classifier = Chosen_classifier;
  /// the repair.
  using Delaunay_repair = typename Default::Get<Repair, Default_repair>::type;
  /// the update policy.
  using Delaunay_update_policy = Policy;
  /// the visitor.
  using Periodic_update_visitor = Chosen_visitor;
  /// classifier, repair, engines, policy and visitor, as one object. Of the engines only that for
  /// whole triangulations is used; if it is not `GUIBAS_STOLFI`, points are inserted one by one.
  using Settings =
      Dynamic_triangulation_settings_2<Chosen_classifier, Delaunay_repair, Policy, Chosen_visitor>;
  /// whether work is shared among threads.
  using Concurrency_tag = ConcurrencyTag;
  /// the read-only view that classifiers get.
  using Frame = Dynamic_frame_2<State>;

  /// @}
  /// \name Creation
  /// @{

  /// creates an empty triangulation of the torus with this cell.
  /// \throws Periodic_cell_error_2 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it.
  explicit Dynamic_periodic_Delaunay_triangulation_2(const Periodic_cell_2& cell,
                                                     const Settings& settings = Settings())
    : m_classifier(settings.classifier)
    , m_repair(settings.repair)
    , m_policy(settings.policy)
    , m_visitor(settings.visitor)
  {
    check(cell);
    m_core = std::make_unique<Core>(cell);
    m_core->update.set_engines(settings.engines);
  }

  /// the same, but with a classifier.
  Dynamic_periodic_Delaunay_triangulation_2(const Periodic_cell_2& cell,
                                            const Delaunay_classifier& classifier)
    : Dynamic_periodic_Delaunay_triangulation_2(cell, Settings{classifier})
  {
  }

  /// triangulates the points of the range; the i-th one has id i. Cost: O(n log n).
  /// \tparam InputIterator its values are convertible to `Point`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_2 if a point is 2<sup>20</sup> cells or more from the origin.
  /// \throws Point_limit_error_2 if there are more points than 32 bits allow.
  /// \throws Periodic_cell_error_2 as above.
  template <class InputIterator>
  Dynamic_periodic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                            const Periodic_cell_2& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_2(cell, settings)
  {
    insert(first, beyond, Emptyset_iterator());
  }

  /// the same, but with a classifier.
  template <class InputIterator>
  Dynamic_periodic_Delaunay_triangulation_2(InputIterator first, InputIterator beyond,
                                            const Periodic_cell_2& cell,
                                            const Delaunay_classifier& classifier)
    : Dynamic_periodic_Delaunay_triangulation_2(first, beyond, cell, Settings{classifier})
  {
  }

  /// the same, but takes the range as a whole: anything with `begin()` and `end()`.
  template <class Range, class = If_range<Range>>
  Dynamic_periodic_Delaunay_triangulation_2(const Range& points, const Periodic_cell_2& cell,
                                            const Settings& settings = Settings())
    : Dynamic_periodic_Delaunay_triangulation_2(std::begin(points), std::end(points), cell,
                                                settings)
  {
  }

  /// the same, but with a classifier.
  template <class Range, class = If_range<Range>>
  Dynamic_periodic_Delaunay_triangulation_2(const Range& points, const Periodic_cell_2& cell,
                                            const Delaunay_classifier& classifier)
    : Dynamic_periodic_Delaunay_triangulation_2(points, cell, Settings{classifier})
  {
  }

  /// copies everything. Cost: linear.
  Dynamic_periodic_Delaunay_triangulation_2(const Dynamic_periodic_Delaunay_triangulation_2& other)
    : m_classifier(other.m_classifier)
    , m_repair(other.m_repair)
    , m_policy(other.m_policy)
    , m_visitor(other.m_visitor)
    , m_core(std::make_unique<Core>(other.m_core->state))
  {
    m_core->update.copy_state(other.m_core->update);
  }
  /// takes everything from the other triangulation. That one is then empty, with the same cell.
  Dynamic_periodic_Delaunay_triangulation_2(Dynamic_periodic_Delaunay_triangulation_2&& other)
    : Dynamic_periodic_Delaunay_triangulation_2(
          other.cell(), Settings{other.m_classifier, other.m_repair, other.m_core->update.engines(),
                                 other.m_policy, other.m_visitor})
  {
    swap(other);
  }
  /// replaces everything. If it throws, nothing has changed.
  Dynamic_periodic_Delaunay_triangulation_2&
  operator=(Dynamic_periodic_Delaunay_triangulation_2 other)
  {
    swap(other);
    return *this;
  }
  /// exchanges everything with the other triangulation.
  void swap(Dynamic_periodic_Delaunay_triangulation_2& other)
  {
    using std::swap;
    swap(m_classifier, other.m_classifier);
    swap(m_repair, other.m_repair);
    swap(m_policy, other.m_policy);
    swap(m_visitor, other.m_visitor);
    swap(m_core, other.m_core);
  }
  /// calls `a.swap(b)`.
  friend void swap(Dynamic_periodic_Delaunay_triangulation_2& a,
                   Dynamic_periodic_Delaunay_triangulation_2& b)
  {
    a.swap(b);
  }

  /// @}
  /// \name Motion
  /// @{

  /// moves point i to the i-th position of the range, for all points, and repairs the
  /// triangulation. The range has one position for each id; positions for ids of removed points are
  /// ignored. Of a point that moves by more than half the cell, as where it is wrapped, the nearest
  /// image is taken to be where it has gone.
  ///
  /// Cost: one pass over all points and edges, of which most are skipped where all is calm, and the
  /// repair of what is broken. Where many points jump, a sample of the edges decides whether
  /// triangulating everything anew is cheaper.
  /// \throws Point_count_error_2 if the number of positions is not `number_of_ids()`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Periodic_range_error_2 if a point is 2<sup>20</sup> cells or more from the origin.
  ///
  /// If it throws one of these, or if the range throws, or the policy or the classifier when it is
  /// asked, nothing has changed. If the repair throws, the points have moved, and the next call
  /// triangulates everything anew.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond)
  {
    return update(first, beyond, Periodic_cell_2(cell()));
  }

  /// the same, in a cell that has changed since the last call: by deformation, by other vectors for
  /// the same lattice, as where a sheared cell is flipped, or by both.
  /// \throws Periodic_cell_error_2 if the cell is so thin or extreme that doubles cannot tell how
  /// far points are apart in it, or if it is a slab and the cell so far was none, or the reverse;
  /// nothing has changed.
  template <class InputIterator>
  Update_report_2 update(InputIterator first, InputIterator beyond, const Periodic_cell_2& cell)
  {
    const Floating_point floating_point;
    check_next(cell);
    if (!is_certified() && (Chosen_classifier::is_exact || !m_core->update.is_whole()))
      mend();
    if constexpr (Dynamic_Delaunay_triangulations_2::internal::is_in_memory<InputIterator>) {
      if (size_type(beyond - first) != number_of_ids())
        throw Point_count_error_2(number_of_ids(), size_type(beyond - first));
      return update_to(Points_in_memory<InputIterator>{first}, cell);
    } else {
      m_next.clear();
      for (; first != beyond; ++first) {
        auto&& value = *first;
        const Point& p = value;
        m_next.push_back({p.x(), p.y()});
        if (m_next.size() > number_of_ids())
          break;
      }
      if (m_next.size() != number_of_ids())
        throw Point_count_error_2(number_of_ids(), m_next.size());
      return update_to(Read_positions{m_next}, cell);
    }
  }

  /// the same, but takes the range as a whole.
  template <class Range, class = If_range<Range>>
  Update_report_2 update(const Range& points)
  {
    return update(std::begin(points), std::end(points));
  }

  /// the same, but takes the range as a whole.
  template <class Range, class = If_range<Range>>
  Update_report_2 update(const Range& points, const Periodic_cell_2& cell)
  {
    return update(std::begin(points), std::end(points), cell);
  }

  /// moves one point. All others stay where they are. Cost: proportional to what that breaks, and
  /// to the walk to where the point jumps, if it does. \throws Unknown_id_error_2,
  /// Non_finite_coordinate_error_2 or Periodic_range_error_2; nothing has changed then.
  Update_report_2 move(size_type id, const Point& p)
  {
    const std::pair<size_type, Point> mover(id, p);
    return move(&mover, &mover + 1);
  }

  /// moves some points, one after the other. \tparam InputIterator its values are pairs of an id
  /// and a `Point`. \throws Repeated_id_error_2 if an id is given more than once, or the above.
  template <class InputIterator>
  Update_report_2 move(InputIterator first, InputIterator beyond)
  {
    using Mover = typename std::iterator_traits<InputIterator>::value_type;
    const Floating_point floating_point;
    Change change;
    Population_input::read_movers(first, beyond, First_of_pair_property_map<Mover>(),
                                  Second_of_pair_property_map<Mover>(), m_core->state, change);
    const std::vector<Position> positions = checked(change.moved_points, change.moved, cell());
    return run([&](Update_report_2& report) {
      for (std::size_t i = 0; i < positions.size(); ++i)
        m_core->update.move(change.moved[i], positions[i], report);
    });
  }

  /// @}
  /// \name Population
  /// @{

  /// adds a point, and returns its id: the smallest free one. If it coincides with another point,
  /// it shares that one's vertex. \throws Non_finite_coordinate_error_2, Periodic_range_error_2, or
  /// Point_limit_error_2 if there would be too many points; nothing has changed then.
  size_type insert(const Point& p)
  {
    size_type id = 0;
    insert(&p, &p + 1, &id);
    return id;
  }

  /// adds the points of the range, along a Hilbert curve. Their ids are written to `ids` first.
  template <class InputIterator, class OutputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond, OutputIterator ids)
  {
    const Floating_point floating_point;
    Change change;
    Population_input::read_newcomers(first, beyond, Identity_property_map<Point>(), m_core->state,
                                     change);
    const std::vector<Position> positions = checked(change.coming_points, change.coming, cell());
    for (const Index id : change.coming)
      *ids++ = id;
    return run(
        [&](Update_report_2& report) { m_core->update.insert(change.coming, positions, report); });
  }

  /// removes a point; its id is free from then on.
  /// \throws Unknown_id_error_2 if no point has this id; nothing has changed then.
  Update_report_2 remove(size_type id) { return remove(&id, &id + 1); }

  /// removes the points with these ids.
  /// \throws Unknown_id_error_2 if an id belongs to no point; nothing has changed then.
  /// \throws Repeated_id_error_2 if an id is given more than once; nothing has changed then.
  template <class InputIterator>
  Update_report_2 remove(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    std::vector<Index> gone;
    Population_input::read_ids(first, beyond, m_core->state, gone);
    return run([&](Update_report_2& report) {
      for (const Index id : gone)
        m_core->update.remove(id, report);
    });
  }

  /// \cond
  // For `Dynamic_population_2`: a function of a point and its place in a frame, which throws if no
  // point can be there. The floating-point state is the default one as long as it lives.
  class Position_check
  {
  public:
    explicit Position_check(const Periodic_cell_2& cell)
      : m_torus(cell)
    {
    }
    void operator()(const Point& p, size_type place) const { checked_position(p, place, m_torus); }

  private:
    Floating_point m_floating_point;
    Dynamic_Delaunay_triangulations_2::internal::Torus_2 m_torus;
  };
  Position_check position_check() const { return Position_check(cell()); }
  Position_check position_check(const Periodic_cell_2& next) const
  {
    check_next(next);
    return Position_check(next);
  }

  // For `Dynamic_population_2`: a frame in which points are removed and inserted, too. The range
  // has a position for each id that is in use now. All but those of removed points have been
  // checked, as have the new points. Writes the ids of the new points.
  template <class InputIterator>
  Update_report_2 update_population(InputIterator first, InputIterator beyond,
                                    const std::vector<size_type>& gone,
                                    const std::vector<Point>& coming,
                                    std::vector<size_type>& coming_ids, const Periodic_cell_2& cell)
  {
    const Floating_point floating_point;
    Change change;
    Population_input::read_newcomers(coming.begin(), coming.end(), Identity_property_map<Point>(),
                                     m_core->state, change);
    change.gone.assign(gone.begin(), gone.end());
    change.coming = m_core->state.ids().next_ids(coming.size(), change.gone);
    const std::vector<Position> positions = checked(change.coming_points, change.coming, cell);
    m_next.clear();
    for (; first != beyond; ++first)
      m_next.push_back({first->x(), first->y()});
    std::vector<size_type> ids(change.coming.begin(), change.coming.end());
    return run_frame([&](Update_report_2& report) {
      for (const Index id : change.gone)
        m_core->update.remove(id, report);
      coming_ids.swap(ids);
      m_core->update.stage(Read_positions{m_next}, cell);
      m_core->update.update(Read_positions{m_next}, cell, m_classifier, m_repair, m_policy, report);
      m_core->update.insert(change.coming, positions, report);
    });
  }
  template <class InputIterator>
  Update_report_2
  update_population(InputIterator first, InputIterator beyond, const std::vector<size_type>& gone,
                    const std::vector<Point>& coming, std::vector<size_type>& coming_ids)
  {
    return update_population(first, beyond, gone, coming, coming_ids, Periodic_cell_2(cell()));
  }
  /// \endcond

  /// @}
  /// \name Access
  /// @{

  /// the cell of the last frame.
  const Periodic_cell_2& cell() const { return m_core->state.torus().cell(); }
  /// the number of points, coincident ones included.
  size_type number_of_points() const { return m_core->state.ids().number_of_points(); }
  /// the number of different places of points, up to translations of the lattice.
  size_type number_of_vertices() const { return m_core->state.number_of_vertices(); }
  /// three for each vertex; fewer in a slab, where counting them takes a pass.
  size_type number_of_edges() const
  {
    if (!cell().is_slab())
      return 3 * number_of_vertices();
    size_type edges = 0;
    for_each_edge([&](size_type, size_type, const Periodic_shift_2&) { ++edges; });
    return edges;
  }
  /// two for each vertex; fewer in a slab, where counting them takes a pass.
  size_type number_of_faces() const
  {
    if (!cell().is_slab())
      return 2 * number_of_vertices();
    size_type faces = 0;
    for (Index f = 0; f < m_core->state.arrays().number_of_faces(); ++f)
      faces += !is_in_gap(f);
    return faces;
  }
  /// one more than the largest id that was ever in use.
  size_type number_of_ids() const { return m_core->state.ids().number_of_ids(); }
  /// whether a point has this id.
  bool has_id(size_type id) const { return m_core->state.ids().is_taken(id); }

  /// the point with this id, as it was given last. \throws Unknown_id_error_2
  Point point(size_type id) const
  {
    check_id(id);
    const Position p = m_core->state.position_of_id(Index(id));
    return Point(p.x, p.y);
  }

  /// the id of the point that represents those that coincide with this one. \throws
  /// Unknown_id_error_2
  size_type representative(size_type id) const
  {
    check_id(id);
    const auto& ids = m_core->state.ids();
    return ids.representative(ids.vertex(Index(id)));
  }

  /// the vector from the first point to the image of the second one by `shift`, rounded.
  Vector vector(size_type i, size_type j, const Periodic_shift_2& shift) const
  {
    const Point p = point(i), q = point(j);
    return Vector(q.x() - p.x() + (shift[0] * cell().ax() + shift[1] * cell().bx()),
                  q.y() - p.y() + (shift[0] * cell().ay() + shift[1] * cell().by()));
  }

  /// calls `f(i, j, shift)` once for each edge: the image of point j by `shift`, at `point(j)` plus
  /// `shift[0]` times the cell's first vector plus `shift[1]` times its second one, is a neighbor
  /// of point i. Points that coincide with others have no edges but those of their representatives.
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    const auto& state = m_core->state;
    for (Index e = 0; e < state.arrays().number_of_edges(); ++e) {
      const Index h = state.arrays().halfedge(e);
      const Index from = Arrays::next(h), to = Arrays::previous(h);
      if (!are_across(from, to))
        f(id_at(from), id_at(to), shift_between(from, to));
    }
  }

  /// calls `f(i, j, shift)` once for each edge of the boundary of a slab, along which the points of
  /// the strip are on the left: on one side all outermost points in turn, and on the other. If all
  /// points are on one line, each edge is met from both sides. A torus has no boundary.
  template <class Function>
  void for_each_boundary_edge(const Function& f) const
  {
    const auto& arrays = m_core->state.arrays();
    for (Index h = 0; h < 3 * arrays.number_of_faces(); ++h) {
      const Index from = Arrays::previous(h), to = Arrays::next(h);
      if (is_in_gap(h / 3) && !are_across(from, to))
        f(id_at(from), id_at(to), shift_between(from, to));
    }
  }

  /// calls `f(j, shift)` for each edge of the point with this id, or of its representative,
  /// counterclockwise: for the neighbor j and its shift. An edge from a point to its own image is
  /// met at both of its ends. \throws Unknown_id_error_2
  template <class Function>
  void for_each_neighbor(size_type id, const Function& f) const
  {
    check_id(id);
    const auto& state = m_core->state;
    state.arrays().for_each_corner(state.ids().vertex(Index(id)), [&](Index h) {
      if (!are_across(h, Arrays::next(h)))
        f(id_at(Arrays::next(h)), shift_between(h, Arrays::next(h)));
    });
  }

  /// calls `f(ids, shifts)` once for each face, with arrays of three ids and three shifts: the
  /// images of these points are the corners of a counterclockwise triangle. The first shift is (0,
  /// 0).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    for (Index h = 0; h < 3 * m_core->state.arrays().number_of_faces(); h += 3)
      if (!is_in_gap(h / 3))
        f(std::array<size_type, 3>{id_at(h), id_at(h + 1), id_at(h + 2)},
          std::array<Periodic_shift_2, 3>{shift_between(h, h), shift_between(h, h + 1),
                                          shift_between(h, h + 2)});
  }

  /// @}
  /// \name Certainty
  /// @{

  /// whether the triangulation is proved Delaunay. With an exact classifier only an exception that
  /// is none of the documented ones can leave it unproved; the next change then triangulates
  /// everything anew.
  bool is_certified() const { return m_core->update.is_certified(); }

  /// does what is needed for `is_certified()`: examines all edges and repairs the broken ones, or
  /// nothing if it is certified.
  Update_report_2 mend()
  {
    const Floating_point floating_point;
    return run([this](Update_report_2& report) { m_core->update.certify_all(report); });
  }
  /// examines all edges exactly, unless it is certified, and returns whether it is Delaunay.
  /// Changes nothing else. Cost: one pass over all edges.
  bool certify()
  {
    const Floating_point floating_point;
    return m_core->update.certify();
  }

  /// tests whether it is what it says to be: a triangulation of the torus with all points, the
  /// areas of whose faces sum up, in exact arithmetic, to that of the cell; and if it is certified,
  /// one that is Delaunay by exact predicates. Meant for tests. Cost: linear, microseconds a point.
  bool is_valid() const
  {
    const Floating_point floating_point;
    return m_core->update.is_valid();
  }

  /// @}
  /// \name Checkpoints
  /// Writes and reads the triangulation as a file, \ref DynamicDelaunayTriangulation2Checkpoints. A
  /// run continues from a checkpoint as if it had not been interrupted.
  /// @{

  /// writes the cell, the triangulation and the ids of its points. Cost: linear, about 140 bytes a
  /// point. \throws Checkpoint_error_2 if the stream fails; what was written is then unusable. It
  /// is also thrown, before anything is written, if an exception ended the last change before each
  /// point had its vertex.
  void write_checkpoint(std::ostream& out) const
  {
    write_checkpoint(out, checkpoint_subject, [](auto&) {});
  }

  /// replaces everything but the settings, also the cell, which may become a slab or cease to be
  /// one. The file is validated: its faces must be a triangulated torus with all points, which
  /// covers the space once, each number and id must occur exactly once, and a triangulation that is
  /// marked as certified must be Delaunay by exact predicates. The classifier is told that
  /// everything is new. Reads exactly what was written, and
  /// leaves the rest of the stream unread. Cost: linear; memory in proportion to what is read.
  /// \throws Checkpoint_error_2 if the file is refused. Whatever is thrown, nothing changes, unless
  /// the visitor throws it while it is told what has changed.
  void read_checkpoint(std::istream& in)
  {
    read_checkpoint(
        in, checkpoint_subject, [](auto&, const auto&) {}, [] {});
  }

  /// writes a checkpoint. Where `write_checkpoint()` would throw `Checkpoint_error_2`, the stream
  /// fails (`failbit`).
  friend std::ostream& operator<<(std::ostream& out,
                                  const Dynamic_periodic_Delaunay_triangulation_2& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::write_to_stream(out, dt);
  }

  /// skips white space, then reads a checkpoint. Where `read_checkpoint()` would throw
  /// `Checkpoint_error_2`, the stream fails (`failbit`), and the triangulation does not change.
  friend std::istream& operator>>(std::istream& in, Dynamic_periodic_Delaunay_triangulation_2& dt)
  {
    return Dynamic_Delaunay_triangulations_2::internal::read_from_stream(in, dt);
  }

  /// \cond
  // The same, but `append` writes, and `read_more` reads, additional lines of the file; when
  // nothing can be refused any more, `exchange_more` takes what they say, and throws nothing.
  template <class Append>
  void write_checkpoint(std::ostream& out, std::string_view subject, const Append& append) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Floating_point floating_point;
    Checkpoint_writer_2<State>(m_core->state, is_certified(), m_core->update.memory())
        .write(out, subject, append);
  }

  template <class ReadAppendix, class Exchange>
  void read_checkpoint(std::istream& in, std::string_view subject, const ReadAppendix& read_more,
                       const Exchange& exchange_more)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Floating_point floating_point;
    Checkpoint_input_2 file(in, subject);
    Checkpoint_reader_2<State> reader(file);
    State state(cell());
    reader.read(state);
    read_more(file, state.ids());
    file.finish();
    Delaunay_classifier classifier = m_classifier;
    inform_classifier(classifier, Frame(state));
    if constexpr (has_visitor)
      m_visitor.before_update(std::as_const(*this));
    const Update_report_2 report =
        m_core->update.restore(state, reader.is_certified(), reader.memory());
    m_classifier = std::move(classifier); // nothing throws from here on
    exchange_more();
    if constexpr (has_visitor)
      tell_visitor(report);
  }
  /// \endcond

  /// @}
  /// \name Settings
  /// @{

  /// the classifier.
  const Delaunay_classifier& classifier() const { return m_classifier; }
  /// the repair.
  const Delaunay_repair& repair() const { return m_repair; }
  /// the update policy.
  const Policy& policy() const { return m_policy; }
  /// what the classifier gets: points, edges and faces as flat arrays.
  Frame frame() const { return Frame(m_core->state); }
  /// the Classified set of the last update, as vertices of `frame()`. Empty if vertices have got
  /// other numbers since, or if points came apart and all edges were examined for that.
  const std::vector<Index>& classified_vertices() const
  {
    return m_core->update.tools().classification().vertices();
  }
  /// the Padded set of the last update whose repair was `Border_splice_repair_2`.
  const std::vector<Index>& padded_vertices() const { return m_core->update.tools().padded(); }
  /// the Border set of that update.
  const std::vector<Index>& border_vertices() const { return m_core->update.tools().border(); }
  /// the visitor.
  const Chosen_visitor& visitor() const { return m_visitor; }
  /// the same, but in order to read and clear what it has recorded.
  Chosen_visitor& visitor() { return m_visitor; }

  /// @}

private:
  static constexpr std::string_view checkpoint_subject =
      "Dynamic_periodic_Delaunay_triangulation_2";

  struct Core
  {
    explicit Core(const Periodic_cell_2& cell)
      : state(cell)
      , update(state)
    {
    }
    explicit Core(const State& other)
      : state(other)
      , update(state)
    {
    }
    State state;
    Update update;
  };

  static void check(const Periodic_cell_2& cell)
  {
    const Floating_point floating_point;
    Dynamic_Delaunay_triangulations_2::internal::check_cell(cell);
  }

  void check_id(size_type id) const
  {
    if (!has_id(id))
      throw Unknown_id_error_2(id, number_of_ids());
  }

  // The same for the cell of the next frame.
  void check_next(const Periodic_cell_2& next) const
  {
    check(next);
    if (next.is_slab() != cell().is_slab())
      throw Periodic_cell_error_2(next.ax(), next.ay(), next.bx(), next.by(),
                                  next.is_slab() ? "a cell cannot become a slab"
                                                 : "a slab cannot become a cell with two vectors");
  }

  static std::vector<Position> checked(const std::vector<Point>& points,
                                       const std::vector<Index>& ids, const Periodic_cell_2& cell)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Torus_2 torus(cell);
    std::vector<Position> positions;
    for (std::size_t i = 0; i < points.size(); ++i)
      positions.push_back(checked_position(points[i], ids[i], torus));
    return positions;
  }

  // The positions of a frame, by ids.
  template <class Iterator>
  struct Points_in_memory
  {
    Position operator()(size_type id) const
    {
      const Point& p = first[std::ptrdiff_t(id)];
      return {p.x(), p.y()};
    }
    void prefetch(size_type id) const
    {
      Dynamic_Delaunay_triangulations_2::internal::prefetch(&first[std::ptrdiff_t(id)]);
    }
    Iterator first;
  };
  struct Read_positions
  {
    Position operator()(size_type id) const { return positions[id]; }
    void prefetch(size_type id) const
    {
      Dynamic_Delaunay_triangulations_2::internal::prefetch(&positions[id]);
    }
    const std::vector<Position>& positions;
  };

  template <class Next>
  Update_report_2 update_to(const Next& next, const Periodic_cell_2& cell)
  {
    if (!m_core->update.stage(next, cell))
      check_positions(next, cell); // throws
    return run_frame([&](Update_report_2& report) {
      m_core->update.update(next, cell, m_classifier, m_repair, m_policy, report);
    });
  }

  template <class Next>
  void check_positions(const Next& next, const Periodic_cell_2& cell) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Torus_2 torus(cell);
    for (size_type id = 0; id < number_of_ids(); ++id)
      if (has_id(id)) {
        const Position p = next(id);
        checked_position(Point(p.x, p.y), id, torus);
      }
  }

  template <class Function>
  Update_report_2 run_frame(const Function& change)
  {
    const Update_report_2 report = run(change);
    m_policy.after_update(frame(), report);
    return report;
  }

  template <class Function>
  Update_report_2 run(const Function& change)
  {
    if constexpr (has_visitor)
      m_visitor.before_update(std::as_const(*this));
    const Update_report_2 report = m_core->update.run(m_classifier, change);
    if constexpr (has_visitor)
      tell_visitor(report);
    return report;
  }

  void tell_visitor(const Update_report_2& report)
  {
    using Kind = Change_of_edges::Kind;
    m_told.clear();
    m_told.swap(m_core->update.log());
    for (const Change_of_edges& change : m_told) {
      const Periodic_shift_2& shift = change.shifts[0];
      if (change.kind == Kind::CELL_EXCHANGED)
        m_visitor.after_cell_exchange(std::as_const(*this), change.shifts);
      else if (change.kind == Kind::POINT_TRANSLATED)
        m_visitor.after_translation(std::as_const(*this), size_type(change.i), shift);
      else if (change.kind == Kind::EDGE_REMOVED)
        m_visitor.after_edge_removal(std::as_const(*this), size_type(change.i), size_type(change.j),
                                     shift);
      else
        m_visitor.after_edge_creation(std::as_const(*this), size_type(change.i),
                                      size_type(change.j), shift);
    }
    m_visitor.after_update(std::as_const(*this), report);
  }

  size_type id_at(Index corner) const
  {
    const auto& state = m_core->state;
    return state.ids().representative(state.arrays().apex(corner));
  }
  Periodic_shift_2 shift_between(Index corner, Index other) const
  {
    const Periodic_shift_2& s = m_core->state.shift(corner);
    const Periodic_shift_2& t = m_core->state.shift(other);
    return {t[0] - s[0], t[1] - s[1]};
  }

  bool are_across(Index corner, Index other) const
  {
    const auto& state = m_core->state;
    return state.torus().are_across(state.shift(corner), state.shift(other));
  }
  // Whether a face is beside a slab, between its sides.
  bool is_in_gap(Index f) const
  {
    return are_across(3 * f, 3 * f + 1) || are_across(3 * f, 3 * f + 2);
  }

  Delaunay_classifier m_classifier;
  Delaunay_repair m_repair;
  Policy m_policy;
  Chosen_visitor m_visitor;
  std::unique_ptr<Core> m_core;
  std::vector<Position> m_next;        // indexed by ids
  std::vector<Change_of_edges> m_told; // to the visitor
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
