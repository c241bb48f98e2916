// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Ghost_opponents.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace run {

namespace {

using scenario::Cell;
using scenario::Point;
using scenario::Shift;

// Finds an image by its position.
class Image_finder
{
public:
  explicit Image_finder(std::vector<Image> images)
    : m_images(std::move(images))
  {
    std::sort(m_images.begin(), m_images.end(), [](const Image& a, const Image& b) {
      return std::tie(a.point.x, a.point.y, a.place) < std::tie(b.point.x, b.point.y, b.place);
    });
  }

  const Image& at(const Kernel::Point_2& p) const
  {
    return *std::lower_bound(
        m_images.begin(), m_images.end(), p, [](const Image& image, const Kernel::Point_2& q) {
          return std::pair(image.point.x, image.point.y) < std::pair(q.x(), q.y());
        });
  }

private:
  std::vector<Image> m_images;
};

// Replaces images of coincident points by images of the one that represents them.
class Representation
{
public:
  Representation(const std::vector<Point>& points, const Cell& cell,
                 const std::vector<std::uint32_t>& representatives)
    : m_points(points)
    , m_cell(cell)
    , m_representatives(representatives)
  {
  }

  std::pair<std::uint32_t, Shift> of(const Image& image) const
  {
    const std::uint32_t other = m_representatives[image.place];
    if (other == image.place) {
      return {other, image.shift};
    }
    const Shift apart = shift_between(m_points[other], m_points[image.place]);
    return {other, {image.shift[0] + apart[0], image.shift[1] + apart[1]}};
  }

private:
  // The shift between two points that coincide up to a translation.
  Shift shift_between(const Point& p, const Point& q) const
  {
    const double x = q.x - p.x, y = q.y - p.y;
    const auto& [a, b] = m_cell.sides;
    if (m_cell.is_slab()) {
      const Point& u = m_cell.period();
      const int shift =
          static_cast<int>(std::lround((x * u.x + y * u.y) / (u.x * u.x + u.y * u.y)));
      return m_cell.is_periodic[0] ? Shift{shift, 0} : Shift{0, shift};
    }
    return {static_cast<int>(std::lround((x * b.y - y * b.x) / m_cell.area())),
            static_cast<int>(std::lround((a.x * y - a.y * x) / m_cell.area()))};
  }

  const std::vector<Point>& m_points;
  const Cell& m_cell;
  const std::vector<std::uint32_t>& m_representatives;
};

// The range of coordinates across a slab that its points have.
struct Height_range
{
  double low;
  double high;

  // Half of the width of a circle between these heights.
  double reach(double center, double radius) const
  {
    const double beyond = (std::max)({0.0, low - center, center - high});
    return std::sqrt((std::max)(0.0, (radius - beyond) * (radius + beyond)));
  }
};

// The height range of the points; infinite for a torus.
Height_range height_range(const Lattice_window& window, const std::vector<Point>& points)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!window.is_slab()) {
    return {-infinity, infinity};
  }
  Height_range range{infinity, -infinity};
  for (const Point& point : points) {
    const double height = window.across(point);
    range = {(std::min)(range.low, height), (std::max)(range.high, height)};
  }
  return range;
}

} // namespace

void Ghost_opponents::prepare(const std::vector<Point>& points, const Cell& cell)
{
  constexpr double spare = 1.25;
  m_points = points;
  m_cell = cell;
  m_window.emplace(cell);
  m_margin = m_largest ? (std::min)(spare * *m_largest, m_window->safe_margin()) : first_margin();
  m_images = m_window->images(points, m_margin);
  std::vector<Point> images;
  for (const Image& image : m_images) {
    images.push_back(image.point);
  }
  // ghosts come and go, so that the order is that of this frame
  m_static.prepare(images, true);
}

// Enough for random points. For thin cells the safe margin would be much wider.
double Ghost_opponents::first_margin() const
{
  const double safe = m_window->safe_margin();
  if (m_cell->is_slab() || m_points.empty()) {
    return safe;
  }
  constexpr double spacings = 4.0;
  const double spacing = std::sqrt(std::abs(m_cell->area()) / static_cast<double>(m_points.size()));
  return (std::min)(spacings * spacing, safe);
}

