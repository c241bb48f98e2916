// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Data of one's own in the faces, kept right by a visitor: each face holds drops of paint, and none
// is lost or made up, whatever happens to the faces.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Indexed_triangulation_data_structure_2.h>

#include <iostream>
#include <random>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Tds = CGAL::Indexed_triangulation_data_structure_2<Kernel, void, long>; // drops in faces

//! [visitor]
// A flip shares the drops of its two faces out between them. The drops of removed faces are spare,
// until faces are created.
class Paint_visitor : public CGAL::Delaunay_update_visitor_base_2
{
public:
  template <class Dynamic>
  void after_flip(const Dynamic&, const typename Dynamic::Edge& e)
  {
    const auto f = e.first, g = f->neighbor(e.second);
    const long drops = f->info() + g->info();
    f->info() = drops / 2;
    g->info() = drops - f->info();
  }

  template <class Dynamic>
  void before_face_removal(const Dynamic&, typename Dynamic::Face_handle f)
  {
    m_spare += std::exchange(f->info(), 0);
  }

  template <class Dynamic>
  void after_face_creation(const Dynamic&, typename Dynamic::Face_handle f)
  {
    f->info() = m_spare / 2;
    m_spare -= f->info();
  }

  template <class Dynamic>
  void after_update(const Dynamic& dt, const CGAL::Update_report_2&)
  {
    dt.infinite_vertex()->face()->info() += std::exchange(m_spare, 0);
  }

  void add_spare(long drops) { m_spare += drops; }

private:
  long m_spare = 0;
};

using Dynamic_triangulation =
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::With_data_structure_2<Tds>,
                                           CGAL::With_visitor_2<Paint_visitor>>;
//! [visitor]

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 20);
  std::normal_distribution<double> step(0, 0.05);
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i)
    points.push_back(Point(coordinate(random), coordinate(random)));

  Dynamic_triangulation dt(points.begin(), points.end());
  dt.visitor().add_spare(1000000); // to be spread when faces come

  for (int frame = 0; frame < 100; ++frame) {
    for (Point& p : points)
      p = Point(p.x() + step(random), p.y() + step(random));
    dt.update(points.begin(), points.end());
    dt.remove(7);
    dt.insert(points[7]); // gets the id that is free
  }

  long drops = 0;
  for (const auto f : dt.triangulation().all_face_handles())
    drops += f->info();
  std::cout << drops << " drops of paint in " << dt.triangulation().number_of_faces() << " faces\n";
  return drops == 1000000 ? 0 : 1;
}
