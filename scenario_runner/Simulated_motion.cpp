// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Simulated_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace scenario {

namespace {

// The first `number_of_points` places, row by row from below, of a lattice of touching discs.
class Body_lattice
{
public:
  Body_lattice(std::size_t number_of_points, std::size_t columns, Packing packing, double diameter,
               const Point& corner, const Periods& periods)
    : m_number_of_points(number_of_points)
    , m_columns(columns)
    , m_packing(packing)
    , m_diameter(diameter)
    , m_corner(corner)
    , m_periods(periods)
  {
    find_pairs_across();
  }

  std::size_t number_of_points() const { return m_number_of_points; }

  Point point(std::size_t i) const
  {
    const std::size_t row = i / m_columns;
    const bool shifted = m_packing == Packing::hexagonal && row % 2 == 1;
    const double x = static_cast<double>(i % m_columns) + (shifted ? 1.0 : 0.5);
    const double y = 0.5 + static_cast<double>(row) * row_distance(m_packing);
    return {m_corner.x + m_diameter * x, m_corner.y + m_diameter * y};
  }

  Point center() const
  {
    Point sum{0.0, 0.0};
    for (std::size_t i = 0; i != m_number_of_points; ++i) {
      sum.x += point(i).x;
      sum.y += point(i).y;
    }
    const auto number = static_cast<double>(m_number_of_points);
    return {sum.x / number, sum.y / number};
  }

  // Calls visit(j) for every place j > i near place i. The diagonals of square cells are among
  // them: bonds there make the body resist shear.
  template <class Visit>
  void for_each_later_near_place(std::size_t i, Visit visit) const
  {
    const std::size_t end = (std::min)(m_number_of_points, i + m_columns + 2);
    for (std::size_t j = i + 1; j < end; j = next_candidate(i, j)) {
      if (distance(i, j) < reach()) {
        visit(j);
      }
    }
    for (auto pair = std::lower_bound(m_pairs_across.begin(), m_pairs_across.end(),
                                      std::pair(i, std::size_t(0)));
         pair != m_pairs_across.end() && pair->first == i; ++pair) {
      visit(pair->second);
    }
  }

private:
  double reach() const { return 1.6 * m_diameter; }

  // Finds the pairs that are near across a side of a periodic box, and not inside of it.
  void find_pairs_across()
  {
    std::vector<std::size_t> outer;
    for (std::size_t i = 0; i != m_number_of_points; ++i) {
      if (is_near_side(point(i).x, m_periods.x) || is_near_side(point(i).y, m_periods.y)) {
        outer.push_back(i);
      }
    }
    for (auto i = outer.begin(); i != outer.end(); ++i) {
      for (auto j = i + 1; j != outer.end(); ++j) {
        const Point offset =
            m_periods.nearest({point(*j).x - point(*i).x, point(*j).y - point(*i).y});
        if (std::hypot(offset.x, offset.y) < reach() && distance(*i, *j) >= reach()) {
          m_pairs_across.emplace_back(*i, *j);
        }
      }
    }
  }

  bool is_near_side(double coordinate, double period) const
  {
    return period != 0.0 && (coordinate < reach() || coordinate > period - reach());
  }

  // Near places follow i directly or are around the one above it.
  std::size_t next_candidate(std::size_t i, std::size_t j) const
  {
    return j == i + 1 ? (std::max)(i + 2, i + m_columns - 1) : j + 1;
  }

  double distance(std::size_t i, std::size_t j) const
  {
    return std::hypot(point(j).x - point(i).x, point(j).y - point(i).y);
  }

