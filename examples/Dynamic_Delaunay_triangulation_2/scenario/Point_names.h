// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_POINT_NAMES_H
#define SCENARIO_POINT_NAMES_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace scenario {

// Ids for points that have names: 0, 1, 2 and so on, in the order in which the names first appear.
class Point_names
{
public:
  std::int64_t id(std::string_view name)
  {
    const auto [place, is_new] = m_ids.emplace(name, static_cast<std::int64_t>(m_names.size()));
    if (is_new) {
      m_names.push_back(&place->first);
    }
    return place->second;
  }

  const std::string& name(std::int64_t id) const { return *m_names[static_cast<std::size_t>(id)]; }

private:
  std::unordered_map<std::string, std::int64_t> m_ids;
  std::vector<const std::string*> m_names;
};

} // namespace scenario

#endif // SCENARIO_POINT_NAMES_H
