// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_STATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_STATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_cells_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_predicates_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_translations_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/wires/Wire_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Flat_walls_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/State_base_3.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Where a vertex is: at `base` plus multiples of the basis, without rounding. The base is the point
// as it was given, so that one that is wrapped into the cell gets other multiples, and stays where
// it is; `position` is the sum, rounded. Without multiples, as nearly all are that are not wrapped,
// it is the base itself.
struct Torus_place_3
{
  Torus_place_3() = default;
  explicit Torus_place_3(const Position_3& p)
    : position(p)
    , base(p)
  {
  }
  Torus_place_3(const Position_3& b, const Multiples_3& m, const Torus_3& torus)
    : position(are_zero(m) ? b : b + torus.combination(m))
    , base(b)
    , multiples(m)
  {
  }

  Position_3 position{0, 0, 0}, base{0, 0, 0};
  Multiples_3 multiples{0, 0, 0};
};

// The places of the vertices, present or those of the last frame. Bases are neither read nor
// written where they are the positions: in calm frames of many points it is memory that counts.
class Torus_positions_3
{
public:
  using Place = Torus_place_3;

  const Position_3* data() const { return m_positions.data(); }
  const Position_3& position(Vertex_index v) const { return m_positions[v]; }
  Position_3 base(Vertex_index v) const
  {
    return are_zero(m_multiples[v]) ? m_positions[v] : m_bases[v].position();
  }
  const Multiples_3& multiples(Vertex_index v) const { return m_multiples[v]; }
  Index number() const { return Index(m_positions.size()); }
  // Whether a vertex is exactly where others have it.
  bool has_same(Vertex_index v, const Torus_positions_3& others) const
  {
    return m_multiples[v] == others.m_multiples[v] && is_same(base(v), others.base(v));
  }
  Torus_place_3 place(Vertex_index v) const
  {
    Torus_place_3 place(m_positions[v]);
    place.base = base(v);
    place.multiples = m_multiples[v];
    return place;
  }

  void set(Vertex_index v, const Torus_place_3& place)
  {
    m_positions[v] = place.position;
    m_multiples[v] = place.multiples;
    if (!are_zero(place.multiples))
      m_bases[v] = {place.base.x, place.base.y, place.base.z};
  }
  // Moves a vertex to where another base is, with the multiples that `last` has for it.
  void set(Vertex_index v, const Position_3& base, const Torus_positions_3& last,
           const Torus_3& torus)
  {
    const Multiples_3 m = last.m_multiples[v];
    m_multiples[v] = m;
    if (are_zero(m))
      return set_position(v, base);
    set_position(v, base + torus.combination(m));
    m_bases[v] = {base.x, base.y, base.z};
  }
  // At least one. Nowhere is the infinite vertex, so floating point proves nothing of it.
  void resize(Index number)
  {
    m_positions.resize(number);
    m_multiples.resize(number);
    m_bases.resize(number);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    m_positions[Vertex_index(infinite_index)] = {nan, nan, nan};
  }
  void swap(Torus_positions_3& other)
  {
    m_positions.swap(other.m_positions);
    m_multiples.swap(other.m_multiples);
    m_bases.swap(other.m_bases);
  }

private:
  // One by one: g++ 12 would store all on the stack, in pieces, and load it again in others, which
  // waits. Reading a frame takes 3.3 nanoseconds a point so, 5.1 otherwise.
  void set_position(Vertex_index v, const Position_3& p)
  {
    Position_3& position = m_positions[v];
    position.x = p.x;
    position.y = p.y;
    position.z = p.z;
  }

  struct Base // of three doubles, not four
  {
    Position_3 position() const { return {x, y, z}; }
    double x, y, z;
  };

  Column<Vertex_index, Position_3> m_positions;
  Column<Vertex_index, Multiples_3> m_multiples;
  Column<Vertex_index, Base> m_bases; // means something where a vertex has multiples
};

