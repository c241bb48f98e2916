// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Function_in_python.h"

#include "bindings/python/src/Errors.h"
#include "bindings/python/src/Numpy.h"

#include <utility>
#include <vector>

namespace py = pybind11;

namespace python {

namespace {

// Refers to the triangulation, and is cut off from it when the call ends.
class Classifier_frame
{
public:
  explicit Classifier_frame(const Frame_copies& frame)
    : m_frame(&frame)
  {
  }

  void end() { m_frame = nullptr; }

  const Frame_copies& operator*() const
  {
    if (m_frame == nullptr) {
      throw Use_error("a frame is valid only while its classifier is called");
    }
    return *m_frame;
  }

private:
  const Frame_copies* m_frame;
};

std::vector<std::int64_t> integers(py::handle object, const char* name)
{
  if (object.is_none()) {
    return {};
  }
  const Input input = ids_input(object, name);
  const Rows& rows = input.rows;
  std::vector<std::int64_t> numbers;
  for (std::size_t i = 0; i < rows.size; ++i) {
    numbers.push_back(rows.at<std::int64_t>(i, 0));
  }
  return numbers;
}

class Function_in_python : public Python_function
{
public:
  explicit Function_in_python(Shared_reference function)
    : m_function(std::move(function))
    , m_wants_updates(py::hasattr(*m_function, "after_update"))
  {
  }

  Named classify(const Frame_copies& frame) const override
  {
    const py::gil_scoped_acquire lock;
    const py::object answer = call(*m_function, frame);
    if (answer.is_none()) {
      return {};
    }
    if (!py::isinstance<py::tuple>(answer)) {
      return {integers(answer, "the classifier's vertices"), {}};
    }
    const py::tuple both(answer);
    if (both.size() != 2) {
      throw py::value_error(
          "a classifier returns None, vertices, or a tuple of vertices and edges");
    }
    return {integers(both[0], "the classifier's vertices"),
            integers(both[1], "the classifier's edges")};
  }

  void after_update(const Frame_copies& frame) const override
  {
    if (m_wants_updates) {
      const py::gil_scoped_acquire lock;
      call(m_function->attr("after_update"), frame);
    }
  }

private:
  static py::object call(const py::object& function, const Frame_copies& frame)
  {
    const auto shown = std::make_shared<Classifier_frame>(frame);
    const struct At_end
    {
      Classifier_frame& frame;
      ~At_end() { frame.end(); }
    } at_end{*shown};
    return function(shown);
  }

  Shared_reference m_function;
  bool m_wants_updates;
};

template <class Function>
auto array_of(Function Frame_copies::*copy, std::vector<std::size_t> shape_of_row)
{
  return [=](const Classifier_frame& frame) {
    return to_numpy({((*frame).*copy)(), shape_of_row});
  };
}

} // namespace

std::shared_ptr<const Python_function> function_in_python(Shared_reference function)
{
  return std::make_shared<Function_in_python>(std::move(function));
}

void bind_classifier_frame(py::module_& module)
{
  py::class_<Classifier_frame, std::shared_ptr<Classifier_frame>>(
      module, "ClassifierFrame",
      "What a classifier is called with: the positions of the new frame, and the edges of the "
      "last\n"
      "one. Valid during the call. Every array is a copy that is made when it is asked for, so "
      "ask\n"
      "once; it may be kept. Vertices are numbered from 1; 0 is the infinite vertex.")
      .def_property_readonly("positions", array_of(&Frame_copies::positions, {2}),
                             "float64 (vertices + 1, 2): where each vertex is; NaN for vertex 0.")
      .def_property_readonly("previous_positions", array_of(&Frame_copies::previous_positions, {2}),
                             "float64 (vertices + 1, 2): where each vertex was one frame ago.")
      .def_property_readonly(
          "edges", array_of(&Frame_copies::edges, {4}),
          "int32 (edges, 4): both ends of each edge, and the vertices on its left\n"
          "and right. Edges to the infinite vertex are there, too.")
      .def_property_readonly(
          "corners", array_of(&Frame_copies::corners, {4, 2}),
          "float64 (edges, 4, 2): where the vertices in ``edges`` are, in periodic space as seen\n"
          "from the edge; NaN for vertex 0. A classifier that asks for these works in both spaces.")
      .def_property_readonly("ids", array_of(&Frame_copies::ids, {}),
                             "int32 (vertices + 1,): the id of each vertex; -1 for vertex 0.")
      .def_property_readonly(
          "new_edges", array_of(&Frame_copies::new_edges, {}),
          "int32 (k,): in after_update(), the edges that were triangulated anew,\n"
          "unless everything is new.")
      .def_property_readonly(
          "everything_is_new",
          [](const Classifier_frame& frame) { return (*frame).everything_is_new; },
          "bool: whether everything was triangulated anew, and vertices have other numbers.");
}

} // namespace python
