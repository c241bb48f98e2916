// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_MEASURES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_MEASURES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_boundary_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Cell_cutters_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Vertex_geometry_2.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The areas, perimeters, centroids and shape indices of the points' Voronoi cells: whole, in the plane
or in periodic space, or clipped to a box in the plane. The area of a cell is the space that its
point has for itself; its inverse is the local density. The shape index is the perimeter over the
square root of the area: 3.54 of a circle, 3.72 of a regular hexagon, 3.81 of a regular pentagon.
Lloyd's relaxation moves the points to the centroids repeatedly, until all cells are about alike.

Areas are in the squared unit of the coordinates, perimeters and centroids in that unit. Each of
them has an entry for every id.

- Points that coincide share a cell. Each gets an equal share of its area, so that the areas still
  add up, and the whole perimeter, the centroid and the shape index of the whole cell.
- In periodic space the centroid of each point, also of one that coincides with another by a
  translation, is near the point as it was given, wrapped or not.
- An unbounded cell has infinite area, perimeter and shape index. The cells of all points on the
  hull are unbounded; so are all cells if the points do not span the plane. In a space that is
  periodic in two directions all cells are bounded.
- An unbounded cell, and a clipped one without area, have no centroid. The point's own position
  takes its place: a relaxation leaves the point where it is.
- A clipped cell that does not reach into the box has the shape index 0. Without area, but with a
  perimeter, the shape index is infinite. Where a cell touches the box only from outside, rounding
  may leave it a tiny area, and so a centroid there.
- Removed ids have 0 for all measures.

For a `Dynamic_population_2`, the index of a cell is `population.id(user_id)`.

<b>Whole cells.</b> An edge with the angles \f$\alpha\f$ and \f$\beta\f$ opposite to it is dual to a
Voronoi edge of length \f$l (\cot \alpha + \cot \beta) / 2\f$, where \f$l\f$ is its own length, and
the triangles over that Voronoi edge from both of its ends have areas of
\f$l^2 (\cot \alpha + \cot \beta) / 8\f$ (Meyer, Desbrun, Schröder, Barr: *Discrete
differential-geometry operators for triangulated 2-manifolds*, 2003). The cell of a point consists
of those of its edges. Every face adds its three cotangents, which have one denominator, to its
three vertices. With \f$d\f$ the edge's vector from the point and \f$n\f$ the same turned by a right
angle into the face, the face's triangle has its centroid at \f$d / 3 + n \cot \alpha / 6\f$ from
the point; so the cell's centroid is a sum over faces, too. No circumcenter is computed. Still,
nearly flat faces cause large errors. With the circumradius \f$R\f$ and the shortest edge \f$h\f$ of
a face, areas of about \f$R^2\f$ cancel, and the result has an error of about \f$10^{-16} R^2\f$;
lengths have an error of about \f$10^{-16} R^2 / h\f$. Such faces occur at the hull and beside large
empty regions. If a face is so flat that rounding hides its orientation, which takes \f$R\f$ to be
\f$10^{15} h\f$ or so, the cells of its vertices count as unbounded. In periodic space the vectors
between points are rounded as their coordinates are: points far from the origin have such faces
sooner.

<b>Clipped cells.</b> The box is cut by the bisector of the point and each of its Delaunay
neighbors, one after the other, unless these bisectors enclose a cell that is all in the box. The
result is the cell, since the cell is where the point is as near as any of its Delaunay neighbors.
Nothing is divided by values that may vanish: flat faces and points on a line are no special cases.
With \f$D\f$ the diameter of the box, corners of cells are off by about \f$10^{-16} D\f$ across
their sides, and areas by about \f$10^{-16} D^2\f$, however far away the points are: if they are two
diameters away, exact arithmetic places their bisectors. So areas add up but for rounding. Areas
are never negative. Coordinates that are no doubles are rounded first. The centroid is a mean of
places between these corners, with weights that are never negative. So it stays between them,
however thin the cell is. Where a cell is about as wide as it is long, the centroid is as accurate
as its corners.

For whole cells, coordinates may be of any size whose cube is still a double; for clipped cells, of
any size.

An object keeps its memory: `compute()` allocates nothing if the triangulation had as many ids and
vertices before, and, for clipped cells, if no cell has more corners than any cell before.

