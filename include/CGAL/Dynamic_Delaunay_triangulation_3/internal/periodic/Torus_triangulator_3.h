// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_patch_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Vertex_order_3.h>

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
template <class State>
class Torus_triangulator_3
{
  using Arrays = Torus_cells_3;
  using Insertion = Torus_insertion_3<State>;

public:
  using Covered = std::vector<std::pair<Vertex_index, Vertex_index>>;

  explicit Torus_triangulator_3(State& state)
    : m_state(state)
    , m_insertion(state)
  {
  }

  // Builds the cells of all vertices, which should be near to each other's places in the basis'
  // parallelepiped. `covered` lists vertices that coincide with others, each with the one that has
  // cells; they have none.
  void triangulate(Covered& covered)
  {
    const Index vertices = m_state.number_of_vertices();
    const std::vector<Vertex_index> order = order_by_rounds(vertices);
    covered.clear();
    m_state.arrays.reset(vertices + 1);
    m_state.spans_space = vertices > 0;
    for (std::size_t number = few; vertices > 0; number *= 8) {
      covered.clear();
      triangulate_with_images(order, (std::min)(number, std::size_t(vertices)), covered);
      if (insert_from(order, number, covered))
        break;
    }
    m_state.arrays.close_gaps();
    m_state.arrays.sort_cells();
  }

private:
  static constexpr std::size_t few = 100; // vertices
  static constexpr double spacings = 2.5; // as margin of random points
  static constexpr double enough = 1.25;  // of a cell's size, as margin of few points
  static constexpr std::size_t most_images = std::size_t(1) << 26;

  // Inserts vertices from some place in the order on. False if one is in its own way.
  bool insert_from(const std::vector<Vertex_index>& order, std::size_t first, Covered& covered)
  {
    if (first >= order.size())
      return true;
    m_insertion.start_at(Arrays::cell_of(m_state.arrays.corner_of(m_seeds.front())));
    for (std::size_t i = first; i < order.size(); ++i) {
      const std::optional<Vertex_index> other = m_insertion.insert(order[i]);
      if (!other)
        return false;
      if (*other != null_index)
        covered.emplace_back(order[i], *other);
    }
    return true;
  }

