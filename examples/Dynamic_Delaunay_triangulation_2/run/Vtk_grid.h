// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_VTK_GRID_H
#define RUN_VTK_GRID_H

#include "../scenario/Motion.h"
#include "Exact_number.h"
#include "Vertex_sets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace run {

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

} // namespace run

#endif // RUN_VTK_GRID_H
