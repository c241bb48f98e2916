# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Neighbors of each atom of a LAMMPS dump, as LAMMPS and OVITO write it.

    lammps_neighbors.py DUMP

Prints a line for each step, and then one for each atom: its id and those of its neighbors. They are neighbors in space
if the atoms differ in z, and then the box must be open, or periodic along all sides; else in the plane, which is periodic
where the box is.
"""

import sys

from dynamic_delaunay import read_recording, track

for step, atoms, report in track(read_recording(sys.argv[1])):
    print(f"step {step}: {len(atoms)} atoms, {report.inserted} new, {report.flips} flips")
    for row, id in enumerate(atoms.ids):
        print(id, *sorted(atoms.ids[atoms.neighbors_of(row)]))
