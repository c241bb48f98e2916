// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_GRADIENTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_GRADIENTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The gradients of an energy of bounded Voronoi cells, by positions and by radii: the forces on cells
in a model of tissue, with the opposite sign. The energy is any function of the areas of cells and
of the lengths of the pieces of their boundaries. It is given by its derivatives, a *weight* for
each area and for each piece.

For instance, the energy \f$\sum_i (A_i - 1)^2 + (P_i - 3.8)^2\f$ has the area weights
\f$2 (A_i - 1)\f$ and, for every piece of cell i, the length weight \f$2 (P_i - 3.8)\f$.

<b>How.</b> Every curve that bounds a cell moves in the direction of its normal \f$n\f$ when points
move: the bisector of a point in the origin and a neighbor at \f$d\f$ in a place \f$x\f$ by
\f$v = (x \cdot dp - (x - d) \cdot dp') / |d|\f$, a circle by \f$v = n \cdot dp + dr\f$, a wall not
at all. The area changes by the integral of \f$v\f$ over the boundary (Reynolds' transport theorem),
a length by the integral of curvature times \f$v\f$, and by the motion of its ends along it. A
corner of two curves moves by \f$w\f$ with \f$w \cdot n = v\f$ for both of them.

A length has no gradient where the curves at one of its ends are tangent: a contact that just begins
grows infinitely fast. Such a corner adds nothing if the curves are tangent but for rounding. A
contact between points with equal radii would end at the smaller circle if these differed, so there
is no gradient by one of them alone; the sum over all radii is the gradient by a common radius.

\sa `Bounded_voronoi_cells_2`
*/
class Bounded_voronoi_gradients_2
{
public:
  /// \name Types
  /// @{

  /// the type of ids.
  using size_type = std::size_t;
  /// a vector: two doubles, `x` and `y`.
  using Vector = Dynamic_Delaunay_triangulations_2::Position_2;
  /// the cells.
  using Cells = Bounded_voronoi_cells_2;

  /// @}
  /// \name Computation
  /// @{

  /// computes both gradients. `cells` must be those of `dt` in its present state; `area_weights`
  /// has an entry for each id, and `length_weights` one for each of `cells.pieces()`.
  ///
  /// If memory runs out, there are no gradients. Points that coincide have one cell: their
  /// representative gets the gradient for all of them together, and the others get 0. Removed ids
  /// have 0.
  ///
  /// Cost: linear.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \throws Point_count_error_2 if there are not as many weights as ids, or as pieces; nothing
  /// changes.
  /// \pre `cells.has_pieces()`
  template <class Dynamic>
  void compute(const Dynamic& dt, const Cells& cells, const std::vector<double>& area_weights,
               const std::vector<double>& length_weights)
  {
    CGAL_precondition(cells.has_pieces());
    const size_type ids = cells.areas().size();
    if (area_weights.size() != ids)
      throw Point_count_error_2(ids, area_weights.size());
    if (length_weights.size() != cells.pieces().size())
      throw Point_count_error_2(cells.pieces().size(), length_weights.size());
    const Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic> space(dt);
    find_weights_of_cells(space, area_weights);
    m_by_positions.reserve(ids);
    m_by_radii.reserve(ids); // nothing throws from here on
    m_by_positions.assign(ids, {0, 0});
    m_by_radii.assign(ids, 0);
    for (size_type id = 0; id < ids; ++id)
      if (cells.first_pieces()[id] < cells.first_pieces()[id + 1])
        add_cell(space, cells, id, length_weights);
  }

  /// @}
  /// \name Access
  /// @{

  /// the derivatives by the coordinates of each id.
  const std::vector<Vector>& by_positions() const { return m_by_positions; }
  /// the derivatives by the radius of each id.
  const std::vector<double>& by_radii() const { return m_by_radii; }

  /// @}

private:
  using Piece = Cells::Piece;
  using Side = Cells::Side;

  // A curve that bounds a cell: the bisector with a neighbor at `way` from the cell's point, the
  // circle around a point at `way` from it, or a wall.
  struct Curve
  {
    enum Kind { BISECTOR, CIRCLE, WALL } kind;
    size_type other;
    Vector way;
    Vector wall_normal;
  };

  // Points that coincide share the area equally, so the weight of their cell is the mean of theirs.
  template <class Space>
  void find_weights_of_cells(const Space& space, const std::vector<double>& weights)
  {
    m_by_positions.clear();
    m_by_radii.clear();
    m_weights.assign(space.number_of_cells(), 0);
    m_sharers.assign(space.number_of_cells(), 0);
    for (size_type id = 0; id < weights.size(); ++id)
      if (space.has_id(id)) {
        m_weights[space.cell(id)] += weights[id];
        ++m_sharers[space.cell(id)];
      }
  }

  template <class Space>
  static Curve curve(const Space& space, const Cells& cells, size_type id, const Piece& piece)
  {
    if (piece.angle > 0)
      return {Curve::CIRCLE, id, {0, 0}, {0, 0}};
    if (piece.side != Side::WALL)
      return {Curve::BISECTOR, piece.other, space.vector(id, piece.other, piece.shift), {0, 0}};
    const std::vector<Vector>& corners = cells.domain();
    const Vector &p = corners[piece.other],
                 &q = corners[piece.other + 1 < corners.size() ? piece.other + 1 : 0];
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    return {Curve::WALL, id, {0, 0}, {(q.y - p.y) / length, -(q.x - p.x) / length}};
  }

  // Returns the unit normal of a curve at the place x, relative to the cell's point.
  static Vector normal(const Curve& curve, const Vector& x)
  {
    const auto unit = [](const Vector& v) {
      const double length = std::hypot(v.x, v.y);
      return Vector{v.x / length, v.y / length};
    };
    switch (curve.kind) {
    case Curve::BISECTOR:
      return unit(curve.way);
    case Curve::CIRCLE:
      return unit({x.x - curve.way.x, x.y - curve.way.y});
    default:
      return curve.wall_normal;
    }
  }

  // Adds `factor` times the gradient of the velocity of a curve in x.
  void add_velocity(size_type id, const Curve& curve, const Vector& x, double factor)
  {
    const Vector n = normal(curve, x);
    if (curve.kind == Curve::BISECTOR) {
      const double scale = factor / std::hypot(curve.way.x, curve.way.y);
      add(id, scale, x);
      add(curve.other, -scale, {x.x - curve.way.x, x.y - curve.way.y});
    } else if (curve.kind == Curve::CIRCLE) {
      add(curve.other, factor, n);
      m_by_radii[curve.other] += factor;
    }
  }

  void add(size_type id, double factor, const Vector& v)
  {
    m_by_positions[id].x += factor * v.x;
    m_by_positions[id].y += factor * v.y;
  }

  // Adds the integral of the velocity over a piece.
  void add_integral(size_type id, const Curve& curve, const Piece& piece, const Vector& from,
                    const Vector& to, double factor)
  {
    if (curve.kind == Curve::BISECTOR)
      add_velocity(id, curve, {(from.x + to.x) / 2, (from.y + to.y) / 2}, factor * piece.length);
    else if (curve.kind == Curve::CIRCLE) {
      add(id, factor, {to.y - from.y, from.x - to.x});
      m_by_radii[id] += factor * piece.length;
    }
  }

  // Adds the gradient of the motion of a corner, where two curves meet, along `direction`.
  void add_corner(size_type id, const Curve& first, const Curve& second, const Vector& x,
                  const Vector& direction)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    constexpr double tangent = 1e-12;
    const Vector m = normal(first, x), n = normal(second, x);
    const double sine = cross(m, n);
    if (std::abs(sine) < tangent)
      return;
    add_velocity(id, first, x, dot(direction, {n.y, -n.x}) / sine);
    add_velocity(id, second, x, dot(direction, {-m.y, m.x}) / sine);
  }

  template <class Space>
  void add_cell(const Space& space, const Cells& cells, size_type id,
                const std::vector<double>& length_weights)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const double area_weight = m_weights[space.cell(id)] / m_sharers[space.cell(id)];
    const size_type first = cells.first_pieces()[id], beyond = cells.first_pieces()[id + 1];
    const Vector p = space.position(id);
    for (size_type i = first; i < beyond; ++i) {
      const size_type k = i + 1 < beyond ? i + 1 : first;
      const Piece &piece = cells.pieces()[i], &next = cells.pieces()[k];
      const Curve here = curve(space, cells, id, piece);
      const Vector from = piece.from - p, to = piece.to - p;
      const double weight = length_weights[i];
      const double curvature = here.kind == Curve::CIRCLE ? 1 / cells.radii()[id] : 0;
      add_integral(id, here, piece, from, to, area_weight + weight * curvature);
      if (i == k)
        continue; // a whole circle has no corner
      Curve there = curve(space, cells, id, next);
      const Vector along = turned_left(normal(here, to)),
                   along_next = turned_left(normal(there, to));
      // if the neighbor's circle ends a contact here, both pieces are on one bisector
      if (here.kind == Curve::BISECTOR && there.kind == Curve::BISECTOR &&
          piece.side != next.side && here.other == there.other && piece.shift == next.shift)
        there = {Curve::CIRCLE, here.other, here.way, {0, 0}};
      const double next_weight = length_weights[k];
      add_corner(id, here, there, to,
                 {weight * along.x - next_weight * along_next.x,
                  weight * along.y - next_weight * along_next.y});
    }
  }

  static Vector turned_left(const Vector& v) { return {-v.y, v.x}; }

  std::vector<Vector> m_by_positions;
  std::vector<double> m_by_radii;
  std::vector<double> m_weights, m_sharers; // of the cells
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_GRADIENTS_2_H
