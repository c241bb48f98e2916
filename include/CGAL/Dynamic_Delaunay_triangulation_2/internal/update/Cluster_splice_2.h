// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_CLUSTER_SPLICE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_CLUSTER_SPLICE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Static_triangulator_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

enum class Splice_result_2 { DONE, TOO_LARGE, TOO_DEAR, COINCIDENCE };

// What splices may do (in), and what they have done (out).
struct Splice_limits_2
{
  std::size_t max_enlargements; // in, per cluster: if it needs more, it keeps its old faces
  std::size_t max_vertices;     // in: to triangulate in all; out: how many of these are left
  std::size_t enlargements = 0; // out, of all clusters
};

// Adds the finite neighbors of the vertices of a region, from the `first` vertex on.
template <class State>
void add_layer(const State& state, Index_set_2& region, std::size_t first = 0)
{
  for (const std::size_t beyond = region.size(); first < beyond; ++first)
    state.arrays().for_each_neighbor(region[first], [&](Vertex_index w) {
      if (w != infinite_index)
        region.insert(w);
    });
}

// Replaces a region by those of these vertices that are in faces, and some layers around them.
// Returns how many of these vertices there are; they come first.
template <class State>
std::size_t collect_region(const State& state, const std::vector<Index>& vertices, unsigned layers,
                           Index_set_2& region)
{
  region.clear(state.arrays().number_of_vertices());
  for (const Vertex_index v : vertices)
    if (!state.arrays().is_outside(v))
      region.insert(v);
  const std::size_t inner = region.size();
  for (unsigned layer = 0; layer < layers; ++layer)
    add_layer(state, region);
  return inner;
}

// Makes the new faces around a cluster of connected vertices. Writes nothing.
//
// A splice is correct only if the old and the new faces have the same boundary, edge for edge (an
// open problem of the thesis: an edge could get lost). Where the boundaries differ, their vertices
// join the cluster, which is then triangulated again.
template <class State>
class Cluster_splice_2
{
  using Arrays = Halfedge_arrays_2;

public:
  explicit Cluster_splice_2(const State& state)
    : m_state(state)
    , m_order(state)
    , m_triangulator(state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_triangulator.set_engine(engine); }

  // Starts a cluster: v, and all vertices that can be reached from v through vertices w for which
  // `belongs(w)` is true. False if they are more than `most`; then some of them are missing.
  template <class Belongs>
  bool collect(Vertex_index v, std::size_t most, const Belongs& belongs)
  {
    m_cluster.clear(m_state.arrays().number_of_vertices());
    m_cluster.insert(v);
    for (std::size_t i = 0; i < m_cluster.size() && m_cluster.size() <= most; ++i)
      m_state.arrays().for_each_neighbor(m_cluster[i], [&](Vertex_index w) {
        if (belongs(w))
          m_cluster.insert(w);
      });
    m_first_size = m_cluster.size();
    return m_first_size <= most;
  }

  // Triangulates the cluster and its border. Enlarges it until the new faces fit, within `limits`.
  Splice_result_2 make(Splice_limits_2& limits)
  {
    constexpr std::size_t gentle_enlargements = 3;
    m_looked_at.clear();
    for (std::size_t enlargements = 0;; ++enlargements) {
      collect_old_faces();
      const std::size_t size = m_cluster.size() + m_border.size();
      if (is_too_large(size))
        return Splice_result_2::TOO_LARGE;
      if (size > limits.max_vertices)
        return Splice_result_2::TOO_DEAR;
      limits.max_vertices -= size;
      if (!triangulate())
        return Splice_result_2::COINCIDENCE;
      collect_new_faces();
      m_fits = boundaries_agree() && !doubles_an_edge();
      if (m_fits || enlargements == limits.max_enlargements)
        return Splice_result_2::DONE;
      grow(enlargements >= gentle_enlargements);
      ++limits.enlargements;
    }
  }

  // From half of all points on, a fresh triangulation of all points costs less.
  bool is_too_large(std::size_t region) const { return 2 * region > m_state.number_of_vertices(); }

