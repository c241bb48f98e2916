// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_PREPARED_SPLICES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_PREPARED_SPLICES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cluster_splice_2.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

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

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_PREPARED_SPLICES_2_H
