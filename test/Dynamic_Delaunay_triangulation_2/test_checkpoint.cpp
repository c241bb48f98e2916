// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A triangulation that was written and read goes on as the original does; a file that is no
// checkpoint is refused and changes nothing.

#include "checkpoint_files.h"
#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Hybrid_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/IO/io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <utility>

namespace test_checkpoint {

using CGAL::Checkpoint_error_2;
using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Population = CGAL::Dynamic_population_2<Exact>;
using Points = Cloud<Epick>::Points;

template <class Dynamic>
Dynamic restored(const Dynamic& original)
{
  Dynamic copy;
  read(copy, checkpoint_of(original));
  return copy;
}

template <class Dynamic>
std::vector<std::pair<std::size_t, std::size_t>> edges_of(const Dynamic& dt)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j) { edges.emplace_back(i, j); });
  return edges;
}

template <class Dynamic>
void expect_equal(const Dynamic& dt, const Dynamic& other)
{
  ASSERT_TRUE(other.is_valid(true));
  ASSERT_EQ(dt.is_certified(), other.is_certified());
  ASSERT_EQ(dt.number_of_ids(), other.number_of_ids());
  ASSERT_EQ(dt.tds().dimension(), other.tds().dimension());
  ASSERT_EQ(edges_of(dt), edges_of(other));
  const auto frame = dt.frame(), other_frame = other.frame();
  ASSERT_EQ(frame.number_of_faces(), other_frame.number_of_faces());
  for (typename Dynamic::Frame::Face_index f(0); f < frame.number_of_faces(); ++f)
    ASSERT_EQ(frame.face(f), other_frame.face(f));
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    ASSERT_EQ(dt.has_id(id), other.has_id(id));
    if (dt.has_id(id)) {
      ASSERT_EQ(dt.point(id), other.point(id));
      ASSERT_EQ(dt.vertex(id).index(), other.vertex(id).index());
      ASSERT_EQ(dt.id(dt.vertex(id)), other.id(other.vertex(id)));
    }
  }
}

// Random calls, equal for both: whole frames, points that come, go, move, or meet.
template <class Dynamic>
class Common_future
{
  using Kernel = typename Dynamic::Geom_traits;
  using Point = typename Dynamic::Point;

public:
  Common_future(unsigned seed, double step)
    : m_cloud(seed)
    , m_step(step)
  {
  }

  template <class Call>
  void both(Dynamic& dt, Dynamic& other, const Call& call)
  {
    const CGAL::Update_report_2 report = call(dt), other_report = call(other);
    ASSERT_EQ(all_of(report), all_of(other_report));
    ASSERT_NO_FATAL_FAILURE(expect_equal(dt, other));
  }

  void frame(Dynamic& dt, Dynamic& other)
  {
    std::vector<Point> points(dt.number_of_ids());
    for (std::size_t id = 0; id < points.size(); ++id)
      if (dt.has_id(id))
        points[id] = m_cloud.shifted(dt.point(id), m_step);
    if (below(4) == 0 && !ids_of(dt).empty())
      points[any_id(dt)] = points[any_id(dt)];
    both(dt, other, [&](Dynamic& t) { return t.update(points.begin(), points.end()); });
  }

  void any_call(Dynamic& dt, Dynamic& other)
  {
    const bool has_points = dt.number_of_points() > 0;
    switch (below(has_points ? 6 : 1)) {
    case 0: {
      const auto points = m_cloud.uniform(1 + below(3));
      std::vector<std::size_t> ids;
      return both(dt, other, [&](Dynamic& t) {
        return t.insert(points.begin(), points.end(), std::back_inserter(ids));
      });
    }
    case 1: {
      const std::size_t id = any_id(dt);
      return both(dt, other, [&](Dynamic& t) { return t.remove(id); });
    }
    case 2: {
      const std::pair<std::size_t, Point> mover(any_id(dt), dt.point(any_id(dt)));
      return both(dt, other, [&](Dynamic& t) { return t.move(&mover, &mover + 1); });
    }
    case 3: {
      const std::size_t id = any_id(dt);
      const Point p = m_cloud.shifted(dt.point(id), 10 * m_step);
      return both(dt, other, [&](Dynamic& t) { return t.move(id, p); });
    }
    default:
      return frame(dt, other);
    }
  }

  std::size_t below(std::size_t end) { return m_cloud.random()() % end; }

private:
  static std::vector<std::size_t> ids_of(const Dynamic& dt)
  {
    std::vector<std::size_t> ids;
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
      if (dt.has_id(id))
        ids.push_back(id);
    return ids;
  }

