// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A repair mends what was classified. It does so with the tools of a `Dynamic_mender_2`, each of which leaves
the triangulation a valid triangulated sphere, so that no repair can break it.

If the classifier is exact and the repair leaves edges open, the triangulation is rebuilt after it.

\cgalHasModelsBegin
\cgalHasModels{Flip_and_splice_repair_2}
\cgalHasModels{Border_splice_repair_2}
\cgalHasModels{Flip_repair_2}
\cgalHasModels{Relocation_repair_2}
\cgalHasModels{Rebuild_repair_2}
\cgalHasModelsEnd
*/
class DelaunayRepair_2
{
public:
  /*!
  repairs. It is called once in every frame in which at least one vertex is classified.

  If it throws, the positions are the new ones, the data structure is valid and the triangulation not certified; the
  exception is handed on.

  \param mender what was classified, which edges are open, and the tools. It is good until the call ends.
  \tparam Mender `Dynamic_mender_2`
  */
  template <class Mender>
  void operator()(Mender& mender);
};
