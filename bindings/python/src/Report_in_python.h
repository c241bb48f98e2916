// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_REPORT_IN_PYTHON_H
#define PYTHON_REPORT_IN_PYTHON_H

#include "bindings/common/Report_fields.h"

#include <pybind11/pybind11.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string>

namespace python {

template <class Report>
struct Report_count
{
  const char* name;
  std::size_t Report::*value;
  const char* documentation;
  bool is_shown = false; // by repr()
};

// What a call did, with these counts.
template <class Report, std::size_t number>
void bind_report(pybind11::module_& module, const std::string& name,
                 const std::array<Report_count<Report>, number>& counts)
{
  namespace py = pybind11;
  py::class_<Report> report_class(module, name.c_str(),
                                  "What one call did. All counts are integers.");
  for (const Report_count<Report>& count : counts) {
    report_class.def_readonly(count.name, count.value, count.documentation);
  }
  report_class
      .def_readonly("certified", &Report::certified,
                    "bool: whether the triangulation is proved Delaunay")
      .def_property_readonly("rebuilt", &Report::rebuilt,
                             "bool: whether everything was triangulated anew")
      .def_property_readonly("rebuild_reason", bindings::rebuild_reason<Report>,
                             "str: why everything was triangulated anew; None if it was not")
      .def(py::pickle(
          [counts](const Report& report) {
            py::list values;
            for (const auto& count : counts) {
              values.append(report.*count.value);
            }
            return py::make_tuple(values, int(report.rebuild_reason), report.certified);
          },
          [counts](const py::tuple& state) {
            Report report;
            const py::list values = state[0];
            for (std::size_t i = 0; i < counts.size(); ++i) {
              report.*counts[i].value = values[i].template cast<std::size_t>();
            }
            report.rebuild_reason = CGAL::Rebuild_reason_2(state[1].template cast<int>());
            report.certified = state[2].template cast<bool>();
            return report;
          }))
      .def(
          "__eq__",
          [counts](const Report& a, const Report& b) {
            return std::all_of(
                       counts.begin(), counts.end(),
                       [&](const auto& count) { return a.*count.value == b.*count.value; }) &&
                   a.rebuild_reason == b.rebuild_reason && a.certified == b.certified;
          },
          py::is_operator())
      .def("__repr__", [counts, name](const Report& report) {
        std::ostringstream out;
        out << name << '(';
        for (const auto& count : counts) {
          if (count.is_shown) {
            out << count.name << '=' << report.*count.value << ", ";
          }
        }
        out << "rebuild_reason="
            << (report.rebuilt() ? "'" + std::string(bindings::rebuild_reason(report)) + "'"
                                 : "None")
            << ", certified=" << (report.certified ? "True" : "False") << ')';
        return out.str();
      });
}

} // namespace python

#endif // PYTHON_REPORT_IN_PYTHON_H
