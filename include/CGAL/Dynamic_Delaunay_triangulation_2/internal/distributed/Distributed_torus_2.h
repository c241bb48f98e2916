// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TORUS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TORUS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_question_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_deformation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_image_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Replaces the outline in a periodic space: points are everywhere, but to a face only those in a
// box around its owned corner, the focus, matter. The box reaches |r| + |t| to each side, where r
// and t are two vectors of the lattice.
//
// For each place there is an image of the focus closer to it than R = (|r| + |t|) / 2: in the
// parallelogram of r and t around that image the place is x r + y t with |x| and |y| at most 1/2,
// and r and t are not parallel. So every open disk of radius R contains an image of the focus.
//
//   - A disk that has the focus p on its boundary, and a radius of R or more, contains the open
//     disk of radius R that touches it in p. The latter lies in the box, and contains an image of
//     p. So if no point in the box is inside of a face's disk, the radius of that disk is less than
//     R, and all of it is in the box.
//   - p is no corner of the hull, and on no edge of it, where p + r, p - r, p + t and p - t are
//     held, and these are in the box: of a line through p each open side has one of them.
template <class Points>
class Distributed_surroundings_2
{
public:
  void gather(Distributed_ranks_2&, const Points& points) { m_reach = points.space().reach(); }

  // A box around all points that matter to a question.
  Box_2 box_for(const Distributed_question_2& question) const
  {
    return Box_2{question.x, question.y, question.x, question.y}.enlarged(m_reach);
  }

  // Points are beyond every line, and no box is without points.
  template <class Point>
  bool is_any_beyond(const Point&, const Point&) const
  {
    return true;
  }
  bool excludes(const Box_2&) const { return false; }
  bool excludes_about(const Box_2&) const { return false; }

private:
  double m_reach = 0;
};

// A flat torus, as a space of distributed points. Ranks hold images of points as points of the
// plane. `Lattice_grid_2` makes images exact, within limits that this class keeps.
//
// Images are numbered by a *basis* of the lattice, two short vectors. The basis is kept while the
// cell is deformed, so that ghosts and zones that ranks have sent each other stay of use. Other
// vectors of the same lattice, which the user may take for the cell, do not change it.
//
// Limits. Let H be the sum of the lengths of the shortest basis at some time. While the kept one is
// deformed by at most a factor of 2 in each direction, and back, since it was the shortest, it is
// no longer than 4 H; and H of any two such times differ by a factor of at most 4. An own image is
// at most one cell of the basis outside of the cell at the origin: no farther from the origin than
// 2 * 4 H. A zone is around disks at own images, whose diameters are less than H, with a margin of
// 8 cells of at most H / 2, and a cell for rounding: when it was made, it reached no farther than
// 13.5 H. Since then it was deformed with the basis by at most a factor of 2, and H was at most
// twice what it is now: the zone reaches no farther than 54 H. So do images in it; images that
// ranks ask for are nearer. The grid has room for 128 H, and images beyond that are in no zone.
template <class Kernel_>
class Distributed_torus_2
{
public:
  using Kernel = Kernel_;
  using Shift = Periodic_shift_2;
  using Image = Distributed_image_2<Shift>;
  template <class Points>
  using Outline = Distributed_surroundings_2<Points>;

  static constexpr bool has_other_images = true;
  static constexpr const char* constructor = "the periodic constructor";
  // The number of vertices, minus edges, plus faces: that of a torus.
  static constexpr std::uint64_t euler_characteristic = 0;

  struct Parameters
  {
    std::array<double, 4> cell;
  };
  static constexpr std::array<char, 24> file_name = checkpoint_name("distributed periodic 1\n");

