// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_patch_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/wires/Wire_axis_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/wires/Wire_outside_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/wires/Wire_planes_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Parallel_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Vertex_order_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Canonical_cells_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Triangulates all vertices of a torus from scratch.
//
// Some of them are triangulated with their images in a margin around, in open space. A Delaunay
// cell of the torus has an empty sphere, so it is among these cells if the margin has its vertices;
// and if cells, one of each class, are found that fit together across their facets and cover the
// torus once, they are the Delaunay cells. Else the margin grows. All other vertices are inserted
// into these cells. Where that fails, as where points crowd in a part of the cell, more of them are
// triangulated with images.
//
// In a slab the highest and the lowest points are among the first ones, as the images of one that
// is higher than all others before are in each other's way. The hull of images has the hull facets
// of the slab in its middle, which are in a plane along the slab. All vertices of a cell of the
// slab are in a cylinder along its normal, as wide as the largest empty circle of the lattice: in
// the plane of each vertex a larger one has images of it inside. So a margin of some such circles
// is enough.
//
// In a wire the first ones are those of the hull, as it is seen along its vector a, and some near
// to it. The line along a through a vertex of a cell meets the cell's empty sphere in a chord that
// is no longer than a, as there is an image of the vertex at each end of a longer one, or inside;
// and the middle of the chord is as high along a as the center of the sphere. So the vertices of a
// cell differ by |a| at most along a. A margin of one vector has all cells of the vertices within
// the parallelepiped, one of two vectors also their neighbors; less is enough in most cases. In the
// planes of hull facets circles take the place of spheres.
template <class State>
class Torus_triangulator_3
{
  using Arrays = Torus_cells_3;
  using Parts = typename State::Exact_parts;

public:
  using Covered = std::vector<std::pair<Vertex_index, Vertex_index>>;

  explicit Torus_triangulator_3(State& state)
    : m_state(state)
    , m_signs(state)
    , m_insertion(state)
    , m_parallel_insertion(state, m_insertion)
  {
  }

  // Builds the cells of all vertices, which should be near to each other's places in the basis'
  // parallelepiped. `covered` lists vertices that coincide with others, each with the one that has
  // cells; they have none.
  void triangulate(Covered& covered)
  {
    const Index vertices = m_state.number_of_vertices();
    std::vector<Vertex_index> order = order_by_rounds(vertices);
    covered.clear();
    m_state.arrays.reset(vertices + 1);
    m_state.spans_space = vertices > 0;
    bool is_second_try = false; // with those that could not be inserted before
    for (std::size_t number = few; vertices > 0; number *= is_second_try ? 1 : 8) {
      covered.clear();
      if (m_state.torus.is_slab())
        bring_outermost_to_front(order, number / 8);
      if (m_state.torus.is_wire())
        number =
            (std::max)(number, 2 * Wire_outside_3<State>(m_state).bring_to_front(order, number));
      if (!triangulate_with_images(order, (std::min)(number, std::size_t(vertices)), covered)) {
        is_second_try = false;
        if (number < vertices)
          continue;
        m_state.spans_space = false;
        Wire_planes_3<State>(m_state).find_covered(covered);
        break;
      }
      if (insert_from(order, number, covered))
        break;
      is_second_try = !is_second_try && m_left.size() < number / 8;
      if (is_second_try)
        bring_left_to_front(order);
    }
    let_first_ones_have_cells(covered);
    Canonical_cells_3<Arrays, Parts>(m_state.arrays).order();
    if (m_state.torus.is_wire() && m_state.spans_space)
      choose_axis(); // which cells have been there first may depend on threads
  }

private:
  // Vertices. With 100 constructions take 1.2 times as long for 10,000 random points, 2.0 times for
  // 1,000, and 3.7 times for 200.
  static constexpr std::size_t few = 24;
  static constexpr double spacings = 2.5; // as margin of random points
  static constexpr double enough = 1.25;  // of a cell's size, as margin of few points
  static constexpr std::size_t most_images = std::size_t(1) << 26;

  // Brings so many of the highest vertices of a slab to the front, and as many of the lowest ones;
  // by rounded elevations, but with those that are exactly the outermost.
  void bring_outermost_to_front(std::vector<Vertex_index>& order, std::size_t number) const
  {
    std::vector<Elevation> all;
    for (const Vertex_index v : order)
      all.push_back({m_state.torus.elevation(m_state.positions.position(v)), v});
    std::sort(all.begin(), all.end());
    Column<Vertex_index, char> is_outermost(m_state.positions.number(), 0);
    for (std::size_t i = 0; i < (std::min)(number, all.size()); ++i) {
      is_outermost[all[i].vertex] = 1;
      is_outermost[all[all.size() - 1 - i].vertex] = 1;
    }
    is_outermost[outermost(all.begin(), all.end(), -1)] = 1;
    is_outermost[outermost(all.rbegin(), all.rend(), 1)] = 1;
    std::stable_partition(order.begin(), order.end(),
                          [&](Vertex_index v) { return is_outermost[v] != 0; });
  }
  void bring_left_to_front(std::vector<Vertex_index>& order) const
  {
    Column<Vertex_index, char> is_left(m_state.positions.number(), 0);
    for (const Vertex_index v : m_left)
      is_left[v] = 1;
    std::stable_partition(order.begin(), order.end(),
                          [&](Vertex_index v) { return is_left[v] != 0; });
  }
  struct Elevation
  {
    double rounded;
    Vertex_index vertex;

