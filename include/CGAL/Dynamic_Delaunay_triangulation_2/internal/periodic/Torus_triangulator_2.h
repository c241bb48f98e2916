// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The faces of a closed surface over the vertices 1, 2, ..., with a shift for each corner.
struct Periodic_faces_2
{
  Uninitialized_column<Halfedge_index, Vertex_index> apexes;
  Uninitialized_column<Halfedge_index, Halfedge_index> twins;
  // of each apex; the first of a face has none
  Uninitialized_column<Halfedge_index, Periodic_shift_2> shifts;
  Uninitialized_column<Vertex_index, Index> points; // of each vertex; the first one is not used
};

// Images of points in the plane, rounded, with the functions that predicates on vertices call.
// Image 0 is at infinity. The other images are set with any numbers; then arrange() numbers them
// along a curve, so that images that are close in space are close in memory.
class Image_cloud_2
{
public:
  using Traits = Exact_predicates_inexact_constructions_kernel;

  struct Image
  {
    Position_2 position;
    Index point;
    Periodic_shift_2 shift;
  };

  void reserve(std::size_t images)
  {
    m_positions.reserve(images + 1);
    m_points.reserve(images + 1);
    m_shifts.reserve(images + 1);
  }
  void resize(std::size_t images)
  {
    m_positions.resize(images + 1);
    m_points.resize(images + 1);
    m_shifts.resize(images + 1);
    m_positions[infinite_index] = nan_point();
  }
  void set(Vertex_index number, const Image& image)
  {
    m_positions[number] = image.position;
    m_points[number] = image.point;
    m_shifts[number] = image.shift;
  }

  // Renumbers the images in this order. Afterwards `order` has their new numbers.
  template <class Parts>
  void arrange(Spatial_order_2& order)
  {
    const auto arrange_all = [&](auto& data) {
      std::remove_reference_t<decltype(data)> arranged(data.size());
      arranged[infinite_index] = data[infinite_index];
      Parts::for_each_element(order.size(),
                              [&](std::size_t i) { arranged[i + 1] = data[order[i]]; });
      data.swap(arranged);
    };
    arrange_all(m_positions);
    arrange_all(m_points);
    arrange_all(m_shifts);
    Parts::for_each_element(order.size(), [&](std::size_t i) { order.renumber(i, Index(i + 1)); });
  }

  void release()
  {
    Position_vector().swap(m_positions);
    Uninitialized_vector<Index>().swap(m_points);
    Uninitialized_vector<Periodic_shift_2>().swap(m_shifts);
  }

  std::size_t size() const { return m_positions.size(); }
  Index point_of(Vertex_index image) const { return m_points[image]; }
  const Periodic_shift_2& shift(Vertex_index image) const { return m_shifts[image]; }

  const Position_vector& positions() const { return m_positions; }
  static constexpr bool positions_are_exact() { return true; }
  Traits::Point_2 point(Vertex_index image) const
  {
    return {m_positions[image].x, m_positions[image].y};
  }
  const Traits& traits() const { return m_traits; }

private:
  Position_vector m_positions;
  Uninitialized_vector<Index> m_points;
  Uninitialized_vector<Periodic_shift_2> m_shifts;
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
// cycle, and all areas sum up to that of the cell. Rounding cannot hide that faces cover the torus
// another number of times than once: the sum is a multiple of the cell's area. If a check fails
// there is no result, as for grids, whose ties are broken differently in different images.
//
// Threads share all work, except for the few images around the cell and the edges that these cut.
template <class Parts = Parallel_parts<Sequential_tag>>
class Torus_triangulator_2
{
  using Predicates = Vertex_predicates_2<Image_cloud_2>;
  using Image = Image_cloud_2::Image;

public:
  Torus_triangulator_2()
    : m_guibas_stolfi(Predicates(m_cloud), m_planar)
  {
  }
  Torus_triangulator_2(const Torus_triangulator_2&) = delete;
  Torus_triangulator_2& operator=(const Torus_triangulator_2&) = delete;

  // Inserting fewer points one by one is faster.
  static constexpr std::size_t min_points = 100;

  // False if there is no result.
  template <class Positions>
  bool run(const Torus_2& torus, const Positions& points)
  {
    return points.size() >= min_points && !torus.cell().is_slab() && make_cloud(torus, points) &&
           triangulate(points.size()) && glue(points.size()) && are_stars(points.size()) &&
           cover_once(torus);
  }

  // The result, which may be taken apart.
  Periodic_faces_2& faces() { return m_faces; }

