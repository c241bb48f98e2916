// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_PERIODIC_RUN_H
#define PERIODIC_PERIODIC_RUN_H

#include "../common/Contest.h"
#include "../common/Fastest_static.h"
#include "Ghost_rebuild.h"
#include "Wrapped_motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace periodic {

enum Contestant : std::size_t { PERIODIC, PLANE, GHOSTS, CGAL_PERIODIC };
constexpr std::size_t contestants = 4;

// Nanoseconds a point; of CGAL's periodic triangulation in some frames only.
struct Frame_figures
{
  std::size_t frame = 0; // the first one is 0 and not timed
  std::array<std::optional<double>, contestants> times{};
  std::size_t copies = 0; // points and ghosts
  CGAL::Update_report_2 report{};
};

struct Periodic_case
{
  std::size_t points;
  double step; // the standard deviation of a coordinate, in spacings
  std::uint64_t seed;
  std::size_t warm_up; // frames before the first one that counts
  std::size_t frames;
  std::size_t cgal_frames; // of these
};

// Lets all contestants follow the frames of a case, in turn, and checks what comes out.
class Periodic_run
{
public:
  explicit Periodic_run(const Periodic_case& wanted)
    : m_case(wanted)
    , m_motion(wanted.points, wanted.step, wanted.seed)
    , m_periodic(m_motion.wrapped(), CGAL::Periodic_cell_2(m_motion.side(), m_motion.side()))
    , m_plane(m_motion.unwrapped().begin(), m_motion.unwrapped().end())
  {
    m_ghosts.follow(m_motion, largest_empty_circle(m_periodic));
  }

  // `report(frame)` is called after each frame.
  // \throws std::runtime_error if anything is wrong.
  template <class Report>
  std::vector<Frame_figures> run(const Report& report)
  {
    std::vector<Frame_figures> all;
    for (std::size_t frame = 1; frame <= m_case.warm_up + m_case.frames; ++frame) {
      m_figures = {};
      m_figures.frame = frame;
      time_all();
      if (frame > m_case.warm_up) {
        all.push_back(m_figures);
      }
      report(frame);
    }
    check_thoroughly();
    return all;
  }

private:
  using Plane = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>;
  using Cgal_periodic = CGAL::Periodic_2_Delaunay_triangulation_2<
      CGAL::Periodic_2_Delaunay_triangulation_traits_2<run::Kernel>>;

  void time_all()
  {
    const double radius = largest_empty_circle(m_periodic);
    m_motion.advance();
    m_ghosts.prepare(m_motion, radius);
    m_figures.copies = m_ghosts.number_of_points();
    m_cgal.reset();
    const std::size_t number = has_cgal() ? contestants : contestants - 1;
    common::in_turn(m_figures.frame, number, [this](std::size_t contestant) {
      m_figures.times[contestant] = time(contestant) / static_cast<double>(m_case.points);
    });
    check();
  }

  // True in one of `stride` frames, from the first one that counts on.
  bool has_cgal() const
  {
    if (m_figures.frame <= m_case.warm_up || m_case.cgal_frames == 0) {
      return false;
    }
    const std::size_t stride = (m_case.frames + m_case.cgal_frames - 1) / m_case.cgal_frames;
    return (m_figures.frame - m_case.warm_up - 1) % stride == 0;
  }

  double time(std::size_t contestant)
  {
    switch (contestant) {
    case PERIODIC:
      return common::thread_nanoseconds_of(
          [this] { m_figures.report = m_periodic.update(m_motion.wrapped()); });
    case PLANE:
      return common::thread_nanoseconds_of(
          [this] { m_plane.update(m_motion.unwrapped().begin(), m_motion.unwrapped().end()); });
    case GHOSTS:
      return m_ghosts.time();
    default:
      return common::thread_nanoseconds_of([this] {
        m_cgal.emplace(Cgal_periodic::Iso_rectangle(0.0, 0.0, m_motion.side(), m_motion.side()))
            .insert(m_motion.wrapped().begin(), m_motion.wrapped().end(), true);
      });
    }
  }

  void check() const
  {
    require(m_figures.report.certified && m_periodic.is_certified(),
            "the periodic triangulation is not certified");
    require(m_plane.is_certified(), "the plane's triangulation is not certified");
    require(!m_cgal || m_cgal->number_of_vertices() == m_case.points,
            "CGAL's periodic triangulation has lost points");
  }

  void check_thoroughly() const
  {
    std::size_t edges = 0;
    m_periodic.for_each_edge(
        [&](std::size_t, std::size_t, const CGAL::Periodic_shift_2&) { ++edges; });
    require(edges == 3 * m_case.points, "the periodic triangulation has " + std::to_string(edges) +
                                            " edges instead of three for each point");
    require(m_periodic.is_valid(), "the periodic triangulation is not valid");
    require(m_ghosts.number_of_faces() == 2 * m_case.points,
            "the triangulation with ghosts does not have two faces for each point in the square");
  }

  void require(bool is_right, const std::string& what) const
  {
    common::require(is_right, common::in_frame(m_figures.frame) + what);
  }

  Periodic_case m_case;
  Wrapped_motion m_motion;
  Dynamic_periodic m_periodic;
  Plane m_plane;
  Ghost_rebuild m_ghosts;
  std::optional<Cgal_periodic> m_cgal;
  Frame_figures m_figures;
};

} // namespace periodic

#endif // PERIODIC_PERIODIC_RUN_H
