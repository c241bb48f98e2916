// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Player_page.h"

#include <array>

namespace run {

namespace {

// bindings/web/player/player.html with its styles and scripts: what comes before the title, between
// the title and the recording, and after the recording.
constexpr std::array<const char*, 3> page_parts = {
#include "player_page_parts.inc"
};

} // namespace

Player_page::Player_page(const std::string& path, const std::string& name,
                         const std::string& method, const Frame_choice& choice)
  : Frame_output(choice)
  , m_file(path)
  , m_name(name)
  , m_method(method)
{
}

void Player_page::finish()
{
  std::ostream& out = m_file.stream();
  out << page_parts[0] << html_text(m_name) << page_parts[1];
  m_recording.write(out, m_name, m_method);
  out << page_parts[2];
  m_file.finish();
}

} // namespace run
