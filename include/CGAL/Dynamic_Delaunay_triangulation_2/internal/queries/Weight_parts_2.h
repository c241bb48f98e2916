// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHT_PARTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHT_PARTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Exact_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Rounded_face_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Weights are parts of a whole. Those of a place on an edge are the ways to its ends, and those of
// one in a face the areas of the triangles with its sides. Sibson's natural neighbors lose parts of
// their cells to a point that is inserted at the place: what they own of the faces that go, less
// what they own of the new ones. A corner owns h l^2 / 8 of each side of a face; see
// Voronoi_face_2. So no circumcenter is needed, and those far away do no harm.

// Parts in doubles, with bounds on their errors: of what a corner owns, those of Rounded_face_2.
// Each sum adds u = 2^-53 times what it is. A tenth more covers the higher orders.
template <class State>
class Rounded_weight_parts_2
{
  using Corner = typename State::Corner;

public:
  explicit Rounded_weight_parts_2(const State& state)
    : m_state(state)
  {
  }

  void start(std::size_t size)
  {
    m_parts.assign(size, 0);
    m_errors.assign(size, 0);
  }

  // How much of the way between the last two corners is before and behind the first one.
  void add_edge(const Corner& p, const Corner& a, const Corner& b)
  {
    double e = 0;
    const Position_2 way = m_state.vector(a, b, e), to = m_state.vector(p, b, e),
                     from = m_state.vector(a, p, e);
    m_parts = {dot(to, way), dot(from, way)};
    m_errors = {error_of_product(to, way, e), error_of_product(from, way, e)};
  }

  void add_triangle(const Corner& p, const std::array<Corner, 3>& corners)
  {
    double e = 0;
    const std::array<Position_2, 3> rays{m_state.vector(p, corners[0], e),
                                         m_state.vector(p, corners[1], e),
                                         m_state.vector(p, corners[2], e)};
    for (std::size_t i = 0; i < 3; ++i) {
      m_parts[i] = cross(rays[(i + 1) % 3], rays[(i + 2) % 3]);
      m_errors[i] = error_of_product(rays[(i + 1) % 3], rays[(i + 2) % 3], e);
    }
  }

  // Adds what the corners of a face own of it, times the sign, to the parts with these numbers, if
  // there are such.
  void add_face(const std::array<Corner, 3>& corners, const std::array<std::size_t, 3>& numbers,
                int sign)
  {
    const Rounded_face_2 face(m_state, corners);
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

  // Makes the parts weights, whose sum is 1, if none of them is farther from the truth than this.
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

  const State& m_state;
  std::vector<double> m_parts, m_errors;
};

// The same without rounding.
template <class State>
class Exact_weight_parts_2
{
  using Corner = typename State::Corner;
  using Number = typename State::Exact;
  using Vector = Exact_vector_2<Number>;

public:
  Exact_weight_parts_2(const State& state, std::size_t size)
    : m_state(state)
    , m_parts(size, Number(0))
  {
  }

  void add_edge(const Corner& p, const Corner& a, const Corner& b)
  {
    const Vector way = m_state.exact_vector(a, b);
    m_parts[0] += dot(m_state.exact_vector(p, b), way);
    m_parts[1] += dot(m_state.exact_vector(a, p), way);
  }

  void add_triangle(const Corner& p, const std::array<Corner, 3>& corners)
  {
    for (std::size_t i = 0; i < 3; ++i)
      m_parts[i] += cross(m_state.exact_vector(p, corners[(i + 1) % 3]),
                          m_state.exact_vector(p, corners[(i + 2) % 3]));
  }

  void add_face(const std::array<Corner, 3>& corners, const std::array<std::size_t, 3>& numbers,
                int sign)
  {
    const std::array<Vector, 3> sides{m_state.exact_vector(corners[1], corners[2]),
                                      m_state.exact_vector(corners[2], corners[0]),
                                      m_state.exact_vector(corners[0], corners[1])};
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

  // The sum of rounded shares, which are positive or 0, is off by as little as they are; without
  // rounding it could have very many digits.
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
  static Number dot(const Vector& v, const Vector& w) { return v.x * w.x + v.y * w.y; }
  static Number cross(const Vector& v, const Vector& w) { return v.x * w.y - v.y * w.x; }

  const State& m_state;
  std::vector<Number> m_parts;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_WEIGHT_PARTS_2_H
