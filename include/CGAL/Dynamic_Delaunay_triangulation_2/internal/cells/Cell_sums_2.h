// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_SUMS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_SUMS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Sums over faces for each Voronoi cell. Threads share the parts of the faces. A part adds to its
// own cells at once. Its summands for cells of other parts, which are few where faces and vertices
// are numbered along one curve, are added when all parts are done, part by part. So the sums depend
// on the parts alone, to the last bit. An object keeps its memory.
template <class Summand>
class Cell_sums_2
{
public:
  // Calls f(cells, face, add) for each face, where add(c, summand) leads to one call of
  // apply(c, summand). Neither f nor apply may use what other calls of apply() change.
  template <class Space, class Function, class Apply>
  void run(const Space& space, const Function& f, const Apply& apply)
  {
    const std::size_t parts = space.number_of_face_parts();
    m_left_over.resize((std::max)(parts, m_left_over.size()));
    for (Summands& summands : m_left_over)
      summands.clear();
    space.for_each_face(
        [&](std::size_t part, const std::array<Index, 3>& cells, const Voronoi_face_2& face) {
          f(cells, face, [&](Index c, const Summand& summand) {
            if (space.has_cell(part, c))
              apply(c, summand);
            else
              leave_over(part, c, summand);
          });
        });
    for (const Summands& summands : m_left_over)
      for (const auto& [c, summand] : summands)
        apply(c, summand);
  }

private:
  using Summands = std::vector<std::pair<Index, Summand>>;

  // A separate function, so that compilers inline the rest.
  BOOST_NOINLINE void leave_over(std::size_t part, Index c, const Summand& summand)
  {
    m_left_over[part].emplace_back(c, summand);
  }

  std::vector<Summands> m_left_over; // of each part
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_SUMS_2_H
