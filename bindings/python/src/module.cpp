// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/common/Bounded_cells.h"
#include "bindings/common/Report_fields.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/python/src/Bounded_cells_in_python.h"
#include "bindings/python/src/Errors.h"
#include "bindings/python/src/Function_in_python.h"
#include "bindings/python/src/Numpy.h"
#include "bindings/python/src/Python_settings.h"
#include "bindings/python/src/Recording_in_python.h"
#include "bindings/python/src/Triangle_walk.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace python {

namespace {

using Report = Subject::Report;

// What Python holds. All work is done without the interpreter's lock, and by one thread at a time.
class Triangulation
{
public:
  void start(const py::object& classifier, const std::string& repair, const std::string& policy,
             unsigned threads, std::uint64_t seed, bool changes, bool is_population,
             const std::optional<Cell>& cell)
  {
    if (m_subject) {
      throw Use_error("a triangulation is initialized once; restore() replaces all of it");
    }
    Python_settings settings{{"", repair, policy, seed, changes, is_population, cell}, nullptr};
    if (py::isinstance<py::str>(classifier)) {
      settings.classifier = classifier.cast<std::string>();
    } else {
      m_function = std::make_shared<py::object>(classifier);
      settings.function = function_in_python(m_function);
    }
    m_threads.emplace(threads);
    m_subject = make_subject(settings);
  }

  Report update(const py::object& points, const py::object& ids, const std::optional<Cell>& cell)
  {
    // a classifier in Python may write to the array that is being read
    const Input its_points = m_function ? copied_points_input(points) : points_input(points),
                its_ids = input_of_ids(ids, its_points);
    return change(
        [&](Subject& subject) { return subject.update(its_ids.rows, its_points.rows, cell); });
  }

  Report move(const py::object& ids, const py::object& points)
  {
    const Input its_points = points_input(points);
    const Input its_ids = ids_input(ids, its_points.rows.size);
    check(its_ids.rows);
    return change([&](Subject& subject) { return subject.move(its_ids.rows, its_points.rows); });
  }

  py::array insert(const py::object& points, const py::object& ids)
  {
    const Input its_points = points_input(points), its_ids = input_of_ids(ids, its_points);
    check_single(its_points.rows);
    std::vector<std::int64_t> new_ids;
    change(
        [&](Subject& subject) { return subject.insert(its_ids.rows, its_points.rows, new_ids); });
    return to_numpy({std::move(new_ids)});
  }

  Report remove(const py::object& ids)
  {
    const Input its_ids = ids_input(ids);
    check_single(its_ids.rows);
    check(its_ids.rows);
    return change([&](Subject& subject) { return subject.remove(its_ids.rows); });
  }

  Report mend()
  {
    return change([](Subject& subject) { return subject.mend(); });
  }

  void restore(const py::bytes& checkpoint)
  {
    const std::string text = checkpoint;
    change([&](Subject& subject) {
      subject.restore(text);
      Report report;
      report.certified = subject.is_certified();
      return report;
    });
  }

  // Calls `f(subject)`, which changes nothing, or nothing that arrays show.
  template <class Function>
  auto read(const Function& f)
  {
    check_caller();
    const py::gil_scoped_release release;
    const std::lock_guard<std::mutex> guard(m_mutex);
    const Caller caller(m_caller);
    Subject& mine = subject();
    return m_threads->execute([&] { return f(mine); });
  }

  // The arrays of a group: those of the last time if nothing has changed since.
  py::tuple arrays(Group group)
  {
    Cached& cached = m_cache[std::size_t(group)];
    if (!cached.arrays || cached.version != m_version) {
      std::uint64_t version = 0;
      std::vector<Array> arrays = read([&](const Subject& subject) {
        version = m_version;
        return subject.arrays(group);
      });
      cached = {to_numpy(std::move(arrays)), version};
    }
    return cached.arrays;
  }

  bool is_current(const py::object& array) const
  {
    for (const Cached& cached : m_cache) {
      if (cached.arrays && cached.version == m_version) {
        for (const py::handle& its_array : cached.arrays) {
          if (its_array.is(array)) {
            return true;
          }
        }
      }
    }
    return false;
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
          m_version};
    });
  }

  py::tuple bounded_gradients(const Bounded_cells_in_python& cells, const py::object& area_weights,
                              const py::object& length_weights)
  {
    const Input areas = numbers_input(area_weights, "weights of areas"),
                lengths = numbers_input(length_weights, "weights of lengths");
    return to_numpy(read([&](const Subject& subject) {
      if (cells.version != m_version) {
        throw Use_error("the triangulation has changed since these cells were made: gradients "
                        "need those of now");
      }
      return gradient_arrays(cells.bounded,
                             subject.bounded_gradients(cells.bounded, areas.rows, lengths.rows));
    }));
  }

  py::tuple answer(Query query, const py::object& query_points, double extent)
  {
    const Input input = points_input(query_points, "query points");
    return to_numpy(read([&](const Subject& subject) {
      return subject.answer({query, input.rows, extent});
    }));
  }

  Report last_report() const { return m_report; }

  // For the garbage collector: a classifier may refer to its triangulation.
  int visit_objects(visitproc visit, void* arg) const
  {
    if (m_function) {
      Py_VISIT(m_function->ptr());
    }
    for (const Cached& cached : m_cache) {
      Py_VISIT(cached.arrays.ptr());
    }
    return 0;
  }
  void clear_objects()
  {
    if (m_function) {
      *m_function = py::none();
    }
    m_cache = {};
  }

