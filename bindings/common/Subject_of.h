// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_SUBJECT_OF_H
#define BINDINGS_SUBJECT_OF_H

#include "bindings/common/Array_reading.h"
#include "bindings/common/Bounded_cells.h"
#include "bindings/common/Checkpoint_end.h"
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

// The triangulation, and the ids of the user if there are any.
template <class Dynamic>
struct Without_user_ids
{
  explicit Without_user_ids(Dynamic its_triangulation)
    : triangulation(std::move(its_triangulation))
  {
  }
  Dynamic triangulation;
};
template <class Dynamic>
using With_user_ids = CGAL::Dynamic_population_2<Dynamic>;

template <class Dynamic, class Kinds, bool has_user_ids>
class Subject_of : public Subject
{
  using Owner = std::conditional_t<has_user_ids, With_user_ids<Dynamic>, Without_user_ids<Dynamic>>;
  using Point = typename Dynamic::Point;
  static constexpr bool is_periodic = is_periodic_triangulation<Dynamic>;

public:
  explicit Subject_of(Dynamic triangulation)
    : m_owner(std::move(triangulation))
  {
  }

  bool is_population() const override { return has_user_ids; }

  Report update(const Rows& ids, const Rows& points, const std::optional<Cell>& cell) override
  {
    const auto update = [&](const auto& rows) {
      if constexpr (is_periodic) {
        if (cell) {
          return changing().update(rows, periodic_cell(*cell));
        }
      }
      return changing().update(rows);
    };
    if constexpr (has_user_ids) {
      return with_leaving([&] { return points_missing_in(ids); },
                          [&] { return update(identified(ids, points)); });
    } else if (const Point* const first = points_in_memory<Point>(points)) {
      return update(CGAL::make_range(first, first + points.size)); // these are prefetched
    } else {
      return update(row_range(points.size, Read_point<Point>{points}));
    }
  }

  Report move(const Rows& ids, const Rows& points) override
  {
    if constexpr (has_user_ids) {
      check_distinct(ids);
    }
    const auto movers = identified(ids, points);
    return changing().move(movers.begin(), movers.end());
  }

  Report insert(const Rows& ids, const Rows& points, std::vector<std::int64_t>& new_ids) override
  {
    if constexpr (has_user_ids) {
      return m_owner.insert(ids.at<std::int64_t>(0, 0), Read_point<Point>{points}(0));
    } else {
      const auto newcomers = row_range(points.size, Read_point<Point>{points});
      return changing().insert(newcomers.begin(), newcomers.end(), std::back_inserter(new_ids));
    }
  }

  Report remove(const Rows& ids) override
  {
    if constexpr (has_user_ids) {
      const std::int64_t user_id = ids.at<std::int64_t>(0, 0);
      return with_leaving(
          [&] {
            return Leaving{{m_owner.id(user_id), user_id}};
          },
          [&] { return m_owner.remove(user_id); });
    } else {
      const auto gone = row_range(ids.size, Read_id{ids});
      return changing().remove(gone.begin(), gone.end());
    }
  }

  Report mend() override { return changing().mend(); }
  bool certify() override { return changing().certify(); }

  bool is_certified() const override { return dt().is_certified(); }
  bool is_valid() const override
  {
    if constexpr (Kinds::has_extras) {
      return dt().is_valid();
    } else {
      return refuse_extra();
    }
  }
  std::size_t number_of_points() const override { return dt().number_of_points(); }
  std::size_t number_of_ids() const override { return dt().number_of_ids(); }
  std::size_t number_of_vertices() const override { return dt().number_of_vertices(); }

