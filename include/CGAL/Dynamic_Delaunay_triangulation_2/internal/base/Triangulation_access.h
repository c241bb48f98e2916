// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_TRIANGULATION_ACCESS_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_TRIANGULATION_ACCESS_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>
#include <iosfwd>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What other headers of the package use of the classes of triangulations, and programs do not.
struct Triangulation_access
{
  template <class Dynamic>
  static const auto& state(const Dynamic& dt)
  {
    return dt.state();
  }

  // Throws if a triangulation cannot have so many points.
  template <class Dynamic>
  static void check_number_of_points(const Dynamic&, std::size_t number)
  {
    Dynamic::check_number_of_points(number);
  }

  // A function of a point and its place in a range, which throws if the position is not allowed, in
  // another cell if there is one more argument.
  template <class Dynamic, class... Cell>
  static auto position_check(Dynamic& dt, const Cell&... cell)
  {
    return dt.position_check(cell...);
  }

  // Moves, removes and inserts the points of a population.
  template <class Dynamic, class... Frame>
  static auto update_population(Dynamic& dt, Frame&&... frame)
  {
    return dt.update_population(std::forward<Frame>(frame)...);
  }

  template <class Dynamic, class... Appendix>
  static void write_checkpoint(const Dynamic& dt, std::ostream& out, const Appendix&... appendix)
  {
    dt.write_file(out, appendix...);
  }
  template <class Dynamic, class... Appendix>
  static void read_checkpoint(Dynamic& dt, std::istream& in, const Appendix&... appendix)
  {
    dt.read_file(in, appendix...);
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_TRIANGULATION_ACCESS_H