  std::size_t m_number_of_points;
  std::size_t m_columns;
  Packing m_packing;
  double m_diameter;
  Point m_corner;
  Periods m_periods;
  std::vector<std::pair<std::size_t, std::size_t>> m_pairs_across; // ascending
};

struct First_frame
{
  std::vector<Point> positions;
  std::vector<Point> velocities;
  Bond_network bonds;
  Periods periods;
};

Point offset_between(const First_frame& frame, std::size_t a, std::size_t b)
{
  return frame.periods.nearest(
      {frame.positions[b].x - frame.positions[a].x, frame.positions[b].y - frame.positions[a].y});
}

void add_particles(const Body_lattice& lattice, const Body_description& body, double jitter,
                   Random_source& random, First_frame& frame)
{
  const Point center = lattice.center();
  for (std::size_t i = 0; i != lattice.number_of_points(); ++i) {
    const Point place = lattice.point(i);
    frame.velocities.push_back({body.velocity.x - body.angular_velocity * (place.y - center.y),
                                body.velocity.y + body.angular_velocity * (place.x - center.x)});
    const double dx = random.uniform(-jitter, jitter);
    const double dy = random.uniform(-jitter, jitter);
    frame.positions.push_back({place.x + dx, place.y + dy});
  }
}

// At rest the body has its jittered shape, not the lattice's: relaxing into a perfect square
// lattice it would make every cell a tie, whose diagonal rounding flips for ever.
void add_bonds(const Body_lattice& lattice, const Body_description& body, std::size_t first_index,
               First_frame& frame)
{
  for (std::size_t i = 0; i != lattice.number_of_points(); ++i) {
    frame.bonds.begin_particle();
    if (body.bonded) {
      lattice.for_each_later_near_place(i, [&](std::size_t j) {
        const Point offset = offset_between(frame, first_index + i, first_index + j);
        frame.bonds.add(static_cast<std::uint32_t>(first_index + j), std::hypot(offset.x, offset.y),
                        body.strain_limit);
      });
    }
  }
}

// Every bond kicks its two ends apart or together. Free random velocities would also set the body
// as a whole drifting and turning, which damping never ends.
void add_shiver(const Body_lattice& lattice, std::size_t first_index, double speed,
                Random_source& random, First_frame& frame)
{
  for (std::size_t i = 0; i != lattice.number_of_points(); ++i) {
    lattice.for_each_later_near_place(i, [&](std::size_t j) {
      const Point offset = offset_between(frame, first_index + i, first_index + j);
      const double factor = random.uniform(-speed, speed) / std::hypot(offset.x, offset.y);
      Point& one = frame.velocities[first_index + i];
      Point& other = frame.velocities[first_index + j];
      one = {one.x - factor * offset.x, one.y - factor * offset.y};
      other = {other.x + factor * offset.x, other.y + factor * offset.y};
    });
  }
}

} // namespace

Particle_system make_particle_system(const Particle_description& description,
                                     const Scaled_scenario& scaled, std::uint64_t seed)
{
  Random_source random(seed);
  First_frame frame;
  frame.periods = periods_of(scaled.box, description.cell);
  for (const Scaled_body& body : scaled.bodies) {
    const Body_lattice lattice(body.number_of_points, body.columns, description.packing,
                               description.diameter, body.description.position, frame.periods);
    const std::size_t first_index = frame.positions.size();
    const double jitter = description.jitter * description.diameter;
    add_particles(lattice, body.description, jitter, random, frame);
    add_bonds(lattice, body.description, first_index, frame);
    if (body.description.shiver != 0.0) {
      const double speed = body.description.shiver * description.diameter *
                           std::sqrt(description.stiffness / description.mass);
      add_shiver(lattice, first_index, speed, random, frame);
    }
  }
  const double damping = description.damping * std::sqrt(description.stiffness * description.mass);
  const Particle_parameters parameters{
      description.diameter, description.mass, description.stiffness, damping,
      scaled.gravity,       scaled.box,       description.cell};
  return Particle_system(parameters, std::move(frame.positions), std::move(frame.velocities),
                         std::move(frame.bonds));
}

double Periods::nearest(double offset, double period)
{
  return period == 0.0 ? offset : offset - period * std::round(offset / period);
}

// Rounding may lead out of the box again: such a coordinate becomes 0.
double Periods::wrapped(double coordinate, double period)
{
  const double rest = coordinate - period * std::floor(coordinate / period);
  return rest >= 0.0 && rest < period ? rest : 0.0;
}

Periods periods_of(const std::optional<Box>& box, Cell_kind kind)
{
  if (!box || kind == Cell_kind::closed) {
    return {};
  }
  return {box->width, kind == Cell_kind::periodic ? box->height : 0.0};
}

