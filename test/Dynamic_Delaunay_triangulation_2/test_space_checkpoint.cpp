// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A triangulation in space that was written and read goes on as the original does; a file that is
// no checkpoint of one is refused and changes nothing.

#include "forged_checkpoint.h"
#include "replaced_heap.h"
#include "space_operations.h"
#include "space_oracle.h"
#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <new>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_space_checkpoint {

using CGAL::Checkpoint_error_2;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Epick>;
using Exact = CGAL::Dynamic_Delaunay_triangulation_3<Epeck>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using space_operations::Program;
using space_points::random_points;

template <class Any>
std::map<std::size_t, typename Any::Point> points_of(const Any& dt)
{
  std::map<std::size_t, typename Any::Point> points;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id))
      points.emplace(id, dt.point(id));
  return points;
}

template <class Any>
void read(Any& dt, const std::string& text)
{
  std::istringstream in(text);
  dt.read_checkpoint(in);
}

// The error with which the text is refused; an error of line 0 if it is accepted.
template <class Any>
Checkpoint_error_2 refusal(Any& dt, const std::string& text)
{
  try {
    read(dt, text);
  } catch (const Checkpoint_error_2& error) {
    return error;
  }
  return Checkpoint_error_2(0, "accepted");
}

template <class Any = Dynamic>
std::string reason(const std::string& text)
{
  Any dt;
  const std::string what = refusal(dt, text).what();
  EXPECT_TRUE(what == "checkpoint: accepted" || dt.number_of_points() == 0);
  return what;
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t place = text.find(what);
  EXPECT_NE(place, text.npos) << what;
  return resealed(text.replace(place, what.size(), by));
}

// All that a triangulation says about its cells, in its order.
template <class Any>
std::vector<std::size_t> told_by(const Any& dt)
{
  std::vector<std::size_t> told;
  const auto tell_all = [&](const auto& ids) { told.insert(told.end(), ids.begin(), ids.end()); };
  dt.for_each_cell(tell_all);
  dt.for_each_facet(tell_all);
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    told.push_back(i);
    told.push_back(j);
  });
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id)) {
      told.push_back(dt.representative(id));
      dt.for_each_neighbor(id, [&](std::size_t j) { told.push_back(j); });
    }
  return told;
}

auto all_of(const CGAL::Update_report_3& r)
{
  return std::tie(r.unproved, r.flips, r.held, r.relocated, r.inserted, r.removed, r.merged,
                  r.parted, r.rebuild_reason, r.certified);
}

// RUNS THAT ARE INTERRUPTED -----------------------------------------------------------------------

// Checkpoints have all numbers of vertices and cells in their order, so nothing else is compared
// but what they do not have.
template <class Any>
void expect_interruptions_to_change_nothing(Program<Any> run, int operations, bool is_compared)
{
  Program<Any> interrupted = run;
  for (int i = 0; i < operations; ++i) {
    SCOPED_TRACE(testing::Message() << "operation " << i);
    ASSERT_NO_FATAL_FAILURE(interrupted.interrupt());
    if (is_compared) {
      ASSERT_EQ(told_by(run.triangulation()), told_by(interrupted.triangulation()));
    }
    ASSERT_NO_FATAL_FAILURE(run.do_something());
    ASSERT_NO_FATAL_FAILURE(interrupted.do_something());
    ASSERT_EQ(checkpoint_of(run.triangulation()), checkpoint_of(interrupted.triangulation()));
  }
  ASSERT_NO_FATAL_FAILURE(
      space_oracle::expect_exact(interrupted.triangulation(), interrupted.points()));
}

class Interrupted_program : public testing::TestWithParam<std::tuple<int, double, double>>
{
};

TEST_P(Interrupted_program, goes_on_as_if_it_had_not_been_interrupted)
{
  const auto [seed, extent, grid] = GetParam();
  Program<Dynamic> program(std::uint64_t(seed), extent, grid);
  program.insert(std::size_t(13 * seed % 97));
  expect_interruptions_to_change_nothing(program, 60, true);
}
INSTANTIATE_TEST_SUITE_P(anywhere, Interrupted_program,
                         testing::Combine(testing::Range(0, 12), testing::Values(1.0),
                                          testing::Values(0.0)));
