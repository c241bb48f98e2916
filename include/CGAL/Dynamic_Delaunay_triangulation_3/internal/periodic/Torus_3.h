// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/walls/Rounded_normal_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

using Exact_number_3 = CGAL::internal::Exact_ring_selector<double>::Type;

// A vector without rounding.
struct Exact_vector_3
{
  Exact_number_3 x, y, z;

  friend Exact_vector_3 cross(const Exact_vector_3& p, const Exact_vector_3& q)
  {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  }
  friend Exact_number_3 dot(const Exact_vector_3& p, const Exact_vector_3& q)
  {
    return p.x * q.x + p.y * q.y + p.z * q.z;
  }
};

// A point of the lattice's space, exact: `base` plus multiples of the basis. Rounded, too.
struct Torus_point_3
{
  Torus_point_3() = default;
  Torus_point_3(double x, double y, double z)
    : base{x, y, z}
    , rounded{x, y, z}
  {
  }
  Torus_point_3(const Position_3& b, const Multiples_3& m, const Position_3& r)
    : base(b)
    , multiples(m)
    , rounded(r)
  {
  }

  Position_3 base{0, 0, 0};
  Multiples_3 multiples{0, 0, 0};
  Position_3 rounded{0, 0, 0};
};

// The flat torus of three dimensions: space, in which the lattice of a cell identifies points. Or a
// slab, whose lattice has two vectors. In the place of the third one it has the normal of these;
// all multiples and fractions of it are 0, but for multiples that stand for points at infinity,
// above the slab or below it. Or a wire, whose lattice has one vector, and unit vectors across it
// in the place of the others; there multiples of the third one stand for the point at infinity.
//
// All multiples and shifts inside of the package refer to a basis of that lattice, which is short
// when it is chosen. Its vectors are integer combinations of the cell's, and in general no doubles.
class Torus_3
{
public:
  using Basis = std::array<std::array<double, 3>, 3>; // of integers

  // By which a point may be away from the origin, in vectors of the cell or of the basis; no
  // vector of a short basis has larger multiples of the cell's vectors.
  static constexpr double max_multiple = 0x1p20;

  // With a short basis. Throws Periodic_cell_error_3 if doubles cannot tell how far points are
  // apart in the cell.
  explicit Torus_3(const Periodic_cell_3& cell)
    : Torus_3(cell, unit_basis())
  {
    shorten_basis();
    set_vectors();
    set_near();
    if (!is_measurable())
      refuse(m_cell, "doubles cannot tell how far points are apart in it");
  }

  // With these combinations of the cell's vectors as basis. Nothing if they are none, or so long or
  // flat that doubles do not serve.
  static std::optional<Torus_3> with_basis(const Periodic_cell_3& cell, const Basis& basis)
  {
    const Torus_3 torus(cell, basis);
    if (std::abs(determinant(basis)) != 1 || !torus.is_measurable())
      return std::nullopt;
    return torus;
  }

  // The same lattice, with a short basis.
  Torus_3 with_short_basis() const { return Torus_3(m_cell); }

  // The torus of a new cell, whose basis is that of the present one as the cell moves: the same
  // vectors, if the cell has other vectors of about the same lattice, as after a sheared cell is
  // flipped; else the same combinations of the cell's vectors. Nothing if the basis would be
  // mirrored, or so long or flat that doubles do not serve.
  std::optional<Torus_3> moved_to(const Periodic_cell_3& cell) const
  {
    const Torus_3 target(cell, unit_basis());
    Torus_3 same_vectors(cell, target.nearest_multiples(m_vectors));
    if (std::abs(determinant(same_vectors.m_basis)) == 1 && has_same_hand(same_vectors) &&
        is_near(same_vectors))
      return same_vectors;
    Torus_3 same_combinations(cell, m_basis);
    if (same_combinations.is_measurable() && has_same_hand(same_combinations))
      return same_combinations;
    return std::nullopt;
  }

