// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PICTURE_SERIES_H
#define RUN_PICTURE_SERIES_H

#include "Bounds.h"
#include "Frame_choice.h"
#include "Frame_record.h"
#include "Output_directory.h"
#include "Output_file.h"
#include "Picture_page.h"
#include "Picture_view.h"
#include "Svg_picture.h"
#include "Vertex_sets.h"

#include <optional>
#include <string>
#include <vector>

namespace run {

// Pictures of some frames of a run, in a directory, and a page that shows them.
class Picture_series
{
public:
  // `name`: of what runs.
  Picture_series(const std::string& directory, const std::string& name, const Frame_choice& choice,
                 const std::optional<scenario::Box>& box)
    : m_directory(directory)
    , m_name(name)
    , m_choice(choice)
    , m_box(box)
    , m_page(m_directory.path_of("index.html"))
  {
  }

  template <class Run>
  void write(const Run& run)
  {
    const Frame_record& record = run.record();
    if (!m_choice.has(record.frame)) {
      return;
    }
    const Picture_view view(frame_bounds(m_box, run.motion().points()));
    const std::string file_name = frame_file_name(record.frame, ".svg");
    Output_file file(m_directory.path_of(file_name));
    const Svg_picture picture(run.triangulation(), view);
    picture.write(file.stream(), record, sets_of_vertices(run));
    file.finish();
    m_pictures.push_back({file_name, record.frame, record.time});
  }

  void finish()
  {
    write_picture_page(m_page.stream(), m_name, m_pictures);
    m_page.finish();
  }

private:
  Output_directory m_directory;
  std::string m_name;
  Frame_choice m_choice;
  std::optional<scenario::Box> m_box;
  Output_file m_page;
  std::vector<Listed_picture> m_pictures;
};

} // namespace run

#endif // RUN_PICTURE_SERIES_H
