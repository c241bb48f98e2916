// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_REPAIR_TOOLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_REPAIR_TOOLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_change_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Lawson_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Point_location_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The tools that repair a periodic triangulation, and their state: the open edges, the vertices
// outside of all faces, the flips that are left, and the report. `Dynamic_mender_2` offers some of
// them to a repair; `Periodic_update_2` uses the others itself.
template <class State, class Editor>
class Periodic_repair_tools_2
{
  using Arrays = Halfedge_arrays_2;
  using Slot = Arrays::Slot;
  using Edge_test = typename State::Edge_test;
  using Parts = typename State::Parts;
  using Place = Place_2<State>;

public:
  using Classification = Dynamic_classification_2<State>;

  Periodic_repair_tools_2(State& state, Editor& editor)
    : m_state(state)
    , m_editor(editor)
    , m_location(state)
  {
  }

  const Static_engines_2& engines() const { return m_engines; }
  void set_engines(const Static_engines_2& engines) { m_engines = engines; }

  // Where the next walk starts.
  Index hint() const { return m_hint; }
  void set_hint(Index v) { m_hint = v; }

  // A CALL --------------------------------------------------------------------------------------

  // `has_to_prove`: whether the call has to end with a certified triangulation.
  void start(Update_report_2& report, bool has_to_prove)
  {
    m_report = &report;
    m_has_to_prove = has_to_prove;
    m_open.clear();
    m_taken_out.clear();
    forget_sets();
    m_flips_left = 100 + 8 * std::size_t(m_state.number_of_vertices());
  }

  Classification& classification() { return m_classification; }

  // To be called after the classifier.
  void take_classification()
  {
    m_report->classified = m_classification.size();
    m_open = m_classification.edges();
    if (m_classification.is_everything()) {
      m_open.resize(number_of_edges());
      std::iota(m_open.begin(), m_open.end(), Index(0));
    } else {
      const auto& arrays = m_state.arrays();
      for (const Index v : m_classification.whole_vertices())
        if (!arrays.is_outside(v))
          arrays.for_each_corner(
              v, [&](Index h) { m_open.push_back(arrays.edge_of(Arrays::previous(h))); });
    }
    // in the order of space: in another one 1,000 points at steps of 0.03 spacings took 3.1 instead
    // of 2.7 relocations a frame
    make_distinct(m_open);
    close_empty();
  }

  // Opens all edges that may not be Delaunay: after that the call can end with a proof.
  void examine_everything()
  {
    m_has_to_prove = true;
    std::vector<std::vector<Index>> open(Parts::number(number_of_edges()));
    Parts::for_each(number_of_edges(),
                    [&](std::size_t part, std::size_t first, std::size_t beyond) {
                      Edge_test(m_state).append_unproved(Index(first), Index(beyond), open[part]);
                    });
    m_open.clear();
    for (const std::vector<Index>& of_part : open)
      m_open.insert(m_open.end(), of_part.begin(), of_part.end());
  }

  // Whether three of ten edges of a sample are not Delaunay: repairing takes more flips then than
  // triangulating anew takes time. Where points flow, all may go far, and break few edges.
  bool is_much_broken() const
  {
    constexpr Index sample_size = 100;
    const Index edges = Index(number_of_edges());
    const Edge_test test(m_state);
    Index broken = 0;
    for (Index i = 0; i < sample_size; ++i)
      broken += test.state(Index(std::uint64_t(i) * edges / sample_size)) != Edge_state_2::DELAUNAY;
    return 10 * broken > 3 * sample_size;
  }

