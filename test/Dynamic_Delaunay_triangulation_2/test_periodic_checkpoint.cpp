// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A periodic triangulation that was written and read goes on as the original does; a file that is
// no checkpoint of one is refused and changes nothing.

#include "checkpoint_files.h"
#include "periodic_operations.h"
#include "periodic_oracle.h"
#include "random_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_periodic_checkpoint {

using CGAL::Checkpoint_error_2;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Cell = CGAL::Periodic_cell_2;
using Shift = CGAL::Periodic_shift_2;
using Triangulation = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel>;
using Population = CGAL::Dynamic_population_2<Triangulation>;

Triangulation restored(const Triangulation& original)
{
  Triangulation copy(Cell(1, 1));
  read(copy, checkpoint_of(original));
  return copy;
}

// The edges in the order in which `for_each` lists them.
template <class For_each>
auto edges_in_order(const For_each& for_each)
{
  std::vector<std::tuple<std::size_t, std::size_t, Shift>> edges;
  for_each(
      [&](std::size_t i, std::size_t j, const Shift& shift) { edges.emplace_back(i, j, shift); });
  return edges;
}

auto edges_of(const Triangulation& pt)
{
  return edges_in_order([&](const auto& f) { pt.for_each_edge(f); });
}

auto boundary_of(const Triangulation& pt)
{
  return edges_in_order([&](const auto& f) { pt.for_each_boundary_edge(f); });
}

auto neighbors_of(const Triangulation& pt, std::size_t id)
{
  return edges_in_order([&](const auto& f) {
    pt.for_each_neighbor(id, [&](std::size_t j, const Shift& shift) { f(id, j, shift); });
  });
}

auto faces_of(const Triangulation& pt)
{
  std::vector<std::pair<std::array<std::size_t, 3>, std::array<Shift, 3>>> faces;
  pt.for_each_face([&](const auto& ids, const auto& shifts) { faces.emplace_back(ids, shifts); });
  return faces;
}

void expect_equal(const Triangulation& pt, const Triangulation& other)
{
  ASSERT_EQ(pt.is_certified(), other.is_certified());
  ASSERT_TRUE(pt.cell() == other.cell());
  ASSERT_EQ(pt.number_of_ids(), other.number_of_ids());
  ASSERT_EQ(pt.number_of_vertices(), other.number_of_vertices());
  ASSERT_EQ(edges_of(pt), edges_of(other));
  ASSERT_EQ(faces_of(pt), faces_of(other));
  ASSERT_EQ(boundary_of(pt), boundary_of(other));
  for (std::size_t id = 0; id < pt.number_of_ids(); ++id) {
    ASSERT_EQ(pt.has_id(id), other.has_id(id));
    if (pt.has_id(id)) {
      ASSERT_EQ(pt.point(id), other.point(id));
      ASSERT_EQ(pt.representative(id), other.representative(id));
      ASSERT_EQ(neighbors_of(pt, id), neighbors_of(other, id));
    }
  }
}

// A run, and one that is written and read again and again: as if they were one triangulation.
class Interrupted_run
{
public:
  explicit Interrupted_run(const Cell& cell)
    : m_run(cell)
    , m_interrupted(cell)
  {
  }

  const Cell& cell() const { return m_run.cell(); }
  std::size_t number_of_ids() const { return m_run.number_of_ids(); }
  std::size_t number_of_points() const { return m_run.number_of_points(); }
  Point point(std::size_t id) const { return m_interrupted.point(id); }

  std::size_t insert(const Point& p)
  {
    std::vector<std::size_t> ids;
    insert(&p, &p + 1, std::back_inserter(ids));
    return ids.front();
  }
  template <class Iterator, class Output>
  void insert(Iterator begin, Iterator end, Output out)
  {
    std::vector<std::size_t> ids, other_ids;
    EXPECT_EQ(all_of(m_run.insert(begin, end, std::back_inserter(ids))),
              all_of(m_interrupted.insert(begin, end, std::back_inserter(other_ids))));
    EXPECT_EQ(ids, other_ids);
    std::copy(ids.begin(), ids.end(), out);
  }
  void remove(std::size_t id)
  {
    EXPECT_EQ(all_of(m_run.remove(id)), all_of(m_interrupted.remove(id)));
  }
  void move(std::size_t id, const Point& p)
  {
    EXPECT_EQ(all_of(m_run.move(id, p)), all_of(m_interrupted.move(id, p)));
  }
  void update(const std::vector<Point>& points, const Cell& cell)
  {
    EXPECT_EQ(all_of(m_run.update(points, cell)), all_of(m_interrupted.update(points, cell)));
  }

