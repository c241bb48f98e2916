# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, Optional, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import are_in_space, as_floats, as_index, as_integer, as_list, as_rows, given, number_of_processors
from ._changes import ChangedEdges, ChangedEdgesByIds, ChangedEdgeShifts, checked_changes
from ._checkpoints import Checkpoints
from ._core import ClassifierFrame, Group, Query, UpdateReport
from ._places import Places, as_extent, lists
from ._rows import Rows, ScipyNames
from .bounded import BoundedCells, Domain, rings_of
from .errors import (
    InputIndexError,
    InputTypeError,
    InputValueError,
    ParameterError,
    PeriodicCellError,
    UnknownIdError,
)
from .neighbors import NeighborList
from .periodic_space import PeriodicDelaunay3D, PeriodicPopulation3D, is_cell_in_space
from .queries import AlphaShape, InterpolationWeights
from .space import DynamicDelaunay3D, Population3D

Classifier = Union[str, Callable[[ClassifierFrame], Any]]
Self = TypeVar("Self", bound="_Triangulation")


class CellMeasures(NamedTuple):
    """Measures of Voronoi cells, a row for each id."""

    areas: NDArray[np.float64]
    """float64 (rows,)"""
    perimeters: NDArray[np.float64]
    """float64 (rows,)"""
    centroids: NDArray[np.float64]
    """float64 (rows, 2)"""
    shape_indices: NDArray[np.float64]
    """float64 (rows,): perimeter / sqrt(area)"""


def _settings(
    classifier: Classifier, repair: Optional[str], policy: str, changes: bool, threads: int, seed: int
) -> dict[str, Any]:
    if not isinstance(classifier, str) and not callable(classifier):
        raise InputTypeError(f"the classifier is {classifier!r}: it must be a name or a function")
    if repair is not None and not isinstance(repair, str):
        raise InputTypeError(f"the repair is {repair!r}: it must be a name or None")
    if not isinstance(policy, str):
        raise InputTypeError(f"the policy is {policy!r}: it must be a name")
    return dict(
        classifier=classifier,
        repair=repair or "",
        policy=policy,
        changes=checked_changes(changes),
        threads=as_integer("threads", threads, 2**31),
        seed=as_integer("seed", seed, 2**64),
    )


def _cell(cell: ArrayLike) -> _core.Cell:
    """From two sides, two vectors as rows, or one vector as one row."""
    array = as_floats("a cell", cell)
    if array.shape == (2,):
        return _core.Cell(array[0], 0.0, 0.0, array[1], False)
    if array.shape == (2, 2):
        (ax, ay), (bx, by) = array.tolist()
        return _core.Cell(ax, ay, bx, by, False)
    if array.shape == (1, 2):
        return _core.Cell(array[0, 0], array[0, 1], 0.0, 0.0, True)
    raise PeriodicCellError(
        f"a cell has the shape {array.shape}: it must be (2,) for the sides of a rectangle, "
        "(2, 2) for two vectors, a row each, or (1, 2) for the vector of a slab"
    )


def _cell_array(cell: _core.Cell) -> NDArray[np.float64]:
    vectors = np.array(cell.numbers).reshape(2, 2)
    return vectors[:1] if cell.is_slab else vectors