  std::size_t any_id(const Dynamic& dt)
  {
    const auto ids = ids_of(dt);
    return ids[below(ids.size())];
  }

  Cloud<Kernel> m_cloud;
  double m_step;
};

// Checkpoints are compared at the end only, so that writing them cannot influence the calls.
template <class Dynamic>
void expect_common_future(Dynamic& dt, Dynamic& other, unsigned seed, double step = 0.05,
                          int frames = 50)
{
  ASSERT_NO_FATAL_FAILURE(expect_equal(dt, other));
  Common_future<Dynamic> future(seed, step);
  for (int frame = 0; frame < frames; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    ASSERT_NO_FATAL_FAILURE(future.any_call(dt, other));
  }
  ASSERT_EQ(checkpoint_of(dt), checkpoint_of(other));
}

template <class Dynamic>
void expect_to_go_on(Dynamic& dt, unsigned seed, double step = 0.05, int frames = 50)
{
  Dynamic other = restored(dt);
  ASSERT_EQ(checkpoint_of(dt), checkpoint_of(other));
  ASSERT_NO_FATAL_FAILURE(expect_common_future(dt, other, seed, step, frames));
}

template <class Dynamic>
void expect_to_go_on_at_every_stage(Dynamic dt, unsigned seed, double step)
{
  for (unsigned stage = 0; stage < 4; ++stage) {
    SCOPED_TRACE(testing::Message() << "stage " << stage);
    ASSERT_NO_FATAL_FAILURE(expect_to_go_on(dt, 10 * seed + stage, step));
  }
}

template <class Kernel>
struct Checkpoints_of : testing::Test
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  using Point = typename Kernel::Point_2;

  static Dynamic triangulated(const std::vector<Point>& points)
  {
    return Dynamic(points.begin(), points.end());
  }
};
using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Checkpoints_of, Kernels);

TYPED_TEST(Checkpoints_of, a_moving_cloud_goes_on_from_any_stage)
{
  for (const double step : {0.003, 0.05, 0.5})
    expect_to_go_on_at_every_stage(this->triangulated(Cloud<TypeParam>(1).uniform(120)), 1, step);
}

TYPED_TEST(Checkpoints_of, ties_are_broken_as_they_would_have_been)
{
  auto points = Cloud<TypeParam>::grid(8, 7);
  auto dt = this->triangulated(points);
  Common_future<decltype(dt)> past(2, 0.2);
  auto other = restored(dt);
  for (int frame = 0; frame < 5; ++frame)
    past.frame(dt, other);
  const auto back = [&](auto& t) { return t.update(points.begin(), points.end()); };
  past.both(dt, other, back);
  other = restored(dt);
  points = scaled<TypeParam>(points, 2);
  past.both(dt, other, back); // whichever diagonals were there still are
  expect_to_go_on(dt, 2, 0.02);
}

TYPED_TEST(Checkpoints_of, points_that_coincide_are_kept_with_their_representative)
{
  auto points = Cloud<TypeParam>(3).uniform(60);
  points[7] = points[3];
  points[59] = points[3];
  points[20] = points[40];
  auto dt = this->triangulated(points);
  dt.remove(3);
  ASSERT_LT(dt.number_of_vertices(), dt.number_of_points());
  expect_to_go_on_at_every_stage(std::move(dt), 3, 0.05);
}

TYPED_TEST(Checkpoints_of, the_smallest_free_id_is_given_next)
{
  auto dt = this->triangulated(Cloud<TypeParam>(4).uniform(60));
  for (const std::size_t id : {31u, 4u, 59u, 17u})
    dt.remove(id);
  auto other = restored(dt);
  EXPECT_EQ(other.number_of_ids(), 60u);
  EXPECT_FALSE(other.has_id(17));
  expect_common_future(dt, other, 4);
}

TYPED_TEST(Checkpoints_of, no_point_one_and_two_and_points_on_a_line_are_kept)
{
  Cloud<TypeParam> cloud(5);
  for (std::size_t n = 0; n < 4; ++n) {
    SCOPED_TRACE(testing::Message() << n << " points");
    auto few = this->triangulated(cloud.uniform(n));
    expect_to_go_on(few, unsigned(n));
    auto line = this->triangulated(cloud.on_line(10 * n));
    expect_to_go_on(line, unsigned(n));
    auto one_place = this->triangulated(std::vector<typename TestFixture::Point>(n, {1, 2}));
    expect_to_go_on(one_place, unsigned(n));
  }
}

