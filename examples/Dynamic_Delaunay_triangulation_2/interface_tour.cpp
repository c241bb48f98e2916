// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A few lines for each part of the interface. The manual and the README show them.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Interpolation_weights_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_in_domain_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

std::vector<Point> random_points(int number)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0, 20), y(0, 10);
  std::vector<Point> points;
  for (int i = 0; i < number; ++i) {
    const double px = x(random);
    points.push_back(Point(px, y(random)));
  }
  return points;
}

//! [property map]
struct Particle
{
  Point position;
  double mass;
};

struct Position_map
{
  using key_type = Particle;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;

  friend reference get(const Position_map&, const Particle& p) { return p.position; }
};
//! [property map]

bool create_and_update()
{
  std::vector<Point> points = random_points(200);
  //! [creation]
  Dynamic dt(points.begin(), points.end()); // the i-th point has id i
  //! [creation]
  points[17] = Point(4, 5);
  //! [update]
  const CGAL::Update_report_2 report = dt.update(points.begin(), points.end());
  if (report.rebuilt())
    std::cout << "so much has moved that everything was triangulated anew\n";
  //! [update]

  std::vector<Particle> particles;
  for (const Point& p : points)
    particles.push_back({p, 1});
  //! [update through a map]
  dt.update(particles.begin(), particles.end(), Position_map());
  //! [update through a map]

  //! [ids]
  const auto v = dt.vertex(17); // CGAL's vertex handle of the point with id 17
  const std::size_t id = dt.id(v);
  const Point& p = dt.point(17);
  //! [ids]
  //! [properties]
  const auto mass = dt.add_vertex_property<double>("mass", 1).first;
  mass[dt.vertex(17)] = 2.5; // stays with point 17, whatever index its vertex gets
  //! [properties]
  return report.certified && id == 17 && p == v->point() && mass[dt.vertex(16)] == 1;
}

bool refuse_bad_input()
{
  std::vector<Point> points = random_points(200);
  Dynamic dt(points.begin(), points.end());
  points[5] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
  //! [errors]
  try {
    dt.update(points.begin(), points.end());
  } catch (const CGAL::Non_finite_coordinate_error_2& error) {
    std::cout << error.what() << '\n'; // and everything is as it was
  }
  //! [errors]
  return dt.is_certified() && dt.is_valid() && std::isfinite(dt.point(5).x());
}

bool change_population()
{
  const std::vector<Point> points = random_points(200);
  Dynamic dt(points.begin(), points.end());
  //! [population]
  const std::size_t id = dt.insert(Point(1, 2)); // the smallest free id
  dt.move(id, Point(1, 3)); // or a range of pairs of ids and points; the others stay
  dt.remove(id);
  //! [population]

  std::vector<std::pair<long, Point>> frame = {
      {4711, Point(0, 0)}, {4712, Point(1, 0)}, {4720, Point(0, 1)}};
  //! [users' ids]
  CGAL::Dynamic_population_2<Dynamic, long> crowd;
  crowd.update(frame.begin(), frame.end()); // pairs of your own ids and points, the whole frame
  //! [users' ids]
  return id == 200 && dt.number_of_points() == 200 && crowd.size() == 3;
}

bool look_at_flat_arrays()
{
  const std::vector<Point> points = random_points(200);
  const Dynamic dt(points.begin(), points.end());
  //! [frame]
  const auto frame = dt.frame();
  double longest = 0;
  for (const auto& edge : frame.edges()) {
    if (frame.is_infinite(edge))
      continue;
    const auto& p = frame.position(edge.source);
    const auto& q = frame.position(edge.target);
    longest = std::fmax(longest, std::hypot(p.x - q.x, p.y - q.y));
  }
  //! [frame]
  return longest > 1;
}