  // Whether the new faces can replace the old ones.
  bool fits() const { return m_fits; }
  const Index_set_2& cluster() const { return m_cluster; }
  // How many vertices the cluster had before it was enlarged; these come first in `cluster()`.
  std::size_t first_size() const { return m_first_size; }
  const Index_set_2& border() const { return m_border; }
  const Index_set_2& old_faces() const { return m_old_faces; }
  const std::vector<Boundary_edge_2>& old_boundary() const { return m_old_boundary; } // sorted
  const Patch_2& new_faces() const { return m_new; }
  // The vertices that were triangulated last. If a coincidence was found, two of them coincide.
  const std::vector<Index>& region() const { return m_region; }

  // The results of make(), to be spliced later.
  struct Record
  {
    std::vector<Index> cluster, border, old_faces;
    std::vector<Index> looked_at; // other faces on which the results depend
    std::size_t first_size;
    bool fits;
    std::vector<Boundary_edge_2> old_boundary;
    Patch_2 new_faces;
  };

  Record record() const
  {
    return {m_cluster.members(),   m_border.members(),
            m_old_faces.members(), m_looked_at,
            m_first_size,          m_fits,
            m_old_boundary,        m_new};
  }

  // Takes over the results of make() that another object has recorded.
  void take(Record&& record)
  {
    const std::size_t vertices = m_state.arrays().number_of_vertices();
    m_cluster.assign(record.cluster, vertices);
    m_border.assign(record.border, vertices);
    m_old_faces.assign(record.old_faces, m_state.arrays().number_of_faces());
    m_first_size = record.first_size;
    m_fits = record.fits;
    m_old_boundary.swap(record.old_boundary);
    std::swap(m_new, record.new_faces);
  }

private:
  // Adds the vertices where the two boundaries differ, or the whole border if none of these is new.
  // From the fourth enlargement on, adds the border and further layers until the cluster has
  // doubled, so that all enlargements together cost at most about twice as much as the last one.
  void grow(bool doubles)
  {
    const std::size_t size = m_cluster.size();
    for (const Vertex_index v : m_disagreeing)
      if (v != infinite_index)
        m_cluster.insert(v);
    if (m_cluster.size() == size || doubles)
      for (const Vertex_index v : m_border)
        m_cluster.insert(v);
    for (std::size_t first = 0; doubles && m_cluster.size() < 2 * size;) {
      const std::size_t beyond = m_cluster.size();
      add_layer(m_state, m_cluster, std::exchange(first, beyond));
      if (m_cluster.size() == beyond)
        return;
    }
  }

  // FACES ---------------------------------------------------------------------------------------

  // Collects the faces around the cluster, their outer vertices and their boundary.
  void collect_old_faces()
  {
    const Arrays& arrays = m_state.arrays();
    m_old_faces.clear(arrays.number_of_faces());
    m_border.clear(m_state.arrays().number_of_vertices());
    m_has_infinite_faces = false;
    for (const Vertex_index v : m_cluster)
      arrays.for_each_corner(v, [&](Halfedge_index h) {
        m_old_faces.insert(Arrays::face_of(h));
        const Vertex_index w = arrays.source(h);
        if (w == infinite_index)
          m_has_infinite_faces = true;
        else if (!m_cluster.contains(w))
          m_border.insert(w);
      });
    m_old_boundary.clear();
    for (const Face_index f : m_old_faces)
      for (const Halfedge_index h : Arrays::halfedges_of(f))
        if (!m_old_faces.contains(Arrays::face_of(arrays.twin(h))))
          m_old_boundary.push_back({arrays.source(h), arrays.target(h), h});
    std::sort(m_old_boundary.begin(), m_old_boundary.end());
  }

  // False if two of the points coincide: triangulating them would lose a vertex.
  bool triangulate()
  {
    m_region.assign(m_cluster.begin(), m_cluster.end());
    m_region.insert(m_region.end(), m_border.begin(), m_border.end());
    m_order.sort(m_region.begin(), m_region.end());
    if (m_order.has_coincident_vertices())
      return false;
    m_triangulator.run(m_order.order());
    return true;
  }

