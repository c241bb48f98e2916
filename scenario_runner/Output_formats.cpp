// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Output_formats.h"

#include "scenario_runner/Lammps_box.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <algorithm>
#include <map>
#include <utility>

namespace run {

namespace {

// Programs that show a cell divide by the lengths of its sides. A side without a length is made to
// reach from the origin, or to have length 1 at the origin.
void widen(double& low, double& high)
{
  if (low == high) {
    low = (std::min)(low, 0.0);
    high = low == 0.0 && high == 0.0 ? 1.0 : (std::max)(high, 0.0);
  }
}

Bounds cell_bounds(const std::optional<scenario::Box>& box,
                   const std::vector<scenario::Point>& points)
{
  Bounds bounds = frame_bounds(box, points);
  widen(bounds.low.x, bounds.high.x);
  widen(bounds.low.y, bounds.high.y);
  return bounds;
}

// The cell, or the bounds as one that is not periodic.
scenario::Cell written_cell(const Run_view& run, const Bounds& bounds)
{
  return run.motion().cell().value_or(scenario::Cell{
      bounds.low, {{{bounds.width(), 0.0}, {0.0, bounds.height()}}}, {false, false}});
}

void write_xyz_head(std::ostream& out, const Run_view& run, const Bounds& bounds)
{
  const scenario::Cell cell = written_cell(run, bounds);
  const auto letter = [](bool is_periodic) { return is_periodic ? "T " : "F "; };
  out << run.motion().points().size() << "\nLattice=\"";
  for (const scenario::Point& side : cell.sides) {
    out << number_text(side.x) << ' ' << number_text(side.y) << " 0 ";
  }
  out << "0 0 1\" Origin=\"" << number_text(cell.corner.x) << ' ' << number_text(cell.corner.y)
      << " -0.5\" pbc=\"" << letter(cell.is_periodic[0]) << letter(cell.is_periodic[1])
      << "F\" Properties=id:" << (are_ids_words(run.motion()) ? 'S' : 'I')
      << ":1:species:S:1:pos:R:3:set:I:1 Time=" << number_text(run.motion().time())
      << " Frame=" << run.record().number << '\n';
}

// The time stands before the time step, as LAMMPS itself has it.
void write_lammps_head(std::ostream& out, const Run_view& run, const Bounds& bounds)
{
  out << "ITEM: TIME\n"
      << number_text(run.motion().time()) << "\nITEM: TIMESTEP\n"
      << run.record().number << "\nITEM: NUMBER OF ATOMS\n"
      << run.motion().points().size() << '\n';
  if (const auto cell = run.motion().cell()) {
    scenario::write_lammps_box(out, *cell);
  } else {
    out << "ITEM: BOX BOUNDS ff ff ff\n"
        << number_text(bounds.low.x) << ' ' << number_text(bounds.high.x) << '\n'
        << number_text(bounds.low.y) << ' ' << number_text(bounds.high.y) << "\n-0.5 0.5\n";
  }
  out << "ITEM: ATOMS id type x y z set\n";
}

// The points of a grid, and its triangles by their places among these points: first the points of
// the motion, then the images that only triangles across the sides of the cell need.
class Grid_points
{
public:
  explicit Grid_points(const Run_view& run)
    : m_points(run.motion().points())
    , m_cell(run.motion().cell())
    , m_number_of_originals(m_points.size())
    , m_triangles(run.triangles())
  {
    for (std::size_t i = 0; i != m_points.size(); ++i) {
      m_originals.push_back(i);
    }
    for (Shown_triangle& triangle : m_triangles) {
      for (std::size_t i = 0; i != 3; ++i) {
        if (triangle.shifts[i] != scenario::Shift{0, 0}) {
          triangle.corners[i] = image(triangle.corners[i], triangle.shifts[i]);
        }
      }
    }
  }

  std::size_t size() const { return m_points.size(); }
  const scenario::Point& point(std::size_t i) const { return m_points[i]; }
  // The place in the motion.
  std::size_t original(std::size_t i) const { return m_originals[i]; }
  bool is_image(std::size_t i) const { return i >= m_number_of_originals; }
  const std::vector<Shown_triangle>& triangles() const { return m_triangles; }

private:
  std::size_t image(std::size_t place, const scenario::Shift& shift)
  {
    const auto [found, is_new] = m_images.emplace(std::pair(place, shift), m_points.size());
    if (is_new) {
      m_points.push_back(m_cell->image(m_points[place], shift));
      m_originals.push_back(place);
    }
    return found->second;
  }

