// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever throws, and whenever memory runs out: each point is where it was or where it should have
// come to, and one call later everything is certified again.

#include "change_ledger.h"
#include "oracle.h"
#include "replaced_heap.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/iterator.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/iterator/iterator_adaptor.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
// CGAL 5.5 loses a new block if there is no memory to note where it is.
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:CGAL::Compact_container";
}
#endif

namespace test_exceptions {

using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2>;
using Point = Epick::Point_2;
using Points = std::vector<Point>;
using Places = std::map<std::size_t, Point>;
using replaced_heap::Scarcity;

// -------------------------------------------------------------------------------------------------
// What must be true after an exception.

bool is_at(const Places& places, std::size_t id, const Point& p)
{
  const auto found = places.find(id);
  return found != places.end() && found->second == p;
}

// Expects each point where it was before the call or where it should be after it.
template <class Dynamic>
void expect_between(const Dynamic& dt, const Places& before, const Places& after)
{
  ASSERT_TRUE(dt.is_valid(true));
  std::size_t points = 0;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id)) {
      ++points;
      ASSERT_TRUE(is_at(before, id, dt.point(id)) || is_at(after, id, dt.point(id)))
          << "id " << id << " is at " << dt.point(id);
    } else {
      ASSERT_TRUE(before.count(id) == 0 || after.count(id) == 0) << "id " << id << " is lost";
    }
  for (const auto& [id, p] : before)
    ASSERT_TRUE(dt.has_id(id) || after.count(id) == 0) << "id " << id << " is lost";
  ASSERT_EQ(dt.number_of_points(), points);
}

enum class Next { MEND, UPDATE, INSERT, REMOVE, MOVE };
constexpr Next all_next[] = {Next::MEND, Next::UPDATE, Next::INSERT, Next::REMOVE, Next::MOVE};

template <class Dynamic>
void update_to(Dynamic& dt, const Places& places)
{
  Points points(dt.number_of_ids(), Point(0, 0));
  for (const auto& [id, p] : places)
    points[id] = p;
  dt.update(points.begin(), points.end());
}

// Makes the next call, and returns the places that points must have after it.
template <class Dynamic>
Places go_on(Dynamic& dt, Next next)
{
  Places places = model_of(dt);
  if (next == Next::INSERT || (places.empty() && next != Next::MEND)) {
    const Point p(3.3, 2.7);
    places.emplace(dt.insert(p), p);
    return places;
  }
  const std::size_t id = places.empty() ? 0 : std::prev(places.end())->first;
  switch (next) {
  case Next::UPDATE:
    for (auto& [other, p] : places)
      p = Point(p.x() + 0.01 * std::sin(double(other)), p.y());
    update_to(dt, places);
    break;
  case Next::REMOVE:
    dt.remove(id);
    places.erase(id);
    break;
  case Next::MOVE:
    places[id] = Point(2.2, 1.9);
    dt.move(id, places[id]);
    break;
  default:
    dt.mend();
  }
  return places;
}

// Expects an exact triangulation after one more call, and after another update.
template <class Dynamic>
void expect_recovery(Dynamic& dt, Next next)
{
  if (dt.is_certified()) {
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model_of(dt)));
  }
  for (const Next call : {next, Next::UPDATE}) {
    const Places places = go_on(dt, call);
    ASSERT_NO_FATAL_FAILURE(expect_valid(dt, places));
    if (!Dynamic::Delaunay_classifier::is_exact)
      dt.mend();
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, places));
  }
}

// -------------------------------------------------------------------------------------------------
// Memory.