bool help_a_simulation()
{
  const std::vector<Point> points = random_points(200);
  const Dynamic dt(points.begin(), points.end());
  const std::size_t i = 17;
  Kernel::Vector_2 force(0, 0);
  //! [neighbor lists]
  CGAL::Delaunay_neighbor_lists_2 lists; // keeps its memory from frame to frame
  lists.compute(dt);
  for (const std::size_t j : lists.neighbors(i)) // or, as arrays, lists.offsets() and neighbors()
    force += points[j] - points[i];              // a spring to each neighbor
  //! [neighbor lists]

  //! [Voronoi cells]
  CGAL::Voronoi_cell_measures_2 cells;
  cells.compute(dt, CGAL::Bbox_2(0, 0, 20, 10)); // the cells fill the box
  const double density = 1 / cells.areas()[i];   // and cells.perimeters()
  cells.compute(dt);                             // whole cells
  const auto [x, y] = cells.centroids()[i];      // and cells.shape_indices()
  //! [Voronoi cells]

  double total = 0;
  //! [Voronoi edges]
  CGAL::for_each_voronoi_edge(dt, [&](std::size_t, std::size_t, double length) {
    if (std::isfinite(length)) // not between neighbors on the hull
      total += length;
  });
  std::vector<CGAL::Voronoi_cell_measures_2::Position> corners;
  CGAL::voronoi_cell_corners(dt, i, std::back_inserter(corners));
  //! [Voronoi edges]

  //! [Voronoi forces]
  std::vector<double> by_area(points.size()), by_perimeter(points.size()); // derivatives of E
  for (std::size_t k = 0; k < points.size(); ++k) {
    by_area[k] = 2 * (cells.areas()[k] - 1);
    by_perimeter[k] = 2 * (cells.perimeters()[k] - 3.8);
  }
  CGAL::Voronoi_cell_gradients_2 gradients;
  gradients.compute(dt, by_area, by_perimeter); // ignores what unbounded cells have there
  const auto [dx, dy] = gradients.gradients()[i];
  force -= Kernel::Vector_2(dx, dy);
  //! [Voronoi forces]

  //! [bounded cells]
  using Bounded_cells = CGAL::Bounded_voronoi_cells_2;
  const std::vector<Point> walls{Point(-5, 0), Point(25, 0), Point(10, 20)}; // counterclockwise
  Bounded_cells bounded;
  bounded.set_domain(walls.begin(), walls.end());
  bounded.compute(dt, 1.5); // a radius
  double contact = 0;       // of point i with all of its neighbors
  for (std::size_t k = bounded.first_pieces()[i]; k < bounded.first_pieces()[i + 1]; ++k)
    if (bounded.pieces()[k].side == Bounded_cells::Side::NEIGHBOR)
      contact += bounded.pieces()[k].length;
  //! [bounded cells]

  CGAL::Polygon_2<Kernel> hall, pillar;
  for (const Point& p : {Point(-1, -1), Point(21, -1), Point(21, 11), Point(-1, 11)})
    hall.push_back(p);
  for (const Point& p : {Point(-0.9, -0.9), Point(-0.9, -0.8), Point(-0.8, -0.8)})
    pillar.push_back(p);
  //! [cells in a domain]
  CGAL::Polygon_with_holes_2<Kernel> domain(hall);
  domain.add_hole(pillar);
  using Cells_in_domain = CGAL::Voronoi_cells_in_domain_2;
  Cells_in_domain in_domain(domain, Cells_in_domain::Rule::VISIBLE);
  in_domain.compute(dt);       // or with radii
  std::vector<Point> boundary; // of cell i, the corners of its first ring
  const std::size_t ring = in_domain.first_rings()[i];
  for (std::size_t k = in_domain.first_pieces()[ring]; k < in_domain.first_pieces()[ring + 1]; ++k)
    boundary.emplace_back(in_domain.pieces()[k].from.x, in_domain.pieces()[k].from.y);
  const Cells_in_domain::Cell one = in_domain.cell(dt, i); // without the others
  //! [cells in a domain]

  std::vector<std::size_t> ids;
  //! [queries]
  CGAL::Delaunay_point_queries_2<Dynamic> queries(dt);
  const auto nearest = queries.nearest(Point(1, 2));          // none, if there is no point
  queries.neighbors_within(i, 0.25, std::back_inserter(ids)); // a squared radius; decided exactly
  //! [queries]

  const std::vector<Point> places{Point(1, 2), Point(1.5, 2)};
  const std::vector<double> temperatures(dt.number_of_ids(), 20);
  std::vector<double> samples;
  //! [interpolation]
  CGAL::Interpolation_weights_2 weights; // three arrays: offsets(), ids(), weights()
  weights.compute_natural_neighbor(dt, places.begin(), places.end());        // or compute_linear()
  weights.interpolate(temperatures.begin(), std::back_inserter(samples), 0); // 0 outside the hull
  //! [interpolation]
  return samples.size() == places.size() && lists.degree(i) >= 2 && force.squared_length() > 0 &&
         density > 0 && std::hypot(x - points[i].x(), y - points[i].y()) < 1 && total > 0 &&
         corners.size() > 2 && contact > 0 && boundary.size() > 2 && one.area > 0 &&
         nearest.has_value();
}

bool choose_what_is_done()
{
  std::vector<Point> points = random_points(200);
  //! [choices]
  using Classifier = CGAL::Point_distance_classifier_2;
  using Repair = CGAL::Border_splice_repair_2;
  using Policy = CGAL::Key_frame_policy_2;
  using Triangulation =
      CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier, CGAL::With_repair_2<Repair>,
                                             CGAL::With_policy_2<Policy>>;
  Triangulation::Settings settings;
  settings.classifier = Classifier(0.7);
  settings.repair = Repair(1);
  settings.policy = Policy(10);
  Triangulation dt(points.begin(), points.end(), settings);
  //! [choices]
  for (int frame = 1; frame <= 10; ++frame)
    dt.update(points.begin(), points.end());
  return dt.is_certified();
}

int main()
{
  return create_and_update() && refuse_bad_input() && change_population() &&
                 look_at_flat_arrays() && help_a_simulation() && choose_what_is_done()
             ? 0
             : 1;
}
