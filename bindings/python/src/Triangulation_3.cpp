// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Triangulation_3.h"

#include "bindings/python/src/Guarded_methods.h"
#include "bindings/python/src/Guarded_subject.h"
#include "bindings/python/src/Numpy.h"
#include "bindings/python/src/Report_in_python.h"
#include "bindings/python/src/Subject_3.h"

#include <pybind11/stl.h>

#include <array>
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

using Report = Subject_3::Report;

// What Python holds.
class Triangulation_3 : public Guarded_subject<Subject_3>
{
public:
  void start(unsigned threads, bool changes, bool is_population)
  {
    check_is_new();
    m_number_of_threads = threads;
    Guarded_subject::start(threads, make_subject_3(changes, is_population));
  }
  void start_as_copy(Triangulation_3& other)
  {
    check_is_new();
    auto copy = other.read([](const Subject_3& its) { return its.copy(); });
    m_number_of_threads = other.m_number_of_threads;
    Guarded_subject::start(m_number_of_threads, std::move(copy), other.last_report());
  }

  Report update(const py::object& points, const py::object& ids)
  {
    const Input its_points = positions_input(points), its_ids = input_of_ids(ids, its_points);
    return change(
        [&](Subject_3& subject) { return subject.update(its_ids.rows, its_points.rows); });
  }

private:
  unsigned m_number_of_threads = 1;
};

constexpr std::array<Report_count<Report>, 8> counts_of_report{{
    {"flips", &Report::flips, "flips: 2-3, 3-2, and two for each 4-4", true},
    {"unproved", &Report::unproved, "tetrahedra that exact predicates had to look at", true},
    {"held", &Report::held, "vertices that were held back, so that no tetrahedron was inverted",
     true},
    {"inserted", &Report::inserted, "points inserted", true},
    {"removed", &Report::removed, "points removed", true},
    {"relocated", &Report::relocated, "vertices that were taken out and inserted anew", true},
    {"merged", &Report::merged, "vertices that came to coincide with others"},
    {"parted", &Report::parted, "points that left a vertex that they had shared"},
}};

// Of whole cells, or in a box from the first three numbers to the others.
py::tuple voronoi_cells(Triangulation_3& t, const std::optional<std::array<double, 6>>& sides)
{
  const auto arrays = t.read([&](const Subject_3& subject) {
    if (!sides) {
      return subject.voronoi_cells(nullptr);
    }
    const auto& [xmin, ymin, zmin, xmax, ymax, zmax] = *sides;
    const CGAL::Bbox_3 box(xmin, ymin, zmin, xmax, ymax, zmax);
    return subject.voronoi_cells(&box);
  });
  py::tuple result(arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    result[i] = to_numpy(arrays[i]);
  }
  return result;
}

} // namespace

void bind_triangulation_3(py::module_& module)
{
  bind_report(module, "UpdateReport3D", counts_of_report);
  py::class_<Triangulation_3> type(module, "Triangulation3D");
  type.def(py::init<>())
      .def("_start", &Triangulation_3::start, py::arg("threads"), py::arg("changes"),
           py::arg("population"))
      .def("_start_as_copy", &Triangulation_3::start_as_copy)
      .def("_update", &Triangulation_3::update)
      .def("_volumes",
           [](Triangulation_3& t) {
             return to_numpy(t.read([](const Subject_3& subject) { return subject.volumes(); }));
           })
      .def("_voronoi_volumes",
           [](Triangulation_3& t) {
             return to_numpy(
                 t.read([](const Subject_3& subject) { return subject.voronoi_volumes(); }));
           })
      .def("_voronoi_cells", voronoi_cells)
      .def_property_readonly(
          "dimension",
          asking<Triangulation_3>([](const Subject_3& s) { return s.dimension_of_points(); }),
          "int: 3; 2 if all points are in a plane, 1 on a line, 0 if all coincide, -1 without "
          "points.");
  bind_guarded(
      type, "UpdateReport3D",
      "Triangulate anew after a call for which memory did not suffice, and return a report.\n\n"
      "Does nothing if it is certified.");
}

} // namespace python
