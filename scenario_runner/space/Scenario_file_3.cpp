// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Scenario_file_3.h"

#include "scenario_runner/Json_object_reader.h"
#include "scenario_runner/Json_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenario {

namespace {

constexpr Range any{-1e6, 1e6};

Block_description_3 read_block(const Json_object_reader& reader)
{
  reader.allow_only({"counts", "position", "velocity"});
  constexpr auto most = static_cast<double>(max_points);
  Block_description_3 block{{}, reader.triple("position", any)};
  const std::array<double, 3> counts = reader.triple("counts", {1.0, most});
  for (std::size_t i = 0; i != 3; ++i) {
    block.counts[i] = static_cast<std::size_t>(counts[i]);
    if (static_cast<double>(block.counts[i]) != counts[i]) {
      reader.fail("key '" + reader.path("counts") + "' has to have three integers");
    }
  }
  if (counts[0] * counts[1] * counts[2] > most) {
    reader.fail("key '" + reader.path("counts") + "' has too many points, allowed are " +
                std::to_string(max_points));
  }
  if (reader.has("velocity")) {
    block.velocity = reader.triple("velocity", any);
  }
  return block;
}

void check_blocks(const Json_object_reader& reader, const Particle_description_3& particles)
{
  if (particles.number_of_points() > max_points) {
    reader.fail("the blocks of key 'blocks' have too many points, allowed are " +
                std::to_string(max_points));
  }
  for (std::size_t i = 0; particles.box && i != particles.blocks.size(); ++i) {
    const Block_description_3& block = particles.blocks[i];
    for (std::size_t axis = 0; axis != 3; ++axis) {
      const double size = particles.diameter * static_cast<double>(block.counts[axis]);
      if (block.position[axis] < 0.0 || block.position[axis] + size > (*particles.box)[axis]) {
        reader.fail("key 'blocks[" + std::to_string(i) +
                    "]' describes a block that is not inside of the box of key 'box'");
      }
    }
  }
}

Particle_description_3 read_particles(const Json_object_reader& reader)
{
  reader.allow_only({"dimension", "name", "kind", "seed", "frames", "time_step", "jitter",
                     "diameter", "mass", "stiffness", "damping", "gravity", "box", "blocks"});
  Particle_description_3 particles{};
  particles.jitter = reader.number("jitter", {0.0, 0.5});
  particles.diameter = reader.number("diameter", magnitude);
  particles.mass = reader.number("mass", magnitude);
  particles.stiffness = reader.number("stiffness", magnitude);
  particles.damping = reader.number("damping", {0.0, 2.0});
  particles.gravity = reader.number("gravity", {0.0, 1e6});
  particles.time_step = reader.number("time_step", positive_up_to(largest_time_step));
  if (reader.has("box")) {
    particles.box = reader.triple("box", magnitude);
  }
  for (const Json_object_reader& block : reader.objects("blocks")) {
    particles.blocks.push_back(read_block(block));
  }
  check_blocks(reader, particles);
  return particles;
}

std::array<bool, 3> periodic_axes(const Json_object_reader& reader)
{
  const std::string cell =
      reader.has("cell") ? reader.choice("cell", {"closed", "periodic", "slab", "wire"}) : "closed";
  return {cell != "closed", cell == "periodic" || cell == "slab", cell == "periodic"};
}

Brownian_description_3 read_brownian(const Json_object_reader& reader)
{
  reader.allow_only(
      {"dimension", "name", "kind", "seed", "frames", "time_step", "points", "box", "cell"});
  return {reader.count("points", max_points), reader.triple("box", magnitude),
          reader.number("time_step", positive_up_to(largest_time_step)), periodic_axes(reader)};
}

} // namespace

std::size_t Particle_description_3::number_of_points() const
{
  std::size_t sum = 0;
  for (const Block_description_3& block : blocks) {
    sum += block.number_of_points();
  }
  return sum;
}

bool is_scenario_in_space(const std::string& file, const std::string& text)
{
  const nlohmann::json json = parse_json(file, text);
  const Json_object_reader reader(json, file, "");
  if (!reader.has("dimension")) {
    return false;
  }
  if (json["dimension"] != 3) {
    reader.fail(
        "key 'dimension' is not 3, for a scenario in space; without it a scenario is in the "
        "plane");
  }
  return true;
}

Scenario_description_3 parse_scenario_3(const std::string& file, const std::string& text)
{
  const nlohmann::json json = parse_json(file, text);
  const Json_object_reader reader(json, file, "");
  Scenario_description_3 description;
  if (reader.choice("kind", {"particles", "brownian"}) == "brownian") {
    description.kind = read_brownian(reader);
  } else {
    description.kind = read_particles(reader);
  }
  description.name = reader.word("name");
  description.seed = reader.integer("seed", 0, (std::numeric_limits<std::uint64_t>::max)());
  description.frames = reader.count("frames", 1'000'000'000);
  return description;
}

Particle_description_3 scaled_to(Particle_description_3 particles, std::size_t number_of_points)
{
  const auto before = static_cast<double>(particles.number_of_points());
  const double factor = std::cbrt(static_cast<double>(number_of_points) / before);
  particles.gravity /= factor;
  if (particles.box) {
    for (double& side : *particles.box) {
      side *= factor;
    }
  }
  for (Block_description_3& block : particles.blocks) {
    const double points = static_cast<double>(block.number_of_points()) * factor * factor * factor;
    for (std::size_t axis = 0; axis != 3; ++axis) {
      block.position[axis] *= factor;
    }
    for (const std::size_t axis : {std::size_t(0), std::size_t(1)}) {
      const double count = std::round(static_cast<double>(block.counts[axis]) * factor);
      block.counts[axis] = static_cast<std::size_t>((std::max)(1.0, count));
    }
    const auto layer = static_cast<double>(block.counts[0] * block.counts[1]);
    block.counts[2] = static_cast<std::size_t>((std::max)(1.0, std::ceil(points / layer)));
  }
  while (particles.number_of_points() < number_of_points) {
    ++particles.blocks.back().counts[2];
  }
  return particles;
}

} // namespace scenario
