// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi cells in polygons with holes, by three rules, against exact Boolean operations and
// against sweeps around their points.

#include "domain_oracle.h"
#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_in_domain_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace domain_oracle;
using Cells = CGAL::Voronoi_cells_in_domain_2;
using Rule = Cells::Rule;
using Side = Cells::Side;
using Plane = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Numbers = std::vector<double>;
using Point = Epick::Point_2;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Rule rules[]{Rule::WHOLE, Rule::CONNECTED, Rule::VISIBLE};

Plane triangulation(const Points& points)
{
  return Plane(points.begin(), points.end());
}

double sum(const Numbers& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

double area(const Domain& domain)
{
  Epeck::FT result = 0;
  const auto add = [&](const Polygon& ring, int sign) {
    const auto corners = query_oracle::exact_points(ring.container());
    result += sign * CGAL::abs(CGAL::polygon_area_2(corners.begin(), corners.end(), Epeck()));
  };
  add(domain.outer_boundary(), 1);
  for (const Polygon& hole : domain.holes())
    add(hole, -1);
  return CGAL::to_double(result);
}

Polygon polygon(const Points& corners)
{
  return Polygon(corners.begin(), corners.end());
}

Polygon box(double x, double y, double width, double height)
{
  return polygon(
      {Point(x, y), Point(x + width, y), Point(x + width, y + height), Point(x, y + height)});
}

bool is_inside(const Domain& domain, const Point& p)
{
  if (domain.outer_boundary().has_on_unbounded_side(p))
    return false;
  for (const Polygon& hole : domain.holes())
    if (hole.has_on_bounded_side(p))
      return false;
  return true;
}

bool is_on_wall(const Domain& domain, const Point& p)
{
  return domain.outer_boundary().has_on_boundary(p) ||
         std::any_of(domain.holes_begin(), domain.holes_end(),
                     [&](const Polygon& hole) { return hole.has_on_boundary(p); });
}

// -------------------------------------------------------------------------------------------------
// Domains.

// Three halls side by side, over a corridor.
Domain comb()
{
  return Domain(
      polygon({Point(0, 0), Point(12, 0), Point(12, 10), Point(9, 10), Point(9, 2), Point(8, 2),
               Point(8, 10), Point(5, 10), Point(5, 2), Point(4, 2), Point(4, 10), Point(0, 10)}));
}

Domain hall_with_pillars()
{
  Domain domain(box(0, 0, 10, 10));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      domain.add_hole(box(1.5 + 3 * i, 1.5 + 3 * j, 1, 1));
  return domain;
}

// A star with random rays, and as its holes smaller stars that touch neither it nor one another.
class Random_domain
{
public:
  explicit Random_domain(unsigned seed, bool is_on_grid)
    : m_random(seed)
    , m_is_on_grid(is_on_grid)
  {
  }

  Domain make()
  {
    for (;;) {
      const Polygon outer = star(5, 5, 5, 4 + int(m_random() % 12));
      if (outer.is_simple())
        return with_holes(Domain(outer));
    }
  }
  Point inside(const Domain& domain)
  {
    for (;;) {
      const Point p = anywhere();
      if (is_inside(domain, p))
        return p;
    }
  }
  Point anywhere(double low = 0, double high = 10)
  {
    const double x = rounded(between(low, high));
    return Point(x, rounded(between(low, high)));
  }
  // At most `number` points, all different.
  Points inside(const Domain& domain, std::size_t number)
  {
    std::set<Point> points;
    for (std::size_t i = 0; i < number; ++i)
      points.insert(inside(domain));
    return {points.begin(), points.end()};
  }

private:
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }
  double rounded(double x) const { return m_is_on_grid ? std::round(2 * x) / 2 : x; }

  Polygon star(double x, double y, double size, int corners)
  {
    Points points;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.28 * i / corners, r = size * between(0.2, 1);
      points.emplace_back(rounded(x + r * std::cos(angle)), rounded(y + r * std::sin(angle)));
    }
    return polygon(points);
  }

  Domain with_holes(Domain domain)
  {
    for (int i = int(m_random() % 6); i > 0; --i) {
      const Point p = inside(domain);
      const Polygon hole = star(p.x(), p.y(), between(0.3, 2), 3 + int(m_random() % 4));
      Domain next = domain;
      next.add_hole(hole);
      try {
        const Cells cells(next);
        domain = next;
      } catch (const CGAL::Domain_error_2&) { // it touches something
      }
    }
    return domain;
  }

  std::mt19937 m_random;
  bool m_is_on_grid;
};

// -------------------------------------------------------------------------------------------------
// Comparison.

struct Shape
{
  std::size_t outer = 0, holes = 0;
  std::map<std::size_t, double> contacts{};
};

