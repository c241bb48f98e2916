// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHTS_AT_PLACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHTS_AT_PLACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Point_location_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/State_with_place_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Weight_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The faces whose circles contain a place, and the border around them: a point inserted there
// would replace these faces. The place must be inside of the hull, and at no vertex. Then the faces
// form a tree, and all of their corners are on the border.
template <class State>
class Cavity_2
{
  using Arrays = Halfedge_arrays_2;
  using Chart = typename State::Chart;

public:
  using Site = typename State::Site;

  // `places` are those of the corners in the border; the border's size can stand for 0.
  struct Face
  {
    std::array<Site, 3> corners;
    std::array<std::size_t, 3> places;
  };

  const Kept_list<Face>& faces() const { return m_faces; }
  // Counterclockwise.
  const Kept_list<Site>& border() const { return m_border; }

  // Begins with face f, which contains the place, boundary included; `chart` is as seen from there.
  void find(const State& state, Face_index f, const Chart& chart)
  {
    m_faces.clear();
    m_border.clear();
    Face face;
    for (Index i = 0; i < 3; ++i) {
      const Halfedge_index side = Arrays::halfedge_in(f, (i + 2) % 3); // begins at corner i
      face.corners[i] = state.site_in(Arrays::halfedge_in(f, i), chart);
      face.places[i] = m_border.size();
      go_around(state, side, chart);
    }
    m_faces.push_back(face);
  }

private:
  // A face that was entered across `halfedge`, one of its own, from a face with `outer_chart`.
  struct Entry
  {
    Halfedge_index halfedge;
    Chart chart, outer_chart;
    std::size_t begin, middle; // the places of the half-edge's target and apex
  };

  // Lists the border beyond half-edge h of a face in the cavity, from its source to before its
  // target, and the faces up to there.
  void go_around(const State& state, Halfedge_index h, Chart chart)
  {
    for (;;) {
      const Halfedge_index entry = state.arrays().twin(h);
      const Chart beyond = state.chart_beyond(h, chart);
      if (is_in_cavity(state, entry, beyond)) {
        m_entries.push_back({entry, beyond, chart, m_border.size(), 0});
        h = Arrays::next(entry);
        chart = beyond;
        continue;
      }
      m_border.push_back(state.site_in(Arrays::next(h), chart));
      while (!m_entries.empty() && h == Arrays::previous(m_entries.back().halfedge)) {
        h = state.arrays().twin(m_entries.back().halfedge);
        chart = m_entries.back().outer_chart;
        leave(state, m_entries.back());
        m_entries.pop_back();
      }
      if (m_entries.empty())
        return;
      m_entries[m_entries.size() - 1].middle = m_border.size();
      h = Arrays::previous(m_entries.back().halfedge);
    }
  }

  void leave(const State& state, const Entry& entry)
  {
    const Halfedge_index h = entry.halfedge;
    m_faces.push_back({{state.site_in(h, entry.chart), state.site_in(Arrays::next(h), entry.chart),
                        state.site_in(Arrays::previous(h), entry.chart)},
                       {entry.middle, m_border.size(), entry.begin}});
  }

  static bool is_in_cavity(const State& state, Halfedge_index h, const Chart& chart)
  {
    const Face_index f = Arrays::face_of(h);
    if (state.is_outside(f))
      return false;
    const auto corner = [&](Index i) { return state.site_in(Arrays::halfedge_in(f, i), chart); };
    return state.side_of_circle(corner(0), corner(1), corner(2), State::site_of(null_index)) ==
           ON_POSITIVE_SIDE;
  }

  Kept_list<Face> m_faces;
  Kept_list<Site> m_border;
  Kept_list<Entry> m_entries;
};

// A point with its weight.
struct Weighted_id_2
{
  std::pair<Index, Periodic_shift_2> id_and_shift;
  double weight;

  friend bool operator<(const Weighted_id_2& a, const Weighted_id_2& b)
  {
    return a.id_and_shift.first != b.id_and_shift.first
               ? a.id_and_shift.first < b.id_and_shift.first
               : a.id_and_shift.second < b.id_and_shift.second;
  }
};

// Computes the weights of the points around places, one place after the other.
template <class Dynamic>
class Weights_at_place_2
{
  using Arrays = Halfedge_arrays_2;
  using State = State_with_place_2<Dynamic>;
  using Site = typename State::Site;

public:
  using Point = typename Dynamic::Point;

  // No weight is off by more.
  static constexpr double largest_error = 1e-12;

  explicit Weights_at_place_2(const Dynamic& dt)
    : m_state(dt)
    , m_rounded(m_state)
  {
  }
  Weights_at_place_2(const Weights_at_place_2& other)
    : m_state(other.m_state)
    , m_rounded(m_state)
  {
  }
  Weights_at_place_2& operator=(const Weights_at_place_2&) = delete;

