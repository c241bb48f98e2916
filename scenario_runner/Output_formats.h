// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_OUTPUT_FORMATS_H
#define SCENARIO_RUNNER_OUTPUT_FORMATS_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Output_file.h"
#include "scenario_runner/Pictures.h"
#include "scenario_runner/Scenario_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace run {

// A row for each frame, as comma separated values. Times are in nanoseconds, of the whole frame.
class Frame_log
{
public:
  explicit Frame_log(const std::string& path)
    : m_file(path)
  {
    m_file.stream() << "frame,time,points,population_changed,certified,mcc,rebuild_reason,"
                       "classified,padded,border,flips,splices,enlargements,relocated,"
                       "dynamic_ns,static_insert_ns,static_fastest_ns\n";
  }

  void write(const Frame_record& record)
  {
    const CGAL::Update_report_2& update = record.update;
    m_file.stream() << record.frame << ',' << Exact_number{record.time} << ',' << record.points
                    << ',' << record.population_changed << ',' << record.certified << ','
                    << Exact_number{record.validity} << ','
                    << rebuild_reason_name(update.rebuild_reason) << ',' << update.classified << ','
                    << update.padded << ',' << update.border << ',' << update.flips << ','
                    << update.splices << ',' << update.enlargements << ',' << update.relocated
                    << ',' << Exact_number{record.nanoseconds.dynamic} << ','
                    << Exact_number{record.nanoseconds.static_insert} << ','
                    << Exact_number{record.nanoseconds.static_fastest} << '\n';
    m_file.check();
  }

  void finish() { m_file.finish(); }

private:
  Output_file m_file;
};

// The extended XYZ format, which says in the second line of a frame what the columns are. The
// points have a species because atoms have one: X, for unknown.
struct Extended_xyz_format
{
  static constexpr char species = 'X';

  static void write_head(std::ostream& out, const scenario::Motion& motion, const Bounds& bounds,
                         std::size_t frame)
  {
    out << motion.points().size() << "\nLattice=\"" << Exact_number{bounds.width()} << " 0 0 0 "
        << Exact_number{bounds.height()} << " 0 0 0 1\" Origin=\"" << Exact_number{bounds.low.x}
        << ' ' << Exact_number{bounds.low.y}
        << " -0.5\" pbc=\"F F F\" Properties=id:I:1:species:S:1:pos:R:3:set:I:1 Time="
        << Exact_number{motion.time()} << " Frame=" << frame << '\n';
  }
};

// A text dump of LAMMPS, which scenario/Lammps_dump.h reads as the same motion. All atoms are of
// type 1.
struct Lammps_format
{
  static constexpr char species = '1';

  // The time stands before the time step, as LAMMPS itself has it.
  static void write_head(std::ostream& out, const scenario::Motion& motion, const Bounds& bounds,
                         std::size_t frame)
  {
    out << "ITEM: TIME\n"
        << Exact_number{motion.time()} << "\nITEM: TIMESTEP\n"
        << frame << "\nITEM: NUMBER OF ATOMS\n"
        << motion.points().size() << "\nITEM: BOX BOUNDS ff ff ff\n"
        << Exact_number{bounds.low.x} << ' ' << Exact_number{bounds.high.x} << '\n'
        << Exact_number{bounds.low.y} << ' ' << Exact_number{bounds.high.y}
        << "\n-0.5 0.5\nITEM: ATOMS id type x y z set\n";
  }
};

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

// A frame as an unstructured grid in VTK's XML format: all points in the order of the motion, and
// the triangles, whatever they are worth. Points that coincide share those of the first of them.
template <class Run>
class Vtk_grid
{
public:
  explicit Vtk_grid(const Run& run)
    : m_motion(run.motion())
    , m_sets(sets_of_points(run))
    , m_frame(run.triangulation().frame())
  {
    find_places(run);
    find_triangles();
  }

  void write(std::ostream& out) const
  {
    out << "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           "<UnstructuredGrid>\n";
    write_time(out);
    out << "<Piece NumberOfPoints=\"" << m_sets.size() << "\" NumberOfCells=\""
        << m_triangles.size() << "\">\n";
    write_point_data(out);
    write_cell_data(out);
    write_points(out);
    write_cells(out);
    out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }

private:
  using Frame = typename Run::Dynamic::Frame;
  using Index = typename Frame::Index;

  struct Triangle
  {
    std::array<std::size_t, 3> places;
    bool is_delaunay;
  };

  void find_places(const Run& run)
  {
    m_place_of_vertex.resize(m_frame.number_of_vertices() + std::size_t(1));
    for (std::size_t place = m_sets.size(); place-- != 0;) {
      m_place_of_vertex[run.vertex(place)] = place;
    }
  }

  void find_triangles()
  {
    const std::vector<bool> is_delaunay = faces_that_are_delaunay();
    for (Index f = 0; f != m_frame.number_of_faces(); ++f) {
      const std::array<Index, 3> face = m_frame.face(f);
      if (std::none_of(face.begin(), face.end(), [](Index v) { return Frame::is_infinite(v); })) {
        m_triangles.push_back(
            {{m_place_of_vertex[face[0]], m_place_of_vertex[face[1]], m_place_of_vertex[face[2]]},
             is_delaunay[f]});
      }
    }
  }

