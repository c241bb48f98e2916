// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Scenario_file.h"

#include "scenario_runner/Json_object_reader.h"
#include "scenario_runner/Json_text.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace scenario {

namespace {

// The extent of a body, the discs' radii included.
Box extent(const Body_description& body, Packing packing, double diameter)
{
  const double shift = packing == Packing::hexagonal && body.rows > 1 ? 0.5 : 0.0;
  return {diameter * (static_cast<double>(body.columns) + shift),
          diameter * (1.0 + static_cast<double>(body.rows - 1) * row_distance(packing))};
}

void check_bonded(const Json_object_reader& reader, const Body_description& body,
                  const std::string& key)
{
  if (!body.bonded) {
    reader.fail("key '" + reader.path(key) + "' needs '" + reader.path("bonded") + "' to be true");
  }
}

Body_description read_body(const Json_object_reader& reader)
{
  reader.allow_only({"rows", "columns", "position", "velocity", "angular_velocity", "bonded",
                     "strain_limit", "shiver"});
  constexpr Range any{-1e6, 1e6};
  const auto [x, y] = reader.pair("position", any);
  Body_description body{
      reader.count("rows", max_points), reader.count("columns", max_points), {x, y}};
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

Box read_box(const Json_object_reader& reader)
{
  const auto [width, height] = reader.pair("box", magnitude);
  return {width, height};
}

Cell_kind read_cell(const Json_object_reader& reader)
{
  if (!reader.has("cell")) {
    return Cell_kind::closed;
  }
  const std::string name = reader.choice("cell", {"closed", "channel", "periodic"});
  if (name != "closed" && !reader.has("box")) {
    reader.fail("key 'cell' is " + in_quotes(name) + ", which needs key 'box'");
  }
  return name == "closed"    ? Cell_kind::closed
         : name == "channel" ? Cell_kind::channel
                             : Cell_kind::periodic;
}

void check_number_of_points(const Json_object_reader& reader, const Particle_description& particles)
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

void check_inside_box(const Json_object_reader& reader, const Particle_description& particles)
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

Particle_description read_particles(const Json_object_reader& reader)
{
  reader.allow_only({"name", "kind", "seed", "frames", "time_step", "largest_stable_time_step",
                     "packing", "jitter", "diameter", "mass", "stiffness", "damping", "gravity",
                     "box", "cell", "bodies"});
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
  particles.cell = read_cell(reader);
  for (const Json_object_reader& body : reader.objects("bodies")) {
    particles.bodies.push_back(read_body(body));
  }
  check_number_of_points(reader, particles);
  check_inside_box(reader, particles);
  return particles;
}

Brownian_description read_brownian(const Json_object_reader& reader)
{
  reader.allow_only({"name", "kind", "seed", "frames", "time_step", "points", "box", "cell"});
  return {reader.count("points", max_points), read_box(reader),
          reader.number("time_step", positive_up_to(largest_time_step)), read_cell(reader)};
}

std::size_t scaled_columns(const Body_description& body, std::size_t number_of_points)
{
  if (number_of_points == body.number_of_points()) {
    return body.columns;
  }
  const double shape = static_cast<double>(body.columns) / static_cast<double>(body.rows);
  const double columns = std::round(std::sqrt(static_cast<double>(number_of_points) * shape));
  return static_cast<std::size_t>((std::max)(1.0, columns));
}

} // namespace

std::optional<Cell> cell_of(const Box& box, Cell_kind kind)
{
  if (kind == Cell_kind::closed) {
    return std::nullopt;
  }
  return Cell{
      {0.0, 0.0}, {{{box.width, 0.0}, {0.0, box.height}}}, {true, kind == Cell_kind::periodic}};
}

double row_distance(Packing packing)
{
  return packing == Packing::square ? 1.0 : std::sqrt(0.75);
}

std::size_t Particle_description::number_of_points() const
{
  std::size_t sum = 0;
  for (const Body_description& body : bodies) {
    sum += body.number_of_points();
  }
  return sum;
}

Scaled_scenario scaled_to(const Particle_description& particles, std::size_t number_of_points)
{
  const auto before = static_cast<double>(particles.number_of_points());
  const auto after = static_cast<double>(number_of_points);
  Scaled_scenario scaled{std::sqrt(after / before), 0.0, particles.box, {}};
  scaled.gravity = particles.gravity / scaled.factor;
  if (scaled.box) {
    scaled.box->width *= scaled.factor;
    scaled.box->height *= scaled.factor;
  }
  std::size_t sum = 0;
  std::size_t scaled_sum = 0;
  for (Body_description body : particles.bodies) {
    sum += body.number_of_points();
    const auto scaled_end =
        static_cast<std::size_t>(std::llround(after * (static_cast<double>(sum) / before)));
    const std::size_t number = scaled_end - scaled_sum;
    scaled_sum = scaled_end;
    const std::size_t columns = scaled_columns(body, number);
    body.position.x *= scaled.factor;
    body.position.y *= scaled.factor;
    body.angular_velocity /= scaled.factor;
    scaled.bodies.push_back({number, columns, body});
  }
  return scaled;
}

Scenario_description parse_scenario(const std::string& file, const std::string& text)
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
  description.frames = reader.count("frames", 1'000'000'000);
  return description;
}

Scenario_description read_scenario_file(const std::string& path)
{
  return parse_scenario(path, read_text_file(path));
}

} // namespace scenario
