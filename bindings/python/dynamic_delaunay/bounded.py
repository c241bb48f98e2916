# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Voronoi cells that end at a radius, at the walls of a domain, or at both."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import IntEnum
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .errors import InputTypeError, InputValueError, UseError
from .neighbors import NeighborList

if TYPE_CHECKING:
    from ._triangulations import _Triangulation


class Side(IntEnum):
    """What is on the other side of a piece of a cell's boundary."""

    NEIGHBOR = 0
    """the cell of a neighbor: a contact"""
    WALL = 1
    """the outside of the domain"""
    FREE = 2
    """no cell"""


class CellPieces(NamedTuple):
    """The boundaries of cells in pieces, those of each row one after the other, ring after ring: the outer boundary of a
    component counterclockwise, and then those of its holes, clockwise. Each is a segment, or an arc at the radius."""

    indptr: NDArray[np.int32]
    """int32 (rows + 1,): where the pieces of each row begin"""
    sides: NDArray[np.int32]
    """int32 (pieces,): what is on the other side, a ``Side``"""
    others: NDArray[np.int32]
    """int32 (pieces,): the row of the neighbor whose bisector it is on; of a wall its number, from that after the first
    corner on, where those of holes follow; of an arc and of a line of sight the row of the cell"""
    shifts: NDArray[np.int32]
    """int32 (pieces, 2): the shift of the neighbor; 0 in the plane"""
    starts: NDArray[np.float64]
    """float64 (pieces, 2): where it begins"""
    ends: NDArray[np.float64]
    """float64 (pieces, 2): where it ends"""
    lengths: NDArray[np.float64]
    """float64 (pieces,): the length of the segment or of the arc"""
    angles: NDArray[np.float64]
    """float64 (pieces,): the angle of an arc around the point, in radians; 0 of a segment"""


class CellSurface(NamedTuple):
    """The border of all cells together, as lines of free pieces, with the cells on the left. A closed line surrounds a
    group of cells, or a hole if it is clockwise; others go from wall to wall."""

    indptr: NDArray[np.int32]
    """int32 (lines + 1,): where each line begins"""
    pieces: NDArray[np.int32]
    """int32 (k,): the pieces of all lines, one after the other, as places in the arrays of ``CellPieces``"""
    rows: NDArray[np.int32]
    """int32 (k,): the rows of their cells"""
    areas: NDArray[np.float64]
    """float64 (lines,): the area that a line encloses, negative of a hole; NaN if it is not closed or winds"""
    windings: NDArray[np.int32]
    """int32 (lines, 2): how often a line winds around the periodic cell; 0 in the plane"""
    are_closed: NDArray[np.int32]
    """int32 (lines,): 1 if a line ends where it begins, or in an image of that place, else 0"""


class BoundedCellGradients(NamedTuple):
    """How an energy of bounded cells changes."""

    by_positions: NDArray[np.float64]
    """float64 (rows, 2): with x and y of each point"""
    by_radii: NDArray[np.float64]
    """float64 (rows,): with each radius"""


class HasGeoInterface(Protocol):
    """What shows itself as GeoJSON, such as a polygon of shapely."""

    @property
    def __geo_interface__(self) -> Mapping[str, Any]: ...


Domain = Union[ArrayLike, Sequence[ArrayLike], HasGeoInterface, Mapping[str, Any]]

Polygon = tuple[NDArray[np.float64], list[NDArray[np.float64]]]
"""An outer boundary, and holes."""


def _first(sequence: Any) -> Any:
    return sequence[0] if isinstance(sequence, (list, tuple, np.ndarray)) and len(sequence) else None


