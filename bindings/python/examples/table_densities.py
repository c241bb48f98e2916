# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""The density at each row of a table of tracks, as of trackpy: one over the area of its Voronoi cell in the picture.

    table_densities.py TRACKS.csv DENSITIES.csv

The table has the columns frame, particle, x and y, in any order of rows; it is written with a column more.
"""

import sys

import pandas

from dynamic_delaunay import track

tracks = pandas.read_csv(sys.argv[1])
picture = (tracks.x.min(), tracks.y.min(), tracks.x.max(), tracks.y.max())
tables = []
for frame in track(tracks):
    particles = frame.triangulation
    density = 1 / particles.clipped_cells(picture).areas
    tables.append(pandas.DataFrame({"frame": frame.number, "particle": particles.ids, "density": density}))
densities = tracks.merge(pandas.concat(tables), on=["frame", "particle"], how="left")
densities.to_csv(sys.argv[2], index=False)
mean = densities.groupby("frame").density.mean()
print(f"{len(mean)} frames, mean density from {mean.min():.4g} to {mean.max():.4g}")
