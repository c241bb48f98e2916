// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_UPDATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_UPDATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Flip_parts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Held_vertices_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Calm_frames_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/State_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_set_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Chosen_rebuilds_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Waiting_points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/update/Whole_rebuild_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Update_report_3.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Changes points, and makes their triangulation Delaunay again. The phases of a frame, in order:
// points that go are taken out; all others move; a pass finds what floating point does not prove;
// cells that are not positive are flipped away, or one of their vertices is held; facets that are
// not legal are flipped; held vertices are released; one ray proves that the cells cover space
// once; vertices that cannot arrive are taken out; what was taken out, has parted from others, or
// is new is inserted. Whatever fails ends in a rebuild.
//
// A space is open space or a torus. It says which tools the phases use: `State`, `Insertion`,
// `Removal`, `Static`, which triangulates from scratch, and `Proof`.
template <class Space>
class Update_3
{
  using State = typename Space::State;
  using Arrays = typename State::Arrays;
  using Point = typename State::Point;
  using Place = typename State::Place;
  using Reason = Rebuild_reason_2;
  using Parts = typename State::Parts;
  using Phases = typename State::Phases;
  using Flips = Lawson_flips_3<State>;

public:
  using Frame = Dynamic_frame_3<State>;
  using Chosen_rebuilds = Chosen_rebuilds_3<State>;

  explicit Update_3(State& state)
    : m_state(state)
    , m_flips(state)
    , m_flip_parts(state)
    , m_held(state, m_other.positions, m_flips)
    , m_waiting(state, m_other.positions, m_flips, m_held)
    , m_rebuild(state)
    , m_proof(state)
  {
  }

  bool is_certified() const { return m_is_certified; }

  // Takes over what is known of the other update's state, a copy of which is this one's.
  void take_over(const Update_3& other)
  {
    m_is_certified = other.m_is_certified;
    m_calm_frames = other.m_calm_frames;
    m_other.positions.resize(m_state.positions.number());
  }

  // The positions of a frame, to be filled before run().
  typename State::Staged& staged() { return m_other; }

  // Proves the triangulation again. If that fails, the next call rebuilds.
  bool certify();

  // What is wrong with the triangulation, or null.
  const char* problem() const;

  // Reserves the memory in which a change removes points. If it throws, nothing has changed; after
  // it, run() removes all points that go, or throws nothing.
  void reserve(const Change_3<Point>& change);

  // The present frame, between calls.
  Frame frame() const { return Frame(m_state, m_other.positions); }

  // If memory does not suffice to begin, or the policy throws in a frame of points that stay,
  // nothing changes. If either happens later, there are no cells, each point is where it was or
  // where it belongs, and the next call rebuilds.
  Update_report_3 run(const Change_3<Point>& change, const Chosen_rebuilds& chosen = {});

private:
  void run_phases(const Change_3<Point>& change, bool is_chosen, bool was_certified,
                  const Chosen_rebuilds& chosen)
  {
    Reason reason = is_chosen ? Reason::POLICY : reason_not_to_mend(change, was_certified);
    if (!m_waiting.remove(change.gone, reason == Reason::NONE) ||
        !m_waiting.move(change, reason == Reason::NONE))
      reason = Reason::STUCK;
    m_report.removed = change.gone.size();
    m_report.inserted = change.coming.size();
    if (change.positions != nullptr)
      stage(*change.positions);
    m_state.ids.reserve(change.coming);
    if (change.is_frame) {
      m_other.exchange(m_state);
      m_other.note_exchange(m_state);
    }
    if (reason == Reason::NONE && change.positions != nullptr && chosen.include(frame()))
      reason = Reason::POLICY;
    if (reason == Reason::NONE)
      reason = mend(change);
    if (reason == Reason::NONE)
      return;
    m_held.bring_to_targets();
    m_rebuild.run(change, reason == Reason::POPULATION || reason == Reason::DIMENSION);
    m_report.rebuild_reason = reason;
    m_report.merged = m_report.parted = 0;
  }

