// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A triangulation that was written and read goes on as the original does; a file that is no
// checkpoint of one is refused and changes nothing. `Checkpoints_in` says so in every space.

#include "forged_checkpoint.h"
#include "oracle.h"
#include "periodic_oracle.h"
#include "replaced_heap.h"
#include "sealed_checkpoint.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Hybrid_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/IO/io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ios>
#include <limits>
#include <new>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_checkpoint {

using CGAL::Checkpoint_error_2;
using Cell = CGAL::Periodic_cell_2;
using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
using Population = CGAL::Dynamic_population_2<Exact>;
using Periodic_population = CGAL::Dynamic_population_2<Periodic>;
using Point = Epick::Point_2;
using Points = std::vector<Point>;

// SPACES ------------------------------------------------------------------------------------------

template <class Kernel_>
struct Plane
{
  using Kernel = Kernel_;
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

  static Dynamic of(const std::vector<typename Kernel::Point_2>& points) { return Dynamic(points); }
};

struct Torus
{
  using Kernel = Epick;
  using Dynamic = Periodic;

  static double side(std::size_t points) { return std::ceil(std::sqrt(1. + double(points))); }
  static Dynamic of(const Points& points)
  {
    const double s = side(points.size());
    return Dynamic(points, Cell(s, 0, 1, s));
  }
};

struct Slab : Torus
{
  static Dynamic of(const Points& points)
  {
    return Dynamic(points, Cell::slab(side(points.size()), 1));
  }
};

template <class Dynamic>
constexpr bool is_periodic = decltype(std::declval<const Dynamic&>().frame())::is_periodic;

template <class Dynamic>
Dynamic empty()
{
  if constexpr (is_periodic<Dynamic>)
    return Dynamic(Cell(1, 1));
  else
    return {};
}

// A small triangulation whose checkpoint has everything that a file can have.
template <class Space>
typename Space::Dynamic specimen()
{
  auto points = Cloud<typename Space::Kernel>(17).uniform(9);
  points[4] = points[2];
  auto dt = Space::of(points);
  dt.remove(6);
  return dt;
}

template <class Space>
typename Space::Dynamic other_one()
{
  return Space::of(Cloud<typename Space::Kernel>(18).uniform(30));
}

template <class Dynamic>
void expect_certified_and_exact(const Dynamic& dt)
{
  if constexpr (is_periodic<Dynamic>)
    expect_periodic_delaunay(dt);
  else
    expect_exact(dt, model_of(dt));
}

// The cell a little sheared and stretched.
Cell sheared(const Cell& cell)
{
  return cell.is_slab() ? Cell::slab(cell.ax() * 1.02, cell.ay())
                        : Cell(cell.ax() * 1.02, cell.ay(), cell.bx() + 0.1, cell.by() * 0.99);
}

// FILES -------------------------------------------------------------------------------------------

template <class Read>
void read(Read& target, const std::string& text)
{
  std::istringstream in(text);
  target.read_checkpoint(in);
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t place = text.find(what);
  EXPECT_NE(place, text.npos) << what;
  return resealed(text.replace(place, what.size(), by));
}

// The error with which the text is refused; an error of line 0 if it is accepted.
template <class Read>
Checkpoint_error_2 refusal(Read& target, const std::string& text)
{
  try {
    read(target, text);
  } catch (const Checkpoint_error_2& error) {
    return error;
  }
  return Checkpoint_error_2(0, "accepted");
}

// Where a file is refused, which leaves the triangulation empty; 0 if it is not.
template <class Dynamic>
std::size_t line_of_refusal(const std::string& text, Dynamic&& dt = empty<Dynamic>())
{
  const std::size_t line = refusal(dt, text).line();
  EXPECT_TRUE(line == 0 || dt.number_of_points() == 0);
  return line;
}

template <class Dynamic>
std::string reason(const std::string& text)
{
  auto dt = empty<Dynamic>();
  return refusal(dt, text).what();
}

auto all_of(const CGAL::Update_report_2& r)
{
  return std::tie(r.classified, r.padded, r.border, r.flips, r.splices, r.spliced, r.enlargements,
                  r.relocated, r.inserted, r.removed, r.merged, r.parted, r.rebuild_reason,
                  r.certified);
}

std::string line_below(const std::string& text, const std::string& name)
{
  const std::size_t begin = text.find('\n', text.find('\n' + name + ' ') + 1) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

template <class Dynamic>
Dynamic restored(const Dynamic& original)
{
  auto copy = empty<Dynamic>();
  read(copy, checkpoint_of(original));
  return copy;
}

template <class Part>
void append(std::vector<std::int64_t>& numbers, const Part& part)
{
  if constexpr (std::is_convertible_v<const Part&, std::int64_t>)
    numbers.push_back(std::int64_t(part));
  else
    for (const auto& number : part)
      append(numbers, number);
}

// All that a triangulation says about its faces, edges and neighbors, in its order.
template <class Dynamic>
std::vector<std::int64_t> told_by(const Dynamic& dt)
{
  std::vector<std::int64_t> told;
  const auto tell = [&](const auto&... parts) { (append(told, parts), ...); };
  const auto frame = dt.frame();
  for (unsigned f = 0; f < frame.number_of_faces(); ++f)
    tell(frame.face(typename Dynamic::Frame::Face_index(f)));
  tell(-1);
  dt.for_each_face(tell);
  tell(-1);
  dt.for_each_edge(tell);
  tell(-1);
  if constexpr (is_periodic<Dynamic>)
    dt.for_each_boundary_edge(tell);
  else
    tell(dt.tds().dimension());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id)) {
      tell(-1, id, dt.representative(id), unsigned(frame.vertex(id)));
      dt.for_each_neighbor(id, tell);
    }
  return told;
}

