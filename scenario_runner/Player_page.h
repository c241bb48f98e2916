// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PLAYER_PAGE_H
#define SCENARIO_RUNNER_PLAYER_PAGE_H

#include "scenario_runner/Output_file.h"
#include "scenario_runner/Pictures.h"
#include "scenario_runner/Run_recording.h"

#include <string>

namespace run {

// One HTML file that plays some frames of a run in a browser. It needs nothing beside it, and no
// network. The frames are kept until the last one has come: 20 bytes for each point of each frame.
class Player_page : public Frame_output
{
public:
  Player_page(const std::string& path, const std::string& name, const std::string& method,
              const Frame_choice& choice);

  void finish() override;

private:
  void write(const Run_view& run) override { m_recording.add(run); }

  Output_file m_file;
  std::string m_name;
  std::string m_method;
  Run_recording m_recording;
};

} // namespace run

#endif // SCENARIO_RUNNER_PLAYER_PAGE_H
