// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A tissue: cells grow, push and pull their neighbors, divide in two when they are large enough,
// and some die. Neighbors are those of the Delaunay triangulation that are not too far away. This
// file knows nothing of CGAL, and compiles in a second: Cell_neighbors has it in a file of its own.

#include "growing_tissue/Cell_neighbors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

namespace {

// The cells, by their ids. The radius of a removed cell is 0.
struct Tissue
{
  std::vector<double> x, y, radius;
  Cell_neighbors neighbors;

  void add(double at_x, double at_y, double its_radius)
  {
    const std::size_t id = neighbors.insert(at_x, at_y);
    const std::size_t size = (std::max)(id + 1, x.size());
    x.resize(size);
    y.resize(size);
    radius.resize(size);
    x[id] = at_x;
    y[id] = at_y;
    radius[id] = its_radius;
  }

  void remove(std::size_t id)
  {
    neighbors.remove(id);
    radius[id] = 0;
  }
};

// Each pair is a spring that is at rest where the two cells touch; cells do not coast.
void relax(Tissue& tissue)
{
  constexpr double reach = 1.3, step = 0.1;
  std::vector<double> x = tissue.x, y = tissue.y;
  for (const auto& [i, j] : tissue.neighbors.pairs()) {
    const double dx = tissue.x[j] - tissue.x[i], dy = tissue.y[j] - tissue.y[i];
    const double distance = std::hypot(dx, dy), rest = tissue.radius[i] + tissue.radius[j];
    if (distance > reach * rest)
      continue;
    const double pull = step * (distance - rest) / distance;
    x[i] += pull * dx;
    y[i] += pull * dy;
    x[j] -= pull * dx;
    y[j] -= pull * dy;
  }
  tissue.x = x;
  tissue.y = y;
  tissue.neighbors.update(x, y);
}

// Divides each large cell into two of half its area. Returns the number of divided cells.
std::size_t divide(Tissue& tissue, std::mt19937& random)
{
  constexpr double largest = 0.6;
  std::uniform_real_distribution<double> angle(0, 6.283);
  std::size_t divided = 0;
  for (std::size_t i = 0, cells = tissue.x.size(); i < cells; ++i)
    if (tissue.radius[i] > largest) {
      const double half = tissue.radius[i] / std::sqrt(2.0), a = angle(random);
      const double dx = 0.1 * std::cos(a), dy = 0.1 * std::sin(a);
      tissue.radius[i] = half;
      tissue.add(tissue.x[i] + dx, tissue.y[i] + dy, half);
      ++divided;
    }
  return divided;
}

} // namespace

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> chance(0, 1), growth(0, 0.003);
  Tissue tissue;
  for (int i = 0; i < 100; ++i)
    tissue.add(i % 10 + 0.1 * chance(random), i / 10 + 0.1 * chance(random), 0.4);

  std::size_t divided = 0, died = 0;
  bool is_certified = true;
  for (int step = 0; step < 400; ++step) {
    for (std::size_t i = 0; i < tissue.x.size(); ++i)
      if (tissue.radius[i] > 0) {
        tissue.radius[i] += growth(random);
        if (chance(random) < 0.0005) {
          tissue.remove(i);
          ++died;
        }
      }
    divided += divide(tissue, random);
    relax(tissue);
    is_certified = is_certified && tissue.neighbors.is_certified();
  }
  std::cout << 100 + divided - died << " cells after " << divided << " divisions and " << died
            << " deaths, " << tissue.neighbors.pairs().size() << " pairs of neighbors\n";
  return is_certified && divided > 0 && died > 0 ? 0 : 1;
}
