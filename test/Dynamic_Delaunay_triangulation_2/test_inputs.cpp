// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points may come from any C++ range, even if its iterators store or create their values; wrong
// uses are refused.

#include "../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Arithmetic.h"
#include "oracle.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/accepts_inexact_predicates_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/iterator.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/property_map.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/iterator_adaptor.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/iterator/zip_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/irange.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <list>
#include <locale>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using Point = Epick::Point_2;
using Points = std::vector<Point>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Population = CGAL::Dynamic_population_2<Dynamic>;

constexpr std::size_t number = 500; // enough to overwrite what a dangling reference points to

// RANGES ------------------------------------------------------------------------------------------

// An iterator that stores its value, as iterators that read files do: the value is destroyed with
// the iterator.
class Stashing_iterator : public boost::iterator_adaptor<Stashing_iterator, Points::const_iterator>
{
public:
  explicit Stashing_iterator(Points::const_iterator place)
    : iterator_adaptor(place)
  {
  }
  ~Stashing_iterator() { m_value = Point(-1, -1); }
  Stashing_iterator(const Stashing_iterator&) = default;
  Stashing_iterator& operator=(const Stashing_iterator&) = default;

private:
  friend class boost::iterator_core_access;

  const Point& dereference() const { return m_value = *base(); }

  mutable Point m_value;
};

// Each value can be read once only.
class Single_pass_iterator : public boost::iterator_facade<Single_pass_iterator, Point,
                                                           boost::single_pass_traversal_tag, Point>
{
public:
  Single_pass_iterator(std::deque<Point>* queue, std::size_t left)
    : m_queue(queue)
    , m_left(left)
  {
  }

private:
  friend class boost::iterator_core_access;

  Point dereference() const
  {
    const Point p = m_queue->front();
    m_queue->pop_front();
    return p;
  }
  void increment() { --m_left; }
  bool equal(const Single_pass_iterator& other) const { return m_left == other.m_left; }

  std::deque<Point>* m_queue;
  std::size_t m_left;
};

struct Particle
{
  std::array<double, 7> other = {};
  Point where;
};

struct Where
{
  using result_type = const Point&;
  const Point& operator()(const Particle& particle) const { return particle.where; }
};

struct Pair_of
{
  std::pair<Point, int> operator()(const Point& p) const { return {p, 3}; }
};

