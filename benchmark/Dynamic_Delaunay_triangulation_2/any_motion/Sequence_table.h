// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_SEQUENCE_TABLE_H
#define ANY_MOTION_SEQUENCE_TABLE_H

#include "Sequence_figures.h"

#include <CGAL/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

namespace any_motion {

// For people: a line for each sequence, and what of it is slow.
class Sequence_table
{
public:
  explicit Sequence_table(std::ostream& out)
    : m_out(out)
  {
    m_out << std::fixed;
  }

  void write_head()
  {
    m_out << std::left << std::setw(name_width) << "" << std::right << std::setw(8) << "points"
          << std::setw(7) << "frames" << std::setw(9) << "median" << std::setw(9) << "worst"
          << std::setw(11) << "dynamic" << std::setw(11) << "static" << std::setw(9) << "rebuilds"
          << std::setw(11) << "relocated" << std::setw(11) << "flips" << std::setw(9) << "splices"
          << '\n';
  }

  void write_row(const Sequence_figures& figures)
  {
    using Report = CGAL::Update_report_2;
    const auto a_point = [](double nanoseconds, const Frame_figures& frame) {
      return frame.points == 0 ? 0.0 : nanoseconds / static_cast<double>(frame.points);
    };
    m_out << std::left << std::setw(name_width) << figures.kind << std::right << std::setw(8)
          << figures.points() << std::setw(7) << figures.frames.size() << std::setprecision(3)
          << std::setw(9) << figures.median_ratio() << std::setw(9) << figures.worst_ratio()
          << std::setprecision(1) << std::setw(11)
          << figures.median([&](const auto& frame) { return a_point(frame.dynamic, frame); })
          << std::setw(11) << figures.median([&](const auto& frame) {
               return a_point(frame.fastest_static(), frame);
             })
          << std::setw(9) << figures.rebuilds() << std::setw(11) << figures.mean(&Report::relocated)
          << std::setw(11) << figures.mean(&Report::flips) << std::setw(9)
          << figures.mean(&Report::splices) << (figures.was_cut_short ? "  cut short" : "")
          << std::endl;
  }

  void write_summary(const std::vector<Sequence_figures>& all)
  {
    write_times_faster(all, "calm");
    write_times_faster(all, "jumps");
    write_slow_medians(all);
    write_slow_frames(all);
  }

private:
  static std::string name(const Sequence_figures& figures)
  {
    return figures.kind + '/' + std::to_string(figures.points());
  }

  void write_times_faster(const std::vector<Sequence_figures>& all, const std::string& group)
  {
    const char* head = "\nTimes faster than the fastest static way, ";
    for (const Sequence_figures& figures : all) {
      if (figures.group == group) {
        if (head != nullptr) {
          m_out << head << group << ", medians\n" << std::setprecision(2);
          head = nullptr;
        }
        m_out << "  " << std::left << std::setw(name_width) << name(figures) << std::right
              << std::setw(9) << 1.0 / figures.median_ratio() << '\n';
      }
    }
  }

  void write_slow_medians(const std::vector<Sequence_figures>& all)
  {
    const auto is_slow_one = [](const Sequence_figures& figures) {
      return figures.median_ratio() > slow_median;
    };
    m_out << std::setprecision(2) << '\n'
          << std::count_if(all.begin(), all.end(), is_slow_one) << " of " << all.size()
          << " medians above " << slow_median << '\n'
          << std::setprecision(3);
    for (const Sequence_figures& figures : all) {
      if (is_slow_one(figures)) {
        m_out << "  " << std::left << std::setw(name_width) << name(figures) << std::right
              << std::setw(9) << figures.median_ratio() << '\n';
      }
    }
  }

  void write_slow_frames(const std::vector<Sequence_figures>& all)
  {
    std::size_t slow = 0, frames = 0;
    for (const Sequence_figures& figures : all) {
      frames += figures.frames.size();
      slow += slow_frames(figures);
    }
    m_out << std::setprecision(2) << '\n'
          << slow << " of " << frames << " frames above " << slow_frame << '\n'
          << std::setprecision(3);
    for (const Sequence_figures& figures : all) {
      if (slow_frames(figures) != 0) {
        m_out << "  " << std::left << std::setw(name_width) << name(figures) << std::right
              << std::setw(5) << slow_frames(figures) << " of " << figures.frames.size() << ':';
        write_frames(figures);
        m_out << '\n';
      }
    }
  }

  static std::size_t slow_frames(const Sequence_figures& figures)
  {
    std::size_t slow = 0;
    for (const Frame_figures& frame : figures.frames) {
      slow += frame.ratio() > slow_frame ? 1 : 0;
    }
    return slow;
  }

  void write_frames(const Sequence_figures& figures)
  {
    constexpr std::size_t most = 8;
    std::size_t written = 0;
    for (const Frame_figures& frame : figures.frames) {
      if (frame.ratio() > slow_frame && written++ < most) {
        m_out << "  " << frame.frame << " (" << frame.ratio() << ')';
      }
    }
    m_out << (written > most ? "  ..." : "");
  }

  static constexpr int name_width = 40;

  std::ostream& m_out;
};

} // namespace any_motion

#endif // ANY_MOTION_SEQUENCE_TABLE_H
