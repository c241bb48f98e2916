// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Populations in space: frames list who is there, by ids of the user.

#include "forged_checkpoint.h"
#include "replaced_heap.h"
#include "space_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <map>
#include <new>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_space_population {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Epick>;
using Population = CGAL::Dynamic_population_3<Dynamic>;
using Point = Dynamic::Point;
template <class Any>
using Crowd_of = std::map<typename Any::User_id, typename Any::Point>;
using Crowd = Crowd_of<Population>;

// The crowd in another order.
template <class Any>
auto shuffled(const Any& crowd, std::mt19937_64& random)
{
  std::vector<std::pair<typename Any::key_type, typename Any::mapped_type>> frame(crowd.begin(),
                                                                                  crowd.end());
  std::shuffle(frame.begin(), frame.end(), random);
  return frame;
}

template <class Any>
void expect_population(const Any& population, const Crowd_of<Any>& crowd)
{
  ASSERT_EQ(population.size(), crowd.size());
  std::map<std::size_t, typename Any::Point> points;
  for (const auto& [user_id, p] : crowd) {
    ASSERT_TRUE(population.has(user_id));
    ASSERT_EQ(population.user_id(population.id(user_id)), user_id);
    ASSERT_EQ(population.point(user_id), p);
    points.emplace(population.id(user_id), p);
  }
  ASSERT_EQ(points.size(), crowd.size());
  ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(population.triangulation(), points));
}

// Random frames, with points on a grid if there is one.
template <class Any>
class Frames
{
public:
  using User_id = typename Any::User_id;
  using Its_point = typename Any::Point;

  Frames(std::uint64_t seed, double grid)
    : m_random(seed)
    , m_grid(grid)
  {
  }

  std::mt19937_64& random() { return m_random; }
  std::size_t below(std::size_t end) { return std::size_t(m_random() % end); }

  Its_point anywhere()
  {
    std::uniform_real_distribution<double> coordinate(0, 1);
    const double x = on_grid(coordinate(m_random)), y = on_grid(coordinate(m_random));
    return Its_point(x, y, on_grid(coordinate(m_random)));
  }

  // Some leave, all others move, some come.
  void change(Crowd_of<Any>& crowd, std::size_t most)
  {
    for (std::size_t n = below(most + 1); n > 0 && !crowd.empty(); --n)
      crowd.erase(std::next(crowd.begin(), std::ptrdiff_t(below(crowd.size()))));
    static constexpr double steps[] = {0, 1e-4, 0.003, 0.02, 0.2};
    const double step = steps[below(5)];
    for (auto& [user_id, p] : crowd)
      p = shaken(p, step);
    for (std::size_t n = below(most + 1); n > 0; --n)
      crowd[next_id()] = anywhere();
    if (crowd.size() > 3 && below(3) == 0) // two meet
      crowd.begin()->second = std::next(crowd.begin(), 2)->second;
  }

  User_id next_id() { return User_id(m_next_id++ * 37); }

private:
  double on_grid(double x) const { return m_grid > 0 ? std::floor(x / m_grid) * m_grid : x; }

  Its_point shaken(const Its_point& p, double step)
  {
    std::uniform_real_distribution<double> by(-step, step);
    const double x = CGAL::to_double(p.x()) + by(m_random);
    const double y = CGAL::to_double(p.y()) + by(m_random);
    const double z = CGAL::to_double(p.z()) + by(m_random);
    return Its_point(on_grid(x), on_grid(y), on_grid(z));
  }

  std::mt19937_64 m_random;
  double m_grid;
  std::int64_t m_next_id = -3;
};

class Population_in_space : public testing::TestWithParam<std::tuple<int, double, int>>
{
};

