// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_UPDATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_UPDATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Lawson_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_periodic_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Periodic_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Periodic_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Periodic_safe_edges_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Spatial_order_2.h>
#include <CGAL/number_utils.h>
#include <CGAL/Update_report_2.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Keeps a periodic triangulation Delaunay: builds it, and repairs it after points have moved, come
// or gone. Every function leaves a certified triangulation.
template <class Maintained, class Editor>
class Periodic_update_2
{
  using Mirror = Neighborhood_mirror_2;
  using Slot = Mirror::Slot;
  using Edge_test = typename Maintained::Edge_test;

public:
  explicit Periodic_update_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_editor(maintained)
  {
  }

  // What has changed since the log was last cleared, if it is kept.
  std::vector<Periodic_change_2>& log() { return m_editor.log(); }

  // POPULATION ----------------------------------------------------------------------------------

  // Inserts points with the next ids.
  void insert(const std::vector<Index>& next_ids, const std::vector<Position_2>& points,
              Update_report_2& report)
  {
    m_editor.ids().reserve(next_ids);
    place_all(next_ids, points, report);
    report.inserted += points.size();
  }

  void remove(Index id, Update_report_2& report)
  {
    ++report.removed;
    make_duplicate_if_shared(id);
    if (!ids().is_representative(id))
      return m_editor.ids().remove_duplicate(id);
    const Index v = ids().vertex(id);
    m_taken_out.clear();
    const bool is_out = m_maintained.number_of_vertices() > 1 && take_out({v}, false, report);
    if (!is_out)
      return rebuild(Rebuild_reason_2::STUCK, report, id);
    m_editor.ids().provide_for_removals(1);
    m_editor.ids().remove_representative(id);
    legalize(report);
    m_editor.drop(m_taken_out);
  }

  // Moves one point.
  void move(Index id, const Position_2& p, Update_report_2& report)
  {
    make_duplicate_if_shared(id);
    const Index v = ids().vertex(id);
    if (!ids().is_representative(id)) {
      if (coincide(p, m_maintained.positions()[v]))
        m_editor.ids().duplicate(id).point = p;
      else
        place(id, p, report);
      return;
    }
    const Position_2 before = m_maintained.positions()[v];
    const Periodic_shift_2 shift = shift_of_step(before, p);
    m_editor.set_position(v, p);
    m_editor.shift_images(v, shift);
    if (are_faces_counterclockwise(v)) {
      open_surroundings(v);
      return legalize(report);
    }
    m_editor.set_position(v, before);
    m_editor.shift_images(v, no_shift - shift);
    m_taken_out.clear();
    const bool is_out = take_out({v}, false, report);
    m_editor.set_position(v, p);
    if (!is_out)
      return rebuild(Rebuild_reason_2::STUCK, report);
    legalize(report);
    put_back_all(report);
  }

  // MOTION --------------------------------------------------------------------------------------

  // Reads the position `next(id)` of each point for update(). False if a coordinate is not finite,
  // or a point out of range in the new cell.
  template <class Next>
  bool stage(const Next& next, const Periodic_cell_2& cell)
  {
    const Torus_2 now(cell);
    const bool is_same = cell == m_maintained.torus().cell();
    m_multiples = is_same ? unit_multiples : multiples_in_new_cell(m_maintained.torus(), now);
    return (is_same ? stage_vertices<true>(next, now) : stage_vertices<false>(next, now)) &&
           std::all_of(ids().duplicates().begin(), ids().duplicates().end(),
                       [&](const auto& d) { return is_in_range(now.multiples(next(d.id)), now); });
  }

  // Moves all points to the positions that were staged, and are given again, in the same cell.
  template <class Next>
  void update(const Next& next, const Periodic_cell_2& cell, Update_report_2& report)
  {
    m_taken_out.clear();
    const std::vector<Index> jumpers = find_jumpers();
    const bool are_many = jumpers.size() > max_taken_out();
    bool is_mended = are_many || take_out(jumpers, false, report);
    if (is_mended)
      legalize(report);
    move_vertices(cell);
    const std::vector<Index> parted = move_duplicates(next);
    const bool is_too_much = are_many && is_much_broken();
    is_mended = is_mended && !is_too_much && untangle(report);
    if (is_mended)
      put_back_all(report);
    else
      rebuild(is_too_much ? Rebuild_reason_2::TOO_MUCH_BROKEN : Rebuild_reason_2::STUCK, report);
    for (const Index id : parted)
      if (!ids().is_representative(id))
        move(id, next(id), report);
    report.parted += parted.size();
    m_safe_edges.learn(frame());
    m_editor.clear_news(m_safe_edges.holds());
  }