  void interrupt() { m_interrupted = restored(m_interrupted); }

  void expect_equal() const
  {
    ASSERT_TRUE(m_interrupted.is_valid());
    ASSERT_NO_FATAL_FAILURE(test_periodic_checkpoint::expect_equal(m_run, m_interrupted));
  }
  void expect_equal_checkpoints() const
  {
    ASSERT_EQ(checkpoint_of(m_run), checkpoint_of(m_interrupted));
  }

private:
  Triangulation m_run, m_interrupted;
};

// With up to about `most` points.
void interrupt_at_random(std::uint64_t seed, std::size_t most, int calls)
{
  Random_operations<Interrupted_run> operations(seed, most);
  Interrupted_run& run = operations.triangulation();
  std::mt19937_64 random(seed);
  operations.insert(random() % (most + 1));
  for (int call = 0; call < calls; ++call) {
    SCOPED_TRACE(testing::Message() << "call " << call);
    if (random() % 3 == 0)
      run.interrupt();
    const auto kind = random() % 8;
    if (kind < 2)
      operations.shake();
    else if (kind == 2)
      operations.insert(run.number_of_points() < most ? 1 + random() % 4 : 0);
    else if (kind == 3 && run.number_of_points() > 0)
      operations.meet();
    else
      operations.step();
    ASSERT_NO_FATAL_FAILURE(run.expect_equal());
    ASSERT_NO_FATAL_FAILURE(operations.expect_points());
    ASSERT_FALSE(testing::Test::HasFailure());
  }
  ASSERT_NO_FATAL_FAILURE(run.expect_equal_checkpoints());
}

TEST(Periodic_checkpoints, a_run_goes_on_as_if_it_had_not_been_interrupted)
{
  for (std::uint64_t seed = 1; seed <= 24; ++seed)
    ASSERT_NO_FATAL_FAILURE(interrupt_at_random(seed, 12, 150)) << "seed " << seed;
  for (std::uint64_t seed = 25; seed <= 32; ++seed)
    ASSERT_NO_FATAL_FAILURE(interrupt_at_random(seed, 250, 30)) << "seed " << seed;
}

// Points that stream, where some jump: which points count as jumping depends on the mean of the
// last frame.
TEST(Periodic_checkpoints, the_mean_motion_is_kept)
{
  std::mt19937_64 random(2);
  auto points = random_points(random, 200, 14);
  Triangulation run(points, Cell(14, 14));
  std::size_t relocated = 0;
  for (int frame = 0; frame < 30; ++frame) {
    Triangulation interrupted = restored(run);
    const double way = frame % 2 == 0 ? 0.6 : -0.3;
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = Point(points[i].x() + way + random_between(random, -0.3, 0.3), points[i].y());
    const CGAL::Update_report_2 report = run.update(points);
    ASSERT_EQ(all_of(interrupted.update(points)), all_of(report));
    ASSERT_NO_FATAL_FAILURE(expect_equal(run, interrupted));
    relocated += report.relocated;
  }
  EXPECT_GT(relocated, 0u);
}

// The uninterrupted run skips edges that it has proved safe; the other one has to prove them first.
TEST(Periodic_checkpoints, edges_that_are_skipped_make_no_difference)
{
  std::mt19937_64 random(3);
  for (const Cell& cell : {Cell(20, 20), Cell::slab(20, 4)}) {
    auto points = random_points(random, 400, 20);
    Triangulation run(points, cell), interrupted(points, cell);
    std::size_t flips = 0;
    for (int frame = 0; frame < 150; ++frame) {
      if (frame % 50 == 30)
        interrupted = restored(interrupted);
      for (Point& p : points)
        p = Point(p.x() + random_between(random, -1e-3, 1e-3), p.y());
      const CGAL::Update_report_2 report = run.update(points);
      ASSERT_EQ(all_of(interrupted.update(points)), all_of(report));
      ASSERT_EQ(edges_of(run), edges_of(interrupted));
      flips += report.flips;
    }
    EXPECT_GT(flips, 10u);
    ASSERT_EQ(checkpoint_of(run), checkpoint_of(interrupted));
  }
}

