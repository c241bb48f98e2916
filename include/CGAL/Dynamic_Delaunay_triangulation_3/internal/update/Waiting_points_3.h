// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_WAITING_POINTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_WAITING_POINTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Held_vertices_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Lawson_flips_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Vertex_order_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Takes vertices out of cells that are Delaunay, and inserts points that wait, into such cells:
// those of vertices that were taken out, covered points that have parted, and new ones.
template <class Space>
class Waiting_points_3
{
  using State = typename Space::State;
  using Arrays = typename State::Arrays;
  using Point = typename State::Point;
  using Place = typename State::Place;
  using Flips = Lawson_flips_3<State>;

public:
  // Keeps the array of former positions as long as that of the state.
  Waiting_points_3(State& state, typename State::Positions& previous, Flips& flips,
                   Held_vertices_3<State>& held)
    : m_state(state)
    , m_previous(previous)
    , m_flips(flips)
    , m_held(held)
    , m_insertion(state)
    , m_removal(state)
  {
  }

  void clear()
  {
    m_pending.clear();
    m_without_cells.clear();
  }

  // Reserves memory, so that remove() throws nothing before all points are removed, and notes the
  // cells of vertices that get other representatives.
  void prepare(const Change_3<Point>& change)
  {
    m_without_cells.reserve(change.gone.size());
    if (!m_state.spans_space || !m_state.arrays.history().is_on())
      return;
    for (const std::vector<Point_id>* ids : {&change.gone, &change.moved})
      for (const Point_id id : *ids)
        if (m_state.ids.is_representative(id) && !m_state.ids.is_alone(id)) {
          find_star(m_state.arrays, m_state.ids.vertex(id), m_state.marks, m_star);
          m_state.arrays.note_star(m_star);
        }
  }

  // Removes points, then their vertices from the cells if these are to be mended. False if that has
  // failed.
  bool remove(const std::vector<Point_id>& gone, bool is_mending)
  {
    for (const Point_id id : gone)
      if (const Vertex_index v = remove_point(id); v != null_index)
        m_without_cells.push_back(v);
    return !is_mending || std::all_of(m_without_cells.begin(), m_without_cells.end(),
                                      [this](Vertex_index v) { return take_out(v); });
  }

  // Moves points alone: a short way with the cells around them; others are taken out, and wait to
  // be inserted.
  bool move(const Change_3<Point>& change, bool is_mending)
  {
    bool is_right = true;
    for (std::size_t i = 0; i < change.moved.size(); ++i)
      is_right =
          move_point(change.moved[i], change.moved_points[i], is_mending && is_right) && is_right;
    return is_right;
  }

  // Takes out a vertex, which belongs to this place. False if that has failed.
  bool take_out_for_long_way(Vertex_index v, const Place& place)
  {
    const Vertex_index beside = some_neighbor(v);
    if (!take_out(v))
      return false;
    set_place(v, place);
    m_pending.push_back({v, m_state.ids.representative(v), place, beside});
    return true;
  }

  // Points that no longer are where their representative is wait to be inserted. Returns their
  // number.
  std::size_t part_covered()
  {
    const std::size_t before = m_pending.size();
    for (const Point_id id : m_state.ids.covered_ids()) {
      const Point& point = m_state.ids.covered_point(id);
      const Vertex_index v = m_state.ids.vertex(id);
      if (!m_state.coincide(point, v))
        m_pending.push_back({null_index, id, m_state.place_near(point, v), v});
    }
    return m_pending.size() - before;
  }

  void wait(Point_id id, const Point& point)
  {
    m_pending.push_back({null_index, id, m_state.place_of(point), null_index});
  }

  // Inserts all that wait. Then each vertex has cells. False if that has failed.
  bool insert_all()
  {
    m_merged = 0;
    sort_pending();
    m_first_new = null_index;
    m_has_start = false;
    for (const Pending& pending : m_pending) {
      if (m_first_new == null_index && pending.beside == null_index)
        m_first_new = Vertex_index(m_state.positions.number());
      if (!insert(pending))
        return false;
    }
    drop_vertices_without_cells();
    return true;
  }
  // How many of the vertices that were taken out have been found to coincide with others.
  std::size_t number_of_merged() const { return m_merged; }

private:
  // A point that waits to be inserted: of a vertex that has no cells, or a new one.
  struct Pending
  {
    Vertex_index vertex; // null_index if the point has none
    Point_id id;
    Place place;
    Vertex_index beside; // a vertex to start the search at, or null_index
  };

  void set_place(Vertex_index v, const Place& place)
  {
    m_state.positions.set(v, place);
    m_state.include(place);
  }

  // TAKING OUT ------------------------------------------------------------------------------------