// What the error of rounded images depends on.
struct Torus_measures_3
{
  void include(const Position_3& base, const Position_3& position, const Multiples_3& multiples)
  {
    include(position);
    if (!are_zero(multiples))
      include_base(base, multiples);
  }
  // One that is not the position.
  void include_base(const Position_3& base, const Multiples_3& multiples)
  {
    include(base);
    sum = (std::max)(sum, double(std::abs(multiples[0])) + std::abs(multiples[1]) +
                              std::abs(multiples[2]));
  }
  // Each coordinate by itself: one maximum of all would wait for the one before, six times a place.
  void include(const Position_3& p)
  {
    extent = {(std::max)(std::abs(p.x), extent.x), (std::max)(std::abs(p.y), extent.y),
              (std::max)(std::abs(p.z), extent.z)};
  }
  Torus_measures_3 with(const Torus_measures_3& other) const
  {
    return {{(std::max)(extent.x, other.extent.x), (std::max)(extent.y, other.extent.y),
             (std::max)(extent.z, other.extent.z)},
            (std::max)(sum, other.sum),
            has_strayed || other.has_strayed};
  }
  double largest() const { return (std::max)({extent.x, extent.y, extent.z}); }

  Position_3 extent{0, 0, 0}; // of all coordinates' absolute values
  double sum = 0;             // of absolute values of the multiples of a vertex
  bool has_strayed = false;   // whether a vertex is far out of the basis' parallelepiped
};

// The smallest box around positions: six instructions for each of them.
struct Torus_box_3
{
  void include(const Position_3& p)
  {
    low = {(std::min)(p.x, low.x), (std::min)(p.y, low.y), (std::min)(p.z, low.z)};
    high = {(std::max)(p.x, high.x), (std::max)(p.y, high.y), (std::max)(p.z, high.z)};
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Position_3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
};

// The positions and the cell of a frame, before they count; from the exchange on, those of the last
// frame, and at last as the new cell carries them.
template <class Point>
class Torus_staged_3
{
public:
  // The cell of the next frame: the present one,
  template <class State>
  void set_cell(const State&)
  {
    m_torus.reset();
    m_can_mend = true;
  }
  // or another one.
  template <class State>
  void set_cell(const State& state, const Periodic_cell_3& cell)
  {
    set_cell(state);
    if (cell == state.torus.cell())
      return;
    if (cell.dimension() != state.torus.dimension())
      Torus_3::refuse(cell, "a cell cannot get another number of vectors");
    m_torus = state.torus.moved_to(cell);
    m_can_mend = m_torus.has_value();
    if (!m_torus)
      m_torus = Torus_3(cell);
  }
  // Whether the basis of the last frame could be moved to this one's.
  bool can_mend() const { return m_can_mend; }
  // Whether the cell is not that of the last frame.
  bool has_other_cell() const { return m_torus.has_value(); }

  // Each vertex goes to that image of its point that is nearest to where it was, carried with the
  // cell. False if the point is not finite, or too far away. Inline: reading a frame takes 0.8 of
  // the time then.
  template <class State>
  BOOST_FORCEINLINE bool set(const State& state, Vertex_index v, const Point& p)
  {
    const Position_3 base = approximation(p);
    if (!m_torus && state.torus.is_clearly_in_range(base) &&
        state.torus.is_short(base - state.positions.base(v))) {
      positions.set(v, base, state.positions, state.torus);
      return true;
    }
    return set_anywhere(state, v, p);
  }
  template <class State>
  bool accepts(const State& state, const Point& p) const
  {
    const Position_3 base = approximation(p);
    return is_finite(base) && (m_torus ? *m_torus : state.torus).is_in_range(base);
  }
  template <class State>
  void check(const State& state, const Point& p, std::size_t id) const
  {
    (m_torus ? *m_torus : state.torus).check(approximation(p), id);
  }