TYPED_TEST(Checkpoints_of, all_points_may_have_gone)
{
  auto dt = this->triangulated(Cloud<TypeParam>(6).uniform(5));
  for (std::size_t id = 0; id < 5; ++id)
    dt.remove(id);
  expect_to_go_on(dt, 6);
}

TYPED_TEST(Checkpoints_of, a_file_replaces_whatever_is_there)
{
  auto dt = this->triangulated(Cloud<TypeParam>(7).uniform(50));
  for (const std::size_t n : {0u, 1u, 20u, 200u}) {
    auto other = this->triangulated(Cloud<TypeParam>(8).uniform(n));
    const auto* const place = &other.triangulation();
    other.mend();
    read(other, checkpoint_of(dt));
    EXPECT_EQ(&other.triangulation(), place);
    ASSERT_NO_FATAL_FAILURE(expect_equal(dt, other));
    ASSERT_EQ(checkpoint_of(dt), checkpoint_of(other));
  }
}

// Coordinates that no double can hold.
std::vector<Epeck::Point_2> thirds(const std::vector<Epeck::Point_2>& points)
{
  std::vector<Epeck::Point_2> result;
  for (const auto& p : points)
    result.emplace_back(p.x() / 3 - p.y() / 7, -p.y() / 3);
  return result;
}

TEST(Checkpoints, fractions_are_kept_exactly)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epeck>;
  const auto points = thirds(Cloud<Epeck>(9).uniform(60));
  Dynamic dt(points.begin(), points.end());
  ASSERT_FALSE(dt.frame().positions_are_exact());
  expect_to_go_on_at_every_stage(std::move(dt), 9, 0.05);
}

TEST(Checkpoints, kernels_of_equal_kinds_of_coordinates_share_their_files)
{
  using Gmpq_kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
  const auto points = thirds(Cloud<Epeck>(10).uniform(40));
  const CGAL::Dynamic_Delaunay_triangulation_2<Epeck> lazy(points.begin(), points.end());
  CGAL::Dynamic_Delaunay_triangulation_2<Gmpq_kernel> eager;
  read(eager, checkpoint_of(lazy));
  EXPECT_TRUE(eager.is_valid(true));
  EXPECT_EQ(checkpoint_of(eager), checkpoint_of(lazy));
}

TEST(Checkpoints, any_finite_double_is_kept_to_the_bit)
{
  using Limits = std::numeric_limits<double>;
  const Points points = {{-0., 0.1},
                         {Limits::denorm_min(), -(Limits::min)()},
                         {1e300, -1e-300},
                         {(Limits::max)() / 8, 1. / 3}};
  const Exact dt(points.begin(), points.end());
  const Exact other = restored(dt);
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_EQ(other.point(id), points[id]);
    EXPECT_EQ(std::signbit(other.point(id).x()), std::signbit(points[id].x()));
  }
}

TEST(Checkpoints, what_an_exact_classifier_remembers_makes_no_difference)
{
  Cloud<Epick> cloud(11);
  auto points = cloud.uniform(400);
  Exact dt(points.begin(), points.end());
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Safe_region_classifier_2> by_regions(
      points.begin(), points.end());
  for (int frame = 0; frame < 60; ++frame) {
    cloud.shake(points, 1e-4);
    dt.update(points.begin(), points.end());
    by_regions.update(points.begin(), points.end());
  }
  expect_to_go_on(dt, 11, 1e-4, 100);
  expect_to_go_on(by_regions, 11, 1e-4, 100);
}

// Motion that is mended in some frames and rebuilt in others, depending on repairs that failed.
TEST(Checkpoints, what_was_in_vain_is_remembered)
{
  Cloud<Epick> cloud(11);
  auto points = cloud.uniform(1500);
  Exact dt(points.begin(), points.end());
  std::size_t rebuilt = 0;
  for (int frame = 0; frame < 40; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    Exact other = restored(dt);
    const std::size_t stride = frame % 3 == 0 ? 24 : 4;
    for (std::size_t i = std::size_t(frame) % stride; i < points.size(); i += stride)
      points[i] = cloud.shifted(points[i], 2);
    const CGAL::Update_report_2 report = dt.update(points.begin(), points.end());
    ASSERT_EQ(all_of(other.update(points.begin(), points.end())), all_of(report));
    rebuilt += report.rebuilt();
  }
  EXPECT_GT(rebuilt, 3u);
  EXPECT_LT(rebuilt, 40u);
}