// Calls f(first, beyond, point_map) for the points in every kind of range.
template <class Function>
void for_each_kind_of_range(const Points& points, const Function& f)
{
  const boost::typed_identity_property_map<Point> identity;
  const auto call = [&](const char* kind, auto first, auto beyond, auto map) {
    SCOPED_TRACE(kind);
    f(first, beyond, map);
  };
  call("pointers", points.data(), points.data() + points.size(), identity);
  call("vector", points.begin(), points.end(), identity);
  const std::list<Point> list(points.begin(), points.end());
  call("list", list.begin(), list.end(), identity);
  const std::deque<Point> deque(points.begin(), points.end());
  call("deque", deque.begin(), deque.end(), identity);
  call("iterators that keep their values", Stashing_iterator(points.begin()),
       Stashing_iterator(points.end()), identity);
  std::deque<Point> queue = deque;
  call("a single pass", Single_pass_iterator(&queue, points.size()),
       Single_pass_iterator(&queue, 0), identity);

  std::vector<Particle> particles(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    particles[i].where = points[i];
  call("references that a function gives",
       boost::make_transform_iterator(particles.begin(), Where()),
       boost::make_transform_iterator(particles.end(), Where()), identity);
  call("a property map of structures", particles.begin(), particles.end(),
       boost::make_function_property_map<Particle, const Point&>(Where()));

  // the property map returns a reference into a temporary pair of the iterator
  const Pair_of pair_of;
  call("references into values that are made",
       boost::make_transform_iterator(points.begin(), pair_of),
       boost::make_transform_iterator(points.end(), pair_of),
       CGAL::First_of_pair_property_map<std::pair<Point, int>>());

  std::vector<double> x, y;
  for (const Point& p : points) {
    x.push_back(p.x());
    y.push_back(p.y());
  }
  const auto position = boost::make_function_property_map<std::size_t>(
      [&](std::size_t i) { return Point(x[i], y[i]); });
  const boost::counting_iterator<std::size_t> zero(0), end(points.size());
  call("two arrays by numbers", zero, end, position);
  const auto range = boost::irange<std::size_t>(0, points.size());
  call("two arrays by a range of numbers", range.begin(), range.end(), position);
  call("points by numbers", zero, end,
       boost::make_iterator_property_map(points.begin(),
                                         boost::typed_identity_property_map<std::size_t>()));
  const auto zipped = [](const auto& a, const auto& b) {
    return boost::make_zip_iterator(boost::make_tuple(a, b));
  };
  using Tuple = boost::tuple<const double&, const double&>;
  call("two arrays side by side", zipped(x.cbegin(), y.cbegin()), zipped(x.cend(), y.cend()),
       boost::make_function_property_map<Tuple>(
           [](const Tuple& t) { return Point(t.get<0>(), t.get<1>()); }));
  const auto made = [&](std::size_t i) { return Point(x[i], y[i]); };
  call("points that are made", boost::make_transform_iterator(zero, made),
       boost::make_transform_iterator(end, made), identity);
}

TEST(Ranges, of_any_kind_are_read_by_the_constructor)
{
  const Points points = Cloud<Epick>(1).uniform(number);
  for_each_kind_of_range(points, [&](auto first, auto beyond, auto map) {
    const Dynamic dt(first, beyond, map);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  });
}

void expect_to_be_read_by_an_update(const Points& before)
{
  Points points = before;
  Cloud<Epick>(2).shake(points, 0.1);
  for_each_kind_of_range(points, [&](auto first, auto beyond, auto map) {
    Dynamic dt(before);
    dt.update(first, beyond, map);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  });
}

TEST(Ranges, of_any_kind_are_read_by_an_update)
{
  expect_to_be_read_by_an_update(Cloud<Epick>(1).uniform(number));
}

TEST(Ranges, of_any_kind_are_read_by_an_update_with_points_that_coincide)
{
  Points points = Cloud<Epick>(1).uniform(number);
  points[7] = points[300];
  expect_to_be_read_by_an_update(points);
}

TEST(Ranges, of_any_kind_are_read_by_an_insertion)
{
  Cloud<Epick> cloud(3);
  const Points before = cloud.uniform(number), points = cloud.uniform(100);
  Points all = before;
  all.insert(all.end(), points.begin(), points.end());
  for_each_kind_of_range(points, [&](auto first, auto beyond, auto map) {
    Dynamic dt(before);
    std::vector<std::size_t> ids;
    dt.insert(first, beyond, map, std::back_inserter(ids));
    ASSERT_EQ(ids.size(), points.size());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, all));
  });
}

TEST(Ranges, of_ids_in_braces_are_read_by_a_removal)
{
  const Points points = Cloud<Epick>(4).uniform(10);
  Dynamic dt(points);
  EXPECT_EQ(dt.remove({3, 7}).removed, 2u);
  EXPECT_FALSE(dt.has_id(3) || dt.has_id(7));
  EXPECT_EQ(dt.number_of_points(), 8u);
  EXPECT_TRUE(dt.is_certified() && dt.is_valid(true));
}