template <class Dynamic>
void expect_equal(const Dynamic& dt, const Dynamic& other)
{
  ASSERT_TRUE(other.is_valid(true));
  ASSERT_EQ(dt.is_certified(), other.is_certified());
  ASSERT_EQ(dt.number_of_ids(), other.number_of_ids());
  ASSERT_EQ(dt.number_of_vertices(), other.number_of_vertices());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    ASSERT_EQ(dt.has_id(id), other.has_id(id));
    if (dt.has_id(id)) {
      ASSERT_EQ(dt.point(id), other.point(id));
    }
  }
  ASSERT_EQ(told_by(dt), told_by(other));
  if constexpr (is_periodic<Dynamic>) {
    ASSERT_TRUE(dt.cell() == other.cell());
  }
}

// RUNS THAT ARE INTERRUPTED -----------------------------------------------------------------------

// Random calls, equal for both: whole frames, points that come, go, move, or meet; in periodic
// space also points that are given by other images, and cells that change.
template <class Dynamic>
class Common_future
{
  using Kernel = typename Dynamic::Geom_traits;
  using Point = typename Dynamic::Point;

public:
  Common_future(unsigned seed, double step, std::size_t most = 1000)
    : m_cloud(seed)
    , m_step(step)
    , m_most(most)
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
        points[id] = image(dt, m_cloud.shifted(dt.point(id), m_step));
    if (below(4) == 0 && !ids_of(dt).empty())
      points[any_id(dt)] = points[any_id(dt)];
    if constexpr (is_periodic<Dynamic>) {
      const Cell cell = next_cell(dt.cell());
      both(dt, other, [&](Dynamic& t) { return t.update(points, cell); });
    } else {
      both(dt, other, [&](Dynamic& t) { return t.update(points); });
    }
  }

  void any_call(Dynamic& dt, Dynamic& other)
  {
    const std::size_t kind = dt.number_of_points() > 0 ? below(6) : 0;
    if (kind == 0 && dt.number_of_points() < m_most) {
      const auto points = m_cloud.uniform(1 + below(3));
      std::vector<std::size_t> ids;
      both(dt, other, [&](Dynamic& t) { return t.insert(points, std::back_inserter(ids)); });
    } else if (kind < 2) {
      const std::size_t id = any_id(dt);
      both(dt, other, [&](Dynamic& t) { return t.remove(id); });
    } else if (kind == 2) {
      const std::pair<std::size_t, Point> mover(any_id(dt), image(dt, dt.point(any_id(dt))));
      both(dt, other, [&](Dynamic& t) { return t.move(&mover, &mover + 1); });
    } else if (kind == 3) {
      const std::size_t id = any_id(dt);
      const Point p = m_cloud.shifted(dt.point(id), 10 * m_step);
      both(dt, other, [&](Dynamic& t) { return t.move(id, p); });
    } else {
      frame(dt, other);
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

  // The point, or in periodic space now and then one of its next images.
  Point image(const Dynamic& dt, const Point& p)
  {
    if constexpr (is_periodic<Dynamic>) {
      const Cell& cell = dt.cell();
      if (below(5) == 0) {
        const int i = int(below(3)) - 1, j = cell.is_slab() ? 0 : int(below(3)) - 1;
        return Point(p.x() + i * cell.ax() + j * cell.bx(), p.y() + i * cell.ay() + j * cell.by());
      }
    }
    return p;
  }

  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_cloud.random());
  }

  // The same cell, one that is a little different, or any other one of about its size.
  Cell next_cell(const Cell& cell)
  {
    if (below(3) > 0)
      return cell;
    if (below(4) > 0)
      return sheared(cell);
    if (cell.is_slab())
      return Cell::slab(cell.ax() * between(-1.3, -0.7), between(-1, 1));
    const double side = std::sqrt(std::abs(cell.ax() * cell.by() - cell.ay() * cell.bx()));
    return Cell(side, side * between(-0.3, 0.3), side * between(-1.3, 1.3),
                side * between(0.6, 1.6));
  }

  Cloud<Kernel> m_cloud;
  double m_step;
  std::size_t m_most;
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

template <class Space>
struct Checkpoints_in : testing::Test
{
  using Kernel = typename Space::Kernel;
  using Dynamic = typename Space::Dynamic;
  using Population = CGAL::Dynamic_population_2<Dynamic>;
  using Point = typename Kernel::Point_2;

  static Dynamic uniform(unsigned seed, std::size_t n)
  {
    return Space::of(Cloud<Kernel>(seed).uniform(n));
  }
};
using Spaces = testing::Types<Plane<Epick>, Plane<Epeck>, Torus, Slab>;
TYPED_TEST_SUITE(Checkpoints_in, Spaces);

TYPED_TEST(Checkpoints_in, a_run_goes_on_as_if_it_had_not_been_interrupted)
{
  for (const double step : {0.003, 0.05, 0.5})
    expect_to_go_on_at_every_stage(this->uniform(1, 120), 1, step);
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    auto run = this->uniform(seed, seed % 12), interrupted = restored(run);
    Common_future<typename TestFixture::Dynamic> future(seed, seed % 2 == 0 ? 0.05 : 0.5, 12);
    for (int call = 0; call < 150; ++call) {
      if (future.below(3) == 0)
        interrupted = restored(interrupted);
      ASSERT_NO_FATAL_FAILURE(future.any_call(run, interrupted)) << "call " << call;
    }
    ASSERT_EQ(checkpoint_of(run), checkpoint_of(interrupted));
  }
}

