// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_INTERPOLATION_WEIGHTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_INTERPOLATION_WEIGHTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Query_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Weights_at_point_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Weights by which a quantity that is known at the points is interpolated elsewhere, at *query
points*, in the plane, in a periodic cell or in a slab. `ids()` and `weights()` hold those of all
query points, one list after the other, and `offsets()` tells where each list begins (compressed
sparse rows).

- *Natural neighbor* weights are Sibson's: if a query point were inserted, its Voronoi cell
  would take a part of each neighbor's; the weight of a neighbor is its share in the new cell. They
  do not depend on which diagonals the triangulation has where points are cocircular, and they
  change continuously with the query point and the points, and with the former differentiably,
except at the points.
- *Linear* weights are the barycentric coordinates of the query point in its face. They are faster,
and have kinks at edges.

Both are positive or 0, add up to 1, and reproduce linear functions: the weighted sum of the points
is the query point.

- A query point on a point has the weight 1 for that point. Of points that coincide, only the
  representative, the one that was there first, has weights.
- A query point on an edge of the hull, or of a slab's border, and for linear weights on any edge,
has weights for the two ends alone.
- A query point outside of the convex hull, or of a slab, has no weights. Nor has any if the points
  do not span the plane, or if there are none.

No weight differs from the exact one, for the coordinates as they are given, by more than 1e-12.
They are computed in doubles, with a bound on the error, and with rational numbers where that bound
is larger, as at hulls with faces that are nearly flat. The manual has the bound,
\ref DynamicDelaunaySubsection_Interpolation.

In periodic space a neighbor is an image of a point: `shifts()` tells which one, in multiples of the
cell's vectors, relative to the query point as it is given. A point can be a neighbor by several
images, and has a weight for each.

Ids are those of the triangulation. For a `Dynamic_population_2`, `population.id(user_id)` and
`population.user_id(id)` convert between these and the user's ids.

\cgalExample{Dynamic_Delaunay_triangulation_2/interpolated_field.cpp}

\sa `Delaunay_point_queries_2`
\sa `Voronoi_cell_measures_2`
*/
class Interpolation_weights_2
{
public:
  /// \name Types
  /// @{

  /// an id in the arrays: 32 bits, as inside the triangulation.
  using Id = std::uint32_t;
  /// the type of numbers of query points and entries.
  using size_type = std::size_t;

  /// @}
  /// \name Computation
  /// Both functions replace all weights by those of a range of query points, and change nothing if
  /// they throw. Threads share the work if the triangulation has the `Parallel_tag`. Query points
  /// that follow each other in space are faster.
  ///
  /// \tparam Dynamic a `Dynamic_Delaunay_triangulation_2` whose circles are Euclidean, or a
  ///   `Dynamic_periodic_Delaunay_triangulation_2`.
  /// \tparam ForwardIterator has the value type `Dynamic::Point`.
  /// \throws Uncertified_triangulation_error_2 unless the triangulation is certified.
  /// \throws Non_finite_coordinate_error_2 if a coordinate of a query point is NaN or infinite;
  /// `id()` of this and of the following errors is the number of the query point.
  /// \throws Coordinate_range_error_2 if a coordinate is too large for this program.
  /// \throws Periodic_range_error_2 if a query point is 2<sup>20</sup> cells or more from the
  /// origin.
  /// @{

  /// computes natural neighbor weights.
  ///
  /// Cost for each query point: a walk of O(n<sup>1/3</sup>) expected steps for evenly spread
  /// points, O(1) near the last query point; and time proportional to the number of natural
  /// neighbors, about 6.
  template <class Dynamic, class ForwardIterator>
  void compute_natural_neighbor(const Dynamic& dt, ForwardIterator first, ForwardIterator beyond)
  {
    compute(dt, first, beyond, [](auto& at, const auto& p, size_type i, auto found) {
      at.natural_neighbors(p, i, found);
    });
  }