TEST(Checkpoints, uncertified_triangulations_are_kept_as_they_are)
{
  using Classifier = CGAL::Nearly_delaunay_classifier_2;
  using Heuristic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier,
                                             CGAL::With_repair_2<CGAL::Flip_repair_2>>;
  for (unsigned seed = 0; seed < 4; ++seed) {
    Cloud<Epick> cloud(seed);
    auto points = cloud.uniform(150);
    Heuristic dt(points.begin(), points.end());
    for (int frame = 0; frame < 6; ++frame) {
      cloud.shake(points, 0.1);
      dt.update(points.begin(), points.end());
    }
    ASSERT_FALSE(dt.is_certified());
    Heuristic other = restored(dt);
    EXPECT_FALSE(other.is_certified());
    EXPECT_THROW(other.triangulation(), CGAL::Uncertified_triangulation_error_2);
    EXPECT_EQ(all_of(dt.mend()), all_of(other.mend()));
    expect_equal(dt, other);
    cloud.shake(points, 0.1);
    dt.update(points.begin(), points.end());
    expect_to_go_on_at_every_stage(std::move(dt), seed, 0.1);
  }
}

// Records after each update whether it is told that everything is new.
struct Told_classifier
{
  static constexpr bool is_exact = true;
  std::vector<bool> told;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    CGAL::Circumcircle_classifier_2()(frame, classified);
  }
  template <class Frame>
  void after_update(const Frame& frame)
  {
    told.push_back(frame.everything_is_new());
  }
};

TEST(Checkpoints, the_classifier_is_told_once_that_everything_is_new)
{
  Cloud<Epick> cloud(12);
  auto points = cloud.uniform(50);
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Told_classifier>;
  Dynamic dt(points.begin(), points.end());
  const std::string text = checkpoint_of(dt);
  cloud.shake(points, 0.01);
  dt.update(points.begin(), points.end());
  read(dt, text);
  EXPECT_EQ(dt.classifier().told, (std::vector<bool>{true, false, true}));
  dt.update(points.begin(), points.end());
  EXPECT_EQ(dt.classifier().told, (std::vector<bool>{true, false, true, false}));
}

TEST(Checkpoints, the_sets_of_the_last_update_are_forgotten)
{
  Cloud<Epick> cloud(13);
  auto points = cloud.uniform(200);
  Exact dt(points.begin(), points.end()), few(points.begin(), points.begin() + 3);
  cloud.shake(points, 0.03);
  dt.update(points.begin(), points.end());
  ASSERT_FALSE(dt.classified_vertices().empty());
  read(dt, checkpoint_of(few));
  EXPECT_TRUE(dt.classified_vertices().empty());
}

struct Failure_of_a_user
{
};

struct Faulty_repair
{
  template <class Mender>
  void operator()(Mender&) const
  {
    throw Failure_of_a_user();
  }
};

TEST(Checkpoints, what_an_exception_has_left_is_kept_or_not_written_at_all)
{
  Cloud<Epick> cloud(14);
  auto points = cloud.uniform(50);
  points[1] = points[0];
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                                         CGAL::With_repair_2<Faulty_repair>>;
  Dynamic dt(points.begin(), points.end());
  for (std::size_t id = 2; id < points.size(); ++id)
    points[id] = cloud.shifted(points[id], 0.5);
  EXPECT_THROW(dt.update(points.begin(), points.end()), Failure_of_a_user);
  Dynamic other = restored(dt);
  EXPECT_FALSE(other.is_certified());
  EXPECT_EQ(all_of(dt.mend()), all_of(other.mend()));
  expect_equal(dt, other);

  cloud.shake(points, 0.5); // the two part
  EXPECT_THROW(dt.update(points.begin(), points.end()), Failure_of_a_user);
  std::ostringstream out;
  EXPECT_THROW(dt.write_checkpoint(out), Checkpoint_error_2);
  EXPECT_FALSE(out << dt);
  EXPECT_EQ(out.str(), "");
}

TEST(Checkpoints, what_follows_in_the_stream_stays_there)
{
  const auto points = Cloud<Epick>(15).uniform(20);
  const Exact first(points.begin(), points.begin() + 10), second(points.begin(), points.end());
  std::istringstream in(checkpoint_of(first) + checkpoint_of(second) + "more");
  Exact dt;
  dt.read_checkpoint(in);
  expect_equal(first, dt);
  dt.read_checkpoint(in);
  expect_equal(second, dt);
  std::string rest;
  in >> rest;
  EXPECT_EQ(rest, "more");
}

