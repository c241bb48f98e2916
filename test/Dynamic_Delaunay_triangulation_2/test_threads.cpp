// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Threads change nothing but the time: results to the last bit, reports, what visitors are told,
// and what is thrown.

#define CGAL_DYNAMIC_DELAUNAY_POINTS_OF_PART 64

#include "oracle.h"
#include "random_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>

#ifdef CGAL_LINKED_WITH_TBB

#include <boost/property_map/function_property_map.hpp>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <new>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
using CGAL::Dynamic_Delaunay_triangulations_2::Position_2;
using Point = Epick::Point_2;
using Points = std::vector<Point>;

// So many points that every pass has many parts, and fewer for most of a thousand runs: every pass
// still has some parts.
constexpr std::size_t many = 2000, fewer = 400;

// How often each comparison is made: DYNAMIC_DELAUNAY_THREAD_RUNS=1000 for a longer look. At most
// `long_runs` of them are of many points.
constexpr int long_runs = 20;
int number_of_runs()
{
  const char* const text = std::getenv("DYNAMIC_DELAUNAY_THREAD_RUNS");
  return text == nullptr ? 1 : std::atoi(text);
}

// Calls `f` with a number of threads, which may be more than the machine has.
template <class Function>
void with_threads(int number, const Function& f)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena(number).execute(f);
}

template <class Dynamic, class = void>
constexpr bool is_planar = false;
template <class Dynamic>
constexpr bool is_planar<Dynamic, std::void_t<decltype(std::declval<const Dynamic&>().tds())>> =
    true;

// A hash of all that is noted, in its order: after Fowler, Noll and Vo, but for words of 64 bits,
// whose upper bits are folded into the lower ones.
class Diary
{
public:
  void note(std::string_view text)
  {
    for (std::size_t i = 0; i < text.size(); i += sizeof m_hash) {
      std::uint64_t word = 0;
      std::memcpy(&word, text.data() + i, (std::min)(sizeof word, text.size() - i));
      m_hash = (m_hash ^ word) * 0x100000001b3u;
      m_hash ^= m_hash >> 32;
    }
  }
  template <class Number>
  void note_number(Number number)
  {
    note({reinterpret_cast<const char*>(&number), sizeof number});
  }
  template <class T>
  void note_all(const std::vector<T>& numbers)
  {
    note_number(numbers.size());
    note({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)});
  }
  void note(const CGAL::Update_report_2& report)
  {
    for (const std::size_t count :
         {report.classified, report.padded, report.border, report.flips, report.splices,
          report.spliced, report.enlargements, report.relocated, report.inserted, report.removed,
          report.merged, report.parted, std::size_t(report.rebuild_reason),
          std::size_t(report.certified)})
      note_number(count);
  }
  // Notes all indices of vertices, edges and faces, and all bits of the coordinates.
  template <class Dynamic>
  void note_state(const Dynamic& dt)
  {
    std::stringstream state;
    dt.write_checkpoint(state);
    note(state.str());
  }
  // Notes what a frame may change: the edges by vertices, and CGAL's structure with all points. It
  // takes a quarter of the time of note_state(), which is called in periodic space.
  template <class Dynamic>
  void note_frame(const Dynamic& dt)
  {
    if constexpr (is_planar<Dynamic>) {
      note_all(dt.frame().edges());
      note_structure(dt);
    } else
      note_state(dt);
  }

  std::uint64_t hash() const { return m_hash; }

private:
  template <class Dynamic>
  void note_structure(const Dynamic& dt)
  {
    const auto& tds = dt.tds();
    for (auto f = tds.face_iterator_base_begin(); f != tds.face_iterator_base_end(); ++f)
      for (int i = 0; i < 3; ++i) {
        note_vertex(dt, f->vertex(i));
        note_vertices(dt, f->neighbor(i));
      }
    for (auto v = tds.vertices_begin(); v != tds.vertices_end(); ++v) {
      note_vertices(dt, v->face());
      if (v == dt.infinite_vertex())
        continue;
      note_number(v->point().x());
      note_number(v->point().y());
    }
  }
  // Faces are known by their vertices.
  template <class Dynamic>
  void note_vertices(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    if (f == typename Dynamic::Face_handle())
      return note("-");
    for (int i = 0; i < 3; ++i)
      note_vertex(dt, f->vertex(i));
  }
  template <class Dynamic>
  void note_vertex(const Dynamic& dt, typename Dynamic::Vertex_handle v)
  {
    if (v == typename Dynamic::Vertex_handle() || v == dt.infinite_vertex())
      return note("-");
    note_number(dt.id(v));
  }

  std::uint64_t m_hash = 0xcbf29ce484222325u;
};

// Notes all its notifications.
class Noting_visitor : public CGAL::Delaunay_update_visitor_base_2
{
public:
  explicit Noting_visitor(Diary* diary = nullptr)
    : m_diary(diary)
  {
  }

