// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_POINTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_POINTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The part of a checkpoint that is about points and their ids, in the plane, in periodic space, and
// in space.

// Writes all ids, and the coordinates of vertices, as `vertex_coordinates(v)`, and of covered
// points, as `coordinates(point)`.
template <class Point, class Vertex_coordinates, class Coordinates>
void write_points(Checkpoint_output_2& file, const Point_ids_2<Point>& ids,
                  const Vertex_coordinates& vertex_coordinates, const Coordinates& coordinates)
{
  file.line("ids", ids.number_of_ids());
  file.line("vertices", ids.number_of_representatives());
  for (Vertex_index v(1); v <= ids.number_of_representatives(); ++v)
    file.line(ids.representative(v), vertex_coordinates(v));
  file.line("duplicates", ids.number_of_covered());
  for (const Point_id id : ids.covered_ids())
    file.line(id, ids.vertex(id), coordinates(ids.covered_point(id)));
  file.line("free_ids", ids.number_of_ids() - ids.number_of_points());
  for (Point_id id(0); id < ids.number_of_ids(); ++id)
    if (!ids.is_taken(id))
      file.line(id);
}

// Reads the same. `Space` reads coordinates: `read_vertex()` adds a point to `points`,
// `read_point()` returns one, `coincide()` compares two, and `fewest_vertices()` and
// `most_vertices()` say how many there may be.
template <class Point, class Space>
class Checkpoint_points_reader_2
{
public:
  Checkpoint_points_reader_2(Checkpoint_input_2& file, Space& space, std::vector<Point>& points,
                             Point_ids_2<Point>& ids)
    : m_file(file)
    , m_space(space)
    , m_points(points)
    , m_kept_ids(ids)
  {
  }

  void read()
  {
    m_number_of_ids = m_file.number_entry("ids", Index(0), max_ids);
    read_vertices();
    read_covered();
    read_free_ids();
    check_ids();
    m_kept_ids.reset(m_number_of_ids);
    auto id = m_ids.begin();
    for (Index i = 0; i < number_of_vertices(); ++i)
      m_kept_ids.add_representative(*id++);
    for (const auto& [vertex, point] : m_covered)
      m_kept_ids.cover(*id++, vertex, point);
    m_kept_ids.finish_numbering();
  }

private:
  // Ids must be smaller than `null_index`. The limit for vertices is lower (`max_vertices`),
  // because Flat_faces_2 numbers eight half-edges per vertex.
  static constexpr Index max_ids = null_index - 1;

  Index number_of_vertices() const { return Index(m_points.size()); }

  void read_vertices()
  {
    const Index number =
        m_file.number_entry("vertices", m_space.fewest_vertices(), m_space.most_vertices());
    for (Vertex_index v(1); v <= number; ++v) {
      read_id();
      m_space.read_vertex();
      m_file.end_line();
    }
  }

  // Reads the id at the beginning of a line.
  void read_id()
  {
    m_file.next_line();
    if (m_number_of_ids == 0)
      m_file.refuse("a point is here, and there are no ids");
    m_ids.emplace_back(m_file.number("the id", Index(0), m_number_of_ids - 1));
  }

  void read_covered()
  {
    const Index number =
        m_file.number_entry("duplicates", Index(0), (std::min)(m_number_of_ids, max_vertices));
    if (number > 0 && number_of_vertices() == 0)
      m_file.refuse("there are duplicates, and no vertices");
    for (Index i = 0; i < number; ++i) {
      read_id();
      const Vertex_index vertex(m_file.number("the vertex", Index(1), number_of_vertices()));
      const Point p = m_space.read_point();
      m_file.end_line();
      if (!m_space.coincide(p, m_points[vertex - 1]))
        m_file.refuse("the duplicate is not where its vertex is");
      m_covered.emplace_back(vertex, p);
    }
  }

  void read_free_ids()
  {
    const std::size_t points = m_ids.size();
    const auto number = m_file.number_entry("free_ids", std::size_t(0), std::size_t(max_ids));
    if (points + number != m_number_of_ids)
      m_file.refuse("of " + std::to_string(m_number_of_ids) + " ids " + std::to_string(points) +
                    " are taken, and " + std::to_string(number) + " cannot be free");
    for (std::size_t i = 0; i < number; ++i) {
      read_id();
      m_file.end_line();
    }
  }

  // As many ids were read as there are, so it is enough that no id occurs twice.
  void check_ids() const
  {
    std::vector<bool> is_there(m_number_of_ids);
    for (const Point_id id : m_ids) {
      if (is_there[id])
        m_file.refuse("the id " + std::to_string(id) + " is there more than once, above");
      is_there[id] = true;
    }
  }

  Checkpoint_input_2& m_file;
  Space& m_space;
  std::vector<Point>& m_points;
  Point_ids_2<Point>& m_kept_ids;
  Index m_number_of_ids = 0;
  std::vector<Point_id> m_ids; // of representatives, then of covered points, then free ones
  std::vector<std::pair<Vertex_index, Point>> m_covered; // their vertices, and the points
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_POINTS_2_H
