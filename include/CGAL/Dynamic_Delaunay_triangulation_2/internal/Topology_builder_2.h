// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_BUILDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_BUILDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulator_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_2.h>
#include <CGAL/enum.h>
#include <CGAL/Unique_hash_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Puts points into a spatial order, distinguishes representatives from duplicates, and numbers the
// vertices in that order. Where points coincide, a former representative is preferred.
template <class Maintained>
class Point_numbering_2
{
  using Point = typename Maintained::Point;
  using Ids = Point_ids_2<Point>;
  using Parts = typename Maintained::Parts;

public:
  explicit Point_numbering_2(const Maintained& maintained)
    : m_maintained(maintained)
  {
  }

  // Numbers these points with these ids. All ids are smaller than `number_of_ids`.
  void number(std::vector<Index> ids, std::vector<Point> points, Index number_of_ids)
  {
    m_point_ids = std::move(ids);
    m_points = std::move(points);
    sort_points();
    number_points(number_of_ids);
  }

  // The same for the vertices of the maintained triangulation, at their present positions and in
  // this order. No vertices may coincide, and there must be no duplicates.
  void number(Spatial_order_2 order)
  {
    const Index vertices = m_maintained.number_of_vertices();
    m_order = std::move(order);
    m_point_ids.resize(vertices + std::size_t(1)); // the infinite vertex has no point
    m_points.resize(vertices + std::size_t(1));
    Parts::for_each(vertices, [&](std::size_t, std::size_t first, std::size_t beyond) {
      for (Index v = Index(first) + 1; v <= beyond; ++v) {
        m_point_ids[v] = m_maintained.ids().representative(v);
        m_points[v] = m_maintained.point(v);
      }
    });
    number_points(m_maintained.ids().number_of_ids());
  }

  // The same for all points of the maintained triangulation, at their present positions.
  void number()
  {
    const Ids& ids = m_maintained.ids();
    std::vector<Index> point_ids = ids.representatives_and_duplicates();
    std::vector<Point> points;
    points.reserve(point_ids.size());
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
      points.push_back(m_maintained.point(v));
    for (const auto& duplicate : ids.duplicates())
      points.push_back(duplicate.point);
    number(std::move(point_ids), std::move(points), ids.number_of_ids());
  }

  // The vertices, by their new numbers.
  const Spatial_order_2& order() const { return m_order; }
  // The results: the ids, and the point of each vertex.
  Ids& ids() { return m_ids; }
  const Point& point(Index vertex) const { return m_points[m_place_of_vertex[vertex - 1]]; }

  // Free memory that is not needed any more: the points, the order, and all the rest. Throw
  // nothing.
  void release_points()
  {
    std::vector<Point>().swap(m_points);
    std::vector<Index>().swap(m_point_ids);
    std::vector<Index>().swap(m_place_of_vertex);
  }
  void release_order() { m_order.release(); }
  void release()
  {
    release_points();
    release_order();
    m_ids = Ids();
  }

private:
  // Replaces the indices of points in the order by numbers of vertices.
  void number_points(Index number_of_ids)
  {
    const auto are_in_one_place = [this](Index i, Index j) {
      return coincide(m_maintained.traits(), m_points[i], m_points[j]);
    };
    m_ids.reset(number_of_ids);
    m_place_of_vertex.clear();
    m_place_of_vertex.reserve(m_points.size());
    if (m_order.template are_distinct<Parts>(are_in_one_place))
      number_distinct_points();
    else
      m_order.merge_coincident(are_in_one_place, [this](std::size_t first, std::size_t beyond) {
        return add_vertex(first, beyond);
      });
    m_ids.settle();
  }

  // Each point gets a vertex, so threads need not know of each other's.
  void number_distinct_points()
  {
    m_place_of_vertex.resize(m_order.size());
    m_ids.resize(Index(m_order.size()));
    Parts::for_each(m_order.size(), [&](std::size_t, std::size_t i, std::size_t beyond) {
      for (; i < beyond; ++i) {
        const Index place = m_order[i], vertex = Index(i) + 1;
        m_place_of_vertex[i] = place;
        m_ids.set_representative(vertex, m_point_ids[place]);
        m_order.renumber(i, vertex);
      }
    });
  }

