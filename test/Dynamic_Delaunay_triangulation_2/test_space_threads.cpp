// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Threads change nothing but the time: in space, too, checkpoints, which have every number, and
// reports are the same.

#define CGAL_DYNAMIC_DELAUNAY_POINTS_OF_PART 64

#include "sealed_checkpoint.h"
#include "space_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#ifdef CGAL_LINKED_WITH_TBB

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

// Calls `f` with some threads, which may be more than the machine has.
template <class Function>
void with_threads(int threads, const Function& f)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 16);
  tbb::task_arena(threads).execute(f);
}
template <class Function>
void with_threads(const Function& f)
{
  with_threads(4, f);
}

using Sequential_in_space = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick>;
using Parallel_in_space =
    CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick,
                                           CGAL::With_concurrency_2<CGAL::Parallel_tag>>;

auto all_of(const CGAL::Update_report_3& r)
{
  return std::tie(r.unproved, r.flips, r.held, r.relocated, r.inserted, r.removed, r.merged,
                  r.parted, r.rebuild_reason, r.certified);
}

template <class Kernel>
class Threads_in_space : public testing::Test
{
protected:
  using Point = typename Kernel::Point_3;
  using Points = std::vector<Point>;
  using Sequential = CGAL::Dynamic_Delaunay_triangulation_3<Kernel>;
  using Parallel =
      CGAL::Dynamic_Delaunay_triangulation_3<Kernel, CGAL::With_concurrency_2<CGAL::Parallel_tag>>;

  Points random_points(std::size_t number)
  {
    std::uniform_real_distribution<double> coordinate(0, 1);
    Points points;
    for (std::size_t i = 0; i < number; ++i) {
      const double x = coordinate(m_random), y = coordinate(m_random);
      points.emplace_back(x, y, coordinate(m_random));
    }
    return points;
  }

  Point shaken(const Point& p, double step)
  {
    std::normal_distribution<double> normal(0, step);
    const double x = CGAL::to_double(p.x()) + normal(m_random);
    const double y = CGAL::to_double(p.y()) + normal(m_random);
    return Point(x, y, CGAL::to_double(p.z()) + normal(m_random));
  }

  std::mt19937_64 m_random{1};
};

using Kernels = testing::Types<CGAL::Epick, CGAL::Epeck>;
TYPED_TEST_SUITE(Threads_in_space, Kernels);

TYPED_TEST(Threads_in_space, change_nothing_but_the_time)
{
  auto points = this->random_points(700);
  points[5] = points[600];
  typename TestFixture::Sequential alone(points);
  typename TestFixture::Parallel together;
  with_threads([&] { together.insert(points.begin(), points.end()); });
  for (const double step : {1e-6, 1e-3, 0.004, 0.01, 0.1, 1e-3}) {
    for (auto& p : points)
      p = this->shaken(p, step);
    const CGAL::Update_report_3 report = alone.update(points);
    CGAL::Update_report_3 other;
    with_threads([&] { other = together.update(points); });
    ASSERT_EQ(all_of(report), all_of(other));
    ASSERT_EQ(checkpoint_of(alone), checkpoint_of(together));
    with_threads([&] { EXPECT_TRUE(together.certify()); });
  }
}

