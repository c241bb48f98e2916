// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A repair mends what was classified. It does so with the tools of a `CGAL::Dynamic_mender_2`, each of which leaves
the triangulation a valid triangulated sphere, so that no repair can break it.

What the tools of an update may cost together is limited: by two rebuilds, or less if the repair calls
`CGAL::Dynamic_mender_2::limit_cost()`. When that is spent, everything is rebuilt. If the classifier is exact and the
repair leaves edges open, the triangulation is rebuilt after it.

Vertices that the repair takes out of their faces, coincident points that part, and points that come are put in after
it. What that breaks is mended by `CGAL::Flip_and_splice_repair_2`, whatever the repair is, and so is what breaks where
points come, go or move alone.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Flip_and_splice_repair_2}
\cgalHasModels{CGAL::Border_splice_repair_2}
\cgalHasModels{CGAL::Flip_repair_2}
\cgalHasModels{CGAL::Relocation_repair_2}
\cgalHasModels{CGAL::Rebuild_repair_2}
\cgalHasModelsEnd
*/
class DelaunayRepair_2
{
public:
  /*!
  repairs. It is called once in every frame in which something is classified, or in which points go, unless everything
  is rebuilt before.

  If it throws, the positions are the new ones, the data structure is valid and the triangulation not certified; the
  exception is handed on.

  \param mender what was classified, which edges are open, and the tools. It is good until the call ends.
  \tparam Mender `CGAL::Dynamic_mender_2`
  */
  template <class Mender>
  void operator()(Mender& mender);
};
