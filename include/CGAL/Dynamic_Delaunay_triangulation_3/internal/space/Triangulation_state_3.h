// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_TRIANGULATION_STATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_TRIANGULATION_STATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Positions_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/State_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The positions of a frame, before they count; from the exchange on, those of the last frame.
template <class Point>
struct Staged_positions_3
{
  // There is one cell only, as it were.
  template <class State>
  static void set_cell(const State&)
  {
  }
  static constexpr bool can_mend() { return true; }
  static constexpr bool has_other_cell() { return false; }

  // False if the point is refused.
  template <class State>
  bool set(const State&, Vertex_index v, const Point& p)
  {
    const Position_3 position = approximation(p);
    positions.set(v, Place_3<Point>(position, p));
    return is_within_limit(position);
  }
  template <class State>
  static bool accepts(const State&, const Point& p)
  {
    return is_within_limit(approximation(p));
  }
  template <class State>
  static void check(const State& state, const Point& p, std::size_t id)
  {
    state.check(p, id);
  }

  // Exchanges all with what counts.
  template <class State>
  void exchange(State& state)
  {
    state.positions.swap(positions);
    state.ids.covered_points().swap(covered);
    std::swap(state.positions_are_exact, are_exact);
  }
  template <class State>
  static void note_exchange(const State&)
  {
  }
  template <class State>
  static void carry(const State&)
  {
  }

  Positions_3<Point> positions;
  std::vector<Point> covered; // of covered points, by their numbers
  bool are_exact = true;
};

// Points, their ids, their cells, and the origin.
//
// The origin is a point strictly inside of the hull. An infinite cell is seen from there as a cone:
// it is positive if the origin lies strictly beneath its hull facet. So finite and infinite cells
// are tested and flipped in the same way, and a frame whose cells are all positive is a
// triangulation if one ray from the origin meets a single hull facet.
template <class GeomTraits, class ConcurrencyTag>
class Triangulation_state_3
  : public State_base_3<GeomTraits, ConcurrencyTag, Positions_3<typename GeomTraits::Point_3>,
                        Tetrahedra_arrays_3>
{
  using Base = State_base_3<GeomTraits, ConcurrencyTag, Positions_3<typename GeomTraits::Point_3>,
                            Tetrahedra_arrays_3>;

public:
  using Traits = GeomTraits;
  using Point = typename Base::Point;
  using Place = typename Base::Place;
  using Positions = typename Base::Positions;
  using Staged = Staged_positions_3<Point>;

  // Where more is to be mended, it costs more than a rebuild. Of 10,000 random points, steps of
  // 0.14 mean spacings break three cells a vertex; then both ways take as long. Of points on a
  // sphere, which have fewer cells, any step breaks nearly all.
  static constexpr double most_broken = 0.44; // of all cells

  static constexpr bool mends_by_cells = false;

  static double smallest_way() { return 0.25; }
  static Position_3 along_hull(const Position_3&, const Position_3& to,
                               const std::vector<Cell_index>&)
  {
    return to;
  }
  Position_3 beneath_hull(Vertex_index, const std::vector<Cell_index>&) const { return origin; }
  static Position_3 on_wall(const Position_3&, const Position_3&, const Position_3& wanted)
  {
    return wanted;
  }
  static void find_walls() {}
  static constexpr bool repeats(int) { return false; }
  Position_3 coordinates_to_cut(Vertex_index v, const Few<double, 3>&) const
  {
    return positions.position(v);
  }
  static Position_3 between_walls(const Position_3& wanted, const Position_3&) { return wanted; }
  static constexpr bool has_levels(int) { return true; }
  static constexpr bool goes_on_to_cover_once() { return false; } // a ray says so

  explicit Triangulation_state_3(const Traits& geometry = Traits())
    : traits(geometry)
  {
  }

  Triangulation_state_3 without_points() const { return Triangulation_state_3(traits); }

  using Base::ids;
  using Base::positions;
  using Base::spans_space;

  // -1 without points, 0 if all coincide, 1 if they are on a line, 2 in a plane, else 3. After an
  // exception, -1 or 0.
  int dimension() const
  {
    if (spans_space)
      return 3;
    if (!flat_triangles.empty())
      return 2;
    return !flat_edges.empty() ? 1 : ids.number_of_points() > 0 ? 0 : -1;
  }
  decltype(auto) point(Vertex_index v) const { return positions.point(v); }
  static decltype(auto) point_at(const Place& place) { return place.point(); }
  static Place place_of(const Point& point) { return Place(approximation(point), point); }
  static Place place_near(const Point& point, Vertex_index) { return place_of(point); }
  Place place_anew(Vertex_index v) const { return positions.place(v); }
  static void check(const Point& p, std::size_t id) { checked_position(p, id); }
  static bool coincide(const Point& p, const Point& q)
  {
    return p.x() == q.x() && p.y() == q.y() && p.z() == q.z();
  }
  bool coincide(const Point& p, Vertex_index v) const { return coincide(p, point(v)); }

  static void note_move(Point_id, const Point&, const Point&, Vertex_index) {}

  void include(const Place& place)
  {
    if constexpr (!is_three_doubles<Point>)
      positions_are_exact = positions_are_exact && has_exact_position(place.point());
  }
  void include_all()
  {
    positions_are_exact = true;
    if constexpr (!is_three_doubles<Point>)
      for (Vertex_index v(1); v < positions.number(); ++v)
        include(positions.place(v));
  }

  // The origin goes with the others.
  bool begin_frame(const Position_3& mean, const Positions&)
  {
    origin = origin + mean;
    return is_finite(origin);
  }
  void end_change() {}
  void begin_rebuild() {}

  void drop_cells()
  {
    flat_edges.clear();
    flat_triangles.clear();
    Base::drop_cells();
  }
  void renumber_vertices(const Column<Vertex_index, Vertex_index>& numbers, Index vertices)
  {
    Base::arrays.renumber_all(numbers, vertices);
    for (auto& edge : flat_edges)
      for (Vertex_index& v : edge)
        v = numbers[v];
    for (auto& triangle : flat_triangles)
      for (Vertex_index& v : triangle)
        v = numbers[v];
  }

  Traits traits;
  bool positions_are_exact = true; // no point is rounded in the array of positions
  // Where points do not span space, they are coplanar, and the edges and triangles of a Delaunay
  // triangulation of their plane are in these lists.
  std::vector<Few<Vertex_index, 2>> flat_edges;
  std::vector<Few<Vertex_index, 3>> flat_triangles;
  bool has_origin = false;
  Position_3 origin{0, 0, 0};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_TRIANGULATION_STATE_3_H
