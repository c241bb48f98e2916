// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_SCENARIO_FILE_H
#define SCENARIO_SCENARIO_FILE_H

#include "Json_object_reader.h"
#include "Scenario_description.h"
#include "Text_file.h"

#include <cstdint>
#include <limits>
#include <string>

namespace scenario {

inline void check_bonded(const Json_object_reader& reader, const Body_description& body,
                         const std::string& key)
{
  if (!body.bonded) {
    reader.fail("key '" + reader.path(key) + "' needs '" + reader.path("bonded") + "' to be true");
  }
}

// Of lengths, masses and stiffnesses. Beyond it their quotients could leave the range of numbers.
constexpr Range magnitude{1e-6, 1e6};

inline Body_description read_body(const Json_object_reader& reader)
{
  reader.allow_only({"rows", "columns", "position", "velocity", "angular_velocity", "bonded",
                     "strain_limit", "shiver"});
  constexpr Range any{-1e6, 1e6};
  const auto [x, y] = reader.pair("position", any);
  Body_description body{
      reader.integer("rows", 1, max_points), reader.integer("columns", 1, max_points), {x, y}};
  if (reader.has("velocity")) {
    const auto [vx, vy] = reader.pair("velocity", any);
    body.velocity = {vx, vy};
  }
  if (reader.has("angular_velocity")) {
    body.angular_velocity = reader.number("angular_velocity", any);
  }
  if (reader.has("bonded")) {
    body.bonded = reader.boolean("bonded");
  }
  if (reader.has("strain_limit")) {
    check_bonded(reader, body, "strain_limit");
    body.strain_limit = reader.number("strain_limit", positive_up_to(1.0));
  }
  if (reader.has("shiver")) {
    check_bonded(reader, body, "shiver");
    body.shiver = reader.number("shiver", {0.0, 1.0});
  }
  return body;
}

inline Box read_box(const Json_object_reader& reader)
{
  const auto [width, height] = reader.pair("box", magnitude);
  return {width, height};
}

inline void check_number_of_points(const Json_object_reader& reader,
                                   const Particle_description& particles)
{
  double sum = 0.0;
  for (const Body_description& body : particles.bodies) {
    sum += static_cast<double>(body.rows) * static_cast<double>(body.columns);
  }
  if (sum > static_cast<double>(max_points)) {
    reader.fail("the bodies of key 'bodies' have too many points, allowed are " +
                std::to_string(max_points));
  }
}

inline void check_inside_box(const Json_object_reader& reader,
                             const Particle_description& particles)
{
  for (std::size_t i = 0; particles.box && i != particles.bodies.size(); ++i) {
    const Body_description& body = particles.bodies[i];
    const Box size = extent(body, particles.packing, particles.diameter);
    if (body.position.x < 0.0 || body.position.x + size.width > particles.box->width ||
        body.position.y < 0.0 || body.position.y + size.height > particles.box->height) {
      reader.fail("key 'bodies[" + std::to_string(i) + "]' describes a body of " +
                  std::to_string(size.width) + " x " + std::to_string(size.height) +
                  " that is not inside of the box of key 'box'");
    }
  }
}

inline Particle_description read_particles(const Json_object_reader& reader)
{
  reader.allow_only({"name", "kind", "seed", "frames", "time_step", "largest_stable_time_step",
                     "packing", "jitter", "diameter", "mass", "stiffness", "damping", "gravity",
                     "box", "bodies"});
  Particle_description particles;
  particles.packing = reader.choice("packing", {"square", "hexagonal"}) == "square"
                          ? Packing::square
                          : Packing::hexagonal;
  particles.jitter = reader.number("jitter", {0.0, 0.5});
  particles.diameter = reader.number("diameter", magnitude);
  particles.mass = reader.number("mass", magnitude);
  particles.stiffness = reader.number("stiffness", magnitude);
  particles.damping = reader.number("damping", {0.0, 2.0});
  particles.gravity = reader.number("gravity", {0.0, 1e6});
  particles.time_step = reader.number("time_step", positive_up_to(largest_time_step));
  if (reader.has("largest_stable_time_step")) {
    particles.largest_stable_time_step =
        reader.number("largest_stable_time_step", positive_up_to(largest_time_step));
  }
  if (reader.has("box")) {
    particles.box = read_box(reader);
  }
  for (const Json_object_reader& body : reader.objects("bodies")) {
    particles.bodies.push_back(read_body(body));
  }
  check_number_of_points(reader, particles);
  check_inside_box(reader, particles);
  return particles;
}

inline Brownian_description read_brownian(const Json_object_reader& reader)
{
  reader.allow_only({"name", "kind", "seed", "frames", "time_step", "points", "box"});
  return {reader.integer("points", 1, max_points), read_box(reader),
          reader.number("time_step", positive_up_to(largest_time_step))};
}

// `file` is what messages call the text.
inline Scenario_description parse_scenario(const std::string& file, const std::string& text)
{
  const nlohmann::json json = parse_json(file, text);
  const Json_object_reader reader(json, file, "");
  const bool is_brownian = reader.choice("kind", {"particles", "brownian"}) == "brownian";
  Scenario_description description;
  if (is_brownian) {
    description.kind = read_brownian(reader);
  } else {
    description.kind = read_particles(reader);
  }
  description.name = reader.word("name");
  description.seed = reader.integer("seed", 0, (std::numeric_limits<std::uint64_t>::max)());
  description.frames = reader.integer("frames", 1, 1'000'000'000);
  return description;
}

inline Scenario_description read_scenario_file(const std::string& path)
{
  return parse_scenario(path, read_text_file(path));
}

} // namespace scenario

#endif // SCENARIO_SCENARIO_FILE_H
