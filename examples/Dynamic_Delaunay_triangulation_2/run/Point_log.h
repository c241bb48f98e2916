// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_POINT_LOG_H
#define RUN_POINT_LOG_H

#include "../scenario/Motion.h"
#include "../scenario/Scenario_description.h"
#include "Bounds.h"
#include "Exact_number.h"
#include "Frame_choice.h"
#include "Output_file.h"
#include "Vertex_sets.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace run {

// The points of some frames of a run in one file, a line each: id, species, x, y, z and the number
// of the set. `Format::write_head(out, motion, bounds, frame)` writes what stands above them,
// `Format::species` is what all points are.
template <class Format>
class Point_log
{
public:
  Point_log(const std::string& path, const Frame_choice& choice,
            const std::optional<scenario::Box>& box)
    : m_file(path)
    , m_choice(choice)
    , m_box(box)
  {
  }

  template <class Run>
  void write(const Run& run)
  {
    const std::size_t frame = run.record().frame;
    if (m_choice.has(frame)) {
      const scenario::Motion& motion = run.motion();
      Format::write_head(m_file.stream(), motion, cell_bounds(m_box, motion.points()), frame);
      write_points(motion, sets_of_points(run));
      m_file.check();
    }
  }

  void finish() { m_file.finish(); }

private:
  void write_points(const scenario::Motion& motion, const std::vector<unsigned>& sets)
  {
    for (std::size_t i = 0; i != sets.size(); ++i) {
      const scenario::Point& point = motion.points()[i];
      m_file.stream() << motion.ids()[i] << ' ' << Format::species << ' ' << Exact_number{point.x}
                      << ' ' << Exact_number{point.y} << " 0 " << sets[i] << '\n';
    }
  }

  Output_file m_file;
  Frame_choice m_choice;
  std::optional<scenario::Box> m_box;
};

} // namespace run

#endif // RUN_POINT_LOG_H
