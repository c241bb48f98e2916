// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CELL_LOG_H
#define SCENARIO_RUNNER_CELL_LOG_H

#include "scenario_runner/Csv_writer.h"
#include "scenario_runner/Domain_file.h"
#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Pictures.h"

#include <optional>
#include <string>

namespace run {

// The bounded Voronoi cells of some frames as comma separated values, a row for each point.
class Cell_log : public Frame_output
{
public:
  // Without a radius cells end only at the walls of the domain, which is read from the given file.
  // The rule says which part of a cell counts where walls divide it.
  Cell_log(const std::string& path, const Frame_choice& choice, const std::optional<double>& radius,
           const std::optional<std::string>& domain, Cell_rule rule);

  void finish() override { m_file.finish(); }

private:
  void write(const Run_view& run) override;

  Cells_in_domains m_cells;
  double m_radius;
  Csv_writer m_file;
};

} // namespace run

#endif // SCENARIO_RUNNER_CELL_LOG_H
