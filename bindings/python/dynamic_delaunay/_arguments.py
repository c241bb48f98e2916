# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""What users give, checked or brought into one shape."""

from __future__ import annotations

import operator
import os
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import InputTypeError, InputValueError


def as_index(name: str, number: Any) -> int:
    try:
        return operator.index(number)
    except TypeError:
        raise InputTypeError(f"{name} is {number!r}: it must be an integer") from None


def as_integer(name: str, number: Any, bound: int) -> int:
    integer = as_index(name, number)
    if not 0 <= integer < bound:
        raise InputValueError(f"{name} is {integer}: it must be from 0 to {bound - 1}")
    return integer


def number_of_processors() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def as_floats(name: str, numbers: ArrayLike) -> NDArray[np.float64]:
    try:
        return np.asarray(numbers, dtype=np.float64)
    except TypeError as error:
        raise InputTypeError(f"{name} must be real numbers: {error}") from None
    except ValueError as error:
        raise InputValueError(f"{name} must be real numbers: {error}") from None


def as_rows(points: ArrayLike, dimension: int = 2) -> ArrayLike:
    """One point (2,) becomes (1, 2), or in space (3,) becomes (1, 3). What is no array at all is refused where points
    are read."""
    try:
        array = np.asarray(points)
    except (TypeError, ValueError):
        return points
    return array[np.newaxis] if array.shape == (dimension,) else points


def as_list(ids: ArrayLike) -> ArrayLike:
    """One id becomes (1,)."""
    try:
        return np.atleast_1d(ids)
    except (TypeError, ValueError):
        return ids


def are_in_space(points: Any) -> bool:
    """Whether the shape is (n, 3). What is no array at all is refused where points are read."""
    try:
        shape = np.shape(points)
    except (TypeError, ValueError):
        return False
    return len(shape) == 2 and shape[1] == 3


def given(name: str, array: Optional[ArrayLike]) -> ArrayLike:
    if array is None:
        raise InputTypeError(f"ids and points must be given together, or neither: there are no {name}")
    return array