    friend bool operator<(const Elevation& a, const Elevation& b) { return a.rounded < b.rounded; }
  };
  // The vertex that is exactly the highest, or by the sign -1 the lowest, of a list that begins
  // with what rounding takes for it.
  template <class Iterator>
  Vertex_index outermost(Iterator first, Iterator beyond, int sign) const
  {
    const Torus_3& torus = m_state.torus;
    const double uncertain = 4 * std::sqrt(m_state.squared_error);
    const auto image = [this](Vertex_index v) { return m_state.image(Torus_site_3{v, {}}); };
    Vertex_index found = first->vertex;
    for (auto i = first; i != beyond && std::abs(i->rounded - first->rounded) <= uncertain; ++i) {
      const Exact_vector_3 way = torus.exact_vector(image(found), image(i->vertex));
      if (sign * int(CGAL::sign(dot(torus.exact_vector(2), way))) > 0)
        found = i->vertex;
    }
    return found;
  }

  // Inserts vertices from some place in the order on. Those that are in their own way, as where
  // cells are still large, are tried again when all others are there. False if some remain.
  bool insert_from(const std::vector<Vertex_index>& order, std::size_t first, Covered& covered)
  {
    m_left.clear();
    m_insertion.start_at(Arrays::cell_of(m_state.arrays.corner_of(m_seeds.front())));
    for (std::size_t beyond = first; first < order.size(); first = beyond) {
      std::vector<Vertex_index> round;
      for (; beyond < order.size() && round_of(order[beyond]) == round_of(order[first]); ++beyond)
        round.push_back(order[beyond]);
      const std::vector<Vertex_index> left = m_parallel_insertion.insert(std::move(round), covered);
      m_left.insert(m_left.end(), left.begin(), left.end());
    }
    for (std::size_t before = m_left.size() + 1; m_left.size() < before;) {
      before = m_left.size();
      m_left = m_parallel_insertion.insert(std::move(m_left), covered);
    }
    return m_left.empty();
  }

  // Of vertices that coincide, the first one in the order of rounds gets the cells, whichever has
  // got them: so that nothing depends on threads.
  void let_first_ones_have_cells(Covered& covered)
  {
    std::map<Vertex_index, Vertex_index> first; // of those that coincide with one that has cells
    for (const auto& [v, other] : covered)
      if (Vertex_index& known = first.emplace(other, other).first->second;
          Order_of_rounds_3()(v, known))
        known = v;
    if (std::all_of(first.begin(), first.end(), [](const auto& f) { return f.first == f.second; }))
      return;
    const Torus_3& torus = m_state.torus;
    const auto& positions = m_state.positions;
    Column<Vertex_index, Torus_shift_3> shifts(positions.number(), Torus_shift_3());
    Column<Vertex_index, Vertex_index> numbers(positions.number(), infinite_index);
    for (Vertex_index v(1); v < numbers.size(); ++v)
      numbers[v] = v;
    for (const auto& [v, known] : first) {
      const Position_3 way = positions.position(v) - positions.position(known);
      shifts[v] = Torus_shift_3::of(Torus_3::nearest(torus.fractions(way)));
      numbers[v] = known;
    }
    m_state.arrays.close_gaps();
    m_state.arrays.shift_vertices(shifts);
    m_state.arrays.renumber_all(numbers, positions.number());
    for (auto& [v, other] : covered) {
      const Vertex_index known = first[other];
      v = v == known ? other : v;
      other = known;
    }
  }

  // Triangulates the first so many vertices. Those that coincide are left out in a second attempt.
  // False if they are in a plane along a wire.
  bool triangulate_with_images(const std::vector<Vertex_index>& order, std::size_t number,
                               Covered& covered)
  {
    m_seeds.assign(order.begin(), order.begin() + std::ptrdiff_t(number));
    for (int attempt = 0;; ++attempt) {
      list_images(margin(attempt));
      Torus_patch_3<State> patch(m_state);
      Covered coinciding;
      const auto triangulate = [&] {
        return patch.triangulate(m_images, [&](std::size_t i, std::size_t j) {
          coinciding.emplace_back(m_images[i].vertex, m_images[j].vertex);
        });
      };
      bool spans_space = triangulate();
      if (!spans_space && m_state.torus.is_slab()) {
        append_points_at_infinity();
        spans_space = triangulate();
      }
      if (!spans_space && m_state.torus.is_wire())
        return false;
      if (!coinciding.empty()) {
        leave_out(coinciding, covered);
        continue;
      }
      if (spans_space && take_over(patch))
        return true;
    }
  }