// Expects closed rings, outer ones first, that add up to the measures of the cell.
Shape checked_shape(const Cells& cells, std::size_t id)
{
  Shape shape;
  double area = 0, perimeter = 0;
  for (std::size_t ring = cells.first_rings()[id]; ring < cells.first_rings()[id + 1]; ++ring) {
    area += cells.ring_areas()[ring];
    ++(cells.ring_areas()[ring] > 0 ? shape.outer : shape.holes);
    EXPECT_GT(shape.outer, 0u);
    const std::size_t first = cells.first_pieces()[ring], beyond = cells.first_pieces()[ring + 1];
    EXPECT_LT(first, beyond);
    for (std::size_t i = first; i < beyond; ++i) {
      const auto &piece = cells.pieces()[i], &next = cells.pieces()[i + 1 < beyond ? i + 1 : first];
      EXPECT_NEAR(piece.to.x, next.from.x, 1e-11);
      EXPECT_NEAR(piece.to.y, next.from.y, 1e-11);
      perimeter += piece.length;
      if (piece.side == Side::NEIGHBOR)
        shape.contacts[piece.other] += piece.length;
    }
  }
  EXPECT_NEAR(area, cells.areas()[id], 1e-12);
  EXPECT_NEAR(perimeter, cells.perimeters()[id], 1e-12);
  return shape;
}

constexpr double length_error = 1e-9; // of lines that are about parallel

void expect_area(const Cells& cells, std::size_t id, const Point& p, const Measured& measured)
{
  const double area = cells.areas()[id];
  ASSERT_NEAR(area, double(measured.area), 1e-12 * double(measured.area));
  ASSERT_NEAR(area * (cells.centroids()[id].x - p.x()), double(measured.moment_x), 1e-11);
  ASSERT_NEAR(area * (cells.centroids()[id].y - p.y()), double(measured.moment_y), 1e-11);
}

void expect_lengths(const Cells& cells, std::size_t id, const Measured& measured)
{
  const Shape shape = checked_shape(cells, id);
  ASSERT_NEAR(cells.wall_lengths()[id], double(measured.wall), length_error);
  for (const auto& [other, length] : measured.contacts) {
    const auto found = shape.contacts.find(other);
    ASSERT_NEAR(found == shape.contacts.end() ? 0 : found->second, double(length), length_error);
  }
  for (const auto& [other, length] : shape.contacts)
    ASSERT_TRUE(length < length_error || measured.contacts.count(other) == 1);
}

void expect_right(const Points& points, const Domain& domain, double radius, bool is_general)
{
  const Plane dt = triangulation(points);
  std::map<Rule, Cells> cells;
  for (const Rule rule : rules) {
    cells.emplace(rule, Cells(domain, rule));
    cells.at(rule).compute(dt, radius);
  }
  for (std::size_t id = 0; id < points.size(); ++id) {
    SCOPED_TRACE(testing::Message() << "id " << id << ", radius " << radius);
    const Boolean_cell boolean(points, id, domain, radius);
    for (const bool is_connected : {false, true}) {
      SCOPED_TRACE(is_connected ? "connected" : "whole");
      const Cells& these = cells.at(is_connected ? Rule::CONNECTED : Rule::WHOLE);
      const Measured measured = boolean.measure(is_connected);
      if (is_connected && (measured.components == 0 || measured.is_pinched))
        continue; // the oracle finds no component of a point on a wall, or too large a one
      ASSERT_NO_FATAL_FAILURE(expect_area(these, id, points[id], measured));
      ASSERT_NEAR(these.perimeters()[id], double(measured.perimeter), length_error);
      if (is_general) {
        ASSERT_NO_FATAL_FAILURE(expect_lengths(these, id, measured));
        const Shape shape = checked_shape(these, id);
        ASSERT_EQ(shape.outer, measured.components);
        ASSERT_EQ(shape.holes, measured.holes);
      }
    }
    if (is_on_wall(domain, points[id]))
      continue; // the sweep would look through the wall
    SCOPED_TRACE("visible");
    const Cells& visible = cells.at(Rule::VISIBLE);
    const Measured measured =
        Visible_cell(points[id], lines_around(points, id, domain), radius).measure();
    ASSERT_NO_FATAL_FAILURE(expect_area(visible, id, points[id], measured));
    ASSERT_NEAR(visible.perimeters()[id], double(measured.perimeter), length_error);
    if (is_general) {
      ASSERT_NO_FATAL_FAILURE(expect_lengths(visible, id, measured));
    }
    ASSERT_EQ(checked_shape(visible, id).outer, 1u);
    ASSERT_EQ(checked_shape(visible, id).holes, 0u);
  }
}

TEST(Cells_in_domains, are_what_boolean_operations_and_sweeps_have)
{
  std::mt19937 random(1);
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random_domain source(seed, false);
    const Domain domain = source.make();
    const Points points = source.inside(domain, 1 + random() % 20);
    for (const double radius : {infinity, 0.3, 1.0, 4.0})
      ASSERT_NO_FATAL_FAILURE(expect_right(points, domain, radius, true));
  }
}

