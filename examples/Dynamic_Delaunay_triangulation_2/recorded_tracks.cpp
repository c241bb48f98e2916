// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Tracks from a file: in each frame some people are there, others have come or gone. The population
// inserts, removes, and moves them.
//
// recorded_tracks [FILE.csv], whose first line names the columns: frame,time,id,x,y

#include "scenario/Csv_motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using People = std::vector<std::pair<std::int64_t, Point>>;

People people_of(const scenario::Recorded_frame& frame)
{
  People people;
  for (std::size_t i = 0; i < frame.ids.size(); ++i)
    people.emplace_back(frame.ids[i], Point(frame.points[i].x, frame.points[i].y));
  return people;
}

// Of any two: the nearest ones are neighbors in the triangulation.
double least_distance(const Dynamic& dt)
{
  double least = std::numeric_limits<double>::infinity();
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    least = (std::min)(least, std::sqrt(CGAL::squared_distance(dt.point(i), dt.point(j))));
  });
  return least;
}

bool follow(const scenario::Recording& recording)
{
  CGAL::Dynamic_population_2<Dynamic> population;
  std::size_t came = 0, went = 0;
  double least = std::numeric_limits<double>::infinity();
  bool all_right = true;
  for (const scenario::Recorded_frame& frame : recording) {
    const People people = people_of(frame);
    const auto report = population.update(people.begin(), people.end());
    came += report.inserted;
    went += report.removed;
    all_right = all_right && report.certified && population.size() == people.size();
    least = (std::min)(least, least_distance(population.triangulation()));
    if (report.inserted + report.removed > 0)
      std::cout << "time " << frame.time << ": " << people.size() << " there, " << report.inserted
                << " came, " << report.removed << " went\n";
  }
  std::cout << recording.size() << " frames, " << came << " came, " << went << " went, "
            << (all_right ? "all" : "not all") << " frames certified; the nearest two were "
            << least << " apart\n";
  return all_right && came - went == population.size();
}

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : "data/corridor.csv";
  try {
    return follow(scenario::read_csv_motion(file)) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n'; // says the line, and what is wrong with it
    return 1;
  }
}
