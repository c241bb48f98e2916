// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Outputs_3.h"

#include "scenario_runner/Lammps_box.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
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

// The bounds as a cell that is not periodic.
scenario::Cell_3 open_cell(const Bounds_3& bounds)
{
  scenario::Cell_3 cell{bounds.low, {}, {}};
  for (std::size_t axis = 0; axis != dimension; ++axis) {
    cell.sides[axis][axis] = bounds.high[axis] - bounds.low[axis];
  }
  return cell;
}

void write_xyz_head(std::ostream& out, const Motion_run_3& run, const Bounds_3& bounds)
{
  const scenario::Cell_3 cell = run.motion().cell().value_or(open_cell(bounds));
  out << run.motion().points().size() << "\nLattice=\"";
  for (std::size_t i = 0; i != dimension; ++i) {
    out << (i == 0 ? "" : " ") << text_of(cell.sides[i]);
  }
  out << "\" Origin=\"" << text_of(cell.corner) << "\" pbc=\"";
  for (std::size_t i = 0; i != dimension; ++i) {
    out << (i == 0 ? "" : " ") << (cell.is_periodic[i] ? 'T' : 'F');
  }
  out << "\" Properties=id:" << (are_ids_words(run.motion()) ? 'S' : 'I')
      << ":1:species:S:1:pos:R:3 Time=" << number_text(run.motion().time())
      << " Frame=" << run.record().number << '\n';
}

// The time stands before the time step, as LAMMPS itself has it.
void write_lammps_head(std::ostream& out, const Motion_run_3& run, const Bounds_3& bounds)
{
  out << "ITEM: TIME\n"
      << number_text(run.motion().time()) << "\nITEM: TIMESTEP\n"
      << run.record().number << "\nITEM: NUMBER OF ATOMS\n"
      << run.motion().points().size() << '\n';
  if (const auto cell = run.motion().cell()) {
    scenario::write_lammps_box(out, *cell);
  } else {
    out << "ITEM: BOX BOUNDS ff ff ff\n";
    for (std::size_t axis = 0; axis != dimension; ++axis) {
      out << number_text(bounds.low[axis]) << ' ' << number_text(bounds.high[axis]) << '\n';
    }
  }
  out << "ITEM: ATOMS id type x y z\n";
}

// What a grid of the frame has: the points of the motion, then the images that cells across the
// sides of a periodic cell need.
class Grid_points_3
{
public:
  explicit Grid_points_3(const Motion_run_3& run)
    : m_cell(run.motion().cell())
    , m_points(run.motion().points())
    , m_number_of_originals(m_points.size())
  {
    for (const Shown_cell_3& cell : run.cells()) {
      std::array<std::size_t, 4>& corners = m_corners.emplace_back();
      for (std::size_t i = 0; i != corners.size(); ++i) {
        corners[i] = number_of(cell.places[i], cell.shifts[i]);
      }
    }
  }

  std::size_t size() const { return m_points.size(); }
  const scenario::Point_3& point(std::size_t i) const { return m_points[i]; }
  bool is_image(std::size_t i) const { return i >= m_number_of_originals; }
  // The place in the motion of a point, or of the one of which it is an image.
  std::size_t original(std::size_t i) const
  {
    return is_image(i) ? m_originals[i - m_number_of_originals] : i;
  }
  const std::vector<std::array<std::size_t, 4>>& corners_of_cells() const { return m_corners; }

private:
  using Image = std::tuple<std::size_t, int, int, int>; // a place and a shift

  std::size_t number_of(std::size_t place, const scenario::Shift_3& shift)
  {
    if (shift == scenario::Shift_3{}) {
      return place;
    }
    const auto [a, b, c] = shift;
    const auto [found, is_new] = m_images.try_emplace(Image(place, a, b, c), m_points.size());
    if (is_new) {
      m_points.push_back(m_cell->image(m_points[place], shift));
      m_originals.push_back(place);
    }
    return found->second;
  }

  std::optional<scenario::Cell_3> m_cell;
  std::vector<scenario::Point_3> m_points;
  std::size_t m_number_of_originals;
  std::vector<std::size_t> m_originals; // of images
  std::map<Image, std::size_t> m_images;
  std::vector<std::array<std::size_t, 4>> m_corners;
};

// Writes the corner of a cell, where its sides begin, and its sides.
void write_grid_cell(std::ostream& out, const scenario::Cell_3& cell)
{
  write_vtk_array(out,
                  R"(type="Float64" Name="CellCorner" NumberOfComponents="3" NumberOfTuples="1")",
                  1, [&](std::size_t) { return text_of(cell.corner); });
  write_vtk_array(out,
                  R"(type="Float64" Name="CellSides" NumberOfComponents="3" NumberOfTuples="3")", 3,
                  [&](std::size_t i) { return text_of(cell.sides[i]); });
  write_vtk_array(out, R"(type="UInt8" Name="CellIsPeriodic" NumberOfTuples="3")", 3,
                  [&](std::size_t i) { return cell.is_periodic[i] ? 1 : 0; });
}

} // namespace

void write_vtk_grid(std::ostream& out, const Motion_run_3& run)
{
  constexpr int tetrahedron_type = 10; // VTK_TETRA
  const scenario::Motion_3& motion = run.motion();
  const Grid_points_3 points(run);
  const auto& cells = points.corners_of_cells();
  const auto cell = motion.cell();
  begin_vtk_grid(out, motion.time(), run.record().number);
  if (cell) {
    write_grid_cell(out, *cell);
  }
  out << "</FieldData>\n<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfCells=\""
      << cells.size() << "\">\n<PointData>\n";
  write_vtk_array(out, R"(type="Int64" Name="id")", points.size(),
                  [&](std::size_t i) { return motion.ids()[points.original(i)]; });
  if (motion.names()) {
    write_vtk_array(out, R"(type="String" Name="name")", points.size(),
                    [&](std::size_t i) { return vtk_text(motion.id_text(points.original(i))); });
  }
  if (cell) {
    write_vtk_array(out, R"(type="UInt8" Name="image")", points.size(),
                    [&](std::size_t i) { return points.is_image(i) ? 1 : 0; });
  }
  out << "</PointData>\n<Points>\n";
  write_vtk_array(out, R"(type="Float64" Name="Points" NumberOfComponents="3")", points.size(),
                  [&](std::size_t i) { return text_of(points.point(i)); });
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

// What is infinite is left empty.
void Outputs_3::write_cells(const Motion_run_3& run)
{
  const scenario::Motion_3& motion = run.motion();
  const std::vector<Measured_cell_3> cells = run.measured_cells(m_measures);
  const auto finite = [](double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  for (std::size_t i = 0; i != motion.points().size(); ++i) {
    const auto& [volume, surface_area, contacts] = cells[i];
    const auto& [x, y, z] = motion.points()[i];
    m_cells->write(run.record().number, motion.time(), motion.id_text(i), x, y, z, finite(volume),
                   finite(volume > 0.0 ? 1.0 / volume : std::numeric_limits<double>::infinity()),
                   finite(surface_area), contacts);
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