// False if `work` ran out of memory after the given number of allocations.
bool succeeds(const std::function<void()>& work, long allocations)
{
  try {
    const Scarcity scarcity(allocations);
    work();
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

template <class Dynamic>
std::unique_ptr<Dynamic> triangulated(const Points& points)
{
  auto dt = std::make_unique<Dynamic>();
  if constexpr (!std::is_same_v<Dynamic, Exact> && !std::is_same_v<Dynamic, Heuristic>)
    dt->classifier().watch(*dt);
  dt->insert(points, CGAL::Emptyset_iterator());
  return dt;
}

template <class Dynamic>
using Change = std::function<void(Dynamic&)>;

// Makes the call once for each of its allocations, at which memory then runs out.
template <class Dynamic>
void expect_survival(const Points& points, const Change<Dynamic>& change)
{
  constexpr long ways = std::size(all_next);
  const auto changed = triangulated<Dynamic>(points);
  change(*changed);
  const Places after = model_of(*changed);
  for (long allocations = 0;; ++allocations) {
    SCOPED_TRACE(testing::Message() << allocations << " allocations");
    const auto dt = triangulated<Dynamic>(points);
    const Places before = model_of(*dt);
    if (succeeds([&] { change(*dt); }, allocations))
      break;
    ASSERT_NO_FATAL_FAILURE(expect_between(*dt, before, after));
    ASSERT_NO_FATAL_FAILURE(
        expect_recovery(*dt, all_next[(allocations + allocations / ways) % ways]));
    if (testing::Test::HasFailure())
      return;
  }
}

template <class Dynamic>
class Memory : public testing::Test
{
protected:
  using Change = test_exceptions::Change<Dynamic>;

  // Expects survival of each of the changes, from the same points.
  static void expect_survival_of(const Points& points, const std::vector<Change>& changes)
  {
    for (const Change& change : changes)
      ASSERT_NO_FATAL_FAILURE(expect_survival<Dynamic>(points, change));
  }

  static Change update(const Points& points)
  {
    return [points](Dynamic& dt) { dt.update(points.begin(), points.end()); };
  }

  static Change insert(const Points& points)
  {
    return [points](Dynamic& dt) {
      std::vector<std::size_t> ids(points.size());
      dt.insert(points.begin(), points.end(), ids.begin());
    };
  }

  static Change remove(std::size_t first, std::size_t beyond)
  {
    return [=](Dynamic& dt) {
      std::vector<std::size_t> ids(beyond - first);
      std::iota(ids.begin(), ids.end(), first);
      dt.remove(ids.begin(), ids.end());
    };
  }

  static Change move(std::size_t first, const Points& places)
  {
    return [=](Dynamic& dt) {
      std::vector<std::pair<std::size_t, Point>> movers;
      for (std::size_t i = 0; i < places.size(); ++i)
        movers.emplace_back(first + i, places[i]);
      dt.move(movers.begin(), movers.end());
    };
  }

  static Change mend_after(const Points& points)
  {
    return [points](Dynamic& dt) {
      dt.update(points.begin(), points.end());
      dt.mend();
    };
  }

  Cloud<Epick> cloud{1};
};

using Triangulations =
    testing::Types<Exact, Heuristic, Watched_triangulation<Epick, CGAL::Safe_region_classifier_2>,
                   Watched_triangulation<Epick, CGAL::Point_distance_classifier_2>>;
TYPED_TEST_SUITE(Memory, Triangulations);

TYPED_TEST(Memory, may_run_out_in_an_update_that_breaks_little_or_everything)
{
  const Points points = this->cloud.uniform(60);
  Points moved = points;
  this->cloud.shake(moved, 0.06);
  Points in_steps = points;
  this->cloud.shake(in_steps, 0.2);
  const Points elsewhere = this->cloud.uniform(60);
  this->expect_survival_of(points,
                           {this->update(moved), this->update(in_steps), this->update(elsewhere)});
}

TYPED_TEST(Memory, may_run_out_in_an_update_that_numbers_the_vertices_anew)
{
  const Points points = this->cloud.uniform(300), elsewhere = this->cloud.uniform(300);
  this->expect_survival_of(points, {this->update(elsewhere)});
}

TYPED_TEST(Memory, may_run_out_in_a_mending)
{
  const Points points = this->cloud.uniform(60);
  Points moved = points;
  this->cloud.shake(moved, 0.15);
  this->expect_survival_of(points, {this->mend_after(moved)});
}

TYPED_TEST(Memory, may_run_out_when_points_meet_and_part_by_an_update)
{
  const Points points = this->cloud.uniform(60);
  Points few = points, many = points, moved = points;
  this->cloud.shake(moved, 0.02);
  few[3] = few[4] = few[5] = points[6];
  for (std::size_t i = 0; i < 30; ++i)
    many[i] = points[30 + i % 7];
  ASSERT_NO_FATAL_FAILURE(
      this->expect_survival_of(points, {this->update(few), this->update(many)}));
  ASSERT_NO_FATAL_FAILURE(
      this->expect_survival_of(few, {this->update(points), this->update(moved)}));
  this->expect_survival_of(many, {this->update(points)});
}

TYPED_TEST(Memory, may_run_out_on_the_way_onto_a_line_along_it_and_off_again)
{
  const Points line = this->cloud.on_line(20), other_line = this->cloud.on_line(20);
  const Points plane = this->cloud.uniform(20);
  ASSERT_NO_FATAL_FAILURE(this->expect_survival_of(plane, {this->update(line)}));
  this->expect_survival_of(line, {this->update(other_line), this->update(plane),
                                  this->insert({Point(0, 5000)}), this->remove(5, 7),
                                  this->move(2, {Point(0, 9000)})});
}

TYPED_TEST(Memory, may_run_out_when_points_come)
{
  const Points points = this->cloud.uniform(60), others = this->cloud.uniform(60);
  const Points some = {others[0], points[5], Point(-9, 4), others[1], others[0], others[2]};
  ASSERT_NO_FATAL_FAILURE(
      this->expect_survival_of({}, {this->insert({points[0]}), this->insert(points)}));
  this->expect_survival_of(points,
                           {this->insert({others[0]}), this->insert(some), this->insert(others)});
}

TYPED_TEST(Memory, may_run_out_when_points_go)
{
  Points points = this->cloud.uniform(60);
  points.insert(points.begin(), 3, points[0]);
  ASSERT_NO_FATAL_FAILURE(this->expect_survival_of({points[0]}, {this->remove(0, 1)}));
  this->expect_survival_of(points, {this->remove(40, 41), this->remove(1, 7), this->remove(0, 40)});
}

TYPED_TEST(Memory, may_run_out_when_some_points_move)
{
  Points points = this->cloud.uniform(60);
  points.insert(points.begin(), 3, points[0]);
  const Points elsewhere = this->cloud.uniform(40);
  for (const std::size_t number : {1u, 5u, 40u}) {
    Points near(points.begin(), points.begin() + std::ptrdiff_t(number));
    this->cloud.shake(near, 0.05);
    const Points far(elsewhere.begin(), elsewhere.begin() + std::ptrdiff_t(number));
    const Points onto_others(points.end() - std::ptrdiff_t(number), points.end());
    ASSERT_NO_FATAL_FAILURE(this->expect_survival_of(
        points, {this->move(0, near), this->move(0, far), this->move(0, onto_others)}));
  }
}

TEST(Memory_of_constructors, may_run_out)
{
  Points points = Cloud<Epick>(2).uniform(60);
  points.push_back(points[7]);
  for (const Points& given : {points, Cloud<Epick>(2).on_line(9), Points()}) {
    long allocations = 0;
    while (!succeeds([&] { Exact(given.begin(), given.end()); }, allocations))
      ++allocations;
    EXPECT_GT(allocations, 5);
  }
}

// -------------------------------------------------------------------------------------------------
// Memory of populations.

using People = CGAL::Dynamic_population_2<Exact, int>;
using Frame = std::map<int, Point>;

void expect_between(const People& people, const Frame& before, const Frame& after)
{
  ASSERT_TRUE(people.triangulation().is_valid(true));
  ASSERT_EQ(people.size(), people.triangulation().number_of_points());
  std::size_t known = 0;
  for (int user_id = 0; user_id < 200; ++user_id) {
    const bool was = before.count(user_id) > 0, will = after.count(user_id) > 0;
    if (people.has(user_id)) {
      ++known;
      const Point& p = people.point(user_id);
      ASSERT_TRUE((was && before.at(user_id) == p) || (will && after.at(user_id) == p)) << user_id;
      ASSERT_EQ(people.user_id(people.id(user_id)), user_id);
    } else {
      ASSERT_FALSE(was && will) << user_id << " is lost";
    }
  }
  ASSERT_EQ(known, people.size());
}

template <class Call>
void expect_survival(const Frame& before, const Frame& after, const Call& call)
{
  for (long allocations = 0;; ++allocations) {
    SCOPED_TRACE(testing::Message() << allocations << " allocations");
    People people;
    people.update(before.begin(), before.end());
    const bool is_done = succeeds([&] { call(people); }, allocations);
    ASSERT_NO_FATAL_FAILURE(expect_between(people, before, after));
    const Frame& next = allocations % 2 == 0 ? before : after;
    ASSERT_TRUE(people.update(next.begin(), next.end()).certified);
    ASSERT_NO_FATAL_FAILURE(expect_between(people, next, next));
    ASSERT_NO_FATAL_FAILURE(expect_exact(people.triangulation(), model_of(people.triangulation())));
    if (is_done)
      break;
  }
}

void expect_survival(const Frame& before, const Frame& after)
{
  expect_survival(before, after,
                  [&](People& people) { people.update(after.begin(), after.end()); });
}

TEST(Memory_of_populations, may_run_out_while_a_range_comes_or_goes)
{
  const Points points = Cloud<Epick>(6).uniform(60);
  Frame all, few, newcomers;
  std::vector<int> names;
  for (int i = 0; i < 60; ++i) {
    all.emplace(i, points[std::size_t(i)]);
    (i % 3 == 0 ? newcomers : few).emplace(i, points[std::size_t(i)]);
    if (i % 3 == 0)
      names.push_back(i);
  }
  ASSERT_NO_FATAL_FAILURE(
      expect_survival(few, all, [&](People& people) { people.insert(newcomers); }));
  ASSERT_NO_FATAL_FAILURE(expect_survival(all, few, [&](People& people) { people.remove(names); }));
}

TEST(Memory_of_populations, may_run_out_in_a_frame_in_which_some_come_and_go_and_the_others_move)
{
  Cloud<Epick> cloud(3);
  const Points points = cloud.uniform(100);
  Frame before, few, many;
  for (int i = 0; i < 60; ++i)
    before.emplace(i, points[std::size_t(i)]);
  for (int i = 3; i < 65; ++i)
    few.emplace(i, cloud.shifted(points[std::size_t(i)], 0.02));
  few[30] = few[31];
  for (int i = 30; i < 100; ++i)
    many.emplace(i, cloud.shifted(points[std::size_t(i)], 0.02));
  ASSERT_NO_FATAL_FAILURE(expect_survival(before, few));
  ASSERT_NO_FATAL_FAILURE(expect_survival(few, before));
  ASSERT_NO_FATAL_FAILURE(expect_survival(before, many));
  ASSERT_NO_FATAL_FAILURE(expect_survival({}, before));
  ASSERT_NO_FATAL_FAILURE(expect_survival(before, {}));
}

// -------------------------------------------------------------------------------------------------
// Exceptions of the user's own.

struct Failure
{
};

// Throws when it is burned for the k-th time, counted from 0.
class Fuse
{
public:
  void set(int k) { *m_left = k; }
  void burn() const
  {
    if ((*m_left)-- == 0)
      throw Failure();
  }

private:
  std::shared_ptr<int> m_left = std::make_shared<int>(-1);
};

// A property map that returns the value itself, and burns a fuse.
auto fused_map(const Fuse& fuse)
{
  return boost::make_function_property_map<Point>([fuse](const Point& p) {
    fuse.burn();
    return p;
  });
}

// Passes its values once; reading one burns a fuse.
template <class Iterator>
class Fused_iterator
  : public boost::iterator_adaptor<Fused_iterator<Iterator>, Iterator, boost::use_default,
                                   boost::single_pass_traversal_tag>
{
public:
  Fused_iterator(Iterator position, const Fuse& fuse)
    : Fused_iterator::iterator_adaptor_(position)
    , m_fuse(fuse)
  {
  }

private:
  friend class boost::iterator_core_access;

  decltype(auto) dereference() const
  {
    m_fuse.burn();
    return *this->base();
  }

  Fuse m_fuse;
};

// Repeats the call, and makes another one of its burns throw each time: nothing may change.
template <class Call>
void expect_nothing_changes(Exact& dt, const Call& call)
{
  const Places before = model_of(dt);
  for (int k = 0;; ++k) {
    SCOPED_TRACE(testing::Message() << "fuse of " << k);
    Fuse fuse;
    fuse.set(k);
    try {
      call(fuse);
      ASSERT_GT(k, 0);
      return;
    } catch (const Failure&) {
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, before));
  }
}

class Ranges : public testing::Test
{
protected:
  Ranges()
  {
    points[3] = points[4]; // a duplicate: frames are then read by other code
    dt.update(points.begin(), points.end());
    for (std::size_t id = 5; id < 20; ++id)
      movers.emplace_back(id, others[id]);
  }

  Points points = Cloud<Epick>(4).uniform(40), others = Cloud<Epick>(5).uniform(40);
  std::vector<std::pair<std::size_t, Point>> movers;
  std::vector<std::size_t> ids = {3, 4, 5, 20};
  std::vector<std::size_t> new_ids;
  Exact dt{points.begin(), points.end()};
};

TEST_F(Ranges, may_throw_at_any_element_and_nothing_changes)
{
  const auto expect_of = [&](const auto& range, const auto& call) {
    expect_nothing_changes(dt, [&](const Fuse& fuse) {
      call(Fused_iterator(range.begin(), fuse), Fused_iterator(range.end(), fuse));
    });
  };
  expect_of(others, [&](auto first, auto beyond) { dt.update(first, beyond); });
  expect_of(movers, [&](auto first, auto beyond) { dt.move(first, beyond); });
  expect_of(points, [&](auto first, auto beyond) {
    dt.insert(first, beyond, std::back_inserter(new_ids));
  });
  expect_of(ids, [&](auto first, auto beyond) { dt.remove(first, beyond); });
}

TEST_F(Ranges, may_be_read_by_property_maps_that_throw_and_nothing_changes)
{
  const auto update_to_others = [&](const Fuse& fuse) {
    dt.update(others.begin(), others.end(), fused_map(fuse));
  };
  expect_nothing_changes(dt, update_to_others);
  expect_nothing_changes(dt, [&](const Fuse& fuse) {
    dt.insert(points.begin(), points.end(), fused_map(fuse), std::back_inserter(new_ids));
  });
  dt = Exact(others.begin(), others.end()); // no duplicates
  expect_nothing_changes(dt, update_to_others);
}

TEST_F(Ranges, of_ids_may_have_no_room_for_newcomers_and_none_comes)
{
  expect_nothing_changes(dt, [&](const Fuse& fuse) {
    dt.insert(others.begin(), others.end(),
              boost::make_function_output_iterator([fuse](std::size_t) { fuse.burn(); }));
  });
}

TEST_F(Ranges, of_populations_may_throw_at_any_element_and_nothing_changes)
{
  Frame before, after, newcomers;
  std::vector<int> names;
  for (int i = 0; i < 30; ++i) {
    before.emplace(i, points[std::size_t(i)]);
    after.emplace(i + 5, others[std::size_t(i)]);
    newcomers.emplace(i + 100, others[std::size_t(i)]);
    names.push_back(i);
  }
  for (int k = 0; k < 30; ++k) { // each element is read once
    People people;
    people.update(before.begin(), before.end());
    const auto expect_nothing = [&](const auto& range, const auto& call) {
      Fuse fuse;
      fuse.set(k);
      EXPECT_THROW(call(Fused_iterator(range.begin(), fuse), Fused_iterator(range.end(), fuse)),
                   Failure);
      ASSERT_NO_FATAL_FAILURE(expect_between(people, before, before));
    };
    expect_nothing(after, [&](auto first, auto beyond) { people.update(first, beyond); });
    expect_nothing(newcomers, [&](auto first, auto beyond) { people.insert(first, beyond); });
    expect_nothing(before, [&](auto first, auto beyond) { people.move(first, beyond); });
    expect_nothing(names, [&](auto first, auto beyond) { people.remove(first, beyond); });
    people.update(after.begin(), after.end());
    ASSERT_NO_FATAL_FAILURE(expect_between(people, after, after));
  }
}

// A classifier, a repair and a policy that burn fuses.
struct Fused_classifier : CGAL::Circumcircle_classifier_2
{
  Fuse classification, news;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    CGAL::Circumcircle_classifier_2::operator()(frame, classified);
    classification.burn();
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    news.burn();
    CGAL::Circumcircle_classifier_2::after_update(frame);
    news.burn();
  }
};

