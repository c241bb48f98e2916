// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Visitors are notified of everything that happens, in every kind of call.

#include "interrupting_visitor.h"
#include "listening_visitor.h"
#include "oracle.h"
#include "population_player.h"
#include "stamps.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_visitors {

using Points = Cloud<Epick>::Points;
using Edges = std::vector<CGAL::Edge_changes_visitor_2::Edge>;

// What is known only from the notifications of a visitor.
struct Hearsay
{
  std::map<std::size_t, std::size_t> vertices; // the ids of the finite ones, by stamps
  CGAL::Update_report_2 report;
  int updates = 0, finished_updates = 0;
  int flips = 0, created_faces = 0, created_vertices = 0, removals = 0, merges = 0, id_changes = 0;
};

// Checks that each notification fits the ones before.
class Listener : public Listening_visitor<>
{
  using Base = Listening_visitor<>;

public:
  const Hearsay& hearsay() const { return m_hearsay; }

  template <class Dynamic>
  void before_update(const Dynamic& dt)
  {
    ++m_hearsay.updates;
    expect_in_step(dt);
  }

  template <class Dynamic>
  void after_update(const Dynamic& dt, const CGAL::Update_report_2& report)
  {
    ++m_hearsay.finished_updates;
    m_hearsay.report = report;
    EXPECT_EQ(dt.is_certified(), report.certified);
    expect_in_step(dt);
  }

  template <class Dynamic>
  void before_flip(const Dynamic& dt, const typename Dynamic::Edge& e)
  {
    ++m_hearsay.flips;
    Base::before_flip(dt, e);
  }

  template <class Dynamic>
  void after_face_creation(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    ++m_hearsay.created_faces;
    Base::after_face_creation(dt, f);
  }

  template <class Dynamic>
  void after_vertex_creation(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id)
  {
    ++m_hearsay.created_vertices;
    EXPECT_EQ(dt.id(v), id);
    EXPECT_EQ(dt.vertex(id), v);
    EXPECT_TRUE(m_hearsay.vertices.emplace(v->info().value, id).second);
  }

  template <class Dynamic>
  void before_vertex_removal(const Dynamic&, typename Dynamic::Vertex_handle v, std::size_t id)
  {
    ++m_hearsay.removals;
    forget_vertex(v->info().value, id);
  }

  template <class Dynamic>
  void before_vertex_merge(const Dynamic&, typename Dynamic::Vertex_handle v, std::size_t id,
                           typename Dynamic::Vertex_handle stays)
  {
    ++m_hearsay.merges;
    forget_vertex(v->info().value, id);
    EXPECT_EQ(m_hearsay.vertices.count(stays->info().value), 1u);
  }

  template <class Dynamic>
  void after_id_change(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id_before)
  {
    ++m_hearsay.id_changes;
    EXPECT_EQ(m_hearsay.vertices.at(v->info().value), id_before);
    m_hearsay.vertices.at(v->info().value) = dt.id(v);
    Base::after_id_change(dt, v, id_before);
  }

private:
  void forget_vertex(std::size_t v, std::size_t id)
  {
    const auto known = m_hearsay.vertices.find(v);
    ASSERT_TRUE(known != m_hearsay.vertices.end());
    EXPECT_EQ(known->second, id);
    m_hearsay.vertices.erase(known);
  }

  template <class Dynamic>
  void expect_in_step(const Dynamic& dt) const
  {
    expect_to_know_all_faces(dt);
    std::map<std::size_t, std::size_t> vertices;
    for (auto v = dt.tds().vertices_begin(); v != dt.tds().vertices_end(); ++v)
      if (v != dt.infinite_vertex())
        vertices.emplace(v->info().value, dt.id(v));
    EXPECT_EQ(vertices, m_hearsay.vertices);
  }

  Hearsay m_hearsay;
};

template <class Visitor, class Classifier = CGAL::Circumcircle_classifier_2,
          class Repair = CGAL::Default, class Kernel = Epick>
using Visited = CGAL::Dynamic_Delaunay_triangulation_2<
    Kernel, Classifier, CGAL::With_repair_2<Repair>,
    CGAL::With_data_structure_2<Stamped_data_structure<Kernel>>, CGAL::With_visitor_2<Visitor>>;

// -------------------------------------------------------------------------------------------------
// All repairs

template <class Dynamic>
class Listening : public testing::Test
{
};

using Ways =
    testing::Types<Visited<Listener>,
                   Visited<Listener, CGAL::Circumcircle_classifier_2, CGAL::Flip_repair_2>,
                   Visited<Listener, CGAL::Circumcircle_classifier_2, CGAL::Border_splice_repair_2>,
                   Visited<Listener, CGAL::Circumcircle_classifier_2, CGAL::Relocation_repair_2>,
                   Visited<Listener, CGAL::Point_distance_classifier_2>>;