  bool has_id(std::int64_t id) const override
  {
    if constexpr (has_user_ids) {
      return m_owner.has(id);
    } else {
      return dt().has_id(std::size_t(id));
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
    const Row_numbers rows(dt(), has_user_ids);
    if constexpr (has_user_ids) {
      if (group == Group::CHANGES) {
        return change_arrays<std::int64_t>(m_owner.visitor(),
                                           [&](std::size_t id) { return user_id_then(id); });
      }
      if (group == Group::IDS) {
        return {id_array(dt(), [&](std::size_t id) { return m_owner.user_id(id); })};
      }
    }
    return read_arrays(dt(), rows, group);
  }

  std::vector<Array> clipped_cells(const Box& box) const override
  {
    if constexpr (is_periodic) {
      throw std::invalid_argument("cells of a periodic triangulation cannot be clipped to a box");
    } else {
      CGAL::Voronoi_cell_measures_2 measures;
      measures.compute(dt(), CGAL::Bbox_2(box.xmin, box.ymin, box.xmax, box.ymax));
      return measure_arrays(dt(), Row_numbers(dt(), has_user_ids), measures);
    }
  }

  Array cell_corners(std::int64_t id) const override
  {
    if constexpr (has_user_ids) {
      return corner_array(dt(), m_owner.id(id));
    } else {
      return corner_array(dt(), std::size_t(id));
    }
  }

  Bounded_cells bounded_cells(Bounded_cells bounded, const Radii& radii) const override
  {
    bounded.cell = cell();
    return compute_bounded_cells<Kinds::has_extras>(dt(), Row_numbers(dt(), has_user_ids),
                                                    std::move(bounded), radii);
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
      return answer_arrays(dt(), Row_numbers(dt(), has_user_ids), question);
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
                   [&] { return m_owner.read_checkpoint(in); });
    } else {
      check_end(checkpoint);
      std::istringstream in(checkpoint);
      m_owner.triangulation.read_checkpoint(in);
    }
  }

private:
  [[noreturn]] static bool refuse_extra()
  {
    throw std::logic_error(
        "this binding has no checkpoints, checks of validity, gradients or queries");
  }

  const auto& owner() const
  {
    if constexpr (has_user_ids) {
      return m_owner;
    } else {
      return m_owner.triangulation;
    }
  }
  auto& changing()
  {
    if constexpr (has_user_ids) {
      return m_owner;
    } else {
      return m_owner.triangulation;
    }
  }
  const Dynamic& dt() const
  {
    if constexpr (has_user_ids) {
      return m_owner.triangulation();
    } else {
      return m_owner.triangulation;
    }
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

  using Leaving = std::vector<Leaving_point>;

  // Makes a change, of which a visitor that records changes has to know beforehand who leaves.
  template <class Find_leaving, class Change>
  auto with_leaving(const Find_leaving& find_leaving, const Change& change)
  {
    if constexpr (records_changes<std::decay_t<decltype(m_owner.visitor())>>) {
      const Leaving leaving = find_leaving();
      m_owner.visitor().expect(leaving);
      try {
        return change();
      } catch (...) {
        m_owner.visitor().expect({});
        if (!leaving.empty() && m_owner.has(leaving.front().user_id)) {
          m_owner.visitor().clear(); // all was taken back
        }
        throw;
      }
    } else {
      return change();
    }
  }

  Leaving points_missing_in(const Rows& ids) const
  {
    std::vector<bool> is_there(dt().number_of_ids());
    for (std::size_t i = 0; i < ids.size; ++i) {
      const std::int64_t user_id = ids.at<std::int64_t>(i, 0);
      if (m_owner.has(user_id)) {
        is_there[m_owner.id(user_id)] = true;
      }
    }
    Leaving missing;
    for (std::size_t id = 0; id < is_there.size(); ++id) {
      if (!is_there[id] && dt().has_id(id)) {
        missing.push_back({id, m_owner.user_id(id)});
      }
    }
    return missing;
  }

  // Of a point that is there, or has left in the last call.
  std::int64_t user_id_then(std::size_t id) const
  {
    if constexpr (records_changes<std::decay_t<decltype(m_owner.visitor())>>) {
      if (m_owner.visitor().is_name(id)) {
        return m_owner.visitor().user_id(id);
      }
    }
    return m_owner.user_id(id);
  }

  static auto identified(const Rows& ids, const Rows& points)
  {
    return row_range(points.size, Read_identified_point<Point>{ids, points});
  }

  Owner m_owner;
};

} // namespace bindings

#endif // BINDINGS_SUBJECT_OF_H
