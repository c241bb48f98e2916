// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_PARALLEL_INSERTION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_PARALLEL_INSERTION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Spatial_parts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Vertex_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Vertex_order_3.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What threads do in open space.
template <class State, class Region = Everywhere_3>
using Insertion_in_rounds_3 = Vertex_insertion_3<State, Order_of_rounds_3, Region>;

// Inserts lists of vertices into the cells of a state, by threads, each by an insertion in a
// region.
//
// Space is divided into about as many parts as there are threads. Each thread inserts the vertices
// of a part whose cells in conflict have all their vertices there. Those that are left, along the
// borders, are then inserted in parts with other borders, and what is left of them by one thread.
//
// In open space the cells are those of insertion one after the other, in the order of rounds: ties
// are decided so, and of points that coincide the first one gets cells. On a torus no tie depends
// on an order, but of points that coincide any one may get cells. Apart from that, only the numbers
// of cells depend on threads.
template <class State, template <class, class> class Insertion_in_region = Insertion_in_rounds_3>
class Parallel_insertion_3
{
  using Parts = typename State::Exact_parts;
  // By which space is divided.
  struct Coordinates
  {
    Position_3 position(Vertex_index v) const { return state.coordinates_to_cut(v, shift); }
    Index number() const { return state.positions.number(); }

    const State& state;
    Few<double, 3> shift;
  };
  using Division = Spatial_parts_3<Coordinates, Parts>;
  using Arrays = typename State::Arrays;

public:
  using Covered = std::vector<std::pair<Vertex_index, Vertex_index>>;
  // By one thread.
  using Insertion = Insertion_in_region<State, Everywhere_3>;

  Parallel_insertion_3(State& state, Insertion& insertion)
    : m_state(state)
    , m_insertion(insertion)
  {
  }

  // Inserts the vertices of a round. `covered` gets those that coincide with others, in any order,
  // each with the one that has cells. Returns those that cannot be inserted, as happens on a torus
  // alone.
  std::vector<Vertex_index> insert(std::vector<Vertex_index> vertices, Covered& covered)
  {
    if (is_worth_threads(vertices.size()))
      for (const Cuts& cuts : ways_to_cut(vertices.size())) {
        if (vertices.size() < few_left)
          break;
        const Coordinates coordinates{m_state, cuts.shift};
        vertices = insert_in_parts(Division(coordinates, cuts.numbers), vertices, covered);
      }
    std::vector<Vertex_index> left;
    for (const Vertex_index v : vertices) {
      const Vertex_index other = m_insertion.insert(v);
      if (other == v)
        left.push_back(v);
      else if (other != null_index)
        covered.emplace_back(v, other);
    }
    return left;
  }

private:
  // Lets cells be replaced whose vertices are in a part.
  struct Part_region
  {
    bool has(const Vertices_3& v) const
    {
      return division->has(part, v[0]) && division->has(part, v[1]) && division->has(part, v[2]) &&
             division->has(part, v[3]);
    }

    const Division* division;
    std::size_t part;
  };
  using Part_insertion = Insertion_in_region<State, Part_region>;

  // What a thread does in a part, in lines of the cache of its own.
  struct alignas(64) Work
  {
    std::vector<Vertex_index> vertices; // to be inserted
    Cell_index start = null_index;      // where the next walk begins, if there is such a cell
    std::vector<Vertex_index> left;
    Covered covered;
  };

  // Where vertices are that are left, so that others that coincide with them are left, too. One bit
  // stands for many places, so some vertices are left for nothing.
  class Left_places
  {
  public:
    explicit Left_places(std::size_t vertices)
      : m_bits(16 * vertices + 1, false)
    {
    }
    bool may_have(const Position_3& p) const { return m_bits[number(p)]; }
    void insert(const Position_3& p) { m_bits[number(p)] = true; }

  private:
    std::size_t number(const Position_3& p) const
    {
      std::size_t hash = 0;
      for (const double x : {p.x, p.y, p.z})
        boost::hash_combine(hash, x + 0.0); // the same for both zeros
      return hash % m_bits.size();
    }

    std::vector<bool> m_bits;
  };

  // With fewer ones for each thread too many are at borders.
  static constexpr std::size_t least_of_part = (std::max)(Parts::usual_size / 4, std::size_t(1));
  // To divide all vertices anew takes as long as to insert some hundred.
  static constexpr std::size_t few_left = (std::max)(Parts::usual_size / 8, std::size_t(1));

  static bool is_worth_threads(std::size_t vertices)
  {
    return Parts::most_workers() > 1 && vertices >= 2 * least_of_part;
  }

  // Where borders are along an axis: nowhere, or in one of two ways, which are far from each other.
  enum class Borders { NONE, USUAL, OTHER };

  // A division.
  struct Cuts
  {
    typename Division::Numbers numbers{1, 1, 1};
    Few<double, 3> shift{0, 0, 0};
  };
  Cuts cuts(const typename Division::Numbers& n, const Few<Borders, 3>& borders) const
  {
    Cuts cuts;
    for (int axis = 0; axis < 3; ++axis)
      if (borders[axis] == Borders::OTHER && m_state.repeats(axis)) {
        cuts.numbers[axis] = n[axis];
        cuts.shift[axis] = 0.5 / double(n[axis]);
      } else if (borders[axis] != Borders::NONE) {
        const std::size_t other = n[axis] == 2 ? 3 : 2;
        cuts.numbers[axis] = borders[axis] == Borders::USUAL ? n[axis] : other;
      }
    return cuts;
  }

