// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VORONOI_TISSUE_VORONOI_TISSUE_H
#define VORONOI_TISSUE_VORONOI_TISSUE_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_visitor_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace tissue {

// Lengths are in units of the square root of a cell's preferred area, and the unit of time makes
// the mobility times the stiffness of areas 1.
struct Parameters
{
  std::size_t cells = 400;
  double target_shape = 3.81; // the preferred perimeter
  double speed = 0.1;         // of a cell by itself
  double rotation = 1;        // how fast its direction diffuses
  double time_step = 0.1;
  unsigned seed = 1;
};

// The self-propelled Voronoi model (Bi, Yang, Marchetti, Manning: Motility-driven glass and jamming
// transitions in biological tissues, Physical Review X 6, 021011, 2016): the cells of a tissue
// without gaps are the Voronoi cells of points in a periodic square. Their energy is the sum of
// (A - 1)^2 + (P - p0)^2 over areas A and perimeters P; each point goes down its gradient, and
// crawls with a constant speed in a direction that diffuses.
class Voronoi_tissue
{
public:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Edge_changes = CGAL::Periodic_edge_changes_visitor_2;
  using Dynamic =
      CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                      CGAL::With_visitor_2<Edge_changes>>;

  explicit Voronoi_tissue(const Parameters& parameters)
    : m_parameters(parameters)
    , m_random(parameters.seed)
    , m_triangulation(CGAL::Periodic_cell_2(side(), side()))
    , m_area_weights(parameters.cells)
    , m_perimeter_weights(parameters.cells)
  {
    std::uniform_real_distribution<double> coordinate(0, side()), angle(0, 2 * std::acos(-1.0));
    for (std::size_t i = 0; i < parameters.cells; ++i) {
      const double x = coordinate(m_random);
      m_positions.push_back(Point(x, coordinate(m_random)));
      m_directions.push_back(angle(m_random));
    }
    std::vector<std::size_t> ids(parameters.cells);
    m_triangulation.insert(m_positions.begin(), m_positions.end(), ids.begin());
    relax();
  }

  // Makes an Euler step.
  CGAL::Update_report_2 step()
  {
    const double time_step = m_parameters.time_step;
    std::normal_distribution<double> turn(0, std::sqrt(2 * m_parameters.rotation * time_step));
    find_gradients();
    for (std::size_t i = 0; i < m_positions.size(); ++i) {
      const auto [x, y] = m_gradients.gradients()[i];
      const double direction = m_directions[i];
      m_positions[i] =
          Point(m_positions[i].x() + time_step * (m_parameters.speed * std::cos(direction) - x),
                m_positions[i].y() + time_step * (m_parameters.speed * std::sin(direction) - y));
      m_directions[i] += turn(m_random);
    }
    m_triangulation.visitor().clear();
    return m_triangulation.update(m_positions);
  }

  // The T1 events of the last step: two cells part, and two others become neighbors between them.
  std::size_t exchanges() const { return m_triangulation.visitor().created_edges().size(); }

  const Parameters& parameters() const { return m_parameters; }
  // Never wrapped, so differences to earlier ones are displacements.
  const std::vector<Point>& positions() const { return m_positions; }
  const Dynamic& triangulation() const { return m_triangulation; }
  // The measures of cells before the last step.
  const CGAL::Voronoi_cell_measures_2& cells() const { return m_cells; }

private:
  double side() const { return std::sqrt(double(m_parameters.cells)); }

  // Lloyd's relaxation, a little. Among random points some cells are so thin that an Euler step
  // would throw points far away.
  void relax()
  {
    constexpr int iterations = 5;
    for (int i = 0; i < iterations; ++i) {
      m_cells.compute(m_triangulation);
      for (std::size_t id = 0; id < m_positions.size(); ++id)
        m_positions[id] = Point(m_cells.centroids()[id].x, m_cells.centroids()[id].y);
      m_triangulation.update(m_positions);
    }
  }

  void find_gradients()
  {
    m_cells.compute(m_triangulation);
    for (std::size_t i = 0; i < m_positions.size(); ++i) {
      m_area_weights[i] = 2 * (m_cells.areas()[i] - 1);
      m_perimeter_weights[i] = 2 * (m_cells.perimeters()[i] - m_parameters.target_shape);
    }
    m_gradients.compute(m_triangulation, m_area_weights, m_perimeter_weights);
  }

  Parameters m_parameters;
  std::mt19937 m_random;
  std::vector<Point> m_positions;
  std::vector<double> m_directions;
  Dynamic m_triangulation;
  CGAL::Voronoi_cell_measures_2 m_cells;
  CGAL::Voronoi_cell_gradients_2 m_gradients;
  std::vector<double> m_area_weights, m_perimeter_weights;
};

} // namespace tissue

#endif // VORONOI_TISSUE_VORONOI_TISSUE_H
