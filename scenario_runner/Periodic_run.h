// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PERIODIC_RUN_H
#define SCENARIO_RUNNER_PERIODIC_RUN_H

#include "scenario_runner/Ghost_opponents.h"
#include "scenario_runner/Motion_run.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace run {

// The torus or the slab that the motion's cell makes.
struct Periodic_space
{
  using Opponents = Ghost_opponents;

  static std::tuple<CGAL::Periodic_cell_2> cell(const scenario::Motion& motion)
  {
    const scenario::Cell cell = *motion.cell();
    if (cell.is_slab()) {
      return CGAL::Periodic_cell_2(Kernel::Vector_2(cell.period().x, cell.period().y));
    }
    const auto& [a, b] = cell.sides;
    return CGAL::Periodic_cell_2(a.x, a.y, b.x, b.y);
  }

  static void prepare(Opponents& opponents, const scenario::Motion& motion, bool)
  {
    opponents.prepare(motion.points(), *motion.cell());
  }
};

template <class Classifier>
using Dynamic_periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<
    Kernel, Classifier, CGAL::With_repair_2<Any_repair>, CGAL::With_policy_2<Any_policy>,
    CGAL::With_concurrency_2<Concurrency_tag>>;

// The run of a motion that has a cell.
template <class Classifier>
class Periodic_run : public Motion_run<Dynamic_periodic<Classifier>, Periodic_space>
{
  using Base = Motion_run<Dynamic_periodic<Classifier>, Periodic_space>;

public:
  using Base::kept;
  using Base::motion;
  using Base::triangulation;
  using typename Base::Dynamic;

  using Base::Base;

  std::vector<Shown_edge> edges() const override
  {
    const std::vector<std::uint32_t> places = places_of_ids();
    const auto frame = triangulation().frame();
    typename Dynamic::Frame::Edge_index e(0);
    std::vector<Shown_edge> edges;
    triangulation().for_each_edge(
        [&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
          while (std::isnan(frame.edge_vector(e).x)) { // across the gap of a slab
            ++e;
          }
          edges.push_back({places[i], places[j], frame.is_delaunay(e++), along_sides(shift)});
        });
    return edges;
  }

  std::vector<Shown_triangle> triangles() const override
  {
    const auto frame = triangulation().frame();
    const std::vector<bool> are_delaunay = are_faces_delaunay(frame);
    typename Dynamic::Frame::Face_index f(0);
    std::vector<Shown_triangle> triangles;
    for (const Periodic_face& face : faces()) {
      while (is_in_gap(frame.face_corners(f))) {
        ++f;
      }
      const auto& [a, b, c] = face.places;
      triangles.push_back({{a, b, c}, are_delaunay[f++], face.shifts});
    }
    return triangles;
  }

private:
  template <class Corners>
  static bool is_in_gap(const Corners& corners)
  {
    return std::isnan(corners[1].x) || std::isnan(corners[2].x);
  }

  double agreement() override
  {
    const std::vector<std::uint32_t> places = places_of_ids();
    std::vector<std::uint32_t> representatives;
    for (std::size_t place = 0; place != motion().points().size(); ++place) {
      representatives.push_back(places[triangulation().representative(kept().id(motion(), place))]);
    }
    return Base::opponents().agreement(faces(), representatives);
  }

  std::vector<Periodic_face> faces() const
  {
    const std::vector<std::uint32_t> places = places_of_ids();
    std::vector<Periodic_face> faces;
    triangulation().for_each_face([&](const std::array<std::size_t, 3>& ids,
                                      const std::array<CGAL::Periodic_shift_2, 3>& shifts) {
      Periodic_face face{};
      for (std::size_t i = 0; i != 3; ++i) {
        face.places[i] = places[ids[i]];
        face.shifts[i] = along_sides(shifts[i]);
      }
      faces.push_back(face);
    });
    return faces;
  }

  std::vector<std::uint32_t> places_of_ids() const
  {
    std::vector<std::uint32_t> places(triangulation().number_of_ids());
    for (std::size_t place = 0; place != motion().points().size(); ++place) {
      places[kept().id(motion(), place)] = static_cast<std::uint32_t>(place);
    }
    return places;
  }

  // Converts a shift of the triangulation, to which the only vector of a slab is the first one.
  scenario::Shift along_sides(const CGAL::Periodic_shift_2& shift) const
  {
    const scenario::Cell cell = *motion().cell();
    return cell.is_slab() && !cell.is_periodic[0] ? scenario::Shift{0, shift[0]}
                                                  : scenario::Shift{shift[0], shift[1]};
  }
};

} // namespace run

#endif // SCENARIO_RUNNER_PERIODIC_RUN_H
