// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CANONICAL_CELLS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CANONICAL_CELLS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Gives cells numbers that do not depend on how they have been made, and leaves no gaps: they
// follow their smallest vertices, then the second ones, and so on. A pass over them then reads
// positions in order. The infinite vertex comes after all others.
//
// The vertices of a cell begin with the smallest one and the smallest of the others; the
// orientation says in which order the other two follow. In open space two cells with the same first
// three vertices would lie on the same side of a facet: three vertices tell all cells apart. On a
// torus, where a cell may have several sites of a vertex, and cells the same vertices, as among few
// points, sites tell what vertices do not.
template <class Arrays, class Parts>
class Canonical_cells_3
{
  using Cell = typename Arrays::Cell;
  template <class Index_of_kind, class T>
  using Uninitialized_column =
      Dynamic_Delaunay_triangulations_2::internal::Uninitialized_column<Index_of_kind, T>;
  template <class T>
  using Uninitialized_vector = Dynamic_Delaunay_triangulations_2::internal::Uninitialized_vector<T>;

public:
  explicit Canonical_cells_3(Arrays& arrays)
    : m_arrays(arrays)
  {
  }

  // Renumbers the cells, and drops free ones. Once for an object.
  void order()
  {
    find_smallest();
    count();
    m_cells.resize(m_first.back());
    m_turned.resize(m_arrays.number_of_cells());
    m_corners.assign(m_arrays.number_of_vertices(), Corner_index(null_index));
    const std::size_t vertices = m_first.size() - 1;
    m_late.resize(Parts::number(vertices, Parts::size_for(32)));
    Parts::for_each(vertices, Parts::size_for(32),
                    [&](std::size_t part, std::size_t first, std::size_t beyond) {
                      std::vector<Key> keys;
                      for (std::size_t rank = first; rank < beyond; ++rank)
                        order_cells_of(rank, keys, m_late[part]);
                    });
    for (const std::vector<Corner_index>& corners : m_late)
      for (const Corner_index k : corners)
        if (Corner_index& corner = m_corners[vertex(k)]; k < corner)
          corner = k;
    const bool has_end = m_arrays.corner_of(infinite_index) != null_index;
    Parts::for_each_element(m_cells.size(), Parts::size_for(8), [&](std::size_t i) {
      Cell& cell = m_cells[Cell_index(i)];
      for (int place = 0; place < 4; ++place) {
        const Corner_index old = cell.mirrors[place];
        cell.mirrors[place] = turned(old);
        if constexpr (Cell::may_repeat_vertices)
          if (has_end && m_arrays.vertex(old) == infinite_index) // stays when its chart is moved
            cell.beyond[place] = cell.beyond[place] + m_arrays.site(first_corner(old)).shift;
      }
    });
    m_arrays.replace_all(m_cells, m_corners);
  }

private:
  static constexpr std::size_t ahead = 24, most_counted = 24;
  using Places = Few<std::uint8_t, 4>;

  // The second and third vertex of a cell, its old number, and where its vertices go.
  struct Key
  {
    std::uint64_t vertices;
    Cell_index cell;
    Places places;    // old ones, in the new order
    Index number = 0; // among the cells with the same smallest vertex
  };

  // Of finite vertices from 0 on, in the order of their numbers.
  static Index rank(Vertex_index v) { return Index(v) - 1; }
  static_assert(infinite_index == 0, "so its rank is the largest of all");

  void find_smallest()
  {
    m_smallest.resize(m_arrays.number_of_cells());
    Parts::for_each_element(m_smallest.size(), [&](std::size_t i) {
      const Cell_index c(i);
      Index smallest = null_index;
      if (!m_arrays.is_free(c))
        for (const Vertex_index v : m_arrays.vertices(c))
          smallest = (std::min)(smallest, rank(v));
      m_smallest[c] = smallest;
    });
  }

  // Lists the cells by their smallest vertices.
  void count()
  {
    m_first.assign(m_arrays.number_of_vertices(), 0); // one more than finite ones
    for (Cell_index c(0); c < m_smallest.size(); ++c)
      if (m_smallest[c] != null_index)
        ++m_first[m_smallest[c] + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<Index> next(m_first);
    m_list.resize(m_first.back());
    for (Cell_index c(0); c < m_smallest.size(); ++c)
      if (m_smallest[c] != null_index)
        m_list[next[m_smallest[c]]++] = Index(c);
  }

  // Writes the cells whose smallest vertex has a rank. `late` gets the corners of vertices that
  // are the smallest of no cell.
  void order_cells_of(std::size_t rank_of_smallest, std::vector<Key>& keys,
                      std::vector<Corner_index>& late)
  {
    const Index first = m_first[rank_of_smallest], beyond = m_first[rank_of_smallest + 1];
    if (first == beyond)
      return;
    keys.clear();
    for (Index i = first; i < beyond; ++i) {
      if (i + ahead < m_list.size())
        m_arrays.prefetch(Cell_index(m_list[i + ahead]));
      keys.push_back(key_of(Cell_index(m_list[i]), Index(rank_of_smallest)));
    }
    m_corners[Vertex_index(rank_of_smallest + 1)] = Arrays::corner(Cell_index(first), 0);
    find_numbers(keys);
    for (const Key& key : keys)
      write(Cell_index(first + key.number), key, late);
  }

  // Branches for cells with the same three vertices alone, which are rare: others would be
  // mispredicted.
  bool precedes(const Key& a, const Key& b) const
  {
    if constexpr (Cell::may_repeat_vertices)
      if (a.vertices == b.vertices)
        return sites(a) < sites(b);
    return a.vertices < b.vertices;
  }
  auto sites(const Key& key) const { return m_arrays.cell(key.cell).turned(key.places).sites(); }

  void find_numbers(std::vector<Key>& keys) const
  {
    if (keys.size() > most_counted) {
      std::sort(keys.begin(), keys.end(),
                [this](const Key& a, const Key& b) { return precedes(a, b); });
      for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i].number = Index(i);
      return;
    }
    // to count the smaller ones of a few takes no branches, which would be mispredicted
    for (std::size_t i = 0; i < keys.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const bool is_smaller = precedes(keys[j], keys[i]);
        keys[i].number += Index(is_smaller);
        keys[j].number += Index(!is_smaller);
      }
  }

