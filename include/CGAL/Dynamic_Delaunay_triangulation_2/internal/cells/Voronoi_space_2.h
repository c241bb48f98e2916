// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_SPACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_SPACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Vertex_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The other end of an edge, as seen from a point.
struct Voronoi_neighbor_2
{
  std::size_t id;
  Periodic_shift_2 shift; // 0 in the plane
  Position_2 vector;
};

// Vectors from a vertex to an image of another one, with a bound on how far those of a face are
// off, besides the rounding of one subtraction.
template <class Dynamic, bool = Dynamic::Frame::is_periodic>
class Image_vectors_2
{
  static_assert(Has_euclidean_circles_2<typename Dynamic::Geom_traits>::value,
                "these traits have circles of their own, and Voronoi cells are computed for the "
                "Euclidean ones");

public:
  explicit Image_vectors_2(const Dynamic& dt)
    : m_vector(dt)
  {
  }

  BOOST_FORCEINLINE Position_2 operator()(Vertex_index v, Vertex_index w, const Periodic_shift_2&) const
  {
    return m_vector(v, w);
  }
  static double error(Vertex_index, const Position_2&, const Periodic_shift_2&, const Position_2&,
                      const Periodic_shift_2&)
  {
    return 0;
  }

private:
  const Vertex_differences_2<Dynamic> m_vector;
};

template <class Dynamic>
class Image_vectors_2<Dynamic, true>
{
public:
  explicit Image_vectors_2(const Dynamic& dt)
    : m_positions(dt.frame().positions().data())
    , m_cell(dt.cell())
  {
  }

  // Rounded as in the triangulation.
  BOOST_FORCEINLINE Position_2 operator()(Vertex_index v, Vertex_index w, const Periodic_shift_2& shift) const
  {
    const Position_2 &p = m_positions[v], &q = m_positions[w];
    return {q.x - p.x + (times(shift[0], m_cell.ax()) + times(shift[1], m_cell.bx())),
            q.y - p.y + (times(shift[0], m_cell.ay()) + times(shift[1], m_cell.by()))};
  }

  // Of the face of v with the vectors to two images by the shifts s and t. With u = 2^-53, a
  // coordinate of a vector is computed from those of p, q and two products t with an error of less
  // than 4u (|p| + |q| + |t|), and each |q| is at most |p| + |t| + |v|, where v is the vector.
  double error(Vertex_index v, const Position_2& to_s, const Periodic_shift_2& s, const Position_2& to_t,
               const Periodic_shift_2& t) const
  {
    const auto sum = [](const Position_2& u) { return std::abs(u.x) + std::abs(u.y); };
    const double a = std::abs(m_cell.ax()) + std::abs(m_cell.ay());
    const double b = std::abs(m_cell.bx()) + std::abs(m_cell.by());
    return 0x1p-50 *
           (sum(m_positions[v]) + sum(to_s) + sum(to_t) +
            times(std::abs(s[0]) + std::abs(t[0]), a) + times(std::abs(s[1]) + std::abs(t[1]), b));
  }

private:
  // In an open direction the cell's vector means nothing, and shifts are 0.
  static double times(int number, double x) { return number == 0 ? 0 : number * x; }

  const Position_2* const m_positions; // of vertices
  const Periodic_cell_2& m_cell;
};

// A triangulation as Voronoi cells see it, in the plane and in periodic space. Cells are numbered
// as vertices are, in an order of space; points that coincide share one. Not every number is that
// of a cell. A cell is open, and so unbounded, if an edge at its point has a single face, or none.
template <class Dynamic>
class Voronoi_space_2
{
  using Frame = typename Dynamic::Frame;
  using Parts = typename Frame::Parts;
  using Arrays = Halfedge_arrays_2;

public:
  // Throws unless the triangulation is certified.
  explicit Voronoi_space_2(const Dynamic& dt)
    : m_frame(dt.frame())
    , m_vector(dt)
    , m_cells_of_part(number_of_cells() / number_of_face_parts() + 1)
  {
    if constexpr (Frame::is_periodic)
      check_certified(dt);
    else
      dt.triangulation();
  }

  Index number_of_ids() const { return m_frame.number_of_ids(); }
  bool has_id(std::size_t id) const { return m_frame.has_id(id); }
  bool is_representative(std::size_t id) const { return m_frame.id(m_frame.vertex(id)) == id; }
  Index number_of_cells() const { return m_frame.number_of_vertices() + 1; }
  Index cell(std::size_t id) const { return m_frame.vertex(id); }
  bool is_cell(Index c) const { return !m_frame.is_infinite(Vertex_index(c)); }
  std::size_t id_of_cell(Index c) const { return m_frame.id(Vertex_index(c)); }

  // As the point was given: in periodic space duplicates may be given by other images.
  Position_2 position(std::size_t id) const
  {
    if constexpr (Frame::is_periodic)
      return approximation(m_frame.state().point_of_id(Point_id(id)));
    else
      return m_frame.position(m_frame.vertex(id));
  }
  // From a point to an image of another one.
  Position_2 vector(std::size_t id, std::size_t other, const Periodic_shift_2& shift) const
  {
    return m_vector(m_frame.vertex(id), m_frame.vertex(other), shift);
  }

  template <class Function>
  void for_each_duplicate(const Function& f) const
  {
    m_frame.for_each_duplicate(f);
  }