  void sort_points()
  {
    const boost::counting_iterator<Index> first(0), beyond(Index(m_points.size()));
    if (m_maintained.positions_are_exact()) {
      std::vector<Position_2> positions(m_points.size());
      Parts::for_each(m_points.size(), [&](std::size_t, std::size_t i, std::size_t end) {
        for (; i < end; ++i)
          positions[i] = approximation(m_points[i]);
      });
      m_order.template sort<Parts>(positions, first, beyond);
    } else
      m_order.sort_by_comparisons(first, beyond, [this](Index i, Index j) {
        return compare_xy(m_maintained.traits(), m_points[i], m_points[j]) == SMALLER;
      });
  }

  // Adds a vertex for the coincident points in these places of the order.
  Index add_vertex(std::size_t first, std::size_t beyond)
  {
    std::size_t representative = first;
    while (representative + 1 < beyond && !was_representative(m_point_ids[m_order[representative]]))
      ++representative;
    if (!was_representative(m_point_ids[m_order[representative]]))
      representative = first;
    const Index id = m_point_ids[m_order[representative]];
    const Index vertex = m_ids.add_representative(id);
    m_place_of_vertex.push_back(m_order[representative]);
    for (std::size_t i = first; i < beyond; ++i)
      if (i != representative)
        m_ids.add_duplicate(m_point_ids[m_order[i]], id, m_points[m_order[i]]);
    return vertex;
  }

  bool was_representative(Index id) const
  {
    const Ids& ids = m_maintained.ids();
    return ids.is_taken(id) && ids.is_representative(id);
  }

  const Maintained& m_maintained;
  Spatial_order_2 m_order;
  std::vector<Point> m_points; // the points to number
  std::vector<Index> m_point_ids;
  std::vector<Index> m_place_of_vertex; // index in m_points of its representative
  Ids m_ids;
};

// Writes the whole topology at once, into the CGAL triangulation and the mirror: triangulates from
// scratch, restores, or reads back what CGAL has changed. Afterwards everything is new.
template <class Maintained>
class Topology_builder_2
{
  using Topology = typename Maintained::Topology;
  using Positions = typename Maintained::Positions;
  using Point = typename Maintained::Point;
  using Vertex_handle = typename Maintained::Vertex_handle;
  using Face_handle = typename Maintained::Face_handle;
  using Ids = Point_ids_2<Point>;
  using Parts = typename Maintained::Parts;
  using Static_triangulation = Static_triangulation_2<typename Maintained::Traits>;

public:
  explicit Topology_builder_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_topology(maintained.m_topology)
    , m_positions(maintained.m_positions)
    , m_vertex_order(maintained)
    , m_numbering(maintained)
    , m_triangulator(maintained)
  {
  }

  void set_engine(Static_engine_2 engine) { m_triangulator.set_engine(engine); }

  // Replaces everything by a fresh triangulation of these points with these ids, all of which are
  // smaller than `number_of_ids`. Points that are present already keep their vertices.
  void build(std::vector<Index> ids, std::vector<Point> points, Index number_of_ids)
  {
    write_all_anew([&] {
      m_numbering.number(std::move(ids), std::move(points), number_of_ids);
      triangulate_numbered();
    });
  }

  // The same for the present points except those in `gone`, and for the points that come.
  void build_with(const std::vector<Index>& gone, std::vector<Index> coming_ids,
                  std::vector<Point> coming_points)
  {
    try {
      Index number_of_ids = m_topology.m_ids.number_of_ids();
      for (const Index id : coming_ids)
        number_of_ids = (std::max)(number_of_ids, id + 1);
      std::vector<Index> ids = ids_without(gone);
      std::vector<Point> points;
      if (ids.empty()) { // as at a construction, where memory counts
        ids = std::move(coming_ids);
        points = std::move(coming_points);
      } else {
        points.reserve(ids.size() + coming_ids.size());
        for (const Index id : ids)
          points.push_back(m_maintained.point_of_id(id));
        points.insert(points.end(), coming_points.begin(), coming_points.end());
        ids.insert(ids.end(), coming_ids.begin(), coming_ids.end());
      }
      build(std::move(ids), std::move(points), number_of_ids);
    } catch (...) {
      m_goes.clear();
      throw;
    }
    m_goes.clear();
  }

