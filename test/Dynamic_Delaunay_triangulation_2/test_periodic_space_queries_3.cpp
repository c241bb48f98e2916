// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nearest points in tori, slabs and wires in space, against a look at all images.

#include "periodic_space_tested.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace test_periodic_space_queries_3 {

using namespace periodic_space_tested;
using space_points::lattice;

using Queries = CGAL::Delaunay_point_queries_3<Dynamic>;
using Image = Queries::Answer;
using Images = std::vector<Image>;
using Exact = CGAL::Exact_rational;

bool is_before(const Image& a, const Image& b)
{
  return Site_order()(a, b);
}

// Answers by a look at all images.
class Search
{
public:
  explicit Search(const Dynamic& dt)
    : m_dt(dt)
  {
    const auto& [a, b, c] = std::tie(dt.cell().a(), dt.cell().b(), dt.cell().c());
    m_inverse = {cross(b, c), cross(c, a), cross(a, b)};
    const double volume = dot(a, m_inverse[0]);
    for (auto& row : m_inverse)
      for (double& x : row)
        x /= volume;
  }

  std::optional<Image> nearest(const Point& p, const std::optional<Image>& asking = {}) const
  {
    std::optional<Image> nearest;
    Exact least = 0;
    for_each_near(p, reach(p), [&](const Image& image) {
      const Exact square = squared_distance(p, image);
      if (image != asking &&
          (!nearest || square < least || (square == least && is_before(image, *nearest)))) {
        nearest = image;
        least = square;
      }
    });
    return nearest;
  }

  Images within(const Point& p, double square, const std::optional<Image>& asking = {}) const
  {
    Images found;
    for_each_near(p, std::sqrt(square), [&](const Image& image) {
      if (image != asking && squared_distance(p, image) <= Exact(square))
        found.push_back(image);
    });
    std::sort(found.begin(), found.end(), is_before);
    return found;
  }

private:
  std::size_t dimension() const { return std::size_t(m_dt.cell().dimension()); }

  using Row = std::array<double, 3>;

  static double dot(const Row& v, const Row& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }
  static Row cross(const Row& v, const Row& w)
  {
    return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
  }

  Exact squared_distance(const Point& p, const Image& image) const
  {
    const Point q = m_dt.point(image.first);
    Exact sum = 0;
    for (int k = 0; k < 3; ++k) {
      Exact way = Exact(q[k]) - Exact(p[k]);
      for (std::size_t i = 0; i < 3; ++i)
        way += image.second[i] * Exact(m_dt.cell().vector(i)[std::size_t(k)]);
      sum += way * way;
    }
    return sum;
  }

  Row fractions_of_way(const Point& p, std::size_t id) const
  {
    const Point q = m_dt.point(id);
    const Row way{p.x() - q.x(), p.y() - q.y(), p.z() - q.z()};
    return {dot(m_inverse[0], way), dot(m_inverse[1], way), dot(m_inverse[2], way)};
  }

  // Far enough for a nearest image that is not the one asking: some image of any point is as near,
  // and so is the next one along the shortest vector.
  double reach(const Point& p) const
  {
    double least = std::numeric_limits<double>::infinity(), step = least;
    for (std::size_t i = 0; i < dimension(); ++i)
      step = (std::min)(step, std::sqrt(dot(m_dt.cell().vector(i), m_dt.cell().vector(i))));
    for (std::size_t id = 0; id < m_dt.number_of_ids(); ++id)
      if (m_dt.has_id(id)) {
        const Row fractions = fractions_of_way(p, id);
        Image image(id, {0, 0, 0});
        for (std::size_t i = 0; i < dimension(); ++i)
          image.second[i] = int(std::lrint(fractions[i]));
        least = (std::min)(least, std::sqrt(CGAL::to_double(squared_distance(p, image))));
      }
    return least + step;
  }

