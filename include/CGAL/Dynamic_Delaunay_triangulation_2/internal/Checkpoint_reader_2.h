// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_READER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_READER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Checkpoint_file_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Repair_costs_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_builder_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Checks whether faces, given by their vertices alone, form a triangulated sphere without doubled
// edges, and links neighboring faces. They do if
//   - each edge has two faces, which run along it in opposite directions,
//   - the faces at each vertex form one cycle,
//   - all faces are connected, and
//   - there are two faces fewer than twice as many as finite vertices (Euler's formula).
class Sphere_check_2
{
public:
  // What is wrong, and at which face. `what` is null if nothing is.
  struct Flaw
  {
    const char* what = nullptr;
    Index face = 0;
  };

  // `vertices` counts the infinite vertex, too.
  Sphere_check_2(Flat_faces_2& faces, Index vertices)
    : m_faces(faces)
    , m_vertices(vertices)
  {
  }

  // Links the faces, and returns the first flaw.
  Flaw run()
  {
    sort_halfedges();
    Flaw flaw = link();
    if (!flaw.what)
      flaw = check_vertices();
    if (!flaw.what)
      flaw = check_connection();
    return flaw;
  }

private:
  static Flaw flaw_at(Index halfedge, const char* what)
  {
    return {what, Flat_faces_2::number_in_mirror(halfedge) / 3};
  }

  template <class Function>
  void for_each_halfedge(const Function& f) const
  {
    for (Index face = 0; face < m_faces.number_of_faces(); ++face)
      for (Index i = 0; i < 3; ++i)
        f(Flat_faces_2::first_halfedge(face) + i);
  }

  // Sorts by sources.
  void sort_halfedges()
  {
    m_first.assign(m_vertices + std::size_t(1), 0);
    for_each_halfedge([this](Index h) { ++m_first[m_faces.source(h)]; });
    for (Index v = 0; v < m_vertices; ++v)
      m_first[v + 1] += m_first[v];
    m_sorted.resize(m_first[m_vertices]);
    for_each_halfedge([this](Index h) { m_sorted[--m_first[m_faces.source(h)]] = h; });
  }

  template <class Function>
  void for_each_halfedge_from(Index v, const Function& f) const
  {
    for (Index i = m_first[v]; i < m_first[v + 1]; ++i)
      f(m_sorted[i]);
  }

  Flaw link()
  {
    Flaw flaw;
    std::vector<Index> halfedge_to(m_vertices, no_index); // from v to each vertex
    for (Index v = 0; v < m_vertices; ++v) {
      for_each_halfedge_from(v, [&](Index h) {
        Index& there = halfedge_to[m_faces.target(h)];
        if (m_faces.target(h) == v)
          flaw = flaw_at(h, "the face has a vertex twice");
        else if (there != no_index)
          flaw = flaw_at(h, "an edge of the face is there twice");
        there = h;
      });
      for_each_halfedge_from(v, [&](Index h) {
        const Index arriving = Flat_faces_2::previous(h);
        const Index back = halfedge_to[m_faces.source(arriving)];
        if (back == no_index)
          flaw = flaw_at(h, "an edge of the face has no other face");
        m_faces.set_twin(arriving, back);
      });
      for_each_halfedge_from(v, [&](Index h) { halfedge_to[m_faces.target(h)] = no_index; });
      if (flaw.what)
        return flaw;
    }
    return flaw;
  }

  Flaw check_vertices() const
  {
    for (Index v = 0; v < m_vertices; ++v) {
      const Index degree = m_first[v + 1] - m_first[v];
      if (degree == 0)
        return {"a vertex is in no face", m_faces.number_of_faces() - 1};
      const Index start = m_sorted[m_first[v]];
      Index around = 0, h = start;
      do {
        h = m_faces.twin(Flat_faces_2::previous(h));
        ++around;
      } while (h != start);
      if (around != degree)
        return flaw_at(start, "the faces at a vertex of the face are not one cycle");
    }
    return {};
  }

  Flaw check_connection() const
  {
    std::vector<bool> is_reached(m_faces.number_of_faces());
    std::vector<Index> waiting(1, 0);
    is_reached[0] = true;
    while (!waiting.empty()) {
      const Index h = Flat_faces_2::first_halfedge(waiting.back());
      waiting.pop_back();
      for (Index i = 0; i < 3; ++i) {
        const Index f = Flat_faces_2::number_in_mirror(m_faces.twin(h + i)) / 3;
        if (!is_reached[f])
          waiting.push_back(f);
        is_reached[f] = true;
      }
    }
    for (Index f = 0; f < m_faces.number_of_faces(); ++f)
      if (!is_reached[f])
        return {"the face hangs together with the first one by no edges", f};
    return {};
  }

  Flat_faces_2& m_faces;
  Index m_vertices;
  std::vector<Index> m_first;  // index in m_sorted of the first half-edge from each vertex
  std::vector<Index> m_sorted; // the half-edges by their sources
};

