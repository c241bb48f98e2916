// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_SPACE_SUBJECT_3_H
#define PYTHON_SPACE_SUBJECT_3_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Checkpoint_end.h"
#include "bindings/common/Found_points.h"
#include "bindings/common/Owning_subject.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Cell_arrays_3.h"
#include "bindings/python/src/Errors.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace python {

template <class Its_subject, class Dynamic, bool has_user_ids>
using Owning_subject_3 =
    Owning_subject<Its_subject, Dynamic,
                   std::conditional_t<has_user_ids, CGAL::Dynamic_population_3<Dynamic>, void>>;

// A triangulation of points in space, or a population, and what is the same for both in open and in
// periodic space. `Its_subject` is abstract.
template <class Its_subject, class Dynamic, bool has_user_ids>
class Space_subject_3 : public Owning_subject_3<Its_subject, Dynamic, has_user_ids>
{
  using Base = Owning_subject_3<Its_subject, Dynamic, has_user_ids>;
  using Base::identified, Base::points_missing_in, Base::positions, Base::with_leaving;
  using typename Base::Leaving;
  using typename Base::Point;

protected:
  using Base::dt, Base::owner, Base::rows;

public:
  using typename Base::Report;

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

  // What has to do with cells depends on the space.
  std::vector<Array> arrays(Group group) const override
  {
    switch (group) {
    case Group::IDS:
      return Base::ids();
    case Group::POINTS:
      return {point_array_3(dt(), rows())};
    case Group::DUPLICATES:
      return {{duplicate_pairs_3(dt(), rows()), {2}}};
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

  std::vector<Array> answer(const Question& question) const override
  {
    using Queries = CGAL::Delaunay_point_queries_3<Dynamic>;
    const auto query_points = positions(question.query_points);
    switch (question.query) {
    case Query::NEAREST:
      return nearest_arrays<Queries>(certified(), rows(), query_points);
    case Query::WITHIN:
      if constexpr (is_periodic_triangulation<Dynamic>) {
        check_number_of_images(images_within(question.extent), dt().number_of_points(),
                               question.query_points.size);
      }
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

protected:
  explicit Space_subject_3(Dynamic triangulation)
    : Base(std::move(triangulation))
  {
  }

  // Takes a frame; in periodic space there is a cell.
  template <class... Its_cell>
  Report take_frame(const Rows& ids, const Rows& points, const Its_cell&... cell)
  {
    if constexpr (has_user_ids) {
      return with_leaving([&] { return points_missing_in(ids); },
                          [&] { return owner().update(identified(ids, points), cell...); });
    } else if (const Point* const first = points_in_memory<Point>(points)) {
      return owner().update(first, first + points.size, cell...);
    } else {
      return owner().update(positions(points), cell...);
    }
  }

  const Dynamic& certified() const
  {
    if (!dt().is_certified()) {
      throw No_cells_error();
    }
    return dt();
  }

private:
  // Whether the last call has failed before a visitor was told of all that it has changed.
  bool is_untold() const { return Base::is_recording() && owner().visitor().is_in_update(); }

  // About how many images of a point are in a sphere; in a slab or a wire, of one in its middle.
  double images_within(double radius) const
  {
    constexpr double pi = 3.14159;
    const auto& cell = dt().cell();
    if (cell.is_wire()) {
      return 2 * (radius / std::hypot(cell.a()[0], cell.a()[1], cell.a()[2]));
    }
    if (cell.is_slab()) {
      const auto &a = cell.a(), &b = cell.b();
      const double area = std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                     a[0] * b[1] - a[1] * b[0]);
      return pi * radius * (radius / area);
    }
    return 4 * pi / 3 * radius * radius * (radius / cell.volume());
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

} // namespace python

#endif // PYTHON_SPACE_SUBJECT_3_H