// Corners, bisectors, walls and circles meet in all ways there.
TEST(Cells_in_domains, are_right_where_everything_is_on_a_grid)
{
  std::mt19937 random(2);
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random_domain source(seed, true);
    const Domain domain = source.make();
    const Points points = source.inside(domain, 1 + random() % 20);
    for (const double radius : {infinity, 0.5, 1.25, 5.0})
      ASSERT_NO_FATAL_FAILURE(expect_right(points, domain, radius, false));
  }
}

// A grid that is rotated, so that its degeneracies are so up to rounding.
TEST(Cells_in_domains, have_right_areas_where_rounding_decides_what_meets)
{
  const auto turned = [](const auto& places) {
    Points result;
    for (const Point& p : places)
      result.emplace_back(0.6 * p.x() - 0.8 * p.y(), 0.8 * p.x() + 0.6 * p.y());
    return result;
  };
  std::mt19937 random(3);
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random_domain source(seed, true);
    const Domain on_grid = source.make();
    Domain domain(polygon(turned(on_grid.outer_boundary())));
    for (const Polygon& hole : on_grid.holes())
      domain.add_hole(polygon(turned(hole)));
    Points points = turned(source.inside(on_grid, 1 + random() % 20));
    points.erase(std::remove_if(points.begin(), points.end(),
                                [&](const Point& p) { return !is_inside(domain, p); }),
                 points.end());
    const Plane dt = triangulation(points);
    for (const double radius : {infinity, 0.5, 1.25, 5.0})
      for (const Rule rule : {Rule::WHOLE, Rule::VISIBLE}) {
        Cells cells(domain, rule);
        cells.compute(dt, radius);
        for (std::size_t id = 0; id < points.size(); ++id) {
          SCOPED_TRACE(testing::Message() << "id " << id << ", radius " << radius);
          checked_shape(cells, id);
          if (rule == Rule::WHOLE) {
            const Boolean_cell boolean(points, id, domain, radius);
            ASSERT_NO_FATAL_FAILURE(expect_area(cells, id, points[id], boolean.measure(false)));
          }
        }
      }
  }
}

TEST(Cells_in_domains, add_up_to_the_domain)
{
  for (unsigned seed = 1; seed <= 8; ++seed)
    for (const bool is_on_grid : {false, true}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << (is_on_grid ? ", grid" : ""));
      Random_domain source(seed, is_on_grid);
      const Domain domain = source.make();
      const Plane dt = triangulation(source.inside(domain, is_on_grid ? 50 : 1000));
      Cells whole(domain), connected(domain, Rule::CONNECTED), visible(domain, Rule::VISIBLE);
      whole.compute(dt);
      connected.compute(dt);
      visible.compute(dt);
      ASSERT_NEAR(sum(whole.areas()), area(domain), 1e-13 * area(domain));
      for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
        ASSERT_LE(connected.areas()[id], whole.areas()[id] * (1 + 1e-12));
        ASSERT_LE(visible.areas()[id], connected.areas()[id] * (1 + 1e-12));
      }
    }
}

// Points outside of the domain, whose measures are differences: errors are larger.
void expect_right_outside(const Points& points, const Domain& domain, double radius)
{
  const Plane dt = triangulation(points);
  Cells whole(domain), connected(domain, Rule::CONNECTED), visible(domain, Rule::VISIBLE);
  for (Cells* cells : {&whole, &connected, &visible})
    cells->compute(dt, radius);
  for (std::size_t id = 0; id < points.size(); ++id) {
    SCOPED_TRACE(testing::Message() << "id " << id << ", radius " << radius);
    const Point& p = points[id];
    const Measured measured = Boolean_cell(points, id, domain, radius).measure(false);
    ASSERT_NEAR(whole.areas()[id], double(measured.area), 1e-10);
    ASSERT_NEAR(whole.perimeters()[id], double(measured.perimeter), 1e-8);
    ASSERT_NEAR(whole.wall_lengths()[id], double(measured.wall), 1e-8);
    ASSERT_NEAR(whole.areas()[id] * (whole.centroids()[id].x - p.x()), double(measured.moment_x),
                1e-9);
    checked_shape(whole, id);
    ASSERT_NEAR(whole.cell(dt, id, radius).area, whole.areas()[id], 1e-12);
    ASSERT_EQ(whole.is_in_domain({p.x(), p.y()}), is_inside(domain, p));
    if (is_inside(domain, p))
      continue;
    for (const Cells* cells : {&connected, &visible}) {
      ASSERT_EQ(cells->areas()[id] + cells->perimeters()[id], 0);
      ASSERT_EQ(cells->centroids()[id].x, p.x());
      ASSERT_EQ(cells->first_rings()[id], cells->first_rings()[id + 1]);
      ASSERT_TRUE(cells->cell(dt, id, radius).pieces.empty());
    }
  }
}