TEST(Ranges, of_any_kind_are_read_in_periodic_space_also_with_another_cell)
{
  using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
  Cloud<Epick> cloud(7);
  const Points points = cloud.uniform(number);
  Points others = points;
  cloud.shake(others, 0.1);
  const CGAL::Periodic_cell_2 cell(23, 23), wider(24, 1, 0, 23);
  const auto expect_there = [](const Periodic& pt, const Points& places) {
    ASSERT_TRUE(pt.is_certified() && pt.is_valid(true));
    for (std::size_t id = 0; id < number; ++id)
      ASSERT_EQ(pt.point(id), places[id]);
  };
  for_each_kind_of_range(points, [&](auto first, auto beyond, auto map) {
    ASSERT_NO_FATAL_FAILURE(expect_there(Periodic(first, beyond, map, cell), points));
  });
  for_each_kind_of_range(others, [&](auto first, auto beyond, auto map) {
    Periodic pt(points, cell);
    pt.update(first, beyond, map, wider);
    EXPECT_TRUE(pt.cell() == wider);
    ASSERT_NO_FATAL_FAILURE(expect_there(pt, others));
  });
}

TEST(Ranges, of_pairs_that_are_made_are_read_by_moves_and_populations)
{
  Cloud<Epick> cloud(4);
  const Points before = cloud.uniform(number);
  Points points = before;
  cloud.shake(points, 0.1);
  const auto pair_of = [&](std::size_t i) { return std::pair<std::size_t, Point>(i, points[i]); };
  const auto first =
      boost::make_transform_iterator(boost::counting_iterator<std::size_t>(0), pair_of);
  const auto beyond =
      boost::make_transform_iterator(boost::counting_iterator<std::size_t>(number), pair_of);
  Dynamic dt(before);
  dt.move(first, beyond);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));

  Population people;
  people.update(first, beyond);
  for (std::size_t i = 0; i < number; ++i)
    ASSERT_EQ(people.point(std::int64_t(i)), points[i]);
  people.move(first, beyond);
  ASSERT_NO_FATAL_FAILURE(expect_exact(people.triangulation(), points));
}

TEST(Ranges, of_users_ids_are_read_by_updates_insertions_moves_and_removals)
{
  Cloud<Epick> cloud(6);
  Points points = cloud.uniform(number);
  const auto id_map = boost::make_function_property_map<std::size_t>(
      [](std::size_t i) { return std::int64_t(i) + 1000; });
  const auto point_map =
      boost::make_function_property_map<std::size_t>([&](std::size_t i) { return points[i]; });
  const boost::counting_iterator<std::size_t> first(0), beyond(number);
  Population people;
  EXPECT_TRUE(people.insert(first, beyond, id_map, point_map).certified);
  ASSERT_NO_FATAL_FAILURE(expect_exact(people.triangulation(), points));
  cloud.shake(points, 0.1);
  people.move(first, beyond, id_map, point_map);
  ASSERT_NO_FATAL_FAILURE(expect_exact(people.triangulation(), points));
  cloud.shake(points, 0.1);
  people.remove(std::array<int, 2>{1003, 1004});
  people.insert(-1, Point(2, 2));
  people.update(first, beyond, id_map, point_map);
  EXPECT_TRUE(people.has(1003) && people.has(1004) && !people.has(-1));
  ASSERT_NO_FATAL_FAILURE(expect_exact(people.triangulation(), points));

  people.insert(std::list<std::pair<int, Point>>{{3, {0.5, 0.25}}});
  const std::array<std::size_t, 1> four{4};
  const auto itself =
      boost::make_function_property_map<std::size_t>([](std::size_t i) { return i; });
  const auto somewhere =
      boost::make_function_property_map<std::size_t>([](std::size_t) { return Point(2, 2); });
  people.insert(four, itself, somewhere);
  EXPECT_EQ(people.point(4), Point(2, 2));
  people.move(four, itself, somewhere);
  people.move(std::vector<std::pair<int, Point>>{{4, {0.125, 3}}});
  people.insert(5, Point(1, 1));
  people.move(5, Point(0.125, 3));
  EXPECT_EQ(people.vertex(5), people.vertex(4));
  people.remove(std::array<int, 3>{4, 1000, 3});
  EXPECT_EQ(people.point(5), Point(0.125, 3));
  EXPECT_EQ(people.size(), number);
  points[0] = Point(0.125, 3);
  for (std::size_t i = 0; i < number; ++i)
    ASSERT_EQ(people.point(i == 0 ? 5 : 1000 + std::int64_t(i)), points[i]);
  EXPECT_TRUE(people.triangulation().is_certified() && people.triangulation().is_valid(true));
  const std::vector<std::pair<std::int64_t, Point>> frame{{1002, {0, 0}}, {5, {1, 0}}, {3, {0, 1}}};
  people.update(four, itself, somewhere);
  EXPECT_TRUE(people.size() == 1 && people.has(4));
  people.update(frame);
  for (const auto& [user_id, p] : frame)
    ASSERT_EQ(people.point(user_id), p);
  EXPECT_EQ(people.size(), 3u);
}

