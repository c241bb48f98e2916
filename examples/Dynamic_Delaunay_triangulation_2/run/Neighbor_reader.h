// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_NEIGHBOR_READER_H
#define RUN_NEIGHBOR_READER_H

#include "../scenario/Motion.h"

#include <cstddef>
#include <cstdint>

namespace run {

// Who is whose neighbor in a triangulation, as a motion's physics asks for it. Keeps its memory.
class Neighbor_reader
{
public:
  // Ids are places in the motion. A motion that does not ask gets none.
  template <class Dynamic>
  const scenario::Neighbor_edges& operator()(const scenario::Motion& motion, const Dynamic& dt)
  {
    m_edges.clear();
    if (motion.uses_neighbors()) {
      dt.for_each_edge([this](std::size_t i, std::size_t j) {
        m_edges.emplace_back(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      });
    }
    return m_edges;
  }

private:
  scenario::Neighbor_edges m_edges;
};

} // namespace run

#endif // RUN_NEIGHBOR_READER_H