  template <class Dynamic>
  void before_flip(const Dynamic& dt, const typename Dynamic::Edge& e)
  {
    note_face(dt, e.first, 'f');
  }
  template <class Dynamic>
  void before_face_removal(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    note_face(dt, f, 'r');
  }
  template <class Dynamic>
  void after_face_creation(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    note_face(dt, f, 'c');
  }
  template <class Dynamic>
  void after_vertex_creation(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t id)
  {
    m_diary->note("v");
    m_diary->note_number(id);
  }
  template <class Dynamic>
  void before_vertex_removal(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t id)
  {
    m_diary->note("d");
    m_diary->note_number(id);
  }

private:
  template <class Dynamic>
  void note_face(const Dynamic& dt, typename Dynamic::Face_handle f, char kind)
  {
    m_diary->note({&kind, 1});
    for (int i = 0; i < 3; ++i) {
      const auto v = f->vertex(i);
      const bool is_finite = v != typename Dynamic::Vertex_handle() && v != dt.infinite_vertex();
      m_diary->note_number(is_finite ? dt.id(v) : std::size_t(-1));
    }
  }

  Diary* m_diary;
};

class Noting_periodic_visitor : public CGAL::Delaunay_update_visitor_base_2
{
public:
  explicit Noting_periodic_visitor(Diary* diary = nullptr)
    : m_diary(diary)
  {
  }

  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t i, std::size_t j,
                           const CGAL::Periodic_shift_2& shift)
  {
    note('c', i, j, shift);
  }
  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t i, std::size_t j,
                          const CGAL::Periodic_shift_2& shift)
  {
    note('r', i, j, shift);
  }
  template <class Dynamic>
  void after_translation(const Dynamic&, std::size_t i, const CGAL::Periodic_shift_2& shift)
  {
    note('t', i, i, shift);
  }

private:
  void note(char kind, std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift)
  {
    m_diary->note({&kind, 1});
    for (const std::size_t id : {i, j})
      m_diary->note_number(id);
    for (const int multiple : shift)
      m_diary->note_number(multiple);
  }

  Diary* m_diary;
};

template <class Tag, class Visitor = CGAL::Default>
using Planar =
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, CGAL::With_visitor_2<Visitor>,
                                           CGAL::With_concurrency_2<Tag>>;
template <class Tag, class Visitor = CGAL::Default>
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<
    Epick, CGAL::Default, CGAL::With_visitor_2<Visitor>, CGAL::With_concurrency_2<Tag>>;
using Parallel = Planar<CGAL::Parallel_tag>;

// Only frames without threads are compared with the oracle. Equal diaries prove all others right,
// since they contain everything of a triangulation.
template <class Tag>
constexpr bool is_reference = std::is_same_v<Tag, CGAL::Sequential_tag>;

template <class Play>
void expect_equal_diaries(const Play& play, int first_run, int beyond)
{
  Diary sequential;
  play.template run<CGAL::Sequential_tag>(sequential);
  for (int run = first_run; run < beyond; ++run)
    for (const int threads : {1, 2, 3, 8}) {
      Diary diary;
      with_threads(threads, [&] { play.template run<CGAL::Parallel_tag>(diary); });
      ASSERT_EQ(diary.hash(), sequential.hash()) << threads << " threads, run " << run;
    }
}

// Where `make(n)` makes a play of n points, `play.run<Tag>(diary)` has to be the same with any
// number of threads, and without the tag.
template <class Make>
void expect_equal_diaries(const Make& make)
{
  const int runs = number_of_runs();
  ASSERT_NO_FATAL_FAILURE(expect_equal_diaries(make(many), 0, (std::min)(runs, long_runs)));
  if (runs > long_runs) {
    ASSERT_NO_FATAL_FAILURE(expect_equal_diaries(make(fewer), long_runs, runs));
  }
}

template <class Dynamic>
void note_measures(Diary& diary, const Dynamic& dt)
{
  const auto note_all = [&diary](const CGAL::Voronoi_cell_measures_2& measures) {
    diary.note_all(measures.areas());
    diary.note_all(measures.perimeters());
    diary.note_all(measures.centroids());
    diary.note_all(measures.shape_indices());
  };
  CGAL::Voronoi_cell_measures_2 measures;
  measures.compute(dt);
  note_all(measures);
  CGAL::Voronoi_cell_gradients_2 gradients;
  gradients.compute(dt, measures.areas(), measures.perimeters());
  diary.note_all(gradients.gradients());
  measures.compute(dt, CGAL::Bbox_2(0, 0, 40, 30));
  note_all(measures);
}

// A population of points that are moved all together in some frames, then changes one by one.
struct Motion
{
  Points points;
  double step;
  int frames = 3;

  template <class Tag>
  void run(Diary& diary) const
  {
    play<Planar<Tag>, is_reference<Tag>>(diary, Planar<Tag>());
    using Told = Planar<Tag, Noting_visitor>;
    typename Told::Settings settings;
    settings.visitor = Noting_visitor(&diary);
    play<Told, is_reference<Tag>>(diary, Told(settings));
  }

private:
  template <class Dynamic, bool is_checked>
  void play(Diary& diary, Dynamic dt) const
  {
    Cloud<Epick> cloud(5);
    Points moved = points;
    dt.insert(moved, CGAL::Emptyset_iterator());
    diary.note_state(dt);
    for (int frame = 0; frame < frames; ++frame) {
      if (step > 0)
        cloud.shake(moved, step);
      diary.note(dt.update(moved));
      diary.note_all(dt.classified_vertices());
      diary.note_frame(dt);
      if constexpr (is_checked) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved)) << "frame " << frame;
      }
    }
    diary.note_state(dt);
    CGAL::Delaunay_neighbor_lists_2 neighbors;
    neighbors.compute(dt);
    diary.note_all(neighbors.neighbors());
    note_measures(diary, dt);
    Dynamic copy(dt);
    EXPECT_TRUE(copy.is_valid());
  }
};

