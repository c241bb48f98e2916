// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the largest time step at which particle scenarios stay stable, by bisection.
//
// A time step is stable when, over all frames of the scenario file with its own number of points
// and its own seed, neighbors taken from a fresh Delaunay triangulation of every frame,
//  - every coordinate stays finite, and no center of a particle passes a wall;
//  - the total energy, averaged over windows of 20 frames, never rises above its lowest value so
//    far by more than a twentieth of its first value: springs and dampers may only store and take
//    energy;
//  - no bond that cannot break is ever strained by a tenth: hard bodies hold together;
//  - the kinetic energy of the last 100 frames is at most twice that at the end of a run with half
//    the time step and twice the frames, give or take a ten-thousandth of the first energy: points
//    that should be at rest do not boil.
// Near its bound stability is a matter of chance, so the printed value, in sqrt(mass / stiffness)
// and rounded down to hundredths, is the largest one below which the bisection met no unstable one.

#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <variant>

namespace {

using namespace scenario;

bool all_finite(const std::vector<Point>& points)
{
  return std::all_of(points.begin(), points.end(), [](const Point& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
  });
}

bool bodies_hold(const Particle_description& particles, const Particle_system& system)
{
  const bool may_break =
      std::any_of(particles.bodies.begin(), particles.bodies.end(),
                  [](const Body_description& body) { return body.strain_limit.has_value(); });
  return may_break || system.largest_strain() < 0.1;
}

class Energy_watch
{
public:
  // False once the energy has risen.
  bool accepts(double energy)
  {
    m_sum += energy;
    if (++m_number != window) {
      return std::isfinite(energy);
    }
    const double mean = m_sum / window;
    m_sum = 0.0;
    m_number = 0;
    if (!m_first) {
      m_first = mean;
      m_lowest = mean;
    }
    m_lowest = (std::min)(m_lowest, mean);
    return mean <= m_lowest + 0.05 * *m_first;
  }

  double first() const { return m_first.value_or(0.0); }

private:
  static constexpr int window = 20;
  int m_number = 0;
  double m_sum = 0.0;
  double m_lowest = 0.0;
  std::optional<double> m_first;
};

struct Outcome
{
  double first_energy;
  double last_kinetic_energy;
};

// Nothing when the run is not stable in itself.
std::optional<Outcome> run(const Scenario_description& description, double time_step,
                           std::size_t frames)
{
  constexpr std::size_t last_frames = 100;
  const auto& particles = std::get<Particle_description>(description.kind);
  Overrides overrides;
  overrides.time_step = time_step;
  const auto motion = make_motion(description, particles, overrides);
  Static_neighbors neighbors;
  Energy_watch watch;
  double last_kinetic_energy = 0.0;
  for (std::size_t frame = 0; frame != frames; ++frame) {
    const Neighbor_edges& edges = neighbors(motion->points());
    const Energy energy = motion->energy(edges);
    if (frame + last_frames >= frames) {
      last_kinetic_energy += energy.kinetic / last_frames;
    }
    motion->advance(edges);
    if (!watch.accepts(energy.total()) || !all_finite(motion->points()) ||
        motion->system().number_put_back() != 0 || !bodies_hold(particles, motion->system())) {
      return std::nullopt;
    }
  }
  return Outcome{watch.first(), last_kinetic_energy};
}

bool is_stable(const Scenario_description& description, double time_step)
{
  const auto outcome = run(description, time_step, description.frames);
  if (!outcome) {
    return false;
  }
  const auto finer = run(description, 0.5 * time_step, 2 * description.frames);
  return finer && outcome->last_kinetic_energy <=
                      2.0 * finer->last_kinetic_energy + 1e-4 * outcome->first_energy;
}

double largest_stable_time_step(const Scenario_description& description)
{
  int stable = 0;
  int unstable = 200;
  while (unstable - stable > 1) {
    const int middle = (stable + unstable) / 2;
    (is_stable(description, 0.01 * middle) ? stable : unstable) = middle;
  }
  return 0.01 * stable;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s SCENARIO.json...\n", argv[0]);
    return 2;
  }
  try {
    for (int i = 1; i != argc; ++i) {
      const Scenario_description description = read_scenario_file(argv[i]);
      if (!std::holds_alternative<Particle_description>(description.kind)) {
        std::printf("%-24s any\n", description.name.c_str());
        continue;
      }
      std::printf("%-24s %.2f\n", description.name.c_str(), largest_stable_time_step(description));
      std::fflush(stdout);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
