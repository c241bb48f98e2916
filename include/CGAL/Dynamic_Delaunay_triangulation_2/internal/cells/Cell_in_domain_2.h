// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_IN_DOMAIN_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_IN_DOMAIN_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Bounded_cell_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Polygonal_domain_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/enum.h>
#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The intersection of a domain with a bounded cell, which is convex.
//
// The triangles of the domain that the cell reaches are found from the triangle of its point on,
// through edges that cross the cell. The part of the cell in a triangle, cut as by any convex
// polygon, is a *portion*. Portions meet at diagonals of the domain. So boundaries are traced from
// piece to piece around a portion, and through a diagonal to the portion beyond; no general
// clipping is needed. If only what the point sees counts, a portion that it sees through other
// triangles is also cut by the outermost rays that pass all edges in between (as in CGAL's
// Triangular_expansion_visibility_2). Exact predicates choose these rays.
class Cell_in_domain_2
{
  using Domain = Polygonal_domain_2;
  using Face_handle = Domain::Face_handle;
  using Vertex_handle = Domain::Vertex_handle;
  static constexpr std::size_t none = std::size_t(-1);

public:
  enum class Kind { CELL, WALL, SIGHT, ARC, DIAGONAL };

  // A piece of the boundary: of a side of the cell or a wall, which have numbers, of a line of
  // sight, of a diagonal, or an arc. Segments are given by lines and intervals of Bounded_cell_2.
  struct Piece
  {
    Kind kind;
    std::size_t number;
    Position_2 normal;
    double distance, first, last;
    Position_2 from, to; // of an arc
    double angle;
    std::size_t portion;
    std::size_t door = 0; // the piece before the next one: this piece, or a diagonal's twin
    double end = 0;       // of a diagonal, where the piece after the twin begins
    bool is_used = false;
  };

  explicit Cell_in_domain_2(const Domain& domain)
    : m_domain(domain)
  {
  }

  // Begins with a cell relative to p, which is its point or the center of the domain; its point is
  // in the closed `face`. The cell must stay until the next start(). False if all of it is in the
  // domain.
  bool start(const Position_2& p, Face_handle face, const Bounded_cell_2& cell)
  {
    m_p = p;
    m_cell = &cell;
    m_portion_of_face.resize(m_domain.number_of_faces(), none);
    m_portions.clear();
    if (m_domain.is_infinite(face))
      face = reached_face(face);
    if (face == Face_handle())
      return true;
    bool meets_wall = false;
    flood(face, [&](Face_handle here, int i) {
      meets_wall = meets_wall || is_wall(here, i);
      return !is_wall(here, i);
    });
    return meets_wall || !face->info().is_inside;
  }
  // After start() there are the portions that are connected with p. Then one of these two functions
  // may be called, take_visible() only if p is in the domain.
  void take_all()
  {
    if (!m_portions.empty())
      flood(m_portions.front().face, [](Face_handle, int) { return true; });
  }
  void take_visible()
  {
    const Face_handle face = m_portions.front().face;
    m_portions.clear();
    add_portions_at(face);
    const std::size_t starts = m_portions.size();
    for (std::size_t i = 0; i < starts; ++i)
      look_around(i, starts);
    for (std::size_t i = starts; i < m_portions.size(); ++i)
      look_further(i);
  }

  // Calls f(area, pieces) for each closed line of pieces: for each component its outer boundary,
  // and then its holes, whose areas are negative.
  template <class Function>
  void for_each_ring(const Function& f)
  {
    m_pieces.clear();
    for (std::size_t i = 0; i < m_portions.size(); ++i)
      cut_portion(i);
    match_diagonals();
    m_rings.clear();
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (m_pieces[i].kind != Kind::DIAGONAL && !m_pieces[i].is_used)
        trace_ring(i);
    std::sort(m_rings.begin(), m_rings.end(), [](const Ring& r, const Ring& s) {
      return std::make_tuple(r.component, r.area < 0, r.first) <
             std::make_tuple(s.component, s.area < 0, s.first);
    });
    for (const Ring& ring : m_rings) {
      m_ring.clear();
      append_ring(ring.first);
      f(ring.area, m_ring);
    }
  }

private:
  // Widths below this share of the distance from the point may be due to rounding.
  static constexpr double narrow = 0x1p-48;
  // The labels of a portion's sides that are not sides of the cell.
  static constexpr std::size_t first_edge = none - 4, ray = none - 1;

