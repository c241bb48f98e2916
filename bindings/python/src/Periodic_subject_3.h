// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_PERIODIC_SUBJECT_3_H
#define PYTHON_PERIODIC_SUBJECT_3_H

#include "bindings/common/Checkpoint_end.h"
#include "bindings/common/Owning_subject.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Errors.h"
#include "bindings/python/src/Periodic_arrays_3.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
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
  virtual std::vector<Array> voronoi_cells() const = 0;
};

using Dynamic_periodic_3 = CGAL::Dynamic_periodic_Delaunay_triangulation_3<
    CGAL::Exact_predicates_inexact_constructions_kernel,
    CGAL::With_concurrency_2<run::Concurrency_tag>>;

template <bool has_user_ids>
using Owning_periodic_subject_3 = Owning_subject<
    Periodic_subject_3, Dynamic_periodic_3,
    std::conditional_t<has_user_ids, CGAL::Dynamic_population_3<Dynamic_periodic_3>, void>>;

template <bool has_user_ids>
class Periodic_subject_of_3 : public Owning_periodic_subject_3<has_user_ids>
{
  using Base = Owning_periodic_subject_3<has_user_ids>;
  using Base::dt, Base::identified, Base::owner, Base::positions, Base::rows;
  using typename Base::Point;

public:
  using typename Base::Its_cell, typename Base::Report;

  explicit Periodic_subject_of_3(const Its_cell& cell)
    : Base(Dynamic_periodic_3(cell))
  {
  }
  std::unique_ptr<Periodic_subject_3> copy() const override
  {
    return std::make_unique<Periodic_subject_of_3>(*this);
  }

  Report update(const Rows& ids, const Rows& points, const std::optional<Its_cell>& cell) override
  {
    const Its_cell its_cell = cell ? *cell : this->cell();
    if constexpr (has_user_ids) {
      return owner().update(identified(ids, points), its_cell);
    } else if (const Point* const first = points_in_memory<Point>(points)) {
      return owner().update(first, first + points.size, its_cell);
    } else {
      return owner().update(positions(points), its_cell);
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
    return owner().remove(gone.begin(), gone.end());
  }

  bool is_valid() const override { return dt().is_valid(); }
  Its_cell cell() const override { return dt().cell(); }

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
      return periodic_edge_arrays(certified(), rows());
    case Group::TRIANGLES: // here tetrahedra
      return periodic_simplex_arrays(certified(), rows());
    case Group::NEIGHBOR_LISTS:
      return periodic_neighbor_list_arrays(certified(), rows());
    default:
      throw std::invalid_argument("there are no such arrays of points in periodic space");
    }
  }
  Array volumes() const override { return periodic_volume_array(certified()); }
  std::vector<Array> voronoi_cells() const override
  {
    return periodic_voronoi_arrays(certified(), rows());
  }

  std::vector<Array> answer(const Question&) const override
  {
    throw std::invalid_argument("there are no queries of points in periodic space");
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
    owner().read_checkpoint(in);
  }

private:
  const Dynamic_periodic_3& certified() const
  {
    if (!dt().is_certified()) {
      throw No_cells_error();
    }
    return dt();
  }
};

// Without points.
inline std::unique_ptr<Periodic_subject_3>
make_periodic_subject_3(const CGAL::Periodic_cell_3& cell, bool is_population)
{
  if (is_population) {
    return std::make_unique<Periodic_subject_of_3<true>>(cell);
  }
  return std::make_unique<Periodic_subject_of_3<false>>(cell);
}

} // namespace python

#endif // PYTHON_PERIODIC_SUBJECT_3_H
