// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_DOMAIN_FIGURE_H
#define MANUAL_FIGURES_DOMAIN_FIGURE_H

#include "Panel.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_in_domain_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cstddef>
#include <string>
#include <vector>

namespace manual_figures {

// The cell of a point in a hall with walls and a pillar, by each rule, and all bisectors.
class Domain_figure
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Place = Kernel::Point_2;
  using Polygon = CGAL::Polygon_2<Kernel>;
  using Cells = CGAL::Voronoi_cells_in_domain_2;

public:
  static std::string draw()
  {
    const Panel whole = panel(Cells::Rule::WHOLE, "(a) WHOLE");
    const Panel connected = panel(Cells::Rule::CONNECTED, "(b) CONNECTED");
    const Panel visible = panel(Cells::Rule::VISIBLE, "(c) VISIBLE");
    return svg_of({&whole, &connected, &visible});
  }

private:
  static Polygon polygon(const std::vector<Place>& corners)
  {
    return Polygon(corners.begin(), corners.end());
  }

  static CGAL::Polygon_with_holes_2<Kernel> hall()
  {
    CGAL::Polygon_with_holes_2<Kernel> hall(polygon(
        {Place(0, 0), Place(12, 0), Place(12, 6), Place(7.6, 6), Place(7.6, 3), Place(7.3, 3),
         Place(7.3, 6), Place(4.3, 6), Place(4.3, 1.5), Place(4, 1.5), Place(4, 6), Place(0, 6)}));
    hall.add_hole(polygon({Place(5.2, 2.2), Place(6, 2.2), Place(6, 2.8), Place(5.2, 2.8)}));
    return hall;
  }

  static Panel panel(Cells::Rule rule, const std::string& caption)
  {
    const CGAL::Polygon_with_holes_2<Kernel> domain = hall();
    const std::vector<Place> points{Place(5.8, 4),   Place(1.2, 1.2), Place(1, 5.2), Place(5, 0.6),
                                    Place(9.5, 0.8), Place(11, 3),    Place(10, 5.4)};
    const CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points.begin(), points.end());
    Cells cells(domain, Cells::Rule::WHOLE);
    cells.compute(dt);
    Panel panel({{-0.1, -0.1}, {12.1, 6.1}}, caption);
    fill(panel, Cells(domain, rule).cell(dt, 0));
    for (const Cells::Piece& piece : cells.pieces())
      panel.line(point(piece.from), point(piece.to),
                 piece.side == Cells::Side::WALL ? "#333333" : "#aaaaaa",
                 piece.side == Cells::Side::WALL ? 7.0 : 3.0);
    for (std::size_t i = 0; i < points.size(); ++i)
      panel.dot({points[i].x(), points[i].y()}, i == 0 ? "#1b5fd5" : "#333333", 11.0);
    return panel;
  }

  static Point point(const Cells::Position& p) { return {p.x, p.y}; }

  static void fill(Panel& panel, const Cells::Cell& cell)
  {
    std::vector<std::vector<Point>> rings(cell.ring_areas.size());
    for (std::size_t ring = 0; ring < rings.size(); ++ring)
      for (std::size_t i = cell.first_pieces[ring]; i < cell.first_pieces[ring + 1]; ++i)
        rings[ring].push_back(point(cell.pieces[i].from));
    panel.area(rings, "rgba(27,95,213,0.35)");
  }
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_DOMAIN_FIGURE_H
