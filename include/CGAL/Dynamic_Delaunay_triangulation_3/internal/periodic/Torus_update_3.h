// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_UPDATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_UPDATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Held_vertices_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_flips_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_rebuild_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_removal_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Changes points of a torus and its cell, and makes their triangulation Delaunay again, by the
// phases of `Update_3`. There is no hull: cells that stay positive go on covering the torus once.
template <class State>
class Torus_update_3
{
  using Arrays = Torus_cells_3;
  using Point = typename State::Point;
  using Reason = Rebuild_reason_2;
  using Flips = Torus_flips_3<State>;

public:
  explicit Torus_update_3(State& state)
    : m_state(state)
    , m_flips(state)
    , m_held(state, m_other, m_flips)
    , m_insertion(state)
    , m_removal(state)
    , m_rebuild(state)
  {
  }

  bool is_certified() const { return m_is_certified; }

  // Takes over what is known of the other update's state, a copy of which is this one's.
  void take_over(const Torus_update_3& other) { m_is_certified = other.m_is_certified; }

  // Proves the triangulation again. If that fails, the next call rebuilds.
  bool certify()
  {
    const Torus_certificate_3<State> certificate(m_state);
    m_is_certified = m_is_certified && certificate.is_combinatorially_valid() &&
                     certificate.is_Delaunay(m_unproved) && certificate.covers_once();
    return m_is_certified;
  }

  // What is wrong with the triangulation, or null.
  const char* problem() const
  {
    const Torus_certificate_3<State> certificate(m_state);
    if (!certificate.is_combinatorially_valid())
      return "the cells do not fit together, or a vertex has none";
    if (!certificate.is_Delaunay())
      return "it is not Delaunay";
    if (m_state.number_of_vertices() > 0 && !certificate.covers_once())
      return "the cells do not cover the torus once";
    return nullptr;
  }

  // Reads and checks a frame before anything changes.
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map,
             const Periodic_cell_3& cell)
  {
    m_next_torus.reset();
    m_is_torus_new = false;
    if (cell != m_state.torus.cell()) {
      m_next_torus = m_state.torus.moved_to(cell);
      m_is_torus_new = !m_next_torus;
      if (!m_next_torus)
        m_next_torus = Torus_3(cell);
    }
    const std::size_t expected = m_state.ids.number_of_ids();
    m_points.clear();
    m_points.reserve(expected);
    for (; first != beyond; ++first) {
      if (m_points.size() == expected)
        throw Point_count_error_2(expected, expected + 1);
      m_points.push_back(get(point_map, *first));
    }
    if (m_points.size() != expected)
      throw Point_count_error_2(expected, m_points.size());
    const Torus_3& torus = next_torus();
    for (std::size_t id = 0; id < expected; ++id)
      if (m_state.ids.is_taken(id))
        check(m_points[id], id, torus);
    m_other.resize(m_state.positions.number());
    m_other_covered.resize(m_state.ids.number_of_covered());
  }

  // Throws if a point is not finite, or too far away.
  static void check(const Point& p, std::size_t id, const Torus_3& torus)
  {
    const Position_3 position = approximation(p);
    if (!is_finite(position))
      throw Non_finite_coordinate_error_3(id, position.x, position.y, position.z);
    if (!torus.is_in_range(position))
      throw Periodic_range_error_3(id, position.x, position.y, position.z, Torus_3::max_multiple);
  }

  // If memory runs out, there are no cells, each point is where it was or where it belongs, and the
  // next call rebuilds.
  Update_report_3 run(const Change_3<Point>& change)
  {
    m_state.ids.reserve_for_removals(change.gone.size() + change.coming.size());
    m_report = Update_report_3();
    m_flips.clear();
    m_held.forget();
    const bool was_certified = std::exchange(m_is_certified, false);
    try {
      run_phases(change, was_certified);
    } catch (...) {
      m_held.bring_to_targets();
      m_state.drop_cells();
      throw;
    }
    m_report.flips += m_flips.number_of_flips();
    m_flips.clear();
    m_held.forget();
    m_unproved = std::vector<Cell_index>();
    m_report.certified = m_is_certified = true;
    return m_report;
  }

