// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Alpha shapes, against CGAL's of exact numbers, and in periodic space against one of all images
// around.

#include "query_oracle.h"

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_alpha_shape_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace query_oracle;
using Shape = CGAL::Delaunay_alpha_shape_2;
using Class = Shape::Classification_type;
using Number = Epeck::FT;
using Ends = std::set<Exact_point>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;

using Vertex_base = CGAL::Alpha_shape_vertex_base_2<Epeck>;
using Face_base = CGAL::Alpha_shape_face_base_2<Epeck>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
using Cgal_shape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<Epeck, Structure>>;

Class class_of(Cgal_shape::Classification_type c)
{
  return c == Cgal_shape::EXTERIOR   ? Class::EXTERIOR
         : c == Cgal_shape::SINGULAR ? Class::SINGULAR
         : c == Cgal_shape::REGULAR  ? Class::REGULAR
                                     : Class::INTERIOR;
}

// All classes by places, so that they can be compared.
struct Classes
{
  std::map<Ends, Class> points, edges, faces;

  friend bool operator==(const Classes& a, const Classes& b)
  {
    return a.points == b.points && a.edges == b.edges && a.faces == b.faces;
  }
};

Classes classes_by_cgal(const Exact_points& points, const Number& alpha)
{
  Classes classes;
  const Cgal_shape shape(points.begin(), points.end(), alpha, Cgal_shape::GENERAL);
  for (auto v = shape.finite_vertices_begin(); v != shape.finite_vertices_end(); ++v)
    classes.points[{v->point()}] =
        shape.dimension() < 2 ? Class::SINGULAR : class_of(shape.classify(v));
  if (shape.dimension() < 2)
    return classes;
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f)
    classes.faces[{f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()}] =
        class_of(shape.classify(Cgal_shape::Face_handle(f)));
  for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e)
    classes.edges[{e->first->vertex(Cgal_shape::cw(e->second))->point(),
                   e->first->vertex(Cgal_shape::ccw(e->second))->point()}] =
        class_of(shape.classify(*e));
  return classes;
}

template <class Dynamic>
Classes classes_of(const Dynamic& dt, const Shape& shape)
{
  Classes classes;
  const auto frame = dt.frame();
  const auto point = [&](auto v) { return exact(dt.point(frame.id(v))); };
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id))
      classes.points[{exact(dt.point(id))}] = shape.points()[id];
  EXPECT_EQ(shape.edges().size(), frame.number_of_edges());
  EXPECT_EQ(shape.faces().size(), frame.number_of_faces());
  for (typename Dynamic::Frame::Edge_index e(0); e < shape.edges().size(); ++e) {
    const auto edge = frame.edge(e);
    if (frame.is_infinite(edge))
      EXPECT_EQ(shape.edges()[e], Class::EXTERIOR);
    else
      classes.edges[{point(edge.source), point(edge.target)}] = shape.edges()[e];
  }
  for (typename Dynamic::Frame::Face_index f(0); f < shape.faces().size(); ++f) {
    const auto [a, b, c] = frame.face(f);
    if (a == 0 || b == 0 || c == 0)
      EXPECT_EQ(shape.faces()[f], Class::EXTERIOR);
    else
      classes.faces[{point(a), point(b), point(c)}] = shape.faces()[f];
  }
  return classes;
}

// The number of edges and of faces of each class, which does not depend on the choice of diagonals.
std::array<std::size_t, 8> sizes(const Classes& classes)
{
  std::array<std::size_t, 8> sizes{};
  for (const auto& [ends, c] : classes.edges)
    ++sizes[std::size_t(c)];
  for (const auto& [ends, c] : classes.faces)
    ++sizes[4 + std::size_t(c)];
  return sizes;
}

template <class Kernel>
class Alpha_shapes_of : public testing::Test
{
protected:
  using Subject = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  using Points = std::vector<typename Kernel::Point_2>;

