// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the periodic triangulation of several ranks with that of one process. One process may
// cut Delaunay cells of more than three corners in any way: here exact arithmetic finds these
// cells, and they are cut again as ranks have to cut them.

#ifndef DISTRIBUTED_PERIODIC_ORACLE_H
#define DISTRIBUTED_PERIODIC_ORACLE_H

#include "distributed_oracle.h"

#include <CGAL/Distributed_dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <tuple>

using Distributed_periodic = CGAL::Distributed_dynamic_periodic_Delaunay_triangulation_2<Kernel>;
using Cell = CGAL::Periodic_cell_2;
using Shift = CGAL::Periodic_shift_2;
// The smaller id first; of a point to its own image, the larger one of both shifts.
using Periodic_edge = std::tuple<Id, Id, Shift>;
using Periodic_edges = std::vector<Periodic_edge>; // ascending

inline Shift operator+(const Shift& s, const Shift& t)
{
  return {s[0] + t[0], s[1] + t[1]};
}
inline Shift operator-(const Shift& s, const Shift& t)
{
  return {s[0] - t[0], s[1] - t[1]};
}

inline Periodic_edge normal_form(Id i, Id j, const Shift& shift)
{
  const Shift back = Shift{0, 0} - shift;
  const bool is_turned = j < i || (i == j && back > shift);
  return is_turned ? Periodic_edge{j, i, back} : Periodic_edge{i, j, shift};
}

// The edges that one process has, with the diagonals of the ranks.
class One_process
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_point = Exact::Point_2;

public:
  One_process(const Population& points, const Cell& cell)
    : m_cell(cell)
  {
    Points positions;
    for (const auto& [id, p] : points) {
      m_ids.push_back(id);
      positions.push_back(p);
    }
    const CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel> dt(positions, cell);
    expect(dt.is_certified(), "one process is certified");
    m_vertices = dt.number_of_vertices();
    m_points = positions;
    read_labels(dt);
    read_faces(dt);
    for (std::size_t f = 0; f < m_faces.size(); ++f)
      if (!m_seen[f])
        cut(f);
  }

  std::size_t number_of_vertices() const { return m_vertices; }
  Periodic_edges edges() const { return Periodic_edges(m_edges.begin(), m_edges.end()); }

private:
  using Image = std::pair<std::size_t, Shift>; // of a label
  using Face = std::array<Image, 3>;
  using Side = std::tuple<std::size_t, std::size_t, Shift>;

  // Of points that coincide one process labels the vertex by any, ranks by the smallest id.
  template <class Triangulation>
  void read_labels(const Triangulation& dt)
  {
    std::map<std::size_t, std::size_t> labels;
    for (std::size_t i = 0; i < m_ids.size(); ++i)
      labels.emplace(dt.representative(i), i);
    const double determinant = m_cell.ax() * m_cell.by() - m_cell.ay() * m_cell.bx();
    for (std::size_t i = 0; i < m_ids.size(); ++i) {
      const auto label = labels.find(i);
      if (label == labels.end()) {
        m_labels.push_back({i, {0, 0}});
        continue;
      }
      const std::size_t j = label->second;
      const double x = m_points[i].x() - m_points[j].x(), y = m_points[i].y() - m_points[j].y();
      const Shift shift{int(std::lround((x * m_cell.by() - y * m_cell.bx()) / determinant)),
                        int(std::lround((y * m_cell.ax() - x * m_cell.ay()) / determinant))};
      m_labels.push_back({j, shift});
      expect(place({j, shift}) == place({i, {0, 0}}), "points of one vertex coincide");
    }
  }

  template <class Triangulation>
  void read_faces(const Triangulation& dt)
  {
    dt.for_each_face(
        [&](const std::array<std::size_t, 3>& ids, const std::array<Shift, 3>& shifts) {
          Face face;
          for (std::size_t k = 0; k < 3; ++k) {
            const Image& label = m_labels[ids[k]];
            face[k] = {label.first, label.second + shifts[k]};
          }
          for (std::size_t k = 0; k < 3; ++k)
            m_sides[side(face[k], face[(k + 1) % 3])] = {m_faces.size(), k};
          m_faces.push_back(face);
        });
    m_seen.assign(m_faces.size(), false);
    expect(m_sides.size() == 3 * m_faces.size(), "one process has each side once");
  }

  static Side side(const Image& p, const Image& q)
  {
    return {p.first, q.first, q.second - p.second};
  }

  Exact_point place(const Image& image) const
  {
    const Point& p = m_points[image.first];
    const Exact::FT i(image.second[0]), j(image.second[1]);
    return Exact_point(Exact::FT(p.x()) + i * m_cell.ax() + j * m_cell.bx(),
                       Exact::FT(p.y()) + i * m_cell.ay() + j * m_cell.by());
  }

  // The face on the other side of an edge, translated so that it shares the edge.
  std::pair<std::size_t, Face> beyond(const Face& face, std::size_t k) const
  {
    const Image &p = face[k], &q = face[(k + 1) % 3];
    const auto [number, place] = m_sides.at(side(q, p));
    Face other = m_faces[number];
    const Shift shift = q.second - other[place].second;
    std::rotate(other.begin(), other.begin() + long(place), other.end());
    for (Image& corner : other)
      corner.second = corner.second + shift;
    return {number, other};
  }

  bool are_on_one_circle(const Face& face, const Image& other) const
  {
    return CGAL::side_of_oriented_circle(place(face[0]), place(face[1]), place(face[2]),
                                         place(other)) == CGAL::ON_ORIENTED_BOUNDARY;
  }

  // Cuts the Delaunay cell that contains a face: all its corners are joined with one of them.
  void cut(std::size_t first)
  {
    std::vector<std::pair<std::size_t, Face>> waiting{{first, m_faces[first]}};
    std::set<Image> corners;
    while (!waiting.empty()) {
      const auto [number, face] = waiting.back();
      waiting.pop_back();
      if (m_seen[number])
        continue;
      m_seen[number] = true;
      for (std::size_t k = 0; k < 3; ++k) {
        corners.insert(face[k]);
        const auto next = beyond(face, k);
        if (are_on_one_circle(face, next.second[2]))
          waiting.push_back(next);
        else
          note(face[k], face[(k + 1) % 3]);
      }
    }
    const auto apex =
        std::min_element(corners.begin(), corners.end(), [&](const Image& p, const Image& q) {
          return p.first != q.first ? p.first < q.first : place(p) < place(q);
        });
    for (const Image& corner : corners)
      if (corner != *apex)
        note(*apex, corner);
  }

  void note(const Image& p, const Image& q)
  {
    m_edges.insert(normal_form(m_ids[p.first], m_ids[q.first], q.second - p.second));
  }

  Cell m_cell;
  std::vector<Id> m_ids; // ascending
  Points m_points;
  std::vector<Image> m_labels;
  std::vector<Face> m_faces;
  std::map<Side, std::pair<std::size_t, std::size_t>> m_sides;
  std::vector<bool> m_seen;
  std::set<Periodic_edge> m_edges;
  std::size_t m_vertices = 0;
};

