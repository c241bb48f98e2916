// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_GRADIENTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_GRADIENTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <boost/config.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

How areas and perimeters of the points' Voronoi cells change when the points move: the forces of
models whose energy depends on these, such as that of Bi, Yang, Marchetti and Manning
(*Motility-driven glass and jamming transitions in biological tissues*, Physical Review X 6, 021011,
2016), whose appendix derives them from the derivatives of circumcenters.

Let \f$A_i\f$ and \f$P_i\f$ be the area and the perimeter of the cell of point \f$i\f$, and
\f$E\f$ a function of all of them. With the weights \f$a_i = \partial E / \partial A_i\f$ and
\f$b_i = \partial E / \partial P_i\f$, which the caller computes from `Voronoi_cell_measures_2`,
`compute()` finds for every point \f$k\f$, in one go,
\f[ \frac{\partial E}{\partial x_k} =
    \sum_i a_i \frac{\partial A_i}{\partial x_k} + b_i \frac{\partial P_i}{\partial x_k} . \f]
The force is the negative of that. With \f$a_i = 1\f$ and all other weights 0 the vector of \f$k\f$
is \f$\partial A_i / \partial x_k\f$, and with \f$b_i = 1\f$ it is
\f$\partial P_i / \partial x_k\f$.

- An unbounded cell contributes nothing: its weights are ignored, whatever they are.
- Points that coincide share a cell, as in `Voronoi_cell_measures_2`: the area of each is an equal
  share of the cell's, the perimeter is the cell's. Their vector is the change where they move
  together, of which each gets an equal share. (If one of them moves alone, the cell is split, and
  there is no derivative.)
- In periodic space the images of a point move with it. Points may be given wrapped or not.
- Removed ids have the vector 0, and their weights are ignored.

The vectors of all points add up to 0, but for rounding.

<b>Derivation.</b> All sums are over faces. Let \f$i\f$, \f$j\f$ and \f$k\f$ be the corners of a
face, counterclockwise, \f$d = x_j - x_i\f$, \f$n\f$ that vector turned left, which is into the
face, \f$h\f$ the cotangent of the angle at \f$k\f$, and \f$c = x_i + (d + h n) / 2\f$ the
circumcenter.

