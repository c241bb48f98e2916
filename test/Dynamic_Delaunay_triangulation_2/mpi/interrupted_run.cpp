// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: points fly about in a box, with a checkpoint every ten frames.
//
// Arguments are a file and one of
//
//   kill           in frame 40 the last rank kills itself, while others write
//   throw          in frame 45 the last rank throws
//   resume FRAME   continues from the file, and compares with an undisturbed run

#include "distributed_oracle.h"
#include "distributed_theme.h"

#include <csignal>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>

namespace interrupted_run {

struct State // of a point, but for its position
{
  double vx, vy;
  std::int64_t frame;
};

constexpr int last_frame = 60;
constexpr double box_side = 20;

void step(Point& p, State& state)
{
  if (p.x() < 0 || p.x() > box_side)
    state.vx = p.x() < 0 ? std::abs(state.vx) : -std::abs(state.vx);
  if (p.y() < 0 || p.y() > box_side)
    state.vy = p.y() < 0 ? std::abs(state.vy) : -std::abs(state.vy);
  p = Point(p.x() + state.vx, p.y() + state.vy);
  ++state.frame;
}

// All points at the start, the same on all ranks.
std::map<Id, State> start_of_run(Population& population)
{
  std::mt19937 random(29);
  std::uniform_real_distribution<double> coordinate(0, box_side), speed(-0.3, 0.3);
  std::map<Id, State> states;
  for (Id id = 0; id < 500; ++id) {
    population[id] = Point(coordinate(random), coordinate(random));
    states[id] = {speed(random), speed(random), 0};
  }
  return states;
}

void update(Distributed& dt, std::vector<State>& states)
{
  Points next = dt.owned_points();
  for (std::size_t k = 0; k < next.size(); ++k)
    step(next[k], states[k]);
  const auto distributions = dt.number_of_distributions();
  dt.update(next.begin(), next.end());
  if (dt.number_of_distributions() != distributions)
    states = dt.carry(states);
}

void run_until_interrupted(const std::string& file, const std::string& end)
{
  Population population;
  const std::map<Id, State> all = start_of_run(population);
  const auto own = own_part(population, in_turn);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  std::vector<State> states;
  for (const Id id : dt.owned_ids())
    states.push_back(all.at(id));
  for (int frame = 1; frame <= last_frame; ++frame) {
    update(dt, states);
    const bool is_last_rank = this_rank == number_of_ranks - 1;
    if (is_last_rank && end == "kill" && frame == 40)
      std::raise(SIGKILL);
    if (is_last_rank && end == "throw" && frame == 45)
      throw std::runtime_error("the last rank has had enough");
    if (frame % 10 == 0)
      dt.write_checkpoint(file, states);
  }
}

void resume(const std::string& file, int expected_frame)
{
  const std::vector<std::pair<Id, Point>> none;
  Distributed dt(MPI_COMM_WORLD, none.begin(), none.end());
  std::vector<State> states;
  dt.read_checkpoint(file, states);
  for (const State& state : states)
    expect(state.frame == expected_frame, "the last complete checkpoint is read");
  Population population;
  std::map<Id, State> undisturbed = start_of_run(population);
  for (int frame = 1; frame <= last_frame; ++frame) {
    for (auto& [id, p] : population)
      step(p, undisturbed[id]);
    if (frame <= expected_frame)
      continue;
    update(dt, states);
    expect(own_positions(dt, population) == dt.owned_points(),
           "positions are those of an undisturbed run");
    expect_exact(dt, population, "the run that continues");
  }
}

void run_theme()
{
  const std::string file = theme_arguments.at(0), mode = theme_arguments.at(1);
  if (mode == "resume")
    resume(file, std::stoi(theme_arguments.at(2)));
  else
    run_until_interrupted(file, mode);
}

const Theme theme("interrupted_run", run_theme);

} // namespace interrupted_run