  /// computes linear weights. Cost for each query point: the walk.
  template <class Dynamic, class ForwardIterator>
  void compute_linear(const Dynamic& dt, ForwardIterator first, ForwardIterator beyond)
  {
    compute(dt, first, beyond,
            [](auto& at, const auto& p, size_type i, auto found) { at.linear(p, i, found); });
  }

  /// @}
  /// \name Access
  /// @{

  /// the number of query points.
  size_type number_of_query_points() const { return m_offsets.size() - 1; }
  /// whether a query point has no weights, because it is outside of the hull or of the slab, or
  /// because the points do not span the plane. \pre `i < number_of_query_points()`
  bool is_outside(size_type i) const { return m_offsets[i] == m_offsets[i + 1]; }
  /// where the list of each query point begins in `ids()` and `weights()`, and where the last list
  /// ends: `number_of_query_points() + 1` numbers.
  const std::vector<size_type>& offsets() const { return m_offsets; }
  /// the ids of all lists, ascending in each.
  const std::vector<Id>& ids() const { return m_ids; }
  /// the weights of these points, from 0 to 1. Those of a list with k entries add up to 1, up to an
  /// error of k 2<sup>-53</sup>.
  const std::vector<double>& weights() const { return m_weights; }
  /// in periodic space, which images have these weights, as in `Delaunay_point_queries_2`: the
  /// image is at `point(id)` plus `shift[0]` times the cell's first vector plus `shift[1]` times
  /// its second one. Empty in the plane.
  const std::vector<Periodic_shift_2>& shifts() const { return m_shifts; }

  /// writes the interpolated value at each query point, in their order: the weighted sum of the
  /// points' values. \param values the points' values, by ids from 0 on; read only for the ids in
  /// `ids()`. \param results where to write. \param outside what is written for query points
  /// without weights. \tparam RandomAccessIterator has a value type V with `V + double * V`:
  /// numbers, vectors. \return where the next value would be written.
  template <class RandomAccessIterator, class OutputIterator>
  OutputIterator
  interpolate(RandomAccessIterator values, OutputIterator results,
              const typename std::iterator_traits<RandomAccessIterator>::value_type& outside) const
  {
    using Value = typename std::iterator_traits<RandomAccessIterator>::value_type;
    using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
    for (size_type i = 0; i < number_of_query_points(); ++i) {
      size_type entry = m_offsets[i];
      const auto term = [&] { return m_weights[entry] * values[Difference(m_ids[entry])]; };
      Value sum = is_outside(i) ? outside : Value(term());
      while (++entry < m_offsets[i + 1])
        sum = sum + term();
      *results++ = sum;
    }
    return results;
  }

  /// @}

private:
  template <class Dynamic, class ForwardIterator, class Function>
  void compute(const Dynamic& dt, ForwardIterator first, ForwardIterator beyond,
               const Function& weigh)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    using At = Weights_at_point_2<Dynamic>;
    const Default_floating_point floating_point;
    const std::vector<typename Dynamic::Point> points(first, beyond);
    std::vector<Weighted_id_2> all;
    std::vector<size_type> offsets;
    list_in_parts<typename Dynamic::Frame::Parts>(
        At(dt), points.size(), all, offsets,
        [&](At& at, size_type i, auto found) { weigh(at, points[i], i, found); });
    Interpolation_weights_2 next;
    next.m_offsets.swap(offsets);
    next.m_ids.reserve(all.size());
    next.m_weights.reserve(all.size());
    for (const Weighted_id_2& one : all) {
      next.m_ids.push_back(one.id);
      next.m_weights.push_back(one.weight);
      At::Geometry::show(one.shift, [&](const auto&... it) { (next.m_shifts.push_back(it), ...); });
    }
    *this = std::move(next);
  }

  std::vector<size_type> m_offsets{0};
  std::vector<Id> m_ids;
  std::vector<double> m_weights;
  std::vector<Periodic_shift_2> m_shifts;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_INTERPOLATION_WEIGHTS_2_H
