// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_INDEXED_ELEMENTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_INDEXED_ELEMENTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Compact_container.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cgal/Indexed_storage_2.h>
#include <CGAL/Handle_hash_function.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_utils_2.h>

#include <cstddef>
#include <functional>
#include <istream>
#include <iterator>
#include <ostream>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A vertex or a face, as a storage and a number. The object is part of a handle.
template <class Storage, class Number_>
class Indexed_element_2
{
public:
  using Number = Number_;

  Indexed_element_2() = default;
  Indexed_element_2(Storage* storage, Number index)
    : m_storage(storage)
    , m_index(index)
  {
  }

protected:
  Storage* m_storage = nullptr;
  Number m_index = null_index;
};

// Declares `Info`, without which CGAL's triangulations do not accept points with infos.
template <class Info_>
struct Info_type_2
{
  using Info = Info_;
};
template <>
struct Info_type_2<void>
{
};

// A handle and an iterator of vertices or faces. It stays valid when arrays grow, and when a
// structure is moved or swapped.
template <class Element>
class Indexed_handle_2
{
public:
  using Storage = typename Element::Storage;
  using value_type = Element;
  using reference = Element&;
  using pointer = Element*;
  using difference_type = std::ptrdiff_t;
  using size_type = std::size_t;
  using iterator_category = std::bidirectional_iterator_tag;

  using Number = typename Element::Number;

  // The number in a past-the-end iterator. It stays valid when the arrays grow.
  static constexpr Number end_index{null_index - 2};

  Indexed_handle_2(std::nullptr_t = nullptr) noexcept {}
  Indexed_handle_2(Storage* storage, Number index) noexcept
    : m_element(storage, index)
  {
  }

  // The number of the element. The next change may give the element another number.
  Number index() const { return m_element.m_index; }

  Element& operator*() const { return m_element; }
  Element* operator->() const { return &m_element; }

  // The number from i on that an element has, or that of the end.
  static Number next(const Storage& s, Number i)
  {
    while (i < Element::size_with_holes(s) && Element::is_hole(s, i))
      ++i;
    return i < Element::size_with_holes(s) ? i : end_index;
  }

  Indexed_handle_2& operator++()
  {
    m_element.m_index = next(*m_element.m_storage, m_element.m_index + 1);
    return *this;
  }
  Indexed_handle_2 operator++(int)
  {
    const Indexed_handle_2 before(*this);
    ++*this;
    return before;
  }
  Indexed_handle_2& operator--()
  {
    Number& i = m_element.m_index;
    i = i == end_index ? Number(Element::size_with_holes(*m_element.m_storage)) : i;
    do
      i = Number(i - 1);
    while (Element::is_hole(*m_element.m_storage, i));
    return *this;
  }
  Indexed_handle_2 operator--(int)
  {
    const Indexed_handle_2 before(*this);
    --*this;
    return before;
  }

  // Compares the numbers first, because they nearly always decide.
  friend bool operator==(const Indexed_handle_2& a, const Indexed_handle_2& b)
  {
    return a.index() == b.index() && a.storage() == b.storage();
  }
  friend bool operator!=(const Indexed_handle_2& a, const Indexed_handle_2& b) { return !(a == b); }
  friend bool operator<(const Indexed_handle_2& a, const Indexed_handle_2& b)
  {
    return a.index() != b.index() ? a.index() < b.index() : a.serial() < b.serial();
  }
  friend bool operator>(const Indexed_handle_2& a, const Indexed_handle_2& b) { return b < a; }
  friend bool operator<=(const Indexed_handle_2& a, const Indexed_handle_2& b) { return !(b < a); }
  friend bool operator>=(const Indexed_handle_2& a, const Indexed_handle_2& b) { return !(a < b); }

  // Returns different values for different handles, because CGAL's `Unique_hash_map` takes the
  // value for the handle. If it has 32 bits, they differ only among handles of one structure.
  friend std::size_t hash_value(const Indexed_handle_2& h)
  {
    constexpr bool is_wide = sizeof(std::size_t) > sizeof(Index);
    constexpr std::size_t factor = is_wide ? std::size_t(1) << 16 << 16 : 0x9e3779b1;
    return h.serial() * factor + h.index();
  }

private:
  const Storage* storage() const { return m_element.m_storage; }
  std::uint32_t serial() const { return storage() == nullptr ? 0 : storage()->serial(); }

  mutable Element m_element;
};

