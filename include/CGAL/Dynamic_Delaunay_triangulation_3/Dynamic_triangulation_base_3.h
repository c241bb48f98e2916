// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_TRIANGULATION_BASE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_TRIANGULATION_BASE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_triangulation_base.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/is_listening.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Triangulation_access.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Dynamic_triangulation_options_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_reader_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/io/Checkpoint_writer_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Simplex_changes_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Update_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/policies/Dynamic_triangulation_settings_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/views/Dynamic_frame_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Delaunay_update_visitor_base_3.h>
#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif
#include <CGAL/tags.h>

#include <cstddef>
#include <iostream>
#include <istream>
#include <memory>
#include <ostream>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_3::internal {

using Dynamic_Delaunay_triangulations_2::internal::Triangulation_access;

// The types that options choose.
template <class... Options>
struct Chosen_types_3 : Options_check_3<Options...>
{
  template <template <class> class Kind, class Usual>
  using Option =
      typename Dynamic_Delaunay_triangulations_2::internal::Option_2<Kind, Usual, Options...>::type;
  using Concurrency_tag = Option<With_concurrency_2, Sequential_tag>;
  using Visitor = Option<With_visitor_2, Delaunay_update_visitor_base_3>;
  using Policy = Option<With_policy_2, Always_dynamic_policy_2>;
  // Changes are recorded for those who want to know.
  static constexpr bool is_watched = !std::is_same_v<Visitor, Delaunay_update_visitor_base_3>;
};

} // namespace Dynamic_Delaunay_triangulations_3::internal

// Compiles what updates and checkpoints in a space need, with the usual kernel, whatever the policy
// and the visitor are. With `extern` as the first argument, leaves that to another source file. To
// be used in namespace CGAL.
#define CGAL_DYNAMIC_DELAUNAY_COMPILE_3(prefix, Space_3, tag)                                      \
  CGAL_DYNAMIC_DELAUNAY_COMPILE_IN_SPACE_3(                                                        \
      prefix, Dynamic_Delaunay_triangulations_3::internal::Space_3<                                \
                  Exact_predicates_inexact_constructions_kernel, tag>)
#define CGAL_DYNAMIC_DELAUNAY_COMPILE_IN_SPACE_3(prefix, ...)                                      \
  prefix template class Dynamic_Delaunay_triangulations_3::internal::Update_3<__VA_ARGS__>;        \
  prefix template class Dynamic_Delaunay_triangulations_3::internal::Simplex_changes_3<            \
      typename __VA_ARGS__::State>;                                                                \
  prefix template class Dynamic_Delaunay_triangulations_3::internal::Checkpoint_writer_3<          \
      typename __VA_ARGS__::State>;                                                                \
  prefix template class Dynamic_Delaunay_triangulations_3::internal::Checkpoint_reader_3<          \
      typename __VA_ARGS__::State>

// Says of a space that all these are compiled elsewhere, where that is so.
#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED
#define CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE_3(Space_3)
#elif !defined(CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_COMPILED_PARALLEL)
#define CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE_3(Space_3)                                        \
  CGAL_DYNAMIC_DELAUNAY_COMPILE_3(extern, Space_3, Sequential_tag);
#else
#define CGAL_DYNAMIC_DELAUNAY_COMPILED_ELSEWHERE_3(Space_3)                                        \
  CGAL_DYNAMIC_DELAUNAY_COMPILE_3(extern, Space_3, Sequential_tag);                                \
  CGAL_DYNAMIC_DELAUNAY_COMPILE_3(extern, Space_3, Parallel_tag);
#endif

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What `Dynamic_Delaunay_triangulation_3` and `Dynamic_periodic_Delaunay_triangulation_3` have in
common: points that move, are inserted and removed, proofs, policies and visitors. Programs use it
as a part of these classes alone.

