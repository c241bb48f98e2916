# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Delaunay triangulations of moving points, kept exact while the points move.

``DynamicDelaunay`` for points in the plane or in space, ``Population`` for those that come and go, ``PeriodicDelaunay``
and ``PeriodicPopulation`` for both in periodic cells, ``track()`` for whole trajectories, and ``read_recording()`` for
files of them.
"""

from . import errors
from ._core import ClassifierFrame, UpdateReport, UpdateReport3D, __version__
from ._triangulations import CellMeasures, DynamicDelaunay, PeriodicDelaunay, PeriodicPopulation, Population
from .bounded import BoundedCellGradients, BoundedCells, CellPieces, CellSurface, Side
from .errors import *  # noqa: F403
from .neighbors import NeighborList
from .periodic_space import (
    PeriodicDelaunay3D,
    PeriodicNeighborLists3D,
    PeriodicPopulation3D,
    PeriodicVoronoiCells3D,
)
from .queries import AlphaClass, AlphaShape, InterpolationWeights, NearestPoints, PointsWithin
from .recording import RecordedFrame, read_recording
from .space import DynamicDelaunay3D, Population3D, VoronoiCells3D
from .trajectory import Frame, track

__all__ = [
    "AlphaClass",
    "AlphaShape",
    "BoundedCellGradients",
    "BoundedCells",
    "CellMeasures",
    "CellPieces",
    "CellSurface",
    "ClassifierFrame",
    "DynamicDelaunay",
    "DynamicDelaunay3D",
    "Frame",
    "InterpolationWeights",
    "NearestPoints",
    "NeighborList",
    "PeriodicDelaunay",
    "PeriodicDelaunay3D",
    "PeriodicNeighborLists3D",
    "PeriodicPopulation",
    "PeriodicPopulation3D",
    "PeriodicVoronoiCells3D",
    "PointsWithin",
    "Population",
    "Population3D",
    "RecordedFrame",
    "Side",
    "UpdateReport",
    "UpdateReport3D",
    "VoronoiCells3D",
    "__version__",
    "errors",
    "read_recording",
    "track",
]