TEST_P(Population_in_space, is_exact_whoever_comes_and_goes)
{
  const auto [seed, grid, size] = GetParam();
  Frames<Population> frames(std::uint64_t(seed), grid);
  Population population;
  Crowd crowd;
  for (int i = 0; i < size; ++i)
    crowd[frames.next_id()] = frames.anywhere();
  for (int frame = 0; frame < 40; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    const std::size_t before = population.size();
    const CGAL::Update_report_3 report = population.update(shuffled(crowd, frames.random()));
    EXPECT_TRUE(report.certified);
    EXPECT_EQ(before - report.removed + report.inserted, crowd.size());
    ASSERT_NO_FATAL_FAILURE(expect_population(population, crowd));
    frames.change(crowd, frame % 4 == 3 ? crowd.size() : 1 + crowd.size() / 30);
  }
}
INSTANTIATE_TEST_SUITE_P(anywhere, Population_in_space,
                         testing::Combine(testing::Range(0, 8), testing::Values(0.0),
                                          testing::Values(3, 60, 400)));
INSTANTIATE_TEST_SUITE_P(on_a_grid, Population_in_space,
                         testing::Combine(testing::Range(10, 18), testing::Values(0.25),
                                          testing::Values(10, 100)));

TEST(Populations_in_space, of_an_exact_kernel_are_exact)
{
  using Exact = CGAL::Dynamic_population_3<CGAL::Dynamic_Delaunay_triangulation_3<Epeck>, int>;
  Frames<Exact> frames(1, 0);
  Exact population;
  Crowd_of<Exact> crowd;
  for (int i = 0; i < 60; ++i)
    crowd[frames.next_id()] = frames.anywhere();
  for (int frame = 0; frame < 8; ++frame) {
    population.update(shuffled(crowd, frames.random()));
    ASSERT_NO_FATAL_FAILURE(expect_population(population, crowd));
    frames.change(crowd, 2);
  }
}

// A calm crowd with some who come and go, of which everybody is on the move.
TEST(Populations_in_space, are_mended_not_rebuilt)
{
  Frames<Population> frames(4, 0);
  Population population;
  Crowd crowd;
  for (int i = 0; i < 1000; ++i)
    crowd[frames.next_id()] = frames.anywhere();
  population.update(crowd);
  std::size_t flips = 0;
  for (int frame = 0; frame < 10; ++frame) {
    for (auto& [user_id, p] : crowd)
      p = Point(p.x() + 0.005 * p.y(), p.y(), p.z() + 0.005 * p.x());
    for (int i = 0; i < 5; ++i)
      crowd.erase(std::next(crowd.begin(), std::ptrdiff_t(frames.below(crowd.size()))));
    for (int i = 0; i < 5; ++i)
      crowd[frames.next_id()] = frames.anywhere();
    const CGAL::Update_report_3 report = population.update(crowd);
    EXPECT_FALSE(report.rebuilt());
    EXPECT_EQ(report.removed, 5u);
    EXPECT_EQ(report.inserted, 5u);
    flips += report.flips;
  }
  EXPECT_GT(flips, 100u);
  EXPECT_EQ(population.triangulation().number_of_ids(), 1000u); // ids of those who go are reused
  ASSERT_NO_FATAL_FAILURE(expect_population(population, crowd));
}

TEST(Populations_in_space, lose_representatives_of_points_that_move_on)
{
  Population population;
  Crowd crowd;
  Frames<Population> frames(5, 0);
  for (int i = 0; i < 200; ++i)
    crowd[i] = frames.anywhere();
  for (const int i : {50, 51, 52, 60})
    crowd[i] = crowd[49];
  population.update(crowd);
  ASSERT_EQ(population.triangulation().number_of_vertices(), 196u);
  crowd.erase(49); // represents the others
  crowd.erase(51);
  for (const int i : {50, 52, 60})
    crowd[i] = frames.anywhere();
  population.update(crowd);
  ASSERT_NO_FATAL_FAILURE(expect_population(population, crowd));
}