  // Triangulates the first so many vertices. Those that coincide are left out in a second attempt.
  void triangulate_with_images(const std::vector<Vertex_index>& order, std::size_t number,
                               Covered& covered)
  {
    m_seeds.assign(order.begin(), order.begin() + std::ptrdiff_t(number));
    for (int attempt = 0;; ++attempt) {
      list_images(margin(attempt));
      Torus_patch_3<State> patch(m_state);
      Covered coinciding;
      const bool spans_space = patch.triangulate(
          m_images, [this](std::size_t i) { return m_hints[i]; },
          [&](std::size_t i, std::size_t j) {
            coinciding.emplace_back(m_images[i].vertex, m_images[j].vertex);
          });
      if (!coinciding.empty()) {
        leave_out(coinciding, covered);
        continue;
      }
      if (spans_space && take_over(patch))
        return;
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
    const double spacing = std::cbrt(m_state.torus.volume() / double(m_seeds.size()));
    const double growth = attempt < 2 ? 1 + 0.6 * attempt : std::pow(1.4, attempt - 2);
    Few<double, 3> margin;
    for (int i = 0; i < 3; ++i) {
      const double even = spacings * spacing / m_state.torus.height(i);
      margin[i] = growth * (attempt < 2 ? (std::min)(even, double(enough)) : enough);
    }
    return margin;
  }

  // Lists the images of the seeds in the basis' parallelepiped and in a margin around, and for each
  // the image of the seed before by the same shift.
  void list_images(const Few<double, 3>& margin)
  {
    Multiples_3 most;
    for (int i = 0; i < 3; ++i)
      most[i] = int(std::ceil(margin[i])) + 1;
    if (double(m_seeds.size()) * (1 + 2 * margin[0]) * (1 + 2 * margin[1]) * (1 + 2 * margin[2]) >
        double(most_images))
      throw std::length_error("a periodic cell is too thin for its points");
    m_images.clear();
    m_hints.clear();
    std::map<int, std::size_t> last; // by codes of shifts
    const auto is_within = [](double x, double m) { return -m <= x && x <= 1 + m; };
    for (const Vertex_index v : m_seeds) {
      const Position_3 f = m_state.torus.fractions(m_state.positions.position(v));
      for (int x = -most[0]; x <= most[0]; ++x)
        for (int y = -most[1]; y <= most[1]; ++y)
          for (int z = -most[2]; z <= most[2]; ++z)
            if (is_within(f.x + x, margin[0]) && is_within(f.y + y, margin[1]) &&
                is_within(f.z + z, margin[2])) {
              const Torus_shift_3 shift = Torus_shift_3::of({x, y, z});
              const auto at = last.emplace(shift.code, std::size_t(-1)).first;
              m_hints.push_back(at->second);
              at->second = m_images.size();
              m_images.push_back({v, shift});
            }
    }
  }

  // A cell's sites in ascending order, moved so that the first one has the shift 0: the same for
  // all images of the cell.
  struct Class
  {
    Torus_sites_3 sites;
    Torus_shift_3 shift; // of the first one before

    explicit Class(const Torus_sites_3& given)
      : sites(given)
    {
      std::sort(sites.begin(), sites.end());
      shift = sites[0].shift;
      for (Torus_site_3& s : sites)
        s.shift = s.shift - shift;
    }
  };

  // Takes over one cell of each class, if they fit together and cover the torus once.
  bool take_over(const Torus_patch_3<State>& patch)
  {
    m_classes.clear();
    const Tetrahedra_arrays_3& cells = patch.arrays();
    for (Cell_index c(0); c < cells.number_of_cells(); ++c)
      if (!cells.is_infinite(c))
        if (const Class of_cell(patch.sites(c)); of_cell.shift == Torus_shift_3())
          m_classes.emplace_back(of_cell.sites, c);
    std::sort(m_classes.begin(), m_classes.end());
    m_state.arrays.reset(m_state.number_of_vertices() + 1);
    for (const auto& [sites, c] : m_classes)
      m_state.arrays.set_sites(m_state.arrays.make_cell(), patch.sites(c));
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
    return Torus_certificate_3<State>(m_state).covers_once();
  }

  // Connects a corner with its mirror in a cell of the class that the neighbor in the patch has.
  bool find_mirror(const Torus_patch_3<State>& patch, Corner_index k)
  {
    const Tetrahedra_arrays_3& cells = patch.arrays();
    const Corner_index mirror =
        cells.mirror(Arrays::corner(m_classes[Arrays::cell_of(k)].second, Arrays::place_of(k)));
    if (cells.is_infinite(Arrays::cell_of(mirror)))
      return false;
    const Class neighbor(patch.sites(Arrays::cell_of(mirror)));
    const auto at = std::lower_bound(
        m_classes.begin(), m_classes.end(), neighbor.sites,
        [](const auto& entry, const Torus_sites_3& sites) { return entry.first < sites; });
    if (at == m_classes.end() || !(at->first == neighbor.sites))
      return false;
    Torus_site_3 apex = patch.site(cells.vertex(mirror));
    apex.shift = apex.shift - neighbor.shift;
    const Cell_index other(at - m_classes.begin());
    const Corner_index l = Arrays::corner(other, m_state.arrays.place_of(other, apex));
    m_mirrors[k] = l;
    m_state.arrays.connect(k, l, neighbor.shift);
    return true;
  }

  State& m_state;
  Insertion m_insertion;
  std::vector<Vertex_index> m_seeds;
  std::vector<Torus_site_3> m_images;
  std::vector<std::size_t> m_hints;
  std::vector<std::pair<Torus_sites_3, Cell_index>> m_classes; // with cells of the patch
  Column<Corner_index, Corner_index> m_mirrors;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_TRIANGULATOR_3_H
