// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_SURFACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_SURFACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

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
and of its holes. With one radius, that is the boundary of the union of the discs, and the points on
it those of the alpha shape.

A line consists of free pieces, each beginning where the last one ends, with the cells on its left.
A line is *closed*, or goes from wall to wall. In the plane, a closed line that encloses a positive
area surrounds a component of the cells, and one with a negative area a hole. In periodic space a
closed line can wind around the cell, and its area means nothing then.

Contacts of no more than rounding, which one of two cells may have and the other not, do not count.

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

  /// finds the lines. Cost: linear, but that the contacts of a point are searched for each of its
  /// ends of lines.
  void compute(const Cells& cells)
  {
    clear();
    try {
      find_successors(cells);
      m_is_taken.assign(cells.pieces().size(), false);
      m_first_pieces.push_back(0);
      for (size_type piece = 0; piece < m_successors.size(); ++piece)
        if (is_free(cells, piece) && !m_has_predecessor[piece])
          add_line(cells, piece);
      for (size_type piece = 0; piece < m_successors.size(); ++piece)
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
  /// the area that each line encloses, negative if it is clockwise; NaN if it is not closed.
  const std::vector<double>& areas() const { return m_areas; }
  /// whether a line ends where it begins.
  bool is_closed(size_type line) const { return !std::isnan(m_areas[line]); }

  /// @}

private:
  using Piece = Cells::Piece;
  using Side = Cells::Side;
  static constexpr size_type none = std::size_t(-1);

  void clear()
  {
    m_successors.clear();
    m_pieces.clear();
    m_first_pieces.clear();
    m_ids.clear();
    m_areas.clear();
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

  // The same contact as a piece of the neighbor.
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

  // Turns around the end of a free piece, through all cells that meet there.
  size_type successor(const Cells& cells, size_type piece) const
  {
    size_type next = next_in_cell(cells, piece);
    for (size_type turns = 0; turns < cells.pieces().size(); ++turns) {
      if (cells.pieces()[next].side == Side::WALL)
        return none;
      if (is_free(cells, next))
        return next;
      const size_type beyond = twin(cells, next);
      next = next_in_cell(cells, beyond == none ? next : beyond);
    }
    return none;
  }

  void find_successors(const Cells& cells)
  {
    const size_type pieces = cells.pieces().size();
    m_owners.resize(pieces);
    for (size_type id = 0; id < cells.areas().size(); ++id)
      for (size_type i = cells.first_pieces()[id]; i < cells.first_pieces()[id + 1]; ++i)
        m_owners[i] = id;
    m_successors.assign(pieces, none);
    m_has_predecessor.assign(pieces, false);
    for (size_type piece = 0; piece < pieces; ++piece)
      if (is_free(cells, piece)) {
        m_successors[piece] = successor(cells, piece);
        if (m_successors[piece] != none)
          m_has_predecessor[m_successors[piece]] = true;
      }
  }

  void add_line(const Cells& cells, size_type first)
  {
    double doubled_area = 0;
    size_type piece = first;
    do {
      m_is_taken[piece] = true;
      m_pieces.push_back(piece);
      m_ids.push_back(m_owners[piece]);
      doubled_area += doubled_area_at(cells, piece, cells.pieces()[first].from);
      piece = m_successors[piece];
    } while (piece != none && !m_is_taken[piece]);
    m_first_pieces.push_back(m_pieces.size());
    m_areas.push_back(piece == first ? doubled_area / 2 : std::numeric_limits<double>::quiet_NaN());
  }

  // Between a piece and a place: a triangle, and for an arc what is beyond its chord.
  double doubled_area_at(const Cells& cells, size_type number, const Cells::Position& place) const
  {
    const Piece& piece = cells.pieces()[number];
    const double radius = cells.radii()[m_owners[number]];
    const double beyond = piece.angle > 0 ? piece.angle - std::sin(piece.angle) : 0;
    return (piece.from.x - place.x) * (piece.to.y - place.y) -
           (piece.from.y - place.y) * (piece.to.x - place.x) + radius * radius * beyond;
  }

  std::vector<size_type> m_pieces, m_first_pieces, m_ids;
  std::vector<double> m_areas;
  std::vector<size_type> m_owners, m_successors; // of each piece of a cell
  std::vector<bool> m_has_predecessor, m_is_taken;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_BOUNDED_VORONOI_SURFACE_2_H