  // Exchanges all with what counts.
  template <class State>
  void exchange(State& state)
  {
    state.positions.swap(positions);
    state.ids.covered_points().swap(covered);
    if (m_torus)
      std::swap(state.torus, *m_torus);
  }
  // To be called after that, for visitors: notes which points are given at other images.
  template <class State>
  void note_exchange(State& state) const
  {
    if (!state.translations.is_on())
      return;
    const Torus_3 &from = m_torus ? *m_torus : state.torus, &to = state.torus;
    if (m_torus)
      state.translations.exchange_cell(from, to);
    const auto& ids = state.ids;
    for (Vertex_index v(1); v < positions.number(); ++v)
      if (ids.has_representative(v))
        state.translations.translate(
            ids.representative(v),
            to.in_vectors_of_cell(state.positions.multiples(v) - positions.multiples(v)));
    for (Index i = 0; i < ids.number_of_covered(); ++i) {
      const Point_id id = ids.covered_id(i);
      const Position_3 f = from.fractions(positions.position(ids.vertex(id)));
      const Position_3 old_way = f - from.fractions(approximation(covered[i]));
      const Position_3 new_way = f - to.fractions(approximation(ids.covered_point(id)));
      state.translations.translate(
          id, to.in_vectors_of_cell(Torus_3::nearest(new_way) - Torus_3::nearest(old_way)));
    }
  }
  // To be called after that: the last frame's vertices go with the cell.
  template <class State>
  void carry(State& state)
  {
    if (!m_torus)
      return;
    state.forget_measures();
    state.origin = state.torus.carried(state.origin, *m_torus);
    for (Vertex_index v(1); v < positions.number(); ++v)
      positions.set(v, Torus_place_3(state.torus.carried(positions.position(v), *m_torus)));
  }

  Torus_positions_3 positions;
  std::vector<Point> covered; // by their numbers
  bool are_exact = true;      // always

private:
  template <class State>
  BOOST_NOINLINE bool set_anywhere(const State& state, Vertex_index v, const Point& p)
  {
    if (!accepts(state, p))
      return false;
    const Position_3 base = approximation(p);
    const Torus_3& torus = m_torus ? *m_torus : state.torus;
    const Position_3 position = state.positions.position(v);
    const Position_3 from = m_torus ? torus.carried(position, state.torus) : position;
    positions.set(v, Torus_place_3(base, Torus_3::nearest(torus.fractions(from - base)), torus));
    return true;
  }

