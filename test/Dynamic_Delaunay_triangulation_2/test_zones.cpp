// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the proof over ranks trusts without looking at faces: zones and how dense points are there.
// Needs no MPI.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_density_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distributed_zone_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
using CGAL::Dynamic_Delaunay_triangulations_2::Index;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

constexpr double side = 40;

class Zones : public testing::Test
{
protected:
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  Box_2 any_box(double longest)
  {
    const double x = uniform(-5, side + 5), y = uniform(-5, side + 5);
    return {x, y, x + uniform(0, longest), y + uniform(0, longest)};
  }
  // A large box, and some around it and beyond the grid.
  Distributed_zone_2 any_zone(double cell_size)
  {
    Distributed_zone_2 zone({-2, -2, side + 2, side + 2}, cell_size);
    const double low = uniform(0, side / 4);
    zone.add({low, low, uniform(0.7, 1.1) * side, uniform(0.7, 1.1) * side});
    for (int k = 0; k < 10; ++k)
      zone.add(any_box(3));
    zone.sum_up();
    return zone;
  }
  Point place_in(const Box_2& box)
  {
    return Point(uniform(box.x_low, box.x_high), uniform(box.y_low, box.y_high));
  }

  std::mt19937 random{1};
};

TEST_F(Zones, A_box_that_is_covered_has_no_place_outside)
{
  std::size_t covered = 0;
  for (int k = 0; k < 200; ++k) {
    const Distributed_zone_2 zone = any_zone(uniform(0.2, 1));
    for (int i = 0; i < 100; ++i) {
      const Box_2 box = any_box(4);
      if (!zone.covers(box))
        continue;
      ++covered;
      for (int n = 0; n < 20; ++n) {
        const Point p = place_in(box);
        EXPECT_TRUE(zone.contains(p.x(), p.y()));
      }
    }
  }
  EXPECT_GT(covered, 2000u);
}

TEST_F(Zones, Places_within_the_depth_around_a_place_are_in_the_zone)
{
  std::size_t deep = 0;
  for (int k = 0; k < 200; ++k) {
    const Distributed_zone_2 zone = any_zone(uniform(0.2, 1));
    for (int i = 0; i < 100; ++i) {
      const Point p = place_in({-3, -3, side + 3, side + 3});
      const double depth = zone.depth_around(p.x(), p.y());
      deep += depth > 0;
      for (int n = 0; n < 20 && depth > 0; ++n) {
        const Point q = place_in({p.x() - depth, p.y() - depth, p.x() + depth, p.y() + depth});
        EXPECT_TRUE(zone.contains(q.x(), q.y()));
      }
      for (const double x : {p.x() - depth, p.x() + depth})
        for (const double y : {p.y() - depth, p.y() + depth})
          EXPECT_TRUE(depth == 0 || zone.contains(x, y));
    }
  }
  EXPECT_GT(deep, 2000u);
}

TEST_F(Zones, What_other_ranks_read_of_a_zone_contains_the_same_places_and_misses_no_box)
{
  for (int k = 0; k < 100; ++k) {
    const Distributed_zone_2 zone = any_zone(uniform(0.2, 1));
    const std::vector<std::uint64_t> words = zone.to_words();
    const Distributed_zone_2 read = Distributed_zone_2::of_words(words.begin(), words.end());
    for (int i = 0; i < 300; ++i) {
      const Point p = place_in({-10, -10, side + 10, side + 10});
      EXPECT_EQ(zone.contains(p.x(), p.y()), read.contains(p.x(), p.y()));
      const Box_2 box{p.x() - uniform(0, 2), p.y() - uniform(0, 2), p.x() + uniform(0, 2),
                      p.y() + uniform(0, 2)};
      if (zone.contains(p.x(), p.y())) {
        EXPECT_TRUE(read.may_meet(box));
      }
    }
  }
}

// The disk of a face is where all of it is if its circle is: the places of a zone around it may
// have holes, but not larger ones than the circle would meet. Every third vertex is a ghost.
TEST_F(Zones, Disks_of_faces_at_dense_points_are_in_the_zone)
{
  std::size_t dense_vertices = 0, deep_vertices = 0;
  for (int k = 0; k < 60; ++k) {
    const double spacing = uniform(0.4, 1);
    const Distributed_zone_2 zone = any_zone(0.7 * spacing);
    const Box_2 hole = any_box(6 * zone.block_size());
    std::vector<Point> points;
    for (int n = int(side * side / (spacing * spacing)); n > 0; --n) {
      const Point p = place_in({0, 0, side, side});
      if (!hole.meets({p.x(), p.y(), p.x(), p.y()}))
        points.push_back(p);
    }
    const Dynamic dt(points.begin(), points.end());
    const auto frame = dt.frame();
    std::vector<std::uint8_t> vertices(frame.number_of_vertices() + std::size_t(1), 1);
    vertices[0] = 0;
    Distributed_density_2 density;
    density.set_zone(zone);
    density.clear();
    std::vector<Index> own, ghosts;
    for (Index v = 1; v < vertices.size(); ++v)
      (v % 3 == 0 ? ghosts : own).push_back(v);
    for (const Index v : own)
      density.add_own(zone, frame.position(v));
    density.find_dense(zone, [&](const auto& add) {
      for (const Index v : ghosts)
        add(frame.position(v));
    });
    for (std::size_t n = 0; n < own.size(); ++n)
      vertices[own[n]] = !density.is_dense(n);
    for (const Index v : own) {
      const auto p = frame.position(v);
      dense_vertices += vertices[v] == 0;
      deep_vertices += zone.depth_around(p.x, p.y) > 4 * zone.block_size();
    }
    for (Index g = 0; g < frame.number_of_faces(); ++g) {
      const auto face = frame.face(g);
      if (vertices[face[0]] != 0 && vertices[face[1]] != 0 && vertices[face[2]] != 0)
        continue;
      bool is_finite = true;
      for (const Index v : face)
        is_finite = is_finite && v != 0;
      if (!is_finite) {
        const bool is_at_dense = (face[0] != 0 && vertices[face[0]] == 0) ||
                                 (face[1] != 0 && vertices[face[1]] == 0) ||
                                 (face[2] != 0 && vertices[face[2]] == 0);
        EXPECT_FALSE(is_at_dense) << "a dense vertex at the hull";
        continue;
      }
      const auto point = [&](std::size_t i) {
        return Point(frame.position(face[i]).x, frame.position(face[i]).y);
      };
      const Point c = CGAL::circumcenter(point(0), point(1), point(2));
      const double radius = std::sqrt(CGAL::squared_distance(c, point(0)));
      for (int n = 0; n < 64; ++n) {
        const double angle = n * 0.098174770424681; // of 64 in a circle
        EXPECT_TRUE(
            zone.contains(c.x() + radius * std::cos(angle), c.y() + radius * std::sin(angle)));
      }
    }
  }
  EXPECT_GT(dense_vertices, 10000u);
  EXPECT_GT(2 * dense_vertices, deep_vertices);
}

} // namespace
