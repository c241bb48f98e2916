// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_TRIANGULATION_BASE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_TRIANGULATION_BASE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Default.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_triangulation_base.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/is_listening.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Triangulation_access.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Validity_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_options_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_settings_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Repair_by_exactness_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_frame_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <cstddef>
#include <istream>
#include <memory>
#include <ostream>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The types that a triangulation is made of; specialized for each class of triangulations, since a
// base class cannot read them from a class that is not complete yet.
template <class Dynamic>
struct Triangulation_types_2;

// The repair that goes with the exactness of a classifier, which may be known to the object alone.
template <class Classifier, bool knows_exactness = Knows_exactness<Classifier>::value>
struct Repair_for_exactness_2
{
  using type = Repair_by_exactness_2;
};
template <class Classifier>
struct Repair_for_exactness_2<Classifier, true>
{
  using type =
      std::conditional_t<Classifier::is_exact, Hold_and_flip_repair_2, Border_splice_repair_2>;
};

// The repair that is used with a classifier if the user chooses none.
template <class Classifier, class = void>
struct Usual_repair_2 : Repair_for_exactness_2<Classifier>
{
};
template <class Classifier>
struct Usual_repair_2<Classifier, std::void_t<typename Classifier::Usual_repair>>
{
  using type = typename Classifier::Usual_repair;
};

