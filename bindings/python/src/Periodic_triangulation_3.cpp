// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Periodic_triangulation_3.h"

#include "bindings/python/src/Guarded_methods.h"
#include "bindings/python/src/Guarded_subject.h"
#include "bindings/python/src/Numpy.h"
#include "bindings/python/src/Periodic_subject_3.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace python {

namespace {

using Report = Periodic_subject_3::Report;
using Vectors = std::vector<CGAL::Periodic_cell_3::Coordinates>; // three, two or one

CGAL::Periodic_cell_3 cell_of(const Vectors& vectors)
{
  if (vectors.size() == 1) {
    return CGAL::Periodic_cell_3(vectors.at(0));
  }
  return vectors.size() == 2 ? CGAL::Periodic_cell_3(vectors.at(0), vectors.at(1))
                             : CGAL::Periodic_cell_3(vectors.at(0), vectors.at(1), vectors.at(2));
}

// What Python holds.
class Periodic_triangulation_3 : public Guarded_subject<Periodic_subject_3>
{
public:
  void start(unsigned threads, bool changes, bool is_population, const Vectors& cell)
  {
    check_is_new();
    m_number_of_threads = threads;
    Guarded_subject::start(threads, make_periodic_subject_3(cell_of(cell), changes, is_population));
  }
  void start_as_copy(Periodic_triangulation_3& other)
  {
    check_is_new();
    auto copy = other.read([](const Periodic_subject_3& its) { return its.copy(); });
    m_number_of_threads = other.m_number_of_threads;
    Guarded_subject::start(m_number_of_threads, std::move(copy), other.last_report());
  }

  Report update(const py::object& points, const py::object& ids, const std::optional<Vectors>& cell)
  {
    const Input its_points = positions_input(points), its_ids = input_of_ids(ids, its_points);
    std::optional<CGAL::Periodic_cell_3> its_cell;
    if (cell) {
      its_cell = cell_of(*cell);
    }
    return change([&](Periodic_subject_3& subject) {
      return subject.update(its_ids.rows, its_points.rows, its_cell);
    });
  }

  py::array cell()
  {
    std::vector<double> numbers;
    const CGAL::Periodic_cell_3 its_cell =
        read([](const Periodic_subject_3& subject) { return subject.cell(); });
    for (int i = 0; i < its_cell.dimension(); ++i) {
      const auto& vector = its_cell.vector(std::size_t(i));
      numbers.insert(numbers.end(), vector.begin(), vector.end());
    }
    return to_numpy({std::move(numbers), {3}});
  }

private:
  unsigned m_number_of_threads = 1;
};

} // namespace

void bind_periodic_triangulation_3(py::module_& module)
{
  using Guarded = Periodic_triangulation_3;
  py::class_<Guarded> type(module, "PeriodicTriangulation3D");
  type.def(py::init<>())
      .def("_start", &Guarded::start, py::arg("threads"), py::arg("changes"), py::arg("population"),
           py::arg("cell"))
      .def("_start_as_copy", &Guarded::start_as_copy)
      .def("_update", &Guarded::update)
      .def("_cell", &Guarded::cell)
      .def("_volumes",
           [](Guarded& t) {
             return to_numpy(
                 t.read([](const Periodic_subject_3& subject) { return subject.volumes(); }));
           })
      .def("_voronoi_volumes",
           [](Guarded& t) {
             return to_numpy(t.read(
                 [](const Periodic_subject_3& subject) { return subject.voronoi_volumes(); }));
           })
      .def("_voronoi_cells", [](Guarded& t) {
        return to_numpy(
            t.read([](const Periodic_subject_3& subject) { return subject.voronoi_cells(); }));
      });
  bind_guarded(
      type, "UpdateReport3D",
      "Triangulate anew after a call for which memory did not suffice, and return a report.\n\n"
      "Does nothing if it is certified.");
}

} // namespace python
