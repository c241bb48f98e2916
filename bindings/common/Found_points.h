// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_FOUND_POINTS_H
#define BINDINGS_FOUND_POINTS_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bindings {

// What queries find: rows, and shifts, which are zeros where space is not periodic.
template <class Dynamic>
class Found_images
{
  static constexpr std::size_t dimension = std::size_t(dimension_of<typename Dynamic::Point>);

public:
  using Point = typename Dynamic::Point;
  using Shift = std::array<int, dimension>;

  Found_images(const Dynamic& dt, const Row_numbers& row_numbers, std::size_t size)
    : m_dt(dt)
    , m_row_numbers(row_numbers)
  {
    check_length(dimension * size);
    m_rows.reserve(size);
    m_shifts.reserve(dimension * size);
  }

  void add(std::size_t id, const Shift& shift) { append(m_row_numbers[id], shift); }
  // Also notes the distance from the query point.
  void add(const std::pair<std::size_t, Shift>& image, const Point& query_point)
  {
    add(image.first, image.second);
    m_distances.push_back(distance(image.first, image.second, query_point));
  }
  void add(std::size_t id, const Point& query_point) { add({id, Shift{}}, query_point); }
  void add_none()
  {
    append(-1, Shift{});
    m_distances.push_back(std::numeric_limits<double>::infinity());
  }

  Array rows() { return {std::move(m_rows)}; }
  Array shifts() { return {std::move(m_shifts), {dimension}}; }
  Array distances() { return {std::move(m_distances)}; }

private:
  void append(std::int32_t row, const Shift& shift)
  {
    m_rows.push_back(row);
    m_shifts.insert(m_shifts.end(), shift.begin(), shift.end());
  }

  double distance(std::size_t id, [[maybe_unused]] const Shift& shift,
                  const Point& query_point) const
  {
    const auto& p = m_dt.point(id);
    double x = p.x() - query_point.x(), y = p.y() - query_point.y();
    if constexpr (dimension == 3) {
      double z = p.z() - query_point.z();
      if constexpr (is_periodic_triangulation<Dynamic>) {
        for (std::size_t i = 0; i < dimension; ++i) {
          const auto& vector = m_dt.cell().vector(i);
          x += shift[i] * vector[0];
          y += shift[i] * vector[1];
          z += shift[i] * vector[2];
        }
      }
      return std::hypot(x, y, z);
    } else if constexpr (is_periodic_triangulation<Dynamic>) {
      const auto& cell = m_dt.cell();
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

// Where the list of each query point begins, and where the last one ends.
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

// What a query for one point returns: an id, or an image, if there is any point.
template <class Queries>
using Nearest_of = decltype(std::declval<const Queries&>().nearest(
    std::declval<const typename Queries::Point&>()));

// Of each query point the row of the nearest point, -1 if there are no points; its distance and
// shift.
template <class Queries, class Dynamic, class Query_points>
std::vector<Array> nearest_arrays(const Dynamic& dt, const Row_numbers& rows,
                                  const Query_points& query_points)
{
  std::vector<Nearest_of<Queries>> answers;
  Queries(dt).nearest(query_points.begin(), query_points.end(), std::back_inserter(answers));
  Found_images<Dynamic> found(dt, rows, answers.size());
  auto query_point = query_points.begin();
  for (const auto& answer : answers) {
    if (answer) {
      found.add(*answer, *query_point);
    } else {
      found.add_none();
    }
    ++query_point;
  }
  return {found.rows(), found.distances(), found.shifts()};
}

// The square of a radius, rounded up, so that no point on the circle or sphere is lost.
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

// Refuses a radius with which arrays of 32 bits could not hold what is found, where about so many
// images of each point are within it.
inline void check_number_of_images(double images, std::size_t points, std::size_t query_points)
{
  constexpr double most = (std::numeric_limits<std::int32_t>::max)();
  const double found = images * double(points) * double(query_points);
  if (found > 2 * most) { // well above, since their numbers vary
    throw std::invalid_argument("the radius is so large, compared to the cell, that about " +
                                std::to_string(std::llround((std::min)(found, 1e18))) +
                                " images would be found: an array holds at most 2147483647");
  }
}

// Where the list of each query point begins; rows, distances and shifts of the points within the
// radius.
template <class Queries, class Dynamic, class Query_points>
std::vector<Array> within_arrays(const Dynamic& dt, const Row_numbers& rows,
                                 const Query_points& query_points, double radius)
{
  std::vector<typename Nearest_of<Queries>::value_type> answers;
  std::vector<std::size_t> begins;
  Queries(dt).within(query_points.begin(), query_points.end(), square_of_radius(radius), answers,
                     begins);
  Found_images<Dynamic> found(dt, rows, answers.size());
  for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
    const auto query_point = *(query_points.begin() + std::ptrdiff_t(i));
    for (std::size_t k = begins[i]; k < begins[i + 1]; ++k) {
      found.add(answers[k], query_point);
    }
  }
  return {begins_array(begins), found.rows(), found.distances(), found.shifts()};
}

} // namespace bindings

#endif // BINDINGS_FOUND_POINTS_H
