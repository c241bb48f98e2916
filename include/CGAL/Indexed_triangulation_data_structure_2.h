// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INDEXED_TRIANGULATION_DATA_STRUCTURE_2_H
#define CGAL_INDEXED_TRIANGULATION_DATA_STRUCTURE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cgal/Indexed_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cgal/Indexed_storage_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_ds_face_base_2.h>
#include <CGAL/Triangulation_ds_vertex_base_2.h>
#include <CGAL/Unique_hash_map.h>

#include <memory>
#include <string>
#include <utility>

namespace CGAL {
/*!
\ingroup PkgDynamicDelaunayTriangulation2VertexFaceClasses

A triangulation data structure on flat arrays with indices of 32 bits. `Delaunay_triangulation_2`
and CGAL's other triangulations without constraints run on it, with all their functions. A
`Dynamic_Delaunay_triangulation_2` keeps its topology in one, and nowhere else.

A vertex whose point is two doubles takes 20 bytes, and a face 36: 92 bytes a point, where CGAL's
`Triangulation_data_structure_2` takes 136. A `Dynamic_Delaunay_triangulation_2` adds 60 bytes a
point for its edges.

<b>Handles.</b> A handle is a pointer to the arrays, and an index, `h.index()`. It stays valid when
elements are added, and when the structure is moved or swapped. Vertices and faces are not objects
in memory: the `Vertex` that `*v` or `v->` gives lives in the handle `v`, and only as long as `v`.
So take handles by value, and do not store the address of a vertex or a face. A reference to a point
is valid until the next vertex is added.

<b>Your data.</b> Vertices and faces cannot be derived from. Choose `VertexInfo` and `FaceInfo` for
what `info()` of a vertex or a face returns, as with `Triangulation_vertex_base_with_info_2`, or add
properties at run time with `add_vertex_property()` and `add_face_property()`. Both follow their
vertices and faces when indices change.

\tparam Traits the geometric traits of the triangulation, which have `Point_2`.
\tparam VertexInfo the type of `info()` of a vertex; default constructible and copyable, not `bool`.
  Without it, vertices have no `info()`.
\tparam FaceInfo the type of `info()` of a face, with the same demands.

\cgalModels{TriangulationDataStructure_2}

\sa `Triangulation_data_structure_2`
*/
template <class Traits, class VertexInfo = void, class FaceInfo = void>
class Indexed_triangulation_data_structure_2
#ifndef DOXYGEN_RUNNING
  : public Dynamic_Delaunay_triangulations_2::internal::Indexed_tds_base_2<
        Dynamic_Delaunay_triangulations_2::internal::Indexed_storage_2<typename Traits::Point_2,
                                                                       VertexInfo, FaceInfo>>
#endif
{
  using Storage =
      Dynamic_Delaunay_triangulations_2::internal::Indexed_storage_2<typename Traits::Point_2,
                                                                     VertexInfo, FaceInfo>;
  using Base = Dynamic_Delaunay_triangulations_2::internal::Indexed_tds_base_2<Storage>;
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Face_index = Dynamic_Delaunay_triangulations_2::Face_index;

public:
  /// \name Types
  /// @{

  /// the type of `info()` of a vertex, or `void`.
  using Vertex_info = VertexInfo;
  /// the type of `info()` of a face, or `void`.
  using Face_info = FaceInfo;
  /// a handle of a vertex, and an iterator.
  using Vertex_handle = typename Storage::Vertex_handle;
  /// a handle of a face, and an iterator.
  using Face_handle = typename Storage::Face_handle;
  /// the type of a property map from vertex handles to values of type `T`, a model of
  /// `LvaluePropertyMap`.
  template <class T>
  using Vertex_property_map = typename Storage::Vertex_properties::template Map<T>;
  /// the type of a property map from face handles to values of type `T`, a model of
  /// `LvaluePropertyMap`.
  template <class T>
  using Face_property_map = typename Storage::Face_properties::template Map<T>;

  /// \cond
  // Vertices and faces of other types need another structure.
  template <class Vb>
  struct Rebind_vertex
  {
    using Other = Triangulation_data_structure_2<Vb, Triangulation_ds_face_base_2<>>;
  };
  template <class Fb>
  struct Rebind_face
  {
    using Other = Triangulation_data_structure_2<Triangulation_ds_vertex_base_2<>, Fb>;
  };
  /// \endcond

  /// @}
  /// \name Creation
  /// @{

  /// creates an empty structure.
  Indexed_triangulation_data_structure_2()
    : m_storage(std::make_unique<Storage>())
  {
    attach();
  }

  /// copies the vertices, the faces and all data of users. An element has the same index in the
  /// copy. Cost: linear.
  Indexed_triangulation_data_structure_2(const Indexed_triangulation_data_structure_2& other)
    : Base()
    , m_storage(other.m_storage ? std::make_unique<Storage>(*other.m_storage)
                                : std::make_unique<Storage>())
  {
    attach();
    this->set_dimension(other.dimension());
  }
  /// replaces this structure by a copy of the other one. If it throws, nothing has changed.
  Indexed_triangulation_data_structure_2&
  operator=(const Indexed_triangulation_data_structure_2& other)
  {
    Indexed_triangulation_data_structure_2 copy(other);
    swap(copy);
    return *this;
  }

  /// takes everything from the other structure. Handles stay valid. The other structure can then
  /// only be destroyed, cleared, swapped, or assigned to.
  Indexed_triangulation_data_structure_2(Indexed_triangulation_data_structure_2&& other) noexcept
    : m_storage(std::move(other.m_storage))
  {
    attach();
    this->set_dimension(other.dimension());
    other.attach();
    other.set_dimension(-2);
  }
  /// replaces this structure by the other one, which is left as by the move constructor.
  Indexed_triangulation_data_structure_2&
  operator=(Indexed_triangulation_data_structure_2&& other) noexcept
  {
    Indexed_triangulation_data_structure_2 taken(std::move(other));
    swap(taken);
    return *this;
  }

  /// \cond
  // The destructor of the base class clears its containers, so they must have no storage by then.
  ~Indexed_triangulation_data_structure_2()
  {
    m_storage.reset();
    attach();
  }
  /// \endcond

  /// exchanges everything with the other structure. Handles stay valid.
  void swap(Indexed_triangulation_data_structure_2& other) noexcept
  {
    m_storage.swap(other.m_storage);
    attach();
    other.attach();
    const int dimension = this->dimension();
    this->set_dimension(other.dimension());
    other.set_dimension(dimension);
  }

  /// removes all vertices and faces.
  void clear()
  {
    if (!m_storage)
      m_storage = std::make_unique<Storage>();
    attach();
    Base::clear();
  }

  /// makes this structure a copy of the other one. \return the copy of vertex `v`;
  /// `Vertex_handle()` if there is no `v`, or if both structures are the same one, which then does
  /// not change.
  Vertex_handle copy_tds(const Indexed_triangulation_data_structure_2& other,
                         Vertex_handle v = Vertex_handle())
  {
    if (this == &other)
      return Vertex_handle();
    *this = other;
    return v == Vertex_handle() ? v : vertex_handle(v.index());
  }

  /// makes this structure a copy of one of another type, whose vertices have points of the same
  /// type. Cost: linear. \return the copy of vertex `v`.
  template <class OtherTds>
  Vertex_handle copy_tds(const OtherTds& other,
                         typename OtherTds::Vertex_handle v = typename OtherTds::Vertex_handle())
  {
    return copy_tds(
        other, v, [](const auto& from, auto& to) { to.set_point(from.point()); },
        [](const auto&, auto&) {});
  }

  /// makes this structure a copy of one of another type, by converters. `convert_vertex(from, to)`
  /// is called for each vertex `from` and its copy `to`, which has no point before;
  /// `convert_face(from, to)` for each face. CGAL's converters have further functions with one
  /// argument, which are not called.
  template <class OtherTds, class ConvertVertex, class ConvertFace>
  Vertex_handle copy_tds(const OtherTds& other, typename OtherTds::Vertex_handle v,
                         const ConvertVertex& convert_vertex, const ConvertFace& convert_face)
  {
    Indexed_triangulation_data_structure_2 copy;
    const std::size_t vertices = other.number_of_vertices();
    const std::size_t faces = other.faces().size();
    copy.vertices().reserve(vertices);
    copy.faces().reserve(faces);
    Unique_hash_map<typename OtherTds::Vertex_handle, Vertex_handle> copy_of_vertex(Vertex_handle(),
                                                                                    vertices);
    Unique_hash_map<typename OtherTds::Face_handle, Face_handle> copy_of_face(Face_handle(), faces);
    for (auto w = other.vertices().begin(); w != other.vertices().end(); ++w) {
      const Vertex_handle to = copy_of_vertex[w] = copy.create_vertex();
      convert_vertex(*w, *to);
    }
    for (auto f = other.faces().begin(); f != other.faces().end(); ++f)
      copy_of_face[f] = copy.create_face();
    for (auto f = other.faces().begin(); f != other.faces().end(); ++f) {
      const Face_handle to = copy_of_face[f];
      for (int i = 0; i < 3; ++i) {
        if (f->vertex(i) != typename OtherTds::Vertex_handle())
          to->set_vertex(i, copy_of_vertex[f->vertex(i)]);
        if (f->neighbor(i) != typename OtherTds::Face_handle())
          to->set_neighbor(i, copy_of_face[f->neighbor(i)]);
      }
      convert_face(*f, *to);
    }
    for (auto w = other.vertices().begin(); w != other.vertices().end(); ++w)
      if (w->face() != typename OtherTds::Face_handle())
        copy_of_vertex[w]->set_face(copy_of_face[w->face()]);
    copy.set_dimension(other.dimension());
    swap(copy);
    return v == typename OtherTds::Vertex_handle() ? Vertex_handle() : copy_of_vertex[v];
  }

  /// @}
  /// \name Indices
  /// @{

  /// the handle of the vertex with this index. \pre there is one.
  Vertex_handle vertex_handle(std::size_t index) const
  {
    return Vertex_handle(m_storage.get(), Vertex_index(index));
  }
  /// the handle of the face with this index. \pre there is one.
  Face_handle face_handle(std::size_t index) const
  {
    return Face_handle(m_storage.get(), Face_index(index));
  }

  /// whether elements that were removed have left unused indices. New elements get these first.
  bool has_garbage() const { return m_storage && m_storage->has_holes(); }

  /// gives the elements consecutive indices from 0 on, in their previous order. All handles become
  /// invalid, so a triangulation that owns this structure can no longer be used: copy the structure
  /// first. Cost: linear; none if `has_garbage()` is false.
  void collect_garbage()
  {
    if (m_storage)
      m_storage->collect_garbage();
  }

  /// @}
  /// \name Properties
  /// @{

  /// adds a property to the vertices, with `value` for all present and future vertices. \return its
  /// map, and true; if a property with this name and type exists, its map, and false. The map is
  /// valid until this structure is destroyed or assigned to; if it is moved or swapped, the map
  /// belongs to the other structure.
  template <class T>
  std::pair<Vertex_property_map<T>, bool> add_vertex_property(const std::string& name,
                                                              const T& value = T())
  {
    return m_storage->vertex_properties().template add<T>(name, value);
  }
  /// adds a property to the faces, as `add_vertex_property()` does to the vertices.
  template <class T>
  std::pair<Face_property_map<T>, bool> add_face_property(const std::string& name,
                                                          const T& value = T())
  {
    return m_storage->face_properties().template add<T>(name, value);
  }

  /// @}

private:
  friend class Dynamic_Delaunay_triangulations_2::internal::Indexed_storage_access_2;

  void attach() noexcept
  {
    this->_vertices.attach(m_storage.get());
    this->_faces.attach(m_storage.get());
  }

  std::unique_ptr<Storage> m_storage;
};

} // namespace CGAL

#endif // CGAL_INDEXED_TRIANGULATION_DATA_STRUCTURE_2_H