TEST(Cells_in_domains, of_points_outside_are_what_the_domain_has_of_them_or_empty_by_the_rule)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const bool is_on_grid = seed % 2 == 0;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random_domain source(seed, is_on_grid);
    const Domain domain = source.make();
    std::set<Point> points;
    while (points.size() < seed)
      points.insert(source.anywhere(-5, 15));
    for (const double radius : {infinity, 1.0, 6.0})
      ASSERT_NO_FATAL_FAILURE(
          expect_right_outside(Points(points.begin(), points.end()), domain, radius));
  }
}

TEST(Cells_in_domains, add_up_to_the_domain_wherever_points_are)
{
  const Domain domain = hall_with_pillars();
  Random_domain source(1, false);
  Points points{Point(2, 2), Point(1e6, -1e6), Point(5, 5)};
  for (int i = 0; i < 2000; ++i)
    points.push_back(source.anywhere(-10, 20));
  Cells cells(domain);
  cells.compute(triangulation(points));
  EXPECT_NEAR(sum(cells.areas()), area(domain), 1e-10);
  cells.compute(triangulation({Point(2, 2)}), 0.25); // in a pillar
  EXPECT_EQ(cells.areas()[0], 0);
  for (const Point& p : {Point(2, 2), Point(11, 5), Point(-1e-300, 5), Point(5, -300)}) {
    cells.compute(triangulation({p}));
    EXPECT_NEAR(cells.areas()[0], area(domain), 1e-10) << p;
    EXPECT_FALSE(cells.is_in_domain({p.x(), p.y()})) << p;
  }
}

TEST(Cells_in_domains, are_those_of_a_convex_domain_where_it_is_convex)
{
  const Polygon hexagon =
      polygon({Point(3, 0), Point(8, 1), Point(10, 5), Point(7, 10), Point(2, 9), Point(0, 4)});
  Random_domain source(3, false);
  const Plane dt = triangulation(source.inside(Domain(hexagon), 300));
  CGAL::Bounded_voronoi_cells_2 convex;
  convex.set_domain(hexagon.vertices_begin(), hexagon.vertices_end());
  for (const Point& p : {Point(5, 5), Point(3, 0), Point(0, 0), Point(1.5, 2), Point(1, 2)})
    EXPECT_EQ(convex.is_in_domain({p.x(), p.y()}),
              Cells(Domain(hexagon)).is_in_domain({p.x(), p.y()}))
        << p;
  for (const double radius : {infinity, 0.4})
    for (const Rule rule : rules) {
      convex.compute(dt, radius);
      Cells cells(Domain(hexagon), rule);
      cells.compute(dt, radius);
      for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
        ASSERT_NEAR(cells.areas()[id], convex.areas()[id], 1e-12 * convex.areas()[id]);
        ASSERT_NEAR(cells.perimeters()[id], convex.perimeters()[id], 1e-12);
        ASSERT_NEAR(cells.wall_lengths()[id], convex.wall_lengths()[id], 1e-12);
        ASSERT_NEAR(cells.free_lengths()[id], convex.free_lengths()[id], 1e-12);
        ASSERT_EQ(checked_shape(cells, id).outer, 1u);
      }
    }
}

TEST(Cells_in_domains, may_have_three_components_of_which_one_has_the_point)
{
  const Plane dt = triangulation({Point(6.5, 9), Point(6.5, 1)});
  Cells cells(comb());
  cells.compute(dt);
  EXPECT_DOUBLE_EQ(cells.areas()[0], 20 + 15 + 15);
  EXPECT_EQ(checked_shape(cells, 0).outer, 3u);
  EXPECT_DOUBLE_EQ(checked_shape(cells, 0).contacts[1], 10);
  cells.set_rule(Rule::CONNECTED);
  cells.compute(dt);
  EXPECT_DOUBLE_EQ(cells.areas()[0], 15);
  EXPECT_DOUBLE_EQ(cells.areas()[1], 12 * 5 - 2 * 3);
  EXPECT_EQ(checked_shape(cells, 0).outer, 1u);
  EXPECT_DOUBLE_EQ(checked_shape(cells, 0).contacts[1], 3);
}

TEST(Cells_in_domains, have_a_ring_around_each_hole)
{
  const Domain domain = hall_with_pillars();
  const Plane dt = triangulation({Point(5, 3.2)});
  for (const Rule rule : {Rule::WHOLE, Rule::CONNECTED}) {
    Cells cells(domain, rule);
    cells.compute(dt);
    EXPECT_DOUBLE_EQ(cells.areas()[0], 91);
    EXPECT_DOUBLE_EQ(cells.wall_lengths()[0], 40 + 36);
    EXPECT_EQ(checked_shape(cells, 0).outer, 1u);
    EXPECT_EQ(checked_shape(cells, 0).holes, 9u);
    EXPECT_NEAR(cells.centroids()[0].x, 5, 1e-14);
    EXPECT_NEAR(cells.centroids()[0].y, 5, 1e-14);
  }
  // two holes in a disc around two pillars, whose outer boundary is one arc
  Cells cells(domain);
  cells.compute(triangulation({Point(5, 3.5)}), 2.4);
  EXPECT_EQ(checked_shape(cells, 0).holes, 2u);
  EXPECT_DOUBLE_EQ(cells.pieces()[0].angle, double(2 * pi));
}

