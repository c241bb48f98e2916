// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_BOND_NETWORK_H
#define SCENARIO_BOND_NETWORK_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace scenario {

struct Bond
{
  std::uint32_t partner;
  double rest_length;
  double strain_limit; // infinite for bonds that never break
};

// The bonds of each particle to partners with a larger index, one flat array for all.
class Bond_network
{
public:
  // Bonds are added particle by particle: first begin_particle(), then its bonds.
  void begin_particle() { m_begin.push_back(m_bonds.size()); }

  void add(std::uint32_t partner, double rest_length, const std::optional<double>& strain_limit)
  {
    m_bonds.push_back(
        {partner, rest_length, strain_limit.value_or(std::numeric_limits<double>::infinity())});
  }

  bool connects(std::uint32_t a, std::uint32_t b) const
  {
    const std::uint32_t low = a < b ? a : b;
    const std::uint32_t high = a < b ? b : a;
    for (std::size_t i = m_begin[low]; i != end_of(low); ++i) {
      if (m_bonds[i].partner == high) {
        return true;
      }
    }
    return false;
  }

  // Calls visit(particle, bond) for every unbroken bond; the bond breaks where it answers false.
  template <class Visit>
  void for_each(Visit visit)
  {
    for (std::uint32_t particle = 0; particle != m_begin.size(); ++particle) {
      const std::size_t end = end_of(particle);
      for (std::size_t i = m_begin[particle]; i != end; ++i) {
        if (m_bonds[i].partner != broken && !visit(particle, m_bonds[i])) {
          m_bonds[i].partner = broken;
          ++m_number_of_broken;
        }
      }
    }
  }

  std::size_t number_of_bonds() const { return m_bonds.size(); }
  std::size_t number_of_broken() const { return m_number_of_broken; }

private:
  static constexpr std::uint32_t broken = (std::numeric_limits<std::uint32_t>::max)();

  std::size_t end_of(std::uint32_t particle) const
  {
    return particle + 1 == m_begin.size() ? m_bonds.size() : m_begin[particle + 1];
  }

  std::vector<std::size_t> m_begin;
  std::vector<Bond> m_bonds;
  std::size_t m_number_of_broken = 0;
};

} // namespace scenario

#endif // SCENARIO_BOND_NETWORK_H
