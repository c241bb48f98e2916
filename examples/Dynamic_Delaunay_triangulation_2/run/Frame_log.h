// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_FRAME_LOG_H
#define RUN_FRAME_LOG_H

#include "Frame_record.h"
#include "Output_file.h"
#include "Rebuild_reason_name.h"

#include <limits>
#include <string>

namespace run {

// A row for each frame, as comma separated values. Times are in nanoseconds, of the whole frame.
class Frame_log
{
public:
  explicit Frame_log(const std::string& path)
    : m_file(path)
  {
    m_file.stream().precision(std::numeric_limits<double>::max_digits10);
    m_file.stream() << "frame,time,points,population_changed,certified,mcc,rebuild_reason,"
                       "classified,padded,border,flips,splices,growths,relocated,"
                       "dynamic_ns,static_insert_ns,static_fastest_ns\n";
  }

  void write(const Frame_record& record)
  {
    const CGAL::Update_report_2& update = record.update;
    m_file.stream() << record.frame << ',' << record.time << ',' << record.points << ','
                    << record.population_changed << ',' << record.certified << ','
                    << record.validity << ',' << rebuild_reason_name(update.rebuild_reason) << ','
                    << update.classified << ',' << update.padded << ',' << update.border << ','
                    << update.flips << ',' << update.splices << ',' << update.growths << ','
                    << update.relocated << ',' << record.nanoseconds.dynamic << ','
                    << record.nanoseconds.static_insert << ',' << record.nanoseconds.static_fastest
                    << '\n';
  }

  void finish() { m_file.finish(); }

private:
  Output_file m_file;
};

} // namespace run

#endif // RUN_FRAME_LOG_H
