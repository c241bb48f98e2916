// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever is refused, in the plane and in periodic space, and by populations there: the exception
// says what is wrong, and nothing changes.

#include "oracle.h"
#include "sealed_checkpoint.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Kernel_traits.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <limits>
#include <list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_refusals {

using Cell = CGAL::Periodic_cell_2;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Places that are none: their coordinates are no numbers, or too large for doubles.
template <class Point>
std::vector<Point> no_places()
{
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  if constexpr (std::is_same_v<FT, double>)
    return {Point(1, nan), Point(1, infinity), Point(1, -infinity)};
  else
    return {Point(1, FT(1e300) * FT(1e300))};
}

// What a call is refused with.
template <class Call>
std::string refusal_of(const Call& call)
{
  try {
    call();
  } catch (const CGAL::Non_finite_coordinate_error_2& error) {
    return "no number at " + std::to_string(error.id());
  } catch (const CGAL::Periodic_range_error_2& error) {
    return "out of range at " + std::to_string(error.id());
  } catch (const CGAL::Periodic_cell_error_2&) {
    return "no such cell";
  } catch (const CGAL::Point_count_error_2& error) {
    const bool are_more = std::string(error.what()).find(" or more") != std::string::npos;
    return std::to_string(error.given()) + (are_more ? " or more" : "") + " for " +
           std::to_string(error.expected());
  } catch (const CGAL::Unknown_id_error_2& error) {
    return "unknown " + std::to_string(error.id()) + " of " + std::to_string(error.number_of_ids());
  } catch (const CGAL::Unknown_user_id_error_2& error) {
    return "unknown " + error.id();
  } catch (const CGAL::Repeated_id_error_2& error) {
    return "repeated " + error.id();
  }
  return "nothing";
}

template <class Subject>
struct Refused_call
{
  std::string refusal;
  std::function<void(Subject&)> call;
};

template <class Subject>
void expect_refusals(Subject& subject, const std::vector<Refused_call<Subject>>& calls)
{
  const std::string before = checkpoint_of(subject);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "call " << i);
    EXPECT_EQ(refusal_of([&] { calls[i].call(subject); }), calls[i].refusal);
    EXPECT_EQ(checkpoint_of(subject), before);
  }
}

// A space makes a triangulation of points, and knows cells that it refuses.
template <class Kernel>
struct Plane
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  static constexpr bool is_periodic = false;

  static Dynamic triangulation() { return {}; }
};

struct Torus
{
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
  static constexpr bool is_periodic = true;

  static Dynamic triangulation() { return Dynamic(Cell(3, 3)); }
  static std::vector<Cell> refused_cells()
  {
    return {Cell(1e-200, 1e-200), Cell(1, 0, 1e12, 1), Cell::slab(3, 0)};
  }
};

struct Slab : Torus
{
  static Dynamic triangulation() { return Dynamic(Cell::slab(3, 0)); }
  static std::vector<Cell> refused_cells() { return {Cell(3, 3)}; }
};

template <class Space>
class Refusals : public testing::Test
{
protected:
  using Dynamic = typename Space::Dynamic;
  using Place = typename Dynamic::Point;
  using Places = std::vector<Place>;
  using People = CGAL::Dynamic_population_2<Dynamic>;
  using Crowd = std::vector<std::pair<std::int64_t, Place>>;

  // Points of which number 6 has gone.
  Refusals()
  {
    std::vector<std::size_t> ids;
    m_dt.insert(m_points, std::back_inserter(ids));
    m_dt.remove(6);
    m_people.insert(Crowd{{7, {0, 0}}, {-2, {1, 0}}, {9, {0, 1}}});
  }

  Places with(std::size_t id, const Place& p) const
  {
    Places points = m_points;
    points[id] = p;
    return points;
  }

  Places m_points{{0.1, 0.2}, {1.3, 0.1}, {2.6, 0.4}, {0.3, 1.2}, {1.1, 1.4},
                  {2.2, 1.7}, {0.4, 2.3}, {1.6, 2.1}, {2.9, 2.7}};
  Dynamic m_dt = Space::triangulation();
  People m_people{Space::triangulation()};
};
using Spaces = testing::Types<Plane<Epick>, Plane<Epeck>, Torus, Slab>;
TYPED_TEST_SUITE(Refusals, Spaces);