  // Collects the faces that have a vertex of the cluster.
  void collect_new_faces()
  {
    const Flat_faces_2& faces = m_triangulator.faces();
    m_new.clear();
    m_new_number.assign(faces.number_of_faces(), null_index);
    Index number = 0;
    for (Face_index f = 0; f < faces.number_of_faces(); ++f) {
      const Halfedge_index h = Flat_faces_2::first_halfedge(f);
      if (m_cluster.contains(faces.apex(h)) || m_cluster.contains(faces.apex(h + 1)) ||
          m_cluster.contains(faces.apex(h + 2)))
        m_new_number[f] = number++;
    }
    for (Face_index f = 0; f < faces.number_of_faces(); ++f)
      if (m_new_number[f] != null_index)
        for (Index i = 0; i < 3; ++i) {
          const Halfedge_index h = Flat_faces_2::first_halfedge(f) + i;
          const Halfedge_index g = Flat_faces_2::number_in_arrays(faces.twin(h));
          const Index neighbor = m_new_number[Arrays::face_of(g)];
          m_new.apexes.push_back(faces.apex(h));
          m_new.twins.push_back(neighbor == null_index
                                    ? Halfedge_index(null_index)
                                    : Arrays::halfedge_in(neighbor, Arrays::place_of(g)));
        }
    m_new.find_boundary();
  }

  // BOUNDARIES ----------------------------------------------------------------------------------

  // Whether the result is a sphere with all vertices again (guarantee 1 in the manual): the old and
  // the new faces have equal boundary edges, are equally many, and both or neither of them include
  // infinite faces. No condition suffices alone: a cluster that was turned inside out can swap the
  // infinite vertex for a vertex of its border.
  bool boundaries_agree()
  {
    find_disagreeing();
    return m_disagreeing.empty() && m_old_faces.size() == m_new.number_of_faces() &&
           m_has_infinite_faces == has_new_infinite_faces();
  }

  bool has_new_infinite_faces() const
  {
    return std::find(m_new.apexes.begin(), m_new.apexes.end(), infinite_index) !=
           m_new.apexes.end();
  }

  void find_disagreeing()
  {
    m_disagreeing.clear();
    const auto note = [this](const Boundary_edge_2& edge) {
      m_disagreeing.push_back(edge.source);
      m_disagreeing.push_back(edge.target);
    };
    auto a = m_old_boundary.begin(), b = m_new.boundary.begin();
    while (a != m_old_boundary.end() || b != m_new.boundary.end())
      if (b == m_new.boundary.end() || (a != m_old_boundary.end() && *a < *b))
        note(*a++);
      else if (a == m_old_boundary.end() || *b < *a)
        note(*b++);
      else
        ++a, ++b;
  }

  // Whether an edge between two new faces joins vertices outside of the cluster that another edge,
  // which is not between two old faces, joins already. This is possible only where old faces
  // overlap. Adds such vertices to the disagreeing ones.
  bool doubles_an_edge()
  {
    for (Halfedge_index h = 0; h < Index(m_new.twins.size()); ++h) {
      const Vertex_index v = m_new.apexes[Arrays::next(h)], w = m_new.apexes[Arrays::previous(h)];
      if (m_new.twins[h] != null_index && v < w && !m_cluster.contains(v) &&
          !m_cluster.contains(w) && is_edge_outside(w, v)) {
        m_disagreeing.push_back(v);
        m_disagreeing.push_back(w);
      }
    }
    return !m_disagreeing.empty();
  }