// Points of many kinds: cells in ties, a vertex amid hundreds, points that coincide by the dozen,
// crowds that are far apart, and nearly all points on the hull.
std::map<std::string, std::vector<CGAL::Epick::Point_3>> points_of_many_kinds()
{
  using Point = CGAL::Epick::Point_3;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto around = [&](const Point& p, double size) {
    const double x = p.x() + size * normal(random), y = p.y() + size * normal(random);
    return Point(x, y, p.z() + size * normal(random));
  };
  std::map<std::string, std::vector<Point>> kinds;
  for (const int number : {4, 5, 20, 100, 500, 3000})
    for (int i = 0; i < number; ++i)
      kinds["random " + std::to_string(number)].push_back(around({0, 0, 0}, 1));
  for (int i = 0; i < 1000; ++i) {
    kinds["lattice"].emplace_back(i % 10, i / 10 % 10, i / 100);
    kinds["coincident"].emplace_back(i % 5, i / 5 % 5, i * i % 7);
    kinds["crowds"].push_back(around({i % 2 == 0 ? 1e9 : 0.0, 0, i % 3 == 0 ? 1e9 : 0.0}, 1e-3));
    const Point p = around({0, 0, 0}, 1);
    kinds["layers"].emplace_back(p.x(), p.y(), std::rint(p.z()));
    kinds["line"].emplace_back(0, i % 100 == 0 ? p.y() : 0, p.z());
    kinds["hull"].push_back(CGAL::ORIGIN +
                            (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length()));
    kinds["parabola"].emplace_back(i, i * i, i % 3 == 0 ? 1 : -i * i);
  }
  kinds["hull"].emplace_back(0.1, 0, 0);
  auto& pairs = kinds["pairs"];
  for (int i = 0; i < 3000; ++i)
    pairs.push_back(i % 3 == 2 ? pairs[random() % pairs.size()] : around({0, 0, 0}, 1));
  return kinds;
}

TEST(Construction_in_space, does_not_depend_on_threads)
{
  for (const auto& [kind, points] : points_of_many_kinds()) {
    SCOPED_TRACE(kind);
    const Sequential_in_space alone(points);
    EXPECT_TRUE(alone.is_valid());
    for (const int threads : {1, 2, 3, 4, 5, 8, 16})
      with_threads(threads, [&, &points = points] {
        const Parallel_in_space together(points);
        EXPECT_TRUE(checkpoint_of(alone) == checkpoint_of(together)) << threads << " threads";
      });
  }
}

// The same frames for triangulations without threads, and in 1, 2, 3 and 8 threads.
template <class Sequential, class Parallel>
class Compared
{
public:
  template <class... Arguments>
  explicit Compared(const Arguments&... arguments)
    : m_alone(arguments...)
    , m_together(4, Parallel(arguments...))
  {
  }

  template <class... Frame>
  CGAL::Update_report_3 update(const Frame&... frame)
  {
    const CGAL::Update_report_3 report = m_alone.update(frame...);
    const std::string checkpoint = checkpoint_of(m_alone);
    const int threads[] = {1, 2, 3, 8};
    for (std::size_t i = 0; i < m_together.size(); ++i) {
      CGAL::Update_report_3 other;
      with_threads(threads[i], [&] { other = m_together[i].update(frame...); });
      EXPECT_EQ(all_of(report), all_of(other)) << threads[i] << " threads";
      EXPECT_EQ(checkpoint, checkpoint_of(m_together[i])) << threads[i] << " threads";
    }
    return report;
  }

  bool is_valid() const
  {
    bool is = m_alone.is_valid();
    for (const Parallel& together : m_together)
      is = is && together.is_valid();
    return is;
  }

private:
  Sequential m_alone;
  std::vector<Parallel> m_together;
};

TYPED_TEST(Threads_in_space, change_nothing_in_rough_frames)
{
  using Place = typename TestFixture::Point;
  using Compared_here = Compared<typename TestFixture::Sequential, typename TestFixture::Parallel>;
  constexpr bool is_fast = std::is_same_v<TypeParam, CGAL::Epick>;
  const std::size_t number = is_fast ? 4000 : 1000;
  const double spacing = 1 / std::cbrt(double(number));
  for (const std::string kind : {"uniform", "jumps", "streams", "held"}) {
    SCOPED_TRACE(kind);
    auto points = this->random_points(number);
    Compared_here compared(points);
    std::size_t held = 0;
    for (const double step : {0.02, 0.05, 0.08}) {
      for (std::size_t i = 0; i < number; ++i) {
        Place& p = points[i];
        if (kind == "streams" && i % 2 == 0)
          p = Place(p.x() + typename TypeParam::FT(4 * step * spacing), p.y(), p.z());
        const bool is_restless = kind == "held" && i % 50 == 0;
        p = this->shaken(p, (is_restless ? 10 : 1) * step * spacing);
      }
      if (kind == "jumps")
        std::swap(points[7], points[number - 7]);
      held += compared.update(points).held;
    }
    EXPECT_GT(held, 0u);
    EXPECT_TRUE(compared.is_valid());
  }
}