TEST(Checkpoints, the_example_in_the_manual_is_a_checkpoint)
{
  const Points points = {{0, 0}, {2, 0}, {2, 1}, {0, 1}, {1, 0.4}, {2, 1}};
  Exact dt(points.begin(), points.end());
  dt.remove(3);
  EXPECT_EQ(checkpoint_of(dt), "Dynamic_Delaunay_triangulation_2 checkpoint 1\n"
                               "coordinates double\npositions exact\ncertified yes\n"
                               "hopeless_share 65536\ndimension 2\n"
                               "ids 6\nvertices 4\n0 0 0\n4 1 0.4\n1 2 0\n2 2 1\n"
                               "duplicates 1\n5 4 2 1\nfree_ids 1\n3\n"
                               "faces 6\n4 1 2\n3 2 1\n0 3 1\n0 1 4\n2 3 4\n0 4 3\n"
                               "corners 5\n15 5\n10 3\n12 4\n17 5\n16 5\n"
                               "edges 9\n3 3\n13 13\n9 9\n6 6\n14 14\n11 11\n16 16\n17 17\n15 15\n"
                               "checksum abeaeb85\n");
}

// POPULATIONS -------------------------------------------------------------------------------------

TEST(Checkpoints, a_population_goes_on_with_the_ids_of_its_user)
{
  Cloud<Epick> cloud(16);
  std::vector<std::pair<std::int64_t, Epick::Point_2>> crowd;
  std::int64_t next_id = -20;
  const auto change = [&] {
    for (auto& [id, p] : crowd)
      p = cloud.shifted(p, 0.05);
    for (int i = 0; i < 3 && !crowd.empty(); ++i)
      crowd.erase(crowd.begin() + std::ptrdiff_t(cloud.random()() % crowd.size()));
    for (const auto& p : cloud.uniform(5))
      crowd.emplace_back(next_id++ * 1000000007, p);
  };
  Population population;
  for (int stage = 0; stage < 5; ++stage) {
    Population other;
    read(other, checkpoint_of(population));
    for (int frame = 0; frame < 10; ++frame) {
      change();
      ASSERT_EQ(all_of(population.update(crowd.begin(), crowd.end())),
                all_of(other.update(crowd.begin(), crowd.end())));
      ASSERT_NO_FATAL_FAILURE(expect_equal(population.triangulation(), other.triangulation()));
      ASSERT_EQ(other.size(), crowd.size());
      for (const auto& [id, p] : crowd)
        ASSERT_EQ(other.point(id), p);
    }
    ASSERT_EQ(checkpoint_of(population), checkpoint_of(other));
  }
}

TEST(Checkpoints, ids_of_users_of_any_integer_type_are_kept_or_refused)
{
  using Large = CGAL::Dynamic_population_2<Exact, std::uint64_t>;
  using Small = CGAL::Dynamic_population_2<Exact, unsigned char>;
  Large large;
  Small small;
  large.insert(200, {1, 2});
  read(small, checkpoint_of(large));
  EXPECT_TRUE(small.has(200));
  large.insert((std::numeric_limits<std::uint64_t>::max)(), {3, 2});
  EXPECT_GT(refusal(small, checkpoint_of(large)).line(), 0u);
  EXPECT_EQ(small.size(), 1u);
  Large copy;
  read(copy, checkpoint_of(large));
  EXPECT_TRUE(copy.has((std::numeric_limits<std::uint64_t>::max)()));
}

TEST(Checkpoints, ids_of_users_that_repeat_are_refused)
{
  Population population;
  population.insert(5, {0, 0});
  population.insert(6, {1, 0});
  const std::string text = checkpoint_of(population);
  Population other;
  EXPECT_GT(refusal(other, replaced(text, "\n1 6\n", "\n1 5\n")).line(), 0u);
  EXPECT_GT(refusal(other, replaced(text, "user_ids 2", "user_ids 1")).line(), 0u);
  EXPECT_EQ(other.size(), 0u);
}

// REFUSALS ----------------------------------------------------------------------------------------

// A small triangulation whose checkpoint has everything that a file can have.
Exact specimen()
{
  Points points = Cloud<Epick>(17).uniform(9);
  points[4] = points[2];
  Exact dt(points.begin(), points.end());
  dt.remove(6);
  return dt;
}

