// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_INDEXED_STORAGE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_INDEXED_STORAGE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cgal/User_data_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class Element>
class Indexed_handle_2;
template <class Storage>
class Indexed_vertex_2;
template <class Storage>
class Indexed_face_2;

// All that an `Indexed_triangulation_data_structure_2` consists of, except its dimension: vertices
// and faces as rows of arrays. Handles hold its address, which does not change when structures are
// moved and swapped. It belongs to the state of a dynamic triangulation, on whose arrays CGAL's
// triangulation runs; or to a structure alone, as all copies do.
//
// It has two kinds of writers. CGAL's algorithms write through handles: the three vertices and the
// three neighbors of a face, and the face of a vertex. Then erased elements leave holes, a twin or
// a corner is just any half-edge of the right face, and edges have no numbers (`arrays().edges()`
// is empty). The editor and the builder write the arrays themselves, complete and without holes,
// after collect_garbage() and `number_from_neighbors()` if CGAL's algorithms have written.
template <class Point_, class VertexInfo, class FaceInfo>
class Indexed_storage_2
{
public:
  using Point = Point_;
  using Vertex_info = VertexInfo;
  using Face_info = FaceInfo;
  using Vertex = Indexed_vertex_2<Indexed_storage_2>;
  using Face = Indexed_face_2<Indexed_storage_2>;
  using Vertex_handle = Indexed_handle_2<Vertex>;
  using Face_handle = Indexed_handle_2<Face>;
  using Vertex_data = User_data_2<Vertex_handle, Vertex_info>;
  using Face_data = User_data_2<Face_handle, Face_info>;

  static constexpr bool points_are_two_doubles = is_two_doubles<Point>;
  using Stored_point = std::conditional_t<points_are_two_doubles, Position_2, Point>;
  using Points = Uninitialized_vector<Stored_point>;

  Indexed_storage_2() = default;
  // A copy has no numbers of edges.
  Indexed_storage_2(const Indexed_storage_2&) = default;
  Indexed_storage_2& operator=(const Indexed_storage_2&) = delete;

  // READING ---------------------------------------------------------------------------------------

  const Halfedge_arrays_2& arrays() const { return m_arrays; }
  const Point& point(Vertex_index v) const { return as_point(m_points[v]); }
  Point& point(Vertex_index v) { return as_point(m_points[v]); }

  // A number that no other storage of the program has. Handles are ordered and hashed by it.
  std::uint32_t serial() const { return m_serial.number; }

  // Whether anything was changed through a handle since this flag was last cleared.
  bool is_written_by_handles() const { return m_is_written_by_handles; }
  void note_written_by_handle() { m_is_written_by_handles = true; }

  Vertex_data& vertex_data() { return m_vertex_data; }
  Face_data& face_data() { return m_face_data; }

  Index vertices_with_holes() const { return m_arrays.number_of_vertices(); }
  Index faces_with_holes() const { return m_arrays.faces_with_holes(); }
  std::size_t number_of_vertices() const { return vertices_with_holes() - m_erased_vertices; }
  std::size_t number_of_faces() const { return faces_with_holes() - m_erased_faces; }
  bool is_erased_vertex(Vertex_index v) const { return m_arrays.corner(v) == erased_index; }
  bool is_erased_face(Face_index f) const
  {
    return m_arrays.apex(Halfedge_arrays_2::halfedge_in(f, 0)) == erased_index;
  }
  bool has_holes() const { return m_erased_vertices + m_erased_faces > 0; }

  // WRITING BY HANDLES ----------------------------------------------------------------------------

  // Returns a new vertex without face. The point of an erased vertex whose number it takes stays
  // until set_point(): a program may remove a vertex, then insert a reference to its point.
  Vertex_index create_vertex()
  {
    note_written_by_handle();
    if (!m_free_vertices.empty()) {
      const Vertex_index v = m_free_vertices.back();
      m_vertex_data.reset(v);
      m_free_vertices.pop_back();
      --m_erased_vertices;
      m_arrays.m_corner[v] = null_index;
      return v;
    }
    reserve_extra(m_points, 1);
    reserve_extra(m_arrays.m_corner, 1);
    m_vertex_data.resize(m_points.size() + 1);
    m_points.push_back(Stored_point());
    m_arrays.m_corner.push_back(null_index);
    return Vertex_index(m_arrays.m_corner.size() - 1);
  }

  // Returns a new face without vertices and neighbors.
  Face_index create_face()
  {
    note_written_by_handle();
    Face_index f;
    if (!m_free_faces.empty()) {
      f = m_free_faces.back();
      m_face_data.reset(f);
      m_free_faces.pop_back();
      --m_erased_faces;
    } else {
      f = Face_index(faces_with_holes());
      reserve_extra(m_arrays.m_halfedges, 3);
      m_face_data.resize(f + std::size_t(1));
      m_arrays.m_halfedges.resize(m_arrays.m_halfedges.size() + 3);
    }
    for (const Halfedge_index h : Halfedge_arrays_2::halfedges_of(f))
      m_arrays.m_halfedges[h] = {null_index, null_index, null_index};
    return f;
  }