def rings_of(domain: Optional[Domain]) -> list[Any]:
    """The outer boundary of a domain and its holes, or nothing if there is no domain."""
    if domain is None:
        return []
    geometry: Any = getattr(domain, "__geo_interface__", domain)
    if not isinstance(geometry, Mapping):
        is_of_rings = _first(_first(_first(geometry))) is not None
        return list(geometry) if is_of_rings else [geometry]
    if geometry.get("type") == "FeatureCollection" and len(geometry.get("features", ())) == 1:
        geometry = geometry["features"][0]
    if geometry.get("type") == "Feature":
        geometry = geometry.get("geometry") or {}
    rings = geometry.get("coordinates")
    if geometry.get("type") != "Polygon" or _first(rings) is None:
        raise InputValueError(
            f"the domain is GeoJSON of the type {geometry.get('type')!r}: it must be a 'Polygon' with corners, a "
            "'Feature' of one, or a 'FeatureCollection' of one 'Feature'"
        )
    # a place may have a height
    return [[p if _first(p) is None else p[:2] for p in ring] if _first(ring) is not None else ring for ring in rings]


_MOST_SEGMENTS = 1_000_000


def _largest_turn(radii: NDArray[np.float64], segments: int, tolerance: Optional[float]) -> NDArray[np.float64]:
    """The largest angle of an arc that a segment may stand for."""
    if tolerance is None:
        if not isinstance(segments, (int, np.integer)):
            raise InputTypeError(f"segments is {segments!r}: it must be an integer")
        if not 3 <= segments <= _MOST_SEGMENTS:
            raise InputValueError(f"segments is {segments}: it must be from 3 to {_MOST_SEGMENTS} for a circle")
        return np.full(radii.shape, 2 * np.pi / segments)
    if not isinstance(tolerance, (int, float, np.number)):
        raise InputTypeError(f"the tolerance is {tolerance!r}: it must be a number")
    if not tolerance > 0:
        raise InputValueError(f"the tolerance is {tolerance}: it must be positive")
    # a chord of the angle t is r (1 - cos(t / 2)) = 2 r sin(t / 4)**2 away from its arc
    turns: NDArray[np.float64] = np.minimum(4 * np.arcsin(np.sqrt(np.minimum(tolerance / radii / 2, 1))), 2 * np.pi / 3)
    if turns.size and not turns.min() >= 2 * np.pi / _MOST_SEGMENTS:
        raise InputValueError(
            f"the tolerance is {tolerance}: with the radius {radii.max()} a circle would have more than "
            f"{_MOST_SEGMENTS} segments"
        )
    return turns


