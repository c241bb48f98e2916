// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cells of a tissue crawl and push each other: the self-propelled Voronoi model of Bi, Yang,
// Marchetti and Manning (Physical Review X 6, 021011, 2016). If cells prefer a perimeter p0 below
// 3.8 or so, they are caged by their neighbors, and the tissue is rigid; above, they flow. The
// forces are gradients of the cells' areas and perimeters.
//
// voronoi_tissue [CELLS [TIME [P0...]]]

#include "voronoi_tissue/Observation.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <vector>

namespace {

// The number in a text; 0 if it is none from `low` to `high`.
double number(const char* text, double low, double high)
{
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  return *end == 0 && value >= low && value <= high ? value : 0;
}

void write_row(const tissue::Parameters& parameters, const tissue::Observation& seen)
{
  std::cout << std::fixed << std::setprecision(2) << std::setw(5) << parameters.target_shape
            << std::setprecision(4);
  for (const std::size_t quarter : {1u, 2u, 4u})
    std::cout << std::setw(9) << seen.samples[seen.samples.size() * quarter / 4 - 1].mean_square;
  std::cout << std::setw(13) << seen.samples.back().cage_relative_mean_square << std::setw(9)
            << seen.effective_diffusivity(parameters) << std::setw(9)
            << seen.samples.back().self_overlap << std::setw(9) << seen.exchange_rate
            << std::setw(8) << seen.shape_index << std::endl;
}

void write_head()
{
  std::cout << "        mean squared displacement  relative            share\n"
               "   p0      T/4      T/2        T      to cage    D_eff  staying  T1 rate   shape\n";
}

std::vector<double> shapes_of(int argc, char** argv)
{
  if (argc <= 3)
    return {3.5, 3.95};
  std::vector<double> shapes;
  for (int i = 3; i < argc; ++i)
    shapes.push_back(number(argv[i], 3, 5));
  return shapes;
}

} // namespace

int main(int argc, char** argv)
{
  tissue::Parameters parameters;
  parameters.cells = argc > 1 ? std::size_t(number(argv[1], 10, 1e6)) : 100;
  const double time = argc > 2 ? number(argv[2], 1, 1e6) : 40;
  const std::vector<double> shapes = shapes_of(argc, argv);
  if (parameters.cells == 0 || time == 0 || *std::min_element(shapes.begin(), shapes.end()) == 0) {
    std::cerr << "voronoi_tissue [CELLS [TIME [P0...]]]: 10 to 1000000 cells, a time from 1 to "
                 "1000000, and shapes from 3 to 5\n";
    return 1;
  }

  write_head();
  std::vector<double> displacements;
  bool is_certified = true;
  for (const double shape : shapes) {
    parameters.target_shape = shape;
    const tissue::Observation seen = tissue::observe(parameters, time / 2, time, [] {});
    write_row(parameters, seen);
    displacements.push_back(seen.samples.back().mean_square);
    is_certified = is_certified && seen.is_certified;
  }
  const bool flows = displacements.back() > 5 * displacements.front();
  return is_certified && (flows || argc > 1) ? 0 : 1;
}
