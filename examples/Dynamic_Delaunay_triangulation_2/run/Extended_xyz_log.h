// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_EXTENDED_XYZ_LOG_H
#define RUN_EXTENDED_XYZ_LOG_H

#include "../scenario/Motion.h"
#include "Bounds.h"
#include "Exact_number.h"
#include "Frame_choice.h"
#include "Frame_record.h"
#include "Output_file.h"
#include "Vertex_sets.h"

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace run {

// The points of some frames of a run in the extended XYZ format, which says in the second line of
// a frame what the columns are. The points have a species because atoms have one: X, for unknown.
class Extended_xyz_log
{
public:
  Extended_xyz_log(const std::string& path, const Frame_choice& choice,
                   const std::optional<scenario::Box>& box)
    : m_file(path)
    , m_choice(choice)
    , m_box(box)
  {
  }

  template <class Run>
  void write(const Run& run)
  {
    if (m_choice.has(run.record().frame)) {
      write_head(run.motion(), run.record());
      write_points(run.motion(), sets_of_points(run));
    }
  }

  void finish() { m_file.finish(); }

private:
  void write_head(const scenario::Motion& motion, const Frame_record& record)
  {
    const Bounds bounds = cell_bounds(m_box, motion.points());
    m_file.stream() << motion.points().size() << "\nLattice=\"" << Exact_number{bounds.width()}
                    << " 0 0 0 " << Exact_number{bounds.height()} << " 0 0 0 1\" Origin=\""
                    << Exact_number{bounds.low.x} << ' ' << Exact_number{bounds.low.y}
                    << " -0.5\" pbc=\"F F F\" Properties=id:I:1:species:S:1:pos:R:3:set:I:1 Time="
                    << Exact_number{record.time} << " Frame=" << record.frame << '\n';
  }

  void write_points(const scenario::Motion& motion, const std::vector<unsigned>& sets)
  {
    for (std::size_t i = 0; i != sets.size(); ++i) {
      const scenario::Point& point = motion.points()[i];
      m_file.stream() << motion.ids()[i] << " X " << Exact_number{point.x} << ' '
                      << Exact_number{point.y} << " 0 " << sets[i] << '\n';
    }
  }

  Output_file m_file;
  Frame_choice m_choice;
  std::optional<scenario::Box> m_box;
};

} // namespace run

#endif // RUN_EXTENDED_XYZ_LOG_H
