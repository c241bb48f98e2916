// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_SURFACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_SURFACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The surface of all bounded Voronoi cells together, as lines: the border of a tissue, of its parts
and of its holes. With one radius and no domain this is the boundary of the union of the discs, and
the cells along it are those of the points on the boundary of the alpha shape.

A line consists of free pieces, each of which begins where the last one ends, with the cells on its
left. It goes from wall to wall, or is *closed*. A closed line around a positive area surrounds a
component of the cells, and one around a negative area a hole. In periodic space a closed line may
wind around the torus instead, and then has no area: a component that winds has such lines, or holes
only. The pieces of a line may be those of different images there, as each piece is around its own
point.

A contact that only one of two cells has, because of rounding, does not count.

\sa `Bounded_voronoi_cells_2`
*/
class Bounded_voronoi_surface_2
{
public:
  /// \name Types
  /// @{

  /// the type of numbers.
  using size_type = std::size_t;
  /// the cells.
  using Cells = Bounded_voronoi_cells_2;

  /// @}
  /// \name Computation
  /// If memory runs out, there are no lines.
  /// @{

  /// finds the lines. Cost: linear; for each end of a free piece, also a search through the pieces
  /// of a neighbor. \pre `cells.has_pieces()`
  void compute(const Cells& cells)
  {
    CGAL_precondition(cells.has_pieces());
    clear();
    try {
      find_steps(cells);
      m_is_taken.assign(cells.pieces().size(), false);
      m_first_pieces.push_back(0);
      for (size_type piece = 0; piece < m_steps.size(); ++piece)
        if (is_free(cells, piece) && !m_has_predecessor[piece])
          add_line(cells, piece);
      for (size_type piece = 0; piece < m_steps.size(); ++piece)
        if (is_free(cells, piece) && !m_is_taken[piece])
          add_line(cells, piece);
    } catch (...) {
      clear();
      throw;
    }
  }

  /// @}
  /// \name Access
  /// @{

  /// the number of lines.
  size_type number_of_lines() const { return m_areas.size(); }
  /// the pieces of all lines, as numbers in `Cells::pieces()`: those of each line are consecutive.
  const std::vector<size_type>& pieces() const { return m_pieces; }
  /// where the pieces of each line begin in `pieces()`; one more entry than there are lines.
  const std::vector<size_type>& first_pieces() const { return m_first_pieces; }
  /// the id of the cell of each entry of `pieces()`.
  const std::vector<size_type>& ids() const { return m_ids; }
  /// the area that each line encloses, negative if it is clockwise; NaN if it is not closed or
  /// winds.
  const std::vector<double>& areas() const { return m_areas; }
  /// the vectors of the periodic cell by which the end of each line is translated against its
  /// beginning: how it winds. 0 in the plane.
  const std::vector<Periodic_shift_2>& windings() const { return m_windings; }
  /// whether a line ends where it begins, or in an image of that place.
  /// \pre `line < number_of_lines()`
  bool is_closed(size_type line) const
  {
    return m_steps[m_pieces[m_first_pieces[line + 1] - 1]].piece != none;
  }

  /// @}

private:
  using Piece = Cells::Piece;
  using Side = Cells::Side;
  static constexpr size_type none = std::size_t(-1);

  // The free piece that follows another one, and the shift of its cell relative to the cell of the
  // other one.
  struct Step
  {
    size_type piece;
    Periodic_shift_2 shift;
  };

  void clear()
  {
    m_steps.clear();
    m_pieces.clear();
    m_first_pieces.clear();
    m_ids.clear();
    m_areas.clear();
    m_windings.clear();
  }

  static bool is_free(const Cells& cells, size_type piece)
  {
    return cells.pieces()[piece].side == Side::FREE;
  }

  size_type next_in_cell(const Cells& cells, size_type piece) const
  {
    const size_type id = m_owners[piece];
    return piece + 1 < cells.first_pieces()[id + 1] ? piece + 1 : cells.first_pieces()[id];
  }