template <class Storage_>
class Indexed_vertex_2 : public Indexed_element_2<Storage_, Vertex_index>,
                         public Info_type_2<typename Storage_::Vertex_info>
{
public:
  using Storage = Storage_;
  using Point = typename Storage::Point;
  using Vertex_handle = typename Storage::Vertex_handle;
  using Face_handle = typename Storage::Face_handle;

  using Indexed_element_2<Storage_, Vertex_index>::Indexed_element_2;

  Face_handle face() const
  {
    const Halfedge_index h = m_storage->arrays().corner(m_index);
    return h == null_index ? Face_handle() : Face_handle(m_storage, Halfedge_arrays_2::face_of(h));
  }
  void set_face(const Face_handle& f) { m_storage->set_face(m_index, f.index()); }

  const Point& point() const { return std::as_const(*m_storage).point(m_index); }
  Point& point() { return m_storage->point(m_index); }
  void set_point(const Point& p) { m_storage->set_point(m_index, p); }

  decltype(auto) info() const { return m_storage->vertex_info(m_index); }

  bool is_valid(bool = false, int = 0) const { return face() != Face_handle(); }

  // What Indexed_container_2 needs.
  static Index size_with_holes(const Storage& s) { return s.vertices_with_holes(); }
  static std::size_t size(const Storage& s) { return s.number_of_vertices(); }
  static bool is_hole(const Storage& s, Vertex_index v) { return s.is_erased_vertex(v); }
  static Vertex_handle create(Storage& s) { return {&s, s.create_vertex()}; }
  static Vertex_handle create(Storage& s, const Point& p)
  {
    const Vertex_handle v = create(s);
    v->set_point(p);
    return v;
  }
  static Vertex_handle create(Storage& s, const Indexed_vertex_2& other)
  {
    if (other.m_storage == nullptr)
      return create(s);
    const Point p = other.point(); // a copy, because the array of points may grow
    const Vertex_handle v = create(s, p);
    if constexpr (!std::is_void_v<typename Storage::Vertex_info>)
      v->info() = other.info();
    if (other.m_storage == &s)
      s.vertex_properties().copy(other.m_index, v.index());
    return v;
  }
  static void erase(Storage& s, Vertex_index v) { s.erase_vertex(v); }
  static void clear(Storage& s) { s.clear_vertices(); }
  static void reserve(Storage& s, std::size_t number) { s.reserve_vertices(number); }

private:
  template <class Element>
  friend class Indexed_handle_2;
  using Indexed_element_2<Storage_, Vertex_index>::m_storage; // accessible to the handle, a friend
  using Indexed_element_2<Storage_, Vertex_index>::m_index;

  // Private, because it would make a handle refer to another vertex.
  Indexed_vertex_2& operator=(const Indexed_vertex_2&) = default;

public:
  Indexed_vertex_2(const Indexed_vertex_2&) = default;
  Indexed_vertex_2() = default;
};

