// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_LAMMPS_LOG_H
#define RUN_LAMMPS_LOG_H

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

// The points of some frames of a run as a text dump of LAMMPS, which scenario/Lammps_dump.h reads
// as the same motion. All atoms are of type 1.
class Lammps_log
{
public:
  Lammps_log(const std::string& path, const Frame_choice& choice,
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
      write_atoms(run.motion(), sets_of_points(run));
    }
  }

  void finish() { m_file.finish(); }

private:
  // The time stands before the time step, as LAMMPS itself has it.
  void write_head(const scenario::Motion& motion, const Frame_record& record)
  {
    const Bounds bounds = cell_bounds(m_box, motion.points());
    m_file.stream() << "ITEM: TIME\n"
                    << Exact_number{record.time} << "\nITEM: TIMESTEP\n"
                    << record.frame << "\nITEM: NUMBER OF ATOMS\n"
                    << motion.points().size() << "\nITEM: BOX BOUNDS ff ff ff\n"
                    << Exact_number{bounds.low.x} << ' ' << Exact_number{bounds.high.x} << '\n'
                    << Exact_number{bounds.low.y} << ' ' << Exact_number{bounds.high.y}
                    << "\n-0.5 0.5\nITEM: ATOMS id type x y z set\n";
  }

  void write_atoms(const scenario::Motion& motion, const std::vector<unsigned>& sets)
  {
    for (std::size_t i = 0; i != sets.size(); ++i) {
      const scenario::Point& point = motion.points()[i];
      m_file.stream() << motion.ids()[i] << " 1 " << Exact_number{point.x} << ' '
                      << Exact_number{point.y} << " 0 " << sets[i] << '\n';
    }
  }

  Output_file m_file;
  Frame_choice m_choice;
  std::optional<scenario::Box> m_box;
};

} // namespace run

#endif // RUN_LAMMPS_LOG_H
