# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points in a periodic cell in space."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import as_floats, given, number_of_processors
from ._changes import ChangedEdgeShifts
from ._core import Group, UpdateReport3D
from ._points_in_space import ByIds3D, ByNumbers3D, PointsInSpace, checked_settings
from .errors import PeriodicCellError
from .neighbors import NeighborList

Self = TypeVar("Self", bound="_InPeriodicSpace")


class PeriodicNeighborLists3D(NamedTuple):
    """The neighbors of all rows in periodic space, of one moment. Those of row i are the entries from ``indptr[i]`` to
    ``indptr[i + 1]``, by ascending rows and then shifts. A point may be its own neighbor, and another one several
    times, by different images."""

    indptr: NDArray[np.int32]
    """int32 (rows + 1,)"""
    indices: NDArray[np.int32]
    """int32 (pairs,): the row of each neighbor"""
    shifts: NDArray[np.int32]
    """int32 (pairs, 3): which image it is: how often it is moved by each vector of the cell"""
    vectors: NDArray[np.float64]
    """float64 (pairs, 3): the way from the point to that image, in the unit of the coordinates"""


class PeriodicVoronoiCells3D(NamedTuple):
    """Voronoi cells of points in periodic space, a row for each id; zeros for ids that are free. Of a population, a row
    for each point. The volumes add up to that of the periodic cell. In a slab the cells of its highest and lowest
    points are unbounded, in a wire those of the points on its hull.

    Points that coincide share a cell: each has its share of the volume, and the first of them has the facets.
    """

    volumes: NDArray[np.float64]
    """float64 (rows,), in the cubed unit of the coordinates. ``inf`` where a cell is unbounded."""
    surface_areas: NDArray[np.float64]
    """float64 (rows,), in the squared unit; ``inf`` where a cell is unbounded."""
    centroids: NDArray[np.float64]
    """float64 (rows, 3), near to the points as they were given; an unbounded cell has its point instead."""
    indptr: NDArray[np.int64]
    """int64 (rows + 1,): the facets of row i are those from ``indptr[i]`` to ``indptr[i + 1]``."""
    neighbors: NDArray[np.int32]
    """int32 (facets,): the row on the other side of each facet, ascending for each row. Which cells share a facet is
    decided exactly."""
    facet_areas: NDArray[np.float64]
    """float64 (facets,), in the squared unit; ``inf`` where a facet is unbounded."""
    shifts: NDArray[np.int32]
    """int32 (facets, 3): which image the other side is"""
    vectors: NDArray[np.float64]
    """float64 (facets, 3): the way from the point to that image, in the unit of the coordinates"""


def is_cell_in_space(cell: Any) -> bool:
    """Whether the shape is (3,), (3, 3), (2, 3) or (1, 3). What is no array at all is refused where cells are read."""
    try:
        return np.shape(cell) in ((3,), (3, 3), (2, 3), (1, 3))
    except (TypeError, ValueError):
        return False


def _vectors(cell: ArrayLike) -> list[list[float]]:
    """From three sides, or three vectors as rows, or the two of a slab, or the one of a wire."""
    array = as_floats("a cell", cell)
    if array.shape == (3,):
        array = np.diag(array)
    if array.shape not in ((3, 3), (2, 3), (1, 3)):
        raise PeriodicCellError(
            f"a cell of points in space has the shape {array.shape}: it must be (3,) for the sides of a box, (3, 3) for "
            "three vectors, a row each, (2, 3) for those of a slab, or (1, 3) for that of a wire"
        )
    vectors: list[list[float]] = array.tolist()
    return vectors


class _InPeriodicSpace(ChangedEdgeShifts, PointsInSpace, _core.PeriodicTriangulation3D):
    """What triangulations in periodic space have in common."""

    def __new__(cls: type[Self], *_arguments: Any, **_named: Any) -> Self:
        self = super().__new__(cls)
        _core.PeriodicTriangulation3D.__init__(self)  # so that there is something, whatever a derived class does
        return self

    def _init(self, cell: ArrayLike, settings: dict[str, Any]) -> None:
        settings = checked_settings(settings)
        self._start(settings["threads"] or number_of_processors(), settings["changes"], self._has_user_ids, _vectors(cell))
        self._settings = settings

    def _init_empty(self, settings: dict[str, Any]) -> None:
        self._init((1.0, 1.0, 1.0), settings)

    @property
    def cell(self) -> NDArray[np.float64]:
        """float64 (vectors, 3): the vectors of the cell, a row each: three, two of a slab, or one of a wire."""
        return self._cell()

    @property
    def points(self) -> NDArray[np.float64]:
        """float64 (rows, 3): the position of each row as it was given, NaN for a removed id."""
        return self._arrays(Group.POINTS)[0]

    @property
    def simplices(self) -> NDArray[np.int32]:
        """int32 (simplices, 4): rows of the corners of each tetrahedron; those of the images by ``simplex_shifts`` are
        positively oriented: the last three are counterclockwise from outside."""
        return self._arrays(Group.SIMPLICES)[0]

    @property
    def simplex_shifts(self) -> NDArray[np.int32]:
        """int32 (simplices, 4, 3): the shifts of the corners; those of the first ones are 0."""
        return self._arrays(Group.SIMPLICES)[1]

    @property
    def edge_shifts(self) -> NDArray[np.int32]:
        """int32 (edges, 3): the shift of the second end of each edge."""
        return self._arrays(Group.EDGES)[1]

    @property
    def neighbor_shifts(self) -> NDArray[np.int32]:
        """int32 (pairs, 3): the shift of each neighbor in ``indices``."""
        return self._arrays(Group.NEIGHBOR_LISTS)[2]

    @property
    def neighbor_vectors(self) -> NDArray[np.float64]:
        """float64 (pairs, 3): the way to each neighbor in ``indices``, in the unit of the coordinates."""
        return self._arrays(Group.NEIGHBOR_LISTS)[3]

    def neighbor_lists(self) -> PeriodicNeighborLists3D:
        """The neighbors of all rows, with shifts and vectors. Where points are cospherical they are those of one of the
        Delaunay triangulations; the neighbors of ``voronoi_cells()`` do not depend on that."""
        return PeriodicNeighborLists3D(*self._arrays(Group.NEIGHBOR_LISTS))

    def volumes(self) -> NDArray[np.float64]:
        """float64 (simplices,): volumes of the tetrahedra, in the cubed unit of the coordinates. Computed in floating
        point. Cost: linear, in each call."""
        return self._volumes()

    def voronoi_volumes(self) -> NDArray[np.float64]:
        """float64 (rows,): volumes of the Voronoi cells, and nothing else: in less than half of the
        time of ``voronoi_cells()``. Cost: linear, in each call."""
        return self._voronoi_volumes()

    def voronoi_cells(self) -> PeriodicVoronoiCells3D:
        """The Voronoi cells of all rows, which fill space. Cost: linear, in each call; some microseconds a point."""
        return PeriodicVoronoiCells3D(*self._voronoi_cells())

    def neighbor_list(self) -> NeighborList:
        """Pairs of neighbors with vectors and the areas of Voronoi facets, as freud's. Of points that coincide, only
        the one that represents them has neighbors. Cost: that of ``voronoi_cells()``."""
        cells = self.voronoi_cells()
        counts = np.diff(cells.indptr)
        first = np.repeat(np.arange(len(counts), dtype=np.int32), counts)
        return NeighborList(first, cells.neighbors, cells.vectors, cells.facet_areas, counts)