// LIMITS ------------------------------------------------------------------------------------------

template <class Value>
struct Unreadable
{
  const Value& operator()(std::ptrdiff_t) const { throw std::logic_error("a point was read"); }
};

// An iterator of a range that may be longer than any memory, and must not be read.
template <class Value>
auto unreadable(std::size_t i)
{
  return boost::make_transform_iterator(boost::make_counting_iterator(std::ptrdiff_t(i)),
                                        Unreadable<Value>());
}

constexpr std::size_t most_points = 536'870'911; // half-edges have numbers of 32 bits

template <class Call>
void expect_too_many(std::size_t points, const Call& call)
{
  try {
    call();
    ADD_FAILURE() << "too many points were taken";
  } catch (const CGAL::Point_limit_error_2& error) {
    EXPECT_EQ(error.number(), points);
    EXPECT_EQ(error.limit(), most_points);
    EXPECT_NE(std::string(error.what()).find(std::to_string(points)), std::string::npos);
  }
}

TEST(Too_many_points, are_refused_before_any_is_read)
{
  const auto first = unreadable<Point>(0);
  const std::size_t one_more = most_points + 1, far_more = std::size_t(1) << 40;
  expect_too_many(one_more, [&] { Dynamic(first, unreadable<Point>(one_more)); });
  expect_too_many(far_more, [&] { Dynamic(first, unreadable<Point>(far_more)); });
  const CGAL::Periodic_cell_2 cell(1, 1);
  using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
  expect_too_many(one_more, [&] { Periodic(first, unreadable<Point>(one_more), cell); });
}

TEST(Too_many_points, are_refused_beside_those_that_are_there)
{
  const Points points = Cloud<Epick>(9).uniform(20);
  Dynamic dt(points.begin(), points.end());
  expect_too_many(most_points + 1, [&] {
    dt.insert(unreadable<Point>(0), unreadable<Point>(most_points - 19), CGAL::Emptyset_iterator());
  });
  expect_exact(dt, points);

  using Named_point = std::pair<int, Point>;
  Population population;
  population.update(std::vector<Named_point>{{9, {0, 0}}, {4, {1, 0}}, {7, {0, 1}}});
  expect_too_many(most_points + 1, [&] {
    population.update(unreadable<Named_point>(0), unreadable<Named_point>(most_points + 1));
  });
  expect_too_many(most_points + 1, [&] {
    population.insert(unreadable<Named_point>(0), unreadable<Named_point>(most_points - 2));
  });
  EXPECT_EQ(population.triangulation().number_of_points(), 3u);
  EXPECT_EQ(population.point(4), Point(1, 0));
}

// WRONG USES --------------------------------------------------------------------------------------

// Classifies an edge or a vertex that does not exist.
struct Wrong_classifier
{
  static constexpr bool is_exact = false;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classification) const
  {
    if (names_an_edge)
      classification.add_edge(typename Frame::Edge_index(frame.number_of_edges() + excess));
    else
      classification.add_vertex(
          typename Frame::Vertex_index(frame.number_of_vertices() + 1 + excess));
  }

  bool names_an_edge = false;
  unsigned excess = 0;
};

