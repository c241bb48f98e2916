// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices and faces that carry a stamp, unique in the program: handles change, and the stamp shows
// whether a point still has the vertex that it had.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_STAMPS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_STAMPS_H

#include <CGAL/Indexed_triangulation_data_structure_2.h>

#include <cstddef>
#include <map>
#include <type_traits>
#include <vector>

struct Stamp
{
  std::size_t value = next();

private:
  static std::size_t next()
  {
    static std::size_t next = 0;
    return next++;
  }
};

template <class Traits>
using Stamped_data_structure = CGAL::Indexed_triangulation_data_structure_2<Traits, Stamp, Stamp>;

template <class Dynamic>
constexpr bool has_stamps =
    std::is_same_v<typename Dynamic::Triangulation_data_structure::Vertex_info, Stamp>;

// 0 where vertices have no stamps.
template <class Dynamic>
std::size_t stamp_of([[maybe_unused]] const Dynamic& dt, [[maybe_unused]] std::size_t id)
{
  if constexpr (has_stamps<Dynamic>)
    return dt.vertex(id)->info().value;
  return 0;
}

// The stamps of the vertices that only one point has, by the ids of these points.
template <class Dynamic>
std::map<std::size_t, std::size_t> stamps_of(const Dynamic& dt)
{
  std::map<std::size_t, std::vector<std::size_t>> ids_at;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id))
      ids_at[stamp_of(dt, id)].push_back(id);
  std::map<std::size_t, std::size_t> stamps;
  if (!has_stamps<Dynamic>)
    return stamps;
  for (const auto& [stamp, ids] : ids_at)
    if (ids.size() == 1)
      stamps.emplace(ids.front(), stamp);
  return stamps;
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_STAMPS_H
