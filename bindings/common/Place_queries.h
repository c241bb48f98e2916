// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_PLACE_QUERIES_H
#define BINDINGS_PLACE_QUERIES_H

#include "bindings/common/Array_reading.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_alpha_shape_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Interpolation_weights_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bindings {

// What queries find: rows, and shifts, which are zeros in the plane.
template <class Dynamic>
class Found_images
{
public:
  using Point = typename Dynamic::Point;
  using Shift = CGAL::Periodic_shift_2;

  Found_images(const Dynamic& dt, const Row_numbers& row_numbers, std::size_t size)
    : m_dt(dt)
    , m_row_numbers(row_numbers)
  {
    check_length(2 * size);
    m_rows.reserve(size);
    m_shifts.reserve(2 * size);
  }

  void add(std::size_t id, const Shift& shift)
  {
    m_rows.push_back(m_row_numbers[id]);
    append(m_shifts, shift);
  }
  // Also notes the distance from the place.
  void add(const std::pair<std::size_t, Shift>& image, const Point& place)
  {
    add(image.first, image.second);
    m_distances.push_back(distance(image.first, image.second, place));
  }
  void add(std::size_t id, const Point& place) { add({id, {0, 0}}, place); }
  void add_none()
  {
    m_rows.push_back(-1);
    append(m_shifts, {0, 0});
    m_distances.push_back(std::numeric_limits<double>::infinity());
  }

  Array rows() { return {std::move(m_rows)}; }
  Array shifts() { return {std::move(m_shifts), {2}}; }
  Array distances() { return {std::move(m_distances)}; }

private:
  double distance(std::size_t id, const Shift& shift, const Point& place) const
  {
    const auto& p = m_dt.point(id);
    double x = p.x() - place.x(), y = p.y() - place.y();
    if constexpr (is_periodic_triangulation<Dynamic>) {
      const CGAL::Periodic_cell_2& cell = m_dt.cell();
      x += shift[0] * cell.ax() + shift[1] * cell.bx();
      y += shift[0] * cell.ay() + shift[1] * cell.by();
    }
    return std::hypot(x, y);
  }

  const Dynamic& m_dt;
  const Row_numbers& m_row_numbers;
  Integers m_rows, m_shifts;
  Doubles m_distances;
};

// Where the list of each place begins, and where the last one ends.
inline Array begins_array(const std::vector<std::size_t>& begins)
{
  check_length(begins.back());
  Integers numbers;
  numbers.reserve(begins.size());
  for (const std::size_t begin : begins) {
    numbers.push_back(std::int32_t(begin));
  }
  return {std::move(numbers)};
}

// Of each place the row of the nearest point, -1 if there are no points; its distance and shift.
template <class Dynamic, class Places>
std::vector<Array> nearest_arrays(const Dynamic& dt, const Row_numbers& rows, const Places& places)
{
  using Queries = CGAL::Delaunay_point_queries_2<Dynamic>;
  std::vector<std::optional<typename Queries::Answer>> answers;
  Queries(dt).nearest(places.begin(), places.end(), std::back_inserter(answers));
  Found_images<Dynamic> found(dt, rows, answers.size());
  auto place = places.begin();
  for (const auto& answer : answers) {
    if (answer) {
      found.add(*answer, *place);
    } else {
      found.add_none();
    }
    ++place;
  }
  return {found.rows(), found.distances(), found.shifts()};
}

// The square of a radius, rounded up, so that no point on the circle is lost.
inline double square_of_radius(double radius)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  constexpr double least_exact = 1e-280; // below it the error of a square may underflow
  const double square = radius * radius;
  if (!(square < largest)) {
    return largest;
  }
  const bool is_rounded_down = std::fma(radius, radius, -square) > 0;
  const bool is_tiny = radius > 0 && square < least_exact;
  return is_rounded_down || is_tiny ? std::nextafter(square, largest) : square;
}

// Refuses a radius with which arrays of 32 bits could not hold what is found. In the plane each
// point is found once for each place at most.
template <class Dynamic>
void check_number_of_images(const Dynamic& dt, std::size_t places, double radius)
{
  if constexpr (is_periodic_triangulation<Dynamic>) {
    constexpr double most = (std::numeric_limits<std::int32_t>::max)(), pi = 3.14159;
    const CGAL::Periodic_cell_2& cell = dt.cell();
    const double length = std::hypot(cell.ax(), cell.ay());
    const double area = std::abs(cell.ax() * cell.by() - cell.ay() * cell.bx());
    const double images = cell.is_slab() ? 2 * radius / length : pi * radius * (radius / area);
    const double found = images * double(dt.number_of_points()) * double(places);
    if (found > 2 * most) { // well above, since the images in a circle vary
      throw std::invalid_argument("the radius is so large, compared to the cell, that about " +
                                  std::to_string(std::llround((std::min)(found, 1e18))) +
                                  " images would be found: an array holds at most 2147483647");
    }
  }
}