TEST(Cells_in_domains, end_where_a_wall_is_on_a_bisector)
{
  // the bisector has the ends of the walls between the halls on it
  const Plane halls = triangulation({Point(6.5, 3.5), Point(6.5, 0.5)});
  Cells cells(comb());
  cells.compute(halls);
  EXPECT_DOUBLE_EQ(cells.areas()[0], (4 + 3 + 3) * 8);
  EXPECT_DOUBLE_EQ(cells.areas()[1], 12 * 2);
  EXPECT_EQ(checked_shape(cells, 0).outer, 3u);
  cells.set_rule(Rule::CONNECTED);
  cells.compute(halls);
  EXPECT_DOUBLE_EQ(cells.areas()[0], 3 * 8);
  // a wall of a hole is on the bisector, and in one cell only
  Domain domain(box(0, 0, 4, 4));
  domain.add_hole(box(2, 1, 1, 1));
  for (const Rule rule : rules) {
    Cells beside(domain, rule);
    beside.compute(triangulation({Point(1, 1.5), Point(3, 1.5)}));
    EXPECT_DOUBLE_EQ(beside.areas()[0], 8);
    EXPECT_DOUBLE_EQ(beside.perimeters()[0], 12);
    EXPECT_EQ(checked_shape(beside, 0).outer, 1u);
    if (rule != Rule::VISIBLE) { // from a wall one does not see what is behind it
      EXPECT_DOUBLE_EQ(beside.areas()[1], 7);
      EXPECT_DOUBLE_EQ(beside.perimeters()[1], 14);
    } else {
      EXPECT_DOUBLE_EQ(beside.areas()[1], 4);
    }
  }
}

TEST(Visible_cells, have_what_is_seen_from_walls_and_corners)
{
  const Domain bend(
      polygon({Point(0, 0), Point(4, 0), Point(4, 1), Point(1, 1), Point(1, 4), Point(0, 4)}));
  const auto seen_from = [&](double x, double y) {
    return Cells(bend, Rule::VISIBLE).cell(triangulation({Point(x, y)}), 0);
  };
  EXPECT_DOUBLE_EQ(seen_from(1, 1).area, 7); // from the corner everything
  EXPECT_DOUBLE_EQ(seen_from(0, 0).area, 7);
  EXPECT_DOUBLE_EQ(seen_from(1, 3).area, 4);
  EXPECT_DOUBLE_EQ(seen_from(1, 3).wall_length, 9); // with the wall that it is on
  EXPECT_DOUBLE_EQ(seen_from(1, 3).free_length, 1);
  EXPECT_DOUBLE_EQ(seen_from(4, 1).area, 4);
  EXPECT_DOUBLE_EQ(seen_from(4, 0).area, 4 + 1 / 6.0);
  EXPECT_EQ(seen_from(4, 1).ring_areas.size(), 1u);
}

TEST(Visible_cells, end_at_walls_that_are_seen_edge_on)
{
  Domain domain(box(0, 0, 10, 2));
  domain.add_hole(polygon({Point(4, 0.5), Point(6, 0.5), Point(6, 1)}));
  const auto cell = Cells(domain, Rule::VISIBLE).cell(triangulation({Point(1, 0.5)}), 0);
  // above a ray through (6, 1), and below the wall and the line that goes on from it
  EXPECT_DOUBLE_EQ(cell.area, 20 - (0.5 * 5 * 0.5 - 0.5 * 3 * 0) - (0.5 + 0.9) * 4 / 2 + 0.25 * 3);
}

