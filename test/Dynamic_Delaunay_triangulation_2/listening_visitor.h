// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A visitor that knows all faces by its notifications alone, and the edges of a triangulation.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_LISTENING_VISITOR_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_LISTENING_VISITOR_H

#include "stamps.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

template <class Dynamic>
std::set<std::pair<std::size_t, std::size_t>> edges_of(const Dynamic& dt)
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j) { edges.insert(std::minmax(i, j)); });
  return edges;
}

// Checks that each notification of a face fits the ones before. Vertices and faces have stamps.
template <class Base = CGAL::Delaunay_update_visitor_base_2>
class Listening_visitor : public Base
{
public:
  template <class Dynamic>
  void before_flip(const Dynamic& dt, const typename Dynamic::Edge& e)
  {
    Base::before_flip(dt, e);
    forget(dt, e.first);
    forget(dt, e.first->neighbor(e.second));
  }

  template <class Dynamic>
  void after_flip(const Dynamic& dt, const typename Dynamic::Edge& e)
  {
    Base::after_flip(dt, e);
    learn(dt, e.first);
    learn(dt, e.first->neighbor(e.second));
  }

  template <class Dynamic>
  void before_face_removal(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    Base::before_face_removal(dt, f);
    forget(dt, f);
  }

  template <class Dynamic>
  void after_face_creation(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    Base::after_face_creation(dt, f);
    learn(dt, f);
  }

  template <class Dynamic>
  void after_id_change(const Dynamic& dt, typename Dynamic::Vertex_handle v, std::size_t id_before)
  {
    Base::after_id_change(dt, v, id_before);
    for (auto& face : m_faces) {
      const Vertex before{v->info().value, id_before}, now{v->info().value, dt.id(v)};
      std::replace(face.second.begin(), face.second.end(), before, now);
    }
  }

protected:
  template <class Dynamic>
  void expect_to_know_all_faces(const Dynamic& dt) const
  {
    std::map<std::size_t, Triple> faces;
    if (dt.tds().dimension() == 2)
      for (auto f = dt.tds().faces_begin(); f != dt.tds().faces_end(); ++f)
        faces.emplace(f->info().value, vertices_of(dt, f));
    EXPECT_TRUE(faces == m_faces);
  }

private:
  using Vertex = std::pair<std::size_t, std::size_t>; // its stamp and its id
  using Triple = std::array<Vertex, 3>;               // ascending, by stamps

  template <class Dynamic>
  static Triple vertices_of(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    Triple vertices;
    for (int i = 0; i < 3; ++i) {
      const auto v = f->vertex(i);
      vertices[std::size_t(i)] = {v->info().value,
                                  v == dt.infinite_vertex() ? std::size_t(-1) : dt.id(v)};
    }
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  template <class Dynamic>
  void forget(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    const auto known = m_faces.find(f->info().value);
    ASSERT_TRUE(known != m_faces.end());
    EXPECT_EQ(known->second, vertices_of(dt, f));
    m_faces.erase(known);
  }

  template <class Dynamic>
  void learn(const Dynamic& dt, typename Dynamic::Face_handle f)
  {
    EXPECT_TRUE(m_faces.emplace(f->info().value, vertices_of(dt, f)).second);
  }

  std::map<std::size_t, Triple> m_faces; // by their own stamps
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_LISTENING_VISITOR_H
