// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Zones, and the density of points in them, on which the proof over ranks relies instead of looking
// at faces. Needs no MPI.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_cover_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_zone_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_zones {

using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
using CGAL::Dynamic_Delaunay_triangulations_2::Face_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Index;
using CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;
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
  // A deformation of the cell that a zone may follow; the identity half of the time.
  Basis_2 any_basis()
  {
    const auto part = [&] { return uniform(-0.2, 0.2); };
    return random() % 2 == 0 ? unit_basis : Basis_2{{{1 + part(), part()}, {part(), 1 + part()}}};
  }
  // The image of a place after a deformation of space.
  static Point deformed(const Point& p, const Basis_2& basis)
  {
    return Point(p.x() * basis[0].x + p.y() * basis[1].x, p.x() * basis[0].y + p.y() * basis[1].y);
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
    Distributed_zone_2 zone = any_zone(uniform(0.2, 1));
    zone.follow(any_basis());
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
  EXPECT_GT(covered, 1500u);
}

TEST_F(Zones, Places_within_the_depth_around_a_place_are_in_the_zone)
{
  std::size_t deep = 0;
  for (int k = 0; k < 200; ++k) {
    Distributed_zone_2 zone = any_zone(uniform(0.2, 1));
    zone.follow(any_basis());
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
    Distributed_zone_2 zone = any_zone(uniform(0.2, 1));
    const std::vector<std::uint64_t> words = zone.to_words();
    Distributed_zone_2 read = Distributed_zone_2::of_words(words.begin(), words.end());
    read.follow(any_basis());
    zone.follow(read);
    for (int i = 0; i < 300; ++i) {
      const Point p = place_in({-10, -10, side + 10, side + 10});
      EXPECT_EQ(zone.contains(p.x(), p.y()), read.contains(p.x(), p.y()));
      const Box_2 box{p.x() - uniform(0, 2), p.y() - uniform(0, 2), p.x() + uniform(0, 2),
                      p.y() + uniform(0, 2)};
      if (zone.contains(p.x(), p.y())) {
        EXPECT_TRUE(read.may_meet(box));
        EXPECT_TRUE(read.bounds().contains(p.x(), p.y()));
      }
    }
  }
}

TEST_F(Zones, Places_stay_in_a_zone_that_is_deformed_with_them)
{
  std::size_t inside = 0;
  for (int k = 0; k < 100; ++k) {
    const double cell_size = uniform(0.2, 1);
    const Distributed_zone_2 zone = any_zone(cell_size);
    const Basis_2 basis = any_basis();
    Distributed_zone_2 followed = zone;
    followed.follow(basis);
    for (int i = 0; i < 300; ++i) {
      const Point p = place_in({-3, -3, side + 3, side + 3});
      if (zone.depth_around(p.x(), p.y()) == 0)
        continue;
      const Point q = deformed(p, basis);
      EXPECT_TRUE(followed.contains(q.x(), q.y()));
      ++inside;
    }
  }
  EXPECT_GT(inside, 5000u);
}

TEST_F(Zones, A_zone_that_is_deformed_too_much_is_none)
{
  const auto is_none = [&](const Basis_2& basis) {
    Distributed_zone_2 zone = any_zone(1), other = zone;
    zone.follow(basis);
    EXPECT_TRUE(other.follow(zone));
    EXPECT_FALSE(other.follow(zone));
    EXPECT_EQ(other.is_empty(), zone.is_empty());
    return zone.is_empty();
  };
  EXPECT_FALSE(is_none({{{1, 0}, {1.4, 1}}}));
  EXPECT_TRUE(is_none({{{1, 0}, {1.5, 1}}}));
  EXPECT_TRUE(is_none({{{0.6, 0}, {0, 0.6}}}));
  EXPECT_TRUE(is_none({{{1.5, 0}, {0, 1.5}}}));
}

