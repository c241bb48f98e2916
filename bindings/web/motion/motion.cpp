// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The motion of the scenarios as a WebAssembly module, for motion.mjs beside. Numbers cross the
// border in buffers in WebAssembly's memory.

#include "bindings/web/motion/Played_motion.h"

#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>

namespace page {

namespace {

struct Player
{
  std::unique_ptr<Played_motion> motion;
  Neighbor_edges neighbors;
};

std::string text;
std::string error;

} // namespace

extern "C" {

// Where the text of a scenario is written, of so many bytes.
EMSCRIPTEN_KEEPALIVE char* motion_text(std::size_t size)
{
  text.resize(size);
  return text.data();
}

// Null if the text is refused; motion_error() says why.
EMSCRIPTEN_KEEPALIVE Player* motion_open(std::size_t number_of_points)
{
  try {
    auto player = std::make_unique<Player>();
    player->motion = make_motion(scenario::parse_scenario("scenario", text), number_of_points);
    return player.release();
  } catch (const std::exception& e) {
    error = e.what();
    return nullptr;
  }
}

EMSCRIPTEN_KEEPALIVE const char* motion_error()
{
  return error.c_str();
}

EMSCRIPTEN_KEEPALIVE void motion_close(Player* player)
{
  delete player;
}

EMSCRIPTEN_KEEPALIVE std::size_t motion_number_of_points(const Player* player)
{
  return player->motion->points().size();
}

// Two coordinates of each.
EMSCRIPTEN_KEEPALIVE const Point* motion_points(const Player* player)
{
  return player->motion->points().data();
}

EMSCRIPTEN_KEEPALIVE double motion_factor(const Player* player)
{
  return player->motion->factor();
}

EMSCRIPTEN_KEEPALIVE double motion_spacing(const Player* player)
{
  return player->motion->spacing();
}

EMSCRIPTEN_KEEPALIVE void motion_set_field(Player* player, double x, double y)
{
  player->motion->set_field({x, y});
}

EMSCRIPTEN_KEEPALIVE void motion_hold(Player* player, std::uint32_t point, double x, double y)
{
  player->motion->hold(point, {x, y});
}

EMSCRIPTEN_KEEPALIVE void motion_add(Player* player, double x, double y)
{
  player->motion->add({x, y});
}

EMSCRIPTEN_KEEPALIVE void motion_remove(Player* player, std::uint32_t point)
{
  player->motion->remove(point);
}

EMSCRIPTEN_KEEPALIVE void motion_put_back(Player* player, std::uint32_t point, double x, double y)
{
  player->motion->put_back(point, {x, y});
}

// Where two numbers of points are written for each of so many edges, before the next step.
EMSCRIPTEN_KEEPALIVE void* motion_neighbors(Player* player, std::size_t number_of_edges)
{
  player->neighbors.resize(number_of_edges);
  return player->neighbors.data();
}

EMSCRIPTEN_KEEPALIVE void motion_advance(Player* player)
{
  player->motion->advance(player->neighbors);
}

} // extern "C"

} // namespace page
