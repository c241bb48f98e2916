// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_FRAME_CHOICE_H
#define RUN_FRAME_CHOICE_H

#include <cstddef>

namespace run {

// Every so many frames of a run, from its first one on, and its last one.
class Frame_choice
{
public:
  Frame_choice(std::size_t frames, std::size_t every)
    : m_frames(frames)
    , m_every(every)
  {
  }

  bool has(std::size_t frame) const { return frame % m_every == 0 || frame == m_frames; }

private:
  std::size_t m_frames;
  std::size_t m_every;
};

// As many as a person looks at.
inline Frame_choice about_thirty(std::size_t frames)
{
  return {frames, frames / 30 + 1};
}

} // namespace run

#endif // RUN_FRAME_CHOICE_H
