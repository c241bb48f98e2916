// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_SUBJECT_3_H
#define PYTHON_SUBJECT_3_H

#include "bindings/common/Checkpoint_end.h"
#include "bindings/common/Found_points.h"
#include "bindings/common/Owning_subject.h"
#include "bindings/common/Recorded_changes.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Cell_arrays_3.h"
#include "bindings/python/src/Errors.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Edge_changes_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
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

template <class Visitor>
using Dynamic_3 =
    CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel,
                                           CGAL::With_concurrency_2<run::Concurrency_tag>,
                                           CGAL::With_visitor_2<Visitor>>;
template <class Dynamic, bool has_user_ids>
using Owning_subject_3 =
    Owning_subject<Subject_3, Dynamic,
                   std::conditional_t<has_user_ids, CGAL::Dynamic_population_3<Dynamic>, void>>;

template <class Dynamic, bool has_user_ids>
class Subject_of_3 : public Owning_subject_3<Dynamic, has_user_ids>
{
  using Base = Owning_subject_3<Dynamic, has_user_ids>;
  using Base::dt, Base::identified, Base::owner, Base::points_missing_in, Base::positions,
      Base::rows, Base::with_leaving;
  using typename Base::Leaving;
  using typename Base::Point;

public:
  using typename Base::Report;

  Subject_of_3()
    : Base(Dynamic())
  {
  }
  std::unique_ptr<Subject_3> copy() const override { return std::make_unique<Subject_of_3>(*this); }

  Report update(const Rows& ids, const Rows& points) override
  {
    if constexpr (has_user_ids) {
      return with_leaving([&] { return points_missing_in(ids); },
                          [&] { return owner().update(identified(ids, points)); });
    } else if (const Point* const first = points_in_memory<Point>(points)) {
      return owner().update(first, first + points.size);
    } else {
      return owner().update(positions(points));
    }
  }

  Report insert(const Rows& ids, const Rows& points, std::vector<std::int64_t>& new_ids) override
  {
    if constexpr (has_user_ids) {
      return owner().insert(identified(ids, points));
    } else {
      const auto newcomers = positions(points);
      std::vector<std::size_t> given;
      const Report report =
          owner().insert(newcomers.begin(), newcomers.end(), std::back_inserter(given));
      new_ids.assign(given.begin(), given.end());
      return report;
    }
  }

  Report remove(const Rows& ids) override
  {
    const auto gone = row_range(ids.size, Read_id{ids});
    const auto remove = [&] { return owner().remove(gone.begin(), gone.end()); };
    if constexpr (has_user_ids) {
      return with_leaving([&] { return points_of(ids); }, remove);
    } else {
      return remove();
    }
  }

  // A visitor is not told of what `mend()` does itself, but of a call that changes no point.
  Report mend() override
  {
    return dt().is_certified() && !is_untold() ? owner().mend() : remove(Rows());
  }

  bool is_valid() const override { return dt().is_valid(); }
  int dimension_of_points() const override { return dt().dimension(); }

  std::vector<Array> arrays(Group group) const override
  {
    switch (group) {
    case Group::IDS:
      return Base::ids();
    case Group::POINTS:
      return {point_array_3(dt(), rows())};
    case Group::DUPLICATES:
      return {{duplicate_pairs_3(dt(), rows()), {2}}};
    case Group::EDGES:
      return {edge_array_3(certified(), rows())};
    case Group::TRIANGLES: // here tetrahedra
      return simplex_arrays_3(certified(), rows());
    case Group::NEIGHBOR_LISTS:
      return neighbor_list_arrays_3(certified(), rows());
    case Group::CHANGES:
      if (is_untold()) {
        throw Untold_error("what has changed is not known yet, since memory did not suffice for "
                           "the last call: call mend()");
      }
      return Base::changes();
    default:
      throw std::invalid_argument("there are no such arrays of points in space");
    }
  }
  Array volumes() const override { return volume_array_3(certified()); }
  std::vector<Array> voronoi_cells(const CGAL::Bbox_3* box) const override
  {
    return voronoi_arrays_3(certified(), rows(), box);
  }

  std::vector<Array> answer(const Question& question) const override
  {
    using Queries = CGAL::Delaunay_point_queries_3<Dynamic>;
    const auto query_points = positions(question.query_points);
    switch (question.query) {
    case Query::NEAREST:
      return nearest_arrays<Queries>(certified(), rows(), query_points);
    case Query::WITHIN:
      return within_arrays<Queries>(certified(), rows(), query_points, question.extent);
    default:
      throw std::invalid_argument("there are no such queries of points in space");
    }
  }

  std::string checkpoint() const override
  {
    std::ostringstream out;
    owner().write_checkpoint(out);
    return out.str();
  }

  void restore(const std::string& checkpoint) override
  {
    check_end(checkpoint);
    std::istringstream in(checkpoint);
    const auto read = [&] { owner().read_checkpoint(in); };
    if constexpr (has_user_ids) {
      with_leaving([&] { return points_missing_in(Rows()); }, read);
    } else {
      read();
    }
  }

private:
  const Dynamic& certified() const
  {
    if (!dt().is_certified()) {
      throw No_cells_error();
    }
    return dt();
  }

  // Whether the last call has failed before a visitor was told of all that it has changed.
  bool is_untold() const
  {
    if constexpr (Base::is_recording) {
      return owner().visitor().is_in_update();
    } else {
      return false;
    }
  }

  // Throws as a removal does if one is not there.
  Leaving points_of(const Rows& ids) const
  {
    Leaving leaving;
    for (std::size_t i = 0; i < ids.size; ++i) {
      const std::int64_t user_id = Read_id{ids}(i);
      leaving.push_back({owner().id(user_id), user_id});
    }
    return leaving;
  }
};

// Without points; and without a visitor if it has nothing to record.
inline std::unique_ptr<Subject_3> make_subject_3(bool records_changes, bool is_population)
{
  const auto make = [&](auto visitor) -> std::unique_ptr<Subject_3> {
    using Dynamic = Dynamic_3<decltype(visitor)>;
    if (is_population) {
      return std::make_unique<Subject_of_3<Dynamic, true>>();
    }
    return std::make_unique<Subject_of_3<Dynamic, false>>();
  };
  if (records_changes) {
    return make(Recorded_changes<Edges_alone_visitor_3>());
  }
  return make(CGAL::Delaunay_update_visitor_base_3());
}

} // namespace python

#endif // PYTHON_SUBJECT_3_H