TEST(Wrong_uses, of_indices_by_classifiers_are_refused_and_change_nothing)
{
  Cloud<Epick> cloud(8);
  const Points points = cloud.uniform(50);
  Points next = points;
  cloud.shake(next, 0.1);
  for (const bool names_an_edge : {false, true})
    for (const unsigned excess : {0u, 1u, 1000000u, 0xfff00000u}) {
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, Wrong_classifier> dt(
          points.begin(), points.end(), Wrong_classifier{names_an_edge, excess});
      try {
        dt.update(next);
        ADD_FAILURE() << "not refused";
      } catch (const CGAL::Unknown_index_error_2& error) {
        EXPECT_GE(error.index(), error.bound());
        EXPECT_NE(std::string(error.what()).find(names_an_edge ? "no edge" : "no vertex"),
                  std::string::npos);
      }
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
}

// Until it is rebuilt, the triangulation cannot know whether such a handle has changed it.
TEST(Wrong_uses, of_handles_that_change_a_vertex_or_a_face_are_seen)
{
  const Points points = Cloud<Epick>(9).uniform(50);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                         CGAL::With_repair_2<CGAL::Rebuild_repair_2>>
      dt(points.begin(), points.end());
  dt.vertex(5)->set_point(Point(points[5].x() + 1e-9, points[5].y()));
  EXPECT_FALSE(dt.is_valid());
  dt.vertex(5)->set_point(points[5]);
  EXPECT_FALSE(dt.is_valid());
  Points elsewhere = Cloud<Epick>(10).uniform(50);
  dt.update(elsewhere.begin(), elsewhere.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, elsewhere));
  dt.infinite_vertex()->face()->set_neighbor(0, dt.vertex(5)->face());
  EXPECT_FALSE(dt.is_valid());

  const CGAL::Dynamic_Delaunay_triangulation_2<Epeck> exact(Cloud<Epeck>(9).uniform(50));
  exact.vertex(5)->set_point(Epeck::Point_2(Epeck::FT(1) / 3, 5));
  EXPECT_FALSE(exact.is_valid());
}

} // namespace

template <>
constexpr bool CGAL::accepts_inexact_predicates_2<CGAL::Simple_cartesian<double>> = true;

namespace {

using CGAL::Dynamic_Delaunay_triangulations_2::internal::Are_known_to_be_inexact_2;

// Thousands with commas, and a comma before the fraction.
struct German_commas : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Messages, have_the_same_numbers_in_every_locale)
{
  const std::locale before = std::locale::global(std::locale(std::locale(), new German_commas));
  const std::string count = CGAL::Point_count_error_2(10080, 1009).what();
  const std::string coordinates =
      CGAL::Non_finite_coordinate_error_2(1234, 0.1, std::numeric_limits<double>::infinity())
          .what();
  std::locale::global(before);
  EXPECT_EQ(count.find("given are 1009 entries, and 10080 are due"), 0u) << count;
  EXPECT_EQ(coordinates, "point 1234 has the coordinates (0.1, inf): both must be finite numbers");
}

TEST(Kernels, whose_predicates_are_rounded_are_known)
{
  EXPECT_TRUE(Are_known_to_be_inexact_2<CGAL::Simple_cartesian<double>>::value);
  EXPECT_TRUE(Are_known_to_be_inexact_2<CGAL::Simple_cartesian<float>>::value);
  EXPECT_TRUE(Are_known_to_be_inexact_2<CGAL::Cartesian<double>>::value);
  EXPECT_TRUE(Are_known_to_be_inexact_2<
              CGAL::Projection_traits_xy_3<CGAL::Simple_cartesian<double>>>::value);
  EXPECT_FALSE(Are_known_to_be_inexact_2<Epick>::value);
  EXPECT_FALSE(Are_known_to_be_inexact_2<Epeck>::value);
  EXPECT_FALSE(Are_known_to_be_inexact_2<CGAL::Projection_traits_xy_3<Epick>>::value);
  EXPECT_FALSE(Are_known_to_be_inexact_2<CGAL::Simple_cartesian<Epeck::FT>>::value);
}

