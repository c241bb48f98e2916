// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_MENDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_MENDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The tools of a repair, which may call them in any order. A mender knows the classification, and
which edges are *open*, that is, not yet proved Delaunay. Each tool works on the open edges, and
leaves open what it could not prove. The edges that are open at the start are those that the
classifier named, and all edges of the vertices that it named. If the same update removes points,
the edges that this changed are open, too. Points are inserted after the repair.

The total cost of all tools in an update is limited. A tool that reaches the limit rebuilds the
triangulation, for the reason `Rebuild_reason_2::BUDGET_SPENT`. After a rebuild no edge is open, and
tools do nothing.

In periodic space splices work otherwise. `splice_classified()` flips the edges around the
classified and padded vertices. `splice_open()` and `relocate()` take the vertices of a region out,
and insert them anew after the repair. With a heuristic classifier these two examine all edges
first, since points can be inserted only if all edges are proved.

\tparam Repair_tools an internal type.
*/
template <class Repair_tools>
class Dynamic_mender_2
{
public:
  /// the type of all numbers, as in `Dynamic_frame_2`.
  using Index = Dynamic_Delaunay_triangulations_2::Index;

  /// \cond
  explicit Dynamic_mender_2(Repair_tools& tools)
    : m_tools(tools)
  {
  }
  /// \endcond

  /// \name Remaining Work
  /// @{

  /// the classification.
  const typename Repair_tools::Classification& classification() const
  {
    return m_tools.context.classification;
  }
  /// whether the update has to end with a proof, that is, the classifier is exact. If so, and if
  /// the repair leaves edges open, the triangulation is rebuilt after the repair.
  bool has_to_prove() const;
  /// the number of open edges.
  std::size_t number_of_open_edges() const;
  /// the number of all edges.
  std::size_t number_of_edges() const;
  /// whether no work is left: no edge is open, or the triangulation was rebuilt.
  bool is_done() const { return number_of_open_edges() == 0 || m_tools.context.has_rebuilt(); }
  /// whether a rebuild is expected to cost less than mending all that was classified, and inserting
  /// and removing the points of the same update.
  bool is_rebuild_cheaper() const;

  /// @}
  /// \name Tools
  /// @{

  /// limits what the tools may spend from now on: the expected cost of mending the open edges and a
  /// quarter more, plus an eighth of the cost of a rebuild, but at most that of one rebuild.
  /// Without this call the limit is the cost of two rebuilds. A constant is added to both limits;
  /// it matters for small triangulations.
  void limit_cost();

  /// whether `hold()` can work: the classifier is exact, and the triangulation was certified before
  /// its points moved.
  bool can_hold() const;

  /// holds vertices back so that all finite faces are counterclockwise and tile the convex hull. A
  /// vertex that would turn a face over goes where the mean displacement of its neighbors takes it,
  /// or stays where it was before the points moved. Flips only edges at the hull, and what follows
  /// from that. Does nothing unless `can_hold()`; rebuilds where so many vertices have
  /// to be held that this costs more, or if the hull cannot be made convex. After it `flip()`
  /// closes all edges. Expected cost: proportional to the number of open edges and of held
  /// vertices.
  void hold();

  /// lets the held vertices move on to their positions, as far as no face turns over, and flips
  /// around them. The vertices that cannot arrive are taken out of their faces, and inserted at
  /// their positions after the repair. One that cannot be taken out either, as at a side of a slab,
  /// goes to its position, and the edges around it are open then. Rebuilds if edges are open
  /// before. Expected cost: proportional to the number of held vertices.
  void release();

  /// flips edges (Lawson), starting at the open ones, until no flippable edge violates the
  /// in-circle condition. Expected cost: proportional to the number of flips. Edges that it cannot
  /// repair stay open: flips can get stuck at inverted faces.
  void flip();

  /// splices around the classified vertices with `padding` layers. With a heuristic classifier all
  /// edges count as closed afterwards, whether they were tested or not. Rebuilds if a region holds
  /// more than half of the vertices, also after it was enlarged. With a heuristic classifier it
  /// also rebuilds if points in a region coincide; with an exact one they become one vertex, and
  /// the edges that this changes are open. It rebuilds as well if fewer than three vertices would
  /// stay.
  void splice_classified(unsigned padding);

  /// splices around the vertices of the open edges with `padding` layers. Edges that it could not
  /// prove stay open, also around a region that would have to be enlarged too often. Rebuilds in
  /// the same cases as `splice_classified()`.
  void splice_open(unsigned padding);

  /// lets CGAL's `move_if_no_collision()` move one vertex after the other from its position one
  /// frame ago to the current one, in a copy, and takes over the result. Rebuilds if the
  /// triangulation was not certified a frame ago, if it was rebuilt since, if points coincide, if
  /// the same update inserts or removes points, or if the result is not proved Delaunay.
  void relocate();

  /// triangulates everything anew, in the order of the last triangulation, and closes all edges.
  /// This may renumber the vertices, so it empties the sets of classified, padded and border
  /// vertices.
  void rebuild(Rebuild_reason_2 reason);

  /// @}

private:
  Repair_tools& m_tools;
};

// Defined outside of the class, so that they are not inline: where they are declared extern,
// compilers leave out all that they call, which is most of the package (`compiled_updates.h`).
template <class Repair_tools>
bool Dynamic_mender_2<Repair_tools>::has_to_prove() const
{
  return m_tools.context.proof.is_required();
}
template <class Repair_tools>
std::size_t Dynamic_mender_2<Repair_tools>::number_of_open_edges() const
{
  return m_tools.context.proof.size();
}
template <class Repair_tools>
std::size_t Dynamic_mender_2<Repair_tools>::number_of_edges() const
{
  return m_tools.context.state.arrays().number_of_edges();
}
template <class Repair_tools>
bool Dynamic_mender_2<Repair_tools>::is_rebuild_cheaper() const
{
  return m_tools.context.is_rebuild_cheaper();
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::limit_cost()
{
  m_tools.context.limit_cost();
}
template <class Repair_tools>
bool Dynamic_mender_2<Repair_tools>::can_hold() const
{
  return m_tools.context.can_hold();
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::hold()
{
  m_tools.holds.hold();
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::release()
{
  m_tools.holds.release();
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::flip()
{
  m_tools.flips.flip();
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::splice_classified(unsigned padding)
{
  m_tools.regions.splice_classified(padding);
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::splice_open(unsigned padding)
{
  m_tools.regions.splice_open(padding);
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::relocate()
{
  m_tools.regions.relocate();
}
template <class Repair_tools>
void Dynamic_mender_2<Repair_tools>::rebuild(Rebuild_reason_2 reason)
{
  m_tools.context.rebuild(reason);
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_MENDER_2_H