  // Returns the vertex that has lost its last point, or null_index.
  Vertex_index remove_point(Point_id id)
  {
    auto& ids = m_state.ids;
    if (!ids.is_representative(id)) {
      ids.remove_covered(id);
      return null_index;
    }
    const Vertex_index v = ids.vertex(id);
    const Point_id heir = ids.find_covered_at(v, [](const Point&) { return true; });
    if (heir != null_index) {
      let_represent(heir, v);
      ids.remove_covered(id);
      return null_index;
    }
    ids.remove_representative(id);
    return v;
  }

  // Lets a covered point represent its vertex, which stays where it is.
  void let_represent(Point_id heir, Vertex_index v)
  {
    const Place place = m_state.place_near(m_state.ids.covered_point(heir), v);
    m_state.ids.exchange_representative(heir, m_state.point(v));
    set_place(v, place);
  }

  bool move_point(Point_id id, const Point& point, bool is_mending)
  {
    auto& ids = m_state.ids;
    const Vertex_index v = ids.vertex(id);
    const auto is_here = [&](const Point& p) { return m_state.coincide(p, v); };
    const Place place = m_state.place_near(point, v);
    m_state.note_move(
        id, ids.is_representative(id) ? Point(m_state.point(v)) : ids.covered_point(id), point, v);
    if (is_here(point)) {
      if (ids.is_representative(id))
        set_place(v, place); // another image
      else
        ids.covered_point(id) = point;
      return true;
    }
    if (ids.is_representative(id)) // covered points that have been moved cannot stand in for it
      if (const Point_id heir = ids.find_covered_at(v, is_here); heir != null_index)
        let_represent(heir, v);
    if (!ids.is_representative(id)) {
      ids.covered_point(id) = point;
      m_pending.push_back({null_index, id, place, v});
      return true;
    }
    m_state.include(place);
    if (is_mending && move_within_star(v, place))
      return true;
    const Vertex_index beside = is_mending ? some_neighbor(v) : Vertex_index(null_index);
    const bool is_right = !is_mending || take_out(v);
    m_state.positions.set(v, place);
    m_pending.push_back({v, id, place, beside});
    return is_right;
  }

  // Moves a vertex whose finite cells stay positive, and flips. As their border does not move, they
  // cover what they did, once. So do infinite ones of a slab. False, and nothing has changed, if a
  // cell is infinite in other spaces, or inverted, or if flips are stuck.
  bool move_within_star(Vertex_index v, const Place& place)
  {
    Arrays& arrays = m_state.arrays;
    find_star(arrays, v, m_state.marks, m_star);
    const Place before = m_state.positions.place(v);
    m_state.positions.set(v, place);
    const bool is_inside = std::all_of(m_star.begin(), m_star.end(), [&](Cell_index c) {
      return (m_state.goes_on_to_cover_once() || !arrays.is_infinite(c)) && m_flips.is_positive(c);
    });
    if (is_inside) {
      arrays.forget_safe_cells(m_star);
      arrays.begin();
      for (const Cell_index c : m_star)
        m_flips.open_cell(c);
      m_flips.run();
      if (m_flips.take_stuck().empty()) {
        arrays.commit();
        return true;
      }
      arrays.undo();
    }
    m_state.positions.set(v, before);
    return false;
  }

  bool take_out(Vertex_index v)
  {
    if (!m_removal.remove(v, m_flips) && !take_out_from_inside(v))
      return false;
    m_flips.run();
    return m_flips.take_stuck().empty();
  }
  // Where images of a vertex are in each other's way, as on the hull of a wire, it goes inside, as
  // far as it has to. With many cells, such as those of flat walls, it hardly ever gets there.
  bool take_out_from_inside(Vertex_index v)
  {
    constexpr std::size_t most_cells = 256;
    find_star(m_state.arrays, v, m_state.marks, m_star);
    return m_star.size() <= most_cells && m_held.lead(v, m_state.beneath_hull(v, m_star),
                                                      [&] { return m_removal.remove(v, m_flips); });
  }

  Vertex_index some_neighbor(Vertex_index v) const
  {
    for (const Vertex_index w :
         m_state.arrays.vertices(Arrays::cell_of(m_state.arrays.corner_of(v))))
      if (w != v && w != infinite_index)
        return w;
    return null_index;
  }

  // INSERTION -------------------------------------------------------------------------------------

  // New ones come last, along a curve.
  void sort_pending()
  {
    std::vector<Pending> fresh;
    std::vector<Position_3> places;
    const auto first_new =
        std::stable_partition(m_pending.begin(), m_pending.end(),
                              [](const Pending& p) { return p.beside != null_index; });
    for (auto p = first_new; p != m_pending.end(); ++p) {
      fresh.push_back(*p);
      places.push_back(p->place.position);
    }
    std::size_t n = 0;
    for (const Index i : Order_along_curve_3<typename State::Parts>(places).run())
      *(first_new + std::ptrdiff_t(n++)) = fresh[i];
  }

