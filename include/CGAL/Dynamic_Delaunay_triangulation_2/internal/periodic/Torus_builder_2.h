// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_BUILDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_BUILDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Lawson_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Vertex_relocation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_visitor_calls_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_editing_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_triangulator_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Staying_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Writes a whole triangulation of a torus at once: triangulates from scratch, copies, or restores.
// After triangulating or restoring, everything counts as new.
template <class State>
class Torus_builder_2
{
  using Arrays = Halfedge_arrays_2;
  using Editor = Topology_editor_2<State>;
  using Kind = Periodic_change_2::Kind;
  using Parts = typename State::Parts;
  using Point = typename State::Point;
  using Writer = typename State::Writer;
  using Positions = typename Writer::Positions;

public:
  explicit Torus_builder_2(State& state)
    : m_state(state)
    , m_writer(state)
    , m_editing(state)
    , m_editor(state)
    , m_relocation(state, m_editor)
    , m_staying(state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_engine = engine; }

  void rebuild() { build_with({}, {}, {}); }

  // Triangulates the present points except those in `gone`, and the points that come. If it throws,
  // nothing has changed.
  void build_with(const std::vector<Point_id>& gone, std::vector<Point_id> coming_ids,
                  std::vector<Point> coming_points)
  {
    try {
      build(m_staying.collect(gone, std::move(coming_ids), std::move(coming_points)));
    } catch (...) {
      m_staying.forget();
      throw;
    }
    m_staying.forget();
  }

  // Makes the triangulation, which must be empty, a copy of another one. The visitor is not called.
  // If this throws, the copy can only be discarded.
  void copy(const State& other)
  {
    m_writer.copy(other);
    m_writer.cell_changes() = other.number_of_cell_changes();
    ids() = other.ids();
    m_writer.changes() = other.changes();
  }

  // Restores a triangulation that was kept, and must be valid, into one without points. `shifts`
  // are those of the apexes of half-edges. If memory runs out, the target can only be discarded.
  void restore(const Torus_2& torus, const Checkpoint_arrays_2<Point>& kept,
               const typename State::Shifts& shifts)
  {
    Periodic_faces_2 faces;
    for (Halfedge_index h(0); h < Index(shifts.size()); ++h) {
      const Flat_halfedge_index flat = Flat_faces_2::from_arrays(h);
      faces.apexes.push_back(kept.faces.apex(flat));
      faces.twins.push_back(Flat_faces_2::number_in_arrays(kept.faces.twin(flat)));
    }
    m_writer.set_torus(torus);
    faces.shifts = shifts;
    write_points(kept.points.size(), [&](Vertex_index v) { return kept.points[v - 1]; });
    write_faces(faces, [] {});
    for (Edge_index e(0); e < arrays().number_of_edges(); ++e)
      arrays().set_edge(e, kept.forward_halfedges[e]);
    for (Vertex_index v(1); v < arrays().number_of_vertices(); ++v)
      arrays().set_corner(v, kept.corners[v - 1]);
    hide_shifted_edges();
    ids() = kept.ids;
  }

  // Reserves the memory that exchange() needs.
  void reserve_for_exchange(const State& other)
  {
    m_editing.reserve(std::size_t(arrays().number_of_edges()) + other.arrays().number_of_edges());
  }

  // Exchanges everything with another triangulation, except the user's visitor. Throws nothing
  // after reserve_for_exchange().
  void exchange(State& other)
  {
    m_editing.note_all_edges(Kind::EDGE_REMOVED);
    exchange_content(other);
    const Writer others(other);
    std::swap(m_writer.changes(), others.changes());
    std::swap(m_writer.cell_changes(), others.cell_changes());
    m_editing.note_all_edges(Kind::EDGE_CREATED);
  }

private:
  Writable_halfedge_arrays_2& arrays() { return m_writer.arrays(); }
  typename State::Ids& ids() { return m_writer.ids(); }

  void exchange_content(State& other)
  {
    m_writer.exchange(other);
    std::swap(ids(), Writer(other).ids());
  }

  // BUILDING ------------------------------------------------------------------------------------

