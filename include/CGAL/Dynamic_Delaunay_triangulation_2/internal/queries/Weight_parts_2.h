// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHT_PARTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHT_PARTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Exact_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Rounded_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Site_geometry_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Weights are parts of a whole. On an edge, the part of an end is the way from the query point to
// the other end. In a face, the part of a corner is the area of the triangle of the query point and
// the opposite side. The part of one of Sibson's natural neighbors is what its cell loses to a
// point inserted there: what it owns of the faces that go, less what it owns of the new ones. A
// corner owns h l^2 / 8 at each of its sides of a face; see Voronoi_face_2. So no circumcenter is
// needed, and far ones do no harm.

// Parts in doubles, with bounds on their errors. What a corner owns has the bounds of
// Rounded_face_2. Each sum adds u = 2^-53 times its value. A tenth more covers the higher orders.
template <class State>
class Rounded_weight_parts_2
{
  using Geometry = Site_geometry_2<State>;
  using Query_point = typename Geometry::Query_point;
  using Site = typename State::Site;

public:
  explicit Rounded_weight_parts_2(const Geometry& geometry)
    : m_geometry(geometry)
  {
  }

  void start(std::size_t size)
  {
    m_parts.assign(size, 0);
    m_errors.assign(size, 0);
  }

  // Sets the parts for q on the edge from a to b: the ways from q to b and from a to q.
  void add_edge(const Query_point& q, const Site& a, const Site& b)
  {
    double e = 0;
    const Position_2 way = m_geometry.vector(a, b, e), to = m_geometry.vector(q, b, e),
                     from = m_geometry.vector(a, q, e);
    m_parts = {dot(to, way), dot(from, way)};
    m_errors = {error_of_product(to, way, e), error_of_product(from, way, e)};
  }

  void add_triangle(const Query_point& q, const std::array<Site, 3>& corners)
  {
    double e = 0;
    const std::array<Position_2, 3> rays{m_geometry.vector(q, corners[0], e),
                                         m_geometry.vector(q, corners[1], e),
                                         m_geometry.vector(q, corners[2], e)};
    for (std::size_t i = 0; i < 3; ++i) {
      m_parts[i] = cross(rays[(i + 1) % 3], rays[(i + 2) % 3]);
      m_errors[i] = error_of_product(rays[(i + 1) % 3], rays[(i + 2) % 3], e);
    }
  }

  // Adds what the corners of a face own of it, times the sign, to the parts with these numbers.
  // Ignores numbers that no part has. The first corner may be the query point.
  template <class Corner>
  void add_face(const Corner& a, const Site& b, const Site& c,
                const std::array<std::size_t, 3>& numbers, int sign)
  {
    const Rounded_face_2 face(m_geometry, a, b, c);
    std::array<double, 3> owned, errors;
    for (std::size_t i = 0; i < 3; ++i) {
      owned[i] = sign * face.cotangent(i) * face.squared_length(i);
      errors[i] = 1.1 * face.error_of_owned(i);
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::size_t number = numbers[i]; number < m_parts.size()) {
        const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
        const double both = owned[j] + owned[l];
        m_parts[number] += both;
        m_errors[number] +=
            errors[j] + errors[l] + 1.1 * unit * (std::abs(both) + std::abs(m_parts[number]));
      }
  }

  // Turns the parts into weights with the sum 1. True only if none is off by more than this error.
  bool normalize(double largest_error)
  {
    const double sum = std::accumulate(m_parts.begin(), m_parts.end(), 0.0);
    const double error = std::accumulate(m_errors.begin(), m_errors.end(), 0.0) +
                         unit * double(m_parts.size() + 4) * sum;
    bool is_proved = sum > smallest;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
      m_parts[i] = (std::max)(m_parts[i] / sum, 0.0);
      is_proved = is_proved && 1.1 * (m_errors[i] + m_parts[i] * error) <= largest_error * sum;
    }
    return is_proved;
  }
  const std::vector<double>& weights() const { return m_parts; }

private:
  static constexpr double unit = 0x1p-53, smallest = 1e-280;

  const Geometry m_geometry;
  std::vector<double> m_parts, m_errors;
};

// Parts without rounding, by the functions of Rounded_weight_parts_2.
template <class State>
class Exact_weight_parts_2
{
  using Geometry = Site_geometry_2<State>;
  using Query_point = typename Geometry::Query_point;
  using Site = typename State::Site;
  using Number = typename Geometry::Exact;
  using Vector = Exact_vector_2<Number>;

public:
  Exact_weight_parts_2(const Geometry& geometry, std::size_t size)
    : m_geometry(geometry)
    , m_parts(size, Number(0))
  {
  }

  void add_edge(const Query_point& q, const Site& a, const Site& b)
  {
    const Vector way = m_geometry.exact_vector(a, b);
    m_parts[0] += dot(m_geometry.exact_vector(q, b), way);
    m_parts[1] += dot(m_geometry.exact_vector(a, q), way);
  }

  void add_triangle(const Query_point& q, const std::array<Site, 3>& corners)
  {
    for (std::size_t i = 0; i < 3; ++i)
      m_parts[i] += cross(m_geometry.exact_vector(q, corners[(i + 1) % 3]),
                          m_geometry.exact_vector(q, corners[(i + 2) % 3]));
  }

  template <class Corner>
  void add_face(const Corner& a, const Site& b, const Site& c,
                const std::array<std::size_t, 3>& numbers, int sign)
  {
    const std::array<Vector, 3> sides{m_geometry.exact_vector(b, c), m_geometry.exact_vector(c, a),
                                      m_geometry.exact_vector(a, b)};
    const Number doubled_area = cross(sides[0], sides[1]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Number owned =
          Number(-sign) * dot(sides[j], sides[k]) * dot(sides[i], sides[i]) / doubled_area;
      for (const std::size_t corner : {numbers[j], numbers[k]})
        if (corner < m_parts.size())
          m_parts[corner] += owned;
    }
  }

  // Adds rounded shares: none is negative, so the sum is relatively as exact as they are. Without
  // rounding, the sum could have very many digits.
  std::vector<double> weights() const
  {
    const Number largest = *std::max_element(m_parts.begin(), m_parts.end());
    std::vector<double> weights;
    for (const Number& part : m_parts)
      weights.push_back(CGAL::to_double(Number(part / largest)));
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights)
      weight /= sum;
    return weights;
  }

private:
  const Geometry m_geometry;
  std::vector<Number> m_parts;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHT_PARTS_2_H
