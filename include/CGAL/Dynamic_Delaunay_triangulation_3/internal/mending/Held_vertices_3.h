// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_HELD_VERTICES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_HELD_VERTICES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Divided_list.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Flip_parts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Lawson_flips_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Spatial_parts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Positions_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Holds vertices back until all cells are positive, and releases them later.
//
// A cell that is not positive is flipped away, if one flip makes positive cells only. Else that
// vertex of it is held whose motion differs most from its neighbors': it waits where their mean
// motion carries it from its old position, then where all vertices' mean motion does, and at last
// at its old position. If cells stay inverted even so, flips are in the way: those around these
// cells are undone, and forbidden near them, and it goes on. In the last attempt there are no flips
// at all, and everything may return to its old position, where all cells were positive.
//
// Where there is much to do, threads do it in parts of space first, as they were before the frame.
// A part takes up a cell if it has the vertices of the cell and of its neighbors, and moves a
// vertex if it has all neighbors of it. So no other part reads the position: all cells that another
// one reads have three vertices there, or are at a vertex there. What that leaves is done in turn.
template <class State>
class Held_vertices_3
{
  using Flips = Lawson_flips_3<State>;
  using Arrays = typename State::Arrays;
  using Place = typename State::Place;
  using Division = typename Flips::Division;
  using Parts = typename State::Exact_parts;
  template <class Element>
  using Divided_list = Dynamic_Delaunay_triangulations_2::internal::Divided_list<Element>;
  using Positions = typename State::Positions;

public:
  Held_vertices_3(State& state, const Positions& previous, Flips& flips)
    : m_state(state)
    , m_previous(previous)
    , m_flips(flips)
    , m_whole(flips)
  {
  }

  // Begins a frame in which all vertices move by `mean` in the mean, the origin from `old_origin`.
  void begin(const Position_3& mean, const Position_3& old_origin)
  {
    m_mean = mean;
    m_old_origin = old_origin;
    m_new_origin = m_state.origin;
    forget();
  }

  // Gives memory back, too: five bytes a vertex, which calm frames do not need.
  void forget()
  {
    m_whole.held.clear();
    m_parts.clear();
    m_number = Column<Vertex_index, Index>();
    m_may_right = Column<Vertex_index, char>();
  }

  std::size_t number() const { return m_whole.held.size(); }

  // Makes all cells positive; `bad` are those that are not. Opens the facets of all cells that
  // flips have changed or that have a held vertex. False if that has failed, or if more than `most`
  // vertices would have to be held: then the frame has to be rebuilt.
  bool hold(const std::vector<Cell_index>& bad, std::size_t most)
  {
    if (!bad.empty()) {
      make_room();
      m_state.find_walls();
    }
    arrays().begin();
    m_whole.bad = bad;
    m_whole.failed.clear();
    m_is_last_attempt = false;
    right_or_hold_in_parts(most);
    for (int attempt = 0; attempt < attempts_with_flips && number() <= most; ++attempt) {
      if (!right_or_hold(m_whole, most))
        break;
      m_whole.failed = keep_what_is_inverted(m_whole.failed);
      if (m_whole.failed.empty())
        return commit();
      undo_around_failed(attempt);
    }
    const bool are_too_many = number() > most;
    start_anew();
    return !are_too_many && hold_without_flips();
  }

  // Moves each held vertex on to where it belongs, or half or a quarter of the way, or less in some
  // spaces, in several rounds, with flips after each move. All facets are legal before and
  // afterwards, but for stuck ones. Where they are many, threads release them in parts first.
  void release()
  {
    release_in_parts();
    const std::vector<Index> waiting = waiting_ones();
    release(m_whole, waiting);
  }

  // Leads a vertex, which is not waiting, towards a place in a few steps, each of which may be very
  // small, until is_enough() is true. All facets are legal before and after each. Returns whether
  // it got so far; if this throws, the vertex is where it was.
  template <class Predicate>
  bool lead(Vertex_index v, const Position_3& to, const Predicate& is_enough)
  {
    constexpr int most_steps = 20;
    constexpr double smallest_way = 0x1p-20;
    const Place before = m_state.positions.place(v);
    Held led{v, Place(to), Waits::CARRIED, true, false, 0};
    try {
      for (int step = 0; step < most_steps && !led.has_arrived; ++step) {
        if (!release(m_whole, led, smallest_way) || !m_flips.take_stuck().empty())
          return false;
        if (is_enough())
          return true;
      }
    } catch (...) {
      m_state.positions.set(v, before);
      throw;
    }
    return false;
  }

