// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PICTURE_SERIES_H
#define RUN_PICTURE_SERIES_H

#include "Output_file.h"
#include "Picture_view.h"
#include "Svg_picture.h"

#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace run {

// Pictures of evenly spaced frames of a run, and of its last one, in a directory.
class Picture_series
{
public:
  Picture_series(const std::string& directory, std::size_t frames,
                 const std::optional<scenario::Box>& box)
    : m_directory(directory)
    , m_frames(frames)
    , m_stride(frames / most_pictures + 1)
    , m_box(box)
  {
    std::error_code error;
    std::filesystem::create_directories(m_directory, error);
    if (!std::filesystem::is_directory(m_directory)) {
      throw std::runtime_error(directory + ": cannot be made a directory" +
                               (error ? ": " + error.message() : ""));
    }
  }

  template <class Run>
  void draw(const Run& run) const
  {
    const std::size_t frame = run.record().frame;
    if (frame % m_stride != 0 && frame != m_frames) {
      return;
    }
    const Picture_view view = m_box ? Picture_view(*m_box) : Picture_view(run.motion().points());
    Output_file file((m_directory / name(frame)).string());
    const Svg_picture picture(run.triangulation(), view);
    picture.write(file.stream(), !run.record().update.rebuilt());
    file.finish();
  }

private:
  static constexpr std::size_t most_pictures = 30;

  static std::string name(std::size_t frame)
  {
    std::ostringstream text;
    text << "frame_" << std::setw(5) << std::setfill('0') << frame << ".svg";
    return text.str();
  }

  std::filesystem::path m_directory;
  std::size_t m_frames;
  std::size_t m_stride;
  std::optional<scenario::Box> m_box;
};

} // namespace run

#endif // RUN_PICTURE_SERIES_H