TEST(Populations_in_space, change_by_single_calls)
{
  Population population;
  Crowd crowd;
  Frames<Population> frames(6, 0);
  for (int turn = 0; turn < 120; ++turn) {
    const std::size_t kind = crowd.size() < 20 ? 0 : frames.below(5);
    const auto some = crowd.empty()
                          ? crowd.end()
                          : std::next(crowd.begin(), std::ptrdiff_t(frames.below(crowd.size())));
    if (kind == 0) {
      Crowd newcomers;
      for (std::size_t n = frames.below(3); n < 3; ++n)
        newcomers[frames.next_id()] = frames.anywhere();
      EXPECT_EQ(population.insert(newcomers).inserted, newcomers.size());
      crowd.insert(newcomers.begin(), newcomers.end());
    } else if (kind == 1) {
      EXPECT_EQ(population.remove(some->first).removed, 1u);
      crowd.erase(some);
    } else if (kind == 2) {
      some->second = frames.anywhere();
      population.move(some->first, some->second);
    } else if (kind == 3) {
      Crowd movers{*crowd.begin(), *crowd.rbegin()};
      for (auto& [user_id, p] : movers)
        crowd[user_id] = p = frames.anywhere();
      population.move(movers);
    } else {
      const std::vector<std::int64_t> leaving{crowd.begin()->first, crowd.rbegin()->first};
      population.remove(leaving);
      for (const std::int64_t id : leaving)
        crowd.erase(id);
    }
    ASSERT_NO_FATAL_FAILURE(expect_population(population, crowd)) << "turn " << turn;
  }
  EXPECT_TRUE(population.certify());
  EXPECT_TRUE(population.mend().certified);
}

struct Particle
{
  unsigned char name;
  double x, y, z;
};
struct Name_of
{
  using key_type = Particle;
  using value_type = unsigned char;
  using reference = unsigned char;
  using category = boost::readable_property_map_tag;
  friend unsigned char get(Name_of, const Particle& p) { return p.name; }
};
struct Place_of
{
  using key_type = Particle;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;
  friend Point get(Place_of, const Particle& p) { return Point(p.x, p.y, p.z); }
};

TEST(Populations_in_space, read_any_range_by_maps)
{
  CGAL::Dynamic_population_3<Dynamic, unsigned char> population;
  const std::list<Particle> particles{
      {200, 0, 0, 0}, {7, 1, 0, 0}, {255, 0, 1, 0}, {0, 0, 0, 1}, {9, 1, 1, 1}};
  population.update(particles, Name_of(), Place_of());
  EXPECT_EQ(population.size(), 5u);
  EXPECT_EQ(population.point(255), Point(0, 1, 0));
  population.update(particles.begin(), std::prev(particles.end()), Name_of(), Place_of());
  EXPECT_EQ(population.size(), 4u);
  EXPECT_EQ(population.triangulation().number_of_cells(), 1u);
}

// ERRORS ------------------------------------------------------------------------------------------