  // Erasing throws nothing: if memory has run out, the number stays unused until the elements are
  // cleared or collect_garbage() is called.
  void erase_vertex(Vertex_index v) noexcept
  {
    note_written_by_handle();
    m_arrays.m_corner[v] = Halfedge_index(erased_index);
    ++m_erased_vertices;
    append_if_possible(m_free_vertices, v);
  }

  void erase_face(Face_index f) noexcept
  {
    note_written_by_handle();
    m_arrays.m_halfedges[Halfedge_arrays_2::halfedge_in(f, 0)].apex = Vertex_index(erased_index);
    ++m_erased_faces;
    append_if_possible(m_free_faces, f);
  }

  void set_vertex(Halfedge_index h, Vertex_index v)
  {
    note_written_by_handle();
    m_arrays.m_halfedges[h].apex = v;
  }

  // Sets the neighbor at h to face g, or to none. The twin of h is then any half-edge of g.
  void set_neighbor(Halfedge_index h, Face_index g)
  {
    note_written_by_handle();
    m_arrays.m_halfedges[h].twin =
        g == null_index ? null_index : Halfedge_arrays_2::halfedge_in(g, 0);
  }

  void set_face(Vertex_index v, Face_index f)
  {
    note_written_by_handle();
    m_arrays.m_corner[v] = f == null_index ? null_index : Halfedge_arrays_2::halfedge_in(f, 0);
  }

  void set_point(Vertex_index v, const Point& p)
  {
    note_written_by_handle();
    point(v) = p;
  }

  void clear_vertices() noexcept
  {
    note_written_by_handle();
    m_points.clear();
    m_arrays.m_corner.clear();
    m_vertex_data.resize(0);
    m_free_vertices.clear();
    m_erased_vertices = 0;
  }

  void clear_faces() noexcept
  {
    note_written_by_handle();
    m_arrays.m_halfedges.clear();
    m_arrays.drop_edges();
    m_face_data.resize(0);
    m_free_faces.clear();
    m_erased_faces = 0;
  }

  void reserve_vertices(std::size_t number)
  {
    m_points.reserve(number);
    m_arrays.m_corner.reserve(number);
    m_vertex_data.reserve(number);
  }
  void reserve_faces(std::size_t number)
  {
    m_arrays.m_halfedges.reserve(3 * number);
    m_face_data.reserve(number);
  }

  // NUMBERING -------------------------------------------------------------------------------------

  // Removes the holes: elements get consecutive numbers in their present order. Cost: linear.
  void collect_garbage()
  {
    if (!has_holes())
      return;
    const auto [vertices_before, new_vertex] = numbers_without_holes<Vertex_index>(
        vertices_with_holes(), [this](Vertex_index v) { return is_erased_vertex(v); });
    const auto [faces_before, new_face] = numbers_without_holes<Face_index>(
        faces_with_holes(), [this](Face_index f) { return is_erased_face(f); });
    const auto face_data = m_face_data.prepare(faces_before);
    const auto vertex_data = m_vertex_data.prepare(vertices_before);
    m_arrays.drop_edges(); // nothing throws from here on, unless copying a point does
    for (Vertex_index v(0); v < Index(vertices_before.size()); ++v) {
      m_points[v] = std::move(m_points[vertices_before[v]]);
      m_arrays.m_corner[v] = with_face(m_arrays.corner(vertices_before[v]), new_face);
    }
    for (Face_index f(0); f < Index(faces_before.size()); ++f)
      for (Index i = 0; i < 3; ++i) {
        auto& to = m_arrays.m_halfedges[Halfedge_arrays_2::halfedge_in(f, i)];
        to = m_arrays.m_halfedges[Halfedge_arrays_2::halfedge_in(faces_before[f], i)];
        if (to.apex != null_index)
          to.apex = new_vertex[to.apex];
        to.twin = with_face(to.twin, new_face);
      }
    m_points.resize(vertices_before.size());
    m_arrays.m_corner.resize(vertices_before.size());
    m_arrays.m_halfedges.resize(3 * faces_before.size());
    m_vertex_data.renumber(vertex_data, vertices_before);
    m_face_data.renumber(face_data, faces_before);
    m_free_vertices.clear();
    m_free_faces.clear();
    m_erased_vertices = m_erased_faces = 0;
  }

  // WHERE THE EDITOR AND THE BUILDER WRITE --------------------------------------------------------
  // They write points and arrays themselves, and call these functions and those of the data of
  // users so that these follow.

