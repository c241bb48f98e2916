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

// A triangulation as Voronoi cells see it, by the same functions in the plane and in periodic
// space. Cells have numbers; points that coincide share one. A cell is open, and so unbounded, if
// an edge at its point has a single face, or none.
template <class Dynamic, bool = Dynamic::Frame::is_periodic>
class Voronoi_space_2;

// The other end of an edge, as seen from a point.
struct Voronoi_neighbor_2
{
  std::size_t id;
  Periodic_shift_2 shift;
  Position_2 vector; // NaN to the infinite vertex, which has no id

  bool is_infinite() const { return std::isnan(vector.x); }
};

// What is alike in both spaces. Cells are numbered as vertices are, in an order of space. Not every
// number is that of a cell.
template <class Dynamic>
class Voronoi_cells_of_frame_2
{
protected:
  using Frame = typename Dynamic::Frame;
  using Parts = typename Frame::Parts;

public:
  Index number_of_ids() const { return m_frame.number_of_ids(); }
  bool has_id(std::size_t id) const { return m_frame.has_id(id); }
  bool is_representative(std::size_t id) const { return m_frame.id(m_frame.vertex(id)) == id; }
  Index number_of_cells() const { return m_frame.number_of_vertices() + 1; }
  Index cell(std::size_t id) const { return m_frame.vertex(id); }
  bool is_cell(Index c) const { return !m_frame.is_infinite(c); }
  std::size_t id_of_cell(Index c) const { return m_frame.id(c); }

  template <class Function>
  void for_each_duplicate(const Function& f) const
  {
    m_frame.for_each_duplicate(f);
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

  // Calls f(first, beyond) for parts of the ids, or of the cells.
  template <class Function>
  static void for_each_range(std::size_t size, const Function& f)
  {
    Parts::for_each(size, [&](std::size_t, std::size_t first, std::size_t beyond) {
      f(Index(first), Index(beyond));
    });
  }

protected:
  explicit Voronoi_cells_of_frame_2(const Frame& frame)
    : m_frame(frame)
    , m_cells_of_part(number_of_cells() / number_of_face_parts() + 1)
  {
  }

  // Calls f(part, i) for the number i of each face.
  template <class Function>
  void for_each_face_number(const Function& f) const
  {
    Parts::for_each(m_frame.number_of_faces(), faces_of_part(),
                    [&](std::size_t part, std::size_t first, std::size_t beyond) {
                      for (std::size_t i = first; i < beyond; ++i)
                        f(part, Index(i));
                    });
  }

  const Frame m_frame;

private:
  // Fewer and larger parts have fewer faces between them.
  std::size_t faces_of_part() const
  {
    constexpr std::size_t max_parts = 32;
    return (std::max)(Parts::usual_size, std::size_t(m_frame.number_of_faces()) / max_parts);
  }

  const std::size_t m_cells_of_part;
};

// THE PLANE ---------------------------------------------------------------------------------------

template <class Dynamic>
class Voronoi_space_2<Dynamic, false> : public Voronoi_cells_of_frame_2<Dynamic>
{
  using Base = Voronoi_cells_of_frame_2<Dynamic>;
  using Base::m_frame;
  static_assert(Has_euclidean_circles_2<typename Dynamic::Geom_traits>::value,
                "these traits have circles of their own, and Voronoi cells are computed for the "
                "Euclidean ones");

public:
  // Throws unless the triangulation is certified.
  explicit Voronoi_space_2(const Dynamic& dt)
    : Base(dt.frame())
    , m_dimension(dt.triangulation().dimension())
    , m_vector(dt)
  {
  }

  Position_2 position(std::size_t id) const { return m_frame.position(m_frame.vertex(id)); }

  // Calls f(part, cells, face).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    if (m_dimension == 2)
      this->for_each_face_number([&](std::size_t part, Index i) { call_with_face(part, i, f); });
  }

  template <class Function>
  void for_each_open_cell(const Function& f) const
  {
    if (m_dimension == 2)
      m_frame.for_each_neighbor(infinite_index, f);
    else
      for (Vertex_index v = 1; v < this->number_of_cells(); ++v)
        f(v);
  }

  // Calls f(neighbor) counterclockwise, also for the infinite vertex.
  template <class Function>
  void for_each_neighbor(std::size_t id, const Function& f) const
  {
    const Vertex_index v = m_frame.vertex(id);
    if (m_dimension == 2)
      m_frame.for_each_neighbor(v, [&](Vertex_index w) { f(neighbor(v, w)); });
    else
      m_frame.state().for_each_finite_neighbor(v, [&](Vertex_index w) { f(neighbor(v, w)); });
  }

  // Returns the face of a point and two neighbors, the second one left of the first, if any.
  std::optional<Voronoi_face_2> face(std::size_t, const Voronoi_neighbor_2& right,
                                     const Voronoi_neighbor_2& left) const
  {
    if (right.is_infinite() || left.is_infinite())
      return std::nullopt;
    const Voronoi_face_2 face({m_vector(m_frame.vertex(right.id), m_frame.vertex(left.id)),
                               Position_2{-left.vector.x, -left.vector.y}, right.vector});
    return face.is_flat() ? std::nullopt : std::optional<Voronoi_face_2>(face);
  }

private:
  template <class Function>
  BOOST_FORCEINLINE void call_with_face(std::size_t part, Index i, const Function& f) const
  {
    const std::array<Index, 3> v = m_frame.face(i);
    if (std::none_of(v.begin(), v.end(), [&](Vertex_index w) { return m_frame.is_infinite(w); }))
      f(part, v,
        Voronoi_face_2({m_vector(v[1], v[2]), m_vector(v[2], v[0]), m_vector(v[0], v[1])}));
  }

