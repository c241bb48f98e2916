// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_HELD_VERTICES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_HELD_VERTICES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Lawson_flips_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Positions_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Holds vertices back until all cells are positive, and releases them later.
//
// A cell that is not positive is flipped away, if one flip makes positive cells only. Else that
// vertex of it is held whose motion differs most from its neighbors': it waits where their mean
// motion carries it from its old position, then where all vertices' mean motion does, and at last
// at its old position. If cells stay inverted even so, flips are in the way: all of them are undone
// and forbidden near these cells, and it all begins again; in the last attempt everything may
// return to its old position, where all cells were positive.
template <class State>
class Held_vertices_3
{
  using Flips = Lawson_flips_3<State>;
  using Arrays = typename State::Arrays;
  using Place = typename State::Place;
  using Positions = typename State::Positions;

public:
  Held_vertices_3(State& state, const Positions& previous, Flips& flips)
    : m_state(state)
    , m_previous(previous)
    , m_flips(flips)
  {
  }

  // Begins a frame in which all vertices move by `mean` in the mean, the origin from `old_origin`.
  void begin(const Position_3& mean, const Position_3& old_origin)
  {
    m_mean = mean;
    m_old_origin = old_origin;
    m_new_origin = m_state.origin;
    m_held.clear();
    m_number.assign(m_state.positions.number(), null_index);
    m_may_right.assign(m_state.positions.number(), 1);
  }

  void forget() { m_held.clear(); }

  std::size_t number() const { return m_held.size(); }

  // Makes all cells positive; `bad` are those that are not. Opens the facets of all cells that
  // flips have changed or that have a held vertex. False if that has failed, or if more than `most`
  // vertices would have to be held: then the frame has to be rebuilt.
  bool hold(const std::vector<Cell_index>& bad, std::size_t most)
  {
    for (int attempt = 0; attempt < attempts; ++attempt) {
      arrays().begin();
      m_bad = bad;
      if (attempt == attempts - 1)
        find_all_bad();
      m_is_last_attempt = attempt == attempts - 1;
      m_failed.clear();
      if (!right_or_hold(m_is_last_attempt ? m_state.positions.number() : most)) {
        give_up();
        return false;
      }
      if (keep_what_is_inverted(m_failed).empty()) {
        open_what_has_changed();
        arrays().commit();
        return true;
      }
      forbid_flips(attempt);
      start_anew();
    }
    give_up();
    return false;
  }

  // Moves each held vertex on to where it belongs, or half or a quarter of the way, or less in some
  // spaces, in several rounds, with flips after each move. All facets are legal before and
  // afterwards, but for stuck ones.
  void release()
  {
    for (int round = 0; round < rounds; ++round) {
      bool has_moved = false;
      for (std::size_t i = 0; i < m_held.size(); ++i)
        if (m_held[i].is_waiting)
          has_moved = release(i) || has_moved;
      if (!has_moved)
        return;
    }
  }

  // Moves a vertex of each stuck facet back, towards where all vertices' mean motion carries it,
  // and flips. False if none can move.
  bool retreat(const std::vector<Corner_index>& stuck)
  {
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
    for (const Held& held : m_held)
      m_state.positions.set(held.vertex, held.target);
  }

  // Calls f(v, place) for each vertex that has not arrived, with the place where it belongs.
  template <class Function>
  void for_each_left(const Function& f) const
  {
    for (const Held& held : m_held)
      if (!held.has_arrived)
        f(held.vertex, held.target);
  }

private:
  static constexpr int attempts = 8, rounds = 12, retreats = 3;
  // A cell of a star that cannot be righted by so few flips costs more than to wait.
  static constexpr std::size_t most_inverted = 6;

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

  Arrays& arrays() { return m_state.arrays; }
  const Arrays& arrays() const { return m_state.arrays; }
  const Position_3& position(Vertex_index v) const { return m_state.positions.position(v); }
  bool is_positive(Cell_index c) const { return m_flips.is_positive(c); }
  bool is_held(Vertex_index v) const { return m_number[v] != null_index; }

  // HOLDING ---------------------------------------------------------------------------------------

  void find_all_bad()
  {
    m_bad.clear();
    for (Cell_index c(0); c < arrays().number_of_cells(); ++c)
      if (!arrays().is_free(c) && !is_positive(c))
        m_bad.push_back(c);
  }

  // Takes up cells that are not positive until none is left. False if too many would be held.
  bool right_or_hold(std::size_t most)
  {
    while (!m_bad.empty()) {
      const Cell_index c = m_bad.back();
      if (arrays().is_free(c) || is_positive(c)) {
        m_bad.pop_back();
        continue;
      }
      if (!m_is_last_attempt && may_right(c) && right(c))
        continue;
      if (!hold_one_of(c)) {
        m_failed.push_back(c);
        m_bad.pop_back();
        continue;
      }
      if (m_held.size() > most)
        return false;
    }
    return true;
  }