  std::optional<Torus_3> m_torus; // if the cell is another one
  bool m_can_mend = true;
};

// Points in periodic space, their ids and their cells. On a torus and in a slab nothing depends on
// an origin, and there are cells as soon as there is a point. In a wire the origin is a point of
// the axis (see `Wire_signs_3`), and there are cells unless all points are in a plane along it.
template <class GeomTraits, class ConcurrencyTag>
class Torus_state_3
  : public State_base_3<GeomTraits, ConcurrencyTag, Torus_positions_3, Torus_cells_3>
{
  using Base = State_base_3<GeomTraits, ConcurrencyTag, Torus_positions_3, Torus_cells_3>;

public:
  using Traits = GeomTraits;
  using Point = typename Base::Point;
  using Place = Torus_place_3;
  using Positions = Torus_positions_3;
  using Staged = Torus_staged_3<Point>;

  static_assert(is_three_doubles<Point>,
                "the coordinates of points in periodic space must be of type double");

  // Of 10,000 random points, steps of 0.18 mean spacings break 3.7 cells a vertex, and are mended
  // in 0.7 to 0.9 of the time of a rebuild; of lattices that are shaken more cells are not proved,
  // but fewer broken.
  static constexpr double most_broken = 0.89; // of all cells
  static constexpr bool positions_are_exact = true;
  static constexpr bool mends_by_cells = true;

  // Next to the hull of a slab or a wire, the facets of which are as long as the cell, a vertex has
  // so many neighbors that only a short way breaks few of its cells: of 200 frames of 1,000 random
  // points in a pipe with steps of 0.1 mean spacings, 8 are rebuilt without such short ways, and 3
  // with them; without them, 50 times as many vertices are taken out and inserted.
  double smallest_way() const { return torus.dimension() < 3 ? 0x1p-7 : 0.25; }

  // A way along the hull, as near to one between two positions as can be: the hull of a slab is
  // flat, and that of a wire may be so around a vertex; else it is along the wire.
  Position_3 along_hull(const Position_3& from, const Position_3& to,
                        const std::vector<Cell_index>& star) const
  {
    const Position_3 way = to - from;
    if (torus.is_slab())
      return from + (way - torus.elevation(way) * torus.vector(2));
    if (!torus.is_wire())
      return to;
    if (const std::optional<Position_3> normal = normal_of_wall(star))
      return from + (way - Torus_3::product(*normal, way) * *normal);
    return from + torus.combination(torus.fractions(way));
  }

  // The middle of the finite cells around a vertex.
  Position_3 beneath_hull(Vertex_index v, const std::vector<Cell_index>& star) const
  {
    Position_3 sum{0, 0, 0};
    double number = 0;
    for (const Cell_index c : star)
      if (!arrays.is_infinite(c)) {
        const Torus_sites_3 sites = arrays.sites(c);
        Position_3 here{0, 0, 0}, middle{0, 0, 0};
        for (const Torus_site_3& s : sites) {
          here = s.vertex == v ? position(s) : here;
          middle = middle + 0.25 * position(s);
        }
        sum = sum + (middle - here);
        ++number;
      }
    return positions.position(v) + (number == 0 ? 0 : 1 / number) * sum;
  }

  // A place near to `wanted` with those coordinates that a motion keeps, as across a wall, unless
  // it keeps all. In a duct a point at the edge of a wall is on two planes of the hull, and has to
  // stay in one of them: of 400 frames of 1,000 points, a third of them on the walls, that take
  // steps of 0.05 mean spacings, 22 percent were rebuilt without this, and one with it.
  Position_3 on_wall(const Position_3& before, const Position_3& after,
                     const Position_3& wanted) const
  {
    const bool x = before.x == after.x, y = before.y == after.y, z = before.z == after.z;
    if (torus.dimension() == 3 || (x && y && z))
      return wanted;
    return {x ? after.x : wanted.x, y ? after.y : wanted.y, z ? after.z : wanted.z};
  }

  // Finds flat walls across axes: planes with several vertices, beyond which there is none.
  void find_walls()
  {
    const auto wall = [&](int axis, double sign) {
      return torus.is_open_along(std::size_t(axis))
                 ? flat_wall(positions, axis, sign)
                 : sign * std::numeric_limits<double>::infinity();
    };
    m_low = {wall(0, -1), wall(1, -1), wall(2, -1)};
    m_high = {wall(0, 1), wall(1, 1), wall(2, 1)};
  }

  // The place `wanted`, but with a coordinate of another one where it is beyond a flat wall: there
  // a vertex would be alone, with cells as large as the basis. Of 40 frames of 10,000 points, a
  // third of them on the walls of a slab, that take steps of 0.1 mean spacings, three were rebuilt
  // without this, and none with it.
  Position_3 between_walls(const Position_3& wanted, const Position_3& other) const
  {
    const auto is_beyond = [](double x, double low, double high) { return x < low || x > high; };
    return {is_beyond(wanted.x, m_low.x, m_high.x) ? other.x : wanted.x,
            is_beyond(wanted.y, m_low.y, m_high.y) ? other.y : wanted.y,
            is_beyond(wanted.z, m_low.z, m_high.z) ? other.z : wanted.z};
  }

  // Whether space is repeated along an axis of the coordinates in which parts are cut, those of the
  // basis, in which vertices are shifted, and wrapped: so that no border has to be where a period
  // ends.
  bool repeats(int axis) const { return axis < torus.dimension(); }
  Position_3 coordinates_to_cut(Vertex_index v, const Few<double, 3>& shift) const
  {
    const Position_3& p = positions.position(v);
    const auto across = [&](int axis) { return Torus_3::product(torus.vector(axis), p); };
    const auto wrapped = [](double x) { return x - std::floor(x); };
    const Position_3 f = torus.fractions(p);
    return {wrapped(f.x + shift[0]), repeats(1) ? wrapped(f.y + shift[1]) : across(1),
            repeats(2) ? wrapped(f.z + shift[2]) : across(2)};
  }

  // Whether images that have a coordinate of their positions in common have it exactly so.
  bool has_levels(int axis) const
  {
    bool has = torus.is_open_along(std::size_t(axis));
    for (int i = 0; i < torus.dimension(); ++i)
      has = has && coordinate(torus.vector(i), axis) == 0;
    return has;
  }

  // The hull of a wire may have moved across its axis.
  bool goes_on_to_cover_once() const { return !torus.is_wire(); }

  explicit Torus_state_3(const Periodic_cell_3& cell)
    : torus(cell)
  {
  }

  Torus_state_3 without_points() const { return Torus_state_3(torus.cell()); }

  using Base::arrays;
  using Base::positions;
  using typename Base::Parts;

  Point point(Vertex_index v) const { return to_point(positions.base(v)); }
  static Point point_at(const Place& place) { return to_point(place.base); }
  // In the basis' parallelepiped.
  Place place_of(const Point& point) const
  {
    const Position_3 base = approximation(point);
    return Place(base, Multiples_3{0, 0, 0} - Torus_3::floor(torus.fractions(base)), torus);
  }
  Place place_near(const Point& point, Vertex_index v) const
  {
    const Position_3 base = approximation(point), way = positions.position(v) - base;
    return Place(base, Torus_3::nearest(torus.fractions(way)), torus);
  }
  bool coincide(const Point& p, Vertex_index v) const
  {
    const Place place = place_near(p, v);
    return torus.coincide({place.base, place.multiples, place.position},
                          image(Torus_site_3{v, {}}));
  }

  // Where a vertex is in a new basis.
  Place place_anew(Vertex_index v) const { return place_of(point(v)); }
  // Throws if a point is not finite, or too far away.
  void check(const Point& p, std::size_t id) const { torus.check(approximation(p), id); }

  // An image, exact and rounded; or what stands for a point at infinity.
  Torus_point_3 image(const Torus_site_3& site) const
  {
    const Multiples_3 shift = site.shift.multiples();
    return {positions.base(site.vertex), positions.multiples(site.vertex) + shift,
            rounded(site, shift)};
  }
  // Inline, as far as shifts are small, as nearly all are.
  BOOST_FORCEINLINE Position_3 position(const Torus_site_3& site) const
  {
    const Position_3& p = positions.position(site.vertex);
    if (site.shift == Torus_shift_3())
      return p;
    if (Small_translations_3::has(site.shift))
      return p + torus.small_translations().of(site.shift);
    return rounded_image(site);
  }

  // A point is given elsewhere, and may be meant at another image than before.
  void note_move(Point_id id, const Point& from, const Point& to, Vertex_index v)
  {
    if (translations.is_on())
      translations.translate(id, torus.in_vectors_of_cell(place_near(to, v).multiples -
                                                          place_near(from, v).multiples));
  }

  // What rounding moves sites by grows with the places that there are.
  void include(const Place& place)
  {
    forget_measures();
    m_present.include(place.base, place.position, place.multiples);
    m_present.has_strayed = m_present.has_strayed || torus.is_far_out(place.position);
    use_reach(m_reach.with(m_present));
  }
  void include_all()
  {
    measure();
    use_reach(m_present);
  }
  // To be called when others than these vertices, or these elsewhere, are those of the last frame.
  void forget_measures() { m_measured = 0; }
  // A vertex that is held is carried by others' ways: at most twice as far as all go.
  // That depends on both frames alone, as after a checkpoint. The axis of a wire goes with the
  // others.
  bool begin_frame(const Position_3& mean, const Positions& previous)
  {
    if (torus.is_wire())
      set_origin(origin + mean);
    Torus_measures_3 reach =
        m_measured == previous.number() ? m_present : measures(previous, false);
    measure();
    reach = reach.with(m_present);
    reach.extent = 4 * reach.extent;
    use_reach(reach);
    return is_finite(origin);
  }
  // Wraps vertices into the basis' parallelepiped where one has gone far out of it, so that shifts
  // stay small.
  void end_change()
  {
    if (!m_present.has_strayed)
      return;
    Column<Vertex_index, Torus_shift_3> shifts(positions.number(), Torus_shift_3());
    for (Vertex_index v(1); v < positions.number(); ++v) {
      const Torus_place_3 place = positions.place(v);
      const Multiples_3 out = Torus_3::floor(torus.fractions(place.position));
      shifts[v] = Torus_shift_3::of(out);
      positions.set(v, Torus_place_3(place.base, place.multiples - out, torus));
    }
    arrays.shift_vertices(shifts);
    include_all();
  }
  // How far points and vertices go, for filters: a coordinate, and a sum of multiples.
  std::array<double, 2> reach() const { return {m_reach.largest(), m_reach.sum}; }
  // False if that is too little for the points.
  bool set_reach(const std::array<double, 2>& reach)
  {
    include_all();
    if (!(m_present.largest() <= reach[0] && m_present.sum <= reach[1]))
      return false;
    use_reach({{reach[0], reach[0], reach[0]}, reach[1]});
    return true;
  }
  // In a wire a point of the axis, which is moved along that as near to the vertices as these are
  // to each other.
  void set_origin(const Position_3& p)
  {
    origin = p;
    if (is_finite(p) && torus.is_far_out(p))
      origin = p - torus.combination(Torus_3::floor(torus.fractions(p)));
  }

  void begin_rebuild() { torus = torus.with_short_basis(); }

  void renumber_vertices(const Column<Vertex_index, Vertex_index>& numbers, Index vertices)
  {
    arrays.renumber_all(numbers, vertices);
  }

  Torus_3 torus;
  Torus_translations_3 translations; // for visitors
  double squared_error = 0;          // by which filters have to reckon
  bool has_origin = true;
  Position_3 origin{0, 0, 0};

private:
  // NaN, of which a filter proves nothing, where the bound of the error does not hold, and at
  // infinity.
  Position_3 rounded(const Torus_site_3& site, const Multiples_3& shift) const
  {
    const Position_3& p = positions.position(site.vertex);
    if (site.shift == Torus_shift_3())
      return p;
    if (!Torus_3::is_in_filter(shift)) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      return {nan, nan, nan};
    }
    return p + torus.combination(shift);
  }
  BOOST_NOINLINE Position_3 rounded_image(const Torus_site_3& site) const
  {
    return rounded(site, site.shift.multiples());
  }
  static Point to_point(const Position_3& p) { return Point(p.x, p.y, p.z); }