class _Triangulation(Checkpoints, Places, Rows, _core.Triangulation):
    """What triangulations in the plane and in periodic space have in common."""

    _settings: dict[str, Any]

    def __new__(cls: type[Self], *_arguments: Any, **_named: Any) -> Self:
        self = super().__new__(cls)
        _core.Triangulation.__init__(self)  # so that there is something, whatever a derived class does
        return self

    def _init(self, population: bool, cell: Optional[_core.Cell], settings: dict[str, Any]) -> None:
        chosen: dict[str, Any] = {**settings, "threads": settings["threads"] or number_of_processors()}
        self._start(population=population, cell=cell, **chosen)
        self._settings = settings

    @property
    def points(self) -> NDArray[np.float64]:
        """float64 (rows, 2): the position of each row, NaN for a removed id."""
        return self._arrays(Group.POINTS)[0]

    @property
    def triangles(self) -> NDArray[np.int32]:
        """int32 (triangles, 3): rows of the corners, counterclockwise."""
        return self._arrays(Group.TRIANGLES)[0]

    @property
    def areas(self) -> NDArray[np.float64]:
        """float64 (rows,): areas of the Voronoi cells, in the squared unit of the coordinates. ``inf`` where a cell is
        unbounded: of the points on the convex hull, so of all points on one line, and in a slab of those on its border;
        a torus has none. ``clipped_cells()`` and ``bounded_cells()`` bound them. 0 for removed ids. Points that
        coincide share their cell's area."""
        return self._arrays(Group.CELLS)[0]

    @property
    def perimeters(self) -> NDArray[np.float64]:
        """float64 (rows,): perimeters of the Voronoi cells, in the unit of the coordinates."""
        return self._arrays(Group.CELLS)[1]

    @property
    def centroids(self) -> NDArray[np.float64]:
        """float64 (rows, 2): centroids of the Voronoi cells; an unbounded one has its point instead."""
        return self._arrays(Group.CELLS)[2]

    @property
    def shape_indices(self) -> NDArray[np.float64]:
        """float64 (rows,): perimeter over the square root of the area: 3.72 of a regular hexagon."""
        return self._arrays(Group.CELLS)[3]

    @property
    def ridges(self) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
        """int32 (ridges, 2), float64 (ridges,): rows of neighbors, and the length of the edge between their Voronoi
        cells, infinite on the hull."""
        pairs, lengths, _ = self._arrays(Group.RIDGES)
        return pairs, lengths

    def voronoi_cell(self, id: int) -> NDArray[np.float64]:
        """float64 (k, 2): the corners of the Voronoi cell of a point, counterclockwise; none if it is unbounded."""
        integer = as_index("the id", id)
        if not -(2**63) <= integer < 2**63:
            raise UnknownIdError(f"there is no point with id {integer}: ids have 64 bits")
        return self._cell_corners(integer)

    def bounded_cells(
        self, radius: ArrayLike = np.inf, domain: Optional[Domain] = None, rule: str = "whole"
    ) -> BoundedCells:
        """Voronoi cells as far as they reach: each ends at a radius around its point, one for all or float (rows,), at
        the walls of a domain, or at both.

        A domain is any simple polygon with holes that do not touch, and there is none in periodic space: its corners,
        float (k, 2); or a sequence of such rings, the outer boundary and then the holes; or what has a
        ``__geo_interface__``, such as a polygon of shapely; or GeoJSON as a dictionary. Rings turn either way, and have
        their first corner also at the end or not. What of a cell counts where walls divide it, the ``rule`` says:

        - ``"whole"``: all that the domain has of it, also of a point that is outside of the domain;
        - ``"connected"``: the component that has the point, as PedPy has it; nothing if the point is outside;
        - ``"visible"``: what is in line of sight from the point; nothing if the point is outside.

        ``are_inside`` of the result says which points are in the domain. Only cells by the rule ``"whole"`` without a
        domain, or in one that is convex without straight corners, have ``rings()``, a surface and gradients; all have
        ``polygons()``. Cost: linear; in a convex domain, times the number of walls.

        ParameterError if a radius is not positive, or infinite without a domain, where those of removed ids mean
        nothing; DomainError if a domain is no such polygon; InputValueError if there is no such rule."""
        radii = as_floats("the radius", radius)
        one = float(radii) if radii.ndim == 0 else None
        if one == np.inf and domain is None:
            raise _nothing_bounds_cells(has_domains=not isinstance(self, _Periodic))
        return BoundedCells(self, self._bounded_cells(one, radius, rings_of(domain), rule))

    def interpolation_weights(self, query_points: ArrayLike, method: str = "natural") -> InterpolationWeights:
        """The weights by which values at the points are interpolated at query points (m, 2), or one, (2,). By
        ``"natural"`` they are Sibson's, of natural neighbors, smooth except at the points; by ``"linear"`` the
        barycentric coordinates in the triangle.

        The weights hold for any values, so they are computed once for many: ``weights.interpolate(values)`` has the
        values at the query points. Of points that coincide, only the one that represents them has weights. Cost: that
        of ``nearest()``.

        NonFiniteCoordinateError if a query point is not finite; InputValueError if there is no such method."""
        queries = {"natural": Query.NATURAL_WEIGHTS, "linear": Query.LINEAR_WEIGHTS}
        if not isinstance(method, str) or method not in queries:
            raise InputValueError(f"the method is {method!r}: it must be 'natural' or 'linear'")
        (indptr, indices, weights, shifts), shape = lists(self, queries[method], query_points)
        return InterpolationWeights(indptr, indices, weights, shifts, shape)

    def alpha_shape(self, alpha: float) -> AlphaShape:
        """The alpha shape of the points: what is left of the triangulation when a disc, whose squared radius is
        ``alpha``, erases what it can reach without covering a point. Decided exactly, as CGAL's ``Alpha_shape_2`` in
        its general mode. Cost: linear.

        InputValueError if alpha is negative, or not a finite number."""
        number = as_extent("alpha", alpha)
        if number == np.inf:
            raise InputValueError("alpha is inf: it must be a finite number, the square of a radius")
        return AlphaShape(*self._answer(Query.ALPHA_SHAPE, np.empty((0, 2)), number))

    def neighbor_list(self) -> NeighborList:
        """Pairs of neighbors with vectors and the lengths of Voronoi edges, as freud's. Of points that coincide, only
        the one that represents them has neighbors."""
        while True:
            pairs, lengths, shifts = self._arrays(Group.RIDGES)
            points, cell = self.points, self._cell()
            if self._is_current(pairs):  # else another thread has changed the triangulation in between
                break
        first, second = np.concatenate([pairs, pairs[:, ::-1]]).T
        vectors = points[second] - points[first]
        if cell is not None:
            vectors += np.concatenate([shifts, -shifts]) @ np.array(cell.numbers).reshape(2, 2)
        order = np.lexsort((second, first))
        counts = np.bincount(first, minlength=len(points))
        weights = np.concatenate([lengths, lengths])
        return NeighborList(first[order], second[order], vectors[order], weights[order], counts)

    def __reduce__(self) -> tuple[Any, ...]:
        checkpoint = self.checkpoint()  # UseError if there are no settings, as __init__() was not called
        others = {name: value for name, value in vars(self).items() if name != "_settings"}
        return _restored, (type(self), self._settings, checkpoint), others or None