  // Throws if a point is not finite, or too far away.
  void check(const Position_3& p, std::size_t id) const
  {
    if (!is_finite(p))
      throw Non_finite_coordinate_error_3(id, p.x, p.y, p.z);
    if (!is_in_range(p))
      throw Periodic_range_error_3(id, p.x, p.y, p.z, max_multiple);
  }

  const Periodic_cell_3& cell() const { return m_cell; }
  const Basis& basis() const { return m_basis; } // of each vector, multiples of the cell's
  bool is_slab() const { return m_cell.is_slab(); }
  bool is_wire() const { return m_cell.is_wire(); }
  int dimension() const { return m_cell.dimension(); }
  const Position_3& vector(int i) const { return m_vectors[std::size_t(i)]; }
  const Exact_vector_3& exact_vector(int i) const { return m_exact_vectors[std::size_t(i)]; }
  // Of a slab, in the direction of the exact third vector.
  const Rounded_normal_3& normal() const { return m_normal; }
  // That of the cell; of a slab the area of its basis' parallelogram, of a wire its length.
  double volume() const { return std::abs(m_determinant); }
  // The distance between opposite faces of the basis' parallelepiped, or sides of a parallelogram.
  double height(int i) const { return 1 / std::sqrt(squared_length(m_inverse[std::size_t(i)])); }

  // A combination of the basis, rounded.
  Position_3 combination(const Multiples_3& m) const
  {
    return double(m[0]) * m_vectors[0] + double(m[1]) * m_vectors[1] + double(m[2]) * m_vectors[2];
  }
  Position_3 combination(const Position_3& fractions) const
  {
    return fractions.x * m_vectors[0] + fractions.y * m_vectors[1] + fractions.z * m_vectors[2];
  }

  // Combinations of the basis, rounded in the same way.
  const Small_translations_3& small_translations() const { return m_small_translations; }

  // A vector in multiples of the basis, rounded.
  Position_3 fractions(const Position_3& v) const
  {
    return {product(m_inverse[0], v), product(m_inverse[1], v), product(m_inverse[2], v)};
  }
  // How far a vector goes along the normal of a slab, rounded.
  double elevation(const Position_3& v) const { return product(m_vectors[2], v); }
  // Where a position of the other torus is when its basis moves to this one's, rounded.
  Position_3 carried(const Position_3& p, const Torus_3& from) const
  {
    const Position_3 along = combination(from.fractions(p));
    if (is_wire())
      return along + turned(p - from.combination(from.fractions(p)), from);
    return is_slab() ? along + from.elevation(p) * m_vectors[2] : along;
  }
  static Multiples_3 nearest(const Position_3& fractions)
  {
    return {int(std::lrint(fractions.x)), int(std::lrint(fractions.y)),
            int(std::lrint(fractions.z))};
  }
  static Multiples_3 floor(const Position_3& fractions)
  {
    return {int(std::floor(fractions.x)), int(std::floor(fractions.y)),
            int(std::floor(fractions.z))};
  }

  // Whether multiples of such a point can be counted.
  bool is_in_range(const Position_3& p) const
  {
    if (is_clearly_in_range(p))
      return true;
    if (is_wire() && !(squared_length(p) < max_multiple * max_multiple * squared_length(vector(0))))
      return false;
    return is_small(fractions(p)) &&
           is_small({product(m_inverse_of_cell[0], p), product(m_inverse_of_cell[1], p),
                     product(m_inverse_of_cell[2], p)});
  }
  // True only if they can, and never of NaN. A fraction is a product with a row of an inverse, the
  // longest of which has a length of max_multiple / (2 m_near).
  bool is_clearly_in_range(const Position_3& p) const { return sum_of_sizes(p) < m_near; }

  // True only if none of a vector's fractions is larger than a quarter.
  bool is_short(const Position_3& v) const
  {
    return sum_of_sizes(v) < 0.49 / max_multiple * m_near;
  }

  // Whether a position is so far out of the basis' parallelepiped that it is wrapped.
  bool is_far_out(const Position_3& p) const
  {
    const Position_3 v = p - m_middle;
    if (std::abs(v.x) < m_inside && std::abs(v.y) < m_inside && std::abs(v.z) < m_inside)
      return false;
    const Position_3 f = fractions(p);
    return !((std::max)({f.x, f.y, f.z}) < 2 && (std::min)({f.x, f.y, f.z}) > -1);
  }

