// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_POLYGONAL_DOMAIN_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_POLYGONAL_DOMAIN_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Decimal_number.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Exact_lines_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A polygon with holes, in triangles: a constrained triangulation of its convex hull, whose faces
// know whether they are inside. All vertices are corners of the polygon. Corners are numbered along
// the outer boundary first, and then along one hole after the other. A wall has the number of its
// first corner.
class Polygonal_domain_2
{
public:
  static constexpr std::size_t none = std::size_t(-1);
  using Ring = std::vector<Position_2>;

  // Edge i is opposite to vertex i.
  struct Face_info
  {
    std::size_t number = none;
    bool is_inside = false;
    std::array<std::size_t, 3> walls{none, none, none};
    std::array<Position_2, 3> normals{}; // of the edges, outward
  };

  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Triangulation = Constrained_Delaunay_triangulation_2<
      Kernel, Triangulation_data_structure_2<
                  Triangulation_vertex_base_with_info_2<std::size_t, Kernel>,
                  Triangulation_face_base_with_info_2<
                      Face_info, Kernel, Constrained_triangulation_face_base_2<Kernel>>>>;
  using Face_handle = Triangulation::Face_handle;
  using Vertex_handle = Triangulation::Vertex_handle;

  // Throws Domain_error_2 unless each ring is simple, and the holes are inside of the first one and
  // outside of each other.
  explicit Polygonal_domain_2(const std::vector<Ring>& rings)
  {
    insert_corners(rings);
    for_each_wall(rings, [&](std::size_t wall, Vertex_handle v, Vertex_handle w, bool) {
      insert_wall(wall, v, w);
    });
    number_faces();
    for_each_wall(rings, [&](std::size_t wall, Vertex_handle v, Vertex_handle w, bool) {
      name_wall(wall, v, w);
    });
    const std::vector<int> depths = find_depths();
    for_each_wall(rings, [&](std::size_t wall, Vertex_handle v, Vertex_handle w, bool is_outer) {
      check_sides(wall, v, w, is_outer ? 1 : 2, depths);
    });
  }

  // Not copied, because m_corners points into the triangulation.
  Polygonal_domain_2(const Polygonal_domain_2&) = delete;
  Polygonal_domain_2& operator=(const Polygonal_domain_2&) = delete;

  std::size_t number_of_faces() const { return m_number_of_faces; }
  bool is_infinite(Face_handle face) const { return m_triangulation.is_infinite(face); }
  Vertex_handle infinite_vertex() const { return m_triangulation.infinite_vertex(); }

  // Returns a face inside that contains p, perhaps on its boundary; if there is none, a face that
  // contains p, perhaps an infinite one. Walks from face `last`, and updates it.
  Face_handle locate(const Point& p, Face_handle& last) const
  {
    Triangulation::Locate_type type;
    int i;
    last = m_triangulation.locate(p, type, i, last);
    if (last->info().is_inside)
      return last;
    if (type == Triangulation::EDGE && last->neighbor(i)->info().is_inside)
      return last->neighbor(i);
    if (type == Triangulation::VERTEX) {
      const auto first = m_triangulation.incident_faces(last->vertex(i));
      auto face = first;
      do
        if (face->info().is_inside)
          return face;
      while (++face != first);
    }
    return last;
  }

  // The distance of edge i from p, negative if p is beyond. Both faces of an edge give the same
  // result up to the sign.
  static double distance(const Position_2& p, Face_handle face, int i)
  {
    return dot(face->info().normals[std::size_t(i)], corner(first_end(face, i)) - p);
  }
  static Position_2 corner(Vertex_handle v) { return {v->point().x(), v->point().y()}; }

  Surroundings_2 surroundings() const { return {m_least, m_most}; }

private:
  void insert_corners(const std::vector<Ring>& rings)
  {
    std::size_t number = 0;
    for (const Ring& ring : rings) {
      if (ring.size() < 3)
        throw Domain_error_2(number, "a closed line of walls has at least three corners");
      for (const Position_2& p : ring) {
        check_domain_corner(number, p, rings[0][0]);
        insert_corner(p);
        ++number;
      }
    }
  }