  // Triangulates all points anew, but for the one with the id `gone`, which is removed.
  void rebuild(Rebuild_reason_2 reason, Index gone = null_index)
  {
    m_report->rebuild_reason = reason;
    m_open.clear();
    m_taken_out.clear();
    forget_sets();
    std::vector<Index> taken;
    std::vector<Position_2> points;
    for (Index id = 0; id < ids().number_of_ids(); ++id)
      if (ids().is_taken(id) && id != gone)
        taken.push_back(id);
    points.resize(taken.size());
    Parts::for_each(taken.size(), [&](std::size_t, std::size_t first, std::size_t beyond) {
      for (std::size_t i = first; i < beyond; ++i)
        points[i] = m_state.position_of_id(taken[i]);
    });
    const Index number_of_ids = ids().number_of_ids();
    const std::size_t logged = m_editor.log().size();
    m_editor.reserve_for_log(m_state.arrays().number_of_edges());
    m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_REMOVED);
    State before(m_state.torus().cell());
    m_editor.swap(before);
    try {
      m_editor.ids().reset(number_of_ids);
      const Update_report_2 counts = *m_report;
      place_all(taken, points);
      *m_report = counts; // a rebuild counts no flips
      m_editor.ids().settle();
    } catch (...) {
      m_editor.swap(before); // which still has all points
      m_editor.log().resize(logged, {});
      throw;
    }
  }

  // STATE ---------------------------------------------------------------------------------------

  const std::vector<Index>& padded() const { return m_padded; }
  const std::vector<Index>& border() const { return m_border; }
  const Classification& classification() const { return m_classification; }
  bool has_to_prove() const { return m_has_to_prove; }
  bool has_rebuilt() const { return m_report->rebuilt(); }
  std::size_t number_of_edges() const { return m_state.arrays().number_of_edges(); }
  std::size_t number_of_open_edges() const { return m_open.size(); }
  bool has_inverted_edges() const { return !find_tangled().empty(); }

  // Whether three of ten edges are open; see is_much_broken().
  bool is_rebuild_cheaper() const { return 10 * m_open.size() > 3 * number_of_edges(); }

  // So many vertices are at most taken out and put back: more are as much work as triangulating
  // anew.
  std::size_t max_taken_out() const { return 10 + m_state.number_of_vertices() / 6; }

  // TOOLS, as Dynamic_mender_2 documents them ----------------------------------------------------

  // Three flips for two vertices cost about as much as triangulating anew.
  void limit_cost() { m_flips_left = 100 + 3 * std::size_t(m_state.number_of_vertices()) / 2; }

  void take_out_jumpers() {} // they are out since before anything has moved
  void take_out_farthest() {}

  void flip()
  {
    if (!flip_open() && m_flips_left == 0)
      rebuild(Rebuild_reason_2::BUDGET_SPENT);
  }
  void flip_inverted() { flip(); }

  void splice_classified(unsigned padding)
  {
    if (has_rebuilt())
      return;
    std::vector<Index> region = m_classification.vertices();
    m_padded = pad(region, padding);
    for (const Index v : region)
      if (!m_state.arrays().is_outside(v))
        open_surroundings(v);
    m_border = pad(region, 1);
    m_report->padded = m_padded.size();
    m_report->border = m_border.size();
    flip();
    if (has_inverted_edges())
      splice_inverted(0);
    if (!m_has_to_prove)
      m_open.clear();
  }

  void splice_open(unsigned padding)
  {
    require_proof();
    std::vector<Index> vertices;
    for (const Index e : m_open) {
      const Edge_2 edge = m_state.edge(e);
      vertices.insert(vertices.end(), {edge.source, edge.target, edge.left, edge.right});
    }
    make_distinct(vertices);
    renew(vertices, padding);
  }

  void splice_inverted(unsigned padding)
  {
    require_proof();
    renew(find_tangled(), padding);
  }

  void relocate()
  {
    require_proof();
    if (has_rebuilt())
      return;
    renew(m_classification.vertices(), 0);
  }

  // POINTS --------------------------------------------------------------------------------------

  Periodic_shift_2 shift_of_step(const Position_2& from, const Position_2& to) const
  {
    return m_state.shift_of_step(from, to);
  }

  // Whether two points differ by a vector of the lattice.
  bool coincide(const Position_2& p, const Position_2& q) const
  {
    return m_state.torus().coincide(p, q);
  }

  // If this point represents others at its vertex, one of them becomes the representative instead.
  void make_duplicate_if_shared(Index id)
  {
    if (!ids().is_representative(id))
      return;
    const Index v = ids().vertex(id);
    const Index other = ids().find_duplicate_at(v, [](const auto&) { return true; });
    if (other == null_index)
      return;
    const Position_2 before = m_state.positions()[v], p = ids().duplicate(other).point;
    m_editor.ids().reserve_for_duplicates(1);
    m_editor.exchange_representative(other, p, before, shift_of_step(before, p));
  }

  // Makes a vertex for a point with a reserved id or the id of a duplicate, or makes the point a
  // duplicate where a vertex is.
  void place(Index id, const Position_2& p)
  {
    m_editor.ids().reserve_for_duplicates(1);
    if (m_state.number_of_vertices() == 0) {
      const auto basis = short_basis(m_state.torus());
      m_editor.start(p, basis[0], basis[1]);
      m_editor.ids().place_representative(id, 1);
      m_editor.reserve_for_log(3);
      m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_CREATED);
      m_open = {0, 1, 2};
      return legalize();
    }
    const Slot slot = m_editor.make_slot();
    m_editor.set_position(slot.vertex, p);
    const Place found = locate(slot.vertex);
    if (found.vertex == null_index) {
      m_editor.ids().place_representative(id, slot.vertex);
      return put_in(slot, found);
    }
    m_editor.ids().place_duplicate(id, found.vertex, p);
    m_editor.drop({slot});
  }

  // The same for many points, in an order in which each is near to the one before.
  void place_all(const std::vector<Index>& ids, const std::vector<Position_2>& points)
  {
    if (m_state.number_of_vertices() == 0 && m_engines.whole == Static_engine_2::GUIBAS_STOLFI &&
        build(ids, points))
      return;
    std::vector<Position_2> wrapped;
    for (const Position_2& p : points)
      wrapped.push_back(m_state.torus().wrapped(p));
    for_each_in_order(wrapped, [&](Index i) { place(ids[i], points[i]); });
  }

  // Calls f(i) for all numbers of positions, each of which is near to the one before.
  template <class Function>
  void for_each_in_order(const std::vector<Position_2>& positions, const Function& f)
  {
    const boost::counting_iterator<Index> first(0), beyond(Index(positions.size()));
    m_order.sort(positions, first, beyond);
    for (std::size_t i = 0; i < m_order.size(); ++i) {
      f(m_order[i]);
      m_located_near = m_order.size(); // the next one
    }
    m_located_near = 1;
    m_order.release();
  }

  // Makes the first vertices, all at once. False, with no vertices, if that did not end certified,
  // as where points coincide or form a grid.
  bool build(const std::vector<Index>& ids, const std::vector<Position_2>& points)
  {
    Periodic_builder_2<Parts> builder;
    if (!builder.run(m_state.torus(), points))
      return false;
    const std::size_t logged = m_editor.log().size();
    const typename State::Ids ids_before = m_state.ids();
    m_editor.build(builder.faces(), ids, points);
    builder.release();
    m_editor.reserve_for_log(m_state.arrays().number_of_edges());
    m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_CREATED);
    examine_everything();
    m_flips_left = m_open.size() + points.size();
    if (flip_open())
      return true;
    State empty(m_state.torus().cell());
    m_editor.swap(empty);
    m_editor.ids() = ids_before;
    m_editor.log().resize(logged, {});
    m_open.clear();
    return false;
  }

  // Takes a vertex out of its faces where everything is Delaunay, and stays so. False, with nothing
  // done, where its faces meet their images.
  bool take_out_of_delaunay(Index v)
  {
    reserve_extra(m_taken_out, 1);
    if (!m_polygon.read(m_state, v))
      return false;
    m_polygon.triangulate_as_delaunay(m_state);
    m_taken_out.push_back(m_editor.take_out(m_polygon));
    return true;
  }

  // Takes vertices out of faces of any kind, and opens the edges around. If that fails the result
  // is false, and all that can be done is to triangulate anew.
  bool take_out_of_tangle(const std::vector<Index>& vertices)
  {
    reserve_extra(m_taken_out, vertices.size());
    for (const Index v : vertices) {
      if (!m_polygon.read(m_state, v) || !m_polygon.has_different_vertices())
        return false;
      m_polygon.triangulate_anyhow(m_state, m_state.positions()[v]);
      const std::size_t first_new = m_state.changes().new_edges.size();
      m_taken_out.push_back(m_editor.take_out(m_polygon));
      open_polygon(first_new);
    }
    close_empty();
    return true;
  }

  // Puts the vertices that were taken out where their positions are.
  void put_back_all()
  {
    std::vector<Position_2> wrapped;
    for (const Slot& slot : m_taken_out)
      wrapped.push_back(m_state.torus().wrapped(m_state.positions()[slot.vertex]));
    std::vector<Slot> merged;
    for_each_in_order(wrapped, [&](Index i) {
      const Slot& slot = m_taken_out[i];
      if (!put_back(slot))
        merged.push_back(slot);
    });
    if (!merged.empty())
      forget_sets();
    m_editor.drop(merged);
    m_report->relocated += m_taken_out.size();
    m_taken_out.clear();
  }

  // Deletes the vertices that were taken out, which have no points.
  void drop_taken_out()
  {
    m_editor.drop(m_taken_out);
    m_taken_out.clear();
  }

  // EDGES ---------------------------------------------------------------------------------------

  bool are_faces_counterclockwise(Index v) const
  {
    bool are = true;
    m_state.arrays().for_each_corner(v, [&](Index h) { are = are && is_counterclockwise(h); });
    return are;
  }

  void open_surroundings(Index v)
  {
    const auto& arrays = m_state.arrays();
    arrays.for_each_corner(v, [&](Index h) {
      m_open.push_back(arrays.edge_of(h));
      m_open.push_back(arrays.edge_of(Arrays::next(h)));
    });
  }

  // Flips the open edges, all of counterclockwise faces, until all edges are Delaunay.
  void legalize()
  {
    while (!m_open.empty())
      m_report->flips +=
          m_flips.run(m_state, m_editor, m_open, false, (std::numeric_limits<std::size_t>::max)());
  }

