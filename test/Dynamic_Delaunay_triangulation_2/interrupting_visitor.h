// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A visitor that throws in the middle of a call.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_INTERRUPTING_VISITOR_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_INTERRUPTING_VISITOR_H

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <stdexcept>

// The exception that tests throw from a visitor or a classifier.
struct Refusal : std::runtime_error
{
  Refusal()
    : std::runtime_error("it has had enough")
  {
  }
};

// Throws at the n-th change that it is notified of between the beginning and the end of a call.
class Interrupting_visitor : public CGAL::Delaunay_update_visitor_base_2
{
public:
  void throw_at(int n) { m_left = n; }
  bool has_thrown() const { return m_left == 0; }

  template <class... Arguments>
  void before_flip(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void before_face_removal(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void after_face_creation(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void after_vertex_creation(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void before_vertex_removal(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void before_vertex_relocation(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void before_vertex_merge(const Arguments&...)
  {
    hear();
  }
  template <class... Arguments>
  void after_id_change(const Arguments&...)
  {
    hear();
  }

protected:
  void hear()
  {
    if (m_left > 0 && --m_left == 0)
      throw Refusal();
  }

private:
  int m_left = -1;
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_INTERRUPTING_VISITOR_H
