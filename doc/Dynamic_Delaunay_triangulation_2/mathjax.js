// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
MathJax.Hub.Config({
  messageStyle: "none",
  showMathMenu: false, // most of what is in it is not copied
  SVG: {linebreaks: {automatic: true, width: "container"}}
});