// TRIANGULATIONS ----------------------------------------------------------------------------------

TEST(Threads, change_nothing_in_random_clouds_whatever_the_step)
{
  // Points hardly move; edges are flipped; everything is rebuilt; all numbers fit after a rebuild;
  // faces are turned over.
  struct Case
  {
    unsigned seed;
    double step;
    int frames;
  };
  for (const auto [seed, step, frames] :
       {Case{1, 1e-6, 12}, {2, 0.03, 3}, {3, 30, 3}, {4, 0.7, 3}, {10, 0.3, 6}}) {
    SCOPED_TRACE(testing::Message() << "step " << step);
    expect_equal_diaries([s = seed, step = step, frames = frames](std::size_t n) {
      return Motion{Cloud<Epick>(s).uniform(n), step, frames};
    });
  }
}

TEST(Threads, change_nothing_on_a_grid_full_of_ties)
{
  expect_equal_diaries([](std::size_t n) { return Motion{Cloud<Epick>::grid(n / 40, 40), 0}; });
}

TEST(Threads, change_nothing_on_a_line)
{
  expect_equal_diaries([](std::size_t n) {
    Points line;
    for (std::size_t i = 0; i < n; ++i)
      line.emplace_back(double(i * 7919 % n), 0);
    return Motion{line, 0, 1};
  });
}

TEST(Threads, change_nothing_where_points_coincide)
{
  const auto coincident = [](std::size_t n) {
    Points points = Cloud<Epick>(6).uniform(n);
    for (Point& p : points)
      p = Point(std::floor(p.x() * 2) / 2, std::floor(p.y() * 2) / 2);
    return points;
  };
  expect_equal_diaries([&](std::size_t n) { return Motion{coincident(n), 0, 1}; });
  expect_equal_diaries([&](std::size_t n) { return Motion{coincident(n), 0.001, 1}; }); // all part
}

TEST(Threads, change_nothing_where_points_are_dense_in_some_places)
{
  const auto dense = [](std::size_t n) {
    Points points = Cloud<Epick>(7).uniform(n);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double scale = std::ldexp(1.0, -int(i % 60));
      points[i] = Point(points[i].x() * scale, points[i].y() * scale);
    }
    return points;
  };
  expect_equal_diaries([&](std::size_t n) { return Motion{dense(n), 0, 1}; });
  expect_equal_diaries([&](std::size_t n) { return Motion{dense(n), 0.01, 1}; });
}

// All broken edges are repaired by splices. Where points jump, regions grow, and may merge.
struct Spliced_motion
{
  std::size_t size;
  double step, jump = 0;
  std::size_t stay = 0; // how many points there are for one that jumps
  unsigned padding = 0;
  CGAL::Static_engine_2 engine = CGAL::Static_engine_2::GUIBAS_STOLFI;

  template <class Tag>
  void run(Diary& diary) const
  {
    using Spliced = CGAL::Dynamic_Delaunay_triangulation_2<
        Epick, CGAL::Default, CGAL::With_repair_2<CGAL::Border_splice_repair_2>,
        CGAL::With_visitor_2<Noting_visitor>, CGAL::With_concurrency_2<Tag>>;
    typename Spliced::Settings settings;
    settings.repair = CGAL::Border_splice_repair_2(padding);
    settings.engines.region = engine;
    settings.visitor = Noting_visitor(&diary);
    Cloud<Epick> cloud(13);
    Points points = cloud.uniform(size);
    Spliced dt(points.begin(), points.end(), settings);
    std::size_t splices = 0, enlargements = 0;
    for (int frame = 0; frame < 8; ++frame) {
      cloud.shake(points, step);
      for (std::size_t i = std::size_t(frame); jump > 0 && i < size; i += stay)
        points[i] = cloud.shifted(points[i], jump);
      const CGAL::Update_report_2 report = dt.update(points);
      splices += report.splices;
      enlargements += report.enlargements;
      diary.note(report);
      diary.note_all(dt.padded_vertices());
      diary.note_all(dt.border_vertices());
      diary.note_frame(dt);
      if constexpr (is_reference<Tag>) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points)) << "frame " << frame;
      }
    }
    diary.note_state(dt);
    if (size == many) { // fewer points may need none
      EXPECT_GT(splices, 0u);
      EXPECT_EQ(enlargements > 0, jump > 0);
    }
  }
};

TEST(Threads, change_nothing_where_many_regions_are_spliced)
{
  for (const double step : {0.0003, 0.003, 0.02})
    expect_equal_diaries([&](std::size_t n) { return Spliced_motion{n, step}; });
  expect_equal_diaries([&](std::size_t n) { return Spliced_motion{n, 0.003, 0, 0, 1}; });
}

TEST(Threads, change_nothing_where_spliced_regions_grow_into_each_other)
{
  for (const double jump : {0.5, 1., 2.})
    expect_equal_diaries([&](std::size_t n) { return Spliced_motion{n, 0.003, jump, 100}; });
  expect_equal_diaries([&](std::size_t n) { return Spliced_motion{n, 0.003, 1, 50}; });
}