  // Those whose edges all need no repair.
  std::vector<bool> faces_that_are_delaunay() const
  {
    std::vector<bool> are_delaunay(m_frame.number_of_faces(), true);
    for (Index e = 0; e != m_frame.number_of_edges(); ++e) {
      if (!m_frame.is_delaunay(e)) {
        for (const Index f : m_frame.faces_at(e)) {
          are_delaunay[f] = false;
        }
      }
    }
    return are_delaunay;
  }

  // `write_value(i)` writes what the array has for the i-th of `size` things.
  template <class Write_value>
  static void write_array(std::ostream& out, const std::string& attributes, std::size_t size,
                          const Write_value& write_value)
  {
    out << "<DataArray " << attributes << " format=\"ascii\">\n";
    for (std::size_t i = 0; i != size; ++i) {
      write_value(i);
      out << '\n';
    }
    out << "</DataArray>\n";
  }

  void write_time(std::ostream& out) const
  {
    out << "<FieldData>\n";
    write_array(out, R"(type="Float64" Name="TimeValue" NumberOfTuples="1")", 1,
                [&](std::size_t) { out << Exact_number{m_motion.time()}; });
    out << "</FieldData>\n";
  }

  void write_point_data(std::ostream& out) const
  {
    out << "<PointData Scalars=\"set\">\n";
    write_array(out, R"(type="Int64" Name="id")", m_sets.size(),
                [&](std::size_t i) { out << m_motion.ids()[i]; });
    write_array(out, R"(type="UInt8" Name="set")", m_sets.size(),
                [&](std::size_t i) { out << m_sets[i]; });
    out << "</PointData>\n";
  }

  void write_cell_data(std::ostream& out) const
  {
    out << "<CellData>\n";
    write_array(out, R"(type="UInt8" Name="delaunay")", m_triangles.size(),
                [&](std::size_t i) { out << (m_triangles[i].is_delaunay ? 1 : 0); });
    out << "</CellData>\n";
  }

  void write_points(std::ostream& out) const
  {
    out << "<Points>\n";
    write_array(out, R"(type="Float64" Name="Points" NumberOfComponents="3")", m_sets.size(),
                [&](std::size_t i) {
                  const scenario::Point& point = m_motion.points()[i];
                  out << Exact_number{point.x} << ' ' << Exact_number{point.y} << " 0";
                });
    out << "</Points>\n";
  }

  void write_cells(std::ostream& out) const
  {
    constexpr int triangle_type = 5; // VTK_TRIANGLE
    out << "<Cells>\n";
    write_array(out, R"(type="Int64" Name="connectivity")", m_triangles.size(), [&](std::size_t i) {
      const auto& places = m_triangles[i].places;
      out << places[0] << ' ' << places[1] << ' ' << places[2];
    });
    write_array(out, R"(type="Int64" Name="offsets")", m_triangles.size(),
                [&](std::size_t i) { out << 3 * (i + 1); });
    write_array(out, R"(type="UInt8" Name="types")", m_triangles.size(),
                [&](std::size_t) { out << triangle_type; });
    out << "</Cells>\n";
  }

  const scenario::Motion& m_motion;
  std::vector<unsigned> m_sets; // of each point
  Frame m_frame;
  std::vector<std::size_t> m_place_of_vertex; // in the motion
  std::vector<Triangle> m_triangles;
};

// Some frames of a run in a directory, each as a VTK file, and a collection that lists them.
class Vtk_series
{
public:
  Vtk_series(const std::string& directory, const Frame_choice& choice)
    : m_directory(directory)
    , m_choice(choice)
    , m_collection(m_directory.path_of("frames.pvd"))
  {
  }

  template <class Run>
  void write(const Run& run)
  {
    const std::size_t frame = run.record().frame;
    if (!m_choice.has(frame)) {
      return;
    }
    Output_file file(m_directory.path_of(frame_file_name(frame, ending)));
    Vtk_grid<Run>(run).write(file.stream());
    file.finish();
    m_frames.push_back(frame);
    m_times.push_back(run.record().time);
  }

  void finish()
  {
    std::ostream& out = m_collection.stream();
    out << "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           "<Collection>\n";
    const std::vector<double> times = distinct_times();
    for (std::size_t i = 0; i != m_frames.size(); ++i) {
      out << "<DataSet timestep=\"" << Exact_number{times[i]} << "\" part=\"0\" file=\""
          << frame_file_name(m_frames[i], ending) << "\"/>\n";
    }
    out << "</Collection>\n</VTKFile>\n";
    m_collection.finish();
  }

private:
  static constexpr const char* ending = ".vtu";

  // A collection takes files of one time for parts of one picture, and a recording may have any
  // times: where they do not ascend, the numbers of the frames stand for them.
  std::vector<double> distinct_times() const
  {
    const bool ascend =
        std::adjacent_find(m_times.begin(), m_times.end(), std::greater_equal<>()) == m_times.end();
    return ascend ? m_times : std::vector<double>(m_frames.begin(), m_frames.end());
  }

  Output_directory m_directory;
  Frame_choice m_choice;
  Output_file m_collection;
  std::vector<std::size_t> m_frames;
  std::vector<double> m_times;
};

} // namespace run

#endif // SCENARIO_RUNNER_OUTPUT_FORMATS_H
