// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_SUBJECT_3_H
#define PYTHON_SUBJECT_3_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Cell_arrays_3.h"
#include "bindings/python/src/Errors.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace python {

// A triangulation of points in space, as Python uses it. The rows of its arrays are ids.
class Subject_3
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Kernel, run::Concurrency_tag>;
  using Point = Dynamic::Point;

  static auto positions(const Rows& points)
  {
    return row_range(points.size, Read_point<Point>{points});
  }

public:
  using Report = CGAL::Update_report_3;

  const Dynamic& triangulation() const { return m_triangulation; }

  Report update(const Rows& points)
  {
    if (const Point* const first = points_in_memory<Point>(points)) {
      return m_triangulation.update(first, first + points.size);
    }
    return m_triangulation.update(positions(points));
  }
  Report move(const Rows& ids, const Rows& points)
  {
    const auto movers = row_range(points.size, Read_identified_point<Point>{ids, points});
    return m_triangulation.move(movers.begin(), movers.end());
  }
  Report insert(const Rows& points, std::vector<std::size_t>& new_ids)
  {
    const auto newcomers = positions(points);
    return m_triangulation.insert(newcomers.begin(), newcomers.end(), std::back_inserter(new_ids));
  }
  Report remove(const Rows& ids)
  {
    const auto gone = row_range(ids.size, Read_id{ids});
    return m_triangulation.remove(gone.begin(), gone.end());
  }
  Report mend() { return m_triangulation.mend(); }

  std::size_t number_of_ids() const { return m_triangulation.number_of_ids(); }

  std::vector<Array> arrays(Group group) const
  {
    switch (group) {
    case Group::IDS:
      return {id_array(m_triangulation, [](std::size_t id) { return id; })};
    case Group::POINTS:
      return {point_array_3(m_triangulation)};
    case Group::DUPLICATES:
      return {{duplicate_pairs_3(m_triangulation), {2}}};
    case Group::EDGES:
      return {edge_array_3(certified())};
    case Group::TRIANGLES: // here tetrahedra
      return simplex_arrays_3(certified());
    case Group::NEIGHBOR_LISTS:
      return neighbor_list_arrays_3(certified());
    default:
      throw std::invalid_argument("there are no such arrays of points in space");
    }
  }
  Array volumes() const { return volume_array_3(certified()); }
  std::vector<Array> voronoi_cells(const CGAL::Bbox_3* box) const
  {
    return voronoi_arrays_3(certified(), box);
  }

private:
  const Dynamic& certified() const
  {
    if (!m_triangulation.is_certified()) {
      throw No_cells_error();
    }
    return m_triangulation;
  }

  Dynamic m_triangulation;
};

} // namespace python

#endif // PYTHON_SUBJECT_3_H