  // Divisions for so many vertices, one after the other: what is near to the borders of some of
  // them is far from those of others.
  std::vector<Cuts> ways_to_cut(std::size_t vertices) const
  {
    const std::size_t most = (std::max)(vertices / least_of_part, std::size_t(1));
    const typename Division::Numbers n = numbers((std::min)(Parts::most_workers(), most));
    if (n[1] == 1)
      return {{{n[0], 1, 1}}, {{1, n[0], 1}}, {{1, 1, n[0]}}};
    constexpr Borders none = Borders::NONE, usual = Borders::USUAL, other = Borders::OTHER;
    return {cuts(n, {usual, usual, usual}), cuts(n, {other, other, other}),
            cuts(n, {other, usual, none}), cuts(n, {none, other, usual}),
            cuts(n, {usual, none, other})};
  }

  // Into how many slabs, columns and blocks space is divided for so many threads: so that the one
  // with the most parts has as few of all as possible.
  static typename Division::Numbers numbers(std::size_t threads)
  {
    typename Division::Numbers best{1, 1, 1};
    const auto rounds = [threads](const typename Division::Numbers& n) {
      return (Division::number(n) + threads - 1) / threads;
    };
    for (std::size_t x = 1; x <= Division::most_in_row; ++x)
      for (std::size_t y = 1; y <= x; ++y)
        for (std::size_t z = 1; z <= y; ++z) {
          const typename Division::Numbers n{x, y, z};
          const std::size_t share = rounds(n) * Division::number(best);
          const std::size_t best_share = rounds(best) * Division::number(n);
          if (share < best_share ||
              (share == best_share && Division::number(n) < Division::number(best)))
            best = n;
        }
    return best;
  }

  // Returns the vertices that are left, in their order.
  std::vector<Vertex_index> insert_in_parts(const Division& division,
                                            const std::vector<Vertex_index>& vertices,
                                            Covered& covered)
  {
    constexpr std::size_t cells = 7; // that random points add, each
    std::vector<Work> works(division.number());
    for (const Vertex_index v : vertices)
      works[division.part_of(v)].vertices.push_back(v);
    for (std::size_t part = 0; part < works.size(); ++part)
      works[part].start = find_start({&division, part}, works[part].vertices);
    m_state.arrays.template begin_parts<Parts>(
        works.size(), [&](std::size_t part) { return cells * works[part].vertices.size(); });
    Parts::run_long(works.size(), [&](std::size_t part) {
      insert({&division, part}, works[part]);
    });
    m_state.arrays.end_parts();
    std::vector<Vertex_index> left;
    for (const Work& work : works) {
      if (work.start != null_index)
        m_insertion.start_at(work.start); // where it was last, there may be no cell any more
      left.insert(left.end(), work.left.begin(), work.left.end());
      covered.insert(covered.end(), work.covered.begin(), work.covered.end());
    }
    std::sort(left.begin(), left.end());
    return left;
  }

  // A cell of a region that contains one of some vertices, or null_index.
  Cell_index find_start(const Part_region& region, const std::vector<Vertex_index>& vertices)
  {
    constexpr std::size_t tries = 16;
    for (std::size_t i = 0; i < tries && !vertices.empty(); ++i) {
      const Cell_index c = m_insertion.locate(vertices[vertices.size() * i / tries]);
      m_insertion.start_at(c);
      if (region.has(m_state.arrays.vertices(c)))
        return c;
    }
    return null_index;
  }

  void insert(const Part_region& region, Work& work)
  {
    if (work.start == null_index) {
      work.left.swap(work.vertices);
      return;
    }
    Part_insertion insertion(m_state, region);
    insertion.start_at(work.start);
    Left_places places_left(work.vertices.size());
    for (const Vertex_index v : work.vertices) {
      const Position_3& p = m_state.positions.position(v);
      const Vertex_index other = places_left.may_have(p) ? v : insertion.insert(v);
      if (other == v) {
        work.left.push_back(v);
        places_left.insert(p);
        insertion.start_at(start_near(region, v, insertion.last()));
      } else if (other != null_index) {
        work.covered.emplace_back(v, other);
      }
    }
    work.start = insertion.last();
  }

  // A cell of a region near to a vertex that could not be inserted. From the last one walks may
  // lead out of the region, wherever they go.
  Cell_index start_near(const Part_region& region, Vertex_index v, Cell_index last) const
  {
    constexpr Index most_steps = 64;
    for (Index step = 1; step <= most_steps && step < v; ++step) { // numbers follow a curve
      const Vertex_index u(v - step);
      if (region.division->part_of(u) != region.part) // others change meanwhile
        continue;
      if (const Corner_index k = m_state.arrays.corner_of(u); k != null_index)
        if (const Cell_index c = Arrays::cell_of(k); region.has(m_state.arrays.vertices(c)))
          return c;
    }
    return last;
  }

  State& m_state;
  Insertion& m_insertion;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_PARALLEL_INSERTION_3_H
