// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHTS_AT_POINT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHTS_AT_POINT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Point_location_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Query_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Weight_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The faces whose circles contain a query point, and the border around them: a point inserted there
// would replace these faces. The query point must be inside of the hull, and at no vertex. Then the
// faces form a tree, and all of their corners are on the border.
template <class State>
class Cavity_2
{
  using Arrays = Halfedge_arrays_2;
  using Query = Query_2<State>;
  using Chart = typename State::Chart;

public:
  using Site = typename State::Site;

  // `numbers` are those of the corners in the border; the border's size can stand for 0.
  struct Face
  {
    std::array<Site, 3> corners;
    std::array<std::size_t, 3> numbers;
  };

  const Kept_list<Face>& faces() const { return m_faces; }
  // Counterclockwise.
  const Kept_list<Site>& border() const { return m_border; }

  // Begins with face f, which contains the query point, boundary included; `chart` is as seen from
  // there.
  void find(const Query& query, Face_index f, const Chart& chart)
  {
    m_faces.clear();
    m_border.clear();
    Face face;
    for (Index i = 0; i < 3; ++i) {
      const Halfedge_index side = Arrays::halfedge_in(f, (i + 2) % 3); // begins at corner i
      face.corners[i] = query.state().site_in(Arrays::halfedge_in(f, i), chart);
      face.numbers[i] = m_border.size();
      go_around(query, side, chart);
    }
    m_faces.push_back(face);
  }

private:
  // A face that was entered across `halfedge`, one of its own, from a face with `outer_chart`.
  struct Entry
  {
    Halfedge_index halfedge;
    Chart chart, outer_chart;
    std::size_t begin, middle; // the numbers of the half-edge's target and apex in the border
  };