TEST(Kernels, whose_predicates_are_rounded_never_certify)
{
  using Rounded = CGAL::Simple_cartesian<double>;
  std::vector<Rounded::Point_2> points = Cloud<Rounded>(10).uniform(100);
  CGAL::Dynamic_Delaunay_triangulation_2<Rounded> dt(points);
  EXPECT_FALSE(dt.is_certified());
  EXPECT_FALSE(dt.update(points).certified);
  EXPECT_FALSE(dt.mend().certified);
  EXPECT_FALSE(dt.certify());
  EXPECT_THROW(dt.triangulation(), CGAL::Uncertified_triangulation_error_2);
  EXPECT_TRUE(dt.is_valid(true));
  EXPECT_EQ(dt.number_of_vertices(), 100u);
}

TEST(Default, stands_for_every_parameter)
{
  using All_default = CGAL::Dynamic_Delaunay_triangulation_2<
      Epick, CGAL::Default, CGAL::With_concurrency_2<CGAL::Default>,
      CGAL::With_visitor_2<CGAL::Default>, CGAL::With_policy_2<CGAL::Default>,
      CGAL::With_data_structure_2<CGAL::Default>, CGAL::With_repair_2<CGAL::Default>>;
  using Usual = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  static_assert(std::is_same_v<All_default::Delaunay_repair, Usual::Delaunay_repair>);
  static_assert(std::is_same_v<All_default::Delaunay_update_policy, Usual::Delaunay_update_policy>);
  static_assert(std::is_same_v<All_default::Concurrency_tag, Usual::Concurrency_tag>);
  static_assert(std::is_same_v<All_default::Triangulation_data_structure,
                               Usual::Triangulation_data_structure>);
  static_assert(std::is_same_v<All_default::Delaunay_classifier, CGAL::Circumcircle_classifier_2>);
  static_assert(
      std::is_same_v<All_default::Delaunay_update_visitor, CGAL::Delaunay_update_visitor_base_2>);
  Cloud<Epick> cloud(11);
  Points points = cloud.uniform(60);
  All_default dt(points);
  cloud.shake(points, 0.1);
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Options, may_come_in_any_order)
{
  using CGAL::With_policy_2, CGAL::With_repair_2, CGAL::With_visitor_2;
  using Policy = CGAL::Always_static_policy_2;
  using Repair = CGAL::Rebuild_repair_2;
  using Visitor = CGAL::Edge_changes_visitor_2;
  using One =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, With_repair_2<Repair>,
                                             With_policy_2<Policy>, With_visitor_2<Visitor>>;
  using Other =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, With_visitor_2<Visitor>,
                                             With_repair_2<Repair>, With_policy_2<Policy>>;
  static_assert(std::is_same_v<One::Delaunay_repair, Repair>);
  static_assert(std::is_same_v<One::Delaunay_update_policy, Policy>);
  static_assert(std::is_same_v<One::Delaunay_update_visitor, Visitor>);
  static_assert(std::is_same_v<One::Settings, Other::Settings>);
  static_assert(std::is_same_v<One::Frame, Other::Frame>);
}

// FLOATING POINT ----------------------------------------------------------------------------------

// Tests run in the caller's floating-point mode, which must be kept; the oracle in CGAL's mode.
class Floating_point : public testing::TestWithParam<random_operations::Arithmetic>
{
protected:
  void SetUp() override { m_in_use.emplace(GetParam()); }
  void TearDown() override { m_in_use.reset(); }

  void expect_that_it_was_given_back() const { EXPECT_TRUE(m_in_use->is_kept()); }

  template <class Call>
  void check(const Call& call)
  {
    expect_that_it_was_given_back();
    m_in_use.reset();
    call();
    m_in_use.emplace(GetParam());
  }

private:
  std::optional<random_operations::Arithmetic_in_use> m_in_use;
};