  // Leaves out vertices that coincide with others.
  void leave_out(const Covered& coinciding, Covered& covered)
  {
    std::map<Vertex_index, Vertex_index> other;
    const auto find = [&](Vertex_index v) {
      for (auto at = other.find(v); at != other.end(); at = other.find(v))
        v = at->second;
      return v;
    };
    for (const auto& [v, w] : coinciding)
      if (const Vertex_index first = find(v), second = find(w); first != second)
        other[first] = second;
    for (const auto& [v, w] : other)
      covered.emplace_back(v, find(w));
    m_seeds.erase(std::remove_if(m_seeds.begin(), m_seeds.end(),
                                 [&](Vertex_index v) { return other.count(v) > 0; }),
                  m_seeds.end());
  }

  // The margin that an attempt takes, in multiples of the basis: in each direction some spacings of
  // evenly spread points, and later, as voids may be as large as the cell, so many cells.
  Few<double, 3> margin(int attempt) const
  {
    if (m_state.torus.is_slab())
      return margin_in_slab(attempt);
    if (m_state.torus.is_wire()) // rounding moves points by far less than a hundredth
      return {attempt == 0 ? 1.5 : 2.01 * std::pow(1.4, attempt - 1), 0, 0};
    const double spacing = std::cbrt(m_state.torus.volume() / double(m_seeds.size()));
    const double growth = attempt < 2 ? 1 + 0.6 * attempt : std::pow(1.4, attempt - 2);
    Few<double, 3> margin;
    for (int i = 0; i < 3; ++i) {
      const double even = spacings * spacing / m_state.torus.height(i);
      margin[i] = growth * (attempt < 2 ? (std::min)(even, double(enough)) : enough);
    }
    return margin;
  }

  // Hull facets are as large as the cell, and so are cells beneath.
  Few<double, 3> margin_in_slab(int attempt) const
  {
    const Torus_3& torus = m_state.torus;
    const double longest =
        std::sqrt((std::max)(squared_length(torus.vector(0)), squared_length(torus.vector(1))));
    const double length = enough * std::pow(1.4, attempt) * longest;
    return {length / torus.height(0), length / torus.height(1), 0};
  }

  void append_points_at_infinity()
  {
    m_images.push_back(Torus_site_3::above());
    m_images.push_back(Torus_site_3::below());
  }

  // Lists the images of the seeds in the basis' parallelepiped and in a margin around, in rounds
  // along a curve: seed by seed they would be rows of a lattice first, whose cells are large.
  void list_images(const Few<double, 3>& margin)
  {
    Multiples_3 most;
    for (int i = 0; i < 3; ++i)
      most[i] = i < m_state.torus.dimension() ? int(std::ceil(margin[i])) + 1 : 0;
    if (double(m_seeds.size()) * (1 + 2 * margin[0]) * (1 + 2 * margin[1]) * (1 + 2 * margin[2]) >
        double(most_images))
      throw std::length_error("a periodic cell is too thin for its points");
    std::vector<Torus_site_3> images;
    std::vector<Position_3> positions;
    const auto is_within = [](double x, double m) { return -m <= x && x <= 1 + m; };
    for (const Vertex_index v : m_seeds) {
      const Position_3& p = m_state.positions.position(v);
      const Position_3 f = m_state.torus.fractions(p);
      for (int x = -most[0]; x <= most[0]; ++x)
        for (int y = -most[1]; y <= most[1]; ++y)
          for (int z = -most[2]; z <= most[2]; ++z)
            if (is_within(f.x + x, margin[0]) && is_within(f.y + y, margin[1]) &&
                is_within(f.z + z, margin[2])) {
              images.push_back({v, Torus_shift_3::of({x, y, z})});
              positions.push_back(p + m_state.torus.combination(Multiples_3{x, y, z}));
            }
    }
    const std::vector<Index> along_curve = Order_along_curve_3<Parts>(positions).run();
    m_images.clear();
    for (const Vertex_index n : order_by_rounds(Index(images.size())))
      m_images.push_back(images[along_curve[n - 1]]);
  }

  // A cell's sites in ascending order, moved so that the first finite one has the shift 0: the same
  // for all images of the cell.
  struct Class
  {
    Torus_sites_3 sites;
    Torus_shift_3 shift; // of that one before

    explicit Class(const Torus_sites_3& given)
      : sites(given)
    {
      std::sort(sites.begin(), sites.end());
      shift = sites[sites[0].is_infinite() ? 1 : 0].shift;
      for (Torus_site_3& s : sites)
        s = s - shift;
    }
  };