  // Calls f with a superset of all images that are not farther away than that.
  template <class Function>
  void for_each_near(const Point& p, double reach, const Function& f) const
  {
    reach *= 1 + 1e-9;
    for (std::size_t id = 0; id < m_dt.number_of_ids(); ++id) {
      if (!m_dt.has_id(id))
        continue;
      const Row middle = fractions_of_way(p, id);
      std::array<int, 3> low{0, 0, 0}, high{0, 0, 0};
      for (std::size_t i = 0; i < dimension(); ++i) {
        const double wide = reach * std::sqrt(dot(m_inverse[i], m_inverse[i])) + 1e-6;
        low[i] = int(std::ceil(middle[i] - wide));
        high[i] = int(std::floor(middle[i] + wide));
      }
      for (int i = low[0]; i <= high[0]; ++i)
        for (int j = low[1]; j <= high[1]; ++j)
          for (int k = low[2]; k <= high[2]; ++k)
            if (is_near({i - middle[0], j - middle[1], k - middle[2]}, reach))
              f(Image(id, {i, j, k}));
    }
  }
  bool is_near(const Row& fractions, double reach) const
  {
    double square = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double x = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        x += fractions[i] * m_dt.cell().vector(i)[k];
        size += std::abs(m_dt.cell().vector(i)[k]);
      }
      square += x * x;
    }
    return std::sqrt(square) <= reach + 1e-6 * size;
  }

  const Dynamic& m_dt;
  std::array<Row, 3> m_inverse;
};

Images sorted(Images images)
{
  std::sort(images.begin(), images.end(), is_before);
  return images;
}

void expect_answers(const Dynamic& dt, const Queries& queries, const Points& places,
                    const std::vector<double>& squared_radii)
{
  const Search search(dt);
  std::vector<std::optional<Image>> all;
  queries.nearest(places.begin(), places.end(), std::back_inserter(all));
  ASSERT_EQ(all.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto expected = search.nearest(places[i]);
    ASSERT_EQ(queries.nearest(places[i]), expected);
    ASSERT_EQ(all[i], expected);
  }
  for (const double square : squared_radii) {
    Images answers;
    std::vector<std::size_t> begins;
    queries.within(places.begin(), places.end(), square, answers, begins);
    ASSERT_EQ(begins.size(), places.size() + 1);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Images expected = search.within(places[i], square);
      Images found;
      queries.within(places[i], square, std::back_inserter(found));
      ASSERT_EQ(sorted(found), expected);
      ASSERT_EQ(Images(answers.begin() + std::ptrdiff_t(begins[i]),
                       answers.begin() + std::ptrdiff_t(begins[i + 1])),
                expected);
    }
  }
  int number = 0;
  for (std::size_t id = 0; id < dt.number_of_ids() && number < 12; ++id) {
    if (!dt.has_id(id))
      continue;
    ++number;
    const Image asking(id, {0, 0, 0});
    ASSERT_EQ(queries.nearest_neighbor(id), search.nearest(dt.point(id), asking)) << id;
    for (const double square : squared_radii) {
      Images found;
      queries.neighbors_within(id, square, std::back_inserter(found));
      ASSERT_EQ(sorted(found), search.within(dt.point(id), square, asking)) << id;
    }
  }
}

// In the cell, around it, and far away; where space is open never farther than all images can be
// looked at.
Points places_around(const Cell& cell, unsigned seed, double thickness = 1)
{
  std::mt19937_64 random(seed);
  Points places;
  for (const double extent : {1.0, 1.0, 1.0, 3.0, 3.0, 100.0, 1e5}) {
    std::uniform_real_distribution<double> fraction(-extent, extent);
    const double x = fraction(random), y = fraction(random), z = fraction(random);
    places.push_back(place_in(cell, Point(x, y, z), thickness / (std::max)(1.0, extent / 3)));
  }
  return places;
}

using Queries_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Queries_in_periodic_space, all_kinds(), name_of);

TEST_P(Queries_in_periodic_space, find_the_nearest_images_in_any_cell)
{
  for (const Cell& cell : {unit, triclinic, skew, mirrored, kind.box(1, 0.9, 0.06)})
    for (const std::size_t number : {1u, 2u, 3u, 5u, 30u, 200u})
      for (const double thickness : {0.0, 1.0}) {
        if (dimension == 3 && thickness == 0)
          continue;
        SCOPED_TRACE(std::to_string(number) + " points");
        const unsigned seed = unsigned(number);
        Points points = points_in(cell, number, thickness, seed);
        if (dimension == 1 && number % 2 == 0) // in a plane along a wire, not in a line
          points.back() = points.back() + combination(cell, 0, 1, 0);
        for (std::size_t i = 0; i < number; i += 3) // some are other images of others
          points.push_back(image(points[i], {int(i % 5) - 2, int(i % 2), 0}, cell));
        Dynamic dt(points, cell);
        const Queries queries(dt);
        const double square = cell.volume() < 0.1 || number > 100 ? 0.04 : dimension == 1 ? 9 : 0.5;
        ASSERT_NO_FATAL_FAILURE(
            expect_answers(dt, queries, places_around(cell, seed), {0, square / 20, square}));
        points = shaken(points, 0.3);
        dt.update(points);
        dt.remove(number / 2);
        ASSERT_NO_FATAL_FAILURE(
            expect_answers(dt, queries, places_around(cell, seed + 1), {square}));
      }
}