  // Returns the piece of the neighbor on the same contact, or `none`.
  size_type twin(const Cells& cells, size_type piece) const
  {
    const Piece& contact = cells.pieces()[piece];
    const Periodic_shift_2 back{-contact.shift[0], -contact.shift[1]};
    for (size_type i = cells.first_pieces()[contact.other];
         i < cells.first_pieces()[contact.other + 1]; ++i) {
      const Piece& other = cells.pieces()[i];
      if (other.side == Side::NEIGHBOR && other.other == m_owners[piece] && other.shift == back)
        return i;
    }
    return none;
  }

  // Finds the next free piece: turns around the end of this one, through all cells that meet there.
  Step step_from(const Cells& cells, size_type piece) const
  {
    Periodic_shift_2 shift{0, 0};
    size_type next = next_in_cell(cells, piece);
    for (size_type turns = 0; turns < cells.pieces().size(); ++turns) {
      const Piece& contact = cells.pieces()[next];
      if (contact.side == Side::WALL)
        break;
      if (contact.side == Side::FREE)
        return {next, shift};
      const size_type beyond = twin(cells, next);
      if (beyond != none)
        add(shift, contact.shift);
      next = next_in_cell(cells, beyond == none ? next : beyond);
    }
    return {none, {0, 0}};
  }

  static void add(Periodic_shift_2& sum, const Periodic_shift_2& shift)
  {
    sum[0] += shift[0];
    sum[1] += shift[1];
  }

  void find_steps(const Cells& cells)
  {
    const size_type pieces = cells.pieces().size();
    m_owners.resize(pieces);
    for (size_type id = 0; id < cells.areas().size(); ++id)
      for (size_type i = cells.first_pieces()[id]; i < cells.first_pieces()[id + 1]; ++i)
        m_owners[i] = id;
    m_steps.assign(pieces, {none, {0, 0}});
    m_has_predecessor.assign(pieces, false);
    for (size_type piece = 0; piece < pieces; ++piece)
      if (is_free(cells, piece)) {
        m_steps[piece] = step_from(cells, piece);
        if (m_steps[piece].piece != none)
          m_has_predecessor[m_steps[piece].piece] = true;
      }
  }

  // The area is that of the polygon of chords, plus what is between arcs and their chords. Chords
  // are put end to end, since the pieces may be of different images.
  void add_line(const Cells& cells, size_type first)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    double doubled_area = 0;
    Cells::Position end{0, 0};
    Periodic_shift_2 winding{0, 0};
    size_type number = first;
    do {
      const Piece& piece = cells.pieces()[number];
      m_is_taken[number] = true;
      m_pieces.push_back(number);
      m_ids.push_back(m_owners[number]);
      const Cells::Position chord{piece.to.x - piece.from.x, piece.to.y - piece.from.y};
      doubled_area += cross(end, chord) + doubled_area_beyond_chord(cells, number);
      end = {end.x + chord.x, end.y + chord.y};
      add(winding, m_steps[number].shift);
      number = m_steps[number].piece;
    } while (number != none && !m_is_taken[number]);
    m_first_pieces.push_back(m_pieces.size());
    m_windings.push_back(winding);
    const bool encloses = number == first && winding == Periodic_shift_2{0, 0};
    m_areas.push_back(encloses ? doubled_area / 2 : std::numeric_limits<double>::quiet_NaN());
  }

  double doubled_area_beyond_chord(const Cells& cells, size_type number) const
  {
    const double radius = cells.radii()[m_owners[number]], angle = cells.pieces()[number].angle;
    return angle > 0 ? radius * radius * (angle - std::sin(angle)) : 0;
  }

  std::vector<size_type> m_pieces, m_first_pieces, m_ids;
  std::vector<double> m_areas;
  std::vector<Periodic_shift_2> m_windings;
  std::vector<size_type> m_owners; // the ids of the cells of all pieces
  std::vector<Step> m_steps;
  std::vector<bool> m_has_predecessor, m_is_taken;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_SURFACE_2_H