\cgalExample{Dynamic_Delaunay_triangulation_2/lloyd_relaxation.cpp}

\sa `Voronoi_cell_gradients_2`
\sa `for_each_voronoi_edge()`
\sa `voronoi_cell_corners()`
*/
class Voronoi_cell_measures_2
{
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Face = Dynamic_Delaunay_triangulations_2::internal::Voronoi_face_2;
  template <class Dynamic>
  using Space = Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic>;

public:
  /// \name Types
  /// @{

  /// the type of ids.
  using size_type = std::size_t;
  /// a place: two doubles, `x` and `y`.
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;

  /// @}
  /// \name Computation
  /// If memory runs out, there are no measures.
  /// @{

  /// measures the whole cells.
  ///
  /// Cost: linear, one pass over the faces; in a slab one more.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_2` or
  ///   `Dynamic_periodic_Delaunay_triangulation_2`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    const Space<Dynamic> space(dt);
    start(space);
    m_sums.run(
        space,
        [](const std::array<Vertex_index, 3>& cells, const Face& face, const auto& add) {
          add_face(cells, face, add);
        },
        [this](Index c, const Cell& part) {
          m_cells[c].add(part.area, part.perimeter, part.moment);
        });
    space.for_each_open_cell([&](Index c) { m_cells[c] = Cell::unbounded(); });
    copy_to_ids(space, [&](Index id, Index c) {
      const Position p = space.position(id);
      const Cell& cell = m_cells[c];
      if (!cell.has_centroid())
        return p;
      const double weight = 3 * cell.area;
      return Position{p.x + cell.moment.x / weight, p.y + cell.moment.y / weight};
    });
  }

  /// measures the parts of the cells in a box. Perimeters include what lies on the boundary of the
  /// box. Points may be outside of the box; a cell that does not reach into it has the area and the
  /// perimeter 0. If there is any point, the areas add up to the area of the box, and the mean of
  /// the centroids, weighted by areas, is its center.
  ///
  /// Cost: for each point, proportional to the number of its neighbors times the number of its
  /// cell's corners. Both are six or less on average; only a point with very many neighbors costs
  /// much more. \tparam Dynamic a `Dynamic_Delaunay_triangulation_2`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \throws Parameter_error_2 unless the width and the height of the box are from 0 to 1e153;
  /// nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const Bbox_2& box)
  {
    using Dynamic_Delaunay_triangulations_2::internal::check_extent;
    constexpr double largest = 1e153; // its square is a double
    check_extent("the width of the box", box.xmax() - box.xmin(), largest);
    check_extent("the height of the box", box.ymax() - box.ymin(), largest);
    const Space<Dynamic> space(dt);
    start(space);
    cut_cells(space, {box.xmin(), box.ymin()}, {box.xmax(), box.ymax()});
    copy_to_ids(space, [&](Index, Index c) { return m_cells[c].moment; });
  }

  /// measures the parts of the cells in a box of the kernel, whose corners are rounded to doubles.
  template <class Dynamic>
  void compute(const Dynamic& dt, const typename Dynamic::Geom_traits::Iso_rectangle_2& box)
  {
    compute(dt, Bbox_2(CGAL::to_double(box.xmin()), CGAL::to_double(box.ymin()),
                       CGAL::to_double(box.xmax()), CGAL::to_double(box.ymax())));
  }

  /// @}
  /// \name Access
  /// @{

  /// the area of each id.
  const std::vector<double>& areas() const { return m_areas; }
  /// the perimeter of each id.
  const std::vector<double>& perimeters() const { return m_perimeters; }
  /// the centroid of each id.
  const std::vector<Position>& centroids() const { return m_centroids; }
  /// the shape index of each id: the perimeter of its cell over the square root of the area.
  const std::vector<double>& shape_indices() const { return m_shape_indices; }

  /// @}

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Cell
  {
    double area = 0, perimeter = 0;
    Position moment{0, 0}; // of a clipped cell the centroid, of a whole one three times the area
                           // times the vector there
    double points = 1;     // the number of points that share it

    // Later additions leave infinity infinite.
    static Cell unbounded() { return {infinity, infinity}; }

    void add(double its_area, double length, const Position& its_moment)
    {
      area += its_area;
      perimeter += length;
      moment.x += its_moment.x;
      moment.y += its_moment.y;
    }
    double shape_index() const
    {
      if (perimeter == 0)
        return 0;
      return area > 0 && area < infinity ? perimeter / std::sqrt(area) : infinity;
    }
    bool has_centroid() const { return area > 0 && area < infinity; }
  };

  template <class Its_space>
  void start(const Its_space& space)
  {
    for (std::vector<double>* measures : {&m_areas, &m_perimeters, &m_shape_indices})
      measures->clear();
    m_centroids.clear();
    for (std::vector<double>* measures : {&m_areas, &m_perimeters, &m_shape_indices})
      measures->reserve(space.number_of_ids());
    m_centroids.reserve(space.number_of_ids());
    m_cells.assign(space.number_of_cells(), Cell());
  }

  // Copies the measures from cells to ids; `centroid(id, c)` is that of cell c.
  template <class Its_space, class Centroid>
  void copy_to_ids(const Its_space& space, const Centroid& centroid)
  {
    space.for_each_duplicate([&](Index id) { ++m_cells[space.cell(id)].points; });
    for (std::vector<double>* measures : {&m_areas, &m_perimeters, &m_shape_indices})
      measures->resize(space.number_of_ids()); // throws nothing
    m_centroids.resize(space.number_of_ids());
    space.for_each_range(space.number_of_ids(), [&](std::size_t, Index first, Index beyond) {
      for (Index id = first; id < beyond; ++id) {
        const bool is_there = space.has_id(id);
        const Index c = is_there ? space.cell(id) : 0;
        const Cell cell = is_there ? m_cells[c] : Cell();
        m_areas[id] = cell.area / cell.points;
        m_perimeters[id] = cell.perimeter;
        m_shape_indices[id] = cell.shape_index();
        m_centroids[id] = is_there ? centroid(id, c) : Position{0, 0};
      }
    });
  }

  // WHOLE CELLS ---------------------------------------------------------------------------------

  template <class Add>
  static void add_face(const std::array<Vertex_index, 3>& cells, const Face& face, const Add& add)
  {
    if (face.is_flat()) {
      for (const Index c : cells)
        add(c, Cell::unbounded());
      return;
    }
    std::array<Cell, 3> parts; // of the corners
    for (std::size_t i = 0; i < 3; ++i) {
      const double cotangent = face.cotangent(i);
      const double area = face.squared_length(i) * cotangent / 8;
      const double length = face.length(i) * cotangent / 2;
      const Position d = face.side(i), n = face.normal(i);
      const double across = area * cotangent / 2;
      Cell &from = parts[(i + 1) % 3], &to = parts[(i + 2) % 3];
      from.add(area, length, {across * n.x + area * d.x, across * n.y + area * d.y});
      to.add(area, length, {across * n.x - area * d.x, across * n.y - area * d.y});
    }
    for (std::size_t i = 0; i < 3; ++i)
      add(cells[i], parts[i]);
  }

  // CLIPPED CELLS -------------------------------------------------------------------------------

  template <class Its_space>
  void cut_cells(const Its_space& space, const Position& low, const Position& high)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    m_parts.resize((std::max)(space.number_of_ranges(m_cells.size()), m_parts.size()));
    space.for_each_range(m_cells.size(), [&](std::size_t part, Index first, Index beyond) {
      Cut_cell_2& cell = m_parts[part];
      for (Index c = first; c < beyond; ++c) {
        if (!space.is_cell(c))
          continue;
        const size_type id = space.id_of_cell(c);
        cut_out_of_box(space, id, low, high, cell);
        const auto measures =
            measures_of_polygon(cell.polygon.corners(), cell.origin, space.position(id));
        m_cells[c] = {measures.area, measures.perimeter, measures.centroid};
      }
    });
  }

  std::vector<double> m_areas, m_perimeters, m_shape_indices;
  std::vector<Position> m_centroids;
  std::vector<Cell> m_cells;
  Dynamic_Delaunay_triangulations_2::internal::Cell_sums_2<Cell> m_sums;
  std::vector<Dynamic_Delaunay_triangulations_2::internal::Cut_cell_2> m_parts; // memory of each
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_MEASURES_2_H
