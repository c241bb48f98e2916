// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the benchmark of the Python package needs of C++: the motion of scenarios and recordings,
// and the same updates without Python.

#include "scenario_runner/Open_motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Triangulation = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Population = CGAL::Dynamic_population_2<Triangulation>;
using Points = py::array_t<double, py::array::c_style>;
using Ids = py::array_t<std::int64_t, py::array::c_style>;

// Nanoseconds that `work()` takes.
template <class Work>
double duration(const Work& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
}

// The frames of a scenario or of a recording, whose name tells which, one by one.
class Motion
{
public:
  Motion(const std::string& path, const std::optional<std::size_t>& points)
    : m_motion(scenario::open_motion(scenario::scenario_path(path), overrides(points)))
  {
    const auto& first = positions();
    if (m_motion->uses_neighbors()) {
      m_neighbors = std::make_unique<Triangulation>(first);
    }
  }

  std::string name() const { return m_motion->name(); }
  bool has_fixed_population() const { return m_motion->has_fixed_population(); }
  bool is_periodic() const { return m_motion->cell().has_value(); }

  Ids ids() const { return Ids(py::ssize_t(m_motion->ids().size()), m_motion->ids().data()); }

  Points points() const
  {
    Points points({py::ssize_t(m_motion->points().size()), py::ssize_t(2)});
    auto place = points.mutable_unchecked<2>();
    for (std::size_t i = 0; i < m_motion->points().size(); ++i) {
      place(py::ssize_t(i), 0) = m_motion->points()[i].x;
      place(py::ssize_t(i), 1) = m_motion->points()[i].y;
    }
    return points;
  }

  bool advance()
  {
    scenario::Neighbor_edges edges;
    if (m_neighbors) {
      m_neighbors->for_each_edge([&](std::size_t i, std::size_t j) {
        edges.emplace_back(std::uint32_t(i), std::uint32_t(j));
      });
    }
    const bool goes_on = m_motion->advance(edges);
    if (goes_on && m_neighbors) {
      m_neighbors->update(positions());
    }
    return goes_on;
  }

private:
  static scenario::Overrides overrides(const std::optional<std::size_t>& points)
  {
    scenario::Overrides overrides;
    overrides.points = points;
    return overrides;
  }

  std::vector<Point> positions() const
  {
    std::vector<Point> positions;
    for (const auto& p : m_motion->points()) {
      positions.emplace_back(p.x, p.y);
    }
    return positions;
  }

  std::unique_ptr<scenario::Motion> m_motion;
  std::unique_ptr<Triangulation> m_neighbors; // if the motion asks for them
};

// The rows, as a program in C++ has them.
CGAL::Iterator_range<const Point*> as_points(const Points& points)
{
  static_assert(sizeof(Point) == 2 * sizeof(double), "a point is two doubles");
  const auto* const first = reinterpret_cast<const Point*>(points.data());
  return {first, first + points.shape(0)};
}

// Both follow some frames, and return nanoseconds for each.
class Reference
{
public:
  explicit Reference(const Points& points)
    : m_triangulation(as_points(points))
  {
  }
  std::vector<double> follow(const std::vector<Points>& frames)
  {
    std::vector<double> times;
    for (const Points& frame : frames) {
      times.push_back(duration([&] { m_triangulation.update(as_points(frame)); }));
    }
    return times;
  }

private:
  Triangulation m_triangulation;
};

class Population_reference
{
public:
  std::vector<double> follow(const std::vector<std::pair<Ids, Points>>& frames)
  {
    std::vector<double> times;
    for (const auto& [ids, points] : frames) {
      const auto its_points = as_points(points);
      times.push_back(duration([&, first_id = ids.data()] {
        const auto pair = [&](std::size_t i) {
          return std::pair(first_id[i], its_points.begin()[i]);
        };
        m_population.update(
            boost::make_transform_iterator(boost::counting_iterator<std::size_t>(0), pair),
            boost::make_transform_iterator(boost::counting_iterator(its_points.size()), pair));
      }));
    }
    return times;
  }

private:
  Population m_population;
};

} // namespace

PYBIND11_MODULE(reference, module)
{
  py::class_<Motion>(module, "Motion")
      .def(py::init<const std::string&, const std::optional<std::size_t>&>(), py::arg("path"),
           py::arg("points") = py::none())
      .def_property_readonly("name", &Motion::name)
      .def_property_readonly("has_fixed_population", &Motion::has_fixed_population)
      .def_property_readonly("is_periodic", &Motion::is_periodic)
      .def_property_readonly("ids", &Motion::ids)
      .def_property_readonly("points", &Motion::points)
      .def("advance", &Motion::advance);
  py::class_<Reference>(module, "Reference")
      .def(py::init<const Points&>())
      .def("follow", &Reference::follow);
  py::class_<Population_reference>(module, "PopulationReference")
      .def(py::init<>())
      .def("follow", &Population_reference::follow);
  module.def("recordings", [] { return scenario::recordings(); });
}