// The sum of the lengths of the two shortest vectors that span the lattice.
inline double shortest_sum(const Cell& cell)
{
  Kernel::Vector_2 r(cell.ax(), cell.ay()), t(cell.bx(), cell.by());
  for (int steps = 0; steps < 64; ++steps) {
    if (r * r > t * t)
      std::swap(r, t);
    t = t - std::round(r * t / (r * r)) * r;
  }
  return std::sqrt(r * r) + std::sqrt(t * t);
}

// The points that all ranks have triangulated, on rank 0: those that were given, but for rounding.
inline Population triangulated(const Distributed_periodic& dt, const Population& given,
                               const std::string& what)
{
  struct Place
  {
    Id id;
    double x, y;
  };
  std::vector<Place> own;
  const std::vector<Id> ids = dt.owned_ids();
  const Points points = dt.owned_points();
  const double most = 0x1p-45 * shortest_sum(dt.cell());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Point& p = given.at(ids[k]);
    expect(std::abs(points[k].x() - p.x()) <= most && std::abs(points[k].y() - p.y()) <= most,
           what + ": points are where they were given, but for rounding");
    expect(dt.point(ids[k]) == points[k], what + ": a point has one position");
    own.push_back({ids[k], points[k].x(), points[k].y()});
  }
  Population all;
  for (const Place& place : gathered_data(own))
    all[place.id] = Point(place.x, place.y);
  return all;
}

inline void expect_exact(const Distributed_periodic& dt, const Population& population,
                         const std::string& what)
{
  Periodic_edges own, sides;
  dt.for_each_edge([&](Id i, Id j, const Shift& shift) {
    expect(i <= j, what + ": the smaller id is first");
    own.push_back(normal_form(i, j, shift));
  });
  std::uint64_t faces = 0;
  dt.for_each_face([&](const std::array<Id, 3>& ids, const std::array<Shift, 3>& shifts) {
    ++faces;
    expect(shifts[0] == Shift{0, 0}, what + ": the first corner of a face is not shifted");
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      sides.push_back(normal_form(ids[k], ids[next], shifts[next] - shifts[k]));
    }
  });
  expect(dt.is_certified(), what + ": certified");
  expect(sum(dt.number_of_owned_points()) == population.size(), what + ": all points are owned");
  faces = sum(faces);
  const Periodic_edges all = gathered(own), all_sides = gathered(sides);
  const Population points = triangulated(dt, population, what);
  if (this_rank > 0)
    return;
  const One_process one(points, dt.cell());
  expect(all == one.edges(), what + ": the edges of all ranks are those of one");
  expect(faces == 2 * one.number_of_vertices(), what + ": twice as many faces as vertices");
  for (const Periodic_edge& side : all_sides)
    expect(std::binary_search(all.begin(), all.end(), side), what + ": sides of faces are edges");
}

// A deformation that keeps the cell.
inline auto always(const Cell& cell)
{
  return [=](int) { return cell; };
}

// As run(), in the cell that `deform(frame)` returns. The result must be valid and certified.
template <class Deform, class Move>
void run_periodic(const std::string& what, const Points& points, int frames,
                  const Ownership& ownership, const Deform& deform, const Move& move)
{
  const Population population = numbered(points);
  Cell cell = deform(0);
  auto dt =
      distributed<Distributed_periodic>(population, ownership.owner, cell, ownership.load_factor);
  follow(dt, population, what, frames, move, [&](const Population& moved, int frame) {
    const Cell next_cell = deform(frame);
    if (next_cell == cell)
      update(dt, moved);
    else
      update(dt, moved, next_cell);
    cell = next_cell;
  });
  expect(dt.is_valid(), what + ": valid");
  expect(dt.certify(), what + ": certified anew");
}

#endif // DISTRIBUTED_PERIODIC_ORACLE_H
