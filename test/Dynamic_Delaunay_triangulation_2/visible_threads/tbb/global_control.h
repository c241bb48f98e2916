// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// See parallel_for.h, which starts as many threads as it is asked for.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_GLOBAL_CONTROL_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_GLOBAL_CONTROL_H

#include <algorithm>
#include <cstddef>
#include <limits>

namespace tbb {

class global_control
{
public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t value)
    : m_before(limit())
  {
    limit() = (std::min)(limit(), value);
  }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;
  ~global_control() { limit() = m_before; }

  static std::size_t active_value(parameter) { return limit(); }

private:
  static std::size_t& limit()
  {
    static std::size_t limit = (std::numeric_limits<std::size_t>::max)();
    return limit;
  }

  std::size_t m_before;
};

} // namespace tbb

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_GLOBAL_CONTROL_H