  // Triangulates these points. Where points coincide, one that keeps its vertex becomes the
  // representative, if any of these is among them.
  void build(const Points_to_build_2<Point>& all)
  {
    const std::size_t logged = m_editing.log().size();
    m_editing.reserve(arrays().number_of_edges());
    State before(m_state.argument());
    m_editing.note_all_edges(Kind::EDGE_REMOVED);
    exchange_content(before);
    try {
      m_writer.changes().everything_is_new = true;
      m_writer.positions().forget_previous();
      ids().template reset<Parts>(all.number_of_ids);
      if (!all.ids.empty() && !triangulate(all.ids, all.points))
        insert(all.ids, all.points, number_of_first(all.ids, before.ids()));
      ids().finish_numbering();
    } catch (...) {
      m_relocation.forget();
      exchange_content(before);
      m_editing.log().resize(logged);
      throw;
    }
    release(before);
  }

  // Frees most of a state that is no longer used. Threads share the arrays: to give their memory
  // back takes a fiftieth of a rebuild.
  static void release(State& state)
  {
    const Writer writer(state);
    if (Parts::are_shared(Parts::number(state.number_of_vertices())))
      Parts::run(Parts::least_shared, [&](std::size_t part) {
        std::size_t arrays = 0;
        const auto release_one = [&](auto& array) {
          if (arrays++ == part)
            std::decay_t<decltype(array)>().swap(array);
        };
        writer.arrays().for_each_array(release_one);
        release_one(writer.shifts());
      });
  }

  // How many of the points that are built, the first ones, keep their vertices.
  std::size_t number_of_first(const std::vector<Point_id>& built,
                              const typename State::Ids& ids_before) const
  {
    const auto second = std::find_if(built.begin(), built.end(), [&](Point_id id) {
      return !m_staying.keeps_vertex(id, ids_before);
    });
    return std::size_t(second - built.begin());
  }

  // Triangulates all points at once. False if the result cannot be proved, as where points coincide
  // or form a grid: then there are no vertices.
  bool triangulate(const std::vector<Point_id>& point_ids, const std::vector<Point>& points)
  {
    if (m_engine != Static_engine_2::GUIBAS_STOLFI)
      return false;
    Torus_triangulator_2<Parts> triangulator;
    Position_vector positions(points.size());
    Parts::for_each_element(points.size(),
                            [&](std::size_t i) { positions[i] = approximation(points[i]); });
    if (!triangulator.run(m_state.torus(), positions))
      return false;
    const std::size_t logged = m_editing.log().size();
    Periodic_faces_2& faces = triangulator.faces();
    const std::size_t vertices = faces.points.size() - 1;
    write_points(vertices, [&](Vertex_index v) { return points[faces.points[v]]; });
    write_faces(faces, [&] {
      triangulator.release();
      Position_vector().swap(positions);
    });
    ids().resize(Index(vertices));
    Parts::for_each_element(vertices, [&](std::size_t i) {
      ids().set_representative(Vertex_index(i + 1), point_ids[faces.points[Vertex_index(i + 1)]]);
    });
    hide_shifted_edges();
    note_created_edges();
    std::vector<Edge_index> open;
    append_unproved(m_state, open);
    if (flip(open, open.size() + points.size()))
      return true;
    State empty(m_state.argument());
    Writer(empty).ids().reset(ids().number_of_ids());
    exchange_content(empty);
    m_editing.log().resize(logged);
    return false;
  }

  // Inserts one point after the other, those before `second` first.
  void insert(const std::vector<Point_id>& point_ids, const std::vector<Point>& points,
              std::size_t second)
  {
    start(point_ids.front(), points.front());
    insert_part(point_ids, points, 1, (std::max)(second, std::size_t(1)));
    insert_part(point_ids, points, (std::max)(second, std::size_t(1)), points.size());
  }

  void insert_part(const std::vector<Point_id>& all_ids, const std::vector<Point>& all_points,
                   std::size_t first, std::size_t beyond)
  {
    if (first == beyond)
      return;
    const auto i = std::ptrdiff_t(first), k = std::ptrdiff_t(beyond);
    std::vector<Point_id> point_ids(all_ids.begin() + i, all_ids.begin() + k);
    std::vector<Point> points(all_points.begin() + i, all_points.begin() + k);
    static constexpr std::size_t most_faces =
        64; // that one insertion replaces: for more, flips take less time
    m_relocation.announce_reserved(point_ids, points);
    m_relocation.put_in(
        {}, [] { return most_faces; },
        [this](Vertex_index v, std::size_t, std::size_t faces) {
          if (faces == 0)
            m_lawson.run_around(m_state, m_editor, v, m_open, any_number);
          return true;
        });
    m_relocation.finish();
  }

