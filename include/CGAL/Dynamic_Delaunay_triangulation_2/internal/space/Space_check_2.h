// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_SPACE_CHECK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_SPACE_CHECK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class T>
T as(T); // to be called with what has to convert to T

struct Any_function
{
  template <class... Arguments>
  void operator()(Arguments&&...) const;
};

// Whether `use` can be called with a space and with these values: whether what it would return is
// well formed.
template <class Space, class Use>
constexpr bool answers(const Use&)
{
  return std::is_invocable_v<Use, const Space&, Vertex_index, Halfedge_index, Edge_index,
                             Face_index, const typename Space::Site&, const typename Space::Chart&,
                             const Position_2&, std::vector<Edge_index>&, const Any_function&>;
}

// Whether expressions with a space and these values are well formed.
#define CGAL_DYNAMIC_DELAUNAY_ANSWERS(...)                                                         \
  answers<Space>([]([[maybe_unused]] const auto& s, [[maybe_unused]] const auto& v,                \
                    [[maybe_unused]] const auto& h, [[maybe_unused]] const auto& e,                \
                    [[maybe_unused]] const auto& f, [[maybe_unused]] const auto& site,             \
                    [[maybe_unused]] const auto& chart, [[maybe_unused]] const auto& position,     \
                    [[maybe_unused]] auto& edges,                                                  \
                    [[maybe_unused]] const auto& function) -> decltype(__VA_ARGS__, void()) {})