  // Whether the policy is asked.
  bool is_choice(const Change_3<Point>& change, bool was_certified) const
  {
    return change.is_frame && reason_not_to_mend(change, was_certified) == Reason::NONE;
  }
  // Asks it at the new positions, before anything changes.
  bool is_chosen_before(const Chosen_rebuilds& chosen)
  {
    m_other.exchange(m_state);
    try {
      const bool is_chosen = chosen.include(frame());
      m_other.exchange(m_state);
      return is_chosen;
    } catch (...) {
      m_other.exchange(m_state);
      throw;
    }
  }

  // Removing a point costs some eleven insertions: where 8 percent of 100,000 points go and as many
  // come, mending takes 0.95 of the time of a rebuild, where 9 percent do, 1.1 (./dev bench space).
  Reason reason_not_to_mend(const Change_3<Point>& change, bool was_certified) const
  {
    if (!m_state.spans_space)
      return Reason::DIMENSION;
    if (!was_certified || !m_state.has_origin || (change.is_frame && !m_other.can_mend()))
      return Reason::STUCK;
    if (11 * (change.gone.size() + change.moved.size()) + change.coming.size() >
        m_state.number_of_vertices())
      return Reason::POPULATION;
    return Reason::NONE;
  }

  // MOTION ----------------------------------------------------------------------------------------

  // Stages a frame in which points have gone, now that the others have their numbers. What is left
  // of the cells fills the gaps, as a pass expects it.
  void stage(const std::vector<Point>& positions)
  {
    m_state.arrays.close_gaps();
    Input_3<State>::stage(positions.begin(), positions.end(),
                          boost::typed_identity_property_map<Point>(), m_state, m_other);
  }

  Reason mend(const Change_3<Point>& change)
  {
    if (change.is_frame)
      if (const Reason reason = mend_frame(); reason != Reason::NONE)
        return reason;
    for (std::size_t i = 0; i < change.coming.size(); ++i)
      m_waiting.wait(change.coming[i], change.coming_points[i]);
    if (!m_waiting.insert_all())
      return Reason::STUCK;
    m_report.merged = m_waiting.number_of_merged();
    m_state.arrays.close_gaps();
    m_state.end_change();
    return Reason::NONE;
  }

  Reason mend_frame()
  {
    m_other.carry(m_state);
    m_report.parted = m_waiting.part_covered();
    const Position_3 old_origin = m_state.origin, mean = mean_motion();
    if (!m_state.begin_frame(mean, m_other.positions))
      return Reason::STUCK;
    Phases::enter("classify");
    m_calm_frames.find_unproved(m_state, m_other.positions,
                                {mean, old_origin, !m_other.has_other_cell()}, m_unproved);
    m_report.unproved = m_unproved.finite.size();
    if (is_hopeless())
      return Reason::TOO_MUCH_BROKEN;
    Phases::enter("examine");
    examine_unproved(old_origin);
    const std::size_t vertices = m_state.number_of_vertices();
    if (m_examined.bad.size() > few_inverted + vertices / inverted_share)
      return Reason::TOO_MUCH_BROKEN;
    Phases::enter("hold");
    m_held.begin(mean, old_origin);
    const bool is_held = m_held.hold(m_examined.bad, few_held + vertices / held_share);
    m_report.held = m_held.number();
    if (!is_held)
      return Reason::TOO_MUCH_BROKEN;
    Phases::enter("flip");
    open_illegal();
    m_flip_parts.run(m_flips);
    Phases::enter("release");
    m_held.release();
    Phases::enter("rest");
    // only from a Delaunay triangulation can vertices be taken out, or be inserted into it
    if (!unstick() || !go_on_to_cover_once())
      return Reason::STUCK;
    return take_out_left() ? Reason::NONE : Reason::STUCK;
  }

