// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VORONOI_CELL_MEASURES_2_H
#define CGAL_VORONOI_CELL_MEASURES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The areas and perimeters of the points' Voronoi cells: whole, or clipped to a box. The area of a
cell is the space that its point has for itself; its inverse is the local density. Clipped cells
also have centroids. Lloyd's relaxation moves the points to these, again and again, until all cells
are about alike.

Areas are in the squared unit of the coordinates, perimeters and centroids in that unit. Each of
them has an entry for every id.

- Points that coincide share a cell. Each gets an equal share of its area, so that the areas still
  add up, the whole perimeter, and the centroid of the whole cell.
- A clipped cell without area has no centroid. The point's own position takes its place: a
  relaxation leaves the point where it is.
- Removed ids have 0 for all of them.

For a `Dynamic_population_2`, the index of a cell is `population.id(user_id)`.

<b>Whole cells.</b> An edge with the angles \f$\alpha\f$ and \f$\beta\f$ opposite to it is dual to a
Voronoi edge of length \f$l (\cot \alpha + \cot \beta) / 2\f$, where \f$l\f$ is its own length, and
the triangles over that Voronoi edge from both of its ends have areas of
\f$l^2 (\cot \alpha + \cot \beta) / 8\f$ (Meyer, Desbrun, Schröder, Barr: *Discrete
differential-geometry operators for triangulated 2-manifolds*, 2003). The cell of a point consists
of those of its edges. Every face adds its three cotangents, which have one denominator, to its
three vertices. No circumcenter is computed. Still, nearly flat faces cause large errors. With the
circumradius \f$R\f$ and the shortest edge \f$h\f$ of a face, areas of about \f$R^2\f$ cancel, and
the result has an error of about \f$10^{-16} R^2\f$; lengths have an error of about
\f$10^{-16} R^2 / h\f$. Such faces occur at the hull and beside large empty regions. If a face is so
flat that rounding hides its orientation, which takes \f$R\f$ to be \f$10^{15} h\f$ or so, the cells
of its vertices count as unbounded.

<b>Clipped cells.</b> The box is cut by the bisector of the point and each of its Delaunay
neighbors, one after the other. The result is the cell, since the cell is where the point is as near
as any of its Delaunay neighbors. Nothing is divided by values that may vanish: flat faces and
points on a line are no special cases. Two neighbors cut along the same line, rounding included, so
no area between them is lost or counted twice. With \f$D\f$ the diameter of the box and all points
whose cells reach into it, corners of cells have errors of about \f$10^{-16} D\f$. The centroid is a
mean of places between these corners, with weights that are never negative. So it stays between
them, however thin the cell is. Where a cell is about as wide as it is long, the centroid is as
accurate as its corners.

Coordinates may be of any size whose square is still a double.

An object keeps its memory: `compute()` allocates nothing if the triangulation had as many ids and
vertices before, and, for clipped cells, if no cell has more corners than any cell before.

\cgalExample{Dynamic_Delaunay_triangulation_2/crowd_densities.cpp}
\cgalExample{Dynamic_Delaunay_triangulation_2/lloyd_relaxation.cpp}
*/
class Voronoi_cell_measures_2
{
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  template <class Dynamic>
  using Differences = Dynamic_Delaunay_triangulations_2::internal::Vertex_differences_2<Dynamic>;
  template <class Dynamic>
  using Neighbors = Dynamic_Delaunay_triangulations_2::internal::Finite_neighbors_2<Dynamic>;

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

  /// measures the whole cells. Area and perimeter of an unbounded cell are infinite. The cells of
  /// all points on the hull are unbounded; so are all cells if the points do not span the plane.
  /// There are no centroids.
  ///
  /// Cost: linear, one pass over the faces. \tparam Dynamic a `Dynamic_Delaunay_triangulation_2`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    start(dt);
    if (dt.triangulation().dimension() == 2)
      add_faces(dt.frame(), Differences<Dynamic>(dt));
    else
      m_cells.assign(m_cells.size(), Cell::unbounded());
    settle(dt.frame());
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
  /// \throws Parameter_error_2 if the width or height of the box is negative or not a finite
  /// number; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const Bbox_2& box)
  {
    check_extent("the width of the box", box.xmax() - box.xmin());
    check_extent("the height of the box", box.ymax() - box.ymin());
    start(dt);
    m_centroids.reserve(dt.number_of_ids());
    m_cell_centroids.resize(m_cells.size());
    clip_cells(dt, box);
    settle(dt.frame());
    settle_centroids(dt.frame());
  }