INSTANTIATE_TEST_SUITE_P(on_a_grid, Interrupted_program,
                         testing::Combine(testing::Range(20, 32), testing::Values(1.0),
                                          testing::Values(0.25)));
INSTANTIATE_TEST_SUITE_P(far_and_near, Interrupted_program,
                         testing::Combine(testing::Range(40, 42), testing::Values(1e-150, 1e70),
                                          testing::Values(0.0)));

// How coordinates were rounded in computing them is not kept for points that coincide with others.
TEST(Interrupted_program_of_an_exact_kernel, goes_on_with_the_same_triangulations)
{
  Program<Exact> program(5);
  program.insert(30);
  expect_interruptions_to_change_nothing(program, 15, true);
}

TEST(Interrupted_run, has_the_same_reports_of_many_points)
{
  Points points = random_points(3000);
  points[7] = points[2900];
  Dynamic run(points), other;
  std::mt19937_64 random(3);
  std::normal_distribution<double> step(0, 0.002);
  std::size_t flips = 0;
  for (int frame = 0; frame < 10; ++frame) {
    if (frame % 3 == 0)
      read(other, checkpoint_of(run));
    for (Point& p : points) {
      const double x = p.x() + step(random), y = p.y() + step(random);
      p = Point(x, y, p.z() + step(random));
    }
    const CGAL::Update_report_3 report = run.update(points);
    flips += report.flips;
    ASSERT_EQ(all_of(report), all_of(other.update(points)));
    ASSERT_EQ(checkpoint_of(run), checkpoint_of(other));
  }
  EXPECT_GT(flips, 1000u);
}

TEST(Space_checkpoints, may_be_written_and_read_by_streams_one_after_the_other)
{
  const Dynamic first(random_points(20)), second(random_points(7, 2));
  std::stringstream file;
  file << first << "\n " << second << "rest";
  Dynamic a, b;
  EXPECT_TRUE(file >> a >> b);
  EXPECT_EQ(checkpoint_of(a), checkpoint_of(first));
  EXPECT_EQ(checkpoint_of(b), checkpoint_of(second));
  std::string rest;
  file >> rest;
  EXPECT_EQ(rest, "rest");
  std::istringstream nonsense("nonsense");
  EXPECT_FALSE(nonsense >> a);
  EXPECT_EQ(checkpoint_of(a), checkpoint_of(first));
}

TEST(Space_checkpoints, free_ids_are_given_again_from_the_smallest_on)
{
  Dynamic dt(random_points(30)), other;
  dt.remove({29, 4, 17});
  read(other, checkpoint_of(dt));
  EXPECT_EQ(other.number_of_ids(), 30u);
  for (const std::size_t id : {4u, 17u, 29u, 30u})
    EXPECT_EQ(other.insert(Point(0.5, 0.5, double(id))), id);
}

TEST(Space_checkpoints, the_example_in_the_manual_is_a_checkpoint)
{
  Dynamic dt(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}, {2, 2, 2}});
  dt.remove(5);
  EXPECT_EQ(checkpoint_of(dt),
            "Dynamic_Delaunay_triangulation_3 checkpoint 1\ncoordinates double\npositions exact\n"
            "dimension 3\nids 6\nvertices 4\n3 0 0 1\n0 0 0 0\n2 0 1 0\n1 1 0 0\n"
            "duplicates 1\n4 3 0 1 0\nfree_ids 1\n5\norigin 0.20618 0.39283 0.20865\n"
            "cells 5\n1 2 3 4\n1 2 4 0\n1 2 0 3\n1 3 0 4\n2 3 4 0\n"
            "corners 5\n19\n12\n16\n17\n18\nchecksum 6c2fdfdb\n");
}