template <class Storage_>
class Indexed_face_2 : public Indexed_element_2<Storage_, Face_index>,
                       public Info_type_2<typename Storage_::Face_info>,
                       public Triangulation_cw_ccw_2
{
public:
  using Storage = Storage_;
  using Vertex_handle = typename Storage::Vertex_handle;
  using Face_handle = typename Storage::Face_handle;

  using Indexed_element_2<Storage_, Face_index>::Indexed_element_2;

  Vertex_handle vertex(int i) const
  {
    const Vertex_index v = m_storage->arrays().apex(halfedge(i));
    return v == null_index ? Vertex_handle() : Vertex_handle(m_storage, v);
  }
  bool has_vertex(const Vertex_handle& v) const
  {
    int i;
    return has_vertex(v, i);
  }
  bool has_vertex(const Vertex_handle& v, int& i) const { return find(i, is_vertex(v)); }
  int index(const Vertex_handle& v) const { return index_where(is_vertex(v)); }

  Face_handle neighbor(int i) const
  {
    const Halfedge_index g = m_storage->arrays().twin(halfedge(i));
    return g == null_index ? Face_handle() : Face_handle(m_storage, Halfedge_arrays_2::face_of(g));
  }
  bool has_neighbor(const Face_handle& g) const
  {
    int i;
    return has_neighbor(g, i);
  }
  bool has_neighbor(const Face_handle& g, int& i) const { return find(i, is_neighbor(g)); }
  int index(const Face_handle& g) const { return index_where(is_neighbor(g)); }

  void set_vertex(int i, const Vertex_handle& v) { m_storage->set_vertex(halfedge(i), v.index()); }
  void set_vertices() { set_vertices(nullptr, nullptr, nullptr); }
  void set_vertices(const Vertex_handle& v0, const Vertex_handle& v1, const Vertex_handle& v2)
  {
    set_vertex(0, v0);
    set_vertex(1, v1);
    set_vertex(2, v2);
  }
  void set_neighbor(int i, const Face_handle& g)
  {
    m_storage->set_neighbor(halfedge(i), g.index());
  }
  void set_neighbors() { set_neighbors(nullptr, nullptr, nullptr); }
  void set_neighbors(const Face_handle& g0, const Face_handle& g1, const Face_handle& g2)
  {
    set_neighbor(0, g0);
    set_neighbor(1, g1);
    set_neighbor(2, g2);
  }

  void reorient()
  {
    set_vertices(vertex(1), vertex(0), vertex(2));
    set_neighbors(neighbor(1), neighbor(0), neighbor(2));
  }
  void ccw_permute()
  {
    set_vertices(vertex(2), vertex(0), vertex(1));
    set_neighbors(neighbor(2), neighbor(0), neighbor(1));
  }
  void cw_permute()
  {
    set_vertices(vertex(1), vertex(2), vertex(0));
    set_neighbors(neighbor(1), neighbor(2), neighbor(0));
  }

  // Returns the number of the face's vertices, less one.
  int dimension() const
  {
    const auto& arrays = m_storage->arrays();
    int i = 2;
    while (i >= 0 && arrays.apex(halfedge(i)) == null_index)
      --i;
    return i;
  }

  decltype(auto) info() const { return m_storage->face_info(m_index); }

  bool is_valid(bool = false, int = 0) const { return true; }

  // What Indexed_container_2 needs.
  static Index size_with_holes(const Storage& s) { return s.faces_with_holes(); }
  static std::size_t size(const Storage& s) { return s.number_of_faces(); }
  static bool is_hole(const Storage& s, Face_index f) { return s.is_erased_face(f); }
  static Face_handle create(Storage& s) { return {&s, s.create_face()}; }
  static Face_handle create(Storage& s, const Vertex_handle& v0, const Vertex_handle& v1,
                            const Vertex_handle& v2)
  {
    const Face_handle f = create(s);
    f->set_vertices(v0, v1, v2);
    return f;
  }
  static Face_handle create(Storage& s, const Vertex_handle& v0, const Vertex_handle& v1,
                            const Vertex_handle& v2, const Face_handle& g0, const Face_handle& g1,
                            const Face_handle& g2)
  {
    const Face_handle f = create(s, v0, v1, v2);
    f->set_neighbors(g0, g1, g2);
    return f;
  }
  // Does not take over the vertices and neighbors of a face of another storage.
  static Face_handle create(Storage& s, const Indexed_face_2& other)
  {
    const Face_handle f = create(s);
    if (other.m_storage == &s) {
      f->set_vertices(other.vertex(0), other.vertex(1), other.vertex(2));
      f->set_neighbors(other.neighbor(0), other.neighbor(1), other.neighbor(2));
      s.face_properties().copy(other.m_index, f.index());
    }
    if constexpr (!std::is_void_v<typename Storage::Face_info>)
      if (other.m_storage != nullptr)
        f->info() = other.info();
    return f;
  }
  static void erase(Storage& s, Face_index f) { s.erase_face(f); }
  static void clear(Storage& s) { s.clear_faces(); }
  static void reserve(Storage& s, std::size_t number) { s.reserve_faces(number); }

private:
  template <class Element>
  friend class Indexed_handle_2;
  using Indexed_element_2<Storage_, Face_index>::m_storage; // accessible to the handle, a friend
  using Indexed_element_2<Storage_, Face_index>::m_index;

  // Private, because it would make a handle refer to another face.
  Indexed_face_2& operator=(const Indexed_face_2&) = default;

  Halfedge_index halfedge(int i) const
  {
    CGAL_precondition(i >= 0 && i <= 2);
    return Halfedge_arrays_2::halfedge_in(m_index, Index(i));
  }

  auto is_vertex(const Vertex_handle& v) const
  {
    return [this, v](int i) { return vertex(i) == v; };
  }
  auto is_neighbor(const Face_handle& g) const
  {
    return [this, g](int i) { return neighbor(i) == g; };
  }

  template <class Predicate>
  static bool find(int& found, const Predicate& is)
  {
    for (int i = 0; i < 3; ++i)
      if (is(i)) {
        found = i;
        return true;
      }
    return false;
  }

  // Returns the i for which is(i) is true. There must be one.
  template <class Predicate>
  static int index_where(const Predicate& is)
  {
    const int i = is(0) ? 0 : is(1) ? 1 : 2;
    CGAL_assertion(is(i));
    return i;
  }

public:
  Indexed_face_2(const Indexed_face_2&) = default;
  Indexed_face_2() = default;
};

