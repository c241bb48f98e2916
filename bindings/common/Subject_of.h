// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_SUBJECT_OF_H
#define BINDINGS_SUBJECT_OF_H

#include "bindings/common/Array_reading.h"
#include "bindings/common/Bounded_cells.h"
#include "bindings/common/Checkpoint_end.h"
#include "bindings/common/Owning_subject.h"
#include "bindings/common/Point_queries.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace bindings {

inline CGAL::Periodic_cell_2 periodic_cell(const Cell& cell)
{
  return cell.is_slab ? CGAL::Periodic_cell_2::slab(cell.ax, cell.ay)
                      : CGAL::Periodic_cell_2(cell.ax, cell.ay, cell.bx, cell.by);
}

template <class Dynamic, bool has_user_ids>
using Owning_subject_2 =
    Owning_subject<Subject, Dynamic,
                   std::conditional_t<has_user_ids, CGAL::Dynamic_population_2<Dynamic>, void>>;

template <class Dynamic, class Kinds, bool has_user_ids>
class Subject_of : public Owning_subject_2<Dynamic, has_user_ids>
{
  using Base = Owning_subject_2<Dynamic, has_user_ids>;
  using Base::dt, Base::identified, Base::owner, Base::points_missing_in, Base::positions,
      Base::rows, Base::with_leaving;
  using typename Base::Leaving;
  using typename Base::Point;
  static constexpr bool is_periodic = is_periodic_triangulation<Dynamic>;

public:
  using typename Base::Report;

  explicit Subject_of(Dynamic triangulation)
    : Base(std::move(triangulation))
  {
  }

  Report update(const Rows& ids, const Rows& points, const std::optional<Cell>& cell) override
  {
    const auto update = [&](const auto& its_points) {
      if constexpr (is_periodic) {
        if (cell) {
          return owner().update(its_points, periodic_cell(*cell));
        }
      }
      return owner().update(its_points);
    };
    if constexpr (has_user_ids) {
      return with_leaving([&] { return points_missing_in(ids); },
                          [&] { return update(identified(ids, points)); });
    } else if (const Point* const first = points_in_memory<Point>(points)) {
      return update(CGAL::make_range(first, first + points.size)); // these are prefetched
    } else {
      return update(positions(points));
    }
  }

  Report move(const Rows& ids, const Rows& points) override
  {
    if constexpr (has_user_ids) {
      check_distinct(ids);
    }
    return Base::move(ids, points);
  }

  Report insert(const Rows& ids, const Rows& points, std::vector<std::int64_t>& new_ids) override
  {
    if constexpr (has_user_ids) {
      return owner().insert(ids.at<std::int64_t>(0, 0), Read_point<Point>{points}(0));
    } else {
      const auto newcomers = positions(points);
      return owner().insert(newcomers.begin(), newcomers.end(), std::back_inserter(new_ids));
    }
  }

  Report remove(const Rows& ids) override
  {
    if constexpr (has_user_ids) {
      const std::int64_t user_id = ids.at<std::int64_t>(0, 0);
      return with_leaving(
          [&] {
            return Leaving{{owner().id(user_id), user_id}};
          },
          [&] { return owner().remove(user_id); });
    } else {
      const auto gone = row_range(ids.size, Read_id{ids});
      return owner().remove(gone.begin(), gone.end());
    }
  }

  bool is_valid() const override
  {
    if constexpr (Kinds::has_extras) {
      return dt().is_valid();
    } else {
      return refuse_extra();
    }
  }

  std::optional<Cell> cell() const override
  {
    if constexpr (is_periodic) {
      const CGAL::Periodic_cell_2& c = dt().cell();
      return Cell{c.ax(), c.ay(), c.bx(), c.by(), c.is_slab()};
    } else {
      return std::nullopt;
    }
  }

  std::vector<Array> arrays(Group group) const override
  {
    switch (group) {
    case Group::IDS:
      return Base::ids();
    case Group::CHANGES:
      return Base::changes();
    default:
      return read_arrays(dt(), rows(), group);
    }
  }

  std::vector<Array> clipped_cells(const Box& box) const override
  {
    if constexpr (is_periodic) {
      throw std::invalid_argument("cells of a periodic triangulation cannot be clipped to a box");
    } else {
      CGAL::Voronoi_cell_measures_2 measures;
      measures.compute(dt(), CGAL::Bbox_2(box.xmin, box.ymin, box.xmax, box.ymax));
      return measure_arrays(dt(), rows(), measures);
    }
  }

  Array cell_corners(std::int64_t id) const override
  {
    if constexpr (has_user_ids) {
      return corner_array(dt(), owner().id(id));
    } else {
      return corner_array(dt(), std::size_t(id));
    }
  }

  Bounded_cells bounded_cells(Bounded_cells bounded, const Radii& radii) const override
  {
    bounded.cell = cell();
    return compute_bounded_cells<Kinds::has_extras>(dt(), rows(), std::move(bounded), radii);
  }

  CGAL::Bounded_voronoi_gradients_2 bounded_gradients(const Bounded_cells& bounded,
                                                      const Rows& area_weights,
                                                      const Rows& length_weights) const override
  {
    if constexpr (Kinds::has_extras) {
      return compute_bounded_gradients(dt(), bounded, area_weights, length_weights);
    } else {
      return refuse_extra(), CGAL::Bounded_voronoi_gradients_2();
    }
  }

  std::vector<Array> answer(const Question& question) const override
  {
    if constexpr (Kinds::has_extras) {
      return answer_arrays(dt(), rows(), question);
    } else {
      return refuse_extra(), std::vector<Array>();
    }
  }

  std::string checkpoint() const override
  {
    if constexpr (Kinds::has_extras) {
      std::ostringstream out;
      owner().write_checkpoint(out);
      return out.str();
    } else {
      return refuse_extra(), "";
    }
  }

  void restore(const std::string& checkpoint) override
  {
    if constexpr (!Kinds::has_extras) {
      refuse_extra();
    } else if constexpr (has_user_ids) {
      check_end(checkpoint);
      std::istringstream in(checkpoint);
      with_leaving([&] { return points_missing_in(Rows()); },
                   [&] { return owner().read_checkpoint(in); });
    } else {
      check_end(checkpoint);
      std::istringstream in(checkpoint);
      owner().read_checkpoint(in);
    }
  }

private:
  [[noreturn]] static bool refuse_extra()
  {
    throw std::logic_error(
        "this binding has no checkpoints, checks of validity, gradients or queries");
  }

  // The triangulation would name the point by its own id.
  static void check_distinct(const Rows& ids)
  {
    std::vector<std::int64_t> sorted;
    for (std::size_t i = 0; i < ids.size; ++i) {
      sorted.push_back(ids.at<std::int64_t>(i, 0));
    }
    std::sort(sorted.begin(), sorted.end());
    const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
    if (repeated != sorted.end()) {
      throw CGAL::Repeated_id_error_2(*repeated);
    }
  }
};

} // namespace bindings

#endif // BINDINGS_SUBJECT_OF_H