struct Fused_repair
{
  Fuse fuse;

  template <class Mender>
  void operator()(Mender& mender) const
  {
    fuse.burn();
    mender.flip();
    fuse.burn();
    CGAL::Hold_and_flip_repair_2()(mender);
    fuse.burn();
  }
};

struct Fused_policy
{
  Fuse question, report;

  template <class Frame>
  bool wants_rebuild(const Frame&) const
  {
    question.burn();
    return false;
  }
  template <class Frame>
  void after_update(const Frame&, const CGAL::Update_report_2&) const
  {
    report.burn();
  }
};

using Fused_triangulation = CGAL::Dynamic_Delaunay_triangulation_2<
    Epick, Change_ledger<Fused_classifier>, CGAL::With_repair_2<Fused_repair>,
    CGAL::With_data_structure_2<Stamped_data_structure<Epick>>, CGAL::With_policy_2<Fused_policy>>;

class Parts : public testing::Test
{
protected:
  Parts()
  {
    points[3] = points[4];
    dt.classifier().watch(dt);
    std::vector<std::size_t> ids(points.size());
    dt.insert(points.begin(), points.end(), ids.begin());
    cloud.shake(moved, 0.08);
    moved[10] = moved[11];
    moved[12] = moved[13];
  }

  void burn_in_update(const Fuse& fuse, int k)
  {
    Fuse(fuse).set(k);
    EXPECT_THROW(dt.update(moved.begin(), moved.end()), Failure);
  }