  // Lists the border beyond half-edge h of a face in the cavity, from its source to before its
  // target, and the faces up to there.
  void go_around(const Query& query, Halfedge_index h, Chart chart)
  {
    const State& state = query.state();
    for (;;) {
      const Halfedge_index entry = state.arrays().twin(h);
      const Chart beyond = state.chart_beyond(h, chart);
      if (is_in_cavity(query, Arrays::face_of(entry), beyond)) {
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

  static bool is_in_cavity(const Query& query, Face_index f, const Chart& chart)
  {
    const auto& geometry = query.geometry();
    if (is_outside(geometry, f))
      return false;
    const auto corner = [&](Index i) {
      return query.state().site_in(Arrays::halfedge_in(f, i), chart);
    };
    return geometry.side_of_circle(corner(0), corner(1), corner(2), query.point()) ==
           ON_POSITIVE_SIDE;
  }

  Kept_list<Face> m_faces;
  Kept_list<Site> m_border;
  Kept_list<Entry> m_entries;
};

// A point with its weight.
struct Weighted_id_2
{
  Point_id id;
  Periodic_shift_2 shift;
  double weight;

  friend bool operator<(const Weighted_id_2& a, const Weighted_id_2& b)
  {
    return a.id != b.id ? a.id < b.id : a.shift < b.shift;
  }
};

// Computes the weights of the points around query points, one query point after the other.
template <class Dynamic>
class Weights_at_point_2
{
  using Arrays = Halfedge_arrays_2;
  using State = State_of_2<Dynamic>;
  using Site = typename State::Site;
  using Query = Query_2<State>;
  static_assert(Site_geometry_2<State>::has_euclidean_circles,
                "these traits have circles of their own, and areas are those of Euclidean ones");

public:
  using Geometry = Site_geometry_2<State>;
  using Point = typename Dynamic::Point;

  // No weight is off by more.
  static constexpr double largest_error = 1e-12;

  // Throws unless the triangulation is certified.
  explicit Weights_at_point_2(const Dynamic& dt)
    : m_geometry(certified_state(dt))
    , m_rounded(m_geometry)
  {
  }

  // Writes all weights, in no particular order; none if p is outside of the hull. `number` is what
  // errors call p.
  template <class OutputIterator>
  void natural_neighbors(const Point& p, std::size_t number, OutputIterator weights)
  {
    const Query query(state(), p, number);
    if (!locate(query) || write_at_vertex(query, weights))
      return;
    const Halfedge_index h = edge_with(query);
    if (h != null_index && is_outside(m_geometry, Arrays::face_of(state().arrays().twin(h))))
      return write_on_edge(query, h, weights);
    m_cavity.find(query, m_location.face, m_location.chart);
    const auto& border = m_cavity.border();
    const std::size_t size = border.size();
    const auto add = [&](auto& parts) {
      const auto wrapped = [&](std::size_t i) { return i == size ? 0 : i; };
      for (const auto& [corners, numbers] : m_cavity.faces())
        parts.add_face(corners[0], corners[1], corners[2],
                       {wrapped(numbers[0]), wrapped(numbers[1]), wrapped(numbers[2])}, 1);
      for (std::size_t i = 0; i < size; ++i) {
        const std::size_t next = wrapped(i + 1);
        parts.add_face(query.point(), border[i], border[next], {size, i, next}, -1);
      }
    };
    write(border, add, weights);
  }

  template <class OutputIterator>
  void linear(const Point& p, std::size_t number, OutputIterator weights)
  {
    const Query query(state(), p, number);
    if (!locate(query) || write_at_vertex(query, weights))
      return;
    if (const Halfedge_index h = edge_with(query); h != null_index)
      return write_on_edge(query, h, weights);
    const std::array<Site, 3> corners{corner(first_halfedge()), corner(first_halfedge() + 1),
                                      corner(first_halfedge() + 2)};
    write(
        corners, [&](auto& parts) { parts.add_triangle(query.point(), corners); }, weights);
  }

private:
  const State& state() const { return m_geometry.state(); }
  Halfedge_index first_halfedge() const { return Arrays::halfedge_in(m_location.face, 0); }
  Site corner(Halfedge_index h) const { return state().site_in(h, m_location.chart); }

  // False if the query point is outside of the hull.
  bool locate(const Query& query)
  {
    if (state().arrays().number_of_faces() == 0)
      return false;
    const bool is_near = query.rounded_squared_distance(m_last) <= m_near;
    m_location =
        Point_location_2(state(), query).locate(m_last, is_near ? 0 : state().number_of_vertices());
    if (is_outside(m_geometry, m_location.face))
      return false;
    // To a next point that is few edges away, walking is faster than searching for a better start.
    constexpr double few = 8;
    double ignored = 0;
    const Position_2 side =
        m_geometry.vector(corner(first_halfedge()), corner(first_halfedge() + 1), ignored);
    m_last = state().arrays().apex(first_halfedge());
    m_near = few * few * dot(side, side);
    return true;
  }

  // The half-edge of the face that the query point is on, or `null_index`.
  Halfedge_index edge_with(const Query& query) const
  {
    if (!m_location.is_inside)
      for (Halfedge_index h = first_halfedge(); h < first_halfedge() + 3; ++h)
        if (query.orientation(corner(Arrays::next(h)), corner(Arrays::previous(h))) == COLLINEAR)
          return h;
    return null_index;
  }

  template <class OutputIterator>
  bool write_at_vertex(const Query& query, OutputIterator weights) const
  {
    if (m_location.vertex == null_index)
      return false;
    for (Halfedge_index h = first_halfedge(); h < first_halfedge() + 3; ++h)
      if (query.is_at(corner(h)))
        *weights++ = weighted(corner(h), 1);
    return true;
  }

  template <class OutputIterator>
  void write_on_edge(const Query& query, Halfedge_index h, OutputIterator weights)
  {
    const std::array<Site, 2> ends{corner(Arrays::next(h)), corner(Arrays::previous(h))};
    write(
        ends, [&](auto& parts) { parts.add_edge(query.point(), ends[0], ends[1]); }, weights);
  }

  // Writes the weights of sites whose parts `add` adds up, exactly if doubles are too imprecise.
  template <class Sites, class Add, class OutputIterator>
  void write(const Sites& sites, const Add& add, OutputIterator weights)
  {
    const auto write_all = [&](const std::vector<double>& values) {
      for (std::size_t i = 0; i < sites.size(); ++i)
        *weights++ = weighted(sites[i], values[i]);
    };
    m_rounded.start(sites.size());
    add(m_rounded);
    if (m_rounded.normalize(largest_error))
      return write_all(m_rounded.weights());
    Exact_weight_parts_2<State> exact(m_geometry, sites.size());
    add(exact);
    write_all(exact.weights());
  }

  Weighted_id_2 weighted(const Site& site, double weight) const
  {
    return {state().ids().representative(State::vertex_of(site)), m_geometry.shift(site), weight};
  }

  Geometry m_geometry;
  Rounded_weight_parts_2<State> m_rounded;
  Location_2<State> m_location;
  Cavity_2<State> m_cavity;
  Vertex_index m_last{1}; // near the last query point
  double m_near = -1;     // the squared distance to walk from there at most
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHTS_AT_POINT_2_H
