// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DRAW_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DRAW_DYNAMIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#ifdef DOXYGEN_RUNNING

namespace CGAL {

/*!
\ingroup PkgDrawDynamicDelaunayTriangulation2

opens a window, draws `dt.triangulation()` in it as CGAL draws its own triangulations, and waits
until the window is closed. This needs a program that is linked to CGAL's target
`CGAL::CGAL_Basic_viewer`, which adds Qt and defines `CGAL_USE_BASIC_VIEWER`. Other programs print
to `std::cerr` that they cannot draw. If the environment variable `CGAL_TEST_SUITE` is set, no
window is opened.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2`.
\param dt the triangulation to draw.
\param options what CGAL's `draw()` takes after a triangulation. In CGAL 6 that is a title, or
  graphics scene options and optionally a title; in CGAL 5 a title and optionally whether to leave
  out the faces.

\throws Uncertified_triangulation_error_2 unless `dt.is_certified()`.
*/
template <class Dynamic, class... Options>
void draw(const Dynamic& dt, const Options&... options);

/*!
\ingroup PkgDrawDynamicDelaunayTriangulation2

adds the vertices, edges and faces of `dt.triangulation()` to a graphics scene, which CGAL offers
from version 6.0 on.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2`.
\param dt the triangulation to add.
\param scene the scene; it keeps its previous contents.
\param options graphics scene options, or nothing.

\throws Uncertified_triangulation_error_2 unless `dt.is_certified()`.
*/
template <class Dynamic, class... Options>
void add_to_graphics_scene(const Dynamic& dt, Graphics_scene& scene, const Options&... options);

} // namespace CGAL

#elif defined(CGAL_USE_BASIC_VIEWER) || __has_include(<CGAL/Basic_viewer.h>)

#include <CGAL/draw_triangulation_2.h>

namespace CGAL {

template <class... Parameters, class... Options>
void draw(const Dynamic_Delaunay_triangulation_2<Parameters...>& dt, const Options&... options)
{
  draw(dt.triangulation(), options...);
}

#if __has_include(<CGAL/Graphics_scene.h>)
template <class... Parameters, class... Options>
void add_to_graphics_scene(const Dynamic_Delaunay_triangulation_2<Parameters...>& dt,
                           Graphics_scene& scene, const Options&... options)
{
  add_to_graphics_scene(dt.triangulation(), scene, options...);
}
#endif

} // namespace CGAL

#else // CGAL 5 without its viewer, whose header may not be installed

#include <iostream>

namespace CGAL {

template <class... Parameters>
void draw(const Dynamic_Delaunay_triangulation_2<Parameters...>& dt, const char* = "", bool = false)
{
  dt.triangulation(); // throws here, too, unless certified
  std::cerr << "Impossible to draw, CGAL_USE_BASIC_VIEWER is not defined." << std::endl;
}

} // namespace CGAL

#endif

#endif // CGAL_DRAW_DYNAMIC_DELAUNAY_TRIANGULATION_2_H
