// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VORONOI_CELL_MEASURES_2_H
#define CGAL_VORONOI_CELL_MEASURES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
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

The areas and perimeters of the points' Voronoi cells: whole, or clipped to a box. What a point has
for itself, and so one over its local density. Of clipped cells the centroids, too, to which Lloyd's
relaxation moves the points, again and again, until their cells are about alike.

Areas are in the unit of the coordinates, squared, perimeters and centroids in the unit of the
coordinates. Each is there for every id.

- Points that coincide share a cell. Each gets an equal share of its area, so that all areas still
  add up, the whole perimeter, and the centroid of the whole.
- A clipped cell without area has no centroid. The point itself stands in its place: a relaxation
  leaves it where it is.
- Ids that were removed have 0 for all of them.

A `Dynamic_population_2` has its cells at `population.id(user_id)`.

<b>Whole cells.</b> An edge with the angles \f$\alpha\f$ and \f$\beta\f$ opposite to it is dual to a
Voronoi edge of length \f$l (\cot \alpha + \cot \beta) / 2\f$, where \f$l\f$ is its own length,
and the triangles over that Voronoi edge from both of its ends have areas of
\f$l^2 (\cot \alpha + \cot \beta) / 8\f$ (Meyer, Desbrun, Schröder, Barr: *Discrete
differential-geometry operators for triangulated 2-manifolds*, 2003). The cell of a point consists
of those of its edges.
Every face adds its three cotangents, which have one denominator, to its three vertices. No
circumcenter is computed. Still, a nearly flat face reaches far: where the circumradius is
\f$R\f$ and the shortest edge \f$h\f$, areas of about \f$R^2\f$ cancel, and what is left has
errors of about \f$10^{-16} R^2\f$; lengths, of \f$10^{-16} R^2 / h\f$. Such faces occur at the hull
and beside large empty regions. If a face is so flat that its orientation drowns in rounding, which
takes \f$R\f$ to be \f$10^{15} h\f$ or so, its vertices' cells count as unbounded.

<b>Clipped cells.</b> The box is cut by the bisector of the point and each of its Delaunay
neighbors, one after the other. That is the cell, since the cell is where the point is as near as
any of its Delaunay neighbors. Nothing is divided by what may vanish: flat faces and points on a
line need no case of their own. Two neighbors cut along one and the same line, rounding included, so
no area gets lost, or is counted twice, between them. With \f$D\f$ the diameter of the box and all
points whose cells reach into it, corners of cells have errors of about \f$10^{-16} D\f$. The
centroid is a mean of places between these corners, with weights that are never negative: it stays
between them, however thin the cell is. Where a cell is about as wide as it is long, the centroid is
as right as its corners.

Coordinates may be of any size as long as their squares are doubles.

An object keeps its memory: `compute()` allocates nothing if the triangulation had as many ids and
vertices before, and, for clipped cells, no cell had more corners than any before.

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

  /// measures the whole cells. Both measures of an unbounded cell are infinite: those of all points
  /// on the hull, and of all points if these do not span the plane. There are no centroids.
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

  /// measures the cells' parts in a box. Perimeters include what lies on the boundary of the box.
  /// Points may be outside of the box; a cell that does not reach into it has the area and the
  /// perimeter 0. If there is a point, the areas add up to that of the box, and the centroids,
  /// weighted by areas, to its center.
  ///
  /// Cost: for each point that of the number of its neighbors times the number of its cell's
  /// corners. Both are six or less on average; only a point with very many neighbors costs more
  /// than its share. \tparam Dynamic a `Dynamic_Delaunay_triangulation_2`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \throws Parameter_error_2 if the width or height of the box is negative, or no finite number;
  /// nothing changes.
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

  /// the same with a box of the kernel; its corners are rounded to doubles.
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
  /// the centroid of each id, if the cells were clipped; nothing, if they were whole.
  const std::vector<Position>& centroids() const { return m_centroids; }

  /// @}

private:
  // Of a vertex.
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

  // From vertices to ids.
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

  // What is added to infinity later leaves it infinite.
  void unbound(const std::array<Index, 3>& face)
  {
    for (const Index v : face)
      m_cells[v] = Cell::unbounded();
  }

  template <class Vectors>
  void add_face(const std::array<Index, 3>& face, const Vectors& vector)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    // each opposite to the corner with its number, and all of them around the face
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

  // Of the two shorter sides, which are the ones to tell how flat a face is; 0 if rounding may have
  // changed its sign: its error is less than 4 * 2^-53 times the sum of both products.
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
    // from its center the box looks the same to all points
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

  // Cuts off where the scalar product with `direction` is larger than `bound`. For the neighbor
  // both numbers have the opposite sign, whatever their rounding errors: it is the same line.
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

  // By triangles from one corner on, which are as small as the cell is, wherever it may be. Returns
  // the centroid, if there is one.
  std::optional<Position> measure(Cell& cell) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    double weight = 0;
    Position mean{0, 0}; // of the triangles' centroids, from that corner
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const Position& p = m_corners[i];
      const Position& q = m_corners[i + 1 < m_corners.size() ? i + 1 : 0];
      const Position u = p - m_corners[0], v = q - m_corners[0];
      const double doubled_area = cross(u, v);
      cell.area += doubled_area / 2;
      cell.perimeter += distance(p, q);
      if (!(doubled_area > 0)) // rounding turns triangles of thin cells around
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