  Key key_of(Cell_index c, Index smallest) const
  {
    Few<Index, 4> ranks;
    for (int i = 0; i < 4; ++i)
      ranks[i] = rank(m_arrays.vertices(c)[i]);
    if constexpr (Cell::may_repeat_vertices)
      if (are_repeated(ranks))
        return key_of_repeating(c, ranks);
    const int at =
        int(ranks[1] == smallest) + 2 * int(ranks[2] == smallest) + 3 * int(ranks[3] == smallest);
    const auto& o = other_places[at];
    const Index a = ranks[o[0]], b = ranks[o[1]], d = ranks[o[2]];
    return key(c, ranks, at, int(b < a) * int(b < d) + 2 * int(d < a) * int(d < b));
  }
  static bool are_repeated(const Few<Index, 4>& r)
  {
    return (int(r[0] == r[1]) | int(r[0] == r[2]) | int(r[0] == r[3]) | int(r[1] == r[2]) |
            int(r[1] == r[3]) | int(r[2] == r[3])) != 0;
  }
  // Of a cell with several sites of a vertex: the first one of all keys.
  Key key_of_repeating(Cell_index c, const Few<Index, 4>& ranks) const
  {
    const Index smallest = *std::min_element(ranks.begin(), ranks.end());
    std::optional<Key> first;
    for (int at = 0; at < 4; ++at)
      for (int turn = 0; turn < 3 && ranks[at] == smallest; ++turn)
        if (const Key other = key(c, ranks, at, turn); !first || precedes(other, *first))
          first = other;
    return *first;
  }
  static Key key(Cell_index c, const Few<Index, 4>& ranks, int at, int turn)
  {
    const auto& o = other_places[at];
    const std::uint8_t second = o[turn], third = o[(turn + 1) % 3], fourth = o[(turn + 2) % 3];
    return {(std::uint64_t(ranks[second]) << 32) | ranks[third],
            c,
            {std::uint8_t(at), second, third, fourth},
            0};
  }

  void write(Cell_index number, const Key& key, std::vector<Corner_index>& late)
  {
    const Cell& cell = m_cells[number] = m_arrays.cell(key.cell).turned(key.places);
    std::uint64_t places = 0; // new ones, in the old order
    for (int i = 0; i < 4; ++i) {
      const Vertex_index v = cell.vertices[i];
      places |= std::uint64_t(i) << (2 * key.places[i]);
      if (i > 0 && (v == infinite_index || m_first[rank(v)] == m_first[Index(v)]))
        late.push_back(Arrays::corner(number, i));
    }
    m_turned[key.cell] = (std::uint64_t(number) << 8) | places;
  }

  Corner_index turned(Corner_index k) const
  {
    const std::uint64_t cell = m_turned[Arrays::cell_of(k)];
    return Arrays::corner(Cell_index(cell >> 8), int(cell >> (2 * Arrays::place_of(k))) & 3);
  }

  // The old corner, in the cell of another one, of what comes first now.
  Corner_index first_corner(Corner_index k) const
  {
    int place = 0;
    while (Arrays::place_of(turned(Arrays::corner(Arrays::cell_of(k), place))) != 0)
      ++place;
    return Arrays::corner(Arrays::cell_of(k), place);
  }

  Vertex_index vertex(Corner_index k) const
  {
    return m_cells[Arrays::cell_of(k)].vertices[Arrays::place_of(k)];
  }

  Arrays& m_arrays;
  Uninitialized_column<Cell_index, Index> m_smallest; // ranks; null_index for free cells
  std::vector<Index> m_first;         // by rank, where the cells begin of which it is the smallest
  Uninitialized_vector<Index> m_list; // of cells by their smallest vertices
  // for each old cell its new number, and where its vertices go
  Uninitialized_column<Cell_index, std::uint64_t> m_turned;
  std::vector<std::vector<Corner_index>> m_late;
  typename Arrays::Cells m_cells;
  Column<Vertex_index, Corner_index> m_corners;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CANONICAL_CELLS_3_H