  // Whether the next frame need not look at all edges.
  bool skips_edges() const { return m_safe_edges.holds(); }

  // Triangulates all points anew, but for the one with the id `gone`, which is removed.
  void rebuild(Rebuild_reason_2 reason, Update_report_2& report, Index gone = no_index)
  {
    report.rebuild_reason = reason;
    m_open.clear();
    std::vector<Index> taken;
    std::vector<Position_2> points;
    for (Index id = 0; id < ids().number_of_ids(); ++id)
      if (ids().is_taken(id) && id != gone) {
        taken.push_back(id);
        points.push_back(m_maintained.position_of_id(id));
      }
    const Index number_of_ids = ids().number_of_ids();
    const std::size_t logged = m_editor.log().size();
    m_editor.provide_for_log(m_maintained.mirror().number_of_edges());
    m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_REMOVED);
    Maintained before(m_maintained.torus().cell());
    m_editor.swap(before);
    try {
      m_editor.ids().reset(number_of_ids);
      Update_report_2 ignored;
      place_all(taken, points, ignored);
      m_editor.ids().settle();
    } catch (...) {
      m_editor.swap(before); // which still has all points
      m_editor.log().resize(logged, {});
      throw;
    }
  }

  // CERTIFICATE ---------------------------------------------------------------------------------

  // Tests everything again, exactly: that the shifts agree, that all faces are counterclockwise,
  // that their areas sum up to that of the cell, that all edges are locally Delaunay, and that
  // duplicates are where their representatives are.
  bool is_valid() const
  {
    const Index n = m_maintained.number_of_vertices();
    const auto& mirror = m_maintained.mirror();
    if (mirror.number_of_faces() != 2 * n || mirror.number_of_edges() != 3 * n ||
        ids().number_of_representatives() != n)
      return false;
    Torus_2::Polynomial<1> area{0, 0}, area_of_cell = m_maintained.torus().exact_double_area();
    for (Index h = 0; h < 6 * n; ++h) {
      const Index g = mirror.twin(h);
      if (mirror.twin(g) != h || mirror.source(h) != mirror.target(g) ||
          m_maintained.transition(h) != no_shift - m_maintained.transition(g))
        return false;
      if (h % 3 != 0)
        continue;
      const auto face = m_maintained.torus().exact_double_area(
          m_maintained.image(h), m_maintained.image(h + 1), m_maintained.image(h + 2));
      area = {area[0] + face[0], area[1] + face[1]};
    }
    const Edge_test test(m_maintained);
    for (Index e = 0; e < mirror.number_of_edges(); ++e)
      if (test.state(e) != Edge_state_2::DELAUNAY)
        return false;
    for (const auto& duplicate : ids().duplicates())
      if (!coincide(duplicate.point, m_maintained.positions()[ids().vertex(duplicate.id)]))
        return false;
    if (CGAL::is_negative(area_of_cell[0]))
      area_of_cell[0] = -area_of_cell[0];
    return n == 0 || area == area_of_cell;
  }