TEST(Threads, change_nothing_where_regions_are_triangulated_by_insertion)
{
  expect_equal_diaries([&](std::size_t n) {
    return Spliced_motion{n, 0.003, 1, 100, 0, CGAL::Static_engine_2::INSERTION};
  });
}

// After a heuristic classifier nothing is rebuilt, even if flips leave overlapping faces.
TEST(Threads, double_no_edge_where_flips_alone_mend_faces_that_overlap)
{
  using Flipping =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2,
                                             CGAL::With_repair_2<CGAL::Flip_repair_2>,
                                             CGAL::With_concurrency_2<CGAL::Parallel_tag>>;
  Cloud<Epick> cloud(12);
  for (const double step : {0.5, 1., 2.}) {
    Points points = cloud.uniform(many);
    Flipping dt(points.begin(), points.end(), CGAL::Random_classifier_2(1));
    for (int frame = 0; frame < 4; ++frame) {
      cloud.shake(points, step);
      with_threads(3, [&] { dt.update(points); });
      ASSERT_TRUE(dt.is_valid(true)) << "step " << step << ", frame " << frame;
    }
  }
}

// Measures of whole cells are sums over faces, divided into parts; those of clipped cells are not.
TEST(Threads, leave_out_no_face_of_a_cell)
{
  const Points points = Cloud<Epick>(11).uniform(many);
  const Parallel dt(points.begin(), points.end());
  CGAL::Voronoi_cell_measures_2 whole, clipped;
  with_threads(2, [&] {
    whole.compute(dt);
    clipped.compute(dt, CGAL::Bbox_2(-1e3, -1e3, 1e3, 1e3));
  });
  std::size_t compared = 0;
  for (std::size_t id = 0; id < many; ++id)
    if (whole.areas()[id] < 10 && clipped.areas()[id] < 10) {
      ASSERT_NEAR(whole.areas()[id], clipped.areas()[id], 1e-6) << id;
      ASSERT_NEAR(whole.perimeters()[id], clipped.perimeters()[id], 1e-6) << id;
      ++compared;
    }
  EXPECT_GT(compared, many / 2);
}

// Some points jump anywhere in each frame, by chance onto others; the others hardly move.
struct Jumps
{
  std::size_t size;
  double share;
  double step = 0.001;

  template <class Tag>
  void run(Diary& diary) const
  {
    using Told = Planar<Tag, Noting_visitor>;
    typename Told::Settings settings;
    settings.visitor = Noting_visitor(&diary);
    Cloud<Epick> cloud(16);
    Points points = cloud.uniform(size);
    Told dt(points.begin(), points.end(), settings);
    std::size_t relocated = 0, merged = 0;
    for (int frame = 0; frame < 5; ++frame) {
      cloud.shake(points, step);
      const Points places = cloud.uniform(std::size_t(share * double(size)));
      for (std::size_t i = 0; i < places.size(); ++i)
        points[(i * 7919 + std::size_t(frame) * 101) % size] =
            i % 9 == 0 ? points[(i * 31) % size] : places[i];
      const CGAL::Update_report_2 report = dt.update(points);
      relocated += report.relocated;
      merged += report.merged;
      diary.note(report);
      diary.note_frame(dt);
      if constexpr (is_reference<Tag>) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points)) << "frame " << frame;
      }
    }
    diary.note_state(dt);
    EXPECT_GT(relocated, std::size_t(share * double(size)));
    EXPECT_GT(merged, 0u);
  }
};

TEST(Threads, change_nothing_where_points_jump)
{
  expect_equal_diaries([](std::size_t n) { return Jumps{n, 0.01}; });
  expect_equal_diaries([](std::size_t n) { return Jumps{n, 0.02}; });
  expect_equal_diaries([](std::size_t n) { return Jumps{n, 0.01, 0.03}; });
}

// A share of the points leaves in every frame, and new ones come.
struct Population_motion
{
  std::size_t size;
  double share;

  template <class Tag>
  void run(Diary& diary) const
  {
    Cloud<Epick> cloud(8);
    CGAL::Dynamic_population_2<Planar<Tag>> population;
    std::vector<std::pair<std::int64_t, Point>> crowd;
    std::int64_t next = 0;
    for (const Point& p : cloud.uniform(size))
      crowd.emplace_back(next++, p);
    for (int frame = 0; frame < 4; ++frame) {
      diary.note(population.update(crowd));
      diary.note_state(population.triangulation());
      for (auto& [id, p] : crowd)
        p = cloud.shifted(p, 1e-3);
      for (std::size_t i = std::size_t(frame); i < crowd.size(); i += std::size_t(1 / share))
        crowd[i] = {next++, cloud.shifted(crowd[i].second, 1)};
    }
  }
};

TEST(Threads, change_nothing_where_points_come_and_go)
{
  expect_equal_diaries([](std::size_t n) { return Population_motion{n, 0.01}; });
  expect_equal_diaries([](std::size_t n) { return Population_motion{n, 0.05}; });
  expect_equal_diaries([](std::size_t n) { return Population_motion{n, 0.3}; });
}