  // A triangle, or the part of it that is seen between the rays to `right` and `left`, if any.
  struct Portion
  {
    Face_handle face;
    Vertex_handle right, left;
    int entry;                                              // the edge where rays come in
    std::array<std::size_t, 3> beyond{none, none, none};    // the portion beyond each diagonal
    std::array<std::size_t, 3> diagonals{none, none, none}; // their pieces
    std::size_t first_piece = 0, beyond_pieces = 0;
    std::size_t component = 0;
  };

  struct Ring
  {
    std::size_t first, component;
    double area;
  };

  static int ccw(int i) { return Domain::Triangulation::ccw(i); }
  static int cw(int i) { return Domain::Triangulation::cw(i); }
  static bool is_wall(Face_handle face, int i)
  {
    return face->info().walls[std::size_t(i)] != none;
  }
  Orientation turn(Vertex_handle v, Vertex_handle w) const
  {
    return orientation(Domain::Point(m_p.x, m_p.y), v->point(), w->point());
  }

  static bool is_narrow(double h, double first, double last)
  {
    return last - first <= narrow * (std::abs(h) + std::abs(first) + std::abs(last));
  }

  // Whether a part of edge i, wider than rounding, is in the cell.
  bool crosses(Face_handle face, int i) const
  {
    const Position_2& n = face->info().normals[std::size_t(i)];
    const auto place = [&](Vertex_handle v) {
      const Position_2 way = Domain::corner(v) - m_p;
      return n.x * way.y - n.y * way.x;
    };
    const double h = Domain::distance(m_p, face, i);
    const auto part =
        m_cell->part_of_line(n, h, place(face->vertex(ccw(i))), place(face->vertex(cw(i))));
    return !is_narrow(h, part.first, part.last);
  }

  // FINDING PORTIONS ------------------------------------------------------------------------------

  // Returns a face at the convex hull of the domain that the cell of a point outside of the hull
  // reaches, or none. All other faces that it reaches are found from there.
  Face_handle reached_face(Face_handle infinite) const
  {
    Face_handle around = infinite;
    do {
      const int i = around->index(m_domain.infinite_vertex());
      const Face_handle face = around->neighbor(i);
      if (crosses(face, face->index(around)))
        return face;
      around = around->neighbor(ccw(i));
    } while (around != infinite);
    return Face_handle();
  }

  // Finds the portions behind all edges that cross the cell and that may be passed.
  template <class Predicate>
  void flood(Face_handle start, const Predicate& may_pass)
  {
    m_portions.clear();
    add_portion(start);
    m_portion_of_face[start->info().number] = 0;
    for (std::size_t i = 0; i < m_portions.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Face_handle face = m_portions[i].face, next = face->neighbor(k);
        if (m_portions[i].beyond[std::size_t(k)] != none || !crosses(face, k) ||
            !may_pass(face, k) || m_domain.is_infinite(next))
          continue;
        std::size_t& portion = m_portion_of_face[next->info().number];
        if (portion == none)
          portion = add_portion(next);
        if (!is_wall(face, k))
          link(i, k, portion);
      }
    for (const Portion& portion : m_portions)
      m_portion_of_face[portion.face->info().number] = none;
  }

  std::size_t add_portion(Face_handle face)
  {
    Portion portion{};
    portion.face = face;
    portion.component = m_portions.size();
    m_portions.push_back(portion);
    return m_portions.size() - 1;
  }

  void link(std::size_t i, int k, std::size_t j)
  {
    m_portions[i].beyond[std::size_t(k)] = j;
    m_portions[j].beyond[std::size_t(m_portions[j].face->index(m_portions[i].face))] = i;
    const std::size_t components[]{component(i), component(j)};
    m_portions[(std::max)(components[0], components[1])].component =
        (std::min)(components[0], components[1]);
  }
  std::size_t component(std::size_t i) const
  {
    while (m_portions[i].component != i)
      i = m_portions[i].component;
    return i;
  }

