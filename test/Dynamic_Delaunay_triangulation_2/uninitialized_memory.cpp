// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moves, removes and inserts points in the plane, in space and in their periodic cells, and reads
// what others read of the results, so that the memory sanitizer sees all of it (`./dev test
// --sanitize`). Many arrays are not set before threads write them. Here one thread does what
// threads would share, the last part first, as the sanitizer does not see what TBB does.

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Part_runner.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

namespace {

struct Last_part_first_tag : CGAL::Parallel_tag
{
};

} // namespace

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <>
class Part_runner<Last_part_first_tag>
{
public:
  static constexpr bool is_parallel = true;

  static std::size_t most_workers() { return 64; }

  template <class Function>
  static void run(std::size_t parts, std::size_t, const Function& f)
  {
    while (parts-- > 0)
      f(parts);
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Concurrency = CGAL::With_concurrency_2<Last_part_first_tag>;

void require(bool is_so, const char* what)
{
  if (is_so)
    return;
  std::cerr << what << '\n';
  std::exit(1);
}

// Points of d coordinates between 0 and the side of a cube, or square, with a point for each unit.
template <class Point>
class Points
{
public:
  Points(std::size_t number, unsigned seed)
    : m_side(std::pow(double(number), 1.0 / Point::Ambient_dimension::value))
    , m_random(seed)
  {
    for (std::size_t i = 0; i < number; ++i)
      m_points.push_back(any());
  }

  double side() const { return m_side; }
  const std::vector<Point>& all() const { return m_points; }

  Point any()
  {
    std::uniform_real_distribution<double> coordinate(0, m_side);
    return near(Point(CGAL::ORIGIN), coordinate);
  }

  // Steps of all lengths; some jump, and some meet.
  void move(int frame)
  {
    constexpr double steps[] = {0.001, 0.01, 0.05, 0.15, 0.4, 0};
    std::normal_distribution<double> step(0, steps[frame % 6]);
    for (Point& p : m_points)
      p = near(p, step);
    for (std::size_t i = 0; frame % 5 == 0 && i < m_points.size(); i += 50)
      m_points[i] = any();
    for (std::size_t i = 1; frame % 7 == 3 && i < m_points.size(); i += 97)
      m_points[i] = m_points[i - 1];
  }

  // Every tenth point leaves, and others come.
  template <class Dynamic>
  void exchange_some(Dynamic& dt)
  {
    std::vector<std::size_t> going;
    std::vector<Point> coming;
    for (std::size_t id = 0; id < dt.number_of_ids(); id += 10) {
      going.push_back(id);
      coming.push_back(any());
    }
    dt.remove(going);
    dt.insert(coming);
    m_points.resize(dt.number_of_ids());
    for (std::size_t id = 0; id < m_points.size(); ++id)
      m_points[id] = dt.point(id);
  }

private:
  template <class Distribution>
  CGAL::Point_2<Kernel> near(const CGAL::Point_2<Kernel>& p, Distribution& step)
  {
    const double x = p.x() + step(m_random);
    return {x, p.y() + step(m_random)};
  }
  template <class Distribution>
  CGAL::Point_3<Kernel> near(const CGAL::Point_3<Kernel>& p, Distribution& step)
  {
    const double x = p.x() + step(m_random), y = p.y() + step(m_random);
    return {x, y, p.z() + step(m_random)};
  }
  const double m_side;
  std::mt19937 m_random;
  std::vector<Point> m_points;
};

const std::vector<double>& sizes(const CGAL::Voronoi_cell_measures_2& cells)
{
  return cells.areas();
}
const std::vector<double>& sizes(const CGAL::Voronoi_cell_measures_3& cells)
{
  return cells.volumes();
}

// Goes some frames, and decides by all results after each: the sanitizer reports what decides
// something. In open space, cells end at a box.
template <class Neighbor_lists, class Measures, class Dynamic, class Point, class... Box>
void run(Dynamic dt, Points<Point> points, const Box&... box)
{
  Neighbor_lists lists;
  Measures cells;
  for (int frame = 0; frame < 18; ++frame) {
    points.move(frame);
    dt.update(points.all());
    if (frame % 8 == 5)
      points.exchange_some(dt);
    require(dt.is_certified() && dt.is_valid(), "not Delaunay");
    lists.compute(dt);
    for (const std::size_t id : lists.neighbors())
      require(id < dt.number_of_ids(), "no id");
    cells.compute(dt, box...);
    for (const double size : sizes(cells))
      require(size >= 0, "no size");
  }
}

void run_in_plane(std::size_t number, unsigned seed)
{
  using Plane =
      CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Circumcircle_classifier_2, Concurrency>;
  using Torus =
      CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, CGAL::Circumcircle_classifier_2,
                                                      Concurrency>;
  const Points<Kernel::Point_2> points(number, seed);
  const double side = points.side();
  run<CGAL::Delaunay_neighbor_lists_2, CGAL::Voronoi_cell_measures_2>(
      Plane(points.all()), points, CGAL::Bbox_2(0, 0, side, side));
  const CGAL::Periodic_cell_2 cell(side, 0, 0.2 * side, side);
  run<CGAL::Delaunay_neighbor_lists_2, CGAL::Voronoi_cell_measures_2>(
      Torus(points.all().begin(), points.all().end(), cell), points);
}

void run_in_space(std::size_t number, unsigned seed)
{
  using Space = CGAL::Dynamic_Delaunay_triangulation_3<Kernel, Concurrency>;
  using Torus = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel, Concurrency>;
  const Points<Kernel::Point_3> points(number, seed);
  const double side = points.side();
  run<CGAL::Delaunay_neighbor_lists_3, CGAL::Voronoi_cell_measures_3>(
      Space(points.all()), points, CGAL::Bbox_3(0, 0, 0, side, side, side));
  const CGAL::Periodic_cell_3 cell(side, side, side);
  run<CGAL::Delaunay_neighbor_lists_3, CGAL::Voronoi_cell_measures_3>(
      Torus(points.all().begin(), points.all().end(), cell), points);
}

} // namespace

int main()
{
  unsigned seed = 1;
  for (const std::size_t number : {3u, 9u, 40u, 600u, 5000u})
    run_in_plane(number, seed++);
  for (const std::size_t number : {3u, 9u, 40u, 600u, 2000u})
    run_in_space(number, seed++);
}
