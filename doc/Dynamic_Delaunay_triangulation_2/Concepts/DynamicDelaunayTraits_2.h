// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

The points of a `CGAL::Dynamic_Delaunay_triangulation_2`, and the predicates about them. The plane that is triangulated
is that of their `x()` and `y()`: traits that project onto another plane, such as `Projection_traits_yz_3`, are no
models.

A point may hold more than its place, such as a height, or a name. Nothing of that is looked at, and it stays with the
point: `CGAL::Dynamic_Delaunay_triangulation_2::point()` returns all that the user has given last, and the vertex has
the point of the one whose id it names (`CGAL::Dynamic_Delaunay_triangulation_2::id()`). Points *coincide* if they are
equal in `x()` and `y()`, whatever else they hold. A frame with other heights and the same places breaks nothing.

Points that are a kernel's `Point_2` with doubles for coordinates are the fastest: they are made of the flat arrays
again, and need no room of their own. Others are kept beside these. As long as their coordinates are doubles, the
floating-point filters decide nearly all signs just the same.

Checkpoints keep `x()` and `y()` only: `CGAL::Dynamic_Delaunay_triangulation_2::write_checkpoint()` and
`CGAL::Dynamic_Delaunay_triangulation_2::read_checkpoint()` compile for a kernel's `Point_2` alone. Other parts ask for
more where their pages say so, such as `CGAL::Delaunay_point_queries_2`; `CGAL::Relocation_repair_2` compares points by
`==`, as CGAL does when it moves them.

\cgalRefines{DelaunayTriangulationTraits_2}

The traits are default constructible.

\cgalHasModelsBegin
\cgalHasModels{Exact_predicates_inexact_constructions_kernel}
\cgalHasModels{Exact_predicates_exact_constructions_kernel}
\cgalHasModels{Projection_traits_xy_3<K>, for each of these kernels}
\cgalHasModelsEnd
*/
class DynamicDelaunayTraits_2
{
public:
  /*!
  the point type. It is default constructible, can be copied and assigned, and has member functions `x()` and `y()`,
  whose values have `CGAL::to_double()`, to the nearest double or one of its neighbors, and, where they are not of the
  type `double`, `CGAL::to_interval()`. Where both bounds of the interval are equal they are the coordinate.
  It has an `operator<<`, by which CGAL says which points are not as they should be.
  */
  using Point_2 = unspecified_type;

  /*!
  compares `x()` of two points, exactly.
  */
  using Compare_x_2 = unspecified_type;

  /*!
  compares `y()` of two points, exactly.
  */
  using Compare_y_2 = unspecified_type;

  /*!
  the orientation of three points by their `x()` and `y()`, exactly.
  */
  using Orientation_2 = unspecified_type;

  /*!
  on which side of the circle through three points a fourth one is, by their `x()` and `y()`, exactly.
  */
  using Side_of_oriented_circle_2 = unspecified_type;
};