  // Makes the first vertex, with two faces over a basis r, t of the lattice:
  //
  //        t ------- r + t
  //       /  1    /  /
  //      /    /  0  /
  //     v ------- r
  void start(Point_id id, const Point& p)
  {
    const auto [r, t] = short_basis(m_state.torus());
    m_writer.positions().append(p);
    ids().append_vertex();
    ids().place_representative(id, Vertex_index(1));
    Periodic_faces_2 faces;
    faces.apexes.assign(6, Vertex_index(1));
    for (const int twin : {4, 5, 3, 2, 0, 1})
      faces.twins.emplace_back(twin);
    faces.shifts.assign({no_shift, r, r + t, no_shift, r + t, t});
    write_faces(faces, [] {});
    hide_shifted_edges();
    note_created_edges();
    m_open = {Edge_index(0), Edge_index(1), Edge_index(2)};
    flip(m_open, any_number);
  }

  // Flips these edges until all is Delaunay. False if flips do not help, or more than `most` would
  // be needed.
  bool flip(std::vector<Edge_index>& open, std::size_t most)
  {
    while (!open.empty()) {
      const std::size_t flips = m_lawson.run(m_state, m_editor, open, false, most);
      most -= flips;
      if (!open.empty() && (flips == 0 || most == 0))
        return false;
    }
    return true;
  }

  void note_created_edges()
  {
    m_editing.reserve(arrays().number_of_edges());
    m_editing.note_all_edges(Kind::EDGE_CREATED);
  }

  // WRITING -------------------------------------------------------------------------------------

  // Writes the points of all vertices, where vertex v has the point `point(v)`.
  template <class Function>
  void write_points(std::size_t vertices, const Function& point)
  {
    typename Positions::Stored_points points;
    Position_vector positions;
    m_writer.positions().template collect<Parts>(vertices, point, points, positions);
    m_writer.positions().exchange(points, positions);
  }

  // Writes the faces of all vertices, and frees their memory. One thread calls `companion()`
  // meanwhile.
  template <class Companion>
  void write_faces(Periodic_faces_2& faces, const Companion& companion)
  {
    m_writer.changes().everything_is_new = true;
    const Index vertices = m_state.number_of_vertices();
    m_writer.shifts().swap(faces.shifts);
    const auto apex_and_twin = [&](Face_index f, Index i) {
      const Halfedge_index h = Arrays::halfedge_in(f, i);
      return std::pair(faces.apexes[h], faces.twins[h]);
    };
    arrays().template write<Parts>(vertices, 2 * vertices, apex_and_twin, [&] {
      Uninitialized_vector<Vertex_index>().swap(faces.apexes);
      Uninitialized_vector<Halfedge_index>().swap(faces.twins);
      companion();
    });
  }

  // Hides the edges of faces that cross the border. One of an edge's faces hides it, so that no two
  // threads do.
  void hide_shifted_edges()
  {
    Parts::for_each_element(arrays().number_of_faces(), [&](std::size_t number) {
      const Face_index f(number);
      if (!m_state.crosses_border(f))
        return;
      for (const Halfedge_index h : Arrays::halfedges_of(f)) {
        const Face_index beyond = Arrays::face_of(arrays().twin(h));
        if (f <= beyond || !m_state.crosses_border(beyond))
          arrays().hide_edge(arrays().edge_of(h));
      }
    });
  }

  static constexpr std::size_t any_number = (std::numeric_limits<std::size_t>::max)();

  const State& m_state;
  const Writer m_writer;
  Torus_editing_2<State> m_editing;
  Editor m_editor;
  Vertex_relocation_2<State> m_relocation;
  Staying_points_2<State> m_staying;
  Lawson_flips_2 m_lawson;
  std::vector<Edge_index> m_open; // edges to examine
  Static_engine_2 m_engine = Static_engine_2::GUIBAS_STOLFI;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_BUILDER_2_H
