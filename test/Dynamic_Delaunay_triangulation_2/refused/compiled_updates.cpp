// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Without the macro, other files would compile all of it again, and nobody would notice.
#include <CGAL/Dynamic_Delaunay_triangulation_2/compiled_updates.h>