// Neighboring doubles have no double between them.
TEST(Space_checkpoints, may_be_of_points_around_no_double)
{
  const double a = 0x1p53;
  for (const Points& points :
       {Points{{a, a, a}, {a + 2, a, a}, {a, a + 2, a}, {a, a, a + 2}},
        Points{{a, a, a}, {a + 2, a, a}, {a, a + 2, a}, {a, a, a + 2}, {a + 2, a + 2, a + 2}}}) {
    Dynamic dt(points), other;
    const std::string text = checkpoint_of(dt);
    EXPECT_NE(text.find("\norigin none\n"), text.npos);
    read(other, text);
    EXPECT_EQ(checkpoint_of(other), text);
    EXPECT_TRUE(other.certify());
    ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(other, points_of(dt)));
  }
}

// FILES THAT ARE REFUSED --------------------------------------------------------------------------

// Small ones, with and without cells, with points that coincide, and free ids.
std::vector<Dynamic> specimens()
{
  Points points = random_points(8);
  points[4] = points[2];
  Dynamic space(points);
  space.remove(6);
  return {space, Dynamic(), Dynamic(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}})};
}

void expect_readable(const Checkpoint_error_2& error, const std::string& text)
{
  EXPECT_GT(error.line(), 0u);
  EXPECT_LE(error.line(), std::size_t(std::count(text.begin(), text.end(), '\n')) + 1);
  EXPECT_LT(std::string(error.what()).size(), 500u);
}

TEST(Space_checkpoints, that_end_too_early_are_refused)
{
  Dynamic target(random_points(5));
  const std::string before = checkpoint_of(target);
  for (const Dynamic& dt : specimens()) {
    const std::string text = checkpoint_of(dt);
    for (std::size_t size = 0; size < text.size(); ++size) {
      const Checkpoint_error_2 error = refusal(target, text.substr(0, size));
      ASSERT_GT(error.line(), 0u) << "of " << text.size() << " bytes, " << size;
      ASSERT_NO_FATAL_FAILURE(expect_readable(error, text));
    }
    ASSERT_EQ(checkpoint_of(target), before);
  }
}

TEST(Space_checkpoints, with_a_byte_that_is_another_are_refused)
{
  Dynamic target(random_points(5));
  const std::string before = checkpoint_of(target);
  std::size_t number = 0;
  for (const Dynamic& dt : specimens()) {
    const std::string original = checkpoint_of(dt);
    for (std::size_t place = 0; place < original.size(); ++place)
      for (const unsigned change : {1u, 2u, 4u, 8u, 16u, 32u, 64u, 128u, 255u}) {
        std::string text = original;
        text[place] = char((unsigned char)(text[place]) ^ change);
        ASSERT_GT(refusal(target, text).line(), 0u) << "byte " << place << ", " << change;
        ++number;
      }
    ASSERT_EQ(checkpoint_of(target), before);
  }
  EXPECT_GT(number, 5000u);
}

// What is accepted of files that were edited is right, and goes on.
void expect_harmless(const std::string& text, std::size_t& accepted)
{
  Dynamic dt;
  const Checkpoint_error_2 error = refusal(dt, text);
  if (error.line() > 0) {
    EXPECT_EQ(dt.number_of_points(), 0u);
    return expect_readable(error, text);
  }
  ++accepted;
  const auto points = points_of(dt);
  ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(dt, points)) << text;
  Points frame(dt.number_of_ids(), Point(0, 0, 0));
  for (const auto& [id, p] : points)
    frame[id] = p;
  dt.update(frame);
  dt.insert(Point(0.3, 0.3, 0.3));
  ASSERT_TRUE(dt.is_valid(true)) << text;
}

TEST(Space_checkpoints, with_a_byte_that_is_another_and_the_right_sum_do_no_harm)
{
  std::size_t accepted = 0;
  for (const Dynamic& dt : specimens()) {
    const std::string original = checkpoint_of(dt);
    const std::size_t end = original.rfind("checksum ");
    for (std::size_t place = 0; place < end; ++place)
      for (const char c : {'0', '1', '7', ' ', '-', '.', '\n', 'e'}) {
        std::string text = original;
        text[place] = c;
        ASSERT_NO_FATAL_FAILURE(expect_harmless(resealed(text), accepted)) << "byte " << place;
      }
  }
  EXPECT_GT(accepted, 100u); // others coordinates
}