TEST(Periodic_checkpoints, any_double_is_kept_to_the_bit)
{
  using Limits = std::numeric_limits<double>;
  const std::vector<Point> points = {
      {-0., 0.1}, {Limits::denorm_min(), -(Limits::min)()}, {1. / 3, -2. / 3}, {1e5, 1e-300}};
  const Triangulation pt(points, Cell(1, 1e-17, -0.3, 1));
  const Triangulation other = restored(pt);
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_EQ(other.point(id), points[id]);
    EXPECT_EQ(std::signbit(other.point(id).x()), std::signbit(points[id].x()));
  }
  EXPECT_TRUE(other.cell() == pt.cell());
}

TEST(Periodic_checkpoints, a_slab_is_kept_also_where_its_points_are_as_far_across_as_can_be)
{
  constexpr double far = (std::numeric_limits<double>::max)();
  Triangulation pt(std::vector<Point>{{0, 0}, {1, 1}, {2, 3}}, Cell::slab(3, 0));
  const std::vector<Point> next{{0, far}, {1, far}, {2, far}};
  pt.update(next);
  Triangulation other = restored(pt);
  expect_equal(pt, other);
}

TEST(Periodic_checkpoints, a_file_replaces_whatever_is_there)
{
  std::mt19937_64 random(4);
  const Triangulation slab(random_points(random, 20, 3), Cell::slab(3, 1));
  const Triangulation torus(random_points(random, 30, 3), Cell(3, 3));
  const Triangulation empty(Cell(2, 1));
  Triangulation pt(Cell(1, 1));
  for (const Triangulation* file : {&slab, &torus, &empty, &torus, &slab, &slab, &empty}) {
    read(pt, checkpoint_of(*file));
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
    ASSERT_NO_FATAL_FAILURE(expect_equal(*file, pt));
  }
}

TEST(Periodic_checkpoints, the_example_in_the_manual_is_a_checkpoint)
{
  Triangulation pt(Cell(4, 4));
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

// After memory runs out, the next update must mend the original and the one read from a checkpoint
// alike. Returns how many checkpoints were written, and how many were refused.
std::pair<int, int> run_out_of_memory(bool first_two_part)
{
  std::mt19937_64 random(5);
  auto points = random_points(random, 30, 3);
  points[1] = points[0];
  auto next = points;
  for (Point& p : next)
    p = Point(p.x() + random_between(random, -0.2, 0.2), p.y());
  if (!first_two_part)
    next[1] = next[0];
  next[2] = points[3];
  int kept = 0, not_written = 0;
  bool is_done = false;
  for (long allocations = 0; !is_done; ++allocations) {
    Triangulation pt(points, Cell(3, 3));
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      pt.update(next);
      is_done = true;
    } catch (const std::bad_alloc&) {
    }
    if (pt.is_certified())
      continue;
    std::ostringstream out;
    try {
      pt.write_checkpoint(out);
      ++kept;
    } catch (const Checkpoint_error_2& error) {
      EXPECT_EQ(error.line(), 0u);
      EXPECT_EQ(out.str(), "");
      ++not_written;
      continue;
    }
    Triangulation other = restored(pt);
    EXPECT_FALSE(other.is_certified());
    EXPECT_EQ(all_of(pt.update(next)), all_of(other.update(next)));
    expect_equal(pt, other);
    EXPECT_TRUE(other.is_valid());
  }
  return {kept, not_written};
}

TEST(Periodic_checkpoints, what_an_exception_has_left_is_kept_or_not_written_at_all)
{
  EXPECT_GT(run_out_of_memory(false).first, 0);
  EXPECT_GT(run_out_of_memory(true).second, 0); // where a point has no vertex of its own yet
}

// POPULATIONS -------------------------------------------------------------------------------------

