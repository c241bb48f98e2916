// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Four points of any finite doubles, and what is true about them.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_QUADRUPLES_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_QUADRUPLES_H

#include "exact_signs.h"
#include "oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>

using CGAL::Dynamic_Delaunay_triangulations_2::Position_2;

using Random = std::mt19937_64;
using Quadruple = std::array<Position_2, 4>;

constexpr double largest = (std::numeric_limits<double>::max)();

inline double between(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline int whole(Random& random, int low, int high)
{
  return std::uniform_int_distribution<int>(low, high)(random);
}

inline double within_range(double x)
{
  return (std::min)((std::max)(x, -largest), largest);
}

// Four points each, of all magnitudes, many of them on a line or on a circle, or nearly so.
class Quadruples
{
public:
  explicit Quadruples(unsigned seed)
    : random(seed)
  {
  }

  Quadruple next()
  {
    Quadruple q = make();
    if (random() % 3 == 0)
      for (int i = whole(random, 1, 3); i > 0; --i)
        nudge(random() % 2 ? q[random() % 4].x : q[random() % 4].y);
    std::shuffle(q.begin(), q.end(), random);
    if (random() % 8 && exact_signs::orientation(q[0], q[1], q[2]) < 0)
      std::swap(q[1], q[2]);
    return q;
  }

  // A finite double of random bits.
  double any_double()
  {
    for (;;) {
      const std::uint64_t bits = random();
      double x;
      std::memcpy(&x, &bits, sizeof x);
      if (std::isfinite(x))
        return x;
    }
  }

  // Half of them are close to where a square, or a product of squares, underflows or overflows.
  int any_exponent()
  {
    static constexpr int thresholds[] = {-1074, -1022, -700, -540, -485, -400, -333, -268,
                                         -250,  -243,  -200, -100, 0,    100,  200,  243,
                                         252,   256,   300,  341,  400,  508,  512,  1018};
    return random() % 2 ? thresholds[random() % std::size(thresholds)] + whole(random, -4, 4)
                        : whole(random, -1074, 1022);
  }

  Random random;

private:
  Quadruple make()
  {
    switch (random() % 8) {
    case 0:
      return made([this] { return any_double(); }, [this] { return any_double(); });
    case 1:
      return of_integers(any_exponent());
    case 2: {
      const int x = any_exponent(), y = any_exponent();
      return made([&] { return integer_times(x, 8); }, [&] { return integer_times(y, 8); });
    }
    case 3:
      return far_away();
    case 4:
      return around_a_magnitude();
    case 5:
      return trapezoid();
    case 6:
      return on_a_line();
    default:
      return on_a_circle();
    }
  }

  template <class X, class Y>
  Quadruple made(X x, Y y)
  {
    Quadruple q;
    for (Position_2& p : q) {
      p.x = within_range(x());
      p.y = within_range(y());
    }
    return q;
  }

  double integer_times(int exponent, int bits)
  {
    const double bound = std::ldexp(1., bits);
    return std::ldexp(std::round(between(random, -bound, bound)), exponent);
  }

  Quadruple of_integers(int exponent)
  {
    const int bits = whole(random, 1, 52);
    const auto integer = [&] { return integer_times(exponent - bits, bits); };
    return made(integer, integer);
  }

  Quadruple far_away()
  {
    const auto near = [this](double place, int bits) {
      const double step = std::nextafter(std::abs(place), largest) - std::abs(place);
      return [=] { return place + step * integer_times(0, bits); };
    };
    const double x = any_double() / 2, y = random() % 2 ? x : any_double() / 2;
    const int bits = whole(random, 1, 20);
    return made(near(x, bits), near(y, bits));
  }

  Quadruple around_a_magnitude()
  {
    const int exponent = any_exponent(), spread = whole(random, 1, 300);
    const auto coordinate = [&] {
      return std::ldexp(between(random, -2, 2), exponent + whole(random, -spread, spread));
    };
    return made(coordinate, coordinate);
  }

  // Cocircular, whatever its coordinates are.
  Quadruple trapezoid()
  {
    const bool is_any = random() % 2;
    const int exponent = any_exponent(), other = exponent + whole(random, -60, 60);
    const auto coordinate = [&](int e) {
      return is_any ? any_double() : within_range(std::ldexp(between(random, -2, 2), e));
    };
    const double x1 = coordinate(exponent), x2 = random() % 2 ? x1 : coordinate(exponent);
    const double y1 = coordinate(other), y2 = coordinate(other);
    return {{{-x1, y1}, {x1, y1}, {x2, y2}, {-x2, y2}}};
  }

  Quadruple on_a_line()
  {
    const double x = std::ldexp(between(random, -2, 2), any_exponent());
    const double y = std::ldexp(between(random, -2, 2), any_exponent());
    Quadruple q;
    for (Position_2& p : q) {
      const double factor = std::ldexp(random() % 2 ? 1. : -1., whole(random, -30, 30));
      p = {within_range(x * factor), within_range(y * factor)};
    }
    return q;
  }

  Quadruple on_a_circle()
  {
    static constexpr int on_it[][2] = {{65, 0},  {63, 16}, {60, 25}, {56, 33}, {52, 39},
                                       {39, 52}, {33, 56}, {25, 60}, {16, 63}, {0, 65}};
    const int exponent = any_exponent();
    const double offset = random() % 2 ? 0 : std::round(between(random, -1e15, 1e15));
    const auto coordinate = [&](int k) {
      return within_range(std::ldexp(offset + (random() % 2 ? k : -k), exponent));
    };
    Quadruple q;
    for (Position_2& p : q) {
      const auto& k = on_it[random() % std::size(on_it)];
      p.x = coordinate(k[0]);
      p.y = coordinate(k[1]);
    }
    return q;
  }

  void nudge(double& x)
  {
    for (int i = whole(random, 1, 2); i > 0; --i)
      x = within_range(std::nextafter(x, random() % 2 ? HUGE_VAL : -HUGE_VAL));
  }
};

inline std::string text(const Quadruple& q)
{
  std::ostringstream out;
  out << std::hexfloat;
  for (const Position_2& p : q)
    out << '(' << p.x << ", " << p.y << ") ";
  return out.str();
}

inline Epick::Point_2 point(const Position_2& p)
{
  return {p.x, p.y};
}

// The three signs of the edge bc between the faces abc and dcb.
struct Signs
{
  explicit Signs(const Quadruple& q)
    : left(exact_signs::orientation(q[0], q[1], q[2]))
    , right(exact_signs::orientation(q[3], q[2], q[1]))
    , side(exact_signs::side_of_circle(q[0], q[1], q[2], q[3]))
  {
  }

  bool are_counterclockwise() const { return left > 0 && right > 0; }

  int left, right, side;
};

inline bool are_coordinates(const Quadruple& q)
{
  using CGAL::Dynamic_Delaunay_triangulations_2::internal::is_within_limit;
  return std::all_of(q.begin(), q.end(), [](const Position_2& p) {
    return is_within_limit(p.x) && is_within_limit(p.y);
  });
}

// A sample of all doubles that the package takes for coordinates; how many of them were ties.
inline std::size_t expect_exact_kernel_predicates(unsigned seed, int number)
{
  Quadruples quadruples(seed);
  std::size_t ties = 0;
  for (int i = 0; i < number; ++i) {
    const Quadruple q = quadruples.next();
    if (!are_coordinates(q))
      continue;
    const Signs signs(q);
    EXPECT_EQ(CGAL::orientation(point(q[0]), point(q[1]), point(q[2])), signs.left) << text(q);
    EXPECT_EQ(CGAL::side_of_oriented_circle(point(q[0]), point(q[1]), point(q[2]), point(q[3])),
              signs.side)
        << text(q);
    EXPECT_EQ(CGAL::compare_x(point(q[0]), point(q[1])), (q[0].x > q[1].x) - (q[0].x < q[1].x))
        << text(q);
    ties += signs.side == 0;
  }
  return ties;
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_QUADRUPLES_H