  // The normal of the hull facets of some cells, if rounding finds no other one.
  std::optional<Position_3> normal_of_wall(const std::vector<Cell_index>& cells) const
  {
    std::optional<Position_3> normal;
    for (const Cell_index c : cells) {
      const Torus_sites_3 s = arrays.sites(c);
      const int infinite = infinite_place(s);
      if (infinite == 4)
        continue;
      const Torus_facet_3 f = hull_facet(s, infinite);
      const Position_3 p = position(f[0]);
      const Position_3 n = Torus_3::cross_product(position(f[1]) - p, position(f[2]) - p);
      const Position_3 unit = (1 / std::sqrt(squared_length(n))) * n;
      if (!normal)
        normal = unit;
      if (!(std::abs(Torus_3::product(*normal, unit)) > 1 - 1e-14))
        return std::nullopt;
    }
    return normal;
  }

  void use_reach(const Torus_measures_3& reach)
  {
    m_reach = reach;
    squared_error = torus.squared_error(reach.largest(), reach.sum);
  }

  void measure()
  {
    m_present = measures(positions, true);
    m_measured = positions.number();
  }
  Torus_measures_3 measures(const Positions& places, bool looks_for_strayed) const
  {
    std::array<Torus_measures_3, Parts::max_parts> found;
    Parts::for_each(places.number() - 1, [&](std::size_t part, std::size_t first, std::size_t end) {
      const Vertex_index begin(first + 1), last(end);
      Torus_measures_3 measures;
      Torus_box_3 box;
      for (Vertex_index v(begin); v <= last; ++v) {
        box.include(places.position(v));
        if (!are_zero(places.multiples(v)))
          measures.include_base(places.base(v), places.multiples(v));
      }
      if (begin <= last) {
        measures.include(box.low);
        measures.include(box.high);
      }
      if (looks_for_strayed && torus.may_be_far_out(box.low, box.high))
        for (Vertex_index v(begin); v <= last; ++v)
          measures.has_strayed |= torus.is_far_out(places.position(v));
      found[part] = measures;
    });
    Torus_measures_3 measures;
    for (const Torus_measures_3& of_part : found)
      measures = measures.with(of_part);
    return measures;
  }

