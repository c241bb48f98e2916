// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_VTK_SERIES_H
#define RUN_VTK_SERIES_H

#include "Exact_number.h"
#include "Frame_choice.h"
#include "Output_directory.h"
#include "Output_file.h"
#include "Vtk_grid.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace run {

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

#endif // RUN_VTK_SERIES_H
