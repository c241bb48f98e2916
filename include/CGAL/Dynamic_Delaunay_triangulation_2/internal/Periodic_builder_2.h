// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_BUILDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_BUILDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Torus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The faces of a closed surface over the vertices 1, 2, ..., with a shift for each corner.
struct Periodic_faces_2
{
  std::vector<Index> apexes, twins;     // of each half-edge, three for a face
  std::vector<Periodic_shift_2> shifts; // of its apex
  std::vector<Index> points;            // of each vertex; the first one is not used
};

// Images of points in the plane, rounded, as predicates on vertices ask for them. Number 0 is at
// infinity.
class Image_cloud_2
{
public:
  using Traits = Exact_predicates_inexact_constructions_kernel;

  void clear()
  {
    m_positions = {nowhere()};
    m_points = {no_index};
    m_shifts = {no_shift};
  }
  void add(const Position_2& position, Index point, const Periodic_shift_2& shift)
  {
    m_positions.push_back(position);
    m_points.push_back(point);
    m_shifts.push_back(shift);
  }

  std::size_t size() const { return m_positions.size(); }
  Index point_of(Index image) const { return m_points[image]; }
  const Periodic_shift_2& shift(Index image) const { return m_shifts[image]; }

  const std::vector<Position_2>& positions() const { return m_positions; }
  static constexpr bool positions_are_exact() { return true; }
  Traits::Point_2 point(Index image) const { return {m_positions[image].x, m_positions[image].y}; }
  const Traits& traits() const { return m_traits; }

private:
  std::vector<Position_2> m_positions;
  std::vector<Index> m_points;
  std::vector<Periodic_shift_2> m_shifts;
  Traits m_traits;
};

// Triangulates points of a torus from scratch, by the engine of the plane: wraps all points into a
// cell of short vectors, adds the images around it, as far as circles may reach where points are
// about evenly spread, and keeps one face of each class of faces that are translations of each
// other.
//
// Images are rounded, ties are broken in any way, and there may be too few images. So the result is
// not taken for Delaunay, only for a triangulation of the torus, and that is checked: there are
// twice as many faces as points, each half-edge has one twin, the faces around a vertex are one
// cycle, and their areas sum up to that of the cell. Rounding cannot hide another degree than one,
// since the sum is a multiple of the cell's area. Where a check fails there is no result. That is
// so for grids, whose ties are broken differently in different images.
class Periodic_builder_2
{
  using Predicates = Vertex_predicates_2<Image_cloud_2>;

public:
  Periodic_builder_2()
    : m_guibas_stolfi(Predicates(m_cloud), m_planar)
  {
  }
  Periodic_builder_2(const Periodic_builder_2&) = delete;
  Periodic_builder_2& operator=(const Periodic_builder_2&) = delete;

  // Fewer points are inserted faster.
  static constexpr std::size_t min_points = 100;

  // False if there is no result.
  bool run(const Torus_2& torus, const std::vector<Position_2>& points)
  {
    return points.size() >= min_points && !torus.cell().is_slab() && make_cloud(torus, points) &&
           triangulate(points.size()) && glue(points.size()) && are_stars(points.size()) &&
           cover_once(torus);
  }

  const Periodic_faces_2& faces() const { return m_faces; }

  void release()
  {
    m_faces = Periodic_faces_2();
    m_cloud.clear();
    m_planar.release();
    m_order.release();
    std::vector<Index>().swap(m_vertex_of_point);
    std::vector<Index>().swap(m_face_numbers);
    std::vector<Open_halfedge>().swap(m_open);
  }

private:
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  // The wrapped points, and then their images around the cell.
  bool make_cloud(const Torus_2& torus, const std::vector<Position_2>& points)
  {
    const auto basis = short_basis(torus);
    const Position_2 r = torus.vector({double(basis[0][0]), double(basis[0][1])});
    const Position_2 t = torus.vector({double(basis[1][0]), double(basis[1][1])});
    const Torus_2 short_torus(Periodic_cell_2(r.x, r.y, t.x, t.y));
    const double n = double(points.size()), area = torus.cell().area();
    // the largest empty circles of n random points have a radius of about sqrt(log n / pi) spacings
    const double margin = 1.2 * std::sqrt(std::log(n) * area / n);
    const double along_r = margin * std::hypot(t.x, t.y) / area;
    const double along_t = margin * std::hypot(r.x, r.y) / area;
    if (!(along_r < 0.5 && along_t < 0.5))
      return false;
    m_cloud.clear();
    std::vector<Position_2> multiples;
    for (Index i = 0; i < points.size(); ++i) {
      const Position_2 m = short_torus.multiples(points[i]);
      const Periodic_shift_2 k{int(-std::floor(m.x)), int(-std::floor(m.y))};
      multiples.push_back({m.x + k[0], m.y + k[1]});
      add(torus, points[i], i, combination(basis, k));
    }
    for (Index i = 0; i < points.size(); ++i) {
      const int u = side(multiples[i].x, along_r), v = side(multiples[i].y, along_t);
      const Periodic_shift_2 k = m_cloud.shift(i + 1);
      if (u != 0)
        add(torus, points[i], i, k + combination(basis, {u, 0}));
      if (v != 0)
        add(torus, points[i], i, k + combination(basis, {0, v}));
      if (u != 0 && v != 0)
        add(torus, points[i], i, k + combination(basis, {u, v}));
    }
    return m_cloud.size() <= max_vertices; // of the plane, whose numbers have 32 bits as well
  }

