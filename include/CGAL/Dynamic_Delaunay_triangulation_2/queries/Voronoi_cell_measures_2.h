// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_MEASURES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_MEASURES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Exact_lines_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
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
  perimeter, the shape index is infinite.
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
neighbors, one after the other. The result is the cell, since the cell is where the point is as near
as any of its Delaunay neighbors. Nothing is divided by values that may vanish: flat faces and
points on a line are no special cases. Two neighbors cut along the same line, rounding included, so
no area between them is lost or counted twice. With \f$D\f$ the diameter of the box, corners of
cells have errors of about \f$10^{-16} D\f$, and areas of about \f$10^{-16} D^2\f$, however far away
the points are: if they are several diameters away, exact arithmetic places their bisectors. Areas
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
  using Face = Dynamic_Delaunay_triangulations_2::internal::Voronoi_face_2;
  template <class Dynamic>
  using Space = Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic>;
  template <class Dynamic>
  using Differences = Dynamic_Delaunay_triangulations_2::internal::Vertex_differences_2<Dynamic>;

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
        [](const std::array<Index, 3>& cells, const Face& face, const auto& add) {
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
    m_cell_centroids.resize(m_cells.size());
    clip_cells(dt, box);
    copy_to_ids(space, [&](Index, Index c) { return m_cell_centroids[c]; });
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
    Position moment{0, 0}; // of a whole cell: three times the area times the vector to the centroid
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
    space.for_each_range(space.number_of_ids(), [&](Index first, Index beyond) {
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
  static void add_face(const std::array<Index, 3>& cells, const Face& face, const Add& add)
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

  // The corners of what is left of the box, counterclockwise, and memory for the next cut.
  struct Polygon
  {
    std::vector<Position> corners{}, clipped{};

    // Cuts off the part where the scalar product with `direction` is larger than `bound`. The
    // neighbor's cell is clipped with the opposite signs of both, and the same rounding errors:
    // along the same line.
    void clip(const Position& direction, double bound)
    {
      using Dynamic_Delaunay_triangulations_2::internal::dot;
      if (corners.empty())
        return;
      const auto excess_of = [&](const Position& p) { return dot(direction, p) - bound; };
      clipped.clear();
      Position last = corners.back();
      double last_excess = excess_of(last);
      for (const Position& corner : corners) {
        const double excess = excess_of(corner);
        if ((last_excess > 0) != (excess > 0)) {
          const double t = last_excess / (last_excess - excess);
          clipped.push_back({last.x + t * (corner.x - last.x), last.y + t * (corner.y - last.y)});
        }
        if (!(excess > 0))
          clipped.push_back(corner);
        last = corner;
        last_excess = excess;
      }
      corners.swap(clipped);
    }
  };

  template <class Dynamic>
  void clip_cells(const Dynamic& dt, const Bbox_2& box)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const auto frame = dt.frame();
    const Differences<Dynamic> vector(dt);
    // relative to its center the box is the same for all points
    const Position least{box.xmin(), box.ymin()}, most{box.xmax(), box.ymax()};
    const auto [center, reach] = Surroundings_2(least, most);
    const Position low = least - center, high = most - center;
    const auto clip_from_afar = [&, center = center, reach = reach](Index v, Index w,
                                                                    Polygon& polygon) {
      const Position p = frame.position(v), q = frame.position(w);
      const Division_2 sides = division(p - center, q - center, vector(v, w), reach);
      if (sides == Division_2::ALL_BEYOND)
        polygon.corners.clear();
      if (sides != Division_2::UNKNOWN)
        return;
      const auto [direction, product] = exact_bisector(p, q, vector(v, w), center);
      polygon.clip(direction, product);
    };
    const auto clip_cell = [&, center = center, reach = reach](Index v, Polygon& polygon) {
      polygon.corners = {low, {high.x, low.y}, high, {low.x, high.y}};
      const Position p = frame.position(v) - center;
      frame.state().for_each_finite_neighbor(v, [&](Index w) {
        const Position q = frame.position(w) - center;
        const double distances = Surroundings_2::size(p) + Surroundings_2::size(q);
        if (distances > 8 * reach) // the same for both cells, so that they are cut alike
          return clip_from_afar(v, w, polygon);
        const Position middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
        const Position direction = vector(v, w);
        polygon.clip(direction, dot(direction, middle));
      });
      const std::optional<Position> centroid = measure(polygon.corners, m_cells[v]);
      m_cell_centroids[v] =
          centroid ? Position{center.x + centroid->x, center.y + centroid->y} : frame.position(v);
    };
    using Parts = typename Dynamic::Frame::Parts;
    const std::size_t vertices = frame.number_of_vertices();
    m_polygons.resize((std::max)(Parts::number(vertices), m_polygons.size()));
    Parts::for_each(vertices, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      for (std::size_t v = first; v < beyond; ++v)
        clip_cell(Index(v + 1), m_polygons[part]);
    });
  }

  // Adds up the triangles at one corner, which are as small as the cell, however far it is from the
  // origin. Returns the centroid, if it exists.
  static std::optional<Position> measure(const std::vector<Position>& corners, Cell& cell)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    double weight = 0;
    Position mean{0, 0}; // of the triangles' centroids, relative to that corner
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Position& p = corners[i];
      const Position& q = corners[i + 1 < corners.size() ? i + 1 : 0];
      const Position u = p - corners[0], v = q - corners[0];
      const double doubled_area = cross(u, v);
      cell.area += doubled_area / 2;
      cell.perimeter += distance(p, q);
      if (!(doubled_area > 0)) // rounding can invert triangles of thin cells
        continue;
      weight += doubled_area;
      const double share = doubled_area / weight;
      mean.x += share * ((u.x + v.x) / 3 - mean.x);
      mean.y += share * ((u.y + v.y) / 3 - mean.y);
    }
    cell.area = (std::max)(cell.area, 0.0); // rounding can make the sum negative
    if (weight == 0)
      return std::nullopt;
    return Position{corners[0].x + mean.x, corners[0].y + mean.y};
  }

  std::vector<double> m_areas, m_perimeters, m_shape_indices;
  std::vector<Position> m_centroids;
  std::vector<Cell> m_cells;
  Dynamic_Delaunay_triangulations_2::internal::Cell_sums_2<Cell> m_sums;
  std::vector<Position> m_cell_centroids; // of each cell, if cells are clipped
  std::vector<Polygon> m_polygons;        // of each part
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_MEASURES_2_H
