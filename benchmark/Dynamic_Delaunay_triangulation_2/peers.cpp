// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares this package with other programs that triangulate, on the same frames of the same
// motions, in one run and in turn, the order rotating. The peers, and what of each is timed and
// why, are described in peers/..._peer.h; what is common to all in peers/Peer.h. All points are on
// a grid of integers, see peers/Grid_motion.h.
//
// Columns of the table:
//   ns/point, q1, q3   median over the frames, and quartiles
//   to ours      that median over this package's exact one: above 1 we win, below 1 we lose
//   win, even, loss   of this package's exact update; even if the quartiles overlap
//   equal        frames whose edges are those of the Delaunay triangulation, and whose number of
//                faces is right, by exact predicates, ties counting as equal
//   validity     mean of the Matthews correlation coefficient of the edges
//
// CGAL and this package promise to be exact: a difference in one of their results ends the program
// with an error. Differences of all others are counted.

#include "common/Program.h"
#include "peers/Delaunator_peer.h"
#include "peers/Peer_cases.h"
#include "peers/Peers_output.h"
#include "peers/Peers_run.h"
#include "peers/Qhull_peer.h"
#include "scenario_runner/Progress.h"

#include <CGAL/version.h>

#include <boost/version.hpp>
#include <CLI/CLI.hpp>

#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace peers;

void add_options(CLI::App& app, Peers_options& options)
{
  constexpr int fewest_points = 10, most_points = 10'000'000, most_frames = 100'000;
  app.description("Times this package and its peers on the same frames, in turn, and compares what "
                  "comes out.");
  common::add_option(app, "--points", options.chosen_points, "N...",
                     "how many; default 1000 10000 100000", CLI::Range(fewest_points, most_points));
  common::add_option(app, "--frames", options.frames, "N",
                     "timed ones of each motion; default 96 to 4", CLI::Range(1, most_frames));
  common::add_option(app, "--filter", options.filter, "TEXT",
                     "only motions with this in 'motion/points'");
  common::add_option(app, "--output", options.output, "DIR",
                     "where peers.csv goes; default build/dev/bench/peers");
  app.add_flag("--large", options.is_large, "a million points, too");
  app.add_flag("--quick", options.is_quick, "a first look, in less than a minute");
}

// None if Node.js or the package is missing.
std::shared_ptr<Delaunator_peer> find_delaunator()
{
  try {
    return std::make_shared<Delaunator_peer>();
  } catch (const std::runtime_error& error) {
    std::cerr << "No delaunator, as Node.js or the package is missing: " << error.what() << '\n';
    return nullptr;
  }
}

std::string versions(const Delaunator_peer* delaunator)
{
  const int boost = BOOST_VERSION;
  return std::string("CGAL ") + CGAL_STR(CGAL_VERSION) + "; Boost " +
         std::to_string(boost / 100'000) + '.' + std::to_string(boost / 100 % 1'000) + "; Qhull " +
         qh_version + "; " + (delaunator ? delaunator->versions() : "no delaunator");
}

std::vector<Case_record> run_cases(const std::vector<Peer_case>& cases,
                                   const std::shared_ptr<Delaunator_peer>& delaunator)
{
  constexpr std::size_t unit = 1000;
  std::size_t work = 0;
  for (const Peer_case& wanted : cases) {
    work += wanted.work();
  }
  run::Progress_display progress(work / unit, true, "thousand points");
  Peers_run run(delaunator, [&](std::size_t done) { progress.show(done / unit); });
  std::vector<Case_record> records;
  for (const Peer_case& wanted : cases) {
    try {
      records.push_back(run.run(wanted));
    } catch (const std::exception& error) {
      throw std::runtime_error(wanted.name() + ": " + error.what());
    }
  }
  return records;
}

bool run_peers(const Peers_options& options, const std::string& command)
{
  const std::vector<Peer_case> cases = peer_cases(options);
  if (cases.empty()) {
    throw std::runtime_error("there is no motion with '" + options.filter + "' in its name");
  }
  std::filesystem::create_directories(options.output);
  const auto delaunator = find_delaunator();
  const std::vector<Case_record> records = run_cases(cases, delaunator);
  write_tables(std::cout, records);
  const std::string path = (std::filesystem::path(options.output) / "peers.csv").string();
  write_csv(path, {"command: " + command, "versions: " + versions(delaunator.get())}, records);
  std::cout << '\n' << versions(delaunator.get()) << '\n' << command << std::endl;
  std::cerr << "CSV: " << path << '\n';
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Peers_options>("peers", argc, argv, add_options, run_peers);
}
