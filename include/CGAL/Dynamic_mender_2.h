// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_MENDER_2_H
#define CGAL_DYNAMIC_MENDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Repair_tools_2.h>
#include <CGAL/Update_report_2.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The tools of a repair, which calls them in the order that it likes. A mender knows what was
classified and which edges are still *open*, that is, not yet proved Delaunay; each tool works on
these, and leaves open what it could not prove. At the start the open edges are those that the
classifier named, and all edges of the vertices that it named; where points go in the same update,
also those that this has changed. Points that come are put in after the repair.

What all tools of an update may cost together is limited. When that is spent, the next tool rebuilds
the triangulation, for the reason `Rebuild_reason_2::BUDGET_SPENT`. After a rebuild no edge is open,
and tools do nothing.

\tparam Maintained an internal type.
*/
template <class Maintained>
class Dynamic_mender_2
{
  using Repair_tools = Dynamic_Delaunay_triangulations_2::internal::Repair_tools_2<Maintained>;

public:
  /// as in `Dynamic_frame_2`.
  using Index = Dynamic_Delaunay_triangulations_2::Index;

  /// \cond
  explicit Dynamic_mender_2(Repair_tools& tools)
    : m_tools(tools)
  {
  }
  /// \endcond

  /// \name What There Is to Do
  /// @{

  /// what the classifier picked.
  const Dynamic_classification_2<Maintained>& classification() const
  {
    return static_cast<const Repair_tools&>(m_tools).classification();
  }
  /// whether the update has to end with a proof: the classifier is exact. If it has, and edges are
  /// left open, the triangulation is rebuilt after the repair.
  bool has_to_prove() const { return m_tools.has_to_prove(); }
  /// the number of open edges.
  std::size_t number_of_open_edges() const { return m_tools.open_edges().size(); }
  /// whether there are open edges other than those between faces that are known to be
  /// counterclockwise.
  bool has_inverted_edges() const { return !m_tools.open_edges().uncertain().empty(); }
  /// the number of all edges.
  std::size_t number_of_edges() const { return m_tools.number_of_edges(); }
  /// whether there is nothing left to do.
  bool is_done() const { return number_of_open_edges() == 0 || m_tools.has_rebuilt(); }
  /// whether a rebuild is expected to cost less than mending all that was classified.
  bool is_rebuild_cheaper() const { return m_tools.is_rebuild_cheaper(); }

  /// @}
  /// \name Tools
  /// @{

  /// lets the tools spend from now on a quarter more than mending the open edges is expected to
  /// cost, and an eighth of what a rebuild does. Without it they may spend two rebuilds.
  void limit_cost() { m_tools.limit_cost(); }

  /// takes those vertices out of their faces that went farther than their neighborhoods reach, of
  /// the vertices at open edges that may have inverted faces. After the repair they are put in
  /// again where they are now. Cost: proportional to their number; rebuilds if they are so many
  /// that this costs less. Does nothing if the classifier is heuristic.
  void take_out_jumpers() { m_tools.take_out_jumpers(); }

  /// takes a vertex out for each open edge that may have inverted faces: of its four vertices the
  /// one that went farthest as seen from the others. For what flips have left. Otherwise the same.
  void take_out_farthest() { m_tools.take_out_farthest(); }

  /// flips edges from the open ones on until none that can be flipped violates the in-circle
  /// condition (Lawson). Expected cost: proportional to the number of flips. Leaves open what it
  /// cannot right: at inverted faces flips can get stuck.
  void flip() { m_tools.flip(); }

  /// the same for those open edges only that may have inverted faces, and what is around them; the
  /// others stay open. If none is left, the faces tile the convex hull, which makes other flips
  /// cheaper: they cannot double an edge, so that need not be looked for.
  void flip_inverted() { m_tools.flip_inverted(); }

  /// splices around the classified vertices with `padding` layers; with a heuristic classifier all
  /// edges count as closed after it, looked at or not. Rebuilds if a region holds more than half of
  /// the vertices, also after it had to grow, or, with a heuristic classifier, if points in it
  /// coincide; with an exact one they become one vertex, and what that changes is open.
  void splice_classified(unsigned padding) { m_tools.splice_classified(padding); }

  /// splices around the vertices of the open edges with `padding` layers, and leaves those edges
  /// open that it could not prove, also around a region that would have to grow too often. Rebuilds
  /// as `splice_classified()` does.
  void splice_open(unsigned padding) { m_tools.splice_open(padding); }

  /// the same around those open edges only that may have inverted faces.
  void splice_inverted(unsigned padding) { m_tools.splice_inverted(padding); }

  /// lets CGAL's `move_if_no_collision()` bring one vertex after the other from where it was a
  /// frame ago to where it is now. Rebuilds if the triangulation was not certified a frame ago, if
  /// it was rebuilt since, if points coincide, or if points come or go in the same update.
  void relocate() { m_tools.relocate(); }

  /// triangulates everything anew, in the order of the last triangulation, and closes all edges.
  /// That may number the vertices anew, so the sets of classified, padded and border vertices are
  /// empty then.
  void rebuild(Rebuild_reason_2 reason) { m_tools.rebuild(reason); }

  /// @}

private:
  Repair_tools& m_tools;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_MENDER_2_H