  // A fresh triangulation of the points at their present positions. The vertices keep their numbers
  // while these fit the positions.
  void rebuild()
  {
    write_all_anew([&] {
      if (!sort_vertices()) {
        m_numbering.number();
        triangulate_numbered();
      } else if (are_numbers_far_apart()) {
        m_numbering.number(m_vertex_order.take_order());
        triangulate_numbered();
      } else
        triangulate(m_vertex_order.order());
    });
  }

  // Restores a triangulation that was kept, and must be valid, into one without points. If memory
  // runs out, the target can only be discarded.
  void restore(Checkpoint_arrays_2<Point>& kept)
  {
    CGAL_precondition(m_maintained.number_of_vertices() == 0);
    restore_vertices(kept);
    if (kept.faces.number_of_faces() == 0)
      return triangulate_line();
    take_faces(kept.faces);
    restore_numbers(kept);
  }

  // Makes the triangulation, which must be empty, a copy of another one, with all user data in
  // vertices and faces. The visitor is not called. If this throws, the copy can only be discarded.
  void copy(const Maintained& other)
  {
    CGAL_precondition(m_maintained.number_of_vertices() == 0);
    copy_handles(other);
    m_topology.m_mirror = other.mirror();
    m_topology.m_ids = other.ids();
    m_topology.m_changes = other.changes();
    m_positions = other.m_positions;
  }

  // Exchanges everything with another one, except the user's visitor. Throws nothing.
  void exchange(Maintained& other)
  {
    auto& visitor_calls = m_topology.m_visitor_calls;
    tell_of_faces_before();
    for_each_vertex([&](Vertex_handle v, Index id) { visitor_calls.before_vertex_removal(v, id); });
    exchange_topology(other.m_topology);
    std::swap(m_positions, other.m_positions);
    for_each_vertex([&](Vertex_handle v, Index id) { visitor_calls.after_vertex_creation(v, id); });
    tell_of_faces_after();
  }

  // Moves each vertex from its last position, in a Delaunay triangulation, to its present one with
  // CGAL's own functions. Then reads CGAL's faces back. `relocated` counts the moved vertices.
  // False if others stay in the places of some vertices: all points are written then, but the
  // triangulation is not Delaunay.
  bool relocate_all(std::size_t& relocated)
  {
    bool all_arrived = false;
    write_all_anew([&] {
      all_arrived = relocate_one_by_one(relocated);
      m_positions.template write<Parts>(m_topology.m_vertices);
      read_back();
    });
    return all_arrived;
  }

private:
  // THE VISITOR -----------------------------------------------------------------------------------

  // Writes all faces anew by f(), and calls the visitor before and after, even if f() throws.
  template <class Function>
  void write_all_anew(const Function& f)
  {
    m_topology.m_changes.everything_is_new = true; // also if memory runs out on the way
    tell_of_faces_before();
    try {
      f();
    } catch (...) {
      tell_of_faces_after();
      throw;
    }
    tell_of_faces_after();
  }

  void tell_of_faces_before()
  {
    for_each_face([this](Face_handle f) { m_topology.m_visitor_calls.before_face_removal(f); });
  }
  void tell_of_faces_after()
  {
    for_each_face([this](Face_handle f) { m_topology.m_visitor_calls.after_face_creation(f); });
  }

