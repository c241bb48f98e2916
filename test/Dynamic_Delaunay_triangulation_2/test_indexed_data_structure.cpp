// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What CGAL and Boost do with a triangulation on the indexed data structure is what they do on
// CGAL's own structure.

#include <CGAL/boost/graph/graph_traits_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_adaptation_policies_2.h>
#include <CGAL/Delaunay_triangulation_adaptation_traits_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_triangulation_data_structure_2.h>
#include <CGAL/interpolation_functions.h>
#include <CGAL/natural_neighbor_coordinates_2.h>
#include <CGAL/Random.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/Voronoi_diagram_2.h>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/iterator/zip_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/tuple/tuple.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <new>
#include <random>
#include <set>
#include <sstream>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace test_indexed_data_structure {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Points = std::vector<Point>;
using Indexed_tds = CGAL::Indexed_triangulation_data_structure_2<Kernel>;
using Indexed = CGAL::Delaunay_triangulation_2<Kernel, Indexed_tds>;
using Indexed_with_info =
    CGAL::Delaunay_triangulation_2<Kernel,
                                   CGAL::Indexed_triangulation_data_structure_2<Kernel, int>>;
using Usual = CGAL::Delaunay_triangulation_2<Kernel>;
using Usual_with_info_tds =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>>;
using Usual_with_info = CGAL::Delaunay_triangulation_2<Kernel, Usual_with_info_tds>;

Points random_points(std::size_t number, unsigned seed)
{
  CGAL::Random random(seed);
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double x = random.get_double();
    points.push_back(Point(x, random.get_double()));
  }
  return points;
}

// A square lattice, with all its cocircular points.
Points lattice(int size)
{
  Points points;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      points.push_back(Point(x, y));
  return points;
}

// The finite faces as sets of points: the same for the same triangulation on any structure.
template <class Triangulation>
std::set<std::array<Point, 3>> triangles_of(const Triangulation& t)
{
  std::set<std::array<Point, 3>> result;
  for (const auto f : t.finite_face_handles()) {
    std::array<Point, 3> corners{f->vertex(0)->point(), f->vertex(1)->point(),
                                 f->vertex(2)->point()};
    std::sort(corners.begin(), corners.end());
    result.insert(corners);
  }
  return result;
}

template <class One, class Other>
void expect_same(const One& one, const Other& other)
{
  EXPECT_TRUE(one.is_valid());
  EXPECT_TRUE(other.is_valid());
  EXPECT_TRUE(one.tds().is_valid());
  EXPECT_TRUE(one.dimension() == other.dimension());
  EXPECT_TRUE(one.number_of_vertices() == other.number_of_vertices());
  EXPECT_TRUE(triangles_of(one) == triangles_of(other));
}

// INFO --------------------------------------------------------------------------------------------

TEST(Indexed_data_structure, takes_points_with_infos)
{
  const Points points = random_points(500, 1);
  std::vector<int> infos;
  std::vector<std::pair<Point, int>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    infos.push_back(int(i) + 7);
    pairs.emplace_back(points[i], infos.back());
  }
  Indexed_with_info of_pairs;
  EXPECT_TRUE(of_pairs.insert(pairs.begin(), pairs.end()) == 500);
  Indexed_with_info of_zip;
  const auto first = boost::make_tuple(points.begin(), infos.begin());
  const auto last = boost::make_tuple(points.end(), infos.end());
  EXPECT_TRUE(of_zip.insert(boost::make_zip_iterator(first), boost::make_zip_iterator(last)) ==
              500);
  // Points alone can still be inserted.
  Indexed_with_info of_points(points.begin(), points.end());
  expect_same(of_pairs, of_zip);
  expect_same(of_pairs, of_points);

  std::map<Point, int> info_of(pairs.begin(), pairs.end());
  for (const auto v : of_pairs.finite_vertex_handles())
    EXPECT_TRUE(v->info() == info_of.at(v->point()));
  for (const auto v : of_zip.finite_vertex_handles())
    EXPECT_TRUE(v->info() == info_of.at(v->point()));
  const Indexed_with_info copy(of_pairs);
  for (const auto v : copy.finite_vertex_handles())
    EXPECT_TRUE(v->info() == info_of.at(v->point()));
}

// COPIES AND FILES --------------------------------------------------------------------------------