double Ghost_opponents::agreement(std::vector<Periodic_face> faces,
                                  const std::vector<std::uint32_t>& representatives)
{
  std::transform(faces.begin(), faces.end(), faces.begin(), normal);
  sort_once(faces);
  const double safe = m_window->safe_margin();
  std::vector<Periodic_face> reference =
      proved_faces(m_static.reference(), m_images, m_margin, representatives);
  double agreement = agreement_of(faces, reference, m_points, *m_cell);
  for (double margin = m_margin;
       agreement != 1.0 && margin < safe && !is_complete(reference, representatives);) {
    margin = (std::min)((std::max)(2.0 * margin, first_margin()), safe);
    reference = faces_with(margin, representatives);
    agreement = agreement_of(faces, reference, m_points, *m_cell);
  }
  return agreement;
}

// True if the number of faces proves that none is missing, which it never does for slabs.
bool Ghost_opponents::is_complete(const std::vector<Periodic_face>& faces,
                                  const std::vector<std::uint32_t>& representatives) const
{
  std::size_t places = 0;
  for (std::size_t place = 0; place != representatives.size(); ++place) {
    places += representatives[place] == place;
  }
  return !m_window->is_slab() && faces.size() == 2 * places;
}

// True for a face of three images of one point of a slab: they are on a line but for rounding.
bool Ghost_opponents::is_rounded_line(const Periodic_face& face) const
{
  const auto& [a, b, c] = face.places;
  return m_window->is_slab() && a == b && b == c;
}

std::vector<Periodic_face>
Ghost_opponents::faces_with(double margin, const std::vector<std::uint32_t>& representatives)
{
  std::vector<Image> images = m_window->images(m_points, margin);
  images.erase(std::remove_if(
                   images.begin(), images.end(),
                   [&](const Image& image) { return representatives[image.place] != image.place; }),
               images.end());
  std::vector<Kernel::Point_2> points;
  for (const Image& image : images) {
    points.emplace_back(image.point.x, image.point.y);
  }
  const Static_triangulation triangulation(points.begin(), points.end());
  return proved_faces(triangulation, std::move(images), margin, representatives);
}

// A face belongs to the periodic triangulation if its circle is in the window with its margin,
// where all images are. One image of each periodic face has its center in the window: it is found
// if the margin is as wide as the radius. With the safe margin of Lattice_window, circles need not
// be examined, which may be too large for doubles.
std::vector<Periodic_face>
Ghost_opponents::proved_faces(const Static_triangulation& triangulation, std::vector<Image> images,
                              double margin, const std::vector<std::uint32_t>& representatives)
{
  const bool is_safe = margin >= m_window->safe_margin();
  const Image_finder finder(std::move(images));
  const Representation representation(m_points, *m_cell, representatives);
  const Height_range heights = height_range(*m_window, m_points);
  std::vector<Periodic_face> faces;
  double largest = 0.0;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    const Kernel::Point_2 dual = triangulation.dual(f);
    const Point center{dual.x(), dual.y()};
    double radius = std::sqrt(CGAL::squared_distance(dual, f->vertex(0)->point()));
    radius = heights.reach(m_window->across(center), radius);
    bool is_proved = m_window->overhang(center, radius) <= margin;
    Periodic_face face{};
    for (std::size_t i = 0; i != 3; ++i) {
      const Image& image = finder.at(f->vertex(static_cast<int>(i))->point());
      std::tie(face.places[i], face.shifts[i]) = representation.of(image);
      is_proved = is_proved || (is_safe && m_window->contains(image.point));
    }
    if (is_proved && !is_rounded_line(face)) {
      faces.push_back(normal(face));
      if (m_window->contains(center)) {
        largest = (std::max)(largest, radius);
      }
    }
  }
  m_largest = largest;
  sort_once(faces);
  return faces;
}

} // namespace run