  // Causes the same failure repeatedly, with another kind of call after each.
  void expect_recovery_from(const Fuse& fuse, int k, bool changes)
  {
    for (const Next next : all_next) {
      SCOPED_TRACE(testing::Message() << "next call " << int(next));
      const Places before = model_of(dt);
      Points all(dt.number_of_ids(), Point(1, 1));
      for (const auto& [id, p] : before)
        all[id] = id < moved.size() ? moved[id] : p;
      std::swap(all, moved);
      burn_in_update(fuse, k);
      std::swap(all, moved);
      const Places after = model_of(dt);
      if (!changes) {
        ASSERT_EQ(after, before);
      }
      ASSERT_NO_FATAL_FAILURE(expect_recovery(dt, next));
      update_to(dt, before_meeting());
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, before_meeting()));
    }
  }

  // The places at which all points that still exist began.
  Places before_meeting() const
  {
    Places places = model_of(dt);
    for (auto& [id, p] : places)
      if (id < points.size())
        p = points[id];
    return places;
  }

  Cloud<Epick> cloud{6};
  Points points = cloud.uniform(120), moved = points;
  Change_ledger<Fused_classifier> classifier;
  Fused_repair repair;
  Fused_policy policy;
  Fused_triangulation dt{Fused_triangulation::Settings{classifier, repair, {}, policy}};
};

