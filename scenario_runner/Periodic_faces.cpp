// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Periodic_faces.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace run {

namespace {

using scenario::Cell;
using scenario::Point;
using scenario::Shift;

Shift difference(const Shift& s, const Shift& t)
{
  return {s[0] - t[0], s[1] - t[1]};
}

// The edges of faces, each with the corners opposite to it.
class Periodic_edges
{
public:
  struct Edge
  {
    std::array<std::uint32_t, 2> places;
    Shift shift; // of the second end, as seen from the first one

    friend bool operator<(const Edge& e, const Edge& f)
    {
      return std::tie(e.places, e.shift) < std::tie(f.places, f.shift);
    }
  };

  Periodic_edges(const std::vector<Periodic_face>& faces, const std::vector<Point>& points,
                 const Cell& cell)
    : m_points(points)
    , m_cell(cell)
  {
    for (const Periodic_face& face : faces) {
      for (std::size_t i = 0; i != 3; ++i) {
        add(face, i, (i + 1) % 3, (i + 2) % 3);
      }
    }
  }

  // The number of these edges that the others lack, without those that are ties.
  std::size_t number_beyond(const Periodic_edges& others) const
  {
    return static_cast<std::size_t>(
        std::count_if(m_edges.begin(), m_edges.end(), [&](const auto& entry) {
          return others.m_edges.count(entry.first) == 0 && !is_tie(entry.first, entry.second);
        }));
  }

  std::size_t size() const { return m_edges.size(); }

private:
  struct Apex
  {
    std::uint32_t place;
    Shift shift; // as seen from the first end
  };

  void add(const Periodic_face& face, std::size_t from, std::size_t to, std::size_t apex)
  {
    const Shift shift = difference(face.shifts[to], face.shifts[from]);
    const Edge there{{face.places[from], face.places[to]}, shift};
    const Edge back{{face.places[to], face.places[from]}, difference({0, 0}, shift)};
    const std::size_t first = there < back ? from : to;
    m_edges[(std::min)(there, back)].push_back(
        {face.places[apex], difference(face.shifts[apex], face.shifts[first])});
  }

  static constexpr double rounding = 1e-9;

  // Whether doubles cannot tell on which side of the circle through the others a corner is; or at
  // the border of a slab, whether there is a face at all.
  bool is_tie(const Edge& edge, const std::vector<Apex>& apexes) const
  {
    return apexes.size() == 1 ? is_flat(edge, apexes[0])
                              : apexes.size() == 2 && are_cocircular(edge, apexes);
  }

  bool is_flat(const Edge& edge, const Apex& apex) const
  {
    const Point origin = image(edge.places[0], {0, 0});
    const Point p = from(origin, image(edge.places[1], edge.shift));
    const Point q = from(origin, image(apex.place, apex.shift));
    return std::abs(p.x * q.y - p.y * q.x) <=
           rounding * (p.x * p.x + p.y * p.y + q.x * q.x + q.y * q.y);
  }

  bool are_cocircular(const Edge& edge, const std::vector<Apex>& apexes) const
  {
    const Point origin = image(apexes[1].place, apexes[1].shift);
    const std::array<Point, 3> corners = {image(edge.places[0], {0, 0}),
                                          image(edge.places[1], edge.shift),
                                          image(apexes[0].place, apexes[0].shift)};
    double determinant = 0.0, size = 0.0;
    for (std::size_t i = 0; i != 3; ++i) {
      const Point p = from(origin, corners[i]), q = from(origin, corners[(i + 1) % 3]);
      const Point r = from(origin, corners[(i + 2) % 3]);
      const double square = r.x * r.x + r.y * r.y;
      determinant += square * (p.x * q.y - p.y * q.x);
      size += square * (std::abs(p.x * q.y) + std::abs(p.y * q.x));
    }
    return std::abs(determinant) <= rounding * size;
  }

  Point image(std::uint32_t place, const Shift& shift) const
  {
    return m_cell.image(m_points[place], shift);
  }

  static Point from(const Point& origin, const Point& p)
  {
    return {p.x - origin.x, p.y - origin.y};
  }

  const std::vector<Point>& m_points;
  const Cell& m_cell;
  std::map<Edge, std::vector<Apex>> m_edges;
};

} // namespace

Periodic_face normal(const Periodic_face& face)
{
  Periodic_face best{};
  for (std::size_t first = 0; first != 3; ++first) {
    Periodic_face turned{};
    for (std::size_t i = 0; i != 3; ++i) {
      const std::size_t corner = (first + i) % 3;
      turned.places[i] = face.places[corner];
      turned.shifts[i] = difference(face.shifts[corner], face.shifts[first]);
    }
    if (first == 0 || turned < best) {
      best = turned;
    }
  }
  return best;
}

void sort_once(std::vector<Periodic_face>& faces)
{
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

double agreement_of(const std::vector<Periodic_face>& faces,
                    const std::vector<Periodic_face>& reference, const std::vector<Point>& points,
                    const Cell& cell)
{
  if (faces == reference) {
    return 1.0;
  }
  const Periodic_edges edges(faces, points, cell);
  const Periodic_edges right_edges(reference, points, cell);
  const std::size_t wrong = edges.number_beyond(right_edges);
  const std::size_t missing = right_edges.number_beyond(edges);
  return CGAL::Delaunay_agreement(edges.size() - wrong, wrong, missing, points.size())
      .matthews_correlation_coefficient();
}

} // namespace run