private:
  const Torus_3& next_torus() const { return m_next_torus ? *m_next_torus : m_state.torus; }

  void run_phases(const Change_3<Point>& change, bool was_certified)
  {
    m_report.removed = change.gone.size();
    m_report.inserted = change.coming.size();
    m_waiting.clear();
    Reason reason = reason_not_to_mend(change, was_certified);
    for (const Point_id id : change.gone)
      if (!remove(id, reason == Reason::NONE))
        reason = Reason::STUCK;
    m_state.ids.reserve(change.coming);
    if (change.is_frame)
      exchange_positions();
    for (std::size_t i = 0; i < change.moved.size(); ++i)
      if (!move(change.moved[i], change.moved_points[i], reason == Reason::NONE))
        reason = Reason::STUCK;
    if (reason == Reason::NONE)
      reason = mend(change);
    if (reason == Reason::NONE)
      return;
    m_held.bring_to_targets();
    m_rebuild.run(change);
    m_report.rebuild_reason = reason;
    m_report.merged = m_report.parted = 0;
  }

  Reason reason_not_to_mend(const Change_3<Point>& change, bool was_certified) const
  {
    if (m_state.number_of_vertices() == 0)
      return Reason::DIMENSION;
    if (!was_certified || (change.is_frame && m_is_torus_new))
      return Reason::STUCK;
    if (10 * (change.gone.size() + change.moved.size()) + change.coming.size() >
        m_state.number_of_vertices())
      return Reason::POPULATION;
    return Reason::NONE;
  }

  // MOTION ----------------------------------------------------------------------------------------

  // Lets the positions of a frame count, and its cell. Each vertex goes to that image of its new
  // point that is nearest to where it was, carried with the cell.
  void exchange_positions()
  {
    const Torus_3 old_torus = m_state.torus;
    if (m_next_torus)
      m_state.torus = *m_next_torus;
    for (Vertex_index v(1); v < m_state.positions.number(); ++v) {
      if (m_next_torus)
        m_state.positions.set(v, Torus_place_3(m_state.torus.combination(
                                     old_torus.fractions(m_state.positions.position(v)))));
      const Position_3 base = approximation(m_points[m_state.ids.representative(v)]);
      m_other.set(v, m_state.place_at(base, m_state.positions.position(v)));
    }
    for (Index i = 0; i < m_state.ids.number_of_covered(); ++i)
      m_other_covered[i] = m_points[m_state.ids.covered_id(i)];
    m_state.positions.swap(m_other);
    m_state.ids.covered_points().swap(m_other_covered);
  }

  Reason mend(const Change_3<Point>& change)
  {
    if (change.is_frame)
      if (const Reason reason = mend_frame(); reason != Reason::NONE)
        return reason;
    for (std::size_t i = 0; i < change.coming.size(); ++i)
      add_vertex(change.coming[i], change.coming_points[i]);
    if (!insert_all())
      return Reason::STUCK;
    m_state.arrays.close_gaps();
    recenter();
    return Reason::NONE;
  }

  Reason mend_frame()
  {
    m_state.arrays.close_gaps();
    m_state.set_error(&m_other);
    find_unproved_in_torus(m_state, m_unproved);
    m_report.unproved = m_unproved.size();
    if (is_hopeless())
      return Reason::TOO_MUCH_BROKEN;
    find_bad();
    const std::size_t vertices = m_state.number_of_vertices();
    if (m_bad.size() > few_inverted + vertices / inverted_share)
      return Reason::TOO_MUCH_BROKEN;
    m_held.begin(mean_motion(), m_state.origin);
    const bool is_held = m_held.hold(m_bad, few_held + vertices / held_share);
    m_report.held = m_held.number();
    if (!is_held)
      return Reason::TOO_MUCH_BROKEN;
    open_illegal();
    m_flips.run();
    m_held.release();
    // only from a Delaunay triangulation can vertices be taken out, or be inserted into it
    if (!unstick() || !take_out_left())
      return Reason::STUCK;
    return part_covered();
  }

  Position_3 mean_motion() const
  {
    const double share = 1 / double(m_state.number_of_vertices());
    Position_3 sum{0, 0, 0};
    for (Vertex_index v(1); v < m_state.positions.number(); ++v)
      sum = sum + share * (m_state.positions.position(v) - m_other.position(v));
    return sum;
  }

  // Whether so many cells are broken that flips cost more than a rebuild, or get stuck. A sample
  // tells broken cells from those with ties.
  bool is_hopeless() const
  {
    if (m_unproved.size() <= few_inverted + m_state.number_of_vertices() * most_broken)
      return false;
    std::size_t broken = 0;
    for (std::size_t i = 0; i < sample; ++i)
      broken += is_broken(m_unproved[m_unproved.size() * i / sample]);
    return 2 * broken > sample;
  }
  bool is_broken(Cell_index c) const
  {
    if (!m_flips.is_positive(c))
      return true;
    for (int i = 0; i < 4; ++i)
      if (m_flips.is_illegal(Arrays::corner(c, i)))
        return true;
    return false;
  }

  void find_bad()
  {
    m_bad.clear();
    for (const Cell_index c : m_unproved)
      if (!m_flips.is_positive(c))
        m_bad.push_back(c);
  }

  // Opens the facets of cells that were not proved, each once.
  void open_illegal()
  {
    Cell_marks_3& marks = m_state.marks;
    marks.clear(m_state.arrays.number_of_cells());
    for (const Cell_index c : m_unproved)
      marks.insert(c);
    for (const Cell_index c : m_unproved)
      for (int i = 0; i < 4 && !m_state.arrays.is_free(c); ++i) {
        const Corner_index k = Arrays::corner(c, i), mirror = m_state.arrays.mirror(k);
        if (k < mirror || !marks.has(Arrays::cell_of(mirror)))
          m_flips.open(k);
      }
  }

  // Where flips are stuck, a vertex steps back, and is released again. False where that is
  // hopeless.
  bool unstick()
  {
    const std::size_t most_stuck = few_stuck + m_state.number_of_vertices() / stuck_share;
    for (int round = 0; round < rounds; ++round) {
      for (int step = 0; step < steps; ++step) {
        const std::vector<Corner_index> stuck = m_flips.take_stuck();
        if (stuck.empty())
          break;
        if (step + 1 == steps || stuck.size() > most_stuck || !m_held.retreat(stuck))
          return false;
      }
      m_held.release();
      const std::vector<Corner_index> stuck = m_flips.take_stuck();
      if (stuck.empty())
        return true;
      for (const Corner_index k : stuck)
        m_flips.remember_stuck(k);
    }
    return false;
  }

  // Takes out vertices that have not arrived.
  bool take_out_left()
  {
    std::vector<std::pair<Vertex_index, Torus_place_3>> left;
    m_held.for_each_left(
        [&](Vertex_index v, const Torus_place_3& place) { left.emplace_back(v, place); });
    for (const auto& [v, place] : left) {
      if (!m_removal.remove(v))
        return false;
      m_state.positions.set(v, place);
      m_waiting.push_back(v);
    }
    m_report.relocated += left.size();
    m_held.forget();
    return true;
  }

  // POPULATION ------------------------------------------------------------------------------------

  Point point_of(Vertex_index v) const
  {
    const Position_3& base = m_state.positions.base(v);
    return Point(base.x, base.y, base.z);
  }

  // Removes a point, with its cells if they are to be mended. False if that fails: then a rebuild
  // has to follow.
  bool remove(Point_id id, bool with_cells)
  {
    auto& ids = m_state.ids;
    const Vertex_index v = ids.vertex(id);
    if (ids.is_representative(id) && !ids.is_alone(id))
      let_another_represent(v);
    if (!ids.is_representative(id)) {
      ids.remove_covered(id);
      return true;
    }
    const bool is_removed = with_cells && m_removal.remove(v);
    if (!is_removed)
      m_state.arrays.clear_cells();
    ids.remove_representative(id);
    free_vertex(v);
    return is_removed;
  }

  void let_another_represent(Vertex_index v)
  {
    const Point_id next = m_state.ids.find_covered_at(v, [](const Point&) { return true; });
    const Point point = m_state.ids.covered_point(next);
    const Position_3 position = m_state.positions.position(v);
    m_state.ids.exchange_representative(next, point_of(v));
    m_state.positions.set(v, m_state.place_at(approximation(point), position));
  }

  // Gives the number of a vertex without points and cells to the last one.
  void free_vertex(Vertex_index v)
  {
    const Vertex_index last(m_state.number_of_vertices());
    if (v != last) {
      m_state.positions.set(v, m_state.positions.place(last));
      m_state.ids.move_points(last, v);
      if (m_state.arrays.number_of_cells() > 0 && m_state.arrays.corner_of(last) != null_index) {
        find_star(m_state.arrays, last, m_state.marks, m_star);
        m_state.arrays.renumber(last, v, m_star);
      }
    }
    m_state.ids.resize(last - 1);
    m_state.positions.resize(last);
    m_state.arrays.resize_vertices(last);
  }

  // A vertex for a point, which is reserved or covered; it waits for its cells.
  void add_vertex(Point_id id, const Point& point)
  {
    const Vertex_index v(m_state.positions.number());
    const Position_3 base = approximation(point);
    const Multiples_3 multiples = Torus_3::floor(m_state.torus.fractions(base));
    m_state.positions.resize(v + 1);
    m_state.positions.set(v, Torus_place_3(base, Multiples_3{0, 0, 0} - multiples, m_state.torus));
    m_state.arrays.resize_vertices(v + 1);
    m_state.ids.append_vertex();
    m_state.ids.place_representative(id, v);
    m_waiting.push_back(v);
  }

  // Moves one point. The vertex of a point that is alone is taken out, and waits.
  // False if that fails: then a rebuild has to follow.
  bool move(Point_id id, const Point& point, bool with_cells)
  {
    auto& ids = m_state.ids;
    const Vertex_index v = ids.vertex(id);
    if (ids.is_representative(id) && !ids.is_alone(id))
      let_another_represent(v);
    if (!ids.is_representative(id)) {
      ids.covered_point(id) = point;
      if (with_cells)
        add_vertex(id, point);
      return true;
    }
    const bool is_taken_out = with_cells && m_removal.remove(v);
    if (is_taken_out)
      m_waiting.push_back(v);
    else
      m_state.arrays.clear_cells();
    m_state.positions.set(v, m_state.place_at(approximation(point), m_state.positions.position(v)));
    return is_taken_out;
  }

  // Gives covered points that are no longer where their vertex is vertices of their own.
  Reason part_covered()
  {
    std::vector<std::pair<Point_id, Point>> parted;
    m_state.ids.for_each_covered([&](Point_id id, Vertex_index v, const Point& point) {
      if (!m_state.coincide(point, v))
        parted.emplace_back(id, point);
    });
    if (10 * parted.size() > m_state.number_of_vertices())
      return Reason::COINCIDENCE;
    std::sort(parted.begin(), parted.end(),
              [](const auto& p, const auto& q) { return p.first < q.first; });
    for (const auto& [id, point] : parted)
      add_vertex(id, point);
    m_report.parted = parted.size();
    return Reason::NONE;
  }

  // Inserts the vertices that wait; those that coincide with others are covered by them. False if
  // one is in its own way: then a rebuild has to follow.
  bool insert_all()
  {
    if (m_waiting.empty())
      return true;
    m_state.set_error(nullptr);
    Vertex_index start(1);
    while (start < m_state.positions.number() && m_state.arrays.corner_of(start) == null_index)
      ++start;
    if (start == m_state.positions.number())
      return false;
    m_insertion.start_at(start);
    std::vector<Vertex_index> free;
    for (const Vertex_index v : m_waiting)
      switch (m_insertion.insert(v)) {
      case Torus_insertion_3<State>::Result::INSERTED:
        break;
      case Torus_insertion_3<State>::Result::COINCIDES:
        m_state.ids.merge(v, m_insertion.coinciding(), point_of(v));
        free.push_back(v);
        break;
      case Torus_insertion_3<State>::Result::IS_IN_ITS_OWN_WAY:
        free_all(free);
        return false;
      }
    m_report.merged = free.size();
    free_all(free);
    return true;
  }
  // The last ones first, so that the last vertex always has points.
  void free_all(std::vector<Vertex_index>& vertices)
  {
    std::sort(vertices.begin(), vertices.end(), std::greater<Index>());
    for (const Vertex_index v : vertices)
      free_vertex(v);
  }

  // Wraps vertices into the basis' parallelepiped where one has gone far out of it, so that shifts
  // stay small.
  void recenter()
  {
    const auto is_far = [this](Vertex_index v) {
      const Position_3 f = m_state.torus.fractions(m_state.positions.position(v));
      return !((std::max)({f.x, f.y, f.z}) < 2 && (std::min)({f.x, f.y, f.z}) > -1);
    };
    bool is_one_far = false;
    for (Vertex_index v(1); v < m_state.positions.number() && !is_one_far; ++v)
      is_one_far = is_far(v);
    if (!is_one_far)
      return;
    Column<Vertex_index, Torus_shift_3> shifts(m_state.positions.number(), Torus_shift_3());
    for (Vertex_index v(1); v < m_state.positions.number(); ++v) {
      const Torus_place_3 place = m_state.positions.place(v);
      const Multiples_3 out = Torus_3::floor(m_state.torus.fractions(place.position));
      shifts[v] = Torus_shift_3::of(out);
      m_state.positions.set(v, Torus_place_3(place.base, place.multiples - out, m_state.torus));
    }
    m_state.arrays.shift_vertices(shifts);
    m_state.set_error(nullptr);
  }

  // A rebuild takes some 9 microseconds a point. Of 10,000 random points, steps of 0.18 mean
  // spacings break 3.7 cells a vertex, and are mended in 7; of lattices that are shaken more cells
  // are not proved, but fewer broken.
  static constexpr std::size_t most_broken = 6, sample = 64; // cells a vertex; cells
  static constexpr std::size_t few_inverted = 16, inverted_share = 4, few_held = 20, held_share = 8;
  static constexpr std::size_t few_stuck = 16, stuck_share = 1024; // facets
  static constexpr int rounds = 4, steps = 100;                    // of retreats from them

  State& m_state;
  bool m_is_certified = true;          // no points are triangulated
  std::vector<Point> m_points;         // of a frame, by ids
  Torus_positions_3 m_other;           // from the exchange on, those of the last frame
  std::vector<Point> m_other_covered;  // likewise
  std::optional<Torus_3> m_next_torus; // of a frame with another cell
  bool m_is_torus_new = false;         // whether the old one cannot be moved to it
  Flips m_flips;
  Held_vertices_3<State, Flips> m_held;
  Torus_insertion_3<State> m_insertion;
  Torus_removal_3<State> m_removal;
  Torus_rebuild_3<State> m_rebuild;

  Update_report_3 m_report;
  std::vector<Cell_index> m_unproved, m_bad, m_star;
  std::vector<Vertex_index> m_waiting; // without cells
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_UPDATE_3_H