  // Moves a vertex of each stuck facet back, towards where all vertices' mean motion carries it,
  // and flips. False if none can move.
  bool retreat(const std::vector<Corner_index>& stuck)
  {
    make_room();
    bool has_moved = false;
    std::vector<Vertex_index> obstacles;
    for (const Corner_index k : stuck)
      if (!arrays().is_free(Arrays::cell_of(k))) {
        m_flips.remember_stuck(k);
        if (has_moved)
          continue;
        obstacles.clear();
        m_flips.append_obstacles(k, obstacles);
        for (const Vertex_index v : arrays().vertices(Arrays::cell_of(k)))
          obstacles.push_back(v);
        obstacles.push_back(arrays().apex(k));
        for (const Vertex_index v : obstacles)
          if (v != infinite_index && retreat(v)) {
            has_moved = true;
            break;
          }
      }
    return has_moved;
  }

  // Puts all vertices where they belong, whatever becomes of their cells.
  void bring_to_targets()
  {
    for (const Held& held : m_whole.held)
      m_state.positions.set(held.vertex, held.target);
    for (const Work& part : m_parts) // which an exception has left
      for (const Held& held : part.held)
        m_state.positions.set(held.vertex, held.target);
  }

  // Calls f(v, place) for each vertex that has not arrived, with the place where it belongs.
  template <class Function>
  void for_each_left(const Function& f) const
  {
    for (const Held& held : m_whole.held)
      if (!held.has_arrived)
        f(held.vertex, held.target);
  }

private:
  static constexpr int attempts_with_flips = 7, rounds = 12, retreats = 3;
  // A cell of a star that cannot be righted by so few flips costs more than to wait.
  static constexpr std::size_t most_inverted = 6;
  static constexpr std::size_t few_cells = 64; // free ones, with which a part begins
  // A part of those that threads find: each takes some 500 nanoseconds.
  static constexpr std::size_t least_stars = Parts::size_for(256);
  // To right a cell, or to hold or release a vertex, takes as long as to test and flip so many.
  static constexpr std::size_t facets_of_cell = 8;

  enum class Waits { CARRIED, AT_HOME, WHERE_IT_WAS };

  struct Held
  {
    Vertex_index vertex;
    Place target;
    Waits waits;
    bool is_waiting; // false if it has arrived, or goes so far that it is taken out at once
    bool has_arrived;
    int retreats;
  };

  // What is held, and what is to be done, in all or in a part.
  struct alignas(64) Work
  {
    explicit Work(Flips& flips_there)
      : flips(flips_there)
    {
    }

    Flips& flips;
    std::size_t first = 0; // number of the first of those that are held
    std::vector<Held> held;
    std::vector<Cell_index> bad; // cells that may not be positive
    std::vector<Cell_index> failed;
    std::vector<Cell_index> left; // that a part leaves to others
    std::vector<Cell_index> star;
    Cell_set_3 in_star;
    bool needs_others = false; // whether a part could not right a cell because of its neighbors
  };

  enum class Outcome { HELD, FAILED, LEFT };

  void make_room()
  {
    if (!m_number.empty())
      return;
    m_number.assign(m_state.positions.number(), null_index);
    m_may_right.assign(m_state.positions.number(), 1);
  }

  Arrays& arrays() { return m_state.arrays; }
  const Arrays& arrays() const { return m_state.arrays; }
  const Position_3& position(Vertex_index v) const { return m_state.positions.position(v); }
  static bool is_positive(const Work& work, Cell_index c) { return work.flips.is_positive(c); }
  bool is_held(Vertex_index v) const { return m_number[v] != null_index; }

  // HOLDING ---------------------------------------------------------------------------------------

