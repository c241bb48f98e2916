# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points in space."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import given, number_of_processors
from ._core import Group, UpdateReport3D
from ._points_in_space import ByIds3D, ByNumbers3D, PointsInSpace, checked_settings
from ._rows import ScipyNames
from .errors import InputValueError

Self = TypeVar("Self", bound="_InSpace")

OUTWARD_FACETS = np.array([(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)])
"""Of a positively oriented tetrahedron, opposite to each corner: the other three, counterclockwise from outside."""


class VoronoiCells3D(NamedTuple):
    """Voronoi cells of points in space, a row for each id; zeros for ids that are free. Of a population, a row for each
    point.

    Points that coincide share a cell: each has its share of the volume, and the first of them has the facets.
    """

    volumes: NDArray[np.float64]
    """float64 (rows,), in the cubed unit of the coordinates. ``inf`` where a cell is unbounded."""
    surface_areas: NDArray[np.float64]
    """float64 (rows,), in the squared unit; ``inf`` where a cell is unbounded."""
    centroids: NDArray[np.float64]
    """float64 (rows, 3); an unbounded cell has its point instead."""
    indptr: NDArray[np.int64]
    """int64 (rows + 1,): the facets of row i are those from ``indptr[i]`` to ``indptr[i + 1]``."""
    neighbors: NDArray[np.int32]
    """int32 (facets,): the row on the other side of each facet, ascending for each row. Which cells share a facet is
    decided exactly."""
    facet_areas: NDArray[np.float64]
    """float64 (facets,), in the squared unit."""


def _sides(box: ArrayLike) -> list[float]:
    sides: NDArray[Any] = np.asarray(box)
    if sides.dtype.kind not in "biuf" or sides.shape != (6,):
        raise InputValueError(
            f"a box of {sides.dtype} with the shape {sides.shape}: it must have six numbers, xmin, ymin, zmin, xmax, "
            "ymax and zmax"
        )
    sides = sides.astype(np.float64)
    if not (sides[:3] < sides[3:]).all() or not np.isfinite(sides).all() or (sides[3:] - sides[:3] > 1e100).any():
        raise InputValueError(
            f"the box {tuple(sides.tolist())} is empty, not finite, or longer than 1e100: its numbers are xmin, ymin, "
            "zmin, xmax, ymax and zmax, in this order"
        )
    return [float(side) for side in sides]