TEST(Space_checkpoints, that_were_forged_do_no_harm)
{
  unsigned seed = 0;
  std::size_t accepted = 0;
  for (const Dynamic& dt : specimens()) {
    Forger forger(checkpoint_of(dt), ++seed);
    for (int i = 0; i < 3000; ++i)
      ASSERT_NO_FATAL_FAILURE(expect_harmless(forger.forged(), accepted));
  }
  EXPECT_GT(accepted, 100u);
}

// A file with these points, in their order, and these cells; the origin is (1/4, 1/4, 1/4).
std::string file_of(const Points& points, const std::vector<std::array<unsigned, 4>>& cells,
                    const std::string& origin = "0.25 0.25 0.25")
{
  std::ostringstream out;
  out << "Dynamic_Delaunay_triangulation_3 checkpoint 1\ncoordinates double\npositions exact\n"
      << "dimension 3\nids " << points.size() << "\nvertices " << points.size() << '\n';
  for (std::size_t i = 0; i < points.size(); ++i)
    out << i << ' ' << points[i] << '\n';
  out << "duplicates 0\nfree_ids 0\norigin " << origin << "\ncells " << cells.size() << '\n';
  std::vector<std::size_t> corners(points.size() + 1, 0);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      out << cells[c][i] << (i < 3 ? ' ' : '\n');
      if (cells[c][i] < corners.size())
        corners[cells[c][i]] = 4 * c + i;
    }
  out << "corners " << corners.size() << '\n';
  for (const std::size_t k : corners)
    out << k << '\n';
  return sealed(out.str());
}

using Cells = std::vector<std::array<unsigned, 4>>;

// A positive cell of these vertices, and the infinite ones around it.
Cells cells_around(unsigned a, unsigned b, unsigned c, unsigned d)
{
  return {{a, b, c, d}, {a, 0, d, c}, {d, b, 0, a}, {b, a, c, 0}, {0, c, b, d}};
}