struct Convert_vertex
{
  // CGAL's structure creates a vertex by this operator,
  Usual_with_info_tds::Vertex operator()(const Indexed_with_info::Vertex& from) const
  {
    return Usual_with_info_tds::Vertex(from.point());
  }
  // and then calls this one. The indexed structure calls this one only.
  template <class From, class To>
  void operator()(const From& from, To& to) const
  {
    to.set_point(from.point());
    to.info() = from.info();
  }
};

struct Convert_face
{
  template <class From>
  Usual_with_info_tds::Face operator()(const From&) const
  {
    return Usual_with_info_tds::Face();
  }
  template <class From, class To>
  void operator()(const From&, To&) const
  {
  }
};

void structures_are_copied_to_each_other(const Points& points)
{
  Usual_with_info usual(points.begin(), points.end());
  int next = 0;
  for (const auto v : usual.finite_vertex_handles())
    v->info() = next++;

  Indexed_with_info indexed;
  indexed.set_infinite_vertex(indexed.tds().copy_tds(usual.tds(), usual.infinite_vertex(),
                                                     Convert_vertex(), Convert_face()));
  expect_same(indexed, usual);
  // One that grows and shrinks before it is copied has holes.
  const Points others = random_points(50, 2);
  std::vector<Indexed_with_info::Vertex_handle> added;
  for (const Point& p : others)
    added.push_back(indexed.insert(p));
  for (const auto v : added)
    indexed.remove(v);

  Usual_with_info back;
  back.set_infinite_vertex(back.tds().copy_tds(indexed.tds(), indexed.infinite_vertex(),
                                               Convert_vertex(), Convert_face()));
  expect_same(back, usual);
  std::map<Point, int> info_of;
  for (const auto v : usual.finite_vertex_handles())
    info_of[v->point()] = v->info();
  for (const auto v : indexed.finite_vertex_handles())
    EXPECT_TRUE(v->info() == info_of.at(v->point()));
  for (const auto v : back.finite_vertex_handles())
    EXPECT_TRUE(v->info() == info_of.at(v->point()));

  // Without converters points are copied alone.
  Indexed plain;
  plain.set_infinite_vertex(plain.tds().copy_tds(back.tds(), back.infinite_vertex()));
  expect_same(plain, usual);
}

void streams_keep_all(const Points& points)
{
  const Indexed written(points.begin(), points.end());
  std::stringstream file;
  file.precision(17);
  file << written;
  Indexed read;
  file >> read;
  expect_same(read, written);

  // Files of the two structures are alike.
  std::stringstream file_of_usual;
  file_of_usual.precision(17);
  file_of_usual << Usual(points.begin(), points.end());
  Indexed read_of_usual;
  file_of_usual >> read_of_usual;
  EXPECT_TRUE(read_of_usual.is_valid());
  EXPECT_TRUE(read_of_usual.number_of_vertices() == written.number_of_vertices());
}

// HANDLES -----------------------------------------------------------------------------------------

template <class Handles>
void handles_are_keys(const Handles& handles, std::size_t number)
{
  using Handle = typename Handles::value_type;
  CGAL::Unique_hash_map<Handle, std::size_t> by_cgal(number + 1);
  std::unordered_map<Handle, std::size_t> by_hash;
  std::set<Handle> ordered;
  std::unordered_set<std::size_t> hashes;
  std::size_t next = 0;
  for (const Handle& h : handles) {
    EXPECT_TRUE(!by_cgal.is_defined(h));
    by_cgal[h] = next;
    EXPECT_TRUE(by_hash.emplace(h, next).second);
    EXPECT_TRUE(ordered.insert(h).second);
    EXPECT_TRUE(hashes.insert(hash_value(h)).second);
    ++next;
  }
  EXPECT_TRUE(next == number);
  next = 0;
  for (const Handle& h : handles) {
    EXPECT_TRUE(by_cgal[h] == next);
    EXPECT_TRUE(by_hash.at(h) == next);
    EXPECT_TRUE(ordered.count(h) == 1);
    ++next;
  }
  EXPECT_TRUE(ordered.count(Handle()) == 0);
  EXPECT_TRUE(by_hash.count(Handle()) == 0);
}