private:
  struct Cached
  {
    py::tuple arrays{py::reinterpret_steal<py::tuple>(py::handle())};
    std::uint64_t version = 0;
  };

  // Remembers which thread is at work.
  class Caller
  {
  public:
    explicit Caller(std::atomic<std::thread::id>& caller)
      : m_caller(caller)
    {
      m_caller = std::this_thread::get_id();
    }
    Caller(const Caller&) = delete;
    Caller& operator=(const Caller&) = delete;
    ~Caller() { m_caller = std::thread::id(); }

  private:
    std::atomic<std::thread::id>& m_caller;
  };

  Subject& subject() const
  {
    if (!m_subject) {
      throw Use_error("the triangulation is not initialized: its __init__() was not called");
    }
    return *m_subject;
  }

  void check_caller() const
  {
    if (m_caller == std::this_thread::get_id()) {
      throw Use_error("a triangulation cannot be used by its own classifier, which is "
                      "given all that it may ask for");
    }
  }

  template <class Function>
  Report change(const Function& f)
  {
    m_report = read([&](Subject& subject) {
      ++m_version; // also if it throws
      return f(subject);
    });
    return m_report;
  }

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

  Input input_of_ids(const py::object& ids, const Input& points) const
  {
    return subject().is_population() ? ids_input(ids, points.rows.size) : Input{};
  }

  void check_single(const Rows& rows) const
  {
    if (subject().is_population() && rows.size != 1) {
      throw std::invalid_argument("a population inserts and removes one point at a time; update() "
                                  "takes a whole frame");
    }
  }

  void check(const Rows& ids) const
  {
    for (std::size_t i = 0; i < ids.size && !subject().is_population(); ++i) {
      const std::int64_t id = ids.at<std::int64_t>(i, 0);
      if (id < 0) {
        throw_unknown_id(id, subject().number_of_ids());
      }
    }
  }

  Shared_reference m_function; // the classifier, if it is written in Python
  std::unique_ptr<Subject> m_subject;
  std::optional<run::Threads> m_threads; // that share its work
  std::mutex m_mutex;
  std::atomic<std::thread::id> m_caller{};
  std::atomic<std::uint64_t> m_version{0};
  std::array<Cached, std::size_t(Group::CHANGES) + 1> m_cache{};
  Report m_report{};
};

bool are_equal(const Report& a, const Report& b)
{
  return std::all_of(counts_of_reports.begin(), counts_of_reports.end(),
                     [&](auto count) { return a.*count == b.*count; }) &&
         a.rebuild_reason == b.rebuild_reason && a.certified == b.certified;
}

void bind_report(py::module_& module)
{
  py::class_<Report>(module, "UpdateReport", "What one call did. All counts are integers.")
      .def_readonly("classified", &Report::classified, "vertices that the classifier picked")
      .def_readonly("padded", &Report::padded, "vertices in the layers around them (splices only)")
      .def_readonly("border", &Report::border, "vertices in the layer beyond (splices only)")
      .def_readonly("flips", &Report::flips, "edges flipped")
      .def_readonly("splices", &Report::splices, "regions triangulated anew")
      .def_readonly("spliced", &Report::spliced, "vertices of these regions")
      .def_readonly("enlargements", &Report::enlargements, "how often a region was enlarged")
      .def_readonly("relocated", &Report::relocated, "vertices that jumped and were inserted anew")
      .def_readonly("inserted", &Report::inserted, "points inserted")
      .def_readonly("removed", &Report::removed, "points removed")
      .def_readonly("merged", &Report::merged, "vertices that came to coincide with others")
      .def_readonly("parted", &Report::parted, "points that left a vertex that they had shared")
      .def_readonly("certified", &Report::certified,
                    "bool: whether the triangulation is proved Delaunay")
      .def_property_readonly("rebuilt", &Report::rebuilt,
                             "bool: whether everything was triangulated anew")
      .def_property_readonly("rebuild_reason", rebuild_reason,
                             "str: why everything was triangulated anew; None if it was not")
      .def(py::pickle(
          [](const Report& report) {
            py::list counts;
            for (const auto count : counts_of_reports) {
              counts.append(report.*count);
            }
            return py::make_tuple(counts, int(report.rebuild_reason), report.certified);
          },
          [](const py::tuple& state) {
            Report report;
            const py::list counts = state[0];
            for (std::size_t i = 0; i < counts_of_reports.size(); ++i) {
              report.*counts_of_reports[i] = counts[i].cast<std::size_t>();
            }
            report.rebuild_reason = CGAL::Rebuild_reason_2(state[1].cast<int>());
            report.certified = state[2].cast<bool>();
            return report;
          }))
      .def("__eq__", are_equal, py::is_operator())
      .def("__repr__", [](const Report& report) {
        std::ostringstream out;
        out << "UpdateReport(flips=" << report.flips << ", classified=" << report.classified
            << ", inserted=" << report.inserted << ", removed=" << report.removed
            << ", relocated=" << report.relocated << ", rebuild_reason="
            << (report.rebuilt() ? "'" + std::string(rebuild_reason(report)) + "'" : "None")
            << ", certified=" << (report.certified ? "True" : "False") << ')';
        return out.str();
      });
}

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