TEST(Cells_in_domains, have_errors_that_say_what_is_wrong_and_change_nothing)
{
  const Domain domain = hall_with_pillars();
  const Plane dt = triangulation({Point(0.5, 1), Point(9, 4)});
  Cells cells(domain);
  cells.compute(dt);
  const Numbers areas = cells.areas();
  EXPECT_THROW(cells.compute(dt, 0), CGAL::Parameter_error_2);
  EXPECT_THROW(cells.compute(dt, Numbers{1}), CGAL::Point_count_error_2);
  EXPECT_THROW(cells.compute(dt, Numbers{1, std::nan("")}), CGAL::Parameter_error_2);
  EXPECT_THROW(cells.cell(dt, 2), CGAL::Unknown_id_error_2);
  EXPECT_EQ(cells.areas(), areas);

  // the error names the corner, and the old domain stays
  const auto with_hole = [](const Polygon& hole) {
    Domain result(box(0, 0, 10, 10));
    result.add_hole(box(1, 1, 4, 4));
    result.add_hole(hole);
    return result;
  };
  const std::vector<std::pair<std::size_t, Domain>> wrong{
      {0, Domain()},
      {0, Domain(polygon({Point(0, 0), Point(1, 0)}))},
      {1, Domain(polygon({Point(0, 0), Point(1, infinity), Point(1, 1)}))},
      {2, Domain(polygon({Point(0, 0), Point(1, 0), Point(2, 0)}))},
      {2, Domain(polygon({Point(0, 0), Point(2, 2), Point(2, 0), Point(0, 2)}))},
      {3, Domain(polygon({Point(0, 0), Point(2, 0), Point(1, 1), Point(0, 0)}))},
      {8, with_hole(box(10.5, 1, 2, 2))},
      {8, with_hole(box(2, 2, 1, 1))},
      {0, with_hole(box(-1, -1, 12, 12))},
      {4, with_hole(box(0.5, 0.5, 6, 6))},
      {5, with_hole(box(5, 2, 1, 1))},
      {8, with_hole(box(4, 4, 2, 2))}};
  for (const auto& [corner, these] : wrong) {
    try {
      cells.set_domain(these);
      ADD_FAILURE() << these;
    } catch (const CGAL::Domain_error_2& error) {
      EXPECT_EQ(error.corner(), corner) << error.what();
    }
  }
  cells.compute(dt);
  EXPECT_EQ(cells.areas(), areas);
}

TEST(Cells_in_domains, can_be_asked_for_one_by_one)
{
  const Domain domain = comb();
  Random_domain source(5, false);
  Points points = source.inside(domain, 30);
  points.push_back(points[3]); // they share a cell
  Plane dt = triangulation(points);
  dt.remove(7);
  for (const Rule rule : rules)
    for (const double radius : {infinity, 2.5}) {
      Cells cells(domain, rule);
      cells.compute(dt, radius);
      for (std::size_t id = 0; id < points.size(); ++id) {
        if (id == 7) {
          EXPECT_THROW(cells.cell(dt, id), CGAL::Unknown_id_error_2);
          EXPECT_EQ(cells.first_rings()[id], cells.first_rings()[id + 1]);
          continue;
        }
        const Cells::Cell cell = cells.cell(dt, id, radius);
        ASSERT_EQ(cell.area, cells.areas()[id]);
        ASSERT_EQ(cell.perimeter, cells.perimeters()[id]);
        ASSERT_EQ(cell.wall_length, cells.wall_lengths()[id]);
        ASSERT_EQ(cell.free_length, cells.free_lengths()[id]);
        ASSERT_EQ(cell.centroid.x, cells.centroids()[id].x);
        ASSERT_EQ(cell.first_pieces.size(), cell.ring_areas.size() + 1);
        ASSERT_EQ(cell.first_pieces.back(), cell.pieces.size());
        if (dt.id(dt.vertex(id)) == id) {
          const std::size_t first = cells.first_rings()[id];
          ASSERT_EQ(cells.first_rings()[id + 1] - first, cell.ring_areas.size());
          for (std::size_t i = 0; i < cell.ring_areas.size(); ++i)
            ASSERT_EQ(cells.ring_areas()[first + i], cell.ring_areas[i]);
        }
      }
    }
}

TEST(Cells_in_domains, scale_with_the_unit_however_large_or_small)
{
  Random_domain source(6, false);
  const Domain domain = source.make();
  const Points points = source.inside(domain, 50);
  const auto scaled = [](const auto& places, double unit) {
    Points result;
    for (const Point& p : places)
      result.emplace_back(unit * p.x(), unit * p.y());
    return result;
  };
  for (const Rule rule : rules) {
    Cells cells(domain, rule);
    cells.compute(triangulation(points), 1.5);
    for (const double unit : {0x1p-200, 0x1p-30, 0x1p40, 0x1p200}) {
      Domain large(polygon(scaled(domain.outer_boundary(), unit)));
      for (const Polygon& hole : domain.holes())
        large.add_hole(polygon(scaled(hole, unit)));
      Cells of_large(large, rule);
      of_large.compute(triangulation(scaled(points, unit)), 1.5 * unit);
      for (std::size_t id = 0; id < points.size(); ++id)
        ASSERT_EQ(of_large.areas()[id], unit * unit * cells.areas()[id]);
    }
  }
}

// -------------------------------------------------------------------------------------------------
// Points far from the domain.

using Bounded = CGAL::Bounded_voronoi_cells_2;
using Measures = CGAL::Voronoi_cell_measures_2;
using CGAL::Bbox_2;

Polygon polygon(const Bbox_2& box)
{
  return polygon({Point(box.xmin(), box.ymin()), Point(box.xmax(), box.ymin()),
                  Point(box.xmax(), box.ymax()), Point(box.xmin(), box.ymax())});
}

