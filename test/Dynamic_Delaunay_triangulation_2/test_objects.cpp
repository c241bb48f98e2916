// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Objects can be moved, copied and swapped; whatever is left works.

#include "oracle.h"
#include "sealed_checkpoint.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Periodic_cell_2.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace test_objects {

using Point = Epick::Point_2;
using Points = std::vector<Point>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Population = CGAL::Dynamic_population_2<Dynamic>;

constexpr std::size_t number = 500;

// OBJECTS THAT WERE MOVED FROM --------------------------------------------------------------------

template <class Classifier>
void expect_to_work_after_a_move(const Classifier& classifier)
{
  using Moved = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier>;
  Cloud<Epick> cloud(6);
  Points points = cloud.uniform(number), others = cloud.uniform(number - 40);
  Moved dt(points.begin(), points.end(), classifier);
  for (int frame = 0; frame < 20; ++frame) { // until a classifier knows the points
    cloud.shake(points, 1e-5);
    dt.update(points);
  }
  const auto vertex = dt.vertex(3);
  Moved target(std::move(dt));
  EXPECT_EQ(target.vertex(3), vertex);
  ASSERT_NO_FATAL_FAILURE(expect_valid(target, points));
  EXPECT_EQ(dt.number_of_points(), 0u);
  EXPECT_TRUE(dt.is_valid(true));
  EXPECT_THROW(dt.update(points), CGAL::Point_count_error_2);
  std::vector<std::size_t> ids;
  dt.insert(others, std::back_inserter(ids));
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(others, 1e-3);
    dt.update(others);
    cloud.shake(points, 1e-3);
    target.update(points);
  }
  dt.mend();
  target.mend();
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, others));
  ASSERT_NO_FATAL_FAILURE(expect_exact(target, points));
  dt = std::move(target);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  EXPECT_EQ(target.number_of_points(), 0u);
  target = Moved(others.begin(), others.end(), classifier);
  ASSERT_NO_FATAL_FAILURE(expect_exact(target, others));
}

TEST(Objects, that_were_moved_from_are_empty_and_work)
{
  ASSERT_NO_FATAL_FAILURE(expect_to_work_after_a_move(CGAL::Circumcircle_classifier_2()));
  ASSERT_NO_FATAL_FAILURE(expect_to_work_after_a_move(CGAL::Point_distance_classifier_2(0.5)));
}

TEST(Objects, that_are_moved_to_themselves_stay_as_they_are)
{
  Cloud<Epick> cloud(7);
  Points points = cloud.uniform(number);
  Dynamic dt(points);
  Dynamic& same = dt;
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 1e-5);
    dt.update(points);
    dt = std::move(same);
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Objects, that_are_populations_can_be_moved)
{
  Population people;
  std::vector<std::pair<int, Point>> crowd = {{9, {0, 0}}, {4, {1, 0}}, {7, {0, 1}}, {1, {3, 3}}};
  people.update(crowd);
  Population target(std::move(people));
  EXPECT_EQ(target.size(), 4u);
  EXPECT_EQ(people.size(), 0u);
  EXPECT_FALSE(people.has(9));
  crowd.pop_back();
  people.update(crowd);
  target.update(crowd);
  for (const Population* each : {&people, &target}) {
    EXPECT_EQ(each->size(), 3u);
    EXPECT_EQ(each->point(4), Point(1, 0));
    EXPECT_TRUE(each->triangulation().is_valid(true));
  }
}

// COPIES ------------------------------------------------------------------------------------------

// Expects equal results of equal calls of an object and its copy, and no effect on each other.
template <class Classifier>
void expect_copies_to_go_on(const Classifier& classifier)
{
  using Copied = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier>;
  Cloud<Epick> cloud(8);
  Points points = cloud.uniform(number);
  points[5] = points[2]; // a duplicate
  Copied dt(points.begin(), points.end(), classifier);
  dt.remove(7);
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 1e-5);
    points[5] = points[2];
    dt.update(points);
  }
  const std::string state = checkpoint_of(dt);
  Copied copy = dt;
  EXPECT_EQ(checkpoint_of(copy), state);
  EXPECT_TRUE(copy.is_valid(true));
  EXPECT_NE(copy.vertex(3), dt.vertex(3));
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 1e-3);
    const auto report = dt.update(points), report_of_copy = copy.update(points);
    ASSERT_EQ(report.classified, report_of_copy.classified);
    ASSERT_EQ(report.flips, report_of_copy.flips);
    ASSERT_EQ(checkpoint_of(copy), checkpoint_of(dt));
  }
  const std::string before = checkpoint_of(dt);
  copy.insert(Point(0.5, 0.5));
  EXPECT_EQ(checkpoint_of(dt), before);
  dt = copy;
  EXPECT_EQ(checkpoint_of(dt), checkpoint_of(copy));
  EXPECT_TRUE(dt.is_valid(true));
}

