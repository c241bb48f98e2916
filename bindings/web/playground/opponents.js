// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the page has another library to compare with, as assemble.cmake has found it: delaunator of npm, or null.

export const delaunator = null;
