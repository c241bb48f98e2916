// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points come, go and move, by ids of the triangulation or of its user: after each change the
// triangulation is that of CGAL.

#include "plain_oracle.h"

#include <CGAL/Dynamic_population_2.h>

#include <iterator>

using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Population = CGAL::Dynamic_population_2<Dynamic, long>;

std::size_t any_id(const Points_by_id& points, CGAL::Random& random)
{
  return std::next(points.begin(), random.get_int(0, int(points.size())))->first;
}

void single_points_come_go_and_move()
{
  CGAL::Random random(1);
  Dynamic dt;
  Points_by_id points;
  for (int i = 0; i < 150; ++i) {
    const Point p = random_point(random);
    const std::size_t id = dt.insert(p);
    assert(points.emplace(id, p).second); // it was free
    if (i % 3 == 2) {
      const std::size_t gone = any_id(points, random);
      dt.remove(gone);
      points.erase(gone);
    }
    const std::size_t mover = any_id(points, random);
    points[mover] = random_point(random);
    dt.move(mover, points[mover]);
    assert_exact(dt, points);
  }
  while (!points.empty()) {
    const std::size_t gone = any_id(points, random);
    dt.remove(gone);
    points.erase(gone);
    assert_exact(dt, points);
  }
}

void assert_exact_population(const Population& population, const std::map<long, Point>& people)
{
  Points_by_id points;
  for (const auto& [number, p] : people) {
    assert(population.has(number));
    assert(population.user_id(population.id(number)) == number);
    points.emplace(population.id(number), p);
  }
  assert_exact(population.triangulation(), points);
}

void whole_frames_with_other_people()
{
  CGAL::Random random(2);
  Population population;
  std::map<long, Point> people;
  long next_number = -50;
  for (int frame = 0; frame < 30; ++frame) {
    for (auto person = people.begin(); person != people.end();) {
      Point& p = person->second;
      p = Point(p.x() + 0.05, p.y() + random.get_double(-0.01, 0.01));
      person = p.x() > 1 ? people.erase(person) : std::next(person);
    }
    while (people.size() < 120)
      people.emplace(next_number++, random_point(random));
    population.update(people);
    assert_exact_population(population, people);
  }
}

int main()
{
  single_points_come_go_and_move();
  whole_frames_with_other_people();
  return 0;
}
