// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Recording_in_python.h"

#include "bindings/python/src/Numpy.h"
#include "scenario_runner/Csv_header.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/space/Motion_3.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace python {

namespace {

// The names that stand for ids in all frames of a recording, made once.
class Names_in_python
{
public:
  py::object ids(const scenario::Recorded_frame& frame)
  {
    if (!frame.names) {
      return to_numpy({frame.ids});
    }
    if (m_names != frame.names) {
      set(frame.names);
    }
    py::list texts(frame.ids.size());
    for (std::size_t i = 0; i < frame.ids.size(); ++i) {
      texts[i] = m_texts[std::size_t(frame.ids[i])];
    }
    return py::module_::import("numpy").attr("array")(texts, py::arg("dtype") = "str");
  }

private:
  // Names may be in any encoding: what is no UTF-8 is kept as Python keeps it in names of files.
  void set(std::shared_ptr<const scenario::Point_name_list> names)
  {
    m_texts.clear();
    for (const std::string& name : *names) {
      m_texts.push_back(py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(name.data(), py::ssize_t(name.size()), "surrogateescape")));
    }
    m_names = std::move(names);
  }

  std::shared_ptr<const scenario::Point_name_list> m_names;
  std::vector<py::object> m_texts;
};

py::array points_of(const scenario::Recorded_frame& frame, std::size_t dimension)
{
  std::vector<double> points;
  points.reserve(dimension * frame.points.size());
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    points.insert(points.end(), {frame.points[i].x, frame.points[i].y});
    if (dimension == 3) {
      points.push_back(frame.heights.empty() ? 0.0 : frame.heights[i]);
    }
  }
  return to_numpy({std::move(points), {dimension}});
}

// The vectors by which the plane or space is repeated.
py::object cell_of(const scenario::Recorded_frame& frame, std::size_t dimension)
{
  if (dimension == 3 && frame.box) {
    std::vector<double> vectors;
    for (std::size_t i = 0; i < 3; ++i) {
      const scenario::Point_3& side = frame.box->sides[i];
      if (frame.box->is_periodic[i]) {
        vectors.insert(vectors.end(), side.begin(), side.end());
      }
    }
    return to_numpy({std::move(vectors), {3}});
  }
  if (!frame.cell) {
    return py::none();
  }
  std::vector<double> vectors;
  for (std::size_t side = 0; side < 2; ++side) {
    if (frame.cell->is_periodic[side]) {
      vectors.insert(vectors.end(), {frame.cell->sides[side].x, frame.cell->sides[side].y});
    }
  }
  return to_numpy({std::move(vectors), {2}});
}

// The dimension that a recording has, if none is wanted.
int checked_dimension(const std::string& path, const scenario::Recording& recording,
                      std::optional<int> wanted)
{
  const int dimension = wanted.value_or(scenario::is_in_space(recording) ? 3 : 2);
  const std::string name = scenario::is_standard_input(path) ? "standard input" : path;
  if (dimension == 3) {
    scenario::check_in_space(name, recording, "dimension=2");
  } else {
    scenario::check_in_plane(name, recording);
  }
  return dimension;
}

py::list read_recording(const std::string& path, const std::string& columns,
                        std::optional<int> wanted_dimension)
{
  scenario::Recording recording;
  std::size_t dimension = 0;
  {
    const py::gil_scoped_release release;
    recording = scenario::read_recording(path, columns.empty() ? scenario::Table_columns()
                                                               : scenario::table_columns(columns));
    dimension = std::size_t(checked_dimension(path, recording, wanted_dimension));
  }
  py::list frames;
  Names_in_python names;
  for (const scenario::Recorded_frame& frame : recording) {
    frames.append(py::make_tuple(frame.number, frame.time, names.ids(frame),
                                 points_of(frame, dimension), cell_of(frame, dimension)));
  }
  return frames;
}

// The places of frame, time, id, x, y and z among the titles of a table, -1 for what is not there.
py::tuple table_columns(const std::vector<std::string>& titles)
{
  std::string line;
  for (const std::string& title : titles) {
    line += line.empty() ? "\"" : "\t\"";
    for (const char c : title) {
      line += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    line += '"';
  }
  const scenario::Csv_layout layout =
      scenario::Csv_header("the table", line, 0, {scenario::Separator::tab}, {}).layout();
  py::list places;
  for (const std::size_t place : layout.positions) {
    places.append(place == scenario::Csv_layout::none ? -1 : std::int64_t(place));
  }
  return places;
}

} // namespace

void bind_recordings(py::module_& module)
{
  module.def("_read_recording", [](const py::bytes& path, const std::string& columns,
                                   const std::optional<int>& dimension) {
    return read_recording(path, columns, dimension);
  });
  module.def("_table_columns", table_columns);
}

} // namespace python