TEST(Indexed_data_structure, has_handles_that_are_keys_beside_those_of_another_one)
{
  const Points points = random_points(300, 3);
  const Indexed one(points.begin(), points.end()), copy(one);
  std::vector<Indexed::Vertex_handle> vertices;
  std::vector<Indexed::Face_handle> all_faces;
  for (const Indexed* t : {&one, &copy}) {
    for (const auto v : t->all_vertex_handles())
      vertices.push_back(v);
    for (const auto f : t->all_face_handles())
      all_faces.push_back(f);
  }
  handles_are_keys(vertices, vertices.size());
  handles_are_keys(all_faces, all_faces.size());
}

// GRAPH -------------------------------------------------------------------------------------------

// CGAL's graph begins with an edge in `v->face()`, and does not ask whether that one is finite.
template <class Triangulation>
void begin_with_finite_edges(Triangulation& t)
{
  for (const auto v : t.finite_vertex_handles()) {
    auto edge = t.incident_edges(v);
    while (t.is_infinite(edge))
      ++edge;
    v->set_face(edge->first);
  }
}

// The number of edges from one of the points to every other.
template <class Triangulation>
std::map<Point, int> steps_from(const Triangulation& t, const Point& start)
{
  using Vertex = typename boost::graph_traits<Triangulation>::vertex_descriptor;
  std::unordered_map<Vertex, boost::default_color_type> colors;
  std::unordered_map<Vertex, int> steps;
  const Vertex first = t.nearest_vertex(start);
  steps[first] = 0;
  boost::breadth_first_search(
      t, first,
      boost::color_map(boost::make_assoc_property_map(colors))
          .visitor(boost::make_bfs_visitor(boost::record_distances(
              boost::make_assoc_property_map(steps), boost::on_tree_edge()))));
  std::map<Point, int> result;
  for (const auto& [v, number] : steps)
    result[v->point()] = number;
  return result;
}

void graphs_are_the_same(const Points& points)
{
  Indexed indexed(points.begin(), points.end());
  Usual usual(points.begin(), points.end());
  begin_with_finite_edges(indexed);
  begin_with_finite_edges(usual);
  const auto [vertex, vertices_end] = vertices(indexed);
  const auto [edge, edges_end] = edges(indexed);
  EXPECT_TRUE(std::distance(vertex, vertices_end) == std::ptrdiff_t(points.size()));
  EXPECT_TRUE(num_vertices(indexed) == num_vertices(usual));
  EXPECT_TRUE(num_edges(indexed) == num_edges(usual));
  EXPECT_TRUE(num_edges(indexed) == std::size_t(std::distance(edge, edges_end)));
  for (const auto v : indexed.finite_vertex_handles()) {
    const auto [out, out_end] = out_edges(v, indexed);
    EXPECT_TRUE(std::size_t(std::distance(out, out_end)) == out_degree(v, indexed));
    for (auto e = out; e != out_end; ++e)
      EXPECT_TRUE(source(*e, indexed) == v && target(*e, indexed) != v);
    const auto [neighbor, neighbors_end] = adjacent_vertices(v, indexed);
    EXPECT_TRUE(std::size_t(std::distance(neighbor, neighbors_end)) == out_degree(v, indexed));
    for (auto w = neighbor; w != neighbors_end; ++w)
      EXPECT_TRUE(indexed.is_edge(v, *w));
  }
  EXPECT_TRUE(steps_from(indexed, points[0]).size() == points.size());
  EXPECT_TRUE(steps_from(indexed, points[0]) == steps_from(usual, points[0]));
}

// VORONOI DIAGRAM AND INTERPOLATION ---------------------------------------------------------------

template <class Triangulation>
using Diagram = CGAL::Voronoi_diagram_2<
    Triangulation, CGAL::Delaunay_triangulation_adaptation_traits_2<Triangulation>,
    CGAL::Delaunay_triangulation_caching_degeneracy_removal_policy_2<Triangulation>>;

// For each site the number of edges of its cell.
template <class Triangulation>
std::map<Point, int> edges_of_cells(const Diagram<Triangulation>& diagram)
{
  std::map<Point, int> result;
  for (auto cell = diagram.faces_begin(); cell != diagram.faces_end(); ++cell) {
    int& number = result[cell->dual()->point()];
    auto around = cell->ccb();
    const auto done = around;
    do
      ++number;
    while (++around != done);
  }
  return result;
}