  // False only if no position of a box is.
  bool may_be_far_out(const Position_3& low, const Position_3& high) const
  {
    const Position_3 f = fractions(0.5 * (low + high)), half = 0.5 * (high - low);
    const auto is_near = [&](double fraction, const Position_3& row) {
      const double reach =
          std::abs(row.x) * half.x + std::abs(row.y) * half.y + std::abs(row.z) * half.z;
      return std::abs(fraction - 0.5) + reach < 1.4; // and not 1.5, so that rounding does not count
    };
    return !(is_near(f.x, m_inverse[0]) && is_near(f.y, m_inverse[1]) &&
             is_near(f.z, m_inverse[2]));
  }

  // What so many of the basis are of the cell's vectors.
  Periodic_shift_3 in_vectors_of_cell(const Multiples_3& m) const
  {
    Periodic_shift_3 shift;
    for (std::size_t j = 0; j < 3; ++j)
      shift[j] = int(m_basis[0][j] * m[0] + m_basis[1][j] * m[1] + m_basis[2][j] * m[2]);
    return shift;
  }

  // The exact vector from one point to another.
  Exact_vector_3 exact_vector(const Torus_point_3& from, const Torus_point_3& to) const
  {
    Exact_vector_3 v{Exact_number_3(to.base.x) - Exact_number_3(from.base.x),
                     Exact_number_3(to.base.y) - Exact_number_3(from.base.y),
                     Exact_number_3(to.base.z) - Exact_number_3(from.base.z)};
    for (int i = 0; i < 3; ++i)
      if (const int number = to.multiples[i] - from.multiples[i]; number != 0) {
        const Exact_number_3 times = double(number);
        const Exact_vector_3& w = m_exact_vectors[std::size_t(i)];
        v.x = v.x + times * w.x;
        v.y = v.y + times * w.y;
        v.z = v.z + times * w.z;
      }
    return v;
  }
  // 1 if a point stands for the one at infinity above a slab, or around a wire, -1 for the one
  // below a slab, else 0.
  int end_of_space(const Torus_point_3& p) const
  {
    return dimension() == 3 ? 0 : p.multiples[2] > 0 ? 1 : p.multiples[2] < 0 ? -1 : 0;
  }
  // Whether space is open along a coordinate axis: no vector of the basis goes along it.
  bool is_open_along(std::size_t axis) const
  {
    return !m_goes_along[0][axis] && !m_goes_along[1][axis] && !m_goes_along[2][axis];
  }
  // True only if four points have one exact coordinate in common: so they are coplanar.
  bool are_level(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                 const Torus_point_3& s) const
  {
    return is_level([](const Position_3& x) { return x.x; }, 0, p, q, r, s) ||
           is_level([](const Position_3& x) { return x.y; }, 1, p, q, r, s) ||
           is_level([](const Position_3& x) { return x.z; }, 2, p, q, r, s);
  }
  bool coincide(const Torus_point_3& p, const Torus_point_3& q) const
  {
    const Exact_vector_3 v = exact_vector(p, q);
    return CGAL::is_zero(v.x) && CGAL::is_zero(v.y) && CGAL::is_zero(v.z);
  }

