// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PICTURE_SERIES_H
#define RUN_PICTURE_SERIES_H

#include "Bounds.h"
#include "Frame_choice.h"
#include "Output_directory.h"
#include "Output_file.h"
#include "Picture_view.h"
#include "Svg_picture.h"
#include "Vertex_sets.h"

#include <cstddef>
#include <optional>
#include <string>

namespace run {

// Pictures of some frames of a run, in a directory.
class Picture_series
{
public:
  Picture_series(const std::string& directory, const Frame_choice& choice,
                 const std::optional<scenario::Box>& box)
    : m_directory(directory)
    , m_choice(choice)
    , m_box(box)
  {
  }

  template <class Run>
  void write(const Run& run) const
  {
    const std::size_t frame = run.record().frame;
    if (!m_choice.has(frame)) {
      return;
    }
    const Picture_view view(frame_bounds(m_box, run.motion().points()));
    Output_file file(m_directory.path_of(frame_file_name(frame, ".svg")));
    const Svg_picture picture(run.triangulation(), view);
    picture.write(file.stream(), sets_of_vertices(run));
    file.finish();
  }

private:
  Output_directory m_directory;
  Frame_choice m_choice;
  std::optional<scenario::Box> m_box;
};

} // namespace run

#endif // RUN_PICTURE_SERIES_H
