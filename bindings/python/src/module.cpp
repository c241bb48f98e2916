// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/common/Bounded_cells.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/python/src/Bounded_cells_in_python.h"
#include "bindings/python/src/Errors.h"
#include "bindings/python/src/Function_in_python.h"
#include "bindings/python/src/Guarded_methods.h"
#include "bindings/python/src/Guarded_subject.h"
#include "bindings/python/src/Numpy.h"
#include "bindings/python/src/Periodic_triangulation_3.h"
#include "bindings/python/src/Python_settings.h"
#include "bindings/python/src/Recording_in_python.h"
#include "bindings/python/src/Report_in_python.h"
#include "bindings/python/src/Triangle_walk.h"
#include "bindings/python/src/Triangulation_3.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace python {

namespace {

using Report = Subject::Report;

// What Python holds.
class Triangulation : public Guarded_subject<Subject>
{
public:
  void start(const py::object& classifier, const std::string& repair, const std::string& policy,
             unsigned threads, std::uint64_t seed, bool changes, bool is_population,
             const std::optional<Cell>& cell)
  {
    check_is_new();
    Python_settings settings{{"", repair, policy, seed, changes, is_population, cell}, nullptr};
    if (py::isinstance<py::str>(classifier)) {
      settings.classifier = classifier.cast<std::string>();
    } else {
      m_function = std::make_shared<py::object>(classifier);
      settings.function = function_in_python(m_function);
    }
    Guarded_subject::start(threads, make_subject(settings));
  }

  Report update(const py::object& points, const py::object& ids, const std::optional<Cell>& cell)
  {
    // a classifier in Python may write to the array that is being read
    const Input its_points = m_function ? copied_points_input(points) : points_input(points),
                its_ids = input_of_ids(ids, its_points);
    return change(
        [&](Subject& subject) { return subject.update(its_ids.rows, its_points.rows, cell); });
  }

  py::array find_simplex(const py::object& query_points)
  {
    const Input input = points_input(query_points, "query points");
    py::array points, corners, neighbors;
    bool is_certified = false;
    while (!is_current(corners)) { // another thread may change the triangulation in between
      const py::tuple triangles = arrays(Group::TRIANGLES);
      corners = triangles[0];
      neighbors = triangles[1];
      points = arrays(Group::POINTS)[0];
      is_certified = read([](const Subject& subject) { return subject.is_certified(); });
    }
    if (!is_certified) {
      throw CGAL::Uncertified_triangulation_error_2();
    }
    const Flat_triangles flat{
        static_cast<const double*>(points.data()), static_cast<const std::int32_t*>(corners.data()),
        static_cast<const std::int32_t*>(neighbors.data()), std::size_t(corners.shape(0))};
    std::vector<std::int32_t> found;
    {
      const py::gil_scoped_release release;
      found = triangles_at(input.rows, flat);
    }
    return to_numpy({std::move(found)});
  }

  // One radius, or else one for each row. A domain has rings; without them there is none.
  Bounded_cells_in_python bounded_cells(const std::optional<double>& radius,
                                        const py::object& radii,
                                        const std::vector<py::object>& rings,
                                        const std::string& rule)
  {
    const Input its_radii = radius ? Input{} : numbers_input(radii, "radii");
    const run::Cell_rule its_rule = run::cell_rule(rule);
    std::vector<Corners> domain;
    for (const py::object& ring : rings) {
      domain.push_back(corners_of(points_input(ring, "the corners of a domain")));
    }
    return read([&](const Subject& subject) {
      Bounded_cells bounded =
          domain.empty() ? Bounded_cells() : cells_in_domain(std::move(domain), its_rule);
      return Bounded_cells_in_python{
          subject.bounded_cells(std::move(bounded),
                                radius ? Radii(*radius) : Radii(its_radii.rows)),
          version()};
    });
  }

  py::tuple bounded_gradients(const Bounded_cells_in_python& cells, const py::object& area_weights,
                              const py::object& length_weights)
  {
    const Input areas = numbers_input(area_weights, "weights of areas"),
                lengths = numbers_input(length_weights, "weights of lengths");
    return to_numpy(read([&](const Subject& subject) {
      if (cells.version != version()) {
        throw Use_error("the triangulation has changed since these cells were made: gradients "
                        "need those of now");
      }
      return gradient_arrays(cells.bounded,
                             subject.bounded_gradients(cells.bounded, areas.rows, lengths.rows));
    }));
  }

  // For the garbage collector: a classifier may refer to its triangulation.
  int visit_objects(visitproc visit, void* arg) const
  {
    if (m_function) {
      Py_VISIT(m_function->ptr());
    }
    return visit_arrays(visit, arg);
  }
  void clear_objects()
  {
    if (m_function) {
      *m_function = py::none();
    }
    clear_arrays();
  }

private:
  static Corners corners_of(const Input& ring)
  {
    Corners corners;
    for (const Corner& corner : row_range(ring.rows.size, Read_point<Corner>{ring.rows})) {
      corners.push_back(corner);
    }
    if (corners.size() > 1 && corners.front() == corners.back()) {
      corners.pop_back(); // a ring that is closed
    }
    return corners;
  }

