// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_VTK_COLLECTION_H
#define SCENARIO_RUNNER_VTK_COLLECTION_H

#include "scenario_runner/Output_file.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace run {

// Writes an array of `size` elements; `text(i)` is the text of the i-th one.
template <class Text>
void write_vtk_array(std::ostream& out, const char* attributes, std::size_t size, const Text& text)
{
  out << "<DataArray " << attributes << " format=\"ascii\">\n";
  for (std::size_t i = 0; i != size; ++i) {
    out << text(i) << '\n';
  }
  out << "</DataArray>\n";
}

// A text as VTK has it among others: its bytes as numbers, and a zero.
std::string vtk_text(const std::string& text);

// Writes the begin of an unstructured grid in VTK's XML format, up to its field data: the time and
// the number of the frame. Further field data may follow.
void begin_vtk_grid(std::ostream& out, double time, std::int64_t number);

// Some frames in a directory, each as a VTK file, and a collection that lists them.
class Vtk_collection
{
public:
  explicit Vtk_collection(const std::string& directory);

  // Writes a file with what write(stream) writes.
  template <class Write>
  void add(std::int64_t number, double time, const Write& write)
  {
    Output_file file(m_directory.path_of(file_name(number)));
    write(file.stream());
    file.finish();
    m_numbers.push_back(number);
    m_times.push_back(time);
  }

  void finish();

private:
  static std::string file_name(std::int64_t number);
  std::vector<double> distinct_times() const;

  Output_directory m_directory;
  Output_file m_collection;
  std::vector<std::int64_t> m_numbers; // of frames
  std::vector<double> m_times;
};

} // namespace run

#endif // SCENARIO_RUNNER_VTK_COLLECTION_H