  /// the same, but takes a box of the kernel, whose corners are rounded to doubles.
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
  /// the centroid of each id, if the cells were clipped; empty, if they were whole.
  const std::vector<Position>& centroids() const { return m_centroids; }

  /// @}

private:
  // The measures of a vertex's cell.
  struct Cell
  {
    double area = 0, perimeter = 0;
    double points = 1; // that share it

    static Cell unbounded()
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      return {infinity, infinity};
    }
  };

  template <class Dynamic>
  void start(const Dynamic& dt)
  {
    dt.triangulation(); // throws unless it is certified
    m_areas.clear();
    m_perimeters.clear();
    m_centroids.clear();
    m_areas.reserve(dt.number_of_ids());
    m_perimeters.reserve(dt.number_of_ids());
    m_cells.assign(dt.number_of_vertices() + 1, Cell());
  }

  // Copies the measures from vertices to ids.
  template <class Frame>
  void settle(const Frame& frame)
  {
    frame.for_each_duplicate([&](Index id) { ++m_cells[frame.vertex(id)].points; });
    for (Index id = 0; id < frame.number_of_ids(); ++id) {
      const Cell cell = frame.has_id(id) ? m_cells[frame.vertex(id)] : Cell();
      m_areas.push_back(cell.area / cell.points);
      m_perimeters.push_back(cell.perimeter);
    }
  }

  template <class Frame>
  void settle_centroids(const Frame& frame)
  {
    for (Index id = 0; id < frame.number_of_ids(); ++id)
      m_centroids.push_back(frame.has_id(id) ? m_cell_centroids[frame.vertex(id)] : Position{0, 0});
  }

  // WHOLE CELLS ---------------------------------------------------------------------------------

  template <class Frame, class Vectors>
  void add_faces(const Frame& frame, const Vectors& vector)
  {
    for (Index f = 0; f < frame.number_of_faces(); ++f) {
      const std::array<Index, 3> face = frame.face(f);
      if (std::none_of(face.begin(), face.end(), [](Index v) { return Frame::is_infinite(v); }))
        add_face(face, vector);
      else
        unbound(face);
    }
  }

  // Later additions leave infinity infinite.
  void unbound(const std::array<Index, 3>& face)
  {
    for (const Index v : face)
      m_cells[v] = Cell::unbounded();
  }

  template <class Vectors>
  void add_face(const std::array<Index, 3>& face, const Vectors& vector)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    // each is opposite to the corner with its number, and they run around the face
    const std::array<Position, 3> sides = {vector(face[1], face[2]), vector(face[2], face[0]),
                                           vector(face[0], face[1])};
    const std::array<double, 3> squares = {dot(sides[0], sides[0]), dot(sides[1], sides[1]),
                                           dot(sides[2], sides[2])};
    const double doubled_area = cross_of_shorter(sides, squares);
    if (!(doubled_area > 0))
      return unbound(face);
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
      const double cotangent = -dot(sides[j], sides[k]) / doubled_area;
      const double area = squares[i] * cotangent / 8;
      const double length = std::sqrt(squares[i]) * cotangent / 2;
      for (const Index v : {face[j], face[k]}) {
        m_cells[v].area += area;
        m_cells[v].perimeter += length;
      }
    }
  }

  // The cross product of the two shorter sides, which best tell how flat a face is. It is 0 if
  // rounding may have changed its sign: its error is less than 4 * 2^-53 times the sum of both
  // products.
  static double cross_of_shorter(const std::array<Position, 3>& sides,
                                 const std::array<double, 3>& squares)
  {
    const auto longest = std::size_t(std::max_element(squares.begin(), squares.end()) - //
                                     squares.begin());
    const Position& p = sides[(longest + 1) % 3];
    const Position& q = sides[(longest + 2) % 3];
    const double plus = p.x * q.y, minus = p.y * q.x;
    return plus - minus > 0x1p-51 * (std::abs(plus) + std::abs(minus)) ? plus - minus : 0;
  }

  // CLIPPED CELLS -------------------------------------------------------------------------------

  static void check_extent(const char* name, double extent)
  {
    constexpr double largest = (std::numeric_limits<double>::max)();
    if (!(extent >= 0 && extent <= largest))
      throw Parameter_error_2(name, extent, 0, largest);
  }

  template <class Dynamic>
  void clip_cells(const Dynamic& dt, const Bbox_2& box)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const auto frame = dt.frame();
    const Differences<Dynamic> vector(dt);
    const Neighbors<Dynamic> around(dt);
    // relative to its center the box is the same for all points
    const Position center{box.xmin() + (box.xmax() - box.xmin()) / 2,
                          box.ymin() + (box.ymax() - box.ymin()) / 2};
    const Position low = Position{box.xmin(), box.ymin()} - center;
    const Position high = Position{box.xmax(), box.ymax()} - center;
    for (Index v = 1; v <= frame.number_of_vertices(); ++v) {
      m_corners = {low, {high.x, low.y}, high, {low.x, high.y}};
      const Position p = frame.position(v) - center;
      around.for_each(v, [&](Index w) {
        const Position q = frame.position(w) - center;
        const Position middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
        const Position direction = vector(v, w);
        clip(direction, dot(direction, middle));
      });
      const std::optional<Position> centroid = measure(m_cells[v]);
      m_cell_centroids[v] =
          centroid ? Position{center.x + centroid->x, center.y + centroid->y} : frame.position(v);
    }
  }

  // Cuts off the part where the scalar product with `direction` is larger than `bound`. For the
  // neighbor both numbers have the opposite sign, whatever their rounding errors: it is the same
  // line.
  void clip(const Position& direction, double bound)
  {
    using Dynamic_Delaunay_triangulations_2::internal::dot;
    if (m_corners.empty())
      return;
    const auto excess_of = [&](const Position& p) { return dot(direction, p) - bound; };
    m_clipped.clear();
    Position last = m_corners.back();
    double last_excess = excess_of(last);
    for (const Position& corner : m_corners) {
      const double excess = excess_of(corner);
      if ((last_excess > 0) != (excess > 0)) {
        const double t = last_excess / (last_excess - excess);
        m_clipped.push_back({last.x + t * (corner.x - last.x), last.y + t * (corner.y - last.y)});
      }
      if (!(excess > 0))
        m_clipped.push_back(corner);
      last = corner;
      last_excess = excess;
    }
    m_corners.swap(m_clipped);
  }

  // Adds up triangles at one corner, which are as small as the cell is, wherever it may be. Returns
  // the centroid, if it exists.
  std::optional<Position> measure(Cell& cell) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    double weight = 0;
    Position mean{0, 0}; // of the triangles' centroids, relative to that corner
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const Position& p = m_corners[i];
      const Position& q = m_corners[i + 1 < m_corners.size() ? i + 1 : 0];
      const Position u = p - m_corners[0], v = q - m_corners[0];
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
    if (weight == 0)
      return std::nullopt;
    return Position{m_corners[0].x + mean.x, m_corners[0].y + mean.y};
  }

  std::vector<double> m_areas, m_perimeters;
  std::vector<Position> m_centroids;
  std::vector<Cell> m_cells;                  // of each vertex
  std::vector<Position> m_cell_centroids;     // of each vertex, if cells are clipped
  std::vector<Position> m_corners, m_clipped; // of one cell, around it
};

} // namespace CGAL

#endif // CGAL_VORONOI_CELL_MEASURES_2_H