// Ties everywhere, and flips of four cells to four.
TYPED_TEST(Threads_in_space, change_nothing_in_lattices)
{
  constexpr int side = std::is_same_v<TypeParam, CGAL::Epick> ? 16 : 8;
  typename TestFixture::Points points;
  for (int i = 0; i < side * side * side; ++i)
    points.emplace_back(i % side, i / side % side, i / side / side);
  const auto lattice = points;
  Compared<typename TestFixture::Sequential, typename TestFixture::Parallel> compared(points);
  std::uniform_int_distribution<int> coin(0, 9), eighths(-1, 1);
  for (int frame = 0; frame < 4; ++frame) {
    for (std::size_t i = 0; i < points.size(); ++i) // some go an eighth of the way to a neighbor
      if (coin(this->m_random) == 0)
        points[i] = lattice[i] + typename TypeParam::Vector_3(eighths(this->m_random) / 8.0,
                                                              eighths(this->m_random) / 8.0, 0);
    compared.update(points);
  }
  compared.update(lattice);
  EXPECT_TRUE(compared.is_valid());
}

TYPED_TEST(Threads_in_space, change_nothing_in_populations)
{
  using Place = typename TestFixture::Point;
  CGAL::Dynamic_population_3<typename TestFixture::Sequential> alone;
  CGAL::Dynamic_population_3<typename TestFixture::Parallel> together;
  std::map<std::int64_t, Place> crowd;
  std::int64_t next = 0;
  for (const Place& p : this->random_points(500))
    crowd[next++] = p;
  for (int frame = 0; frame < 5; ++frame) {
    for (auto& [id, p] : crowd)
      p = this->shaken(p, 0.002);
    for (const Place& p : this->random_points(4)) {
      crowd.erase(crowd.begin());
      crowd[next++] = p;
    }
    const CGAL::Update_report_3 report = alone.update(crowd);
    CGAL::Update_report_3 other;
    with_threads([&] { other = together.update(crowd); });
    ASSERT_EQ(all_of(report), all_of(other));
    ASSERT_EQ(checkpoint_of(alone), checkpoint_of(together));
  }
}

TYPED_TEST(Threads_in_space, throw_the_same)
{
  auto points = this->random_points(700);
  typename TestFixture::Parallel together(points);
  const std::string before = checkpoint_of(together);
  points[300] = points[650] = typename TestFixture::Point(
      typename TypeParam::FT(1e300) * typename TypeParam::FT(1e300), 0, 0);
  with_threads([&] {
    try {
      together.update(points);
      FAIL() << "nothing is thrown";
    } catch (const CGAL::Non_finite_coordinate_error_3& error) {
      EXPECT_EQ(error.id(), 300u);
    }
  });
  EXPECT_EQ(checkpoint_of(together), before);
}

class Threads_in_periodic_space : public testing::Test
{
protected:
  using Sequential = CGAL::Dynamic_periodic_Delaunay_triangulation_3<CGAL::Epick>;
  using Parallel =
      CGAL::Dynamic_periodic_Delaunay_triangulation_3<CGAL::Epick,
                                                      CGAL::With_concurrency_2<CGAL::Parallel_tag>>;
  using Point = Sequential::Point;
};