  // False if the images of a point are in each other's way.
  bool insert(const Pending& pending)
  {
    const Vertex_index v = pending.vertex != null_index ? pending.vertex : append_vertex(pending);
    start_near(pending);
    const Vertex_index other = m_insertion.insert(v, m_flips);
    if (other == v)
      return false;
    if (other != null_index)
      merge(pending, v, other);
    else if (pending.vertex == null_index)
      m_state.ids.place_representative(pending.id, v);
    return true;
  }

  // A point that waits is where another vertex is.
  void merge(const Pending& pending, Vertex_index v, Vertex_index other)
  {
    auto& ids = m_state.ids;
    m_without_cells.push_back(v);
    if (pending.vertex == null_index) {
      ids.place_covered(pending.id, other, m_state.point_at(pending.place));
      if (other >= m_first_new && pending.id < ids.representative(other))
        let_represent(pending.id, other);
      return;
    }
    ids.reserve_for_covered(1);
    ids.merge(v, other, m_state.point_at(pending.place));
    ++m_merged;
  }

  Vertex_index append_vertex(const Pending& pending)
  {
    const Vertex_index v(m_state.positions.number());
    m_state.ids.reserve_for_vertices(1);
    m_state.positions.resize(v + 1);
    m_previous.resize(v + 1);
    m_state.arrays.resize_vertices(v + 1);
    m_state.ids.append_vertex(); // throws nothing
    set_place(v, pending.place);
    return v;
  }

  // The search starts at the vertex that is named, if it has cells, or else at the last insertion.
  void start_near(const Pending& pending)
  {
    const Arrays& arrays = m_state.arrays;
    if (pending.beside != null_index && has_cells(pending.beside))
      m_insertion.start_at(Arrays::cell_of(arrays.corner_of(pending.beside)));
    else if (!std::exchange(m_has_start, true) || m_insertion.last() >= arrays.number_of_cells() ||
             arrays.is_free(m_insertion.last()))
      m_insertion.start_at(closest_of_sample(pending.place.position));
  }

  // Jump and walk (Mücke, Saias and Zhu 1996): a cell of the closest of n^(1/4) vertices.
  Cell_index closest_of_sample(const Position_3& target) const
  {
    const Index vertices = m_state.arrays.number_of_vertices();
    std::size_t number = 1;
    while (number * number * number * number < vertices)
      ++number;
    Cell_index closest = null_index;
    double smallest = 0;
    for (std::size_t i = 0; i <= number; ++i)
      if (const Vertex_index v(1 + (vertices - 1) * i / (number + 1));
          v < vertices && has_cells(v)) {
        const double distance = squared_length(m_state.positions.position(v) - target);
        if (closest == null_index || distance < smallest) {
          closest = Arrays::cell_of(m_state.arrays.corner_of(v));
          smallest = distance;
        }
      }
    for (Cell_index c(0); closest == null_index; ++c)
      if (!m_state.arrays.is_free(c))
        closest = c;
    return closest;
  }
  bool has_cells(Vertex_index v) const
  {
    const Corner_index k = m_state.arrays.corner_of(v);
    return k != null_index && Arrays::cell_of(k) < m_state.arrays.number_of_cells() &&
           !m_state.arrays.is_free(Arrays::cell_of(k)) && m_state.arrays.vertex(k) == v;
  }

  // The last vertices take the numbers of those that have no points any more.
  void drop_vertices_without_cells()
  {
    std::sort(m_without_cells.begin(), m_without_cells.end());
    for (std::size_t i = m_without_cells.size(); i-- > 0;) {
      const Vertex_index v = m_without_cells[i], last(m_state.positions.number() - 1);
      if (v != last) {
        find_star(m_state.arrays, last, m_state.marks, m_star);
        m_state.arrays.renumber(last, v, m_star);
        m_state.positions.set(v, m_state.positions.place(last));
        m_state.ids.move_points(last, v);
      }
      m_state.ids.resize(last - 1);
      m_state.arrays.pop_vertex();
      m_state.positions.resize(last);
      m_previous.resize(last);
    }
    m_without_cells.clear();
  }

  State& m_state;
  typename State::Positions& m_previous;
  Flips& m_flips;
  Held_vertices_3<State>& m_held;
  typename Space::Insertion m_insertion;
  typename Space::Removal m_removal;
  std::vector<Pending> m_pending;
  std::vector<Vertex_index> m_without_cells; // vertices that have lost their points
  Vertex_index m_first_new;                  // from here on, vertices are of new points
  bool m_has_start = false;                  // the last insertion is close to the next one
  std::size_t m_merged = 0;
  std::vector<Cell_index> m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_WAITING_POINTS_3_H