TYPED_TEST_SUITE(Listening, Ways);

TYPED_TEST(Listening, knows_all_faces_and_vertices_of_clouds_that_move)
{
  Cloud<Epick> cloud(1);
  Points points = cloud.uniform(300);
  TypeParam dt(points);
  const Hearsay& hearsay = dt.visitor().hearsay();
  EXPECT_EQ(hearsay.created_vertices, 300);
  for (const double step : {0., 0.01, 0.05, 0.2, 0.5, 30.}) {
    cloud.shake(points, step);
    const auto report = dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
    EXPECT_EQ(hearsay.report.flips, report.flips);
    EXPECT_EQ(hearsay.report.rebuild_reason, report.rebuild_reason);
  }
  dt.mend();
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  EXPECT_EQ(hearsay.updates, hearsay.finished_updates);
}

TYPED_TEST(Listening, knows_who_comes_goes_meets_and_parts)
{
  for (const bool is_lattice : {true, false})
    for (unsigned seed = 0; seed < 3; ++seed) {
      Population_player<TypeParam> player({is_lattice ? 6 : 5, is_lattice}, seed, 40);
      ASSERT_NO_FATAL_FAILURE(player.play(150)) << seed;
      ASSERT_FALSE(this->HasFailure()) << seed;
      const Hearsay& hearsay = player.triangulation().visitor().hearsay();
      EXPECT_GT(hearsay.removals, 0);
      EXPECT_TRUE(hearsay.merges > 0 || !is_lattice);
      EXPECT_EQ(hearsay.updates, hearsay.finished_updates);
    }
}

// -------------------------------------------------------------------------------------------------

TEST(Visitor, is_told_of_flips_alone_where_flips_mend_all)
{
  Cloud<Epick> cloud(2);
  Points points = cloud.uniform(300);
  using Dynamic = Visited<Listener, CGAL::Circumcircle_classifier_2, CGAL::Flip_repair_2>;
  Dynamic dt(points);
  const Hearsay before = dt.visitor().hearsay();
  cloud.shake(points, 0.02);
  const auto report = dt.update(points);
  const Hearsay& after = dt.visitor().hearsay();
  ASSERT_FALSE(report.rebuilt());
  EXPECT_GT(report.flips, 0u);
  EXPECT_EQ(std::size_t(after.flips - before.flips), report.flips);
  EXPECT_EQ(after.created_faces, before.created_faces);
}

TEST(Visitor, is_told_of_points_that_hand_their_vertex_over)
{
  Population_player<Visited<Listener>> player({4, true}, 7, 60);
  ASSERT_NO_FATAL_FAILURE(player.play(200));
  const auto& dt = player.triangulation();
  EXPECT_GT(dt.visitor().hearsay().id_changes, 0);
  EXPECT_GT(dt.visitor().hearsay().merges, 0);
}

TEST(Visitor, follows_points_on_a_line_and_back)
{
  Cloud<Epick> cloud(3);
  const Points spread = cloud.uniform(60), line = cloud.on_line(60);
  Visited<Listener> dt(line);
  for (const Points* points : {&spread, &line, &line, &spread}) {
    dt.update(*points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, *points));
  }
  EXPECT_EQ(dt.visitor().hearsay().finished_updates, 5);
}

TEST(Visitor, is_told_that_a_checkpoint_replaces_everything)
{
  Cloud<Epick> cloud(4);
  std::stringstream file;
  const Points points = cloud.uniform(50);
  Visited<Listener>(points).write_checkpoint(file);
  Visited<Listener> dt(cloud.uniform(80));
  dt.read_checkpoint(file);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  EXPECT_EQ(dt.visitor().hearsay().removals, 80);
  EXPECT_EQ(dt.visitor().hearsay().vertices.size(), 50u);
  EXPECT_EQ(dt.visitor().hearsay().finished_updates, 2);
}

// In before_update() nothing has changed yet, so CGAL's triangulation is safe to use.
struct Looks_before : CGAL::Delaunay_update_visitor_base_2
{
  template <class Dynamic>
  void before_update(const Dynamic& dt)
  {
    ASSERT_TRUE(dt.is_certified());
    EXPECT_TRUE(dt.triangulation().is_valid());
    if (dt.has_id(0))
      before = dt.point(0);
  }
  template <class Dynamic>
  void after_flip(const Dynamic& dt, const typename Dynamic::Edge&)
  {
    EXPECT_FALSE(dt.is_certified());
  }

