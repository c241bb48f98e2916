// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tori, slabs and wires in space, as the tests that run for each of them see them.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_TESTED_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_TESTED_H

#include "periodic_space_oracle.h"
#include "space_points.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace periodic_space_tested {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using Vector = Kernel::Vector_3;
using Cell = CGAL::Periodic_cell_3;
using Coordinates = Cell::Coordinates;
using periodic_space_oracle::cells_of;
using periodic_space_oracle::Shift;
using periodic_space_oracle::Site;
using periodic_space_oracle::operator+;
using periodic_space_oracle::operator-;
using space_points::random_points;
using space_points::shaken;

constexpr double infinity = std::numeric_limits<double>::infinity();

// KINDS OF CELLS ----------------------------------------------------------------------------------

struct Kind
{
  // The cell of this kind with the first ones of these vectors.
  Cell cell(const Coordinates& a, const Coordinates& b, const Coordinates& c) const
  {
    return dimension == 1 ? Cell(a) : dimension == 2 ? Cell(a, b) : Cell(a, b, c);
  }
  Cell box(double width, double depth, double height) const
  {
    return cell({width, 0, 0}, {0, depth, 0}, {0, 0, height});
  }

  const char* name;
  std::size_t dimension;   // everything is repeated along so many vectors
  std::vector<Cell> cells; // of which the last but one has no simple numbers
};

inline const Kind torus{"torus",
                        3,
                        {Cell(1, 1, 1), Cell(3, 1, 0.5),
                         Cell({1, 0.1, 0.2}, {0.5, -0.9, 0.1}, {7.3, 0.2, 1.1}),
                         Cell({0, 1, 0}, {1, 0, 0}, {0.2, 0.3, 0.8})}};
inline const Kind slab{"slab",
                       2,
                       {Cell({1, 0, 0}, {0, 1, 0}), Cell({0, 0.4, 0}, {3, 0.1, 0}),
                        Cell({1, 0, 0}, {7.3, 0.9, 0}), Cell({1, 0.1, 0.2}, {0.5, -0.9, 0.7}),
                        Cell({0, 0, -1}, {0.3, 0, 1.2})}};
inline const Kind wire{"wire",
                       1,
                       {Cell(Coordinates{1, 0, 0}), Cell(Coordinates{0.1, 3, 0.25}),
                        Cell(Coordinates{0.5, -0.9, 0.7}), Cell(Coordinates{0, 0, -0.7})}};

// A test that runs for some kinds.
class Of_kind : public testing::TestWithParam<const Kind*>
{
protected:
  const Kind& kind = *GetParam();
  const std::size_t dimension = kind.dimension;
  const Cell unit = kind.box(1, 1, 1);
  const Cell tilted = kind.cells.rbegin()[1];
  const Cell triclinic = kind.cell({1.1, 0.03, -0.2}, {0.4, 0.9, 0.1}, {-0.3, 0.45, 1.2});
  const Cell mirrored = kind.cell({0, 1, 0}, {1, 0, 0}, {0.2, 0.3, 0.8});
  const Cell skew = kind.cell({1, 0, 0}, {1.7, 1, 0}, {-1.6, 1.4, 0.8}); // not by short vectors
  // Images of points with few bits are not rounded.
  const Cell oblique = kind.cell({1, 0.25, 0.125}, {0.25, 1.125, 0.5}, {-0.125, 0.375, 0.875});
};

inline auto all_kinds()
{
  return testing::Values(&torus, &slab, &wire);
}
inline auto open_kinds()
{
  return testing::Values(&slab, &wire);
}
inline std::string name_of(const testing::TestParamInfo<const Kind*>& info)
{
  return info.param->name;
}

// POINTS ------------------------------------------------------------------------------------------

inline Vector combination(const Cell& cell, double x, double y, double z)
{
  const auto& [a, b, c] = std::tie(cell.a(), cell.b(), cell.c());
  return Vector(x * a[0] + y * b[0] + z * c[0], x * a[1] + y * b[1] + z * c[1],
                x * a[2] + y * b[2] + z * c[2]);
}

// Of a slab or a wire, only those numbers of the shift count along which it is repeated.
inline Point image(const Point& p, const Shift& shift, const Cell& cell)
{
  return p + combination(cell, shift[0], cell.dimension() > 1 ? shift[1] : 0,
                         cell.dimension() > 2 ? shift[2] : 0);
}

// Points of a cube that has a corner in the origin.
inline Points points_of_cube(std::size_t number, double side = 1, unsigned seed = 7)
{
  Points points;
  for (const Point& p : random_points(number, seed))
    points.emplace_back(side * p.x(), side * p.y(), side * p.z());
  return points;
}

// A place by fractions of the cell's vectors; across a slab or a wire from 0 to `thickness`.
inline Point place_in(const Cell& cell, const Point& fractions, double thickness = 1)
{
  return CGAL::ORIGIN + combination(cell, fractions.x(),
                                    (cell.dimension() > 1 ? 1 : thickness) * fractions.y(),
                                    (cell.dimension() > 2 ? 1 : thickness) * fractions.z());
}
inline Points points_in(const Cell& cell, std::size_t number, double thickness = 1,
                        unsigned seed = 7)
{
  Points points;
  for (const Point& p : random_points(number, seed))
    points.push_back(place_in(cell, p, thickness));
  return points;
}

inline double rounded(double x, int bits = 30)
{
  return std::ldexp(std::rint(std::ldexp(x, bits)), -bits);
}
inline Point rounded(const Point& p, int bits = 30)
{
  return Point(rounded(p.x(), bits), rounded(p.y(), bits), rounded(p.z(), bits));
}
// Whose images in cells with few bits are not rounded.
inline Points short_points_in(const Cell& cell, std::size_t number, double thickness = 1,
                              unsigned seed = 7)
{
  Points points;
  for (const Point& p : random_points(number, seed))
    points.push_back(rounded(place_in(cell, rounded(p, 27), thickness)));
  return points;
}
inline Point near(const Point& p, double step, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> way(-step, step);
  const double x = way(random), y = way(random);
  return p + (rounded(Point(x, y, way(random))) - CGAL::ORIGIN);
}

inline Points box_lattice(int length, int width, int depth)
{
  Points points;
  for (int x = 0; x < length; ++x)
    for (int y = 0; y < width; ++y)
      for (int z = 0; z < depth; ++z)
        points.emplace_back(x, y, z);
  return points;
}

// WHAT IS EXPECTED --------------------------------------------------------------------------------

inline std::map<std::size_t, Point> by_id(const Points& points)
{
  std::map<std::size_t, Point> result;
  for (std::size_t id = 0; id < points.size(); ++id)
    result.emplace(id, points[id]);
  return result;
}

inline void expect_exact(const Dynamic& dt, const Points& points, const Cell& cell)
{
  periodic_space_oracle::expect_exact(dt, by_id(points), cell);
}

template <class Any>
std::string written(const Any& any)
{
  std::ostringstream out;
  any.write_checkpoint(out);
  return out.str();
}

// That of the pairs. (g++ 12 warns that these, compared as arrays, may be uninitialized.)
struct Site_order
{
  bool operator()(const Site& a, const Site& b) const
  {
    return std::tie(a.first, a.second[0], a.second[1], a.second[2]) <
           std::tie(b.first, b.second[0], b.second[1], b.second[2]);
  }
};

} // namespace periodic_space_tested

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_TESTED_H
