// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Cell_log.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace run {

namespace {

Cells_in_domains cells_in(const std::optional<std::string>& domain, Cell_rule rule)
{
  if (domain) {
    return scenario::cells_in(scenario::read_polygon_file(*domain), rule, *domain);
  }
  return CGAL::Bounded_voronoi_cells_2();
}

} // namespace

Cell_log::Cell_log(const std::string& path, const Frame_choice& choice,
                   const std::optional<double>& radius, const std::optional<std::string>& domain,
                   Cell_rule rule)
  : Frame_output(choice)
  , m_cells(cells_in(domain, rule))
  , m_radius(radius.value_or(std::numeric_limits<double>::infinity()))
  , m_file(path, {"frame", "time", "id", "x", "y", "area", "density", "perimeter", "contacts",
                  "free_length", "wall_length"})
{
}

void Cell_log::write(const Run_view& run)
{
  const std::vector<Shown_cell> cells = run.cells(m_cells, m_radius);
  const scenario::Motion& motion = run.motion();
  for (std::size_t i = 0; i != cells.size(); ++i) {
    const Shown_cell& cell = cells[i];
    std::optional<double> density;
    if (cell.area > 0.0) {
      density = 1.0 / cell.area;
    }
    m_file.write(run.record().number, motion.time(), motion.id_text(i), motion.points()[i].x,
                 motion.points()[i].y, cell.area, density, cell.perimeter, cell.contacts,
                 cell.free_length, cell.wall_length);
  }
}

} // namespace run
