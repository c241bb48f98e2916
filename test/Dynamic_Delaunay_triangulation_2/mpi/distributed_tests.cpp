// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the theme that the first argument names.

#include "distributed_oracle.h"
#include "distributed_theme.h"

int main(int argc, char** argv)
{
  theme_arguments.assign(argv + 2, argv + argc);
  start(argc, argv);
  themes().at(argv[1])();
  MPI_Finalize();
}