  Shared_reference m_function; // the classifier, if it is written in Python
};

constexpr std::array<Report_count<Report>, 12> counts_of_report{{
    {"flips", &Report::flips, "edges flipped", true},
    {"classified", &Report::classified, "vertices that the classifier picked", true},
    {"inserted", &Report::inserted, "points inserted", true},
    {"removed", &Report::removed, "points removed", true},
    {"relocated", &Report::relocated, "vertices that jumped and were inserted anew", true},
    {"padded", &Report::padded, "vertices in the layers around the classified ones (splices only)"},
    {"border", &Report::border, "vertices in the layer beyond these (splices only)"},
    {"splices", &Report::splices, "regions triangulated anew"},
    {"spliced", &Report::spliced, "vertices of these regions"},
    {"enlargements", &Report::enlargements, "how often a region was enlarged"},
    {"merged", &Report::merged, "vertices that came to coincide with others"},
    {"parted", &Report::parted, "points that left a vertex that they had shared"},
}};

// None while Python is constructing the object.
Triangulation* triangulation_of(PyObject* object)
{
  auto* const instance = reinterpret_cast<py::detail::instance*>(object);
  const bool is_there = instance->simple_layout && instance->simple_holder_constructed;
  return is_there ? instance->get_value_and_holder().value_ptr<Triangulation>() : nullptr;
}

void let_garbage_be_collected(PyHeapTypeObject* heap_type)
{
  PyTypeObject& type = heap_type->ht_type;
  type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type.tp_traverse = [](PyObject* object, visitproc visit, void* arg) {
    Py_VISIT(Py_TYPE(object));
    const Triangulation* const triangulation = triangulation_of(object);
    return triangulation == nullptr ? 0 : triangulation->visit_objects(visit, arg);
  };
  type.tp_clear = [](PyObject* object) {
    if (Triangulation* const triangulation = triangulation_of(object)) {
      triangulation->clear_objects();
    }
    return 0;
  };
}

void bind_triangulation(py::module_& module)
{
  py::enum_<Group>(module, "Group")
      .value("IDS", Group::IDS)
      .value("POINTS", Group::POINTS)
      .value("DUPLICATES", Group::DUPLICATES)
      .value("EDGES", Group::EDGES)
      .value("TRIANGLES", Group::TRIANGLES)
      .value("SIMPLICES", Group::TRIANGLES) // of points in space
      .value("NEIGHBOR_LISTS", Group::NEIGHBOR_LISTS)
      .value("CELLS", Group::CELLS)
      .value("RIDGES", Group::RIDGES)
      .value("CHANGES", Group::CHANGES);
  py::enum_<Query>(module, "Query")
      .value("NEAREST", Query::NEAREST)
      .value("WITHIN", Query::WITHIN)
      .value("NATURAL_WEIGHTS", Query::NATURAL_WEIGHTS)
      .value("LINEAR_WEIGHTS", Query::LINEAR_WEIGHTS)
      .value("ALPHA_SHAPE", Query::ALPHA_SHAPE);
  py::class_<Cell>(module, "Cell")
      .def(py::init([](double ax, double ay, double bx, double by, bool is_slab) {
        return Cell{ax, ay, bx, by, is_slab};
      }))
      .def_property_readonly("numbers",
                             [](const Cell& c) {
                               return std::array<double, 4>{c.ax, c.ay, c.bx, c.by};
                             })
      .def_readonly("is_slab", &Cell::is_slab);
  py::class_<Triangulation> type(module, "Triangulation",
                                 py::custom_type_setup(let_garbage_be_collected));
  type.def(py::init<>())
      .def("_start", &Triangulation::start, py::arg("classifier"), py::arg("repair"),
           py::arg("policy"), py::arg("threads"), py::arg("seed"), py::arg("changes"),
           py::arg("population"), py::arg("cell"))
      .def("_update", &Triangulation::update)
      .def("_find_simplex", &Triangulation::find_simplex)
      .def("_cell", asking<Triangulation>([](const Subject& subject) { return subject.cell(); }))
      .def("_clipped_cells",
           [](Triangulation& t, double xmin, double ymin, double xmax, double ymax) {
             return to_numpy(t.read([&](const Subject& subject) {
               return subject.clipped_cells({xmin, ymin, xmax, ymax});
             }));
           })
      .def("_bounded_cells", &Triangulation::bounded_cells)
      .def("_bounded_gradients", &Triangulation::bounded_gradients)
      .def("_cell_corners", [](Triangulation& t, std::int64_t id) {
        return to_numpy(t.read([&](const Subject& s) { return s.cell_corners(id); }));
      });
  bind_guarded(type, "UpdateReport",
               "Make the triangulation exactly Delaunay after a heuristic update, and return a "
               "report.\n\n"
               "Does nothing if it is certified.");
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.attr("__version__") = CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION;
  register_errors();
  bind_report(module, "UpdateReport", counts_of_report);
  bind_classifier_frame(module);
  bind_bounded_cells(module);
  bind_recordings(module);
  bind_triangulation(module);
  bind_triangulation_3(module);
  bind_periodic_triangulation_3(module);
}

} // namespace python
