// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_FRAME_LOG_H
#define RUN_FRAME_LOG_H

#include "Exact_number.h"
#include "Frame_record.h"
#include "Output_file.h"
#include "Rebuild_reason_name.h"

#include <string>

namespace run {

// A row for each frame, as comma separated values. Times are in nanoseconds, of the whole frame.
class Frame_log
{
public:
  explicit Frame_log(const std::string& path)
    : m_file(path)
  {
    m_file.stream() << "frame,time,points,population_changed,certified,mcc,rebuild_reason,"
                       "classified,padded,border,flips,splices,enlargements,relocated,"
                       "dynamic_ns,static_insert_ns,static_fastest_ns\n";
  }

  void write(const Frame_record& record)
  {
    const CGAL::Update_report_2& update = record.update;
    m_file.stream() << record.frame << ',' << Exact_number{record.time} << ',' << record.points
                    << ',' << record.population_changed << ',' << record.certified << ','
                    << Exact_number{record.validity} << ','
                    << rebuild_reason_name(update.rebuild_reason) << ',' << update.classified << ','
                    << update.padded << ',' << update.border << ',' << update.flips << ','
                    << update.splices << ',' << update.enlargements << ',' << update.relocated
                    << ',' << Exact_number{record.nanoseconds.dynamic} << ','
                    << Exact_number{record.nanoseconds.static_insert} << ','
                    << Exact_number{record.nanoseconds.static_fastest} << '\n';
    m_file.check();
  }

  void finish() { m_file.finish(); }

private:
  Output_file m_file;
};

} // namespace run

#endif // RUN_FRAME_LOG_H