TEST_P(Queries_in_periodic_space, find_all_of_those_that_are_equally_near)
{
  for (const int side : {1, 2, 3, 4}) {
    const Cell cell = kind.box(side, side, side);
    const Dynamic dt(lattice(side), cell);
    const Queries queries(dt);
    ASSERT_NO_FATAL_FAILURE(expect_answers(dt, queries,
                                           {{0, 0, 0},
                                            {0.5, 0.5, 0.5},
                                            {-0.5, 7.5, 3},
                                            {1, 1.25, 1},
                                            image(Point(0.5, 0, 0.5), {100000, -30000, 0}, cell)},
                                           {0, 0.25, 0.75, 1, 2, 3}));
  }
}

TEST_P(Queries_in_periodic_space, follow_points_and_cells_that_move)
{
  Points points = points_of_cube(80);
  Dynamic dt(points, unit);
  const Queries queries(dt);
  for (int frame = 1; frame <= 20; ++frame) {
    for (Point& p : points)
      p = Point(p.x() + 0.05 * p.y() + 0.3, p.y() + 0.01, p.z() - 0.4);
    double strain = 0.05 * frame;
    strain -= std::round(strain);
    const Cell cell = kind.cell({1, 0, 0}, {strain, 1, 0}, {0, 0.02 * frame, 1});
    dt.update(points, cell);
    ASSERT_NO_FATAL_FAILURE(
        expect_answers(dt, queries, places_around(cell, unsigned(frame)), {0.03}));
  }
}

// Each coordinate of a point or of a query point is nearly that of a plane between images.
TEST_P(Queries_in_periodic_space, are_exact_where_doubles_are_not)
{
  const double little = 0x1p-54;
  const Points points{{0.25, 0.5, 0.5}, {0.75 + 2 * little, 0.5, 0.5}, {0.5, 0.5 - little, 0.125}};
  for (const Cell& cell : {unit, kind.cell({0.1, 1, 0}, {1, 1.0 / 3, 0}, {0.3, 0.7, 1})}) {
    const Dynamic dt(points, cell);
    const Queries queries(dt);
    Points places{{0.5, 0.5, 0.5}, {0, 0.5, 0.5}, {0.5 - little, 0.5, 0.3125}, {1e-300, 0, 0}};
    for (int i = 0; i < 40; ++i)
      places.push_back(
          image(CGAL::ORIGIN + combination(cell, i * 0.25 - 3, (i % 5) * 0.5, (i % 3) * 0.5),
                {0, 10000, 0}, cell));
    ASSERT_NO_FATAL_FAILURE(expect_answers(dt, queries, places, {0, 0.0625, 0.25}));
  }
}

// Half way between two images of the only point, as nearly as doubles say.
TEST_P(Queries_in_periodic_space, are_exact_far_away)
{
  for (const Cell& cell : {triclinic, skew, mirrored}) {
    const Point only(0.1, 0.2, 0.3);
    const Dynamic dt(Points{only}, cell);
    Points places;
    for (int i = 1; i < 40; ++i)
      for (const int far : {1, 1000, 100000})
        places.push_back(image(only + combination(cell, 0.5, 0, 0),
                               {far * i / 40, far * 3, -far * i / 40}, cell));
    ASSERT_NO_FATAL_FAILURE(expect_answers(dt, Queries(dt), places, {0.3}));
  }
}