def _nothing_bounds_cells(has_domains: bool) -> ParameterError:
    wanted = "a radius, bounded_cells(2.5), or a domain, bounded_cells(domain=corners)"
    error = ParameterError(
        "the radius is inf, as it is without one, and there is no domain: cells need an end. Give "
        + (wanted if has_domains else "a finite radius, bounded_cells(2.5)")
    )
    error.value = np.inf
    return error


def _restored(kind: type[Self], settings: dict[str, Any], checkpoint: bytes) -> Self:
    triangulation = kind.__new__(kind)
    cell = _cell((1.0, 1.0)) if issubclass(kind, _Periodic) else None  # the checkpoint has another one
    triangulation._init(issubclass(kind, _ByIds), cell, settings)
    triangulation.restore(checkpoint)
    return triangulation


class _Planar(ScipyNames, _Triangulation):
    """What triangulations in the plane have in common, beside what SciPy's have."""

    @property
    def neighbors(self) -> NDArray[np.int32]:
        """int32 (triangles, 3): the triangle opposite to each corner, -1 on the hull, as scipy.spatial.Delaunay has
        it."""
        return self._arrays(Group.TRIANGLES)[1]

    @property
    def simplices(self) -> NDArray[np.int32]:
        """int32 (triangles, 3): ``triangles``, by the name that SciPy has for them."""
        return self.triangles

    @property
    def convex_hull(self) -> NDArray[np.int32]:
        """int32 (k, 2): rows of both ends of each edge of the convex hull, with the inside on the left."""
        triangles, neighbors = self._arrays(Group.TRIANGLES)
        triangle, opposite = np.nonzero(neighbors < 0)
        corners = triangles[triangle]
        at = np.arange(len(triangle))
        return np.column_stack([corners[at, (opposite + 1) % 3], corners[at, (opposite + 2) % 3]])

    def find_simplex(self, query_points: ArrayLike) -> Union[int, NDArray[np.int32]]:
        """int32 (m,) for query points (m, 2), an int for one, (2,): the triangle in which each of them is, boundary
        included; -1 outside of all. Decided exactly. Cost: about n**(1/3) for each query point."""
        found = self._find_simplex(as_rows(query_points))
        return int(found[0]) if np.ndim(query_points) == 1 and len(found) == 1 else found

    def clipped_cells(self, box: ArrayLike) -> CellMeasures:
        """Measures of the parts of the Voronoi cells inside a box (xmin, ymin, xmax, ymax). Cells of the hull are
        bounded there. Cost: linear. InputValueError if the box is empty, as matplotlib's (xmin, xmax, ymin, ymax)
        mostly is."""
        sides = as_floats("a box", box)
        if sides.shape != (4,):
            raise InputValueError(f"a box has the shape {sides.shape}: it must be (4,), for xmin, ymin, xmax and ymax")
        if not (sides[:2] < sides[2:]).all() or not np.isfinite(sides).all():
            raise InputValueError(
                f"the box {tuple(sides.tolist())} is empty or not finite: its numbers are xmin, ymin, xmax and ymax, in "
                "this order, with xmin < xmax and ymin < ymax"
            )
        return CellMeasures(*self._clipped_cells(*sides))