double Random_source::gaussian()
{
  if (m_has_spare) {
    m_has_spare = false;
    return m_spare;
  }
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  const double angle = 6.283185307179586 * uniform();
  m_spare = radius * std::sin(angle);
  m_has_spare = true;
  return radius * std::cos(angle);
}

void Bond_network::add(std::uint32_t partner, double rest_length,
                       const std::optional<double>& strain_limit)
{
  m_bonds.push_back(
      {partner, rest_length, strain_limit.value_or(std::numeric_limits<double>::infinity())});
}

void Bond_network::break_all_of(std::uint32_t particle)
{
  for_each([particle](std::uint32_t owner, const Bond& bond) {
    return owner != particle && bond.partner != particle;
  });
}

bool Bond_network::connects(std::uint32_t a, std::uint32_t b) const
{
  const std::uint32_t low = a < b ? a : b;
  const std::uint32_t high = a < b ? b : a;
  for (std::size_t i = m_begin[low]; i != end_of(low); ++i) {
    if (m_bonds[i].partner == high) {
      return true;
    }
  }
  return false;
}

std::size_t Bond_network::end_of(std::uint32_t particle) const
{
  return particle + 1 == m_begin.size() ? m_bonds.size() : m_begin[particle + 1];
}

Particle_system::Particle_system(const Particle_parameters& parameters,
                                 std::vector<Point> positions, std::vector<Point> velocities,
                                 Bond_network bonds)
  : m_parameters(parameters)
  , m_periods(periods_of(parameters.box, parameters.cell))
  , m_gravity{0.0, -parameters.gravity}
  , m_positions(std::move(positions))
  , m_velocities(std::move(velocities))
  , m_forces(m_positions.size())
  , m_bonds(std::move(bonds))
{
}

std::optional<Cell> Particle_system::cell() const
{
  return m_parameters.box ? cell_of(*m_parameters.box, m_parameters.cell) : std::nullopt;
}

void Particle_system::add(const Point& position)
{
  m_positions.push_back(position);
  m_velocities.push_back({0.0, 0.0});
  m_forces.emplace_back();
  m_bonds.begin_particle();
}

void Particle_system::remove(std::uint32_t particle)
{
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  m_positions[particle] = m_velocities[particle] = {nowhere, nowhere};
  m_bonds.break_all_of(particle);
}

void Particle_system::put(std::uint32_t particle, const Point& position)
{
  m_positions[particle] = position;
  m_velocities[particle] = {0.0, 0.0};
}

void Particle_system::step(const Neighbor_edges& neighbors, double time_step)
{
  compute_forces(neighbors);
  m_pushes.clear();
  const double factor = time_step / m_parameters.mass;
  for (std::size_t i = 0; i != m_positions.size(); ++i) {
    m_velocities[i].x += factor * m_forces[i].x;
    m_velocities[i].y += factor * m_forces[i].y;
    m_positions[i].x += time_step * m_velocities[i].x;
    m_positions[i].y += time_step * m_velocities[i].y;
  }
  if (m_parameters.box) {
    put_back_into_box();
  }
}

Energy Particle_system::energy(const Neighbor_edges& neighbors, double time_step)
{
  Energy energy;
  energy.potential = compute_forces(neighbors);
  const double factor = 0.5 * time_step / m_parameters.mass;
  for (std::size_t i = 0; i != m_positions.size(); ++i) {
    const double vx = m_velocities[i].x + factor * m_forces[i].x;
    const double vy = m_velocities[i].y + factor * m_forces[i].y;
    energy.kinetic += 0.5 * m_parameters.mass * (vx * vx + vy * vy);
  }
  return energy;
}

double Particle_system::compute_forces(const Neighbor_edges& neighbors)
{
  const Point weight{m_parameters.mass * m_gravity.x, m_parameters.mass * m_gravity.y};
  std::fill(m_forces.begin(), m_forces.end(), weight);
  for (const auto& [particle, force] : m_pushes) {
    m_forces[particle].x += force.x;
    m_forces[particle].y += force.y;
  }
  double potential = bond_forces() + contact_forces(neighbors);
  if (m_parameters.box) {
    potential += wall_forces();
  }
  if (weight.x != 0.0 || weight.y != 0.0) {
    for (const Point& position : m_positions) {
      potential -= weight.x * position.x + weight.y * position.y;
    }
  }
  return potential;
}