// Where the list of each place begins; rows, distances and shifts of the points in its circle.
template <class Dynamic, class Places>
std::vector<Array> within_arrays(const Dynamic& dt, const Row_numbers& rows, const Places& places,
                                 double radius)
{
  using Queries = CGAL::Delaunay_point_queries_2<Dynamic>;
  const std::size_t size = std::size_t(places.end() - places.begin());
  check_number_of_images(dt, size, radius);
  std::vector<typename Queries::Answer> answers;
  std::vector<std::size_t> begins;
  Queries(dt).within(places.begin(), places.end(), square_of_radius(radius), answers, begins);
  Found_images<Dynamic> found(dt, rows, answers.size());
  for (std::size_t i = 0; i < size; ++i) {
    const auto place = *(places.begin() + std::ptrdiff_t(i));
    for (std::size_t k = begins[i]; k < begins[i + 1]; ++k) {
      found.add(answers[k], place);
    }
  }
  return {begins_array(begins), found.rows(), found.distances(), found.shifts()};
}

// Where the list of each place begins; rows, weights and shifts.
template <class Dynamic>
std::vector<Array> weight_arrays(const Dynamic& dt, const Row_numbers& rows,
                                 const CGAL::Interpolation_weights_2& weights)
{
  Found_images<Dynamic> found(dt, rows, weights.ids().size());
  for (std::size_t i = 0; i < weights.ids().size(); ++i) {
    found.add(weights.ids()[i],
              weights.shifts().empty() ? CGAL::Periodic_shift_2{0, 0} : weights.shifts()[i]);
  }
  return {begins_array(weights.offsets()), found.rows(), {weights.weights()}, found.shifts()};
}

using Alpha_class = CGAL::Delaunay_alpha_shape_2::Classification_type;

// Of points on a line, whose edges have no numbers: an edge is in the complex, without a face, if
// the square of its length is at most four times alpha.
template <class Dynamic>
Integers alpha_classes_on_line(const Dynamic& dt, double alpha)
{
  using Point = typename Dynamic::Point;
  const double square = 4 * alpha;
  const bool is_finite = std::isfinite(square);
  const double scale = is_finite ? 1 : 0.5;
  const auto scaled = [&](std::size_t id) {
    return Point(scale * dt.point(id).x(), scale * dt.point(id).y());
  };
  Integers classes;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const auto&...) {
    const bool is_long = CGAL::compare_squared_distance(scaled(i), scaled(j),
                                                        is_finite ? square : alpha) == CGAL::LARGER;
    classes.push_back(std::int32_t(is_long ? Alpha_class::EXTERIOR : Alpha_class::SINGULAR));
  });
  return classes;
}

// Whether a face is one of those that `for_each_face()` passes over.
template <bool is_periodic, class Frame>
bool is_passed_over_face(const Frame& frame, typename Frame::Face_index f)
{
  if constexpr (is_periodic) {
    return frame.state().is_in_gap(f);
  } else {
    const auto face = frame.face(f);
    return frame.is_infinite(face[0]) || frame.is_infinite(face[1]) || frame.is_infinite(face[2]);
  }
}

// The classes of points, by rows, of edges and of faces, in the order of their arrays.
template <class Dynamic>
std::vector<Array> alpha_arrays(const Dynamic& dt, const Row_numbers& rows, double alpha)
{
  using Edge_index = typename Dynamic::Frame::Edge_index;
  using Face_index = typename Dynamic::Frame::Face_index;
  constexpr bool is_periodic = is_periodic_triangulation<Dynamic>;
  CGAL::Delaunay_alpha_shape_2 shape;
  shape.compute(dt, alpha);
  const auto frame = dt.frame();
  Integers points, edges, faces;
  for (std::size_t id = 0; id < shape.points().size(); ++id) {
    if (dt.has_id(id) || !rows.are_dense()) {
      points.push_back(std::int32_t(shape.points()[id]));
    }
  }
  for (Edge_index e(0); e < shape.edges().size(); ++e) {
    if (!is_passed_over<is_periodic>(frame, e)) {
      edges.push_back(std::int32_t(shape.edges()[e]));
    }
  }
  for (Face_index f(0); f < shape.faces().size(); ++f) {
    if (!is_passed_over_face<is_periodic>(frame, f)) {
      faces.push_back(std::int32_t(shape.faces()[f]));
    }
  }
  if (shape.edges().empty()) {
    edges = alpha_classes_on_line(dt, alpha);
  }
  return {{std::move(points)}, {std::move(edges)}, {std::move(faces)}};
}

template <class Dynamic>
std::vector<Array> answer_arrays(const Dynamic& dt, const Row_numbers& rows,
                                 const Question& question)
{
  const auto places =
      row_range(question.places.size, Read_point<typename Dynamic::Point>{question.places});
  CGAL::Interpolation_weights_2 weights;
  switch (question.query) {
  case Query::NEAREST:
    return nearest_arrays(dt, rows, places);
  case Query::WITHIN:
    return within_arrays(dt, rows, places, question.extent);
  case Query::NATURAL_WEIGHTS:
    weights.compute_natural_neighbor(dt, places.begin(), places.end());
    return weight_arrays(dt, rows, weights);
  case Query::LINEAR_WEIGHTS:
    weights.compute_linear(dt, places.begin(), places.end());
    return weight_arrays(dt, rows, weights);
  case Query::ALPHA_SHAPE:
    return alpha_arrays(dt, rows, question.extent);
  }
  return {};
}

} // namespace bindings

#endif // BINDINGS_PLACE_QUERIES_H
