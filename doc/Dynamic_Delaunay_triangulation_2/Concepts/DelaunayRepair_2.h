// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A repair restores the neighborhoods that were classified. It uses the tools of a
`CGAL::Dynamic_mender_2`. Each tool leaves the triangulation a valid triangulated sphere, so no
repair can break it.

The cost of all tools of an update is limited: by that of two rebuilds, or less if the repair calls
`CGAL::Dynamic_mender_2::limit_cost()`. When it is spent, everything is rebuilt. If the classifier
is exact and the repair leaves edges open, the triangulation is rebuilt after it.

Where `CGAL::Dynamic_mender_2::can_hold()` is true, a repair may hold vertices back so that no face
is inverted. Flips then close all edges. A repair that calls `CGAL::Dynamic_mender_2::hold()` has to
call `CGAL::Dynamic_mender_2::flip()` and then `CGAL::Dynamic_mender_2::release()`, which lets the
held vertices move on to their positions.

After the repair the update inserts the vertices that the repair took out of their faces, coincident
points that separate, and new points. `CGAL::Hold_and_flip_repair_2` repairs what that breaks,
whatever the repair is, and also what `insert()`, `remove()` and `move()` break.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Hold_and_flip_repair_2}
\cgalHasModels{CGAL::Border_splice_repair_2}
\cgalHasModels{CGAL::Flip_repair_2}
\cgalHasModels{CGAL::Relocation_repair_2}
\cgalHasModels{CGAL::Rebuild_repair_2}
\cgalHasModels{CGAL::Repair_by_exactness_2}
\cgalHasModels{CGAL::Chosen_repair_2}
\cgalHasModelsEnd
*/
class DelaunayRepair_2
{
public:
  /*!
  repairs. It is called once in every frame in which something is classified, or in which removed
  points leave edges open, unless everything is rebuilt before. `CGAL::Hold_and_flip_repair_2`, and
  repairs that derive from it, may be called up to four times in a frame: once in each step, if the
  frame is taken in steps (\ref DynamicDelaunaySubsection_Steps).

  If it throws, the positions are the new ones, the data structure is valid, and the triangulation
  is not certified; the exception is rethrown.

  \param mender what was classified, which edges are open, and the tools. It is valid until the
  call ends.
  \tparam Mender `CGAL::Dynamic_mender_2`
  */
  template <class Mender>
  void operator()(Mender& mender);
};