// A call that asks the subject.
template <class Answer>
auto asking(Answer (Subject::*question)() const)
{
  return [=](Triangulation& triangulation) {
    return triangulation.read([&](const Subject& subject) { return (subject.*question)(); });
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
  py::class_<Triangulation>(module, "Triangulation",
                            py::custom_type_setup(let_garbage_be_collected))
      .def(py::init<>())
      .def("_start", &Triangulation::start, py::arg("classifier"), py::arg("repair"),
           py::arg("policy"), py::arg("threads"), py::arg("seed"), py::arg("changes"),
           py::arg("population"), py::arg("cell"))
      .def("_update", &Triangulation::update)
      .def("_move", &Triangulation::move)
      .def("_insert", &Triangulation::insert)
      .def("_remove", &Triangulation::remove)
      .def("_restore", &Triangulation::restore)
      .def("_arrays", &Triangulation::arrays)
      .def("_find_simplex", &Triangulation::find_simplex)
      .def("_is_current", &Triangulation::is_current)
      .def("_cell", asking(&Subject::cell))
      .def("_checkpoint",
           [](Triangulation& t) {
             return py::bytes(t.read([](const Subject& subject) { return subject.checkpoint(); }));
           })
      .def("_clipped_cells",
           [](Triangulation& t, double xmin, double ymin, double xmax, double ymax) {
             return to_numpy(t.read([&](const Subject& subject) {
               return subject.clipped_cells({xmin, ymin, xmax, ymax});
             }));
           })
      .def("_bounded_cells", &Triangulation::bounded_cells)
      .def("_bounded_gradients", &Triangulation::bounded_gradients)
      .def("_answer", &Triangulation::answer)
      .def("_cell_corners",
           [](Triangulation& t, std::int64_t id) {
             return to_numpy(t.read([&](const Subject& s) { return s.cell_corners(id); }));
           })
      .def("_has_id",
           [](Triangulation& t, std::int64_t id) {
             return t.read([&](const Subject& subject) { return subject.has_id(id); });
           })
      .def("mend", &Triangulation::mend,
           "Make the triangulation exactly Delaunay after a heuristic update, and return a "
           "report.\n\n"
           "Does nothing if it is certified.")
      .def(
          "certify",
          [](Triangulation& t) {
            return t.read([](Subject& subject) { return subject.certify(); });
          },
          "Test by exact predicates whether the triangulation is Delaunay, and certify it if "
          "so.\n\n"
          "Cost: one pass over the edges; none if it is certified.")
      .def("is_valid", asking(&Subject::is_valid),
           "Whether everything is as it must be, tested exactly. For tests. Cost: linear.")
      .def_property_readonly("last_report", &Triangulation::last_report,
                             "UpdateReport: what the last call that changed something did.")
      .def_property_readonly("is_certified", asking(&Subject::is_certified),
                             "bool: whether exact predicates have proved it Delaunay.")
      .def_property_readonly("number_of_points", asking(&Subject::number_of_points),
                             "int: points, coincident ones included.")
      .def_property_readonly("number_of_ids", asking(&Subject::number_of_ids),
                             "int: one more than the largest id ever in use.")
      .def_property_readonly("number_of_vertices", asking(&Subject::number_of_vertices),
                             "int: places that differ.");
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.attr("__version__") = CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION;
  register_errors();
  bind_report(module);
  bind_classifier_frame(module);
  bind_bounded_cells(module);
  bind_recordings(module);
  bind_triangulation(module);
}

} // namespace python
