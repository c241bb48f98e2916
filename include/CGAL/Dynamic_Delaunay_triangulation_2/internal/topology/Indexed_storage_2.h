// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_INDEXED_STORAGE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_INDEXED_STORAGE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Surface_mesh/Properties.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// User data at vertices or faces, in arrays with one value for each element of the storage. Users
// access the values by handles of type `Handle`.
template <class Handle>
class Indexed_properties_2
{
public:
  // A property map from handles to values. It refers to an array that the storage owns.
  template <class T>
  class Map
  {
    using Array = Properties::Property_array<T>;

  public:
    using key_type = Handle;
    using value_type = T;
    using reference = typename Array::reference;
    using category = boost::lvalue_property_map_tag;

    explicit Map(Array* array = nullptr)
      : m_array(array)
    {
    }

    reference operator[](const Handle& h) const { return (*m_array)[h.index()]; }

    friend reference get(const Map& map, const Handle& h) { return map[h]; }
    friend void put(const Map& map, const Handle& h, const T& value) { map[h] = value; }

  private:
    Array* m_array;
  };

  // Tells Property_container the type of its maps.
  template <class Key, class T>
  struct Get_property_map
  {
    using type = Map<T>;
  };

  // Returns the property with this name, and whether it is new. A new one has `value` everywhere.
  template <class T>
  std::pair<Map<T>, bool> add(const std::string& name, const T& value)
  {
    const auto added = m_arrays.template add<T>(name, value);
    return {added.first, added.second};
  }

  std::vector<std::string> names() const { return m_arrays.properties(); }

  // Makes room for so many more elements. Then append() throws only what copying a value throws.
  void reserve_extra(std::size_t number)
  {
    if (m_arrays.capacity() < m_arrays.size() + number)
      m_arrays.reserve(2 * m_arrays.size() + number);
  }
  void reserve(std::size_t number) { m_arrays.reserve(number); }
  void append() { m_arrays.push_back(); }
  void resize(std::size_t number) { m_arrays.resize(number); }
  void reset(Index i) { m_arrays.reset(i); }

  void move_last_to(Index i)
  {
    const std::size_t last = m_arrays.size() - 1;
    if (i != last)
      m_arrays.swap(i, last);
    m_arrays.resize(last);
  }

  // Copies the values of element `from` to element `to` of the same storage.
  void copy(Index from, Index to)
  {
    if (m_arrays.n_properties() > 0)
      m_arrays.transfer(m_arrays, from, to);
  }

  bool empty() const { return m_arrays.n_properties() == 0; }

  // Renumbers the values. `others` is a copy of this object. The element with number i has the
  // number before[i] in `others`, or is new if that is `null_index`. Memory must be reserved.
  void renumber(const Indexed_properties_2& others, const std::vector<Index>& before)
  {
    m_arrays.resize(before.size());
    if (empty())
      return;
    for (Index i = 0; i < Index(before.size()); ++i)
      if (before[i] == null_index)
        m_arrays.reset(i);
      else
        m_arrays.transfer(others.m_arrays, before[i], i);
  }

private:
  using Container = Properties::Property_container<Indexed_properties_2, Handle>;

  Container m_arrays;
};

// The array of `info()`; none if `Info` is void.
template <class Info>
struct Info_array_2
{
  static_assert(!std::is_same_v<Info, bool>, "take char: there are no references to single bits");

  void reserve(std::size_t number) { values.reserve(number); }
  void reserve_extra(std::size_t number) { internal::reserve_extra(values, number); }
  void append() { values.emplace_back(); }
  void resize(std::size_t number) { values.resize(number); }
  void reset(Index i) { values[i] = Info(); }
  void move_last_to(Index i)
  {
    if (i + std::size_t(1) != values.size())
      values[i] = std::move(values.back());
    values.pop_back();
  }
  // Returns the values, renumbered as by `Indexed_properties_2::renumber()`.
  Info_array_2 renumbered(const std::vector<Index>& before) const
  {
    Info_array_2 others;
    others.resize(before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i] != null_index)
        others.values[i] = values[before[i]];
    return others;
  }

  std::vector<Info> values;
};

template <>
struct Info_array_2<void>
{
  void reserve(std::size_t) {}
  void reserve_extra(std::size_t) {}
  void append() {}
  void resize(std::size_t) {}
  void reset(Index) {}
  void move_last_to(Index) {}
  Info_array_2 renumbered(const std::vector<Index>&) const { return {}; }
};

template <class Element>
class Indexed_handle_2;
template <class Storage>
class Indexed_vertex_2;
template <class Storage>
class Indexed_face_2;

