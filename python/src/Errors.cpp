// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Errors.h"

#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <pybind11/pybind11.h>

#include <exception>
#include <string>

namespace py = pybind11;

namespace python {

namespace {

void set_error(const char* name, const std::string& message, const py::dict& data)
{
  const py::object type = py::module_::import("dynamic_delaunay.errors").attr(name);
  const py::object error = type(message);
  for (const auto& [key, value] : data) {
    py::setattr(error, key, value);
  }
  PyErr_SetObject(type.ptr(), error.ptr());
}

py::object number(const std::string& digits)
{
  return py::int_(py::str(digits));
}

void translate(std::exception_ptr exception)
{
  using namespace py::literals;
  try {
    std::rethrow_exception(exception);
  } catch (const CGAL::Non_finite_coordinate_error_2& e) {
    set_error("NonFiniteCoordinateError", e.what(),
              py::dict("id"_a = e.id(), "x"_a = e.x(), "y"_a = e.y()));
  } catch (const CGAL::Coordinate_range_error_2& e) {
    set_error("CoordinateRangeError", e.what(),
              py::dict("id"_a = e.id(), "x"_a = e.x(), "y"_a = e.y(), "limit"_a = e.limit()));
  } catch (const CGAL::Point_count_error_2& e) {
    set_error("PointCountError", e.what(),
              py::dict("expected"_a = e.expected(), "given"_a = e.given()));
  } catch (const CGAL::Point_limit_error_2& e) {
    set_error("PointLimitError", e.what(),
              py::dict("number"_a = e.number(), "limit"_a = e.limit()));
  } catch (const CGAL::Unknown_id_error_2& e) {
    set_error("UnknownIdError", e.what(),
              py::dict("id"_a = e.id(), "number_of_ids"_a = e.number_of_ids()));
  } catch (const CGAL::Unknown_user_id_error_2& e) {
    set_error("UnknownIdError", e.what(), py::dict("id"_a = number(e.id())));
  } catch (const CGAL::Repeated_id_error_2& e) {
    set_error("RepeatedIdError", e.what(), py::dict("id"_a = number(e.id())));
  } catch (const CGAL::Uncertified_triangulation_error_2&) {
    set_error(
        "UncertifiedTriangulationError", // that of C++ names what Python has not
        "the triangulation is not certified, as after a heuristic update: call mend() to make "
        "it Delaunay, or certify() to find out whether it is; points, edges, triangles and "
        "indices can be read as they are",
        {});
  } catch (const CGAL::Parameter_error_2& e) {
    set_error("ParameterError", e.what(), py::dict("value"_a = e.value()));
  } catch (const CGAL::Periodic_cell_error_2& e) {
    set_error("PeriodicCellError", e.what(), {});
  } catch (const CGAL::Periodic_range_error_2& e) {
    set_error("PeriodicRangeError", e.what(), py::dict("id"_a = e.id()));
  } catch (const CGAL::Checkpoint_error_2& e) {
    set_error("CheckpointError", e.what(), py::dict("line"_a = e.line()));
  } catch (const CGAL::Dynamic_Delaunay_triangulation_error_2& e) {
    set_error("DynamicDelaunayError", e.what(), {});
  }
}

} // namespace

void register_errors()
{
  py::register_exception_translator(translate);
}

void throw_unknown_id(std::int64_t id, std::size_t number_of_ids)
{
  using namespace py::literals;
  set_error("UnknownIdError",
            "there is no point with id " + std::to_string(id) + ": ids are not negative",
            py::dict("id"_a = id, "number_of_ids"_a = number_of_ids));
  throw py::error_already_set();
}

} // namespace python
