// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Vtk_collection.h"

#include "scenario_runner/Number_text.h"

#include <algorithm>
#include <functional>

namespace run {

std::string vtk_text(const std::string& text)
{
  std::string bytes;
  for (const char c : text) {
    bytes += std::to_string(static_cast<unsigned char>(c)) + ' ';
  }
  return bytes + '0';
}

void begin_vtk_grid(std::ostream& out, double time, std::int64_t number)
{
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid>\n<FieldData>\n";
  write_vtk_array(out, R"(type="Float64" Name="TimeValue" NumberOfTuples="1")", 1,
                  [&](std::size_t) { return number_text(time); });
  write_vtk_array(out, R"(type="Int64" Name="Frame" NumberOfTuples="1")", 1,
                  [&](std::size_t) { return number; });
}

Vtk_collection::Vtk_collection(const std::string& directory)
  : m_directory(directory)
  , m_collection(m_directory.path_of("frames.pvd"))
{
}

std::string Vtk_collection::file_name(std::int64_t number)
{
  return frame_file_name(number, ".vtu");
}

void Vtk_collection::finish()
{
  std::ostream& out = m_collection.stream();
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<Collection>\n";
  const std::vector<double> times = distinct_times();
  for (std::size_t i = 0; i != m_numbers.size(); ++i) {
    out << "<DataSet timestep=\"" << number_text(times[i]) << "\" part=\"0\" file=\""
        << file_name(m_numbers[i]) << "\"/>\n";
  }
  out << "</Collection>\n</VTKFile>\n";
  m_collection.finish();
}

// In a collection files of equal times are parts of one picture, and a recording may have any
// times: if they do not ascend, the numbers of the frames take their place.
std::vector<double> Vtk_collection::distinct_times() const
{
  const bool ascend =
      std::adjacent_find(m_times.begin(), m_times.end(), std::greater_equal<>()) == m_times.end();
  return ascend ? m_times : std::vector<double>(m_numbers.begin(), m_numbers.end());
}

} // namespace run