// All that an `Indexed_triangulation_data_structure_2` consists of, except its dimension: vertices
// and faces as rows of arrays. Handles hold its address, which does not change when structures are
// moved and swapped.
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
  using Vertex_properties = Indexed_properties_2<Vertex_handle>;
  using Face_properties = Indexed_properties_2<Face_handle>;

  static constexpr bool points_are_two_doubles = is_two_doubles<Point>;
  using Stored_point = std::conditional_t<points_are_two_doubles, Position_2, Point>;
  using Points = std::vector<Stored_point>;

  Indexed_storage_2() = default;
  // A copy has no numbers of edges.
  Indexed_storage_2(const Indexed_storage_2& other)
    : m_arrays(other.m_arrays, Halfedge_arrays_2::Without_edges())
    , m_points(other.m_points)
    , m_vertex_properties(other.m_vertex_properties)
    , m_face_properties(other.m_face_properties)
    , m_vertex_infos(other.m_vertex_infos)
    , m_face_infos(other.m_face_infos)
    , m_free_vertices(other.m_free_vertices)
    , m_free_faces(other.m_free_faces)
    , m_erased_vertices(other.m_erased_vertices)
    , m_erased_faces(other.m_erased_faces)
  {
  }
  Indexed_storage_2& operator=(const Indexed_storage_2&) = delete;

  // READING ---------------------------------------------------------------------------------------

  const Halfedge_arrays_2& arrays() const { return m_arrays; }
  const Points& points() const { return m_points; }

  const Point& point(Vertex_index v) const { return as_point(m_points[v]); }
  Point& point(Vertex_index v) { return as_point(m_points[v]); }

  // A number that no other storage of the program has. Handles are ordered and hashed by it.
  std::uint32_t serial() const { return m_serial; }

  // Whether anything was changed through a handle since this flag was last cleared.
  bool is_written_by_handles() const { return m_is_written_by_handles; }
  void note_written_by_handle() { m_is_written_by_handles = true; }

  Vertex_properties& vertex_properties() { return m_vertex_properties; }
  Face_properties& face_properties() { return m_face_properties; }
  auto& vertex_info(Vertex_index v) { return m_vertex_infos.values[v]; }
  auto& face_info(Face_index f) { return m_face_infos.values[f]; }

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
  Index create_vertex()
  {
    note_written_by_handle();
    if (!m_free_vertices.empty()) {
      const Vertex_index v = m_free_vertices.back();
      m_free_vertices.pop_back();
      --m_erased_vertices;
      m_arrays.m_corner[v] = null_index;
      m_vertex_properties.reset(v);
      m_vertex_infos.reset(v);
      return v;
    }
    reserve_extra(m_points, 1);
    reserve_extra(m_arrays.m_corner, 1);
    m_vertex_properties.reserve_extra(1);
    m_vertex_infos.reserve_extra(1);
    m_points.emplace_back();
    m_vertex_properties.append();
    m_vertex_infos.append();
    m_arrays.m_corner.push_back(null_index);
    return Index(m_arrays.m_corner.size()) - 1;
  }

  // Returns a new face without vertices and neighbors.
  Index create_face()
  {
    note_written_by_handle();
    Face_index f;
    if (!m_free_faces.empty()) {
      f = m_free_faces.back();
      m_free_faces.pop_back();
      --m_erased_faces;
      m_face_properties.reset(f);
      m_face_infos.reset(f);
    } else {
      f = faces_with_holes();
      reserve_extra(m_arrays.m_halfedges, 3);
      m_face_properties.reserve_extra(1);
      m_face_infos.reserve_extra(1);
      m_face_properties.append();
      m_face_infos.append();
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
    m_arrays.m_corner[v] = erased_index;
    ++m_erased_vertices;
    append_if_possible(m_free_vertices, v);
  }

  void erase_face(Face_index f) noexcept
  {
    note_written_by_handle();
    m_arrays.m_halfedges[Halfedge_arrays_2::halfedge_in(f, 0)].apex = erased_index;
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
        g == null_index ? Halfedge_index(null_index) : Halfedge_arrays_2::halfedge_in(g, 0);
  }

  void set_face(Vertex_index v, Face_index f)
  {
    note_written_by_handle();
    m_arrays.m_corner[v] =
        f == null_index ? Halfedge_index(null_index) : Halfedge_arrays_2::halfedge_in(f, 0);
  }

  void set_point(Vertex_index v, const Point& p)
  {
    note_written_by_handle();
    store(m_points[v], p);
  }

  void clear_vertices() noexcept
  {
    note_written_by_handle();
    m_points.clear();
    m_arrays.m_corner.clear();
    m_vertex_properties.resize(0);
    m_vertex_infos.resize(0);
    m_free_vertices.clear();
    m_erased_vertices = 0;
  }

  void clear_faces() noexcept
  {
    note_written_by_handle();
    m_arrays.m_halfedges.clear();
    m_arrays.drop_edges();
    m_face_properties.resize(0);
    m_face_infos.resize(0);
    m_free_faces.clear();
    m_erased_faces = 0;
  }

  void reserve_vertices(std::size_t number)
  {
    m_points.reserve(number);
    m_arrays.m_corner.reserve(number);
    m_vertex_properties.reserve(number);
    m_vertex_infos.reserve(number);
  }
  void reserve_faces(std::size_t number)
  {
    m_arrays.m_halfedges.reserve(3 * number);
    m_face_properties.reserve(number);
    m_face_infos.reserve(number);
  }

  // NUMBERING -------------------------------------------------------------------------------------

  // Removes the holes: elements get consecutive numbers in their present order. Cost: linear.
  void collect_garbage()
  {
    if (!has_holes())
      return;
    const auto [vertices_before, new_vertex] = numbers_without_holes(
        vertices_with_holes(), [this](Vertex_index v) { return is_erased_vertex(v); });
    const auto [faces_before, new_face] = numbers_without_holes(
        faces_with_holes(), [this](Face_index f) { return is_erased_face(f); });
    Renumbered_face_data face_data(m_face_properties, m_face_infos, faces_before);
    Renumbered_vertex_data vertex_data(m_vertex_properties, m_vertex_infos, vertices_before);
    m_arrays.drop_edges(); // nothing throws from here on, unless copying a point or a value does
    for (Vertex_index v = 0; v < Index(vertices_before.size()); ++v) {
      m_points[v] = std::move(m_points[vertices_before[v]]);
      m_arrays.m_corner[v] = with_face(m_arrays.corner(vertices_before[v]), new_face);
    }
    for (Face_index f = 0; f < Index(faces_before.size()); ++f)
      for (Index i = 0; i < 3; ++i) {
        auto& to = m_arrays.m_halfedges[Halfedge_arrays_2::halfedge_in(f, i)];
        to = m_arrays.m_halfedges[Halfedge_arrays_2::halfedge_in(faces_before[f], i)];
        to.apex = to.apex == null_index ? null_index : new_vertex[to.apex];
        to.twin = with_face(to.twin, new_face);
      }
    m_points.resize(vertices_before.size());
    m_arrays.m_corner.resize(vertices_before.size());
    m_arrays.m_halfedges.resize(3 * faces_before.size());
    vertex_data.take(m_vertex_properties, m_vertex_infos);
    face_data.take(m_face_properties, m_face_infos);
    m_free_vertices.clear();
    m_free_faces.clear();
    m_erased_vertices = m_erased_faces = 0;
  }

private:
  template <class Traits, class Tds, class VisitorCalls>
  friend class Topology_2;
  template <class State>
  friend class Topology_builder_2;
  template <class State>
  friend class Plane_editing_2;

  // WHERE THE EDITOR AND THE BUILDER WRITE --------------------------------------------------------
  // They write points and arrays themselves, and call these functions so that user data follow.

  // After this, append_slot() throws only what copying a value throws.
  void reserve_for_slot()
  {
    m_vertex_properties.reserve_extra(1);
    m_face_properties.reserve_extra(2);
    m_vertex_infos.reserve_extra(1);
    m_face_infos.reserve_extra(2);
  }

  // Appends the user data of a vertex and two faces.
  void append_slot()
  {
    m_vertex_properties.append();
    m_vertex_infos.append();
    for (int i = 0; i < 2; ++i) {
      m_face_properties.append();
      m_face_infos.append();
    }
  }

  void reserve_data(std::size_t vertices, std::size_t faces)
  {
    m_vertex_properties.reserve(vertices);
    m_vertex_infos.reserve(vertices);
    m_face_properties.reserve(faces);
    m_face_infos.reserve(faces);
  }

  // Resizes the user data to these numbers of elements.
  void resize_data(std::size_t vertices, std::size_t faces)
  {
    m_vertex_properties.resize(vertices);
    m_vertex_infos.resize(vertices);
    m_face_properties.resize(faces);
    m_face_infos.resize(faces);
  }

  auto renumbered_vertex_data(const std::vector<Index>& before)
  {
    return Renumbered_vertex_data(m_vertex_properties, m_vertex_infos, before);
  }
  template <class Data>
  void take_vertex_data(Data& data)
  {
    data.take(m_vertex_properties, m_vertex_infos);
  }

  void resize_vertex_data(std::size_t vertices)
  {
    m_vertex_properties.resize(vertices);
    m_vertex_infos.resize(vertices);
  }
  void resize_face_data(std::size_t faces)
  {
    m_face_properties.resize(faces);
    m_face_infos.resize(faces);
  }

  // Whether vertices have an `info()` or properties.
  bool has_vertex_data() const
  {
    return !std::is_void_v<Vertex_info> || !m_vertex_properties.empty();
  }

  // Takes over everything from another storage, which must have no holes.
  void copy(const Indexed_storage_2& other)
  {
    CGAL_precondition(!other.has_holes());
    m_arrays = other.m_arrays;
    m_points = other.m_points;
    m_vertex_properties = other.m_vertex_properties;
    m_face_properties = other.m_face_properties;
    m_vertex_infos = other.m_vertex_infos;
    m_face_infos = other.m_face_infos;
    m_is_written_by_handles = other.m_is_written_by_handles;
  }

  // Exchanges points and arrays with another storage. Then all user data are as in new elements.
  void exchange(Indexed_storage_2& other)
  {
    std::swap(m_arrays, other.m_arrays);
    m_points.swap(other.m_points);
    resize_data(0, 0);
    resize_data(m_points.size(), m_arrays.faces_with_holes());
    m_is_written_by_handles = other.m_is_written_by_handles;
  }

  void renew_vertex(Vertex_index v)
  {
    m_vertex_properties.reset(v);
    m_vertex_infos.reset(v);
  }

  void move_last_vertex_data_to(Vertex_index v)
  {
    m_vertex_properties.move_last_to(v);
    m_vertex_infos.move_last_to(v);
  }
  void move_last_face_data_to(Face_index f)
  {
    m_face_properties.move_last_to(f);
    m_face_infos.move_last_to(f);
  }

  // The user data of elements with new numbers: the element with number i had the number before[i],
  // or is new if that is `null_index`. Constructed in advance, so that take() needs no memory.
  template <class Data, class Infos>
  class Renumbered_data
  {
  public:
    Renumbered_data(Data& properties, const Infos& infos, const std::vector<Index>& before)
      : m_before(before)
      , m_properties(properties)
      , m_infos(infos.renumbered(before))
    {
      properties.reserve(before.size());
    }

    void take(Data& properties, Infos& infos)
    {
      properties.renumber(m_properties, m_before);
      std::swap(infos, m_infos);
    }

  private:
    const std::vector<Index>& m_before;
    Data m_properties;
    Infos m_infos;
  };
  using Renumbered_vertex_data = Renumbered_data<Vertex_properties, Info_array_2<Vertex_info>>;
  using Renumbered_face_data = Renumbered_data<Face_properties, Info_array_2<Face_info>>;

  static constexpr Index erased_index = null_index - 1;

  static const Point& as_point(const Point& p) { return p; }
  static Point& as_point(Point& p) { return p; }
  // Such a point is two doubles and nothing else; all accesses to `Position_2` may alias.
  static const Point& as_point(const Position_2& p) { return reinterpret_cast<const Point&>(p); }
  static Point& as_point(Position_2& p) { return reinterpret_cast<Point&>(p); }

  static void store(Point& stored, const Point& p) { stored = p; }
  static void store(Position_2& stored, const Point& p) { stored = {p.x(), p.y()}; }

  static void append_if_possible(std::vector<Index>& list, Index i) noexcept
  {
    try {
      list.push_back(i);
    } catch (const std::bad_alloc&) {
    }
  }

  // Returns the former number for each new one, and the new number (or none) for each former one.
  template <class Predicate>
  static std::pair<std::vector<Index>, std::vector<Index>>
  numbers_without_holes(Index size, const Predicate& is_hole)
  {
    std::vector<Index> before, after(size, null_index);
    for (Index i = 0; i < size; ++i)
      if (!is_hole(i)) {
        after[i] = Index(before.size());
        before.push_back(i);
      }
    return {std::move(before), std::move(after)};
  }

  // Returns the number of half-edge h once its face has its new number.
  static Halfedge_index with_face(Halfedge_index h, const std::vector<Index>& new_face)
  {
    return h == null_index ? Halfedge_index(null_index)
                           : Halfedge_arrays_2::halfedge_in(new_face[Halfedge_arrays_2::face_of(h)],
                                                            Halfedge_arrays_2::place_of(h));
  }

  static std::uint32_t next_serial()
  {
    static std::atomic<std::uint32_t> last{0};
    return ++last;
  }

  Halfedge_arrays_2 m_arrays;
  Points m_points;
  Vertex_properties m_vertex_properties;
  Face_properties m_face_properties;
  Info_array_2<Vertex_info> m_vertex_infos;
  Info_array_2<Face_info> m_face_infos;
  std::vector<Index> m_free_vertices, m_free_faces; // holes to be filled, the last one first
  std::size_t m_erased_vertices = 0, m_erased_faces = 0;
  bool m_is_written_by_handles = false;
  const std::uint32_t m_serial = next_serial();
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_INDEXED_STORAGE_2_H