  // In which direction the images of a point are around the cell.
  static int side(double multiple, double margin)
  {
    return multiple < margin ? 1 : multiple > 1 - margin ? -1 : 0;
  }

  static Periodic_shift_2 combination(const std::array<Periodic_shift_2, 2>& basis,
                                      const Periodic_shift_2& k)
  {
    return {k[0] * basis[0][0] + k[1] * basis[1][0], k[0] * basis[0][1] + k[1] * basis[1][1]};
  }

  void add(const Torus_2& torus, const Position_2& p, Index i, const Periodic_shift_2& shift)
  {
    m_cloud.add(torus.rounded({p, shift}), i, shift);
  }

  // False if two images are in one place.
  bool triangulate(std::size_t points)
  {
    const boost::counting_iterator<Index> first(1), beyond(Index(m_cloud.size()));
    m_order.sort(m_cloud.positions(), first, beyond);
    m_vertex_of_point.resize(points);
    m_faces.points = {no_index};
    for (std::size_t i = 0; i < m_order.size(); ++i) {
      const Index image = m_order[i];
      if (i > 0 && are_together(image, m_order[i - 1]))
        return false;
      if (image <= points) {
        m_vertex_of_point[image - 1] = Index(m_faces.points.size());
        m_faces.points.push_back(image - 1);
      }
    }
    m_guibas_stolfi.run(m_order);
    return true;
  }

  bool are_together(Index image, Index other) const
  {
    const Position_2 &p = m_cloud.positions()[image], &q = m_cloud.positions()[other];
    return p.x == q.x && p.y == q.y;
  }

  Index vertex(Index image) const { return m_vertex_of_point[m_cloud.point_of(image)]; }

  // Of all translations of a face it is the one whose first corner is a wrapped point. The first
  // corner has the smallest vertex, and the smallest shift if several corners have that vertex.
  bool is_kept(Index planar_face, std::size_t points) const
  {
    const Index h = Flat_faces_2::first_halfedge(planar_face);
    std::array<Index, 3> corners{m_planar.apex(h), m_planar.apex(h + 1), m_planar.apex(h + 2)};
    if (std::find(corners.begin(), corners.end(), infinite_index) != corners.end())
      return false;
    const Index first = *std::min_element(corners.begin(), corners.end(), [&](Index a, Index b) {
      return std::make_tuple(vertex(a), m_cloud.shift(a)) <
             std::make_tuple(vertex(b), m_cloud.shift(b));
    });
    return first <= points;
  }

  // Copies the faces that are kept, and links them. False if they are not one of each class.
  bool glue(std::size_t points)
  {
    number_faces(points);
    if (m_faces.apexes.size() != 6 * points)
      return false;
    m_open.clear();
    m_faces.twins.assign(m_faces.apexes.size(), no_index);
    for (Index f = 0; f < m_planar.number_of_faces(); ++f)
      if (m_face_numbers[f] != no_index)
        for (Index i = 0; i < 3; ++i)
          link(Flat_faces_2::first_halfedge(f) + i, 3 * m_face_numbers[f] + i);
    std::sort(m_open.begin(), m_open.end());
    for (std::size_t i = 0; i < m_open.size(); i += 2) {
      if (i + 1 == m_open.size() || !m_open[i].is_twin_of(m_open[i + 1]) ||
          (i + 2 < m_open.size() && m_open[i + 1].has_edge_of(m_open[i + 2])))
        return false;
      m_faces.twins[m_open[i].halfedge] = m_open[i + 1].halfedge;
      m_faces.twins[m_open[i + 1].halfedge] = m_open[i].halfedge;
    }
    return true;
  }

