// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ROBUSTNESS_REPORT_H
#define ROBUSTNESS_ROBUSTNESS_REPORT_H

#include "../common/Table.h"
#include "Robustness_run.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace robustness {

inline const char* fault_name(Fault fault)
{
  return fault == Fault::WRONG ? "wrong" : fault == Fault::LOST ? "lost" : "crashed";
}

// The columns of the tables, and the members of the report.
inline std::vector<std::pair<std::string, std::uint64_t>> figures(const Counts& counts)
{
  using Op = Operation;
  return {{"operations", counts.number_of_operations()},
          {"insert", counts[Op::INSERT] + counts[Op::INSERT_RANGE]},
          {"remove", counts[Op::REMOVE] + counts[Op::REMOVE_RANGE]},
          {"move", counts[Op::MOVE]},
          {"frames", counts[Op::UPDATE]},
          {"mend", counts[Op::MEND] + counts[Op::CERTIFY]},
          {"misuse", counts[Op::MISUSE]},
          {"points", counts.points},
          {"flips", counts.flips},
          {"splices", counts.splices},
          {"merged", counts.merged},
          {"parted", counts.parted},
          {"rebuilds", counts.number_of_rebuilds()},
          {"certified", counts.certified},
          {"wrong", counts[Fault::WRONG]},
          {"lost", counts[Fault::LOST]},
          {"crashed", counts[Fault::CRASHED]}};
}

// A family that no trial has drawn has no counts.
inline Counts counts_of(const Family& family, const Results& results)
{
  const auto found = results.families.find(family.name);
  return found == results.families.end() ? Counts() : found->second;
}

inline void write_row(common::Table& table, const std::string& name, const Counts& counts)
{
  std::vector<std::string> cells;
  for (const auto& [column, value] : figures(counts)) {
    cells.push_back(std::to_string(value));
  }
  if (counts.trials != 0) {
    table.write_cells(name, cells);
  }
}

inline void write_tables(std::ostream& out, const Results& results)
{
  constexpr int name_width = 30;
  std::vector<common::Column> columns;
  for (const auto& [name, value] : figures(Counts())) {
    columns.push_back({name, name == "points" ? 12 : 11});
  }
  common::Table table(out, name_width, columns);
  table.write_head("family");
  for (const Family& family : families()) {
    write_row(table, family.name, counts_of(family, results));
  }
  write_row(table, "all", results.total());
  out << '\n';
  table.write_head("classifier");
  for (const auto& [name, counts] : results.classifiers) {
    write_row(table, name, counts);
  }
}

inline void write_findings(std::ostream& out, const Results& results)
{
  constexpr std::size_t most = 20;
  const std::size_t shown = (std::min)(most, results.findings.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const Found& found = results.findings[i];
    out << fault_name(found.fault) << " after " << found.operation << " operations: " << found.what
        << "\n  " << found.setup << "\n  --family " << found.family << " --trial " << found.seed
        << '\n';
  }
  if (shown < results.findings.size()) {
    out << "and " << results.findings.size() - shown << " more\n";
  }
}

inline nlohmann::ordered_json json(const Counts& counts)
{
  nlohmann::ordered_json object;
  object["trials"] = counts.trials;
  for (const auto& [name, value] : figures(counts)) {
    object[name] = value;
  }
  for (std::size_t i = 0; i < operation_names.size(); ++i) {
    object["calls"][operation_names[i]] = counts.operations[i];
  }
  for (std::size_t i = 1; i < counts.rebuilds.size(); ++i) {
    const auto reason = static_cast<CGAL::Rebuild_reason_2>(i);
    object["rebuild_reasons"][run::rebuild_reason_name(reason)] = counts.rebuilds[i];
  }
  object["relocated"] = counts.relocated;
  return object;
}

inline nlohmann::ordered_json json(const Results& results)
{
  nlohmann::ordered_json object;
  object["all"] = json(results.total());
  for (const Family& family : families()) {
    object["families"][family.name] = json(counts_of(family, results));
  }
  for (const auto& [name, counts] : results.classifiers) {
    object["classifiers"][name] = json(counts);
  }
  object["findings"] = nlohmann::ordered_json::array();
  for (const Found& found : results.findings) {
    object["findings"].push_back({{"family", found.family},
                                  {"trial", found.seed},
                                  {"operation", found.operation},
                                  {"setup", found.setup},
                                  {"fault", fault_name(found.fault)},
                                  {"what", found.what}});
  }
  return object;
}

} // namespace robustness

#endif // ROBUSTNESS_ROBUSTNESS_REPORT_H
