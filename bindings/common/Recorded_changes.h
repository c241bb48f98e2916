// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_RECORDED_CHANGES_H
#define BINDINGS_RECORDED_CHANGES_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Edge_changes_visitor_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Periodic_edge_changes_visitor_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
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
//
// Whether it listens is said when it is made: with a type of its own, triangulations that record
// nothing would double what compilers have to do.
template <class Visitor>
class Recorded_changes : public Visitor
{
public:
  explicit Recorded_changes(bool is_listening = false)
    : m_is_listening(is_listening)
  {
  }
  bool is_listening() const { return m_is_listening; }

  // To be called before the call in which these points leave.
  void expect(std::vector<Leaving_point> leaving) { m_expected = std::move(leaving); }

  static bool is_name(std::size_t id) { return id >= first_name; }
  std::int64_t user_id(std::size_t name) const { return m_left[name - first_name].user_id; }

  // Whether the last call has failed, so that the lists are not complete.
  bool is_in_update() const { return m_is_in_update; }

  // To be called if a call has failed and has changed nothing.
  void clear()
  {
    Visitor::clear();
    m_left.clear();
    m_is_in_update = m_is_told = false;
  }

  template <class Dynamic>
  void before_update(const Dynamic& dt)
  {
    if (!tells_later || !m_is_in_update || m_is_told) {
      clear();
    }
    m_is_in_update = true;
    Visitor::before_update(dt);
    const std::size_t first = m_left.size();
    m_left.insert(m_left.end(), m_expected.begin(), m_expected.end());
    m_expected.clear();
    if (m_left.size() > first) {
      rename(dt, first);
    }
  }

  template <class Dynamic, class... Translation>
  void after_translation(const Dynamic& dt, const Translation&... translation)
  {
    m_is_told = true;
    Visitor::after_translation(dt, translation...);
  }
  template <class Dynamic, class Multiples>
  void after_cell_exchange(const Dynamic& dt, const Multiples& multiples)
  {
    m_is_told = true;
    Visitor::after_cell_exchange(dt, multiples);
  }

  template <class Dynamic, class... Edge>
  void after_edge_removal(const Dynamic& dt, const Edge&... edge)
  {
    m_is_told = true;
    Visitor::after_edge_removal(dt, edge...);
  }
  template <class Dynamic, class... Edge>
  void after_edge_creation(const Dynamic& dt, const Edge&... edge)
  {
    m_is_told = true;
    Visitor::after_edge_creation(dt, edge...);
  }

  template <class Dynamic, class Report>
  void after_update(const Dynamic& dt, const Report& report)
  {
    m_is_in_update = false;
    Visitor::after_update(dt, report);
  }

private:
  static constexpr std::size_t first_name = std::size_t(1) << 31; // more than any id

  // Those that leave, from the one with this number on.
  template <class Dynamic>
  void rename(const Dynamic& dt, std::size_t first)
  {
    std::vector<std::size_t> names(dt.number_of_ids());
    for (std::size_t id = 0; id < names.size(); ++id) {
      names[id] = id;
    }
    for (std::size_t k = first; k < m_left.size(); ++k) {
      names[m_left[k].id] = first_name + k;
    }
    dt.for_each_edge([&](std::size_t i, std::size_t j, const auto&... shift) {
      if (is_name(names[i]) || is_name(names[j])) {
        note_removal(dt, names[i], names[j], shift...);
        note_creation(dt, i, j, shift...);
      }
    });
  }

  // The visitor of the plane is told of flips and faces, others of edges.
  static constexpr bool is_planar = std::is_base_of_v<CGAL::Edge_changes_visitor_2, Visitor>;
  // In space, what a call has changed before memory ran out is told after the next one, unless some
  // of it was told already.
  static constexpr bool tells_later =
      std::is_base_of_v<CGAL::Edge_changes_visitor_3, Visitor> ||
      std::is_base_of_v<CGAL::Periodic_edge_changes_visitor_3, Visitor>;

  template <class Dynamic>
  void note_removal([[maybe_unused]] const Dynamic& dt, std::size_t i, std::size_t j)
  {
    if constexpr (is_planar) {
      Visitor::note(i, j, -Visitor::whole);
    } else {
      Visitor::after_edge_removal(dt, (std::min)(i, j), (std::max)(i, j));
    }
  }
  template <class Dynamic>
  void note_creation([[maybe_unused]] const Dynamic& dt, std::size_t i, std::size_t j)
  {
    if constexpr (is_planar) {
      Visitor::note(i, j, Visitor::whole);
    } else {
      Visitor::after_edge_creation(dt, (std::min)(i, j), (std::max)(i, j));
    }
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

  bool m_is_listening;
  std::vector<Leaving_point> m_expected, m_left;
  bool m_is_in_update = false, m_is_told = false;
};

} // namespace bindings

#endif // BINDINGS_RECORDED_CHANGES_H