// The areas of the cells in a box by each class, with the same radius where there is one.
std::map<std::string, Numbers> areas_in(const Bbox_2& box, const Points& points,
                                        double radius = infinity)
{
  const Plane dt = triangulation(points);
  Bounded bounded;
  bounded.set_domain(box);
  bounded.compute(dt, radius);
  Cells whole(Domain(polygon(box)));
  whole.compute(dt, radius);
  Measures measures;
  measures.compute(dt, box);
  return {{"bounded", bounded.areas()}, {"whole", whole.areas()}, {"clipped", measures.areas()}};
}

void expect_areas(const Bbox_2& box, const Points& points, const Numbers& expected,
                  double radius = infinity)
{
  for (const auto& [name, areas] : areas_in(box, points, radius)) {
    SCOPED_TRACE(name);
    ASSERT_EQ(areas.size(), expected.size());
    for (std::size_t id = 0; id < areas.size(); ++id)
      ASSERT_DOUBLE_EQ(areas[id], expected[id]) << id;
  }
}

// The area of a cell in a box, rounded at the end.
double exact_area(const Points& points, std::size_t id, const Bbox_2& box)
{
  const auto polygon = query_oracle::clipped_cell(points, points[id], box);
  return query_oracle::rounded(CGAL::polygon_area_2(polygon.begin(), polygon.end(), Epeck()));
}

TEST(Points_far_away, share_a_tiny_room)
{
  const Points points{Point(0, 0), Point(1, 0), Point(0, 1)};
  const double x = 1e6, y = 1e6 + 1e-6; // rounded: the room has its own corners
  const double side = y - x;
  expect_areas(Bbox_2(x, x, y, y), points, {0, side * side / 2, side * side / 2});
  expect_areas(Bbox_2(x, x, y, y), points, {0, side * side / 2, side * side / 2}, 1e7);
}

TEST(Points_far_away, have_a_room_for_themselves)
{
  const Bbox_2 room(-3, -1, 3, 1);
  for (const double x : {1e3, 1e17, 1e100, 1e160, 1e308}) {
    SCOPED_TRACE(x);
    expect_areas(room, {Point(x, 0)}, {12});
    expect_areas(room, {Point(-x, x)}, {12});
    expect_areas(room, {Point(x, 1), Point(-x, 1)}, {6, 6});
    expect_areas(room, {Point(0, x), Point(1, x / 2)}, {0, 12});
  }
  const Plane dt = triangulation({Point(1e100, 0)});
  Bounded cells;
  cells.set_domain(room);
  cells.compute(dt, infinity);
  EXPECT_EQ(cells.pieces().size(), 4u);
  EXPECT_DOUBLE_EQ(cells.perimeters()[0], 16);
  EXPECT_DOUBLE_EQ(cells.wall_lengths()[0], 16);
  EXPECT_NEAR(cells.centroids()[0].x, 0, 1e-15);
  EXPECT_NEAR(cells.centroids()[0].y, 0, 1e-15);
  cells.compute(dt, 1e99);
  EXPECT_EQ(cells.areas()[0], 0);
  EXPECT_EQ(cells.centroids()[0].x, 1e100);
}

TEST(Points_far_away, touch_where_both_of_them_reach)
{
  Bounded cells;
  cells.set_domain(Bbox_2(-1, -1, 1, 1));
  const double reach = 3000 + 0x1p-13;
  cells.compute(triangulation({Point(-3000, 0), Point(3000, 0)}), Numbers{1e4, reach});
  const double contact = 2 * std::sqrt((reach - 3000) * (reach + 3000));
  EXPECT_NEAR(cells.areas()[0], 2, 1e-14);
  EXPECT_NEAR(cells.free_lengths()[0], 2 - contact, 1e-11);
  EXPECT_NEAR(cells.wall_lengths()[0], 4, 1e-14);
}