  // The square of a length by which rounding moves a vector between two images at most, where bases
  // and positions have coordinates up to `largest`, multiples have absolute values of a sum up to
  // `sum`, and shifts of images have multiples up to `most_in_filter`.
  //
  // Let u = 2^-53, and L and B be the largest coordinates of the cell's and the basis' vectors. A
  // coordinate of a basis vector, a sum of three products by integers whose absolute values sum up
  // to M, is off by at most d = 4u M L. A position is the sum of its base and three products: with
  // S = sum, it is off by S d + 5u (largest + S (B + d)). An image adds three products by integers
  // whose absolute values sum up to T = 3 most_in_filter: it is off by another T d + 5u (largest +
  // (S + T) (B + d)), the rounding of the last sum included. In all this is less than (S + T) d +
  // 12u (largest + (S + T) (B + d)). A vector between two images has twice that in each
  // coordinate, and sqrt(3) times as much as its length: 3.5 times suffices.
  double squared_error(double largest, double sum) const
  {
    const double multiples = sum + 3 * most_in_filter;
    const double error =
        multiples * m_error + 0x1p-49 * (largest + multiples * (m_largest + m_error));
    return 12.5 * error * error;
  }
  static constexpr int most_in_filter = 16;
  static bool is_in_filter(const Multiples_3& shift)
  {
    return std::abs(shift[0]) <= most_in_filter && std::abs(shift[1]) <= most_in_filter &&
           std::abs(shift[2]) <= most_in_filter;
  }

  static double product(const Position_3& p, const Position_3& q)
  {
    return p.x * q.x + p.y * q.y + p.z * q.z;
  }
  static Position_3 cross_product(const Position_3& p, const Position_3& q)
  {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  }

  [[noreturn]] static void refuse(const Periodic_cell_3& cell, const char* demand)
  {
    if (cell.is_wire())
      throw Periodic_cell_error_3(cell.a(), demand);
    if (cell.is_slab())
      throw Periodic_cell_error_3(cell.a(), cell.b(), demand);
    throw Periodic_cell_error_3(cell.a(), cell.b(), cell.c(), demand);
  }

private:
  template <class Coordinate>
  bool is_level(const Coordinate& coordinate, std::size_t axis, const Torus_point_3& p,
                const Torus_point_3& q, const Torus_point_3& r, const Torus_point_3& s) const
  {
    const double level = coordinate(p.base);
    for (const Torus_point_3* const other : {&q, &r, &s}) {
      if (coordinate(other->base) != level)
        return false;
      for (int i = 0; i < 3; ++i)
        if (m_goes_along[std::size_t(i)][axis] && other->multiples[i] != p.multiples[i])
          return false;
    }
    return true;
  }

  static Basis unit_basis() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

  Torus_3(const Periodic_cell_3& cell, const Basis& basis)
    : m_cell(cell)
    , m_basis(unit_basis())
  {
    set_vectors();
    m_inverse_of_cell = m_inverse;
    m_basis = basis;
    set_vectors();
    set_near();
  }

