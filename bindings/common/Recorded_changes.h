// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_RECORDED_CHANGES_H
#define BINDINGS_RECORDED_CHANGES_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace bindings {

// A point that leaves a population.
struct Leaving_point
{
  std::size_t id;
  std::int64_t user_id;
};

// A visitor that lists changed edges: those of the last call alone. A point that comes to a
// population in that call may get the id of one that leaves it. So the latter gets another name
// first, as if it had been called so before the call.
template <class Visitor>
class Recorded_changes : public Visitor
{
public:
  // To be called before the call in which these points leave.
  void expect(std::vector<Leaving_point> leaving) { m_expected = std::move(leaving); }

  static bool is_name(std::size_t id) { return id >= first_name; }
  std::int64_t user_id(std::size_t name) const { return m_left[name - first_name].user_id; }

  template <class Dynamic>
  void before_update(const Dynamic& dt)
  {
    Visitor::clear();
    Visitor::before_update(dt);
    m_left = std::exchange(m_expected, {});
    if (!m_left.empty()) {
      rename(dt);
    }
  }

private:
  static constexpr std::size_t first_name = std::size_t(1) << 31; // more than any id

  template <class Dynamic>
  void rename(const Dynamic& dt)
  {
    std::vector<std::size_t> names(dt.number_of_ids());
    for (std::size_t id = 0; id < names.size(); ++id) {
      names[id] = id;
    }
    for (std::size_t k = 0; k < m_left.size(); ++k) {
      names[m_left[k].id] = first_name + k;
    }
    dt.for_each_edge([&](std::size_t i, std::size_t j, const auto&... shift) {
      if (is_name(names[i]) || is_name(names[j])) {
        note_removal(dt, names[i], names[j], shift...);
        note_creation(dt, i, j, shift...);
      }
    });
  }

  template <class Dynamic>
  void note_removal(const Dynamic&, std::size_t i, std::size_t j)
  {
    Visitor::note(i, j, -Visitor::whole);
  }
  template <class Dynamic>
  void note_creation(const Dynamic&, std::size_t i, std::size_t j)
  {
    Visitor::note(i, j, Visitor::whole);
  }
  template <class Dynamic, class Shift>
  void note_removal(const Dynamic& dt, std::size_t i, std::size_t j, const Shift& shift)
  {
    Visitor::after_edge_removal(dt, i, j, shift);
  }
  template <class Dynamic, class Shift>
  void note_creation(const Dynamic& dt, std::size_t i, std::size_t j, const Shift& shift)
  {
    Visitor::after_edge_creation(dt, i, j, shift);
  }

  std::vector<Leaving_point> m_expected, m_left;
};

template <class Visitor>
constexpr bool records_changes = false;
template <class Visitor>
constexpr bool records_changes<Recorded_changes<Visitor>> = true;

} // namespace bindings

#endif // BINDINGS_RECORDED_CHANGES_H