<em>Areas.</em> Let \f$L\f$ be the length of the Voronoi edge between \f$i\f$ and \f$j\f$, and
\f$m\f$ its middle. If \f$x_j\f$ moves, a point \f$y\f$ of that edge keeps \f$|y - x_i|^2 = |y -
x_j|^2\f$, so it moves across the edge with \f$\dot y \cdot d = (x_j - y) \cdot \dot x_j\f$. What
moves across a border changes the area, and what the ends do beside that is of second order. The
integral over the edge is \f[ \frac{\partial A_i}{\partial x_j} = \frac{L}{|d|} (x_j - m), \qquad
\mbox{and likewise} \qquad \frac{\partial A_i}{\partial x_i} = \sum_j \frac{L}{|d|} (m - x_i) . \f]
With \f$h'\f$ the cotangent in the other face at the edge, \f$L = |d| (h + h') / 2\f$ and
\f$m = x_i + d / 2 + (h - h') n / 4\f$. So
\f$\partial A_i / \partial x_j = (h + h') d / 4 - (h^2 - h'^2) n / 8\f$, which is a sum of a part of
each face. All that a face adds for this edge is
\f[ (a_i - a_j) \left( \frac{h}{4} d + \frac{h^2}{8} n \right) \mbox{ to } i, \qquad
    (a_i - a_j) \left( \frac{h}{4} d - \frac{h^2}{8} n \right) \mbox{ to } j . \f]
Only differences of weights count: what one cell loses its neighbor gains.

<em>Perimeters.</em> The face owns \f$|d| h / 2\f$ of the Voronoi edge, the signed distance of
\f$c\f$ from the edge of \f$i\f$ and \f$j\f$. It belongs to both perimeters. Where \f$c\f$
moves, the Voronoi edge, which lies along \f$n\f$, gets longer by \f$\dot c \cdot n / |d|\f$. So
\f$E\f$ changes by \f$\dot c \cdot g\f$ with \f$g = \sum (b_i + b_j) n / |d|\f$, a sum over the
face's three edges. If
\f$x_k\f$ moves, \f$c\f$ stays equally far from \f$x_i\f$ and \f$x_j\f$, so it moves along \f$n\f$,
and \f$(c - x_k) \cdot (\dot c - \dot x_k) = (c - x_i) \cdot \dot c\f$ says how far:
\f$\dot c = n\, ((x_k - c) \cdot \dot x_k) / D\f$, where \f$D\f$ is twice the area of the face. So
the face adds
\f[ \frac{g \cdot n}{D} (x_k - c) \mbox{ to } k, \f]
and likewise to its other corners.

The derivatives of areas stay continuous where an edge flips. Those of perimeters jump when four
points are on a circle, since the length of the vanishing Voronoi edge has a kink there. No Voronoi
edge is a divisor, however short it is. A nearly flat face with circumradius \f$R\f$ and shortest
edge \f$h\f$ adds parts of about \f$(R / h)^2\f$ to the vectors of its corners, which then have
errors of about \f$10^{-16}\f$ times that.

An object keeps its memory: `compute()` allocates nothing if the triangulation had as many ids and
vertices before.

\cgalExample{Dynamic_Delaunay_triangulation_2/voronoi_tissue.cpp}

\sa `Voronoi_cell_measures_2`
*/
class Voronoi_cell_gradients_2
{
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Face = Dynamic_Delaunay_triangulations_2::internal::Voronoi_face_2;

public:
  /// \name Types
  /// @{

  /// the type of ids.
  using size_type = std::size_t;
  /// a vector: two doubles, `x` and `y`.
  using Vector = Dynamic_Delaunay_triangulations_2::Position_2;

  /// @}
  /// \name Computation
  /// If memory runs out, there are no gradients.
  /// @{

  /// computes the vectors of all points. There is one weight for each id.
  ///
  /// Cost: linear, one pass over the faces; in a slab one more; two more if a face is so flat that
  /// rounding hides its orientation.
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_2` or
  ///   `Dynamic_periodic_Delaunay_triangulation_2`.
  /// \throws Uncertified_triangulation_error_2 unless `dt.is_certified()`; nothing changes.
  /// \throws Point_count_error_2 if there are not as many weights as ids; nothing changes.
  template <class Dynamic>
  void compute(const Dynamic& dt, const std::vector<double>& area_weights,
               const std::vector<double>& perimeter_weights)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Voronoi_space_2<Dynamic> space(dt);
    for (const std::vector<double>* weights : {&area_weights, &perimeter_weights})
      if (weights->size() != space.number_of_ids())
        throw Point_count_error_2(space.number_of_ids(), weights->size());
    m_gradients.clear();
    m_gradients.reserve(space.number_of_ids());
    m_cells.assign(space.number_of_cells(), Cell());
    space.for_each_open_cell([this](Index c) { m_cells[c].is_unbounded = true; });
    if (!add_faces(space, area_weights, perimeter_weights)) {
      find_flat(space);
      add_faces(space, area_weights, perimeter_weights);
    }
    copy_to_ids(space);
  }

  /// @}
  /// \name Access
  /// @{

  /// the vector of each id, in units of energy by length.
  const std::vector<Vector>& gradients() const { return m_gradients; }

  /// @}

private:
  struct Cell
  {
    double area_weight = 0, perimeter_weight = 0;
    double points = 0; // the number of points that share it
    Vector gradient{0, 0};
    bool is_unbounded = false;

    bool has_weight() const { return area_weight != 0 || perimeter_weight != 0; }
  };

  // Adds what all faces contribute. False if a flat face makes a cell unbounded: its weights must
  // count for nothing then, but other faces have used them.
  template <class Space>
  bool add_faces(const Space& space, const std::vector<double>& area_weights,
                 const std::vector<double>& perimeter_weights)
  {
    read_weights(space, area_weights, perimeter_weights);
    std::atomic<bool> is_any_flat{false};
    m_sums.run(
        space,
        [&](const std::array<Vertex_index, 3>& cells, const Face& face, const auto& add) {
          if (!face.is_flat())
            add_face(cells, face, add);
          else if (!(m_cells[cells[0]].is_unbounded && m_cells[cells[1]].is_unbounded &&
                     m_cells[cells[2]].is_unbounded))
            is_any_flat.store(true, std::memory_order_relaxed);
        },
        [this](Index c, const Vector& part) {
          m_cells[c].gradient.x += part.x;
          m_cells[c].gradient.y += part.y;
        });
    return !is_any_flat;
  }

  template <class Space>
  BOOST_NOINLINE void find_flat(const Space& space)
  {
    for (Cell& cell : m_cells)
      cell = Cell{0, 0, 0, {0, 0}, cell.is_unbounded};
    Dynamic_Delaunay_triangulations_2::internal::Cell_sums_2<bool> unbounded;
    unbounded.run(
        space,
        [](const std::array<Vertex_index, 3>& cells, const Face& face, const auto& add) {
          if (face.is_flat())
            for (const Index c : cells)
              add(c, true);
        },
        [this](Index c, bool is_unbounded) { m_cells[c].is_unbounded = is_unbounded; });
  }

  template <class Space>
  void read_weights(const Space& space, const std::vector<double>& area_weights,
                    const std::vector<double>& perimeter_weights)
  {
    for (Index id = 0; id < space.number_of_ids(); ++id) {
      if (!space.has_id(id))
        continue;
      Cell& cell = m_cells[space.cell(id)];
      ++cell.points;
      if (cell.is_unbounded)
        continue;
      cell.area_weight += (area_weights[id] - cell.area_weight) / cell.points; // the mean
      cell.perimeter_weight += perimeter_weights[id];
    }
  }

  template <class Add>
  void add_face(const std::array<Vertex_index, 3>& cells, const Face& face, const Add& add) const
  {
    using Dynamic_Delaunay_triangulations_2::internal::dot;
    if (!(m_cells[cells[0]].has_weight() || m_cells[cells[1]].has_weight() ||
          m_cells[cells[2]].has_weight()))
      return;
    // once each, as divisions take most of the time
    const std::array<double, 3> cotangents{face.cotangent(0), face.cotangent(1), face.cotangent(2)};
    std::array<Vector, 3> parts{}; // of the corners
    Vector pull{0, 0};             // of the perimeters, on the circumcenter
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const Cell &from = m_cells[cells[i]], &to = m_cells[cells[j]];
      add_areas(from.area_weight - to.area_weight, cotangents[k], face, k, parts[i], parts[j]);
      const double weight = (from.perimeter_weight + to.perimeter_weight) / face.length(k);
      pull.x += weight * face.normal(k).x;
      pull.y += weight * face.normal(k).y;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector to_center = face.to_circumcenter(k, cotangents[(k + 2) % 3]);
      const double share = dot(pull, face.normal(k)) / face.doubled_area();
      add(cells[k], Vector{parts[k].x - share * to_center.x, parts[k].y - share * to_center.y});
    }
  }

  // Adds what the face contributes for its side k, from i to j. `difference` is that of their area
  // weights, and h the cotangent of the angle opposite to the side.
  static void add_areas(double difference, double h, const Face& face, std::size_t k, Vector& i,
                        Vector& j)
  {
    const double along = difference * h / 4, across = difference * h * h / 8;
    const Vector d = face.side(k), n = face.normal(k);
    i.x += along * d.x + across * n.x;
    i.y += along * d.y + across * n.y;
    j.x += along * d.x - across * n.x;
    j.y += along * d.y - across * n.y;
  }

  template <class Space>
  void copy_to_ids(const Space& space)
  {
    m_gradients.resize(space.number_of_ids()); // throws nothing
    space.for_each_range(space.number_of_ids(), [&](std::size_t, Index first, Index beyond) {
      for (Index id = first; id < beyond; ++id) {
        const Cell cell = space.has_id(id) ? m_cells[space.cell(id)] : Cell();
        const double share = cell.points > 0 ? 1 / cell.points : 0;
        m_gradients[id] = {share * cell.gradient.x, share * cell.gradient.y};
      }
    });
  }

  std::vector<Vector> m_gradients;
  std::vector<Cell> m_cells;
  Dynamic_Delaunay_triangulations_2::internal::Cell_sums_2<Vector> m_sums;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELL_GRADIENTS_2_H