  void number_faces(std::size_t points)
  {
    m_faces.apexes.clear();
    m_faces.shifts.clear();
    m_face_numbers.assign(m_planar.number_of_faces(), no_index);
    for (Index f = 0; f < m_planar.number_of_faces(); ++f) {
      if (!is_kept(f, points))
        continue;
      m_face_numbers[f] = Index(m_faces.apexes.size() / 3);
      const Index h = Flat_faces_2::first_halfedge(f);
      for (Index i = h; i < h + 3; ++i) {
        m_faces.apexes.push_back(vertex(m_planar.apex(i)));
        m_faces.shifts.push_back(m_cloud.shift(m_planar.apex(i)) - m_cloud.shift(m_planar.apex(h)));
      }
    }
  }

  // A half-edge whose twin in the plane is of a face that is not kept.
  struct Open_halfedge
  {
    Index from, to; // in ascending order
    Periodic_shift_2 shift;
    bool is_reversed;
    Index halfedge;

    auto edge() const { return std::tie(from, to, shift); }
    bool has_edge_of(const Open_halfedge& other) const { return edge() == other.edge(); }
    bool is_twin_of(const Open_halfedge& other) const
    {
      return has_edge_of(other) && is_reversed != other.is_reversed;
    }
    friend bool operator<(const Open_halfedge& g, const Open_halfedge& h)
    {
      return std::tuple_cat(g.edge(), std::tie(g.is_reversed)) <
             std::tuple_cat(h.edge(), std::tie(h.is_reversed));
    }
  };

  void link(Index planar, Index h)
  {
    const Index twin = m_planar.twin(planar), number = m_face_numbers[twin / 4];
    if (number != no_index) {
      m_faces.twins[h] = 3 * number + twin % 4;
      return;
    }
    Index from = m_faces.apexes[next(h)], to = m_faces.apexes[previous(h)];
    Periodic_shift_2 shift = m_faces.shifts[previous(h)] - m_faces.shifts[next(h)];
    const bool is_reversed = from > to || (from == to && shift < no_shift);
    if (is_reversed) {
      std::swap(from, to);
      shift = no_shift - shift;
    }
    m_open.push_back({from, to, shift, is_reversed, h});
  }

  // Whether the corners of each vertex are one cycle.
  bool are_stars(std::size_t points) const
  {
    std::vector<Index> corner(points + 1, no_index);
    for (Index h = 0; h < m_faces.apexes.size(); ++h)
      corner[m_faces.apexes[h]] = h;
    std::size_t corners = 0;
    for (std::size_t v = 1; v <= points; ++v) {
      if (corner[v] == no_index)
        return false;
      Index h = corner[v];
      do {
        h = next(m_faces.twins[next(h)]);
        if (m_faces.apexes[h] != v || ++corners > m_faces.apexes.size())
          return false;
      } while (h != corner[v]);
    }
    return corners == m_faces.apexes.size();
  }

  // Whether the faces cover the torus once.
  bool cover_once(const Torus_2& torus) const
  {
    double doubled_area = 0;
    for (Index f = 0; f < m_planar.number_of_faces(); ++f)
      if (m_face_numbers[f] != no_index) {
        const Index h = Flat_faces_2::first_halfedge(f);
        const Position_2& p = m_cloud.positions()[m_planar.apex(h)];
        const Position_2& q = m_cloud.positions()[m_planar.apex(h + 1)];
        const Position_2& s = m_cloud.positions()[m_planar.apex(h + 2)];
        doubled_area += (q.x - p.x) * (s.y - p.y) - (q.y - p.y) * (s.x - p.x);
      }
    return std::abs(doubled_area / torus.cell().area() - 2) < 0.5;
  }

  Image_cloud_2 m_cloud;
  Spatial_order_2 m_order;
  Flat_faces_2 m_planar;
  Guibas_stolfi_2<Predicates> m_guibas_stolfi;
  std::vector<Index> m_vertex_of_point;
  std::vector<Index> m_face_numbers; // of the planar faces that are kept
  std::vector<Open_halfedge> m_open;
  Periodic_faces_2 m_faces;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_BUILDER_2_H