class _Periodic(ChangedEdgeShifts, _Triangulation):
    """What triangulations of a periodic space have in common."""

    @property
    def cell(self) -> NDArray[np.float64]:
        """float64 (2, 2): the vectors of the cell, a row each; (1, 2) of a slab."""
        cell = self._cell()
        assert cell is not None
        return _cell_array(cell)

    @property
    def edge_shifts(self) -> NDArray[np.int32]:
        """int32 (edges, 2): the shift of the second end of each edge."""
        return self._arrays(Group.EDGES)[1]

    @property
    def triangle_shifts(self) -> NDArray[np.int32]:
        """int32 (triangles, 3, 2): the shifts of the corners; those of the first ones are 0."""
        return self._arrays(Group.TRIANGLES)[1]

    @property
    def neighbor_shifts(self) -> NDArray[np.int32]:
        """int32 (pairs, 2): the shift of each neighbor in ``indices``."""
        return self._arrays(Group.NEIGHBOR_LISTS)[2]


class _ByNumbers(ChangedEdges, _Triangulation):
    """Points with the ids 0, 1, 2, ..."""

    def insert(self, points: ArrayLike) -> NDArray[np.int64]:
        """Add points, float (m, 2), or one, (2,); return their ids, int64 (m,)."""
        return self._insert(as_rows(points), None)

    def remove(self, ids: ArrayLike) -> UpdateReport:
        """Remove points by their ids, int (m,), or one."""
        return self._remove(as_list(ids))

    def move(self, ids: ArrayLike, points: ArrayLike) -> UpdateReport:
        """Move some points, int (m,), or one, to positions, float (m, 2) or (2,). All others stay."""
        return self._move(as_list(ids), as_rows(points))


class _ByShape(_Triangulation):
    """What makes a triangulation in space of points (n, 3). A class of its own, so that others have the signatures of
    their ``__init__()``, of which the points are the last argument without a name."""

    def __new__(cls, *arguments: Any, **named: Any) -> Any:
        if are_in_space(named.get("points", arguments[-1] if arguments else None)):
            if cls is DynamicDelaunay:
                return DynamicDelaunay3D(*arguments, **named)
            if cls is Population:
                return Population3D(*arguments, **named)
        return super().__new__(cls)