TYPED_TEST(Checkpoints_in, ties_are_broken_as_they_would_have_been)
{
  auto points = Cloud<typename TypeParam::Kernel>::grid(8, 7);
  auto dt = TypeParam::of(points);
  Common_future<decltype(dt)> past(2, 0.2);
  auto other = restored(dt);
  for (int frame = 0; frame < 5; ++frame)
    past.frame(dt, other);
  const auto back = [&](auto& t) { return t.update(points); };
  past.both(dt, other, back);
  other = restored(dt);
  points = scaled<typename TypeParam::Kernel>(points, 2);
  past.both(dt, other, back); // whichever diagonals were there still are
  expect_to_go_on(dt, 2, 0.02);
}

TYPED_TEST(Checkpoints_in, points_that_coincide_keep_their_representative)
{
  auto points = Cloud<typename TypeParam::Kernel>(3).uniform(60);
  points[7] = points[3];
  points[59] = points[3];
  points[20] = points[40];
  auto dt = TypeParam::of(points);
  dt.remove(3);
  ASSERT_LT(dt.number_of_vertices(), dt.number_of_points());
  expect_to_go_on_at_every_stage(std::move(dt), 3, 0.05);
}

TYPED_TEST(Checkpoints_in, the_smallest_free_id_is_given_next)
{
  auto dt = this->uniform(4, 60);
  for (const std::size_t id : {31u, 4u, 59u, 17u})
    dt.remove(id);
  auto other = restored(dt);
  EXPECT_EQ(other.number_of_ids(), 60u);
  EXPECT_FALSE(other.has_id(17));
  expect_common_future(dt, other, 4);
}

TYPED_TEST(Checkpoints_in, no_point_one_and_two_and_points_on_a_line_are_kept)
{
  Cloud<typename TypeParam::Kernel> cloud(5);
  for (std::size_t n = 0; n < 4; ++n) {
    SCOPED_TRACE(testing::Message() << n << " points");
    auto few = TypeParam::of(cloud.uniform(n));
    expect_to_go_on(few, unsigned(n));
    auto line = TypeParam::of(cloud.on_line(10 * n));
    expect_to_go_on(line, unsigned(n));
    auto one_place = TypeParam::of(std::vector<typename TestFixture::Point>(n, {1, 2}));
    expect_to_go_on(one_place, unsigned(n));
  }
}

TYPED_TEST(Checkpoints_in, all_points_may_have_gone)
{
  auto dt = this->uniform(6, 5);
  for (std::size_t id = 0; id < 5; ++id)
    dt.remove(id);
  expect_to_go_on(dt, 6);
}

TYPED_TEST(Checkpoints_in, a_file_replaces_whatever_is_there)
{
  auto dt = this->uniform(7, 50);
  for (const std::size_t n : {0u, 1u, 20u, 200u}) {
    auto other = this->uniform(8, n);
    other.mend();
    read(other, checkpoint_of(dt));
    ASSERT_NO_FATAL_FAILURE(expect_equal(dt, other));
    ASSERT_EQ(checkpoint_of(dt), checkpoint_of(other));
  }
}

// The uninterrupted run skips edges that it has proved safe; the other one has to prove them first.
TYPED_TEST(Checkpoints_in, edges_that_are_skipped_make_no_difference)
{
  Cloud<typename TypeParam::Kernel> cloud(9);
  auto points = cloud.uniform(400);
  auto run = TypeParam::of(points), interrupted = restored(run);
  std::size_t flips = 0;
  for (int frame = 0; frame < 100; ++frame) {
    if (frame % 40 == 30)
      interrupted = restored(interrupted);
    cloud.shake(points, 1e-3);
    const CGAL::Update_report_2 report = run.update(points);
    ASSERT_EQ(all_of(interrupted.update(points)), all_of(report));
    ASSERT_EQ(told_by(run), told_by(interrupted));
    flips += report.flips;
  }
  EXPECT_GT(flips, 10u);
  ASSERT_EQ(checkpoint_of(run), checkpoint_of(interrupted));
}

// After memory runs out, the next update must mend the original and the one read from a checkpoint
// alike. Returns how many checkpoints were written, and how many were refused.
template <class Space>
std::pair<int, int> run_out_of_memory(bool first_two_part)
{
  Cloud<typename Space::Kernel> cloud(5);
  auto points = cloud.uniform(30);
  points[1] = points[0];
  auto next = points;
  cloud.shake(next, 0.3);
  if (!first_two_part)
    next[1] = next[0];
  next[2] = points[3];
  int kept = 0, not_written = 0;
  bool is_done = false;
  for (long allocations = 0; !is_done; ++allocations) {
    auto dt = Space::of(points);
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      dt.update(next);
      is_done = true;
    } catch (const std::bad_alloc&) {
    }
    if (dt.is_certified())
      continue;
    std::ostringstream out, other_out;
    try {
      dt.write_checkpoint(out);
      ++kept;
    } catch (const Checkpoint_error_2& error) {
      EXPECT_EQ(error.line(), 0u);
      EXPECT_FALSE(other_out << dt);
      EXPECT_EQ(out.str() + other_out.str(), "");
      ++not_written;
      continue;
    }
    auto other = restored(dt);
    EXPECT_FALSE(other.is_certified());
    EXPECT_EQ(all_of(dt.update(next)), all_of(other.update(next)));
    expect_equal(dt, other);
  }
  return {kept, not_written};
}

TYPED_TEST(Checkpoints_in, what_an_exception_has_left_is_kept_or_not_written)
{
  EXPECT_GT(run_out_of_memory<TypeParam>(false).first, 0);
  EXPECT_GT(run_out_of_memory<TypeParam>(true).second, 0); // a point has no vertex of its own yet
}