  void find_all_bad()
  {
    m_whole.bad.clear();
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c)
      if (!arrays().is_free(c) && !is_positive(m_whole, c))
        m_whole.bad.push_back(c);
  }

  // Takes up cells that are not positive until none is left. False if too many would be held.
  bool right_or_hold(Work& work, std::size_t most)
  {
    while (!work.bad.empty()) {
      prefetch_around(m_state, 0, work.bad.size(),
                      [&](std::size_t n) { return work.bad[work.bad.size() - 1 - n]; });
      const Cell_index c = work.bad.back();
      if (arrays().is_free(c) || is_positive(work, c)) {
        work.bad.pop_back();
        continue;
      }
      const bool is_mine = work.flips.is_around_mine(c) && work.flips.is_mine_with_neighbors(c);
      if (is_mine && !m_is_last_attempt && may_right(c) && right(work, c))
        continue;
      const Outcome outcome = is_mine ? hold_one_of(work, c) : Outcome::LEFT;
      if (outcome != Outcome::HELD) {
        (outcome == Outcome::FAILED ? work.failed : work.left).push_back(c);
        work.bad.pop_back();
      } else if (work.held.size() > most) {
        return false;
      }
    }
    return true;
  }

  // Many parts have many stars at their borders. Of 10,000 points too many are at those of few
  // ones: one thread would take a fifth longer.
  std::vector<typename Division::Numbers> divisions() const
  {
    constexpr std::size_t few = 8 * Parts::least_shared * Parts::usual_size, many = 2 * few;
    if (arrays().number_of_cells() < few)
      return {};
    if (arrays().number_of_cells() < many)
      return {{2, 2, 2}, {3, 3, 1}, {1, 1, 3}};
    return {{3, 3, 3}, {2, 2, 2}, {1, 1, 3}};
  }

  // Where many cells are not positive, does the same in parts, which threads share, until four
  // times a part's share of `most` is held. Others remain.
  void right_or_hold_in_parts(std::size_t most)
  {
    divide_while_worth(
        m_state, m_previous, divisions(), [&] { return facets_of_cell * m_whole.bad.size(); },
        [&](const Division& division) {
          Divided_list<Cell_index> bad;
          divide_bad(division, bad);
          run_in_parts(
              division, [&](std::size_t part) { return bad.size(part); },
              [&](Work& work, std::size_t part) {
                work.bad.assign(bad.begin(part), bad.end(part));
                right_or_hold(work, 4 * most / division.number());
              });
        });
  }

  // Divides the cells by the parts that have all their vertices, and most likely their neighbors.
  // Others remain.
  void divide_bad(const Division& division, Divided_list<Cell_index>& of_parts)
  {
    std::vector<Cell_index>& bad = m_whole.bad;
    const std::size_t none = division.number();
    of_parts.template divide<Parts>(bad, none + 1, [&](std::size_t i) {
      prefetch_around<false>(m_state, bad, i);
      if (arrays().is_free(bad[i])) // others have changed it since, and have taken it up
        return none;
      const Vertices_3& v = arrays().vertices(bad[i]);
      const std::size_t part = division.part_of(v[0] == infinite_index ? v[1] : v[0]);
      return division.has_around(part, v) ? part : none;
    });
    bad.assign(of_parts.begin(none), of_parts.end(none));
  }

  // Calls f(work, part) for all parts, which have pieces(part) of work each, on threads.
  template <class Pieces, class Function>
  void run_in_parts(const Division& division, const Pieces& pieces, const Function& f)
  {
    std::vector<Flips> flips(division.number(), Flips(m_state));
    for (std::size_t part = 0; part < division.number(); ++part) {
      flips[part].begin_part(division, part);
      m_parts.emplace_back(flips[part]);
      m_parts[part].first = m_whole.held.size();
    }
    arrays().template begin_parts<typename State::Parts>(
        division.number(), [&](std::size_t part) { return few_cells + pieces(part) / 2; });
    Parts::run_long(division.number(), [&](std::size_t part) { f(m_parts[part], part); });
    arrays().end_parts();
    for (const Work& part : m_parts)
      take_over(part);
    m_parts.clear();
  }
  void take_over(const Work& part)
  {
    for (const Held& held : part.held) {
      m_number[held.vertex] = Index(m_whole.held.size());
      m_whole.held.push_back(held);
    }
    m_whole.bad.insert(m_whole.bad.end(), part.bad.begin(), part.bad.end());
    m_whole.bad.insert(m_whole.bad.end(), part.left.begin(), part.left.end());
    m_whole.failed.insert(m_whole.failed.end(), part.failed.begin(), part.failed.end());
    m_flips.append_left(part.flips);
  }

  bool right(Work& work, Cell_index c)
  {
    const auto flipped = work.flips.right(c);
    for (int n = 0; n < flipped.number; ++n)
      for (int i = 0; i < 4; ++i)
        if (const Cell_index other = arrays().neighbor(flipped.cells[n], i);
            !is_positive(work, other))
          work.bad.push_back(other);
    return flipped.number > 0;
  }

  bool may_right(Cell_index c) const
  {
    for (int i = 0; i < 4; ++i)
      if (!m_may_right[arrays().vertices(c)[i]] ||
          !m_may_right[arrays().apex(Arrays::corner(c, i))])
        return false;
    return true;
  }

  // Holds that vertex of a cell whose motion differs most from its neighbors', or else lets one
  // that is held wait farther back. FAILED if there is none, LEFT if a part does not have all cells
  // of such vertices.
  Outcome hold_one_of(Work& work, Cell_index c)
  {
    const Vertices_3 vertices = arrays().vertices(c);
    Vertex_index strayed = null_index;
    Motion motion, largest;
    for (const Vertex_index v : vertices)
      if (v != infinite_index && !is_held(v)) {
        motion = motion_of(work, v);
        if (!motion.is_mine)
          return Outcome::LEFT;
        if (strayed == null_index || motion.residual > largest.residual) {
          strayed = v;
          largest = motion;
        }
      }
    if (strayed != null_index) {
      start_to_hold(work, strayed, largest);
      return Outcome::HELD;
    }
    for (const Vertex_index v : vertices)
      if (v != infinite_index && can_wait_farther_back(held_of(work, v))) {
        find_star(work, v);
        if (is_in_part(work) && !is_star_mine(work))
          return Outcome::LEFT;
        wait_farther_back(work, held_of(work, v));
        return Outcome::HELD;
      }
    return Outcome::FAILED;
  }

  Held& held_of(Work& work, Vertex_index v)
  {
    const std::size_t n = m_number[v];
    return n < work.first ? m_whole.held[n] : work.held[n - work.first];
  }

  // Whether the part may move the vertex whose star this is: all neighbors are of the part, too.
  bool is_star_mine(const Work& work) const
  {
    return std::all_of(work.star.begin(), work.star.end(), [&](Cell_index c) {
      const Vertices_3& v = arrays().vertices(c);
      return std::all_of(v.begin(), v.end(), [&](Vertex_index w) { return work.flips.is_mine(w); });
    });
  }

  static bool is_in_part(const Work& work) { return work.flips.part() != Arrays::whole; }

  void find_star(Work& work, Vertex_index v) const
  {
    internal::find_star(arrays(), v, work.in_star, work.star);
  }

  struct Motion
  {
    bool has_neighbors = false; // that are not held
    Position_3 mean{0, 0, 0};   // motion of these
    double residual = 0;        // squared distance from where they carry the vertex
    double size = 0;            // mean squared length of the edges to them, before the frame
    bool is_on_hull = false;
    bool is_mine = true; // all neighbors belong to the part; else nothing else is known
  };

  Motion motion_of(Work& work, Vertex_index v) const
  {
    find_star(work, v);
    Motion motion;
    motion.is_mine = !is_in_part(work) || is_star_mine(work);
    if (!motion.is_mine)
      return motion;
    double number = 0;
    for (const Cell_index c : work.star) // neighbors count once for each common cell
      for (const Vertex_index w : arrays().vertices(c)) {
        motion.is_on_hull = motion.is_on_hull || w == infinite_index;
        if (w != infinite_index && w != v && !is_held(w)) {
          motion.mean = motion.mean + (position(w) - m_previous.position(w));
          motion.size += squared_length(m_previous.position(w) - m_previous.position(v));
          ++number;
        }
      }
    if (number > 0) {
      motion.has_neighbors = true;
      motion.mean = (1 / number) * motion.mean;
      motion.size /= number;
      motion.residual = squared_length(position(v) - (m_previous.position(v) + motion.mean));
    }
    return motion;
  }

  void start_to_hold(Work& work, Vertex_index v, const Motion& motion)
  {
    // one that leaves its star need not try to follow
    const bool jumps = motion.residual > 4 * motion.size;
    work.held.push_back({v, m_state.positions.place(v),
                         motion.has_neighbors ? Waits::CARRIED : Waits::AT_HOME, !jumps, false, 0});
    m_number[v] = Index(work.first + work.held.size() - 1);
    Position_3 wanted = m_previous.position(v) + (motion.has_neighbors ? motion.mean : m_mean);
    if (motion.is_on_hull) { // on a flat one it waits in its plane: out of it, it would be alone
      find_star(work, v);
      wanted = along_hull(work, work.held.back(), wanted);
    } else {
      wanted = m_state.between_walls(wanted, position(v));
    }
    move(work, v, Place(wanted));
  }
  // A place on the hull near to another one, where a vertex may wait whose star has been found.
  Position_3 along_hull(const Work& work, const Held& held, const Position_3& wanted) const
  {
    const Position_3 kept = on_wall(held, wanted);
    return is_same(kept, wanted) ? m_state.along_hull(position(held.vertex), wanted, work.star)
                                 : kept;
  }
  Position_3 on_wall(const Held& held, const Position_3& wanted) const
  {
    return m_state.on_wall(m_previous.position(held.vertex), held.target.position, wanted);
  }

  bool can_wait_farther_back(const Held& held) const
  {
    return held.waits == Waits::CARRIED || (m_is_last_attempt && held.waits == Waits::AT_HOME);
  }
  void wait_farther_back(Work& work, Held& held)
  {
    if (held.waits == Waits::CARRIED) {
      held.waits = Waits::AT_HOME;
      move(work, held.vertex,
           motion_of(work, held.vertex).is_on_hull
               ? Place(on_wall(held, home(held.vertex).position))
               : Place(m_state.between_walls(home(held.vertex).position, held.target.position)));
      return;
    }
    held.waits = Waits::WHERE_IT_WAS;
    move(work, held.vertex, m_previous.place(held.vertex));
    if (!is_same(m_state.origin, m_old_origin)) {
      m_state.origin = m_old_origin;
      find_all_bad();
    }
  }

  Place home(Vertex_index v) const { return Place(m_previous.position(v) + m_mean); }

  void move(Work& work, Vertex_index v, const Place& place)
  {
    m_state.positions.set(v, place);
    find_star(work, v);
    for (const Cell_index c : work.star)
      if (!is_positive(work, c))
        work.bad.push_back(c);
  }

  std::vector<Cell_index> keep_what_is_inverted(const std::vector<Cell_index>& cells) const
  {
    return keep_what_is_inverted(m_whole, cells);
  }
  std::vector<Cell_index> keep_what_is_inverted(const Work& work,
                                                const std::vector<Cell_index>& cells) const
  {
    std::vector<Cell_index> inverted;
    for (const Cell_index c : cells)
      if (!arrays().is_free(c) && !is_positive(work, c))
        inverted.push_back(c);
    return inverted;
  }

  // Undoes the flips around cells that have failed, and forbids them near these.
  void undo_around_failed(int attempt)
  {
    for (const Cell_index c : m_whole.failed)
      forbid_flips(c, attempt > 0);
    m_may_right[infinite_index] = 1; // else no flip of the hull would be left
    m_whole.bad.swap(m_whole.failed);
    m_whole.failed.clear();
    arrays().undo_around(m_whole.bad, m_state.marks);
  }
  void forbid_flips(Cell_index c, bool also_beside)
  {
    for (const Vertex_index v : arrays().vertices(c)) {
      m_may_right[v] = 0;
      if (!also_beside || v == infinite_index)
        continue;
      find_star(m_whole, v);
      for (const Cell_index other : m_whole.star)
        for (const Vertex_index w : arrays().vertices(other))
          m_may_right[w] = 0;
    }
  }

  // The last attempt, in which everything may return to its old position.
  bool hold_without_flips()
  {
    arrays().begin();
    m_whole.failed.clear();
    m_is_last_attempt = true;
    find_all_bad();
    right_or_hold(m_whole, m_state.positions.number());
    if (keep_what_is_inverted(m_whole.failed).empty())
      return commit();
    start_anew();
    return false;
  }
  bool commit()
  {
    open_what_has_changed();
    arrays().commit();
    return true;
  }
  void start_anew()
  {
    arrays().undo();
    for (const Held& held : m_whole.held) {
      m_state.positions.set(held.vertex, held.target);
      m_number[held.vertex] = null_index;
    }
    m_whole.held.clear();
    m_state.origin = m_new_origin;
  }

  // Opens the facets of all cells that have changed, on threads. A flip records each of its cells
  // some seven times.
  void open_what_has_changed()
  {
    std::vector<Cell_index> changed, of_held;
    Dynamic_Delaunay_triangulations_2::internal::append_by_parts<Parts>(
        number(), least_stars, of_held,
        [&](std::size_t i, std::size_t beyond, std::vector<Cell_index>& cells) {
          std::vector<Cell_index> star;
          Cell_set_3 in_star;
          for (; i < beyond; ++i) {
            internal::find_star(arrays(), m_whole.held[i].vertex, in_star, star);
            cells.insert(cells.end(), star.begin(), star.end());
          }
        });
    const auto append_to_changed = [&](auto& marks) {
      marks.clear(arrays().number_of_cells());
      const auto append = [&](Cell_index c) {
        if (marks.insert(c))
          changed.push_back(c);
      };
      arrays().for_each_changed(append);
      std::for_each(of_held.begin(), of_held.end(), append);
    };
    if (of_held.size() + arrays().number_of_changes() < arrays().number_of_cells() / 64)
      append_to_changed(m_whole.in_star); // marks take memory of all cells
    else
      append_to_changed(m_state.marks);
    Flip_parts_3<State>(m_state).open(m_flips, changed);
  }

  // RELEASING -------------------------------------------------------------------------------------

  std::vector<Index> waiting_ones() const
  {
    std::vector<Index> waiting;
    for (std::size_t i = 0; i < m_whole.held.size(); ++i)
      if (m_whole.held[i].is_waiting)
        waiting.push_back(Index(i));
    return waiting;
  }

  // Threads release vertices whose neighbors are of one part.
  void release_in_parts()
  {
    std::vector<Index> waiting = waiting_ones();
    divide_while_worth(
        m_state, m_previous, divisions(), [&] { return facets_of_cell * waiting.size(); },
        [&](const Division& division) {
          Divided_list<Index> of_parts;
          of_parts.template divide<Parts>(waiting, division.number(), [&](std::size_t i) {
            return division.part_of(m_whole.held[waiting[i]].vertex);
          });
          run_in_parts(
              division, [](std::size_t) { return std::size_t(0); },
              [&](Work& work, std::size_t part) {
                release_inside(work, of_parts.begin(part), of_parts.end(part));
              });
          m_flips.run();
          waiting = waiting_ones();
        });
  }

  // Those whose stars are of the part, as they remain.
  void release_inside(Work& work, const Index* first, const Index* beyond)
  {
    std::vector<Index> inside;
    for (; first != beyond; ++first) {
      find_star(work, m_whole.held[*first].vertex);
      if (is_star_mine(work))
        inside.push_back(*first);
    }
    release(work, inside);
  }

  void release(Work& work, std::vector<Index> waiting)
  {
    for (int round = 0; round < rounds; ++round) {
      bool has_moved = false;
      std::size_t kept = 0;
      for (const Index i : waiting) {
        const bool moves = release(work, m_whole.held[i], m_state.smallest_way());
        has_moved = has_moved || moves;
        if (m_whole.held[i].is_waiting && !work.needs_others)
          waiting[kept++] = i;
      }
      waiting.resize(kept);
      if (!has_moved)
        return;
    }
  }

  // Moves one vertex on, at least by this share of its way. Returns whether it could move at all.
  bool release(Work& work, Held& held, double smallest_way)
  {
    work.needs_others = false;
    const Vertex_index v = held.vertex;
    const Place from = m_state.positions.place(v), target = held.target;
    find_star(work, v);
    for (double way = 1; way >= smallest_way; way /= 2) {
      const Place to = way == 1.0 ? target : Place(between(from.position, target.position, way));
      if (!try_to_move(work, v, from, to)) {
        if (work.needs_others)
          return false;
        continue;
      }
      if (way == 1.0) {
        held.is_waiting = false;
        held.has_arrived = true;
      }
      flip_star(work);
      return true;
    }
    return false;
  }
  void flip_star(Work& work)
  {
    for (const Cell_index c : work.star)
      work.flips.open_cell(c);
    work.flips.run();
  }

  static Position_3 between(const Position_3& p, const Position_3& q, double way)
  {
    return p + way * (q - p);
  }

  // Moves a vertex, whose star has been found, if its cells stay positive or a few flips make them
  // so; then that is its new star.
  bool try_to_move(Work& work, Vertex_index v, const Place& from, const Place& to)
  {
    m_state.positions.set(v, to);
    work.bad.clear();
    for (const Cell_index c : work.star)
      if (!is_positive(work, c)) {
        work.bad.push_back(c);
        if (work.bad.size() > most_inverted) {
          m_state.positions.set(v, from);
          return false;
        }
      }
    if (work.bad.empty() || right_all_bad(work, v))
      return true;
    m_state.positions.set(v, from);
    return false;
  }

  bool right_all_bad(Work& work, Vertex_index v)
  {
    const std::size_t part = work.flips.part();
    arrays().begin(part);
    std::vector<Cell_index> left;
    while (!work.bad.empty()) {
      const Cell_index c = work.bad.back();
      work.bad.pop_back();
      if (arrays().is_free(c) || is_positive(work, c))
        continue;
      if (!work.flips.is_mine_with_neighbors(c)) {
        work.needs_others = true;
        left.push_back(c);
      } else if (!right(work, c)) {
        left.push_back(c);
      }
    }
    find_star(work, v);
    if (keep_what_is_inverted(work, left).empty() &&
        keep_what_is_inverted(work, work.star).empty()) {
      work.in_star.clear(arrays().number_of_cells());
      arrays().for_each_changed(
          [&](Cell_index c) {
            if (work.in_star.insert(c))
              work.flips.open_cell(c);
          },
          part);
      arrays().commit(part);
      return true;
    }
    arrays().undo(part);
    find_star(work, v);
    return false;
  }

  bool retreat(Vertex_index v)
  {
    if (is_held(v) && m_whole.held[m_number[v]].retreats >= retreats)
      return false;
    const Place from = m_state.positions.place(v);
    if (!is_held(v)) { // before it moves: so an exception loses no position
      m_whole.held.push_back({v, from, Waits::AT_HOME, false, true, 0});
      m_number[v] = Index(m_whole.held.size() - 1);
    }
    const Position_3 wanted = home(v).position;
    const Position_3 back = motion_of(m_whole, v).is_on_hull
                                ? along_hull(m_whole, m_whole.held[m_number[v]], wanted)
                                : wanted;
    for (const double way : {1.0, 0.5, 0.25}) {
      const Place to(between(from.position, back, way));
      if (is_same(to.position, from.position))
        continue;
      m_state.positions.set(v, to);
      find_star(m_whole, v);
      if (!keep_what_is_inverted(m_whole.star).empty())
        continue;
      Held& held = m_whole.held[m_number[v]];
      held.is_waiting = true;
      held.has_arrived = false;
      ++held.retreats;
      flip_star(m_whole);
      return true;
    }
    m_state.positions.set(v, from);
    return false;
  }

  State& m_state;
  const Positions& m_previous;
  Flips& m_flips;
  Position_3 m_mean{0, 0, 0}, m_old_origin{0, 0, 0}, m_new_origin{0, 0, 0};
  Work m_whole;
  std::vector<Work> m_parts;              // while threads share them
  Column<Vertex_index, Index> m_number;   // of a held vertex in its list, else null_index
  Column<Vertex_index, char> m_may_right; // whether cells at a vertex may be flipped away
  bool m_is_last_attempt = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_HELD_VERTICES_3_H