class DynamicDelaunay(_ByNumbers, _Planar, _ByShape):
    """The Delaunay triangulation of moving points in the plane; of points (n, 3) it becomes a DynamicDelaunay3D, which
    of the parameters has ``changes`` and ``threads``.

    Points have the ids 0, 1, 2, ... in the order in which they are given, and keep them; the id of a removed point is
    free, and the next point gets the smallest free id. Arrays have a row for each id that was ever in use.

    Parameters
    ----------
    points : array_like, float (n, 2)
        x and y of each point. Any strided array of float64 is read in place, other numbers are converted first.
    classifier : str or callable
        What finds the edges that the motion broke: "circumcircle" and "safe_region" are exact, "point_distance:0.7",
        "inflation_aware", "voronoi_circumcenter", "voronoi_circumcenter_estimated", "voronoi_edge_length",
        "nearly_delaunay", "random" and "refined:FIRST+SECOND" may miss some. A callable gets a ClassifierFrame and
        returns None, the vertices to examine, or a tuple of vertices and edges; it may have a method
        ``after_update(frame)``.
    repair : str, optional
        "hold_and_flip", "splice", "flip", "relocate" or "rebuild"; without it, what suits the classifier.
    policy : str
        "always_dynamic", "always_static", "hybrid" or "key_frames:K".
    changes : bool
        Whether to record created and removed edges. That costs time for each edge that is flipped.
    threads : int
        Threads that share the work; 0 for all.
    seed : int
        Of the classifier "random".

    With an exact classifier every call ends with a proof by exact predicates. Calls release the interpreter's lock;
    different objects run in threads at once, and calls of one object wait for each other. Do not write to an array
    while it is read.
    """

    def __init__(
        self,
        points: Optional[ArrayLike] = None,
        *,
        classifier: Classifier = "circumcircle",
        repair: Optional[str] = None,
        policy: str = "always_dynamic",
        changes: bool = False,
        threads: int = 1,
        seed: int = 1,
    ) -> None:
        self._init(False, None, _settings(classifier, repair, policy, changes, threads, seed))
        if points is not None:
            self._insert(points, None)

    def update(self, points: ArrayLike) -> UpdateReport:
        """Move point i to row i of ``points``, float (number_of_ids, 2), and repair what that breaks. Rows of removed
        ids are ignored. Cost: a pass over the edges, of which most are skipped where all is calm."""
        return self._update(points, None, None)


class _PeriodicByShape(_Triangulation):
    """What makes a triangulation in periodic space of points (n, 3), or of a cell in space."""

    def __new__(cls, *arguments: Any, **named: Any) -> Any:
        if cls is PeriodicDelaunay and _are_periodic_in_space(("points", "cell"), arguments, named):
            return PeriodicDelaunay3D(*arguments, **named)
        if cls is PeriodicPopulation and _are_periodic_in_space(("ids", "points", "cell"), arguments, named):
            return PeriodicPopulation3D(*arguments, **named)
        return super().__new__(cls)


def _are_periodic_in_space(names: tuple[str, ...], arguments: tuple[Any, ...], named: dict[str, Any]) -> bool:
    passed = {**dict(zip(names, arguments)), **named}
    return are_in_space(passed.get("points")) or is_cell_in_space(passed.get("cell"))


class PeriodicDelaunay(_ByNumbers, _Periodic, _PeriodicByShape):
    """The Delaunay triangulation of moving points in a periodic cell, which may change with every frame. Of points
    (n, 3), or of a cell in space, (3,), (3, 3), (2, 3) or (1, 3), it becomes a PeriodicDelaunay3D, which of the settings
    has ``changes`` and ``threads``.

    It is of one sheet, and exact: n points have 3n edges and 2n triangles. An edge goes from a point to the image of
    another one by a shift (i, j), which is moved by i times the first vector of the cell and j times the second one.

    Parameters
    ----------
    points : array_like, float (n, 2)
        Positions, wrapped or not.
    cell : array_like
        (2,) the sides of a rectangle; (2, 2) two vectors, a row each; (1, 2) the one vector of a slab, which is open
        across it.
    classifier, repair, policy, changes, threads, seed
        As of DynamicDelaunay.
    """

    def __init__(
        self,
        points: Optional[ArrayLike] = None,
        cell: ArrayLike = (1.0, 1.0),
        *,
        classifier: Classifier = "circumcircle",
        repair: Optional[str] = None,
        policy: str = "always_dynamic",
        changes: bool = False,
        threads: int = 1,
        seed: int = 1,
    ) -> None:
        self._init(False, _cell(cell), _settings(classifier, repair, policy, changes, threads, seed))
        if points is not None:
            self._insert(points, None)

    def update(self, points: ArrayLike, cell: Optional[ArrayLike] = None) -> UpdateReport:
        """Move point i to row i of ``points``, float (number_of_ids, 2), in the same cell, or in one that has changed.
        Where a point is wrapped, it has gone to the nearest image."""
        return self._update(points, None, None if cell is None else _cell(cell))