  // The sites of a cell of the patch. In a slab one beyond its hull has the point at infinity above
  // or below, unless the hull facet is a wall at the side of the patch; in a wire all that there
  // is. Nothing for those without such a cell of the torus.
  std::optional<Torus_sites_3> sites(const Torus_patch_3<State>& patch, Cell_index c) const
  {
    Torus_sites_3 sites = patch.sites(c);
    if (m_state.torus.dimension() == 3)
      return patch.arrays().is_infinite(c) ? std::nullopt : std::optional(sites);
    if (const int place = patch.arrays().place_of(c, infinite_index); place < 4) {
      sites[place] = Torus_site_3::above();
      if (m_state.torus.is_wire())
        return sites;
      if (m_signs.of(sites) < 0)
        sites[place] = Torus_site_3::below();
    }
    const bool is_infinite = std::any_of(sites.begin(), sites.end(),
                                         [](const Torus_site_3& s) { return s.is_infinite(); });
    return is_infinite && !m_signs.is_positive(sites) ? std::nullopt : std::optional(sites);
  }

  // Takes over one cell of each class, if they fit together and cover the torus once.
  bool take_over(const Torus_patch_3<State>& patch)
  {
    m_classes.clear();
    const Tetrahedra_arrays_3& cells = patch.arrays();
    for (Cell_index c(0); c < cells.number_of_cells(); ++c)
      if (const std::optional<Torus_sites_3> given = sites(patch, c))
        if (const Class of_cell(*given); of_cell.shift == Torus_shift_3())
          m_classes.emplace_back(of_cell.sites, c);
    std::sort(m_classes.begin(), m_classes.end());
    m_state.arrays.reset(m_state.number_of_vertices() + 1);
    for (const auto& [ascending, c] : m_classes)
      m_state.arrays.set_sites(m_state.arrays.make_cell(), *sites(patch, c));
    m_mirrors.assign(4 * m_classes.size(), Corner_index(null_index));
    for (Cell_index c(0); c < m_state.arrays.number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i)
        if (!find_mirror(patch, Arrays::corner(c, i)))
          return false;
    for (Corner_index k(0); k < m_mirrors.size(); ++k)
      if (m_mirrors[m_mirrors[k]] != k)
        return false;
    for (Cell_index c(0); c < m_state.arrays.number_of_cells(); ++c)
      m_state.arrays.normalize(c);
    for (const Vertex_index v : m_seeds)
      if (m_state.arrays.corner_of(v) == null_index)
        return false;
    return (!m_state.torus.is_wire() || choose_axis()) &&
           Torus_certificate_3<State>(m_state).covers_once();
  }
  bool choose_axis()
  {
    if (m_state.arrays.corner_of(infinite_index) == null_index)
      return false;
    std::vector<Cell_index> infinite;
    find_star(m_state.arrays, infinite_index, m_state.marks, infinite);
    return Wire_axis_3<State>(m_state, infinite).choose();
  }

  // Connects a corner with its mirror in a cell of the class that the neighbor in the patch has.
  bool find_mirror(const Torus_patch_3<State>& patch, Corner_index k)
  {
    const Tetrahedra_arrays_3& cells = patch.arrays();
    const Corner_index mirror =
        cells.mirror(Arrays::corner(m_classes[Arrays::cell_of(k)].second, Arrays::place_of(k)));
    const std::optional<Torus_sites_3> beyond = sites(patch, Arrays::cell_of(mirror));
    if (!beyond)
      return false;
    const Class neighbor(*beyond);
    const auto at = std::lower_bound(
        m_classes.begin(), m_classes.end(), neighbor.sites,
        [](const auto& entry, const Torus_sites_3& other) { return entry.first < other; });
    if (at == m_classes.end() || !(at->first == neighbor.sites))
      return false;
    const Torus_site_3 apex = (*beyond)[Arrays::place_of(mirror)] - neighbor.shift;
    const Cell_index other(at - m_classes.begin());
    const Corner_index l = Arrays::corner(other, m_state.arrays.place_of(other, apex));
    m_mirrors[k] = l;
    m_state.arrays.connect(k, l, neighbor.shift);
    return true;
  }

  State& m_state;
  Torus_signs_3<State> m_signs;
  Torus_insertion_3<State> m_insertion;
  Parallel_insertion_3<State, Torus_insertion_3> m_parallel_insertion;
  std::vector<Vertex_index> m_seeds;
  std::vector<Vertex_index> m_left; // could not be inserted
  std::vector<Torus_site_3> m_images;
  std::vector<std::pair<Torus_sites_3, Cell_index>> m_classes; // with cells of the patch
  Column<Corner_index, Corner_index> m_mirrors;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_3_H
