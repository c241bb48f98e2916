// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Errors.h"

#include "bindings/common/Error_description.h"
#include "scenario_runner/Text_input.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <variant>

namespace py = pybind11;

namespace python {

using namespace bindings;

namespace {

void set_error(const char* name, const std::string& message, const py::dict& data = {})
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

py::object value_of(const Error_field& field)
{
  if (const auto* const digits = std::get_if<Digits>(&field.value)) {
    return number(digits->text);
  }
  if (const auto* const real = std::get_if<double>(&field.value)) {
    return py::float_(*real);
  }
  return py::int_(std::get<std::size_t>(field.value));
}

// Of what these files, and what they use, refuse by exceptions of pybind11 and of C++. Any other
// one is none of the package.
void translate_refusal(const std::exception_ptr& exception)
{
  try {
    std::rethrow_exception(exception);
  } catch (const py::type_error& error) {
    set_error("InputTypeError", error.what());
  } catch (const py::value_error& error) {
    set_error("InputValueError", error.what());
  } catch (const std::invalid_argument& error) {
    set_error("InputValueError", error.what());
  } catch (const std::out_of_range& error) {
    set_error("InputIndexError", error.what());
  } catch (const Use_error& error) {
    set_error("UseError", error.what());
  } catch (const Untold_error& error) {
    set_error("UncertifiedTriangulationError", error.what());
  } catch (const scenario::Scenario_error& error) {
    using namespace py::literals;
    set_error("RecordingError", error.what(), py::dict("line"_a = error.line()));
  }
}

void translate(std::exception_ptr exception)
{
  if (const auto description = error_description(exception)) {
    py::dict data;
    for (const Error_field& field : description->fields) {
      data[field.name] = value_of(field);
    }
    set_error(description->name, description->message, data);
  } else {
    translate_refusal(exception);
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
