// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

An update policy decides in every frame whether the triangulation is rebuilt at once, or classified
and repaired. A frame that is rebuilt for a policy ends certified, also with a heuristic classifier,
and its report has `CGAL::Rebuild_reason_2::POLICY`.

The constructor of the triangulation copies the policy. A policy may keep data of its own from frame
to frame. Its decisions should depend on what it reads and counts, not on clocks; then updates stay
deterministic.

Triangulations of points in space take the same policies but `CGAL::Hybrid_policy_2`, which they do not
need: where much is broken, a sample of cells tells whether to rebuild. Their policies get a
`CGAL::Dynamic_frame_3` and a `CGAL::Update_report_3`. They are asked in frames in which the points span
space. In a frame of a `CGAL::Dynamic_population_3`, points that go have gone when the policy is asked; if
it throws then, the others have their new positions, and there are no cells until the next call.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Always_dynamic_policy_2}
\cgalHasModels{CGAL::Always_static_policy_2}
\cgalHasModels{CGAL::Hybrid_policy_2}
\cgalHasModels{CGAL::Key_frame_policy_2}
\cgalHasModels{CGAL::Chosen_policy_2}
\cgalHasModelsEnd
*/
class DelaunayUpdatePolicy_2
{
public:
  /*!
  whether this frame is to be rebuilt without calling the classifier. It is called before the
  classifier in every frame in which the points span the plane, unless many points are inserted or
  removed, or many coincident points separate (then the triangulation is rebuilt anyway).

  If it throws, the update changes nothing and rethrows the exception.

  \param frame the points at the positions of the current frame, with the topology of the last one.
  \tparam Frame `CGAL::Dynamic_frame_2`, in space `CGAL::Dynamic_frame_3`
  \return `true` to rebuild.
  */
  template <class Frame>
  bool wants_rebuild(const Frame& frame);

  /*!
  is called at the end of every update with its report, also if `wants_rebuild()` was not called for
  it. A frame of a `CGAL::Dynamic_population_2` is one update. Construction, `insert()`, `remove()`,
  `move()` and `CGAL::Dynamic_Delaunay_triangulation_2::mend()` are no updates.

  If it throws, the update has been done, and the exception is rethrown.

  \param frame the points, with the topology at the end of the update.
  \param report what the update did.
  \tparam Frame `CGAL::Dynamic_frame_2`, in space `CGAL::Dynamic_frame_3`
  \tparam Report `CGAL::Update_report_2`, in space `CGAL::Update_report_3`
  */
  template <class Frame, class Report>
  void after_update(const Frame& frame, const Report& report);
};