TEST_P(Queries_in_periodic_space, may_be_of_any_scale)
{
  for (const double scale : {1e-40, 1e40}) {
    const Cell cell = kind.box(scale, 2 * scale, 0.7 * scale);
    const Dynamic dt(points_in(cell, 40, scale), cell);
    ASSERT_NO_FATAL_FAILURE(
        expect_answers(dt, Queries(dt), places_around(cell, 3, scale), {0.1 * scale * scale}));
  }
}

TEST_P(Queries_in_periodic_space, find_nothing_without_points)
{
  const Dynamic dt(unit);
  const Queries queries(dt);
  EXPECT_EQ(queries.nearest(Point(1, 2, 3)), std::nullopt);
  Images found;
  queries.within(Point(1, 2, 3), 5, std::back_inserter(found));
  EXPECT_TRUE(found.empty());
}

TEST_P(Queries_in_periodic_space, refuse_wrong_input)
{
  const Dynamic dt(points_of_cube(20), unit);
  const Queries queries(dt);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points places{{0, 0, 0}, {0, nan, 0}, {0x1p20, 0, 0}};
  Images found{{7, {0, 0, 0}}};
  std::vector<std::size_t> begins{8};
  EXPECT_THROW(queries.nearest(places[1]), CGAL::Non_finite_coordinate_error_3);
  EXPECT_THROW(queries.nearest(places[2]), CGAL::Periodic_range_error_3);
  try {
    queries.within(places.begin(), places.end(), 0.01, found, begins);
    FAIL();
  } catch (const CGAL::Non_finite_coordinate_error_3& error) {
    EXPECT_EQ(error.id(), 1u);
  }
  for (const double square : {-1.0, nan, 256.01 * 256.01}) {
    EXPECT_THROW(queries.within(places[0], square, std::back_inserter(found)),
                 CGAL::Parameter_error_2);
    EXPECT_THROW(queries.neighbors_within(3, square, std::back_inserter(found)),
                 CGAL::Parameter_error_2);
  }
  EXPECT_THROW(queries.nearest_neighbor(20), CGAL::Unknown_id_error_2);
  EXPECT_EQ(found.size(), 1u);
  EXPECT_EQ(begins, std::vector<std::size_t>{8});
}

// Shifts up to the largest radius do not run over.
TEST_P(Queries_in_periodic_space, reach_far)
{
  // The thickness of 1 allows for a radius of 256. A slab of 1 : 300 would take minutes.
  const Cell cell = kind.box(1, dimension == 2 ? 30 : 300, 400);
  for (const Points& points : {Points{{0, 0, 0}, {0.5, 5, 3}}, // of a wire, these have no cells
                               Points{{0, 0, 0}, {0.5, 5, 3}, {0.25, 5, -3}}}) {
    const Dynamic dt(points, cell);
    ASSERT_NO_FATAL_FAILURE(
        expect_answers(dt, Queries(dt), {{0.25, 1, 0}, {1e5, -4, 3}}, {255.0 * 255, 256.0 * 256}));
  }
}

#ifdef CGAL_LINKED_WITH_TBB
using Threads_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Threads_in_periodic_space, all_kinds(), name_of);

TEST_P(Threads_in_periodic_space, find_the_same_images)
{
  const Points points = points_of_cube(3000), places = points_of_cube(5000, 1, 8);
  const Dynamic dt(points, unit);
  using Parallel =
      CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel,
                                                      CGAL::With_concurrency_2<CGAL::Parallel_tag>>;
  const Parallel parallel(points, unit);
  const Queries queries(dt);
  const CGAL::Delaunay_point_queries_3<Parallel> parallel_queries(parallel);
  std::vector<std::optional<Image>> nearest, parallel_nearest;
  queries.nearest(places.begin(), places.end(), std::back_inserter(nearest));
  parallel_queries.nearest(places.begin(), places.end(), std::back_inserter(parallel_nearest));
  EXPECT_EQ(nearest, parallel_nearest);
  Images found, parallel_found;
  std::vector<std::size_t> begins, parallel_begins;
  queries.within(places.begin(), places.end(), 0.01, found, begins);
  parallel_queries.within(places.begin(), places.end(), 0.01, parallel_found, parallel_begins);
  EXPECT_EQ(found, parallel_found);
  EXPECT_EQ(begins, parallel_begins);
}
#endif // CGAL_LINKED_WITH_TBB

} // namespace test_periodic_space_queries_3