  // Of the cells that were not proved.
  struct Examined_cells
  {
    void append(Cell_index c, bool is_positive) { (is_positive ? positive : bad).push_back(c); }
    void append(const Examined_cells& others)
    {
      bad.insert(bad.end(), others.bad.begin(), others.bad.end());
      positive.insert(positive.end(), others.positive.begin(), others.positive.end());
      hull_was_in_sight = hull_was_in_sight && others.hull_was_in_sight;
    }
    std::vector<Cell_index> bad, positive; // an inverted or flat cell is bad
    bool hull_was_in_sight = true;
  };

  Position_3 mean_motion() const
  {
    const std::size_t vertices = m_state.number_of_vertices();
    const double share = 1 / double(vertices);
    std::array<Position_3, Parts::max_parts> sums{};
    Parts::for_each(vertices, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      Position_3 sum{0, 0, 0};
      for (Vertex_index v(first + 1); v <= beyond; ++v)
        sum = sum + share * (m_state.positions.position(v) - m_other.positions.position(v));
      sums[part] = sum;
    });
    Position_3 sum{0, 0, 0};
    for (const Position_3& part : sums)
      sum = sum + part;
    return sum;
  }

  // Tells the cells that are not positive from others, on threads. Leaves out infinite cells that
  // are right.
  void examine_unproved(const Position_3& old_origin)
  {
    m_examined = Examined_cells();
    for (const std::vector<Cell_index>* cells : {&m_unproved.finite, &m_unproved.infinite})
      append_by_parts<typename State::Exact_parts>(
          cells->size(), least_tested_3<Parts>(cells->size()),
          [&](std::size_t i, std::size_t beyond, Examined_cells& examined) {
            const typename Flips::Signs signs(m_state);
            const Hull_pass_3<State> hull = m_calm_frames.hull_pass(m_state);
            for (; i < beyond; ++i) {
              const Cell_index c = (*cells)[i];
              if (cells == &m_unproved.infinite) {
                prefetch_around<true>(m_state, *cells, i);
                if (is_right(hull, c, old_origin, examined))
                  continue;
              } else {
                prefetch_around<false>(m_state, *cells, i);
              }
              examined.append(c, signs.is_positive(m_state.arrays.sites(c)));
            }
          },
          m_examined);
    if (State::mends_by_cells) {
      std::sort(m_examined.bad.begin(), m_examined.bad.end());
      std::sort(m_examined.positive.begin(), m_examined.positive.end());
    }
  }
  // Whether an infinite cell is right; it gets its slack. One whose slack of sight is more than the
  // way of this frame was positive all the way.
  bool is_right(const Hull_pass_3<State>& hull, Cell_index c, const Position_3& old_origin,
                Examined_cells& examined)
  {
    const auto answer = hull.answer(c);
    m_state.arrays.safe_cells().learn_slack(c, answer.lasting_slack());
    examined.hull_was_in_sight &= answer.slack_of_sight > m_calm_frames.way();
    return answer.slack > 0 ||
           (!m_other.has_other_cell() &&
            hull.has_rested(m_state, m_other.positions, old_origin, c)) ||
           hull.is_right(c);
  }
  // Whether cells, which are all positive, go on to cover space once. They do where the hull has
  // not met the origin: all infinite cells have been positive all along the straight ways of this
  // frame, and then before and after each flip. Else the proof has to look.
  bool go_on_to_cover_once()
  {
    return (m_examined.hull_was_in_sight && m_held.number() == 0) || m_proof.go_on_to_cover_once();
  }
  // Whether so many cells are broken that flips cost more than a rebuild, or get stuck, as after
  // the first motion of a lattice. A sample tells broken cells from those with ties.
  bool is_hopeless() const
  {
    const std::vector<Cell_index>& unproved = m_unproved.finite;
    const double most =
        double(few_inverted) + State::most_broken * double(m_state.arrays.number_of_cells());
    if (!m_state.positions_are_exact || double(unproved.size()) <= most)
      return false;
    std::size_t broken = 0;
    for (std::size_t i = 0; i < sample; ++i)
      broken += is_broken(unproved[unproved.size() * i / sample]);
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

  // Opens the facets of cells that were not proved, each once.
  void open_illegal()
  {
    const std::size_t number = m_examined.bad.size() + m_examined.positive.size();
    if (number < m_state.arrays.number_of_cells() / 64) // marks take memory of all cells
      open_illegal(m_seen);
    else
      open_illegal(m_state.marks);
  }
  template <class Marks>
  void open_illegal(Marks& marks)
  {
    marks.clear(m_state.arrays.number_of_cells());
    for (const std::vector<Cell_index>* cells : {&m_examined.bad, &m_examined.positive})
      for (const Cell_index c : *cells)
        marks.insert(c);
    const auto is_first = [&](Corner_index k) {
      const Corner_index mirror = m_state.arrays.mirror(k);
      return k < mirror || !marks.has(Arrays::cell_of(mirror));
    };
    for (const std::vector<Cell_index>* cells : {&m_examined.bad, &m_examined.positive})
      m_flip_parts.open(m_flips, *cells, is_first);
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
      std::vector<Corner_index> stuck = m_flips.take_stuck();
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
    std::vector<std::pair<Vertex_index, Place>> left;
    m_held.for_each_left([&](Vertex_index v, const Place& place) { left.emplace_back(v, place); });
    for (const auto& [v, place] : left)
      if (!m_waiting.take_out_for_long_way(v, place))
        return false;
    m_report.relocated += left.size();
    m_held.forget(); // all are where they belong; insertion may give others their numbers
    return true;
  }

  static constexpr std::size_t sample = 64; // cells
  static constexpr std::size_t few_inverted = 16, inverted_share = 4, few_held = 20, held_share = 8;
  static constexpr std::size_t few_stuck = 16, stuck_share = 1024; // facets
  static constexpr int rounds = 4, steps = 100;                    // of retreats from them

  State& m_state;
  bool m_is_certified = true;     // no points are triangulated
  typename State::Staged m_other; // from the exchange on, those of the last frame
  Calm_frames_3<State> m_calm_frames;
  Flips m_flips;
  Flip_parts_3<State> m_flip_parts;
  Held_vertices_3<State> m_held;
  Waiting_points_3<Space> m_waiting;
  Whole_rebuild_3<Space> m_rebuild;
  typename Space::Proof m_proof;

  Update_report_3 m_report;
  Unproved_cells_3 m_unproved;
  Examined_cells m_examined;
  Cell_set_3 m_seen; // by a step of the update
};