struct Plane
{
  static Exact empty() { return {}; }
  static Exact specimen() { return test_checkpoint::specimen(); }
  static Exact other_one()
  {
    const auto points = Cloud<Epick>(18).uniform(30);
    return Exact(points.begin(), points.end());
  }
};
INSTANTIATE_TYPED_TEST_SUITE_P(Checkpoints, Checkpoint_files, Plane);

TEST(Checkpoints, nothing_changes_if_a_file_is_refused)
{
  const std::string text = checkpoint_of(specimen());
  Exact dt = Plane::other_one();
  const std::string before = checkpoint_of(dt);
  const auto vertex = dt.vertex(7);
  for (std::size_t size = 0; size < text.size(); size += 7)
    refusal(dt, text.substr(0, size));
  EXPECT_EQ(dt.vertex(7), vertex);
  EXPECT_EQ(checkpoint_of(dt), before);
  Exact other = restored(dt);
  expect_common_future(dt, other, 18);
}

TEST(Checkpoints, a_refusal_says_where_and_why)
{
  const std::string text = checkpoint_of(specimen());
  Exact dt;
  const auto message = [&](const std::string& edited) {
    return std::string(refusal(dt, edited).what());
  };
  EXPECT_EQ(message(replaced(text, "certified yes", "certified maybe")),
            "checkpoint, line 4: certified is \"maybe\", and has to be yes or no");
  EXPECT_EQ(message(replaced(text, "double", "rational")),
            "checkpoint, line 2: the coordinates are of the kind \"rational\", and those of the "
            "triangulation's points of the kind \"double\"");
  EXPECT_EQ(message(replaced(text, "checkpoint 1", "checkpoint 2")),
            "checkpoint, line 1: it is \"Dynamic_Delaunay_triangulation_2 checkpoint 2\", and has "
            "to be \"Dynamic_Delaunay_triangulation_2 checkpoint 1\"");
  EXPECT_EQ(message("\x1b[31m\n"), "checkpoint, line 1: it is \"?[31m\", and has to be "
                                   "\"Dynamic_Delaunay_triangulation_2 checkpoint 1\"");
  EXPECT_EQ(message(checkpoint_of(Population())),
            "checkpoint, line 1: it is \"Dynamic_population_2 checkpoint 1\", and has to be "
            "\"Dynamic_Delaunay_triangulation_2 checkpoint 1\"");
  EXPECT_LT(message(std::string(1000, 'x') + "\n").size(), 300u);
  EXPECT_EQ(message(""), "checkpoint, line 1: the file ends here, and is not complete");
}

TEST(Checkpoints, a_triangulation_that_is_not_delaunay_is_not_believed_to_be_certified)
{
  Cloud<Epick> cloud(19);
  auto points = cloud.uniform(300);
  using Heuristic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2>;
  Heuristic dt(points.begin(), points.end(), CGAL::Point_distance_classifier_2(0.1));
  cloud.shake(points, 0.05);
  dt.update(points.begin(), points.end());
  const std::string text = checkpoint_of(dt);
  ASSERT_FALSE(dt.certify());
  Heuristic other;
  const Checkpoint_error_2 error = refusal(other, replaced(text, "certified no", "certified yes"));
  EXPECT_EQ(error.line(), 4u);
  EXPECT_EQ(other.number_of_points(), 0u);
  read(other, text);
  EXPECT_EQ(all_of(dt.mend()), all_of(other.mend()));
}

TEST(Checkpoints, inconsistent_files_with_the_right_checksum_are_refused)
{
  const std::string text = checkpoint_of(specimen());
  Exact dt;
  const auto is_refused = [&](const std::string& what, const std::string& by) {
    return refusal(dt, replaced(text, what, by)).line() > 0;
  };
  EXPECT_TRUE(is_refused("dimension 2", "dimension 1"));
  EXPECT_TRUE(is_refused("dimension 2", "dimension 3"));
  EXPECT_TRUE(is_refused("positions exact", "positions rounded"));
  EXPECT_TRUE(is_refused("ids 9", "ids 10"));
  EXPECT_TRUE(is_refused("ids 9", "ids 8"));
  EXPECT_TRUE(is_refused("free_ids 1\n6\n", "free_ids 1\n5\n"));
  EXPECT_TRUE(is_refused("free_ids 1\n6\n", "free_ids 1\n6 6\n"));
  EXPECT_TRUE(is_refused("free_ids 1\n6\n", "free_ids 1\n\n"));
  EXPECT_TRUE(is_refused("duplicates 1\n4", "duplicates 1\n3"));
  EXPECT_TRUE(is_refused("duplicates 1", "duplicates 0"));
}

