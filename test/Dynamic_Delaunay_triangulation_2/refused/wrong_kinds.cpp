// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Not one of the assertions below must hold: an index of one kind is none of another, and a number
// is no index unless a program says so.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Frame = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>::Frame;
using Edge = Frame::Edge_index;
using Vertex = Frame::Vertex_index;
using Column = CGAL::Dynamic_Delaunay_triangulations_2::internal::Column<Vertex, double>;

template <class A, class B, class = void>
constexpr bool are_comparable = false;
template <class A, class B>
constexpr bool are_comparable<A, B, std::void_t<decltype(std::declval<A>() == std::declval<B>())>> =
    true;

template <class Index, class = void>
constexpr bool has_entry = false;
template <class Index>
constexpr bool has_entry<Index, std::void_t<decltype(std::declval<Column>()[Index()])>> = true;

static_assert(are_comparable<Edge, Edge> && are_comparable<Edge, unsigned> && has_entry<Vertex> &&
              std::is_constructible_v<Vertex, int> && std::is_convertible_v<Vertex, std::size_t>);

static_assert(std::is_convertible_v<int, Vertex>, "a number becomes no vertex by itself");
static_assert(std::is_convertible_v<Edge, Vertex>, "an edge is no vertex");
static_assert(std::is_constructible_v<Vertex, Edge>, "nor does it become one");
static_assert(std::is_assignable_v<Vertex&, unsigned>, "no number is assigned to a vertex");
static_assert(std::is_convertible_v<std::vector<Edge>, std::vector<Vertex>>, "nor are lists alike");
static_assert(are_comparable<Edge, Vertex>, "an edge equals no vertex");
static_assert(has_entry<Edge>, "an edge has no entry in a column of vertices");
static_assert(has_entry<int>, "nor has a number");
static_assert(std::is_invocable_v<decltype(&Frame::id), Frame, Edge>, "an edge has no id");
