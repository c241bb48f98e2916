// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_SELECTION_H
#define ANY_MOTION_SELECTION_H

#include "Cloud.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace any_motion {

enum class Choice {
  RANDOM, // others in every frame
  FIXED,  // those that were chosen in the first frame, as far as they are still there
  DISC    // the nearest ones to some point, another in every frame
};

// How many points a step moves.
struct Amount
{
  double share = 1.0;
  std::size_t count = 0; // if it is not 0, so many instead

  std::size_t of(std::size_t points) const
  {
    const double wanted = std::round(share * static_cast<double>(points));
    return (std::min)(points, count != 0 ? count : static_cast<std::size_t>(wanted));
  }
};

// Which points a step moves.
class Selection
{
public:
  Selection(const Amount& amount, Choice choice)
    : m_amount(amount)
    , m_choice(choice)
  {
  }

  // Those of this frame.
  const Places& choose(const Cloud& cloud, Random& random)
  {
    const std::size_t wanted = m_amount.of(cloud.size());
    if (m_choice == Choice::FIXED) {
      choose_fixed(wanted, cloud, random);
    } else if (m_choice == Choice::DISC) {
      choose_disc(wanted, cloud, random);
    } else {
      choose_random(wanted, cloud, random);
    }
    return m_chosen;
  }

private:
  void choose_random(std::size_t wanted, const Cloud& cloud, Random& random)
  {
    if (m_all.size() != cloud.size()) {
      m_all.resize(cloud.size());
      std::iota(m_all.begin(), m_all.end(), std::size_t(0));
    }
    for (std::size_t i = 0; i != wanted; ++i) {
      std::swap(m_all[i], m_all[i + any_below(m_all.size() - i, random)]);
    }
    m_chosen.assign(m_all.begin(), m_all.begin() + static_cast<std::ptrdiff_t>(wanted));
  }

  void choose_fixed(std::size_t wanted, const Cloud& cloud, Random& random)
  {
    if (m_is_first) {
      choose_random(wanted, cloud, random);
      for (const std::size_t place : m_chosen) {
        m_fixed.push_back(cloud.ids()[place]);
      }
      m_is_first = false;
    }
    m_chosen.clear();
    for (const Id id : m_fixed) {
      if (const auto place = cloud.place(id)) {
        m_chosen.push_back(*place);
      }
    }
  }

  void choose_disc(std::size_t wanted, const Cloud& cloud, Random& random)
  {
    m_chosen.resize(cloud.size());
    std::iota(m_chosen.begin(), m_chosen.end(), std::size_t(0));
    if (wanted == cloud.size()) {
      return;
    }
    const Point middle = cloud.points[any_below(cloud.size(), random)];
    const auto distance = [&](std::size_t place) {
      const Point& point = cloud.points[place];
      return std::hypot(point.x - middle.x, point.y - middle.y);
    };
    std::nth_element(m_chosen.begin(), m_chosen.begin() + static_cast<std::ptrdiff_t>(wanted),
                     m_chosen.end(), [&](std::size_t place, std::size_t other) {
                       return std::make_pair(distance(place), place) <
                              std::make_pair(distance(other), other);
                     });
    m_chosen.resize(wanted);
  }

  Amount m_amount;
  Choice m_choice;
  bool m_is_first = true;
  std::vector<Id> m_fixed;
  Places m_all;
  Places m_chosen;
};

} // namespace any_motion

#endif // ANY_MOTION_SELECTION_H
