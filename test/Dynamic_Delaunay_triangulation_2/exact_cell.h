// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi cells in space by rational numbers, without a triangulation: each facet is what all other
// half-spaces leave of a huge square.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_EXACT_CELL_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_EXACT_CELL_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace exact_cell {

using Number = CGAL::Exact_rational;
using Vector = std::array<Number, 3>;

inline Number dot(const Vector& p, const Vector& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline Vector cross(const Vector& p, const Vector& q)
{
  return {Number(p[1] * q[2] - p[2] * q[1]), Number(p[2] * q[0] - p[0] * q[2]),
          Number(p[0] * q[1] - p[1] * q[0])};
}
inline Vector combination(const Number& s, const Vector& p, const Number& t, const Vector& q)
{
  return {Number(s * p[0] + t * q[0]), Number(s * p[1] + t * q[1]), Number(s * p[2] + t * q[2])};
}

inline double length(const Vector& p)
{
  return std::hypot(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
}

// All x with normal * x <= product, relative to the point of the cell.
struct Half_space
{
  Vector normal;
  Number product;
  std::size_t neighbor; // or `wall`
};
constexpr std::size_t wall = std::size_t(-1);

struct Corner
{
  Vector place;
  bool is_distant; // on the border of the huge square, and so is the side that begins here
};
using Polygon = std::vector<Corner>;

struct Cell
{
  bool is_bounded = true;
  double volume = 0, surface = 0, reach = 0; // the distance of the most distant corner
  std::array<double, 3> centroid{0, 0, 0};
  std::map<std::size_t, double> areas; // of facets with an area, by neighbor
};

inline Polygon clip(const Polygon& polygon, const Half_space& by)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const Number s = dot(by.normal, from.place) - by.product;
    const Number t = dot(by.normal, to.place) - by.product;
    if (s <= 0)
      result.push_back(from);
    if ((s < 0 && t > 0) || (s > 0 && t < 0)) {
      const Vector crossing = combination(t / (t - s), from.place, -s / (t - s), to.place);
      result.push_back({crossing, s > 0 && from.is_distant});
    } else if (s == 0 && t > 0) {
      result.back().is_distant = false;
    }
  }
  return result;
}

// What the others leave of the border of a half-space.
inline Polygon facet(const std::vector<Half_space>& all, std::size_t k, const Number& size)
{
  const Half_space& its = all[k];
  const Vector axis = its.normal[0] == 0 && its.normal[1] == 0 ? Vector{1, 0, 0} : Vector{0, 0, 1};
  Vector u = cross(its.normal, axis);
  u = combination(1 / (CGAL::abs(u[0]) + CGAL::abs(u[1]) + CGAL::abs(u[2])), u, 0, u);
  Vector v = cross(its.normal, u);
  v = combination(1 / (CGAL::abs(v[0]) + CGAL::abs(v[1]) + CGAL::abs(v[2])), v, 0, v);
  const Vector foot =
      combination(its.product / dot(its.normal, its.normal), its.normal, 0, its.normal);
  Polygon polygon;
  for (const auto& [s, t] : {std::pair<int, int>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    polygon.push_back({combination(1, foot, size, combination(Number(s), u, Number(t), v)), true});
  for (std::size_t j = 0; j < all.size() && !polygon.empty(); ++j) {
    const Vector normal = cross(all[j].normal, its.normal);
    const bool is_parallel = dot(normal, normal) == 0 && dot(all[j].normal, its.normal) > 0;
    const bool is_same = is_parallel && all[j].product * dot(its.normal, its.normal) ==
                                            its.product * dot(all[j].normal, its.normal);
    if (is_same && j < k) // only the first of equal ones has the facet
      return {};
    if (j != k)
      polygon = clip(polygon, all[j]);
  }
  return polygon;
}

template <class Point>
Vector vector_between(const Point& p, const Point& q)
{
  return {Number(Number(q.x()) - Number(p.x())), Number(Number(q.y()) - Number(p.y())),
          Number(Number(q.z()) - Number(p.z()))};
}

// The cell of a point among others that differ from it, in a box if there is one.
template <class Point>
Cell cell(const Point& p, const std::vector<std::pair<std::size_t, Point>>& others,
          const std::optional<CGAL::Bbox_3>& box, double size)
{
  std::vector<Half_space> all;
  for (const auto& [id, q] : others) {
    const Vector way = vector_between(p, q);
    all.push_back({way, Number(dot(way, way) / 2), id});
  }
  if (box) {
    const Vector low = vector_between(p, Point(box->xmin(), box->ymin(), box->zmin()));
    const Vector high = vector_between(p, Point(box->xmax(), box->ymax(), box->zmax()));
    for (std::size_t i = 0; i < 3; ++i) {
      Vector axis{0, 0, 0};
      axis[i] = 1;
      all.push_back({axis, high[i], wall});
      axis[i] = -1;
      all.push_back({axis, Number(-low[i]), wall});
    }
  }
  Cell result;
  result.is_bounded = !all.empty();
  Number volume(0);
  Vector moment{0, 0, 0};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Polygon polygon = facet(all, k, Number(size));
    if (polygon.empty())
      continue;
    Vector doubled{0, 0, 0};
    bool is_distant = false;
    const Vector& first = polygon[0].place;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      is_distant = is_distant || polygon[i].is_distant;
      if (i == 0 || i + 1 == polygon.size())
        continue;
      const Vector &q = polygon[i].place, &r = polygon[i + 1].place;
      Vector part = cross(combination(1, q, -1, first), combination(1, r, -1, first));
      if (dot(part, all[k].normal) < 0)
        part = combination(-1, part, 0, part);
      doubled = combination(1, doubled, 1, part);
      const Number six = dot(first, part);
      volume += six / 6;
      moment = combination(1, moment, six / 24, combination(1, first, 1, combination(1, q, 1, r)));
    }
    if (dot(doubled, doubled) == 0)
      continue;
    result.is_bounded = result.is_bounded && !is_distant;
    const double area = is_distant ? std::numeric_limits<double>::infinity() : length(doubled) / 2;
    result.surface += area;
    if (all[k].neighbor != wall)
      result.areas[all[k].neighbor] = area;
    for (const Corner& corner : polygon)
      result.reach = (std::max)(result.reach, length(corner.place));
  }
  result.volume = CGAL::to_double(volume);
  if (volume > 0) {
    const double at[] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    for (std::size_t i = 0; i < 3; ++i)
      result.centroid[i] = at[i] + CGAL::to_double(Number(moment[i] / volume));
  }
  return result;
}

} // namespace exact_cell

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_EXACT_CELL_H