// While the others rest, some points leave, and others come; a few of these coincide with others.
struct Exchange_at_rest
{
  std::size_t size, stride;

  template <class Tag>
  void run(Diary& diary) const
  {
    const Points points = Cloud<Epick>(23).uniform(size);
    play(diary, points, Planar<Tag>(points.begin(), points.end()));
    using Told = Planar<Tag, Noting_visitor>;
    typename Told::Settings settings;
    settings.visitor = Noting_visitor(&diary);
    play(diary, points, Told(points.begin(), points.end(), settings));

    const double side = std::sqrt(double(size));
    const CGAL::Periodic_cell_2 cell(side, 0, 0.3 * side, side);
    play(diary, points, Periodic<Tag>(points.begin(), points.end(), cell));
    using Told_in_cell = Periodic<Tag, Noting_periodic_visitor>;
    typename Told_in_cell::Settings settings_in_cell;
    settings_in_cell.visitor = Noting_periodic_visitor(&diary);
    play(diary, points, Told_in_cell(points.begin(), points.end(), cell, settings_in_cell));
  }

private:
  template <class Dynamic>
  void play(Diary& diary, const Points& points, Dynamic dt) const
  {
    Cloud<Epick> cloud(24);
    for (std::size_t frame = 0; frame < 4; ++frame) {
      std::vector<std::size_t> gone;
      for (std::size_t id = frame; id < size; id += stride)
        gone.push_back(id);
      Points come = cloud.uniform(gone.size());
      for (std::size_t i = 0; i < come.size(); i += 9)
        come[i] = i % 2 == 0 ? come[i / 2] : points[i];
      diary.note(dt.remove(gone));
      diary.note_state(dt);
      diary.note(dt.insert(come));
      diary.note_state(dt);
      EXPECT_TRUE(dt.is_certified());
      EXPECT_TRUE(dt.is_valid());
    }
  }
};

TEST(Threads, change_nothing_where_points_come_and_go_at_rest)
{
  expect_equal_diaries([](std::size_t n) { return Exchange_at_rest{n, 50}; });
  expect_equal_diaries([](std::size_t n) { return Exchange_at_rest{n, 15}; });
}

// In a sheared cell, to which the points are not wrapped.
struct Periodic_motion
{
  std::size_t size;
  double step;
  int frames = 5;
  bool has_flips = true;

  template <class Tag>
  void run(Diary& diary) const
  {
    play<Periodic<Tag>>(diary, {});
    using Told = Periodic<Tag, Noting_periodic_visitor>;
    typename Told::Settings settings;
    settings.visitor = Noting_periodic_visitor(&diary);
    play<Told>(diary, settings);
  }

private:
  template <class Dynamic>
  void play(Diary& diary, const typename Dynamic::Settings& settings) const
  {
    std::mt19937_64 random(9);
    const double side = std::sqrt(double(size));
    Points points = random_points(random, size, 3 * side);
    const CGAL::Periodic_cell_2 cell(side, 0, 0.3 * side, side);
    Dynamic dt(points.begin(), points.end(), cell, settings);
    diary.note_state(dt);
    std::size_t flips = 0;
    for (int frame = 0; frame < frames; ++frame) {
      for (Point& p : points)
        p = Point(p.x() + random_between(random, -step, step),
                  p.y() + random_between(random, -step, step));
      const CGAL::Update_report_2 report = dt.update(points);
      flips += report.flips;
      diary.note(report);
      diary.note_state(dt);
    }
    EXPECT_EQ(flips > 0, has_flips);
    EXPECT_TRUE(dt.is_valid());
  }
};

TEST(Threads, free_ids_that_new_points_get_from_the_smallest_on)
{
  const Points points = Cloud<Epick>(8).uniform(20000);
  Parallel dt(points);
  std::vector<std::size_t> gone(points.size());
  std::iota(gone.begin(), gone.end(), std::size_t(0));
  std::shuffle(gone.begin(), gone.end(), std::mt19937(8));
  gone.resize(2000);
  EXPECT_FALSE(dt.remove(gone).rebuilt());
  std::sort(gone.begin(), gone.end());
  gone.resize(5);
  std::vector<std::size_t> ids;
  dt.insert(Points(points.begin(), points.begin() + 5), std::back_inserter(ids));
  EXPECT_EQ(ids, gone);
}

TEST(Threads, change_nothing_in_periodic_space)
{
  expect_equal_diaries([](std::size_t n) { return Periodic_motion{n, 1e-5, 5, false}; });
  expect_equal_diaries([](std::size_t n) { return Periodic_motion{n, 0.03}; });
  expect_equal_diaries([](std::size_t n) { return Periodic_motion{n, 0.15}; });
}

TEST(Threads, change_nothing_where_all_points_of_a_cell_are_triangulated_anew)
{
  expect_equal_diaries([](std::size_t n) { return Periodic_motion{n, 10, 2, false}; });
}