  std::vector<scenario::Point> m_points;
  std::optional<scenario::Cell> m_cell;
  std::size_t m_number_of_originals;
  std::vector<std::size_t> m_originals;
  std::map<std::pair<std::size_t, scenario::Shift>, std::size_t> m_images;
  std::vector<Shown_triangle> m_triangles;
};

std::string space_text(const scenario::Point& p)
{
  return number_text(p.x) + ' ' + number_text(p.y) + " 0";
}

// Writes the corner of a cell, where its sides begin, and its sides.
void write_grid_cell(std::ostream& out, const scenario::Cell& cell)
{
  write_vtk_array(out,
                  R"(type="Float64" Name="CellCorner" NumberOfComponents="3" NumberOfTuples="1")",
                  1, [&](std::size_t) { return space_text(cell.corner); });
  write_vtk_array(out,
                  R"(type="Float64" Name="CellSides" NumberOfComponents="3" NumberOfTuples="2")", 2,
                  [&](std::size_t i) { return space_text(cell.sides[i]); });
  write_vtk_array(out, R"(type="UInt8" Name="CellIsPeriodic" NumberOfTuples="2")", 2,
                  [&](std::size_t i) { return cell.is_periodic[i] ? 1 : 0; });
}

} // namespace

Frame_log::Frame_log(const std::string& path)
  : Frame_output({0, 1})
  , m_file(path,
           {"frame", "time", "points", "population_changed", "certified", "mcc", "rebuild_reason",
            "classified", "padded", "border", "flips", "splices", "enlargements", "relocated",
            "dynamic_ns", "static_insert_ns", "static_fastest_ns"})
{
}

void Frame_log::write(const Run_view& run)
{
  const Frame_record& record = run.record();
  if (record.frame == 0) {
    return;
  }
  const CGAL::Update_report_2& update = record.update;
  m_file.write(record.number, record.time, record.points, record.population_changed,
               record.certified, record.validity, rebuild_reason_name(update.rebuild_reason),
               update.classified, update.padded, update.border, update.flips, update.splices,
               update.enlargements, update.relocated, record.nanoseconds.dynamic,
               record.nanoseconds.static_insert, record.nanoseconds.static_fastest);
}

Point_log::Point_log(const std::string& path, Point_file::Format format, const Frame_choice& choice,
                     const std::optional<scenario::Box>& box)
  : Frame_output(choice)
  , m_file(path, format)
  , m_box(box)
{
}

void Point_log::write(const Run_view& run)
{
  std::ostream& out = m_file.stream();
  const auto& points = run.motion().points();
  const Bounds bounds = cell_bounds(m_box, points);
  if (m_file.is_xyz()) {
    write_xyz_head(out, run, bounds);
  } else {
    write_lammps_head(out, run, bounds);
  }
  m_file.name_ids(run.motion());
  const std::vector<Vertex_set> sets = run.sets();
  for (std::size_t i = 0; i != points.size(); ++i) {
    m_file.write_id(run.motion(), i);
    out << number_text(points[i].x) << ' ' << number_text(points[i].y) << " 0 "
        << static_cast<unsigned>(sets[i]) << '\n';
  }
  m_file.check();
}

void write_vtk_grid(std::ostream& out, const Run_view& run)
{
  constexpr int triangle_type = 5; // VTK_TRIANGLE
  const scenario::Motion& motion = run.motion();
  const Grid_points points(run);
  const std::vector<Vertex_set> sets = run.sets();
  const std::vector<Shown_triangle>& triangles = points.triangles();
  const auto cell = motion.cell();
  begin_vtk_grid(out, motion.time(), run.record().number);
  if (cell) {
    write_grid_cell(out, *cell);
  }
  out << "</FieldData>\n<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfCells=\""
      << triangles.size() << "\">\n<PointData Scalars=\"set\">\n";
  write_vtk_array(out, R"(type="Int64" Name="id")", points.size(),
                  [&](std::size_t i) { return motion.ids()[points.original(i)]; });
  if (motion.names()) {
    write_vtk_array(out, R"(type="String" Name="name")", points.size(),
                    [&](std::size_t i) { return vtk_text(motion.id_text(points.original(i))); });
  }
  write_vtk_array(out, R"(type="UInt8" Name="set")", points.size(),
                  [&](std::size_t i) { return static_cast<unsigned>(sets[points.original(i)]); });
  if (cell) {
    write_vtk_array(out, R"(type="UInt8" Name="image")", points.size(),
                    [&](std::size_t i) { return points.is_image(i) ? 1 : 0; });
  }
  out << "</PointData>\n<CellData>\n";
  write_vtk_array(out, R"(type="UInt8" Name="delaunay")", triangles.size(),
                  [&](std::size_t i) { return triangles[i].is_delaunay ? 1 : 0; });
  out << "</CellData>\n<Points>\n";
  write_vtk_array(out, R"(type="Float64" Name="Points" NumberOfComponents="3")", points.size(),
                  [&](std::size_t i) { return space_text(points.point(i)); });
  out << "</Points>\n<Cells>\n";
  write_vtk_array(out, R"(type="Int64" Name="connectivity")", triangles.size(), [&](std::size_t i) {
    const auto& [a, b, c] = triangles[i].corners;
    return std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c);
  });
  write_vtk_array(out, R"(type="Int64" Name="offsets")", triangles.size(),
                  [](std::size_t i) { return 3 * (i + 1); });
  write_vtk_array(out, R"(type="UInt8" Name="types")", triangles.size(),
                  [](std::size_t) { return triangle_type; });
  out << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

Vtk_series::Vtk_series(const std::string& directory, const Frame_choice& choice)
  : Frame_output(choice)
  , m_collection(directory)
{
}

void Vtk_series::write(const Run_view& run)
{
  m_collection.add(run.record().number, run.record().time,
                   [&](std::ostream& out) { write_vtk_grid(out, run); });
}

} // namespace run