  // That of absolute values: at least the length.
  static double sum_of_sizes(const Position_3& p)
  {
    return std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  }
  static bool is_small(const Position_3& p)
  {
    return std::abs(p.x) < max_multiple && std::abs(p.y) < max_multiple &&
           std::abs(p.z) < max_multiple;
  }
  static double determinant(const Basis& m)
  {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
           m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  // A vector across the other wire, turned as that turns to this one: around the normal of both.
  // As it is, if that is unclear.
  Position_3 turned(const Position_3& p, const Torus_3& from) const
  {
    const Position_3 u = (1 / from.volume()) * from.m_vectors[0], v = (1 / volume()) * m_vectors[0];
    const Position_3 k = cross_product(u, v);
    const double c = product(u, v);
    if (!(c > 0) || squared_length(k) == 0)
      return p;
    return c * p + cross_product(k, p) + (product(k, p) / (1 + c)) * k;
  }

  void set_vectors()
  {
    double most = 0, largest_of_cell = 0;
    m_largest = 0;
    const std::size_t vectors = std::size_t(dimension());
    for (std::size_t i = 0; i < vectors; ++i) {
      std::array<double, 3> sum{0, 0, 0};
      std::array<Exact_number_3, 3> exact{Exact_number_3(0), Exact_number_3(0), Exact_number_3(0)};
      double number = 0;
      for (std::size_t j = 0; j < vectors; ++j) {
        number += std::abs(m_basis[i][j]);
        for (std::size_t k = 0; k < 3; ++k) {
          sum[k] += m_basis[i][j] * m_cell.vector(j)[k];
          exact[k] = exact[k] + Exact_number_3(m_basis[i][j]) * Exact_number_3(m_cell.vector(j)[k]);
          largest_of_cell = (std::max)(largest_of_cell, std::abs(m_cell.vector(j)[k]));
        }
      }
      m_vectors[i] = {sum[0], sum[1], sum[2]};
      m_exact_vectors[i] = {exact[0], exact[1], exact[2]};
      for (std::size_t k = 0; k < 3; ++k)
        m_goes_along[i][k] = !CGAL::is_zero(exact[k]);
      most = (std::max)(most, number);
      for (const double x : sum)
        m_largest = (std::max)(m_largest, std::abs(x));
    }
    m_error = 0x1p-51 * most * largest_of_cell;
    if (is_wire())
      return set_across();
    if (is_slab())
      set_normal();
    m_determinant = product(m_vectors[0], cross_product(m_vectors[1], m_vectors[2]));
    for (std::size_t i = 0; i < 3; ++i)
      m_inverse[i] =
          (1 / m_determinant) * cross_product(m_vectors[(i + 1) % 3], m_vectors[(i + 2) % 3]);
    if (is_slab())
      m_inverse[2] = {0, 0, 0};
  }
  // Of the length 1, where it is rounded.
  void set_normal()
  {
    m_normal = Rounded_normal_3::of(m_vectors[0], m_vectors[1], 2 * m_error);
    m_vectors[2] = m_normal.direction;
    m_exact_vectors[2] = cross(m_exact_vectors[0], m_exact_vectors[1]);
  }

  void set_across()
  {
    const double square = squared_length(m_vectors[0]);
    for (std::size_t i = 1; i < 3; ++i) {
      const auto& v = m_cell.vector(i);
      m_vectors[i] = {v[0], v[1], v[2]};
      m_inverse[i] = {0, 0, 0};
    }
    m_inverse[0] = (1 / square) * m_vectors[0];
    m_determinant = std::sqrt(square);
  }

  void set_near()
  {
    m_small_translations.set(m_vectors);
    double most = 0;
    for (const auto* inverse : {&m_inverse, &m_inverse_of_cell})
      for (const Position_3& row : *inverse)
        most = (std::max)(most, squared_length(row));
    m_near = max_multiple / (2 * std::sqrt(most));
    // fractions less than 1.4 from 1/2, so that rounding does not count; 0.8 < 1.4 / sqrt(3)
    m_middle = combination(Position_3{0.5, 0.5, 0.5});
    m_inside = 0.8 / std::sqrt(most);
  }

  // Whether fractions, and what is computed from them, mean something.
  bool is_measurable() const
  {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_finite(m_inverse[i]) || !is_finite(m_vectors[i]))
        return false;
      const double error = std::sqrt(3.0) * (m_error + 0x1p-50 * m_largest);
      if (!(error * std::sqrt(squared_length(m_inverse[i])) < 0x1p-12))
        return false;
    }
    return m_largest > 1e-60 && m_largest < 1e60;
  }
  bool has_same_hand(const Torus_3& other) const
  {
    if (is_wire())
      return product(m_vectors[0], other.m_vectors[0]) > 0;
    return (m_determinant > 0) == (other.m_determinant > 0);
  }
  // Whether the basis of the other torus differs little from this one.
  bool is_near(const Torus_3& other) const
  {
    if (!other.is_measurable())
      return false;
    if (is_wire())
      return squared_length(other.m_vectors[0] - m_vectors[0]) < 0.5 * squared_length(m_vectors[0]);
    for (std::size_t i = 0; i < std::size_t(dimension()); ++i) {
      const Position_3 f = fractions(other.m_vectors[i] - m_vectors[i]);
      if (!(std::abs(f.x) < 0.75 && std::abs(f.y) < 0.75 && std::abs(f.z) < 0.75))
        return false;
    }
    return true;
  }

  Basis nearest_multiples(const std::array<Position_3, 3>& vectors) const
  {
    Basis nearest = unit_basis();
    for (std::size_t i = 0; i < std::size_t(dimension()); ++i) {
      const Position_3 f = fractions(vectors[i]);
      if (!is_small(f))
        return {}; // of determinant 0
      nearest[i] = {std::rint(f.x), std::rint(f.y), std::rint(f.z)};
    }
    return nearest;
  }

  // Takes multiples of vectors from others as long as that makes these shorter. Any basis is
  // correct; a short one keeps shifts small, and cells of few points near.
  void shorten_basis()
  {
    for (int steps = 0; steps < 1000; ++steps) {
      set_vectors();
      if (!shorten_one())
        return;
    }
  }
  bool shorten_one()
  {
    if (is_wire())
      return false;
    if (is_slab())
      return shorten_one_of_two();
    std::array<double, 3> squares;
    for (std::size_t i = 0; i < 3; ++i)
      squares[i] = squared_length(m_vectors[i]);
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return squares[i] < squares[j]; });
    const std::size_t shortest = order[0], middle = order[1], longest = order[2];
    const Position_3 a = m_vectors[shortest], b = m_vectors[middle];
    const double of_middle = product(a, b) / squares[shortest];
    if (is_too_much(of_middle)) {
      take(middle, {shortest, std::rint(of_middle)}, {shortest, 0});
      return true;
    }
    // the multiples of both that lie beneath the longest one, however long that is
    const Position_3 across = b - of_middle * a;
    const double n = product(across, m_vectors[longest]) / squared_length(across);
    const double m = product(a, m_vectors[longest] - std::rint(n) * b) / squares[shortest];
    if (is_too_much(n) || is_too_much(m)) {
      take(longest, {shortest, std::rint(m)}, {middle, std::rint(n)});
      return true;
    }
    for (const double k : {0.0, 1.0, -1.0})
      for (const double l : {0.0, 1.0, -1.0})
        if (is_shorter(longest, {shortest, k}, {middle, l}, squares[longest])) {
          take(longest, {shortest, k}, {middle, l});
          return true;
        }
    return false;
  }
  bool shorten_one_of_two()
  {
    const double squares[] = {squared_length(m_vectors[0]), squared_length(m_vectors[1])};
    const std::size_t shortest = squares[1] < squares[0] ? 1 : 0, longest = 1 - shortest;
    const double number = product(m_vectors[0], m_vectors[1]) / squares[shortest];
    if (!is_too_much(number))
      return false;
    take(longest, {shortest, std::rint(number)}, {shortest, 0});
    return true;
  }
  // Whether a projection can be made clearly shorter.
  static bool is_too_much(double multiple) { return std::abs(multiple) > 0.501; }

  struct Multiple
  {
    std::size_t vector;
    double number;
  };
  bool is_shorter(std::size_t i, const Multiple& first, const Multiple& second, double square) const
  {
    const Position_3 v = m_vectors[i] - first.number * m_vectors[first.vector] -
                         second.number * m_vectors[second.vector];
    return squared_length(v) < 0.999 * square;
  }
  // Subtracts multiples of two vectors from another one.
  void take(std::size_t i, const Multiple& first, const Multiple& second)
  {
    for (std::size_t n = 0; n < 3; ++n)
      m_basis[i][n] -=
          first.number * m_basis[first.vector][n] + second.number * m_basis[second.vector][n];
    for (const double number : m_basis[i])
      if (!(std::abs(number) < max_multiple))
        refuse(m_cell, "a short basis needs too large multiples of its vectors");
  }

  Periodic_cell_3 m_cell;
  Basis m_basis; // multiples of the cell's vectors
  std::array<Position_3, 3> m_vectors, m_inverse, m_inverse_of_cell;
  std::array<Exact_vector_3, 3> m_exact_vectors;
  std::array<std::array<bool, 3>, 3> m_goes_along{}; // whether coordinates of these are not 0
  Rounded_normal_3 m_normal;
  double m_determinant = 0;
  double m_error = 0, m_largest = 0; // of coordinates of the basis
  double m_near = 0;                 // points with smaller coordinates are in range
  Position_3 m_middle{0, 0, 0};      // of the basis' parallelepiped
  double m_inside = 0;               // points that are not farther from that are not far out
  Small_translations_3 m_small_translations;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_3_H
