// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_LANES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_LANES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h> // refuses -ffast-math
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

// Passes over points and edges are written once, for numbers of type `Lanes<n>`: n doubles with
// which a processor computes at once, or a plain double if n is 1. All processors and numbers of
// lanes give the same bits. Compilers that have vector types translate them to instructions of
// AVX-512, AVX2, SSE2, NEON or WebAssembly. With other compilers, or if
// CGAL_DYNAMIC_DELAUNAY_NO_SIMD is defined, there is one lane.
#if defined(__GNUC__) && !defined(CGAL_DYNAMIC_DELAUNAY_NO_SIMD) &&                                \
    (defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__))
#define CGAL_DYNAMIC_DELAUNAY_HAS_LANES
#define CGAL_DYNAMIC_DELAUNAY_INLINE __attribute__((always_inline)) // for lambdas
#else
#define CGAL_DYNAMIC_DELAUNAY_INLINE
#endif

// AVX2 is selected at run time, so that it does not need special compiler flags.
#if defined(CGAL_DYNAMIC_DELAUNAY_HAS_LANES) && defined(__x86_64__) && !defined(__AVX2__)
#define CGAL_DYNAMIC_DELAUNAY_SELECTS_LANES
#endif

// Makes compilers round a product before they use it. Otherwise they may contract a product and a
// sum to one instruction that rounds once, on processors that have it: results would differ.
#if defined(__GNUC__) && (defined(__FMA__) || defined(__FMA4__) || defined(__AVX512F__))
#define CGAL_DYNAMIC_DELAUNAY_KEEP(product) __asm__("" : "+v"(product))
#elif defined(__aarch64__)
#define CGAL_DYNAMIC_DELAUNAY_KEEP(product) __asm__("" : "+w"(product))
#elif !defined(__GNUC__) || defined(__x86_64__) || defined(__i386__) || defined(__wasm__)
#define CGAL_DYNAMIC_DELAUNAY_KEEP(product) static_cast<void>(product)
#else
#define CGAL_DYNAMIC_DELAUNAY_KEEP(product) __asm__("" : "+m"(product))
#endif

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// ONE LANE ----------------------------------------------------------------------------------------

BOOST_FORCEINLINE double product(double a, double b)
{
  double rounded = a * b;
  CGAL_DYNAMIC_DELAUNAY_KEEP(rounded);
  return rounded;
}

BOOST_FORCEINLINE double magnitude(double a)
{
  return std::abs(a);
}

BOOST_FORCEINLINE double larger(double a, double b)
{
  return a < b ? b : a;
}

BOOST_FORCEINLINE double smaller(double a, double b)
{
  return b < a ? b : a;
}

BOOST_FORCEINLINE double root(double a)
{
  return std::sqrt(a);
}

// Bit i of the result is set if lane i answers yes.
BOOST_FORCEINLINE unsigned bits(bool answer)
{
  return answer;
}

template <int n>
constexpr unsigned all_bits = (1u << n) - 1;

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES

// SEVERAL LANES -----------------------------------------------------------------------------------

template <int... places>
using Places = std::integer_sequence<int, places...>;

// Numbers, or the answers of a comparison: integers with all bits set for yes, and none for no.
template <class Number, int n>
struct Lanes_2
{
  typedef Number Vector __attribute__((vector_size(8 * n)));
  using Bits = Lanes_2<std::int64_t, n>;

  // Copies the bits of `value` to all lanes: given the double, g++ would set them one by one.
  BOOST_FORCEINLINE Lanes_2(double value)
  {
    std::int64_t value_bits;
    std::memcpy(&value_bits, &value, sizeof(value));
    vector = (Vector)(value_bits | typename Bits::Vector{});
  }
  BOOST_FORCEINLINE explicit Lanes_2(const Vector& v)
    : vector(v)
  {
  }
  // Takes the lanes of a and b at these places; the lanes of b are numbered after those of a. g++
  // wants as many places as a has lanes.
  template <int m, int... places>
  BOOST_FORCEINLINE Lanes_2(const Lanes_2<Number, m>& a, const Lanes_2<Number, m>& b,
                            Places<places...>)
  {
#ifdef __clang__
    vector = __builtin_shufflevector(a.vector, b.vector, places...);
#else
    vector = __builtin_shuffle(a.vector, b.vector, typename Bits::Vector{places...});
#endif
  }
  // With a destructor of its own, an object is passed by reference: functions for different
  // processors pass vectors by value differently. Inlining removes the references.
  BOOST_FORCEINLINE ~Lanes_2()
  {
  }