  // Calls f(number, first, beyond) for parts of the ids, or of the cells.
  static std::size_t number_of_ranges(std::size_t size) { return Parts::number(size); }
  template <class Function>
  static void for_each_range(std::size_t size, const Function& f)
  {
    Parts::for_each(size, [&](std::size_t number, std::size_t first, std::size_t beyond) {
      f(number, Index(first), Index(beyond));
    });
  }

  // Threads share the parts of the faces. Each part has some of the cells, most of them around its
  // own faces.
  std::size_t number_of_face_parts() const
  {
    return Parts::number(m_frame.number_of_faces(), faces_of_part());
  }
  bool has_cell(std::size_t part, Index c) const
  {
    return c - part * m_cells_of_part < m_cells_of_part; // unsigned: false if c is smaller
  }

  // Calls f(part, cells, face).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    if (m_frame.state().spans_plane())
      Parts::for_each(m_frame.number_of_faces(), faces_of_part(),
                      [&](std::size_t part, std::size_t first, std::size_t beyond) {
                        for (std::size_t i = first; i < beyond; ++i)
                          call_with_face(part, Face_index(i), f);
                      });
  }

  // The cells of a torus are all closed. Those beside the gap of a slab are open.
  template <class Function>
  void for_each_open_cell(const Function& f) const
  {
    if constexpr (Frame::is_periodic) {
      if (!m_frame.state().torus().cell().is_slab())
        return;
      for (Face_index i(0); i < m_frame.number_of_faces(); ++i)
        if (is_open(i, m_frame.face(i)))
          for (const Vertex_index v : m_frame.face(i))
            f(v);
    } else if (m_frame.state().spans_plane())
      m_frame.for_each_neighbor(infinite_index, f);
    else
      for (Vertex_index v(1); v < number_of_cells(); ++v)
        f(v);
  }

  // Calls f(neighbor) counterclockwise.
  template <class Function>
  void for_each_neighbor(std::size_t id, const Function& f) const
  {
    const Vertex_index v = m_frame.vertex(id);
    m_frame.state().for_each_finite_neighbor(v, [&](Vertex_index w, const auto&... shift) {
      const Periodic_shift_2 its_shift{shift...};
      f(Voronoi_neighbor_2{m_frame.id(w), its_shift, m_vector(v, w, its_shift)});
    });
  }

  // Returns the face of a point and two neighbors, the second one left of the first, if any. Where
  // the cell is open, the angle between the neighbors is at least straight, so they make no face.
  std::optional<Voronoi_face_2> face(std::size_t id, const Voronoi_neighbor_2& right,
                                     const Voronoi_neighbor_2& left) const
  {
    const Position_2 last{-left.vector.x, -left.vector.y};
    const Voronoi_face_2 face(
        {vector(right.id, left.id, difference(left.shift, right.shift)), last, right.vector},
        m_vector.error(m_frame.vertex(id), right.vector, right.shift, last, left.shift));
    return face.is_flat() ? std::nullopt : std::optional<Voronoi_face_2>(face);
  }

private:
  // Fewer and larger parts have fewer faces between them.
  std::size_t faces_of_part() const
  {
    constexpr std::size_t max_parts = 32;
    return (std::max)(Parts::usual_size, std::size_t(m_frame.number_of_faces()) / max_parts);
  }

  // Whether face i, with the vertices v, is infinite or in the gap beside a slab.
  bool is_open(Face_index i, const std::array<Vertex_index, 3>& v) const
  {
    if constexpr (Frame::is_periodic)
      return m_frame.state().is_in_gap(i);
    else
      return std::any_of(v.begin(), v.end(), [](Vertex_index w) { return Frame::is_infinite(w); });
  }

  template <class Function>
  BOOST_FORCEINLINE void call_with_face(std::size_t part, Face_index i, const Function& f) const
  {
    const std::array<Vertex_index, 3> v = m_frame.state().arrays().face(i);
    if (is_open(i, v))
      return;
    Periodic_shift_2 s{0, 0}, t{0, 0};
    if constexpr (Frame::is_periodic) {
      const auto [h, k, l] = Arrays::halfedges_of(i);
      s = m_frame.state().shift_between(h, k);
      t = m_frame.state().shift_between(h, l);
    }
    const Position_2 first = m_vector(v[0], v[1], s),
                     second = m_vector(v[1], v[2], difference(t, s)),
                     last = m_vector(v[2], v[0], {-t[0], -t[1]});
    f(part, v, Voronoi_face_2({second, last, first}, m_vector.error(v[0], first, s, last, t)));
  }

  static Periodic_shift_2 difference(const Periodic_shift_2& s, const Periodic_shift_2& t)
  {
    return {s[0] - t[0], s[1] - t[1]};
  }

  const Frame m_frame;
  const Image_vectors_2<Dynamic> m_vector;
  const std::size_t m_cells_of_part;
};

// FACES AROUND A POINT ----------------------------------------------------------------------------

// Calls f(right, left, face) for each two consecutive neighbors of a point, counterclockwise. There
// is no face where the cell is open, or where rounding hides how flat the face is.
template <class Space, class Function>
void for_each_face_around(const Space& space, std::size_t id, const Function& f)
{
  std::optional<Voronoi_neighbor_2> first, last;
  space.for_each_neighbor(id, [&](const Voronoi_neighbor_2& next) {
    if (last)
      f(*last, next, space.face(id, *last, next));
    else
      first = next;
    last = next;
  });
  if (last)
    f(*last, *first, space.face(id, *last, *first));
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_VORONOI_SPACE_2_H
