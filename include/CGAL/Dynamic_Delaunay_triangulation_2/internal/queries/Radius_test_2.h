// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_RADIUS_TEST_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_RADIUS_TEST_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Exact_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Rounded_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/State_with_place_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Tests exactly whether the smallest circles through faces and edges have at most a given radius.
template <class Dynamic>
class Radius_test_2
{
  using Arrays = Halfedge_arrays_2;
  using State = State_with_place_2<Dynamic>;
  using Corner = typename State::Corner;
  using Exact = typename State::Exact;
  using Vector = Exact_vector_2<Exact>;

public:
  // `square` is that of the radius. Throws unless the triangulation is certified, and if the square
  // is negative or not finite.
  template <class FT>
  Radius_test_2(const Dynamic& dt, const FT& square)
    : m_state(dt)
    , m_square(CGAL::to_double(square))
    , m_exact_square(Exact_number_2<FT>::of(checked(square)))
    , m_is_rounded(m_exact_square != Exact(m_square))
  {
  }

  // Whether the face is not outside, and its circle is small enough.
  bool has_face(Face_index f) const
  {
    if (m_state.is_outside(f))
      return false;
    const std::array<Corner, 3> corners = corners_at(Arrays::halfedge_in(f, 0));
    const Rounded_face_2 face(m_state, corners);
    const double excess = face.squared_radius() - m_square;
    if (!m_is_rounded && std::abs(excess) > 1.1 * face.error_of_squared_radius())
      return excess < 0;
    return has_face_exactly(corners);
  }

  // Whether the edge is not outside, and the circle on it as a diameter is small enough and without
  // a point inside.
  bool has_edge(Halfedge_index h) const
  {
    return !m_state.is_outside_at(h) && is_short(h) && !is_attached(h) &&
           !is_attached(m_state.arrays().twin(h));
  }

private:
  template <class FT>
  static const FT& checked(const FT& square)
  {
    constexpr double largest = (std::numeric_limits<double>::max)();
    const double value = CGAL::to_double(square);
    if (!(value >= 0 && value <= largest))
      throw Parameter_error_2("the squared radius", value, 0, largest);
    return square;
  }

  // The corners of the half-edge's face: the apex of the half-edge, its source and its target.
  std::array<Corner, 3> corners_at(Halfedge_index h) const
  {
    const auto frame = m_state.frame_at(h);
    return {m_state.corner_in(h, frame), m_state.corner_in(Arrays::next(h), frame),
            m_state.corner_in(Arrays::previous(h), frame)};
  }

  // Whether a^2 b^2 c^2 <= 4 D^2 square, for the sides and the doubled area D of the face.
  BOOST_NOINLINE bool has_face_exactly(const std::array<Corner, 3>& corners) const
  {
    const Vector a = m_state.exact_vector(corners[0], corners[1]);
    const Vector b = m_state.exact_vector(corners[1], corners[2]);
    const Vector c = m_state.exact_vector(corners[2], corners[0]);
    const Exact doubled_area = a.x * b.y - a.y * b.x;
    return Exact(exact_dot(a, a) * exact_dot(b, b) * exact_dot(c, c)) <=
           Exact(Exact(4) * doubled_area * doubled_area * m_exact_square);
  }

  bool is_short(Halfedge_index h) const
  {
    const auto [apex, source, target] = corners_at(h);
    double e = 0;
    const Position_2 v = m_state.vector(source, target, e);
    const double excess = dot(v, v) - 4 * m_square;
    if (!m_is_rounded && std::abs(excess) > error_of_product(v, v, e) + underflow)
      return excess < 0;
    const Vector exact = m_state.exact_vector(source, target);
    return exact_dot(exact, exact) <= Exact(Exact(4) * m_exact_square);
  }

  // Whether the apex is inside of the circle on the half-edge as a diameter: then the angle at the
  // apex is obtuse. False if the face is outside.
  bool is_attached(Halfedge_index h) const
  {
    if (m_state.is_outside(Arrays::face_of(h)))
      return false;
    const auto [apex, source, target] = corners_at(h);
    double e = 0;
    const Position_2 v = m_state.vector(apex, source, e), w = m_state.vector(apex, target, e);
    const double product = dot(v, w);
    if (std::abs(product) > error_of_product(v, w, e) + underflow)
      return product < 0;
    return exact_dot(m_state.exact_vector(apex, source), m_state.exact_vector(apex, target)) <
           Exact(0);
  }

  static Exact exact_dot(const Vector& v, const Vector& w) { return v.x * w.x + v.y * w.y; }

  static constexpr double underflow = 1e-300; // takes less than this from a sum of products

  const State m_state;
  const double m_square;
  const Exact m_exact_square;
  const bool m_is_rounded;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_RADIUS_TEST_2_H