// If the triangulation of all points at once failed, they would be inserted one by one.
TEST(Threads, triangulate_all_points_of_a_cell_at_once)
{
  std::vector<Position_2> positions;
  for (const Point& p : Cloud<Epick>(17).uniform(many))
    positions.push_back({p.x(), p.y()});
  const double side = std::sqrt(double(many));
  const internal::Torus_2 torus(CGAL::Periodic_cell_2(side, side));
  internal::Torus_triangulator_2<> one;
  ASSERT_TRUE(one.run(torus, positions));
  for (const int threads : {1, 2, 3, 8})
    with_threads(threads, [&] {
      internal::Torus_triangulator_2<internal::Parallel_parts<CGAL::Parallel_tag>> builder;
      ASSERT_TRUE(builder.run(torus, positions));
      EXPECT_EQ(builder.faces().apexes, one.faces().apexes);
      EXPECT_EQ(builder.faces().twins, one.faces().twins);
      EXPECT_EQ(builder.faces().shifts, one.faces().shifts);
      EXPECT_EQ(builder.faces().points, one.faces().points);
    });
}

// Points on small grids, each in an image of its own far away: rounded back into the cell, the
// grids have other diagonals than what is there. No part may be left out of the search for these.
TEST(Threads, find_all_edges_of_a_cell_that_rounding_makes_wrong)
{
  using Torus =
      CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                                      CGAL::With_concurrency_2<CGAL::Parallel_tag>>;
  const double side = std::sqrt(double(many));
  for (const double spacing : {1e-2, 1e-9, 1e-11}) {
    Points points = Cloud<Epick>(19).uniform(many);
    for (std::size_t i = 0; i < many / 4; ++i) {
      const std::size_t grid = i / 16, place = i % 16;
      const double x = side * (0.1 + 0.15 * double(grid % 6)) + spacing * double(place % 4);
      const double y = side * (0.1 + 0.15 * double(grid / 6)) + spacing * double(place / 4);
      points[i] = Point(x + double(i % 1009) * side, y + double(i % 2003) * side);
    }
    with_threads(2, [&] {
      const Torus dt(points.begin(), points.end(), CGAL::Periodic_cell_2(side, side));
      EXPECT_TRUE(dt.is_certified() && dt.is_valid()) << spacing;
    });
  }
}

// A frame examines no edge, and mend() then examines all.
struct Mended_cell
{
  std::size_t size;

  template <class Tag>
  void run(Diary& diary) const
  {
    using Heuristic =
        CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2,
                                                        CGAL::With_concurrency_2<Tag>>;
    Cloud<Epick> cloud(18);
    Points points = cloud.uniform(size);
    const double side = std::sqrt(double(size));
    Heuristic dt(points.begin(), points.end(), CGAL::Periodic_cell_2(side, side),
                 CGAL::Random_classifier_2(0));
    cloud.shake(points, 0.05);
    diary.note(dt.update(points));
    diary.note(dt.mend());
    diary.note_state(dt);
    EXPECT_TRUE(dt.is_certified());
    EXPECT_TRUE(dt.is_valid());
  }
};

TEST(Threads, change_nothing_where_a_cell_is_mended)
{
  expect_equal_diaries([](std::size_t n) { return Mended_cell{n}; });
}

// The points of a grid are triangulated at once, but ties are broken differently in different
// images, so the points are then inserted one by one.
struct Periodic_grid
{
  std::size_t columns;

  template <class Tag>
  void run(Diary& diary) const
  {
    const Points points = Cloud<Epick>::grid(columns, 30);
    const Periodic<Tag> dt(points.begin(), points.end(),
                           CGAL::Periodic_cell_2(double(columns), 30));
    diary.note_state(dt);
    EXPECT_TRUE(dt.is_valid());
  }
};

TEST(Threads, change_nothing_where_points_of_a_cell_form_a_grid)
{
  expect_equal_diaries([](std::size_t n) { return Periodic_grid{n / 30}; });
}

// QUERIES -----------------------------------------------------------------------------------------

// Queries for places among the points and outside of them, also with coincidences and ties.
struct Queries
{
  std::size_t size;

  template <class Tag>
  void run(Diary& diary) const
  {
    const std::size_t columns = size / 30;
    Points points = Cloud<Epick>::grid(columns, 30);
    points.push_back(points[77]);
    const Planar<Tag> plane(points.begin(), points.end());
    ask(diary, CGAL::Delaunay_point_queries_2<Planar<Tag>>(plane));
    const Periodic<Tag> cell(points.begin(), points.end(),
                             CGAL::Periodic_cell_2(double(columns), 0, 3, 30));
    ask(diary, CGAL::Delaunay_point_queries_2<Periodic<Tag>>(cell));
  }

private:
  template <class Point_queries>
  static void ask(Diary& diary, const Point_queries& queries)
  {
    Points places = Cloud<Epick>(14).uniform(500);
    for (const Point& p : Cloud<Epick>::grid(20, 20))
      places.push_back(Point(p.x() + 0.5, p.y()));
    using Nearest = decltype(queries.nearest(places[0]));
    using Answer = typename Nearest::value_type;
    std::vector<Nearest> nearest;
    queries.nearest(places.begin(), places.end(), std::back_inserter(nearest));
    std::vector<Answer> within;
    std::vector<std::size_t> begins;
    queries.within(places.begin(), places.end(), 2, within, begins);
    ASSERT_EQ(nearest.size(), places.size());
    ASSERT_EQ(begins.size(), places.size() + 1);
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(nearest[i], queries.nearest(places[i])) << i;
      std::vector<Answer> around;
      queries.within(places[i], 2, std::back_inserter(around));
      std::sort(around.begin(), around.end());
      ASSERT_EQ(std::vector<Answer>(within.begin() + std::ptrdiff_t(begins[i]),
                                    within.begin() + std::ptrdiff_t(begins[i + 1])),
                around)
          << i;
      diary.note_number(*nearest[i]);
    }
    diary.note_all(within);
    diary.note_all(begins);
  }
};