  BOOST_FORCEINLINE Lanes_2 operator-() const
  {
    return Lanes_2(-vector);
  }
  BOOST_FORCEINLINE Lanes_2 operator+(const Lanes_2& b) const
  {
    return Lanes_2(vector + b.vector);
  }
  BOOST_FORCEINLINE Lanes_2 operator-(const Lanes_2& b) const
  {
    return Lanes_2(vector - b.vector);
  }
  BOOST_FORCEINLINE Lanes_2 operator/(const Lanes_2& b) const
  {
    return Lanes_2(vector / b.vector);
  }
  BOOST_FORCEINLINE Lanes_2 operator&(const Lanes_2& b) const
  {
    return Lanes_2(vector & b.vector);
  }
  BOOST_FORCEINLINE Lanes_2 operator|(const Lanes_2& b) const
  {
    return Lanes_2(vector | b.vector);
  }
  BOOST_FORCEINLINE Bits operator<(const Lanes_2& b) const
  {
    return Bits(vector < b.vector);
  }
  BOOST_FORCEINLINE Bits operator>(const Lanes_2& b) const
  {
    return Bits(vector > b.vector);
  }
  BOOST_FORCEINLINE Bits operator<=(const Lanes_2& b) const
  {
    return Bits(vector <= b.vector);
  }
  BOOST_FORCEINLINE Bits operator==(const Lanes_2& b) const
  {
    return Bits(vector == b.vector);
  }

  BOOST_FORCEINLINE friend Lanes_2 product(const Lanes_2& a, const Lanes_2& b)
  {
    Lanes_2 rounded(a.vector * b.vector);
    CGAL_DYNAMIC_DELAUNAY_KEEP(rounded.vector);
    return rounded;
  }
  BOOST_FORCEINLINE friend Lanes_2 magnitude(const Lanes_2& a)
  {
    return Lanes_2((Vector)((typename Bits::Vector)a.vector & 0x7fffffffffffffff));
  }
  BOOST_FORCEINLINE friend Lanes_2 larger(const Lanes_2& a, const Lanes_2& b)
  {
    return Lanes_2(a.vector < b.vector ? b.vector : a.vector);
  }
  BOOST_FORCEINLINE friend Lanes_2 smaller(const Lanes_2& a, const Lanes_2& b)
  {
    return Lanes_2(b.vector < a.vector ? b.vector : a.vector);
  }
  // By itself g++ 12 takes the roots one by one.
  BOOST_FORCEINLINE friend Lanes_2 root(const Lanes_2& a)
  {
    Lanes_2 result(a);
#if defined(__SSE2__) && !defined(__clang__)
    if constexpr (n == 4)
      __asm__("vsqrtpd {%1, %0|%0, %1}" : "=x"(result.vector) : "x"(a.vector));
    else
      result.vector = __builtin_ia32_sqrtpd(a.vector);
#else
    for (int i = 0; i < n; ++i)
      result.vector[i] = std::sqrt(a.vector[i]);
#endif
    return result;
  }

  Vector vector;
};

template <int n>
using Lanes = std::conditional_t<n == 1, double, Lanes_2<double, n>>;
template <int n>
using Answers = std::conditional_t<n == 1, bool, Lanes_2<std::int64_t, n>>;

#ifdef __SSE2__ // has instructions that vector types cannot express

BOOST_FORCEINLINE unsigned bits(const Answers<2>& answers)
{
  return unsigned(__builtin_ia32_movmskpd((Lanes<2>::Vector)answers.vector));
}

BOOST_FORCEINLINE unsigned bits(const Answers<4>& answers)
{
#ifdef __clang__
  Answers<2>::Vector halves[2];
  std::memcpy(halves, &answers.vector, sizeof(halves));
  return bits(Answers<2>(halves[0])) | bits(Answers<2>(halves[1])) << 2;
#else
  unsigned result;
  __asm__("vmovmskpd {%1, %0|%0, %1}" : "=r"(result) : "x"(answers.vector));
  return result;
#endif
}

#else

BOOST_FORCEINLINE unsigned bits(const Answers<2>& answers)
{
  return unsigned(answers.vector[0] & 1) | unsigned(answers.vector[1] & 2);
}

#endif

#else

template <int n>
using Lanes = double;

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_LANES

// POINTS ------------------------------------------------------------------------------------------

// The coordinates of points, or of vectors, one in each lane.
template <class Number>
struct Points_in_lanes_2
{
  Number x, y;

  BOOST_FORCEINLINE Points_in_lanes_2 operator-(const Points_in_lanes_2& other) const
  {
    return {x - other.x, y - other.y};
  }
};

BOOST_FORCEINLINE Points_in_lanes_2<double> in_one_lane(const Position_2& p)
{
  return {p.x, p.y};
}
BOOST_FORCEINLINE Points_in_lanes_2<double> in_one_lane(const std::array<int, 2>& v)
{
  return {double(v[0]), double(v[1])};
}

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES

// The coordinates of n / 2 points that are consecutive in memory, x and y by turns.
template <int n>
BOOST_FORCEINLINE Lanes<n> coordinates_at(const Position_2* points)
{
  typename Lanes<n>::Vector numbers;
  std::memcpy(&numbers, points, sizeof(numbers));
  return Lanes<n>(numbers);
}

BOOST_FORCEINLINE Lanes<2> in_two_lanes(const Position_2& p)
{
  return coordinates_at<2>(&p);
}
BOOST_FORCEINLINE Lanes<2> in_two_lanes(const std::array<int, 2>& v)
{
  return Lanes<2>(Lanes<2>::Vector{double(v[0]), double(v[1])});
}

#ifdef __SSE2__ // no other processor has four lanes

// The coordinates of two points. By itself g++ 12 uses neither the AVX instructions below nor that
// in bits(): passes over edges would take a tenth longer.
BOOST_FORCEINLINE Lanes<4> in_four_lanes(const Position_2& p, const Position_2& q)
{
  const Lanes<2> low = in_two_lanes(p), high = in_two_lanes(q);
#ifdef __clang__
  return Lanes<4>(low, high, Places<0, 1, 2, 3>());
#else
  Lanes<4>::Vector all;
  __asm__("vinsertf128 {$1, %2, %t1, %0|%0, %t1, %2, 1}"
          : "=x"(all)
          : "x"(low.vector), "xm"(high.vector));
  return Lanes<4>(all);
#endif
}
BOOST_FORCEINLINE Lanes<4> in_four_lanes(const std::array<int, 2>& v, const std::array<int, 2>& w)
{
  typedef std::int64_t Pairs __attribute__((vector_size(16)));
  typedef int Integers __attribute__((vector_size(16)));
  std::int64_t low, high;
  std::memcpy(&low, &v, sizeof(low));
  std::memcpy(&high, &w, sizeof(high));
  const Integers integers = (Integers)Pairs{low, high};
  Lanes<4>::Vector all;
#ifdef __clang__
  all = __builtin_convertvector(integers, Lanes<4>::Vector);
#else
  __asm__("vcvtdq2pd {%1, %0|%0, %1}" : "=x"(all) : "xm"(integers));
#endif
  return Lanes<4>(all);
}

#endif

// The coordinates of n / 2 points: point_at(first), point_at(first + 2), and so on.
template <int n, class Point_at>
BOOST_FORCEINLINE Lanes<n> every_second(int first, const Point_at& point_at)
{
  if constexpr (n == 2)
    return in_two_lanes(point_at(first));
  else
    return in_four_lanes(point_at(first), point_at(first + 2));
}

// Separates x and y, which alternate in a and b. The result has points of a and b by turns.
template <int n>
BOOST_FORCEINLINE Points_in_lanes_2<Lanes<n>> taken_apart(const Lanes_2<double, n>& a,
                                                          const Lanes_2<double, n>& b)
{
  if constexpr (n == 2)
    return {Lanes<n>(a, b, Places<0, 2>()), Lanes<n>(a, b, Places<1, 3>())};
  else
    return {Lanes<n>(a, b, Places<0, 4, 2, 6>()), Lanes<n>(a, b, Places<1, 5, 3, 7>())};
}

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_LANES

// Puts the coordinates of point_at(i) into lane i.
template <int n, class Point_at>
BOOST_FORCEINLINE Points_in_lanes_2<Lanes<n>> points_in_lanes(const Point_at& point_at)
{
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES
  if constexpr (n > 1)
    return taken_apart(every_second<n>(0, point_at), every_second<n>(1, point_at));
  else
#endif
    return in_one_lane(point_at(0));
}

// THE PROCESSOR -----------------------------------------------------------------------------------

// As many lanes as fit into the registers for which the compiler's flags allow, but at most four:
// eight lanes of AVX-512 are slower where points have to be gathered.
#ifndef CGAL_DYNAMIC_DELAUNAY_HAS_LANES
constexpr int usual_lanes = 1;
#elif defined(__AVX2__)
constexpr int usual_lanes = 4;
#else
constexpr int usual_lanes = 2;
#endif

#ifdef CGAL_DYNAMIC_DELAUNAY_SELECTS_LANES

inline bool has_avx2()
{
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

template <class Pass>
__attribute__((target("avx2"))) auto call_with_avx2(const Pass& pass)
{
  return pass(std::integral_constant<int, 4>());
}

#endif // CGAL_DYNAMIC_DELAUNAY_SELECTS_LANES

// Calls pass(n) with the number of lanes of the processor, a constant. The pass, and all functions
// that compute in lanes for it, must be inlined: only then they are compiled for that processor.
template <class Pass>
auto call_with_lanes(const Pass& pass)
{
#ifdef CGAL_DYNAMIC_DELAUNAY_SELECTS_LANES
  if (has_avx2())
    return call_with_avx2(pass);
#endif
  return pass(std::integral_constant<int, usual_lanes>());
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_LANES_2_H