// The part of these types that users choose.
template <class Chosen_classifier, class... Options>
struct Chosen_types_2 : Options_check_2<Options...>
{
  using Classifier = typename Default::Get<Chosen_classifier, Circumcircle_classifier_2>::type;
  using Repair =
      typename Option_2<With_repair_2, typename Usual_repair_2<Classifier>::type, Options...>::type;
  using Policy = typename Option_2<With_policy_2, Always_dynamic_policy_2, Options...>::type;
  using Visitor =
      typename Option_2<With_visitor_2, Delaunay_update_visitor_base_2, Options...>::type;
  using Concurrency_tag = typename Option_2<With_concurrency_2, Sequential_tag, Options...>::type;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

// Compiles what updates of a class of triangulations need, also those with another classifier,
// repair or policy. With `extern` as the first argument, leaves that to another source file. To be
// used in namespace CGAL.
#define CGAL_DYNAMIC_DELAUNAY_COMPILE_UPDATE(prefix, ...)                                          \
  CGAL_DYNAMIC_DELAUNAY_COMPILE_KERNEL(                                                            \
      prefix, Dynamic_Delaunay_triangulations_2::internal::Triangulation_types_2<__VA_ARGS__>)
#define CGAL_DYNAMIC_DELAUNAY_COMPILE_KERNEL(prefix, ...)                                          \
  prefix template class Dynamic_mender_2<                                                          \
      Dynamic_Delaunay_triangulations_2::internal::Repair_tools_2<typename __VA_ARGS__::State>>;   \
  prefix template void Circumcircle_classifier_2::operator()(                                      \
      const Dynamic_frame_2<typename __VA_ARGS__::State>&,                                         \
      Dynamic_classification_2<typename __VA_ARGS__::State>&);                                     \
  prefix template void Circumcircle_classifier_2::after_update(                                    \
      const Dynamic_frame_2<typename __VA_ARGS__::State>&);                                        \
  prefix template Update_report_2                                                                  \
  Dynamic_Delaunay_triangulations_2::internal::Update_2<typename __VA_ARGS__::State>::run(         \
      Dynamic_Delaunay_triangulations_2::internal::Change_2<typename __VA_ARGS__::State::Point>&,  \
      typename __VA_ARGS__::Input&,                                                                \
      const Dynamic_Delaunay_triangulations_2::internal::Update_choices_2<                         \
          typename __VA_ARGS__::State>&)

// The kernels that `compiled_updates.h` compiles: of a class template, with the usual kernel and a
// tag, with any visitor or none.
#define CGAL_DYNAMIC_DELAUNAY_COMPILE(prefix, Dynamic, tag)                                        \
  CGAL_DYNAMIC_DELAUNAY_COMPILE_UPDATE(                                                            \
      prefix,                                                                                      \
      Dynamic<Exact_predicates_inexact_constructions_kernel, Default, With_concurrency_2<tag>>)

// Says of a class template that all these are compiled elsewhere, where that is so.
#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED
#define CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE(Dynamic)
#else
#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_COMPILED_PARALLEL
#define CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE(Dynamic)                                          \
  CGAL_DYNAMIC_DELAUNAY_COMPILE(extern, Dynamic, Sequential_tag);
#else
#define CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE(Dynamic)                                          \
  CGAL_DYNAMIC_DELAUNAY_COMPILE(extern, Dynamic, Sequential_tag);                                  \
  CGAL_DYNAMIC_DELAUNAY_COMPILE(extern, Dynamic, Parallel_tag);
#endif
#endif

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The members that triangulations of moving points share in the plane and in periodic space: motion,
insertion and removal of points, certificates and settings. It is the base class
of `Dynamic_Delaunay_triangulation_2` and `Dynamic_periodic_Delaunay_triangulation_2`, which explain
ids and certificates.

\tparam Derived the triangulation that is derived from this class.
*/
template <class Derived>
class Dynamic_triangulation_base_2
  : public Dynamic_triangulation_base<Derived,
                                      typename Dynamic_Delaunay_triangulations_2::internal::
                                          Triangulation_types_2<Derived>::State::Point,
                                      Update_report_2>
{
  using Types = Dynamic_Delaunay_triangulations_2::internal::Triangulation_types_2<Derived>;
  using Base = Dynamic_triangulation_base<Derived, typename Types::State::Point, Update_report_2>;
  friend Derived;
  friend Base;
  friend Dynamic_Delaunay_triangulations_2::internal::Triangulation_access;
  using State = typename Types::State;
  using Checkpoint = typename Types::Checkpoint;
  using Update = Dynamic_Delaunay_triangulations_2::internal::Update_2<State>;
  using Change = Dynamic_Delaunay_triangulations_2::internal::Change_2<typename State::Point>;
  using Population_input = Dynamic_Delaunay_triangulations_2::internal::Population_input_2<State>;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using typename Base::Identity_map;
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Halfedge_index = Dynamic_Delaunay_triangulations_2::Halfedge_index;
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;
  using Face_index = Dynamic_Delaunay_triangulations_2::Face_index;
  using Point_id = Dynamic_Delaunay_triangulations_2::Point_id;
  template <class Map>
  using If_map = typename Base::template If_map<Map>;
  template <class Iterator>
  using First_of = typename Base::template First_of<Iterator>;
  template <class Iterator>
  using Second_of = typename Base::template Second_of<Iterator>;

public:
  /// \name Types
  /// @{

  /// the traits, or kernel.
  using Geom_traits = typename Types::Geom_traits;
  using typename Base::Point;
  using typename Base::size_type;
  /// the classifier.
  using Delaunay_classifier = typename Types::Classifier;
  /// the repair.
  using Delaunay_repair = typename Types::Repair;
  /// the update policy.
  using Delaunay_update_policy = typename Types::Policy;
  /// the visitor.
  using Update_visitor = typename Types::Visitor;
  /// classifier, repair, engines, policy and visitor, as one object. In periodic space only the
  /// engine for whole triangulations is used; if it is not `GUIBAS_STOLFI`, points are inserted one
  /// by one.
  using Settings = Dynamic_triangulation_settings_2<Delaunay_classifier, Delaunay_repair,
                                                    Delaunay_update_policy, Update_visitor>;
  /// whether work is shared among threads.
  using Concurrency_tag = typename Types::Concurrency_tag;
  /// the read-only view that classifiers get.
  using Frame = Dynamic_frame_2<State>;

  /// @}
  /// \name Copies
  /// @{

  /// copies everything: points, ids, topology, numbers, the user's data in vertices and faces, and
  /// whether it is certified. From then on the same calls have the same results for both.
  /// Classifier, repair, engines, policy and visitor are copied too; the visitor is not called. The
  /// copy has its own vertex and face handles, and its sets of the last update are empty. Cost:
  /// linear.
  Dynamic_triangulation_base_2(const Dynamic_triangulation_base_2& other)
    : m_settings(other.m_settings)
    , m_core(other.empty_core())
  {
    m_core->update.copy(other.m_core->state, other.m_core->update);
  }

  /// takes everything from the other triangulation, and leaves it empty, in the same space, with
  /// the same classifier, repair, engines and policy, and with a moved-from visitor. Handles stay
  /// valid. Allocates memory for the empty triangulation and for copies of the classifier, the
  /// repair and the policy.
  Dynamic_triangulation_base_2(Dynamic_triangulation_base_2&& other)
    : Dynamic_triangulation_base_2(other, other.empty_core())
  {
  }
  /// replaces this triangulation by a copy. If it throws, nothing has changed.
  Dynamic_triangulation_base_2& operator=(const Dynamic_triangulation_base_2& other)
  {
    return *this = Dynamic_triangulation_base_2(other);
  }
  /// takes everything from the other triangulation, and replaces this one by it. Moving an object
  /// to itself changes nothing.
  Dynamic_triangulation_base_2& operator=(Dynamic_triangulation_base_2&& other)
  {
    Dynamic_triangulation_base_2 taken(std::move(other));
    swap(taken);
    return *this;
  }

  /// exchanges everything with the other triangulation. Handles stay valid.
  void swap(Dynamic_triangulation_base_2& other)
  {
    using std::swap;
    swap(m_settings, other.m_settings);
    swap(m_core, other.m_core);
  }
  /// calls `a.swap(b)`.
  friend void swap(Derived& a, Derived& b) { a.swap(b); }

  /// @}
  /// \name Motion
  /// @{

  using Base::move;
  using Base::update;

  /// moves point i to the i-th position of the range, for all points, and repairs the
  /// triangulation. The range has one position for each id; positions for ids of removed points are
  /// ignored. In periodic space the cell stays the same, and a point that moves by more than half
  /// the cell, as when it is wrapped, is taken to have moved to the nearest image of its new
  /// position.
  ///
  /// Cost: one pass over all ids, free ones included; the classifier's pass; and the repair of what
  /// it classified, which for points that jump is proportional to their number. The total is never
  /// much more than the cost of a rebuild. A frame that breaks nothing allocates nothing, except
  /// the first frame, and the one in which the circumcircle classifier first skips edges (16 bytes
  /// a vertex each); in periodic space also every frame that is not read, without a map, from an
  /// array or a vector of points (16 bytes an id).
  /// \throws Point_count_error_2 if the number of positions is not `number_of_ids()`.
  /// \throws Non_finite_coordinate_error_2 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program.
  /// \throws Periodic_range_error_2 in periodic space, if a point is 2<sup>20</sup> cells or more
  /// from the origin.
  ///
  /// Nothing changes if `update()` throws one of these, if the range throws, or if the policy or
  /// the classifier throws when it is asked. If the policy or the classifier throws in
  /// `after_update()`, the update itself is complete. After any other exception the points have
  /// their new positions and the triangulation is not certified; the next update, or `mend()`,
  /// certifies it again. \post `is_certified()`, if the classifier is exact.
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`; by
  ///   default the values are points.
  template <class InputIterator, class PointMap = Identity_map, class = If_map<PointMap>>
  Update_report_2 update(InputIterator first, InputIterator beyond, PointMap point_map = PointMap())
  {
    const Floating_point floating_point;
    m_core->input.stage(first, beyond, point_map);
    return run_frame();
  }

  /// moves some points, and repairs what that breaks. All other points keep their positions. The
  /// repair uses exact predicates, whatever the classifier is; the policy is not asked.
  ///
  /// Cost: proportional to the number of points in the range and to what they break, plus a walk
  /// around the hull if it changes; if points coincide, also proportional to the number of those at
  /// the same vertices.
  ///
  /// \tparam IdMap, PointMap models of `ReadablePropertyMap` from the range's values to ids, any
  ///   integers, and to `Point`; by default the values are pairs of both.
  /// \throws Unknown_id_error_2 if an id belongs to no point.
  /// \throws Repeated_id_error_2 if an id is given more than once.
  /// \throws Non_finite_coordinate_error_2, Coordinate_range_error_2 or Periodic_range_error_2 as
  /// `update()`.
  ///
  /// Nothing changes if `move()` throws one of these, or if the range throws. After any other
  /// exception the triangulation is not certified; `mend()` certifies it again.
  /// \post `is_certified()` if it was, if the classifier is exact, or in periodic space, if the
  /// range is not empty.
  template <class InputIterator, class IdMap = First_of<InputIterator>,
            class PointMap = Second_of<InputIterator>>
  Update_report_2 move(InputIterator first, InputIterator beyond, IdMap id_map = IdMap(),
                       PointMap point_map = PointMap())
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_movers(first, beyond, id_map, point_map, m_core->state, change);
    m_core->input.check(change.moved_points, change.moved);
    return run(change);
  }

  /// @}
  /// \name Population
  /// Inserts and removes points, and repairs what that breaks by exact predicates, whatever the
  /// classifier is. If memory runs out, each point is either inserted (or removed) completely or
  /// not at all, and the triangulation is not certified; `mend()` certifies it again.
  /// @{

  using Base::insert;
  using Base::remove;

  /// inserts the points that `point_map` reads from the values of the range. Their ids are written
  /// to `ids` first: the smallest free ones; if none is free, the next ones, in the order of the
  /// range. A point that coincides with another one shares its vertex. Rebuilds if there are more
  /// than about half as many points as vertices, of more than 32,768 a quarter, in periodic space
  /// more, and while the points do not span the plane.
  ///
  /// Cost of each: O(n<sup>1/3</sup>) expected for evenly spread points to find its place, plus the
  /// repair of what it breaks, plus a walk around the hull if it changes.
  /// \throws Non_finite_coordinate_error_2, Coordinate_range_error_2 or Periodic_range_error_2 as
  /// `update()`, with the id that the point would get; Point_limit_error_2 if there would be more
  /// points than 32 bits allow. Then nothing changes, and no id is written.
  /// \post `is_certified()` if it was, or if the classifier is exact; in periodic space, if the
  /// range is not empty. With a heuristic classifier, an empty one changes nothing.
  template <class InputIterator, class PointMap, class OutputIterator>
  Update_report_2 insert(InputIterator first, InputIterator beyond, PointMap point_map,
                         OutputIterator ids)
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_newcomers(first, beyond, point_map, m_core->state, change);
    m_core->input.check(change.coming_points, change.coming);
    for (const Point_id id : change.coming)
      *ids++ = id;
    return run(change);
  }

  /// removes the points with these ids, which are free from then on. Rebuilds if these are more
  /// than about half of the vertices, of more than 32,768 a quarter, in periodic space more, and if
  /// the points do not span the plane before or after.
  ///
  /// Cost of each: proportional to the number of its neighbors and to what its removal breaks, plus
  /// a walk around the hull if it changes; if points coincide, also proportional to the number of
  /// those at its vertex.
  /// \tparam InputIterator its values are integers.
  /// \throws Unknown_id_error_2 if an id belongs to no point; nothing changes.
  /// \throws Repeated_id_error_2 if an id is given more than once; nothing changes.
  /// \post That of the insertion of a range.
  template <class InputIterator>
  Update_report_2 remove(InputIterator first, InputIterator beyond)
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_ids(first, beyond, m_core->state, change.gone);
    return run(change);
  }

  /// @}
  /// \name Certainty
  /// @{

  /// whether the triangulation is proved Delaunay. Always false if its traits need
  /// `accepts_inexact_predicates_2`, whatever postconditions say. Cost: none.
  bool is_certified() const { return Types::is_exact && m_core->update.is_certified(); }

  /// tests whether the triangulation is Delaunay, by exact predicates at every edge, and certifies
  /// it if so. Changes nothing else, but for edges across the gap beside a slab, which are not
  /// listed. The result is false if an exception has left points without their own vertices, or has
  /// left an uncertified triangulation that does not span the plane. Cost: one pass over all edges,
  /// and flips in the gap; none if it is certified already.
  bool certify()
  {
    const Floating_point floating_point;
    return Types::is_exact && m_core->update.certify(choices());
  }

  /// makes the triangulation Delaunay and certified, whatever the classifier is: all edges are
  /// examined by exact predicates, and `Hold_and_flip_repair_2` repairs the broken ones. Does
  /// nothing if the triangulation is certified already. \post `is_certified()`
  Update_report_2 mend()
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    change.is_mending = true;
    return is_certified() ? certified_report() : run(change);
  }

  /// whether the object is valid: its data structure is valid, no point is lost, and the
  /// certificate holds if `is_certified()`. In the plane the result is false if a point, a vertex
  /// or a neighbor was set through a handle since everything was built last. In periodic space the
  /// areas of the faces must sum up, in exact arithmetic, to the area of the cell. Cost: linear, in
  /// periodic space microseconds a point.
  /// \param verbose whether to print to `std::cerr` what is wrong.
  /// \param level is passed to the `is_valid()` of the data structure in the plane.
  bool is_valid(bool verbose = false, int level = 0) const
  {
    const Floating_point floating_point;
    using Check = Dynamic_Delaunay_triangulations_2::internal::Validity_check_2<State>;
    return Check(m_core->state, verbose).passes(level, is_certified());
  }

  /// @}
  /// \name Points and Ids
  /// @{

  /// the number of finite vertices: less than the number of points if points coincide.
  size_type number_of_vertices() const { return m_core->state.number_of_vertices(); }

  /// calls `f(j)` for each neighbor j of the point with this id, or of its representative,
  /// counterclockwise. In periodic space it calls `f(j, shift)`, and meets an edge from a point to
  /// its own image at both of its ends. Cost: proportional to the number of neighbors; no
  /// allocation.
  /// \throws Unknown_id_error_2 if no point has this id.
  template <class Function>
  void for_each_neighbor(size_type id, const Function& f) const
  {
    const State& state = m_core->state;
    state.for_each_finite_neighbor(this->vertex_of(id), [&](Vertex_index w, const auto&... shift) {
      f(size_type(state.ids().representative(w)), shift...);
    });
  }

  /// @}
  /// \name Views and Settings
  /// @{

  /// the points, edges and faces as flat arrays.
  Frame frame() const { return Frame(m_core->state); }

  /// the classifier.
  const Delaunay_classifier& classifier() const { return m_settings.classifier; }
  /// the repair.
  const Delaunay_repair& repair() const { return m_settings.repair; }
  /// the update policy.
  const Delaunay_update_policy& policy() const { return m_settings.policy; }
  /// the visitor.
  const Update_visitor& visitor() const { return m_settings.visitor; }
  /// the visitor, in order to read and clear what it has recorded.
  Update_visitor& visitor() { return m_settings.visitor; }

  /// the Classified set of the last update, as vertices of `frame()`. Empty after a rebuild that
  /// preceded classification, and if vertices have changed their numbers since. Where a
  /// frame was taken in steps, that of the last step.
  const std::vector<Vertex_index>& classified_vertices() const
  {
    return tools().context.classification.vertices();
  }
  /// the Padded set of the last update that spliced around the Classified set.
  const std::vector<Vertex_index>& padded_vertices() const { return tools().context.padded; }
  /// the Border set of the last update that spliced around the Classified set.
  const std::vector<Vertex_index>& border_vertices() const { return tools().context.border; }

  /// @}

private:
  // Must not move in memory: its parts refer to each other.
  struct Core
  {
    Core(const typename State::Argument& argument, const Static_engines_2& engines)
      : state(argument)
    {
      update.tools().set_engines(engines);
    }

    State state;
    typename Types::Input input{state};
    Update update{state};
    Change change; // of the present call, or the last one
  };

  Dynamic_triangulation_base_2(const Settings& settings, const typename State::Argument& argument)
    : m_settings(settings)
    , m_core(std::make_unique<Core>(argument, settings.engines))
  {
  }
  ~Dynamic_triangulation_base_2() = default;

  // Returns the change of this call, which is still empty.
  Change& begin_change()
  {
    m_core->change.clear();
    return m_core->change;
  }

  // Runs the frame that was staged.
  Update_report_2 run_frame()
  {
    Change& change = begin_change();
    change.is_frame = true;
    return run(change);
  }

  // Runs a change whose input was read and checked.
  Update_report_2 run(Change& change)
  {
    m_core->update.enter();
    start_visit(); // if this throws, a frame that was read is not used
    try {
      const Update_report_2 report = run_phases(change);
      finish_visit(report);
      return report;
    } catch (...) {
      m_core->input.forget_previous();
      throw;
    }
  }

  static void check_number_of_points(size_type number)
  {
    Dynamic_Delaunay_triangulations_2::internal::check_limit(number);
  }

  const auto& point_ids() const { return m_core->state.ids(); }
  static std::string_view checkpoint_subject() { return Types::checkpoint_subject; }

  // Runs a whole frame of `Dynamic_population_2`, in periodic space perhaps with another cell.
  // There is a position for every id, also for those that are removed; `gone` has the ids to
  // remove, all of which exist; `coming` has the points to insert. The ids of these points are
  // written to `coming_ids`, ascending, unless an exception ends this before all removals are done.
  template <class... Cell>
  Update_report_2 update_population(const std::vector<Point>& positions,
                                    const std::vector<size_type>& gone,
                                    const std::vector<Point>& coming,
                                    std::vector<size_type>& coming_ids, const Cell&... cell)
  {
    const Floating_point floating_point;
    Change& change = begin_change();
    Population_input::read_newcomers(coming.begin(), coming.end(), Identity_map(), m_core->state,
                                     change);
    change.is_frame = true;
    for (const size_type id : gone)
      change.gone.emplace_back(id);
    change.coming = m_core->state.ids().next_ids(coming.size(), change.gone);
    const std::vector<size_type> ids(change.coming.begin(), change.coming.end());
    m_core->input.leave_out(change.gone);
    m_core->input.stage(positions.begin(), positions.end(), Identity_map(), cell...);
    try {
      const Update_report_2 report = run(change);
      coming_ids = ids;
      return report;
    } catch (...) {
      if (m_core->update.has_removed())
        coming_ids = ids;
      throw;
    }
  }

  // Writes a checkpoint of this kind. `append` writes additional lines of the file.
  template <class Append>
  void write_file(std::ostream& out, std::string_view subject, const Append& append) const
  {
    const Floating_point floating_point;
    using Writer =
        Dynamic_Delaunay_triangulations_2::internal::Checkpoint_writer_2<State, Checkpoint>;
    Writer(m_core->state, is_certified(), m_core->update.memory()).write(out, subject, append);
  }

  // Reads such a checkpoint. `read_more` reads the lines that `append` wrote. When the whole file
  // was accepted, `exchange_more` takes over what was read; it must not throw.
  template <class ReadAppendix, class Exchange>
  void read_file(std::istream& in, std::string_view subject, const ReadAppendix& read_more,
                 const Exchange& exchange_more)
  {
    using Reader =
        Dynamic_Delaunay_triangulations_2::internal::Checkpoint_reader_2<State, Checkpoint>;
    const Floating_point floating_point;
    Dynamic_Delaunay_triangulations_2::internal::Checkpoint_input_2 file(in, subject);
    Reader reader(file);
    State state(m_core->state.argument());
    reader.read(state);
    read_more(file, state.ids());
    file.finish();
    Delaunay_classifier classifier = m_settings.classifier;
    inform_classifier(classifier, Frame(state));
    listen(); // what is to be told takes memory
    m_core->update.tools().context.builder.reserve_for_exchange(state);
    m_settings.visitor.before_update(this->derived());
    m_settings.classifier = std::move(classifier); // from here on only the visitor may throw
    m_core->update.exchange(state, reader.is_certified(), reader.memory());
    exchange_more();
    finish_visit(is_certified() ? certified_report() : Update_report_2());
  }

  // Takes everything from the other triangulation, which gets an empty core. Classifier, repair and
  // policy are copied, not moved, since both objects go on using them.
  Dynamic_triangulation_base_2(Dynamic_triangulation_base_2& other, std::unique_ptr<Core> empty)
    : m_settings(other.m_settings.classifier, other.m_settings.repair, other.m_settings.engines,
                 other.m_settings.policy, std::move(other.m_settings.visitor))
    , m_core(std::exchange(other.m_core, std::move(empty)))
  {
  }

  std::unique_ptr<Core> empty_core() const
  {
    return std::make_unique<Core>(m_core->state.argument(), tools().engines);
  }

  // Calls `before_update()`; if that throws, nothing has changed yet.
  void start_visit()
  {
    m_settings.visitor.before_update(this->derived());
    listen();
  }
  // From now on, changes are told to the visitor, if it listens.
  void listen()
  {
    using Dynamic_Delaunay_triangulations_2::internal::is_listening;
    m_core->update.tools().context.editor.start_visit(
        m_settings.visitor, &this->derived(),
        is_listening<Delaunay_update_visitor_base_2>(m_settings.visitor));
  }

  // Ends the visit after a change. In periodic space the visitor is told of all changes here; in
  // the plane what it threw in between is rethrown.
  void finish_visit(const Update_report_2& report)
  {
    m_core->update.tools().context.editor.finish_visit();
    m_settings.visitor.after_update(this->derived(), report);
  }

  Update_report_2 run_phases(Change& change)
  {
    Update_report_2 report = m_core->update.run(change, m_core->input, choices());
    report.certified = is_certified();
    if (change.is_frame)
      m_settings.policy.after_update(frame(), report);
    m_core->input.forget_previous();
    return report;
  }

  typename Update::Choices choices()
  {
    return {m_settings.classifier, m_settings.repair, m_settings.policy};
  }

  const auto& tools() const { return std::as_const(m_core->update).tools(); }

  static Update_report_2 certified_report()
  {
    Update_report_2 report;
    report.certified = true;
    return report;
  }

  Settings m_settings;
  std::unique_ptr<Core> m_core;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DYNAMIC_TRIANGULATION_BASE_2_H
