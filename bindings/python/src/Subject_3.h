// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_SUBJECT_3_H
#define PYTHON_SUBJECT_3_H

#include "bindings/common/Recorded_changes.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Cell_arrays_3.h"
#include "bindings/python/src/Space_subject_3.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Edge_changes_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <memory>
#include <vector>

namespace python {

// A triangulation of points in space, as Python uses it, or a population.
class Subject_3 : public Subject_base<CGAL::Update_report_3>
{
public:
  static constexpr int dimension = 3;
  static constexpr bool changes_singly = false;

  virtual std::unique_ptr<Subject_3> copy() const = 0;

  virtual Report update(const Rows& ids, const Rows& points) = 0;

  virtual int dimension_of_points() const = 0;
  virtual Array volumes() const = 0;
  virtual Array voronoi_volumes() const = 0;
  virtual std::vector<Array> voronoi_cells(const CGAL::Bbox_3* box) const = 0;
};

// Of edges alone: facets, which Python is not shown, would take twice as much memory.
class Edges_alone_visitor_3 : public CGAL::Edge_changes_visitor_3
{
public:
  template <class Dynamic>
  void after_facet_removal(const Dynamic&, const Facet&)
  {
  }
  template <class Dynamic>
  void after_facet_creation(const Dynamic&, const Facet&)
  {
  }
};

using Changes_3 = Recorded_changes<Edges_alone_visitor_3>;
using Dynamic_3 =
    CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel,
                                           CGAL::With_concurrency_2<run::Concurrency_tag>,
                                           CGAL::With_visitor_2<Changes_3>>;

template <bool has_user_ids>
class Subject_of_3 : public Space_subject_3<Subject_3, Dynamic_3, has_user_ids>
{
  using Base = Space_subject_3<Subject_3, Dynamic_3, has_user_ids>;
  using Base::certified, Base::dt, Base::rows;

public:
  using typename Base::Report;

  explicit Subject_of_3(const Dynamic_3::Settings& settings)
    : Base(Dynamic_3(settings))
  {
  }
  std::unique_ptr<Subject_3> copy() const override { return std::make_unique<Subject_of_3>(*this); }

  Report update(const Rows& ids, const Rows& points) override
  {
    return Base::take_frame(ids, points);
  }

  int dimension_of_points() const override { return dt().dimension(); }

  std::vector<Array> arrays(Group group) const override
  {
    switch (group) {
    case Group::EDGES:
      return {edge_array_3(certified(), rows())};
    case Group::TRIANGLES: // here tetrahedra
      return simplex_arrays_3(certified(), rows());
    case Group::NEIGHBOR_LISTS:
      return neighbor_list_arrays_3(certified(), rows());
    default:
      return Base::arrays(group);
    }
  }
  Array volumes() const override { return volume_array_3(certified()); }
  Array voronoi_volumes() const override { return voronoi_volume_array_3(certified(), rows()); }
  std::vector<Array> voronoi_cells(const CGAL::Bbox_3* box) const override
  {
    return voronoi_arrays_3(certified(), rows(), box);
  }
};

// Without points.
inline std::unique_ptr<Subject_3> make_subject_3(bool records_changes, bool is_population)
{
  Dynamic_3::Settings settings;
  settings.visitor = Changes_3(records_changes);
  if (is_population) {
    return std::make_unique<Subject_of_3<true>>(settings);
  }
  return std::make_unique<Subject_of_3<false>>(settings);
}

} // namespace python

#endif // PYTHON_SUBJECT_3_H