  // Whether some edge from v to w is not between two old faces. Walks around the finite vertex v.
  bool is_edge_outside(Vertex_index v, Vertex_index w)
  {
    const Arrays& arrays = m_state.arrays();
    bool is_outside = false;
    arrays.for_each_corner(v, [&](Halfedge_index h) {
      const Index beyond = arrays.twin(Arrays::previous(h));
      m_looked_at.push_back(Arrays::face_of(h));
      is_outside = is_outside || (arrays.apex(Arrays::next(h)) == w &&
                                  !(m_old_faces.contains(Arrays::face_of(h)) &&
                                    m_old_faces.contains(Arrays::face_of(beyond))));
    });
    return is_outside;
  }

  const State& m_state;
  Vertex_order_2<State> m_order;
  Static_triangulator_2<State> m_triangulator;
  Index_set_2 m_cluster, m_border, m_old_faces;
  std::size_t m_first_size = 0;
  bool m_fits = false;
  bool m_has_infinite_faces = false;           // among the old faces
  std::vector<Boundary_edge_2> m_old_boundary; // sorted by source, then target
  std::vector<Index> m_region, m_new_number;
  Patch_2 m_new;
  std::vector<Index> m_disagreeing;
  std::vector<Index> m_looked_at; // the faces around vertices of the border that were read
};

// New faces that threads prepare for clusters before their turn comes, while nothing is written.
// Most splices do not touch each other: then the same faces would be made in turn, too.
//
// Whether this is so can be told from the faces that were read: the faces around the vertices of
// the cluster, and faces around vertices of its border, which are recorded as well. Suppose none of
// them was replaced since. Then the same new faces would be made in turn: of a face that was not
// replaced only a twin may have changed, from a half-edge of a replaced face to another half-edge
// of a replaced face. The same cluster would be collected, too: its vertices still have the same
// neighbors, and none of them was spliced. For suppose one was, although its faces were not
// replaced. Then it was in a cluster that kept its faces. Both clusters share this vertex, so they
// are the same, and this one has had its turn.
template <class State>
class Prepared_splices_2
{
  using Parts = typename State::Parts;
  using Cluster_splice = Cluster_splice_2<State>;

public:
  using Record = typename Cluster_splice::Record;

  explicit Prepared_splices_2(const State& state)
    : m_state(state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_engine = engine; }

  // Starts anew: the next call of prepare() drops all records.
  void clear() { m_beyond = 0; }

  // Has threads prepare the clusters that begin at the i-th vertex of `inner` or at one of the next
  // vertices, unless an earlier call has done that or the vertices are too few.
  void prepare(std::size_t i, const Index_set_2& inner, const Index_set_2& spliced,
               std::size_t max_enlargements)
  {
    if (i < m_beyond)
      return;
    const std::size_t size = (std::min)(inner.size() - i, most_at_once);
    const std::size_t parts = (std::min)(Parts::number(size, least), max_parts);
    m_beyond = i + size;
    m_place = {m_parts.size(), 0};
    if (!Parts::are_shared(parts))
      return;
    m_replaced.clear(m_state.arrays().number_of_faces());
    m_place = {0, 0};
    m_parts.resize((std::max)(parts, m_parts.size()));
    for (Part& part : m_parts)
      part.records.clear();
    Parts::run(parts, [&](std::size_t part) {
      prepare_part(m_parts[part], inner, spliced, i + Parts::begin(part, parts, size),
                   i + Parts::begin(part + 1, parts, size), max_enlargements);
    });
  }

  // Returns the record of the cluster that begins at the i-th inner vertex, if the same would be
  // made now within `limits`, and takes its cost from `limits`. Call it for ascending i.
  Record* find(std::size_t i, Splice_limits_2& limits)
  {
    Prepared* const prepared = next_from(i);
    if (prepared == nullptr || prepared->first != i || !is_fresh(prepared->record) ||
        prepared->vertices > limits.max_vertices)
      return nullptr;
    limits.max_vertices -= prepared->vertices;
    limits.enlargements += prepared->enlargements;
    return &prepared->record;
  }

  // Returns the record `number` places after the one found last, or null if its part has none.
  const Record* following(std::size_t number) const
  {
    const auto& records = m_parts[m_place.part].records;
    return m_place.number + number < records.size() ? &records[m_place.number + number].record
                                                    : nullptr;
  }

