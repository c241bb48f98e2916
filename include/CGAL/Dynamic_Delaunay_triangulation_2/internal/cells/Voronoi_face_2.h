// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_FACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_FACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A Delaunay face, given by its sides and cotangents. All measures of Voronoi cells are sums over
// faces of expressions in these.
//
// Take the edge from corner i to corner j with the length l, the vector d, and the angle at the
// opposite corner whose cotangent is h. The circumcenter of the face is at i + d/2 + (h/2) n, where
// n is d, turned left: it points into the face. So the face owns h l / 2 of the edge's Voronoi
// edge, and a triangle with the area h l^2 / 8 on each side of it. Both are negative where the
// circumcenter is beyond the edge; the face there owns as much more.
class Voronoi_face_2
{
public:
  // Side i is opposite to corner i, and goes from corner i + 1 to corner i + 2, counterclockwise
  // around the face. The coordinates of sides are off by at most `error`, besides the rounding of
  // one subtraction.
  explicit Voronoi_face_2(const std::array<Position_2, 3>& sides, double error = 0)
    : m_sides(sides)
    , m_squares{dot(sides[0], sides[0]), dot(sides[1], sides[1]), dot(sides[2], sides[2])}
    , m_doubled_area(cross_of_shorter(error))
  {
  }

  // Whether rounding hides the face's orientation. Then all other results are meaningless.
  bool is_flat() const { return m_doubled_area == 0; }

  double doubled_area() const { return m_doubled_area; }
  const Position_2& side(std::size_t i) const { return m_sides[i]; }
  double squared_length(std::size_t i) const { return m_squares[i]; }
  double length(std::size_t i) const { return std::sqrt(m_squares[i]); }
  // Side i, turned left: it points into the face.
  Position_2 normal(std::size_t i) const { return {-m_sides[i].y, m_sides[i].x}; }

  // The cotangent of the angle at corner i, which is opposite to side i.
  double cotangent(std::size_t i) const
  {
    return -dot(m_sides[(i + 1) % 3], m_sides[(i + 2) % 3]) / m_doubled_area;
  }

  // The vector from corner i to the circumcenter.
  Position_2 to_circumcenter(std::size_t i) const
  {
    return to_circumcenter(i, cotangent((i + 2) % 3));
  }
  // Here h is the cotangent of the angle at corner i + 2.
  Position_2 to_circumcenter(std::size_t i, double h) const
  {
    const std::size_t k = (i + 2) % 3; // this side begins at corner i
    const Position_2 n = normal(k);
    return {(m_sides[k].x + h * n.x) / 2, (m_sides[k].y + h * n.y) / 2};
  }

private:
  // The cross product of the two shorter sides, which show best how flat a face is. Returns 0 if
  // rounding may have changed its sign: besides what `error` adds, its error is less than
  // 4 * 2^-53 times the sum of both products.
  double cross_of_shorter(double error) const
  {
    const auto longest =
        std::size_t(std::max_element(m_squares.begin(), m_squares.end()) - m_squares.begin());
    const Position_2& p = m_sides[(longest + 1) % 3];
    const Position_2& q = m_sides[(longest + 2) % 3];
    const double plus = p.x * q.y, minus = p.y * q.x;
    double bound = 0x1p-51 * (std::abs(plus) + std::abs(minus));
    if (error > 0)
      bound += 2 * error * (std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y));
    return plus - minus > bound ? plus - minus : 0;
  }

  std::array<Position_2, 3> m_sides;
  std::array<double, 3> m_squares;
  double m_doubled_area;
};

// Sums over faces for each Voronoi cell. Threads share the parts of the faces. A part adds to its
// own cells at once. Its summands for cells of other parts, which are few where faces and vertices
// are numbered along one curve, are added when all parts are done, part by part. So the sums depend
// on the parts alone, to the last bit. An object keeps its memory.
template <class Summand>
class Cell_sums_2
{
public:
  // Calls f(cells, face, add) for each face, where add(c, summand) leads to one call of
  // apply(c, summand). Neither f nor apply may use what other calls of apply() change.
  template <class Space, class Function, class Apply>
  void run(const Space& space, const Function& f, const Apply& apply)
  {
    const std::size_t parts = space.number_of_face_parts();
    m_left_over.resize((std::max)(parts, m_left_over.size()));
    for (Summands& summands : m_left_over)
      summands.clear();
    space.for_each_face([&](std::size_t part, const std::array<Vertex_index, 3>& cells,
                            const Voronoi_face_2& face) {
      f(cells, face, [&](Index c, const Summand& summand) {
        if (space.has_cell(part, c))
          apply(c, summand);
        else
          leave_over(part, c, summand);
      });
    });
    for (const Summands& summands : m_left_over)
      for (const auto& [c, summand] : summands)
        apply(c, summand);
  }

private:
  using Summands = std::vector<std::pair<Index, Summand>>;

  // A separate function, so that compilers inline the rest.
  BOOST_NOINLINE void leave_over(std::size_t part, Index c, const Summand& summand)
  {
    m_left_over[part].emplace_back(c, summand);
  }

  std::vector<Summands> m_left_over; // of each part
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_FACE_2_H