void voronoi_diagrams_are_the_same(const Points& points)
{
  const Diagram<Indexed> indexed(Indexed(points.begin(), points.end()));
  const Diagram<Usual> usual(Usual(points.begin(), points.end()));
  EXPECT_TRUE(indexed.is_valid());
  EXPECT_TRUE(indexed.number_of_faces() == points.size());
  EXPECT_TRUE(indexed.number_of_vertices() == usual.number_of_vertices());
  EXPECT_TRUE(indexed.number_of_halfedges() == usual.number_of_halfedges());
  EXPECT_TRUE(indexed.number_of_connected_components() == usual.number_of_connected_components());
  EXPECT_TRUE(edges_of_cells(indexed) == edges_of_cells(usual));
  std::set<Point> corners, corners_of_usual;
  for (auto v = indexed.vertices_begin(); v != indexed.vertices_end(); ++v)
    corners.insert(v->point());
  for (auto v = usual.vertices_begin(); v != usual.vertices_end(); ++v)
    corners_of_usual.insert(v->point());
  EXPECT_TRUE(corners.size() == corners_of_usual.size());
}

TEST(Indexed_data_structure, interpolates_as_on_cgals_structure)
{
  const Points points = random_points(300, 5);
  const Indexed indexed(points.begin(), points.end());
  const Usual usual(points.begin(), points.end());
  std::map<Point, double, Kernel::Less_xy_2> values;
  for (const Point& p : points)
    values[p] = 3 + 2 * p.x() - p.y();
  CGAL::Random random(6);
  for (int i = 0; i < 100; ++i) {
    const double x = random.get_double(0.3, 0.7);
    const Point p(x, random.get_double(0.3, 0.7));
    std::vector<std::pair<Point, double>> of_indexed, of_usual;
    const auto result =
        CGAL::natural_neighbor_coordinates_2(indexed, p, std::back_inserter(of_indexed));
    EXPECT_TRUE(result.third);
    CGAL::natural_neighbor_coordinates_2(usual, p, std::back_inserter(of_usual));
    EXPECT_TRUE(std::set(of_indexed.begin(), of_indexed.end()).size() == of_usual.size());
    const double value =
        CGAL::linear_interpolation(of_indexed.begin(), of_indexed.end(), result.second,
                                   CGAL::Data_access<decltype(values)>(values));
    // Natural neighbors reproduce linear functions.
    EXPECT_TRUE(std::abs(value - (3 + 2 * p.x() - p.y())) < 1e-9);

    // With vertices in place of points there are as many.
    using Weighted_vertex = std::pair<Indexed::Vertex_handle, double>;
    std::vector<Weighted_vertex> vertices;
    const auto of_vertices = CGAL::natural_neighbor_coordinates_2(
        indexed, p, std::back_inserter(vertices), CGAL::Identity<Weighted_vertex>());
    EXPECT_TRUE(of_vertices.third);
    EXPECT_TRUE(vertices.size() == of_indexed.size());
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      EXPECT_TRUE(vertices[k].first->point() == of_indexed[k].first);
      EXPECT_TRUE(vertices[k].second == of_indexed[k].second);
    }
  }
}

// CHANGES -----------------------------------------------------------------------------------------

void all_vertices_are_removed(const Points& points)
{
  Indexed indexed(points.begin(), points.end());
  Usual usual(points.begin(), points.end());
  std::vector<Point> order(points);
  CGAL::Random random(8);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.uniform_int(std::size_t(0), i - 1)]);
  for (std::size_t i = 0; i < order.size(); ++i) {
    indexed.remove(indexed.nearest_vertex(order[i]));
    usual.remove(usual.nearest_vertex(order[i]));
    if (i % 50 == 0 || i + 5 > order.size())
      expect_same(indexed, usual);
  }
  EXPECT_TRUE(indexed.number_of_vertices() == 0);
  EXPECT_TRUE(indexed.dimension() == -1);
  indexed.insert(points.begin(), points.end());
  usual.insert(points.begin(), points.end());
  EXPECT_TRUE(indexed.is_valid());
  EXPECT_TRUE(indexed.number_of_vertices() == usual.number_of_vertices());
}

