// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_OUTPUT_FORMATS_H
#define SCENARIO_RUNNER_OUTPUT_FORMATS_H

#include "scenario_runner/Csv_writer.h"
#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Pictures.h"
#include "scenario_runner/Point_file.h"
#include "scenario_runner/Vtk_collection.h"

#include <optional>
#include <ostream>
#include <string>

namespace run {

// A row for each frame after the first one, as comma separated values. Times are in nanoseconds, of
// the whole frame.
class Frame_log : public Frame_output
{
public:
  explicit Frame_log(const std::string& path);

  void finish() override { m_file.finish(); }

private:
  void write(const Run_view& run) override;

  Csv_writer m_file;
};

// The points of some frames of a run in one file, a line each: id, species, x, y, z and the number
// of the set. Above them is the cell, if space is periodic, or else the box or that of the points.
class Point_log : public Frame_output
{
public:
  Point_log(const std::string& path, Point_file::Format format, const Frame_choice& choice,
            const std::optional<scenario::Box>& box);

  void finish() override { m_file.finish(); }

private:
  void write(const Run_view& run) override;

  Point_file m_file;
  std::optional<scenario::Box> m_box;
};

// A frame as an unstructured grid in VTK's XML format: all points in the order of the motion, and
// the triangles, whatever they are worth. In periodic space the cell is among the field data, and
// the images of points at which triangles have corners follow the points.
void write_vtk_grid(std::ostream& out, const Run_view& run);

// Some frames of a run in a directory, each as a VTK file, and a collection that lists them.
class Vtk_series : public Frame_output
{
public:
  Vtk_series(const std::string& directory, const Frame_choice& choice);

  void finish() override { m_collection.finish(); }

private:
  void write(const Run_view& run) override;

  Vtk_collection m_collection;
};

} // namespace run

#endif // SCENARIO_RUNNER_OUTPUT_FORMATS_H