  Epick::Point_2 before{0, 0};
};

TEST(Visitor, sees_the_last_frame_before_an_update)
{
  Cloud<Epick> cloud(6);
  Points points = cloud.uniform(100);
  Visited<Looks_before> dt(points);
  for (const double step : {0.01, 0.1, 3.}) {
    const auto last = points.front();
    cloud.shake(points, step);
    dt.update(points);
    EXPECT_EQ(dt.visitor().before, last);
  }
}

TEST(Visitor, is_told_nothing_of_input_that_is_refused)
{
  Cloud<Epick> cloud(5);
  Points points = cloud.uniform(20);
  Visited<Listener> dt(points);
  points.pop_back();
  EXPECT_THROW(dt.update(points), CGAL::Point_count_error_2);
  EXPECT_THROW(dt.remove(20), CGAL::Unknown_id_error_2);
  EXPECT_EQ(dt.visitor().hearsay().updates, 1);
}

TEST(Visitor, works_with_exact_coordinates_and_from_a_population)
{
  using Dynamic = Visited<Listener, CGAL::Circumcircle_classifier_2, CGAL::Default, Epeck>;
  CGAL::Dynamic_population_2<Dynamic> population;
  Cloud<Epeck> cloud(6);
  auto points = cloud.uniform(40);
  for (int frame = 0; frame < 6; ++frame) {
    cloud.shake(points, 0.2);
    std::map<std::int64_t, Epeck::Point_2> people;
    for (std::size_t i = std::size_t(frame); i < points.size() - std::size_t(5 - frame); ++i)
      people.emplace(std::int64_t(100 + i), points[i]);
    population.update(people.begin(), people.end());
    EXPECT_EQ(population.visitor().hearsay().vertices.size(), people.size());
  }
  EXPECT_GT(population.visitor().hearsay().removals, 0);
}

// -------------------------------------------------------------------------------------------------
// Visitors that throw

