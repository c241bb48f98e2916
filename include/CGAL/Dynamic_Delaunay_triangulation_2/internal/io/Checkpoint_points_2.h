// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_POINTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_POINTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Checkpoint_file_2.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The lines of points and their ids, which are the same in all spaces.

// `write_vertex(v)` writes the line of a vertex, and `coordinates(p)` returns what is written of a
// point that shares a vertex.
template <class Ids, class WriteVertex, class Coordinates>
void write_checkpoint_points(Checkpoint_output_2& file, const Ids& ids,
                             const WriteVertex& write_vertex, const Coordinates& coordinates)
{
  file.line("vertices", ids.number_of_representatives());
  for (Index v = 1; v <= ids.number_of_representatives(); ++v)
    write_vertex(v);
  file.line("duplicates", ids.duplicates().size());
  for (const auto& duplicate : ids.duplicates()) {
    const auto [x, y] = coordinates(duplicate.point);
    file.line(duplicate.id, ids.vertex(duplicate.id), x, y);
  }
  file.line("free_ids", ids.number_of_ids() - ids.number_of_points());
  for (Index id = 0; id < ids.number_of_ids(); ++id)
    if (!ids.is_taken(id))
      file.line(id);
}

// Reads them, and checks that each id occurs once.
template <class Point>
class Checkpoint_points_2
{
public:
  // The points of the vertices, and the ids, are written there.
  Checkpoint_points_2(Checkpoint_input_2& file, std::vector<Point>& points, Point_ids_2<Point>& ids)
    : m_file(file)
    , m_points(points)
    , m_kept_ids(ids)
  {
  }

  void read_number_of_ids() { m_number_of_ids = m_file.number_entry("ids", Index(0), max_ids); }

  // `read_vertex()` and `read_point()` read what follows the numbers in the line of a vertex, or of
  // a duplicate, and return the point; `coincide(p, q)` is whether they may share a vertex.
  template <class ReadVertex, class ReadPoint, class Coincide>
  void read(Index fewest, Index most, const ReadVertex& read_vertex, const ReadPoint& read_point,
            const Coincide& coincide)
  {
    read_vertices(fewest, most, read_vertex);
    read_duplicates(read_point, coincide);
    read_free_ids();
    check_ids();
    m_kept_ids.reset(m_number_of_ids);
    for (const Index id : m_ids)
      m_kept_ids.add_representative(id);
    for (const Duplicate& duplicate : m_duplicates)
      m_kept_ids.add_duplicate(duplicate.id, m_ids[duplicate.vertex - 1], duplicate.point);
    m_kept_ids.settle();
  }

private:
  // Ids must be smaller than `null_index`. The limit for vertices is lower (`max_vertices`),
  // because Flat_faces_2 numbers eight half-edges per vertex.
  static constexpr Index max_ids = null_index - 1;

  Index number_of_vertices() const { return Index(m_points.size()); }

  template <class ReadVertex>
  void read_vertices(Index fewest, Index most, const ReadVertex& read_vertex)
  {
    const Index number = m_file.number_entry("vertices", fewest, most);
    for (Index v = 1; v <= number; ++v) {
      const Index id = read_id();
      const Point p = read_vertex();
      m_file.end_line();
      m_ids.push_back(id);
      m_points.push_back(p);
    }
  }

  // Reads the id at the beginning of a line.
  Index read_id()
  {
    m_file.next_line();
    if (m_number_of_ids == 0)
      m_file.refuse("a point is here, and there are no ids");
    return m_file.number("the id", Index(0), m_number_of_ids - 1);
  }

  template <class ReadPoint, class Coincide>
  void read_duplicates(const ReadPoint& read_point, const Coincide& coincide)
  {
    const Index number = m_file.number_entry("duplicates", Index(0), m_number_of_ids);
    if (number > 0 && number_of_vertices() == 0)
      m_file.refuse("there are duplicates, and no vertices");
    for (Index i = 0; i < number; ++i) {
      const Index id = read_id();
      const Index vertex = m_file.number("the vertex", Index(1), number_of_vertices());
      const Point p = read_point();
      m_file.end_line();
      if (!coincide(p, m_points[vertex - 1]))
        m_file.refuse("the duplicate is not where its vertex is");
      m_duplicates.push_back({id, vertex, p});
    }
  }

  void read_free_ids()
  {
    const std::size_t points = m_ids.size() + m_duplicates.size();
    const auto number = m_file.number_entry("free_ids", std::size_t(0), std::size_t(max_ids));
    if (points + number != m_number_of_ids)
      m_file.refuse("of " + std::to_string(m_number_of_ids) + " ids " + std::to_string(points) +
                    " are taken, and " + std::to_string(number) + " cannot be free");
    for (std::size_t i = 0; i < number; ++i) {
      m_free_ids.push_back(read_id());
      m_file.end_line();
    }
  }

  // As many ids were read as there may be, so it is enough that each occurs once.
  void check_ids() const
  {
    std::vector<bool> is_there(m_number_of_ids);
    const auto check = [&](Index id) {
      if (is_there[id])
        m_file.refuse("the id " + std::to_string(id) + " is there more than once, above");
      is_there[id] = true;
    };
    std::for_each(m_ids.begin(), m_ids.end(), check);
    for (const Duplicate& duplicate : m_duplicates)
      check(duplicate.id);
    std::for_each(m_free_ids.begin(), m_free_ids.end(), check);
  }

  struct Duplicate
  {
    Index id, vertex;
    Point point;
  };

  Checkpoint_input_2& m_file;
  std::vector<Point>& m_points;
  Point_ids_2<Point>& m_kept_ids;
  Index m_number_of_ids = 0;
  std::vector<Index> m_ids; // of the representatives
  std::vector<Duplicate> m_duplicates;
  std::vector<Index> m_free_ids;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_CHECKPOINT_POINTS_2_H
