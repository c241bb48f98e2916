// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Must not compile with CGAL_LICENSE_ERROR, by which a program asks not to use anything under the
// GPL.

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

int main()
{
}