TEST(Indexed_data_structure, moves_vertices_as_cgals_structure_does)
{
  const Points points = random_points(300, 9);
  Indexed indexed;
  Usual usual;
  std::vector<Indexed::Vertex_handle> of_indexed;
  std::vector<Usual::Vertex_handle> of_usual;
  for (const Point& p : points) {
    of_indexed.push_back(indexed.insert(p));
    of_usual.push_back(usual.insert(p));
  }
  CGAL::Random random(10);
  for (int round = 0; round < 5; ++round) {
    // First by little, then everywhere.
    const double reach = round < 3 ? 0.02 : 2;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = of_usual[i]->point();
      const double x = p.x() + random.get_double(-reach, reach);
      const Point q(x, p.y() + random.get_double(-reach, reach));
      EXPECT_TRUE(indexed.move_if_no_collision(of_indexed[i], q) == of_indexed[i]);
      usual.move_if_no_collision(of_usual[i], q);
    }
    expect_same(indexed, usual);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_TRUE(of_indexed[i]->point() == of_usual[i]->point());
  }
  // A vertex that is moved onto another one does not replace it.
  EXPECT_TRUE(indexed.move_if_no_collision(of_indexed[0], of_indexed[1]->point()) == of_indexed[1]);
  EXPECT_TRUE(indexed.number_of_vertices() == points.size());
  EXPECT_TRUE(indexed.move(of_indexed[0], Point(of_indexed[1]->point())) == of_indexed[1]);
  EXPECT_TRUE(indexed.number_of_vertices() == points.size() - 1);
  EXPECT_TRUE(indexed.is_valid());
}

// A point that is removed and inserted again may be given by a reference into the structure.
TEST(Indexed_data_structure, takes_its_own_points_again)
{
  const Points points = random_points(100, 11);
  Indexed indexed(points.begin(), points.end());
  for (int i = 0; i < 200; ++i) {
    const Indexed::Vertex_handle v = indexed.finite_vertices_begin();
    const Point p = v->point();
    const Point& of_structure = v->point();
    indexed.remove(v);
    EXPECT_TRUE(indexed.insert(of_structure)->point() == p);
  }
  EXPECT_TRUE(indexed.is_valid());
  EXPECT_TRUE(indexed.number_of_vertices() == points.size());
}

// -------------------------------------------------------------------------------------------------
// On several sets of points.

std::vector<Points> point_sets()
{
  const Points cocircular = lattice(12);
  const auto first = [&](int number) {
    return Points(cocircular.begin(), cocircular.begin() + number);
  };
  return {random_points(400, 20), cocircular, Points(), first(1), first(5)};
}

TEST(Indexed_data_structure, is_written_and_read_by_streams)
{
  for (const Points& points : point_sets())
    streams_keep_all(points);
}

TEST(Indexed_data_structure, is_copied_to_cgals_structure_and_back)
{
  for (const Points& points : point_sets())
    structures_are_copied_to_each_other(points);
}

TEST(Indexed_data_structure, lets_all_vertices_be_removed)
{
  for (const Points& points : point_sets())
    all_vertices_are_removed(points);
}

TEST(Indexed_data_structure, is_a_graph_for_boost)
{
  graphs_are_the_same(random_points(400, 20));
}

TEST(Indexed_data_structure, has_a_voronoi_diagram)
{
  voronoi_diagrams_are_the_same(random_points(400, 20));
  voronoi_diagrams_are_the_same(lattice(12));
}

// -------------------------------------------------------------------------------------------------
// What it has beyond the concept.

TEST(Indexed_data_structure,
     keeps_properties_with_vertices_and_faces_through_insertions_and_removals)
{
  const Points points = random_points(300, 30);
  Indexed t(points.begin(), points.begin() + 200);
  const auto [x_of, is_new] = t.tds().add_vertex_property<double>("x", -1);
  EXPECT_TRUE(is_new);
  EXPECT_FALSE(t.tds().add_vertex_property<double>("x", 7).second);
  const auto mark_of = t.tds().add_face_property<int>("mark", 5).first;
  for (const auto v : t.finite_vertex_handles())
    x_of[v] = v->point().x();
  t.insert(points.begin() + 200, points.end());
  std::size_t newcomers = 0;
  for (const auto v : t.finite_vertex_handles()) {
    newcomers += x_of[v] == -1;
    x_of[v] = v->point().x();
  }
  EXPECT_EQ(newcomers, 100u);
  for (std::size_t i = 0; i < 150; ++i)
    t.remove(t.nearest_vertex(points[2 * i]));
  for (const auto v : t.finite_vertex_handles())
    EXPECT_EQ(get(x_of, v), v->point().x());
  for (const auto f : t.all_face_handles())
    EXPECT_EQ(mark_of[f], 5);
}

