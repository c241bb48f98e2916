// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgDynamicDelaunayTriangulation2Concepts
\cgalConcept

A classifier picks, frame by frame, the vertices whose neighborhoods may no longer be Delaunay. It sees the
maintained triangulation through a `Dynamic_frame_2`, with the topology of the last frame and the positions
of the current one.

A classifier is copied into the triangulation when that is constructed, and may keep data of its own from
frame to frame.

\cgalHasModelsBegin
\cgalHasModels{Circumcircle_classifier_2}
\cgalHasModels{Point_distance_classifier_2}
\cgalHasModels{Random_classifier_2}
\cgalHasModelsEnd
*/
class DelaunayClassifier_2
{
public:
  /*!
  whether the classifier is *exact*: of every edge that is not Delaunay at the current positions
  (`Dynamic_frame_2::is_delaunay()`), it classifies at least one end by
  `Dynamic_classification_2::add_vertex()` or `Dynamic_classification_2::add_id()`, or it hands the edge to
  `Dynamic_classification_2::add_edge()`. That has to hold whatever state the last frame was left in.

  Updates with an exact classifier end with the certificate. The claim is not checked again: a classifier
  that makes it wrongly breaks the promise of `Dynamic_Delaunay_triangulation_2::is_certified()`.
  */
  static constexpr bool is_exact = false;

  /*!
  classifies. It is called once in every frame in which the points span the plane and no coincident points
  part (else the triangulation is rebuilt).

  If it throws, the update changes nothing and hands the exception on.

  \tparam Frame `Dynamic_frame_2`
  \tparam Classification `Dynamic_classification_2`
  */
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified);

  /*!
  (optional) is called at the end of every update and after construction, with the new topology. Classifiers
  with data per edge bring it up to date here: `Dynamic_frame_2::everything_is_new()` tells whether the
  numbers of vertices and edges have changed their meaning, `Dynamic_frame_2::new_edges()` which edges were
  triangulated anew otherwise.
  */
  template <class Frame>
  void after_update(const Frame& frame);
};