  // Does nothing if the visitor does not listen.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    if constexpr (Maintained::Visitor_calls::is_heard)
      if (m_maintained.is_mirrored())
        for (const Face_handle face : m_topology.m_faces)
          f(face);
  }

  // RELOCATING ----------------------------------------------------------------------------------

  bool relocate_one_by_one(std::size_t& relocated)
  {
    std::vector<Index> waiting;
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
      if (!coincide(m_maintained.traits(), m_maintained.point(v), m_maintained.previous_point(v)))
        waiting.push_back(v);
    const auto arrives = [&](Index v) {
      const Vertex_handle vertex = m_topology.m_vertices[v];
      const bool arrived =
          m_topology.m_triangulation.move_if_no_collision(vertex, m_maintained.point(v)) == vertex;
      relocated += arrived;
      return arrived;
    };
    // a vertex whose place is taken tries again after the others have moved
    for (std::size_t before = waiting.size() + 1; !waiting.empty() && waiting.size() < before;) {
      before = waiting.size();
      waiting.erase(std::remove_if(waiting.begin(), waiting.end(), arrives), waiting.end());
    }
    return waiting.empty();
  }

  // Reads the topology into the mirror after CGAL has changed it.
  void read_back()
  {
    auto& faces = m_topology.m_faces;
    faces.clear();
    auto& stored = m_topology.m_triangulation.tds().faces();
    for (auto f = stored.begin(); f != stored.end(); ++f)
      faces.push_back(f);
    if (m_maintained.is_mirrored())
      read_faces();
    else
      m_topology.m_mirror.clear();
  }

  // COPYING -------------------------------------------------------------------------------------

  void copy_handles(const Maintained& other)
  {
    auto& tds = m_topology.m_triangulation.tds();
    auto& vertices = m_topology.m_vertices;
    auto& faces = m_topology.m_faces;
    drop_faces(0);
    faces.reserve(other.faces().size());
    vertices.reserve(other.vertices().size());
    for (const Face_handle f : other.faces())
      faces.push_back(tds.create_face(f));
    *vertices.front() = *other.vertices().front();
    for (Index v = 1; v < Index(other.vertices().size()); ++v)
      vertices.push_back(tds.create_vertex(other.vertices()[v]));
    tds.set_dimension(other.triangulation().dimension());
    redirect_copies(other);
  }

  // The copies still refer to the faces and vertices of the other one. In a dimension below 2 faces
  // have fewer vertices and neighbors.
  void redirect_copies(const Maintained& other)
  {
    const auto& vertices = m_topology.m_vertices;
    const auto& faces = m_topology.m_faces;
    Unique_hash_map<Face_handle, Index> number_of_face(no_index, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
      number_of_face[other.faces()[f]] = Index(f);
    const auto copy_of = [&](Face_handle f) {
      return f == Face_handle() ? f : faces[number_of_face[f]];
    };
    for (const Face_handle f : faces)
      for (int i = 0; i < 3; ++i) {
        if (f->vertex(i) != Vertex_handle())
          f->set_vertex(i, vertices[f->vertex(i)->mirror_index()]);
        f->set_neighbor(i, copy_of(f->neighbor(i)));
      }
    for (const Vertex_handle v : vertices)
      v->set_face(copy_of(v->face()));
  }

  // BUILDING ------------------------------------------------------------------------------------

  // Exchanges everything except the visitor, which belongs to the user's object.
  void exchange_topology(Topology& other)
  {
    m_topology.m_triangulation.swap(other.m_triangulation);
    std::swap(m_topology.m_mirror, other.m_mirror);
    m_topology.m_vertices.swap(other.m_vertices);
    m_topology.m_faces.swap(other.m_faces);
    std::swap(m_topology.m_ids, other.m_ids);
    std::swap(m_topology.m_changes, other.m_changes);
  }

  // Representatives come first.
  std::vector<Index> ids_without(const std::vector<Index>& gone)
  {
    std::vector<Index> ids = m_topology.m_ids.representatives_and_duplicates();
    if (gone.empty())
      return ids;
    m_goes.assign(m_topology.m_ids.number_of_ids(), false);
    for (const Index id : gone)
      m_goes[id] = true;
    ids.erase(std::remove_if(ids.begin(), ids.end(), [this](Index id) { return goes(id); }),
              ids.end());
    return ids;
  }

  // Whether the point with this id is removed. A new point may get its id, but not its vertex.
  bool goes(Index id) const { return id < m_goes.size() && m_goes[id]; }

  // False if the vertices may change, because points coincide now, or duplicates may part.
  bool sort_vertices()
  {
    if (!m_topology.m_ids.duplicates().empty())
      return false;
    const boost::counting_iterator<Index> first(1), beyond(Index(m_topology.m_vertices.size()));
    m_vertex_order.sort(first, beyond);
    return !m_vertex_order.has_coincident_vertices();
  }

  // Whether consecutive vertices in space have distant numbers often enough to pay for new ones.
  bool are_numbers_far_apart() const
  {
    return 8 * m_vertex_order.number_of_far_steps() > m_topology.m_vertices.size();
  }

  // Triangulates the vertices as m_numbering numbers them. Representatives that had vertices of
  // their own keep them. If memory runs out, nothing has changed.
  void triangulate_numbered()
  {
    Ids& ids = m_numbering.ids();
    Vertices fresh(m_topology, ids.number_of_representatives(), m_positions.m_are_exact);
    try {
      collect_vertices(fresh);
      m_numbering.release_points();
      exchange_vertices(fresh, ids);
      try {
        triangulate(m_numbering.order());
      } catch (...) {
        exchange_vertices(fresh, ids);
        throw;
      }
    } catch (...) {
      delete_vertices(fresh.handles, ids, m_topology.m_ids);
      throw;
    }
    m_positions.template write<Parts>(m_topology.m_vertices);
    tell_of_vertices(fresh.handles, ids);
    delete_vertices(fresh.handles, ids, m_topology.m_ids);
    m_numbering.release();
  }

  // Handles of vertices, and their positions.
  struct Vertices
  {
    std::vector<Vertex_handle> handles;
    Positions positions;

    // With the infinite vertex, and memory for so many more.
    Vertices(const Topology& topology, std::size_t number, bool are_exact)
    {
      handles.reserve(number + 1);
      positions.reserve(number + 1);
      handles.push_back(topology.triangulation().infinite_vertex());
      positions.m_are_written = false;
      positions.m_are_exact = are_exact;
    }

    void append(Vertex_handle vertex, const Point& p)
    {
      handles.push_back(vertex);
      positions.append(p);
    }
  };

  void exchange_vertices(Vertices& others, Ids& other_ids)
  {
    m_topology.m_vertices.swap(others.handles);
    std::swap(m_topology.m_ids, other_ids);
    std::swap(m_positions, others.positions);
  }

  void collect_vertices(Vertices& fresh)
  {
    const Ids &ids = m_numbering.ids(), &old_ids = m_topology.m_ids;
    for (Index v = 1; v <= ids.number_of_representatives(); ++v) {
      const Index id = ids.representative(v);
      fresh.handles.push_back(keeps_vertex(id, old_ids)
                                  ? m_topology.m_vertices[old_ids.vertex(id)]
                                  : m_topology.m_triangulation.tds().create_vertex());
    }
    fresh.positions.resize(fresh.handles.size());
    Parts::for_each(fresh.handles.size() - 1,
                    [&](std::size_t, std::size_t first, std::size_t beyond) {
                      for (Index v = Index(first) + 1; v <= beyond; ++v)
                        fresh.positions.stage(v, m_numbering.point(v));
                    });
  }

  // Calls f(vertex, id of its representative) if the visitor listens.
  template <class Function>
  void for_each_vertex(const Function& f) const
  {
    if constexpr (Maintained::Visitor_calls::is_heard)
      for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
        f(m_topology.m_vertices[v], m_topology.m_ids.representative(v));
  }

  // Reports the new vertices, and those before that are to be deleted.
  void tell_of_vertices(const std::vector<Vertex_handle>& vertices_before, const Ids& ids_before)
  {
    if constexpr (Maintained::Visitor_calls::is_heard) {
      auto& visitor_calls = m_topology.m_visitor_calls;
      const Ids& ids = m_topology.m_ids;
      for_each_vertex([&](Vertex_handle v, Index id) {
        if (!keeps_vertex(id, ids_before))
          visitor_calls.after_vertex_creation(v, id);
      });
      for (Index v = 1; v < Index(vertices_before.size()); ++v) {
        const Index id = ids_before.representative(v);
        if (!ids.is_taken(id) || goes(id))
          visitor_calls.before_vertex_removal(vertices_before[v], id);
        else if (!ids.is_representative(id))
          visitor_calls.before_vertex_merge(vertices_before[v], id,
                                            m_topology.m_vertices[ids.vertex(id)]);
      }
    }
  }

  static bool is_representative(Index id, const Ids& ids)
  {
    return ids.is_taken(id) && ids.is_representative(id);
  }
  bool keeps_vertex(Index id, const Ids& ids) const
  {
    return is_representative(id, ids) && !goes(id);
  }

  // Deletes those of `vertices` that are not kept in `elsewhere`.
  void delete_vertices(const std::vector<Vertex_handle>& vertices, const Ids& ids,
                       const Ids& elsewhere)
  {
    for (Index v = 1; v < Index(vertices.size()); ++v) {
      const Index id = ids.representative(v);
      if (!keeps_vertex(id, elsewhere))
        m_topology.m_triangulation.tds().delete_vertex(vertices[v]);
    }
  }

  // Triangulates all vertices in this order: into the mirror, and from there, face by face, into
  // CGAL's structure. Frees the temporary data, which would take as much memory as the
  // triangulation. If memory runs out, nothing has changed.
  void triangulate(const Spatial_order_2& order)
  {
    const std::size_t faces_before = m_topology.m_faces.size();
    try {
      m_triangulator.run(order, [&] { provide_faces(2 * order.size() - 2); });
      m_vertex_order.release();
      m_numbering.release_order();
      if (m_triangulator.faces().number_of_faces() > 0)
        take_faces(m_triangulator.faces());
      else
        triangulate_line();
    } catch (...) {
      drop_faces(faces_before);
      throw;
    }
    m_triangulator.release();
  }

  void take_faces(const Flat_faces_2& faces)
  {
    const Index number = faces.number_of_faces();
    auto& mirror = m_topology.m_mirror;
    mirror.reserve(m_maintained.number_of_vertices(), number);
    provide_faces(number); // nothing throws from here on
    drop_faces(number);
    mirror.resize(m_maintained.number_of_vertices(), number);
    Parts::for_each(number, [&](std::size_t, std::size_t first, std::size_t beyond) {
      for (Index f = Index(first); f < beyond; ++f)
        for (Index i = 0; i < 3; ++i) {
          const Index h = Flat_faces_2::first_halfedge(f) + i;
          mirror.set_apex_and_twin(3 * f + i, faces.apex(h),
                                   Flat_faces_2::number_in_mirror(faces.twin(h)));
        }
    });
    mirror.template find_corners<Parts>();
    mirror.template number_edges<Parts>();
    m_topology.m_triangulation.tds().set_dimension(2);
    write_all_faces();
  }

  // Triangulates vertices that do not span the plane, by CGAL's insertion. Then there is no mirror.
  void triangulate_line()
  {
    Static_triangulation line(m_maintained.traits());
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
      line.insert(m_maintained.point(v), v);
    std::vector<typename Static_triangulation::Face_handle> faces;
    for (auto f = line.faces().begin(); f != line.faces().end(); ++f) {
      f->info() = Index(faces.size());
      faces.push_back(f);
    }
    provide_faces(faces.size()); // nothing throws from here on
    drop_faces(faces.size());
    m_topology.m_mirror.clear();
    m_topology.m_triangulation.tds().set_dimension(line.triangulation().dimension());
    copy_faces(faces);
  }

  // RESTORING -----------------------------------------------------------------------------------

  void restore_vertices(Checkpoint_arrays_2<Point>& kept)
  {
    auto& triangulation = m_topology.m_triangulation;
    Vertices fresh(m_topology, kept.points.size(), kept.positions_are_exact);
    for (const Point& p : kept.points)
      fresh.append(triangulation.tds().create_vertex(), p);
    std::copy(kept.positions.begin(), kept.positions.end(),
              fresh.positions.m_positions.begin() + 1);
    exchange_vertices(fresh, kept.ids);
    m_positions.template write<Parts>(m_topology.m_vertices);
  }

  // Restores the numbers of edges, the corners, and the faces that CGAL's vertices store.
  void restore_numbers(const Checkpoint_arrays_2<Point>& kept)
  {
    auto& mirror = m_topology.m_mirror;
    for (Index e = 0; e < mirror.number_of_edges(); ++e) {
      mirror.set_edge(e, kept.edges[e].forward);
      mirror.set_halfedge(e, kept.edges[e].halfedge);
    }
    for (Index v = 0; v < Index(m_topology.m_vertices.size()); ++v) {
      mirror.set_corner(v, kept.corners[v].halfedge);
      m_topology.m_vertices[v]->set_face(m_topology.m_faces[kept.corners[v].face]);
    }
  }

  // BUILDING AND RESTORING ----------------------------------------------------------------------

  void provide_faces(std::size_t number)
  {
    auto& faces = m_topology.m_faces;
    const std::size_t before = faces.size();
    faces.reserve(number);
    try {
      while (faces.size() < number)
        faces.push_back(m_topology.m_triangulation.tds().create_face());
    } catch (...) {
      drop_faces(before);
      throw;
    }
  }

  void drop_faces(std::size_t number)
  {
    auto& faces = m_topology.m_faces;
    while (faces.size() > number) {
      m_topology.m_triangulation.tds().delete_face(faces.back());
      faces.pop_back();
    }
  }

  // Copies the mirror into CGAL's structure.
  void write_all_faces()
  {
    const auto& mirror = m_topology.m_mirror;
    const auto& vertices = m_topology.m_vertices;
    const auto& faces = m_topology.m_faces;
    Parts::for_each(faces.size(), [&](std::size_t, std::size_t first, std::size_t beyond) {
      for (Index f = Index(first); f < beyond; ++f) {
        const Index h = 3 * f;
        faces[f]->set_vertices(vertices[mirror.apex(h)], vertices[mirror.apex(h + 1)],
                               vertices[mirror.apex(h + 2)]);
        faces[f]->set_neighbors(faces[mirror.twin(h) / 3], faces[mirror.twin(h + 1) / 3],
                                faces[mirror.twin(h + 2) / 3]);
      }
    });
    // a vertex stays where it is in memory, wherever it has moved in the plane
    constexpr Index ahead = 16;
    Parts::for_each(vertices.size(), [&](std::size_t, std::size_t first, std::size_t beyond) {
      for (Index v = Index(first); v < beyond; ++v) {
        if (v + ahead < beyond)
          prefetch(&*vertices[v + ahead]);
        vertices[v]->set_mirror_index(v);
        vertices[v]->set_face(faces[mirror.corner(v) / 3]);
      }
    });
  }

  template <class Static_face_handle>
  void copy_faces(const std::vector<Static_face_handle>& static_faces)
  {
    for (Index v = 0; v < Index(m_topology.m_vertices.size()); ++v)
      m_topology.m_vertices[v]->set_mirror_index(v);
    const auto& faces = m_topology.m_faces;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const auto v = static_faces[f]->vertex(i);
        const auto g = static_faces[f]->neighbor(i);
        const bool has_vertex = v != typename Static_triangulation::Vertex_handle();
        const bool has_neighbor = g != Static_face_handle();
        faces[f]->set_vertex(i, has_vertex ? m_topology.m_vertices[v->info()] : Vertex_handle());
        faces[f]->set_neighbor(i, has_neighbor ? faces[g->info()] : Face_handle());
        if (has_vertex)
          faces[f]->vertex(i)->set_face(faces[f]);
      }
  }

  void read_faces()
  {
    const auto& faces = m_topology.m_faces;
    Unique_hash_map<Face_handle, Index> number_of_face(no_index, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
      number_of_face[faces[f]] = Index(f);
    auto& mirror = m_topology.m_mirror;
    mirror.resize(m_maintained.number_of_vertices(), Index(faces.size()));
    for (Index f = 0; f < Index(faces.size()); ++f)
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = faces[f]->neighbor(i);
        mirror.set_apex_and_twin(3 * f + Index(i), faces[f]->vertex(i)->mirror_index(),
                                 3 * number_of_face[g] + Index(g->index(faces[f])));
      }
    mirror.template find_corners<Parts>();
    mirror.template number_edges<Parts>();
    for (Index v = 0; v < Index(m_topology.m_vertices.size()); ++v)
      m_topology.m_vertices[v]->set_face(faces[mirror.corner(v) / 3]);
  }

  const Maintained& m_maintained;
  Topology& m_topology;
  Positions& m_positions;
  Vertex_order_2<Maintained> m_vertex_order;
  Point_numbering_2<Maintained> m_numbering;
  std::vector<bool> m_goes; // indexed by ids, while points come
  Static_triangulator_2<Maintained> m_triangulator;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_BUILDER_2_H
