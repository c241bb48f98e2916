# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Queries of places, in the plane and in space."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arguments import as_floats, as_rows
from ._core import Query
from .errors import InputValueError
from .queries import NearestPoints, PointsWithin


class Asked(Protocol):
    """What triangulations have for them."""

    _coordinates: int
    _has_user_ids: bool

    def _answer(self, query: Query, query_points: ArrayLike, extent: float) -> tuple[NDArray[Any], ...]: ...

    @property
    def number_of_points(self) -> int: ...

    @property
    def number_of_ids(self) -> int: ...


def as_extent(name: str, number: Any) -> float:
    array = as_floats(name, number)
    if array.ndim != 0:
        raise InputValueError(f"{name} has the shape {array.shape}: it must be one number")
    if not array >= 0:
        raise InputValueError(f"{name} is {array}: it must be 0 or more")
    return float(array)


def _number_of_rows(triangulation: Asked) -> int:
    return triangulation.number_of_points if triangulation._has_user_ids else triangulation.number_of_ids


def lists(
    triangulation: Asked, query: Query, query_points: ArrayLike, extent: float = 0.0
) -> tuple[tuple[NDArray[Any], ...], tuple[int, int]]:
    """What is found for each query point, and the numbers of query points and rows."""
    while True:
        rows = _number_of_rows(triangulation)
        arrays = triangulation._answer(query, as_rows(query_points, triangulation._coordinates), extent)
        if rows == _number_of_rows(triangulation):  # else another thread has changed it in between
            return arrays, (len(arrays[0]) - 1, rows)


class Places:
    """Triangulations that can be asked about places."""

    _coordinates = 2
    """of a point"""
    _has_user_ids = False
    """so that rows are points"""

    def nearest(self: Asked, query_points: ArrayLike) -> NearestPoints:
        """The nearest point of each query point: rows, distances and shifts, for query points (m, 2), or one, (2,), in
        space (m, 3) or (3,). Decided exactly. Cost: about n**(1/3) for each query point, in space n**(1/4); less if it
        is near the last one.

        NonFiniteCoordinateError if a query point is not finite, and in PeriodicDelaunay3D PeriodicRangeError if it is
        2**20 cells or more from the origin; their ``id`` is the number of the query point."""
        return NearestPoints(*self._answer(Query.NEAREST, as_rows(query_points, self._coordinates), 0.0))

    def within(self: Asked, query_points: ArrayLike, radius: float) -> PointsWithin:
        """All points within a radius of each query point, as lists one after the other, for query points (m, 2), or
        one, (2,), in space (m, 3) or (3,). Those on the circle or sphere belong to it. In periodic space these are
        images, of which one point may have several.

        A point that is farther than the radius by less than 2**-52 of it may be in the list. A radius beyond 1.3e154,
        whose square is no number of floating point, counts as that. Around points, as
        ``within(triangulation.points, radius)``, each finds itself as well. Cost: that of ``nearest()``, plus the
        number of points that are found.

        NonFiniteCoordinateError and PeriodicRangeError as of ``nearest()``; InputValueError if the radius is negative
        or NaN, or so large, compared to a periodic cell, that 32 bits could not count the images; ParameterError if it
        is more than 256 times as large as a periodic cell in space is thick."""
        extent = as_extent("the radius", radius)
        (indptr, indices, distances, shifts), shape = lists(self, Query.WITHIN, query_points, extent)
        return PointsWithin(indptr, indices, distances, shifts, shape)
