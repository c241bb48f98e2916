// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_AGREEMENT_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_AGREEMENT_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/queries/Delaunay_reference_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

How far the edges of a maintained triangulation agree with those of a Delaunay triangulation of the
same points, as the confusion matrix of "these two points are Delaunay neighbors" over all pairs of
points (thesis 5.1.1). In periodic space edges between different images of two points, or of one,
count as different ones.
*/
class Delaunay_agreement
{
public:
  /// \cond
  Delaunay_agreement(std::size_t true_positives, std::size_t false_positives,
                     std::size_t false_negatives, std::size_t points)
    : m_true_positives(true_positives)
    , m_false_positives(false_positives)
    , m_false_negatives(false_negatives)
  {
    const std::size_t pairs = points < 2 ? 0 : points * (points - 1) / 2;
    const std::size_t named = true_positives + false_positives + false_negatives;
    m_true_negatives = pairs > named ? pairs - named : 0;
  }
  /// \endcond

  /// maintained edges that are Delaunay.
  std::size_t true_positives() const { return m_true_positives; }
  /// maintained edges that are not Delaunay.
  std::size_t false_positives() const { return m_false_positives; }
  /// Delaunay edges that are missing.
  std::size_t false_negatives() const { return m_false_negatives; }
  /// pairs of points that are neighbors in neither triangulation: the number of pairs minus the
  /// numbers above, but not less than 0, as it would be for few points in periodic space.
  std::size_t true_negatives() const { return m_true_negatives; }

  /// whether the two triangulations agree in every edge.
  bool is_perfect() const { return m_false_positives == 0 && m_false_negatives == 0; }

  /// the *validity* of the thesis: exactly 1 if all edges agree, 0 for agreement by chance, -1 for
  /// complete disagreement. By convention 0 if a row or column of the matrix is empty and the
  /// agreement is not perfect.
  double matthews_correlation_coefficient() const
  {
    if (is_perfect())
      return 1;
    const double tp = double(m_true_positives), fp = double(m_false_positives);
    const double fn = double(m_false_negatives), tn = double(m_true_negatives);
    const double product =
        std::sqrt(tp + fp) * std::sqrt(tp + fn) * std::sqrt(tn + fp) * std::sqrt(tn + fn);
    return product == 0 ? 0 : (tp * tn - fp * fn) / product;
  }

private:
  std::size_t m_true_positives, m_false_positives, m_false_negatives, m_true_negatives = 0;
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

compares the edges of a maintained triangulation with those of a Delaunay triangulation of the same
points, which is assumed to be correct. Points are identified by their positions; ids do not matter.

Ties are not errors: where four or more points lie on one circle, any chord between them counts as a
Delaunay edge, as long as there are not more of them than a triangulation has room for.

Cost: O(n log n) for n points; in periodic space also a query for the nearest point at each point of
both triangulations.

\tparam Maintained a `Dynamic_Delaunay_triangulation_2` or a
  `Dynamic_periodic_Delaunay_triangulation_2`, certified or not.
\tparam Reference a `Delaunay_triangulation_2` with the same point type; in periodic space a
  `Dynamic_periodic_Delaunay_triangulation_2`, such as a new one of the same points.
\param maintained the maintained triangulation.
\param reference the correct triangulation.
\throws std::invalid_argument if a point of `maintained` is not in `reference`, or if their cells
differ. \throws Uncertified_triangulation_error_2 if a periodic reference is not certified.
*/
template <class Maintained, class Reference>
Delaunay_agreement delaunay_agreement(const Maintained& maintained, const Reference& reference)
{
  using namespace Dynamic_Delaunay_triangulations_2::internal;
  using Correct = Delaunay_reference_2<Reference>;
  Correct::Sites::check_space(maintained, reference);
  const Default_floating_point floating_point;
  const Correct correct(reference);
  std::vector<typename Correct::Site> site_of_id(maintained.number_of_ids());
  for (std::size_t id = 0; id < site_of_id.size(); ++id)
    if (maintained.has_id(id))
      site_of_id[id] = correct.site(maintained.point(id));
  std::vector<typename Correct::Edge> edges;
  maintained.for_each_edge([&](std::size_t i, std::size_t j, const auto&... shift) {
    edges.push_back(
        Correct::edge(site_of_id[i], shifted(site_of_id[j], Periodic_shift_2{shift...})));
  });
  const auto [right, wrong, missing, sites] = correct.compare(std::move(edges));
  return Delaunay_agreement(right, wrong, missing, sites);
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_DELAUNAY_AGREEMENT_H
