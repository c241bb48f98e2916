// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Lattice_window.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace run {

namespace {

using scenario::Point;
using scenario::Shift;

constexpr double most_shifts = 1 << 24;

double product(const Point& p, const Point& q)
{
  return p.x * q.x + p.y * q.y;
}

double area(const Point& p, const Point& q)
{
  return p.x * q.y - p.y * q.x;
}

double length(const Point& p)
{
  return std::hypot(p.x, p.y);
}

int checked_multiple(double multiple, const char* what)
{
  if (!(std::abs(multiple) < most_shifts)) {
    throw std::runtime_error(what);
  }
  return static_cast<int>(multiple);
}

} // namespace

Lattice_window::Lattice_window(const scenario::Cell& cell)
  : m_cell(cell)
{
  if (cell.is_slab()) {
    m_shifts[0][cell.is_periodic[0] ? 0 : 1] = 1;
    const Point& u = cell.period();
    m_vectors = {u, {-u.y, u.x}};
  } else {
    m_shifts = {{{1, 0}, {0, 1}}};
    shorten_vectors();
  }
  const double whole = std::abs(area(m_vectors[0], m_vectors[1]));
  m_heights = {whole / length(m_vectors[1]), whole / length(m_vectors[0])};
}

// Lagrange's: the longer vector becomes its rest modulo the shorter one, until that is no shorter.
void Lattice_window::shorten_vectors()
{
  m_vectors = m_cell.sides;
  auto& [u, v] = m_vectors;
  while (true) {
    if (length(v) < length(u)) {
      std::swap(u, v);
      std::swap(m_shifts[0], m_shifts[1]);
    }
    const int multiple = checked_multiple(std::round(product(u, v) / product(u, u)),
                                          "the cell is too thin to be filled with ghosts");
    if (multiple == 0) {
      return;
    }
    const Shift before = m_shifts[1];
    for (std::size_t i = 0; i != 2; ++i) {
      m_shifts[1][i] = checked_multiple(double(before[i]) - double(multiple) * m_shifts[0][i],
                                        "the cell is too thin to be filled with ghosts");
    }
    const Point longer = v;
    v = m_cell.translation(m_shifts[1]);
    if (!(length(v) < length(longer))) { // a tie, in which rounding would go on for ever
      v = longer;
      m_shifts[1] = before;
      return;
    }
  }
}

Point Lattice_window::coordinates(const Point& p) const
{
  const Point from_corner{p.x - m_cell.corner.x, p.y - m_cell.corner.y};
  const double whole = area(m_vectors[0], m_vectors[1]);
  return {area(from_corner, m_vectors[1]) / whole, area(m_vectors[0], from_corner) / whole};
}

double Lattice_window::across(const Point& p) const
{
  return area(m_vectors[0], p) / length(m_vectors[0]);
}

bool Lattice_window::contains(const Point& p) const
{
  constexpr double rounding = 1e-9; // rather too many than none
  const auto is_inside = [](double c) { return c >= -rounding && c <= 1.0 + rounding; };
  const Point place = coordinates(p);
  return is_inside(place.x) && (is_slab() || is_inside(place.y));
}

double Lattice_window::overhang(const Point& center, double radius) const
{
  const Point place = coordinates(center);
  const auto beyond = [&](double c, double height) {
    return radius - height * (std::min)(c, 1.0 - c);
  };
  const double along = beyond(place.x, m_heights[0]);
  return is_slab() ? along : (std::max)(along, beyond(place.y, m_heights[1]));
}

double Lattice_window::safe_margin() const
{
  return is_slab() ? length(m_vectors[0]) : length(m_vectors[0]) + length(m_vectors[1]);
}

std::vector<Image> Lattice_window::images(const std::vector<Point>& points, double margin) const
{
  constexpr double rounding = 1e-9;
  const double beyond_x = margin / m_heights[0] + rounding;
  const double beyond_y = is_slab() ? 0.0 : margin / m_heights[1] + rounding;
  const auto first = [](double c, double beyond) {
    return checked_multiple(std::ceil(-beyond - c), "a point is too far from the cell");
  };
  const auto last = [](double c, double beyond) {
    return checked_multiple(std::floor(1.0 + beyond - c), "a point is too far from the cell");
  };
  std::vector<Image> images;
  for (std::size_t place = 0; place != points.size(); ++place) {
    const Point& point = points[place];
    const Point c = coordinates(point);
    const int low_y = is_slab() ? 0 : first(c.y, beyond_y);
    const int high_y = is_slab() ? 0 : last(c.y, beyond_y);
    for (int i = first(c.x, beyond_x); i <= last(c.x, beyond_x); ++i) {
      for (int j = low_y; j <= high_y; ++j) {
        const Shift shift{i * m_shifts[0][0] + j * m_shifts[1][0],
                          i * m_shifts[0][1] + j * m_shifts[1][1]};
        images.push_back({static_cast<std::uint32_t>(place), shift, m_cell.image(point, shift)});
      }
    }
  }
  return images;
}

} // namespace run
