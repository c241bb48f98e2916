// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_OUTPUTS_3_H
#define SCENARIO_RUNNER_SPACE_OUTPUTS_3_H

#include "scenario_runner/Csv_writer.h"
#include "scenario_runner/Pictures.h"
#include "scenario_runner/Point_file.h"
#include "scenario_runner/Progress.h"
#include "scenario_runner/Run_options.h"
#include "scenario_runner/space/Motion_run_3.h"
#include "scenario_runner/Vtk_collection.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>

#include <cstddef>
#include <optional>
#include <ostream>

namespace run {

// A frame as an unstructured grid in VTK's XML format: all points in the order of the motion, then
// the images that only cells across the sides of a periodic cell need, and the cells as tetrahedra.
void write_vtk_grid(std::ostream& out, const Motion_run_3& run);

// The files that a run in space writes while its frames pass. They are opened before the first
// frame, so that a wrong path is reported at once.
class Outputs_3
{
public:
  Outputs_3(const Run_options& options, std::size_t frames);

  // To be called with every frame, from the first one on.
  void take(const Motion_run_3& run);

  // To be called after the last frame: only then files have their names.
  void finish();

private:
  void write_row(const Frame_record_3& record);
  void write_points(Point_file& file, const Motion_run_3& run);
  void write_cells(const Motion_run_3& run);

  Frame_choice m_seen;     // by people, in pictures
  Frame_choice m_recorded; // by programs
  std::optional<Csv_writer> m_csv;
  std::optional<Vtk_collection> m_vtk;
  std::optional<Point_file> m_xyz;
  std::optional<Point_file> m_lammps;
  std::optional<Csv_writer> m_cells;
  CGAL::Voronoi_cell_measures_3 m_measures;
  Progress_display m_progress;
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_OUTPUTS_3_H