  Distributed_torus_2()
    : Distributed_torus_2(Periodic_cell_2(1, 1))
  {
  }
  explicit Distributed_torus_2(const Parameters& parameters)
    : Distributed_torus_2(Periodic_cell_2(parameters.cell[0], parameters.cell[1],
                                          parameters.cell[2], parameters.cell[3]))
  {
  }
  // A torus with the vectors of a cell, rounded to the grid. Throws if there is no grid for them.
  explicit Distributed_torus_2(const Periodic_cell_2& given)
    : m_grid(given)
    , m_torus(m_grid.cell())
  {
    set_basis(short_basis(m_torus));
    m_first_basis = m_basis;
    m_reach = (length(m_basis[0]) + length(m_basis[1])) * (1 + 0x1p-40);
  }
  // A torus that keeps the basis of the last one, if it can.
  Distributed_torus_2(const Periodic_cell_2& given, const Distributed_torus_2& last)
    : Distributed_torus_2(given)
  {
    m_number = last.m_number + 1;
    const Distributed_torus_2 with_short_basis = *this;
    if (!keep_basis(last))
      *this = with_short_basis;
  }

  const Periodic_cell_2& cell() const { return m_torus.cell(); }
  Parameters parameters() const { return {{cell().ax(), cell().ay(), cell().bx(), cell().by()}}; }
  // How far from a corner of a face points matter to the face.
  double reach() const { return m_reach; }

  void agree(Distributed_ranks_2& ranks) const
  {
    if (!ranks.is_same(parameters().cell))
      throw Periodic_cell_error_2(cell().ax(), cell().ay(), cell().bx(), cell().by(),
                                  "it must be the same on all ranks");
  }

  template <class Point>
  Position_2 checked(const Point& p, std::size_t place) const
  {
    const Position_2 position = checked_position(p, place, point_at_place);
    const Position_2 m = m_torus.multiples(position);
    if (!(std::abs(m.x) < most_cells && std::abs(m.y) < most_cells && m_grid.has_room(position)))
      throw Periodic_range_error_2(place, position.x, position.y, most_cells, point_at_place);
    return m_grid.rounded(position);
  }

  // The image in the cell of the basis at the origin, up to rounding.
  Image first_image(const Position_2& given) const
  {
    const Position_2 m = multiples(given);
    return image(given, -std::floor(m.x), -std::floor(m.y));
  }
  // The image nearest to where the point was, unless that is about a cell or more outside of the
  // cell at the origin: then `first_image()`.
  Image next_image(const Position_2& given, const Position_2& before,
                   const Distributed_torus_2& last) const
  {
    const Position_2 m = multiples(given), then = last.multiples(before);
    const double i = nearest_integer(then.x - m.x), j = nearest_integer(then.y - m.y);
    const auto is_near = [](double t) { return t >= -0.9 && t <= 1.9; };
    return is_near(m.x + i) && is_near(m.y + j) ? image(given, i, j) : first_image(given);
  }
  Position_2 given(const Image& image) const
  {
    return m_grid.sum({image.x, image.y}, -std::int64_t(image[0]), -std::int64_t(image[1]));
  }

  Position_2 vector(const Shift& shift) const
  {
    const auto [i, j] = in_cells(shift[0], shift[1]);
    return m_grid.sum({0, 0}, i, j);
  }
  Image translated(const Image& image, const Shift& shift) const
  {
    const auto [i, j] = in_cells(shift[0], shift[1]);
    const Position_2 v = m_grid.sum({0, 0}, i, j);
    return {{image[0] + int(i), image[1] + int(j)}, image.x + v.x, image.y + v.y};
  }
  bool is_none(const Shift& shift) const { return shift[0] == 0 && shift[1] == 0; }
  static Shift difference(const Shift& s, const Shift& t) { return {s[0] - t[0], s[1] - t[1]}; }
  template <class Shifts, class Function>
  static void show(const Shifts& shifts, const Function& f)
  {
    f(shifts);
  }