  // Adds the faces inside of the domain that contain p, of which `face` is one. There are several
  // if p is on an edge, or in a corner.
  void add_portions_at(Face_handle face)
  {
    int on = 0, edge = 0, off = 0;
    for (int i = 0; i < 3; ++i)
      if (turn(face->vertex(ccw(i)), face->vertex(cw(i))) == COLLINEAR) {
        ++on;
        edge = i;
      } else
        off = i;
    if (on == 2) { // in the corner between these edges
      auto around = face->vertex(off)->face();
      const auto first = around;
      do {
        if (around->info().is_inside)
          add_portion(around);
        around = around->neighbor(ccw(around->index(face->vertex(off))));
      } while (around != first);
      return;
    }
    add_portion(face);
    if (on == 1 && face->neighbor(edge)->info().is_inside)
      add_portion(face->neighbor(edge));
  }

  // Looks from p through the edges of portion i, which contains p, as do all below `starts`.
  void look_around(std::size_t i, std::size_t starts)
  {
    for (int k = 0; k < 3; ++k) {
      const Face_handle face = m_portions[i].face;
      const Vertex_handle right = face->vertex(ccw(k)), left = face->vertex(cw(k));
      if (is_wall(face, k))
        continue;
      if (turn(right, left) == LEFT_TURN)
        look_through(i, k, right, left);
      else
        for (std::size_t j = 0; j < starts; ++j)
          if (m_portions[j].face == face->neighbor(k))
            link(i, k, j);
    }
  }

  // Looks through both edges other than the entry. They meet in `middle`, the left end of the right
  // edge and the right end of the left one.
  void look_further(std::size_t i)
  {
    const Portion portion = m_portions[i];
    const Vertex_handle middle = portion.face->vertex(portion.entry);
    const bool is_left_of_right = turn(portion.right, middle) == LEFT_TURN;
    const bool is_right_of_left = turn(portion.left, middle) == RIGHT_TURN;
    if (is_left_of_right)
      look_through(i, ccw(portion.entry), portion.right, is_right_of_left ? middle : portion.left);
    if (is_right_of_left)
      look_through(i, cw(portion.entry), is_left_of_right ? middle : portion.right, portion.left);
  }

  void look_through(std::size_t i, int k, Vertex_handle right, Vertex_handle left)
  {
    const Face_handle face = m_portions[i].face;
    if (is_wall(face, k) || !crosses(face, k))
      return;
    const std::size_t next = add_portion(face->neighbor(k));
    m_portions[next].right = right;
    m_portions[next].left = left;
    m_portions[next].entry = face->neighbor(k)->index(face);
    link(i, k, next);
  }

  // CUTTING PORTIONS ------------------------------------------------------------------------------

  void cut_portion(std::size_t i)
  {
    Portion& portion = m_portions[i];
    portion.first_piece = m_pieces.size();
    if (portion.face->info().is_inside) {
      m_polygon.start(*m_cell);
      for (int k = 0; k < 3; ++k)
        m_polygon.cut(portion.face->info().normals[std::size_t(k)],
                      Domain::distance(m_p, portion.face, k), first_edge + std::size_t(k));
      if (portion.right != Vertex_handle()) {
        cut_by_ray(portion.face, portion.right, RIGHT_TURN);
        cut_by_ray(portion.face, portion.left, LEFT_TURN);
      }
      append_pieces(i);
    }
    portion.beyond_pieces = m_pieces.size();
  }

  // Cuts off what is on one side of the ray through v, if a corner of the triangle is there. So a
  // wall on the ray, which is seen edge-on, stays a wall.
  void cut_by_ray(Face_handle face, Vertex_handle v, Orientation side)
  {
    bool is_beyond = false;
    for (int k = 0; k < 3; ++k)
      is_beyond = is_beyond || turn(v, face->vertex(k)) == side;
    if (!is_beyond)
      return;
    m_polygon.cut(normal_of_ray(v, side), 0, ray);
  }
  // Returns the normal that points to the side that is cut off.
  Position_2 normal_of_ray(Vertex_handle v, Orientation side) const
  {
    const Position_2 way = Domain::corner(v) - m_p;
    const double length = (side == RIGHT_TURN ? 1 : -1) * std::hypot(way.x, way.y);
    return {way.y / length, -way.x / length};
  }

