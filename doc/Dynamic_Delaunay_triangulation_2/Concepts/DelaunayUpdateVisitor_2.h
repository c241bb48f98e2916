// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A visitor is called for every change, as the visitors of CGAL's kinetic data structures are, so it
can keep data of faces, edges and vertices correct. `CGAL::Delaunay_update_visitor_base_2` has all
functions, and is a base for visitors that need only some of them.

A visitor may have a member `bool is_listening() const` as well, which is asked in each call. While
it is false, only `before_update()` and `after_update()` are called, and the rest costs nothing: so
a program that need not know all changes can have the same type as one that must. Its answer may
change between calls, but not after one that has failed, until another one has succeeded.

The calls that may change the triangulation are construction from points, `update()`, `move()`,
`insert()`, `remove()`, `mend()` if there is something to repair, and `read_checkpoint()`. Each of
them begins with `before_update()` and ends with `after_update()`. A frame of a
`CGAL::Dynamic_population_2` is one such call, whichever points are inserted and removed in it.
Between these two

- a visitor may read faces and vertices around those that it is called for, but not all of `tds()`,
  which may contain faces and vertices that are about to be written or deleted;
- vertices that move, in `update()` and in `move()`, have their new points already, in faces that
  may be inverted by that. There are three exceptions. While points of the same frame are removed,
  all others may be where they were before. A vertex that the repair holds back has a point in
  between, until it moves on or is put in. And where a frame is taken in steps, all vertices have
  the points where they have stopped, until the last step begins. So face areas, circumcenters and
  the like are best computed in `after_update()`;
- the handles that a function gets are valid until the next one is called: a rebuild, an insertion
  or a removal may give vertices and faces other indices, and handles refer to indices. What a
  visitor wants to remember it keeps under ids, or in data of vertices and faces;
- a vertex may be outside of all faces, from `before_vertex_relocation()` until the visitor is
  called for the creation of its faces, and `v->face()` then has no meaning;
- the triangulation is not certified, and may have inverted faces.
  `CGAL::Dynamic_Delaunay_triangulation_2::tds()`, `infinite_vertex()` and `id()` may be called, but
  neither `triangulation()` nor `frame()`, and nothing may be changed except the user's data in
  vertices and faces.

Faces with the infinite vertex are treated like all others. While the points do not span the plane
there are no faces, but vertices are still created and removed.

A face is either flipped, which keeps the handles of both faces, or removed or created. A face that
is created may have the handle of one that has been removed, and then contains the user's data of
that one, or of another one after a rebuild. If several faces are rewritten together, the visitor is
called first for all removals, then for the changes of vertices, and then for all creations. There
is one exception: for a new vertex that is put into faces, it is called before their removal. In a
rebuild all faces are rewritten: the visitor is called for the vertices that go before that, and for
new vertices after it. An edge may be flipped more than once in an update, and a face may be removed
and created.

If a visitor throws in `before_update()`, nothing changes. If it throws in one of the functions
between `before_update()` and `after_update()`, it is not called again in this call, not even
`after_update()`. The triangulation continues to the same result as without the exception, and then
throws that exception instead of returning its report. If the call ends by any other exception,
`after_update()` is not called.

The constructor of the triangulation copies the visitor, and it is never copied after that. The
triangulation may be moved between two calls: no visitor should keep its address. All functions are
templates, as the type of the triangulation depends on that of the visitor.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_update_visitor_base_2}
\cgalHasModels{CGAL::Edge_changes_visitor_2}
\cgalHasModelsEnd
*/
class DelaunayUpdateVisitor_2
{
public:
  /*!
  is called after the input of a call was read and accepted, before anything changes.
  \tparam Dynamic a `CGAL::Dynamic_Delaunay_triangulation_2`
  */
  template <class Dynamic>
  void before_update(const Dynamic& dt);

  /*!
  is called at the end of a call. `report` is the report of the call, also if the call does not
  return one. From here on `dt` may be used as between two calls.
  */
  template <class Dynamic>
  void after_update(const Dynamic& dt, const Update_report_2& report);

  /*!
  is called before edge `e` is flipped.
  */
  template <class Dynamic>
  void before_flip(const Dynamic& dt, const typename Dynamic::Edge& e);

  /*!
  is called after a flip. `e` is the new edge between the same two faces.
  */
  template <class Dynamic>
  void after_flip(const Dynamic& dt, const typename Dynamic::Edge& e);

  /*!
  is called before face `f` is removed.
  */
  template <class Dynamic>
  void before_face_removal(const Dynamic& dt, typename Dynamic::Face_handle f);

  /*!
  is called after face `f` was created.
  */
  template <class Dynamic>
  void after_face_creation(const Dynamic& dt, typename Dynamic::Face_handle f);

  /*!
  is called after vertex `v` was created for the point with this id. It has its point;
  `after_face_creation()` is called for its faces later.
  */
  template <class Dynamic>
  void after_vertex_creation(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id);

  /*!
  is called before vertex `v`, the vertex of the point with this id, is removed, and after
  `before_face_removal()` for its faces. The point itself may stay: if other points shared its
  vertex, these get a new one in a rebuild. A rebuild that fails, as memory runs out, calls
  `after_vertex_creation()` for the vertices whose removal it has announced.
  */
  template <class Dynamic>
  void before_vertex_removal(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id);

  /*!
  is called when vertex `v`, the vertex of the point with this id, is taken out of its faces because
  it cannot get to its position through them, and after `before_face_removal()` for these faces. The
  vertex will be put in elsewhere, and keeps its id and the user's data: `after_face_creation()` is
  called for its new faces later in the same call. If another vertex is at its new position,
  `before_vertex_merge()` is called for it instead. A rebuild in between may rewrite all faces.
  */
  template <class Dynamic>
  void before_vertex_relocation(const Dynamic& dt, typename Dynamic::Vertex_handle v,
                                std::size_t id);

  /*!
  is called before vertex `v`, the vertex of the point with this id, is removed because the point
  has come to the position of another one, and after `before_face_removal()` for its faces. The
  point shares the vertex `stays` from now on.
  */
  template <class Dynamic>
  void before_vertex_merge(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id,
                           typename Dynamic::Vertex_handle stays);

  /*!
  is called when vertex `v` gets another representative: the point with the id `dt.id(v)`, which
  shared the vertex, instead of the one with `id_before`, which leaves it.
  */
  template <class Dynamic>
  void after_id_change(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id_before);
};