private:
  const typename State::Ids& ids() const { return m_state.ids(); }

  void close_empty()
  {
    const auto is_empty = [this](Index e) { return m_state.arrays().is_empty_edge(e); };
    m_open.erase(std::remove_if(m_open.begin(), m_open.end(), is_empty), m_open.end());
  }

  // Vertices can be put back only where all is proved.
  void require_proof()
  {
    if (m_has_to_prove)
      return;
    examine_everything();
    flip();
  }

  // Flips the open edges, of faces in any order. False if flips do not help, or none are left.
  bool flip_open()
  {
    while (!m_open.empty()) {
      const std::size_t flips = m_flips.run(m_state, m_editor, m_open, false, m_flips_left);
      m_flips_left -= flips;
      m_report->flips += flips;
      if (!m_open.empty() && (flips == 0 || m_flips_left == 0))
        return false;
    }
    return true;
  }

  // Adds layers of neighbors, and returns these.
  std::vector<Index> pad(std::vector<Index>& region, unsigned layers)
  {
    const auto& arrays = m_state.arrays();
    m_region.clear(m_state.positions().size());
    for (const Index v : region)
      m_region.insert(v);
    for (unsigned layer = 0; layer < layers; ++layer)
      for (std::size_t i = 0, size = m_region.size(); i < size; ++i)
        if (!arrays.is_outside(m_region[i]))
          arrays.for_each_neighbor(m_region[i], [this](Index w) { m_region.insert(w); });
    const auto beyond = m_region.begin() + std::ptrdiff_t(region.size());
    region.insert(region.end(), beyond, m_region.end());
    return std::vector<Index>(beyond, m_region.end());
  }

  // To be called where vertices get other numbers.
  void forget_sets()
  {
    m_classification.clear(m_state);
    m_padded.clear();
    m_border.clear();
  }

  // Takes the vertices of a region out, to be put back when no edge is open, and flips around them.
  void renew(std::vector<Index> region, unsigned padding)
  {
    pad(region, padding);
    const auto is_outside = [this](Index v) { return m_state.arrays().is_outside(v); };
    region.erase(std::remove_if(region.begin(), region.end(), is_outside), region.end());
    if (m_taken_out.size() + region.size() > max_taken_out())
      rebuild(Rebuild_reason_2::TOO_MUCH_BROKEN);
    else if (!take_out_of_tangle(region))
      rebuild(Rebuild_reason_2::STUCK);
    flip();
  }

  // Vertices of faces that flips could not turn counterclockwise.
  std::vector<Index> find_tangled() const
  {
    const auto& arrays = m_state.arrays();
    std::vector<Index> tangled;
    for (const Index e : m_open)
      for (const Index h : {arrays.halfedge(e), arrays.twin(arrays.halfedge(e))})
        if (!is_counterclockwise(h))
          for (const Index v : arrays.face(h / 3))
            tangled.push_back(v);
    make_distinct(tangled);
    return tangled;
  }

  // LOCATION ------------------------------------------------------------------------------------

  // Locates a vertex that is outside of all faces; everything has to be Delaunay.
  Place locate(Index v)
  {
    const auto& arrays = m_state.arrays();
    while (m_hint > m_state.number_of_vertices() || arrays.is_outside(m_hint))
      m_hint = m_hint % m_state.number_of_vertices() + 1;
    const std::size_t vertices = m_state.number_of_vertices();
    const std::size_t spread = (std::min)(vertices, 4 * vertices / m_located_near);
    return m_location.locate(v, m_hint, Index(spread));
  }

  // FACES AND EDGES -----------------------------------------------------------------------------

  // Opens the sides of the polygon, and the edges that are new inside.
  void open_polygon(std::size_t first_new)
  {
    for (const auto& side : m_polygon.sides())
      m_open.push_back(side.edge);
    const auto& new_edges = m_state.changes().new_edges;
    m_open.insert(m_open.end(), new_edges.begin() + std::ptrdiff_t(first_new), new_edges.end());
  }

  // Puts the slot's vertex where it was found, which is at no other vertex. Everything has to be
  // Delaunay, and stays so.
  void put_in(const Slot& slot, const Place& found)
  {
    const auto& arrays = m_state.arrays();
    const Index v = slot.vertex;
    if (found.is_inside &&
        m_polygon.find_as_delaunay(m_state, found.face, found.frame, v, max_faces)) {
      m_polygon.add(slot);
      m_editor.put_in(m_polygon);
    } else
      put_in_and_flip(slot, found);
    // a neighbor, because the number of v itself says nothing about where it is
    m_hint = arrays.source(arrays.corner(v));
  }

  void put_in_and_flip(const Slot& slot, const Place& found)
  {
    const auto& arrays = m_state.arrays();
    m_editor.put_in(slot, no_shift - found.frame, found.face);
    if (found.edge != null_index) { // a flat face, opposite to v in it the edge on which v is
      const std::array<Index, 3> faces{found.face, slot.faces[0], slot.faces[1]};
      const Index place = found.edge % 3;
      m_editor.flip(3 * faces[place] + place);
    }
    arrays.for_each_corner(slot.vertex, [&](Index h) { m_open.push_back(arrays.edge_of(h)); });
    legalize();
  }

  // Puts a vertex back where it is now. If another vertex is there, it gets the points of the
  // slot's vertex, and the result is false.
  bool put_back(const Slot& slot)
  {
    const Place found = locate(slot.vertex);
    if (found.vertex == null_index) {
      put_in(slot, found);
      return true;
    }
    m_editor.ids().reserve_for_duplicates(1);
    m_editor.ids().merge(slot.vertex, found.vertex, m_state.positions()[slot.vertex]);
    ++m_report->merged;
    return false;
  }

  bool is_counterclockwise(Index h) const
  {
    return m_state.torus().orientation(m_state.image(h), m_state.image(Arrays::next(h)),
                                       m_state.image(Arrays::previous(h))) == LEFT_TURN;
  }

  static constexpr std::size_t max_faces = 64; // that a point replaces: flips take less time beyond

  State& m_state;
  Editor& m_editor;
  Star_polygon_2<State> m_polygon; // around the vertex that goes or comes
  Static_engines_2 m_engines;
  Classification m_classification;
  std::vector<Index> m_padded, m_border;
  Index_set_2 m_region;
  Update_report_2* m_report = nullptr;
  bool m_has_to_prove = true;
  std::size_t m_flips_left = 0;
  Lawson_flips_2 m_flips;
  Spatial_order_2 m_order;
  Point_location_2<State> m_location;
  Index m_hint = 1;               // where the next walk starts
  std::size_t m_located_near = 1; // so many points are located near to the one before
  std::vector<Index> m_open;      // edges to examine
  std::vector<Slot> m_taken_out;  // of vertices to be put back
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_REPAIR_TOOLS_2_H
