// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A classifier that records the stamps of the vertices of each vertex, edge and face index, and
// compares after every update: indices that are not reported as changed must keep their stamps.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CHANGE_LEDGER_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CHANGE_LEDGER_H

#include "stamps.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <vector>

// Classifies as `Classifier` does.
template <class Classifier>
class Change_ledger : public Classifier
{
public:
  static constexpr bool is_exact = Classifier::is_exact;

  explicit Change_ledger(const Classifier& classifier = Classifier())
    : Classifier(classifier)
  {
  }

  // To be called before the first point is inserted.
  template <class Dynamic>
  void watch(const Dynamic& dt) const
  {
    *m_stamp_of_id = [&dt](std::size_t id) { return stamp_of(dt, id); };
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    if (frame.everything_is_new())
      write_all(frame);
    else
      compare(frame);
    CGAL::inform_classifier(static_cast<Classifier&>(*this), frame);
  }

private:
  using Edge_index = CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
  using Face_index = CGAL::Dynamic_Delaunay_triangulations_2::Face_index;
  using Vertex_index = CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Stamps_of_edge = std::array<std::size_t, 4>; // of both ends, and of both vertices opposite
  using Stamps_of_face = std::array<std::size_t, 3>;

  static constexpr std::size_t at_infinity = std::size_t(-1);

  template <class Frame>
  void write_all(const Frame& frame)
  {
    m_vertices.clear();
    m_edges.clear();
    m_faces.clear();
    for (Vertex_index v(0); v <= frame.number_of_vertices(); ++v)
      m_vertices.push_back(stamp(frame, v));
    for (Edge_index e(0); e < frame.number_of_edges(); ++e)
      m_edges.push_back(stamps_of_edge(frame, e));
    for (Face_index f(0); f < frame.number_of_faces(); ++f)
      m_faces.push_back(stamps_of_face(frame, f));
  }

  template <class Frame>
  void compare(const Frame& frame)
  {
    const std::set<std::size_t> known(m_vertices.begin(), m_vertices.end());
    frame.follow_vertices(m_vertices, [&](Vertex_index v) {
      EXPECT_EQ(known.count(stamp(frame, v)), 0u) << "vertex " << v << " has not come";
      return stamp(frame, v);
    });
    ASSERT_EQ(m_vertices.size(), frame.number_of_vertices() + std::size_t(1));
    for (Vertex_index v(0); v <= frame.number_of_vertices(); ++v)
      ASSERT_EQ(m_vertices[v], stamp(frame, v)) << "vertex " << v;
    compare_edges(frame);
    compare_faces(frame);
  }

  template <class Frame>
  void compare_edges(const Frame& frame)
  {
    frame.follow_edges(m_edges);
    ASSERT_EQ(m_edges.size(), frame.number_of_edges());
    std::set<Edge_index> changed;
    frame.for_each_changed_edge([&](Edge_index e) { changed.insert(e); });
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const Stamps_of_edge now = stamps_of_edge(frame, e);
      if (changed.count(e) == 0) {
        ASSERT_EQ(m_edges[e], now) << "edge " << e;
      }
      m_edges[e] = now;
    }
  }

  template <class Frame>
  void compare_faces(const Frame& frame)
  {
    frame.follow_faces(m_faces);
    ASSERT_EQ(m_faces.size(), frame.number_of_faces());
    std::set<Face_index> changed;
    frame.for_each_changed_face([&](Face_index f) { changed.insert(f); });
    for (Face_index f(0); f < frame.number_of_faces(); ++f) {
      const Stamps_of_face now = stamps_of_face(frame, f);
      if (changed.count(f) == 0) {
        ASSERT_EQ(m_faces[f], now) << "face " << f;
      }
      m_faces[f] = now;
    }
  }

  template <class Frame>
  std::size_t stamp(const Frame& frame, Vertex_index v) const
  {
    return frame.is_infinite(v) ? at_infinity : (*m_stamp_of_id)(frame.id(v));
  }

  template <class Frame>
  Stamps_of_edge stamps_of_edge(const Frame& frame, Edge_index e) const
  {
    const auto& edge = frame.edge(e);
    Stamps_of_edge stamps{stamp(frame, edge.source), stamp(frame, edge.target),
                          stamp(frame, edge.left), stamp(frame, edge.right)};
    std::sort(stamps.begin(), stamps.begin() + 2);
    std::sort(stamps.begin() + 2, stamps.end());
    return stamps;
  }

  template <class Frame>
  Stamps_of_face stamps_of_face(const Frame& frame, Face_index f) const
  {
    const auto face = frame.face(f);
    Stamps_of_face stamps{stamp(frame, face[0]), stamp(frame, face[1]), stamp(frame, face[2])};
    std::sort(stamps.begin(), stamps.end());
    return stamps;
  }

  std::shared_ptr<std::function<std::size_t(std::size_t)>> m_stamp_of_id =
      std::make_shared<std::function<std::size_t(std::size_t)>>();
  std::vector<std::size_t> m_vertices;
  std::vector<Stamps_of_edge> m_edges;
  std::vector<Stamps_of_face> m_faces;
};

// A triangulation whose classifier is a change ledger.
template <class Kernel, class Classifier, class Repair = CGAL::Default>
using Watched_triangulation = CGAL::Dynamic_Delaunay_triangulation_2<
    Kernel, Change_ledger<Classifier>, CGAL::With_repair_2<Repair>,
    CGAL::With_data_structure_2<Stamped_data_structure<Kernel>>>;

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_CHANGE_LEDGER_H