// What a space has to say. Kernel and state are written once, over a space: what is different in it
// they ask by the types and functions below. The compiler names what a space lacks.
//
// Besides, a space is made from an `Argument`, which argument() returns. Its `Writer` writes
// arrays() and positions(), and what only this space keeps. `Editing<State>` keeps that in step
// with the arrays, and tells visitors by `Visitor_calls`; `Builder<State>` has rebuild(),
// build_with(), copy() and exchange(). Calls and files have classes of their own, as
// `Input_frame_2` and `Checkpoint_plane_2`; queries ask `Site_geometry_2`, by the type of sites.
//
// A *site* is a vertex as seen from a face, on a torus an image. A *chart* says how the face is
// seen from there. A plane with circles of its own needs less: traits with their predicates, and
// `has_euclidean_circles` (`anisotropic_plane.h` of the tests, 50 lines).
template <class Space>
constexpr bool is_space()
{
  using Site = typename Space::Site;
  using Chart = typename Space::Chart;
  using Predicates = typename Space::Predicates;
  using Edge_test = typename Space::Edge_test;

  // ARRAYS AND POINTS ----------------------------------------------------------------------------

  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<const Halfedge_arrays_2&>(s.arrays())),
                "arrays() are the half-edges");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<const Position_vector&>(s.positions()),
                                              as<bool>(s.positions_are_exact())),
                "positions() of the vertices are rounded; positions_are_exact(), whether signs "
                "may be concluded from them");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Vertex_index>(Space::first_vertex)),
                "first_vertex is the first one in the arrays: 0 where that is at infinity, or 1");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<const typename Space::Point&>(s.point(v)),
                                              as<bool>(s.is_at(s.point(v), v))),
                "point(v) is the user's; is_at(point, v) compares exactly");

  // VIEWS ----------------------------------------------------------------------------------------

  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Edge_2>(s.edge(e)), as<bool>(s.is_along(e, h)),
                                              as<bool>(s.is_shown_right(e))),
                "edge(e) has the four vertices of an edge; is_along(e, h), whether half-edge h "
                "has its direction; is_shown_right(e), whether the arrays show it as they have "
                "to");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<std::array<Vertex_index, 3>>(s.face(f)),
                                              as<std::array<Position_2, 3>>(s.face_corners(f))),
                "face(f) and face_corners(f) have the vertices of a face, and where these are");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Edge_corners_2>(s.corners(e)),
                                              as<Edge_corners_2>(s.corners(e, s.positions())),
                                              as<Position_2>(s.edge_vector(e))),
                "corners(e) and edge_vector(e) are rounded, as seen from the edge");
  static_assert(
      CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(s.is_at_infinity(e)), as<bool>(s.breaks_hull(e))),
      "is_at_infinity(e) and breaks_hull(e) tell the edges of the hull, or of a gap");
  static_assert(
      CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(s.is_infinite_face(f)), as<bool>(s.is_hull_edge(h))),
      "is_infinite_face(f) tells faces without orientation; is_hull_edge(h), edges on "
      "the hull or on a side of a slab");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(s.for_each_finite_neighbor(v, function)),
                "for_each_finite_neighbor(v, function) goes around a vertex counterclockwise");

  // SITES AND CHARTS ---------------------------------------------------------------------------

  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Site>(s.site_of(v)),
                                              as<Vertex_index>(s.vertex_of(site)),
                                              as<Site>(s.site_in(h, chart))),
                "site_of(v) is a vertex as seen from itself, site_in(h, chart) the apex of "
                "half-edge h as seen in a chart of its face; vertex_of(site) is the vertex");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Chart>(s.chart_at(h)),
                                              as<Chart>(s.chart_beyond(h, chart)),
                                              as<Chart>(s.chart_seen_from(v, h))),
                "chart_at(h) is how the apex of h sees the face of h, chart_beyond(h, chart) "
                "how the face beyond h is seen, chart_seen_from(v, h) how a vertex that may be "
                "far away sees the face");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(s.are_neighbors(site, site)),
                                              as<Position_2>(s.rounded_position(site))),
                "are_neighbors(a, b) tells whether an edge connects two sites, "
                "rounded_position(site) where one is");
  static_assert(
      CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<double>(s.rounded_squared_distance(v, v)),
                                    as<double>(s.rounded_squared_distance(position, position))),
      "rounded_squared_distance(), of vertices or positions, is that of the nearest "
      "images");

  // TIME -----------------------------------------------------------------------------------------

  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Position_2>(s.previous_position(v)),
                                              as<Position_2>(s.previous_position_at(v, position))),
                "previous_position(v) is where the vertex was one frame ago, "
                "previous_position_at(v, now) the same as seen from the image that is at now");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Position_2>(s.rest_position(v)),
                                              as<bool>(s.have_points_moved()),
                                              as<bool>(s.is_frame_at_rest())),
                "rest_position(v) is where the vertex was before its points moved, taken along "
                "with the cell: there all faces are counterclockwise; a frame is at rest if they "
                "are as before, and so is the cell");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Position_2>(s.position_in_order(position))),
                "position_in_order(position) is by what points are sorted along a curve");

  // PROOFS ---------------------------------------------------------------------------------------

  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(
                    as<Orientation>(Predicates(s).orientation(site, site, site)),
                    as<Oriented_side>(Predicates(s).side_of_circle(site, site, site, site)),
                    as<bool>(Predicates(s).coincide(site, site))),
                "Predicates have orientation(), side_of_circle() and coincide() of sites, "
                "exact");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<Edge_state_2>(Edge_test(s).state(e)),
                                              as<bool>(Edge_test(s).proves_delaunay(e)),
                                              Edge_test(s).append_unproved(0, 0, edges)),
                "Edge_test is the one test of an edge: state(e) is exact, proves_delaunay(e) a "
                "filter, append_unproved(first, beyond, edges) the pass over many");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(s.covers_space())),
                "covers_space() is what must be true of all faces together");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(s.is_structure_valid(true, 0)),
                                              as<bool>(s.is_right_on_line())),
                "is_structure_valid(verbose, level) checks what is stored besides the arrays, "
                "is_right_on_line() the triangulation while it has no faces");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(Space::Slacks::has_hull)),
                "Slacks are the bounds by which edges are skipped");

  // WHAT TOOLS MAY DO ----------------------------------------------------------------------------

  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(Space::has_hull),
                                              as<bool>(Space::can_splice),
                                              as<bool>(Space::can_locate_anywhere)),
                "has_hull, can_splice (a region can be triangulated separately) and "
                "can_locate_anywhere (not only where all is Delaunay) say which tools there are");
  static_assert(
      CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<bool>(s.has_gap()), as<bool>(s.flips_across_gap(e))),
      "has_gap() and flips_across_gap(e) tell edges that only `certify()` flips");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(
                    as<bool>(s.spans_plane()), as<std::size_t>(Space::min_vertices),
                    as<std::size_t>(s.rebuilt_vertices()), as<Index>(s.number_of_vertices())),
                "spans_plane(), min_vertices and rebuilt_vertices() say when a rebuild is "
                "necessary, and what it costs");
  static_assert(CGAL_DYNAMIC_DELAUNAY_ANSWERS(as<std::size_t>(Space::max_degree_to_divide)),
                "max_degree_to_divide bounds the neighbors of a vertex whose star is triangulated "
                "at once");

  return true;
}

#undef CGAL_DYNAMIC_DELAUNAY_ANSWERS

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_SPACE_CHECK_2_H
