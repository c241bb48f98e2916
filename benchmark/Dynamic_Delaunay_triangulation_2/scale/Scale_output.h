// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SCALE_OUTPUT_H
#define SCALE_SCALE_OUTPUT_H

#include "../common/Csv_file.h"
#include "../common/Table.h"
#include "Scale_figures.h"
#include "Scale_memory.h"
#include "Scale_run.h"
#include "Stream_bandwidth.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace scale {

using Bandwidths = std::map<unsigned, Bandwidth>; // by threads

constexpr int name_width = 25;

inline std::string name_of(const Case_record& record)
{
  return record.motion + '/' + std::to_string(record.points);
}

// For people: a row for each number of threads, and one for how many times faster each is than the
// first.
class Time_table
{
public:
  explicit Time_table(std::ostream& out)
    : m_table(out, name_width,
              {{"threads", 8},
               {"frames", 7},
               {"total", 9, 1},
               {"worst", 9, 1},
               {"read", 8, 1},
               {"classify", 9, 1},
               {"repair", 8, 1},
               {"certify", 8, 1},
               {"flips", 8, 3}})
  {
    m_table.write_head("ns a point");
  }

  void write_rows(const Case_record& record)
  {
    const Figures first = figures_of(record.series.front(), record.points);
    for (const Series& series : record.series) {
      const Figures figures = figures_of(series, record.points);
      m_table.write_row(&series == &record.series.front() ? name_of(record) : "", series.threads,
                        series.frames.size(), figures.total, figures.worst, figures.read,
                        figures.classify, figures.repair, figures.certify, figures.flips);
      if (&series != &record.series.front()) {
        write_speedups(first, figures);
      }
    }
  }

private:
  // Speedups of phases of less than a tenth of a nanosecond a point are not shown.
  void write_speedups(const Figures& first, const Figures& figures)
  {
    std::vector<std::string> cells{"", "times"};
    const auto before = first.times(), now = figures.times();
    for (std::size_t i = 0; i != before.size(); ++i) {
      const bool is_timed = before[i] >= 0.1 && now[i] >= 0.1;
      cells.push_back(is_timed ? common::cell(before[i] / now[i], 2) : "-");
    }
    m_table.write_cells("", cells);
  }

  common::Table m_table;
};

// How near frames come to the bandwidth of copying with as many threads.
inline void write_bandwidths(std::ostream& out, const Bandwidths& bandwidths,
                             const std::vector<Case_record>& calm)
{
  common::Table machine(out, name_width, {{"copy", 8, 1}, {"triad", 8, 1}});
  out << '\n';
  machine.write_head("bandwidth, GB/s");
  for (const auto& [threads, bandwidth] : bandwidths) {
    machine.write_row(std::to_string(threads) + " threads", bandwidth.copy, bandwidth.triad);
  }
  common::Table frames(out, name_width,
                       {{"threads", 8}, {"total", 9, 1}, {"skipping", 9, 2}, {"passing", 9, 2}});
  out << '\n';
  frames.write_head("share of the copying");
  for (const Case_record& record : calm) {
    for (const Series& series : record.series) {
      const double total = figures_of(series, record.points).total;
      const double copy = bandwidths.at(series.threads).copy;
      frames.write_row(&series == &record.series.front() ? name_of(record) : "", series.threads,
                       total, bytes_of_skipping / total / copy, bytes_of_passing / total / copy);
    }
  }
}

inline void write_memory(std::ostream& out, const std::vector<Memory_record>& records)
{
  common::Table table(out, name_width,
                      {{"threads", 7},
                       {"CGAL", 7, 1},
                       {"built", 7, 1},
                       {"calm", 7, 1},
                       {"rough", 7, 1},
                       {"rebuilt", 8, 1},
                       {"beyond", 8, 1},
                       {"peak:", 7},
                       {"build", 7, 1},
                       {"frames", 7, 1},
                       {"rebuild", 8, 1},
                       {"GB", 7, 2}});
  out << '\n';
  table.write_head("bytes a point");
  for (const Memory_record& record : records) {
    const auto points = static_cast<double>(record.points);
    table.write_row("memory/" + std::to_string(record.points), record.threads, record.cgal / points,
                    record.constructed / points, record.calm / points, record.rough / points,
                    record.rebuilt / points, (record.rough - record.cgal) / points, "",
                    record.construction_peak / points, record.frame_peak / points,
                    record.rebuild_peak / points, 1e-9 * record.largest());
  }
}

inline void write_csv(const std::filesystem::path& directory, const std::string& command,
                      const std::vector<Case_record>& cases, const Bandwidths& bandwidths,
                      const std::vector<Memory_record>& memory)
{
  const std::vector<std::string> remarks{"command: " + command};
  common::Csv_file times(directory / "scale.csv", remarks,
                         {"motion", "points", "threads", "frames", "total", "worst", "read",
                          "classify", "repair", "certify", "flips"});
  for (const Case_record& record : cases) {
    for (const Series& series : record.series) {
      const Figures figures = figures_of(series, record.points);
      times.write_row(record.motion, record.points, series.threads, series.frames.size(),
                      figures.total, figures.worst, figures.read, figures.classify, figures.repair,
                      figures.certify, figures.flips);
    }
  }
  times.finish();
  common::Csv_file machine(directory / "bandwidth.csv", remarks,
                           {"threads", "copy", "triad", "skipping", "passing"});
  for (const auto& [threads, bandwidth] : bandwidths) {
    machine.write_row(threads, bandwidth.copy, bandwidth.triad, bytes_of_skipping,
                      bytes_of_passing);
  }
  machine.finish();
  common::Csv_file bytes(directory / "memory.csv", remarks,
                         {"points", "threads", "cgal", "built", "calm", "rough", "rebuilt",
                          "build_peak", "frame_peak", "rebuild_peak"});
  for (const Memory_record& record : memory) {
    const auto points = static_cast<double>(record.points);
    bytes.write_row(record.points, record.threads, record.cgal / points,
                    record.constructed / points, record.calm / points, record.rough / points,
                    record.rebuilt / points, record.construction_peak / points,
                    record.frame_peak / points, record.rebuild_peak / points);
  }
  bytes.finish();
}

} // namespace scale

#endif // SCALE_SCALE_OUTPUT_H