// Defined outside of the class, so that they are not inline: where they are declared extern,
// compilers leave out all that they call, which is most of the package (`compiled_updates.h`).
template <class Space>
bool Update_3<Space>::certify()
{
  m_is_certified = m_is_certified && m_proof.holds(m_unproved);
  return m_is_certified;
}

template <class Space>
const char* Update_3<Space>::problem() const
{
  if (!m_is_certified && !m_state.spans_space)
    return "there are no cells: an exception has ended the last call";
  return m_proof.problem();
}

template <class Space>
void Update_3<Space>::reserve(const Change_3<Point>& change)
{
  m_state.ids.reserve_for_removals(change.gone.size() + change.coming.size());
  m_state.ids.reserve_for_covered(change.coming.size() + change.moved.size());
  m_waiting.prepare(change);
}

template <class Space>
Update_report_3 Update_3<Space>::run(const Change_3<Point>& change, const Chosen_rebuilds& chosen)
{
  reserve(change);
  const bool is_chosen =
      is_choice(change, m_is_certified) && change.positions == nullptr && is_chosen_before(chosen);
  m_report = Update_report_3();
  m_flips.clear();
  m_held.forget();
  m_waiting.clear();
  const bool was_certified = std::exchange(m_is_certified, false);
  try {
    run_phases(change, is_chosen, was_certified, chosen);
  } catch (...) {
    m_held.bring_to_targets();
    m_state.drop_cells();
    throw;
  }
  m_report.flips += m_flips.number_of_flips();
  m_flips.clear();
  m_held.forget();
  m_state.marks = Cell_marks_3();
  m_unproved = Unproved_cells_3();
  m_examined = Examined_cells();
  m_report.certified = m_is_certified = true;
  return m_report;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_UPDATE_3_H
