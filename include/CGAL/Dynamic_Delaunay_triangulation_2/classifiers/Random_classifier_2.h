// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_RANDOM_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_RANDOM_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cstdint>
#include <random>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies each point with probability `p`, regardless of its motion (thesis 4.2.3). It is
<em>heuristic</em>. Points are drawn in the order of their ids, so equal seeds classify the same
points on every machine.

Cost: one random number a point.

\cgalModels{DelaunayClassifier_2}
*/
class Random_classifier_2
{
public:
  /// it may miss edges.
  static constexpr bool is_exact = false;

  /// \param p the probability, from 0 to 1.
  /// \param seed the seed of the random numbers.
  /// \throws Parameter_error_2 if `p` is out of its range.
  explicit Random_classifier_2(double p = 0.0025, std::uint64_t seed = 0)
    : m_p(p)
    , m_random(seed)
  {
    if (!(p >= 0 && p <= 1))
      throw Parameter_error_2("the parameter p of random", p, 0, 1);
  }

  /// the probability.
  double p() const { return m_p; }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    // 53 random bits as a double in [0, 1): the standard's distributions differ between libraries
    for (typename Frame::Point_id id(0); id < frame.number_of_ids(); ++id)
      if (frame.has_id(id) && double(m_random() >> 11) * 0x1p-53 < m_p)
        classified.add_id(id);
  }

private:
  double m_p;
  std::mt19937_64 m_random;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_RANDOM_CLASSIFIER_2_H
