// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_SUBJECT_3_H
#define PYTHON_SUBJECT_3_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Checkpoint_end.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Cell_arrays_3.h"
#include "bindings/python/src/Errors.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
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

// A triangulation of points in space, as Python uses it, or a population. The ids of a population
// are the user's, and its arrays speak of rows, which are the places in `Group::IDS`. Else the rows
// are the ids.
class Subject_3
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

public:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Kernel, run::Concurrency_tag>;
  using Report = CGAL::Update_report_3;

  virtual ~Subject_3() = default;
  Subject_3& operator=(const Subject_3&) = delete;
  virtual std::unique_ptr<Subject_3> copy() const = 0;

  virtual bool is_population() const = 0;
  virtual const Dynamic& triangulation() const = 0;
  virtual bool has_id(std::int64_t id) const = 0;

  virtual Report update(const Rows& ids, const Rows& points) = 0;
  virtual Report move(const Rows& ids, const Rows& points) = 0;
  // Tells new ids where they are not the user's.
  virtual Report insert(const Rows& ids, const Rows& points,
                        std::vector<std::int64_t>& new_ids) = 0;
  virtual Report remove(const Rows& ids) = 0;
  virtual Report mend() = 0;

  virtual std::string checkpoint() const = 0;
  virtual void restore(const std::string& checkpoint) = 0;

  std::size_t number_of_ids() const { return triangulation().number_of_ids(); }

  std::vector<Array> arrays(Group group) const
  {
    switch (group) {
    case Group::IDS:
      return {id_array(triangulation(), [this](std::size_t id) { return shown_id(id); })};
    case Group::POINTS:
      return {point_array_3(triangulation(), rows())};
    case Group::DUPLICATES:
      return {{duplicate_pairs_3(triangulation(), rows()), {2}}};
    case Group::EDGES:
      return {edge_array_3(certified(), rows())};
    case Group::TRIANGLES: // here tetrahedra
      return simplex_arrays_3(certified(), rows());
    case Group::NEIGHBOR_LISTS:
      return neighbor_list_arrays_3(certified(), rows());
    default:
      throw std::invalid_argument("there are no such arrays of points in space");
    }
  }
  Array volumes() const { return volume_array_3(certified()); }
  std::vector<Array> voronoi_cells(const CGAL::Bbox_3* box) const
  {
    return voronoi_arrays_3(certified(), rows(), box);
  }

protected:
  Subject_3() = default;
  Subject_3(const Subject_3&) = default;

private:
  virtual std::int64_t shown_id(std::size_t id) const = 0;

  const Dynamic& certified() const
  {
    if (!triangulation().is_certified()) {
      throw No_cells_error();
    }
    return triangulation();
  }
  Row_numbers rows() const { return Row_numbers(triangulation(), is_population()); }
};

template <bool has_user_ids>
class Subject_of_3 : public Subject_3
{
  using Owner = std::conditional_t<has_user_ids, CGAL::Dynamic_population_3<Dynamic>, Dynamic>;
  using Point = Dynamic::Point;

public:
  std::unique_ptr<Subject_3> copy() const override { return std::make_unique<Subject_of_3>(*this); }

  bool is_population() const override { return has_user_ids; }

  const Dynamic& triangulation() const override
  {
    if constexpr (has_user_ids) {
      return m_owner.triangulation();
    } else {
      return m_owner;
    }
  }

  bool has_id(std::int64_t id) const override
  {
    if constexpr (has_user_ids) {
      return m_owner.has(id);
    } else {
      return m_owner.has_id(std::size_t(id));
    }
  }

  Report update(const Rows& ids, const Rows& points) override
  {
    if constexpr (has_user_ids) {
      return m_owner.update(identified(ids, points));
    } else if (const Point* const first = points_in_memory<Point>(points)) {
      return m_owner.update(first, first + points.size);
    } else {
      return m_owner.update(positions(points));
    }
  }

  Report move(const Rows& ids, const Rows& points) override
  {
    const auto movers = identified(ids, points);
    return m_owner.move(movers.begin(), movers.end());
  }

  Report insert(const Rows& ids, const Rows& points, std::vector<std::int64_t>& new_ids) override
  {
    if constexpr (has_user_ids) {
      return m_owner.insert(identified(ids, points));
    } else {
      const auto newcomers = positions(points);
      std::vector<std::size_t> given;
      const Report report =
          m_owner.insert(newcomers.begin(), newcomers.end(), std::back_inserter(given));
      new_ids.assign(given.begin(), given.end());
      return report;
    }
  }

  Report remove(const Rows& ids) override
  {
    const auto gone = row_range(ids.size, Read_id{ids});
    return m_owner.remove(gone.begin(), gone.end());
  }

  Report mend() override { return m_owner.mend(); }

  std::string checkpoint() const override
  {
    std::ostringstream out;
    m_owner.write_checkpoint(out);
    return out.str();
  }

  void restore(const std::string& checkpoint) override
  {
    check_end(checkpoint);
    std::istringstream in(checkpoint);
    m_owner.read_checkpoint(in);
  }

private:
  std::int64_t shown_id(std::size_t id) const override
  {
    if constexpr (has_user_ids) {
      return m_owner.user_id(id);
    } else {
      return std::int64_t(id);
    }
  }

  static auto positions(const Rows& points)
  {
    return row_range(points.size, Read_point<Point>{points});
  }
  static auto identified(const Rows& ids, const Rows& points)
  {
    return row_range(points.size, Read_identified_point<Point>{ids, points});
  }

  Owner m_owner;
};

} // namespace python

#endif // PYTHON_SUBJECT_3_H