TEST(Threads, change_nothing_where_many_places_ask_for_points)
{
  expect_equal_diaries([](std::size_t n) { return Queries{n}; });
}

TEST(Threads, name_the_first_place_that_is_none_and_answer_nothing)
{
  const Points points = Cloud<Epick>(15).uniform(many);
  const Parallel dt(points.begin(), points.end());
  const CGAL::Delaunay_point_queries_2<Parallel> queries(dt);
  Points places = points;
  places[many - 9] = places[1234] = Point(0, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> ids{7}, begins{8};
  std::vector<std::optional<std::size_t>> nearest;
  for (const int threads : {1, 2, 8})
    with_threads(threads, [&] {
      const auto expect_refusal = [&](const auto& ask) {
        try {
          ask();
          ADD_FAILURE() << "was accepted";
        } catch (const CGAL::Non_finite_coordinate_error_2& error) {
          EXPECT_EQ(error.id(), 1234u);
        }
      };
      expect_refusal(
          [&] { queries.nearest(places.begin(), places.end(), std::back_inserter(nearest)); });
      expect_refusal([&] { queries.within(places.begin(), places.end(), 1, ids, begins); });
    });
  EXPECT_TRUE(nearest.empty());
  EXPECT_EQ(ids, std::vector<std::size_t>{7});
  EXPECT_EQ(begins, std::vector<std::size_t>{8});
}

// INPUT THAT IS REFUSED ---------------------------------------------------------------------------

template <class Dynamic>
std::uint64_t state_of(const Dynamic& dt)
{
  Diary diary;
  diary.note_state(dt);
  return diary.hash();
}

TEST(Threads, refuse_the_first_wrong_coordinate_and_change_nothing)
{
  Cloud<Epick> cloud(10);
  Points points = cloud.uniform(many);
  Parallel dt(points);
  const std::uint64_t before = state_of(dt);
  Points moved = points;
  cloud.shake(moved, 0.1);
  for (const std::size_t id : {many - 500, many / 2, std::size_t(3)}) {
    moved[id] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
    for (const int threads : {1, 2, 8}) {
      with_threads(threads, [&] {
        try {
          dt.update(moved);
          ADD_FAILURE() << "was accepted";
        } catch (const CGAL::Non_finite_coordinate_error_2& error) {
          EXPECT_EQ(error.id(), id);
        }
      });
      ASSERT_EQ(state_of(dt), before);
    }
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Threads, pass_on_what_a_point_map_throws_and_change_nothing)
{
  Cloud<Epick> cloud(11);
  Points points = cloud.uniform(many);
  Parallel dt(points);
  const std::uint64_t before = state_of(dt);
  Points moved = points;
  cloud.shake(moved, 0.1);
  for (const int threads : {1, 2, 8}) {
    const auto read = [&](const Point& p) {
      if (&p == &moved[777])
        throw std::bad_alloc();
      return p;
    };
    with_threads(threads, [&] {
      EXPECT_THROW(dt.update(moved.begin(), moved.end(),
                             boost::make_function_property_map<Point, Point>(read)),
                   std::bad_alloc);
    });
    ASSERT_EQ(state_of(dt), before);
  }
  dt.update(moved);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved));
}

// PARTS -------------------------------------------------------------------------------------------

TEST(Parts, are_a_partition_that_depends_on_the_size_alone)
{
  using Parts = internal::Parallel_parts<CGAL::Parallel_tag>;
  for (const std::size_t size : {0u, 1u, 99u, 1000u, 65536u, 1234567u}) {
    for (const int threads : {1, 2, 8})
      with_threads(threads, [&] {
        std::vector<std::pair<std::size_t, std::size_t>> ranges(Parts::number(size, 100));
        Parts::for_each(size, 100, [&](std::size_t part, std::size_t first, std::size_t beyond) {
          ranges.at(part) = {first, beyond};
        });
        std::size_t end = 0;
        for (const auto& [first, beyond] : ranges) {
          EXPECT_EQ(first, end);
          EXPECT_TRUE(ranges.size() == 1 || beyond - first >= 100);
          end = beyond;
        }
        EXPECT_EQ(end, size);
      });
  }
}