class PeriodicDelaunay3D(ByNumbers3D, _InPeriodicSpace):
    """The Delaunay triangulation of moving points in a periodic cell in space, which ``PeriodicDelaunay(points, cell)``
    makes of points (n, 3), or of a cell in space. The cell may change with every frame, but not the number of its
    vectors.

    It is of one sheet, and exact, however few points there are. An edge goes from a point to the image of another one,
    or of itself, by a shift (i, j, k), which is moved by i times the first vector of the cell, j times the second one
    and k times the third one. Points have the ids 0, 1, 2, ... as those of DynamicDelaunay3D, and arrays have a row for
    each.

    Parameters
    ----------
    points : array_like, float (n, 3)
        Positions, wrapped or not.
    cell : array_like
        (3,) the sides of a box; (3, 3) three vectors, a row each, at any angles; (2, 3) the two vectors of a slab,
        which is open across them, as a film or what is between two walls. The third number of each shift is 0 there,
        and simplices fill the layer between the highest and the lowest points; (1, 3) the vector of a wire, which is
        open across it, as a nanotube or what is in a pipe. The last two numbers of each shift are 0 there, and
        simplices fill the convex prism around all points; there are none if these are in a plane along the wire.
    changes : bool
        Whether to record created and removed edges. That costs time for each tetrahedron that changes.
    threads : int
        Threads that share the work; 0 for all.

    Every call ends with a proof by exact predicates. It is copied, pickled, saved and loaded as others.
    """

    def __init__(
        self,
        points: Optional[ArrayLike] = None,
        cell: ArrayLike = (1.0, 1.0, 1.0),
        *,
        changes: bool = False,
        threads: int = 1,
    ) -> None:
        self._init(cell, dict(changes=changes, threads=threads))
        if points is not None:
            self._insert(points, None)

    def update(self, points: ArrayLike, cell: Optional[ArrayLike] = None) -> UpdateReport3D:
        """Move point i to row i of ``points``, float (number_of_ids, 3), in the same cell, or in one that has changed,
        also to other vectors of the same lattice. Where a point is wrapped, it has gone to the nearest image. Rows of
        removed ids are ignored."""
        return self._update(points, None, None if cell is None else _vectors(cell))


class PeriodicPopulation3D(ByIds3D, _InPeriodicSpace):
    """Points in a periodic cell in space that come and go, by any integers of 64 bits as ids, which
    ``PeriodicPopulation(ids, points, cell)`` makes of points (n, 3), or of a cell in space.

    Arrays have a row for each point: row k is the point ``ids[k]``. So ``population.ids[population.edges]`` has the
    edges by ids. Rows change when points come or go.

    Parameters are the ids, int (n,), the points, float (n, 3), and those of PeriodicDelaunay3D. With ``changes=True``
    each call also looks up all ids.
    """

    def __init__(
        self,
        ids: Optional[ArrayLike] = None,
        points: Optional[ArrayLike] = None,
        cell: ArrayLike = (1.0, 1.0, 1.0),
        *,
        changes: bool = False,
        threads: int = 1,
    ) -> None:
        self._init(cell, dict(changes=changes, threads=threads))
        if ids is not None or points is not None:
            self._update(given("points", points), given("ids", ids), None)

    def update(self, ids: ArrayLike, points: ArrayLike, cell: Optional[ArrayLike] = None) -> UpdateReport3D:
        """Take a whole frame, ids int (n,) and positions float (n, 3) in any order, in the same cell, or in one that
        has changed: remove points whose ids are missing, move the others, and insert those with new ids. Nothing
        changes if an id is there twice."""
        return self._update(points, ids, None if cell is None else _vectors(cell))