const Points corner{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
const std::string accepted = "checkpoint: accepted";
const std::string wrong = "checkpoint, line 14: the cells are not a Delaunay triangulation";

TEST(Space_checkpoints, may_be_written_by_others)
{
  EXPECT_EQ(reason(file_of(corner, cells_around(1, 2, 3, 4))), accepted);
  EXPECT_EQ(reason(file_of(corner, cells_around(1, 2, 3, 4), "none")), accepted);
}

TEST(Space_checkpoints, have_to_have_positive_cells_around_their_origin)
{
  for (const char* origin : {"0.25 0.25 -0.25", "5 5 5", "0 0 0"})
    EXPECT_EQ(reason(file_of(corner, cells_around(1, 2, 3, 4), origin)), wrong);
  for (const char* origin : {"0.25 0.25 0.25", "none"})
    EXPECT_EQ(reason(file_of(corner, cells_around(2, 1, 3, 4), origin)), wrong);
  EXPECT_EQ(reason(file_of(corner, cells_around(1, 2, 3, 4), "nan 0 0")),
            "checkpoint, line 13: the origin is \"nan\", and has to be none or a finite number");
  EXPECT_EQ(reason(file_of(corner, cells_around(1, 2, 3, 4), "0 1e999 0")),
            "checkpoint, line 13: the origin is \"1e999\", and has to be a finite number");
  EXPECT_EQ(reason(file_of(corner, cells_around(1, 2, 3, 4), "none 1")),
            "checkpoint, line 13: \"1\" is too much in this line");
}

// All cells are positive, and all facets legal.
TEST(Space_checkpoints, must_not_cover_space_twice)
{
  Points points = corner;
  for (const Point& p : corner)
    points.emplace_back(1.25 * p.x() - 0.1, 1.25 * p.y() - 0.1, 1.25 * p.z() - 0.1);
  Cells cells = cells_around(1, 2, 3, 4);
  for (const std::array<unsigned, 4>& cell : cells_around(5, 6, 7, 8))
    cells.push_back(cell);
  for (const char* origin : {"0.25 0.2 0.15", "none"}) {
    std::string text = file_of(points, cells, origin);
    EXPECT_EQ(reason(text), "checkpoint, line 18: the cells are not a Delaunay triangulation");
  }
}

TEST(Space_checkpoints, have_to_have_cells_that_fit_together)
{
  const std::string facets = ": not exactly two cells have one of the facets";
  Cells cells = cells_around(1, 2, 3, 4);
  cells.push_back(cells[0]);
  EXPECT_EQ(reason(file_of(corner, cells)), "checkpoint, line 15" + facets);
  cells = cells_around(1, 2, 3, 4);
  cells.insert(cells.end(), 2, {1, 0, 4, 3});
  EXPECT_EQ(reason(file_of(corner, cells)), "checkpoint, line 16" + facets);
  cells = cells_around(1, 2, 3, 4);
  cells.pop_back();
  EXPECT_EQ(reason(file_of(corner, cells)),
            "checkpoint, line 14: cells is \"4\", and has to be a number from 5 to 1073741823");
  cells = cells_around(1, 2, 3, 4);
  std::swap(cells[2][0], cells[2][1]);
  EXPECT_EQ(reason(file_of(corner, cells)), "checkpoint, line 14: the cells do not fit together");
  cells[1] = {1, 4, 4, 3};
  EXPECT_EQ(reason(file_of(corner, cells)), "checkpoint, line 16: the cell has a vertex twice");
  cells[1] = {1, 4, 5, 3};
  EXPECT_EQ(reason(file_of(corner, cells)),
            "checkpoint, line 16: the vertex is \"5\", and has to be a number from 0 to 4");
  Points points = corner;
  points.emplace_back(3, 3, 3);
  EXPECT_EQ(reason(file_of(points, cells_around(1, 2, 3, 4))),
            "checkpoint, line 27: this is no corner of vertex 5");
}

// Whatever flip is done to a triangulation that has no ties, the result is not Delaunay.
TEST(Space_checkpoints, have_to_be_Delaunay)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_3;
  using CGAL::Dynamic_Delaunay_triangulations_2::internal::Checkpoint_output_2;
  using Space = internal::Open_space_3<Epick, CGAL::Sequential_tag>;
  using State = Space::State;
  State state;
  internal::Update_3<Space> update(state);
  internal::Change_3<Point> change;
  change.coming_points = random_points(14, 3);
  state.ids.list_next_ids(14, change.coming);
  update.run(change);
  EXPECT_TRUE(update.certify());
  const std::string not_delaunay = "the cells are not a Delaunay triangulation";
  const std::string not_fitting = "not exactly two cells have one of the facets";
  int number = 0, fitting = 0;
  for (const bool has_origin : {true, false})
    for (Cell_index c(0); c < state.arrays.number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i) {
        State flipped = state;
        flipped.has_origin = has_origin;
        flipped.arrays.flip_2_3(flipped.arrays.corner(c, i));
        std::ostringstream out;
        Checkpoint_output_2 file(out, "Dynamic_Delaunay_triangulation_3");
        internal::Checkpoint_writer_3<State>(flipped, file).write();
        file.finish();
        const std::string why = reason(out.str());
        const bool fits = why.find(not_delaunay) != why.npos;
        ASSERT_TRUE(fits || why.find(not_fitting) != why.npos) << why;
        fitting += fits;
        ++number;
      }
  EXPECT_GT(fitting, number / 2);
}