TEST(Objects, that_are_copied_go_on_like_the_original)
{
  ASSERT_NO_FATAL_FAILURE(expect_copies_to_go_on(CGAL::Circumcircle_classifier_2()));
  ASSERT_NO_FATAL_FAILURE(expect_copies_to_go_on(CGAL::Safe_region_classifier_2()));
  ASSERT_NO_FATAL_FAILURE(expect_copies_to_go_on(CGAL::Point_distance_classifier_2(0.5)));
}

TEST(Objects, that_do_not_span_the_plane_are_copied)
{
  const Points line = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  for (std::size_t size = 0; size <= line.size(); ++size) {
    const Points points(line.begin(), line.begin() + std::ptrdiff_t(size));
    const Dynamic dt(points);
    Dynamic copy = dt;
    EXPECT_TRUE(copy.is_valid(true));
    EXPECT_EQ(checkpoint_of(copy), checkpoint_of(dt));
    EXPECT_EQ(copy.insert(Point(1, 1)), size);
    Points more = points;
    more.push_back({1, 1});
    ASSERT_NO_FATAL_FAILURE(expect_exact(copy, more));
  }
}

TEST(Objects, that_are_copied_take_along_what_users_keep_in_vertices_and_faces)
{
  using Tds = CGAL::Indexed_triangulation_data_structure_2<Epick, int, int>;
  using Informed = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                                          CGAL::With_data_structure_2<Tds>>;
  Cloud<Epick> cloud(9);
  const Points points = cloud.uniform(number);
  Informed dt(points);
  for (std::size_t id = 0; id < points.size(); ++id)
    dt.vertex(id)->info() = int(id);
  int sum = 0;
  for (const auto f : dt.triangulation().finite_face_handles())
    sum += f->info() = f->vertex(0)->info() + 1;
  const Informed copy = dt;
  for (std::size_t id = 0; id < points.size(); ++id)
    EXPECT_EQ(copy.vertex(id)->info(), int(id));
  for (const auto f : copy.triangulation().finite_face_handles()) {
    EXPECT_EQ(f->info(), f->vertex(0)->info() + 1);
    sum -= f->info();
  }
  EXPECT_EQ(sum, 0);
}

TEST(Objects, that_are_swapped_exchange_everything)
{
  Cloud<Epick> cloud(10);
  const Points points = cloud.uniform(number), few = cloud.uniform(5);
  Dynamic dt(points), other(few);
  const auto vertex = dt.vertex(3);
  swap(dt, other);
  EXPECT_EQ(other.vertex(3), vertex);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, few));
  ASSERT_NO_FATAL_FAILURE(expect_exact(other, points));
}

TEST(Objects, that_are_populations_can_be_copied)
{
  Population people;
  const std::vector<std::pair<int, Point>> crowd = {{9, {0, 0}}, {4, {1, 0}}, {7, {0, 1}}};
  people.update(crowd);
  Population copy = people;
  copy.remove(4);
  EXPECT_EQ(copy.size(), 2u);
  EXPECT_EQ(people.size(), 3u);
  EXPECT_EQ(people.point(4), Point(1, 0));
  EXPECT_TRUE(people.triangulation().is_valid(true));
  EXPECT_TRUE(copy.triangulation().is_valid(true));
}

// WHAT IS ALIKE IN ALL SPACES ---------------------------------------------------------------------

struct Particle
{
  double mass;
  Point position;
};

const auto position_map = boost::make_function_property_map<Particle, const Point&>(
    [](const Particle& particle) -> const Point& { return particle.position; });

using Mover = std::pair<std::size_t, Point>;

