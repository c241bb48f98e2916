# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Voronoi volumes and neighbors of all particles in all frames of a LAMMPS dump or XYZ file, in open or periodic space.

    voronoi_trajectory.py RECORDING
"""

import sys

import numpy as np
from dynamic_delaunay import read_recording, track

print("step id volume neighbors")
for step, particles, report in track(read_recording(sys.argv[1], dimension=3)):
    cells = particles.voronoi_cells()
    neighbors = np.split(particles.ids[cells.neighbors], cells.indptr[1:-1])
    for id, volume, ids in zip(particles.ids, cells.volumes, neighbors):
        print(step, id, volume, *ids)
