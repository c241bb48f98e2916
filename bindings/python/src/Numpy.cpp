// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Numpy.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace py = pybind11;

namespace python {

namespace {

std::string shape_text(const py::array& array)
{
  return py::str(array.attr("shape"));
}

// Whatever NumPy makes an array of, if its numbers are of one of these kinds.
py::array numbers(py::handle object, const std::string& kinds, const std::string& name)
{
  const py::array array = py::array::ensure(object);
  if (!array) {
    throw py::type_error(name + " cannot be read as an array of numbers");
  }
  if (!array.is(object) && py::isinstance<py::array>(object) &&
      py::isinstance(object, py::module_::import("numpy.ma").attr("MaskedArray"))) {
    throw py::type_error(name + " are a masked array, whose mask would be lost");
  }
  if (array.size() > 0 && kinds.find(array.dtype().kind()) == std::string::npos) {
    throw py::type_error(name + " have the type " + std::string(py::str(array.dtype())) + ": " +
                         (kinds == "iuf" ? "integers" : "real numbers") + " are needed");
  }
  return array;
}

template <class Number>
py::array of_type(const py::array& array)
{
  if (py::isinstance<py::array_t<Number>>(array)) {
    return array;
  }
  const py::array converted = py::array_t<Number, py::array::forcecast>::ensure(array);
  if (!converted) {
    throw py::error_already_set();
  }
  return converted;
}

// What most calls are given: nothing is to be asked or converted. The detours through NumPy take
// longer than a small frame.
template <class Number>
bool is_plain(py::handle object, py::ssize_t dimensions)
{
  const auto& numpy = py::detail::npy_api::get();
  if (Py_TYPE(object.ptr()) != reinterpret_cast<PyTypeObject*>(numpy.PyArray_Type_)) {
    return false;
  }
  const auto* const array = py::detail::array_proxy(object.ptr());
  const auto* const type = py::detail::array_descriptor_proxy(array->descr);
  return array->nd == dimensions && type->byteorder == '=' &&
         type->type_num == py::detail::npy_format_descriptor<Number>::value;
}

// Ids as programs write them that know floating point alone, such as pandas where some are missing.
// Beyond 2^53 not all integers are doubles.
py::array whole_numbers(const py::array& array, const std::string& name)
{
  const py::array numbers = of_type<double>(array);
  const auto flat = py::array_t<double>(numbers).unchecked<1>();
  for (py::ssize_t i = 0; i < flat.shape(0); ++i) {
    if (!(std::trunc(flat(i)) == flat(i) && std::abs(flat(i)) <= 0x1p53)) {
      throw py::type_error(name + " are real numbers, of which number " + std::to_string(i) +
                           " is " + std::string(py::str(py::float_(flat(i)))) +
                           ": integers are needed, or whole numbers up to 2**53");
    }
  }
  return of_type<std::int64_t>(numbers);
}

Input input(py::array array)
{
  Rows rows;
  rows.data = static_cast<const char*>(array.data());
  rows.size = std::size_t(array.shape(0));
  rows.to_next_row = array.strides(0);
  rows.to_next_column = array.ndim() > 1 ? array.strides(1) : 0;
  return {std::move(array), rows};
}

} // namespace

Input points_input(py::handle object, const std::string& name, int dimension)
{
  if (is_plain<double>(object, 2) &&
      py::detail::array_proxy(object.ptr())->dimensions[1] == dimension) {
    return input(py::reinterpret_borrow<py::array>(object));
  }
  const py::array array = numbers(object, "fiu", name);
  if (array.ndim() == 1 && array.size() == 0) {
    return {};
  }
  if (array.ndim() != 2 || array.shape(1) != dimension) {
    throw py::value_error(name + " have the shape " + shape_text(array) + ": it must be " +
                          (dimension == 2 ? "(n, 2), a row of x and y for each point"
                                          : "(n, 3), a row of x, y and z for each point"));
  }
  return input(of_type<double>(array));
}

Input copied_points_input(py::handle object)
{
  const Input original = points_input(object);
  return original.rows.size == 0 ? original : input(original.array.attr("copy")());
}

Input ids_input(py::handle object, const std::string& name)
{
  if (is_plain<std::int64_t>(object, 1)) {
    return input(py::reinterpret_borrow<py::array>(object));
  }
  const py::array array = numbers(object, "iuf", name);
  if (array.ndim() != 1) {
    throw py::value_error(name + " have the shape " + shape_text(array) + ": it must be (n,)");
  }
  if (array.dtype().kind() == 'f') {
    return input(whole_numbers(array, name));
  }
  if (array.size() > 0 && array.dtype().kind() == 'u' && array.itemsize() == 8 &&
      array.attr("max")().cast<std::uint64_t>() > std::uint64_t(INT64_MAX)) {
    throw py::value_error(name + " must be smaller than 2**63");
  }
  return input(of_type<std::int64_t>(array));
}

Input ids_input(py::handle object, std::size_t size, const std::string& name)
{
  Input ids = ids_input(object, name);
  if (ids.rows.size != size) {
    throw py::value_error("there are " + std::to_string(ids.rows.size) + ' ' + name + " and " +
                          std::to_string(size) + " points: there must be as many");
  }
  return ids;
}

Input numbers_input(py::handle object, const std::string& name)
{
  const py::array array = numbers(object, "fiu", name);
  if (array.ndim() != 1) {
    throw py::value_error(name + " have the shape " + shape_text(array) + ": it must be (n,)");
  }
  return input(of_type<double>(array));
}

py::array to_numpy(Array array)
{
  return std::visit(
      [&](auto& numbers) -> py::array {
        using Numbers = std::decay_t<decltype(numbers)>;
        std::size_t size_of_row = 1;
        for (const std::size_t extent : array.shape_of_row) {
          size_of_row *= extent;
        }
        std::vector<py::ssize_t> shape{py::ssize_t(numbers.size() / size_of_row)};
        shape.insert(shape.end(), array.shape_of_row.begin(), array.shape_of_row.end());
        auto owned = std::make_unique<Numbers>(std::move(numbers));
        const auto* const data = owned->data();
        const py::capsule owner(
            owned.release(), [](void* its_numbers) { delete static_cast<Numbers*>(its_numbers); });
        py::array result(py::dtype::of<typename Numbers::value_type>(), shape, data, owner);
        py::detail::array_proxy(result.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
        return result;
      },
      array.numbers);
}

py::tuple to_numpy(std::vector<Array> arrays)
{
  py::tuple tuple(arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    tuple[i] = to_numpy(std::move(arrays[i]));
  }
  return tuple;
}

} // namespace python