// May also throw at the beginning and the end of a call, and after a flip.
struct Throwing : Interrupting_visitor
{
  template <class... Arguments>
  void before_update(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void after_update(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void after_flip(const Arguments&...)
  {
    hear();
  }
};

// Counts what it is told of, in the plane and in periodic space.
class Counter : public CGAL::Delaunay_update_visitor_base_2
{
public:
  explicit Counter(bool is_listening = true)
    : m_is_listening(is_listening)
  {
  }
  bool is_listening() const { return m_is_listening; }

  template <class Dynamic>
  void before_update(const Dynamic&)
  {
    ++calls;
  }
  template <class Dynamic>
  void after_update(const Dynamic&, const CGAL::Update_report_2&)
  {
    ++calls;
  }
  template <class Dynamic, class Face>
  void after_face_creation(const Dynamic&, const Face&)
  {
    ++changes;
  }
  template <class Dynamic, class Edge>
  void before_flip(const Dynamic&, const Edge&)
  {
    ++changes;
  }
  template <class Dynamic, class... Edge>
  void after_edge_creation(const Dynamic&, const Edge&...)
  {
    ++changes;
  }

  int calls = 0, changes = 0;

private:
  bool m_is_listening;
};

template <class Dynamic, class... Cell>
void expect_counts(const Cell&... cell)
{
  Cloud<Epick> cloud(23);
  Points points = cloud.uniform(100);
  typename Dynamic::Settings listening, deaf;
  deaf.visitor = Counter(false);
  Dynamic heard(points, cell..., listening), unheard(points, cell..., deaf);
  cloud.shake(points, 0.02);
  const CGAL::Update_report_2 report = heard.update(points);
  EXPECT_GT(report.flips, 0u);
  EXPECT_EQ(unheard.update(points).flips, report.flips);
  std::stringstream checkpoint;
  heard.write_checkpoint(checkpoint);
  const std::string written = checkpoint.str();
  unheard.read_checkpoint(checkpoint);
  const int changes = heard.visitor().changes;
  std::istringstream in(written);
  heard.read_checkpoint(in);
  EXPECT_GT(heard.visitor().changes, changes);
  EXPECT_EQ(heard.visitor().calls, unheard.visitor().calls);
  EXPECT_EQ(unheard.visitor().changes, 0);
}

TEST(Visitor, that_does_not_listen_is_told_of_calls_alone)
{
  using Counted = CGAL::With_visitor_2<Counter>;
  expect_counts<CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, Counted>>();
  expect_counts<CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, CGAL::Default, Counted>>(
      CGAL::Periodic_cell_2(2, 0, 0, 2));
}

TEST(Visitor_that_throws, leaves_all_as_it_was_where_nothing_has_changed_yet)
{
  Cloud<Epick> cloud(10);
  const Points points = cloud.uniform(50);
  Visited<Throwing> dt(points);
  Points next = points;
  cloud.shake(next, 0.3);
  const auto expect_nothing_changes = [&](const auto& change) {
    dt.visitor().throw_at(1);
    EXPECT_THROW(change(), Refusal);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  };
  expect_nothing_changes([&] { dt.update(next); });
  expect_nothing_changes([&] { dt.move(3, next[3]); });
  expect_nothing_changes([&] { dt.insert(Epick::Point_2(1, 1)); });
  expect_nothing_changes([&] { dt.remove(3); });
  dt.update(next);
  expect_exact(dt, next);
}

TEST(Visitor_that_throws, does_not_keep_an_update_from_its_end)
{
  Cloud<Epick> cloud(11);
  Points points = cloud.uniform(200);
  Visited<Throwing> dt(points);
  int n = 2;
  for (int frame = 0; frame < 60; ++frame, n += 1 + n / 4) {
    cloud.shake(points, frame % 2 == 0 ? 0.03 : 0.1);
    dt.visitor().throw_at(n);
    try {
      dt.update(points);
      ASSERT_FALSE(dt.visitor().has_thrown());
      n = 2;
    } catch (const Refusal&) {
      ASSERT_TRUE(dt.visitor().has_thrown());
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points)) << "frame " << frame << ", call " << n;
  }
}

TEST(Visitor_that_throws, does_not_keep_points_from_coming_and_going)
{
  Points points = Cloud<Epick>(12).uniform(100);
  Visited<Throwing> dt(points);
  for (int n = 2; n < 12; ++n) {
    dt.visitor().throw_at(n);
    points.emplace_back(n, 5.5);
    EXPECT_THROW(dt.insert(points.back()), Refusal);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    dt.visitor().throw_at(n);
    EXPECT_THROW(dt.remove(points.size() - 1), Refusal);
    points.pop_back();
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

// -------------------------------------------------------------------------------------------------
// Edges that have changed

// Expects that the listed changes lead from the edges before to the edges now.
class Edge_changes : public testing::Test
{
protected:
  using Dynamic = Visited<CGAL::Edge_changes_visitor_2>;

  void expect_all_changes_listed(Dynamic& dt,
                                 const std::set<std::pair<std::size_t, std::size_t>>& before)
  {
    const auto now = edges_of(dt);
    Edges created, removed;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(),
                        std::back_inserter(created));
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(),
                        std::back_inserter(removed));
    ASSERT_EQ(dt.visitor().created_edges(), created);
    ASSERT_EQ(dt.visitor().removed_edges(), removed);
  }
};

TEST_F(Edge_changes, are_all_edges_after_construction)
{
  const Points points = Cloud<Epick>(20).uniform(100);
  Dynamic dt(points);
  expect_all_changes_listed(dt, {});
  EXPECT_TRUE(dt.visitor().removed_edges().empty());
}

TEST_F(Edge_changes, are_the_difference_between_two_frames)
{
  Cloud<Epick> cloud(21);
  Points points = cloud.uniform(300);
  Dynamic dt(points);
  for (const double step : {0., 0.001, 0.01, 0.05, 0.3, 30.}) {
    dt.visitor().clear();
    const auto before = edges_of(dt);
    cloud.shake(points, step);
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_all_changes_listed(dt, before)) << step;
  }
}

TEST_F(Edge_changes, are_told_whatever_happens_to_a_population)
{
  for (unsigned seed = 0; seed < 6; ++seed) {
    Population_player<Dynamic> player({5, seed % 2 == 0}, seed, 40);
    Dynamic& dt = player.triangulation();
    ASSERT_NO_THROW(player.start());
    for (int i = 0; i < 200; ++i) {
      dt.visitor().clear();
      const auto before = edges_of(dt);
      ASSERT_NO_THROW(player.play());
      ASSERT_NO_FATAL_FAILURE(expect_all_changes_listed(dt, before)) << seed << ", " << i;
    }
  }
}

TEST_F(Edge_changes, add_up_over_frames_until_they_are_cleared)
{
  Cloud<Epick> cloud(22);
  Points points = cloud.uniform(100);
  Dynamic dt(points);
  dt.visitor().clear();
  const auto before = edges_of(dt);
  for (int frame = 0; frame < 5; ++frame) {
    cloud.shake(points, 0.05);
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_all_changes_listed(dt, before));
  }
  EXPECT_FALSE(dt.visitor().created_edges().empty());
}

} // namespace test_visitors