  void append_pieces(std::size_t i)
  {
    Portion& portion = m_portions[i];
    m_polygon.for_each_piece(
        [&](std::size_t label, const Position_2& normal, double h, double first, double last) {
          Piece piece{Kind::CELL, label, normal, h, first, last, {0, 0}, {0, 0}, 0, i};
          if (label == ray)
            piece.kind = Kind::SIGHT;
          else if (label >= first_edge) {
            const std::size_t edge = label - first_edge;
            const std::size_t wall = portion.face->info().walls[edge];
            piece.kind = wall == none ? Kind::DIAGONAL : Kind::WALL;
            piece.number = wall == none ? edge : wall;
            if (wall == none)
              portion.diagonals[edge] = m_pieces.size();
          }
          m_pieces.push_back(piece);
        },
        [&](const Position_2& from, const Position_2& to, double angle) {
          m_pieces.push_back({Kind::ARC, 0, {0, 0}, 0, 0, 0, from, to, angle, i});
        });
  }

  // Both portions at a diagonal have the same part of it, unless a side of the cell or a wall is
  // about on the diagonal, or the diagonal is seen edge-on. Then the rest, which only one of the
  // portions has, is on that line, and may lead back along an earlier piece.
  void match_diagonals()
  {
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
      Piece& piece = m_pieces[i];
      const std::size_t twin = piece.kind == Kind::DIAGONAL ? twin_of(piece) : none;
      piece.door = twin == none ? i : twin;
      piece.end = twin == none ? piece.last : -m_pieces[twin].last;
    }
    for (Piece& piece : m_pieces)
      if (piece.kind == Kind::DIAGONAL &&
          (!is_narrow(piece.distance, piece.first, piece.end) ||
           !is_narrow(piece.distance, piece.end, piece.first) || &m_pieces[piece.door] == &piece))
        put_on_nearest_line(piece);
  }

  // Names the piece after the nearest line. If the line is no farther than rounding errors, also
  // moves the piece there, so that it can be joined with others.
  void put_on_nearest_line(Piece& piece) const
  {
    const Position_2 from = place(piece, piece.first), to = place(piece, piece.end);
    const Face_handle face = m_portions[piece.portion].face;
    const int edge = int(piece.number);
    Piece nearest = piece;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](Kind kind, std::size_t number, const Position_2& n, double h) {
      const double distance = std::abs(dot(n, from) - h) + std::abs(dot(n, to) - h);
      if (distance >= least)
        return;
      least = distance;
      nearest.kind = kind;
      nearest.number = number;
      nearest.normal = n;
      nearest.distance = h;
    };
    if (turn(face->vertex(ccw(edge)), face->vertex(cw(edge))) == COLLINEAR)
      offer(Kind::SIGHT, ray, piece.normal, piece.distance);
    for (const std::size_t i : {piece.portion, m_pieces[piece.door].portion})
      if (const Portion& portion = m_portions[i]; portion.right != Vertex_handle()) {
        offer(Kind::SIGHT, ray, normal_of_ray(portion.right, RIGHT_TURN), 0);
        offer(Kind::SIGHT, ray, normal_of_ray(portion.left, LEFT_TURN), 0);
      }
    for (const Bounded_cell_2::Side& side : m_cell->sides())
      if (side.label != Bounded_cell_2::no_label)
        offer(Kind::CELL, side.label, side.normal, side.distance);
    const Face_handle beyond = face->neighbor(edge);
    for (int k = 0; k < 3; ++k)
      if (is_wall(beyond, k))
        offer(Kind::WALL, beyond->info().walls[std::size_t(k)],
              beyond->info().normals[std::size_t(k)], Domain::distance(m_p, beyond, k));
    const double reach = std::abs(piece.distance) + std::abs(piece.first) + std::abs(piece.end);
    piece.last = piece.end;
    piece.kind = least < std::numeric_limits<double>::infinity() ? nearest.kind : Kind::SIGHT;
    piece.number = nearest.number;
    if (least > 4 * narrow * reach)
      return;
    piece.normal = nearest.normal;
    piece.distance = nearest.distance;
    piece.first = cross(piece.normal, from);
    piece.last = cross(piece.normal, to);
  }
  static Position_2 place(const Piece& piece, double u)
  {
    return {piece.distance * piece.normal.x - u * piece.normal.y,
            piece.distance * piece.normal.y + u * piece.normal.x};
  }

  // TRACING RINGS ---------------------------------------------------------------------------------

  std::size_t next_in_portion(std::size_t i) const
  {
    const Portion& portion = m_portions[m_pieces[i].portion];
    return i + 1 < portion.beyond_pieces ? i + 1 : portion.first_piece;
  }

  // The next piece that is no diagonal. No two pieces have the same next one, so this ends.
  std::size_t next(std::size_t i) const
  {
    do
      i = next_in_portion(m_pieces[i].door);
    while (m_pieces[i].kind == Kind::DIAGONAL);
    return i;
  }
  std::size_t twin_of(const Piece& diagonal) const
  {
    const Portion& portion = m_portions[diagonal.portion];
    const std::size_t j = portion.beyond[diagonal.number];
    return j == none
               ? none
               : m_portions[j].diagonals[std::size_t(m_portions[j].face->index(portion.face))];
  }

  // Adds the ring of this piece, unless it encloses nothing but rounding errors, as where a wall is
  // on a side of the cell.
  void trace_ring(std::size_t first)
  {
    double area = 0, length = 0, reach = 0;
    bool is_point = true;
    std::size_t i = first;
    do {
      Piece& piece = m_pieces[i];
      piece.is_used = true;
      is_point = is_point && is_negligible(piece);
      if (piece.kind == Kind::ARC) {
        area += m_cell->radius() * m_cell->radius() * piece.angle / 2;
        length += m_cell->radius() * piece.angle;
        reach = (std::max)(reach, m_cell->radius());
      } else {
        area += piece.distance * (piece.last - piece.first) / 2;
        length += std::abs(piece.last - piece.first);
        reach = (std::max)(reach, std::abs(piece.distance) +
                                      (std::max)(std::abs(piece.first), std::abs(piece.last)));
      }
      i = next(i);
    } while (i != first);
    if (!is_point && std::abs(area) > narrow * reach * length)
      m_rings.push_back({first, component(m_pieces[first].portion), area});
  }

  static bool is_negligible(const Piece& piece)
  {
    return piece.kind != Kind::ARC && is_narrow(piece.distance, piece.first, piece.last) &&
           is_narrow(piece.distance, piece.last, piece.first);
  }

  static bool are_one(const Piece& piece, const Piece& next)
  {
    return piece.kind == next.kind && piece.number == next.number &&
           piece.normal.x == next.normal.x && piece.normal.y == next.normal.y &&
           piece.distance == next.distance;
  }
  static void join(Piece& piece, const Piece& next)
  {
    piece.last = next.last;
    piece.to = next.to;
    piece.angle += next.angle;
  }

  // Lists the pieces of a ring. Joins pieces that triangles have divided, and leaves out those that
  // are as short as rounding errors.
  void append_ring(std::size_t first)
  {
    std::size_t i = first;
    do {
      const Piece& piece = m_pieces[i];
      if (!m_ring.empty() && are_one(m_ring.back(), piece))
        join(m_ring.back(), piece);
      else if (!is_negligible(piece))
        m_ring.push_back(piece);
      i = next(i);
    } while (i != first);
    if (m_ring.size() > 1 && are_one(m_ring.back(), m_ring.front())) {
      join(m_ring.back(), m_ring.front());
      m_ring.front() = m_ring.back();
      m_ring.pop_back();
    }
  }

  const Domain& m_domain;
  Position_2 m_p{0, 0};
  const Bounded_cell_2* m_cell = nullptr;
  Bounded_cell_2 m_polygon; // of a portion
  std::vector<Portion> m_portions;
  std::vector<std::size_t> m_portion_of_face;
  std::vector<Piece> m_pieces, m_ring;
  std::vector<Ring> m_rings;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_CELL_IN_DOMAIN_2_H
