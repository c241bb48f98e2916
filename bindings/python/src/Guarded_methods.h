// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_GUARDED_METHODS_H
#define PYTHON_GUARDED_METHODS_H

#include "bindings/python/src/Guarded_subject.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>

namespace python {

// A call that asks the subject, where `question(subject)` returns the answer.
template <class Guarded, class Question>
auto asking(const Question& question)
{
  return [=](Guarded& guarded) { return guarded.read(question); };
}

// Binds what triangulations of all spaces have, with the name of their reports, and what is to be
// said of `mend()`.
template <class Guarded, class... Options>
void bind_guarded(pybind11::class_<Guarded, Options...>& type, const std::string& report,
                  const char* mend_documentation)
{
  const std::string last_report = report + ": what the last call that changed something did.";
  type.def("_move", &Guarded::move)
      .def("_insert", &Guarded::insert)
      .def("_remove", &Guarded::remove)
      .def("_restore", &Guarded::restore)
      .def("_arrays", &Guarded::arrays)
      .def("_is_current", &Guarded::is_current)
      .def("_answer", &Guarded::answer)
      .def("_checkpoint",
           [](Guarded& guarded) {
             return pybind11::bytes(
                 guarded.read([](const auto& subject) { return subject.checkpoint(); }));
           })
      .def("_has_id",
           [](Guarded& guarded, std::int64_t id) {
             return guarded.read([&](const auto& subject) { return subject.has_id(id); });
           })
      .def("mend", &Guarded::mend, mend_documentation)
      .def("certify", asking<Guarded>([](auto& subject) { return subject.certify(); }),
           "Test by exact predicates whether the triangulation is Delaunay, and certify it if "
           "so.\n\n"
           "Cost: one pass; in the plane none if it is certified.")
      .def("is_valid", asking<Guarded>([](const auto& subject) { return subject.is_valid(); }),
           "Whether everything is as it must be, tested exactly. For tests. Cost: linear.")
      .def_property_readonly("last_report", &Guarded::last_report, last_report.c_str())
      .def_property_readonly("is_certified", asking<Guarded>([](const auto& subject) {
                               return subject.is_certified();
                             }),
                             "bool: whether exact predicates have proved it Delaunay.")
      .def_property_readonly("number_of_points", asking<Guarded>([](const auto& subject) {
                               return subject.number_of_points();
                             }),
                             "int: points, coincident ones included.")
      .def_property_readonly("number_of_ids", asking<Guarded>([](const auto& subject) {
                               return subject.number_of_ids();
                             }),
                             "int: one more than the largest id ever in use.")
      .def_property_readonly("number_of_vertices", asking<Guarded>([](const auto& subject) {
                               return subject.number_of_vertices();
                             }),
                             "int: places that differ.");
}

} // namespace python

#endif // PYTHON_GUARDED_METHODS_H