  static std::map<std::string, Points> clouds()
  {
    using Place = typename Kernel::Point_2;
    std::map<std::string, Points> clouds = clouds_of_all_kinds<Kernel>();
    clouds["many"] = Cloud<Kernel>(2).uniform(150);
    clouds["nearly straight hull"] = cloud_with_nearly_straight_hull<Kernel>();
    clouds["right angles"] = {Place(0, 0), Place(4, 0), Place(0, 3), Place(4, 3.5), Place(9, 1)};
    return clouds;
  }

  // Some values of alpha, among them the squared circumradii of some faces and edges.
  static std::vector<Number> alphas_of(const Points& points)
  {
    std::vector<Number> alphas{0, 0.25, 0.5, 1, 4, 1000};
    for (std::size_t i = 0; i + 2 < points.size() && i < 20; ++i) {
      const Exact_point p = exact(points[i]), q = exact(points[i + 1]), r = exact(points[i + 2]);
      alphas.push_back(CGAL::squared_radius(p, q));
      if (!CGAL::collinear(p, q, r))
        alphas.push_back(CGAL::squared_radius(p, q, r));
    }
    return alphas;
  }

  static typename Kernel::FT number(const Number& alpha)
  {
    if constexpr (std::is_same_v<Kernel, Epeck>)
      return alpha;
    else
      return CGAL::to_double(alpha.exact());
  }
};

using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Alpha_shapes_of, Kernels);

TYPED_TEST(Alpha_shapes_of, classes_are_those_of_cgal_also_where_alpha_is_the_radius_of_a_face)
{
  for (const auto& [name, points] : this->clouds()) {
    SCOPED_TRACE(name);
    const typename TestFixture::Subject dt(points.begin(), points.end());
    for (const Number& alpha : this->alphas_of(points)) {
      SCOPED_TRACE(CGAL::to_double(alpha));
      const auto given = this->number(alpha);
      Shape shape;
      shape.compute(dt, given);
      const Classes found = classes_of(dt, shape),
                    expected = classes_by_cgal(exact_points(points), Number(given));
      ASSERT_EQ(found.points, expected.points);
      ASSERT_EQ(sizes(found), sizes(expected));
      if (name != "lattice" && name != "circle" && name != "circle and center") {
        ASSERT_EQ(found, expected);
      }
    }
  }
}

