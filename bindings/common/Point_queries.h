// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_POINT_QUERIES_H
#define BINDINGS_POINT_QUERIES_H

#include "bindings/common/Array_reading.h"
#include "bindings/common/Found_points.h"
#include "bindings/common/Row_iterator.h"
#include "bindings/common/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_alpha_shape_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Interpolation_weights_2.h>
#include <CGAL/enum.h>
#include <CGAL/Periodic_cell_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace bindings {

// About how many images of a point are in a circle.
inline double images_within(const CGAL::Periodic_cell_2& cell, double radius)
{
  constexpr double pi = 3.14159;
  const double length = std::hypot(cell.ax(), cell.ay());
  const double area = std::abs(cell.ax() * cell.by() - cell.ay() * cell.bx());
  return cell.is_slab() ? 2 * radius / length : pi * radius * (radius / area);
}

// Where the list of each query point begins; rows, weights and shifts.
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
  const auto query_points = row_range(question.query_points.size,
                                      Read_point<typename Dynamic::Point>{question.query_points});
  using Queries = CGAL::Delaunay_point_queries_2<Dynamic>;
  CGAL::Interpolation_weights_2 weights;
  switch (question.query) {
  case Query::NEAREST:
    return nearest_arrays<Queries>(dt, rows, query_points);
  case Query::WITHIN:
    if constexpr (is_periodic_triangulation<Dynamic>) {
      check_number_of_images(images_within(dt.cell(), question.extent), dt.number_of_points(),
                             question.query_points.size);
    }
    return within_arrays<Queries>(dt, rows, query_points, question.extent);
  case Query::NATURAL_WEIGHTS:
    weights.compute_natural_neighbor(dt, query_points.begin(), query_points.end());
    return weight_arrays(dt, rows, weights);
  case Query::LINEAR_WEIGHTS:
    weights.compute_linear(dt, query_points.begin(), query_points.end());
    return weight_arrays(dt, rows, weights);
  case Query::ALPHA_SHAPE:
    return alpha_arrays(dt, rows, question.extent);
  }
  return {};
}

} // namespace bindings

#endif // BINDINGS_POINT_QUERIES_H