// Only internally: nothing that a program may do makes a triangulation wrong.
TEST(Certificates_in_space, are_lost_where_points_are_elsewhere)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_3;
  using Space = internal::Open_space_3<Epick, CGAL::Sequential_tag>;
  using State = Space::State;
  for (const std::size_t number : {4u, 5u, 200u})
    for (const bool has_origin : {true, false}) {
      State state;
      internal::Update_3<Space> update(state);
      internal::Change_3<Point> change;
      change.coming_points = random_points(number, 3);
      state.ids.list_next_ids(number, change.coming);
      update.run(change);
      state.has_origin = has_origin;
      EXPECT_TRUE(update.certify());
      const internal::Place_3<Point> place = state.positions.place(Vertex_index(1));
      state.positions.set(Vertex_index(1), internal::Place_3<Point>(Position_3{-9, -8, -7}));
      state.positions.set(Vertex_index(2), place);
      EXPECT_FALSE(update.certify());
      EXPECT_FALSE(update.is_certified());
      EXPECT_STREQ(update.problem(), "it is not Delaunay");
      EXPECT_TRUE(update.run(internal::Change_3<Point>()).rebuilt());
      EXPECT_TRUE(update.certify());
      EXPECT_EQ(update.problem(), nullptr);
    }
}

TEST(Certificates_in_space, are_kept_where_all_is_right)
{
  for (Dynamic dt : {Dynamic(), Dynamic(Points{{0, 0, 0}, {1, 1, 1}}), Dynamic(random_points(500)),
                     Dynamic(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})}) {
    EXPECT_TRUE(dt.certify());
    EXPECT_TRUE(dt.is_certified());
  }
}

TEST(Space_checkpoints, without_cells_have_to_have_the_dimension_of_their_points)
{
  const std::string text = checkpoint_of(specimens()[2]);
  EXPECT_EQ(reason(replaced(text, " 1 1 0\n", " 1 1 1\n")),
            "checkpoint, line 13: the points above have the dimension 3");
  EXPECT_EQ(reason(replaced(text, "dimension 2", "dimension 1")),
            "checkpoint, line 13: the points above have the dimension 2");
  EXPECT_EQ(reason(replaced(text, " 1 1 0\n", " 0 1 0\n")),
            "checkpoint, line 13: two vertices are in the same place, above");
  EXPECT_EQ(reason(replaced(text, "dimension 2", "dimension 3")),
            "checkpoint, line 14: it begins with \"checksum\", and has to begin with \"origin\"");
}

TEST(Space_checkpoints, of_other_triangulations_are_refused)
{
  Exact exact(
      std::vector<Exact::Point>{{0, 0, 0}, {1, 0, 0}, {Exact::Geom_traits::FT(1) / 3, 1, 0}});
  EXPECT_EQ(reason(checkpoint_of(exact)),
            "checkpoint, line 2: the coordinates are of the kind \"rational\", and those of the "
            "triangulation's points of the kind \"double\"");
  EXPECT_EQ(reason(replaced(checkpoint_of(Dynamic()), "exact", "rounded")),
            "checkpoint, line 3: doubles are exact, and cannot be rounded");
  EXPECT_EQ(
      reason(replaced(checkpoint_of(Dynamic()), "triangulation_3", "triangulation_2")),
      "checkpoint, line 1: it is \"Dynamic_Delaunay_triangulation_2 checkpoint 1\", and has to "
      "be \"Dynamic_Delaunay_triangulation_3 checkpoint 1\"");
  EXPECT_EQ(reason<Exact>(replaced(checkpoint_of(exact), "rounded", "exact")),
            "checkpoint, line 8: the first coordinate as a double is something else than that");
}

TEST(Space_checkpoints, change_nothing_if_memory_does_not_suffice_to_read_them)
{
  for (const Dynamic& dt : specimens()) {
    Dynamic target(random_points(6, 9));
    const std::string before = checkpoint_of(target), text = checkpoint_of(dt);
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
}

TEST(Space_checkpoints, say_so_if_a_disk_is_full)
{
  const Dynamic dt(random_points(20));
  const std::string text = checkpoint_of(dt);
  for (std::size_t size = 0; size < text.size(); size += 7) {
    Full_disk disk(size);
    std::ostream out(&disk);
    EXPECT_THROW(dt.write_checkpoint(out), Checkpoint_error_2);
    Full_disk other_disk(size);
    std::ostream other_out(&other_disk);
    EXPECT_FALSE(other_out << dt);
  }
}

} // namespace test_space_checkpoint
