// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_POPULATION_2_H
#define CGAL_DYNAMIC_POPULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_population_base.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/Dynamic_triangulation_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <cstdint>
#include <string_view>
#include <type_traits>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_2::internal {

// What a population takes from its triangulation. A periodic one has no vertex handles.
template <class Dynamic, class = void>
struct Population_traits_2
{
  struct Vertex_handle
  {
  };
  static constexpr std::string_view checkpoint_subject = "periodic Dynamic_population_2";
};
template <class Dynamic>
struct Population_traits_2<Dynamic, std::void_t<typename Dynamic::Vertex_handle>>
{
  using Vertex_handle = typename Dynamic::Vertex_handle;
  static constexpr std::string_view checkpoint_subject = "Dynamic_population_2";
};

} // namespace Dynamic_Delaunay_triangulations_2::internal

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Maintains the Delaunay triangulation of a population that changes while it moves, as in tracking
data and crowds. Every frame lists the points that exist, by ids that the user chooses. Points with
new ids are inserted, points whose ids are missing are removed, and the others move.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2`, or a
  `Dynamic_periodic_Delaunay_triangulation_2`, which has no vertex handles.
\tparam UserId any integer type.
*/
template <class Dynamic, class UserId = std::int64_t>
class Dynamic_population_2
  : public Dynamic_population_base<Dynamic_population_2<Dynamic, UserId>, Dynamic, UserId>
{
  using Base = Dynamic_population_base<Dynamic_population_2, Dynamic, UserId>;
  friend Base;
  using Traits = Dynamic_Delaunay_triangulations_2::internal::Population_traits_2<Dynamic>;
  static constexpr std::string_view checkpoint_subject = Traits::checkpoint_subject;

public:
  using Base::Base;

  /// a vertex of the CGAL triangulation.
  using Vertex_handle = typename Traits::Vertex_handle;

  using Base::user_id;

  /// the vertex of a point. \throws Unknown_user_id_error_2 if no point has this id.
  Vertex_handle vertex(UserId user_id) const
  {
    return this->triangulation().vertex(this->id(user_id));
  }
  /// the user's id of the point at a finite vertex. If several points share the vertex, this is the
  /// id of their representative, the one that was there first.
  UserId user_id(Vertex_handle vertex) const { return user_id(this->triangulation().id(vertex)); }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_POPULATION_2_H