INSTANTIATE_TEST_SUITE_P(All, Floating_point,
                         testing::ValuesIn(random_operations::all_arithmetic()));

TEST_P(Floating_point, of_the_caller_changes_nothing)
{
  for (const int exponent : {0, -1022, -1040, -1060, 900, -1007}) {
    SCOPED_TRACE(testing::Message() << "unit 2^" << exponent);
    Points points;
    std::vector<Points> frames;
    check([&] {
      const double unit = std::ldexp(1, exponent);
      Cloud<Epick> cloud(12);
      for (const Point& p : cloud.uniform(120))
        points.push_back(Point(p.x() * unit, p.y() * unit));
      frames.assign(12, points);
      for (std::size_t frame = 0; frame < frames.size(); ++frame)
        for (std::size_t i = 0; i < points.size(); ++i)
          frames[frame][i] = points[i] =
              cloud.shifted(points[i], (frame % 4 == 3 ? 1 : 0.05) * unit);
      frames[5][3] = frames[5][4];
    });
    std::unique_ptr<Dynamic> dt = std::make_unique<Dynamic>(frames.front());
    for (const Points& frame : frames) {
      dt->update(frame);
      check([&] { expect_exact(*dt, frame); });
      ASSERT_FALSE(HasFatalFailure());
    }
    dt->move(7, Point(0, 0));
    dt->remove(8);
    dt->insert(points[8]);
    points[7] = Point(0, 0);
    EXPECT_TRUE(dt->certify());
    EXPECT_TRUE(dt->is_valid(true));
    check([&] { expect_exact(*dt, points); });
    CGAL::Delaunay_point_queries_2<Dynamic> queries(*dt);
    EXPECT_EQ(queries.nearest(points[20]), 20u);
    std::stringstream file;
    dt->write_checkpoint(file);
    Dynamic other;
    other.read_checkpoint(file);
    check([&] { expect_exact(other, points); });
    std::vector<std::pair<std::size_t, Point>> crowd;
    for (std::size_t i = 0; i < points.size(); i += 2)
      crowd.emplace_back(i, points[i]);
    Population people;
    EXPECT_TRUE(people.update(crowd).certified);
    EXPECT_TRUE(people.triangulation().is_valid(true));
    expect_that_it_was_given_back();
  }
}

// Nine points with an extent for which a rounded scale is the largest double, not infinity: the
// search for a finer grid must end.
TEST_P(Floating_point, lets_points_at_the_smallest_extents_be_sorted)
{
  Points points;
  for (int i = 0; i < 9; ++i)
    points.push_back(Point(i * 4e-305, (i * i % 7) * 4e-306));
  const Dynamic dt(points);
  check([&] { expect_exact(dt, points); });
}

#ifdef CGAL_LINKED_WITH_TBB
// So many points that both threads get some. A thread starts with the mode of the thread that has
// created it, or with the default mode.
TEST_P(Floating_point, of_the_caller_changes_nothing_on_two_threads)
{
  std::vector<Points> frames;
  check([&] {
    Cloud<Epick> cloud(13);
    Points points = cloud.uniform(20000);
    for (Point& p : points)
      p = Point(std::ldexp(p.x(), -1040), std::ldexp(p.y(), -1040));
    for (int frame = 0; frame < 4; ++frame) {
      frames.push_back(points);
      for (Point& p : points)
        p = cloud.shifted(p, std::ldexp(0.003, -1040));
    }
  });
  using Parallel =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                             CGAL::With_concurrency_2<CGAL::Parallel_tag>>;
  tbb::task_arena two_threads(2);
  Parallel dt;
  two_threads.execute([&] { dt.insert(frames.front(), CGAL::Emptyset_iterator()); });
  for (const Points& frame : frames) {
    two_threads.execute([&] { dt.update(frame); });
    check([&] { expect_exact(dt, frame); });
    ASSERT_FALSE(HasFatalFailure());
  }
}
#endif

} // namespace