TYPED_TEST(Checkpoints_in, a_population_goes_on_with_the_ids_of_its_user)
{
  using Crowd = std::vector<std::pair<std::int64_t, typename TestFixture::Point>>;
  using Its_population = typename TestFixture::Population;
  Cloud<typename TypeParam::Kernel> cloud(16);
  Crowd crowd;
  std::int64_t next_id = -20;
  const auto change = [&] {
    for (auto& [id, p] : crowd)
      p = cloud.shifted(p, 0.05);
    for (int i = 0; i < 3 && !crowd.empty(); ++i)
      crowd.erase(crowd.begin() + std::ptrdiff_t(cloud.random()() % crowd.size()));
    for (const auto& p : cloud.uniform(5))
      crowd.emplace_back(next_id++ * 1000000007, p);
    crowd.back().second = crowd.front().second;
  };
  const auto update = [&](Its_population& population) {
    if constexpr (is_periodic<typename TypeParam::Dynamic>)
      return population.update(crowd, sheared(population.triangulation().cell()));
    else
      return population.update(crowd);
  };
  Its_population population(this->uniform(0, 0));
  for (int stage = 0; stage < 5; ++stage) {
    Its_population other(empty<typename TypeParam::Dynamic>());
    std::stringstream file;
    file << population;
    file >> other;
    for (int frame = 0; frame < 10; ++frame) {
      change();
      ASSERT_EQ(all_of(update(population)), all_of(update(other)));
      ASSERT_NO_FATAL_FAILURE(expect_equal(population.triangulation(), other.triangulation()));
      ASSERT_EQ(other.size(), crowd.size());
      for (const auto& [id, p] : crowd)
        ASSERT_EQ(other.point(id), p);
    }
    ASSERT_EQ(checkpoint_of(population), checkpoint_of(other));
  }
}

// FILES THAT ARE REFUSED IN EVERY SPACE -----------------------------------------------------------

// The state of the stream after a failing read, which must leave the target unchanged.
template <class Read>
std::ios_base::iostate state_after_reading(Read& target, const std::string& text)
{
  const std::string before = checkpoint_of(target);
  std::istringstream in(text);
  in >> target;
  EXPECT_EQ(checkpoint_of(target), before);
  return in.rdstate();
}

template <class Read>
void expect_nothing_to_change_without_memory(Read& target, const std::string& text)
{
  const std::string before = checkpoint_of(target);
  bool is_read = false;
  for (long allocations = 0; !is_read; ++allocations) {
    std::istringstream in(text);
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      target.read_checkpoint(in);
      is_read = true;
    } catch (const std::bad_alloc&) {
    } catch (const Checkpoint_error_2&) { // the stream has caught the std::bad_alloc
    }
    ASSERT_EQ(checkpoint_of(target), is_read ? text : before);
  }
}

// What is not refused of forged files goes on as a copy of it does.
template <class Dynamic>
void expect_forgeries_to_be_harmless(const std::string& original, unsigned seed, int number)
{
  Forger forger(original, seed);
  int accepted = 0;
  for (int i = 0; i < number; ++i) {
    const std::string text = forger.forged();
    auto dt = empty<Dynamic>();
    if (refusal(dt, text).line() > 0) {
      ASSERT_EQ(dt.number_of_points(), 0u);
      continue;
    }
    ++accepted;
    ASSERT_TRUE(dt.is_valid(true));
    ASSERT_NO_FATAL_FAILURE(expect_to_go_on(dt, unsigned(i), 0.05, 5)) << text;
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, number);
}

// The line of the vertex of point 0, which is the only point there.
std::string vertex_line(const std::string& text)
{
  const std::size_t begin = text.find("\n0 ", text.find("\nvertices"));
  return text.substr(begin, text.find('\n', begin + 1) + 1 - begin);
}

template <class Space>
class Checkpoint_files : public testing::Test
{
protected:
  static std::string text() { return checkpoint_of(specimen<Space>()); }

  // One triangulation refuses all files of a test.
  std::size_t line_of_refusal(const std::string& text)
  {
    return test_checkpoint::line_of_refusal(text, m_dt);
  }

private:
  typename Space::Dynamic m_dt = empty<typename Space::Dynamic>();
};
using Spaces_of_files = testing::Types<Plane<Epick>, Torus, Slab>;
TYPED_TEST_SUITE(Checkpoint_files, Spaces_of_files);

TYPED_TEST(Checkpoint_files, that_are_cut_off_anywhere_are_refused)
{
  const std::string text = this->text();
  for (std::size_t size = 0; size < text.size(); ++size)
    ASSERT_GT(this->line_of_refusal(text.substr(0, size)), 0u) << size;
}

TYPED_TEST(Checkpoint_files, with_any_byte_changed_or_missing_are_refused)
{
  const std::string text = this->text();
  for (std::size_t place = 0; place < text.size(); ++place) {
    for (const char c : {'0', '1', '7', ' ', '\n', '-', '.', 'e', 'x', '\0', '\xff'}) {
      std::string edited = text;
      edited[place] = c;
      if (edited != text) {
        ASSERT_GT(this->line_of_refusal(edited), 0u) << place << " " << int(c);
      }
    }
    std::string shorter = text;
    shorter.erase(place, 1);
    ASSERT_GT(this->line_of_refusal(shorter), 0u) << place;
  }
}