  Position_3 m_low{0, 0, 0}, m_high{0, 0, 0}; // flat walls, or infinite
  Torus_measures_3 m_present;                 // of all vertices
  Index m_measured = 0;                       // their number, if it is of no other places
  Torus_measures_3 m_reach;                   // also of what they have been in this frame
};

// The exact signs that decide cells and facets.
template <class State>
class Torus_signs_3
{
public:
  explicit Torus_signs_3(const State& state)
    : m_state(state)
    , m_predicates(state.torus, state.squared_error)
    , m_in_wire(state, m_predicates)
  {
  }

  const Torus_predicates_3& predicates() const { return m_predicates; }

  // 1 if the cell is positive, -1 if it is inverted, 0 if it is flat.
  int of(const Torus_sites_3& s) const
  {
    if (const int sign = m_predicates.filtered_orientation(position(s[0]), position(s[1]),
                                                           position(s[2]), position(s[3])))
      return sign;
    if (m_state.torus.is_wire())
      if (const int place = infinite_place(s); place < 4)
        return m_in_wire.of(hull_facet(s, place));
    return m_predicates.orientation_in_doubt(point(s[0]), point(s[1]), point(s[2]), point(s[3]));
  }
  bool is_positive(const Torus_sites_3& s) const { return of(s) > 0; }