TEST(Checkpoints, coordinates_have_to_be_finite_and_their_places_right)
{
  const std::string text = checkpoint_of(specimen());
  Exact dt;
  const std::string vertex = '\n' + line_below(text, "vertices") + '\n';
  const std::string id = vertex.substr(0, vertex.find(' '));
  for (const char* point :
       {"nan 1", "inf 1", "1e999 1", "1 ", " 1", "1,5 1", "0x1 1", "1 1 1", "+1 1", "1/2 1", "1"})
    EXPECT_GT(refusal(dt, replaced(text, vertex, id + ' ' + point + '\n')).line(), 0u) << point;

  using Lazy = CGAL::Dynamic_Delaunay_triangulation_2<Epeck>;
  const auto points = thirds(Cloud<Epeck>(20).uniform(3));
  const std::string rounded = checkpoint_of(Lazy(points.begin(), points.end()));
  Lazy lazy;
  const std::string lazy_vertex = '\n' + line_below(rounded, "vertices") + '\n';
  const std::string place = lazy_vertex.substr(0, lazy_vertex.find(' '));
  EXPECT_EQ(refusal(lazy, rounded).line(), 0u);
  for (const char* point : {"012 1 12 1", "019 1 19 1", "-01 1 -1 1", "1/0 1 1 1", "1/00 1 1 1",
                            "/2 1 1 1", "1/ 1 1 1", "- 1 1 1", "1/-2 1 1 1", "1.5 1 1 1",
                            "0x10 1 16 1", "1 1 2 1", "1 1 1 nan", "1 1 1", "nan 1 1 1"})
    EXPECT_GT(refusal(lazy, replaced(rounded, lazy_vertex, place + ' ' + point + '\n')).line(), 0u)
        << point;
  const std::string huge = '1' + std::string(400, '0');
  EXPECT_GT(
      refusal(lazy, replaced(rounded, lazy_vertex, place + ' ' + huge + " 1 1e308 1\n")).line(),
      0u);
}

template <class Dynamic>
void expect_forgeries_to_be_harmless(const Dynamic& original, unsigned seed, int number)
{
  const auto expect_both = [](Dynamic& dt, Dynamic& other, int i) {
    ASSERT_TRUE(dt.is_valid(true));
    ASSERT_NO_FATAL_FAILURE(expect_common_future(dt, other, unsigned(i), 0.05, 5));
  };
  ::expect_forgeries_to_be_harmless(checkpoint_of(original), Dynamic(), seed, number, expect_both);
}

TEST(Checkpoints, a_forged_file_is_refused_or_harmless)
{
  using Heuristic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Nearly_delaunay_classifier_2>;
  expect_forgeries_to_be_harmless(specimen(), 1, 5000);
  Cloud<Epick> cloud(21);
  auto points = cloud.uniform(7);
  Heuristic dt(points.begin(), points.end());
  cloud.shake(points, 0.2);
  dt.update(points.begin(), points.end());
  ASSERT_FALSE(dt.is_certified());
  expect_forgeries_to_be_harmless(dt, 2, 5000);
  const auto line = cloud.on_line(4);
  expect_forgeries_to_be_harmless(Exact(line.begin(), line.end()), 3, 2000);
  const auto fractions = thirds(Cloud<Epeck>(22).uniform(5));
  expect_forgeries_to_be_harmless(
      CGAL::Dynamic_Delaunay_triangulation_2<Epeck>(fractions.begin(), fractions.end()), 4, 1000);
}

// SPHERES -----------------------------------------------------------------------------------------

using Triple = std::array<unsigned, 3>;

const char* flaw_of(const std::vector<Triple>& triples, unsigned vertices)
{
  namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
  internal::Flat_faces_2 faces;
  faces.resize(triples.size());
  for (unsigned f = 0; f < triples.size(); ++f)
    faces.set_vertices(f, triples[f][0], triples[f][1], triples[f][2]);
  return internal::Surface_check_2(faces, vertices).link_and_run().what;
}

std::vector<Triple> tetrahedron(unsigned first)
{
  std::vector<Triple> faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  for (Triple& face : faces)
    for (unsigned& v : face)
      v += first;
  return faces;
}