// The disk of a face is where all of it is if its circle is: the places of a zone around it may
// have holes, but not larger ones than the circle would meet. Every third vertex is a ghost.
TEST_F(Zones, Disks_of_faces_at_dense_points_are_in_the_zone)
{
  std::size_t dense_vertices = 0, deep_vertices = 0;
  for (int k = 0; k < 120; ++k) {
    const double spacing = uniform(0.4, 1);
    Distributed_zone_2 zone = any_zone(0.7 * spacing);
    const double block_size = double(Distributed_zone_2::cells_per_block) * zone.cell_size();
    const double x = uniform(0, side), y = uniform(0, side);
    const Box_2 hole{x, y, x + uniform(1, 8) * block_size, y + uniform(1, 8) * block_size};
    const double shear = k % 3 == 0 ? 0 : uniform(-0.3, 0.3), turn = uniform(-0.05, 0.05);
    const Basis_2 basis = shear == 0 ? unit_basis : Basis_2{{{1, turn}, {shear, 1}}};
    zone.follow(basis);
    std::vector<Point> points;
    for (int n = int(side * side / (spacing * spacing)); n > 0; --n) {
      const Point p = place_in({0, 0, side, side});
      if (!hole.meets({p.x(), p.y(), p.x(), p.y()}))
        points.push_back(deformed(p, basis));
    }
    const Dynamic dt(points.begin(), points.end());
    const auto frame = dt.frame();
    std::vector<bool> are_dense(frame.number_of_vertices() + std::size_t(1), false);
    Distributed_density_2 density;
    density.set_zone(zone);
    std::vector<Vertex_index> own, ghosts;
    for (Vertex_index v(1); v < are_dense.size(); ++v)
      (v % 3 == 0 ? ghosts : own).push_back(v);
    density.clear(own.size());
    for (std::size_t n = 0; n < own.size(); ++n)
      density.add_own(n, zone, frame.position(own[n]));
    density.find_dense(zone, [&](const auto& add) {
      for (const Vertex_index v : ghosts)
        add(frame.position(v));
    });
    for (std::size_t n = 0; n < own.size(); ++n)
      are_dense[own[n]] = density.is_dense(n);
    for (const Vertex_index v : own) {
      const auto p = frame.position(v);
      dense_vertices += are_dense[v];
      deep_vertices += zone.depth_around(p.x, p.y) > 4 * block_size;
    }
    for (Face_index g(0); g < frame.number_of_faces(); ++g) {
      const auto face = frame.face(g);
      if (!are_dense[face[0]] && !are_dense[face[1]] && !are_dense[face[2]])
        continue;
      if (std::count(face.begin(), face.end(), infinite_index) > 0) {
        ADD_FAILURE() << "a dense vertex at the hull";
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

// The circle of a face is an ellipse in the zone, 4.8 cells wide and 3.6 times as long, which
// leaves the zone at the other end. It contains no whole block, and each block has a point outside
// of it.
TEST_F(Zones, Points_at_the_end_of_long_ellipses_that_contain_no_block_are_not_dense)
{
  const Basis_2 basis{{{1, 0}, {1.38, 1}}};
  Distributed_zone_2 zone({0, 0, 80, 80}, 1);
  zone.add({0, 0, 52.5, 80});
  zone.sum_up();
  zone.follow(basis);
  const double radius = 2.4 * std::sqrt(3.63);
  const auto on_unit_circle = [](double angle) { // in coordinates of the zone
    return Point(std::cos(angle) - 1.38 * std::sin(angle), std::sin(angle));
  };
  const auto squared_length = [](const Point& p) { return p.x() * p.x() + p.y() * p.y(); };
  double end = 0; // of the ellipse, on the left
  for (double angle = 0; angle < 6.28; angle += 0.001)
    if (on_unit_circle(angle).x() < 0 &&
        squared_length(on_unit_circle(angle)) > squared_length(on_unit_circle(end)))
      end = angle;
  const Point center(39.9 - radius * on_unit_circle(end).x(),
                     38 - radius * on_unit_circle(end).y());
  const auto on_circle = [&](double angle) {
    const Point p = on_unit_circle(angle);
    return Point(center.x() + radius * p.x(), center.y() + radius * p.y());
  };
  const auto distance = [&](const Point& p) { // from the center, in a space that is not deformed
    const double y = p.y() - center.y();
    return std::hypot(p.x() - center.x() + 1.38 * y, y);
  };
  std::vector<Point> places{on_circle(end), on_circle(end + 1.8), on_circle(end - 1.8)};
  for (double x = 0.02; x < 80; x += 4)
    for (double y = 0.02; y < 80; y += 4) {
      Point outmost(x, y);
      for (const Point& corner :
           {Point(x + 3.96, y), Point(x, y + 3.96), Point(x + 3.96, y + 3.96)})
        if (distance(corner) > distance(outmost))
          outmost = corner;
      ASSERT_GT(distance(outmost), 1.01 * radius);
      places.push_back(outmost);
    }
  const auto contains = [&](const Point& p) {
    const Point q = deformed(p, basis);
    return zone.contains(q.x(), q.y());
  };
  EXPECT_TRUE(contains(on_circle(end)));
  EXPECT_FALSE(contains(on_circle(end + 3.14)));
  Distributed_density_2 density;
  density.set_zone(zone);
  density.clear(places.size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    const Point q = deformed(places[n], basis);
    density.add_own(n, zone, {q.x(), q.y()});
  }
  density.find_dense(zone, [](const auto&) {});
  EXPECT_FALSE(density.is_dense(0));
}

} // namespace test_zones