  // Notes the old faces of a splice. To be called for each one.
  void note_replaced(const Index_set_2& faces)
  {
    if (!is_anything_left())
      return;
    for (const Face_index f : faces)
      m_replaced.insert(f);
  }

private:
  struct Prepared
  {
    std::size_t first;                  // the number of the first vertex among the inner ones
    std::size_t vertices, enlargements; // what make() took from its limits
    Record record;
  };

  // The working memory of a part, and the records that were made in it.
  struct Part
  {
    std::unique_ptr<Cluster_splice> splice;
    Index_set_2 seen; // the vertices that were collected in this part
    std::vector<Prepared> records;
  };

  // A vertex takes a microsecond or more. Parts are few: each has sets of a bit a vertex or face.
  static constexpr std::size_t least = (std::max)(Parts::usual_size / 256, std::size_t(1));
  static constexpr std::size_t max_parts = 8, most_at_once = 1 << 15;
  // Larger clusters are not prepared: all parts would collect the same one.
  static constexpr std::size_t most_vertices = 256, most_triangulated = 2048;

  void prepare_part(Part& part, const Index_set_2& inner, const Index_set_2& spliced,
                    std::size_t first, std::size_t beyond, std::size_t max_enlargements) const
  {
    if (!part.splice)
      part.splice = std::make_unique<Cluster_splice>(m_state);
    part.splice->set_engine(m_engine);
    part.seen.clear(m_state.arrays().number_of_vertices());
    for (std::size_t i = first; i < beyond; ++i) {
      if (part.seen.contains(inner[i]) || spliced.contains(inner[i]) ||
          !collect(part, inner[i], inner, spliced))
        continue;
      Splice_limits_2 limits{max_enlargements, most_triangulated};
      if (part.splice->make(limits) == Splice_result_2::DONE)
        part.records.push_back({i, most_triangulated - limits.max_vertices, limits.enlargements,
                                part.splice->record()});
    }
  }

  // Collects the cluster of v. False if it is too large, or meets one that was too large.
  bool collect(Part& part, Vertex_index v, const Index_set_2& inner,
               const Index_set_2& spliced) const
  {
    bool is_whole = true;
    const auto belongs = [&](Vertex_index w) {
      const bool is_inner = inner.contains(w) && !spliced.contains(w);
      is_whole = is_whole && !(is_inner && part.seen.contains(w));
      return is_inner && is_whole;
    };
    is_whole = part.splice->collect(v, most_vertices, belongs) && is_whole;
    for (const Vertex_index w : part.splice->cluster())
      part.seen.insert(w);
    return is_whole;
  }

  bool is_fresh(const Record& record) const
  {
    const auto is_replaced = [this](Face_index f) { return m_replaced.contains(f); };
    const auto is_any_replaced = [&](const std::vector<Index>& faces) {
      return std::any_of(faces.begin(), faces.end(), is_replaced);
    };
    return !is_any_replaced(record.old_faces) && !is_any_replaced(record.looked_at);
  }

  // The place of a record.
  struct Place
  {
    std::size_t part, number;
  };

  // Goes on to the first record of a cluster that begins at the i-th inner vertex or later.
  Prepared* next_from(std::size_t i)
  {
    for (; is_anything_left(); ++m_place.part, m_place.number = 0) {
      auto& records = m_parts[m_place.part].records;
      for (; m_place.number < records.size(); ++m_place.number)
        if (records[m_place.number].first >= i)
          return &records[m_place.number];
    }
    return nullptr;
  }

  bool is_anything_left() const { return m_place.part < m_parts.size(); }

  const State& m_state;
  Static_engine_2 m_engine = Static_engine_2::GUIBAS_STOLFI;
  std::vector<Part> m_parts;
  Place m_place{0, 0};
  std::size_t m_beyond = 0; // inner vertices before this one were looked at
  Index_set_2 m_replaced;   // faces that were replaced since the last prepare()
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_CLUSTER_SPLICE_2_H