// Tries to flip every edge in each of four parts, in the space that this makes.
template <class Dynamic>
void try_flips_in_parts(
    const typename internal::Triangulation_types_2<Dynamic>::State::Argument& argument)
{
  using State = typename internal::Triangulation_types_2<Dynamic>::State;
  const Points points = Cloud<Epick>(20).uniform(fewer);
  using namespace CGAL::Dynamic_Delaunay_triangulations_2;
  std::vector<Point_id> ids(points.size());
  std::iota(ids.begin(), ids.end(), Point_id(0));
  State state(argument);
  typename State::Builder(state).build_with({}, ids, points);
  internal::Topology_editor_2<State> editor(state);
  const std::size_t vertices = state.positions().size(), parts = 4, most = 3 * parts * fewer;
  const internal::Topology_parts_2 topology(state.arrays(), vertices, parts);
  std::size_t flips = 0, hidden = 0, between = 0;
  editor.flip_in_parts(topology, false, most, [&](std::size_t part, const auto& try_flip) {
    for (Edge_index e(0); e < state.arrays().number_of_edges(); ++e) {
      const auto edge = state.arrays().edge(e);
      const auto is_in_part = [&](Vertex_index v) { return topology.part_of(v) == part; };
      const bool is_shown = edge.source != edge.target;
      const bool is_inside = is_shown && is_in_part(edge.source) && is_in_part(edge.target) &&
                             is_in_part(edge.left) && is_in_part(edge.right);
      EXPECT_EQ(topology.is_inside(part, e), is_inside) << part << ' ' << e;
      const bool is_flipped = try_flip(state.arrays().halfedge(e));
      EXPECT_FALSE(is_flipped && !is_inside) << part << ' ' << e;
      flips += is_flipped;
      hidden += !is_shown;
      between += is_shown && is_in_part(edge.source) && is_in_part(edge.target) && !is_inside;
    }
  });
  EXPECT_GT(flips, fewer / 2);
  EXPECT_GT(between, fewer / 40);
  EXPECT_EQ(hidden > 0, State::is_periodic);
}

TEST(Parts, flip_only_edges_with_all_vertices_there)
{
  const double side = std::sqrt(double(fewer));
  try_flips_in_parts<Planar<CGAL::Sequential_tag>>(Epick());
  try_flips_in_parts<Periodic<CGAL::Sequential_tag>>(CGAL::Periodic_cell_2(side, side));
}

TEST(Parts, have_their_elements_of_a_list_in_its_order)
{
  using Parts = internal::Parallel_parts<CGAL::Parallel_tag>;
  constexpr std::size_t parts = 5;
  std::vector<int> list(many);
  std::iota(list.begin(), list.end(), 0);
  const auto part_of = [](std::size_t i) { return i * i % 7 % parts; };
  for (const int threads : {1, 2, 8})
    with_threads(threads, [&] {
      internal::Divided_list<int> divided;
      divided.divide<Parts>(list, parts, part_of);
      for (std::size_t part = 0; part < parts; ++part) {
        std::vector<int> expected;
        std::copy_if(list.begin(), list.end(), std::back_inserter(expected),
                     [&](int i) { return part_of(std::size_t(i)) == part; });
        EXPECT_EQ(std::vector<int>(divided.begin(part), divided.end(part)), expected) << part;
      }
    });
}

TEST(Parts, find_each_index_once)
{
  using Parts = internal::Parallel_parts<CGAL::Parallel_tag>;
  using CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
  std::vector<Edge_index> indices;
  for (std::size_t i = 0; i < many; ++i)
    indices.push_back(Edge_index(i * i % many));
  std::vector<Edge_index> expected = indices;
  std::sort(expected.begin(), expected.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  for (const int threads : {1, 2, 8})
    with_threads(threads, [&] {
      std::vector<Edge_index> found = indices;
      internal::make_distinct_by_parts<Parts>(found);
      EXPECT_EQ(found, expected);
    });
}

TEST(Parts, are_shared_by_as_many_threads_as_the_program_allows)
{
  using Parts = internal::Parallel_parts<CGAL::Parallel_tag>;
  with_threads(3, [] {
    EXPECT_EQ(Parts::most_workers(), 3u);
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(Parts::most_workers(), 1u);
  });
}

TEST(Parts, throw_what_the_first_one_throws)
{
  using Parts = internal::Parallel_parts<CGAL::Parallel_tag>;
  for (const int threads : {1, 2, 3, 8})
    for (int run = 0; run < 200; ++run)
      with_threads(threads, [&] {
        try {
          Parts::run(40, [](std::size_t part) {
            if (part % 7 == 5)
              throw std::runtime_error(std::to_string(part));
          });
          ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
          EXPECT_STREQ(error.what(), "5");
        }
      });
}

// The first part waits until the second one has failed, if that has begun at all.
TEST(Parts, throw_what_the_first_one_throws_also_where_it_is_not_the_first_to_throw)
{
  using Parts = internal::Parallel_parts<CGAL::Parallel_tag>;
  using Clock = std::chrono::steady_clock;
  std::atomic<bool> has_failed{false};
  const auto end_of_patience = Clock::now() + std::chrono::seconds(20);
  with_threads(2, [&] {
    try {
      Parts::run(2, [&](std::size_t part) {
        while (part == 0 && !has_failed && Clock::now() < end_of_patience)
          std::this_thread::yield();
        has_failed = true;
        throw std::runtime_error(std::to_string(part));
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "0");
    }
  });
}

TEST(Parts, can_be_divided_again)
{
  using Parts = internal::Parallel_parts<CGAL::Parallel_tag>;
  for (const int threads : {1, 2, 8})
    with_threads(threads, [&] {
      std::atomic<std::size_t> sum{0};
      Parts::run(10, [&](std::size_t i) { Parts::run(i, [&](std::size_t k) { sum += k; }); });
      EXPECT_EQ(sum, 120u);
    });
}

} // namespace

#endif // CGAL_LINKED_WITH_TBB