  // Frees the memory of everything but the result.
  void release()
  {
    m_cloud.release();
    m_planar.release();
    m_order.release();
    Uninitialized_vector<Vertex_index>().swap(m_vertex_of_image);
    Uninitialized_vector<Vertex_index>().swap(m_wrapped);
    Uninitialized_vector<Face_index>().swap(m_face_numbers);
    std::vector<Open_halfedge>().swap(m_open);
  }

private:
  using Arrays = Halfedge_arrays_2;

  // Makes the wrapped points, and then images around the cell. False if these were too many.
  template <class Positions>
  bool make_cloud(const Torus_2& torus, const Positions& points)
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
    // room for a half more images than there are if points are evenly spread
    m_cloud.reserve(std::size_t(n * (1 + 3 * along_r) * (1 + 3 * along_t)));
    m_cloud.resize(points.size());
    std::vector<std::vector<Image>> around(Parts::number(points.size()));
    Parts::for_each(points.size(), [&](std::size_t part, std::size_t first, std::size_t beyond) {
      for (Index i = Index(first); i < beyond; ++i) {
        Position_2 m = short_torus.multiples(points[i]);
        const Periodic_shift_2 wrap{int(-std::floor(m.x)), int(-std::floor(m.y))};
        m = {m.x + wrap[0], m.y + wrap[1]};
        const Periodic_shift_2 k = combination(basis, wrap);
        const auto image = [&](int r_multiple, int t_multiple) {
          const Periodic_shift_2 shift = k + combination(basis, {r_multiple, t_multiple});
          return Image{torus.rounded({points[i], shift}), i, shift};
        };
        m_cloud.set(Vertex_index(i + 1), image(0, 0));
        const int u = side(m.x, along_r), v = side(m.y, along_t);
        if (u != 0)
          around[part].push_back(image(u, 0));
        if (v != 0)
          around[part].push_back(image(0, v));
        if (u != 0 && v != 0)
          around[part].push_back(image(u, v));
      }
    });
    return append(around);
  }

  // Appends these images. False if they are too many for the 32-bit numbers of the plane.
  bool append(const std::vector<std::vector<Image>>& around)
  {
    std::size_t next_number = m_cloud.size(), size = m_cloud.size();
    for (const auto& images : around)
      size += images.size();
    if (size > max_vertices)
      return false;
    m_cloud.resize(size - 1);
    for (const auto& images : around)
      for (const Image& image : images)
        m_cloud.set(Vertex_index(next_number++), image);
    return true;
  }

  // The direction, 1 or -1, in which a point has an image within the margin; 0 if in neither.
  static int side(double multiple, double margin)
  {
    return multiple < margin ? 1 : multiple > 1 - margin ? -1 : 0;
  }

  static Periodic_shift_2 combination(const std::array<Periodic_shift_2, 2>& basis,
                                      const Periodic_shift_2& k)
  {
    return {k[0] * basis[0][0] + k[1] * basis[1][0], k[0] * basis[0][1] + k[1] * basis[1][1]};
  }

  // False if two images are in one place.
  bool triangulate(std::size_t points)
  {
    const boost::counting_iterator<Index> first(1), beyond(Index(m_cloud.size()));
    m_order.template sort<Parts>(m_cloud.positions(), first, beyond);
    if (!m_order.template are_distinct<Parts>(
            [this](Index image, Index other) { return are_together(image, other); }))
      return false;
    number_vertices(points);
    m_guibas_stolfi.run(m_order);
    return true;
  }

  bool are_together(Index image, Index other) const
  {
    const Position_2 &p = m_cloud.positions()[image], &q = m_cloud.positions()[other];
    return p.x == q.x && p.y == q.y;
  }

  // Numbers the vertices in the spatial order of the wrapped points, which are the first images at
  // this time. Then numbers all images in spatial order.
  void number_vertices(std::size_t points)
  {
    m_faces.points.resize(points + 1);
    m_faces.points[infinite_index] = null_index;
    m_wrapped.resize(points + 1);
    Uninitialized_vector<Vertex_index> vertex_of_point(points);
    number_in_parts(
        m_order.size(), [&](std::size_t i) { return m_order[i] <= points; },
        [&](std::size_t i, Index number) {
          const Vertex_index v(number + 1);
          m_faces.points[v] = m_order[i] - 1;
          m_wrapped[v] = Vertex_index(i + 1);
          vertex_of_point[m_order[i] - 1] = v;
        });
    m_cloud.template arrange<Parts>(m_order);
    m_vertex_of_image.resize(m_cloud.size());
    Parts::for_each_element(m_order.size(), [&](std::size_t i) {
      const Vertex_index image(i + 1);
      m_vertex_of_image[image] = vertex_of_point[m_cloud.point_of(image)];
    });
  }