template <class Error, class Call>
void expect_refused(const Call& call, const std::string& message)
{
  try {
    call();
    FAIL() << "nothing is thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(Populations_in_space, refuse_wrong_frames_before_anything_changes)
{
  Population population;
  Crowd crowd;
  Frames<Population> frames(7, 0);
  for (int i = 0; i < 30; ++i)
    crowd[10 * i] = frames.anywhere();
  population.update(crowd);
  const std::string before = checkpoint_of(population);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Frame = std::vector<std::pair<std::int64_t, Point>>;
  const Frame frame(crowd.begin(), crowd.end());
  const auto with = [&frame](std::int64_t user_id, const Point& p) {
    Frame wrong = frame;
    wrong.emplace_back(user_id, p);
    wrong.erase(wrong.begin());
    return wrong;
  };
  expect_refused<CGAL::Repeated_id_error_2>([&] { population.update(with(20, Point(9, 9, 9))); },
                                            "20 is there more than once");
  Frame twice = with(5, Point(9, 9, 9));
  twice.emplace_back(5, Point(8, 8, 8));
  expect_refused<CGAL::Repeated_id_error_2>([&] { population.update(twice); }, "5 is there more");
  expect_refused<CGAL::Non_finite_coordinate_error_3>(
      [&] { population.update(with(5, Point(1, nan, 1))); }, "point 29 has");
  expect_refused<CGAL::Non_finite_coordinate_error_3>(
      [&] { population.insert(5, Point(nan, 1, 1)); }, "point 0 has");
  expect_refused<CGAL::Repeated_id_error_2>([&] { population.insert(10, Point(1, 1, 1)); }, "10");
  expect_refused<CGAL::Non_finite_coordinate_error_3>(
      [&] { population.move(10, Point(1, 1, nan)); }, "(1, 1, nan)");
  expect_refused<CGAL::Unknown_user_id_error_2>([&] { population.move(5, Point(1, 1, 1)); }, "5");
  expect_refused<CGAL::Non_finite_coordinate_error_3>(
      [&] {
        population.move(Frame{{20, Point(1, 1, 1)}, {10, Point(nan, 1, 1)}});
      },
      "point 1 has");
  expect_refused<CGAL::Repeated_id_error_2>(
      [&] {
        population.move(Frame{{20, Point(1, 1, 1)}, {20, Point(2, 1, 1)}});
      },
      "20 is there");
  expect_refused<CGAL::Unknown_user_id_error_2>(
      [&] {
        population.move(Frame{{20, Point(1, 1, 1)}, {5, Point(2, 1, 1)}});
      },
      "5");
  expect_refused<CGAL::Unknown_user_id_error_2>([&] { population.remove(5); }, "5");
  const std::vector<std::int64_t> same{10, 20, 10};
  expect_refused<CGAL::Repeated_id_error_2>([&] { population.remove(same); }, "10");
  expect_refused<CGAL::Unknown_user_id_error_2>([&] { population.point(-1); }, "-1");
  EXPECT_EQ(checkpoint_of(population), before);
}

// CHECKPOINTS -------------------------------------------------------------------------------------

TEST(Populations_in_space, go_on_from_checkpoints)
{
  Frames<Population> frames(8, 0);
  Population run;
  Crowd crowd;
  for (int i = 0; i < 90; ++i)
    crowd[frames.next_id()] = frames.anywhere();
  for (int frame = 0; frame < 30; ++frame) {
    Population other;
    std::stringstream file;
    file << run;
    ASSERT_TRUE(file >> other);
    frames.change(crowd, 5);
    run.update(crowd);
    other.update(crowd);
    ASSERT_EQ(checkpoint_of(run), checkpoint_of(other));
    ASSERT_NO_FATAL_FAILURE(expect_population(other, crowd));
    run = std::move(other);
  }
}

TEST(Populations_in_space, refuse_files_that_were_forged)
{
  Population original;
  for (const int i : {3, -8, 700, 4, 12})
    original.insert(i, Point(i, i * i % 7, i % 5));
  original.remove(4);
  const std::string text = checkpoint_of(original);
  Population target;
  target.insert(1, Point(1, 2, 3));
  const std::string before = checkpoint_of(target);
  const auto is_read = [&](const std::string& file) {
    std::istringstream in(file);
    return bool(in >> target);
  };
  for (std::size_t size = 0; size < text.size(); ++size)
    ASSERT_FALSE(is_read(text.substr(0, size)));
  ASSERT_FALSE(is_read(checkpoint_of(original.triangulation())));
  std::string same = text;
  same.replace(same.find(" 700\n"), 5, " -8\n");
  ASSERT_FALSE(is_read(resealed(same)));
  CGAL::Dynamic_population_3<Dynamic, signed char> narrow;
  std::istringstream in(text);
  EXPECT_FALSE(in >> narrow); // 700 does not fit
  ASSERT_EQ(checkpoint_of(target), before);
  Forger forger(text, 1);
  int accepted = 0;
  for (int i = 0; i < 2000; ++i) {
    Population read;
    std::istringstream forged(forger.forged());
    if (!(forged >> read))
      continue;
    ++accepted;
    Crowd crowd;
    for (std::size_t id = 0; id < read.triangulation().number_of_ids(); ++id)
      if (read.triangulation().has_id(id))
        crowd.emplace(read.user_id(id), read.triangulation().point(id));
    ASSERT_NO_FATAL_FAILURE(expect_population(read, crowd));
  }
  EXPECT_GT(accepted, 50);
}

// MEMORY ------------------------------------------------------------------------------------------

bool is_at(const Crowd& crowd, std::int64_t user_id, const Point& p)
{
  const auto found = crowd.find(user_id);
  return found != crowd.end() && found->second == p;
}

// Expects that nobody is lost or mistaken for somebody else.
void expect_between(const Population& population, const Crowd& before, const Crowd& after)
{
  const auto& dt = population.triangulation();
  std::size_t number = 0;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id)) {
      ++number;
      const std::int64_t user_id = population.user_id(id);
      ASSERT_TRUE(population.has(user_id)) << user_id;
      ASSERT_EQ(population.id(user_id), id);
      ASSERT_TRUE(is_at(before, user_id, dt.point(id)) || is_at(after, user_id, dt.point(id)))
          << "id " << user_id;
    }
  ASSERT_EQ(population.size(), number);
  ASSERT_EQ(dt.number_of_points(), number);
  for (const auto& [user_id, p] : before)
    ASSERT_TRUE(population.has(user_id) || after.count(user_id) == 0) << user_id << " is lost";
}