TEST(Points_far_away, have_the_areas_of_exact_polygons)
{
  std::mt19937 random(31);
  const auto power = [&](int least, int most) {
    return std::pow(10, std::uniform_real_distribution<double>(least, most)(random));
  };
  const auto sign = [&] { return random() % 2 == 0 ? 1 : -1; };
  double worst = 0, worst_of_large = 0;
  for (int round = 0; round < 600; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const double unit = round % 3 == 0 ? power(-60, 60) : 1, size = unit * power(-6, 6);
    const double x = unit * sign() * power(-8, 8), y = unit * sign() * power(-8, 8);
    const Bbox_2 box(x, y, x + size, y + size * power(-2, 2));
    const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
    if (!(width > 0 && height > 0))
      continue;
    Points points;
    const double farthest = double(random() % 16);
    for (std::size_t i = 1 + random() % 12; i > 0; --i) {
      const double distance = (width + height) * power(-2, int(farthest));
      points.emplace_back(x + sign() * distance * power(-2, 0), y + sign() * distance);
    }
    const double extent = (width + height) * (width + height), area = width * height;
    const auto areas = areas_in(box, points);
    for (std::size_t id = 0; id < points.size(); ++id) {
      const auto first = std::find(points.begin(), points.end(), points[id]);
      if (first != points.begin() + std::ptrdiff_t(id))
        continue;
      const double sharers = double(std::count(points.begin(), points.end(), points[id]));
      const double expected = exact_area(points, id, box) / sharers;
      for (const auto& [name, found] : areas) {
        const double error = std::abs(found[id] - expected);
        ASSERT_GE(found[id], 0) << name;
        ASSERT_LE(error, 0x1p-46 * extent) << name << ", " << expected << ", id " << id;
        worst = (std::max)(worst, error / extent);
        if (expected > area / 1000)
          worst_of_large = (std::max)(worst_of_large, error / expected);
      }
    }
    for (const auto& [name, found] : areas)
      ASSERT_NEAR(sum(found), area, 0x1p-45 * extent) << name;
  }
  RecordProperty("worst_of_squared_extent", std::to_string(worst * 1e15) + "e-15");
  RecordProperty("worst_relative_of_a_thousandth", std::to_string(worst_of_large * 1e15) + "e-15");
}

TEST(Points_far_away, fill_halls_with_pillars)
{
  std::mt19937 random(32);
  const Domain hall = hall_with_pillars();
  for (const double distance : {10., 1e3, 1e8, 1e20})
    for (int round = 0; round < 20; ++round) {
      SCOPED_TRACE(testing::Message() << distance << ", round " << round);
      std::uniform_real_distribution<double> coordinate(-distance, distance);
      Points points;
      for (int i = 0; i < 4; ++i) {
        const double x = coordinate(random);
        points.emplace_back(x, coordinate(random));
      }
      Cells cells(hall);
      cells.compute(triangulation(points));
      ASSERT_NEAR(sum(cells.areas()), area(hall), 1e-11);
      for (std::size_t id = 0; id < points.size(); ++id) {
        double expected = exact_area(points, id, hall.outer_boundary().bbox());
        for (const Polygon& pillar : hall.holes())
          expected -= exact_area(points, id, pillar.bbox());
        ASSERT_NEAR(cells.areas()[id], expected, 1e-11);
      }
    }
}

TEST(Points_close_together, have_cells_of_their_own)
{
  for (const double distance : {1e-100, 1e-160, 1e-200, 1e-300})
    expect_areas(Bbox_2(-1, -1, 1, 1), {Point(0, 0), Point(distance, 0)}, {2, 2});
}

TEST(Domains_as_large_as_areas_are_numbers, are_the_largest)
{
  Bounded bounded;
  bounded.set_domain(Bbox_2(0, 0, 1e100, 1e100));
  try {
    bounded.set_domain(Bbox_2(0, 0, 1, 1e101));
    FAIL() << "accepted";
  } catch (const CGAL::Domain_error_2& error) {
    EXPECT_EQ(error.corner(), 2u);
  }
  EXPECT_THROW(Cells(Domain(polygon(Bbox_2(0, 0, 1, 1e101)))), CGAL::Domain_error_2);
  const Points points{Point(0, 0), Point(1e160, 0), Point(0, 1e160)};
  const Plane dt = triangulation(points);
  Measures measures;
  EXPECT_THROW(measures.compute(dt, Bbox_2(0, 0, 1e160, 1)), CGAL::Parameter_error_2);
  EXPECT_THROW(measures.compute(dt, Bbox_2(0, 0, 1, 1e154)), CGAL::Parameter_error_2);
  EXPECT_TRUE(measures.areas().empty());
  expect_areas(Bbox_2(0, 0, 1e100, 1e100), points, {1e200, 0, 0});
  bounded.remove_domain();
  EXPECT_THROW(bounded.compute(dt, 1e101), CGAL::Parameter_error_2);
  bounded.compute(triangulation({Point(0, 0), Point(1e100, 0)}), 1e100);
  for (const CGAL::Bounded_voronoi_cells_2::Position& centroid : bounded.centroids())
    EXPECT_TRUE(std::isfinite(centroid.x) && std::isfinite(centroid.y));
}

TEST(Cells_in_domains, need_no_points)
{
  Cells cells(comb());
  cells.compute(triangulation({}));
  EXPECT_TRUE(cells.areas().empty());
  EXPECT_EQ(cells.first_rings(), std::vector<std::size_t>{0});
  cells.compute(triangulation({Point(2, 9)}));
  EXPECT_DOUBLE_EQ(cells.areas()[0], area(comb()));
  const Cells copy = cells;
  EXPECT_DOUBLE_EQ(copy.cell(triangulation({Point(2, 9)}), 0).area, area(comb()));
}

} // namespace