  Voronoi_neighbor_2 neighbor(Vertex_index v, Vertex_index w) const
  {
    if (m_frame.is_infinite(w))
      return {0, {0, 0}, m_frame.position(w)};
    return {m_frame.id(w), {0, 0}, m_vector(v, w)};
  }

  const int m_dimension;
  const Vertex_differences_2<Dynamic> m_vector;
};

// PERIODIC SPACE ----------------------------------------------------------------------------------

template <class Dynamic>
class Voronoi_space_2<Dynamic, true> : public Voronoi_cells_of_frame_2<Dynamic>
{
  using Base = Voronoi_cells_of_frame_2<Dynamic>;
  using Base::m_frame;

public:
  // Throws unless the triangulation is certified.
  explicit Voronoi_space_2(const Dynamic& dt)
    : Base(dt.frame())
    , m_cell(dt.cell())
  {
    check_certified(dt);
  }

  // As the point was given: duplicates may be given by other images.
  Position_2 position(std::size_t id) const
  {
    return approximation(m_frame.state().point_of_id(Index(id)));
  }

  // Calls f(part, cells, face).
  template <class Function>
  void for_each_face(const Function& f) const
  {
    this->for_each_face_number([&](std::size_t part, Index i) {
      if (!m_frame.state().is_in_gap(i))
        call_with_face(part, i, f);
    });
  }

  // The cells of a torus are all closed. Those beside the gap of a slab are open.
  template <class Function>
  void for_each_open_cell(const Function& f) const
  {
    if (!m_cell.is_slab())
      return;
    for (Face_index i = 0; i < m_frame.number_of_faces(); ++i)
      if (m_frame.state().is_in_gap(i))
        for (const Vertex_index v : m_frame.face(i))
          f(v);
  }

  // Calls f(neighbor) counterclockwise.
  template <class Function>
  void for_each_neighbor(std::size_t id, const Function& f) const
  {
    const Vertex_index v = m_frame.vertex(id);
    const Position_2 p = m_frame.position(v);
    m_frame.state().for_each_finite_neighbor(v, [&](Vertex_index w, const Periodic_shift_2& shift) {
      f(Voronoi_neighbor_2{m_frame.id(w), shift, vector(p, m_frame.position(w), shift)});
    });
  }

  // Returns the face of a point and two neighbors, the second one left of the first, if any. Across
  // an open side the angle between the neighbors is at least straight, so they make no face.
  std::optional<Voronoi_face_2> face(std::size_t id, const Voronoi_neighbor_2& right,
                                     const Voronoi_neighbor_2& left) const
  {
    const Position_2 last{-left.vector.x, -left.vector.y};
    const Position_2 opposite = vector(position_of_cell(right.id), position_of_cell(left.id),
                                       difference(left.shift, right.shift));
    const Voronoi_face_2 face(
        {opposite, last, right.vector},
        error(position_of_cell(id), right.vector, right.shift, last, left.shift));
    return face.is_flat() ? std::nullopt : std::optional<Voronoi_face_2>(face);
  }

private:
  template <class Function>
  BOOST_FORCEINLINE void call_with_face(std::size_t part, Face_index i, const Function& f) const
  {
    const auto [h, k, l] = Halfedge_arrays_2::halfedges_of(i);
    const std::array<Index, 3> v = m_frame.state().arrays().face(i);
    const Position_2 &p = m_frame.position(v[0]), &q = m_frame.position(v[1]),
                     &r = m_frame.position(v[2]);
    const Periodic_shift_2 s = m_frame.state().shift_between(h, k),
                           t = m_frame.state().shift_between(h, l);
    const Position_2 first = vector(p, q, s), second = vector(q, r, difference(t, s));
    const Position_2 last = vector(r, p, {-t[0], -t[1]});
    f(part, v, Voronoi_face_2({second, last, first}, error(p, first, s, last, t)));
  }

  Position_2 position_of_cell(std::size_t id) const { return m_frame.position(m_frame.vertex(id)); }

  static Periodic_shift_2 difference(const Periodic_shift_2& s, const Periodic_shift_2& t)
  {
    return {s[0] - t[0], s[1] - t[1]};
  }

  // In an open direction the cell's vector means nothing, and shifts are 0.
  static double times(int number, double x) { return number == 0 ? 0 : number * x; }

  // Rounded as in the triangulation.
  Position_2 vector(const Position_2& p, const Position_2& q, const Periodic_shift_2& shift) const
  {
    return {q.x - p.x + (times(shift[0], m_cell.ax()) + times(shift[1], m_cell.bx())),
            q.y - p.y + (times(shift[0], m_cell.ay()) + times(shift[1], m_cell.by()))};
  }

  // A bound for the rounding errors of a face's vectors. With u = 2^-53, a coordinate of a vector
  // is computed from those of p, q and two products t with an error of less than
  // 4u (|p| + |q| + |t|), and each |q| is at most |p| + |t| + |v|, where v is the vector.
  double error(const Position_2& p, const Position_2& v, const Periodic_shift_2& s,
               const Position_2& w, const Periodic_shift_2& t) const
  {
    const auto sum = [](const Position_2& u) { return std::abs(u.x) + std::abs(u.y); };
    const double a = std::abs(m_cell.ax()) + std::abs(m_cell.ay());
    const double b = std::abs(m_cell.bx()) + std::abs(m_cell.by());
    return 0x1p-50 * (sum(p) + sum(v) + sum(w) + times(std::abs(s[0]) + std::abs(t[0]), a) +
                      times(std::abs(s[1]) + std::abs(t[1]), b));
  }

  const Periodic_cell_2& m_cell;
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