TEST(Checkpoints, faces_that_are_no_sphere_are_refused)
{
  auto faces = tetrahedron(0);
  EXPECT_EQ(flaw_of(faces, 4), nullptr);
  std::swap(faces[1][0], faces[1][1]); // turned over
  EXPECT_NE(flaw_of(faces, 4), nullptr);
  faces = tetrahedron(0);
  EXPECT_STREQ(flaw_of(faces, 5), "a vertex is in no face");
  faces[0] = {1, 1, 2};
  EXPECT_NE(flaw_of(faces, 4), nullptr);
  faces = tetrahedron(0);
  faces.pop_back();
  EXPECT_STREQ(flaw_of(faces, 4), "an edge of the face has no other face");

  // two spheres with a vertex in common
  faces = tetrahedron(0);
  for (const Triple& face : tetrahedron(3))
    faces.push_back(face);
  EXPECT_STREQ(flaw_of(faces, 7), "the faces at a vertex of the face are not one cycle");

  // a sphere and a torus: Euler's formula holds, all in all
  faces = tetrahedron(0);
  for (unsigned i = 0; i < 7; ++i) {
    faces.push_back({4 + i, 4 + (i + 1) % 7, 4 + (i + 3) % 7});
    faces.push_back({4 + i, 4 + (i + 3) % 7, 4 + (i + 2) % 7});
  }
  ASSERT_EQ(faces.size(), 2u * 11 - 4);
  EXPECT_STREQ(flaw_of(faces, 11), "the face hangs together with the first one by no edges");
}

// STREAMS AND MEMORY ------------------------------------------------------------------------------

TEST(Checkpoints, a_stream_that_was_not_opened_is_noticed)
{
  Exact dt;
  std::istringstream in(checkpoint_of(dt));
  in.setstate(std::ios::failbit);
  EXPECT_THROW(dt.read_checkpoint(in), Checkpoint_error_2);
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(dt.write_checkpoint(out), Checkpoint_error_2);
}

TEST(Checkpoints, operators_write_and_read_them)
{
  const Exact dt = specimen();
  Population population;
  population.insert(-7, {1, 2});
  std::stringstream file;
  CGAL::IO::set_binary_mode(file); // checkpoints are text all the same
  file << dt << "\n  " << population << ' ' << dt;
  EXPECT_EQ(file.str(),
            checkpoint_of(dt) + "\n  " + checkpoint_of(population) + ' ' + checkpoint_of(dt));
  Exact copy, other_copy;
  Population copied_population;
  EXPECT_TRUE(file >> copy >> copied_population >> other_copy);
  expect_equal(dt, copy);
  expect_equal(dt, other_copy);
  EXPECT_EQ(checkpoint_of(copied_population), checkpoint_of(population));
}

TEST(Checkpoints, a_stream_fails_where_its_operator_refuses_a_file)
{
  const std::string text = checkpoint_of(specimen());
  Exact dt = Plane::other_one();
  const auto vertex = dt.vertex(7);
  EXPECT_EQ(state_after_reading(dt, replaced(text, "ids 9", "ids 8")), std::ios::failbit);
  EXPECT_EQ(state_after_reading(dt, checkpoint_of(Population())), std::ios::failbit);
  EXPECT_EQ(state_after_reading(dt, " \n"), std::ios::failbit | std::ios::eofbit);
  EXPECT_EQ(dt.vertex(7), vertex);
  Population population;
  population.insert(5, {0, 0});
  EXPECT_EQ(state_after_reading(population, text), std::ios::failbit);
}

TEST(Checkpoints, operators_throw_what_their_stream_is_told_to)
{
  Exact dt = specimen();
  std::istringstream in("garbage\n");
  in.exceptions(std::ios::failbit);
  EXPECT_THROW(in >> dt, std::ios_base::failure);
  Full_disk disk(100);
  std::ostream out(&disk);
  out.exceptions(std::ios::badbit | std::ios::failbit);
  EXPECT_THROW(out << dt, std::ios_base::failure);
}

TEST(Checkpoints, nothing_changes_in_a_population_if_memory_runs_out)
{
  const auto points = Cloud<Epick>(23).uniform(30);
  Population population, other;
  population.insert(7, points[0]);
  for (std::size_t i = 0; i < points.size(); ++i)
    other.insert(std::int64_t(100 + i), points[i]);
  expect_nothing_to_change_without_memory(population, checkpoint_of(other));
  EXPECT_TRUE(population.has(100));
}

} // namespace test_checkpoint
