// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

The traits define the points of a `CGAL::Dynamic_Delaunay_triangulation_2`, and the predicates on
them. The points are triangulated in the plane of their `x()` and `y()`: traits that project onto
another plane, such as `Projection_traits_yz_3`, are no models.

A point may contain more than its position, such as a height or a name. The triangulation ignores
this data, and keeps it with the point: `CGAL::Dynamic_Delaunay_triangulation_2::point()` returns
the whole point that the user gave last, and a vertex has the point of its representative, whose id
is `CGAL::Dynamic_Delaunay_triangulation_2::id()`. Points *coincide* if they are equal in `x()` and
`y()`, whatever else they contain. A frame in which only heights change breaks nothing.

The fastest points are a kernel's `Point_2` that is two doubles and nothing else: the array of
positions is that of the points. Other points are stored beside their positions. If their
coordinates are doubles, the floating-point filters decide nearly all signs just the same.

Checkpoints keep `x()` and `y()` only. Therefore
`CGAL::Dynamic_Delaunay_triangulation_2::write_checkpoint()` and
`CGAL::Dynamic_Delaunay_triangulation_2::read_checkpoint()` compile for a kernel's `Point_2` alone.
Other parts of the package say on their pages if they require more, such as
`CGAL::Delaunay_point_queries_2`. `CGAL::Relocation_repair_2` compares points by `==`, as CGAL does
when it moves them.

Traits may have circles of their own, such as those of a metric in which distances depend on the
direction. They say so by a member `static constexpr bool has_euclidean_circles = false`. Then the
predicates below decide every sign, without a filter, and all guarantees hold with these circles:
the edges are those of `Delaunay_triangulation_2` with these traits. Orientations are the usual
ones, and the circles must define a triangulation for all points, as they do if a linear map makes
them round. Queries for distances ask `Compare_distance_2`. Voronoi cells, interpolation weights and
alpha shapes are computed for Euclidean circles only, and do not compile for such traits.

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
  the point type. It is default constructible, can be copied and assigned, and has member functions
  `x()` and `y()`. `CGAL::to_double()` of their values returns the nearest double or one of its
  neighbors. If the values are not of the type `double`, they also have `CGAL::to_interval()`; where
  both bounds of the interval are equal they are the coordinate. The type has an `operator<<`, which
  CGAL uses in its messages about invalid points.
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
  the side of the circle through three points on which a fourth one is, by their `x()` and `y()`,
  exactly.
  */
  using Side_of_oriented_circle_2 = unspecified_type;
};