// Cells that shear, shrink and are flipped, points that are wrapped, come and go, and coincide.
TEST_F(Threads_in_periodic_space, change_nothing_but_the_time)
{
  const CGAL::Periodic_cell_3 unit(1, 1, 1);
  CGAL::Dynamic_population_3<Sequential> alone{Sequential(unit)};
  CGAL::Dynamic_population_3<Parallel> together{Parallel(unit)};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  const auto random_point = [&] {
    const double x = coordinate(random), y = coordinate(random);
    return Point(x, y, coordinate(random));
  };
  std::map<std::int64_t, Point> crowd;
  std::int64_t next = 0;
  while (next < 600)
    crowd[next++] = random_point();
  double shear = 0;
  for (const double step : {1e-6, 1e-3, 0.004, 0.01, 0.1, 1e-3}) {
    std::normal_distribution<double> normal(0, step);
    for (auto& [id, p] : crowd) {
      const double x = p.x() + normal(random), y = p.y() + normal(random);
      p = Point(x, y, p.z() + normal(random) + double(id % 3));
    }
    crowd.erase(crowd.begin());
    crowd[next++] = random_point();
    crowd[next++] = crowd.rbegin()->second;
    shear += 0.2;
    const CGAL::Periodic_cell_3 cell({1, 0, 0}, {shear - std::rint(shear), 1 - shear / 8, 0},
                                     {0, 0, 1});
    const CGAL::Update_report_3 report = alone.update(crowd, cell);
    CGAL::Update_report_3 other;
    with_threads([&] { other = together.update(crowd, cell); });
    ASSERT_EQ(all_of(report), all_of(other));
    ASSERT_EQ(checkpoint_of(alone), checkpoint_of(together));
    with_threads([&] { EXPECT_TRUE(together.certify()); });
  }
}

// Points of many kinds in fractions of a cell: cells in ties, crowds, layers, walls, points that
// coincide by the dozen, also as images of each other, and so few that their images are neighbors.
std::map<std::string, std::vector<std::array<double, 3>>> fractions_of_many_kinds()
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> anywhere(0, 1);
  std::normal_distribution<double> normal;
  const auto random_place = [&] {
    const double x = anywhere(random), y = anywhere(random);
    return std::array<double, 3>{x, y, anywhere(random)};
  };
  std::map<std::string, std::vector<std::array<double, 3>>> kinds;
  for (const int number : {1, 2, 3, 5, 8, 20, 100, 2000})
    for (int i = 0; i < number; ++i)
      kinds["random " + std::to_string(number)].push_back(random_place());
  auto& copies = kinds["copies"];
  for (int i = 0; i < 2000; ++i)
    copies.push_back(i > 8 && i % 4 != 0 ? copies[random() % copies.size()] : random_place());
  for (int i = 0; i < 1000; ++i) {
    const auto [x, y, z] = random_place();
    kinds["lattice"].push_back({i % 10 / 10.0, i / 10 % 10 / 10.0, i / 100 / 10.0});
    kinds["images"].push_back({i % 8 / 8.0 + double(random() % 3), i / 8 % 8 / 8.0, i / 64 / 8.0});
    kinds["layers"].push_back({x, y, std::rint(3 * z) / 4});
    kinds["crowd"].push_back({0.5 + 0.01 * normal(random), 0.3 + 0.01 * normal(random), z});
    kinds["few planes"].push_back(
        {std::rint(8 * x) / 8 + 1e-15 * (i % 3), std::rint(8 * y) / 8, z});
  }
  return kinds;
}