  // The vectors from places in `from` to places in `to` form a box. Written in multiples of the
  // basis, its corners enclose the shifts.
  template <class Function>
  void for_each_shift(const Box_2& from, const Box_2& to, const Function& f) const
  {
    if (from.is_empty() || to.is_empty())
      return;
    Box_2 around;
    for (const double x : {to.x_low - from.x_high, to.x_high - from.x_low})
      for (const double y : {to.y_low - from.y_high, to.y_high - from.y_low})
        around.add(multiples({x, y}));
    const double most = (std::max)({-around.x_low, around.x_high, -around.y_low, around.y_high});
    around = around.enlarged(0x1p-20 + 0x1p-30 * most); // for rounding
    for (double i = std::ceil(around.x_low); i <= around.x_high; ++i)
      for (double j = std::ceil(around.y_low); j <= around.y_high; ++j) {
        const Shift shift{int(i), int(j)};
        if (from.moved(vector(shift)).meets(to))
          f(shift);
      }
  }

  // The vectors that are deformed with the cell.
  const Basis_2& basis() const { return m_basis; }
  static constexpr double finest_zone = 0x1p-24;

  bool continues(const Distributed_torus_2& last) const { return m_number == last.m_number; }

private:
  static constexpr double most_cells = 0x1p16; // from the origin to a point

  static double length(const Position_2& v) { return std::hypot(v.x, v.y); }

  // Sets the basis to vectors given as multiples of the cell's vectors.
  void set_basis(const std::array<Shift, 2>& basis)
  {
    m_in_cells = basis;
    m_basis = {vector({1, 0}), vector({0, 1})};
    const double d = m_basis[0].x * m_basis[1].y - m_basis[0].y * m_basis[1].x;
    m_inverse_x = {m_basis[1].y / d, -m_basis[1].x / d};
    m_inverse_y = {-m_basis[0].y / d, m_basis[0].x / d};
  }

  // Takes the basis of the last space, deformed with the cell. False if it is deformed too much.
  bool keep_basis(const Distributed_torus_2& last)
  {
    const auto [a, b] = multiples_in_new_cell(last.m_torus, m_torus);
    std::array<Shift, 2> basis;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::int64_t m = last.m_in_cells[k][0], n = last.m_in_cells[k][1];
      const std::int64_t i = m * a[0] + n * b[0], j = m * a[1] + n * b[1];
      const Position_2 about = m_torus.vector({double(i), double(j)});
      if (!(double(std::abs(i)) < max_shift && double(std::abs(j)) < max_shift &&
            length(about) < 8 * m_reach))
        return false;
      basis[k] = {int(i), int(j)};
    }
    set_basis(basis);
    m_first_basis = last.m_first_basis;
    m_number = last.m_number;
    return Distributed_deformation_2(m_first_basis, m_basis).sum_of_squares() <= 4 &&
           Distributed_deformation_2(m_basis, m_first_basis).sum_of_squares() <= 4;
  }

  // A vector in multiples of the basis, rounded.
  Position_2 multiples(const Position_2& v) const
  {
    return {v.x * m_inverse_x.x + v.y * m_inverse_x.y, v.x * m_inverse_y.x + v.y * m_inverse_y.y};
  }

  // A shift, given in multiples of the basis, in multiples of the cell's vectors.
  std::array<std::int64_t, 2> in_cells(std::int64_t i, std::int64_t j) const
  {
    return {i * m_in_cells[0][0] + j * m_in_cells[1][0],
            i * m_in_cells[0][1] + j * m_in_cells[1][1]};
  }

  Image image(const Position_2& given, double i, double j) const
  {
    const auto [k, l] = in_cells(std::int64_t(i), std::int64_t(j));
    const Position_2 p = m_grid.sum(given, k, l);
    return {{int(k), int(l)}, p.x, p.y};
  }

  Lattice_grid_2 m_grid;
  Torus_2 m_torus;
  std::array<Shift, 2> m_in_cells; // the basis in multiples of the cell's vectors
  Basis_2 m_basis, m_first_basis;  // now, and when it was the shortest one
  Position_2 m_inverse_x, m_inverse_y;
  double m_reach;
  std::uint64_t m_number = 0; // how often the basis was replaced since the points were given
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TORUS_2_H