class _InSpace(ScipyNames, PointsInSpace, _core.Triangulation3D):
    """What triangulations in space have in common."""

    def __new__(cls: type[Self], *_arguments: Any, **_named: Any) -> Self:
        self = super().__new__(cls)
        _core.Triangulation3D.__init__(self)  # so that there is something, whatever a derived class does
        return self

    def _init(self, settings: dict[str, Any]) -> None:
        settings = checked_settings(settings)
        self._start(settings["threads"] or number_of_processors(), settings["changes"], self._has_user_ids)
        self._settings = settings

    def _init_empty(self, settings: dict[str, Any]) -> None:
        self._init(settings)

    @property
    def points(self) -> NDArray[np.float64]:
        """float64 (rows, 3): the position of each row, NaN for a removed id."""
        return self._arrays(Group.POINTS)[0]

    @property
    def simplices(self) -> NDArray[np.int32]:
        """int32 (simplices, 4): rows of the corners of each tetrahedron, positively oriented: the last three are
        counterclockwise from outside."""
        return self._arrays(Group.SIMPLICES)[0]

    @property
    def neighbors(self) -> NDArray[np.int32]:
        """int32 (simplices, 4): the simplex opposite to each corner, -1 on the hull, as scipy.spatial.Delaunay has
        it."""
        return self._arrays(Group.SIMPLICES)[1]

    @property
    def convex_hull(self) -> NDArray[np.int32]:
        """int32 (k, 3): rows of the corners of each facet of the convex hull, counterclockwise from outside."""
        simplices, neighbors = self._arrays(Group.SIMPLICES)
        simplex, opposite = np.nonzero(neighbors < 0)
        hull: NDArray[np.int32] = simplices[simplex[:, np.newaxis], OUTWARD_FACETS[opposite]]
        return hull

    def neighbor_lists(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """``indptr`` and ``indices``, of one moment: the neighbors of row i are
        ``indices[indptr[i] : indptr[i + 1]]``."""
        return self.vertex_neighbor_vertices

    def volumes(self) -> NDArray[np.float64]:
        """float64 (simplices,): volumes of the tetrahedra, in the cubed unit of the coordinates. Computed in floating
        point, and wrong by at most 1e-15 times the cube of the longest edge. Cost: linear, in each call."""
        return self._volumes()

    def voronoi_volumes(self) -> NDArray[np.float64]:
        """float64 (rows,): volumes of the whole Voronoi cells, and nothing else: in less than half of the
        time of ``voronoi_cells()``. ``inf`` on the convex hull, 0 for removed ids. Cost: linear, in each call."""
        return self._voronoi_volumes()

    def voronoi_cells(self, box: Optional[ArrayLike] = None) -> VoronoiCells3D:
        """The Voronoi cells of all rows, whole or as far as they are in a box (xmin, ymin, zmin, xmax, ymax, zmax),
        whose volume they fill. Cost: linear, in each call; some microseconds a point. InputValueError if the box is
        empty, or longer than 1e100."""
        return VoronoiCells3D(*self._voronoi_cells(None if box is None else _sides(box)))

class DynamicDelaunay3D(ByNumbers3D, _InSpace):
    """The Delaunay triangulation of moving points in space, which ``DynamicDelaunay(points)`` makes of points (n, 3).

    Points have the ids 0, 1, 2, ... in the order in which they are given, and keep them; the id of a removed point is
    free, and the next point gets the smallest free id. Arrays have a row for each id that was ever in use.

    Parameters
    ----------
    points : array_like, float (n, 3)
        x, y and z of each point. Any strided array of float64 is read in place, other numbers are converted first.
    changes : bool
        Whether to record created and removed edges. That costs time for each tetrahedron that changes.
    threads : int
        Threads that share the work; 0 for all.

    Every call ends with a proof by exact predicates. Fewer than four points, and points in a plane or on a line, have
    no simplices, but edges. Calls release the interpreter's lock; different objects run in threads at once, and calls
    of one object wait for each other. Do not write to an array while it is read.
    """

    def __init__(self, points: Optional[ArrayLike] = None, *, changes: bool = False, threads: int = 1) -> None:
        self._init(dict(changes=changes, threads=threads))
        if points is not None:
            self._insert(points, None)

    def update(self, points: ArrayLike) -> UpdateReport3D:
        """Move point i to row i of ``points``, float (number_of_ids, 3), and repair what that breaks. Rows of removed
        ids are ignored. Cost: a pass over the simplices, never much more than to triangulate all points anew."""
        return self._update(points, None)


class Population3D(ByIds3D, _InSpace):
    """The Delaunay triangulation of points in space that come and go, by any integers of 64 bits as ids, which
    ``Population(ids, points)`` makes of points (n, 3).

    Arrays have a row for each point: row k is the point ``ids[k]``. So ``population.ids[population.edges]`` has the
    edges by ids. Rows change when points come or go.

    Parameters are the ids, int (n,), the points, float (n, 3), and those of DynamicDelaunay3D. With ``changes=True``
    each call also looks up all ids.
    """

    def __init__(
        self,
        ids: Optional[ArrayLike] = None,
        points: Optional[ArrayLike] = None,
        *,
        changes: bool = False,
        threads: int = 1,
    ) -> None:
        self._init(dict(changes=changes, threads=threads))
        if ids is not None or points is not None:
            self._update(given("points", points), given("ids", ids))

    def update(self, ids: ArrayLike, points: ArrayLike) -> UpdateReport3D:
        """Take a whole frame, ids int (n,) and positions float (n, 3) in any order: insert points with new ids, remove
        those whose ids are missing, and move the others. Nothing changes if an id is there twice."""
        return self._update(points, ids)
