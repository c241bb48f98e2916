// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_RECORDED_CHANGES_H
#define PYTHON_RECORDED_CHANGES_H

#include <stdexcept>

namespace python {

// One of the visitors that list changed edges. It lists those of the last call, and none unless it
// is asked to when it is created.
template <class Visitor>
class Recorded_changes : public Visitor
{
public:
  Recorded_changes() = default;
  explicit Recorded_changes(bool is_on)
    : m_is_on(is_on)
  {
  }

  const auto& created_edges() const { return checked().created_edges(); }
  const auto& removed_edges() const { return checked().removed_edges(); }

  template <class Dynamic>
  void before_update(const Dynamic& dt)
  {
    if (m_is_on) {
      Visitor::clear();
      Visitor::before_update(dt);
    }
  }
  template <class... Arguments>
  void after_update(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_update(arguments...);
    }
  }

  // in the plane
  template <class... Arguments>
  void before_flip(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::before_flip(arguments...);
    }
  }
  template <class... Arguments>
  void after_flip(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_flip(arguments...);
    }
  }
  template <class... Arguments>
  void before_face_removal(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::before_face_removal(arguments...);
    }
  }
  template <class... Arguments>
  void after_face_creation(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_face_creation(arguments...);
    }
  }
  template <class... Arguments>
  void after_id_change(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_id_change(arguments...);
    }
  }

  // in periodic space
  template <class... Arguments>
  void after_edge_removal(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_edge_removal(arguments...);
    }
  }
  template <class... Arguments>
  void after_edge_creation(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_edge_creation(arguments...);
    }
  }
  template <class... Arguments>
  void after_translation(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_translation(arguments...);
    }
  }
  template <class... Arguments>
  void after_cell_exchange(const Arguments&... arguments)
  {
    if (m_is_on) {
      Visitor::after_cell_exchange(arguments...);
    }
  }

private:
  const Visitor& checked() const
  {
    if (!m_is_on) {
      throw std::invalid_argument("changed edges are recorded only with changes=True");
    }
    return *this;
  }

  bool m_is_on = false;
};

} // namespace python

#endif // PYTHON_RECORDED_CHANGES_H