TEST(Periodic_checkpoints, a_population_goes_on_with_the_ids_of_its_user)
{
  std::mt19937_64 random(6);
  std::vector<std::pair<std::int64_t, Point>> crowd;
  std::int64_t next_id = -20;
  Population population(Triangulation(Cell(5, 5)));
  for (int stage = 0; stage < 5; ++stage) {
    Population other(Triangulation(Cell(1, 1)));
    std::stringstream file;
    file << population;
    file >> other;
    for (int frame = 0; frame < 10; ++frame) {
      for (auto& [id, p] : crowd)
        p = Point(p.x() + random_between(random, -0.1, 0.1), p.y() + 5);
      for (int i = 0; i < 3 && !crowd.empty(); ++i)
        crowd.erase(crowd.begin() + std::ptrdiff_t(random() % crowd.size()));
      for (const Point& p : random_points(random, 5, 5, 0.5))
        crowd.emplace_back(next_id++ * 1000000007, p);
      const Cell cell(5, 0, 0.1 * frame, 5);
      ASSERT_EQ(all_of(population.update(crowd, cell)), all_of(other.update(crowd, cell)));
      ASSERT_NO_FATAL_FAILURE(expect_equal(population.triangulation(), other.triangulation()));
      ASSERT_EQ(other.size(), crowd.size());
      for (const auto& [id, p] : crowd)
        ASSERT_EQ(other.point(id), p);
    }
    ASSERT_EQ(checkpoint_of(population), checkpoint_of(other));
  }
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

TEST(Periodic_checkpoints, a_population_has_the_ids_of_its_file_also_if_the_visitor_throws)
{
  using Visited =
      CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, CGAL::Default,
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

// REFUSALS ----------------------------------------------------------------------------------------

// A small triangulation whose checkpoint has everything that a file can have.
Triangulation specimen(const Cell& cell = Cell(3, 0, 1, 3))
{
  std::mt19937_64 random(7);
  auto points = random_points(random, 7, 3);
  points[4] = Point(points[2].x() + cell.ax(), points[2].y() + cell.ay());
  Triangulation pt(points, cell);
  pt.move(4, Point(points[2].x(), points[2].y())); // the sum above may be rounded
  pt.remove(5);
  return pt;
}

// The line of the vertex of point 0, which is the only point there.
std::string vertex_line(const std::string& text)
{
  const std::size_t begin = text.find("\n0 ", text.find("\nvertices"));
  return text.substr(begin, text.find('\n', begin + 1) + 1 - begin);
}

std::size_t line_of_refusal(const std::string& text)
{
  Triangulation pt(Cell(1, 1));
  const std::size_t line = refusal(pt, text).line();
  EXPECT_EQ(pt.number_of_points(), 0u);
  return line;
}

struct Torus
{
  static Triangulation empty() { return Triangulation(Cell(1, 1)); }
  static Triangulation specimen() { return test_periodic_checkpoint::specimen(); }
  static Triangulation other_one() { return test_periodic_checkpoint::specimen(Cell::slab(3, 1)); }
};
struct Slab
{
  static Triangulation empty() { return Torus::empty(); }
  static Triangulation specimen() { return Torus::other_one(); }
  static Triangulation other_one() { return Torus::specimen(); }
};
using Periodic_spaces = testing::Types<Torus, Slab>;
INSTANTIATE_TYPED_TEST_SUITE_P(Periodic_checkpoints, Checkpoint_files, Periodic_spaces);

TEST(Periodic_checkpoints, a_refusal_says_where_and_why)
{
  const std::string text = checkpoint_of(specimen());
  Triangulation pt(Cell(1, 1));
  const auto message = [&](const std::string& edited) {
    return std::string(refusal(pt, edited).what());
  };
  EXPECT_EQ(message(replaced(text, "slab no", "slab yes")),
            "checkpoint, line 3: \"1 3\" is too much in this line");
  EXPECT_EQ(message(replaced(text, "certified yes", "certified maybe")),
            "checkpoint, line 4: certified is \"maybe\", and has to be yes or no");
  EXPECT_EQ(message(replaced(text, "hopeless_share 65536", "hopeless_share 0")),
            "checkpoint, line 5: hopeless_share is \"0\", and has to be a number from 1 to 65536");
}

TEST(Periodic_checkpoints, files_of_the_plane_are_refused_here_and_periodic_ones_there)
{
  using Plane = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  using Population_of_the_plane = CGAL::Dynamic_population_2<Plane>;
  Plane plane;
  Population_of_the_plane population_of_the_plane;
  Triangulation pt(Cell(1, 1));
  Population population(Triangulation(Cell(1, 1)));
  const auto expect_refusal = [](auto& target, const std::string& file, const std::string& found,
                                 const std::string& expected) {
    EXPECT_EQ(std::string(refusal(target, file).what()), "checkpoint, line 1: it is \"" + found +
                                                             " checkpoint 1\", and has to be \"" +
                                                             expected + " checkpoint 1\"");
  };
  const std::string periodic = "Dynamic_periodic_Delaunay_triangulation_2",
                    planar = "Dynamic_Delaunay_triangulation_2";
  expect_refusal(pt, checkpoint_of(plane), planar, periodic);
  expect_refusal(plane, checkpoint_of(pt), periodic, planar);
  expect_refusal(population, checkpoint_of(population_of_the_plane), "Dynamic_population_2",
                 "periodic Dynamic_population_2");
  expect_refusal(population_of_the_plane, checkpoint_of(population),
                 "periodic Dynamic_population_2", "Dynamic_population_2");
  expect_refusal(pt, checkpoint_of(population), "periodic Dynamic_population_2", periodic);
}

TEST(Periodic_checkpoints, cells_that_cannot_be_used_are_refused)
{
  const std::string text = checkpoint_of(Triangulation(Cell(3, 3)));
  for (const char* cell : {"3 0 6 0", "0 0 0 3", "1e-300 0 0 1e-300", "nan 0 0 3", "3 0 0 1e999",
                           "3 0 0", "3 0 0 3 0", "1 0 1e-20 1e-40"})
    EXPECT_EQ(line_of_refusal(replaced(text, "cell 3 0 0 3", "cell " + std::string(cell))), 3u)
        << cell;
  const std::string slab = checkpoint_of(Triangulation(Cell::slab(3, 0)));
  for (const char* cell : {"0 0", "inf 0", "3", "3 0 0 1", "1.7e308 1.7e308"})
    EXPECT_EQ(line_of_refusal(replaced(slab, "cell 3 0", "cell " + std::string(cell))), 3u) << cell;
}

TEST(Periodic_checkpoints, a_triangulation_that_is_not_delaunay_is_not_believed_to_be_certified)
{
  const std::string text = checkpoint_of(specimen());
  const std::string moved = replaced(text, vertex_line(text), "\n0 100 200\n");
  EXPECT_EQ(line_of_refusal(moved), 4u);
  // points may be anywhere in a triangulation that is not certified
  Triangulation pt(Cell(1, 1));
  read(pt, replaced(moved, "certified yes", "certified no"));
  EXPECT_FALSE(pt.is_certified());
  EXPECT_EQ(pt.point(0), Point(100, 200));
  EXPECT_TRUE(pt.is_valid()); // as one that is not certified
  EXPECT_FALSE(pt.certify());
  EXPECT_TRUE(pt.mend().certified);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
}

TEST(Periodic_checkpoints, points_have_to_be_in_range_and_duplicates_where_their_vertices_are)
{
  const std::string text = checkpoint_of(specimen());
  const std::string vertex = vertex_line(text);
  const auto lines =
      std::count(text.begin(), text.begin() + std::ptrdiff_t(text.find(vertex)), '\n');
  for (const char* point : {"nan 1", "1 inf", "1e9 1", "1 -1e9", "1", "1 1 1"})
    EXPECT_EQ(line_of_refusal(replaced(text, vertex, "\n0 " + std::string(point) + '\n')),
              std::size_t(lines) + 2)
        << point;
  const std::string duplicate = '\n' + line_below(text, "duplicates") + '\n';
  EXPECT_EQ(line_of_refusal(replaced(text, duplicate, duplicate.substr(0, 5) + "1 1\n")), 14u);
}

// SURFACES ----------------------------------------------------------------------------------------

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

std::string reason(const std::string& text)
{
  Triangulation pt(Cell(1, 1));
  return refusal(pt, text).what();
}

TEST(Periodic_checkpoints, one_point_has_two_faces_over_a_basis_of_the_lattice)
{
  const std::vector<std::string> edges{"0 4", "1 5", "2 3"};
  const auto of_faces = [&](const std::string& f, const std::string& g) {
    return file_of({"1 1"}, {"1 1 1 " + f, "1 1 1 " + g}, {"0"}, edges, "yes");
  };
  EXPECT_EQ(reason(of_faces("1 0 1 1", "1 1 0 1")), "checkpoint: accepted");
  const std::string not_once = "checkpoint, line 19: the faces above do not cover the space once";
  EXPECT_EQ(reason(of_faces("2 0 2 1", "2 1 0 1")), not_once); // a face twice, else all is right
  EXPECT_EQ(reason(of_faces("0 1 1 1", "1 1 1 0")), not_once); // turned over
  EXPECT_EQ(reason(of_faces("1 0 2 0", "2 0 1 0")), not_once);
  EXPECT_EQ(reason(of_faces("1 0 1 0", "1 0 0 0")),
            "checkpoint, line 12: the face has a corner twice");
  EXPECT_EQ(reason(of_faces("1 0 1 1", "1 1 0 2")),
            "checkpoint, line 17: these are half-edges of two edges");
  EXPECT_EQ(reason(of_faces("1 0 1 4194304", "1 1 0 1")),
            "checkpoint, line 12: the shift is \"4194304\", and has to be a number from -4194303 "
            "to 4194303");
}

TEST(Periodic_checkpoints, every_half_edge_is_there_once)
{
  const auto of_edges = [](const std::vector<std::string>& edges) {
    return file_of({"1 1"}, {"1 1 1 1 0 1 1", "1 1 1 1 1 0 1"}, {"5"}, edges);
  };
  EXPECT_EQ(reason(of_edges({"4 0", "5 1", "3 2"})), "checkpoint: accepted");
  const std::string twice = ": a half-edge is there more than once";
  EXPECT_EQ(reason(of_edges({"4 0", "0 4", "3 2"})), "checkpoint, line 18" + twice);
  EXPECT_EQ(reason(of_edges({"4 0", "5 1", "2 2"})), "checkpoint, line 19" + twice);
  EXPECT_EQ(reason(of_edges({"1 0", "5 4", "3 2"})),
            "checkpoint, line 17: these are half-edges of two edges");
}

TEST(Periodic_checkpoints, corners_are_at_their_vertices)
{
  const std::string text = checkpoint_of(specimen());
  const std::string corner = line_below(text, "corners");
  const std::size_t place = text.find("\ncorners ");
  const std::size_t begin = text.find('\n', place + 1) + 1;
  const std::size_t second = text.find('\n', begin) + 1;
  std::string edited = text;
  edited.replace(begin, second - begin, text.substr(second, text.find('\n', second) + 1 - second));
  Triangulation pt(Cell(1, 1));
  EXPECT_NE(std::string(refusal(pt, resealed(edited)).what()).find("this is no corner of vertex 1"),
            std::string::npos)
      << corner;
}

TEST(Periodic_checkpoints, faces_that_are_no_torus_are_refused)
{
  // two tori, of one point each
  EXPECT_EQ(reason(file_of({"1 1", "2 2"},
                           {"1 1 1 1 0 1 1", "1 1 1 1 1 0 1", "2 2 2 1 0 1 1", "2 2 2 1 1 0 1"},
                           {"0", "6"}, {"0 4", "1 5", "2 3", "6 10", "7 11", "8 9"})),
            "checkpoint, line 15: the face hangs together with the first one by no edges");
  // a tetrahedron of which two pairs of vertices are images of one point each
  EXPECT_EQ(reason(file_of({"1 1", "2 2"},
                           {"1 2 1 0 0 1 0", "1 2 2 1 0 0 0", "1 1 2 1 0 1 0", "2 2 1 1 0 1 0"},
                           {"0", "1"}, {"2 4", "1 8", "0 10", "5 7", "3 11", "6 9"})),
            "checkpoint, line 16: the faces at a vertex of the face are not one cycle");
}

TEST(Periodic_checkpoints, a_forged_file_is_refused_or_harmless)
{
  const auto expect_common_update = [](Triangulation& pt, Triangulation& other, int) {
    ASSERT_TRUE(!pt.is_certified() || pt.is_valid());
    std::vector<Point> points(pt.number_of_ids());
    for (std::size_t id = 0; id < points.size(); ++id)
      if (pt.has_id(id))
        points[id] = Point(pt.point(id).x() + 0.01 * double(id), pt.point(id).y());
    ASSERT_EQ(all_of(pt.update(points)), all_of(other.update(points)));
    ASSERT_TRUE(pt.is_valid());
    ASSERT_NO_FATAL_FAILURE(expect_equal(pt, other));
  };
  for (const Cell& cell : {Cell(3, 0, 1, 3), Cell::slab(3, 1)})
    for (const bool is_certified : {true, false}) {
      std::string text = checkpoint_of(specimen(cell));
      if (!is_certified)
        text = replaced(text, "certified yes", "certified no");
      ASSERT_NO_FATAL_FAILURE(expect_forgeries_to_be_harmless(
          text, Triangulation(Cell(1, 1)), unsigned(is_certified), 2500, expect_common_update));
    }
}

} // namespace test_periodic_checkpoint