TYPED_TEST(Refusals, of_a_triangulation)
{
  using Point = typename TestFixture::Place;
  using Points = typename TestFixture::Places;
  using Movers = std::vector<std::pair<int, Point>>;
  using Ids = std::vector<int>;
  const Point good(0.5, 0.5);
  const std::string below_all = "unknown " + std::to_string(std::size_t(-1)) + " of 9";
  std::vector<std::size_t> ids;
  // ranges whose length is known are not read, others as far as is due
  std::vector<Refused_call<typename TestFixture::Dynamic>> calls = {
      {"0 for 9", [=](auto& dt) { dt.update(Points()); }},
      {"8 for 9", [=](auto& dt) { dt.update(Points(8, good)); }},
      {"10 or more for 9", [=](auto& dt) { dt.update(std::list<Point>(49, good)); }},
      {"unknown 6 of 9", [=](auto& dt) { dt.point(6); }},
      {"unknown 9 of 9", [=](auto& dt) { dt.point(9); }},
      {"unknown 6 of 9", [=](auto& dt) { dt.remove(6); }},
      {"unknown 9 of 9", [=](auto& dt) { dt.remove(9); }},
      {"unknown 6 of 9",
       [=](auto& dt) {
         dt.remove(Ids{1, 2, 6});
       }},
      {"repeated 3",
       [=](auto& dt) {
         dt.remove(Ids{3, 4, 3});
       }},
      {below_all,
       [=](auto& dt) {
         dt.remove(Ids{1, -1});
       }},
      {"unknown 6 of 9", [=](auto& dt) { dt.move(6, good); }},
      {"unknown 9 of 9", [=](auto& dt) { dt.move(9, good); }},
      {"unknown 6 of 9",
       [=](auto& dt) {
         dt.move(Movers{{1, good}, {2, good}, {6, good}});
       }},
      {"repeated 3",
       [=](auto& dt) {
         dt.move(Movers{{3, good}, {4, good}, {3, good}});
       }},
      {below_all, [=](auto& dt) {
         dt.move(Movers{{1, good}, {-1, good}});
       }}};
  for (const Point& bad : no_places<Point>()) {
    const auto insert = [=, &ids](auto& dt) {
      dt.insert(Points{good, good, bad}, std::back_inserter(ids));
    };
    calls.push_back({"no number at 4", [=](auto& dt) { dt.update(this->with(4, bad)); }});
    calls.push_back({"no number at 1", [=](auto& dt) { dt.move(1, bad); }});
    calls.push_back({"no number at 6", [=](auto& dt) { dt.insert(bad); }});
    calls.push_back({"no number at 10", insert});
    calls.push_back({"49 for 9", [=](auto& dt) { dt.update(Points(49, bad)); }});
    calls.push_back({"49 for 9", [=](auto& dt) { dt.update(std::deque<Point>(49, bad)); }});
  }
  if constexpr (TypeParam::is_periodic) {
    calls.push_back({"out of range at 4", [=](auto& dt) { dt.update(this->with(4, {1e10, 0})); }});
    calls.push_back({"out of range at 6", [=](auto& dt) { dt.insert(Point(1e300, 0)); }});
    for (const Cell& cell : TypeParam::refused_cells())
      calls.push_back({"no such cell", [=](auto& dt) { dt.update(this->m_points, cell); }});
  } else {
    calls.push_back({"unknown 9 of 9", [=](auto& dt) { dt.vertex(9); }});
  }
  auto& dt = this->m_dt;
  expect_refusals(dt, calls);
  dt.move(1, Point(dt.point(2))); // points that coincide are read one by one
  expect_refusals(dt, calls);
  EXPECT_TRUE(ids.empty());
  EXPECT_TRUE(dt.update(this->m_points).certified);
  EXPECT_TRUE(dt.is_valid(true));
}

TYPED_TEST(Refusals, of_a_population)
{
  using Point = typename TestFixture::Place;
  using Named = typename TestFixture::Crowd;
  using Ids = std::vector<int>;
  const Point near(2, 2), nowhere = no_places<Point>().front(), far(1e9, 0);
  std::vector<Refused_call<typename TestFixture::People>> calls = {
      {"repeated -2",
       [=](auto& p) {
         p.insert(Named{{1, near}, {-2, near}});
       }},
      {"repeated 1",
       [=](auto& p) {
         p.insert(Named{{1, near}, {2, near}, {1, near}});
       }},
      {"no number at 1",
       [=](auto& p) {
         p.insert(Named{{1, near}, {2, nowhere}});
       }},
      {"no number at 0", [=](auto& p) { p.insert(1, nowhere); }},
      {"unknown 1",
       [=](auto& p) {
         p.move(Named{{9, near}, {1, near}});
       }},
      {"repeated 9",
       [=](auto& p) {
         p.move(Named{{9, near}, {9, near}});
       }},
      {"no number at 1",
       [=](auto& p) {
         p.move(Named{{9, near}, {7, nowhere}});
       }},
      {"no number at 0", [=](auto& p) { p.move(9, nowhere); }},
      {"unknown 1",
       [=](auto& p) {
         p.remove(Ids{9, 7, 1});
       }},
      {"repeated 9",
       [=](auto& p) {
         p.remove(Ids{9, 7, 9});
       }},
      {"repeated 8",
       [=](auto& p) {
         p.update(Named{{8, near}, {8, near}});
       }},
      {"no number at 1", [=](auto& p) {
         p.update(Named{{8, near}, {9, nowhere}});
       }}};
  if constexpr (TypeParam::is_periodic) {
    calls.push_back({"out of range at 0", [=](auto& p) { p.update(Named{{8, far}, {9, near}}); }});
    calls.push_back({"out of range at 1", [=](auto& p) { p.update(Named{{9, near}, {8, far}}); }});
    calls.push_back({"out of range at 1", [=](auto& p) { p.move(Named{{7, near}, {9, far}}); }});
    calls.push_back({"out of range at 0", [=](auto& p) { p.insert(8, far); }});
    for (const Cell& cell : TypeParam::refused_cells())
      calls.push_back({"no such cell", [=](auto& p) { p.update(Named{{8, near}}, cell); }});
  }
  auto& people = this->m_people;
  expect_refusals(people, calls);
  EXPECT_TRUE(people.has(7) && people.has(-2) && people.has(9) && !people.has(8));
  people.insert(8, near);
  people.remove(7);
  people.move(Named{{8, Point(2, 2.5)}, {9, Point(1.5, 1)}});
  EXPECT_EQ(people.size(), 3u);
  EXPECT_TRUE(people.triangulation().is_certified() && people.triangulation().is_valid(true));
}

} // namespace test_refusals