// Reads a triangulation that Checkpoint_writer_2 has written. Every value is validated before it is
// used, and memory is allocated only for what was read, whatever numbers the file announces.
template <class Maintained>
class Checkpoint_reader_2
{
  using Point = typename Maintained::Point;
  using FT = std::decay_t<decltype(std::declval<Point>().x())>;
  using Coordinate = Checkpoint_coordinate_2<FT>;
  static_assert(is_made_of_x_and_y<Point>,
                "a checkpoint keeps x and y, which are not all of these points");

public:
  explicit Checkpoint_reader_2(Checkpoint_input_2& file)
    : m_file(file)
  {
  }

  // Reads into an empty triangulation, which can only be discarded if this throws.
  void read(Maintained& maintained)
  {
    read_head();
    read_points();
    if (m_dimension == 2)
      read_topology();
    else
      check_line(maintained);
    Topology_builder_2<Maintained>(maintained).restore(m_kept);
    if (m_is_certified && m_dimension == 2 && !Certificate_2<Maintained>(maintained).holds())
      m_file.refuse(m_certified_line, "the triangulation is not Delaunay, and cannot be certified");
  }

  bool is_certified() const { return m_is_certified; }
  const Repair_experience_2& experience() const { return m_experience; }

private:
  // Ids must be smaller than `no_index`. The limit for vertices is lower (`max_vertices`), because
  // Flat_faces_2 numbers eight half-edges per vertex.
  static constexpr Index max_ids = no_index - 1;

  // Reads a word that must be `yes` or `no`, and returns whether it is `yes`.
  bool flag(const char* name, std::string_view yes, std::string_view no)
  {
    const std::string_view value = m_file.entry(name);
    if (value != yes && value != no)
      m_file.refuse(std::string(name) + " is " + Checkpoint_input_2::quoted(value) +
                    ", and has to be " + std::string(yes) + " or " + std::string(no));
    return value == yes;
  }

  void read_head()
  {
    const std::string_view kind = m_file.entry("coordinates");
    if (kind != Coordinate::kind)
      m_file.refuse("the coordinates are of the kind " + Checkpoint_input_2::quoted(kind) +
                    ", and those of the triangulation's points of the kind " +
                    Checkpoint_input_2::quoted(Coordinate::kind));
    m_kept.positions_are_exact = flag("positions", "exact", "rounded");
    if (Maintained::coordinates_are_doubles && !m_kept.positions_are_exact)
      m_file.refuse("doubles are exact, and cannot be rounded");
    m_is_certified = flag("certified", "yes", "no");
    m_certified_line = m_file.line();
    m_experience.restore(
        m_file.number_entry("hopeless_share", std::size_t(1), Repair_experience_2::all));
    m_dimension = m_file.number_entry("dimension", -1, 2);
    if (m_dimension < 2 && !m_is_certified)
      m_file.refuse("in this dimension the triangulation has to be certified");
    m_number_of_ids = m_file.number_entry("ids", Index(0), max_ids);
  }

  // POINTS --------------------------------------------------------------------------------------

  void read_points()
  {
    read_vertices();
    read_duplicates();
    read_free_ids();
    check_ids();
    m_kept.ids.reset(m_number_of_ids);
    for (Index v = 1; v <= number_of_vertices(); ++v)
      m_kept.ids.add_representative(m_ids[v - 1]);
    for (const Duplicate& duplicate : m_duplicates)
      m_kept.ids.add_duplicate(duplicate.id, m_ids[duplicate.vertex - 1], duplicate.point);
    m_kept.ids.settle();
  }

  Index number_of_vertices() const { return Index(m_kept.points.size()); }

