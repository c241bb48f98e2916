// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ROBUSTNESS_TABLE_H
#define ROBUSTNESS_ROBUSTNESS_TABLE_H

#include "Counts.h"
#include "Families.h"
#include "Robustness_run.h"
#include "scenario_runner/Frame_record.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <iomanip>
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

class Robustness_table
{
public:
  explicit Robustness_table(std::ostream& out)
    : m_out(out)
  {
  }

  void write(const Results& results)
  {
    write_head("family");
    for (std::size_t i = 0; i < families().size(); ++i) {
      write_row(families()[i].name, results.families[i]);
    }
    write_row("all", results.total());
    m_out << '\n';
    write_head("classifier");
    for (const auto& [name, counts] : results.classifiers) {
      write_row(name, counts);
    }
  }

private:
  static constexpr int name_width = 30;

  static int width(const std::string& column) { return column == "points" ? 11 : 10; }

  void write_head(const char* name)
  {
    m_out << std::left << std::setw(name_width) << name << std::right;
    for (const auto& [column, value] : figures(Counts())) {
      m_out << ' ' << std::setw(width(column)) << column;
    }
    m_out << '\n';
  }

  void write_row(const std::string& name, const Counts& counts)
  {
    if (counts.trials == 0) {
      return;
    }
    m_out << std::left << std::setw(name_width) << name << std::right;
    for (const auto& [column, value] : figures(counts)) {
      m_out << ' ' << std::setw(width(column)) << value;
    }
    m_out << '\n';
  }

  std::ostream& m_out;
};

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

inline nlohmann::ordered_json json(const Found& found)
{
  return {{"family", found.family},           {"trial", found.seed},
          {"operation", found.operation},     {"setup", found.setup},
          {"fault", fault_name(found.fault)}, {"what", found.what}};
}

inline nlohmann::ordered_json json(const Results& results)
{
  nlohmann::ordered_json object;
  object["all"] = json(results.total());
  for (std::size_t i = 0; i < families().size(); ++i) {
    object["families"][families()[i].name] = json(results.families[i]);
  }
  for (const auto& [name, counts] : results.classifiers) {
    object["classifiers"][name] = json(counts);
  }
  object["findings"] = nlohmann::ordered_json::array();
  for (const Found& found : results.findings) {
    object["findings"].push_back(json(found));
  }
  return object;
}

} // namespace robustness

#endif // ROBUSTNESS_ROBUSTNESS_TABLE_H