private:
  static constexpr std::array<Periodic_shift_2, 2> unit_multiples{{{1, 0}, {0, 1}}};

  const typename Maintained::Ids& ids() const { return m_maintained.ids(); }

  // POINTS --------------------------------------------------------------------------------------

  Periodic_shift_2 shift_of_step(const Position_2& from, const Position_2& to) const
  {
    const Torus_2& torus = m_maintained.torus();
    return torus.nearest_shift(torus.multiples({to.x - from.x, to.y - from.y}));
  }

  // Whether two points differ by a vector of the lattice.
  bool coincide(const Position_2& p, const Position_2& q) const
  {
    return m_maintained.torus().coincide({p, no_shift}, {q, shift_of_step(q, p)});
  }

  // If this point represents others at its vertex, one of them becomes the representative instead.
  void make_duplicate_if_shared(Index id)
  {
    if (!ids().is_representative(id))
      return;
    const Index v = ids().vertex(id);
    const Index other = ids().find_duplicate_at(v, [](const auto&) { return true; });
    if (other == no_index)
      return;
    const Position_2 before = m_maintained.positions()[v], p = ids().duplicate(other).point;
    m_editor.ids().provide_for_duplicates(1);
    m_editor.hand_over(other, p, before, shift_of_step(before, p));
  }

  // Makes a vertex for a point with a reserved id or the id of a duplicate, or makes the point a
  // duplicate where a vertex is.
  void place(Index id, const Position_2& p, Update_report_2& report)
  {
    m_editor.ids().provide_for_duplicates(1);
    if (m_maintained.number_of_vertices() == 0) {
      const auto basis = short_basis(m_maintained.torus());
      m_editor.start(p, basis[0], basis[1]);
      m_editor.ids().place_representative(id, 1);
      m_editor.provide_for_log(3);
      m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_CREATED);
      m_open = {0, 1, 2};
      return legalize(report);
    }
    const Place found = locate(p);
    if (found.corner != no_index)
      return m_editor.ids().place_duplicate(id, m_maintained.mirror().apex(found.corner), p);
    const Slot slot = m_editor.make_slot();
    m_editor.ids().place_representative(id, slot.vertex);
    put_in(slot, p, found, report);
  }

  // The same for many points, in an order in which each is near to the one before.
  void place_all(const std::vector<Index>& ids, const std::vector<Position_2>& points,
                 Update_report_2& report)
  {
    if (m_maintained.number_of_vertices() == 0 && build(ids, points, report))
      return;
    std::vector<Position_2> wrapped;
    for (const Position_2& p : points)
      wrapped.push_back(m_maintained.torus().wrapped(p));
    for_each_in_order(wrapped, [&](Index i) { place(ids[i], points[i], report); });
  }

  // Calls f(i) for all numbers of positions, each of which is near to the one before.
  template <class Function>
  void for_each_in_order(const std::vector<Position_2>& positions, const Function& f)
  {
    const boost::counting_iterator<Index> first(0), beyond(Index(positions.size()));
    m_order.sort(positions, first, beyond);
    for (std::size_t i = 0; i < m_order.size(); ++i)
      f(m_order[i]);
    m_order.release();
  }

  // Makes the first vertices, all at once. False, with no vertices, if that did not end certified,
  // as where points coincide or form a grid.
  bool build(const std::vector<Index>& ids, const std::vector<Position_2>& points,
             Update_report_2& report)
  {
    Periodic_builder_2 builder;
    if (!builder.run(m_maintained.torus(), points))
      return false;
    const std::size_t logged = m_editor.log().size();
    const typename Maintained::Ids ids_before = m_maintained.ids();
    m_editor.build(builder.faces(), points);
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
      m_editor.ids().place_representative(ids[builder.faces().points[v]], v);
    m_editor.provide_for_log(m_maintained.mirror().number_of_edges());
    m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_CREATED);
    Edge_test(m_maintained).append_unproved(m_open);
    std::size_t most = m_open.size() + points.size();
    if (flip_open(most, report))
      return true;
    Maintained empty(m_maintained.torus().cell());
    m_editor.swap(empty);
    m_editor.ids() = ids_before;
    m_editor.log().resize(logged, {});
    m_open.clear();
    return false;
  }

  // LOCATION ------------------------------------------------------------------------------------

  // A face, and the image of a point in its frame. The point may be on an edge, or at a corner.
  struct Place
  {
    Index face;
    Periodic_shift_2 shift;
    Index edge = no_index, corner = no_index; // half-edges of that face
  };

  // Walks through faces that are all counterclockwise and Delaunay, so the walk ends.
  Place locate(const Position_2& p)
  {
    const auto& mirror = m_maintained.mirror();
    while (m_hint > m_maintained.number_of_vertices() || mirror.is_outside(m_hint))
      m_hint = m_hint % m_maintained.number_of_vertices() + 1;
    const Index start = mirror.corner(m_hint);
    Place place{start / 3,
                m_maintained.shift(start) + shift_of_step(p, m_maintained.positions()[m_hint])};
    Index entry = no_index;
    for (Index h = exit_of(place, p, entry); h != no_index; h = exit_of(place, p, entry)) {
      place.shift = place.shift - m_maintained.transition(h);
      entry = mirror.twin(h);
      place.face = entry / 3;
    }
    return place;
  }

  // The half-edge through which to leave the face, or `no_index`. Then `place` is complete.
  Index exit_of(Place& place, const Position_2& p, Index entry) const
  {
    place.edge = place.corner = no_index;
    for (Index h = 3 * place.face; h < 3 * place.face + 3; ++h) {
      if (h == entry)
        continue;
      const Orientation turn = m_maintained.torus().orientation(
          m_maintained.image(Mirror::next(h)), m_maintained.image(Mirror::previous(h)),
          {p, place.shift});
      if (turn == RIGHT_TURN)
        return h;
      if (turn == COLLINEAR) {
        if (place.edge != no_index) // opposite to the third corner are neither of both edges
          place.corner = 9 * place.face + 3 - place.edge - h;
        place.edge = h;
      }
    }
    return no_index;
  }

  // FACES AND EDGES -----------------------------------------------------------------------------

  // Puts the slot's vertex where p was found, which is no vertex.
  void put_in(const Slot& slot, const Position_2& p, const Place& found, Update_report_2& report)
  {
    const auto& mirror = m_maintained.mirror();
    const Index v = slot.vertex;
    m_editor.put_in(slot, p, found.shift, found.face);
    m_hint = v;
    if (found.edge != no_index) { // a flat face, opposite to v in it the edge on which v is
      const std::array<Index, 3> faces{found.face, slot.faces[0], slot.faces[1]};
      const Index place = found.edge % 3;
      m_editor.flip(3 * faces[place] + place);
    }
    mirror.for_each_corner(v, [&](Index h) { m_open.push_back(mirror.edge_of(h)); });
    legalize(report);
  }

  // The same where p is not located yet. If a vertex is there, it gets the points of the slot's
  // vertex, and the result is false.
  bool put_back(const Slot& slot, const Position_2& p, Update_report_2& report)
  {
    const Place found = locate(p);
    if (found.corner == no_index) {
      put_in(slot, p, found, report);
      return true;
    }
    m_editor.ids().provide_for_duplicates(1);
    m_editor.ids().merge(slot.vertex, m_maintained.mirror().apex(found.corner), p);
    ++report.merged;
    return false;
  }

  // Takes vertices out of their faces, and opens the edges around. If that fails the result is
  // false, and all that can be done is to triangulate anew.
  bool take_out(const std::vector<Index>& vertices, bool are_tangled, Update_report_2& report)
  {
    m_open.reserve(m_open.size() + 8 * vertices.size());
    for (const Index v : vertices) {
      if (!reduce_degree(v, are_tangled, report))
        return false;
      const Index f = m_maintained.mirror().corner(v) / 3;
      m_taken_out.push_back(m_editor.take_out(v));
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        m_open.push_back(m_maintained.mirror().edge_of(h));
    }
    const auto is_empty = [this](Index e) { return m_maintained.mirror().is_empty_edge(e); };
    m_open.erase(std::remove_if(m_open.begin(), m_open.end(), is_empty), m_open.end());
    return true;
  }

  // Flips edges of v until it has degree 3. False if that is not possible. It can fail for
  // a vertex with edges to its own images, where cutting an ear changes the star at two places.
  // Among tangled faces any ear will do if there is no counterclockwise one.
  bool reduce_degree(Index v, bool is_tangled, Update_report_2& report)
  {
    const auto& mirror = m_maintained.mirror();
    for (Index degree = mirror.degree(v); degree != 3; degree = mirror.degree(v)) {
      Index spoke = degree > 3 ? find_ear(v, false) : no_index;
      if (spoke == no_index && degree > 3 && is_tangled)
        spoke = find_ear(v, true);
      if (spoke == no_index)
        return false;
      m_open.push_back(mirror.edge_of(spoke));
      mirror.for_each_side(mirror.edge_of(spoke), [this](Index e) { m_open.push_back(e); });
      m_editor.flip(spoke);
      ++report.flips;
    }
    bool is_simple = true;
    mirror.for_each_neighbor(v, [&](Index w) { is_simple = is_simple && w != v; });
    return is_simple;
  }

  // A half-edge to v whose flip cuts a face off v's star: any, or a counterclockwise one that
  // leaves a star whose faces are at worst flat. Fewer edges then end at v, also where v is its own
  // neighbor.
  Index find_ear(Index v, bool is_any) const
  {
    const auto& mirror = m_maintained.mirror();
    const Torus_2& torus = m_maintained.torus();
    const Index first = mirror.corner(v);
    Index h = first;
    do {
      const Index spoke = Mirror::next(h);
      const auto [a, b, c, d] = m_maintained.corners_at(spoke);
      const Index opposite = mirror.apex(mirror.twin(spoke));
      const int ends = (mirror.source(spoke) == v) + 1;
      const int ends_after = (mirror.apex(spoke) == v) + (opposite == v);
      if (ends_after < ends && m_editor.can_flip(spoke) &&
          (is_any ||
           (torus.orientation(a, b, d) == LEFT_TURN && torus.orientation(a, d, c) != RIGHT_TURN)))
        return spoke;
      h = mirror.next_corner(h);
    } while (h != first);
    return no_index;
  }

  bool is_counterclockwise(Index h) const
  {
    return m_maintained.torus().orientation(m_maintained.image(h),
                                            m_maintained.image(Mirror::next(h)),
                                            m_maintained.image(Mirror::previous(h))) == LEFT_TURN;
  }

  bool are_faces_counterclockwise(Index v) const
  {
    bool are = true;
    m_maintained.mirror().for_each_corner(v, [&](Index h) { are = are && is_counterclockwise(h); });
    return are;
  }

  void open_surroundings(Index v)
  {
    const auto& mirror = m_maintained.mirror();
    mirror.for_each_corner(v, [&](Index h) {
      m_open.push_back(mirror.edge_of(h));
      m_open.push_back(mirror.edge_of(Mirror::next(h)));
    });
  }

  // Flips the open edges, all of counterclockwise faces, until all edges are Delaunay.
  void legalize(Update_report_2& report)
  {
    while (!m_open.empty())
      report.flips += m_flips.run(m_maintained, m_editor, m_open, false,
                                  (std::numeric_limits<std::size_t>::max)());
  }

  // Repairs everything after the vertices have moved, but leaves those out that cannot stay in
  // their faces. False if that does not help.
  bool untangle(Update_report_2& report)
  {
    // three flips for two vertices cost about as much as triangulating anew
    std::size_t most = 100 + 3 * std::size_t(m_maintained.number_of_vertices()) / 2;
    m_safe_edges.append_unproved(frame(), m_open);
    for (int round = 0; !flip_open(most, report); ++round) {
      const std::vector<Index> tangled = find_tangled();
      if (round == max_rounds || m_taken_out.size() + tangled.size() > max_taken_out() ||
          !take_out(tangled, true, report))
        return false;
    }
    return true;
  }

  // Flips the open edges, of faces in any order, and takes the flips off `most`. False if flips do
  // not help, or are used up.
  bool flip_open(std::size_t& most, Update_report_2& report)
  {
    while (!m_open.empty()) {
      const std::size_t flips = m_flips.run(m_maintained, m_editor, m_open, false, most);
      most -= flips;
      report.flips += flips;
      if (!m_open.empty() && (flips == 0 || most == 0))
        return false;
    }
    return true;
  }

  // FRAMES --------------------------------------------------------------------------------------

  using Frame = Periodic_frame_2<Maintained, Editor>;
  Frame frame() const { return Frame(m_maintained, m_editor.news(), m_staged); }

  // Stages the positions of the vertices, and finds which of them come nearest to where they were
  // by a translation, in multiples of the new cell's vectors: points that leave the cell and come
  // in at the other side do not go far. Also finds those that go far otherwise, compared to the
  // last frame's mean motion. The result is that of stage().
  template <bool is_same, class Next>
  bool stage_vertices(const Next& next, const Torus_2& now)
  {
    m_staged.resize(m_maintained.positions().size());
    m_staged[infinite_index] = nowhere();
    m_translated.clear();
    m_far.clear();
    const double long_way = squared_long_way();
    const Index* const representatives = ids().representatives();
    const Index vertices = m_maintained.number_of_vertices();
    const Index end_of_prefetching =
        vertices < min_vertices_to_prefetch ? 0 : vertices - prefetched_ahead;
    bool are_in_range = true;
    Position_2 sum{0, 0};
    for (Index v = 1; v <= vertices; ++v) {
      if (v < end_of_prefetching)
        next.prefetch(representatives[v + prefetched_ahead]);
      const Position_2& p = m_maintained.positions()[v];
      const Position_2 q = next(representatives[v]), multiples = now.multiples(q);
      are_in_range &= is_in_range(multiples, now);
      m_staged[v] = q;
      Position_2 way{q.x - p.x, q.y - p.y};
      const Position_2 step = is_same ? now.multiples(way) : step_to_new_cell(p, multiples);
      if (!is_same || !(std::abs(step.x) <= 0.5 && std::abs(step.y) <= 0.5)) {
        if (!are_in_range)
          return false; // a shift may be no integer
        const Periodic_shift_2 shift = now.nearest_shift(step);
        if (!are_equal(shift, no_shift))
          m_translated.push_back({v, shift});
        way = now.vector({step.x - shift[0], step.y - shift[1]});
      }
      sum = {sum.x + way.x, sum.y + way.y};
      if (squared_distance(way, m_mean_way) > long_way)
        m_far.push_back({v, way});
    }
    m_mean_way = vertices > 0 ? Position_2{sum.x / vertices, sum.y / vertices} : Position_2{0, 0};
    return are_in_range;
  }

  static bool is_in_range(const Position_2& multiples, const Torus_2& torus)
  {
    const Position_2 m = torus.periodic(multiples);
    return std::abs(m.x) < max_shift && std::abs(m.y) < max_shift;
  }

  // From p in the old cell to a position in the new one, in multiples of the new cell's vectors.
  Position_2 step_to_new_cell(const Position_2& p, const Position_2& multiples) const
  {
    const Position_2 s = m_maintained.torus().multiples(p);
    return {multiples.x - (s.x * m_multiples[0][0] + s.y * m_multiples[1][0]),
            multiples.y - (s.x * m_multiples[0][1] + s.y * m_multiples[1][1])};
  }

  static double squared_distance(const Position_2& p, const Position_2& q)
  {
    return CGAL::square(p.x - q.x) + CGAL::square(p.y - q.y);
  }

  // A quarter of the spacing.
  double squared_long_way() const
  {
    return area_of_points() / m_maintained.number_of_vertices() / 16;
  }

  // That of the cell. In a slab that of the strip with all points, or, where that is thin, of
  // squares between points in a row.
  double area_of_points() const
  {
    const Torus_2& torus = m_maintained.torus();
    if (!torus.cell().is_slab())
      return torus.cell().area();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v) {
      const double height = torus.multiples(m_maintained.positions()[v]).y;
      low = (std::min)(low, height);
      high = (std::max)(high, height);
    }
    const double length = std::hypot(torus.cell().ax(), torus.cell().ay());
    return length * (std::max)(high - low, length / m_maintained.number_of_vertices());
  }

  // So many vertices are at most taken out and put back: more are as much work as triangulating
  // anew.
  std::size_t max_taken_out() const { return 10 + m_maintained.number_of_vertices() / 6; }

  // Whether three of ten edges of a sample are not Delaunay: repairing takes more flips then than
  // triangulating anew takes time. Where points flow, all may go far, and break few edges.
  bool is_much_broken() const
  {
    constexpr Index sample_size = 100;
    const Index edges = m_maintained.mirror().number_of_edges();
    const Edge_test test(m_maintained);
    Index broken = 0;
    for (Index i = 0; i < sample_size; ++i)
      broken += test.state(Index(std::uint64_t(i) * edges / sample_size)) != Edge_state_2::DELAUNAY;
    return 10 * broken > 3 * sample_size;
  }

  // Points that go farther than half the way to their nearest neighbors, and would tangle the faces
  // on their way.
  std::vector<Index> find_jumpers() const
  {
    std::vector<Index> jumpers;
    const double long_way = squared_long_way();
    for (const auto& [v, way] : m_far) {
      const double squared = squared_distance(way, m_mean_way);
      if (squared > long_way && 4 * squared > squared_distance_to_neighbors(v))
        jumpers.push_back(v);
    }
    return jumpers;
  }

  double squared_distance_to_neighbors(Index v) const
  {
    double least = std::numeric_limits<double>::infinity();
    const Torus_2& torus = m_maintained.torus();
    m_maintained.mirror().for_each_corner(v, [&](Index h) {
      const Image_2 p = m_maintained.image(h), q = m_maintained.image(Mirror::next(h));
      if (!torus.are_across(p.shift, q.shift))
        least = (std::min)(least, squared_distance(torus.rounded(p), torus.rounded(q)));
    });
    return least;
  }

  // Vertices of faces that flips could not turn counterclockwise.
  std::vector<Index> find_tangled() const
  {
    const auto& mirror = m_maintained.mirror();
    std::vector<Index> tangled;
    for (const Index e : m_open)
      for (const Index h : {mirror.halfedge(e), mirror.twin(mirror.halfedge(e))})
        if (!is_counterclockwise(h))
          for (const Index v : mirror.face(h / 3))
            tangled.push_back(v);
    make_distinct(tangled);
    return tangled;
  }

  void move_vertices(const Periodic_cell_2& cell)
  {
    if (cell != m_maintained.torus().cell())
      m_editor.set_cell(cell, m_multiples);
    m_editor.exchange_positions(m_staged);
    for (const auto& [v, shift] : m_translated)
      if (!m_maintained.mirror().is_outside(v))
        m_editor.shift_images(v, shift);
  }

  // Returns the duplicates that are no longer where their vertices are.
  template <class Next>
  std::vector<Index> move_duplicates(const Next& next)
  {
    std::vector<Index> parted;
    for (auto& duplicate : m_editor.ids().duplicates()) {
      duplicate.point = next(duplicate.id);
      if (!coincide(duplicate.point, m_maintained.positions()[ids().vertex(duplicate.id)]))
        parted.push_back(duplicate.id);
    }
    return parted;
  }

  // Puts the vertices that were taken out where their positions are.
  void put_back_all(Update_report_2& report)
  {
    std::vector<Position_2> wrapped;
    for (const Slot& slot : m_taken_out)
      wrapped.push_back(m_maintained.torus().wrapped(m_maintained.positions()[slot.vertex]));
    std::vector<Slot> merged;
    for_each_in_order(wrapped, [&](Index i) {
      const Slot& slot = m_taken_out[i];
      if (!put_back(slot, Position_2(m_maintained.positions()[slot.vertex]), report))
        merged.push_back(slot);
    });
    m_editor.drop(merged);
    report.relocated += m_taken_out.size();
  }

  static constexpr int max_rounds = 8;
  static constexpr Index prefetched_ahead = 64; // points

  Maintained& m_maintained;
  Editor m_editor;
  Lawson_flips_2 m_flips;
  Periodic_safe_edges_2 m_safe_edges;
  Spatial_order_2 m_order;
  Index m_hint = 1;              // where the next walk starts
  std::vector<Index> m_open;     // edges to examine
  std::vector<Slot> m_taken_out; // of vertices to be put back

  // Of a frame.
  std::vector<Position_2> m_staged; // by vertices: of this frame, and then of the last one
  std::vector<std::pair<Index, Periodic_shift_2>> m_translated;
  std::vector<std::pair<Index, Position_2>> m_far; // vertices and their ways
  Position_2 m_mean_way{0, 0};
  std::array<Periodic_shift_2, 2> m_multiples = unit_multiples; // of the old cell's vectors
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_UPDATE_2_H
