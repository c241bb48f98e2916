// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Outputs_3.h"

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace run {

namespace {

constexpr std::size_t dimension = 3;

std::string text_of(const scenario::Point_3& p)
{
  return number_text(p[0]) + ' ' + number_text(p[1]) + ' ' + number_text(p[2]);
}

struct Bounds_3
{
  scenario::Point_3 low{};
  scenario::Point_3 high{};
};

// A side without a length is made to have length 1: programs that show a box divide by it.
Bounds_3 bounds_of(const std::vector<scenario::Point_3>& points)
{
  Bounds_3 bounds;
  if (!points.empty()) {
    bounds = {points.front(), points.front()};
  }
  for (std::size_t axis = 0; axis != dimension; ++axis) {
    double& low = bounds.low[axis];
    double& high = bounds.high[axis];
    for (const scenario::Point_3& point : points) {
      low = (std::min)(low, point[axis]);
      high = (std::max)(high, point[axis]);
    }
    if (low == high) {
      low -= 0.5;
      high = low + 1.0;
    }
  }
  return bounds;
}

void write_xyz_head(std::ostream& out, const Motion_run_3& run, const Bounds_3& bounds)
{
  out << run.motion().points().size() << "\nLattice=\"";
  for (std::size_t axis = 0; axis != dimension; ++axis) {
    scenario::Point_3 side{};
    side[axis] = bounds.high[axis] - bounds.low[axis];
    out << (axis == 0 ? "" : " ") << text_of(side);
  }
  out << "\" Origin=\"" << text_of(bounds.low)
      << "\" pbc=\"F F F\" Properties=id:" << (are_ids_words(run.motion()) ? 'S' : 'I')
      << ":1:species:S:1:pos:R:3 Time=" << number_text(run.motion().time())
      << " Frame=" << run.record().number << '\n';
}

// The time stands before the time step, as LAMMPS itself has it.
void write_lammps_head(std::ostream& out, const Motion_run_3& run, const Bounds_3& bounds)
{
  out << "ITEM: TIME\n"
      << number_text(run.motion().time()) << "\nITEM: TIMESTEP\n"
      << run.record().number << "\nITEM: NUMBER OF ATOMS\n"
      << run.motion().points().size() << "\nITEM: BOX BOUNDS ff ff ff\n";
  for (std::size_t axis = 0; axis != dimension; ++axis) {
    out << number_text(bounds.low[axis]) << ' ' << number_text(bounds.high[axis]) << '\n';
  }
  out << "ITEM: ATOMS id type x y z\n";
}

} // namespace

void write_vtk_grid(std::ostream& out, const Motion_run_3& run)
{
  constexpr int tetrahedron_type = 10; // VTK_TETRA
  const scenario::Motion_3& motion = run.motion();
  const std::size_t points = motion.points().size();
  const auto cells = run.cells();
  begin_vtk_grid(out, motion.time(), run.record().number);
  out << "</FieldData>\n<Piece NumberOfPoints=\"" << points << "\" NumberOfCells=\"" << cells.size()
      << "\">\n<PointData>\n";
  write_vtk_array(out, R"(type="Int64" Name="id")", points,
                  [&](std::size_t i) { return motion.ids()[i]; });
  if (motion.names()) {
    write_vtk_array(out, R"(type="String" Name="name")", points,
                    [&](std::size_t i) { return vtk_text(motion.id_text(i)); });
  }
  out << "</PointData>\n<Points>\n";
  write_vtk_array(out, R"(type="Float64" Name="Points" NumberOfComponents="3")", points,
                  [&](std::size_t i) { return text_of(motion.points()[i]); });
  out << "</Points>\n<Cells>\n";
  write_vtk_array(out, R"(type="Int64" Name="connectivity")", cells.size(), [&](std::size_t i) {
    const auto& [a, b, c, d] = cells[i];
    return std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + ' ' +
           std::to_string(d);
  });
  write_vtk_array(out, R"(type="Int64" Name="offsets")", cells.size(),
                  [](std::size_t i) { return 4 * (i + 1); });
  write_vtk_array(out, R"(type="UInt8" Name="types")", cells.size(),
                  [](std::size_t) { return tetrahedron_type; });
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

Outputs_3::Outputs_3(const Run_options& options, std::size_t frames)
  : m_seen(options.every ? Frame_choice(frames, *options.every) : about_thirty(frames))
  , m_recorded(frames, options.every.value_or(1))
  , m_progress(frames, !options.quiet)
{
  if (options.csv) {
    m_csv.emplace(*options.csv, std::vector<std::string>{
                                    "frame", "time", "points", "population_changed", "certified",
                                    "rebuild_reason", "unproved", "flips", "held", "relocated",
                                    "inserted", "removed", "merged", "parted", "dynamic_ns",
                                    "static_insert_ns", "static_fastest_ns"});
  }
  if (options.vtk) {
    m_vtk.emplace(*options.vtk);
  }
  if (options.xyz) {
    m_xyz.emplace(*options.xyz, Point_file::Format::EXTENDED_XYZ);
  }
  if (options.lammps) {
    m_lammps.emplace(*options.lammps, Point_file::Format::LAMMPS_DUMP);
  }
  if (options.cells) {
    m_cells.emplace(*options.cells,
                    std::vector<std::string>{"frame", "time", "id", "x", "y", "z", "volume",
                                             "density", "surface_area", "contacts"});
  }
}

void Outputs_3::take(const Motion_run_3& run)
{
  const Frame_record_3& record = run.record();
  if (m_csv && record.frame != 0) {
    write_row(record);
  }
  if (m_vtk && m_seen.has(record.frame)) {
    m_vtk->add(record.number, record.time, [&](std::ostream& out) { write_vtk_grid(out, run); });
  }
  for (std::optional<Point_file>* const file : {&m_xyz, &m_lammps}) {
    if (*file && m_recorded.has(record.frame)) {
      write_points(**file, run);
    }
  }
  if (m_cells && m_recorded.has(record.frame)) {
    write_cells(run);
  }
  m_progress.show(record.frame);
}

void Outputs_3::finish()
{
  for (std::optional<Csv_writer>* const table : {&m_csv, &m_cells}) {
    if (*table) {
      (*table)->finish();
    }
  }
  if (m_vtk) {
    m_vtk->finish();
  }
  for (std::optional<Point_file>* const file : {&m_xyz, &m_lammps}) {
    if (*file) {
      (*file)->finish();
    }
  }
}

void Outputs_3::write_row(const Frame_record_3& record)
{
  const CGAL::Update_report_3& update = record.update;
  m_csv->write(record.number, record.time, record.points, record.population_changed,
               record.certified, rebuild_reason_name(update.rebuild_reason), update.unproved,
               update.flips, update.held, update.relocated, update.inserted, update.removed,
               update.merged, update.parted, record.nanoseconds.dynamic,
               record.nanoseconds.static_insert, record.nanoseconds.static_fastest);
}

// The cells in the motion's box, or whole ones; what is infinite is left empty.
void Outputs_3::write_cells(const Motion_run_3& run)
{
  const scenario::Motion_3& motion = run.motion();
  const auto box = motion.box();
  if (box) {
    m_measures.compute(run.triangulation(),
                       CGAL::Bbox_3(0.0, 0.0, 0.0, (*box)[0], (*box)[1], (*box)[2]));
  } else {
    m_measures.compute(run.triangulation());
  }
  const auto finite = [](double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  for (std::size_t i = 0; i != motion.points().size(); ++i) {
    const std::size_t id = run.id(i), shared = run.triangulation().representative(id);
    const auto& [x, y, z] = motion.points()[i];
    const double volume = m_measures.volumes()[id];
    m_cells->write(run.record().number, motion.time(), motion.id_text(i), x, y, z, finite(volume),
                   finite(volume > 0.0 ? 1.0 / volume : std::numeric_limits<double>::infinity()),
                   finite(m_measures.surface_areas()[id]),
                   m_measures.offsets()[shared + 1] - m_measures.offsets()[shared]);
  }
}

void Outputs_3::write_points(Point_file& file, const Motion_run_3& run)
{
  std::ostream& out = file.stream();
  const std::vector<scenario::Point_3>& points = run.motion().points();
  const Bounds_3 bounds = bounds_of(points);
  if (file.is_xyz()) {
    write_xyz_head(out, run, bounds);
  } else {
    write_lammps_head(out, run, bounds);
  }
  file.name_ids(run.motion());
  for (std::size_t i = 0; i != points.size(); ++i) {
    file.write_id(run.motion(), i);
    out << text_of(points[i]) << '\n';
  }
  file.check();
}

} // namespace run