  // Numbers those i below `size` for which counts(i) is true: calls note(i, number). Returns how
  // many there are.
  template <class Predicate, class Note>
  static Index number_in_parts(std::size_t size, const Predicate& counts, const Note& note)
  {
    std::array<Index, Parts::max_parts> numbers;
    Parts::for_each(size, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      numbers[part] = 0;
      for (std::size_t i = first; i < beyond; ++i)
        numbers[part] += counts(i);
    });
    Index sum = 0;
    for (std::size_t part = 0; part < Parts::number(size); ++part)
      sum += std::exchange(numbers[part], sum);
    Parts::for_each(size, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      for (std::size_t i = first; i < beyond; ++i)
        if (counts(i))
          note(i, numbers[part]++);
    });
    return sum;
  }

  Vertex_index vertex(Vertex_index image) const { return m_vertex_of_image[image]; }
  bool is_wrapped(Vertex_index image) const { return m_wrapped[vertex(image)] == image; }

  // True for that translation of a face whose first corner is a wrapped point. The first corner has
  // the smallest vertex, and the smallest shift if several corners have that vertex.
  bool is_kept(Face_index planar_face) const
  {
    const Flat_halfedge_index h = Flat_faces_2::first_halfedge(planar_face);
    std::array<Vertex_index, 3> corners{m_planar.apex(h), m_planar.apex(h + 1),
                                        m_planar.apex(h + 2)};
    if (std::find(corners.begin(), corners.end(), infinite_index) != corners.end())
      return false;
    // the usual case, which needs no search for the first corner, whose branches are unpredictable
    const auto wrapped = std::count_if(corners.begin(), corners.end(),
                                       [this](Vertex_index image) { return is_wrapped(image); });
    if (wrapped == 0 || wrapped == 3)
      return wrapped == 3;
    const auto comes_before = [&](Vertex_index a, Vertex_index b) {
      return std::make_tuple(vertex(a), m_cloud.shift(a)) <
             std::make_tuple(vertex(b), m_cloud.shift(b));
    };
    return is_wrapped(*std::min_element(corners.begin(), corners.end(), comes_before));
  }

  // Copies the kept faces, and links them. False unless they are one face of each class.
  bool glue(std::size_t points)
  {
    if (number_faces() != 2 * points)
      return false;
    m_faces.twins.resize(6 * points);
    std::vector<std::vector<Open_halfedge>> open(Parts::number(m_planar.number_of_faces()));
    Parts::for_each(m_planar.number_of_faces(),
                    [&](std::size_t part, std::size_t first, std::size_t beyond) {
                      for (Face_index f(first); f < beyond; ++f)
                        for (Index i = 0; i < 3 && m_face_numbers[f] != null_index; ++i)
                          link(Flat_faces_2::first_halfedge(f) + i,
                               Arrays::halfedge_in(m_face_numbers[f], i), open[part]);
                    });
    m_open.clear();
    for (const auto& of_part : open)
      m_open.insert(m_open.end(), of_part.begin(), of_part.end());
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

  // Numbers and copies the kept faces. Returns their number.
  std::size_t number_faces()
  {
    const Index planar_faces = m_planar.number_of_faces();
    m_face_numbers.resize(planar_faces);
    Parts::for_each_element(planar_faces, [&](std::size_t i) {
      const Face_index f(i);
      m_face_numbers[f] = is_kept(f) ? Face_index(0) : null_index; // to be numbered, or not
    });
    const Index kept = number_in_parts(
        planar_faces, [&](std::size_t f) { return m_face_numbers[Face_index(f)] != null_index; },
        [&](std::size_t f, Index number) { m_face_numbers[Face_index(f)] = Face_index(number); });
    m_faces.apexes.resize(3 * std::size_t(kept));
    m_faces.shifts.resize(3 * std::size_t(kept));
    Parts::for_each_element(planar_faces, [&](std::size_t number) {
      const Face_index f(number);
      if (m_face_numbers[f] == null_index)
        return;
      const Flat_halfedge_index h = Flat_faces_2::first_halfedge(f);
      for (Index i = 0; i < 3; ++i) {
        const Vertex_index image = m_planar.apex(h + i);
        const Halfedge_index to = Arrays::halfedge_in(m_face_numbers[f], i);
        m_faces.apexes[to] = vertex(image);
        m_faces.shifts[to] = m_cloud.shift(image) - m_cloud.shift(m_planar.apex(h));
      }
    });
    return kept;
  }

  // A half-edge of a kept face whose twin in the plane belongs to a face that is not kept.
  struct Open_halfedge
  {
    Vertex_index from, to; // in ascending order
    Periodic_shift_2 shift;
    bool is_reversed;
    Halfedge_index halfedge;

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

  void link(Flat_halfedge_index planar, Halfedge_index h, std::vector<Open_halfedge>& open)
  {
    const Flat_halfedge_index twin = m_planar.twin(planar);
    const Face_index number = m_face_numbers[Flat_faces_2::face_of(twin)];
    if (number != null_index) {
      m_faces.twins[h] = Arrays::halfedge_in(number, Flat_faces_2::place_of(twin));
      return;
    }
    Vertex_index from = m_faces.apexes[Arrays::next(h)], to = m_faces.apexes[Arrays::previous(h)];
    Periodic_shift_2 shift = m_faces.shifts[Arrays::previous(h)] - m_faces.shifts[Arrays::next(h)];
    const bool is_reversed = from > to || (from == to && shift < no_shift);
    if (is_reversed) {
      std::swap(from, to);
      shift = no_shift - shift;
    }
    open.push_back({from, to, shift, is_reversed, h});
  }

  // Whether the corners of each vertex are one cycle. It does not matter from which of them a walk
  // starts: if there are several cycles, some corners are not met.
  bool are_stars(std::size_t points) const
  {
    const std::size_t corners = m_faces.apexes.size();
    std::vector<std::atomic<Index>> start(points + 1); // one of each vertex's corners, plus one
    Parts::for_each_element(corners, [&](std::size_t h) {
      start[m_faces.apexes[Halfedge_index(h)]].store(Index(h + 1), std::memory_order_relaxed);
    });
    return Parts::sum(points, [&](std::size_t first, std::size_t beyond) {
             std::size_t met = 0;
             for (Vertex_index v(first + 1); v <= beyond; ++v)
               met += size_of_cycle(v, start[v].load(std::memory_order_relaxed));
             return met;
           }) == corners;
  }

  // The number of corners of v that a walk around it meets. Zero if v has no corners, or the walk
  // meets corners of other vertices.
  std::size_t size_of_cycle(Vertex_index v, Index start) const
  {
    if (start == 0)
      return 0;
    std::size_t met = 0;
    Halfedge_index h(start - 1);
    do {
      h = Arrays::next(m_faces.twins[Arrays::next(h)]);
      if (m_faces.apexes[h] != v || ++met > m_faces.apexes.size())
        return 0;
    } while (h != start - 1);
    return met;
  }

  // Whether the faces cover the torus once.
  bool cover_once(const Torus_2& torus) const
  {
    std::array<double, Parts::max_parts> doubled_areas;
    const Index faces = m_planar.number_of_faces();
    Parts::for_each(faces, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      double sum = 0;
      for (Face_index f(first); f < beyond; ++f)
        if (m_face_numbers[f] != null_index)
          sum += doubled_area(Flat_faces_2::first_halfedge(f));
      doubled_areas[part] = sum;
    });
    const double sum = std::accumulate(
        doubled_areas.begin(), doubled_areas.begin() + std::ptrdiff_t(Parts::number(faces)), 0.);
    return std::abs(sum / torus.cell().area() - 2) < 0.5;
  }

  // Twice the area of the planar face that begins with half-edge h.
  double doubled_area(Flat_halfedge_index h) const
  {
    const Position_2& p = m_cloud.positions()[m_planar.apex(h)];
    const Position_2& q = m_cloud.positions()[m_planar.apex(h + 1)];
    const Position_2& s = m_cloud.positions()[m_planar.apex(h + 2)];
    return (q.x - p.x) * (s.y - p.y) - (q.y - p.y) * (s.x - p.x);
  }

  Image_cloud_2 m_cloud;
  Spatial_order_2 m_order;
  Flat_faces_2 m_planar;
  Guibas_stolfi_2<Predicates, Parts> m_guibas_stolfi;
  Uninitialized_column<Vertex_index, Vertex_index> m_vertex_of_image;
  // the image of each vertex's point in the cell
  Uninitialized_column<Vertex_index, Vertex_index> m_wrapped;
  Uninitialized_column<Face_index, Face_index> m_face_numbers; // of the planar faces that are kept
  std::vector<Open_halfedge> m_open;
  Periodic_faces_2 m_faces;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_2_H
