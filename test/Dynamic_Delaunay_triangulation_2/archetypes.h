// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Models of the concepts that offer only what the reference pages of the concepts demand.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ARCHETYPES_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ARCHETYPES_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/enum.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>
#include <CGAL/version.h>

#include <cstddef>
#include <ostream>

// A point with a name. Coordinates alone do not make one, and there are no comparison operators.
class Named_point_archetype
{
public:
  Named_point_archetype() = default;
  static Named_point_archetype at(float x, float y, int name)
  {
    Named_point_archetype p;
    p.m_x = x;
    p.m_y = y;
    p.m_name = name;
    return p;
  }

  float x() const { return m_x; }
  float y() const { return m_y; }
  int name() const { return m_name; }

  friend std::ostream& operator<<(std::ostream& out, const Named_point_archetype& p)
  {
    return out << p.m_x << ' ' << p.m_y;
  }

private:
  float m_x = 0, m_y = 0;
  int m_name = 0;
};

// DynamicDelaunayTraits_2
class Delaunay_traits_archetype
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

  static Kernel::Point_2 place(const Named_point_archetype& p)
  {
    return Kernel::Point_2(double(p.x()), double(p.y()));
  }

public:
  using Point_2 = Named_point_archetype;
  struct Segment_2
  {
    Point_2 source, target;
  };
  struct Triangle_2
  {
    Point_2 p, q, r;
  };

  struct Compare_x_2
  {
    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const
    {
      return CGAL::compare(p.x(), q.x());
    }
  };
  struct Compare_y_2
  {
    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const
    {
      return CGAL::compare(p.y(), q.y());
    }
  };
#if CGAL_VERSION_NR >= 1060000000 // demanded by the refined concept from CGAL 6.0 on
  struct Compare_xy_2
  {
    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const
    {
      const CGAL::Comparison_result x = CGAL::compare(p.x(), q.x());
      return x != CGAL::EQUAL ? x : CGAL::compare(p.y(), q.y());
    }
  };
  Compare_xy_2 compare_xy_2_object() const
  {
    return {};
  }
#endif
  struct Less_x_2
  {
    bool operator()(const Point_2& p, const Point_2& q) const { return p.x() < q.x(); }
  };
  struct Less_y_2
  {
    bool operator()(const Point_2& p, const Point_2& q) const { return p.y() < q.y(); }
  };
  struct Orientation_2
  {
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const
    {
      return CGAL::orientation(place(p), place(q), place(r));
    }
  };
  struct Side_of_oriented_circle_2
  {
    CGAL::Oriented_side operator()(const Point_2& p, const Point_2& q, const Point_2& r,
                                   const Point_2& s) const
    {
      return CGAL::side_of_oriented_circle(place(p), place(q), place(r), place(s));
    }
  };
  struct Construct_point_2
  {
    const Point_2& operator()(const Point_2& p) const { return p; }
  };
  struct Construct_segment_2
  {
    Segment_2 operator()(const Point_2& p, const Point_2& q) const { return {p, q}; }
  };
  struct Construct_triangle_2
  {
    Triangle_2 operator()(const Point_2& p, const Point_2& q, const Point_2& r) const
    {
      return {p, q, r};
    }
  };

  Compare_x_2 compare_x_2_object() const
  {
    return {};
  }
  Compare_y_2 compare_y_2_object() const
  {
    return {};
  }
  Less_x_2 less_x_2_object() const
  {
    return {};
  }
  Less_y_2 less_y_2_object() const
  {
    return {};
  }
  Orientation_2 orientation_2_object() const
  {
    return {};
  }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const
  {
    return {};
  }
  Construct_point_2 construct_point_2_object() const
  {
    return {};
  }
  Construct_segment_2 construct_segment_2_object() const
  {
    return {};
  }
  Construct_triangle_2 construct_triangle_2_object() const
  {
    return {};
  }
};

// DelaunayClassifier_2, an exact one. It can be copied, as a triangulation takes a copy.
class Classifier_archetype
{
public:
  static constexpr bool is_exact = true;

  static Classifier_archetype make() { return Classifier_archetype(); }
  Classifier_archetype(const Classifier_archetype&) = default;
  Classifier_archetype& operator=(const Classifier_archetype&) = delete;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e)
      if (!frame.is_delaunay(e))
        classified.add_edge(e);
  }

private:
  Classifier_archetype() = default;
};

// DelaunayRepair_2, which leaves much open.
class Repair_archetype
{
public:
  static Repair_archetype make() { return Repair_archetype(); }
  Repair_archetype(const Repair_archetype&) = default;
  Repair_archetype& operator=(const Repair_archetype&) = delete;

  template <class Mender>
  void operator()(Mender& mender)
  {
    mender.flip();
  }

private:
  Repair_archetype() = default;
};

// DelaunayUpdatePolicy_2: every fourth update is a rebuild.
class Policy_archetype
{
public:
  static Policy_archetype make() { return Policy_archetype(); }
  Policy_archetype(const Policy_archetype&) = default;
  Policy_archetype& operator=(const Policy_archetype&) = delete;

  template <class Frame>
  bool wants_rebuild(const Frame&)
  {
    return m_updates % 4 == 3;
  }
  template <class Frame>
  void after_update(const Frame&, const CGAL::Update_report_2&)
  {
    ++m_updates;
  }

private:
  Policy_archetype() = default;

  std::size_t m_updates = 0;
};

// DelaunayUpdateVisitor_2, without the base that has all functions.
class Visitor_archetype
{
public:
  static Visitor_archetype make() { return Visitor_archetype(); }
  Visitor_archetype(const Visitor_archetype&) = default;
  Visitor_archetype& operator=(const Visitor_archetype&) = delete;

  template <class Dynamic>
  void before_update(const Dynamic&)
  {
  }
  template <class Dynamic>
  void after_update(const Dynamic&, const CGAL::Update_report_2&)
  {
  }
  template <class Dynamic>
  void before_flip(const Dynamic&, const typename Dynamic::Edge&)
  {
  }
  template <class Dynamic>
  void after_flip(const Dynamic&, const typename Dynamic::Edge&)
  {
  }
  template <class Dynamic>
  void before_face_removal(const Dynamic&, typename Dynamic::Face_handle)
  {
  }
  template <class Dynamic>
  void after_face_creation(const Dynamic&, typename Dynamic::Face_handle)
  {
  }
  template <class Dynamic>
  void after_vertex_creation(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }
  template <class Dynamic>
  void before_vertex_removal(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }
  template <class Dynamic>
  void before_vertex_relocation(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }
  template <class Dynamic>
  void before_vertex_merge(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t,
                           typename Dynamic::Vertex_handle)
  {
  }
  template <class Dynamic>
  void after_id_change(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }

private:
  Visitor_archetype() = default;
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ARCHETYPES_H
