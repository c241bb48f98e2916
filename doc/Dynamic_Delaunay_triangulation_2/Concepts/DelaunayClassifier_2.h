// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A classifier picks, frame by frame, the vertices whose neighborhoods may no longer be Delaunay. It
sees the maintained triangulation through a `CGAL::Dynamic_frame_2`, with the topology of the last
frame and the positions of the current one.

A classifier is copied into the triangulation when that is constructed, and may keep data of its own
from frame to frame.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Circumcircle_classifier_2}
\cgalHasModels{CGAL::Safe_region_classifier_2}
\cgalHasModels{CGAL::Point_distance_classifier_2}
\cgalHasModels{CGAL::Predictive_point_distance_classifier_2}
\cgalHasModels{CGAL::Inflation_aware_classifier_2}
\cgalHasModels{CGAL::Voronoi_circumcenter_classifier_2}
\cgalHasModels{CGAL::Estimated_voronoi_circumcenter_classifier_2}
\cgalHasModels{CGAL::Voronoi_edge_length_classifier_2}
\cgalHasModels{CGAL::Nearly_delaunay_classifier_2}
\cgalHasModels{CGAL::Random_classifier_2}
\cgalHasModels{CGAL::Refined_classifier_2}
\cgalHasModelsEnd
*/
class DelaunayClassifier_2
{
public:
  /*!
  whether the classifier is *exact*: of every edge that is not Delaunay at the current positions
  (`CGAL::Dynamic_frame_2::is_delaunay()`), it classifies at least one end by
  `CGAL::Dynamic_classification_2::add_vertex()` or `CGAL::Dynamic_classification_2::add_id()`, or
  it hands the edge to `CGAL::Dynamic_classification_2::add_edge()`. That has to hold whatever state
  the last frame was left in.

  Updates with an exact classifier end with the certificate. The claim is not checked again: a
  classifier that makes it wrongly breaks the promise of
  `CGAL::Dynamic_Delaunay_triangulation_2::is_certified()`.
  */
  static constexpr bool is_exact = false;

  /*!
  (optional) the repair that an update uses if it is given none. Without it, that is
  `CGAL::Flip_and_splice_repair_2` if the classifier is exact, and `CGAL::Border_splice_repair_2` if
  it is not.
  */
  using Usual_repair = unspecified_type;

  /*!
  classifies. It is called once in every frame in which the points span the plane, unless the
  triangulation is rebuilt before: because many points come or go, or many coincident points part;
  because the update policy wants it; or, if the classifier is exact and the repair is
  `CGAL::Flip_and_splice_repair_2`, because a sample of the edges says that too much is broken. It
  is not asked where points come, go, or move alone.

  If it throws, the update changes nothing and hands the exception on.

  \param frame the points at the positions of the current frame, with the topology of the last one.
  It is good until the call ends. \param classified is empty at first, and takes what is classified.
  \tparam Frame `CGAL::Dynamic_frame_2`
  \tparam Classification `CGAL::Dynamic_classification_2`
  */
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified);

  /*!
  (optional) is called at the end of every update, after construction, wherever points have come,
  gone, or moved alone, and, of a copy that then takes the classifier's place, when a checkpoint is
  read, with the new topology. Classifiers with data per edge bring it up to date here:
  `CGAL::Dynamic_frame_2::everything_is_new()` tells whether the numbers of vertices and edges have
  changed their meaning, `CGAL::Dynamic_frame_2::new_edges()` which edges were triangulated anew
  otherwise. Where vertices came or went, `CGAL::Dynamic_frame_2::follow_edges()` first brings data
  of each edge in step with the few numbers that have changed, and `follow_vertices()` and
  `follow_faces()` do the same for others. A new edge also changes what is around it: what depends
  on opposite vertices or faces is brought up to date at
  `CGAL::Dynamic_frame_2::for_each_changed_edge()` and
  `CGAL::Dynamic_frame_2::for_each_changed_face()`.

  If it throws, what was done stays done, and the exception is handed on; in the next frame
  `CGAL::Dynamic_frame_2::has_changes()` then says so to `operator()`. When a checkpoint is read,
  nothing changes instead.

  \param frame the points, with the topology that the call ends with.
  \tparam Frame `CGAL::Dynamic_frame_2`
  */
  template <class Frame>
  void after_update(const Frame& frame);

  /*!
  (optional) for classifiers that decide edge by edge, and name edges alone: whether `operator()`
  would hand edge `e` of this frame to `CGAL::Dynamic_classification_2::add_edge()`. With it,
  `CGAL::Refined_classifier_2` asks for the edges that it has to, instead of all.

  \param frame that of the call of `operator()`.
  \param e an edge of it, below `CGAL::Dynamic_frame_2::number_of_edges()`.
  \tparam Frame `CGAL::Dynamic_frame_2`
  */
  template <class Frame>
  bool names_edge(const Frame& frame, typename Frame::Index e) const;
};
