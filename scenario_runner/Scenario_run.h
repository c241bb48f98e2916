// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SCENARIO_RUN_H
#define SCENARIO_RUNNER_SCENARIO_RUN_H

#include "scenario_runner/Motion_run.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Static_triangulation.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace run {

// The plane, where nothing is periodic.
struct Open_space
{
  using Opponents = Static_opponents;

  static std::tuple<> cell(const scenario::Motion&) { return {}; }

  static void prepare(Opponents& opponents, const scenario::Motion& motion, bool population_changed)
  {
    opponents.prepare(motion.points(), population_changed);
  }
};

template <class Dynamic>
using Kept_triangulation = Kept_motion<Dynamic, Open_space>;

template <class Classifier>
using Open_dynamic =
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier, CGAL::With_repair_2<Any_repair>,
                                           CGAL::With_policy_2<Any_policy>,
                                           CGAL::With_concurrency_2<Concurrency_tag>>;

// The run of a motion in the plane.
template <class Classifier>
class Scenario_run : public Motion_run<Open_dynamic<Classifier>, Open_space>
{
  using Base = Motion_run<Open_dynamic<Classifier>, Open_space>;

public:
  using Base::motion;
  using Base::triangulation;
  using typename Base::Dynamic;

  using Base::Base;

  std::vector<Shown_edge> edges() const override
  {
    const std::vector<std::uint32_t> places = places_of_vertices();
    const auto frame = triangulation().frame();
    const bool is_on_line = frame.number_of_edges() == 0; // where every edge is Delaunay
    Edge_index e(0);
    std::vector<Shown_edge> edges;
    triangulation().for_each_edge([&](std::size_t i, std::size_t j) {
      while (!is_on_line && Frame::is_infinite(frame.edge(e))) {
        ++e;
      }
      edges.push_back({places[frame.vertex(i)], places[frame.vertex(j)],
                       is_on_line || frame.is_delaunay(e++)});
    });
    return edges;
  }

  std::vector<Shown_triangle> triangles() const override
  {
    const std::vector<std::uint32_t> places = places_of_vertices();
    const auto frame = triangulation().frame();
    const std::vector<bool> are_delaunay = are_faces_delaunay(frame);
    std::vector<Shown_triangle> triangles;
    for (Face_index f(0); f != frame.number_of_faces(); ++f) {
      const auto [a, b, c] = frame.face(f);
      if (!Frame::is_infinite(a) && !Frame::is_infinite(b) && !Frame::is_infinite(c)) {
        triangles.push_back({{places[a], places[b], places[c]}, are_delaunay[f]});
      }
    }
    return triangles;
  }

private:
  using Frame = typename Dynamic::Frame;
  using Edge_index = typename Frame::Edge_index;
  using Face_index = typename Frame::Face_index;

  double agreement() override
  {
    return CGAL::delaunay_agreement(triangulation(), Base::opponents().reference())
        .matthews_correlation_coefficient();
  }

  // The place of each vertex: that of the first of the points that coincide there.
  std::vector<std::uint32_t> places_of_vertices() const
  {
    std::vector<std::uint32_t> places(triangulation().number_of_vertices() + 1);
    for (std::size_t place = motion().points().size(); place-- != 0;) {
      places[Base::vertex(place)] = static_cast<std::uint32_t>(place);
    }
    return places;
  }
};

} // namespace run

#endif // SCENARIO_RUNNER_SCENARIO_RUN_H
