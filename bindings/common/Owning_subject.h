// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_OWNING_SUBJECT_H
#define BINDINGS_OWNING_SUBJECT_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Change_reading.h"
#include "bindings/common/Recorded_changes.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace bindings {

// A triangulation, or the population that has one, and what is the same for both in the plane, in
// periodic space and in space. `Population` is void where there are no ids of the user.
template <class Base, class Dynamic, class Population>
class Owning_subject : public Base
{
protected:
  static constexpr bool has_user_ids = !std::is_void_v<Population>;
  using Owner = std::conditional_t<has_user_ids, Population, Dynamic>;
  using Point = typename Dynamic::Point;

public:
  using typename Base::Report;

  bool is_population() const override { return has_user_ids; }

  Report move(const Rows& ids, const Rows& points) override
  {
    const auto movers = identified(ids, points);
    return m_owner.move(movers.begin(), movers.end());
  }
  Report mend() override { return m_owner.mend(); }
  bool certify() override { return m_owner.certify(); }

  bool is_certified() const override { return dt().is_certified(); }
  std::size_t number_of_points() const override { return dt().number_of_points(); }
  std::size_t number_of_ids() const override { return dt().number_of_ids(); }
  std::size_t number_of_vertices() const override { return dt().number_of_vertices(); }

  bool has_id(std::int64_t id) const override
  {
    if constexpr (has_user_ids) {
      return m_owner.has(id);
    } else {
      return m_owner.has_id(std::size_t(id));
    }
  }

protected:
  explicit Owning_subject(Dynamic triangulation)
    : m_owner(std::move(triangulation))
  {
  }

  Owner& owner() { return m_owner; }
  const Owner& owner() const { return m_owner; }
  const Dynamic& dt() const
  {
    if constexpr (has_user_ids) {
      return m_owner.triangulation();
    } else {
      return m_owner;
    }
  }
  Row_numbers rows() const { return Row_numbers(dt(), has_user_ids); }

  // The ids of all rows.
  std::vector<Array> ids() const
  {
    return {id_array(dt(), [this](std::size_t id) { return shown_id(id); })};
  }
  // What the last call changed, by ids: those of the user may have left in it.
  std::vector<Array> changes() const
  {
    if constexpr (has_user_ids) {
      return change_arrays<std::int64_t>(m_owner.visitor(),
                                         [this](std::size_t id) { return user_id_then(id); });
    } else {
      return change_arrays<std::int32_t>(m_owner.visitor(),
                                         [](std::size_t id) { return std::int32_t(id); });
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

  using Leaving = std::vector<Leaving_point>;

  bool is_recording() const { return m_owner.visitor().is_listening(); }

  // Makes a change, of which a visitor that records changes has to know beforehand who leaves.
  template <class Find_leaving, class Change>
  auto with_leaving(const Find_leaving& find_leaving, const Change& change)
  {
    if (!is_recording()) {
      return change();
    }
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

private:
  std::int64_t shown_id(std::size_t id) const
  {
    if constexpr (has_user_ids) {
      return m_owner.user_id(id);
    } else {
      return std::int64_t(id);
    }
  }

  // Of a point that is there, or has left in the last call.
  std::int64_t user_id_then(std::size_t id) const
  {
    if (m_owner.visitor().is_name(id)) {
      return m_owner.visitor().user_id(id);
    }
    return m_owner.user_id(id);
  }

  Owner m_owner;
};

} // namespace bindings

#endif // BINDINGS_OWNING_SUBJECT_H
