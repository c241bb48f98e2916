// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tracks from a file: in each frame some people are there, others have come or gone. The population
// inserts, removes, and moves them.
//
// recorded_tracks [FILE.csv], with the columns frame,time,id,x,y and the rows of a frame in
// sequence

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using People = std::vector<std::pair<std::int64_t, Point>>;

struct Frame
{
  std::int64_t number;
  double time;
  People people;
};

std::vector<Frame> read_frames(const std::string& file)
{
  std::ifstream stream(file);
  std::string line;
  if (!std::getline(stream, line) || line != "frame,time,id,x,y")
    throw std::runtime_error(file + ": expected the header frame,time,id,x,y");
  std::vector<Frame> frames;
  for (int number = 2; std::getline(stream, line); ++number) {
    std::istringstream row(line);
    std::int64_t frame, id;
    double time, x, y;
    char comma;
    if (!(row >> frame >> comma >> time >> comma >> id >> comma >> x >> comma >> y))
      throw std::runtime_error(file + ", line " + std::to_string(number) +
                               ": expected five numbers");
    if (frames.empty() || frames.back().number != frame)
      frames.push_back({frame, time, {}});
    frames.back().people.emplace_back(id, Point(x, y));
  }
  return frames;
}

// The least distance of any two points: the nearest ones are neighbors in the triangulation.
double least_distance(const Dynamic& dt)
{
  double least = std::numeric_limits<double>::infinity();
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    least = (std::min)(least, std::sqrt(CGAL::squared_distance(dt.point(i), dt.point(j))));
  });
  return least;
}

bool follow(const std::vector<Frame>& frames)
{
  CGAL::Dynamic_population_2<Dynamic> population;
  std::size_t came = 0, went = 0;
  double least = std::numeric_limits<double>::infinity();
  bool all_right = true;
  for (const Frame& frame : frames) {
    const People& people = frame.people;
    const auto report = population.update(people.begin(), people.end());
    came += report.inserted;
    went += report.removed;
    all_right = all_right && report.certified && population.size() == people.size();
    least = (std::min)(least, least_distance(population.triangulation()));
    if (report.inserted + report.removed > 0)
      std::cout << "time " << frame.time << ": " << people.size() << " there, " << report.inserted
                << " came, " << report.removed << " went\n";
  }
  std::cout << frames.size() << " frames, " << came << " came, " << went << " went, "
            << (all_right ? "all" : "not all") << " frames certified; the nearest two were "
            << least << " apart\n";
  return all_right && came - went == population.size();
}

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : "data/corridor.csv";
  try {
    return follow(read_frames(file)) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n'; // says the line, and what is wrong with it
    return 1;
  }
}