TYPED_TEST(Checkpoint_files, that_announce_much_need_no_memory)
{
  const std::string text = this->text();
  for (const char* announced : {"700000000", "4000000000", "1000000000000000000",
                                "99999999999999999999999999", "-1", "715827882"})
    for (const char* name :
         {"ids", "vertices", "duplicates", "free_ids", "faces", "corners", "edges"}) {
      const std::size_t place = text.find(std::string(1, '\n') + name + ' ') + 1;
      std::string edited = text;
      edited.replace(place, text.find('\n', place) - place, std::string(name) + ' ' + announced);
      edited = resealed(edited);
      replaced_heap::largest_allocation = 0;
      ASSERT_GT(this->line_of_refusal(edited), 0u) << name << " " << announced;
      EXPECT_LT(replaced_heap::largest_allocation, 100000u) << name << " " << announced;
    }
}

TYPED_TEST(Checkpoint_files, change_nothing_if_they_are_refused)
{
  const std::string text = this->text();
  auto dt = other_one<TypeParam>();
  for (std::size_t size = 0; size < text.size(); size += 7)
    ASSERT_TRUE(state_after_reading(dt, text.substr(0, size)) & std::ios::failbit) << size;
  EXPECT_EQ(state_after_reading(dt, "garbage\n" + text), std::ios::failbit);
  expect_to_go_on(dt, 18);
}

TYPED_TEST(Checkpoint_files, change_nothing_if_memory_runs_out)
{
  auto dt = other_one<TypeParam>();
  expect_nothing_to_change_without_memory(dt, this->text());
  EXPECT_TRUE(dt.is_valid());
}

TYPED_TEST(Checkpoint_files, say_where_a_disk_is_full)
{
  const auto dt = specimen<TypeParam>();
  const std::size_t size = checkpoint_of(dt).size();
  for (std::size_t bytes = 0; bytes <= size; ++bytes) {
    Full_disk disk(bytes), other_disk(bytes);
    std::ostream out(&disk), other_out(&other_disk);
    if (bytes < size) {
      ASSERT_THROW(dt.write_checkpoint(out), CGAL::Checkpoint_error_2) << bytes;
    } else {
      EXPECT_NO_THROW(dt.write_checkpoint(out));
    }
    other_out << dt;
    ASSERT_EQ(other_out.fail(), bytes < size) << bytes;
  }
}

TYPED_TEST(Checkpoint_files, say_nothing_false_about_certificates)
{
  const std::string text = this->text();
  const std::string moved = replaced(text, vertex_line(text), "\n0 100 200\n");
  EXPECT_EQ(this->line_of_refusal(moved), 4u);
  // points may be anywhere in a triangulation that is not certified
  auto dt = empty<typename TypeParam::Dynamic>();
  read(dt, replaced(moved, "certified yes", "certified no"));
  EXPECT_FALSE(dt.is_certified());
  EXPECT_EQ(dt.point(0), Point(100, 200));
  EXPECT_TRUE(dt.is_valid()); // as one that is not certified
  EXPECT_FALSE(dt.certify());
  EXPECT_TRUE(dt.mend().certified);
  expect_certified_and_exact(dt);
}

TYPED_TEST(Checkpoint_files, that_are_forged_are_refused_or_harmless)
{
  const std::string text = this->text();
  using Dynamic = typename TypeParam::Dynamic;
  expect_forgeries_to_be_harmless<Dynamic>(text, 0, 4000);
  expect_forgeries_to_be_harmless<Dynamic>(replaced(text, "certified yes", "certified no"), 1,
                                           4000);
}

TEST(Checkpoint_refusals, say_where_and_why)
{
  const std::string plane = checkpoint_of(specimen<Plane<Epick>>()),
                    torus = checkpoint_of(specimen<Torus>());
  EXPECT_EQ(reason<Exact>(replaced(plane, "certified yes", "certified maybe")),
            "checkpoint, line 4: certified is \"maybe\", and has to be yes or no");
  EXPECT_EQ(reason<Periodic>(replaced(torus, "certified yes", "certified maybe")),
            "checkpoint, line 4: certified is \"maybe\", and has to be yes or no");
  EXPECT_EQ(reason<Exact>(replaced(plane, "double", "rational")),
            "checkpoint, line 2: the coordinates are of the kind \"rational\", and those of the "
            "triangulation's points of the kind \"double\"");
  EXPECT_EQ(reason<Periodic>(replaced(torus, "slab no", "slab yes")),
            "checkpoint, line 3: \"1 4\" is too much in this line");
  EXPECT_EQ(reason<Periodic>(replaced(torus, "hopeless_share 65536", "hopeless_share 0")),
            "checkpoint, line 5: hopeless_share is \"0\", and has to be a number from 1 to 65536");
  EXPECT_LT(reason<Exact>(std::string(1000, 'x') + "\n").size(), 300u);
  EXPECT_EQ(reason<Exact>(""), "checkpoint, line 1: the file ends here, and is not complete");
}

TEST(Checkpoint_refusals, tell_files_of_other_kinds)
{
  const auto it_is = [](const std::string& found, const std::string& expected) {
    return "checkpoint, line 1: it is \"" + found + "\", and has to be \"" + expected +
           " checkpoint 1\"";
  };
  const std::string plane = "Dynamic_Delaunay_triangulation_2",
                    torus = "Dynamic_periodic_Delaunay_triangulation_2",
                    people = "Dynamic_population_2", people_there = "periodic " + people,
                    first = " checkpoint 1";
  const std::string file = checkpoint_of(Exact()), periodic_file = checkpoint_of(empty<Periodic>()),
                    file_of_people = checkpoint_of(Population()),
                    periodic_file_of_people = checkpoint_of(Periodic_population(empty<Periodic>()));
  EXPECT_EQ(reason<Exact>(replaced(file, first, " checkpoint 2")),
            it_is(plane + " checkpoint 2", plane));
  EXPECT_EQ(reason<Exact>("\x1b[31m\n"), it_is("?[31m", plane));
  EXPECT_EQ(reason<Exact>(periodic_file), it_is(torus + first, plane));
  EXPECT_EQ(reason<Exact>(file_of_people), it_is(people + first, plane));
  EXPECT_EQ(reason<Periodic>(file), it_is(plane + first, torus));
  EXPECT_EQ(reason<Periodic>(periodic_file_of_people), it_is(people_there + first, torus));
  Population population;
  EXPECT_EQ(refusal(population, periodic_file_of_people).what(),
            it_is(people_there + first, people));
  Periodic_population periodic_population(empty<Periodic>());
  EXPECT_EQ(refusal(periodic_population, file_of_people).what(),
            it_is(people + first, people_there));
}

