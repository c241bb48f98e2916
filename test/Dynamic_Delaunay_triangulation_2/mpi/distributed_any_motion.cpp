// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: random clouds with random motions, populations and distributions. Each
// frame is compared with one process. One run in 16 has up to 20,000 points, so that ranks own
// faces that they need not look at.

#include "distributed_any_run.h"
#include "distributed_theme.h"

namespace distributed_any_motion {

void run_theme()
{
  make_runs<Any_run>(60, [](unsigned run) { return run % 16 == 0 ? 20000 : 400; });
}

const Theme theme("distributed_any_motion", run_theme);

} // namespace distributed_any_motion
