// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_SPACE_FIGURE_H
#define MANUAL_FIGURES_SPACE_FIGURE_H

#include "Panel.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace manual_figures {

// A plane cuts the tetrahedra of a ball whose middle turns, before and after a frame: those that
// the frame removes, and those that it makes, are filled.
class Space_figure
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  using Cell = std::array<std::size_t, 4>; // ids, ascending
  using Cells = std::set<Cell>;

public:
  static std::string draw(std::size_t number_of_points, int number_of_frames)
  {
    std::vector<Place> places = ball(number_of_points), before;
    Dynamic dt(places);
    Cells cells_before;
    for (int frame = 0; frame < number_of_frames; ++frame) {
      before = places;
      cells_before = cells_of(dt);
      turn(places);
      dt.update(places);
    }
    const Cells cells = cells_of(dt);
    const Panel gone = panel(before, cells_before, difference(cells_before, cells), "#e8a33d",
                             "(a) before: tetrahedra that will be gone");
    const Panel made = panel(places, cells, difference(cells, cells_before), "#5b9be8",
                             "(b) after: tetrahedra that are new");
    return svg_of({&gone, &made});
  }

private:
  static std::vector<Place> ball(std::size_t number_of_points)
  {
    std::mt19937 random(1);
    const auto coordinate = [&random] { return std::ldexp(double(random()), -31) - 1; };
    std::vector<Place> places;
    while (places.size() < number_of_points) {
      const double x = coordinate(), y = coordinate();
      const Place p(x, y, coordinate());
      if (CGAL::squared_distance(p, Place(0, 0, 0)) < 1) {
        places.push_back(p);
      }
    }
    return places;
  }

  // Around an axis that is neither in the plane nor normal to it; faster in the middle, while the
  // surface rests.
  static void turn(std::vector<Place>& places)
  {
    constexpr double fastest = 0.02;
    for (Place& p : places) {
      const double distance = std::sqrt(CGAL::squared_distance(p, Place(0, 0, 0)));
      const double angle = fastest * (1 - distance);
      const double u = (p.x() + p.z()) * std::sqrt(0.5), v = (p.z() - p.x()) * std::sqrt(0.5);
      const double y = std::cos(angle) * p.y() - std::sin(angle) * v;
      const double w = std::sin(angle) * p.y() + std::cos(angle) * v;
      p = Place((u - w) * std::sqrt(0.5), y, (u + w) * std::sqrt(0.5));
    }
  }

  static Cells cells_of(const Dynamic& dt)
  {
    Cells cells;
    dt.for_each_cell([&](Cell cell) {
      std::sort(cell.begin(), cell.end());
      cells.insert(cell);
    });
    return cells;
  }

  static Cells difference(const Cells& cells, const Cells& others)
  {
    Cells left;
    std::set_difference(cells.begin(), cells.end(), others.begin(), others.end(),
                        std::inserter(left, left.end()));
    return left;
  }

  static Panel panel(const std::vector<Place>& places, const Cells& cells, const Cells& filled,
                     const std::string& color, const std::string& caption)
  {
    Panel panel({{-1.0, -1.0}, {1.0, 1.0}}, caption);
    for (const Cell& cell : filled) {
      panel.area({section(places, cell)}, color);
    }
    std::vector<std::pair<Point, Point>> lines;
    for (const Facet& facet : facets_of(cells)) {
      const std::vector<Point> ends = section(places, facet);
      if (!ends.empty()) {
        lines.emplace_back(ends[0], ends[1]);
      }
    }
    panel.lines(lines, "#555555", 2.5);
    return panel;
  }

  using Facet = std::array<std::size_t, 3>;

  static std::set<Facet> facets_of(const Cells& cells)
  {
    std::set<Facet> facets;
    for (const auto& [a, b, c, d] : cells) {
      facets.insert({{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}});
    }
    return facets;
  }

  template <std::size_t size>
  static std::vector<Point> section(const std::vector<Place>& places,
                                    const std::array<std::size_t, size>& simplex)
  {
    std::array<Place, size> corners;
    std::transform(simplex.begin(), simplex.end(), corners.begin(),
                   [&](std::size_t id) { return places[id]; });
    return manual_figures::section(corners);
  }
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_SPACE_FIGURE_H