// IN THE PLANE ------------------------------------------------------------------------------------

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

template <class Dynamic>
void expect_kept_to_the_bit(const Points& points, const Dynamic& dt)
{
  const Dynamic other = restored(dt);
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_EQ(other.point(id), points[id]);
    EXPECT_EQ(std::signbit(other.point(id).x()), std::signbit(points[id].x()));
  }
}

TEST(Checkpoints, any_finite_double_is_kept_to_the_bit)
{
  using Limits = std::numeric_limits<double>;
  Points points = {{-0., 0.1},
                   {Limits::denorm_min(), -(Limits::min)()},
                   {1e300, -1e-300},
                   {(Limits::max)() / 8, 1. / 3}};
  expect_kept_to_the_bit(points, Exact(points));
  points[2] = Point(1. / 3, -2. / 3);
  points[3] = Point(1e5, 1e-300);
  const Periodic pt(points, Cell(1, 1e-17, -0.3, 1));
  expect_kept_to_the_bit(points, pt);
  EXPECT_TRUE(restored(pt).cell() == pt.cell());
}

TEST(Checkpoints, safe_regions_make_no_difference)
{
  Cloud<Epick> cloud(11);
  auto points = cloud.uniform(400);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Safe_region_classifier_2> dt(points);
  for (int frame = 0; frame < 60; ++frame) {
    cloud.shake(points, 1e-4);
    dt.update(points);
  }
  expect_to_go_on(dt, 11, 1e-4, 100);
}