TEST(Indexed_data_structure, closes_its_holes_when_garbage_is_collected)
{
  const Points points = random_points(300, 31);
  Indexed t(points.begin(), points.end());
  for (std::size_t i = 0; i < 100; ++i)
    t.remove(t.nearest_vertex(points[3 * i]));
  const auto triangles = triangles_of(t);
  EXPECT_TRUE(t.tds().has_garbage());
  const auto x_of = t.tds().add_vertex_property<double>("x").first;
  for (const auto v : t.finite_vertex_handles())
    x_of[v] = v->point().x();

  Indexed_tds tds(t.tds());
  tds.collect_garbage();
  EXPECT_FALSE(tds.has_garbage());
  EXPECT_TRUE(tds.is_valid());
  const auto copied_x_of = tds.add_vertex_property<double>("x").first;
  for (std::size_t i = 0; i < tds.number_of_vertices(); ++i) {
    const auto v = tds.vertex_handle(i);
    EXPECT_EQ(v.index(), i);
    if (i > 0) { // the infinite one comes first
      EXPECT_EQ(copied_x_of[v], v->point().x());
    }
  }
  Indexed without_holes;
  without_holes.set_infinite_vertex(
      without_holes.tds().copy_tds(tds, tds.vertex_handle(t.infinite_vertex().index())));
  EXPECT_TRUE(without_holes.is_valid());
  EXPECT_TRUE(triangles_of(without_holes) == triangles);
}

TEST(Indexed_data_structure, has_handles_that_survive_growth_and_moves)
{
  const Points points = random_points(2000, 32);
  Indexed t(points.begin(), points.begin() + 10);
  const Indexed::Vertex_handle v = t.finite_vertices_begin();
  const Point p = v->point();
  t.insert(points.begin() + 10, points.end());
  Indexed moved(std::move(t));
  Indexed other;
  other.swap(moved);
  EXPECT_EQ(v->point(), p);
  EXPECT_TRUE(other.nearest_vertex(p) == v);
  moved.clear();
  moved.insert(points.begin(), points.begin() + 50);
  EXPECT_TRUE(moved.is_valid());
}

TEST(Indexed_data_structure, can_be_destroyed_while_elements_have_no_neighbors)
{
  Indexed_tds tds;
  const auto f = tds.create_face();
  tds.create_vertex()->set_face(f);
  Indexed_tds taken(std::move(tds));
  tds.clear();
  EXPECT_EQ(tds.number_of_vertices(), 0u);
  EXPECT_EQ(taken.number_of_vertices(), 1u);
}

// -------------------------------------------------------------------------------------------------
// The triangulation of moving points is a triangulation of CGAL on this structure.

TEST(Triangulation_state, works_with_cgals_queries_and_adaptors_after_every_frame)
{
  std::mt19937 random(40);
  std::normal_distribution<double> step(0, 0.01);
  Points points = random_points(300, 41);
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points);
  for (int frame = 0; frame < 5; ++frame) {
    for (Point& p : points)
      p = Point(p.x() + step(random), p.y() + step(random));
    dt.update(points);
    const Usual usual(points.begin(), points.end());
    expect_same(dt.triangulation(), usual);
    const Point q(0.5, 0.5);
    EXPECT_EQ(dt.triangulation().nearest_vertex(q)->point(), usual.nearest_vertex(q)->point());
    const auto face = dt.triangulation().locate(q);
    EXPECT_FALSE(dt.triangulation().is_infinite(face));
    EXPECT_TRUE(edges_of_cells(Diagram<Indexed>(dt.triangulation())) ==
                edges_of_cells(Diagram<Usual>(usual)));
  }
}

// Converters of vertices and faces, as CGAL's structure demands them.
struct Copied_vertex
{
  Usual::Vertex operator()(const Indexed::Vertex& v) const { return Usual::Vertex(v.point()); }
  void operator()(const Indexed::Vertex&, Usual::Vertex&) const {}
};
struct Copied_face
{
  Usual::Face operator()(const Indexed::Face&) const { return Usual::Face(); }
  void operator()(const Indexed::Face&, Usual::Face&) const {}
};