TEST_F(Threads_in_periodic_space, construct_the_same)
{
  const CGAL::Periodic_cell_3 cells[] = {{1, 1, 1},
                                         {1, 2, 0.7},
                                         {1, 1, 0.02},
                                         {{0.3, 0, 0}, {0.09, 0.3, 0}, {0.06, 0.12, 0.36}},
                                         {{1, 0, 0}, {0.4, 1.1, 0}},
                                         CGAL::Periodic_cell_3{std::array<double, 3>{0, 0, 1}}};
  for (const auto& [kind, fractions] : fractions_of_many_kinds())
    for (const CGAL::Periodic_cell_3& cell : cells) {
      SCOPED_TRACE(kind + ", " + std::to_string(&cell - cells));
      const std::size_t most = cell.is_wire() ? 200 : cell.is_slab() ? 1000 : fractions.size();
      std::vector<Point> points;
      for (std::size_t i = 0; i < (std::min)(most, fractions.size()); ++i) {
        const auto along = [&, &f = fractions[i]](std::size_t axis) {
          return f[0] * cell.vector(0)[axis] + f[1] * cell.vector(1)[axis] +
                 f[2] * cell.vector(2)[axis];
        };
        points.emplace_back(along(0), along(1), along(2));
      }
      const Sequential alone(points.begin(), points.end(), cell);
      EXPECT_TRUE(points.size() <= 200 ? alone.is_valid() : alone.is_certified());
      for (const int threads : {1, 2, 3, 8})
        with_threads(threads, [&, &cell = cell] {
          const Parallel together(points.begin(), points.end(), cell);
          EXPECT_TRUE(checkpoint_of(alone) == checkpoint_of(together)) << threads << " threads";
        });
    }
}

// Rough frames, in a cube and in a slab.
TEST_F(Threads_in_periodic_space, change_nothing_in_rough_frames)
{
  for (const CGAL::Periodic_cell_3& cell :
       {CGAL::Periodic_cell_3(1, 1, 1), CGAL::Periodic_cell_3({1, 0, 0}, {0, 1, 0})}) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(0, 1);
    std::vector<Point> points;
    for (int i = 0; i < 2000; ++i) {
      const double x = coordinate(random), y = coordinate(random);
      points.emplace_back(x, y, coordinate(random));
    }
    Compared<Sequential, Parallel> compared(points, cell);
    for (const double step : {0.001, 0.003, 0.006}) {
      std::normal_distribution<double> normal(0, step);
      for (Point& p : points) {
        const double x = p.x() + normal(random), y = p.y() + normal(random);
        p = Point(x, y, p.z() + normal(random));
      }
      compared.update(points);
    }
    EXPECT_TRUE(compared.is_valid());
  }
}

// Calm frames in a slab and in a duct, a third of whose points slide along the walls.
TEST_F(Threads_in_periodic_space, change_nothing_in_calm_frames_at_walls)
{
  using Cell = CGAL::Periodic_cell_3;
  for (const Cell& cell : {Cell({1, 0, 0}, {0, 1, 0}), Cell(Cell::Coordinates{1, 0, 0})}) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(0, 1);
    std::normal_distribution<double> normal(0, 1e-5);
    const auto on_wall = [&](std::size_t i, double y, double z) {
      const bool is_across_z = cell.is_slab() || i % 2 == 0;
      return i % 3 != 0    ? std::pair(y, z)
             : is_across_z ? std::pair(y, std::rint(z))
                           : std::pair(std::rint(y), z);
    };
    std::vector<Point> points;
    for (std::size_t i = 0; i < 1500; ++i) {
      const double x = coordinate(random), a = coordinate(random);
      const auto [y, z] = on_wall(i, a, coordinate(random));
      points.emplace_back(x, y, z);
    }
    Compared<Sequential, Parallel> compared(points, cell);
    for (int frame = 0; frame < 30; ++frame) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Point p = points[i];
        const double x = p.x() + normal(random), a = p.y() + normal(random);
        const auto [y, z] = on_wall(i, a, p.z() + normal(random));
        points[i] = Point(x, y, z);
      }
      compared.update(points);
    }
    EXPECT_TRUE(compared.is_valid());
  }
}

} // namespace

#else

TEST(Threads_in_space, need_TBB)
{
  GTEST_SKIP() << "compiled without TBB, so there are no threads";
}

#endif
