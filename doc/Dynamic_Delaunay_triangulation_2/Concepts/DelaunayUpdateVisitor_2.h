// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A visitor is told what changes, as by those of CGAL's kinetic data structures: so it can keep data of faces,
edges and vertices in step with them. `CGAL::Delaunay_update_visitor_base_2` has all functions, and is a base for
visitors that need some of them.

Each call of the triangulation that may change it, construction from points,
`update()`, `move()`, `insert()`, `remove()`, `mend()` if there is something to mend, and `read_checkpoint()`,
begins with `before_update()` and ends with `after_update()`. A frame of a `CGAL::Dynamic_population_2` is one such
call, whoever comes and goes in it. Between these two

- faces and vertices around those that are named can be looked at; not all of `tds()`, which may hold faces and
  vertices that are about to be written or deleted;
- vertices that move, in `update()` and in `move()`, still have the points that they had before, and get theirs right
  before `after_update()`, or in a rebuild; new vertices have theirs at once. So face areas, circumcentres and the
  like are best computed in `after_update()`;
- a vertex may be outside of all faces, from `before_vertex_relocation()` until the creation of its faces is told, and
  `v->face()` then means nothing;
- the triangulation is not certified, and may have inverted faces: `CGAL::Dynamic_Delaunay_triangulation_2::tds()`,
  `infinite_vertex()` and `id()` may be asked for, but neither `triangulation()` nor `frame()`, and nothing may be
  changed but what the user keeps in vertices and faces.

Faces with the infinite vertex are told of like all others. While the points do not span the plane there are no
faces to tell of, but vertices still come and go.

What happens to a face is either a flip, which keeps the handles of both faces, or a removal or creation. A face that
is created may have the handle of one that has just been removed, and then has what the user kept in that one. Of
several faces that are written anew together all removals are told first, then what becomes of vertices, and then all
creations; but a new vertex that is put into a face is told of before the removal of that face. In a rebuild that is
all faces. An edge may be flipped more than once in an update, and a face be removed and created.

If a visitor throws in `before_update()`, nothing changes. If it throws in one of the functions between
`before_update()` and `after_update()`, it is told nothing more, not even `after_update()`; the triangulation goes on
to the end as if nobody had thrown, to the same result, and then throws that exception instead of returning its report.
If the call ends by any other exception, `after_update()` is not called.

A visitor is copied into the triangulation when that is constructed, and is never copied after that. The triangulation
may be moved between two calls: no visitor should keep its address. All functions are templates, as the type of the
triangulation depends on that of the visitor.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_update_visitor_base_2}
\cgalHasModels{CGAL::Edge_changes_visitor_2}
\cgalHasModelsEnd
*/
class DelaunayUpdateVisitor_2
{
public:
  /*!
  is called when the input of a call was read and accepted, before anything changes.
  \tparam Dynamic a `CGAL::Dynamic_Delaunay_triangulation_2`
  */
  template <class Dynamic>
  void before_update(const Dynamic& dt);

  /*!
  is called when all is done; `report` is what the call returns, or would if it returned one. From here on `dt` may
  be used like between two calls.
  */
  template <class Dynamic>
  void after_update(const Dynamic& dt, const Update_report_2& report);

  /*!
  edge `e` will be flipped.
  */
  template <class Dynamic>
  void before_flip(const Dynamic& dt, const typename Dynamic::Edge& e);

  /*!
  `e` is the edge that has come by a flip, between the same two faces.
  */
  template <class Dynamic>
  void after_flip(const Dynamic& dt, const typename Dynamic::Edge& e);

  /*!
  face `f` will be no more.
  */
  template <class Dynamic>
  void before_face_removal(const Dynamic& dt, typename Dynamic::Face_handle f);

  /*!
  face `f` is new.
  */
  template <class Dynamic>
  void after_face_creation(const Dynamic& dt, typename Dynamic::Face_handle f);

  /*!
  vertex `v` is new, for the point with this id. It has its point, and its faces are going to be created.
  */
  template <class Dynamic>
  void after_vertex_creation(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id);

  /*!
  vertex `v`, which was that of the point with this id, will be no more; the removal of its faces was told. The point
  may still be there: if other points shared its vertex, these get a new one in a rebuild.
  */
  template <class Dynamic>
  void before_vertex_removal(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id);

  /*!
  vertex `v`, that of the point with this id, is taken out of its faces, because it went far; the removal of these was
  told. It will be put in elsewhere, and keeps its handle, its id and what the user keeps in it: the creation of its
  new faces is told later in the same call. If another vertex is where it has gone to, `before_vertex_merge()` is
  called for it instead. Everything may be rebuilt in between, which writes all faces anew.
  */
  template <class Dynamic>
  void before_vertex_relocation(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id);

  /*!
  vertex `v`, which was that of the point with this id, will be no more; the removal of its faces was told. The point
  has come to where another one is, and shares the vertex `stays` from now on.
  */
  template <class Dynamic>
  void before_vertex_merge(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id,
                           typename Dynamic::Vertex_handle stays);

  /*!
  vertex `v` is another point's: that of `dt.id(v)`, which shared it, instead of that with `id_before`, which goes
  away.
  */
  template <class Dynamic>
  void after_id_change(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id_before);
};
