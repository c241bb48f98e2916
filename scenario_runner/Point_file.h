// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_POINT_FILE_H
#define SCENARIO_RUNNER_POINT_FILE_H

#include "scenario_runner/Csv_writer.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Output_file.h"

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>

namespace run {

// Whether the motion has names for ids, which can stand in a column of XYZ.
bool are_ids_words(const scenario::Any_motion& motion);

// A file of points in frames, for other programs. Where a motion has names for ids, and the format
// cannot have them, it gets numbers, and id_table_of(path) has the name of each.
class Point_file
{
public:
  // Extended XYZ says in the second line of a frame what the columns are. parse_xyz() and
  // parse_lammps_dump() read the same motion.
  enum class Format { EXTENDED_XYZ, LAMMPS_DUMP };

  Point_file(const std::string& path, Format format);

  bool is_xyz() const { return m_format == Format::EXTENDED_XYZ; }
  std::ostream& stream() { return m_file.stream(); }

  // To be called before the points of a frame.
  void name_ids(const scenario::Any_motion& motion);
  // Writes the id of the point in this place, and its species or type.
  void write_id(const scenario::Any_motion& motion, std::size_t place);

  void check() { m_file.check(); }
  void finish();

private:
  std::string m_path;
  Output_file m_file;
  std::optional<Csv_writer> m_id_table;
  Format m_format;
  bool m_has_words = false;
};

} // namespace run

#endif // SCENARIO_RUNNER_POINT_FILE_H