  Writable_halfedge_arrays_2& writable_arrays() { return m_arrays; }
  Points& writable_points() { return m_points; }
  void note_written_by_editor() { m_is_written_by_handles = false; }

  void reserve_data(std::size_t vertices, std::size_t faces)
  {
    m_vertex_data.reserve(vertices);
    m_face_data.reserve(faces);
  }

  // Resizes the user data to these numbers of elements.
  void resize_data(std::size_t vertices, std::size_t faces)
  {
    m_vertex_data.resize(vertices);
    m_face_data.resize(faces);
  }

  // Takes over everything from another storage, which must have no holes.
  void copy(const Indexed_storage_2& other)
  {
    CGAL_precondition(!other.has_holes());
    writable_arrays() = static_cast<const Writable_halfedge_arrays_2&>(other.m_arrays);
    m_points = other.m_points;
    Vertex_data(other.m_vertex_data).swap(m_vertex_data);
    Face_data(other.m_face_data).swap(m_face_data);
    m_is_written_by_handles = other.m_is_written_by_handles;
  }

  // Exchanges points and arrays with another storage. Then all user data are as in new elements.
  void exchange(Indexed_storage_2& other)
  {
    std::swap(writable_arrays(), other.writable_arrays());
    m_points.swap(other.m_points);
    resize_data(0, 0);
    resize_data(m_points.size(), m_arrays.faces_with_holes());
    m_is_written_by_handles = other.m_is_written_by_handles;
  }

private:
  // CGAL's algorithms write single members of the arrays. A copy has no numbers of edges.
  struct Arrays : Writable_halfedge_arrays_2
  {
    using Writable_halfedge_arrays_2::m_corner;
    using Writable_halfedge_arrays_2::m_halfedges;

    Arrays() = default;
    Arrays(const Arrays& other)
      : Writable_halfedge_arrays_2()
    {
      m_halfedges = other.m_halfedges;
      m_corner = other.m_corner;
    }
  };

  struct Serial
  {
    Serial() = default;
    Serial(const Serial&) {} // of a copy it is another one

    static std::uint32_t next()
    {
      static std::atomic<std::uint32_t> last{0};
      return ++last;
    }

    const std::uint32_t number = next();
  };

  static constexpr Index erased_index = null_index - 1;

  static const Point& as_point(const Point& p) { return p; }
  static Point& as_point(Point& p) { return p; }
  // Such a point is two doubles and nothing else; all accesses to `Position_2` may alias.
  static const Point& as_point(const Position_2& p) { return reinterpret_cast<const Point&>(p); }
  static Point& as_point(Position_2& p) { return reinterpret_cast<Point&>(p); }

  template <class Number>
  static void append_if_possible(std::vector<Number>& list, Number i) noexcept
  {
    try {
      list.push_back(i);
    } catch (const std::bad_alloc&) {
    }
  }

  // Returns the former number for each new one, and the new number (or none) for each former one.
  template <class Number, class Predicate>
  static std::pair<Column<Number, Number>, Column<Number, Number>>
  numbers_without_holes(Index size, const Predicate& is_hole)
  {
    Column<Number, Number> before, after(size, null_index);
    for (Number i(0); i < size; ++i)
      if (!is_hole(i)) {
        after[i] = Number(before.size());
        before.push_back(i);
      }
    return {std::move(before), std::move(after)};
  }

  // Returns the number of half-edge h once its face has its new number.
  static Halfedge_index with_face(Halfedge_index h, const Column<Face_index, Face_index>& new_face)
  {
    return h == null_index ? null_index
                           : Halfedge_arrays_2::halfedge_in(new_face[Halfedge_arrays_2::face_of(h)],
                                                            Halfedge_arrays_2::number_in_face(h));
  }

  Arrays m_arrays;
  Points m_points;
  Vertex_data m_vertex_data;
  Face_data m_face_data;
  std::vector<Vertex_index> m_free_vertices; // holes to be filled, the last one first
  std::vector<Face_index> m_free_faces;      // likewise
  std::size_t m_erased_vertices = 0, m_erased_faces = 0;
  bool m_is_written_by_handles = false;
  Serial m_serial;
};

// Returns a triangulation of CGAL that runs on a storage of the caller: an empty one, or one of
// this dimension whose vertex 0 is at infinity.
template <class Triangulation, class Storage>
Triangulation triangulation_on(Storage& storage, const typename Triangulation::Geom_traits& traits,
                               int dimension = -2)
{
  Triangulation result(traits);
  auto& tds = result.tds();
  tds.run_on(storage, dimension);
  result.set_infinite_vertex(dimension == -2 ? tds.insert_first() : tds.vertex_handle(0));
  return result;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_INDEXED_STORAGE_2_H
