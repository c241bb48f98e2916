// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A classifier picks, in every frame, the vertices whose neighborhoods may no longer be Delaunay. It
reads the maintained triangulation through a `CGAL::Dynamic_frame_2`, with the topology of the last
frame and the positions of the current one.

The constructor of the triangulation copies the classifier. A classifier may keep data of its own
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
\cgalHasModels{CGAL::Chosen_classifier_2}
\cgalHasModelsEnd
*/
class DelaunayClassifier_2
{
public:
  /*!
  whether the classifier is *exact*. An exact classifier misses no edge that is not Delaunay at the
  current positions (`CGAL::Dynamic_frame_2::is_delaunay()`): it classifies at least one end by
  `CGAL::Dynamic_classification_2::add_vertex()` or `CGAL::Dynamic_classification_2::add_id()`, or
  passes the edge to `CGAL::Dynamic_classification_2::add_edge()`. That has to hold for any state
  in which the last frame ended.

  Updates with an exact classifier end with the certificate. The claim is not checked: a
  classifier that makes it wrongly breaks the promise of
  `CGAL::Dynamic_Delaunay_triangulation_2::is_certified()`.

  A classifier of which this is known only while a program runs has a constant member function
  `is_exact()` instead. `CGAL::is_classifier_exact()` asks classifiers of both kinds.
  */
  static constexpr bool is_exact = false;

  /*!
  (optional) the repair that an update uses by default. Without this type it is
  `CGAL::Hold_and_flip_repair_2` if the classifier is exact, and `CGAL::Border_splice_repair_2` if
  it is heuristic; if `is_exact` is a function, `CGAL::Repair_by_exactness_2`.
  */
  using Usual_repair = unspecified_type;

  /*!
  classifies. It is called once in every frame in which the points span the plane, unless the
  triangulation is rebuilt before. That happens if many points are inserted or removed, if many
  coincident points separate, if the update policy wants it, or, with an exact classifier and
  `CGAL::Hold_and_flip_repair_2` as the repair, if a sample of the edges shows that too much is
  broken. Where such a sample shows that the frame is better taken in steps,
  `CGAL::Circumcircle_classifier_2` is called in each of them instead
  (\ref DynamicDelaunaySubsection_Steps). An exact one is not called in a frame of a population in
  which points come or go and all others are where they were. It is not called by `insert()`,
  `remove()` and `move()`.

  If it throws, the update changes nothing and rethrows the exception.

  \param frame the points at the positions of the current frame, with the topology of the last one.
  It is valid until the call ends.
  \param classified is empty at first, and receives what is classified.
  \tparam Frame `CGAL::Dynamic_frame_2`
  \tparam Classification `CGAL::Dynamic_classification_2`
  */
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified);

  /*!
  (optional) is called with the new topology at the end of every update, also if `operator()` was
  not called in it, after construction, and whenever points were inserted, removed, or moved. When a
  checkpoint is read it is called on a copy that then replaces the classifier.

  Classifiers with data of edges update it here. `CGAL::Dynamic_frame_2::everything_is_new()` says
  whether all numbers of vertices and edges have changed their meaning. Otherwise
  `CGAL::Dynamic_frame_2::new_edges()` lists the edges that are new. If vertices were inserted or
  removed, `CGAL::Dynamic_frame_2::follow_edges()` first renumbers the data of the few edges whose
  numbers have changed; `follow_vertices()` and `follow_faces()` do the same for data of vertices
  and faces. A new edge also changes its surroundings: data that depends on opposite vertices or
  faces is updated at `CGAL::Dynamic_frame_2::for_each_changed_edge()` and
  `CGAL::Dynamic_frame_2::for_each_changed_face()`.

  If it throws, the update has been done, and the exception is rethrown; in the next frame
  `CGAL::Dynamic_frame_2::has_changes()` tells `operator()` that changes were missed. If it throws
  when a checkpoint is read, nothing changes.

  \param frame the points, with the topology at the end of the call.
  \tparam Frame `CGAL::Dynamic_frame_2`
  */
  template <class Frame>
  void after_update(const Frame& frame);

  /*!
  (optional) whether `operator()` would pass edge `e` of this frame to
  `CGAL::Dynamic_classification_2::add_edge()`. It is meant for classifiers that decide edge by
  edge, and name edges only. With this function `CGAL::Refined_classifier_2` calls it for the edges
  that matter, instead of classifying all edges.

  \param frame the frame of the call of `operator()`.
  \param e one of its edges, below `CGAL::Dynamic_frame_2::number_of_edges()`.
  \tparam Frame `CGAL::Dynamic_frame_2`
  */
  template <class Frame>
  bool names_edge(const Frame& frame, typename Frame::Edge_index e) const;
};