  void read_vertices()
  {
    constexpr std::array<Index, 4> fewest{0, 1, 2, 3}, most{0, 1, max_vertices, max_vertices};
    const std::size_t i = std::size_t(m_dimension + 1);
    const Index number = m_file.number_entry("vertices", fewest[i], most[i]);
    for (Index v = 1; v <= number; ++v) {
      const Index id = read_id();
      const Point p = read_point();
      const Position_2 position = read_position(p);
      m_file.end_line();
      m_ids.push_back(id);
      m_kept.points.push_back(p);
      m_kept.positions.push_back(position);
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

  Point read_point()
  {
    FT x = read_coordinate("the first coordinate");
    FT y = read_coordinate("the second coordinate");
    return Point(x, y);
  }

  FT read_coordinate(const char* name)
  {
    const std::string_view text = m_file.word(name);
    FT x;
    if (!Coordinate::read(text, x) || !is_within_limit(CGAL::to_double(x)))
      m_file.refuse(std::string(name) + " is " + Checkpoint_input_2::quoted(text) +
                    ", and has to be " + Coordinate::meaning + ", not too large for a double");
    return x;
  }

  Position_2 read_position(const Point& p)
  {
    if constexpr (Maintained::coordinates_are_doubles)
      return {p.x(), p.y()};
    else
      return {read_rounded("the first coordinate as a double", p.x()),
              read_rounded("the second coordinate as a double", p.y())};
  }

  double read_rounded(const char* name, const FT& x)
  {
    const double rounded = m_file.finite(name);
    if (m_kept.positions_are_exact ? FT(rounded) != x : !is_near(rounded, CGAL::to_double(x)))
      m_file.refuse(std::string(name) + " is something else than that");
    return rounded;
  }

  // Whether `rounded` may be x rounded to a double. CGAL promises five correct digits.
  static bool is_near(double rounded, double x)
  {
    constexpr double error = 1e-3;
    return std::abs(rounded - x) <= error * std::abs(x) + (std::numeric_limits<double>::min)();
  }

  struct Duplicate
  {
    Index id, vertex;
    Point point;
  };

  void read_duplicates()
  {
    const Index number = m_file.number_entry("duplicates", Index(0), m_number_of_ids);
    if (number > 0 && number_of_vertices() == 0)
      m_file.refuse("there are duplicates, and no vertices");
    for (Index i = 0; i < number; ++i) {
      const Index id = read_id();
      const Index vertex = m_file.number("the vertex", Index(1), number_of_vertices());
      const Point p = read_point();
      m_file.end_line();
      if (p != m_kept.points[vertex - 1])
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

  // Checks that the points are distinct and collinear.
  void check_line(const Maintained& maintained) const
  {
    const auto& traits = maintained.traits();
    std::vector<Point> points = m_kept.points;
    std::sort(points.begin(), points.end(), traits.less_xy_2_object());
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i - 1] == points[i])
        m_file.refuse("two vertices are in the same place, above");
      if (traits.orientation_2_object()(points.front(), points[i], points.back()) != COLLINEAR)
        m_file.refuse("the points above span the plane, and the dimension is less than 2");
    }
  }

  // TOPOLOGY ------------------------------------------------------------------------------------

  void read_topology()
  {
    read_faces();
    read_corners();
    read_edges();
  }

  // By Euler's formula.
  Index number_of_faces() const { return 2 * number_of_vertices() - 2; }
  Index number_of_halfedges() const { return 3 * number_of_faces(); }
  Index number_of_edges() const { return number_of_halfedges() / 2; }

  void read_faces()
  {
    m_file.number_entry("faces", number_of_faces(), number_of_faces());
    const std::size_t first_line = m_file.line() + 1;
    Flat_faces_2& faces = m_kept.faces;
    for (Index f = 0; f < number_of_faces(); ++f) {
      m_file.next_line();
      faces.resize(f + std::size_t(1));
      for (Index i = 0; i < 3; ++i)
        faces.set_apex(Flat_faces_2::first_halfedge(f) + i,
                       m_file.number("the vertex", Index(0), number_of_vertices()));
      m_file.end_line();
    }
    const Sphere_check_2::Flaw flaw = Sphere_check_2(faces, number_of_vertices() + 1).run();
    if (flaw.what)
      m_file.refuse(first_line + flaw.face, flaw.what);
  }

  void read_corners()
  {
    const Index number = number_of_vertices() + 1;
    m_file.number_entry("corners", number, number);
    for (Index v = 0; v < number; ++v) {
      m_file.next_line();
      const Index h = read_halfedge();
      const Index f = m_file.number("the face", Index(0), number_of_faces() - 1);
      m_file.end_line();
      if (m_kept.faces.apex(flat(h)) != v || !has_vertex(f, v))
        m_file.refuse("these are no corner and no face of vertex " + std::to_string(v));
      m_kept.corners.push_back({h, f});
    }
  }

  void read_edges()
  {
    m_file.number_entry("edges", number_of_edges(), number_of_edges());
    std::vector<bool> has_edge(number_of_halfedges());
    for (Index e = 0; e < number_of_edges(); ++e) {
      m_file.next_line();
      const Index forward = read_halfedge();
      const Index halfedge = read_halfedge();
      m_file.end_line();
      const Index twin = Flat_faces_2::number_in_mirror(m_kept.faces.twin(flat(forward)));
      if (halfedge != forward && halfedge != twin)
        m_file.refuse("these are half-edges of two edges");
      if (has_edge[forward])
        m_file.refuse("this edge is there more than once");
      has_edge[forward] = has_edge[twin] = true;
      m_kept.edges.push_back({forward, halfedge});
    }
  }

  Index read_halfedge()
  {
    return m_file.number("the half-edge", Index(0), number_of_halfedges() - 1);
  }

  static Index flat(Index h) { return Flat_faces_2::first_halfedge(h / 3) + h % 3; }

  bool has_vertex(Index face, Index v) const
  {
    const Index h = Flat_faces_2::first_halfedge(face);
    return m_kept.faces.apex(h) == v || m_kept.faces.apex(h + 1) == v ||
           m_kept.faces.apex(h + 2) == v;
  }

  Checkpoint_input_2& m_file;
  int m_dimension = -1;
  bool m_is_certified = false;
  Repair_experience_2 m_experience;
  std::size_t m_certified_line = 0;
  Index m_number_of_ids = 0;
  std::vector<Index> m_ids; // of the representatives
  std::vector<Duplicate> m_duplicates;
  std::vector<Index> m_free_ids;
  Checkpoint_arrays_2<Point> m_kept;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_READER_2_H