  // Writes all weights, in no particular order; none if the place is outside of the hull. `number`
  // is what errors call the place.
  template <class OutputIterator>
  void natural_neighbors(const Point& p, std::size_t number, OutputIterator weights)
  {
    if (!locate(p, number) || write_at_vertex(weights))
      return;
    const Halfedge_index h = edge_with_place();
    if (h != null_index && m_state.is_outside(Arrays::face_of(m_state.arrays().twin(h))))
      return write_on_edge(h, weights);
    m_cavity.find(m_state, m_place.face, m_place.chart);
    const auto& border = m_cavity.border();
    const std::size_t size = border.size();
    write(
        size, [&](std::size_t i) { return border[i]; },
        [&](auto& parts) {
          const auto begin = [&](std::size_t place) { return place == size ? 0 : place; };
          for (const auto& [corners, places] : m_cavity.faces())
            parts.add_face(corners, {begin(places[0]), begin(places[1]), begin(places[2])}, 1);
          for (std::size_t i = 0; i < size; ++i) {
            const std::size_t next = i + 1 < size ? i + 1 : 0;
            parts.add_face({here(), border[i], border[next]}, {size, i, next}, -1);
          }
        },
        weights);
  }

  template <class OutputIterator>
  void linear(const Point& p, std::size_t number, OutputIterator weights)
  {
    if (!locate(p, number) || write_at_vertex(weights))
      return;
    if (const Halfedge_index h = edge_with_place(); h != null_index)
      return write_on_edge(h, weights);
    const std::array<Site, 3> corners{corner(first_halfedge()), corner(first_halfedge() + 1),
                                      corner(first_halfedge() + 2)};
    write(
        3, [&](std::size_t i) { return corners[i]; },
        [&](auto& parts) { parts.add_triangle(here(), corners); }, weights);
  }

private:
  static Site here() { return State::site_of(null_index); }
  Halfedge_index first_halfedge() const { return Arrays::halfedge_in(m_place.face, 0); }
  Site corner(Halfedge_index h) const { return m_state.site_in(h, m_place.chart); }

  // False if the place is outside of the hull.
  bool locate(const Point& p, std::size_t number)
  {
    m_state.set_place(p, number);
    if (m_state.arrays().number_of_faces() == 0)
      return false;
    const bool is_near = m_state.rounded_squared_distance(null_index, m_last) <= m_near;
    m_place = Point_location_2<State>(m_state).locate(null_index, m_last,
                                                      is_near ? 0 : m_state.number_of_vertices());
    if (m_state.is_outside(m_place.face))
      return false;
    // To a next place that is few edges away, walking is faster than searching for a better start.
    constexpr double few = 8;
    double ignored = 0;
    const Position_2 side =
        m_state.vector(corner(first_halfedge()), corner(first_halfedge() + 1), ignored);
    m_last = m_state.arrays().apex(first_halfedge());
    m_near = few * few * dot(side, side);
    return true;
  }

  // The half-edge of m_place.face that the place is on, or `null_index`.
  Halfedge_index edge_with_place() const
  {
    if (!m_place.is_inside)
      for (Halfedge_index h = first_halfedge(); h < first_halfedge() + 3; ++h)
        if (m_state.orientation(corner(Arrays::next(h)), corner(Arrays::previous(h)), here()) ==
            COLLINEAR)
          return h;
    return null_index;
  }

  template <class OutputIterator>
  bool write_at_vertex(OutputIterator weights) const
  {
    if (m_place.vertex == null_index)
      return false;
    for (Halfedge_index h = first_halfedge(); h < first_halfedge() + 3; ++h)
      if (m_state.coincide(here(), corner(h)))
        *weights++ = Weighted_id_2{m_state.id_and_shift(corner(h)), 1};
    return true;
  }

  template <class OutputIterator>
  void write_on_edge(Halfedge_index h, OutputIterator weights)
  {
    const std::array<Site, 2> ends{corner(Arrays::next(h)), corner(Arrays::previous(h))};
    write(
        2, [&](std::size_t i) { return ends[i]; },
        [&](auto& parts) { parts.add_edge(here(), ends[0], ends[1]); }, weights);
  }

  // Writes the weights of corners whose parts `add` adds up, exactly if doubles are too imprecise.
  template <class Site_of, class Add, class OutputIterator>
  void write(std::size_t size, const Site_of& site_of, const Add& add, OutputIterator weights)
  {
    const auto write_all = [&](const std::vector<double>& values) {
      for (std::size_t i = 0; i < size; ++i)
        *weights++ = Weighted_id_2{m_state.id_and_shift(site_of(i)), values[i]};
    };
    m_rounded.start(size);
    add(m_rounded);
    if (m_rounded.normalize(largest_error))
      return write_all(m_rounded.weights());
    Exact_weight_parts_2<State> exact(m_state, size);
    add(exact);
    write_all(exact.weights());
  }

  State m_state;
  Rounded_weight_parts_2<State> m_rounded;
  Place_2<State> m_place;
  Cavity_2<State> m_cavity;
  Vertex_index m_last = 1; // near the last place
  double m_near = -1;      // the squared distance to walk from there at most
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHTS_AT_PLACE_2_H