TEST(Alpha_shapes, alpha_must_be_a_finite_number_and_the_triangulation_certified)
{
  const auto points = Cloud<Epick>(3).uniform(50);
  const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  Shape shape;
  shape.compute(dt, 0.3);
  const Shape::Classes before = shape.edges();
  for (const double alpha :
       {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(shape.compute(dt, alpha), CGAL::Parameter_error_2) << alpha;
  using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2>;
  Heuristic uncertified(points.begin(), points.end(), CGAL::Random_classifier_2(0, 1));
  auto moved = points;
  Cloud<Epick>(4).shake(moved, 0.5);
  uncertified.update(moved.begin(), moved.end());
  EXPECT_THROW(shape.compute(uncertified, 0.3), CGAL::Uncertified_triangulation_error_2);
  EXPECT_EQ(shape.edges(), before);
}

TEST(Alpha_shapes, removed_ids_are_outside_and_duplicates_are_what_their_point_is)
{
  auto points = Cloud<Epick>(6).uniform(100);
  points.push_back(points[40]);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  dt.remove(7);
  Shape shape;
  shape.compute(dt, 0.8);
  ASSERT_EQ(shape.points().size(), 101u);
  EXPECT_EQ(shape.points()[7], Class::EXTERIOR);
  EXPECT_EQ(shape.points()[100], shape.points()[40]);
}

TEST(Alpha_shapes, sizes_that_overflow_or_underflow_are_compared_all_the_same)
{
  for (const double scale : {1e-200, 1e-100, 1e100, 1e150}) {
    SCOPED_TRACE(scale);
    const auto points = scaled<Epick>(Cloud<Epick>::grid(3, 3), scale);
    const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
    for (const double share : {0.24, 0.26, 0.49, 0.51}) {
      Shape shape;
      const Number alpha = Number(share) * Number(scale) * Number(scale);
      shape.compute(dt, alpha);
      ASSERT_EQ(sizes(classes_of(dt, shape)), sizes(classes_by_cgal(exact_points(points), alpha)));
    }
  }
}

// How many edges and faces of a class there are, times their numbers of ends: as each of them goes
// on from each of its ends, those at the points of one cell are enough.
std::map<std::pair<std::size_t, Class>, std::size_t>
ends_by_class(const Classes& classes, const std::set<Exact_point>& cell)
{
  std::map<std::pair<std::size_t, Class>, std::size_t> ends;
  for (const auto* some : {&classes.edges, &classes.faces})
    for (const auto& [corners, c] : *some)
      if (c != Class::EXTERIOR)
        for (const Exact_point& p : corners)
          if (cell.count(p) > 0)
            ++ends[{corners.size(), c}];
  return ends;
}

void expect_periodic(const Periodic& dt, double alpha)
{
  std::set<Exact_point> points;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    points.insert(exact(dt.point(id)));
  const Classes expected = classes_by_cgal(images_around(dt, 4), alpha);
  Shape shape;
  shape.compute(dt, alpha);
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    EXPECT_EQ(shape.points()[id], expected.points.at({exact(dt.point(id))})) << id;
  std::map<std::pair<std::size_t, Class>, std::size_t> ends;
  for (const Class c : shape.edges())
    if (c != Class::EXTERIOR)
      ends[{2, c}] += 2;
  for (const Class c : shape.faces())
    if (c != Class::EXTERIOR)
      ends[{3, c}] += 3;
  EXPECT_EQ(ends, ends_by_class(expected, points));
}

TEST(Alpha_shapes, on_a_torus_and_in_a_slab_they_are_those_of_all_images)
{
  for (const CGAL::Periodic_cell_2& cell :
       {CGAL::Periodic_cell_2(1, 1), CGAL::Periodic_cell_2(1, 0.1, 0.4, 0.9),
        CGAL::Periodic_cell_2::slab(1, 0)})
    for (const std::size_t number : {2u, 5u, 30u})
      for (const double alpha : {0.1, 0.3, 0.5, 0.8, 1.5, 3.0}) {
        SCOPED_TRACE(testing::Message() << number << " points, alpha " << alpha);
        const double scale = 1 / std::sqrt(double(number));
        const auto points = scaled<Epick>(Cloud<Epick>(7).uniform(number), scale);
        ASSERT_NO_FATAL_FAILURE(expect_periodic(Periodic(points, cell), alpha * scale * scale));
      }
  const Periodic lattice(scaled<Epick>(Cloud<Epick>::grid(4, 4), 0.25),
                         CGAL::Periodic_cell_2(1, 1));
  for (const double alpha : {0.01, 0.015625, 0.02, 0.03125, 0.04})
    ASSERT_NO_FATAL_FAILURE(expect_periodic(lattice, alpha));
}

TEST(Alpha_shapes, along_a_slab_a_row_of_points_is_a_chain)
{
  const std::vector<Epick::Point_2> row{{0.1, 0.5}, {0.4, 0.5}, {0.8, 0.5}};
  const Periodic dt(row, CGAL::Periodic_cell_2::slab(1, 0));
  for (const auto& [alpha, expected] :
       std::map<double, std::ptrdiff_t>{{0.02, 0}, {0.0226, 2}, {0.039, 2}, {0.0401, 3}, {9, 3}}) {
    Shape shape;
    shape.compute(dt, alpha);
    EXPECT_EQ(std::count(shape.edges().begin(), shape.edges().end(), Class::SINGULAR), expected);
    EXPECT_EQ(shape.points(), Shape::Classes(3, Class::SINGULAR));
  }
}

} // namespace