  // The sign of the cell if `other` took one of the places.
  int with(Torus_sites_3 s, int place, const Torus_site_3& other) const
  {
    s[place] = other;
    return of(s);
  }

  // Whether the facet between a positive cell and one that has `other` and all but one of its sites
  // is not locally Delaunay.
  bool is_illegal(const Torus_sites_3& s, const Torus_site_3& other) const
  {
    return side_of_sphere(s, other) > 0;
  }
  // Calls f(place) for each facet of a cell, of those for which is_wanted(place), that the filter
  // does not prove legal.
  template <class Predicate, class Function>
  void for_each_doubtful(Cell_index c, const Predicate& is_wanted, const Function& f) const
  {
    using Arrays = typename State::Arrays;
    const Arrays& arrays = m_state.arrays;
    const Torus_sites_3 s = arrays.sites(c);
    const Position_3 origin = position(s[0]);
    const auto way = [&](const Torus_site_3& site) {
      const Position_3 v = position(site) - origin;
      return Points_in_lanes_3<double>{v.x, v.y, v.z};
    };
    const Torus_filter_in_lanes_3<double> filter(way(s[1]), way(s[2]), way(s[3]),
                                                 m_state.squared_error);
    for (int i = 0; i < 4; ++i)
      if (is_wanted(i) && filter.side_of_sphere(way(arrays.apex_site(Arrays::corner(c, i)))) >= 0)
        f(i);
  }

  // 1 if `other` is inside of the sphere of a positive cell, -1 if it is outside. The sphere of an
  // infinite cell is the half space beyond its hull facet, with the circle of that on its border.
  int side_of_sphere(const Torus_sites_3& s, const Torus_site_3& other) const
  {
    if (const int sign = m_predicates.filtered_side_of_sphere(
            position(s[0]), position(s[1]), position(s[2]), position(s[3]), position(other)))
      return sign;
    if (m_state.torus.is_wire())
      if (const int sign = side_between_lines(s, other))
        return sign;
    return m_predicates.side_of_sphere_in_doubt(point(s[0]), point(s[1]), point(s[2]), point(s[3]),
                                                point(other));
  }

private:
  // Of an infinite cell of a wire, most of which have two images of one vertex; 0 if unknown.
  int side_between_lines(const Torus_sites_3& s, const Torus_site_3& other) const
  {
    const int place = infinite_place(s);
    if (place == 4)
      return 0;
    const Torus_facet_3 f = hull_facet(s, place);
    for (int i = 0; i < 3; ++i)
      if (f[i].vertex == f[(i + 1) % 3].vertex && f[(i + 2) % 3].vertex == other.vertex)
        return m_in_wire.side_beside(f, i, other);
    return 0;
  }

  Torus_point_3 point(const Torus_site_3& site) const { return m_state.image(site); }
  BOOST_FORCEINLINE Position_3 position(const Torus_site_3& site) const
  {
    return m_state.position(site);
  }

  const State& m_state;
  Torus_predicates_3 m_predicates;
  Wire_signs_3<State> m_in_wire;
};

template <class Traits, class ConcurrencyTag>
struct Signs_of_3<Torus_state_3<Traits, ConcurrencyTag>>
{
  using type = Torus_signs_3<Torus_state_3<Traits, ConcurrencyTag>>;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_STATE_3_H