// No combinatorial information is read or written, as with CGAL's bases.
template <class Storage>
std::istream& operator>>(std::istream& in, Indexed_vertex_2<Storage>& v)
{
  return in >> v.point();
}
template <class Storage>
std::ostream& operator<<(std::ostream& out, const Indexed_vertex_2<Storage>& v)
{
  return out << v.point();
}
template <class Storage>
std::istream& operator>>(std::istream& in, Indexed_face_2<Storage>&)
{
  return in;
}
template <class Storage>
std::ostream& operator<<(std::ostream& out, const Indexed_face_2<Storage>&)
{
  return out;
}

// The vertices or the faces of a storage, with the interface of `Compact_container` that
// `Triangulation_data_structure_2` uses. It does not own the storage, and has none after a move.
template <class Element>
class Indexed_container_2
{
public:
  using Storage = typename Element::Storage;
  using value_type = Element;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using iterator = Indexed_handle_2<Element>;
  using const_iterator = iterator;

  void attach(Storage* storage) { m_storage = storage; }

  iterator begin() const
  {
    return m_storage == nullptr ? end() : at(iterator::next(*m_storage, typename Element::Number(0)));
  }
  iterator end() const { return at(iterator::end_index); }
  size_type size() const { return m_storage == nullptr ? 0 : Element::size(*m_storage); }
  bool empty() const { return size() == 0; }
  bool is_used(const iterator& i) const
  {
    return i.index() < Element::size_with_holes(*m_storage) &&
           !Element::is_hole(*m_storage, i.index());
  }
  bool owns(const iterator& i) const { return i == end() || owns_dereferenceable(i); }
  bool owns_dereferenceable(const iterator& i) const { return i == at(i.index()) && is_used(i); }

  template <class... Arguments>
  iterator emplace(const Arguments&... arguments)
  {
    return Element::create(*m_storage, arguments...);
  }
  iterator insert(const Element& other) { return Element::create(*m_storage, other); }
  void erase(const iterator& i) { Element::erase(*m_storage, i.index()); }
  void clear()
  {
    if (m_storage != nullptr)
      Element::clear(*m_storage);
  }
  void reserve(size_type number) { Element::reserve(*m_storage, number); }
  void swap(Indexed_container_2& other) { std::swap(m_storage, other.m_storage); }

private:
  iterator at(typename Element::Number i) const { return iterator(m_storage, i); }

  Storage* m_storage = nullptr;
};

// The base that makes Indexed_vertex_2 or Indexed_face_2 the vertices or faces of CGAL's structure.
template <class Element>
struct Indexed_base_2
{
  template <class Tds>
  struct Rebind_TDS
  {
    using Other = Element;
  };
};

template <class Storage>
using Indexed_tds_base_2 = Triangulation_data_structure_2<Indexed_base_2<Indexed_vertex_2<Storage>>,
                                                          Indexed_base_2<Indexed_face_2<Storage>>>;

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

/// \cond

// Specializations that make `Triangulation_data_structure_2` work on a storage: its containers, and
// a circulator of vertices that holds the handle of its vertex. CGAL's circulator would return a
// reference into a handle that no longer exists.
template <class Storage, class Allocator, class IncrementPolicy, class TimeStamper>
class Compact_container<Dynamic_Delaunay_triangulations_2::internal::Indexed_vertex_2<Storage>,
                        Allocator, IncrementPolicy, TimeStamper>
  : public Dynamic_Delaunay_triangulations_2::internal::Indexed_container_2<
        Dynamic_Delaunay_triangulations_2::internal::Indexed_vertex_2<Storage>>
{
};