\tparam Dynamic the class of triangulations.
\tparam Space an internal type.
\tparam Options those of the class.
*/
template <class Dynamic, class Space, class... Options>
class Dynamic_triangulation_base_3
  : public Dynamic_triangulation_base<Dynamic, typename Space::State::Point, Update_report_3>
{
  using Base = Dynamic_triangulation_base<Dynamic, typename Space::State::Point, Update_report_3>;
  friend Base;
  friend Dynamic_Delaunay_triangulations_3::internal::Triangulation_access;
  using Chosen = Dynamic_Delaunay_triangulations_3::internal::Chosen_types_3<Options...>;
  static_assert(Chosen::is_right);
  using Visitor = typename Chosen::Visitor;
  using Policy = typename Chosen::Policy;
  template <class Map>
  using If_map = typename Base::template If_map<Map>;
  template <class Iterator>
  using First_of = typename Base::template First_of<Iterator>;
  template <class Iterator>
  using Second_of = typename Base::template Second_of<Iterator>;

protected:
  /// \cond
  using typename Base::Identity_map;
  using State = typename Space::State;
  using Update = Dynamic_Delaunay_triangulations_3::internal::Update_3<Space>;
  using Chosen_rebuilds = typename Update::Chosen_rebuilds;
  using Input = Dynamic_Delaunay_triangulations_3::internal::Input_3<State>;
  using Change = Dynamic_Delaunay_triangulations_3::internal::Change_3<typename State::Point>;
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point;
  using Index = Dynamic_Delaunay_triangulations_3::Index;
  using Cell_index = Dynamic_Delaunay_triangulations_3::Cell_index;
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  /// \endcond

public:
  /// \name Types
  /// @{

  /// the traits, or kernel.
  using Geom_traits = typename State::Traits;
  using typename Base::Point;
  using typename Base::size_type;
  /// whether work is shared among threads.
  using Concurrency_tag = typename Chosen::Concurrency_tag;
  /// the policy and the visitor, in one object. A policy converts to it.
  using Settings = Dynamic_triangulation_settings_3<Policy, Visitor>;

  /// @}
  /// \name Copies
  /// @{

  /// copies everything: points, ids, cells, policy and visitor. From then on the same calls have
  /// the same results for both. Cost: linear.
  Dynamic_triangulation_base_3(const Dynamic_triangulation_base_3& other)
    : Dynamic_triangulation_base_3(other.state(), other.settings())
  {
    m_core->changes = other.m_core->changes;
    m_core->kernel.take_over(other.m_core->kernel);
  }
  /// takes everything from the other triangulation, and leaves it empty, in periodic space with the
  /// same cell, and with copies of its policy and its visitor.
  Dynamic_triangulation_base_3(Dynamic_triangulation_base_3&& other)
    : Dynamic_triangulation_base_3(other.state().without_points(), other.settings())
  {
    m_core.swap(other.m_core);
  }
  /// replaces this triangulation by a copy. If it throws, nothing has changed.
  Dynamic_triangulation_base_3& operator=(const Dynamic_triangulation_base_3& other)
  {
    Dynamic_triangulation_base_3 copy(other);
    swap(copy);
    return *this;
  }
  /// takes everything from the other triangulation, and replaces this one by it.
  Dynamic_triangulation_base_3& operator=(Dynamic_triangulation_base_3&& other)
  {
    Dynamic_triangulation_base_3 taken(std::move(other));
    swap(taken);
    return *this;
  }

  /// exchanges everything with the other triangulation.
  void swap(Dynamic_triangulation_base_3& other) noexcept { m_core.swap(other.m_core); }
  /// calls `a.swap(b)`.
  friend void swap(Dynamic& a, Dynamic& b) noexcept { a.swap(b); }

  /// @}
  /// \name Motion
  /// @{

  using Base::move;
  using Base::update;

  /// moves point i to the i-th position of the range, for all points, and repairs the
  /// triangulation. The range has one position for each id; positions for ids of removed points are
  /// ignored. In periodic space a point that is given at another of its images, as by wrapping it
  /// into the cell, counts as moved to the image that is nearest to where it was.
  ///
  /// Nothing changes if it throws one of these, or if the range or the policy throws. If memory
  /// runs out later, the points have their new positions and there are no cells until the next
  /// call.
  /// \throws Point_count_error_2 if the number of positions is not `number_of_ids()`.
  /// \throws Non_finite_coordinate_error_3 if a coordinate is NaN or infinite.
  /// \throws Coordinate_range_error_3 if a coordinate is too large for this program; in periodic
  ///   space Periodic_range_error_3 if a point is 2<sup>20</sup> cells or more from the origin.
  /// \post `is_certified()`
  /// \tparam PointMap a model of `ReadablePropertyMap` from the range's values to `Point`; by
  ///   default the values are points.
  template <class InputIterator, class PointMap = Identity_map, class = If_map<PointMap>>
  Update_report_3 update(InputIterator first, InputIterator beyond,
                         const PointMap& point_map = PointMap())
  {
    return update_frame(first, beyond, point_map);
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
  /// \throws Coordinate_range_error_3, in periodic space Periodic_range_error_3, as `update()`.
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
      this->check_id(id);
      change.moved.emplace_back(id);
      change.moved_points.push_back(get(point_map, value));
      m_core->state.check(change.moved_points.back(), id);
    }
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(change.moved);
    return run(change);
  }

  /// @}
  /// \name Insertion and Removal
  /// @{

  using Base::insert;
  using Base::remove;

  /// inserts the points that `point_map` reads from the values of the range. Their ids are written
  /// to `ids` first, in the same order.
  /// \throws Non_finite_coordinate_error_3, Coordinate_range_error_3, Periodic_range_error_3 as
  ///   `update()`; the error's id is the one that the point would get. Then nothing has changed.
  /// \throws Point_limit_error_2 if there would be more points than 32 bits allow.
  template <class InputIterator, class PointMap, class OutputIterator>
  Update_report_3 insert(InputIterator first, InputIterator beyond, const PointMap& point_map,
                         OutputIterator ids)
  {
    const Floating_point floating_point;
    Change change;
    Input::read_newcomers(first, beyond, point_map, m_core->state, change);
    for (const Point_id id : change.coming)
      *ids++ = size_type(id);
    return run(change);
  }

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
      this->check_id(size_type(*first));
      change.gone.emplace_back(*first);
    }
    Dynamic_Delaunay_triangulations_2::internal::check_distinct(change.gone);
    return run(change);
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
  /// Delaunay; without cells, whether the points are coplanar. Cost: microseconds a point, in
  /// periodic space where there are ties many.
  /// \param verbose whether to print to `std::cerr` what is wrong.
  bool is_valid(bool verbose = false) const
  {
    const Floating_point floating_point;
    const char* const problem = m_core->kernel.problem();
    if (problem != nullptr && verbose)
      std::cerr << Space::name << ": " << problem << '\n';
    return problem == nullptr;
  }

  /// @}
  /// \name Points and Ids
  /// @{

  /// the number of vertices: less than the number of points if points coincide.
  size_type number_of_vertices() const { return ids().number_of_representatives(); }
  /// the position of a point, as it was given last.
  /// \throws Unknown_id_error_2 if no point has this id.
  Point point(size_type id) const
  {
    const Vertex_index v = this->vertex_of(id);
    return ids().is_representative(Point_id(id)) ? Point(state().point(v))
                                                 : ids().covered_point(Point_id(id));
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

protected:
  /// \cond
  // Starts with a state without points.
  Dynamic_triangulation_base_3(State state, const Settings& settings)
    : m_core(std::make_unique<Core>(std::move(state), settings))
  {
  }
  ~Dynamic_triangulation_base_3() = default;

  // Moves all points, as `update()` says, to another cell if there is one more argument.
  template <class InputIterator, class PointMap, class... Cell>
  Update_report_3 update_frame(InputIterator first, InputIterator beyond, const PointMap& point_map,
                               const Cell&... cell)
  {
    const Floating_point floating_point;
    m_core->kernel.staged().set_cell(state(), cell...);
    Input::stage(first, beyond, point_map, state(), m_core->kernel.staged());
    Change change;
    change.is_frame = true;
    return run(change);
  }

  const State& state() const { return m_core->state; }
  const typename State::Ids& ids() const { return m_core->state.ids; }
  Index cells() const { return state().spans_space ? state().arrays.number_of_cells() : 0; }
  size_type representative_of(Vertex_index v) const { return ids().representative(v); }
  /// \endcond

private:
  using Changes = Dynamic_Delaunay_triangulations_3::internal::Simplex_changes_3<State>;
  struct Nothing
  {
  };
  static constexpr bool is_watched = Chosen::is_watched;

  // Must not move in memory: its parts refer to each other.
  struct Core
  {
    Core(State s, const Settings& settings)
      : state(std::move(s))
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

  const typename State::Ids& point_ids() const { return ids(); }
  static std::string_view checkpoint_subject() { return Space::name; }
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
      if (is_listening())
        m_core->changes.begin(m_core->state);
      m_core->visitor.before_update(this->derived());
    }
  }
  // Compares, then tells the visitor.
  void finish_visit([[maybe_unused]] const Update_report_3& report)
  {
    if constexpr (is_watched) {
      if (is_listening()) {
        m_core->changes.end(m_core->state);
        tell_changes();
      }
      m_core->visitor.after_update(this->derived(), report);
    }
  }
  void tell_changes()
  {
    using Names = typename Changes::Names;
    Visitor& visitor = m_core->visitor;
    const auto &removed = m_core->changes.removed(), &created = m_core->changes.created();
    Names::tell(m_core->state, visitor, this->derived());
    m_core->changes.close(m_core->state);
    for (const auto& facet : removed.facets)
      Names::apply(facet, [&](const auto&... args) {
        visitor.after_facet_removal(this->derived(), args...);
      });
    for (const auto& edge : removed.edges)
      Names::apply(
          edge, [&](const auto&... args) { visitor.after_edge_removal(this->derived(), args...); });
    for (const auto& edge : created.edges)
      Names::apply(edge, [&](const auto&... args) {
        visitor.after_edge_creation(this->derived(), args...);
      });
    for (const auto& facet : created.facets)
      Names::apply(facet, [&](const auto&... args) {
        visitor.after_facet_creation(this->derived(), args...);
      });
  }
  bool is_listening() const
  {
    using Dynamic_Delaunay_triangulations_2::internal::is_listening;
    return is_listening<Delaunay_update_visitor_base_3>(m_core->visitor);
  }

  static void check_number_of_points(size_type number) { Input::check_number(number); }

  template <class... Cell>
  auto position_check(const Cell&... cell)
  {
    m_core->kernel.staged().set_cell(state(), cell...);
    return [this](const Point& p, size_type place) {
      m_core->kernel.staged().check(state(), p, place);
    };
  }

  // A frame of a population, in another cell if there is one more argument: removes the points
  // `gone`, moves the others to the positions by their ids, and inserts points. All positions are
  // checked. The ids of new points are written to `coming_ids`, ascending, unless an exception ends
  // this before all removals are done.
  template <class... Cell>
  Update_report_3 update_population(const std::vector<Point>& positions,
                                    const std::vector<size_type>& gone,
                                    const std::vector<Point>& coming,
                                    std::vector<size_type>& coming_ids, const Cell&... cell)
  {
    const Floating_point floating_point;
    m_core->kernel.staged().set_cell(state(), cell...);
    Change change;
    change.is_frame = true;
    change.positions = &positions;
    for (const size_type id : gone)
      change.gone.emplace_back(id);
    Input::check_number(this->number_of_points() - change.gone.size() + coming.size());
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
    Dynamic_Delaunay_triangulations_3::internal::Checkpoint_writer_3<State>(state(), file).write();
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
    auto core = std::make_unique<Core>(state().without_points(), settings());
    Dynamic_Delaunay_triangulations_3::internal::Checkpoint_reader_3<State>(core->state, file)
        .read();
    read_more(file, core->state.ids);
    file.finish();
    if constexpr (is_watched) {
      core->visitor.before_update(this->derived());
      if (is_listening())
        core->changes.compare(m_core->state, m_core->changes, core->state);
    }
    m_core.swap(core);
    exchange_more();
    if constexpr (is_watched) {
      Update_report_3 report;
      report.certified = true;
      if (is_listening())
        tell_changes();
      m_core->visitor.after_update(this->derived(), report);
    }
  }

  std::unique_ptr<Core> m_core;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_DYNAMIC_TRIANGULATION_BASE_3_H
