// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_COUNTS_H
#define RANDOM_OPERATIONS_COUNTS_H

#include "Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace random_operations {

inline constexpr std::size_t number_of_reasons =
    static_cast<std::size_t>(CGAL::Rebuild_reason_2::BUDGET_SPENT) + 1;

// The numbers of operations, and of their results.
struct Counts
{
  std::array<std::uint64_t, operation_names.size()> operations{};
  std::uint64_t trials = 0, points = 0;
  std::uint64_t flips = 0, splices = 0, relocated = 0, merged = 0, parted = 0;
  std::array<std::uint64_t, number_of_reasons> rebuilds{}; // also of operations without a rebuild
  std::uint64_t certified = 0;                             // operations after which it was
  std::array<std::uint64_t, 3> faults{};

  std::uint64_t number_of_operations() const
  {
    return std::accumulate(operations.begin(), operations.end(), std::uint64_t(0));
  }

  std::uint64_t number_of_rebuilds() const
  {
    return std::accumulate(rebuilds.begin() + 1, rebuilds.end(), std::uint64_t(0));
  }

  std::uint64_t operator[](Operation operation) const
  {
    return operations[static_cast<std::size_t>(operation)];
  }

  std::uint64_t operator[](Fault fault) const { return faults[static_cast<std::size_t>(fault)]; }
  bool has_faults() const { return faults != decltype(faults){}; }

  void add(Operation operation) { ++operations[static_cast<std::size_t>(operation)]; }
  void add(Fault fault) { ++faults[static_cast<std::size_t>(fault)]; }

  void add(const CGAL::Update_report_2& report)
  {
    flips += report.flips;
    splices += report.splices;
    relocated += report.relocated;
    merged += report.merged;
    parted += report.parted;
    ++rebuilds[static_cast<std::size_t>(report.rebuild_reason)];
  }

  Counts& operator+=(const Counts& other)
  {
    add(other.operations, operations);
    add(other.faults, faults);
    add(other.rebuilds, rebuilds);
    for (const auto count :
         {&Counts::trials, &Counts::points, &Counts::flips, &Counts::splices, &Counts::relocated,
          &Counts::merged, &Counts::parted, &Counts::certified}) {
      this->*count += other.*count;
    }
    return *this;
  }

private:
  template <class Array>
  static void add(const Array& terms, Array& sums)
  {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] += terms[i];
    }
  }
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_COUNTS_H