class BoundedCells:
    """Voronoi cells that end at a radius around their points, at the walls of a domain, or at both.

    ``bounded_cells()`` of a triangulation makes them. They are of that moment, and stay as they are. Arrays are
    read-only and have the rows of the triangulation at that moment; lengths and radii are in the unit of the
    coordinates. An empty cell has area and lengths 0, its point for the centroid, and no pieces.

    Points that coincide share a cell: each has an equal share of its area, and the whole of its lengths and its
    centroid. The pieces are those of the point that represents them; the others have none.

    Cells can be pickled, with all but ``gradients()``, which need the triangulation. A copy is the object itself, since
    cells do not change.
    """

    _triangulation: Optional[_Triangulation]
    _computed: Optional[_core.BoundedCells]

    def __init__(self, triangulation: _Triangulation, core: _core.BoundedCells) -> None:
        self._triangulation = triangulation
        self._computed = core

    @property
    def _core(self) -> _core.BoundedCells:
        assert self._computed is not None  # pickled cells have all that is asked of it
        return self._computed

    def __copy__(self) -> BoundedCells:
        return self

    def __deepcopy__(self, _memo: Any) -> BoundedCells:
        return self

    def __getstate__(self) -> dict[str, Any]:
        names = ["_measures", "points", "are_inside", "pieces", "_rings", "_are_convex", "_vectors"]
        return {name: getattr(self, name) for name in [*names, *(["surface"] if self._are_convex else [])]}

    def __setstate__(self, state: dict[str, Any]) -> None:
        for value in state.values():
            for array in value if isinstance(value, tuple) else [value]:
                if isinstance(array, np.ndarray):
                    array.flags.writeable = False
        vars(self).update(state, _triangulation=None, _computed=None)

    @cached_property
    def _measures(self) -> tuple[NDArray[np.float64], ...]:
        return self._core._measures()

    @cached_property
    def _rings(self) -> tuple[NDArray[np.int32], ...]:
        return self._core._rings()

    @cached_property
    def _are_convex(self) -> bool:
        return self._core._are_convex()

    @cached_property
    def _vectors(self) -> Optional[NDArray[np.float64]]:
        """Those of the periodic cell."""
        cell = self._core._cell()
        return None if cell is None else np.array(cell.numbers).reshape(2, 2)

    def _check_convex(self, what: str) -> None:
        if not self._are_convex:
            raise UseError(
                f"these cells have no {what}: only those of the rule 'whole' have, without a domain or in one that is "
                "convex and has no straight corner"
            )

    @property
    def radii(self) -> NDArray[np.float64]:
        """float64 (rows,): the radius of each cell."""
        return self._measures[0]

    @property
    def areas(self) -> NDArray[np.float64]:
        """float64 (rows,): areas, in the squared unit of the coordinates."""
        return self._measures[1]

    @property
    def perimeters(self) -> NDArray[np.float64]:
        """float64 (rows,): the lengths of whole boundaries."""
        return self._measures[2]

    @property
    def centroids(self) -> NDArray[np.float64]:
        """float64 (rows, 2): centroids. Where walls divide a cell, it may be outside of the cell."""
        return self._measures[3]

    @property
    def free_lengths(self) -> NDArray[np.float64]:
        """float64 (rows,): the length of what is free. A cell is at the surface if it is not 0."""
        return self._measures[4]

    @property
    def wall_lengths(self) -> NDArray[np.float64]:
        """float64 (rows,): the length on walls of the domain."""
        return self._measures[5]

    @cached_property
    def points(self) -> NDArray[np.float64]:
        """float64 (rows, 2): the points of the cells."""
        return self._core._points()

    @cached_property
    def are_inside(self) -> NDArray[np.bool_]:
        """bool (rows,): whether each point is in the domain or on a wall, exactly. Without a domain all are; those of
        removed ids are not."""
        (numbers,) = self._core._are_inside()
        are_inside: NDArray[np.bool_] = numbers == 1
        are_inside.flags.writeable = False
        return are_inside

    @cached_property
    def pieces(self) -> CellPieces:
        """The boundaries of all cells, in pieces."""
        return CellPieces(*self._core._pieces())

    @cached_property
    def surface(self) -> CellSurface:
        """The border of all cells together, as lines. UseError where cells have none; see ``bounded_cells()``."""
        self._check_convex("surface")
        return CellSurface(*self._core._surface())

    @cached_property
    def _owners(self) -> NDArray[np.int64]:
        indptr = self.pieces.indptr
        return np.repeat(np.arange(len(indptr) - 1), np.diff(indptr))

    def neighbor_list(self) -> NeighborList:
        """The contacts between cells, each in both directions: pairs of rows with vectors, and the lengths of contacts
        as weights."""
        touching = self.pieces.sides == Side.NEIGHBOR
        first, second = self._owners[touching].astype(np.int32), self.pieces.others[touching]
        vectors = self.points[second] - self.points[first]
        if self._vectors is not None:
            vectors += self.pieces.shifts[touching] @ self._vectors
        counts = np.bincount(first, minlength=len(self.areas))
        return NeighborList(first, second, vectors, self.pieces.lengths[touching], counts)

    def gradients(self, area_weights: ArrayLike, length_weights: ArrayLike) -> BoundedCellGradients:
        """How an energy changes with positions and radii: the forces on cells, with the opposite sign. The energy is
        given by its derivatives by the areas of cells, float (rows,), and by the lengths of ``pieces``, float
        (pieces,). UseError if the triangulation has changed since the cells were made, or where cells have none; see
        ``bounded_cells()``. Cost: linear.

        For the energy ``((areas - 1)**2 + (perimeters - 3.8)**2).sum()`` these are ``2 * (areas - 1)`` and
        ``np.repeat(2 * (perimeters - 3.8), np.diff(pieces.indptr))``."""
        self._check_convex("gradients")
        if self._triangulation is None:
            raise UseError("these cells were pickled, without the triangulation that gradients need: make them by "
                           "bounded_cells() where they are used")
        return BoundedCellGradients(
            *self._triangulation._bounded_gradients(self._core, area_weights, length_weights)
        )

    def _polyline(
        self, pieces: NDArray[np.int64], segments: int, tolerance: Optional[float]
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Where the segments of these pieces begin, and where those of each piece do."""
        owners, angles = self._owners[pieces], self.pieces.angles[pieces]
        are_arcs = angles > 0
        counts = np.ones(len(pieces), np.int64)
        turns = _largest_turn(self.radii[owners[are_arcs]], segments, tolerance)
        counts[are_arcs] = np.maximum(np.ceil(angles[are_arcs] / turns), 2)
        firsts = np.concatenate([[0], np.cumsum(counts)])
        of_piece = np.repeat(np.arange(len(pieces)), counts)
        turn = angles[of_piece] * (np.arange(firsts[-1]) - firsts[of_piece]) / counts[of_piece]
        centers, corners = self.points[owners[of_piece]], self.pieces.starts[pieces[of_piece]]
        inner = turn > 0
        x, y = (corners - centers)[inner].T
        cosine, sine = np.cos(turn[inner]), np.sin(turn[inner])
        corners[inner] = centers[inner] + np.column_stack([cosine * x - sine * y, sine * x + cosine * y])
        return corners, firsts

    def rings(self, *, segments: int = 64, tolerance: Optional[float] = None) -> list[NDArray[np.float64]]:
        """float64 (k, 2) for each row: the corners of its cell, counterclockwise, the first one once; none of an empty
        cell. As polygons of shapely and collections of matplotlib take them.

        Corners of arcs are on the circle. A whole circle would have so many ``segments``, and every arc has at least
        two; or no place of an arc is farther than the ``tolerance`` from its segments.

        UseError where cells may have several rings: ``polygons()`` has them."""
        if not self._are_convex:
            raise UseError("these cells may have several rings, as walls divide them: polygons() has all of them")
        corners, firsts = self._polyline(np.arange(len(self.pieces.sides)), segments, tolerance)
        return np.split(corners, firsts[self.pieces.indptr[1:-1]])[: len(self.areas)]

    def polygons(self, *, segments: int = 64, tolerance: Optional[float] = None) -> list[list[Polygon]]:
        """The components of each row's cell; none of an empty cell. A component is a pair: its outer boundary,
        counterclockwise, and the list of its holes, clockwise, all float64 (k, 2) with corners as in ``rings()``. So
        ``shapely.geometry.MultiPolygon(cells.polygons()[row])`` is a cell."""
        corners, firsts = self._polyline(np.arange(len(self.pieces.sides)), segments, tolerance)
        indptr, rows, are_holes = self._rings
        cells: list[list[Polygon]] = [[] for _ in self.areas]
        for ring, row, is_hole in zip(np.split(corners, firsts[indptr[1:-1]]), rows, are_holes):
            if is_hole:
                cells[row][-1][1].append(ring)
            else:
                cells[row].append((ring, []))
        return cells

    def surface_lines(self, *, segments: int = 64, tolerance: Optional[float] = None) -> list[NDArray[np.float64]]:
        """float64 (k, 2) for each line of ``surface``: its corners, as in ``rings()``. A closed line ends
        where it begins, but for rounding. In periodic space a line begins at one of its pieces and goes on from there,
        out of the periodic cell if need be."""
        surface = self.surface
        pieces = surface.pieces.astype(np.int64)
        corners, firsts = self._polyline(pieces, segments, tolerance)
        starts, ends = self.pieces.starts[pieces], self.pieces.ends[pieces]
        is_periodic = self._vectors is not None
        lines = []
        for begin, end in zip(surface.indptr[:-1], surface.indptr[1:]):
            line = np.concatenate([corners[firsts[begin] : firsts[end]], ends[end - 1 : end]])
            if is_periodic:  # a piece is around its own point: its image that begins where the last one ends
                ways = np.cumsum(ends[begin:end] - starts[begin:end], axis=0)
                places = starts[begin] + np.concatenate([[[0, 0]], ways[:-1]])
                counts = np.diff(firsts[begin : end + 1])
                counts[-1] += 1
                line += np.repeat(places - starts[begin:end], counts, axis=0)
            lines.append(line)
        return lines
