// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Drawing: with CGAL's viewer, where there is one, and without.

#define CGAL_TEST_SUITE 1 // the viewer then opens no window

#include <CGAL/draw_dynamic_delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_2>;
using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Point_distance_classifier_2>;

const Points points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};

// What `draw` writes to std::cerr.
template <class Draw>
std::string said_by(const Draw& draw)
{
  testing::internal::CaptureStderr();
  draw();
  return testing::internal::GetCapturedStderr();
}

std::string expected()
{
#ifdef CGAL_USE_BASIC_VIEWER
  return "";
#else
  return "Impossible to draw, CGAL_USE_BASIC_VIEWER is not defined.\n";
#endif
}

TEST(Draw, draws_or_says_that_it_cannot)
{
  const Exact dt(points.begin(), points.end());
  EXPECT_EQ(said_by([&] { CGAL::draw(dt); }), expected());
  EXPECT_EQ(said_by([&] { CGAL::draw(dt, "five points"); }), expected());
}

TEST(Draw, refuses_what_is_not_certified)
{
  Heuristic dt(points.begin(), points.end());
  dt.update(points.begin(), points.end());
  ASSERT_FALSE(dt.is_certified());
  EXPECT_THROW(CGAL::draw(dt), CGAL::Uncertified_triangulation_error_2);
  dt.mend();
  EXPECT_EQ(said_by([&] { CGAL::draw(dt); }), expected());
}

#ifdef CGAL_GRAPHICS_SCENE_H

TEST(Draw, adds_to_a_graphics_scene)
{
  const Exact dt(points.begin(), points.end());
  CGAL::Graphics_scene scene;
  CGAL::add_to_graphics_scene(dt, scene);
  EXPECT_FALSE(scene.empty());
  using T = CGAL::Triangulation_2<Kernel, Exact::Triangulation_data_structure>;
  CGAL::Graphics_scene_options<T, T::Vertex_handle, T::Finite_edges_iterator,
                               T::Finite_faces_iterator>
      options;
  options.disable_faces();
  CGAL::add_to_graphics_scene(dt, scene, options);
  EXPECT_EQ(said_by([&] { CGAL::draw(dt, options); }), expected());
  EXPECT_EQ(said_by([&] { CGAL::draw(dt, options, "five points"); }), expected());
}

#endif

} // namespace