class _ByIds(ChangedEdgesByIds, _Triangulation):
    """Points that come and go, by any integers of 64 bits as ids.

    Arrays have a row for each point: row k is the point ``ids[k]``. So ``population.ids[population.edges]`` has the
    edges by ids. Rows change when points come or go.
    """

    _has_user_ids = True

    def insert(self, id: int, point: ArrayLike) -> None:
        """Add one point, float (2,), by a new id."""
        self._insert(as_rows(point), as_list(id))

    def remove(self, id: int) -> UpdateReport:
        """Remove one point."""
        return self._remove(as_list(id))

    def move(self, ids: ArrayLike, points: ArrayLike) -> UpdateReport:
        """Move some points, int (m,), or one, to positions, float (m, 2) or (2,). All others stay."""
        return self._move(as_list(ids), as_rows(points))


class Population(_ByIds, _Planar, _ByShape):
    """The Delaunay triangulation of points in the plane that come and go, by any integers of 64 bits as ids; of points
    (n, 3) it becomes a Population3D, which of the settings has ``changes`` and ``threads``.

    Arrays have a row for each point: row k is the point ``ids[k]``. So ``population.ids[population.edges]`` has the
    edges by ids. Rows change when points come or go.

    Parameters are the ids, int (n,), the points, float (n, 2), and those of DynamicDelaunay. With ``changes=True`` each
    call also looks up all ids.
    """

    def __init__(
        self,
        ids: Optional[ArrayLike] = None,
        points: Optional[ArrayLike] = None,
        *,
        classifier: Classifier = "circumcircle",
        repair: Optional[str] = None,
        policy: str = "always_dynamic",
        changes: bool = False,
        threads: int = 1,
        seed: int = 1,
    ) -> None:
        self._init(True, None, _settings(classifier, repair, policy, changes, threads, seed))
        if ids is not None or points is not None:
            self._update(given("points", points), given("ids", ids), None)

    def update(self, ids: ArrayLike, points: ArrayLike) -> UpdateReport:
        """Take a whole frame, ids int (n,) and positions float (n, 2) in any order: insert points with new ids, remove
        those whose ids are missing, and move the others. Nothing changes if an id is there twice."""
        return self._update(points, ids, None)


class PeriodicPopulation(_ByIds, _Periodic, _PeriodicByShape):
    """A Population in a periodic cell: parameters are the ids, int (n,), the points, float (n, 2), the cell, as of
    PeriodicDelaunay, and those of DynamicDelaunay. Of points (n, 3), or of a cell in space, it becomes a
    PeriodicPopulation3D, which of the settings has ``changes`` and ``threads``."""

    def __init__(
        self,
        ids: Optional[ArrayLike] = None,
        points: Optional[ArrayLike] = None,
        cell: ArrayLike = (1.0, 1.0),
        *,
        classifier: Classifier = "circumcircle",
        repair: Optional[str] = None,
        policy: str = "always_dynamic",
        changes: bool = False,
        threads: int = 1,
        seed: int = 1,
    ) -> None:
        self._init(True, _cell(cell), _settings(classifier, repair, policy, changes, threads, seed))
        if ids is not None or points is not None:
            self._update(given("points", points), given("ids", ids), None)

    def update(self, ids: ArrayLike, points: ArrayLike, cell: Optional[ArrayLike] = None) -> UpdateReport:
        """Take a whole frame, as Population.update() does, in the same cell, or in one that has changed."""
        return self._update(points, ids, None if cell is None else _cell(cell))