TEST(Checkpoints, a_file_is_read_into_the_object_that_was_there)
{
  Exact dt = other_one<Plane<Epick>>();
  const auto* const place = &dt.triangulation();
  read(dt, checkpoint_of(specimen<Plane<Epick>>()));
  EXPECT_EQ(&dt.triangulation(), place);
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
    EXPECT_GT(refusal(other, replaced(checkpoint_of(dt), "certified no", "certified yes")).line(),
              0u);
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

TEST(Checkpoints, inconsistent_files_with_the_right_checksum_are_refused)
{
  const std::string text = checkpoint_of(specimen<Plane<Epick>>());
  const std::pair<const char*, const char*> edits[] = {{"dimension 2", "dimension 1"},
                                                       {"dimension 2", "dimension 3"},
                                                       {"positions exact", "positions rounded"},
                                                       {"ids 9", "ids 10"},
                                                       {"ids 9", "ids 8"},
                                                       {"free_ids 1\n6\n", "free_ids 1\n5\n"},
                                                       {"free_ids 1\n6\n", "free_ids 1\n6 6\n"},
                                                       {"free_ids 1\n6\n", "free_ids 1\n\n"},
                                                       {"duplicates 1\n4", "duplicates 1\n3"},
                                                       {"duplicates 1", "duplicates 0"}};
  for (const auto& [what, by] : edits)
    EXPECT_GT(line_of_refusal<Exact>(replaced(text, what, by)), 0u) << what << " by " << by;
}

TEST(Checkpoints, coordinates_have_to_be_finite_and_their_places_right)
{
  const std::string text = checkpoint_of(specimen<Plane<Epick>>());
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

TEST(Checkpoints, forged_files_of_other_kinds_are_refused_or_harmless)
{
  using Heuristic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Nearly_delaunay_classifier_2>;
  Cloud<Epick> cloud(21);
  auto points = cloud.uniform(7);
  Heuristic dt(points.begin(), points.end());
  cloud.shake(points, 0.2);
  dt.update(points.begin(), points.end());
  ASSERT_FALSE(dt.is_certified());
  expect_forgeries_to_be_harmless<Heuristic>(checkpoint_of(dt), 2, 5000);
  expect_forgeries_to_be_harmless<Exact>(checkpoint_of(Exact(cloud.on_line(4))), 3, 2000);
  using Lazy = CGAL::Dynamic_Delaunay_triangulation_2<Epeck>;
  expect_forgeries_to_be_harmless<Lazy>(checkpoint_of(Lazy(thirds(Cloud<Epeck>(22).uniform(5)))), 4,
                                        1000);
}

// SPHERES -----------------------------------------------------------------------------------------

using Triple = std::array<unsigned, 3>;

const char* flaw_of(const std::vector<Triple>& triples, unsigned vertices)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2;
  internal::Flat_faces_2 faces;
  faces.resize(triples.size());
  Face_index f(0);
  for (const auto& [a, b, c] : triples)
    faces.set_vertices(f++, Vertex_index(a), Vertex_index(b), Vertex_index(c));
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
  const Exact dt = specimen<Plane<Epick>>();
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
  const std::string text = checkpoint_of(specimen<Plane<Epick>>());
  Exact dt = other_one<Plane<Epick>>();
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
  Exact dt = specimen<Plane<Epick>>();
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

// IN PERIODIC SPACE -------------------------------------------------------------------------------

// Points that stream, where some jump: which points count as jumping depends on the mean of the
// last frame.
TEST(Periodic_checkpoints, the_mean_motion_is_kept)
{
  Cloud<Epick> cloud(2);
  auto points = cloud.uniform(200);
  Periodic run(points, Cell(14, 14));
  std::size_t relocated = 0;
  for (int frame = 0; frame < 30; ++frame) {
    Periodic interrupted = restored(run);
    const double way = frame % 2 == 0 ? 0.6 : -0.3;
    for (Point& p : points)
      p = cloud.shifted(Point(p.x() + way, p.y()), 0.2);
    const CGAL::Update_report_2 report = run.update(points);
    ASSERT_EQ(all_of(interrupted.update(points)), all_of(report));
    ASSERT_NO_FATAL_FAILURE(expect_equal(run, interrupted));
    relocated += report.relocated;
  }
  EXPECT_GT(relocated, 0u);
}

TEST(Periodic_checkpoints, points_of_a_slab_are_kept_as_far_across_as_can_be)
{
  constexpr double far = (std::numeric_limits<double>::max)();
  Periodic pt(std::vector<Point>{{0, 0}, {1, 1}, {2, 3}}, Cell::slab(3, 0));
  const std::vector<Point> next{{0, far}, {1, far}, {2, far}};
  pt.update(next);
  Periodic other = restored(pt);
  expect_equal(pt, other);
}

TEST(Periodic_checkpoints, a_file_brings_its_cell)
{
  const auto torus = other_one<Torus>(), slab = other_one<Slab>(), nothing = empty<Periodic>();
  auto pt = empty<Periodic>();
  for (const Periodic* file : {&slab, &torus, &nothing, &torus, &slab, &slab, &nothing}) {
    read(pt, checkpoint_of(*file));
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
    ASSERT_NO_FATAL_FAILURE(expect_equal(*file, pt));
  }
}

TEST(Periodic_checkpoints, the_example_in_the_manual_is_a_checkpoint)
{
  Periodic pt(Cell(4, 4));
  for (const Point& p : {Point(1, 1), Point(3, 2), Point(2, 3), Point(7, 2)})
    pt.insert(p);
  pt.remove(2);
  EXPECT_EQ(checkpoint_of(pt), "Dynamic_periodic_Delaunay_triangulation_2 checkpoint 1\n"
                               "slab no\ncell 4 0 0 4\ncertified yes\n"
                               "hopeless_share 65536\nids 4\nvertices 2\n0 1 1\n1 3 2\n"
                               "duplicates 1\n3 2 7 2\nfree_ids 1\n2\n"
                               "faces 4\n2 1 1 1 0 1 1\n1 2 1 0 0 0 1\n2 2 1 0 -1 1 0\n"
                               "1 2 2 0 -1 0 0\ncorners 2\n9\n11\n"
                               "edges 6\n4 0\n11 3\n8 9\n6 1\n7 2\n10 5\n"
                               "checksum a3eee32e\n");
}

struct Failure_of_a_user
{
};

struct Faulty_visitor : CGAL::Delaunay_update_visitor_base_2
{
  template <class Dynamic>
  void after_update(const Dynamic&, const CGAL::Update_report_2&)
  {
    if (throws)
      throw Failure_of_a_user();
  }
  bool throws = false;
};

TEST(Periodic_checkpoints, a_visitor_that_throws_loses_no_ids_of_a_population)
{
  using Visited =
      CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                                      CGAL::With_visitor_2<Faulty_visitor>>;
  CGAL::Dynamic_population_2<Visited> population(Visited(Cell(1, 1))), other(Visited(Cell(1, 1)));
  other.insert(7, Point(0.5, 0.5));
  population.insert(8, Point(0, 0));
  population.visitor().throws = true;
  EXPECT_THROW(read(population, checkpoint_of(other)), Failure_of_a_user);
  EXPECT_TRUE(population.has(7));
  EXPECT_FALSE(population.has(8));
  EXPECT_EQ(checkpoint_of(population), checkpoint_of(other));
}

TEST(Periodic_checkpoints, cells_that_cannot_be_used_are_refused)
{
  const std::string text = checkpoint_of(Periodic(Cell(3, 3)));
  for (const char* cell : {"3 0 6 0", "0 0 0 3", "1e-300 0 0 1e-300", "nan 0 0 3", "3 0 0 1e999",
                           "3 0 0", "3 0 0 3 0", "1 0 1e-20 1e-40"})
    EXPECT_EQ(
        line_of_refusal<Periodic>(replaced(text, "cell 3 0 0 3", "cell " + std::string(cell))), 3u)
        << cell;
  const std::string slab = checkpoint_of(Periodic(Cell::slab(3, 0)));
  for (const char* cell : {"0 0", "inf 0", "3", "3 0 0 1", "1.7e308 1.7e308"})
    EXPECT_EQ(line_of_refusal<Periodic>(replaced(slab, "cell 3 0", "cell " + std::string(cell))),
              3u)
        << cell;
}

TEST(Periodic_checkpoints, points_and_duplicates_have_to_be_in_their_places)
{
  const std::string text = checkpoint_of(specimen<Torus>());
  const std::string vertex = vertex_line(text);
  const auto lines =
      std::count(text.begin(), text.begin() + std::ptrdiff_t(text.find(vertex)), '\n');
  for (const char* point : {"nan 1", "1 inf", "1e9 1", "1 -1e9", "1", "1 1 1"})
    EXPECT_EQ(line_of_refusal<Periodic>(replaced(text, vertex, "\n0 " + std::string(point) + '\n')),
              std::size_t(lines) + 2)
        << point;
  const std::string duplicate = '\n' + line_below(text, "duplicates") + '\n';
  EXPECT_EQ(line_of_refusal<Periodic>(replaced(text, duplicate, duplicate.substr(0, 5) + "1 1\n")),
            16u);
}

// TORI --------------------------------------------------------------------------------------------

// A checkpoint with these points, in a cell of 4 times 4.
std::string file_of(const std::vector<std::string>& points, const std::vector<std::string>& faces,
                    const std::vector<std::string>& corners, const std::vector<std::string>& edges,
                    const std::string& certified = "no")
{
  std::ostringstream out;
  out << "Dynamic_periodic_Delaunay_triangulation_2 checkpoint 1\nslab no\ncell 4 0 0 4\n"
      << "certified " << certified << "\nhopeless_share 65536\nids " << points.size()
      << "\nvertices " << points.size() << '\n';
  for (std::size_t i = 0; i < points.size(); ++i)
    out << i << ' ' << points[i] << '\n';
  out << "duplicates 0\nfree_ids 0\n";
  const auto list = [&](const char* name, const std::vector<std::string>& lines) {
    out << name << ' ' << lines.size() << '\n';
    for (const std::string& line : lines)
      out << line << '\n';
  };
  list("faces", faces);
  list("corners", corners);
  list("edges", edges);
  return sealed(out.str());
}

TEST(Periodic_checkpoints, one_point_has_two_faces_over_a_basis_of_the_lattice)
{
  const std::vector<std::string> edges{"0 4", "1 5", "2 3"};
  const auto of_faces = [&](const std::string& f, const std::string& g) {
    return file_of({"1 1"}, {"1 1 1 " + f, "1 1 1 " + g}, {"0"}, edges, "yes");
  };
  EXPECT_EQ(reason<Periodic>(of_faces("1 0 1 1", "1 1 0 1")), "checkpoint: accepted");
  const std::string not_once = "checkpoint, line 19: the faces above do not cover the space once";
  EXPECT_EQ(reason<Periodic>(of_faces("2 0 2 1", "2 1 0 1")),
            not_once); // a face twice, else all is right
  EXPECT_EQ(reason<Periodic>(of_faces("0 1 1 1", "1 1 1 0")), not_once); // turned over
  EXPECT_EQ(reason<Periodic>(of_faces("1 0 2 0", "2 0 1 0")), not_once);
  EXPECT_EQ(reason<Periodic>(of_faces("1 0 1 0", "1 0 0 0")),
            "checkpoint, line 12: the face has a corner twice");
  EXPECT_EQ(reason<Periodic>(of_faces("1 0 1 1", "1 1 0 2")),
            "checkpoint, line 17: these are half-edges of two edges");
  EXPECT_EQ(reason<Periodic>(of_faces("1 0 1 4194304", "1 1 0 1")),
            "checkpoint, line 12: the shift is \"4194304\", and has to be a number from -4194303 "
            "to 4194303");
}

TEST(Periodic_checkpoints, every_half_edge_is_there_once)
{
  const auto of_edges = [](const std::vector<std::string>& edges) {
    return file_of({"1 1"}, {"1 1 1 1 0 1 1", "1 1 1 1 1 0 1"}, {"5"}, edges);
  };
  EXPECT_EQ(reason<Periodic>(of_edges({"4 0", "5 1", "3 2"})), "checkpoint: accepted");
  const std::string twice = ": a half-edge is there more than once";
  EXPECT_EQ(reason<Periodic>(of_edges({"4 0", "0 4", "3 2"})), "checkpoint, line 18" + twice);
  EXPECT_EQ(reason<Periodic>(of_edges({"4 0", "5 1", "2 2"})), "checkpoint, line 19" + twice);
  EXPECT_EQ(reason<Periodic>(of_edges({"1 0", "5 4", "3 2"})),
            "checkpoint, line 17: these are half-edges of two edges");
}

TEST(Periodic_checkpoints, corners_are_at_their_vertices)
{
  const std::string text = checkpoint_of(specimen<Torus>());
  const std::string corner = line_below(text, "corners");
  const std::size_t place = text.find("\ncorners ");
  const std::size_t begin = text.find('\n', place + 1) + 1;
  const std::size_t second = text.find('\n', begin) + 1;
  std::string edited = text;
  edited.replace(begin, second - begin, text.substr(second, text.find('\n', second) + 1 - second));
  EXPECT_NE(reason<Periodic>(resealed(edited)).find("this is no corner of vertex 1"), text.npos)
      << corner;
}

TEST(Periodic_checkpoints, faces_that_are_no_torus_are_refused)
{
  // two tori, of one point each
  EXPECT_EQ(
      reason<Periodic>(file_of({"1 1", "2 2"},
                               {"1 1 1 1 0 1 1", "1 1 1 1 1 0 1", "2 2 2 1 0 1 1", "2 2 2 1 1 0 1"},
                               {"0", "6"}, {"0 4", "1 5", "2 3", "6 10", "7 11", "8 9"})),
      "checkpoint, line 15: the face hangs together with the first one by no edges");
  // a tetrahedron of which two pairs of vertices are images of one point each
  EXPECT_EQ(
      reason<Periodic>(file_of({"1 1", "2 2"},
                               {"1 2 1 0 0 1 0", "1 2 2 1 0 0 0", "1 1 2 1 0 1 0", "2 2 1 1 0 1 0"},
                               {"0", "1"}, {"2 4", "1 8", "0 10", "5 7", "3 11", "6 9"})),
      "checkpoint, line 16: the faces at a vertex of the face are not one cycle");
}

} // namespace test_checkpoint