TEST(Triangulation_state, is_copied_to_any_other_one_and_goes_its_own_way_then)
{
  const Points points = random_points(200, 42);
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points);
  Indexed copy(dt.triangulation());
  copy.insert(Point(0.5, 0.5));
  EXPECT_TRUE(copy.is_valid());
  EXPECT_EQ(copy.number_of_vertices(), 201u);
  EXPECT_EQ(dt.triangulation().number_of_vertices(), 200u);
  EXPECT_TRUE(dt.is_valid(true));

  Usual usual;
  usual.set_infinite_vertex(usual.tds().copy_tds(dt.triangulation().tds(), dt.infinite_vertex(),
                                                 Copied_vertex(), Copied_face()));
  EXPECT_TRUE(usual.is_valid());
  expect_same(dt.triangulation(), usual);
}

TEST(Triangulation_state, keeps_properties_through_frames_insertions_removals_and_checkpoints)
{
  std::mt19937 random(43);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Points points = random_points(200, 44);
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points);
  const auto id_of = dt.add_vertex_property<int>("id", -1).first;
  dt.add_face_property<int>("mark", 1);
  for (std::size_t id = 0; id < points.size(); ++id)
    id_of[dt.vertex(id)] = int(id);
  const auto expect_kept = [&] {
    for (std::size_t id = 0; id < points.size(); ++id)
      ASSERT_EQ(id_of[dt.vertex(id)], int(id));
  };
  for (int frame = 0; frame < 6; ++frame) {
    for (Point& p : points) // everywhere in the last frames, so that vertices are numbered anew
      if (frame > 2 || random() % 50 == 0)
        p = Point(coordinate(random), coordinate(random));
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_kept());
    dt.remove(7);
    EXPECT_EQ(dt.insert(points[7]), 7u);
    EXPECT_EQ(id_of[dt.vertex(7)], -1);
    id_of[dt.vertex(7)] = 7;
    ASSERT_NO_FATAL_FAILURE(expect_kept());
  }
  std::stringstream file;
  dt.write_checkpoint(file);
  dt.read_checkpoint(file);
  EXPECT_EQ(id_of[dt.vertex(3)], -1); // the vertices are new
  ASSERT_TRUE(dt.is_valid(true));
}

// A value that can be moved; copies fail when no more are left.
struct Rarely_copied
{
  static inline int copies_left = 1 << 30;
  static int copied(int value)
  {
    if (copies_left == 0)
      throw std::bad_alloc();
    --copies_left;
    return value;
  }

  explicit Rarely_copied(int v = -1)
    : value(v)
  {
  }
  Rarely_copied(const Rarely_copied& other)
    : value(copied(other.value))
  {
  }
  Rarely_copied(Rarely_copied&& other) noexcept = default;
  Rarely_copied& operator=(Rarely_copied other) noexcept
  {
    value = other.value;
    return *this;
  }

  int value;
};

// Calls change(triangulation), where values can be copied 0, 1, 2, ... times, until it succeeds.
template <class Change>
void expect_unchanged_unless_values_are_copied(const Change& change)
{
  const Points points = random_points(60, 45);
  for (int copies = 0, succeeds = 0; succeeds == 0; ++copies) {
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points);
    const auto value_of = dt.add_vertex_property<Rarely_copied>("value").first;
    dt.add_face_property<Rarely_copied>("value");
    for (std::size_t id = 0; id < points.size(); ++id)
      value_of[dt.vertex(id)].value = int(id);
    Rarely_copied::copies_left = copies;
    try {
      change(dt);
      succeeds = 1;
    } catch (const std::bad_alloc&) {
    }
    Rarely_copied::copies_left = 1 << 30;
    ASSERT_TRUE(dt.is_valid(true));
    for (const auto v : dt.tds().vertex_handles())
      if (v != dt.infinite_vertex()) {
        ASSERT_EQ(value_of[v].value, dt.id(v) < points.size() ? int(dt.id(v)) : -1);
      }
  }
}

TEST(Triangulation_state, changes_nothing_if_values_of_users_cannot_be_copied)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  const std::vector<std::size_t> going{3, 7, 20};
  const Points others = random_points(300, 46);
  expect_unchanged_unless_values_are_copied(
      [&](Dynamic& dt) { dt.remove(going.begin(), going.end()); });
  expect_unchanged_unless_values_are_copied([&](Dynamic& dt) { dt.insert(others.front()); });
  expect_unchanged_unless_values_are_copied(
      [&](Dynamic& dt) { dt.insert(others.begin(), others.end()); });
}

} // namespace test_indexed_data_structure
