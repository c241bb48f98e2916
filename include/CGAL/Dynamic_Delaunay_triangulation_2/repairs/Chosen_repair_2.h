// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_CHOSEN_REPAIR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_CHOSEN_REPAIR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Repairs

One of several repairs, chosen while a program runs. It does what the chosen one does.

\tparam Repairs models of `DelaunayRepair_2`, all different; the first one is the default

\cgalModels{DelaunayRepair_2}

\sa `Chosen_classifier_2`
*/
template <class... Repairs>
class Chosen_repair_2
{
public:
  /// whether `Repair` can be chosen.
  template <class Repair>
  static constexpr bool can_be = (std::is_same_v<Repair, Repairs> || ...);

  /// chooses the first repair, with its default parameters.
  Chosen_repair_2() = default;

  /// chooses this repair.
  /// \pre `can_be<Repair>`
  template <class Repair, class = std::enable_if_t<can_be<Repair>>>
  Chosen_repair_2(Repair repair)
    : m_repair(std::move(repair))
  {
  }

  /// calls `f(repair)` with the chosen repair.
  template <class Function>
  decltype(auto) visit(const Function& f) const
  {
    return std::visit(f, m_repair);
  }

  /// repairs.
  template <class Mender>
  void operator()(Mender& mender)
  {
    std::visit([&](auto& chosen) { chosen(mender); }, m_repair);
  }

private:
  std::variant<Repairs...> m_repair;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_CHOSEN_REPAIR_2_H
