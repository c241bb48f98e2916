// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DRAW_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
#define CGAL_DRAW_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Periodic_picture_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>

#ifdef DOXYGEN_RUNNING

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

opens a window, draws the periodic triangulation in it, and waits until the window is closed. Each
face is drawn once, by the image whose first corner is in the cell, so faces reach out of the cell
on some sides. Vertices are drawn in the cell. The outline of the cell is drawn, too; that of a slab
ends at its outermost points. If a slab has no faces, its edges are drawn.

Like `draw()` of `Dynamic_Delaunay_triangulation_2`, this needs a program that is linked to CGAL's
target `CGAL::CGAL_Basic_viewer`. Other programs print to `std::cerr` that they cannot draw. If the
environment variable `CGAL_TEST_SUITE` is set, no window is opened.

\tparam Parameters those of the triangulation.
\param pt the triangulation to draw.
\param title the title of the window.
\param nofill whether to leave out the faces, and draw their edges alone.

\throws Uncertified_triangulation_error_2 unless `pt.is_certified()`.
*/
template <class... Parameters>
void draw(const Dynamic_periodic_Delaunay_triangulation_2<Parameters...>& pt,
          const char* title = "Periodic Delaunay triangulation", bool nofill = false);

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

adds what `draw()` shows to a graphics scene, which CGAL offers from version 6.0 on.

\tparam Parameters those of the triangulation.
\param pt the triangulation to add.
\param scene the scene; it keeps its previous contents.
\param nofill whether to leave out the faces, and draw their edges alone.

\throws Uncertified_triangulation_error_2 unless `pt.is_certified()`.
*/
template <class... Parameters>
void add_to_graphics_scene(const Dynamic_periodic_Delaunay_triangulation_2<Parameters...>& pt,
                           Graphics_scene& scene, bool nofill = false);

} // namespace CGAL

#elif __has_include(<CGAL/Basic_viewer.h>) // CGAL 6

#include <CGAL/Basic_viewer.h>

namespace CGAL {

template <class... Parameters>
void add_to_graphics_scene(const Dynamic_periodic_Delaunay_triangulation_2<Parameters...>& pt,
                           Graphics_scene& scene, bool nofill = false)
{
  Dynamic_Delaunay_triangulations_2::internal::draw_periodic(pt, scene, !nofill);
}

template <class... Parameters>
void draw(const Dynamic_periodic_Delaunay_triangulation_2<Parameters...>& pt,
          const char* title = "Periodic Delaunay triangulation", bool nofill = false)
{
  Graphics_scene scene;
  add_to_graphics_scene(pt, scene, nofill);
  draw_graphics_scene(scene, title);
}

} // namespace CGAL

#elif defined(CGAL_USE_BASIC_VIEWER) // CGAL 5 with its viewer

#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

class Periodic_viewer_2 : public Basic_viewer_qt
{
public:
  template <class Dynamic>
  Periodic_viewer_2(QWidget* parent, const Dynamic& pt, const char* title, bool nofill)
    : Basic_viewer_qt(parent, title, true, true, true, false, false)
  {
    draw_periodic(pt, *this, !nofill);
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

template <class... Parameters>
void draw(const Dynamic_periodic_Delaunay_triangulation_2<Parameters...>& pt,
          const char* title = "Periodic Delaunay triangulation", bool nofill = false)
{
  using namespace Dynamic_Delaunay_triangulations_2::internal;
  check_certified(pt);
#ifdef CGAL_TEST_SUITE
  const bool is_test = true;
#else
  const bool is_test = qEnvironmentVariableIsSet("CGAL_TEST_SUITE");
#endif
  if (is_test)
    return;
  CGAL::Qt::init_ogl_context(4, 3);
  int argc = 1;
  const char* argv[] = {"periodic_viewer", nullptr};
  QApplication application(argc, const_cast<char**>(argv));
  Periodic_viewer_2 viewer(application.activeWindow(), pt, title, nofill);
  viewer.show();
  application.exec();
}

} // namespace CGAL

#else // CGAL 5 without its viewer, whose header may not be installed

#include <iostream>

namespace CGAL {

template <class... Parameters>
void draw(const Dynamic_periodic_Delaunay_triangulation_2<Parameters...>& pt, const char* = "",
          bool = false)
{
  Dynamic_Delaunay_triangulations_2::internal::check_certified(pt);
  std::cerr << "Impossible to draw, CGAL_USE_BASIC_VIEWER is not defined." << std::endl;
}

} // namespace CGAL

#endif

#endif // CGAL_DRAW_DYNAMIC_PERIODIC_DELAUNAY_TRIANGULATION_2_H
