// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

An update policy decides, frame by frame, whether the triangulation is rebuilt at once, or classified and
repaired. A frame that it has rebuilt ends certified, also with a heuristic classifier, and its report has
`CGAL::Rebuild_reason_2::POLICY`.

A policy is copied into the triangulation when that is constructed, and may keep data of its own from frame
to frame. To keep updates deterministic it goes by what it sees and counts, not by clocks.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Always_dynamic_policy_2}
\cgalHasModels{CGAL::Always_static_policy_2}
\cgalHasModels{CGAL::Hybrid_policy_2}
\cgalHasModels{CGAL::Key_frame_policy_2}
\cgalHasModelsEnd
*/
class DelaunayUpdatePolicy_2
{
public:
  /*!
  whether this frame is to be rebuilt, without asking the classifier. It is asked before the classifier, at
  the positions of the current frame and with the topology of the last one, in every frame in which the points
  span the plane, unless many points come or go, or many coincident points part (then the triangulation is rebuilt
  anyway).

  If it throws, the update changes nothing and hands the exception on.

  \param frame the points at the positions of the current frame, with the topology of the last one.
  \tparam Frame `CGAL::Dynamic_frame_2`
  \return `true` to rebuild.
  */
  template <class Frame>
  bool wants_rebuild(const Frame& frame);

  /*!
  is called at the end of every update, also of one for which `wants_rebuild()` was not asked, with what it has done.
  A frame of a `CGAL::Dynamic_population_2` is one update. Construction,
  `CGAL::Dynamic_Delaunay_triangulation_2::mend()`, and points that come, go or move alone are none.

  If it throws, the update has been done, and the exception is handed on.

  \param frame the points, with the topology that the update ends with.
  \param report what the update has done.
  \tparam Frame `CGAL::Dynamic_frame_2`
  */
  template <class Frame>
  void after_update(const Frame& frame, const Update_report_2& report);
};
