// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Triangulation_3.h"

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

Input positions_input(const py::object& points)
{
  return points_input(points, "points", 3);
}

// What Python holds.
class Triangulation_3 : public Guarded_subject<Subject_3>
{
public:
  void start(unsigned threads, bool is_population)
  {
    check_is_new();
    m_number_of_threads = threads;
    Guarded_subject::start(threads, made(is_population));
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
  Report move(const py::object& ids, const py::object& points)
  {
    const Input its_points = positions_input(points);
    const Input its_ids = ids_input(ids, its_points.rows.size);
    check(its_ids.rows);
    return change([&](Subject_3& subject) { return subject.move(its_ids.rows, its_points.rows); });
  }
  py::array insert(const py::object& points, const py::object& ids)
  {
    const Input its_points = positions_input(points), its_ids = input_of_ids(ids, its_points);
    std::vector<std::int64_t> new_ids;
    change(
        [&](Subject_3& subject) { return subject.insert(its_ids.rows, its_points.rows, new_ids); });
    return to_numpy({std::move(new_ids)});
  }
  Report remove(const py::object& ids)
  {
    const Input its_ids = ids_input(ids);
    check(its_ids.rows);
    return change([&](Subject_3& subject) { return subject.remove(its_ids.rows); });
  }
  Report mend()
  {
    return change([](Subject_3& subject) { return subject.mend(); });
  }

  void restore(const py::bytes& checkpoint)
  {
    const std::string text = checkpoint;
    change([&](Subject_3& subject) {
      subject.restore(text);
      Report report;
      report.certified = subject.triangulation().is_certified();
      return report;
    });
  }

private:
  static std::unique_ptr<Subject_3> made(bool is_population)
  {
    if (is_population) {
      return std::make_unique<Subject_of_3<true>>();
    }
    return std::make_unique<Subject_of_3<false>>();
  }

  Input input_of_ids(const py::object& ids, const Input& points) const
  {
    return subject().is_population() ? ids_input(ids, points.rows.size) : Input{};
  }

  void check(const Rows& ids) const
  {
    if (!subject().is_population()) {
      check_not_negative(ids);
    }
  }

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

// A call that asks the triangulation.
template <class Question>
auto asking(const Question& question)
{
  return [=](Triangulation_3& t) {
    return t.read([&](const Subject_3& subject) { return question(subject.triangulation()); });
  };
}

} // namespace

void bind_triangulation_3(py::module_& module)
{
  bind_report(module, "UpdateReport3D", counts_of_report);
  py::class_<Triangulation_3>(module, "Triangulation3D")
      .def(py::init<>())
      .def("_start", &Triangulation_3::start, py::arg("threads"), py::arg("population"))
      .def("_start_as_copy", &Triangulation_3::start_as_copy)
      .def("_update", &Triangulation_3::update)
      .def("_move", &Triangulation_3::move)
      .def("_insert", &Triangulation_3::insert)
      .def("_remove", &Triangulation_3::remove)
      .def("_restore", &Triangulation_3::restore)
      .def("_arrays", &Triangulation_3::arrays)
      .def("_checkpoint",
           [](Triangulation_3& t) {
             return py::bytes(t.read([](const Subject_3& its) { return its.checkpoint(); }));
           })
      .def("_volumes",
           [](Triangulation_3& t) {
             return to_numpy(t.read([](const Subject_3& subject) { return subject.volumes(); }));
           })
      .def("_voronoi_cells", voronoi_cells)
      .def("_is_current", &Triangulation_3::is_current)
      .def("_has_id",
           [](Triangulation_3& t, std::int64_t id) {
             return t.read([&](const Subject_3& subject) { return subject.has_id(id); });
           })
      .def(
          "mend", &Triangulation_3::mend,
          "Triangulate anew after a call for which memory did not suffice, and return a report.\n\n"
          "Does nothing if it is certified.")
      .def("is_valid", asking([](const auto& dt) { return dt.is_valid(); }),
           "Whether everything is as it must be, tested exactly. For tests. Cost: linear.")
      .def_property_readonly("last_report", &Triangulation_3::last_report,
                             "UpdateReport3D: what the last call that changed something did.")
      .def_property_readonly("is_certified",
                             asking([](const auto& dt) { return dt.is_certified(); }),
                             "bool: whether exact predicates have proved it Delaunay.")
      .def_property_readonly("dimension", asking([](const auto& dt) { return dt.dimension(); }),
                             "int: 3; 2 if all points are in a plane, 1 on a line, 0 if all "
                             "coincide, -1 without points.")
      .def_property_readonly("number_of_points",
                             asking([](const auto& dt) { return dt.number_of_points(); }),
                             "int: points, coincident ones included.")
      .def_property_readonly("number_of_ids",
                             asking([](const auto& dt) { return dt.number_of_ids(); }),
                             "int: one more than the largest id ever in use.")
      .def_property_readonly("number_of_vertices",
                             asking([](const auto& dt) { return dt.number_of_vertices(); }),
                             "int: places that differ.");
}

} // namespace python