  void insert_corner(const Position_2& p)
  {
    const std::size_t number = m_corners.size();
    const Face_handle hint = m_corners.empty() ? Face_handle() : m_corners.back()->face();
    const Vertex_handle v = m_triangulation.insert(Point(p.x, p.y), hint);
    if (m_triangulation.number_of_vertices() == number)
      throw Domain_error_2(number, message_text("it is where corner ", v->info(), " is"));
    v->info() = number;
    m_corners.push_back(v);
    if (number == 0)
      m_least = m_most = p;
    m_least = {(std::min)(m_least.x, p.x), (std::min)(m_least.y, p.y)};
    m_most = {(std::max)(m_most.x, p.x), (std::max)(m_most.y, p.y)};
  }

  // Calls f(wall, from, to, is_outer).
  template <class Function>
  void for_each_wall(const std::vector<Ring>& rings, const Function& f) const
  {
    std::size_t first = 0;
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        f(first + i, m_corners[first + i], m_corners[first + (i + 1) % ring.size()], first == 0);
      first += ring.size();
    }
  }

  void insert_wall(std::size_t wall, Vertex_handle v, Vertex_handle w)
  {
    try {
      m_triangulation.insert_constraint(v, w);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      throw Domain_error_2(wall, "the wall after it crosses another one");
    }
    if (!m_triangulation.is_edge(v, w))
      throw Domain_error_2(wall, "the wall after it touches another corner");
  }

  void number_faces()
  {
    for (const Face_handle face : m_triangulation.all_face_handles()) {
      face->info().number = m_number_of_faces++;
      for (int i = 0; i < 3; ++i)
        if (!m_triangulation.is_infinite(face, i))
          face->info().normals[std::size_t(i)] = normal(face, i);
    }
  }

  // Of two ends of an edge, the one with the smaller number.
  static Vertex_handle first_end(Face_handle face, int i)
  {
    const Vertex_handle v = face->vertex(Triangulation::ccw(i)),
                        w = face->vertex(Triangulation::cw(i));
    return v->info() < w->info() ? v : w;
  }

  // The outward normal. Both faces of an edge have the same one up to the sign.
  static Position_2 normal(Face_handle face, int i)
  {
    const Vertex_handle from = face->vertex(Triangulation::ccw(i)),
                        to = face->vertex(Triangulation::cw(i));
    const Position_2 way = corner(to) - corner(from);
    const double length = std::hypot(way.x, way.y);
    return {way.y / length, -way.x / length};
  }

  void name_wall(std::size_t wall, Vertex_handle v, Vertex_handle w)
  {
    const auto [face, i] = edge(v, w);
    face->info().walls[std::size_t(i)] = wall;
    const Face_handle other = face->neighbor(i);
    other->info().walls[std::size_t(other->index(face))] = wall;
  }

  std::pair<Face_handle, int> edge(Vertex_handle v, Vertex_handle w) const
  {
    Face_handle face;
    int i = 0;
    m_triangulation.is_edge(v, w, face, i);
    return {face, i};
  }

  // Returns how many walls are around each face, and marks the faces inside.
  std::vector<int> find_depths()
  {
    std::vector<int> depths(m_number_of_faces, -1);
    std::vector<Face_handle> here{m_triangulation.infinite_face()}, deeper;
    for (int depth = 0; !here.empty(); ++depth) {
      while (!here.empty()) {
        const Face_handle face = here.back();
        here.pop_back();
        int& its_depth = depths[face->info().number];
        if (its_depth != -1)
          continue;
        its_depth = depth;
        face->info().is_inside = depth == 1;
        for (int i = 0; i < 3; ++i)
          if (depths[face->neighbor(i)->info().number] == -1)
            (face->is_constrained(i) ? deeper : here).push_back(face->neighbor(i));
      }
      here.swap(deeper);
    }
    return depths;
  }

  void check_sides(std::size_t wall, Vertex_handle v, Vertex_handle w, int depth,
                   const std::vector<int>& depths) const
  {
    const auto [face, i] = edge(v, w);
    const int here = depths[face->info().number];
    const int there = depths[face->neighbor(i)->info().number];
    if ((std::max)(here, there) != depth || (std::min)(here, there) != depth - 1)
      throw Domain_error_2(wall, depth == 1 ? "it is inside of a hole"
                                            : "a hole must be inside of the outer boundary, and "
                                              "outside of the others");
  }

  Triangulation m_triangulation;
  std::vector<Vertex_handle> m_corners;
  std::size_t m_number_of_faces = 0;
  Position_2 m_least{0, 0}, m_most{0, 0};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_POLYGONAL_DOMAIN_2_H