template <class Storage, class Allocator, class IncrementPolicy, class TimeStamper>
class Compact_container<Dynamic_Delaunay_triangulations_2::internal::Indexed_face_2<Storage>,
                        Allocator, IncrementPolicy, TimeStamper>
  : public Dynamic_Delaunay_triangulations_2::internal::Indexed_container_2<
        Dynamic_Delaunay_triangulations_2::internal::Indexed_face_2<Storage>>
{
};

template <class Storage>
class Triangulation_ds_vertex_circulator_2<
    Dynamic_Delaunay_triangulations_2::internal::Indexed_tds_base_2<Storage>>
  : public Bidirectional_circulator_base<
        Dynamic_Delaunay_triangulations_2::internal::Indexed_vertex_2<Storage>>,
    public Triangulation_cw_ccw_2
{
public:
  using Vertex = Dynamic_Delaunay_triangulations_2::internal::Indexed_vertex_2<Storage>;
  using Face = Dynamic_Delaunay_triangulations_2::internal::Indexed_face_2<Storage>;
  using Vertex_handle = typename Storage::Vertex_handle;
  using Face_handle = typename Storage::Face_handle;
  using Vertex_circulator = Triangulation_ds_vertex_circulator_2;

  Triangulation_ds_vertex_circulator_2() = default;
  Triangulation_ds_vertex_circulator_2(const Vertex_handle& v, Face_handle f = Face_handle())
  {
    if (v == Vertex_handle())
      return;
    if (f == Face_handle())
      f = v->face();
    if (f == Face_handle() || f->dimension() < 1)
      return;
    m_center = v;
    go_to(f);
  }

  Vertex_circulator& operator++()
  {
    const int i = m_face->index(m_center);
    go_to(m_face->neighbor(m_face->dimension() == 1 ? 1 - i : ccw(i)));
    return *this;
  }
  Vertex_circulator operator++(int)
  {
    const Vertex_circulator before(*this);
    ++*this;
    return before;
  }
  Vertex_circulator& operator--()
  {
    const int i = m_face->index(m_center);
    go_to(m_face->neighbor(m_face->dimension() == 1 ? 1 - i : cw(i)));
    return *this;
  }
  Vertex_circulator operator--(int)
  {
    const Vertex_circulator before(*this);
    --*this;
    return before;
  }

  bool operator==(const Vertex_circulator& other) const
  {
    return m_center == other.m_center && m_vertex == other.m_vertex && m_face == other.m_face;
  }
  bool operator!=(const Vertex_circulator& other) const { return !(*this == other); }
  bool operator==(const Vertex_handle& v) const { return m_vertex == v; }
  bool operator!=(const Vertex_handle& v) const { return m_vertex != v; }
  friend bool operator==(const Vertex_handle& v, const Vertex_circulator& c) { return c == v; }
  friend bool operator!=(const Vertex_handle& v, const Vertex_circulator& c) { return c != v; }
  bool is_empty() const { return m_center == Vertex_handle(); }
  bool operator==(std::nullptr_t) const { return is_empty(); }
  bool operator!=(std::nullptr_t) const { return !is_empty(); }

  Vertex& operator*() const { return *m_vertex; }
  Vertex* operator->() const { return &*m_vertex; }
  Vertex_handle base() const { return m_vertex; }
  operator Vertex_handle() const { return m_vertex; }

private:
  // Moves to the vertex after the center in face f, counterclockwise.
  void go_to(const Face_handle& f)
  {
    m_face = f;
    const int i = f->index(m_center);
    m_vertex = f->vertex(f->dimension() == 1 ? 1 - i : ccw(i));
  }

  Vertex_handle m_center, m_vertex;
  Face_handle m_face;
};

namespace internal {
namespace handle {

template <class Element>
struct Hash_functor<Dynamic_Delaunay_triangulations_2::internal::Indexed_handle_2<Element>>
{
  std::size_t
  operator()(const Dynamic_Delaunay_triangulations_2::internal::Indexed_handle_2<Element>& h) const
  {
    return hash_value(h);
  }
};

} // namespace handle
} // namespace internal

/// \endcond

} // namespace CGAL

namespace std {

template <class Element>
struct hash<CGAL::Dynamic_Delaunay_triangulations_2::internal::Indexed_handle_2<Element>>
{
  std::size_t operator()(
      const CGAL::Dynamic_Delaunay_triangulations_2::internal::Indexed_handle_2<Element>& h) const
  {
    return hash_value(h);
  }
};

} // namespace std

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_INDEXED_ELEMENTS_2_H
