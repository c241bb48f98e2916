// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: random clouds in periodic cells, with random motions, deformations,
// populations and distributions. Each frame is compared with one process.

#include "distributed_periodic_any_run.h"
#include "distributed_theme.h"

namespace distributed_periodic_any_motion {

void run_theme()
{
  make_runs<Any_periodic_run>(25, [](unsigned) { return 150; });
}

const Theme theme("distributed_periodic_any_motion", run_theme);

} // namespace distributed_periodic_any_motion