// Calls every overload of what changes points.
template <class Triangulation>
void expect_to_take_all_ranges(Triangulation& dt)
{
  Cloud<Epick> cloud(12);
  Points points = cloud.uniform(number);
  std::list<Particle> particles;
  for (const Point& p : points)
    particles.push_back({1, p});
  std::vector<std::size_t> ids;
  dt.insert(particles.begin(), particles.end(), position_map, std::back_inserter(ids));
  for (Particle& particle : particles)
    particle.position = cloud.uniform(1).front();
  dt.update(particles, position_map);
  EXPECT_EQ(dt.point(1), std::next(particles.begin())->position);
  dt.update(particles.begin(), particles.end(), position_map);
  dt.update(points.data(), points.data() + points.size());
  dt.update(std::list<Point>(points.begin(), points.end()));
  for (std::size_t id = 0; id < number; ++id)
    EXPECT_EQ(dt.point(id), points[id]);
  dt.move(std::vector<Mover>{{5, points[6]}, {7, points[8]}});
  const std::list<Mover> movers{{3, points[4]}};
  using Id_map = CGAL::First_of_pair_property_map<Mover>;
  dt.move(movers, Id_map(), CGAL::Second_of_pair_property_map<Mover>());
  dt.move(8, points[8]);
  EXPECT_EQ(dt.representative(3), 4u);
  EXPECT_EQ(dt.number_of_vertices(), number - 3);
  dt.insert(cloud.uniform(2), std::back_inserter(ids));
  const std::list<Particle> one_more{{1, cloud.uniform(1).front()}};
  dt.insert(one_more, position_map, std::back_inserter(ids));
  EXPECT_EQ(ids.back(), number + 2);
  const Point more[] = {cloud.uniform(1).front(), cloud.uniform(1).front()};
  dt.insert(more);
  EXPECT_EQ(dt.point(number + 4), more[1]);
  const Point one[] = {cloud.uniform(1).front()};
  EXPECT_EQ(dt.insert(one, one + 1).inserted, 1u);
  dt.remove(std::array<int, 2>{1, 5});
  EXPECT_FALSE(dt.has_id(5));
  EXPECT_EQ(dt.number_of_points(), number + 4);
  EXPECT_THROW(dt.representative(5), CGAL::Unknown_id_error_2);
  EXPECT_TRUE(dt.is_certified() && dt.is_valid(true, 1));
}

TEST(Objects, of_all_spaces_take_ranges_and_property_maps)
{
  Dynamic dt;
  expect_to_take_all_ranges(dt);
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick> pt(CGAL::Periodic_cell_2(2, 2));
  expect_to_take_all_ranges(pt);
}

TEST(Objects, are_created_from_ranges_with_a_map_settings_or_a_classifier_alone)
{
  using Classifier = CGAL::Point_distance_classifier_2;
  using Distance = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier>;
  const Points points = Cloud<Epick>(15).uniform(20);
  std::list<Particle> particles;
  for (const Point& p : points)
    particles.push_back({1, p});
  Distance::Settings settings = Classifier(0.25);
  settings.engines.whole = CGAL::Static_engine_2::INSERTION;
  const Distance all[] = {Distance(points, settings),
                          Distance(points.begin(), points.end(), Classifier(0.25)),
                          Distance(particles, position_map, Classifier(0.25)),
                          Distance(particles.begin(), particles.end(), position_map,
                                   Distance::Settings{Classifier(0.25)})};
  for (const Distance& dt : all) {
    EXPECT_EQ(dt.classifier().x(), 0.25);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(Objects, of_periodic_space_take_property_maps_with_a_cell)
{
  using Classifier = CGAL::Point_distance_classifier_2;
  using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, Classifier>;
  const CGAL::Periodic_cell_2 cell(2, 2), wide(3, 2);
  std::list<Particle> particles;
  for (const Point& p : Cloud<Epick>(14).uniform(50))
    particles.push_back({1, p});
  Periodic pt(particles.begin(), particles.end(), position_map, cell, Classifier(0.5));
  EXPECT_EQ(pt.number_of_points(), 50u);
  EXPECT_EQ(pt.classifier().x(), 0.5);
  EXPECT_EQ(Periodic(particles, position_map, cell).number_of_points(), 50u);
  particles.front().position = Point(0.5, 0.25);
  pt.update(particles, position_map, wide);
  EXPECT_TRUE(pt.cell() == wide && pt.point(0) == Point(0.5, 0.25) && pt.is_valid(true));
  const Point array[] = {Point(0, 0), Point(1, 1)}; // a range, and the pointers are iterators
  Periodic two(array, array + 2, wide);
  two.update(array, array + 2, cell);
  two.update(array, cell);
  EXPECT_TRUE(two.number_of_points() == 2 && two.cell() == cell && two.is_valid(true));
}

TEST(Objects, of_periodic_space_keep_their_cell_when_they_are_moved_from)
{
  using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
  Cloud<Epick> cloud(13);
  const Points points = cloud.uniform(50);
  Periodic pt(points, CGAL::Periodic_cell_2(3, 2));
  Periodic target(std::move(pt));
  EXPECT_EQ(pt.number_of_points(), 0u);
  EXPECT_TRUE(pt.cell() == CGAL::Periodic_cell_2(3, 2) && pt.is_valid());
  pt.insert(points.front());
  EXPECT_EQ(pt.number_of_edges(), 3u);
  EXPECT_EQ(target.number_of_edges(), 150u);
  pt = target;
  EXPECT_TRUE(pt.number_of_edges() == 150u && pt.is_valid());
  Periodic& itself = pt;
  pt = std::move(itself);
  EXPECT_TRUE(pt.number_of_edges() == 150u && pt.is_valid());
}

} // namespace test_objects