template <class Call>
long expect_survival(const Population& original, const Crowd& before, const Crowd& after,
                     const Call& call)
{
  for (long allocations = 0;; ++allocations) {
    SCOPED_TRACE(testing::Message() << allocations << " allocations");
    Population population = original;
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      call(population);
      return allocations;
    } catch (const std::bad_alloc&) {
    }
    expect_between(population, before, after);
    if (allocations % 2 == 0) {
      EXPECT_TRUE(population.mend().certified);
      EXPECT_TRUE(population.triangulation().is_valid(true));
    }
    population.update(after);
    expect_population(population, after);
    if (testing::Test::HasFailure())
      return allocations;
  }
}

TEST(Populations_in_space, survive_that_memory_runs_out)
{
  Frames<Population> frames(9, 0);
  for (const std::size_t size : {40u, 300u})
    for (const std::size_t changes : {3u, 30u}) {
      Crowd before;
      for (std::size_t i = 0; i < size; ++i)
        before[frames.next_id()] = frames.anywhere();
      before.begin()->second = before.rbegin()->second;
      Population population;
      population.update(before);
      Crowd after = before, more = before;
      for (auto& [user_id, p] : after)
        p = Point(p.x() + 0.03 * p.y(), p.y(), p.z());
      std::vector<std::int64_t> leaving;
      for (std::size_t n = 0; n < changes; ++n) {
        const auto some = std::next(after.begin(), std::ptrdiff_t(frames.below(after.size())));
        leaving.push_back(some->first);
        after.erase(some);
      }
      Crowd newcomers;
      for (std::size_t n = 0; n < changes; ++n)
        newcomers[frames.next_id()] = frames.anywhere();
      after.insert(newcomers.begin(), newcomers.end());
      more.insert(newcomers.begin(), newcomers.end());
      EXPECT_GT(expect_survival(population, before, after, [&](Population& p) { p.update(after); }),
                10);
      EXPECT_GT(
          expect_survival(population, before, more, [&](Population& p) { p.insert(newcomers); }),
          10);
      Crowd fewer = before;
      for (const std::int64_t id : leaving)
        fewer.erase(id);
      EXPECT_GT(
          expect_survival(population, before, fewer, [&](Population& p) { p.remove(leaving); }), 3);
    }
}

} // namespace test_space_population
