// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_PERIODIC_SUBJECT_3_H
#define PYTHON_PERIODIC_SUBJECT_3_H

#include "bindings/common/Recorded_changes.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Periodic_arrays_3.h"
#include "bindings/python/src/Space_subject_3.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Delaunay_update_visitor_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Periodic_edge_changes_visitor_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <memory>
#include <optional>
#include <vector>

namespace python {

// A triangulation of points in periodic space, as Python uses it, or a population.
class Periodic_subject_3 : public Subject_base<CGAL::Update_report_3>
{
public:
  static constexpr int dimension = 3;
  static constexpr bool changes_singly = false;

  using Its_cell = CGAL::Periodic_cell_3;

  virtual std::unique_ptr<Periodic_subject_3> copy() const = 0;

  // In the same cell if there is no other one.
  virtual Report update(const Rows& ids, const Rows& points,
                        const std::optional<Its_cell>& cell) = 0;

  virtual Its_cell cell() const = 0;
  virtual Array volumes() const = 0;
  virtual Array voronoi_volumes() const = 0;
  virtual std::vector<Array> voronoi_cells() const = 0;
};

using Periodic_changes_3 = Recorded_changes<CGAL::Periodic_edge_changes_visitor_3>;
using Dynamic_periodic_3 = CGAL::Dynamic_periodic_Delaunay_triangulation_3<
    CGAL::Exact_predicates_inexact_constructions_kernel,
    CGAL::With_concurrency_2<run::Concurrency_tag>, CGAL::With_visitor_2<Periodic_changes_3>>;

template <bool has_user_ids>
class Periodic_subject_of_3
  : public Space_subject_3<Periodic_subject_3, Dynamic_periodic_3, has_user_ids>
{
  using Base = Space_subject_3<Periodic_subject_3, Dynamic_periodic_3, has_user_ids>;
  using Base::certified, Base::dt, Base::rows;

public:
  using typename Base::Its_cell, typename Base::Report;

  Periodic_subject_of_3(const Its_cell& cell, const Dynamic_periodic_3::Settings& settings)
    : Base(Dynamic_periodic_3(cell, settings))
  {
  }
  std::unique_ptr<Periodic_subject_3> copy() const override
  {
    return std::make_unique<Periodic_subject_of_3>(*this);
  }

  Report update(const Rows& ids, const Rows& points, const std::optional<Its_cell>& cell) override
  {
    const Its_cell its_cell = cell ? *cell : this->cell();
    return Base::take_frame(ids, points, its_cell);
  }

  Its_cell cell() const override { return dt().cell(); }

  std::vector<Array> arrays(Group group) const override
  {
    switch (group) {
    case Group::EDGES:
      return periodic_edge_arrays(certified(), rows());
    case Group::TRIANGLES: // here tetrahedra
      return periodic_simplex_arrays(certified(), rows());
    case Group::NEIGHBOR_LISTS:
      return periodic_neighbor_list_arrays(certified(), rows());
    default:
      return Base::arrays(group);
    }
  }
  Array volumes() const override { return periodic_volume_array(certified()); }
  Array voronoi_volumes() const override { return voronoi_volume_array_3(certified(), rows()); }
  std::vector<Array> voronoi_cells() const override
  {
    return periodic_voronoi_arrays(certified(), rows());
  }
};

// Without points.
inline std::unique_ptr<Periodic_subject_3>
make_periodic_subject_3(const CGAL::Periodic_cell_3& cell, bool records_changes, bool is_population)
{
  Dynamic_periodic_3::Settings settings;
  settings.visitor = Periodic_changes_3(records_changes);
  if (is_population) {
    return std::make_unique<Periodic_subject_of_3<true>>(cell, settings);
  }
  return std::make_unique<Periodic_subject_of_3<false>>(cell, settings);
}

} // namespace python

#endif // PYTHON_PERIODIC_SUBJECT_3_H