// Names a vertex in every frame, so that the repair is called also where nothing is broken.
struct Busy_classifier
{
  static constexpr bool is_exact = true;

  template <class Frame, class Classification>
  void operator()(const Frame&, Classification& classified) const
  {
    classified.add_vertex(typename Frame::Vertex_index(1));
  }
};

// All edges are Delaunay then, but one point has left the vertex that it shares.
TEST(A_repair_that_throws, leaves_no_certificate_while_a_duplicate_has_no_vertex_of_its_own)
{
  Cloud<Epick> cloud(7);
  Points points = cloud.uniform(30);
  points[9] = points[3];
  Fused_repair repair;
  using Busy = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Busy_classifier,
                                                      CGAL::With_repair_2<Fused_repair>>;
  Busy dt(points.begin(), points.end(), Busy::Settings{Busy_classifier(), repair});
  points[9] = CGAL::midpoint(points[3], points[4]);
  repair.fuse.set(0);
  EXPECT_THROW(dt.update(points.begin(), points.end()), Failure);
  repair.fuse.set(-1);
  EXPECT_FALSE(dt.is_certified());
  EXPECT_FALSE(dt.certify());
  EXPECT_EQ(dt.number_of_vertices(), 29u);
  EXPECT_TRUE(dt.mend().certified);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST_F(Parts, of_classifiers_that_throw_when_asked_change_nothing)
{
  ASSERT_NO_FATAL_FAILURE(expect_recovery_from(classifier.classification, 0, false));
}

TEST_F(Parts, of_policies_that_throw_when_asked_change_nothing)
{
  ASSERT_NO_FATAL_FAILURE(expect_recovery_from(policy.question, 0, false));
}

TEST_F(Parts, of_classifiers_that_throw_when_told_are_told_again)
{
  for (const int k : {0, 1})
    ASSERT_NO_FATAL_FAILURE(expect_recovery_from(classifier.news, k, true));
}

TEST_F(Parts, of_policies_that_throw_when_told_leave_the_frame_as_it_is)
{
  ASSERT_NO_FATAL_FAILURE(expect_recovery_from(policy.report, 0, true));
}

TEST_F(Parts, of_repairs_that_throw_before_amid_and_after_leave_what_the_next_call_mends)
{
  for (const int k : {0, 1, 2})
    ASSERT_NO_FATAL_FAILURE(expect_recovery_from(repair.fuse, k, true));
}

TEST_F(Parts, of_classifiers_that_throw_when_told_of_changes_of_the_population_are_told_again)
{
  for (const int k : {0, 1})
    for (const Next next : {Next::INSERT, Next::MOVE, Next::REMOVE}) {
      SCOPED_TRACE(testing::Message() << "call " << int(next));
      classifier.news.set(k);
      EXPECT_THROW(go_on(dt, next), Failure);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model_of(dt)));
      ASSERT_NO_FATAL_FAILURE(expect_recovery(dt, next));
    }
}

} // namespace test_exceptions
