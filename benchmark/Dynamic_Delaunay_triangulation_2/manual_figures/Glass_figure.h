// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_BENCHMARK_MANUAL_FIGURES_GLASS_FIGURE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_BENCHMARK_MANUAL_FIGURES_GLASS_FIGURE_H

#include "Panel.h"
#include "Section.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace manual_figures {

// A plane cuts the tetrahedra of a glass in a periodic cell, before and after it is sheared a
// little: those that are gone then, and those that are new, are filled.
class Glass_figure
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel>;
  using Site = std::pair<std::size_t, CGAL::Periodic_shift_3>;
  using Cell = std::array<Site, 4>; // ascending, the first one with the shift 0
  using Cells = std::set<Cell>;

public:
  explicit Glass_figure(int edge)
    : m_edge(edge)
  {
  }

  std::string draw()
  {
    std::vector<Place> places = glass();
    Dynamic dt(places, cell());
    const std::vector<Place> before = places;
    const Cells cells_before = cells_of(dt);
    for (int frame = 0; frame < 10; ++frame) {
      shear(places, 0.004);
      dt.update(places, cell());
    }
    const Cells cells = cells_of(dt);
    const Panel made = panel(places, cells, difference(cells, cells_before), "#5b9be8",
                             "(b) at a strain of 0.04: tetrahedra that are new");
    m_strain = 0;
    const Panel gone = panel(before, cells_before, difference(cells_before, cells), "#e8a33d",
                             "(a) at rest: tetrahedra that will be gone");
    return svg_of({&gone, &made});
  }

private:
  // The plane is z = 0 here, and the cell is sheared along x.
  CGAL::Periodic_cell_3 cell() const
  {
    const double length = m_edge;
    return CGAL::Periodic_cell_3(CGAL::Periodic_cell_3::Coordinates{length, 0, 0},
                                 {m_strain * length, length, 0}, {0, 0, length});
  }

  std::vector<Place> glass() const
  {
    std::mt19937 random(1);
    const auto jitter = [&random] { return 0.3 * (double(random()) / 0x1p31 - 1); };
    std::vector<Place> places;
    for (int i = 0; i < m_edge * m_edge * m_edge; ++i) {
      const double x = i % m_edge + jitter(), y = i / m_edge % m_edge + jitter();
      places.emplace_back(x, y, i / m_edge / m_edge + jitter());
    }
    return places;
  }

  void shear(std::vector<Place>& places, double strain)
  {
    m_strain += strain;
    for (Place& p : places) {
      p = Place(p.x() + strain * p.y(), p.y(), p.z());
    }
  }

  static Cells cells_of(const Dynamic& dt)
  {
    Cells cells;
    dt.for_each_cell([&](const std::array<std::size_t, 4>& ids,
                         const std::array<CGAL::Periodic_shift_3, 4>& shifts) {
      Cell cell;
      for (std::size_t i = 0; i < 4; ++i) {
        cell[i] = {ids[i], shifts[i]};
      }
      std::sort(cell.begin(), cell.end());
      const CGAL::Periodic_shift_3 first = cell[0].second;
      for (Site& site : cell) {
        for (std::size_t k = 0; k < 3; ++k) {
          site.second[k] -= first[k];
        }
      }
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

  Panel panel(const std::vector<Place>& places, const Cells& cells, const Cells& filled,
              const std::string& color, const std::string& caption) const
  {
    const double length = m_edge, margin = 0.06 * length;
    Panel panel({{-margin, -margin}, {length + margin, length + margin}}, caption);
    for_each_image(places, filled, [&](const std::array<Place, 4>& corners) {
      panel.area({section(corners)}, color);
    });
    std::map<std::array<long, 4>, std::pair<Point, Point>> lines; // of each facet once
    for_each_image(places, cells, [&](const std::array<Place, 4>& corners) {
      for (std::size_t i = 0; i < 4; ++i) {
        std::array<Place, 3> facet;
        std::copy_if(corners.begin(), corners.end(), facet.begin(),
                     [&](const Place& p) { return p != corners[i]; });
        if (const std::vector<Point> ends = section(facet); !ends.empty()) {
          const auto rounded = [](double x) { return std::lround(1e6 * x); };
          const auto& [low, high] =
              std::minmax(ends[0], ends[1], [](const Point& p, const Point& q) {
                return std::pair(p.x, p.y) < std::pair(q.x, q.y);
              });
          lines.insert(
              {{rounded(low.x), rounded(low.y), rounded(high.x), rounded(high.y)}, {low, high}});
        }
      }
    });
    std::vector<std::pair<Point, Point>> ends;
    for (const auto& [key, line] : lines) {
      ends.push_back(line);
    }
    panel.lines(ends, "#555555", 2);
    const Point a{0, 0}, b{length, 0}, c{length * (1 + m_strain), length},
        d{length * m_strain, length};
    panel.lines({{a, b}, {b, c}, {c, d}, {d, a}}, "#c0392b", 6);
    return panel;
  }

  // Calls f for all images of cells that the plane cuts in the panel.
  template <class Function>
  void for_each_image(const std::vector<Place>& places, const Cells& cells, const Function& f) const
  {
    const double length = m_edge;
    for (const Cell& cell : cells) {
      for (int n = 0; n < 27; ++n) {
        const std::array<int, 3> image{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        std::array<Place, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) {
          const Place& p = places[cell[i].first];
          const CGAL::Periodic_shift_3& s = cell[i].second;
          const double x = s[0] + image[0], y = s[1] + image[1], z = s[2] + image[2];
          corners[i] = Place(p.x() + length * (x + m_strain * y), p.y() + length * y,
                             p.z() + length * z - 0.5 * length);
        }
        if (!section(corners).empty()) {
          f(corners);
        }
      }
    }
  }

  int m_edge;
  double m_strain = 0;
};

} // namespace manual_figures

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_BENCHMARK_MANUAL_FIGURES_GLASS_FIGURE_H