  bool right(Cell_index c)
  {
    const auto flipped = m_flips.right(c);
    for (int n = 0; n < flipped.number; ++n)
      for (int i = 0; i < 4; ++i)
        if (const Cell_index other = arrays().neighbor(flipped.cells[n], i); !is_positive(other))
          m_bad.push_back(other);
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
  // that is held wait farther back. False if there is none.
  bool hold_one_of(Cell_index c)
  {
    const Vertices_3 vertices = arrays().vertices(c);
    Vertex_index strayed = null_index;
    Motion motion, largest;
    for (const Vertex_index v : vertices)
      if (v != infinite_index && !is_held(v)) {
        motion = motion_of(v);
        if (strayed == null_index || motion.residual > largest.residual) {
          strayed = v;
          largest = motion;
        }
      }
    if (strayed != null_index) {
      start_to_hold(strayed, largest);
      return true;
    }
    for (const Vertex_index v : vertices)
      if (v != infinite_index && wait_farther_back(m_held[m_number[v]]))
        return true;
    return false;
  }

  struct Motion
  {
    bool has_neighbors = false; // that are not held
    Position_3 mean{0, 0, 0};   // motion of these
    double residual = 0;        // squared distance from where they carry the vertex
    double size = 0;            // mean squared length of the edges to them, before the frame
  };

  Motion motion_of(Vertex_index v)
  {
    find_star(arrays(), v, m_state.marks, m_star);
    Motion motion;
    double number = 0;
    for (const Cell_index c : m_star) // neighbors count once for each common cell
      for (const Vertex_index w : arrays().vertices(c))
        if (w != infinite_index && w != v && !is_held(w)) {
          motion.mean = motion.mean + (position(w) - m_previous.position(w));
          motion.size += squared_length(m_previous.position(w) - m_previous.position(v));
          ++number;
        }
    if (number > 0) {
      motion.has_neighbors = true;
      motion.mean = (1 / number) * motion.mean;
      motion.size /= number;
      motion.residual = squared_length(position(v) - (m_previous.position(v) + motion.mean));
    }
    return motion;
  }

  void start_to_hold(Vertex_index v, const Motion& motion)
  {
    // one that leaves its star need not try to follow
    const bool jumps = motion.residual > 4 * motion.size;
    m_held.push_back({v, m_state.positions.place(v),
                      motion.has_neighbors ? Waits::CARRIED : Waits::AT_HOME, !jumps, false, 0});
    m_number[v] = Index(m_held.size() - 1);
    move(v, Place(beside_hull(v, m_previous.position(v) +
                                     (motion.has_neighbors ? motion.mean : m_mean))));
  }

  // Where a vertex is to wait; for one on a flat hull, in its plane: out of it, it would be the
  // only vertex there.
  Position_3 beside_hull(Vertex_index v, const Position_3& wanted)
  {
    find_star(arrays(), v, m_state.marks, m_star);
    const bool is_on_hull = std::any_of(m_star.begin(), m_star.end(),
                                        [this](Cell_index c) { return arrays().is_infinite(c); });
    return is_on_hull ? m_state.along_hull(position(v), wanted) : wanted;
  }

  bool wait_farther_back(Held& held)
  {
    if (held.waits == Waits::CARRIED) {
      held.waits = Waits::AT_HOME;
      move(held.vertex, home(held.vertex));
      return true;
    }
    if (!m_is_last_attempt || held.waits == Waits::WHERE_IT_WAS)
      return false;
    held.waits = Waits::WHERE_IT_WAS;
    move(held.vertex, m_previous.place(held.vertex));
    if (!is_same(m_state.origin, m_old_origin)) {
      m_state.origin = m_old_origin;
      find_all_bad();
    }
    return true;
  }

  static bool is_same(const Position_3& p, const Position_3& q)
  {
    return p.x == q.x && p.y == q.y && p.z == q.z;
  }

  Place home(Vertex_index v) const { return Place(m_previous.position(v) + m_mean); }

  void move(Vertex_index v, const Place& place)
  {
    m_state.positions.set(v, place);
    find_star(arrays(), v, m_state.marks, m_star);
    for (const Cell_index c : m_star)
      if (!is_positive(c))
        m_bad.push_back(c);
  }

  std::vector<Cell_index> keep_what_is_inverted(const std::vector<Cell_index>& cells) const
  {
    std::vector<Cell_index> inverted;
    for (const Cell_index c : cells)
      if (!arrays().is_free(c) && !is_positive(c))
        inverted.push_back(c);
    return inverted;
  }

  void forbid_flips(int attempt)
  {
    for (const Cell_index c : m_failed)
      if (!arrays().is_free(c))
        for (const Vertex_index v : arrays().vertices(c)) {
          m_may_right[v] = 0;
          if (attempt == 0 || v == infinite_index)
            continue;
          find_star(arrays(), v, m_state.marks, m_star);
          for (const Cell_index other : m_star)
            for (const Vertex_index w : arrays().vertices(other))
              m_may_right[w] = 0;
        }
    m_may_right[infinite_index] = 1; // else no flip of the hull would be left
  }

  void start_anew()
  {
    arrays().undo();
    m_flips.forget_open_facets();
    for (const Held& held : m_held) {
      m_state.positions.set(held.vertex, held.target);
      m_number[held.vertex] = null_index;
    }
    m_held.clear();
    m_state.origin = m_new_origin;
  }
  void give_up() { start_anew(); }

  void open_what_has_changed()
  {
    m_flips.forget_open_facets(); // those of flips that were followed by others
    arrays().for_each_changed([this](Cell_index c) { m_flips.open_cell(c); });
    for (const Held& held : m_held)
      open_star(held.vertex);
  }
  void open_star(Vertex_index v)
  {
    find_star(arrays(), v, m_state.marks, m_star);
    for (const Cell_index c : m_star)
      m_flips.open_cell(c);
  }

  // RELEASING -------------------------------------------------------------------------------------

  // Moves one vertex on. Returns whether it could move at all.
  bool release(std::size_t i)
  {
    const Vertex_index v = m_held[i].vertex;
    const Place from = m_state.positions.place(v), target = m_held[i].target;
    for (double way = 1; way >= m_state.smallest_way(); way /= 2) {
      const Place to = way == 1.0 ? target : Place(between(from.position, target.position, way));
      if (!try_to_move(v, from, to))
        continue;
      if (way == 1.0) {
        m_held[i].is_waiting = false;
        m_held[i].has_arrived = true;
      }
      open_star(v);
      m_flips.run();
      return true;
    }
    return false;
  }

  static Position_3 between(const Position_3& p, const Position_3& q, double way)
  {
    return p + way * (q - p);
  }

  // Moves a vertex, if its cells stay positive or a few flips make them so.
  bool try_to_move(Vertex_index v, const Place& from, const Place& to)
  {
    m_state.positions.set(v, to);
    find_star(arrays(), v, m_state.marks, m_star);
    m_bad.clear();
    for (const Cell_index c : m_star)
      if (!is_positive(c)) {
        m_bad.push_back(c);
        if (m_bad.size() > most_inverted) {
          m_state.positions.set(v, from);
          return false;
        }
      }
    if (m_bad.empty() || right_all_bad(v))
      return true;
    m_state.positions.set(v, from);
    return false;
  }

  bool right_all_bad(Vertex_index v)
  {
    arrays().begin();
    std::vector<Cell_index> left;
    while (!m_bad.empty()) {
      const Cell_index c = m_bad.back();
      m_bad.pop_back();
      if (!arrays().is_free(c) && !is_positive(c) && !right(c))
        left.push_back(c);
    }
    find_star(arrays(), v, m_state.marks, m_star);
    if (keep_what_is_inverted(left).empty() && keep_what_is_inverted(m_star).empty()) {
      arrays().for_each_changed([this](Cell_index c) { m_flips.open_cell(c); });
      arrays().commit();
      return true;
    }
    arrays().undo();
    m_flips.forget_open_facets();
    return false;
  }

  bool retreat(Vertex_index v)
  {
    if (is_held(v) && m_held[m_number[v]].retreats >= retreats)
      return false;
    const Place from = m_state.positions.place(v);
    if (!is_held(v)) { // before it moves: so an exception loses no position
      m_held.push_back({v, from, Waits::AT_HOME, false, true, 0});
      m_number[v] = Index(m_held.size() - 1);
    }
    const Position_3 back = beside_hull(v, home(v).position);
    for (const double way : {1.0, 0.5, 0.25}) {
      const Place to(between(from.position, back, way));
      if (is_same(to.position, from.position))
        continue;
      m_state.positions.set(v, to);
      find_star(arrays(), v, m_state.marks, m_star);
      if (!keep_what_is_inverted(m_star).empty())
        continue;
      Held& held = m_held[m_number[v]];
      held.is_waiting = true;
      held.has_arrived = false;
      ++held.retreats;
      open_star(v);
      m_flips.run();
      return true;
    }
    m_state.positions.set(v, from);
    return false;
  }

  State& m_state;
  const Positions& m_previous;
  Flips& m_flips;
  Position_3 m_mean{0, 0, 0}, m_old_origin{0, 0, 0}, m_new_origin{0, 0, 0};
  std::vector<Held> m_held;
  Column<Vertex_index, Index> m_number;   // of a held vertex in that list, else null_index
  Column<Vertex_index, char> m_may_right; // whether cells at a vertex may be flipped away
  bool m_is_last_attempt = false;
  std::vector<Cell_index> m_bad, m_failed, m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_HELD_VERTICES_3_H
