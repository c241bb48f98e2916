# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Neighbors of each atom of a LAMMPS dump, as LAMMPS and OVITO write it, in x and y, with periodic sides.

    lammps_neighbors.py DUMP

Prints a line for each step, and then one for each atom: its id and those of its neighbors.
"""

import sys

import numpy as np

from dynamic_delaunay import PeriodicPopulation


def read_frames(path):
    """The step, the sides of the box, ids and positions of each frame."""
    with open(path) as dump:
        while dump.readline():
            step = int(dump.readline())
            dump.readline()
            atoms = int(dump.readline())
            if dump.readline().split()[3:5] != ["pp", "pp"]:
                sys.exit(f"{path}: step {step}: the box must be periodic in x and y, and not tilted")
            bounds = np.array([dump.readline().split() for _ in range(3)], dtype=float)
            columns = dump.readline().split()[2:]
            rows = np.array([dump.readline().split() for _ in range(atoms)])
            number = {column: rows[:, columns.index(column)].astype(float) for column in ("id", "x", "y")}
            points = np.stack([number["x"], number["y"]], axis=1)
            yield step, np.ptp(bounds[:2], axis=1), number["id"].astype(int), points


atoms = PeriodicPopulation()
for step, sides, ids, points in read_frames(sys.argv[1]):
    report = atoms.update(ids, points, cell=sides)
    print(f"step {step}: {len(atoms)} atoms, {report.inserted} new, {report.flips} flips")
    for row, id in enumerate(atoms.ids):
        print(id, *sorted(atoms.ids[atoms.neighbors_of(row)]))