double Particle_system::bond_forces()
{
  double potential = 0.0;
  m_bonds.for_each([&](std::uint32_t particle, const Bond& bond) {
    const Pair pair = between(particle, bond.partner);
    const double length = std::sqrt(pair.squared_distance);
    const double stretch = length - bond.rest_length;
    const double strain = std::abs(stretch) / bond.rest_length;
    if (strain > bond.strain_limit) {
      return false;
    }
    m_largest_strain = (std::max)(m_largest_strain, strain);
    const Point normal = direction(pair, length);
    push_apart(particle, bond.partner, normal,
               -m_parameters.stiffness * stretch - damping_force(pair, normal));
    potential += 0.5 * m_parameters.stiffness * stretch * stretch;
    return true;
  });
  return potential;
}

double Particle_system::contact_forces(const Neighbor_edges& neighbors)
{
  find_contacts(neighbors);
  double potential = 0.0;
  for (const auto& [a, b] : m_contacts) {
    const Pair pair = between(a, b);
    const double distance = std::sqrt(pair.squared_distance);
    const double overlap = m_parameters.diameter - distance;
    const Point normal = direction(pair, distance);
    const double force = m_parameters.stiffness * overlap - damping_force(pair, normal);
    push_apart(a, b, normal, (std::max)(0.0, force));
    potential += 0.5 * m_parameters.stiffness * overlap * overlap;
  }
  return potential;
}

void Particle_system::find_contacts(const Neighbor_edges& neighbors)
{
  const double squared_diameter = m_parameters.diameter * m_parameters.diameter;
  m_contacts.clear();
  for (const auto& [a, b] : neighbors) {
    if (between(a, b).squared_distance < squared_diameter && !m_bonds.connects(a, b)) {
      m_contacts.emplace_back((std::min)(a, b), (std::max)(a, b));
    }
  }
  std::sort(m_contacts.begin(), m_contacts.end());
  // in periodic space points may be neighbors more than once
  m_contacts.erase(std::unique(m_contacts.begin(), m_contacts.end()), m_contacts.end());
}

double Particle_system::wall_forces()
{
  double potential = 0.0;
  if (m_periods.x == 0.0) {
    potential += wall_forces(&Point::x, m_parameters.box->width);
  }
  if (m_periods.y == 0.0) {
    potential += wall_forces(&Point::y, m_parameters.box->height);
  }
  return potential;
}

double Particle_system::wall_forces(double Point::*axis, double side)
{
  double potential = 0.0;
  for (std::size_t i = 0; i != m_positions.size(); ++i) {
    const double position = m_positions[i].*axis, velocity = m_velocities[i].*axis;
    double& force = m_forces[i].*axis;
    potential += wall_force(position, velocity, 1.0, force) +
                 wall_force(side - position, velocity, -1.0, force);
  }
  return potential;
}

double Particle_system::wall_force(double distance, double velocity, double inwards,
                                   double& force) const
{
  const double overlap = 0.5 * m_parameters.diameter - distance;
  if (overlap <= 0.0) {
    return 0.0;
  }
  const double push = m_parameters.stiffness * overlap - m_parameters.damping * inwards * velocity;
  force += inwards * (std::max)(0.0, push);
  return 0.5 * m_parameters.stiffness * overlap * overlap;
}

Particle_system::Pair Particle_system::between(std::uint32_t a, std::uint32_t b) const
{
  const Point offset =
      m_periods.nearest({m_positions[b].x - m_positions[a].x, m_positions[b].y - m_positions[a].y});
  return {offset,
          {m_velocities[b].x - m_velocities[a].x, m_velocities[b].y - m_velocities[a].y},
          offset.x * offset.x + offset.y * offset.y};
}

Point Particle_system::direction(const Pair& pair, double distance)
{
  if (distance == 0.0) {
    return {1.0, 0.0};
  }
  return {pair.offset.x / distance, pair.offset.y / distance};
}

double Particle_system::damping_force(const Pair& pair, const Point& normal) const
{
  return m_parameters.damping *
         (pair.relative_velocity.x * normal.x + pair.relative_velocity.y * normal.y);
}

void Particle_system::push_apart(std::uint32_t a, std::uint32_t b, const Point& normal,
                                 double force)
{
  m_forces[a].x -= force * normal.x;
  m_forces[a].y -= force * normal.y;
  m_forces[b].x += force * normal.x;
  m_forces[b].y += force * normal.y;
}

void Particle_system::put_back_into_box()
{
  put_back(&Point::x, m_parameters.box->width, m_periods.x);
  put_back(&Point::y, m_parameters.box->height, m_periods.y);
}

void Particle_system::put_back(double Point::*axis, double side, double period)
{
  for (std::size_t i = 0; i != m_positions.size(); ++i) {
    double& coordinate = m_positions[i].*axis;
    if (period == 0.0) {
      reflect(coordinate, m_velocities[i].*axis, side);
    } else if (coordinate < 0.0 || coordinate >= period) {
      coordinate = Periods::wrapped(coordinate, period);
    }
  }
}

void Particle_system::reflect(double& coordinate, double& velocity, double side)
{
  if (coordinate < 0.0 || coordinate > side) {
    coordinate = std::clamp(coordinate < 0.0 ? -coordinate : 2.0 * side - coordinate, 0.0, side);
    velocity = -velocity;
    ++m_number_put_back;
  }
}

Particle_motion::Particle_motion(std::string name, const Particle_description& description,
                                 std::uint64_t seed, std::size_t frames,
                                 std::size_t number_of_points)
  : Motion(std::move(name))
  , m_time_step(description.time_step)
  , m_largest_stable_time_step(description.largest_stable_time_step)
  , m_frames(frames)
  , m_seconds_per_frame(description.time_step * std::sqrt(description.mass / description.stiffness))
  , m_ids(number_of_points)
  , m_system(make_particle_system(description, scaled_to(description, number_of_points), seed))
{
  std::iota(m_ids.begin(), m_ids.end(), std::int64_t(0));
}

bool Particle_motion::advance(const Neighbor_edges& neighbors)
{
  m_system.step(neighbors, m_seconds_per_frame);
  m_frame += 1;
  return true;
}

Energy Particle_motion::energy(const Neighbor_edges& neighbors)
{
  return m_system.energy(neighbors, m_seconds_per_frame);
}

Brownian_motion::Brownian_motion(std::string name, const Brownian_description& description,
                                 std::uint64_t seed, std::size_t frames)
  : Motion(std::move(name))
  , m_description(description)
  , m_random(seed)
  , m_frames(frames)
  , m_ids(description.points)
  , m_points(description.points)
{
  std::iota(m_ids.begin(), m_ids.end(), std::int64_t(0));
  for (Point& point : m_points) {
    point.x = m_random.uniform(0.0, m_description.box.width);
    point.y = m_random.uniform(0.0, m_description.box.height);
  }
}

bool Brownian_motion::advance(const Neighbor_edges&)
{
  const double step = m_description.time_step * mean_spacing();
  for (std::size_t i = 0; i != m_points.size(); ++i) {
    const double x = m_points[i].x + step * m_random.gaussian();
    const double y = m_points[i].y + step * m_random.gaussian();
    put(i, {x, y});
  }
  m_time += 1.0;
  return true;
}

void Brownian_motion::put(std::size_t i, const Point& place)
{
  const Box& box = m_description.box;
  const Periods periods = periods_of(box, m_description.cell);
  m_points[i] = {kept_inside(place.x, box.width, periods.x),
                 kept_inside(place.y, box.height, periods.y)};
}

void Brownian_motion::add(const Point& place)
{
  m_ids.push_back(static_cast<std::int64_t>(m_ids.size()));
  m_points.push_back(place);
  put(m_points.size() - 1, place);
}

double Brownian_motion::mean_spacing() const
{
  const Box& box = m_description.box;
  return std::sqrt(box.width * box.height / static_cast<double>(m_points.size()));
}

double Brownian_motion::kept_inside(double value, double side, double period)
{
  if (period != 0.0) {
    return Periods::wrapped(value, period);
  }
  const double folded = std::fmod(std::abs(value), 2.0 * side);
  return folded > side ? 2.0 * side - folded : folded;
}

} // namespace scenario
